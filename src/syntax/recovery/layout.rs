//! The cheapest way to cut a stretch that is laid out in lines; where line breaks say nothing, see
//! [`free`](super::free).
//!
//! A missing or extra number shifts everything behind it, and the shifted numbers may even parse.
//! So all readings compete: the text is cut into records, VOIDs and broken pieces at the least
//! total price, found by dynamic programming over the tokens. A fault costs [`FAULT`]; a record that
//! takes numbers from a line that says it is a record of its own costs more.

use super::super::signature::Reading;
use super::super::table::{Effect, RecordKind};
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::faults;
use super::heads;
use super::id_context::IdContext;
use super::prices::{DOUBTFUL, FAULT, IMPLAUSIBLE, LEAST_PRICE, OWN_LINE, TWO_SLIPS};
use super::stretch::Stretch;
use super::sums::Sums;
use super::witness::Witnesses;

/// The most lines of a broken piece that are checked for beginning like records.
const HEADS: usize = 12;
/// How many own lines are counted at most, so that prices do not overflow.
const OWN_LINES_MAX: u32 = 1_000_000;
/// The lowest bits of a sum of prices, this many, hold a hint that decides between readings of the same price.
const HINT_BITS: u32 = 24;
/// The most tokens that a record without a count has.
const LONGEST_FIXED: usize = 20;

/// Returns the pieces of the cheapest reading. `strict` is the reading by arity, if it has no faults. `doubt_takeovers`
/// makes it dearer for a record to take numbers from a line that looks like a record of its own.
pub(super) fn cut(
    stretch: &Stretch,
    witnesses: &Witnesses,
    strict: Option<&[RecordCandidate]>,
    doubt_takeovers: bool,
) -> Vec<RecordCandidate> {
    debug_assert!(
        witnesses.in_lines,
        "free-form text is read by another search"
    );
    let search = Search {
        stretch,
        witnesses,
        sums: Sums::new(stretch, witnesses),
        doubt_takeovers,
    };
    match strict {
        Some(strict) if search.is_cheap(strict) => strict.to_vec(),
        _ => search.run(),
    }
}

struct Search<'a, 's> {
    stretch: &'a Stretch<'s>,
    witnesses: &'a Witnesses<'a>,
    sums: Sums,
    doubt_takeovers: bool,
}

impl Search<'_, '_> {
    fn run(&self) -> Vec<RecordCandidate> {
        let n = self.stretch.len();
        let mut price = vec![u64::MAX; n + 1];
        let mut from = vec![0u32; n + 1];
        price[0] = 0;
        let mut ends = Vec::new();
        for i in 0..n {
            if price[i] == u64::MAX || !self.sums.may_begin[i] {
                continue;
            }
            ends.clear();
            let exact = self.stretch.read(i);
            let mut offer = |end: usize, p: u32| {
                // The low bits choose among readings of the same price: a piece that does not begin with a line counts
                // there.
                let hint = u64::from(!self.stretch.starts_line(i));
                let total = price[i] + (u64::from(p) << HINT_BITS) + hint;
                if total < price[end] {
                    price[end] = total;
                    from[end] = i as u32;
                }
            };
            if self.stretch.sigs[i].int == Some(0) {
                offer(i + 1, self.void_price(i));
            }
            if let Some(r) = &exact {
                offer(r.end, self.record_price(i, r));
            }
            if let Some(r) = self.stretch.read_by_line(i) {
                offer(r.end, self.record_price(i, &r));
            }
            self.fault_ends(i, &mut ends);
            for &end in &ends {
                offer(end, self.fault(i, end).1);
            }
        }
        let mut pieces = Vec::new();
        let mut end = n;
        while end > 0 {
            let start = from[end] as usize;
            pieces.push(RecordCandidate {
                start,
                end,
                verdict: self.verdict(start, end),
            });
            end = start;
        }
        pieces.reverse();
        pieces
    }

    /// Whether a reading without faults costs less than any fault, so that no other reading need be tried. Every other
    /// reading has a fault: without faults a piece that begins with a `0` is a VOID, any other piece is a record, and
    /// their ends are given.
    fn is_cheap(&self, strict: &[RecordCandidate]) -> bool {
        let mut total = 0;
        strict.iter().all(|piece| {
            total += match &piece.verdict {
                Diagnosis::Whole(r) => self.record_price(piece.start, r),
                _ => self.void_price(piece.start),
            };
            total < LEAST_PRICE
        })
    }

