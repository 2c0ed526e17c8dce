//! Proposals of a record type for a record whose type number does not exist.

use super::entity::State;
use super::references::finding_at;
use super::resolve::Resolver;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::syntax::ast::Broken;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::Kind;
use crate::syntax::table::{Constraint, Effect, Param, ParamKind, RECORD_TYPES, RecordType};

impl Resolver<'_> {
    /// Completes the finding about an unknown type with the type that fits best: it takes as many
    /// parameters, of the right kinds, applies to the ID, and its number is the nearest.
    pub(super) fn propose_type(&self, broken: &Broken, diagnostics: &mut [Diagnostic]) {
        let tokens: Vec<&Token> = self
            .document
            .significant(broken.first, broken.last)
            .collect();
        let [_, written, params @ ..] = tokens.as_slice() else {
            return;
        };
        let Some(code) = written.integer(self.text) else {
            return;
        };
        let best = RECORD_TYPES
            .iter()
            .filter(|ty| self.fits(ty, broken.id, params))
            .min_by_key(|ty| {
                let value = i64::from(ty.code);
                // A sign is lost more easily than digits are mistaken.
                (value.checked_neg() != Some(code), value.abs_diff(code))
            });
        let finding = finding_at(diagnostics, written.span()).filter(|d| d.code == Code::E007);
        if let (Some(ty), Some(finding)) = (best, finding) {
            finding.case = "proposal";
            finding.values.extend([
                ("number", ty.code.to_string().into()),
                ("type", Value::Term(ty.title)),
            ]);
            finding.fixes.push(Fix::replace(
                "fix",
                Applicability::Unsafe,
                written.span(),
                ty.code.to_string(),
            ));
        }
    }

    fn fits(&self, ty: &RecordType, id: Option<u32>, params: &[&Token]) -> bool {
        let state = id.and_then(|id| self.state(id));
        let kind = state.and_then(State::kind);
        let applies = match (ty.effect, state) {
            (Effect::Defines(Kind::Render), _) => id == Some(1),
            (Effect::Defines(_), state) => {
                id != Some(1) && matches!(state, None | Some(State::Undefined))
            }
            (Effect::Changes(kinds), _) => kind.is_some_and(|k| kinds.contains(&k)),
            (Effect::DefinesOrChanges(_, kinds), Some(_)) => {
                kind.is_some_and(|k| kinds.contains(&k))
            }
            (Effect::DefinesOrChanges(..), None) => true,
        };
        let count = match ty.is_counted() {
            true => params
                .first()
                .and_then(|t| t.integer(self.text))
                .unwrap_or(0),
            false => 0,
        };
        let Ok(count) = u64::try_from(count) else {
            return false;
        };
        let n = params.len() as u64;
        let base = ty.arity(count);
        let length = n == base || n == base + ty.optional.len() as u64;
        // The items of a list are not checked if their number agrees with the count. All other parameters are.
        applies
            && length
            && !(ty.is_counted() && count < 2)
            && (params.iter().zip(ty.params.iter().chain(ty.optional)))
                .all(|(t, p)| self.fits_param(t, p))
    }

    fn fits_param(&self, token: &Token, param: &Param) -> bool {
        match param.kind {
            ParamKind::FileName => !token.kind().is_number(),
            ParamKind::Real => {
                let x = token.number(self.text);
                x.is_some_and(|x| match param.constraint {
                    Constraint::Positive => x > 0.0,
                    Constraint::NonZeroScale => x != 0.0,
                    Constraint::Within(a, b) | Constraint::Between(a, b) => a <= x && x <= b,
                    _ => true,
                })
            }
            ParamKind::Integer | ParamKind::Count => {
                let x = token.integer(self.text);
                token.kind() == TokenKind::Integer
                    && x.is_some_and(|x| match param.constraint {
                        Constraint::Axis => (1..=3).contains(&x),
                        Constraint::Within(a, b) => a <= x as f64 && x as f64 <= b,
                        Constraint::AtLeast(a) => x as f64 >= a,
                        _ => true,
                    })
            }
            ParamKind::Reference { kinds, or_none } => match token.integer(self.text) {
                Some(0) => or_none,
                Some(id) => u32::try_from(id)
                    .ok()
                    .and_then(|id| self.state(id)?.kind())
                    .is_some_and(|k| kinds.contains(&k)),
                None => false,
            },
        }
    }
}
