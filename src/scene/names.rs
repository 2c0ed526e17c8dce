//! The IDs to which the records of each entity refer, in one compact table.

use super::model::Scene;
use crate::syntax::table::{Param, ParamKind};
use crate::syntax::{Document, Item, Record};

/// For each ID, the IDs to which its records refer, in file order: the record that defines the ID and those that change
/// it. All IDs stand as their numbers in [`Scene::ids`].
pub struct Names {
    /// The index in `names` where the names of each ID start. One more entry holds the end.
    starts: Vec<u32>,
    names: Vec<u32>,
}

impl Names {
    /// Builds the table. `None` if a record refers to an ID that the scene does not have.
    pub fn new(document: &Document, scene: &Scene) -> Option<Names> {
        let records = || document.items.iter().filter_map(Item::record);
        // References are counted first and then written to their places: a list of pairs would take the same memory
        // again.
        let mut starts = vec![0; 2];
        for record in records() {
            let own = scene.ids.get(record.id)? as usize;
            if starts.len() < own + 3 {
                starts.resize(own + 3, 0);
            }
            starts[own + 2] += references(document, record).count() as u32;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut names = vec![0; starts[starts.len() - 1] as usize];
        for record in records() {
            // While names are written, the entry behind an ID's own is its next free place. In the end the next ID
            // starts there.
            let at = &mut starts[scene.ids.get(record.id)? as usize + 1];
            for name in references(document, record) {
                names[*at as usize] = scene.ids.get(name)?;
                *at += 1;
            }
        }
        Some(Names { starts, names })
    }

    pub fn of(&self, number: usize) -> &[u32] {
        match self.starts.get(number..number + 2) {
            Some(&[start, end]) => &self.names[start as usize..end as usize],
            _ => &[],
        }
    }
}

/// The IDs to which a record refers. A reference that is 0 names none.
pub fn references<'d>(
    document: &'d Document,
    record: &'d Record,
) -> impl Iterator<Item = u32> + use<'d> {
    let refers = |p: &Param| matches!(p.kind, ParamKind::Reference { .. });
    let params = record.ty().params.iter().chain(record.ty().optional);
    // No type has both repeated parameters and references.
    (params.zip(document.values(record)))
        .filter(move |(p, value)| refers(p) && (1.0..=f64::from(u32::MAX)).contains(*value))
        .map(|(_, &value)| value as u32)
}
