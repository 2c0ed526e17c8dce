//! Uses of an ID: definition, references, highlights.

use crate::analysis::Analysis;
use crate::diagnostics::Span;
use crate::syntax::table::{Effect, ParamKind, RecordType};
use crate::syntax::{Item, Record};

use super::token_at_offset::{self, place_at};

/// A token that names an ID.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Occurrence {
    pub span: Span,
    pub kind: Kind,
    /// The index of the token's item among the document's items.
    pub item: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The record that defines the entity.
    Definition,
    /// A record that changes the entity, or declares it.
    Change,
    /// A parameter that refers to the entity.
    Reference,
}

/// Whether records of a type refer to anything.
pub fn refers(ty: &RecordType) -> bool {
    let is_one = |p: &crate::syntax::table::Param| matches!(p.kind, ParamKind::Reference { .. });
    ty.params.iter().chain(ty.optional).any(is_one)
}

/// The references of a record: for each the token's span and the ID.
pub fn references_of(analysis: &Analysis, record: &Record) -> Vec<(Span, u32)> {
    if !refers(record.ty()) {
        return Vec::new();
    }
    let tokens = analysis.document.params(record).enumerate();
    let of = |(i, token): (usize, &crate::syntax::lexer::Token)| {
        let param = record.ty().param(i, record.count())?;
        let id = token_at_offset::reference(param, token, &analysis.source.text)?;
        Some((token.span(), id))
    };
    tokens.filter_map(of).collect()
}

/// Every token that names an ID, in file order.
pub fn occurrences(analysis: &Analysis, id: u32) -> Vec<Occurrence> {
    let document = &analysis.document;
    let definition = analysis.definition(id).map(|r| r.first);
    let mut out = Vec::new();
    for (i, item) in (0..).zip(&document.items) {
        match item {
            Item::Record(record) => {
                if record.id == id {
                    let kind = match definition == Some(record.first) {
                        true => Kind::Definition,
                        false => Kind::Change,
                    };
                    let span = document.id_token(record).span();
                    out.push(Occurrence {
                        span,
                        kind,
                        item: i,
                    });
                }
                if refers(record.ty()) {
                    let own = references_of(analysis, record);
                    let of = own.into_iter().filter(|(_, other)| *other == id);
                    out.extend(of.map(|(span, _)| Occurrence {
                        span,
                        kind: Kind::Reference,
                        item: i,
                    }));
                }
            }
            Item::Broken(broken) if broken.id == Some(id) => {
                let token = &document.tokens[broken.first as usize];
                if token.integer(&analysis.source.text) == Some(i64::from(id)) {
                    let kind = match (definition, broken.ty().map(|t| t.effect)) {
                        (None, Some(Effect::Defines(_) | Effect::DefinesOrChanges(..))) => {
                            Kind::Definition
                        }
                        _ => Kind::Change,
                    };
                    let span = token.span();
                    out.push(Occurrence {
                        span,
                        kind,
                        item: i,
                    });
                }
            }
            _ => {}
        }
    }
    out
}

/// The numbers of occurrences that change the entity, and of those that refer to it.
pub fn counts(all: &[Occurrence]) -> (usize, usize) {
    let count = |kind| all.iter().filter(|o| o.kind == kind).count();
    (count(Kind::Change), count(Kind::Reference))
}

/// The ID that the token at an offset names, and where that token is.
pub fn id_at(analysis: &Analysis, offset: u32) -> Option<(u32, Span)> {
    if let Some(place) = place_at(analysis, offset) {
        let id = place.id(&analysis.source.text)?;
        return Some((id, place.token.span()));
    }
    // The ID of a record that cannot be read.
    let document = &analysis.document;
    match document.items[token_at_offset::item_before(document, offset)?] {
        Item::Broken(broken) => {
            let span = document.tokens[broken.first as usize].span();
            let is_id = document.tokens[broken.first as usize].integer(&analysis.source.text)
                == broken.id.map(i64::from);
            (is_id && offset <= span.end).then_some((broken.id?, span))
        }
        _ => None,
    }
}

/// The place where the ID at an offset is defined: its token, and the whole record.
pub fn definition(analysis: &Analysis, offset: u32) -> Option<(Span, Span)> {
    let (id, _) = id_at(analysis, offset)?;
    let record = analysis.definition(id)?;
    let document = &analysis.document;
    Some((
        document.id_token(record).span(),
        document.span(record.first, record.last),
    ))
}

/// The spans that are highlighted at an offset: every place where the entity is named, with the kind of each. A
/// number that names no entity is highlighted alone, as the same digits elsewhere mean something else.
pub fn highlights(analysis: &Analysis, offset: u32) -> Vec<(Span, Option<Kind>)> {
    let named = references(analysis, offset, true);
    if named.is_empty() {
        let token = token_at_offset::token_at(analysis, offset);
        return token.map(|t| (t.span(), None)).into_iter().collect();
    }
    named.iter().map(|o| (o.span, Some(o.kind))).collect()
}

/// Every place where the entity at an offset is named.
pub fn references(analysis: &Analysis, offset: u32, with_definition: bool) -> Vec<Occurrence> {
    let Some((id, _)) = id_at(analysis, offset) else {
        return Vec::new();
    };
    let mut all = occurrences(analysis, id);
    all.retain(|o| with_definition || o.kind != Kind::Definition);
    all
}
