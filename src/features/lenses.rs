//! Buttons above records.

use rustc_hash::FxHashMap;

use crate::analysis::Analysis;
use crate::diagnostics::Span;
use crate::syntax::table::{Effect, RecordKind};

use super::{entity, uses};

/// A button and the ID token that it stands above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lens {
    pub span: Span,
    pub action: Action,
}

/// The action of a button.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    Render,
    Preview,
    Crosscheck,
    /// Shows the references to an ID: the ID, and the number of tokens, at least two. A single use gets no button, as
    /// the eye does not miss it.
    Uses(u32, usize),
}

/// The buttons of a scene, in order.
pub fn lenses(analysis: &Analysis) -> Vec<Lens> {
    let mut uses: FxHashMap<u32, usize> = FxHashMap::default();
    for record in entity::records(analysis) {
        for (_, id) in uses::references_of(analysis, record) {
            *uses.entry(id).or_default() += 1;
        }
    }
    let mut out = Vec::new();
    for record in entity::records(analysis) {
        let span = analysis.document.id_token(record).span();
        let mut add = |action| out.push(Lens { span, action });
        match (record.kind, record.ty().effect) {
            (RecordKind::Render, _) => {
                add(Action::Render);
                add(Action::Preview);
                add(Action::Crosscheck);
            }
            (_, Effect::Defines(_) | Effect::DefinesOrChanges(..)) => {
                let first = analysis.definition(record.id).map(|r| r.first);
                let count = uses.get(&record.id).copied().unwrap_or(0);
                if first == Some(record.first) && count > 1 {
                    add(Action::Uses(record.id, count));
                }
            }
            _ => {}
        }
    }
    out
}
