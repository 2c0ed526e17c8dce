//! Glass without an index that a comment calls glass, water or diamond. In a scene with an index, only glass that
//! scatters some light, since the others are compared with the object that has the index.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{Test, finding, is_clear, is_glass, lets_through, members};
use crate::diagnostics::Diagnostic;
use crate::lint::Context;
use crate::lint::parts::Parts;
use crate::scene::{NodeId, Origin};
use crate::solids::{Named, named};
use crate::syntax::captions::Captions;
use crate::syntax::lexer::TokenKind;
use crate::syntax::table::RecordKind;
use crate::syntax::words;

/// A substance by the beginnings of its names, without accents, and its index.
struct Substance {
    names: &'static [&'static str],
    index: &'static str,
}

const SUBSTANCES: [Substance; 3] = [
    Substance {
        names: &["glass", "lens", "sklo", "skla", "skle", "cock"],
        index: "1.5 1.5 1.5",
    },
    Substance {
        names: &["water", "voda", "vody", "vodou", "vodni"],
        index: "1.33 1.33 1.33",
    },
    Substance {
        names: &["diamond", "diamant"],
        index: "2.42 2.42 2.42",
    },
];

/// The findings, one for each substance.
pub(super) fn called(context: &Context, root: NodeId, kinds: &[Parts]) -> Vec<Diagnostic> {
    let has_index = |kind: RecordKind| kind == RecordKind::RefractiveIndex;
    let has_comment = || {
        context
            .document
            .tokens
            .iter()
            .any(|t| t.kind().is_comment())
    };
    if !has_comment() {
        return Vec::new();
    }
    let scene = context.scene;
    let is_like: Test = match context.records().any(|r| has_index(r.kind)) {
        true => |o| lets_through(o) && !is_glass(o),
        false => |o| lets_through(o) && !is_clear(o),
    };
    let Some(all) = members(context, root, is_like) else {
        return Vec::new();
    };
    let captions = Captions::of(context.document, context.text);
    let mut comments: FxHashMap<u32, String> = FxHashMap::default();
    for record in context.records() {
        let last = &context.document.tokens[record.last as usize];
        *comments.entry(record.id).or_default() += &behind(context, last.start);
    }
    let mut told = FxHashSet::default();
    let mut objects: [Vec<(Named, Origin)>; SUBSTANCES.len()] = Default::default();
    for part in all.iter().filter(|m| m.is_plain() && m.is_solid(kinds)) {
        let (Some(object), Some(paint)) = (named(scene, part.node), part.paint) else {
            continue;
        };
        let record = scene.origins[paint as usize];
        if !told.insert(paint) {
            continue;
        }
        let of = |id: u32| {
            let lines = comments.get(&id).map_or("", String::as_str);
            [captions.get(id).unwrap_or_default(), lines].join(" ")
        };
        let said = [of(record.id), of(object.id)].join(",");
        let clauses = || said.split([',', ';', '#']).filter(|c| !words::denies(c));
        let is_said = |s: &Substance| clauses().any(|clause| words::has(clause, s.names));
        if let Some(place) = SUBSTANCES.iter().position(is_said) {
            objects[place].push((object, record));
        }
    }
    let cases = ["called", "called-several"];
    let findings = SUBSTANCES
        .iter()
        .zip(&objects)
        .filter_map(|(s, objects)| finding(context, objects, cases, s.index));
    findings.collect()
}

/// The comments on the line behind a place, each with a space before it.
fn behind(context: &Context, place: u32) -> String {
    let tokens = &context.document.tokens;
    let first = tokens.partition_point(|t| t.start < place);
    let on_line = tokens[first..]
        .iter()
        .take_while(|t| t.kind() != TokenKind::Newline);
    let comments = on_line.filter(|t| t.kind().is_comment());
    comments.fold(String::new(), |all, t| all + " " + t.text(context.text))
}
