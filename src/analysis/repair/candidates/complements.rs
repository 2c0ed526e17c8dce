//! Complements written with a minus, as A ∩ −B is on paper.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::Diagnostic;
use crate::syntax::table::{Kind, RecordKind, RecordType};

impl LineContext<'_> {
    /// Whether a finding is about an operand of an intersection that is the ID of an object with a minus: its
    /// complement, as A ∩ −B is written.
    pub(super) fn has_complement(&self, finding: &Diagnostic) -> bool {
        let is_intersection = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Intersection);
        let named = self.params().iter().find(|t| t.span() == finding.span);
        let id = named.and_then(|t| t.integer(self.text)?.checked_neg());
        is_intersection && id.is_some_and(|id| id > 0 && self.kind_of(id) == Some(Kind::Object))
    }

    /// Guesses at a difference in place of an intersection with one complement.
    pub(super) fn as_difference(&self) -> Option<Candidate> {
        let &[a, b] = self.params() else { return None };
        let (kept, taken) = match (a.integer(self.text)? < 0, b.integer(self.text)? < 0) {
            (false, true) => (a, b),
            (true, false) => (b, a),
            _ => return None,
        };
        let code = RecordType::of(RecordKind::Difference).code;
        let taken = taken.integer(self.text)?.checked_neg()?.to_string();
        let new = [
            (self.tokens[1], code.to_string()),
            (a, kept.text(self.text).to_owned()),
            (b, taken.clone()),
        ];
        let mut candidate = self.write(Habit::Type, &new)?;
        candidate.fix.title = "fix-difference";
        Some(Candidate {
            fix: candidate.fix.with("id", taken),
            ..candidate
        })
    }
}
