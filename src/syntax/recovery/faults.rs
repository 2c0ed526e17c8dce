//! Faults of a piece that is no record, and their prices.

use super::super::hex;
use super::super::lexer::TokenKind;
use super::super::signature::{allows, fits};
use super::super::table::{Effect, Param, ParamKind, RecordKind, RecordType};
use super::diagnosis::Diagnosis;
use super::heads::{end_of, expected_ends, integral, point_count, type_at, type_behind_stray};
use super::id_context::IdContext;
use super::prices::{
    CUT_OFF, FAULT, FEW_OFF, IN_ORDER, LEAST_PRICE, NOTHING_WRONG, ONE_OFF, REALS,
    TYPE_AS_COORDINATE,
};
use super::slips::LEAST_HEAD;
use super::stretch::{MIN_LONG_PARAMS, Stretch};

/// Finds what is wrong with tokens `start..end`, and its price, which is at least [`LEAST_PRICE`].
pub(super) fn judge(
    stretch: &Stretch,
    start: usize,
    end: usize,
    known: &impl IdContext,
) -> (Diagnosis, u32) {
    let found = likeliest(stretch, start, end, known);
    debug_assert!(found.1 >= LEAST_PRICE, "{found:?}");
    found
}

fn likeliest(
    stretch: &Stretch,
    start: usize,
    end: usize,
    known: &impl IdContext,
) -> (Diagnosis, u32) {
    let id = &stretch.sigs[start];
    if end == start + 1 && id.kind.is_bad() {
        return (Diagnosis::BadId { ty: None }, FAULT + 10);
    }
    if let Some(ty) = all_but_reals(stretch, start, end) {
        return (Diagnosis::Reals { ty }, REALS);
    }
    if let Some(swapped) = swapped(stretch, start, end) {
        return swapped;
    }
    if let Some(word) = one_word(stretch, start, end) {
        return word;
    }
    let good_id = id.int.is_some_and(|id| id > 0);
    let ty = (start + 1 < end)
        .then(|| type_at(stretch, start + 1))
        .flatten();
    let behind_stray = type_behind_stray(stretch, start + 1).filter(|_| start + 2 < end);
    let with_id = match (ty, behind_stray) {
        (Some(ty), _) => judge_params(stretch, ty, start + 2, end),
        // The error is the stray token; if the rest is right, it is the only one.
        (None, Some(ty)) if end_of(stretch, start + 3, ty) == Some(end as u64) => {
            (Diagnosis::BadType, FAULT)
        }
        (None, _) => untyped(stretch, start, end),
    };
    let surplus = surplus(stretch, (start, end), with_id.1, known);
    let sign = || sign_of_known_type(stretch, start, end, known);
    let is_split = surplus.is_some_and(|(verdict, _)| is_split(stretch, start, verdict));
    let sign = (good_id && !is_split).then(sign).flatten();
    if let Some(slip) = sign.or(surplus) {
        return slip;
    }
    if good_id {
        let lost = lost_id(stretch, start, end).filter(|_| {
            let missing = id.int.is_some_and(|id| known.is_missing(id));
            // `5 0 1 2 3` is an undefined object, unless something else must be here.
            let undefined = ty.is_some_and(|t| t.kind == RecordKind::Undefined)
                && is_between(stretch, start)
                && !id.int.is_some_and(|id| known.misses_another(id));
            !missing && !undefined
        });
        let taken = id.int.is_some_and(|id| known.is_defined(id));
        let in_order = if !taken && follows(stretch, start, known) {
            IN_ORDER
        } else {
            0
        };
        return match lost {
            Some((verdict, price)) if price + in_order < with_id.1 => (verdict, price + in_order),
            _ => with_id,
        };
    }
    // A number that can be no ID may stand in front of a correct operation or property, or of a record that defines a
    // missing ID.
    let line = stretch.line(start);
    let is_meant = |ty: &RecordType| {
        ty.code <= LEAST_HEAD || matches!(ty.effect, Effect::Defines(_)) && known.misses_next(line)
    };
    let is_right = with_id.1 >= NOTHING_WRONG && ty.is_some_and(is_meant);
    let changes = |v: &Diagnosis| matches!(v, Diagnosis::LostId { ty } if matches!(ty.effect, Effect::Changes(_)));
    if let Some(lost) = lost_id(stretch, start, end).filter(|(v, _)| !(is_right && changes(v))) {
        return lost;
    }
    // The ID itself is the fault; what is behind it may be right. A `0` that introduces a comment
    // is no ID gone wrong.
    let void = if id.int == Some(0) && id.before_comment {
        FAULT
    } else {
        0
    };
    // An ID that is spelled as a real is an ID all the same: other mistakes in its record are reported, and references
    // to it are right.
    let spelled = integral(stretch, start).is_some_and(|id| id > 0);
    let of_record = with_id.0;
    let (verdict, price) = match with_id {
        (Diagnosis::Damaged { ty }, _) => {
            // A mere sign or word is likelier to stand in front of the ID than in its place.
            let extra = matches!(id.kind, TokenKind::Word | TokenKind::Invalid);
            // An undefined object hardly has a number too many.
            let extra = extra || ty.kind == RecordKind::Undefined;
            // A number that reads like the type of an operation or a property is hardly a coordinate.
            let head = stretch.record_type(start + 2);
            let extra = extra || head.is_some_and(|t| t.code <= LEAST_HEAD);
            let price = FAULT + bad_price(stretch, start + 2, end) + if extra { 50 } else { 0 };
            (Diagnosis::BadId { ty: Some(ty) }, price + void)
        }
        (Diagnosis::CutOff { ty }, price) => (Diagnosis::BadId { ty }, price + FAULT + void),
        (_, price) => {
            let ty = ty.filter(|t| t.kind != RecordKind::Undefined);
            let bad = bad_price(stretch, start + 1, end);
            // Words on several lines are several mistakes.
            let is_text = id.kind == TokenKind::Word && ty.is_none();
            let is_more = is_text && stretch.line(end - 1) > stretch.line(start);
            let more = if is_more { 2 * FAULT } else { 0 };
            (
                Diagnosis::BadId { ty },
                FAULT + 200 + price.min(200) + bad + void + more,
            )
        }
    };
    match of_record {
        Diagnosis::CutOff { .. } => (verdict, price),
        of_record if spelled => (of_record, price),
        _ => (verdict, price),
    }
}

