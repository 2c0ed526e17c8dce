//! Records whose type is lost: `34 32 33`, or a shape whose first number stands in the place of its type.

use super::types::is_slip;
use super::{Candidate, Habit, LineContext};
use crate::analysis::colours;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::syntax::LEAST_HEAD;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};
use crate::syntax::words;

/// The types that scenes are mostly made of, the most frequent first.
const OFTEN: &[i32] = &[
    11, 12, -1, -701, -101, -103, -102, -299, -2, -201, -402, -501, -105, 9, 10, 5, 6, -3, 4, 14,
    16,
];

/// Beginnings of words for surfaces of revolution, without accents.
const PROFILES: [&str; 4] = ["profil", "lathe", "revol", "rotacn"];

/// Beginnings of words for a double cone, without accents.
const DOUBLE: [&str; 2] = ["doubl", "dvoj"];

/// The most words of a line's comments that are examined.
const MAX_COMMENT_WORDS: usize = 64;

impl LineContext<'_> {
    /// Guesses at the type of an operation without one, as in `34 32 33` where 32 and 33 are objects, or of an
    /// assignment, as in `2 10 0` where 10 is a colour.
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

    /// The candidate that puts a type in behind the ID.
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

    /// Guesses at the type of a record that lacks it: the number in the place of the type is no type, or is that of a
    /// change of an entity that is defined nowhere else. Each frequent type with as many numbers may be meant.
    pub(super) fn lost_type(&self, out: &mut Vec<Candidate>) {
        let (Some(head), Some(id)) = (self.tokens.first(), self.id()) else {
            return;
        };
        // The number is rather the type of a render record that has lost its ID.
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

    /// Guesses at the type of a record that lacks it. If its first number is 0, it reads as an undefined object with
    /// numbers; if it begins with 1 and 0, as a surface without points. A comment on the line may name the shape, or a
    /// colour.
    pub(super) fn type_before_zero(&self, finding: &Diagnostic) -> Vec<Candidate> {
        let (Some(head), Some(ty)) = (self.tokens.first(), self.ty()) else {
            return Vec::new();
        };
        let is_empty_profile =
            ty.is_counted() && self.int(2) == Some(0) && self.params().len() == 2;
        let is_one = match finding.code {
            Code::E009 => ty.kind == RecordKind::Undefined && self.params().len() > 1,
            Code::E005 => {
                let is_own = finding.fixes.iter().any(|f| self.puts_own_id(finding, f));
                ty.kind == RecordKind::Undefined && is_own
            }
            Code::E206 | Code::E008 => is_empty_profile,
            _ => false,
        };
        if !is_one || self.id().is_none() {
            return Vec::new();
        }
        let fits = |ty: &&RecordType| self.fit(ty, &self.tokens[1..]);
        let often =
            (OFTEN.iter().chain(&[12])).filter_map(|&code| RecordType::by_code(code.into()));
        let fitting: Vec<&'static RecordType> = often.filter(fits).collect();
        let words = self.comment_words();
        let shapes: Vec<&RecordType> = words.iter().flat_map(|w| words::shapes(w)).collect();
        let is_coloured = words.iter().any(|w| colours::numbers(w).is_some());
        let is_called = |ty: &&RecordType| {
            let is_shape = shapes.iter().any(|shape| shape.code == ty.code);
            is_shape || shapes.is_empty() && is_coloured && ty.kind == RecordKind::Colour
        };
        let called: Vec<&RecordType> = fitting.iter().copied().filter(is_called).collect();
        let all = if called.is_empty() { fitting } else { called };
        all.into_iter().map(|ty| self.with_type(head, ty)).collect()
    }

    /// The first words of the comments on the line.
    fn comment_words(&self) -> Vec<&str> {
        let comments = self.all.iter().filter(|t| t.kind().is_comment());
        let is_letter = |c: char| c.is_alphabetic();
        let words = comments.flat_map(|t| t.text(self.text).split(move |c| !is_letter(c)));
        let words = words.filter(|w| !w.is_empty());
        words.take(MAX_COMMENT_WORDS).collect()
    }

    /// Guesses at the shape that a comment on the line names, where another type is written: `2 1 0 1 0 1 # ball #` for
    /// `2 11 0 1 0 1`, and `2 17 -1.5 0.5 # cone #` for `2 16 -1.5 0.5`. The type may also be missing: `2 1 1 0 1 # ball #`
    /// for `2 11 1 1 0 1`.
    pub(super) fn called_shape(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_shape = |ty: &&RecordType| ty.family == Family::Shape && self.id().is_some();
        let Some(own) = self.ty().filter(is_shape) else {
            return;
        };
        let is_own = |ty: &&RecordType| ty.code == own.code;
        let is_whole = self.fits(own);
        let shapes = self.comment_words().into_iter().map(words::shapes);
        let called: Vec<_> = match finding.code {
            // Its numbers are as many, and no other name is a better one.
            Code::E201 if is_whole && !self.is_called(&DOUBLE) => {
                shapes.filter_map(|of| of.first().copied()).collect()
            }
            _ if is_whole => return,
            _ => {
                let shapes: Vec<_> = shapes.collect();
                if shapes.iter().flatten().any(is_own) || self.is_called(&PROFILES) {
                    return;
                }
                shapes.into_iter().flatten().collect()
            }
        };
        if called.iter().any(is_own) {
            return;
        }
        let (head, written) = (&self.tokens[0], self.tokens[1].text(self.text));
        if let Some(ty) = called.iter().find(|ty| self.fits(ty)) {
            let habit = match is_slip(written, &ty.code.to_string()) {
                true => Habit::Digit,
                false => Habit::Type,
            };
            out.push(self.write_type(habit, ty));
            return;
        }
        let lost = called.iter().find(|ty| self.fit(ty, &self.tokens[1..]));
        out.extend(
            lost.filter(|_| !is_whole)
                .map(|ty| self.with_type(head, ty)),
        );
    }

    /// Takes out the candidates that write another shape than a comment on the line names, where the written type is the
    /// named one.
    pub(super) fn keep_named_shape(&self, out: &mut Vec<Candidate>) {
        let named: Vec<_> = self.named_shapes().map(|ty| ty.code).collect();
        let mut comments = self.all.iter().filter(|t| t.kind().is_comment());
        let is_own = self.ty().is_some_and(|own| named.contains(&own.code));
        if is_own && !comments.any(|t| words::denies(t.text(self.text))) {
            let is_other =
                |ty: &RecordType| ty.family == Family::Shape && !named.contains(&ty.code);
            out.retain(|c| !c.ty.is_some_and(is_other));
        }
    }

    /// Whether the text tells that a candidate is meant: a comment on the line names the shape whose type the candidate
    /// puts in, and not the shape that the line is if its ID is lost; or pairs with decimal commas are points.
    pub(in crate::analysis::repair) fn tells(&self, candidate: &Candidate) -> bool {
        if candidate.habit == Habit::Doubled {
            let points = self.points_with_commas();
            return points.is_some_and(|p| p.fix.edits == candidate.fix.edits);
        }
        let is_shape = |ty: &&RecordType| ty.family == Family::Shape;
        let lost = candidate.ty.filter(is_shape);
        let Some(lost) = lost.filter(|_| candidate.habit == Habit::NoType) else {
            return false;
        };
        let comments = self.all.iter().filter(|t| t.kind().is_comment());
        if comments
            .into_iter()
            .any(|t| words::denies(t.text(self.text)))
        {
            return false;
        }
        let is_named = |code: i32| self.named_shapes().any(|ty| ty.code == code);
        is_named(lost.code) && !self.names_shape_without_id()
    }

    /// The shapes that comments on the line name.
    fn named_shapes(&self) -> impl Iterator<Item = &'static RecordType> {
        self.comment_words().into_iter().flat_map(words::shapes)
    }

    /// Whether a comment on the line names the shape that the line is if its ID is lost.
    fn names_shape_without_id(&self) -> bool {
        let own = self.shape_without_id();
        own.is_some_and(|own| self.named_shapes().any(|ty| ty.code == own.code))
    }

    /// Whether a fix for a record that seems to have lost its ID repeats the number in front: `4 4 0 1 0 1`. That number
    /// is rather the ID, and the type is lost, unless a comment names the shape.
    pub(in crate::analysis::repair) fn puts_own_id(&self, finding: &Diagnostic, fix: &Fix) -> bool {
        let Some(head) = self.tokens.first() else {
            return false;
        };
        let is_lost = finding.code == Code::E005 && finding.case == "lost";
        let is_in_front = |e: &Edit| {
            let is_same = e.text.trim() == head.text(self.text);
            e.span.start == head.start && e.span.range().is_empty() && is_same
        };
        is_lost && fix.edits.iter().any(is_in_front) && !self.names_shape_without_id()
    }

    /// Guesses at a record whose type stands behind its numbers: `50 0.8 -402`.
    pub(super) fn type_behind(&self) -> Option<Candidate> {
        let (code, before) = self.tokens.split_last()?;
        let (_, numbers) = before.split_first().filter(|_| self.id().is_some())?;
        let ty = code
            .integer(self.text)
            .filter(|&code| code <= LEAST_HEAD.into());
        let ty = RecordType::by_code(ty?).filter(|ty| self.fit(ty, numbers))?;
        let (first, last) = (numbers.first()?, numbers.last()?);
        let span = first.span().to(code.span());
        let written = &self.text[first.span().to(last.span()).range()];
        let candidate = Candidate::writing(Habit::Type, span, format!("{} {written}", ty.code));
        Some(Candidate {
            ty: Some(ty),
            ..candidate
        })
    }

    fn is_defined_elsewhere(&self, id: u32) -> bool {
        let mut entities = self.analysis.scene.entities.iter();
        entities.any(|e| e.id == id && !self.line.touches(e.span))
    }

    /// Guesses at a shape without its type, whose first number happens to be another type that takes another count of
    /// numbers. The ID of the record is used but defined nowhere else.
    pub(super) fn lost_shape_type(&self, out: &mut Vec<Candidate>) {
        let (Some(head), Some(id), Some(ty)) = (self.tokens.first(), self.id(), self.ty()) else {
            return;
        };
        let is_count = |t: &Token| t.integer(self.text).is_some();
        let is_change = matches!(ty.effect, Effect::Changes(_));
        // The number behind the type of a profile is its number of points, which is whole.
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
