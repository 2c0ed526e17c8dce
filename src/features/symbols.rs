//! The outline: sections under `0 # … #`, in them the tree of operations, and whatever is in no tree.

use rustc_hash::FxHashMap;

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span};
use crate::syntax::directive::{inside, is_directive};
use crate::syntax::lexer::Token;
use crate::syntax::table::{Effect, Family, Kind, RecordKind};
use crate::syntax::{Item, Record};

use super::{entity, folding, uses};

/// An entity in the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symbol {
    /// The ID and the comment or type, as "21 ball"; for a section, the words of its heading.
    pub name: String,
    /// The type's title; empty for a section.
    pub detail: String,
    pub sort: Sort,
    /// The span from the first record below the entity to the entity's own record.
    pub span: Span,
    /// The span of the ID, or of the heading.
    pub id_span: Span,
    pub children: Vec<Symbol>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Section,
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

/// The most levels of a tree. Entities below the last level are put on it.
const MAX_DEPTH: usize = 12;

/// The outline of a scene: its sections, and in each of them trees of operations. Each entity is there once, below
/// the first operation of its section that names it, on the way down from the render record. An operation is left out
/// if another one of the same kind only goes on with it.
pub fn symbols(analysis: &Analysis, language: Language) -> Vec<Symbol> {
    let all = Definitions::of(analysis);
    let sections = sections(analysis);
    let section_of = |at: usize| {
        let start = entity::span(analysis, all.records[at]).start;
        sections.partition_point(|s| s.heading.start <= start)
    };
    // The parent of each record is found depth first from the last record, as operands are defined before operations.
    let mut above: Vec<Option<usize>> = vec![None; all.records.len()];
    let mut depth = vec![0usize; all.records.len()];
    let mut taken = vec![false; all.records.len()];
    let mut goes_on = vec![false; all.records.len()];
    for top in (0..all.records.len()).rev() {
        if taken[top] {
            continue;
        }
        taken[top] = true;
        let mut open = vec![top];
        while let Some(at) = open.pop() {
            // The operation above stands in for an operation that is left out.
            let shown = match goes_on[at] {
                true => above[at].unwrap_or(at),
                false => at,
            };
            for (place, operand) in all.operands(analysis, at).enumerate() {
                // Only operands that stand before the record count: a cycle is an error, and no tree.
                if operand >= at || taken[operand] {
                    continue;
                }
                taken[operand] = true;
                open.push(operand);
                if section_of(operand) != section_of(shown) {
                    continue;
                }
                let on = match depth[shown] + 1 < MAX_DEPTH {
                    true => shown,
                    false => above[shown].unwrap_or(shown),
                };
                above[operand] = Some(on);
                depth[operand] = depth[on] + 1;
                goes_on[operand] =
                    goes_on_with(analysis, all.records[at], all.records[operand], place);
            }
        }
    }
    // Children stand before their parents in the file, so they are complete when the parent takes them.
    let mut below: Vec<Vec<Symbol>> = (0..all.records.len()).map(|_| Vec::new()).collect();
    let mut tops: Vec<Vec<Symbol>> = (0..=sections.len()).map(|_| Vec::new()).collect();
    for (i, above) in above.iter().enumerate().filter(|(i, _)| !goes_on[*i]) {
        let children = std::mem::take(&mut below[i]);
        let symbol = symbol(analysis, all.records[i], children, language);
        match above {
            Some(above) => below[*above].push(symbol),
            None => tops[section_of(i)].push(symbol),
        }
    }
    let mut tops = tops.into_iter();
    let mut out = tops.next().unwrap_or_default();
    out.extend(sections.into_iter().zip(tops).map(|(s, children)| Symbol {
        name: s.title,
        detail: String::new(),
        sort: Sort::Section,
        span: s.span,
        id_span: s.heading,
        children,
    }));
    out
}

/// Whether a record only goes on with the work of its operand, which is of the same kind, as `5 -101 4 3` does with
/// that of `4 -101 2 1`. An operand that has a name is a part of its own. `place` counts the record's operands from
/// 0.
fn goes_on_with(analysis: &Analysis, record: &Record, operand: &Record, place: usize) -> bool {
    let is_chained = match record.kind {
        RecordKind::Union | RecordKind::Intersection => true,
        RecordKind::Difference => place == 0,
        _ => false,
    };
    is_chained && operand.kind == record.kind && entity::comment(analysis, operand).is_none()
}

/// A part of the file under a heading.
struct Section {
    title: String,
    heading: Span,
    /// The span from the heading to the last token before the next heading.
    span: Span,
}

/// The sections, in order. Headings on consecutive lines are one heading, with the words of the first that has any.
fn sections(analysis: &Analysis) -> Vec<Section> {
    let (document, source) = (&analysis.document, &analysis.source);
    let line = |offset| source.line_index(offset);
    let mut out: Vec<Section> = Vec::new();
    for token in folding::heading_tokens(analysis) {
        let [void, comment] = [0, 1].map(|i| document.tokens[token + i]);
        let heading = void.span().to(comment.span());
        let goes_on = out.last_mut();
        if let Some(last) = goes_on.filter(|s| line(s.span.end) + 1 >= line(heading.start)) {
            last.span.end = heading.end;
            if last.title.is_empty() {
                last.title = title(&comment, &source.text);
                last.heading = heading;
            }
            continue;
        }
        out.push(Section {
            title: title(&comment, &source.text),
            heading,
            span: heading,
        });
    }
    // A heading begins no section if it is only a line drawn in signs, a record that is commented out, or a comment
    // for zpg.
    out.retain(|s| !s.title.is_empty());
    for i in 0..out.len() {
        let next = out.get(i + 1).map(|s| s.span.start);
        let end = next.unwrap_or(source.text.len() as u32);
        let last = document
            .items
            .partition_point(|item| document.item_span(item).start < end)
            .checked_sub(1)
            .map(|last| document.item_span(&document.items[last]).end);
        let span = &mut out[i].span;
        span.end = last.unwrap_or(end).max(span.end).min(end);
    }
    out
}

/// The words of a heading; empty if there are none, or if they are a record or meant for zpg.
fn title(comment: &Token, text: &str) -> String {
    if is_directive(comment, text) {
        return String::new();
    }
    let words: Vec<&str> = inside(comment.text(text)).split_whitespace().collect();
    let is_number = |word: &&str| word.parse::<f64>().is_ok();
    let is_record = words.len() > 1 && words.iter().take(2).all(is_number);
    let has_words = words.iter().any(|w| w.contains(char::is_alphabetic));
    match has_words && !is_record {
        true => words.join(" "),
        false => String::new(),
    }
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

    /// The indices of the records that define the operands of the record with index `at`.
    fn operands(&self, analysis: &Analysis, at: usize) -> impl Iterator<Item = usize> {
        let references = uses::references_of(analysis, self.records[at]);
        let known = |(_, id): (Span, u32)| self.by_id.get(&id).copied();
        references.into_iter().filter_map(known)
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

/// The sort of the entity that a record defines, for its icon.
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

/// The entities whose ID, type and comment together hold all words of a query, in any case; `limit` at most.
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
