//! W342: an object that a comment calls a mirror or glass, with the optics (-201) of something else, or with none.

use std::cell::LazyCell;

use rustc_hash::{FxHashMap, FxHashSet};

use super::overridden_property::MAX_PROPOSED;
use super::unused_definition;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::syntax::table::{Family, Kind, RecordKind, RecordType};
use crate::syntax::words;
use crate::syntax::{Record, quote};

/// A kind of optics, and the words for it, without accents.
struct Look {
    /// Nouns. A noun counts if the next word names a shape, or if it is the last word.
    nouns: &'static [&'static str],
    /// Beginnings of adjectives.
    adjectives: &'static [&'static str],
    /// The index of the parameter that is the greatest one in optics of this kind: 1 for ks, 2 for kt.
    part: usize,
    /// The cases of the finding: the object has other optics, or none.
    cases: [&'static str; 2],
    /// Records, without their ID, that give an object these optics.
    lines: &'static [&'static str],
}

const LOOKS: [Look; 2] = [
    Look {
        nouns: &["mirror", "zrcadlo"],
        adjectives: &["zrcadlov", "zrcadlic"],
        part: 1,
        cases: ["", "none"],
        lines: &["-201 0.1 0.85 0"],
    },
    Look {
        nouns: &["glass", "sklo"],
        adjectives: &["sklenen"],
        part: 2,
        cases: ["glass", "glass-none"],
        lines: &["-201 0.05 0.1 0.85", "-203 1.5 1.5 1.5"],
    },
];

/// Comments of more words are about something else.
const MAX_COMMENT_WORDS: usize = 5;
/// Words that show that a comment speaks of something beside a mirror or glass, without accents.
const BESIDE: [&str; 24] = [
    "in", "on", "under", "behind", "for", "of", "with", "without", "and", "or", "looking", "like",
    "v", "ve", "na", "pod", "za", "u", "pro", "bez", "s", "se", "nebo", "jako",
];
/// The least part of the light that counts as present in optics, and the greatest one that counts as missing.
const LEAST_PART: f64 = 0.5;
const MAX_LACKED_PART: f64 = 0.1;
/// Largest difference between 1 and the sum of a colour's parts, if the colour may be meant as optics.
const SUM_EPS: f64 = 1e-9;

/// Objects and optics that a comment calls a mirror or glass.
struct Called<'a> {
    /// For each ID the first record with a comment that calls it so, and the kind of optics.
    looks: Vec<(&'a Record, &'static Look)>,
    /// For each ID the records that give optics.
    optics: FxHashMap<u32, Vec<&'a Record>>,
    /// For each ID the records that give a colour.
    colours: FxHashMap<u32, Vec<&'a Record>>,
}

impl<'a> Called<'a> {
    fn of(context: &Context<'a>) -> Called<'a> {
        let mut called = Called {
            looks: Vec::new(),
            optics: FxHashMap::default(),
            colours: FxHashMap::default(),
        };
        if !context.document.contents.comments {
            return called;
        }
        let mut told: FxHashSet<u32> = FxHashSet::default();
        for record in context.records() {
            let of_kind = match record.kind {
                RecordKind::Colour => Some(&mut called.colours),
                _ => gives_optics(record).then_some(&mut called.optics),
            };
            if let Some(all) = of_kind {
                all.entry(record.id).or_default().push(record);
            }
            let is_solid =
                record.ty().family == Family::Shape || super::OPERATIONS.contains(&record.kind);
            if !is_solid && !super::OPTICS.contains(&record.kind) {
                continue;
            }
            let p = context.record_params(record);
            let look = p.comments().find_map(|text| look(text, &p));
            if let Some(look) = look
                && told.insert(record.id)
            {
                called.looks.push((record, look));
            }
        }
        called
    }

    /// The only optics of an ID, if they are written in one record (-201).
    fn only(&self, id: u32) -> Option<&'a Record> {
        match self.optics.get(&id).map(Vec::as_slice) {
            Some(&[only]) if only.kind == RecordKind::Optics => Some(only),
            _ => None,
        }
    }

