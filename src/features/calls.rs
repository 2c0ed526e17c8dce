//! Operations as calls: what an object is made of, and what is made of it.

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span};
use crate::syntax::{Item, Record};

use super::symbols::{self, Sort};
use super::{entity, uses};

/// An entity as a node of the hierarchy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Node {
    pub id: u32,
    pub name: String,
    pub detail: String,
    pub sort: Sort,
    pub span: Span,
    pub id_span: Span,
}

/// A neighbour in the hierarchy, and the tokens of the reference: tokens of the neighbour for [`incoming`] calls, of
/// the entity itself for [`outgoing`] ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    pub node: Node,
    pub at: Vec<Span>,
}

/// The entity at an offset.
pub fn prepare(analysis: &Analysis, offset: u32, language: Language) -> Option<Node> {
    let (id, _) = uses::id_at(analysis, offset)?;
    node(analysis, analysis.definition(id)?, language)
}

fn node(analysis: &Analysis, record: &Record, language: Language) -> Option<Node> {
    Some(Node {
        id: record.id,
        name: symbols::label(analysis, record, language),
        detail: language.name(record.ty().title),
        sort: symbols::sort(record),
        span: entity::span(analysis, record),
        id_span: analysis.document.id_token(record).span(),
    })
}

/// The entities that refer to an entity.
pub fn incoming(analysis: &Analysis, id: u32, language: Language) -> Vec<Call> {
    let mut out: Vec<Call> = Vec::new();
    for o in uses::occurrences(analysis, id) {
        let Item::Record(record) = &analysis.document.items[o.item as usize] else {
            continue;
        };
        if o.kind != uses::Kind::Reference {
            continue;
        }
        match out.last_mut().filter(|call| call.node.id == record.id) {
            Some(call) => call.at.push(o.span),
            None => out.extend(node(analysis, record, language).map(|node| Call {
                node,
                at: vec![o.span],
            })),
        }
    }
    out
}

/// The entities that the record of an entity refers to.
pub fn outgoing(analysis: &Analysis, id: u32, language: Language) -> Vec<Call> {
    let references = (analysis.definition(id)).map(|r| uses::references_of(analysis, r));
    let mut out: Vec<Call> = Vec::new();
    for (span, id) in references.into_iter().flatten() {
        match out.iter_mut().find(|call| call.node.id == id) {
            Some(call) => call.at.push(span),
            None => {
                let to = analysis
                    .definition(id)
                    .and_then(|r| node(analysis, r, language));
                out.extend(to.map(|node| Call {
                    node,
                    at: vec![span],
                }));
            }
        }
    }
    out
}
