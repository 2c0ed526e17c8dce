//! The grammar of one record, by arity: its ID, its type, and as many parameters as the type takes. This is
//! the only place that says what a record is; the parser and recovery both ask here.
//!
//! # Optional groups
//!
//! The text behind a record decides whether the optional group is present. Both ways are followed for some records, up
//! to a line that stands for itself. If only one way can be read, that way is right, wherever the line breaks are. If
//! both ways can be read, or neither, the group is present exactly when it is the rest of the record's line.

use super::lexed::Lexed;
use super::lexer::{Token, TokenKind};
use super::table::{Constraint, Param, ParamKind, RecordKind, RecordType};

/// A text and the columns of its tokens.
#[derive(Debug, Clone, Copy)]
pub(super) struct Columns<'s> {
    pub text: &'s str,
    pub lexed: &'s Lexed,
}

impl Columns<'_> {
    /// How many significant tokens there are.
    pub(super) fn len(&self) -> usize {
        self.lexed.sigs.len()
    }

    pub(super) fn token(&self, i: usize) -> &Token {
        &self.lexed.tokens[self.lexed.sigs[i].token() as usize]
    }

    pub(super) fn kind(&self, i: usize) -> TokenKind {
        self.token(i).kind()
    }

    /// The value of token `i`, if it is an integer that fits into `i32`, the range of IDs, types and counts.
    pub(super) fn int(&self, i: usize) -> Option<i32> {
        let value = *self.lexed.values.get(i)?;
        let int = value as i32;
        (f64::from(int) == value && self.kind(i) == TokenKind::Integer).then_some(int)
    }

    pub(super) fn starts_line(&self, i: usize) -> bool {
        self.lexed.sigs.get(i).is_some_and(|s| s.starts_line())
    }

    /// The values of a token and of the next one on its line, each `None` if it is no integer. At the start of a line
    /// they are an ID and a type.
    pub(super) fn head(&self, i: usize) -> [Option<i32>; 2] {
        [
            self.int(i),
            self.int(i + 1).filter(|_| !self.starts_line(i + 1)),
        ]
    }

    /// Whether the render record begins at a token.
    pub(super) fn begins_render(&self, i: usize) -> bool {
        let is_render = |code| {
            RecordType::by_code(i64::from(code)).is_some_and(|t| t.kind == RecordKind::Render)
        };
        matches!(self.head(i), [Some(1), Some(code)] if is_render(code))
    }

    /// Whether the token before `end` is the last one of its line.
    pub(super) fn ends_line(&self, end: usize) -> bool {
        end == self.len() || self.starts_line(end)
    }

    /// Whether the next token that is no line break is a comment.
    pub(super) fn before_comment(&self, i: usize) -> bool {
        let rest = &self.lexed.tokens[self.lexed.sigs[i].token() as usize + 1..];
        let next = rest.iter().find(|t| t.kind() != TokenKind::Newline);
        next.is_some_and(|t| t.kind().is_comment())
    }
}

/// A record that can be read from some token on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reading {
    /// The end of the record: one past its last token.
    pub end: usize,
    pub ty: &'static RecordType,
    pub count: u32,
    /// Whether the text behind the record can be read both with the optional group and without it.
    pub two_ways: bool,
}

/// Whether a token can stand for a parameter of this kind.
pub(super) fn fits(kind: TokenKind, param: ParamKind) -> bool {
    match param {
        ParamKind::Real => matches!(kind, TokenKind::Integer | TokenKind::Real),
        ParamKind::Integer | ParamKind::Count | ParamKind::Reference { .. } => {
            kind == TokenKind::Integer
        }
        ParamKind::FileName => matches!(
            kind,
            TokenKind::Word | TokenKind::MalformedNumber | TokenKind::Quoted
        ),
    }
}

