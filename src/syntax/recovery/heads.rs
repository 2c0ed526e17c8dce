//! The head of a record, spelled right or not: its type, its number of points, its expected end.

use super::super::lexer::TokenKind;
use super::super::table::{RecordKind, RecordType};
use super::stretch::Stretch;

/// The type that a token stands for, also where it is spelled as a real (`9.0`) or with a sign or
/// letter glued to it (`11?`).
pub(super) fn type_at(stretch: &Stretch, i: usize) -> Option<&'static RecordType> {
    stretch
        .record_type(i)
        .or_else(|| RecordType::by_code(integral(stretch, i).or_else(|| spoiled(stretch, i))?))
}

/// The integer in a token with one sign or letter glued to it. An `e` does not count, since it may be half an exponent.
pub(super) fn spoiled(stretch: &Stretch, i: usize) -> Option<i64> {
    let word = |k| matches!(k, TokenKind::MalformedNumber | TokenKind::Word);
    stretch.sigs.get(i).filter(|s| word(s.kind))?;
    let text = stretch.token(i).text(stretch.text());
    let glue = |c: char| !c.is_ascii_digit() && !"+-.eE".contains(c);
    text.strip_prefix(glue)
        .or_else(|| text.strip_suffix(glue))?
        .parse()
        .ok()
}

/// The integer in a token with letters for the digits that they look like: `1O` is 10, `2l` is 21.
pub(super) fn with_letters(stretch: &Stretch, i: usize) -> Option<i64> {
    let word = |k| matches!(k, TokenKind::MalformedNumber | TokenKind::Word);
    stretch.sigs.get(i).filter(|s| word(s.kind))?;
    let text = stretch.token(i).text(stretch.text());
    let digit = |c: char| match c {
        'O' | 'o' => Some('0'),
        'l' | 'I' | '|' => Some('1'),
        c => c.is_ascii_digit().then_some(c),
    };
    let has_digit = text.contains(|c: char| c.is_ascii_digit());
    let digits: Option<String> = text.chars().map(digit).collect();
    digits.filter(|_| has_digit)?.parse().ok()
}

/// The ID that a number such as `1.0` may mean: 10, its digits without the point. Its value is 1, which only the render
/// record may have as its ID. `None` for other values, and before the type of a render record.
pub(super) fn without_point(stretch: &Stretch, i: usize) -> Option<u32> {
    let is_render = type_at(stretch, i + 1).is_some_and(|ty| ty.kind == RecordKind::Render);
    integral(stretch, i).filter(|&id| id == 1 && !is_render)?;
    let text = stretch.token(i).text(stretch.text());
    let digits = text.replacen(['.', ','], "", 1);
    digits.parse().ok().filter(|&id| id > 1)
}

/// The type at token i + 1, if token i is a stray that stands in the type's place: a word or an invalid token in a free
/// stretch, anything but an integer in a line.
pub(super) fn type_behind_stray(stretch: &Stretch, i: usize) -> Option<&'static RecordType> {
    let stray = |k| match stretch.is_free {
        true => matches!(k, TokenKind::Word | TokenKind::Invalid),
        false => k != TokenKind::Integer,
    };
    stretch.sigs.get(i).filter(|s| stray(s.kind))?;
    type_at(stretch, i + 1)
}

/// The value of a token that is a real with a whole value.
pub(super) fn integral(stretch: &Stretch, i: usize) -> Option<i64> {
    stretch.sigs.get(i).filter(|s| s.kind == TokenKind::Real)?;
    let x = stretch.value(i);
    (x.fract() == 0.0 && x.abs() < 1e9).then_some(x as i64)
}

/// The number of points of the counted record whose parameters begin at `i`; `Err` if it is missing or less than 2.
pub(super) fn point_count(stretch: &Stretch, i: usize) -> Result<u64, ()> {
    let s = stretch.sigs.get(i).ok_or(())?;
    let n = s.int.map(i64::from).or_else(|| integral(stretch, i));
    u64::try_from(n.ok_or(())?)
        .ok()
        .filter(|&n| n >= 2)
        .ok_or(())
}

/// Whether the record at `i` is of a type whose length depends on a count.
pub(super) fn is_counted(stretch: &Stretch, i: usize) -> bool {
    type_at(stretch, i + 1).is_some_and(RecordType::is_counted)
}

/// The end that a record of type `ty` should have if its parameters begin at `first`; `None` if its number of points
/// cannot be used.
pub(super) fn end_of(stretch: &Stretch, first: usize, ty: &RecordType) -> Option<u64> {
    let n = match ty.is_counted() {
        true => point_count(stretch, first).ok()?,
        false => 0,
    };
    Some((first as u64).saturating_add(ty.arity(n)))
}

/// The end that a record with its ID at token `i` should have, perhaps behind the end of the text. `None` if its type
/// or its number of points cannot be used.
pub(super) fn expected_end(stretch: &Stretch, i: usize) -> Option<usize> {
    let end = end_of(stretch, i + 2, type_at(stretch, i + 1)?)?;
    Some(usize::try_from(end).unwrap_or(usize::MAX))
}

/// The ends that a record may have that begins at token `i`, for all ways to understand its head. No end is behind the
/// end of the text.
pub(super) fn expected_ends(stretch: &Stretch, i: usize) -> Vec<usize> {
    let mut out = Vec::new();
    let mut add = |first: usize, ty: Option<&'static RecordType>| {
        let end = ty.and_then(|ty| end_of(stretch, first, ty));
        if let Some(end) = end.filter(|&e| e <= stretch.len() as u64 + 8) {
            out.push((end as usize).min(stretch.len()));
        }
    };
    add(i + 2, type_at(stretch, i + 1));
    add(i + 1, type_at(stretch, i));
    if let Some(ty) = type_behind_stray(stretch, i + 1) {
        add(i + 3, Some(ty));
    }
    if type_at(stretch, i + 1).is_none() {
        // The type is unknown. So the record may be as long as any of those that are often laid out over several lines.
        for params in [9, 10, 12, 16, 18] {
            out.push((i + 2 + params).min(stretch.len()));
        }
        if let Ok(n) = point_count(stretch, i + 2) {
            for per in [2, 5] {
                let end = (i as u64 + 3).saturating_add(n.saturating_mul(per));
                if end <= stretch.len() as u64 {
                    out.push(end as usize);
                }
            }
        }
    }
    out
}
