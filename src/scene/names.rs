//! Who names whom, in one compressed table.

use super::model::Scene;
use crate::syntax::table::{Param, ParamKind};
use crate::syntax::{Document, Item, Record};

/// For each ID, by its number in [`Scene::ids`], the numbers of those that its records name, whether these records define
/// it or change it; in file order.
pub struct Names {
    /// Where the names of each ID begin; one more at the end.
    starts: Vec<u32>,
    names: Vec<u32>,
}

impl Names {
    /// `None` if a record names what is not there.
    pub fn new(document: &Document, scene: &Scene) -> Option<Names> {
        let mut pairs: Vec<(u32, u32)> = Vec::with_capacity(document.items.len());
        let mut starts: Vec<u32> = vec![0];
        for item in &document.items {
            let Item::Record(record) = item else { continue };
            let own = scene.ids.get(record.id)?;
            if starts.len() < own as usize + 2 {
                starts.resize(own as usize + 2, 0);
            }
            for name in references(document, record) {
                pairs.push((own, scene.ids.get(name)?));
                starts[own as usize + 1] += 1;
            }
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut names = vec![0; pairs.len()];
        let mut next = starts.clone();
        for (own, name) in pairs {
            let at = &mut next[own as usize];
            names[*at as usize] = name;
            *at += 1;
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
    let params = record.ty.params.iter().chain(record.ty.optional);
    // No type has both repeated parameters and references.
    (params.zip(document.values(record)))
        .filter(move |(p, value)| refers(p) && (1.0..=f64::from(u32::MAX)).contains(*value))
        .map(|(_, &value)| value as u32)
}
