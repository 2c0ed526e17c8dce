//! Records and scenes with places to fill. They are found by their names, the likeliest first.

use std::cmp::Reverse;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::analysis::Analysis;
use crate::diagnostics::Language;
use crate::scene::Entity;
use crate::syntax::table::{Effect, Family, Kind, ParamKind, RECORD_TYPES, RecordType};
use crate::syntax::words::{names, plain};

use super::completion::{Insert, Proposal, SnippetPart, Sort};
use super::entity;

/// The codes of the most frequent types, as counted in the scenes of the course; shapes that people begin with come
/// first. Other types follow in the order of the reference.
const COMMON: [i32; 24] = [
    11, 12, 4, -101, -1, -701, -2, -299, -402, -401, -501, -201, -103, -102, 14, 9, 1, 3, 16, 5,
    -3, -399, -105, -203,
];

/// All types, in the order in which people use them: first by their number in this file, then by their frequency in
/// scenes.
pub(super) fn by_use(analysis: &Analysis) -> Vec<&'static RecordType> {
    let mut used: FxHashMap<i32, usize> = FxHashMap::default();
    for record in entity::records(analysis) {
        *used.entry(record.ty().code).or_default() += 1;
    }
    let rank = |ty: &&RecordType| {
        let common = COMMON.iter().position(|&code| code == ty.code);
        let uses = used.get(&ty.code).copied().unwrap_or(0);
        (Reverse(uses), common.unwrap_or(COMMON.len()))
    };
    let mut all: Vec<_> = RECORD_TYPES.iter().collect();
    all.sort_by_key(rank);
    all
}

/// The text that an editor compares with a typed word; `None` if the word begins none of the names. Accents do not
/// count: the text begins with the word as it was typed.
pub(super) fn filter(word: &str, names: &[String]) -> Option<String> {
    let typed = plain(word);
    let fits = names.iter().find_map(|name| name.strip_prefix(&typed))?;
    Some(format!("{word}{fits} {}", names.join(" ")))
}

/// Proposals of whole records whose type has a name that begins with `word`. For an empty word, all records that may
/// begin here.
pub(super) fn records(
    analysis: &Analysis,
    word: &str,
    before: u32,
    language: Language,
) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = new_scene(analysis, word, language).into_iter().collect();
    all.extend(by_use(analysis).into_iter().filter_map(|ty| {
        let filter = filter(word, &names(ty))?;
        let id = subject(analysis, ty, before)?.to_string();
        Some(Proposal {
            label: language.name(ty.title),
            detail: format!("{id} {} {}", ty.code, ty.signature()),
            doc: doc(ty, language),
            filter,
            insert: record(Some(id), ty, analysis, before),
            kind: sort(ty),
        })
    }));
    all
}

pub(super) fn doc(ty: &RecordType, language: Language) -> String {
    format!("{}\n\n```zpg\n{}\n```\n", ty.summary(language), ty.example)
}

pub(super) fn sort(ty: &RecordType) -> Sort {
    match ty.family {
        Family::Shape => Sort::Shape,
        Family::Operation => Sort::Operation,
        _ => Sort::Other,
    }
}

/// The ID of a new record: the last entity that the record can change, or a new ID if it defines an entity. `None` if
/// there is none.
fn subject(analysis: &Analysis, ty: &RecordType, before: u32) -> Option<u32> {
    let last = |kinds| last_of(analysis, kinds, before, &FxHashSet::default());
    match ty.effect {
        _ if ty.family == Family::Render => analysis.scene.render.is_none().then_some(1),
        Effect::Defines(_) => entity::next_id(analysis),
        Effect::Changes(kinds) => last(kinds),
        Effect::DefinesOrChanges(_, kinds) => last(kinds).or_else(|| entity::next_id(analysis)),
    }
}