    /// The diagnosis of tokens `start..end`, which are a piece of the cheapest reading.
    fn verdict(&self, start: usize, end: usize) -> Diagnosis {
        let fault = self.fault(start, end);
        if end == start + 1
            && self.stretch.sigs[start].int == Some(0)
            && self.void_price(start) <= fault.1
        {
            return Diagnosis::Void;
        }
        let readings = [
            self.stretch.read(start).copied(),
            self.stretch.read_by_line(start),
        ];
        match readings.into_iter().flatten().find(|r| r.end == end) {
            Some(r) if self.record_price(start, &r) <= fault.1 => Diagnosis::Whole(r),
            _ => fault.0,
        }
    }

    fn void_price(&self, i: usize) -> u32 {
        let behind = !self.stretch.starts_line(i);
        if self.stretch.sigs[i].before_comment {
            let odd = behind && !self.witnesses.voids_behind_records;
            return if odd && self.stretch.ends_line(i + 1) {
                IMPLAUSIBLE
            } else {
                0
            };
        }
        match behind {
            true => IMPLAUSIBLE,
            false if self.stretch.ends_line(i + 1) => 20,
            false => 150,
        }
    }

    /// The price of a record that is right in form.
    fn record_price(&self, start: usize, r: &Reading) -> u32 {
        let stretch = self.stretch;
        let (first, last) = (stretch.line(start), stretch.line(r.end - 1));
        let behind = !stretch.starts_line(start);
        if !behind && first == last && stretch.ends_line(r.end) {
            // One of several definitions of an ID, on a line that also reads well without its ID.
            let id = stretch.sigs[start].int.unwrap_or(0);
            let too_many = matches!(r.ty.effect, Effect::Defines(_))
                && (self.witnesses.head(stretch, id)).is_some_and(|h| {
                    h.definitions > 1 && (h.may_be_lost == 1 || h.first_line < Some(first))
                });
            return if too_many && faults::has_lost_id(stretch, start, r.end) {
                FAULT
            } else {
                0
            };
        }
        let mut price = 0;
        // `ID 0` after something else is likelier two stray numbers than an undefined object; before what is defined
        // already, it is likelier a record with a wrong type.
        let undefined = r.end == start + 2 && r.ty.kind == RecordKind::Undefined;
        if undefined && (behind || self.defines_again(first, r.end)) {
            price += 400;
        }
        if last > first {
            let witness = self.witnesses.takes_over(stretch, start, r.end);
            let group = start + 2 + r.ty.arity(r.count.into()) as usize;
            let doubted = group < r.end && self.witnesses.is_doubted(stretch, group);
            let slip = witness && self.witnesses.slips[last];
            price += match (behind, witness) {
                _ if slip || doubted => TWO_SLIPS,
                (true, true) => IMPLAUSIBLE,
                (false, true) if self.witnesses.is_void_line(stretch, last) => IMPLAUSIBLE,
                (false, true) if self.doubt_takeovers => IMPLAUSIBLE,
                (false, true) if self.is_doubtful(r.end, last) => DOUBTFUL,
                (false, true) => IMPLAUSIBLE,
                (true, false) => 300,
                (false, false) if !stretch.ends_line(r.end) => 200,
                (false, false) => 0,
            };
            // Complete records among the lines of this one make it dearer.
            let swallowed = self.sums.complete_before[last] - self.sums.complete_before[first + 1];
            let sure = self.sums.sure_before[last] - self.sums.sure_before[first + 1];
            price += 400 * swallowed.min(8) + OWN_LINE * sure.min(OWN_LINES_MAX);
        }
        // Objections that the resolver would have count too, but never as much as a fault of form.
        price + self.objections(start, r)
    }

    /// Whether a record that ends with line `line` may rightly take its numbers: nothing says for sure that the line is
    /// a record of its own.
    fn is_doubtful(&self, end: usize, line: usize) -> bool {
        end == self.stretch.line_end(line)
            && !self.sums.is_sure(line)
            && !self.witnesses.is_surely_a_record(self.stretch, line)
    }

    /// Whether the rest of a line is a record that defines what a line before defines.
    fn defines_again(&self, line: usize, start: usize) -> bool {
        let stretch = self.stretch;
        let again = |id| self.witnesses.is_defined_before(stretch, line, id);
        let defines = |r: &Reading| matches!(r.ty.effect, Effect::Defines(_));
        (stretch.read(start)).is_some_and(|r| defines(r) && stretch.ends_line(r.end))
            && stretch.sigs[start].int.is_some_and(again)
    }

    fn objections(&self, start: usize, r: &Reading) -> u32 {
        let id = self.stretch.sigs[start].int.unwrap_or(0);
        let mut price = 0;
        if (id == 1) != (r.ty.kind == RecordKind::Render) {
            price += 600;
        }
        let line = self.stretch.line(start);
        let elsewhere = || {
            let head = self.witnesses.head(self.stretch, id);
            head.is_some_and(|h| h.first_line != Some(line))
        };
        if matches!(r.ty.effect, Effect::Defines(_)) && elsewhere() {
            price += 700;
        }
        if !self.stretch.values_allowed(start, r) {
            price += 500;
        }
        price.min(DOUBTFUL)
    }