/// Whether a value is one that the parameter may have.
#[inline]
pub fn allows(param: &Param, x: f64) -> bool {
    match param.constraint {
        // NaN stands for a file name, which has no constraint.
        _ if x.is_nan() => true,
        Constraint::Any => !matches!(param.kind, ParamKind::Reference { .. }) || x >= 0.0,
        Constraint::Positive => x > 0.0,
        Constraint::ProfileRadius => x >= 0.0,
        Constraint::NonZeroScale => x != 0.0,
        Constraint::Between(a, b) | Constraint::Within(a, b) => a <= x && x <= b,
        Constraint::AtLeast(a) => x >= a,
        Constraint::Axis => (1.0..=3.0).contains(&x),
    }
}

/// Reads the record that begins at token `i` and ends before token `limit`, if there is one without any fault
/// of form.
#[inline]
pub(super) fn read(c: &Columns, i: usize, limit: usize) -> Option<Reading> {
    let mut reading = read_base(c, i, limit)?;
    if !reading.ty.optional.is_empty() {
        let base = reading;
        group(c, &mut reading, limit)?;
        if c.lexed.goes_out(base.end, reading.end) {
            return Some(base);
        }
    }
    Some(reading)
}

/// Like [`read`], but without the optional group.
#[inline]
fn read_base(c: &Columns, i: usize, limit: usize) -> Option<Reading> {
    if limit < i + 2 {
        return None;
    }
    c.int(i).filter(|&id| id > 0)?;
    let ty = RecordType::by_code(c.int(i + 1)?.into())?;
    let first = i + 2;
    let mut count = 0;
    if ty.is_counted() {
        if first >= limit {
            return None;
        }
        count = c.int(first).filter(|&n| n >= 2)? as u32;
    }
    // Compared as 64-bit numbers: a count may claim more than any file can hold.
    if ty.arity(count.into()) > (limit - first) as u64 {
        return None;
    }
    let end = first + ty.arity(count.into()) as usize;
    let head = first + ty.params.len();
    // Repeated parameters are real, all of them.
    let right = are_right(c, first, ty.params)
        && c.lexed.all_numbers(head, end)
        && !c.lexed.goes_out(first, end);
    right.then_some(Reading {
        end,
        ty,
        count,
        two_ways: false,
    })
}

/// Like [`read`], but line breaks alone decide about the optional group: it is present if it is the rest of the line.
/// `None` also if the record does not end with a line then.
pub(super) fn read_by_line(c: &Columns, i: usize, limit: usize) -> Option<Reading> {
    let mut reading = read_base(c, i, limit)?;
    let optional = reading.ty.optional;
    let with = reading.end + optional.len();
    if is_rest_of_line(c, reading.end, with, limit) && are_right(c, reading.end, optional) {
        reading.end = with;
    }
    c.ends_line(reading.end).then_some(reading)
}

/// Whether tokens `from..to` are the rest of the line.
fn is_rest_of_line(c: &Columns, from: usize, to: usize, limit: usize) -> bool {
    to <= limit && (from..to).all(|at| !c.starts_line(at)) && (to == limit || c.ends_line(to))
}

/// Whether the tokens from `first` on can stand for these parameters.
#[inline]
fn are_right(c: &Columns, first: usize, params: &[Param]) -> bool {
    (first..)
        .zip(params)
        .all(|(at, p)| fits(c.kind(at), p.kind))
}

/// Decides whether the optional group is present, and adds it to `reading` if so. `None` if the record can be read in
/// neither way.
fn group(c: &Columns, reading: &mut Reading, limit: usize) -> Option<()> {
    let (end, optional) = (reading.end, reading.ty.optional);
    let with = end + optional.len();
    let own_line = is_rest_of_line(c, end, with, limit);
    let fits_here = with <= limit
        && are_right(c, end, optional)
        && (end..with)
            .zip(optional)
            .all(|(at, p)| allows(p, c.lexed.values[at]));
    let followed = (follow(c, end, with, limit), follow(c, end, end, limit));
    let there = match followed {
        _ if !fits_here => own_line && followed.1.is_err(),
        (Ok(()), Err(_)) => true,
        (Err(_), Ok(())) => false,
        (Ok(()), Ok(())) => {
            reading.two_ways = true;
            own_line
        }
        // Something further on is wrong. Where there are no lines, the way that can be read further is likelier.
        (Err(there), Err(not)) if there != not && !own_line && !stands_alone(c, end, limit) => {
            there > not
        }
        (Err(_), Err(_)) => own_line,
    };
    if there {
        if !are_right(c, end, optional) {
            return None;
        }
        reading.end = with;
    }
    Some(())
}

