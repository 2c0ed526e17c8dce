//! The names of entities that each entity mentions, in one compressed table.

use super::model::Scene;
use crate::syntax::table::{Param, ParamKind};
use crate::syntax::{Document, Item, Record};

/// For each ID, by its number in [`Scene::ids`], the numbers of those that its records name, whether these records define
/// it or change it; in file order.
pub struct Names {
    /// Start of the names of each ID; one more entry at the end.
    starts: Vec<u32>,
    names: Vec<u32>,
}

impl Names {
    /// `None` if a record names what is not there.
    pub fn new(document: &Document, scene: &Scene) -> Option<Names> {
        let records = || document.items.iter().filter_map(Item::record);
        // Counted first, then written down: a list of pairs would take as much again.
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
            // Where its names begin, one further than they do in the end.
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

/// The IDs that a record refers to, without those that are 0.
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
