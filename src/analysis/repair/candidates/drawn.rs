//! A render record with a list of objects in the place of one.

use super::inline::{MAX_ID, MAX_OPERANDS, PARTS_TITLE};
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::table::{Kind, RecordKind, RecordType};

impl LineContext<'_> {
    /// Guesses that a render record lists its objects, as in `1 9999 2 3 4 0`, and joins them by a chain of unions
    /// above it. The background stands behind them, or is left out.
    pub(super) fn drawn(&self, finding: &Diagnostic, used: &[u32]) -> Option<Candidate> {
        let habit = match finding.code {
            Code::E008 | Code::E009 => Habit::Doubled,
            Code::E103 | Code::E202 => Habit::Type,
            _ => return None,
        };
        let ty = self.ty().filter(|ty| ty.kind == RecordKind::Render)?;
        let params = self.params();
        let ids = params.iter().map(|t| t.integer(self.text));
        let ids = ids.collect::<Option<Vec<i64>>>()?;
        let (objects, rest) = match ids.split_last()? {
            (&last, objects) if last == 0 || self.kind_of(last) == Some(Kind::Colour) => {
                (objects, 1)
            }
            _ => (&ids[..], 0),
        };
        let is_above = |id: i64| {
            let mut above = (self.analysis.scene.entities.iter())
                .filter(|e| e.kind == Some(Kind::Object) && e.span.start < self.line.start);
            above.any(|e| i64::from(e.id) == id)
        };
        let is_once = (1..objects.len()).all(|i| !objects[..i].contains(&objects[i]));
        if !(2..=MAX_OPERANDS).contains(&objects.len())
            || objects.len() + rest <= ty.params.len()
            || !is_once
            || !objects.iter().all(|&id| is_above(id))
        {
            return None;
        }
        let union = RecordType::of(RecordKind::Union);
        let (mut above, mut part) = (String::new(), objects[0].to_string());
        for (id, operand) in (self.free_id(used)?..MAX_ID).zip(&objects[1..]) {
            above += &format!("{id} {} {part} {operand}\n", union.code);
            part = id.to_string();
        }
        let head = self.tokens.first()?.start;
        let list = params[0].span().to(params[objects.len() - 1].span());
        if rest == 0 {
            part += " 0";
        }
        let edit = |span: Span, text: String| Edit { span, text };
        let fix = Fix {
            title: PARTS_TITLE,
            values: vec![("type", Value::Term(union.title))],
            applicability: Applicability::Unsafe,
            edits: vec![edit(Span::new(head, head), above), edit(list, part)],
        };
        Some(Candidate::new(habit, fix))
    }
}
