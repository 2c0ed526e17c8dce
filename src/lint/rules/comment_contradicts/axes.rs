//! A rotation whose comment names another axis.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::axes::{LETTERS, axis_by_comment};
use crate::scene::record::Params;
use crate::syntax::quote;

/// The place of the axis in the record.
const PLACE: usize = 1;

pub(super) fn check(context: &Context, p: &Params) -> Option<Diagnostic> {
    let letter = |axis: usize| LETTERS.get(axis.wrapping_sub(1)).copied();
    let written = letter(p.integer(PLACE) as usize)?;
    let said = p
        .own_comments()
        .find_map(|text| axis_by_comment(text, context.scene))?;
    if letter(said)? == written {
        return None;
    }
    let (number, span) = (said.to_string(), p.span_of(PLACE, 1));
    let fix = Fix::replace("fix", Applicability::Unsafe, span, number.clone());
    let finding = Diagnostic::new(Code::W344, span)
        .with("axis", written.to_owned())
        .with("said", LETTERS[said - 1].to_owned());
    Some(finding.fix(fix.with("number", quote(&number))))
}
