//! Slips that show on many lines: the minus of all types is lost, an object has the ID of the render record, two scenes
//! are in one file, definitions need each other.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{characters, slashes};
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::Entity;
use crate::syntax::ast::Record;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Effect, ParamKind, RecordKind, RecordType};
use crate::syntax::{Item, quote};

/// A finding about many lines, and the spans of the errors that it stands for.
pub(super) struct Matter {
    pub finding: Diagnostic,
    pub spans: Vec<Span>,
}

type Find = fn(&Analysis, &[Diagnostic]) -> Option<Matter>;

pub(super) const ALL: [Find; 5] = [slashes::comments, dashes, minus, scenes, reserved];

/// The fewest records with the same slip that count as a habit.
const MIN_HABIT_RECORDS: usize = 3;

/// The most findings about an ID of a wrong kind that are examined.
const MISUSED: usize = 8;

/// Whether a finding stands for many lines, or proposes to move definitions.
pub(super) fn is_of_many(d: &Diagnostic) -> bool {
    let is_moved = d.code == Code::E107 && d.case != "changed" && !d.fixes.is_empty();
    is_moved
        || matches!(
            d.case,
            "slashes" | "dashes" | "minus" | "scenes" | "renders" | "objects"
        )
}

/// Finds typographic dashes that stand for minus signs on many lines, as in text that was copied from a PDF file.
fn dashes(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Matter> {
    let source = &analysis.source;
    let text = source.text.as_str();
    if !findings
        .iter()
        .any(|d| matches!(d.code, Code::E003 | Code::E006 | Code::E012))
    {
        return None;
    }
    let mut edits: Vec<Edit> = Vec::new();
    let mut lines: Vec<usize> = Vec::new();
    for token in &analysis.document.tokens {
        let is_word = matches!(token.kind(), TokenKind::MalformedNumber | TokenKind::Word);
        let written = token.text(text);
        if is_word
            && characters::has_dash(written)
            && let Some(number) = characters::number(written)
        {
            edits.push(edit(token.span(), number));
            lines.push(source.line_index(token.start));
        }
    }
    lines.dedup();
    let first = edits.first().filter(|_| lines.len() >= MIN_HABIT_RECORDS)?;
    let finding = Diagnostic::new(Code::E003, first.span)
        .case("dashes")
        .with("text", crate::syntax::quote(source.slice(first.span)))
        .with("count", Value::Count(edits.len() as u64))
        .fix(Fix::guess("fix", edits));
    let spans = lines.into_iter().map(|line| source.line_span(line));
    let spans = spans.collect();
    Some(Matter { finding, spans })
}

/// Finds types that have lost their minus: in all records of a type, or in all records whose type has a minus.
fn minus(analysis: &Analysis, _: &[Diagnostic]) -> Option<Matter> {
    let text = analysis.source.text.as_str();
    // The types that have their minus in some record.
    let mut signed: FxHashSet<i32> = FxHashSet::default();
    let mut lost: Vec<(&'static RecordType, Token, Span)> = Vec::new();
    let lines = analysis
        .document
        .tokens
        .split(|t| t.kind() == TokenKind::Newline);
    for line in lines {
        let mut tokens = line.iter().filter(|t| !t.kind().is_trivia());
        let (Some(id), Some(ty), params) = (tokens.next(), tokens.next(), tokens) else {
            continue;
        };
        let (Some(1..), Some(code)) = (id.integer(text), ty.integer(text)) else {
            continue;
        };
        let fits = |ty: &RecordType| {
            let first = params.clone().next().and_then(|t| t.integer(text));
            let count = match ty.is_counted() {
                // A profile has two points at least.
                true => first
                    .and_then(|n| u64::try_from(n).ok())
                    .filter(|&n| n >= 2),
                false => Some(0),
            };
            let n = params.clone().count() as u64;
            count.is_some_and(|count| {
                n == ty.arity(count) || n == ty.arity(count) + ty.optional.len() as u64
            })
        };
        let own = RecordType::by_code(code);
        if code < 0 {
            signed.extend(own.map(|ty| ty.code));
        } else if let Some(meant) = code.checked_neg().and_then(RecordType::by_code)
            && fits(meant)
            && !own.is_some_and(fits)
        {
            let last = params.clone().next_back().unwrap_or(ty);
            lost.push((meant, *ty, id.span().to(last.span())));
        }
    }
    if !signed.is_empty() {
        let mut counts: FxHashMap<i32, usize> = FxHashMap::default();
        for (ty, ..) in &lost {
            *counts.entry(ty.code).or_default() += 1;
        }
        lost.retain(|(ty, ..)| !signed.contains(&ty.code) && counts[&ty.code] >= MIN_HABIT_RECORDS);
    }
    let count = lost.len();
    let &(first, token, _) = lost.first().filter(|_| count >= MIN_HABIT_RECORDS)?;
    let alike = lost.iter().all(|l| l.0.code == first.code);
    let edits = lost
        .iter()
        .map(|(ty, token, _)| edit(token.span(), ty.code.to_string()));
    let finding = Diagnostic::new(Code::E007, token.span())
        .case("minus")
        .with("count", Value::Count(count as u64))
        .with("number", first.code.to_string())
        .with("type", Value::Term(first.title))
        .with("kinds", if alike { "one" } else { "many" })
        .fix(Fix::guess("fix", edits.collect()));
    Some(Matter {
        finding,
        spans: lost.into_iter().map(|l| l.2).collect(),
    })
}

fn edit(span: Span, text: impl Into<String>) -> Edit {
    Edit {
        span,
        text: text.into(),
    }
}

pub(super) fn records(analysis: &Analysis) -> impl Iterator<Item = &Record> {
    analysis.document.items.iter().filter_map(Item::record)
}

/// The references of a record: their tokens and IDs.
pub(super) fn references<'a>(
    analysis: &'a Analysis,
    record: &'a Record,
) -> impl Iterator<Item = (Token, i64)> {
    let text = analysis.source.text.as_str();
    (analysis.document.params(record).enumerate()).filter_map(move |(i, token)| {
        let param = record.ty().param(i, record.count())?;
        match param.kind {
            ParamKind::Reference { .. } => Some((*token, token.integer(text)?)),
            _ => None,
        }
    })
}

fn largest(analysis: &Analysis) -> u32 {
    records(analysis).map(|r| r.id).max().unwrap_or(1)
}

/// Finds an object with ID 1, which is that of the render record, and proposes another ID for the object.
fn reserved(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Matter> {
    let is_other = |d: &&Diagnostic| d.code == Code::E105 && d.case == "other";
    let first = findings.iter().find(is_other)?.clone();
    // The only undefined ID may be meant for that object, or the only ID that is used as an object but defined by a
    // colour alone.
    let (undefined, misused) = (super::undefined(findings), misused(analysis, findings));
    if undefined.is_empty()
        && misused.is_empty()
        && let Some((head, id)) = change_of_object_above(analysis)
    {
        let (span, id) = (head.span(), id.to_string());
        let fix = Fix::replace("fix-write", Applicability::Unsafe, span, id.clone());
        return Some(Matter {
            finding: first.fix(fix.with("number", quote(&id))),
            spans: vec![span],
        });
    }
    let new = match (&undefined[..], &misused[..]) {
        (&[id], _) | ([], &[id]) => id,
        _ => largest(analysis).checked_add(1)?.max(2),
    };
    let new = new.to_string();
    let mut edits: Vec<Edit> = Vec::new();
    let mut spans: Vec<Span> = Vec::new();
    for record in records(analysis) {
        let before = edits.len();
        if record.id == 1 && record.kind != RecordKind::Render {
            let head = analysis.document.id_token(record).span();
            edits.push(edit(head, new.clone()));
        }
        let named = references(analysis, record).filter(|r| r.1 == 1);
        edits.extend(named.map(|r| edit(r.0.span(), new.clone())));
        spans.extend(edits[before..].iter().map(|e| e.span));
    }
    let is_explained = |d: &&Diagnostic| super::named(d).is_some_and(|id| id.to_string() == new);
    spans.extend((findings.iter().filter(is_explained)).map(|d| d.span));
    let mut finding = first.fix(Fix {
        title: "fix",
        values: vec![("number", new.into())],
        applicability: Applicability::Unsafe,
        edits,
    });
    finding.case = "objects";
    Some(Matter { finding, spans })
}

/// The ID token of the only record but the render record that has the ID 1, if nothing names that ID, and the ID of the
/// object whose records stand right above: the record gives the object something that it has not yet.
fn change_of_object_above(analysis: &Analysis) -> Option<(Token, u32)> {
    let all: Vec<&Record> = records(analysis).collect();
    let is_stray = |r: &&Record| r.id == 1 && r.kind != RecordKind::Render;
    let mut strays = all.iter().enumerate().filter(|(_, r)| is_stray(r));
    let ((at, stray), None) = (strays.next()?, strays.next()) else {
        return None;
    };
    let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = stray.ty().effect else {
        return None;
    };
    let above = all[at.checked_sub(1)?].id;
    let is_object = |e: &Entity| e.id == above && e.kind.is_some_and(|kind| kinds.contains(&kind));
    let is_named = || (all.iter()).any(|r| references(analysis, r).any(|named| named.1 == 1));
    let has_such = || all.iter().any(|r| r.id == above && r.kind == stray.kind);
    let fits = analysis.scene.entities.iter().any(is_object) && !is_named() && !has_such();
    fits.then(|| (*analysis.document.id_token(stray), above))
}

/// The IDs that are used as objects, but that only a property record defines, such as a colour: if there was an object
/// with that ID, the record would have changed it.
fn misused(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<u32> {
    let is_misused = |d: &&Diagnostic| d.code == Code::E103;
    let mut all: Vec<u32> = (findings.iter().filter(is_misused))
        .filter_map(super::named)
        .take(MISUSED)
        .collect();
    all.sort_unstable();
    all.dedup();
    all.retain(|&id| {
        let defining = records(analysis).filter(|r| r.id == id);
        let mut effects = defining.map(|r| r.ty().effect);
        let all_may_change = !effects.any(|effect| matches!(effect, Effect::Defines(_)));
        all_may_change && analysis.definition(id).is_some()
    });
    all
}

/// Finds two scenes in one file: what follows the first render record is a scene by itself. The fix joins both by a
/// union, and gives new IDs to the second one where both use the same IDs.
fn scenes(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Matter> {
    let doubled = || findings.iter().filter(|d| d.code == Code::E102);
    if doubled().count() < MIN_HABIT_RECORDS && !doubled().any(|d| d.case == "render") {
        return None;
    }
    let is_render = |r: &&Record| r.kind == RecordKind::Render;
    let render = records(analysis).find(is_render)?;
    let end = analysis.document.span(render.first, render.last).end;
    let rest = analysis.source.text.get(end as usize..)?;
    let second = Analysis::trial(analysis.source.with_text(rest.to_owned()));
    let last = records(&second).find(is_render)?;
    if !second.is_sound() {
        return None;
    }
    let in_file = |span: Span| Span::new(span.start + end, span.end + end);
    let of_first = |r: &&Record| analysis.document.span(r.first, r.last).end <= end;
    let ids: FxHashMap<u32, Span> = (records(analysis).take_while(of_first))
        .map(|r| (r.id, analysis.document.span(r.first, r.last)))
        .collect();
    let doubled: FxHashSet<u32> = (records(&second).map(|r| r.id))
        .filter(|id| *id > 1 && ids.contains_key(id))
        .collect();
    let by = match doubled.is_empty() {
        true => 0,
        false => 10_u32.checked_pow(ids.keys().max()?.checked_ilog10()? + 1)?,
    };
    let join = largest(&second)
        .checked_add(by)?
        .max(largest(analysis))
        .checked_add(1)?;
    let moved = |id: i64| id.checked_add(by.into()).unwrap_or(id).to_string();
    let (root, other) = (
        references(analysis, render).next()?,
        references(&second, last).next()?,
    );
    let mut edits = vec![edit(root.0.span(), join.to_string())];
    for record in records(&second) {
        if record.kind == RecordKind::Render {
            let text = format!("{join} -101 {} {}", root.1, moved(other.1));
            let all = second.document.span(record.first, record.last);
            edits.push(edit(in_file(all), text));
            continue;
        }
        if by == 0 {
            continue;
        }
        let head = second.document.id_token(record).span();
        edits.push(edit(in_file(head), moved(record.id.into())));
        let named = references(&second, record).filter(|r| r.1 > 1);
        edits.extend(named.map(|r| edit(in_file(r.0.span()), moved(r.1))));
    }
    let first = records(&second).next()?;
    let begin = in_file(second.document.span(first.first, first.last));
    let (case, begun) = match by {
        0 => ("renders", "render"),
        _ => ("scenes", "first"),
    };
    let finding = Diagnostic::new(Code::E102, begin)
        .case(case)
        .with("count", Value::Count(doubled.len() as u64))
        .with("number", by.to_string())
        .label(*ids.get(&first.id).or(ids.get(&1))?, begun)
        .fix(Fix::guess("fix", edits));
    let spans = vec![Span::new(end, end + rest.len() as u32)];
    Some(Matter { finding, spans })
}

/// The most references that are followed in one file to find definitions that need each other.
const FOLLOWED: usize = 100_000;

/// Finds the findings about a use before the definition where the definitions need each other, and adds the IDs of the
/// cycle to them.
pub(super) fn cycles(analysis: &Analysis, findings: &mut [Diagnostic]) {
    if !findings.iter().any(|d| d.code == Code::E107) {
        return;
    }
    let mut needs: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
    let mut at: Vec<(u32, u32, u32)> = Vec::new();
    for record in records(analysis) {
        let span = analysis.document.span(record.first, record.last);
        at.push((span.start, span.end, record.id));
        let late = matches!(
            record.kind,
            RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
        );
        if !late && !matches!(record.ty().effect, Effect::Changes(_)) {
            let named = references(analysis, record).filter_map(|r| u32::try_from(r.1).ok());
            needs.entry(record.id).or_default().extend(named);
        }
    }
    let mut left = FOLLOWED;
    let is_one = |d: &&mut Diagnostic| d.code == Code::E107 && d.case != "changed";
    for d in findings.iter_mut().filter(is_one) {
        let i = at.partition_point(|r| r.1 <= d.span.start);
        let own = at.get(i).filter(|r| r.0 <= d.span.start).map(|r| r.2);
        let named = analysis.source.slice(d.span).parse::<u32>().ok();
        let (Some(own), Some(named)) = (own, named) else {
            continue;
        };
        if let Some(members) = path(&needs, named, own, &mut left) {
            let all: Vec<String> = members.iter().map(u32::to_string).collect();
            d.case = "cycle";
            d.values.push(("own", own.to_string().into()));
            d.values.push(("members", all.join(" → ").into()));
        }
    }
}

/// The shortest path from one ID to another along the references of definitions. `None` if there is none, or if all of
/// the `left` references are used up.
fn path(
    needs: &FxHashMap<u32, Vec<u32>>,
    from: u32,
    to: u32,
    left: &mut usize,
) -> Option<Vec<u32>> {
    let mut reached: FxHashMap<u32, u32> = FxHashMap::default();
    let mut queue = std::collections::VecDeque::from([from]);
    while let Some(id) = queue.pop_front() {
        if id == to {
            let mut out = vec![to];
            let mut at = to;
            while at != from {
                at = reached[&at];
                out.push(at);
            }
            out.reverse();
            return Some(out);
        }
        for &next in needs.get(&id).map_or(&[][..], Vec::as_slice) {
            *left = left.checked_sub(1)?;
            if next != from && !reached.contains_key(&next) {
                reached.insert(next, id);
                queue.push_back(next);
            }
        }
    }
    None
}