/// The number that tokens `at` and `at + 1` make without the space between them; `None` if they are not digits.
pub(super) fn joined(stretch: &Stretch, at: usize) -> Option<i32> {
    if at + 1 >= stretch.len() {
        return None;
    }
    let [one, two] = [at, at + 1].map(|i| stretch.token(i).text(stretch.text()));
    let digits = |text: &str| text.len() < 6 && text.bytes().all(|b| b.is_ascii_digit());
    let right = digits(two) && digits(one.strip_prefix('-').unwrap_or(one));
    right.then(|| format!("{one}{two}").parse().ok())?
}

/// Whether a record has a token too many because a space cuts its ID in two.
fn is_split(stretch: &Stretch, start: usize, verdict: Diagnosis) -> bool {
    matches!(verdict, Diagnosis::Surplus { id, .. } if joined(stretch, start) == i32::try_from(id).ok())
}

/// Finds a whole line that is a record but for a token too many in front of it or behind its ID, or for a space in its
/// ID. Other lines must speak for the ID: a new ID is needed there, and a changed ID is defined there. `as_typed` is
/// the price of taking the second token for the type.
fn surplus(
    stretch: &Stretch,
    (start, end): (usize, usize),
    as_typed: u32,
    known: &impl IdContext,
) -> Option<(Diagnosis, u32)> {
    let whole_line = stretch.starts_line(start)
        && stretch.ends_line(end)
        && stretch.line(start) == stretch.line(end - 1);
    let ty = stretch
        .record_type(start + 2)
        .filter(|t| t.kind != RecordKind::Undefined && whole_line)?;
    let first = start + 3;
    let n = match ty.is_counted() {
        true => point_count(stretch, first).ok()?,
        false => 0,
    };
    let expected = end.checked_sub(first)?;
    let exact =
        expected as u64 == ty.arity(n) || expected as u64 == ty.arity(n) + ty.optional.len() as u64;
    let right = exact
        && (first..end.min(first + VALUES_MAX)).all(|at| {
            let param = ty.param(at - first, n as usize);
            param.is_some_and(|p| {
                fits(stretch.sigs[at].kind, p.kind) && allows(p, stretch.value(at))
            })
        });
    let is_typed = stretch.record_type(start + 1).is_some();
    let lost_sign = !is_typed && lost_sign(stretch, start, end);
    if !right || lost_sign || stretch.bad(start, first) > 0 {
        return None;
    }
    // A real is no ID.
    let own = stretch.sigs[start].int.unwrap_or(0);
    let speaks = |id: i32| match ty.effect {
        Effect::Changes(_) => known.is_defined(id),
        _ if ty.kind == RecordKind::Render => id == 1,
        _ => known.is_missing(id),
    };
    let is_own = known.is_missing(own);
    let in_front = stretch.sigs[start + 1].int.filter(|_| !is_own);
    // An ID in order speaks for itself, if the second token is hardly the type.
    let is_new = !matches!(ty.effect, Effect::Changes(_));
    let line = stretch.line(start);
    let is_in_order = |id: i32| is_new && known.is_in_order(line, id);
    let no_type = !is_typed || as_typed > FEW_OFF;
    let is_next = |id: i32| no_type && is_in_order(id);
    let has_id = || lost_id(stretch, start, end).is_none();
    let is_next_in_front = |id| is_next(id) && (own == id || !is_next(own));
    // A changed ID is defined elsewhere; but a record that lost its ID or a number may begin with the same number.
    let is_changed = |id: i32| speaks(id) && has_id() && !known.is_in_order(line, own);
    let in_front = in_front.filter(|&id| {
        if is_new {
            speaks(id) || is_next_in_front(id) && (own > 0 || has_id())
        } else {
            is_changed(id)
        }
    });
    // A token that is no type at all is likelier a mistyped type, unless it is the ID once more.
    let doubled = stretch.sigs[start + 1].int == Some(own);
    let behind = if doubled {
        speaks(own) || is_in_order(own)
    } else {
        is_typed && no_type && (speaks(own) || is_next(own)) && has_id()
    };
    let is_joined = |id: i32| speaks(id) || is_in_order(id) && !is_in_order(own);
    let (id, at) = [
        (joined(stretch, start).filter(|&id| is_joined(id)), start),
        (in_front, start),
        (behind.then_some(own), start + 1),
    ]
    .into_iter()
    .find_map(|(id, at)| Some((id.filter(|&id| id > 0)?, at)))?;
    let verdict = Diagnosis::Surplus {
        ty,
        expected,
        at,
        id: id as u32,
    };
    Some((verdict, FAULT - 20))
}

