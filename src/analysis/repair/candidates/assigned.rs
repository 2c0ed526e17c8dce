//! Assignments whose IDs stand in wrong places, with that of the object among them, where the record has another ID or none.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Code, Diagnostic};
use crate::syntax::table::{Kind, RecordKind, RecordType};

impl LineContext<'_> {
    /// The only order in which all that an assignment names is in its place, where its ID is that of no object, or missing:
    /// `-299 2 35` and `35 -299 35 2`, where 2 is an object and 35 an optical property. What is named twice is meant once.
    pub(super) fn assigned(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = RecordType::of(RecordKind::Assignment);
        let is_type = |i: usize| self.int(i) == Some(ty.code.into());
        let is_lost = finding.code == Code::E005 && is_type(0);
        let is_of_object = self.int(0).and_then(|id| self.kind_of(id)) == Some(Kind::Object);
        let is_wrong = finding.code == Code::E103 && is_type(1) && !is_of_object;
        if !is_lost && !is_wrong || self.tokens.len() != 3 + usize::from(is_wrong) {
            return None;
        }
        let mut places: [Option<i64>; 3] = [None; 3];
        let ids = self.tokens.iter().map(|t| t.integer(self.text));
        for (_, id) in ids.enumerate().filter(|(i, _)| !is_type(*i)) {
            let Some(id) = id.filter(|&id| id != 0) else {
                continue;
            };
            let place = match self.kind_of(id)? {
                Kind::Object => 0,
                Kind::Texture | Kind::Colour => 1,
                Kind::Optics => 2,
                _ => return None,
            };
            if places[place].replace(id).is_some_and(|other| other != id) {
                return None;
            }
        }
        let [Some(object), texture, optics] = places else {
            return None;
        };
        let kinds = [Some(object), texture, optics].into_iter().flatten();
        if kinds.count() < 2 {
            return None;
        }
        let [texture, optics] = [texture, optics].map(|id| id.unwrap_or(0));
        let text = format!("{object} {} {texture} {optics}", ty.code);
        let span = self.tokens.first()?.span().to(self.tokens.last()?.span());
        let is_new = self.text[span.range()] != text;
        let habit = if is_lost { Habit::Id } else { Habit::Swapped };
        is_new.then(|| Candidate::writing(habit, span, text))
    }
}