/// A record as a text with places to fill. Each place has a valid value: numbers are those of the type's example,
/// references name the last entities of the file that fit.
pub(super) fn record(
    id: Option<String>,
    ty: &'static RecordType,
    analysis: &Analysis,
    before: u32,
) -> Insert {
    let head = [id, Some(ty.code.to_string())];
    let head: Vec<String> = head.into_iter().flatten().collect();
    let mut pieces = vec![SnippetPart::Fixed(head.join(" "))];
    for value in example_values(analysis, ty, before) {
        pieces.extend([
            SnippetPart::Fixed(" ".to_owned()),
            SnippetPart::Place(value),
        ]);
    }
    Insert(pieces)
}

fn example_values(analysis: &Analysis, ty: &'static RecordType, before: u32) -> Vec<String> {
    let mut used = FxHashSet::default();
    let words: Vec<&str> = ty.example.split_whitespace().skip(2).collect();
    let count_at = ty.params.iter().position(|p| p.kind == ParamKind::Count);
    let count = count_at
        .and_then(|i| words.get(i)?.parse().ok())
        .unwrap_or(0);
    let value = |(i, word): (usize, &&str)| {
        let reference = match ty.param(i, count).map(|p| p.kind) {
            Some(ParamKind::Reference { kinds, .. }) if *word != "0" => {
                last_of(analysis, kinds, before, &used)
            }
            _ => None,
        };
        used.extend(reference);
        reference.map_or_else(|| (*word).to_owned(), |id| id.to_string())
    };
    words.iter().enumerate().map(value).collect()
}

fn last_of(analysis: &Analysis, kinds: &[Kind], before: u32, used: &FxHashSet<u32>) -> Option<u32> {
    let fits = |e: &&Entity| {
        e.kind.is_some_and(|k| kinds.contains(&k)) && e.span.start < before && !used.contains(&e.id)
    };
    let mut all = analysis.scene.entities.iter().rev();
    all.find(fits).map(|e| e.id)
}

/// A scene to begin with; text between `‹` and `›` is a place to fill.
const NEW_SCENE: &str = "\
2 11  ‹0 1 0›  ‹1›
2 -701 ‹0.9 0.2 0.1›
3 4 0 1 0 0
3 -701 ‹0.7 0.7 0.7›
4 -101 2 3
5 -401 ‹0.3›
6 -402 ‹0.7›
6 -1 ‹-4 8 6›
7 -501  ‹0 3 8›  ‹0 -0.25 -1›  0 1 0  ‹45›
1 9999 4 0
";

/// The names of a new scene, as [`names`] gives them.
const NEW_SCENE_NAMES: [&str; 4] = ["new", "scene", "nova", "scena"];

/// The proposal of a whole scene; `None` if the file has a record already.
fn new_scene(analysis: &Analysis, word: &str, language: Language) -> Option<Proposal> {
    if entity::records(analysis).next().is_some() {
        return None;
    }
    let mut pieces = Vec::new();
    for (i, part) in NEW_SCENE.split(['‹', '›']).enumerate() {
        let part = part.to_owned();
        pieces.push(if i % 2 == 0 {
            SnippetPart::Fixed(part)
        } else {
            SnippetPart::Place(part)
        });
    }
    Some(Proposal {
        label: language.say("lsp-new-scene", &[]),
        detail: String::new(),
        doc: String::new(),
        filter: filter(word, &NEW_SCENE_NAMES.map(str::to_owned))?,
        insert: Insert(pieces),
        kind: Sort::Scene,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The scene that is offered has nothing that anything could be said of.
    #[test]
    fn a_new_scene_is_a_good_one() {
        let scene = new_scene(&Analysis::new("a", Vec::new()), "", Language::English);
        let text = scene.unwrap().insert.plain();
        let analysis = Analysis::new("a", text.into_bytes());
        assert_eq!(analysis.findings(), []);
        assert!(analysis.scene.render.is_some());
    }

    #[test]
    fn common_types_are_types() {
        for (i, code) in COMMON.into_iter().enumerate() {
            assert!(RecordType::by_code(code.into()).is_some(), "{code}");
            assert!(!COMMON[..i].contains(&code), "{code} twice");
        }
    }
}
