//! References that lead nowhere, as a witness for how a text is to be read.

use std::collections::HashSet;

use super::faults::Verdict;
use super::layout::Piece;
use super::stream::Stream;
use super::table::ParamKind;

/// How many errors a reading of a text amounts to: its faults, and the IDs that are used and
/// defined nowhere; each record that lost its ID accounts for one of these.
pub fn damage(stream: &Stream, pieces: &[Piece]) -> usize {
    let mut defined = HashSet::new();
    let mut used = HashSet::new();
    let (mut faults, mut lost) = (0, 0);
    for p in pieces {
        let id = stream.sigs[p.start].int.filter(|&id| id > 0);
        match p.verdict {
            Verdict::Void => {}
            Verdict::Whole(r) => {
                defined.extend(id);
                for (i, param) in (p.start + 2..p.end).zip(r.ty.params) {
                    if let ParamKind::Reference { .. } = param.kind {
                        used.extend(stream.sigs[i].int.filter(|&id| id > 0));
                    }
                }
            }
            Verdict::LostId { .. } | Verdict::BadId { .. } => {
                faults += 1;
                lost += 1;
            }
            _ => {
                faults += 1;
                defined.extend(id);
            }
        }
    }
    faults + used.difference(&defined).count().saturating_sub(lost)
}