/// Finds a whole line that would be right if its type had a minus sign: a rotation `ID 2 30 1`, which reads as the head
/// of a surface of revolution with 30 points. If a record of the type as it stands might lack numbers instead, the ID
/// must be one that can be changed.
fn sign_of_known_type(
    stretch: &Stretch,
    start: usize,
    end: usize,
    known: &impl IdContext,
) -> Option<(Diagnosis, u32)> {
    let ty = stretch.record_type(start + 1).filter(|_| start + 2 < end)?;
    let meant = RecordType::by_code(-i64::from(ty.code)).filter(|t| t.code < 0)?;
    let whole_line = stretch.starts_line(start)
        && stretch.ends_line(end)
        && stretch.line(start) == stretch.line(end - 1);
    let got = end - start - 2;
    let right = whole_line
        && got as u64 == meant.arity(0)
        && (start + 2..end)
            .zip(meant.params)
            .all(|(at, p)| fits(stretch.sigs[at].kind, p.kind) && allows(p, stretch.value(at)));
    if !right {
        return None;
    }
    let n = match ty.is_counted() {
        true => point_count(stretch, start + 2).unwrap_or(0),
        false => 0,
    };
    let expected = ty.arity(n);
    let line = stretch.line(start);
    let changes = stretch.sigs[start]
        .int
        .is_some_and(|id| known.is_defined_before(stretch, line, id));
    let far = expected > 2 * got as u64 + 2;
    (expected > got as u64 && (far || changes)).then(|| {
        let expected = usize::try_from(expected).unwrap_or(usize::MAX);
        let verdict = Diagnosis::LostSign {
            ty,
            meant,
            got,
            expected,
        };
        (verdict, FAULT - 20)
    })
}