/// How many records are followed on one way; [`FOLLOWED_IN_ALL`] counts those on all ways together. The ways part where
/// a record may have an optional group of its own.
const FOLLOWED: usize = 8;
const FOLLOWED_IN_ALL: usize = 40;
/// The fewest tokens of a line that counts as evidence. A shorter line may be a piece of a record that is broken
/// anywhere.
const OWN_LINE: usize = 3;

/// Whether a token begins a line of [`OWN_LINE`] tokens or more.
fn stands_alone(c: &Columns, at: usize, limit: usize) -> bool {
    c.starts_line(at) && (at + 1..at + OWN_LINE).all(|next| next < limit && !c.starts_line(next))
}

/// Tries to read some records from token `at` on. `Err` has the furthest token that was reached. The record before ends
/// at `end` without its optional group.
fn follow(c: &Columns, end: usize, at: usize, limit: usize) -> Result<(), usize> {
    // Each entry is a token to go on from, and how many records were read before it.
    let mut open = vec![(at, 0)];
    let mut furthest = at;
    for _ in 0..FOLLOWED_IN_ALL {
        let Some((at, behind)) = open.pop() else {
            return Err(furthest);
        };
        furthest = furthest.max(at);
        if at >= limit || at > end && stands_alone(c, at, limit) || behind == FOLLOWED {
            return Ok(());
        }
        if c.int(at) == Some(0) {
            open.push((at + 1, behind + 1));
            continue;
        }
        let Some(next) = read_base(c, at, limit).filter(|next| !is_odd(c, at, next)) else {
            continue;
        };
        let (optional, with) = (next.ty.optional, next.end + next.ty.optional.len());
        if !optional.is_empty()
            && with <= limit
            && are_right(c, next.end, optional)
            && (next.end..with)
                .zip(optional)
                .all(|(at, p)| allows(p, c.lexed.values[at]))
        {
            open.push((with, behind + 1));
        }
        open.push((next.end, behind + 1));
    }
    Ok(())
}

/// How many values of a long record are looked at to judge whether it is plausible.
const VALUES_MAX: usize = 64;

/// Whether a record that is right in form has a wrong ID or wrong values. ID 1 is wrong for all but the render record,
/// and every other ID is wrong for the render record.
pub(super) fn is_odd(c: &Columns, start: usize, r: &Reading) -> bool {
    (c.int(start) == Some(1)) != (r.ty.kind == RecordKind::Render) || !values_allowed(c, start, r)
}

/// Whether the type of a record allows its values; of a long record the first [`VALUES_MAX`] are checked.
pub(super) fn values_allowed(c: &Columns, start: usize, r: &Reading) -> bool {
    (start + 2..r.end.min(start + 2 + VALUES_MAX))
        .enumerate()
        .all(|(i, at)| {
            (r.ty.param(i, r.count as usize)).is_none_or(|p| allows(p, c.lexed.values[at]))
        })
}

/// Whether the record at token `head` has nothing but ID and type on its first line, and its next line begins with the
/// same ID and the type of a change. The next line is then rather the next record of that object.
pub(super) fn begins_again(columns: &Columns, head: usize, line: usize) -> bool {
    let ty = columns
        .int(line + 1)
        .and_then(|code| RecordType::by_code(code.into()));
    line == head + 2 && columns.int(line) == columns.int(head) && ty.is_some_and(|ty| ty.code < 0)
}
