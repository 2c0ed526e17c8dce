//! Findings about numbers that are no integers where one is needed.

use super::super::quote::quote;
use super::super::table::{Param, ParamKind};
use super::heads::without_point;
use super::report::{Reporter, write};
use crate::diagnostics::{Applicability, Code, Diagnostic, Value};

impl Reporter<'_, '_> {
    /// The diagnostic of a number that is no integer where one is needed.
    pub(super) fn not_an_integer(&self, i: usize, what: &'static str) -> Diagnostic {
        let (text, span) = (self.text(i), self.stretch.token(i).span());
        let d = Diagnostic::new(Code::E010, span)
            .with("text", quote(text))
            .with("parameter", Value::Term(what));
        let value = text.replace(',', ".").parse().ok();
        match value.filter(|x: &f64| x.fract() == 0.0 && x.abs() < 1e15) {
            Some(x) => {
                let whole = format!("{}", x as i64);
                d.with("number", quote(&whole))
                    .fix(write(Applicability::Safe, span, whole))
            }
            None => d,
        }
    }

    /// Like [`not_an_integer`](Self::not_an_integer), for a number in the place of an ID. Without its decimal point the
    /// number may be the ID.
    pub(super) fn no_integer_for_id(&self, i: usize) -> Diagnostic {
        let d = self.not_an_integer(i, "an ID");
        let Some(id) = without_point(self.stretch, i) else {
            return d;
        };
        let (span, id) = (self.stretch.token(i).span(), id.to_string());
        let mut d = Diagnostic {
            fixes: Vec::new(),
            ..d
        };
        d.values.retain(|v| v.0 != "number");
        d.with("number", quote(&id))
            .fix(write(Applicability::Unsafe, span, id))
    }

    /// Like [`not_an_integer`](Self::not_an_integer), for a parameter, which may be a reference.
    pub(super) fn no_integer_for(&self, i: usize, param: &Param) -> Diagnostic {
        let d = self.not_an_integer(i, param.doc);
        match param.kind {
            ParamKind::Reference { .. } => d.case("reference"),
            _ => d,
        }
    }
}
