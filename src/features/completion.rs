//! Proposals while a record is typed: records by name, types, IDs, the next free ID.

use std::fmt::Write as _;

use rustc_hash::FxHashSet;

use crate::analysis::Analysis;
use crate::diagnostics::Language;
use crate::diagnostics::Span;
use crate::syntax::table::{Constraint, Effect, Family, Kind, Param, ParamKind, RecordType};
use crate::syntax::words::names;

use super::token_at_offset::{Typing, typing};
use super::{allow_codes, entity, templates};

/// A proposal that replaces the part of a word that has been typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposal {
    pub label: String,
    /// A few words behind the label.
    pub detail: String,
    /// Markdown.
    pub doc: String,
    /// The text that is compared with what has been typed.
    pub filter: String,
    pub insert: Insert,
    pub kind: Sort,
}

/// A text to insert. Some of its pieces are places to fill.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Insert(pub Vec<SnippetPart>);

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SnippetPart {
    Fixed(String),
    /// A valid value that the user may replace.
    Place(String),
}

impl Insert {
    fn text(text: impl Into<String>) -> Insert {
        Insert(vec![SnippetPart::Fixed(text.into())])
    }

    pub fn has_places(&self) -> bool {
        self.0.iter().any(|p| matches!(p, SnippetPart::Place(_)))
    }

    /// Whether the insert is the text `word` and nothing else.
    fn is(&self, word: &str) -> bool {
        !self.has_places() && self.plain() == word
    }

    pub fn plain(&self) -> String {
        let text = |p: &SnippetPart| match p {
            SnippetPart::Fixed(text) | SnippetPart::Place(text) => text.clone(),
        };
        self.0.iter().map(text).collect()
    }

    /// The text in the notation of snippets, where `${1:…}` is the first place.
    pub fn snippet(&self) -> String {
        let mut number = 0;
        let mut out = String::new();
        for piece in &self.0 {
            let (SnippetPart::Fixed(text) | SnippetPart::Place(text)) = piece;
            let text = text.replace('\\', r"\\").replace('$', r"\$");
            let text = text.replace('}', r"\}");
            match piece {
                SnippetPart::Fixed(_) => out += &text,
                SnippetPart::Place(_) => {
                    number += 1;
                    let _ = write!(out, "${{{number}:{text}}}");
                }
            }
        }
        out
    }
}

/// The sort of a proposal, for its icon in the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Shape,
    Operation,
    Other,
    Scene,
    Id,
    Value,
    File,
}

/// Proposals, and the span of the word that they replace.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Completion {
    pub word: Span,
    pub proposals: Vec<Proposal>,
}

/// The most IDs that are proposed: the last ones of the file.
const MAX_IDS: usize = 200;

/// The proposals for the text at an offset.
pub fn completion(analysis: &Analysis, offset: u32, language: Language) -> Completion {
    if let Some(list) = allow_codes::completion(analysis, offset) {
        return list;
    }
    let Some(typing) = typing(analysis, offset) else {
        return Completion::default();
    };
    let word = analysis.source.slice(typing.word);
    let records = || templates::records(analysis, word, typing.word.start, language);
    let new_id = || new_id(analysis, language);
    let is_name = word.starts_with(char::is_alphabetic);
    let mut proposals = match typing.index {
        _ if typing.complete && is_name => records(),
        _ if typing.complete => new_id(),
        0 if is_name => records(),
        0 => {
            let by_name = if word.is_empty() {
                records()
            } else {
                Vec::new()
            };
            [new_id(), by_name, changes(analysis, language)].concat()
        }
        1 => types(analysis, &typing, word, language),
        i => typing.ty.map_or_else(Vec::new, |ty| {
            let param = ty.param(i - 2, typing.count);
            param.map_or_else(Vec::new, |p| values(analysis, p, offset, language))
        }),
    };
    // A proposal that is equal to the typed word is no help: who accepts it loses the key that ends the word.
    proposals.retain(|p| !p.insert.is(word));
    Completion {
        word: typing.word,
        proposals,
    }
}

/// The next free ID, to begin a record with.
fn new_id(analysis: &Analysis, language: Language) -> Vec<Proposal> {
    let id = entity::next_id(analysis).map(|id| id.to_string());
    let proposal = |id: String| Proposal {
        detail: language.name("the next free ID"),
        doc: String::new(),
        filter: id.clone(),
        insert: Insert::text(id.clone()),
        kind: Sort::Id,
        label: id,
    };
    id.map(proposal).into_iter().collect()
}

/// The IDs that records may change.
fn changes(analysis: &Analysis, language: Language) -> Vec<Proposal> {
    let kinds = [
        Kind::Object,
        Kind::PointLight,
        Kind::AmbientLight,
        Kind::Camera,
        Kind::Optics,
        Kind::Texture,
        Kind::Colour,
    ];
    ids(analysis, &kinds, u32::MAX, language)
}