/// Whether a line begins with the number after the first number of the line before. If the line before is a change, the
/// number must be in order as well.
fn follows(stretch: &Stretch, start: usize, known: &impl IdContext) -> bool {
    let line = stretch.line(start);
    if line == 0 || !stretch.starts_line(start) {
        return false;
    }
    let ([before, code], [id, _]) = (stretch.head(line - 1), stretch.head(line));
    let (Some(before @ 1..), Some(id)) = (before, id) else {
        return false;
    };
    let ty = code.and_then(|code| RecordType::by_code(code.into()));
    let changes = ty.is_some_and(|ty| matches!(ty.effect, Effect::Changes(_)));
    before.checked_add(1) == Some(id) && (!changes || known.is_in_order(line, id))
}

/// Whether the first number of a line is between those of the lines before and behind. The ID 1 of a render record
/// counts as the highest.
fn is_between(stretch: &Stretch, start: usize) -> bool {
    let line = stretch.line(start);
    let first = |line: usize| stretch.sigs[stretch.line_start(line)].int;
    let id = first(line);
    let rises = line == 0 || first(line - 1) < id;
    let next = (line + 1 < stretch.line_count()).then(|| first(line + 1));
    rises && next.is_none_or(|next| next == Some(1) || next > id)
}

/// The price of the bad tokens among `from..to`. It is the same in every reading, so that no reading is cheaper because
/// it swallows them.
pub(super) fn bad_price(stretch: &Stretch, from: usize, to: usize) -> u32 {
    FAULT * stretch.bad(from, to).min(BAD_MAX)
}

/// How many bad tokens of one piece are counted at most.
pub(super) const BAD_MAX: u32 = 1_000_000;

/// The type of a whole line that is a record but for integers spelled as reals; `None` for any other line.
fn all_but_reals(stretch: &Stretch, start: usize, end: usize) -> Option<&'static RecordType> {
    let whole = |i: usize| integral(stretch, i).is_some();
    let line = start + 1 < end && stretch.starts_line(start) && stretch.ends_line(end);
    if !line || stretch.line(start) != stretch.line(end - 1) {
        return None;
    }
    let id = stretch.sigs[start]
        .int
        .map(i64::from)
        .or_else(|| integral(stretch, start));
    id.filter(|&id| id > 0)?;
    let code = stretch.sigs[start + 1].int.map(i64::from);
    let ty = RecordType::by_code(code.or_else(|| integral(stretch, start + 1))?)?;
    let n = match ty.is_counted() {
        true => point_count(stretch, start + 2).ok()?,
        false => 0,
    };
    let got = (end - start - 2) as u64;
    let exact = got == ty.arity(n) || got == ty.arity(n) + ty.optional.len() as u64;
    if !exact {
        return None;
    }
    // Where no integer is spelled as a real, nothing of this kind is wrong.
    let mut respelled = stretch.sigs[start].int.is_none() || code.is_none();
    for i in start + 2..end {
        let param = ty.param(i - start - 2, n as usize)?;
        if !fits(stretch.sigs[i].kind, param.kind) {
            if param.kind == ParamKind::FileName || !whole(i) {
                return None;
            }
            respelled = true;
        }
    }
    respelled.then_some(ty)
}

/// A line `9999 1 …` that would be the render record with its first two numbers swapped.
fn swapped(stretch: &Stretch, start: usize, end: usize) -> Option<(Diagnosis, u32)> {
    let whole_line = stretch.starts_line(start) && stretch.ends_line(end);
    if !whole_line || stretch.line(start) != stretch.line(end - 1) || end < start + 2 {
        return None;
    }
    let ty = stretch
        .record_type(start)
        .filter(|t| t.kind == RecordKind::Render)?;
    let got = end - start - 2;
    let exact = got == ty.params.len() || got == ty.params.len() + ty.optional.len();
    let right = stretch.sigs[start + 1].int == Some(1)
        && exact
        && wrong_kinds(stretch, ty, start + 2, end) == 0;
    right.then_some((Diagnosis::Swapped, FAULT - 20))
}

