//! New IDs: for one entity, or for all.

use rustc_hash::FxHashMap;

use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Edit, Span};
use crate::syntax::Item;
use crate::syntax::lexer::Token;
use crate::syntax::table::RecordKind;

use super::entity::MAX_ID;
use super::uses::{id_at, occurrences, references_of};

/// The token that would be renamed at an offset.
///
/// # Errors
///
/// No ID stands at the place, or the ID is the render record's.
pub fn prepare(analysis: &Analysis, offset: u32) -> Result<Span, Complaint> {
    match id_at(analysis, offset) {
        None => Err(Complaint::new("lsp-no-id")),
        Some((1, _)) => Err(Complaint::new("lsp-render-id")),
        Some((_, span)) => Ok(span),
    }
}

/// The edits that give the entity at an offset another ID, wherever it is named.
///
/// # Errors
///
/// No ID that can be changed stands at the place, or the new one is no ID, reserved, or taken.
pub fn rename(analysis: &Analysis, offset: u32, new: &str) -> Result<Vec<Edit>, Complaint> {
    prepare(analysis, offset)?;
    let (id, _) = id_at(analysis, offset).ok_or_else(|| Complaint::new("lsp-no-id"))?;
    let new = new.trim();
    let wanted = (new.parse::<u32>().ok())
        .filter(|&n| n > 0 && n <= MAX_ID && new.bytes().all(|b| b.is_ascii_digit()))
        .ok_or_else(|| {
            Complaint::new("lsp-not-an-id")
                .with("text", crate::syntax::quote(new))
                .with("max", MAX_ID.to_string())
        })?;
    if wanted == id {
        return Ok(Vec::new());
    }
    if wanted == 1 {
        return Err(Complaint::new("lsp-reserved-id"));
    }
    if let Some(other) = occurrences(analysis, wanted).first() {
        let line = analysis.source.line_index(other.span.start) + 1;
        return Err(Complaint::new("lsp-id-taken")
            .with("id", wanted.to_string())
            .with("line", line.to_string()));
    }
    let text = wanted.to_string();
    let edit = |span| Edit {
        span,
        text: text.clone(),
    };
    Ok((occurrences(analysis, id).iter())
        .map(|o| edit(o.span))
        .collect())
}

/// Whether all entities can be numbered anew. They can if every record can be read.
pub fn can_renumber(analysis: &Analysis) -> bool {
    !analysis
        .document
        .items
        .iter()
        .any(|i| matches!(i, Item::Broken(_)))
}

/// The edits that number all entities anew, in the order of the file: 2, 3, 4 …; the render record keeps 1. `None` if
/// a record cannot be read, as it may name any ID.
pub fn renumber(analysis: &Analysis) -> Option<Vec<Edit>> {
    let (document, text) = (&analysis.document, analysis.source.text.as_str());
    let mut named: Vec<(Span, u32)> = Vec::new();
    for item in &document.items {
        match item {
            Item::Record(record) => {
                if record.kind != RecordKind::Render {
                    let token: &Token = document.id_token(record);
                    named.push((token.span(), record.id));
                }
                named.extend(references_of(analysis, record));
            }
            Item::Void { .. } => {}
            Item::Broken(_) => return None,
        }
    }
    let mut new: FxHashMap<u32, u32> = FxHashMap::default();
    new.insert(1, 1);
    let mut edits = Vec::new();
    for (span, id) in named {
        let next = new.len() as u32 + 1;
        let number = new.entry(id).or_insert(next).to_string();
        if text.get(span.range()) != Some(&number) {
            edits.push(Edit { span, text: number });
        }
    }
    Some(edits)
}
