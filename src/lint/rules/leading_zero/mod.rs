//! S505: a number that begins with a zero and has rather lost its point: `08` for `0.8`.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::syntax::table::{ParamKind, RecordKind};
use crate::syntax::{quote, with_point};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for record in context.records() {
        // Other rules report parts of colours and of light that are above 1.
        let has_parts = matches!(
            record.kind,
            RecordKind::Colour | RecordKind::Optics | RecordKind::OpticsRgb
        );
        let (ty, count) = (record.ty(), record.count());
        for (i, token) in context.document.params(record).enumerate() {
            let text = token.text(context.text);
            let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
            let is_real = ty
                .param(i, count)
                .is_some_and(|p| p.kind == ParamKind::Real);
            let (Some(point), Some(value), true) =
                (with_point(unsigned), token.number(context.text), is_real)
            else {
                continue;
            };
            if value == 0.0 || has_parts && value > 1.0 {
                continue;
            }
            let sign = if value < 0.0 { "-" } else { "" };
            let number = format!("{sign}{point}");
            let fix = Fix::replace("fix", Applicability::Choice, token.span(), number.clone());
            let finding = Diagnostic::new(Code::S505, token.span());
            let finding = finding
                .with("text", quote(text))
                .with("value", Value::Decimal(spelled(value)));
            out.push(finding.with("number", quote(&number)).fix(fix));
        }
    }
}
