//! The outline: the render record, the tree of operations under it, and whatever is in no tree.

use rustc_hash::FxHashMap;

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span};
use crate::syntax::table::{Effect, Family, Kind, RecordKind};
use crate::syntax::{Item, Record};

use super::{entity, uses};

/// An entity in the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symbol {
    /// "21 ball".
    pub name: String,
    /// The type's title.
    pub detail: String,
    pub sort: Sort,
    /// From the first record below it to its own.
    pub span: Span,
    /// Its ID.
    pub id_span: Span,
    pub children: Vec<Symbol>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Render,
    Operation,
    Shape,
    Property,
    Texture,
    Colour,
    Light,
    Camera,
    Undefined,
}

/// Deeper trees are cut off: what is below hangs on the last level.
const MAX_DEPTH: usize = 40;

/// The outline of a scene. Each entity is there once, below the first operation that names it, seen from the
/// render record.
pub fn symbols(analysis: &Analysis, language: Language) -> Vec<Symbol> {
    let all = Definitions::of(analysis);
    // Who hangs on whom: depth first from the last record, as operands are defined before.
    let mut parent: Vec<Option<usize>> = vec![None; all.records.len()];
    let mut depth = vec![0usize; all.records.len()];
    let mut taken = vec![false; all.records.len()];
    for top in (0..all.records.len()).rev() {
        if taken[top] {
            continue;
        }
        taken[top] = true;
        let mut open = vec![top];
        while let Some(at) = open.pop() {
            for operand in all.operands(analysis, at) {
                // Only what stands before: a cycle is an error, and no tree.
                if operand < at && !taken[operand] {
                    taken[operand] = true;
                    let above = match depth[at] + 1 < MAX_DEPTH {
                        true => at,
                        false => parent[at].unwrap_or(at),
                    };
                    parent[operand] = Some(above);
                    depth[operand] = depth[above] + 1;
                    open.push(operand);
                }
            }
        }
    }
    // Children stand before their parents in the file, so they are complete when they are hung up.
    let mut below: Vec<Vec<Symbol>> = (0..all.records.len()).map(|_| Vec::new()).collect();
    let mut tops = Vec::new();
    for (i, above) in parent.iter().enumerate() {
        let symbol = symbol(
            analysis,
            all.records[i],
            std::mem::take(&mut below[i]),
            language,
        );
        match above {
            Some(above) => below[*above].push(symbol),
            None => tops.push(symbol),
        }
    }
    tops
}

/// The records that define something, in file order.
struct Definitions<'a> {
    records: Vec<&'a Record>,
    /// The index of the record that defines an ID.
    by_id: FxHashMap<u32, usize>,
}

impl<'a> Definitions<'a> {
    fn of(analysis: &'a Analysis) -> Definitions<'a> {
        let mut records = Vec::new();
        let mut by_id = FxHashMap::default();
        for item in &analysis.document.items {
            if let Item::Record(record) = item
                && !matches!(record.ty().effect, Effect::Changes(_))
                && !by_id.contains_key(&record.id)
            {
                let is_definition = (analysis.definition(record.id))
                    .is_some_and(|definition| definition.first == record.first);
                if is_definition {
                    by_id.insert(record.id, records.len());
                    records.push(record);
                }
            }
        }
        Definitions { records, by_id }
    }

    /// What a record is made of.
    fn operands(&self, analysis: &Analysis, at: usize) -> Vec<usize> {
        let record = self.records[at];
        let references = uses::references_of(analysis, record);
        let known = |(_, id): (Span, u32)| self.by_id.get(&id).copied();
        references.into_iter().filter_map(known).collect()
    }
}

fn symbol(
    analysis: &Analysis,
    record: &Record,
    children: Vec<Symbol>,
    language: Language,
) -> Symbol {
    let own = entity::span(analysis, record);
    let span = children.iter().fold(own, |span, child| span.to(child.span));
    Symbol {
        name: label(analysis, record, language),
        detail: language.name(record.ty().title),
        sort: sort(record),
        span,
        id_span: analysis.document.id_token(record).span(),
        children,
    }
}

/// "21 ball": the ID and the comment, or the type.
pub fn label(analysis: &Analysis, record: &Record, language: Language) -> String {
    let words = entity::comment(analysis, record);
    let words = words.unwrap_or_else(|| language.name(record.ty().title));
    format!("{} {words}", record.id)
}

/// What a record defines, for its sign.
pub fn sort(record: &Record) -> Sort {
    match record.ty().effect {
        _ if record.ty().family == Family::Operation => Sort::Operation,
        _ if record.kind == RecordKind::Undefined => Sort::Undefined,
        Effect::Defines(kind) | Effect::DefinesOrChanges(kind, _) => match kind {
            Kind::Object => Sort::Shape,
            Kind::Render => Sort::Render,
            Kind::Optics => Sort::Property,
            Kind::Texture => Sort::Texture,
            Kind::Colour => Sort::Colour,
            Kind::AmbientLight | Kind::PointLight => Sort::Light,
            Kind::Camera | Kind::Selection => Sort::Camera,
            Kind::Undefined => Sort::Undefined,
        },
        Effect::Changes(_) => Sort::Undefined,
    }
}

/// The entities whose ID, type or comment holds the words of a query, in any case.
pub fn matching(analysis: &Analysis, query: &str, limit: usize, language: Language) -> Vec<Symbol> {
    let query = query.to_lowercase();
    let words: Vec<&str> = query.split_whitespace().collect();
    let fits = |record: &&&Record| {
        // Names are found in both languages.
        let title = record.ty().title;
        let label = label(analysis, record, language);
        let text = format!("{label} {title} {}", language.name(title)).to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let all = Definitions::of(analysis);
    let found = all.records.iter().filter(fits).take(limit);
    found
        .map(|record| symbol(analysis, record, Vec::new(), language))
        .collect()
}
