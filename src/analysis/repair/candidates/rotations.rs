//! Rotations as other programs have them: by an angle for each axis, by a vector and an angle, by a quaternion, and by
//! the letter of an axis.

use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::whole::records;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span};
use crate::lint::spelling::decimal;
use crate::scene::axes::axis_by_comment;
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Kind, RecordKind, RecordType};

/// Words before the letter of an axis.
const AXIS: [&str; 4] = ["axis", "osa", "osy", "ose"];

/// Beginnings of words for a move, without accents.
const MOVED: [&str; 4] = ["move", "moving", "shift", "posun"];
/// The size in degrees below which an angle is small.
const SMALL_ANGLE: f64 = 20.0;
/// Most angles are a multiple of this, in degrees.
const ANGLE_STEP: f64 = 15.0;

/// The most by which the sum of a quaternion's squared parts differs from 1 if they are written with few digits.
const NORM_OFF_MAX: f64 = 1e-3;
/// The size up to which a part of a quaternion is a rounded 0.
const ZERO_PART_MAX: f64 = 1e-4;
/// The distance in degrees up to which an angle is a whole number of degrees, since a quaternion has few digits.
const DEGREES_OFF_MAX: f64 = 0.05;

/// The orders of a quaternion's parts, that of glTF and that of Blender, each with the index of w.
const ORDERS: [(&str, usize); 2] = [("x y z w", 3), ("w x y z", 0)];

/// Whether four numbers are a quaternion that turns: its length is 1, and it is not just an axis with an angle of 0.
fn is_quaternion(parts: [f64; 4]) -> bool {
    let norm: f64 = parts.iter().map(|x| x * x).sum();
    let turns = parts.iter().filter(|x| x.abs() > ZERO_PART_MAX).count() > 1;
    (norm - 1.0).abs() <= NORM_OFF_MAX && turns
}

/// The angle in degrees and the axis, 1 to 3, of a quaternion whose w is at an index. `None` if it turns about none of
/// the axes.
fn turn(parts: [f64; 4], w: usize) -> Option<(f64, usize)> {
    let vector = (0..4).filter(|&i| i != w).map(|i| parts[i]);
    let mut along = (1..).zip(vector).filter(|(_, x)| x.abs() > ZERO_PART_MAX);
    let (Some((axis, sine)), None) = (along.next(), along.next()) else {
        return None;
    };
    let degrees = 2.0 * sine.atan2(parts[w]).to_degrees();
    let degrees = match degrees {
        _ if degrees > 180.0 => degrees - 360.0,
        _ if degrees < -180.0 => degrees + 360.0,
        _ => degrees,
    };
    let whole = degrees.round();
    Some(match (degrees - whole).abs() <= DEGREES_OFF_MAX {
        true => (whole, axis),
        false => ((degrees * 100.0).round() / 100.0, axis),
    })
}

