//! A rectangle by two corners in space.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::syntax::lexer::Token;
use crate::syntax::table::{RecordKind, RecordType, ShapeKind};

/// The numbers of a corner in space.
const AXES: usize = 3;

impl LineContext<'_> {
    /// Guesses at a rectangle with the six numbers of a box without thickness: a rectangle in the plane z = 0 that is
    /// turned and moved to its place. A box is not proposed, since it would have no inside.
    pub(super) fn flat(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let rectangle = RecordKind::Shape(ShapeKind::Rectangle);
        let is_one = self.ty().is_some_and(|ty| ty.kind == rectangle);
        let params = self.params();
        if finding.code != Code::E009 || !is_one || params.len() != 2 * AXES {
            return;
        }
        let Some((records, id)) = self.turned_rectangle().zip(self.id()) else {
            return;
        };
        out.retain(|c| {
            c.ty.is_none_or(|ty| ty.kind != RecordKind::Shape(ShapeKind::Box))
        });
        let text = records.join(&format!("\n{id} "));
        let head = RecordType::of(rectangle).code;
        let shown: Vec<String> = (records.iter().enumerate())
            .map(|(i, record)| match i {
                0 => format!("`{id} {head} {record}`"),
                _ => format!("`{id} {record}`"),
            })
            .collect();
        let span = params[0].span().to(params[params.len() - 1].span());
        let fix = Fix::replace("fix-flat", Applicability::Unsafe, span, text);
        out.push(Candidate::new(
            Habit::Sibling,
            fix.with("records", shown.join(", ")),
        ));
    }

    /// The numbers of the rectangle, then the records that turn and move it, all without IDs. `None` where its corners
    /// differ on all axes, or are the same on two.
    fn turned_rectangle(&self) -> Option<Vec<String>> {
        let params = self.params();
        self.spaced(params)?;
        let numbers: Option<Vec<f64>> = params.iter().map(|t| t.number(self.text)).collect();
        let numbers = numbers?;
        let is_same = |axis: &usize| numbers[*axis] == numbers[AXES + *axis];
        let mut flat = (0..AXES).filter(is_same);
        let (axis, None) = (flat.next()?, flat.next()) else {
            return None;
        };
        // About x, 90° take y to z; about y, -90° take x to z.
        let ([right, up], turn) = match axis {
            0 => ([2, 1], Some("-2 -90 2")),
            1 => ([0, 2], Some("-2 90 1")),
            _ => ([0, 1], None),
        };
        let ends = |axis: usize| {
            let ends = [axis, AXES + axis];
            match numbers[ends[0]] <= numbers[ends[1]] {
                true => ends,
                false => [ends[1], ends[0]],
            }
        };
        let text = |t: &Token| t.text(self.text).to_owned();
        let [[left, right], [low, high]] = [ends(right), ends(up)];
        let sides: Vec<String> = [left, low, right, high].map(|i| text(&params[i])).to_vec();
        let mut records = vec![sides.join(" ")];
        records.extend(turn.map(str::to_owned));
        if numbers[axis] != 0.0 {
            let mut place = ["0"; AXES].map(str::to_owned);
            place[axis] = text(&params[axis]);
            records.push(format!("-1 {}", place.join(" ")));
        }
        Some(records)
    }
}