    /// The guess that optics of that look right behind a shape are its own: they are given to another object, which no
    /// comment calls so.
    fn given_to_another(&self, context: &Context, shape: &Record, look: &Look) -> Option<Fix> {
        let mut below = context.records().skip_while(|r| r.first <= shape.first);
        let optics = below.find(|r| r.id != shape.id)?;
        let p = context.record_params(optics);
        let mut entities = context.scene.entities.iter();
        let other = entities.find(|e| e.id == optics.id)?;
        let is_another = other.kind == Some(Kind::Object)
            && other.span.start < p.span().start
            && !self.looks.iter().any(|(r, _)| r.id == optics.id)
            && p.own_comments().next().is_none();
        if optics.kind != RecordKind::Optics || p.number(look.part) < LEAST_PART || !is_another {
            return None;
        }
        let id = shape.id.to_string();
        let fix = Fix::replace("fix-id", Applicability::Unsafe, p.id_span(), id.clone());
        Some(fix.with("number", quote(&id)))
    }
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let called = Called::of(context);
    if called.looks.is_empty() {
        return;
    }
    let given = context.with_parts(gives_optics);
    let assigned = LazyCell::new(|| unused_definition::assigned_optics(context));
    let indices = context.records();
    let indices = indices.filter(|r| r.kind == RecordKind::RefractiveIndex);
    let indices: FxHashSet<u32> = indices.map(|r| r.id).collect();
    let mut proposed = 0;
    for &(record, look) in &called.looks {
        if let Some(only) = called.only(record.id) {
            out.extend(other(&context.record_params(only), look));
            continue;
        }
        let has_none = !called.optics.contains_key(&record.id) && !given.contains(&record.id);
        if has_none && record.ty().family == Family::Shape {
            let colour = match called.colours.get(&record.id).map(Vec::as_slice) {
                Some(&[only]) => Some(context.record_params(only)),
                _ => None,
            };
            let has_index = indices.contains(&record.id);
            let mut d = none(context, record, colour.as_ref(), look, has_index);
            proposed += 1;
            if proposed <= MAX_PROPOSED
                && let Some(fix) = called.given_to_another(context, record, look)
            {
                d.fixes.insert(0, fix);
            }
            if let Some(assigned) = assigned.as_ref().filter(|a| a.id == record.id) {
                let fix = assigned.fix.clone();
                d.fixes.insert(0, fix.with("line", quote(&assigned.line)));
            }
            out.push(d);
        }
    }
}

/// The IDs whose optics differ from what a comment says: these are wrong before any index is missing.
pub(super) fn with_other_optics(context: &Context) -> FxHashSet<u32> {
    let called = Called::of(context);
    let looks = called.looks.iter();
    let is_other = |record: &Record, look| {
        let only = called.only(record.id)?;
        other(&context.record_params(only), look)
    };
    let others = looks.filter(|(record, look)| is_other(record, look).is_some());
    others.map(|(record, _)| record.id).collect()
}

/// The shapes that lack the optics that a comment claims.
pub(super) fn without_optics(context: &Context) -> FxHashSet<u32> {
    let called = Called::of(context);
    if called.looks.is_empty() {
        return FxHashSet::default();
    }
    let given = context.with_parts(gives_optics);
    let lacking = called.looks.iter().filter(|(record, _)| {
        let is_given = called.optics.contains_key(&record.id) || given.contains(&record.id);
        record.ty().family == Family::Shape && !is_given
    });
    lacking.map(|(record, _)| record.id).collect()
}

/// Whether a comment calls what a record defines a mirror or glass.
pub(super) fn calls(context: &Context, record: &Record) -> bool {
    let p = context.record_params(record);
    p.comments().any(|said| look(said, &p).is_some())
}

fn gives_optics(record: &Record) -> bool {
    super::OPTICS.contains(&record.kind) || record.kind == RecordKind::Assignment
}

