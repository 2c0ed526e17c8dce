//! Matrices of fewer rows and columns than those of the language, as other programs have them.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::Applicability;
use crate::syntax::lexer::Token;
use crate::syntax::table::RecordKind;

/// Rows and columns of a matrix.
const SIDE: usize = 4;
/// Numbers of a matrix without a place: 3 × 3.
const LINEAR: usize = 9;
/// Numbers of an affine matrix without its last row: 3 × 4.
const AFFINE: usize = 12;
/// The last row of an affine matrix.
const LAST_ROW: &str = "0 0 0 1";

impl LineContext<'_> {
    /// Whether a transformation has fewer numbers than an affine matrix in full, and may be a smaller one.
    pub(in crate::analysis::repair) fn is_smaller_matrix(&self) -> bool {
        let is_one = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::RotationMatrix);
        is_one && (SIDE..=AFFINE).contains(&self.params().len())
    }

    /// The numbers of a 3 × 3 matrix with zeros where there is no move. Twelve numbers are three rows of four, or four of
    /// three of which the last is the move, as POV-Ray has them.
    pub(super) fn smaller_matrix(&self, out: &mut Vec<Candidate>) {
        let params = self.params();
        if !self.is_smaller_matrix() || params.iter().any(|t| t.number(self.text).is_none()) {
            return;
        }
        let text = |t: &Token| t.text(self.text);
        let all: Vec<&str> = params.iter().map(text).collect();
        let row = |some: &[&str], last: &str| format!("{} {last}", some.join(" "));
        let readings: Vec<Vec<String>> = match all.len() {
            LINEAR => vec![all.chunks(SIDE - 1).map(|some| row(some, "0")).collect()],
            AFFINE => {
                let by_rows = all.chunks(SIDE).map(|some| some.join(" ")).collect();
                let column = |i: usize| {
                    let own: Vec<&str> = all.iter().skip(i).step_by(SIDE - 1).copied().collect();
                    own.join(" ")
                };
                vec![by_rows, (0..SIDE - 1).map(column).collect()]
            }
            _ => return,
        };
        let applicability = match readings.len() {
            1 => Applicability::Unsafe,
            _ => Applicability::Choice,
        };
        let span = params[0].span().to(params[params.len() - 1].span());
        out.extend(readings.into_iter().map(|rows| {
            let text = format!("{}  {LAST_ROW}", rows.join("  "));
            let mut candidate = Candidate::writing(Habit::Doubled, span, text);
            candidate.fix.applicability = applicability;
            candidate
        }));
    }
}
