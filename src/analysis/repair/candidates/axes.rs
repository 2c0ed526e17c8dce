//! Vectors along an axis, as POV-Ray has them: `2*z`, `y`, `-x`; and turns about one, `x*75`.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::Applicability;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Family, RecordKind, ShapeKind};

/// How many numbers a vector has.
const OWN: usize = 3;

/// Reads a turn such as `x*75` or `-30*y` as its angle and the number of its axis, 1 to 3.
pub(super) fn about_axis(text: &str) -> Option<String> {
    let (factor, axis) = product(text)?;
    Some(format!("{factor} {}", axis + 1))
}

/// Reads a vector such as `2*z`, `z*2`, `y` or `-y` as its three numbers.
pub(super) fn along_axis(text: &str) -> Option<String> {
    let (factor, axis) = match text.strip_prefix('-') {
        Some(rest) if axis(rest).is_some() => ("-1", axis(rest)?),
        _ => axis(text).map_or_else(|| product(text), |axis| Some(("1", axis)))?,
    };
    let mut numbers = ["0"; OWN];
    numbers[axis] = factor;
    Some(numbers.join(" "))
}

/// Splits a product of a number and an axis into the number and the index of the axis, 0 to 2.
fn product(text: &str) -> Option<(&str, usize)> {
    let (a, b) = text.split_once('*')?;
    let (axis, factor) = match (axis(a), axis(b)) {
        (Some(axis), None) => (axis, b),
        (None, Some(axis)) => (axis, a),
        _ => return None,
    };
    let is_number = factor.parse().is_ok_and(f64::is_finite);
    is_number.then_some((factor, axis))
}

fn axis(text: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == text)
}

impl LineContext<'_> {
    /// Guesses at the numbers of vectors along an axis, and of a turn about one: `2 -1 2*z`, `2 -2 80*x`, `20 4 y 0`.
    pub(super) fn vectors(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let params = self.params();
        if ty.kind == RecordKind::Rotation {
            let [one] = params else { return None };
            let turn = about_axis(one.text(self.text))?;
            return self.write(Habit::Characters, &[(*one, turn)]);
        }
        let has_place = matches!(
            ty.family,
            Family::Shape | Family::Camera | Family::Transformation
        );
        // A scaling along one axis would leave nothing of an object.
        if !has_place || ty.kind == RecordKind::Scaling || params.len() >= ty.params.len() {
            return None;
        }
        let starts = |at: usize| {
            let ends = ty.vectors.iter().scan(0, |sum, n| {
                *sum += n;
                Some(*sum)
            });
            at == 0 || ends.into_iter().any(|end| end == at)
        };
        let mut new: Vec<(Token, String)> = Vec::new();
        let mut count = 0;
        for t in params {
            match along_axis(t.text(self.text)) {
                Some(numbers) if starts(count) => {
                    new.push((*t, numbers));
                    count += OWN;
                }
                _ if t.kind().is_number() => count += 1,
                _ => return None,
            }
        }
        if count != ty.params.len() {
            return None;
        }
        let mut candidate = self.write(Habit::Characters, &new)?;
        let planes = [ShapeKind::HalfSpace, ShapeKind::Plane].map(RecordKind::Shape);
        let is_offset = params.last()?.number(self.text) != Some(0.0);
        // In POV-Ray d has the other sign.
        if planes.contains(&ty.kind) && is_offset {
            candidate.fix.applicability = Applicability::Choice;
        }
        Some(candidate)
    }
}
