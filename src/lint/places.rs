//! Shapes behind a lamp, on the lamp's line, that may be meant as the lamp's place.

use rustc_hash::FxHashMap;

use super::Context;
use crate::scene::names;
use crate::syntax::lexer::TokenKind;
use crate::syntax::table::{Family, RecordKind};
use crate::syntax::{Item, Record};

impl<'a> Context<'a> {
    /// Each lamp with the record behind it that may be its place, as `5 9 5` in `50 -402 1 5 9 5`: three numbers on the
    /// lamp's line that are read as a shape, and whose ID stands nowhere else.
    pub(super) fn lamps_with_places(&self) -> Vec<(&'a Record, &'a Record)> {
        let pairs = self.document.items.windows(2).filter_map(|pair| {
            let [Item::Record(lamp), Item::Record(place)] = pair else {
                return None;
            };
            let is_lamp = lamp.kind == RecordKind::PointLight;
            let is_place = place.ty().family == Family::Shape && place.last - place.first == 2;
            let tokens = &self.document.tokens[lamp.first as usize..=place.last as usize];
            let is_line = !tokens.iter().any(|t| t.kind() == TokenKind::Newline);
            (is_lamp && is_place && is_line).then_some((lamp, place))
        });
        let mut pairs: Vec<_> = pairs.collect();
        if pairs.is_empty() {
            return pairs;
        }
        let mut counts: FxHashMap<u32, usize> = FxHashMap::default();
        for record in self.records() {
            let named = names::references(self.document, record);
            for id in named.chain([record.id]) {
                *counts.entry(id).or_default() += 1;
            }
        }
        pairs.retain(|(_, place)| counts[&place.id] == 1);
        pairs
    }
}
