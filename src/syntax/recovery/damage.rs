//! The number of errors in a reading, undefined references included. Recovery compares readings by this number.

use rustc_hash::FxHashSet;

use super::super::table::{Effect, ParamKind};
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::stretch::Stretch;
use super::surroundings::Surroundings;

/// The IDs that the record at tokens `start..end` refers to.
pub(super) fn of_record(stretch: &Stretch, start: usize, end: usize) -> impl Iterator<Item = i32> {
    let params = stretch.record_type(start + 1).map_or(&[][..], |t| t.params);
    (start + 2..end)
        .zip(params)
        .filter(|(_, p)| matches!(p.kind, ParamKind::Reference { .. }))
        .filter_map(|(i, _)| stretch.sigs[i].int.filter(|&id| id > 0))
}

/// The number of errors in a reading of a stretch: its faults, the IDs that are defined twice, and the IDs that are
/// used and defined nowhere. Each record that lost its ID accounts for one of the undefined IDs.
pub(super) fn damage(
    stretch: &Stretch,
    around: &Surroundings,
    pieces: &[RecordCandidate],
) -> usize {
    let mut defined = FxHashSet::default();
    let mut used = FxHashSet::default();
    let (mut faults, mut lost, mut twice) = (0, 0, 0);
    let elsewhere = |id: i32| around.is_defined(id as u32);
    for p in pieces {
        let id = stretch.sigs[p.start].int.filter(|&id| id > 0);
        match p.verdict {
            Diagnosis::Void => {}
            Diagnosis::Whole(r) => {
                let changes = matches!(r.ty.effect, Effect::Changes(_));
                let again = !changes && id.is_some_and(|id| !defined.insert(id) || elsewhere(id));
                match r.ty.effect {
                    Effect::Defines(_) => twice += usize::from(again),
                    Effect::Changes(_) => used.extend(id),
                    Effect::DefinesOrChanges(..) => {}
                }
                used.extend(of_record(stretch, p.start, r.end));
            }
            Diagnosis::LostId { .. } | Diagnosis::BadId { .. } => {
                faults += 1;
                lost += 1;
            }
            Diagnosis::Surplus { id, .. } => {
                faults += 1;
                defined.insert(id as i32);
            }
            _ => {
                faults += 1;
                defined.extend(id);
            }
        }
    }
    used.extend(around.dangling.iter().map(|&id| id as i32));
    let nowhere = (used.difference(&defined)).filter(|&&id| !elsewhere(id));
    faults + twice + nowhere.count().saturating_sub(lost)
}
