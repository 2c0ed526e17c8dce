//! Records whose type is lost: `34 32 33`, or a shape whose first number stands in the place of its type.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Fix, Value};
use crate::syntax::lexer::Token;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};

/// The types that scenes are mostly made of, the most frequent first.
const OFTEN: &[i32] = &[
    11, 12, -1, -701, -101, -103, -102, -299, -2, -201, -402, -501, -105, 9, 10, 5, 6, -3, 4, 14,
    16,
];

impl LineContext<'_> {
    /// An operation without its type, as in `34 32 33` where 32 and 33 are objects, or an assignment, as in `2 10 0` where
    /// 10 is a colour.
    pub(super) fn without_type(&self) -> Vec<Candidate> {
        let &[head, a, b] = self.tokens.as_slice() else {
            return Vec::new();
        };
        let ids = (self.id(), a.integer(self.text), b.integer(self.text));
        let (Some(own), Some(a), Some(b)) = ids else {
            return Vec::new();
        };
        let is_object = |id: i64| self.kind_of(id) == Some(Kind::Object);
        let is_operation = is_object(a) && is_object(b) && a != b && ![a, b].contains(&own.into());
        let is_look = a == 0 || matches!(self.kind_of(a), Some(Kind::Colour | Kind::Texture));
        let is_assignment = is_object(own.into())
            && (a, b) != (0, 0)
            && is_look
            && (b == 0 || self.kind_of(b) == Some(Kind::Optics));
        let kinds: &[RecordKind] = match (is_operation, is_assignment) {
            _ if self.ty().is_some_and(|ty| self.fits(ty)) => &[],
            (true, _) => &[
                RecordKind::Union,
                RecordKind::Intersection,
                RecordKind::Difference,
            ],
            (false, true) => &[RecordKind::Assignment],
            (false, false) => &[],
        };
        let all = kinds
            .iter()
            .map(|&kind| self.with_type(&head, RecordType::of(kind)));
        all.collect()
    }

    /// The type put in behind the ID.
    fn with_type(&self, head: &Token, ty: &'static RecordType) -> Candidate {
        let text = ty.code.to_string();
        let new = format!("{} {text}", head.text(self.text));
        Candidate {
            habit: Habit::NoType,
            fix: Fix::replace("fix-lost-type", Applicability::Unsafe, head.span(), new)
                .with("number", text)
                .with("type", Value::Term(ty.title)),
            ty: Some(ty),
        }
    }

    /// A record without its type: what stands in its place is none, or would change what is defined nowhere else. One
    /// of as many numbers is put in.
    pub(super) fn lost_type(&self, out: &mut Vec<Candidate>) {
        let (Some(head), Some(id)) = (self.tokens.first(), self.id()) else {
            return;
        };
        // It is rather the type of a render record that has lost its ID.
        if i64::from(id) == i64::from(RecordType::of(RecordKind::Render).code) {
            return;
        }
        let behind = &self.tokens[1..];
        let is_defined = self.is_defined_elsewhere(id);
        if (self.ty()).is_some_and(|ty| is_defined || !matches!(ty.effect, Effect::Changes(_))) {
            return;
        }
        let fitting = OFTEN
            .iter()
            .filter_map(|&code| RecordType::by_code(code.into()));
        let fitting = fitting.filter(|ty| self.fit(ty, behind));
        out.extend(fitting.map(|ty| self.with_type(head, ty)));
    }

    fn is_defined_elsewhere(&self, id: u32) -> bool {
        let mut entities = self.analysis.scene.entities.iter();
        entities.any(|e| e.id == id && !self.line.touches(e.span))
    }

    /// A shape without its type whose first number happens to be another type, with a wrong count of numbers: the shape
    /// of an ID that is used and defined nowhere else.
    pub(super) fn lost_shape_type(&self, out: &mut Vec<Candidate>) {
        let (Some(head), Some(id), Some(ty)) = (self.tokens.first(), self.id(), self.ty()) else {
            return;
        };
        let is_count = |t: &Token| t.integer(self.text).is_some();
        let is_change = matches!(ty.effect, Effect::Changes(_));
        // Behind the type of a profile its number of points is whole.
        let is_profile = ty.is_counted() && !self.params().first().is_none_or(is_count);
        let is_wanted = !self.is_defined_elsewhere(id) && self.named_ids().contains(&id);
        if self.fits(ty) || !is_wanted || !(is_change || is_profile) {
            return;
        }
        let fitting = OFTEN
            .iter()
            .chain(&[1])
            .filter_map(|&code| RecordType::by_code(code.into()))
            .filter(|ty| ty.family == Family::Shape && (is_change || ty.is_counted()))
            .filter(|ty| self.fit(ty, &self.tokens[1..]));
        out.extend(fitting.map(|ty| self.with_type(head, ty)));
    }
}
