//! Shapes that a difference takes away, with a length that has lost its decimal point.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Diagnostic, Fix, Value};
use crate::lint::rules::swapped_difference;
use crate::scene::record::Params;
use crate::syntax::table::{Constraint, RecordKind};
use crate::syntax::{Item, Record, quote, tenth, words};

/// Beginnings of words for what is taken away, beside those for holes, without accents.
const CUT: [&str; 2] = ["cut", "vyrez"];
/// The most lengths of a shape that are tried.
const MAX_LENGTHS: usize = 3;

impl LineContext<'_> {
    /// Guesses that the shape which is taken away, or the one of a union that takes all away, has a length, a whole
    /// number, that is ten times too large: `6` may be `0.6`. Only where a comment says that the shape is a hole or a cut,
    /// or that the first operand is what remains.
    pub(super) fn smaller_cut(&self, finding: &Diagnostic) -> Vec<Candidate> {
        let is_difference = self
            .ty()
            .is_some_and(|ty| ty.kind == RecordKind::Difference);
        let number = |name: &str| {
            let all = finding.values.iter().find(|v| v.0 == name);
            all.and_then(|(_, value)| match value {
                Value::Text(text) => text.parse::<i64>().ok(),
                _ => None,
            })
        };
        let cut = self.int(3).filter(|_| is_difference);
        let cut = cut.and_then(|id| self.shape(id).or_else(|| self.shape(number("two-id")?)));
        let is_said = |p: &Params| is_cut(p) || self.is_in_order();
        let Some(p) = cut.filter(is_said) else {
            return Vec::new();
        };
        let length = |i: usize| {
            let is_length = p.number(i) > 0.0 && p.param(i)?.constraint == Constraint::Positive;
            Some((i, tenth(p.text_of(i)).filter(|_| is_length)?))
        };
        let lengths = (0..p.len()).filter_map(length).take(MAX_LENGTHS);
        let candidates = lengths.map(|(i, text)| {
            let all = (0..p.len()).map(|j| if i == j { &text[..] } else { p.text_of(j) });
            let all = quote(&all.collect::<Vec<_>>().join(" "));
            let fix = Fix::replace(
                "fix-ten-times-smaller",
                Applicability::Choice,
                p.span_of(i, 1),
                text,
            );
            let fix = fix.with("id", p.id.to_string()).with("number", all);
            Candidate::new(Habit::Swapped, fix)
        });
        candidates.collect()
    }

    /// Whether the comment on a difference says that its first operand is the one that remains.
    pub(super) fn is_in_order(&self) -> bool {
        swapped_difference::is_in_order(&self.analysis.context(), self.line)
    }

    /// Whether the record that defines the first operand has a comment that does not call it a hole or a cut.
    pub(in crate::analysis::repair) fn cuts_what_is_no_hole(&self) -> bool {
        let first = self.int(2).and_then(|id| self.shape(id));
        first.is_some_and(|p| p.comments().next().is_some() && !is_cut(&p))
    }

    /// The record of the shape with an ID.
    fn shape(&self, id: i64) -> Option<Params<'_>> {
        let document = &self.analysis.document;
        let is_it = |r: &&Record| i64::from(r.id) == id && matches!(r.kind, RecordKind::Shape(_));
        let record = document.items.iter().filter_map(Item::record).find(is_it)?;
        Some(Params::new(document, self.text, record))
    }
}

/// Whether a comment says that a shape is taken away.
fn is_cut(p: &Params) -> bool {
    p.is_called(&words::HOLE) || p.is_called(&CUT)
}
