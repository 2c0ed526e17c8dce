//! Sums and flags over the lines and tokens of a stretch. With them any part of it is judged at once, however long it
//! is.

use super::super::table::RecordKind;
use super::slips::looks_like_a_head;
use super::stretch::Stretch;
use super::witness::Witnesses;

pub(super) struct Sums {
    /// For each line and the end, how many lines before it look like records of their own.
    pub own_before: Vec<u32>,
    /// For each line and the end, how many lines before it are complete records. Rows of a table of equally long lines
    /// do not count.
    pub complete_before: Vec<u32>,
    /// For each line and the end, how many lines before it are surely records of their own: they are records but for a
    /// slip, or complete records with an ID in order.
    pub sure_before: Vec<u32>,
    /// For each line the last line of the table of numbers that follows it; the line itself if none follows.
    pub table_end: Vec<u32>,
    /// For each token and the end, whether the part of its line before it is whole records.
    pub whole_until: Vec<bool>,
    /// For each token and the end, whether its line is whole records from it on.
    pub whole_from: Vec<bool>,
    /// For each token whether a piece may begin there.
    pub may_begin: Vec<bool>,
}

impl Sums {
    pub(super) fn is_sure(&self, line: usize) -> bool {
        self.sure_before[line + 1] > self.sure_before[line]
    }

    pub(super) fn is_own(&self, line: usize) -> bool {
        self.own_before[line + 1] > self.own_before[line]
    }

    pub(super) fn new(stretch: &Stretch, witnesses: &Witnesses) -> Sums {
        let lines = 0..stretch.line_count();
        let length = |l: usize| stretch.line_end(l) - stretch.line_start(l);
        let in_order = |l: usize| witnesses.order.head(stretch, l).is_some();
        let own = |l: usize| {
            witnesses.ends[l] > 0
                || witnesses.slips[l]
                || in_order(l)
                || looks_like_a_head(stretch, l)
        };
        let complete = |l: usize| {
            witnesses.is_complete_line(stretch, l)
                && !witnesses.is_void_line(stretch, l)
                && (l == 0 || length(l) != length(l - 1))
        };
        let sure =
            |l: usize| witnesses.slips[l] || witnesses.is_complete_line(stretch, l) && in_order(l);
        let mut table_end: Vec<u32> = lines.clone().map(|l| l as u32).collect();
        for l in lines.clone().rev().skip(1) {
            let row = !own(l + 1)
                && stretch.all_numbers(stretch.line_start(l + 1), stretch.line_end(l + 1));
            if row {
                table_end[l] = table_end[l + 1];
            }
        }
        let (whole_until, whole_from) = whole(stretch);
        Sums {
            may_begin: may_begin(stretch, &whole_from),
            whole_until,
            whole_from,
            own_before: sums(lines.clone().map(own)),
            complete_before: sums(lines.clone().map(complete)),
            sure_before: sums(lines.map(sure)),
            table_end,
        }
    }
}

/// For each token and the end, whether the part of its line before it is whole records, and the part from it on.
fn whole(stretch: &Stretch) -> (Vec<bool>, Vec<bool>) {
    let n = stretch.len();
    let (mut until, mut from) = (vec![false; n + 1], vec![false; n + 1]);
    let step = |i: usize| {
        if stretch.sigs[i].int == Some(0) {
            return stretch.sigs[i].before_comment.then_some(i + 1);
        }
        let end = stretch.read(i)?.end;
        (end > i + 2 && end <= stretch.line_end(stretch.line(i))).then_some(end)
    };
    for i in (0..n).rev() {
        from[i] = step(i).is_some_and(|end| stretch.ends_line(end) || from[end]);
    }
    for i in 0..n {
        until[i] |= stretch.starts_line(i);
        if until[i]
            && let Some(end) = step(i).filter(|&e| e < n && !stretch.starts_line(e))
        {
            until[end] = true;
        }
    }
    (until, from)
}

/// For each token whether a piece may begin there. No piece begins in the middle of a line that begins like a record,
/// unless the line is a row of whole records: a number too many is not the ID of another record.
fn may_begin(stretch: &Stretch, whole_from: &[bool]) -> Vec<bool> {
    let mut out = vec![true; stretch.len() + 1];
    for line in 0..stretch.line_count() {
        let (start, end) = (stretch.line_start(line), stretch.line_end(line));
        // Bad tokens may stand before the record.
        let head = (start..end)
            .find(|&i| !stretch.sigs[i].kind.is_bad())
            .unwrap_or(end);
        let headed = stretch
            .sigs
            .get(head)
            .and_then(|s| s.int)
            .is_some_and(|id| id > 0)
            && head + 1 < end
            && stretch
                .record_type(head + 1)
                .is_some_and(|t| t.kind != RecordKind::Undefined);
        if !headed || is_row_of_records(stretch, head, end, whole_from) {
            continue;
        }
        let behind = head + 1..end;
        for (out, sig) in out[behind.clone()].iter_mut().zip(&stretch.sigs[behind]) {
            let heading = sig.int == Some(0) && sig.before_comment;
            *out = heading || sig.kind.is_bad();
        }
    }
    out
}

/// Whether tokens `start..end` are whole records with nothing odd about them.
fn is_row_of_records(stretch: &Stretch, start: usize, end: usize, whole_from: &[bool]) -> bool {
    let mut at = start;
    while at < end {
        if !whole_from[at] {
            return false;
        }
        at = match stretch.read(at) {
            Some(r) if !stretch.is_odd(at, r) => r.end,
            Some(_) => return false,
            None => at + 1,
        };
    }
    true
}

/// The number of flags that are true before each place, and in all.
fn sums(flags: impl Iterator<Item = bool>) -> Vec<u32> {
    let mut n = 0;
    std::iter::once(0)
        .chain(flags.map(|f| {
            n += u32::from(f);
            n
        }))
        .collect()
}
