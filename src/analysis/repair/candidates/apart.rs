//! Numbers behind those of a record that make a record of their own: the place of a lamp, the colour of an object.

use super::{Candidate, Habit, Place};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};

/// A move and a colour have as many numbers.
const OWN: usize = 3;

impl Place<'_> {
    /// A light or a shape with three numbers too many, which are its colour or move it, or with six, which do both.
    /// The type may have lost its minus, too.
    pub(super) fn apart(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_better = |c: &Candidate| matches!(c.habit, Habit::Doubled | Habit::Sibling);
        let (Some(code), Some(id)) = (self.int(1), self.id()) else {
            return;
        };
        let is_surplus = matches!(finding.code, Code::E007 | Code::E009);
        if !is_surplus || out.iter().any(is_better) {
            return;
        }
        let lost = code.checked_neg().and_then(RecordType::by_code);
        let (ty, habit) = match (RecordType::by_code(code), lost) {
            (Some(ty), _) => (ty, Habit::Apart),
            (None, Some(ty)) => (ty, Habit::Sign),
            (None, None) => return,
        };
        let Effect::Defines(kind) = ty.effect else {
            return;
        };
        let is_one = matches!(ty.family, Family::Light | Family::Shape) && !ty.is_counted();
        let wanted = ty.params.len();
        let Some((own, rest)) = self.params().split_at_checked(wanted).filter(|_| is_one) else {
            return;
        };
        let numbers: Option<Vec<f64>> = rest.iter().map(|t| t.number(self.text)).collect();
        let (Some(last), Some(numbers)) = (own.last(), numbers) else {
            return;
        };
        let first: &[RecordKind] = match rest.len() {
            OWN => &[RecordKind::Colour, RecordKind::Translation],
            n if n == 2 * OWN => &[RecordKind::Translation],
            _ => return,
        };
        for &first in first {
            let records = [first, RecordKind::Colour].map(RecordType::of);
            let records = &records[..rest.len() / OWN];
            let each = || records.iter().zip(numbers.chunks(OWN));
            if !each().all(|(ty, numbers)| may_follow(ty, kind, numbers)) {
                continue;
            }
            let sign = (habit == Habit::Sign).then(|| Edit {
                span: self.tokens[1].span(),
                text: ty.code.to_string(),
            });
            let mut before = last;
            let mut edits: Vec<Edit> = sign.into_iter().collect();
            for (ty, tokens) in records.iter().zip(rest.chunks(OWN)) {
                edits.push(self.begun(id, ty, before, &tokens[0]));
                before = &tokens[OWN - 1];
            }
            let span = rest[0].span().to(rest[rest.len() - 1].span());
            let fix = Fix {
                title: match (records.len(), habit) {
                    (1, Habit::Sign) => "fix-sign-apart",
                    (1, _) => "fix-apart",
                    (_, Habit::Sign) => "fix-sign-apart-both",
                    _ => "fix-apart-both",
                },
                values: vec![
                    ("type", Value::Term(records[0].title)),
                    ("number", ty.code.to_string().into()),
                    ("text", quote(&self.text[span.range()]).into()),
                ],
                applicability: Applicability::Unsafe,
                edits,
            };
            out.push(Candidate {
                habit,
                fix,
                ty: None,
            });
        }
    }

    /// The beginning of a record on a line of its own, before a number that stands behind another one.
    fn begun(&self, id: u32, ty: &RecordType, before: &Token, number: &Token) -> Edit {
        let between = Span::new(before.end(), number.start);
        let is_empty = self.text[between.range()].trim().is_empty();
        Edit {
            span: match is_empty {
                true => between,
                false => Span::new(number.start, number.start),
            },
            text: format!("\n{id} {} ", ty.code),
        }
    }
}

/// Whether numbers of a record may be meant to follow what is defined.
fn may_follow(ty: &RecordType, kind: Kind, numbers: &[f64]) -> bool {
    let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = ty.effect else {
        return false;
    };
    let is_colour = || numbers.iter().all(|x| (0.0..=1.0).contains(x));
    kinds.contains(&kind) && (ty.kind != RecordKind::Colour || is_colour())
}
