//! The records that give objects their properties, for rules that repeat these records for another object.

use rustc_hash::FxHashMap;

use super::Context;
use crate::scene::{Node, NodeId, Paint};
use crate::syntax::Record;
use crate::syntax::table::{Effect, Family};

/// The number of aspects of a paint: texture, optics and refractive index.
pub(super) const ASPECTS: usize = 3;

/// For each aspect whether a paint gives it.
pub(super) fn sets(paint: &Paint) -> [bool; ASPECTS] {
    [
        paint.texture.is_some(),
        paint.optics.is_some(),
        paint.index.is_some(),
    ]
}

/// The records that give properties to objects, and the last changes of the properties themselves.
pub(super) struct Properties<'a> {
    /// For each ID the records that give it properties.
    given: FxHashMap<u32, Vec<&'a Record>>,
    /// For each ID the first token of the last record that may change it.
    last: FxHashMap<u32, u32>,
}

impl<'a> Properties<'a> {
    pub(super) fn new(context: &Context<'a>) -> Self {
        let mut properties = Properties {
            given: FxHashMap::default(),
            last: FxHashMap::default(),
        };
        for record in context.records() {
            let family = record.ty().family;
            if matches!(family, Family::Property | Family::Texture | Family::Colour) {
                properties.given.entry(record.id).or_default().push(record);
            }
            if !matches!(record.ty().effect, Effect::Defines(_)) {
                properties.last.insert(record.id, record.first);
            }
        }
        properties
    }

    /// The texts of records that give the operand's properties to the result as well. `None` if the operand's own paint
    /// does not give all aspects that `differ`, or if one of its records names an ID that has changed since.
    pub(super) fn again(
        &self,
        context: &Context,
        operand: u32,
        node: NodeId,
        result: u32,
        differ: [bool; ASPECTS],
    ) -> Option<Vec<String>> {
        let scene = context.scene;
        let mut states = scene.states(node);
        let (node, Node::Paint { paint, .. }) =
            states.find(|(_, n)| !matches!(n, Node::Transform { .. }))?
        else {
            return None;
        };
        let paint = &scene.paints[paint as usize];
        let set = sets(paint);
        if paint.owner != operand || (0..ASPECTS).any(|i| differ[i] && !set[i]) {
            return None;
        }
        // Only records up to the one that made the paint, which the operation took.
        let end = scene.origins[node as usize].span.end;
        let mut lines = Vec::new();
        for &record in self.given.get(&operand)? {
            let start = context.document.tokens[record.first as usize].start;
            if start >= end {
                break;
            }
            let changed = |id: u32| self.last.get(&id).is_some_and(|&at| at > record.first);
            if context.references(record).any(changed) {
                return None;
            }
            let tokens = context.document.significant(record.first, record.last);
            let words: Vec<&str> = tokens.skip(1).map(|t| t.text(context.text)).collect();
            lines.push(format!("{result} {}", words.join(" ")));
        }
        Some(lines).filter(|l| !l.is_empty())
    }
}
