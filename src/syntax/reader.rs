//! Reading by arity: a record is its ID, its type and as many parameters as the type takes.
//! Everything here is strict; what to do about input that is not so is [`super::layout`]'s matter.

use chumsky::error::Cheap;
use chumsky::extra;
use chumsky::input::InputRef;
use chumsky::prelude::*;

use super::ast::{Item, Record};
use super::lexer::TokenKind;
use super::stream::{Sig, Stream};
use super::table::{ParamKind, RecordType};

/// A record that can be read from some token on.
#[derive(Debug, Clone, Copy)]
pub struct Reading {
    /// One past its last token.
    pub end: usize,
    pub ty: &'static RecordType,
    pub count: u32,
}

/// Whether a token can stand for a parameter of this kind.
pub fn fits(kind: TokenKind, param: ParamKind) -> bool {
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

/// Reads the record that begins at token `i`, if there is one without any fault of form.
pub fn read(stream: &Stream, i: usize) -> Option<Reading> {
    let sigs = &stream.sigs;
    sigs[i].int.filter(|&id| id > 0)?;
    let ty = RecordType::by_code(sigs.get(i + 1)?.int?.into())?;
    let first = i + 2;
    let mut count = 0;
    if ty.is_counted() {
        count = sigs.get(first)?.int.filter(|&n| n >= 2)? as u32;
    }
    // Compared as 64-bit numbers: a count may claim more than any file can hold.
    if ty.arity(count.into()) > (sigs.len() - first) as u64 {
        return None;
    }
    let mut end = first + ty.arity(count.into()) as usize;
    if !ty.optional.is_empty() {
        let left = stream.line_end(stream.line(end - 1)) - end;
        if left == ty.optional.len() {
            end += left;
        }
    }
    // Repeated parameters are real, all of them; the others are looked at one by one.
    let right = match ty.is_counted() {
        true => stream.all_numbers(first, end),
        false => sigs[first..end]
            .iter()
            .zip(ty.params.iter().chain(ty.optional))
            .all(|(s, p)| fits(s.kind, p.kind)),
    };
    right.then_some(Reading { end, ty, count })
}

type Extra = extra::Err<Cheap>;

/// The grammar of a text without faults of form: `(void | record)* end`.
///
/// Its parts look at the whole stream: the optional parameters of a record depend on where its line
/// ends.
pub fn records<'s>(stream: &'s Stream<'s>) -> impl Parser<'s, &'s [Sig], Vec<Item>, Extra> {
    let void = any()
        .filter(|s: &Sig| s.int == Some(0))
        .map(|s| Item::Void { token: s.token });
    let record = custom(move |input: &mut InputRef<'s, '_, &'s [Sig], Extra>| {
        let before = input.cursor();
        let start = *before.inner();
        let reading = (start < stream.len())
            .then(|| read(stream, start))
            .flatten();
        let Some(reading) = reading else {
            return Err(Cheap::new(input.span_since(&before)));
        };
        for _ in start..reading.end {
            input.skip();
        }
        Ok(Item::Record(whole(stream, start, &reading)))
    });
    choice((void, record))
        .repeated()
        .collect()
        .then_ignore(end())
}

/// The tree's record for a reading.
pub fn whole(stream: &Stream, start: usize, reading: &Reading) -> Record {
    Record {
        id: stream.sigs[start].int.unwrap_or(0) as u32,
        ty: reading.ty,
        first: stream.sigs[start].token,
        last: stream.sigs[reading.end - 1].token,
        params: (reading.end - start - 2) as u32,
        count: reading.count,
    }
}
