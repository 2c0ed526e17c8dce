//! Tokens by what they mean: IDs, types, references, coordinates, colours, angles.

use crate::analysis::Analysis;
use crate::diagnostics::Span;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Effect, Family, Param, ParamKind, RecordType, Unit};
use crate::syntax::{Item, Record};

/// The meaning of a token.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Role {
    Id,
    Type,
    Reference,
    Number,
    Coordinate,
    Colour,
    Angle,
    File,
    Comment,
    /// A lone `0`.
    Void,
}

impl Role {
    pub const ALL: [Role; 10] = [
        Role::Id,
        Role::Type,
        Role::Reference,
        Role::Number,
        Role::Coordinate,
        Role::Colour,
        Role::Angle,
        Role::File,
        Role::Comment,
        Role::Void,
    ];
}

/// A token with its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Meaning {
    pub span: Span,
    pub role: Role,
    /// Whether the token is the ID of a record that defines its entity.
    pub defines: bool,
}

/// The meanings of the tokens in a stretch of text, in order.
pub fn tokens(analysis: &Analysis, within: Span) -> Vec<Meaning> {
    let document = &analysis.document;
    let all = &document.tokens;
    let last = all.partition_point(|t| t.start < within.end);
    let first = all.partition_point(|t| t.end() <= within.start);
    let mut out = Vec::with_capacity(last.saturating_sub(first));
    let items = &document.items[super::token_at_offset::items_in(document, within)];
    let mut at = first;
    let comment = |t: &Token| Meaning {
        span: t.span(),
        role: Role::Comment,
        defines: false,
    };
    for item in items {
        let (from, to) = item.ends();
        while at < last.min(from as usize) {
            out.extend(
                Some(&all[at])
                    .filter(|t| t.kind().is_comment())
                    .map(comment),
            );
            at += 1;
        }
        let mut index = 0;
        for (i, token) in (from as usize..).zip(&all[from as usize..=to as usize]) {
            let is_inside = i >= first && i < last;
            if token.kind().is_trivia() {
                out.extend(
                    Some(token)
                        .filter(|t| is_inside && t.kind().is_comment())
                        .map(comment),
                );
                continue;
            }
            if is_inside {
                out.extend(meaning(item, token, index));
            }
            index += 1;
        }
        at = at.max(to as usize + 1);
    }
    while at < last {
        out.extend(
            Some(&all[at])
                .filter(|t| t.kind().is_comment())
                .map(comment),
        );
        at += 1;
    }
    out
}

/// The meaning of the token at a position of an item.
fn meaning(item: &Item, token: &Token, index: usize) -> Option<Meaning> {
    let (role, defines) = match item {
        Item::Void { .. } => (Role::Void, false),
        Item::Record(record) => of_record(record, index)?,
        Item::Broken(broken) => match (index, broken.ty()) {
            _ if !token.kind().is_number() => return None,
            (0, _) if broken.id.is_some() => (Role::Id, false),
            (1, Some(_)) => (Role::Type, false),
            _ => (Role::Number, false),
        },
    };
    let role = match token.kind() {
        TokenKind::Quoted => Role::File,
        _ => role,
    };
    Some(Meaning {
        span: token.span(),
        role,
        defines,
    })
}

fn of_record(record: &Record, index: usize) -> Option<(Role, bool)> {
    let ty = record.ty();
    Some(match index {
        0 => (Role::Id, !matches!(ty.effect, Effect::Changes(_))),
        1 => (Role::Type, false),
        i => {
            let param = ty.param(i - 2, record.count())?;
            (of_param(ty, param), false)
        }
    })
}

/// The meaning of a parameter.
pub fn of_param(ty: &RecordType, param: &Param) -> Role {
    let is_colour = ty.family == Family::Colour
        || (ty.repeats.iter().flat_map(|g| g.iter()))
            .any(|p| std::ptr::eq(p, param) && matches!(p.name, "r" | "g" | "b"));
    match (param.kind, param.unit) {
        (ParamKind::Reference { .. }, _) => Role::Reference,
        (ParamKind::FileName, _) => Role::File,
        _ if is_colour => Role::Colour,
        (_, Unit::Degrees) => Role::Angle,
        (_, Unit::Length) => Role::Coordinate,
        _ => Role::Number,
    }
}