/// The kind of optics that a comment claims for the object of a record. `None` if it claims none or both, or seems to
/// be about another object.
fn look(comment: &str, p: &Params) -> Option<&'static Look> {
    let words: Vec<String> = words::of_text(comment)
        .take(MAX_COMMENT_WORDS + 1)
        .collect();
    let is_beside = |w: &String| BESIDE.contains(&w.as_str());
    let is_shape = |w: &String| {
        let shapes = words::shapes(w);
        (!shapes.is_empty()).then(|| shapes.iter().any(|s| s.code == p.ty.code))
    };
    let is_called = |look: &Look| {
        (0..words.len()).any(|i| {
            let word = words[i].as_str();
            let names = || words.get(i + 1).is_none_or(|next| is_shape(next).is_some());
            look.adjectives.iter().any(|a| word.starts_with(a))
                || look.nouns.contains(&word) && names()
        })
    };
    let look = match [is_called(&LOOKS[0]), is_called(&LOOKS[1])] {
        [true, false] => &LOOKS[0],
        [false, true] => &LOOKS[1],
        _ => return None,
    };
    if words.len() > MAX_COMMENT_WORDS || words.iter().any(is_beside) || words::denies(comment) {
        return None;
    }
    let mut shapes = words.iter().filter_map(is_shape);
    let is_another = p.ty.family == Family::Shape && shapes.any(|is_own| !is_own);
    (!is_another).then_some(look)
}

/// The finding about optics in which another part is the greatest, and that of the kind is missing; the fix exchanges
/// the two. `None` for other optics.
fn other(p: &Params, look: &Look) -> Option<Diagnostic> {
    let greatest = (0..3).max_by(|&i, &j| p.number(i).total_cmp(&p.number(j)))?;
    if p.number(greatest) < LEAST_PART || p.number(look.part) > MAX_LACKED_PART {
        return None;
    }
    let mut texts = [0, 1, 2].map(|i| p.text_of(i).to_owned());
    texts.swap(greatest, look.part);
    let mut places = [greatest, look.part];
    places.sort_unstable();
    let edits = places.map(|i| Edit {
        span: p.span_of(i, 1),
        text: texts[i].clone(),
    });
    let fix = Fix::guess("fix", edits.into()).with("number", quote(&texts.join(" ")));
    let d = Diagnostic::new(Code::W342, p.span_of(0, 3)).case(look.cases[0]);
    Some(d.with("id", p.id.to_string()).fix(fix))
}

/// The finding about a shape without optics.
fn none(
    context: &Context,
    record: &Record,
    colour: Option<&Params>,
    look: &Look,
    has_index: bool,
) -> Diagnostic {
    let span = context.document.span(record.first, record.last);
    let d = Diagnostic::new(Code::W342, span)
        .case(look.cases[1])
        .with("id", record.id.to_string());
    let is_parts = |p: &&Params| {
        let parts: [f64; 3] = p.numbers(0);
        p.len() == 3
            && (parts.iter().sum::<f64>() - 1.0).abs() <= SUM_EPS
            && parts[look.part] >= LEAST_PART
    };
    let code = "-201";
    let typed = colour.filter(is_parts).map(|p| {
        let fix = Fix::replace(
            "fix-type",
            Applicability::Choice,
            p.type_span(),
            code.to_owned(),
        );
        fix.with("number", quote(code))
    });
    let index = RecordType::of(RecordKind::RefractiveIndex).code.to_string();
    let is_there = |line: &&&str| has_index && line.split(' ').next() == Some(&index);
    let lines: Vec<String> = look
        .lines
        .iter()
        .filter(|line| !is_there(line))
        .map(|l| format!("{} {l}", record.id))
        .collect();
    let added = context.add_behind(span, "fix", Applicability::Choice, &lines);
    let added = added.with("line", format!("`{}`", lines.join("`, `")));
    typed.into_iter().chain([added]).fold(d, Diagnostic::fix)
}
