//! A record line by line: which line has too few numbers or too many, or would be a record of its own.

use super::super::last_row;
use super::super::quote::quote;
use super::super::table::RecordType;
use super::diagnosis::RecordCandidate;
use super::report::{Reporter, header};
use super::witness::Witnesses;
use crate::diagnostics::{Code, Diagnostic, Value};

impl Reporter<'_, '_> {
    /// Whether the last line of a record is its last row and rather a record of its own.
    pub(super) fn ends_with_record(
        &self,
        witnesses: &Witnesses,
        piece: &RecordCandidate,
        ty: &RecordType,
    ) -> bool {
        let stretch = self.stretch;
        let (last, text) = (stretch.line(piece.end - 1), stretch.text());
        let row = stretch.line_start(last)..stretch.line_end(last);
        let is_row = row.end == piece.end && ty.vectors.last() == Some(&row.len());
        if stretch.line(piece.start) == last || !is_row || ty.is_counted() {
            return false;
        }
        let params = (piece.start + 2..piece.end).map(|i| stretch.token(i).number(text));
        let params: Option<Vec<f64>> = params.collect();
        witnesses.is_complete_line(stretch, last)
            && params.is_some_and(|params| last_row::is_record(ty, &params))
    }

    /// The warning about a record that takes its last numbers from a line which would be a record by itself.
    pub(super) fn line_break(&self, piece: &RecordCandidate, ty: &RecordType) -> Diagnostic {
        let stretch = self.stretch;
        let last = stretch.line(piece.end - 1);
        let (head, line_end) = (stretch.line_start(last), stretch.line_end(last));
        let taken = piece.end - head;
        let is_row = !ty.is_counted() && line_end == piece.end && ty.vectors.last() == Some(&taken);
        let count = |n: usize| Value::Count(n as u64);
        Diagnostic::new(Code::W314, self.span(head, piece.end))
            .case(if is_row { "row" } else { "" })
            .with("type", Value::Term(ty.title))
            .with("wanted", count(piece.end - piece.start - 2))
            .with("got", count(head.saturating_sub(piece.start + 2)))
            .with("off", count(taken))
            .with(
                "line",
                quote(&stretch.text()[self.span(head, line_end).range()]),
            )
            .with("header", header(ty))
            .label(self.span(piece.start, head), "begin")
    }

    /// The number of points that a record has, if its count says another number. `None` if its numbers are not whole
    /// points.
    pub(super) fn points(
        &self,
        piece: &RecordCandidate,
        ty: &RecordType,
        got: usize,
    ) -> Option<usize> {
        let each: usize = ty.repeats.iter().map(|group| group.len()).sum();
        let numbers = got.checked_sub(1).filter(|_| each > 0)?;
        if !numbers.is_multiple_of(each) || numbers < 2 * each {
            return None;
        }
        let rows = self.rows(piece, ty);
        let is_whole = |&(from, to): &(usize, usize)| {
            (ty.repeats.iter()).any(|group| (to - from).is_multiple_of(group.len()))
        };
        (rows.len() == 1 || rows.iter().all(is_whole)).then_some(numbers / each)
    }

    /// For each line of a record the range of tokens that are its numbers, without ID, type and number of points.
    fn rows(&self, piece: &RecordCandidate, ty: &RecordType) -> Vec<(usize, usize)> {
        let stretch = self.stretch;
        let head = piece.start + 2 + usize::from(ty.is_counted());
        let (first, last) = (stretch.line(piece.start), stretch.line(piece.end - 1));
        let rows = (first..=last).map(|l| {
            let from = match l == first {
                true => head,
                false => stretch.line_start(l),
            };
            let to = stretch.line_end(l).min(piece.end);
            (from.min(to), to)
        });
        rows.collect()
    }

    /// Whether each line has one vector of a type, so that some vectors are left out and no line is to blame.
    fn are_vectors(&self, rows: &[(usize, usize)], ty: &RecordType) -> bool {
        let mut lengths = ty.vectors.iter();
        !ty.vectors.is_empty()
            && (rows.iter().map(|(from, to)| to - from).filter(|&n| n > 0))
                .all(|n| lengths.any(|&length| length == n))
    }

    /// The line of a record over several lines that is longer or shorter than the others by just as much as the whole
    /// record is too long or too short, as a range of tokens.
    pub(super) fn odd_row(
        &self,
        piece: &RecordCandidate,
        ty: &RecordType,
        got: usize,
        expected: usize,
    ) -> Option<(usize, usize)> {
        let stretch = self.stretch;
        let (first, last) = (stretch.line(piece.start), stretch.line(piece.end - 1));
        if first == last || stretch.is_free {
            return None;
        }
        let rows = self.rows(piece, ty);
        if self.are_vectors(&rows, ty) {
            return None;
        }
        let off = got as i64 - expected as i64;
        let lengths: Vec<i64> = rows.iter().map(|r| (r.1 - r.0) as i64).collect();
        if lengths[0] == off && off > 0 {
            return Some((piece.start, rows[0].1));
        }
        // How uneven the table is with row `r` put right: how often the length changes from row to
        // row (a short last row is none), and whether points and colours part at a row's end.
        let points = ty.repeats.first().map_or(0, |g| g.len() as i64);
        let head = piece.start + 2 + usize::from(ty.is_counted());
        let points = points * stretch.sigs[(head - 1).min(piece.end - 1)].int.unwrap_or(0) as i64;
        let uneven = |r: usize| {
            let right = |i: usize| lengths[i] - if i == r { off } else { 0 };
            let begin = usize::from(lengths[0] == 0);
            let changes = (begin + 1..lengths.len())
                .filter(|&i| {
                    let (before, now) = (right(i - 1), right(i));
                    now > before || now < before && i + 1 < lengths.len()
                })
                .count();
            let mut sum = 0;
            let parted = (0..lengths.len()).any(|i| {
                sum += right(i);
                sum == points
            });
            let mut distinct: Vec<i64> = (begin..lengths.len()).map(right).collect();
            distinct.sort_unstable();
            distinct.dedup();
            (!parted, changes, distinct.len(), r + 1 == lengths.len())
        };
        let first_row = usize::from(lengths[0] == 0);
        let best = (first_row..rows.len())
            .filter(|&r| lengths[r] - off > 0)
            .min_by_key(|&r| uneven(r))?;
        let from = stretch.line_start(first + best).max(piece.start);
        Some((from, rows[best].1))
    }
}