/// The types that a record with the typed ID may have: types that define an entity if the ID is new, else types that
/// change its entity.
fn types(analysis: &Analysis, typing: &Typing, word: &str, language: Language) -> Vec<Proposal> {
    let by_number = word.starts_with(|c: char| c.is_ascii_digit() || "+-".contains(c));
    let others = |r: &crate::syntax::Record| {
        let start = analysis.document.tokens[r.first as usize].start;
        start < typing.word.start
            && analysis.source.line_index(start) != analysis.source.line_index(typing.word.start)
    };
    let known = (typing.id)
        .filter(|&id| analysis.definition(id).is_some_and(others))
        .and_then(|id| entity::entity(analysis, id)?.kind);
    let fits = |ty: &&RecordType| match (ty.effect, known) {
        _ if typing.id == Some(1) => ty.family == Family::Render,
        _ if ty.family == Family::Render => false,
        (Effect::Defines(_), known) => known.is_none_or(|k| k == Kind::Undefined),
        (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds), Some(kind)) => {
            kinds.contains(&kind)
        }
        (Effect::Changes(_), None) => false,
        (Effect::DefinesOrChanges(..), None) => true,
    };
    let all = templates::by_use(analysis)
        .into_iter()
        .filter(|ty| fits(ty));
    let proposal = |ty: &'static RecordType| {
        let filter = match by_number {
            true => ty.code.to_string(),
            false => templates::filter(word, &[names(ty), vec![ty.code.to_string()]].concat())?,
        };
        Some(Proposal {
            label: format!("{} {}", ty.code, language.name(ty.title)),
            detail: ty.signature(),
            doc: templates::doc(ty, language),
            filter,
            insert: templates::record(None, ty, analysis, typing.word.start),
            kind: templates::sort(ty),
        })
    };
    all.filter_map(proposal).collect()
}

/// The proposals for a parameter's value.
fn values(analysis: &Analysis, param: &Param, offset: u32, language: Language) -> Vec<Proposal> {
    let value = |text: &str, detail: &'static str, kind| Proposal {
        label: text.to_owned(),
        detail: language.name(detail),
        doc: String::new(),
        filter: text.to_owned(),
        insert: Insert::text(text),
        kind,
    };
    match (param.kind, param.constraint) {
        (ParamKind::Reference { kinds, or_none }, _) => {
            let none = or_none.then(|| value("0", "none", Sort::Value));
            none.into_iter()
                .chain(ids(analysis, kinds, offset, language))
                .collect()
        }
        (ParamKind::FileName, _) => {
            let all = pictures(analysis);
            all.iter()
                .map(|name| value(name, "picture", Sort::File))
                .collect()
        }
        (_, Constraint::Axis) => {
            let axes = [
                ("1", "the x axis"),
                ("2", "the y axis"),
                ("3", "the z axis"),
            ];
            axes.map(|(text, detail)| value(text, detail, Sort::Value))
                .into()
        }
        (ParamKind::Integer, Constraint::Within(1.0, 2.0)) => vec![
            value("1", "one sheet", Sort::Value),
            value("2", "two sheets", Sort::Value),
        ],
        _ => Vec::new(),
    }
}

/// The IDs of entities of these kinds that are defined before an offset, the last one first. An ID that is defined
/// more than once, as after `ID 0`, is proposed once.
fn ids(analysis: &Analysis, kinds: &[Kind], before: u32, language: Language) -> Vec<Proposal> {
    let mut seen = FxHashSet::default();
    let fits = |e: &&crate::scene::Entity| {
        e.kind.is_some_and(|k| kinds.contains(&k)) && e.span.end <= before
    };
    let all = analysis
        .scene
        .entities
        .iter()
        .rev()
        .filter(fits)
        .filter(|e| seen.insert(e.id))
        .take(MAX_IDS);
    all.map(|e| Proposal {
        label: e.id.to_string(),
        detail: entity::described(analysis, e.id, language).unwrap_or_default(),
        doc: String::new(),
        filter: e.id.to_string(),
        insert: Insert::text(e.id.to_string()),
        kind: Sort::Id,
    })
    .collect()
}

/// The picture files beside the scene.
fn pictures(analysis: &Analysis) -> Vec<String> {
    const MAX_FILES: usize = 200;
    let folder = analysis
        .source
        .folder()
        .and_then(|f| std::fs::read_dir(f).ok());
    let mut names: Vec<String> = (folder.into_iter().flatten().take(10 * MAX_FILES))
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| {
            let name = name.to_lowercase();
            [".png", ".jpg", ".jpeg"].iter().any(|e| name.ends_with(e))
        })
        .map(|name| match name.contains(char::is_whitespace) {
            true => format!("\"{name}\""),
            false => name,
        })
        .collect();
    names.sort();
    names.truncate(MAX_FILES);
    names
}