impl LineContext<'_> {
    /// Guesses at a rotation with three numbers: a translation if it is for a lamp that has none, else a rotation by an
    /// angle for each axis. Numbers that are hardly angles may be either, unless a comment tells.
    pub(super) fn three_numbers(&self, out: &mut Vec<Candidate>) {
        let Some(mut angles) = self.angles() else {
            return;
        };
        let translation = RecordType::of(RecordKind::Translation);
        let mut translation = Candidate {
            habit: Habit::Doubled,
            ..self.write_type(Habit::Doubled, translation)
        };
        let id = self.id();
        let is_moved = || {
            let mut own = records(self.analysis).filter(|r| Some(r.id) == id);
            own.any(|r| r.kind == RecordKind::Translation)
        };
        let kind = id.and_then(|id| self.kind_of(id.into()));
        if kind == Some(Kind::PointLight) && !is_moved() {
            out.push(translation);
            return;
        }
        let is_called = self.is_called(&MOVED);
        let numbers = || self.params().iter().filter_map(|t| t.number(self.text));
        let is_small = numbers().all(|x| x.abs() < SMALL_ANGLE);
        let is_either = is_small && numbers().any(|x| x % ANGLE_STEP != 0.0);
        if is_called || is_either {
            if !is_called {
                translation.fix.applicability = Applicability::Choice;
                angles.fix.applicability = Applicability::Choice;
            }
            out.push(translation);
        }
        out.push(angles);
    }

    /// A rotation with an angle for each axis, as other programs have it: one about each axis whose angle is not 0,
    /// about x first.
    pub(super) fn angles(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| ty.kind == RecordKind::Rotation)?;
        let [first, _, last] = *self.params() else {
            return None;
        };
        let mut turns = Vec::new();
        for (axis, t) in (1..).zip(self.params()) {
            if t.number(self.text)? != 0.0 {
                turns.push(format!("{} {axis}", t.text(self.text)));
            }
        }
        let title = match turns.len() {
            0 => return None,
            1 => "fix-write",
            _ => "fix-turns",
        };
        let text = turns.join(&format!("\n{} {} ", self.id()?, ty.code));
        let span = Span::new(first.start, last.end());
        let fix = Fix::replace(title, Applicability::Unsafe, span, text.clone());
        Some(Candidate::new(
            Habit::Doubled,
            fix.with("number", quote(&text)),
        ))
    }

    /// Guesses at a rotation whose axis is a vector, behind the angle or before it: the reading whose vector has the
    /// length 1. If both have, or neither, both are choices.
    pub(super) fn about_vector(&self, out: &mut Vec<Candidate>) {
        let &[a, b, c, d] = self.params() else { return };
        let is_rotation = self.ty().is_some_and(|ty| ty.kind == RecordKind::Rotation);
        if !is_rotation || self.quaternion().is_some() {
            return;
        }
        let mut readings: Vec<(bool, String)> = [(a, [b, c, d]), (d, [a, b, c])]
            .into_iter()
            .filter_map(|(angle, vector)| self.about(&angle, &vector))
            .collect();
        if readings.iter().any(|r| r.0) {
            readings.retain(|r| r.0);
        }
        let applicability = match readings.len() {
            1 => Applicability::Unsafe,
            _ => Applicability::Choice,
        };
        let span = a.span().to(d.span());
        out.extend(readings.into_iter().map(|(_, text)| {
            let mut candidate = Candidate::writing(Habit::Doubled, span, text);
            candidate.fix.applicability = applicability;
            candidate
        }));
    }

    /// Reads a rotation about a vector along one of the axes: whether the vector has the length 1, and the angle and
    /// axis as a text. `None` if the vector is along none of them.
    fn about(&self, angle: &Token, vector: &[Token; 3]) -> Option<(bool, String)> {
        let numbers: Option<Vec<f64>> = vector.iter().map(|t| t.number(self.text)).collect();
        let mut along = (1..).zip(numbers?).filter(|(_, x)| *x != 0.0);
        let (Some((axis, length)), None) = (along.next(), along.next()) else {
            return None;
        };
        let angle = angle.text(self.text);
        let angle = match (length < 0.0, angle.strip_prefix('-')) {
            (true, Some(rest)) => rest.to_owned(),
            (true, None) => format!("-{angle}"),
            (false, _) => angle.to_owned(),
        };
        Some((length.abs() == 1.0, format!("{angle} {axis}")))
    }

    /// The parts of a quaternion in the place of a rotation's angle and axis.
    fn quaternion(&self) -> Option<[f64; 4]> {
        self.ty().filter(|ty| ty.kind == RecordKind::Rotation)?;
        let parts: Option<Vec<f64>> = self.params().iter().map(|t| t.number(self.text)).collect();
        let parts = <[f64; 4]>::try_from(parts?).ok()?;
        is_quaternion(parts).then_some(parts)
    }

    /// Whether the rotation is a quaternion that turns about none of the three axes.
    pub(in crate::analysis::repair) fn is_turn_about_no_axis(&self) -> bool {
        let is_none = |parts| ORDERS.iter().all(|&(_, w)| turn(parts, w).is_none());
        self.quaternion().is_some_and(is_none)
    }

    /// Guesses at the angle and the axis of a quaternion, for each order of its parts in which it turns about one of
    /// the three axes.
    pub(super) fn turns_of_quaternion(&self, out: &mut Vec<Candidate>) {
        let Some(parts) = self.quaternion() else {
            return;
        };
        let turns = ORDERS.map(|(order, w)| Some((order, turn(parts, w)?)));
        let applicability = match turns.iter().flatten().count() {
            1 => Applicability::Unsafe,
            _ => Applicability::Choice,
        };
        let params = self.params();
        let span = params[0].span().to(params[3].span());
        out.extend(turns.into_iter().flatten().map(|(order, (degrees, axis))| {
            let text = format!("{} {axis}", decimal(degrees));
            let fix = Fix::replace("fix-quaternion", applicability, span, text.clone());
            let fix = fix.with("order", quote(order)).with("number", quote(&text));
            Candidate::new(Habit::Doubled, fix)
        }));
    }

    /// Guesses at a rotation that has a letter for its axis, which may stand before the angle.
    pub(super) fn axis(&self, out: &mut Vec<Candidate>) {
        let turns = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Rotation);
        let params = self.without_axis_word();
        let new = self.axis_number(&params).filter(|_| turns);
        out.extend(new.and_then(|new| self.write(Habit::Axis, &new)));
    }

    /// Guesses at the axis that a comment on the line names, where the number of the axis is none.
    pub(super) fn called_axis(&self, finding: &Diagnostic) -> Option<Candidate> {
        let is_rotation = |ty: &RecordType| ty.kind == RecordKind::Rotation && self.fits(ty);
        let is_one = finding.code == Code::E205 && self.ty().is_some_and(is_rotation);
        let mut comments = self.all.iter().filter(|t| t.kind().is_comment());
        let scene = &self.analysis.scene;
        let said = || comments.find_map(|t| axis_by_comment(t.text(self.text), scene));
        let axis = is_one.then(said)??.to_string();
        self.write(Habit::Digit, &[(*self.params().last()?, axis)])
    }

    /// The parameters, where a word for an axis is joined with the token behind it: `90 axis x`.
    fn without_axis_word(&self) -> Vec<Token> {
        let is_word = |t: &Token| {
            let text = t.text(self.text).to_lowercase();
            AXIS.contains(&&*text)
        };
        let mut params = self.params().to_vec();
        let word = params.iter().position(is_word);
        if let Some(i) = word.filter(|&i| i + 1 < params.len()) {
            let word = params.remove(i);
            params[i] = self.joined(&word, &params[i]);
        }
        params
    }

    /// The new texts of a rotation's two tokens, if its axis is a letter: the angle first, then the number of the axis.
    pub(super) fn axis_number(&self, params: &[Token]) -> Option<[(Token, String); 2]> {
        let &[first, last] = params else {
            return None;
        };
        let last_word = |t: &Token| t.text(self.text).split_whitespace().last();
        let axis = |t: &Token| match last_word(t)? {
            "x" | "X" => Some("1"),
            "y" | "Y" => Some("2"),
            "z" | "Z" => Some("3"),
            _ => None,
        };
        let (angle, axis) = match (axis(&first), axis(&last)) {
            (Some(axis), None) => (last, axis),
            (None, Some(axis)) => (first, axis),
            _ => return None,
        };
        let angle = angle.text(self.text).to_owned();
        Some([(first, angle), (last, axis.to_owned())])
    }
}
