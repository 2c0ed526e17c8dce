//! Numbers in groups, as spaces, brackets or the vectors of a type show them, and groups that are written twice.

use std::ops::Range;

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Fix, Span};
use crate::syntax::lexer::Token;
use crate::syntax::table::RecordType;

impl LineContext<'_> {
    /// The sizes of the groups in which numbers are written: line ends, brackets and wider spaces divide them. A single
    /// group if nothing does.
    pub(super) fn group_sizes(&self, tokens: &[Token]) -> Vec<usize> {
        let gap = |two: &[Token]| &self.text[two[0].end() as usize..two[1].start as usize];
        let width = |gap: &str| gap.chars().filter(|c| c.is_whitespace()).count();
        let least = tokens.windows(2).map(|two| width(gap(two))).min();
        let is_end = |gap: &str| {
            Some(width(gap)) > least || gap.contains(['\n', '<', '>', '(', ')', '[', ']', '{', '}'])
        };
        let mut sizes = vec![1];
        for two in tokens.windows(2) {
            match sizes.last_mut() {
                Some(size) if !is_end(gap(two)) => *size += 1,
                _ => sizes.push(1),
            }
        }
        sizes
    }

    /// Whether the parameters in the range `first` and as many behind them may be a group and its repetition: the first
    /// group is whole vectors of the type or a whole record, or both are groups of the line.
    fn is_group(&self, ty: &RecordType, first: Range<usize>) -> bool {
        let ends = |sizes: &[usize]| -> Vec<usize> {
            let sums = sizes.iter().scan(0, |sum, n| {
                *sum += n;
                Some(*sum)
            });
            std::iter::once(0).chain(sums).collect()
        };
        let last = 2 * first.end - first.start;
        let of_type = match ty.vectors {
            [] => vec![0, ty.params.len()],
            vectors => ends(vectors),
        };
        let of_line = ends(&self.group_sizes(self.params()));
        let in_all = |all: &[usize], some: &[usize]| some.iter().all(|i| all.contains(i));
        in_all(&of_type, &[first.start, first.end])
            || in_all(&of_line, &[first.start, first.end, last])
    }

    /// Guesses that surplus numbers repeat the group before them, and deletes them.
    pub(super) fn doubled(&self, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| !ty.is_counted()) else {
            return;
        };
        let (params, wanted) = (self.params(), ty.params.len());
        let Some(more) = params.len().checked_sub(wanted).filter(|&more| more > 1) else {
            return;
        };
        let text = |t: &Token| t.text(self.text);
        let value = |t: &Token| t.number(self.text).map(f64::to_bits);
        let same = |a: &[Token], b: &[Token]| a.iter().zip(b).all(|(a, b)| value(a) == value(b));
        let sorted = |a: &[Token]| {
            let mut all: Vec<&str> = a.iter().map(text).collect();
            all.sort_unstable();
            all
        };
        for i in 0..=params.len() - more {
            let dropped = &params[i..i + more];
            let again = i >= more && same(&params[i - more..i], dropped);
            let turned = i == wanted && more == wanted && sorted(&params[..i]) == sorted(dropped);
            if again && self.is_group(ty, i - more..i) || turned {
                let span = Span::new(params[i - 1].end(), dropped[more - 1].end());
                out.push(Candidate::new(
                    Habit::Doubled,
                    Fix::replace("fix-doubled", Applicability::Unsafe, span, ""),
                ));
            }
        }
    }
}