    /// The price of tokens `start..end` as one broken stretch, and what is wrong with it.
    fn fault(&self, start: usize, end: usize) -> (Diagnosis, u32) {
        let stretch = self.stretch;
        let (verdict, mut price) = faults::judge(stretch, start, end, self.witnesses);
        if stretch.goes_out(start + 1, end) {
            price += IMPLAUSIBLE;
        }
        let (first, last) = (stretch.line(start), stretch.line(end - 1));
        // A single token that can be nothing is passed over wherever it stands. Else a fault is
        // likelier to be a whole line, unless the rest of the line is whole records.
        let passed_over = end == start + 1 && stretch.sigs[start].kind.is_bad();
        if !passed_over {
            price += match stretch.starts_line(start) {
                true => 0,
                false if self.sums.whole_until[start] => 30,
                false => 300,
            };
            price += match stretch.ends_line(end) {
                true => 0,
                false if self.sums.whole_from[end] => 30,
                false => 150,
            };
        }
        // An unknown type ends with its line, unless whole records follow on it.
        if matches!(verdict, Diagnosis::UnknownType | Diagnosis::BadType) {
            let strong = |p: usize| {
                self.sums.whole_from[p]
                    && stretch
                        .record_type(p + 1)
                        .is_some_and(|t| t.code < 0 || t.kind == RecordKind::Render)
            };
            if (start + 2..end.min(start + 40)).any(strong) {
                price += 50;
            }
            price += (end - start).saturating_sub(LONGEST_FIXED).min(100_000) as u32;
        }
        if matches!(verdict, Diagnosis::BadPointCount { .. }) {
            price += (end - start).min(1_000_000) as u32 / 4;
        }
        if last > first {
            price += 5 * (last - first).min(12) as u32;
            if !(stretch.starts_line(start) && stretch.ends_line(end)) {
                price += 300;
            }
            // Lines that look like records of their own make the piece dearer.
            let mut own = self.sums.own_before[last + 1] - self.sums.own_before[first + 1];
            own += u32::from(
                stretch.starts_line(start) && self.witnesses.is_complete_line(stretch, first),
            );
            own += self.heads_behind(start, end);
            price += OWN_LINE * own.min(OWN_LINES_MAX);
        }
        (verdict, price)
    }

    /// How many lines of a broken piece begin like records, although all numbers that its head asks for stand before
    /// them.
    fn heads_behind(&self, start: usize, end: usize) -> u32 {
        let stretch = self.stretch;
        let (first, last) = (stretch.line(start), stretch.line(end - 1));
        let full = heads::expected_ends(stretch, start).into_iter().max();
        let is_head = |line: &usize| {
            let at = stretch.line_start(*line);
            full.is_some_and(|full| full <= at)
                && stretch.sigs[at].int.is_some_and(|id| id > 0)
                && stretch.record_type(at + 1).is_some()
        };
        (first + 1..=last).take(HEADS).filter(is_head).count() as u32
    }

    /// Adds the possible ends of a broken piece that begins at token `i` to `ends`.
    fn fault_ends(&self, i: usize, ends: &mut Vec<usize>) {
        let stretch = self.stretch;
        let line = stretch.line(i);
        let line_end = stretch.line_end(line);
        ends.push(line_end);
        let expected = heads::expected_ends(stretch, i);
        // The piece may end where another record could begin.
        let reach = expected.iter().copied().max().unwrap_or(i + 2) + 6;
        for end in i + 1..reach.min(i + 40).min(stretch.len()) {
            if end != line_end && stretch.read(end).is_some() {
                ends.push(end);
            }
        }
        // The piece may end with a later line, if the record was laid out over several.
        let on_line = line_end - i;
        for &e in &expected {
            if e <= line_end + 3 || 2 * on_line > (e - i) + 4 {
                continue;
            }
            let at = stretch.line(e.min(stretch.len()) - 1);
            for l in [at.saturating_sub(1), at, at + 1] {
                if l > line && l < stretch.line_count() {
                    ends.push(stretch.line_end(l));
                }
            }
        }
        // The rest of a short record may stand on the next line.
        if line + 1 < stretch.line_count() && !self.sums.is_own(line + 1) {
            let next = stretch.line_end(line + 1);
            let near = |&e: &usize| e.abs_diff(next) <= 1;
            if next - line_end <= 3 && expected.iter().any(near) {
                ends.push(next);
            }
        }
        if heads::is_counted(stretch, i)
            && heads::expected_end(stretch, i).is_none_or(|e| e > line_end)
        {
            // The table of points may be of any length.
            let l = self.sums.table_end[line] as usize;
            ends.push(stretch.line_end(l));
        }
    }
}