/// A line `7 -701 ff8000`, `7 -701 red` or `7 -201 glass`: one word in the place of all numbers of a record.
fn one_word(stretch: &Stretch, start: usize, end: usize) -> Option<(Diagnosis, u32)> {
    let whole_line = stretch.starts_line(start) && stretch.ends_line(end);
    if !whole_line || end != start + 3 || stretch.sigs[start].int.is_none_or(|id| id <= 0) {
        return None;
    }
    let is_number = |p: &Param| matches!(p.kind, ParamKind::Real);
    let ty = stretch
        .record_type(start + 1)
        .filter(|t| t.code <= LEAST_HEAD && t.params.len() > 1 && t.params.iter().all(is_number))?;
    let word = stretch.token(start + 2).text(stretch.text());
    let is_name = word
        .chars()
        .all(|c| c.is_alphabetic() || c == '-' || c == '"');
    let is_colour = ty.kind == RecordKind::Colour && hex::colour(word).is_some();
    if !is_name && !is_colour {
        return None;
    }
    let verdict = Diagnosis::WrongArity {
        ty,
        got: 1,
        expected: ty.params.len(),
    };
    Some((verdict, FAULT - 20))
}

/// Whether a record of unknown type would be right with a minus sign before the type.
pub(super) fn lost_sign(stretch: &Stretch, start: usize, end: usize) -> bool {
    let code = stretch.sigs[start + 1].int.map(i64::from);
    let ty = code
        .filter(|&c| c > 0)
        .and_then(|c| RecordType::by_code(-c));
    ty.is_some_and(|ty| end_of(stretch, start + 2, ty) == Some(end as u64))
}

fn untyped(stretch: &Stretch, start: usize, end: usize) -> (Diagnosis, u32) {
    let Some(t) = stretch.sigs.get(start + 1).filter(|_| start + 1 < end) else {
        let cut = stretch.has_unclosed_comment(start, end);
        return match cut {
            true => (Diagnosis::CutOff { ty: None }, CUT_OFF),
            false => (Diagnosis::MissingType, FAULT + 60),
        };
    };
    let length = 10 * (end - start).min(20) as u32;
    // A piece over several lines must be as long as a record that is laid out so.
    let over_lines = stretch.line(end - 1) > stretch.line(start);
    // A word on the next line is no type.
    let is_text = t.kind == TokenKind::Word && stretch.line(start + 1) > stretch.line(start);
    let plausible = !over_lines || !is_text && expected_ends(stretch, start).contains(&end);
    let penalty = if plausible { 0 } else { 2 * FAULT };
    let bad = bad_price(stretch, start + 2, end);
    match t.int {
        // A lost sign is likelier than a lost ID.
        Some(_) if lost_sign(stretch, start, end) => (Diagnosis::UnknownType, FAULT - 20 + bad),
        Some(_) => (Diagnosis::UnknownType, FAULT + 30 + penalty + bad),
        None => (Diagnosis::BadType, FAULT + 30 + length / 10 + penalty + bad),
    }
}

/// Judges the parameters `first..end` of a record whose type is known.
fn judge_params(
    stretch: &Stretch,
    ty: &'static RecordType,
    first: usize,
    end: usize,
) -> (Diagnosis, u32) {
    let got = end - first;
    let cut_off = || stretch.has_unclosed_comment(first - 1, end.max(first));
    let mut real_type = 0;
    if stretch.sigs[first - 1].int.is_none() {
        real_type = FAULT;
    }
    let n = match ty.is_counted() {
        true if got == 0 => {
            return match cut_off() {
                true => (Diagnosis::CutOff { ty: Some(ty) }, CUT_OFF),
                false => (Diagnosis::BadPointCount { ty }, FAULT + real_type),
            };
        }
        true => match point_count(stretch, first) {
            Ok(n) if stretch.line(first) == stretch.line(first - 1) => n,
            Ok(n) if ty.arity(n) == got as u64 => n,
            _ => {
                let bad = bad_price(stretch, first + 1, end);
                return (Diagnosis::BadPointCount { ty }, FAULT + real_type + bad);
            }
        },
        false => 0,
    };
    let named = file_name(stretch, ty, first, end).is_some();
    let bad = stretch.bad(first, end) as usize - usize::from(named);
    let base = ty.arity(n);
    let full = base + ty.optional.len() as u64;
    for expected in [base, full] {
        let (got, bad) = (got as u64, bad as u64);
        if got.saturating_sub(bad) <= expected && expected <= got {
            let kinds = wrong_kinds(stretch, ty, first, end);
            let mistakes = (bad.min(u64::from(BAD_MAX)) as u32).max(kinds) * FAULT + real_type;
            if mistakes > 0 {
                return (Diagnosis::Damaged { ty }, mistakes);
            }
            if ty.optional.is_empty() {
                return (Diagnosis::Damaged { ty }, NOTHING_WRONG);
            }
            // Only the end of the line is wrong: the optional parameters are not the last numbers of the line, or the
            // numbers that follow are the optional parameters.
            let (got, other) = (end - first, if expected == base { full } else { base });
            let expected = usize::try_from(other).unwrap_or(usize::MAX);
            return (Diagnosis::WrongArity { ty, got, expected }, 2 * FAULT);
        }
    }
    if cut_off() && (got as u64) < full {
        return (Diagnosis::CutOff { ty: Some(ty) }, CUT_OFF);
    }
    let expected = match full.abs_diff(got as u64) < base.abs_diff(got as u64) {
        true => full,
        false => base,
    };
    // A little more or less is a slip of the pen; hundreds are other records.
    let off = expected.abs_diff(got as u64).min(100_000) as u32;
    let off = if ty.is_counted() { off.min(40) } else { off };
    let verdict = Diagnosis::WrongArity {
        ty,
        got,
        expected: usize::try_from(expected).unwrap_or(usize::MAX),
    };
    (
        verdict,
        FAULT + real_type + ONE_OFF * off + FAULT * (bad as u32).min(BAD_MAX),
    )
}

/// The token that is the file name of a record whose type has one. It is a word, but no bad token.
pub(super) fn file_name(
    stretch: &Stretch,
    ty: &RecordType,
    first: usize,
    end: usize,
) -> Option<usize> {
    if ty.params.first()?.kind != ParamKind::FileName {
        return None;
    }
    (first..end).find(|&i| fits(stretch.sigs[i].kind, ParamKind::FileName))
}

/// How many parameters are numbers of the wrong kind (a real for an integer, a number for a name).
pub(super) fn wrong_kinds(
    stretch: &Stretch,
    ty: &'static RecordType,
    first: usize,
    end: usize,
) -> u32 {
    stretch.sigs[first..end]
        .iter()
        .zip(ty.params.iter().chain(ty.optional))
        .filter(|(s, p)| !fits(s.kind, p.kind))
        .count() as u32
}

/// Whether the tokens would be a whole record if an ID stood in front.
pub(super) fn has_lost_id(stretch: &Stretch, start: usize, end: usize) -> bool {
    lost_id(stretch, start, end).is_some()
}

fn lost_id(stretch: &Stretch, start: usize, end: usize) -> Option<(Diagnosis, u32)> {
    let ty = stretch
        .record_type(start)
        .filter(|t| t.kind != RecordKind::Undefined)?;
    // A negative number can only be a type. A positive number is taken for one only at the head of a whole line.
    let whole_line = stretch.starts_line(start) && stretch.ends_line(end);
    if ty.code > 0 && !whole_line {
        return None;
    }
    let is_head = |ty: &RecordType| ty.code <= LEAST_HEAD;
    let hardly = ty.code > 0 && stretch.record_type(start + 1).is_some_and(is_head);
    let price = FAULT - 10 + if hardly { TYPE_AS_COORDINATE } else { 0 };
    let n = match ty.is_counted() {
        true => point_count(stretch, start + 1).ok()?,
        false => 0,
    };
    let got = (end - start - 1) as u64;
    let exact = got == ty.arity(n) || got == ty.arity(n) + ty.optional.len() as u64;
    let over_lines = stretch.line(start) != stretch.line(end - 1);
    if over_lines && !(ty.is_counted() || ty.params.len() >= MIN_LONG_PARAMS) {
        return None;
    }
    let right = || {
        (start + 1..end.min(start + 1 + VALUES_MAX))
            .enumerate()
            .all(|(i, at)| {
                let param = ty.param(i, n as usize);
                param.is_some_and(|p| {
                    fits(stretch.sigs[at].kind, p.kind) && allows(p, stretch.value(at))
                })
            })
    };
    (exact && right()).then_some((Diagnosis::LostId { ty }, price))
}

/// How many values of a long record are looked at to judge whether it is plausible.
const VALUES_MAX: usize = 64;
