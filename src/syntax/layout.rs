//! Arity first, layout as witness: what to make of a text that cannot be read by arity alone, or
//! whose reading looks odd.
//!
//! A missing or extra number shifts everything behind it, and the shifted numbers may even parse.
//! So all readings compete: the text is cut into records, VOIDs and broken stretches at the least
//! total price, found by dynamic programming over the tokens. A fault costs [`FAULT`]; a record
//! that begins behind another one and ends on a later line costs little where the text is free-form,
//! and more than a fault where a line says that it is a record of its own.

use super::faults::{self, Verdict};
use super::reader::{self, Reading};
use super::references;
use super::stream::Stream;
use super::table::{Effect, RecordType};
use std::collections::{HashMap, HashSet};

/// The price of one error. All other prices are in relation to this one.
pub const FAULT: u32 = 1000;
/// The price of what is likelier a mistake than meant: more than one error, less than two.
const IMPLAUSIBLE: u32 = 1200;
/// The price of a reading that only a second look would doubt: a little less than an error.
const DOUBTFUL: u32 = 900;
/// Prices are added up above this many bits, which count what tells equal readings apart.
const HINT_BITS: u32 = 24;

/// One piece of the text: tokens `start..end`.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    pub start: usize,
    pub end: usize,
    pub verdict: Verdict,
}

/// Records with at least this many parameters are often laid out over several lines.
pub const LONG: usize = 9;

/// No record without a count has more tokens.
const LONGEST_FIXED: usize = 20;

/// What the lines of a text say about its layout.
pub struct Witnesses {
    /// For each line: it begins a record that ends at a line's end, or it is a VOID with a comment.
    /// Holds one past the record's last token, 0 where the line is no witness.
    ends: Vec<u32>,
    /// The text is laid out with records beginning and ending with lines.
    pub in_lines: bool,
    /// What the witness lines say about each ID they define.
    heads: HashMap<i32, Head>,
    /// The IDs that witness lines use or change.
    used: HashSet<i32>,
    /// Comments behind a record on its line are introduced by `0` here.
    voids_behind_records: bool,
}

/// The witness lines that define one ID.
struct Head {
    first_line: usize,
    /// How many can only be definitions, so that all but one are too many; and how many of these
    /// also read well as a record without its ID.
    definitions: u32,
    may_be_lost: u32,
}

impl Head {
    fn at(first_line: usize) -> Head {
        Head {
            first_line,
            definitions: 0,
            may_be_lost: 0,
        }
    }
}

impl Witnesses {
    pub fn new(stream: &Stream) -> Witnesses {
        let lines = stream.line_count();
        let mut ends = vec![0u32; lines];
        let mut heads = HashMap::new();
        for (line, end) in ends.iter_mut().enumerate() {
            let start = stream.line_start(line);
            if stream.sigs[start].int == Some(0) {
                let alone = stream.line_end(line) == start + 1;
                if alone && stream.sigs[start].before_comment {
                    *end = start as u32 + 1;
                }
            } else if let Some(r) = reader::read(stream, start)
                && testifies(stream, start, &r)
            {
                *end = r.end as u32;
            }
        }
        // How much of the text is laid out in lines: a walk from record to record. One disturbed
        // stretch is what one mistake makes, however long the record is that it spoils.
        let (mut line, mut covered, mut stretches, mut disturbed) = (0, 0, 0, false);
        let mut steps = 0;
        let mut used = HashSet::new();
        while line < lines {
            let next = match ends[line] {
                0 if run_to_line_end(stream, line) => line + 1,
                0 => {
                    stretches += usize::from(!disturbed);
                    disturbed = true;
                    line += 1;
                    continue;
                }
                end => {
                    let start = stream.line_start(line);
                    let id = stream.sigs[start].int.unwrap_or(0);
                    match record_type(stream, start + 1).map(|t| t.effect) {
                        Some(Effect::Defines(_)) => {
                            let lost = faults::has_lost_id(stream, start, end as usize);
                            let head = heads.entry(id).or_insert(Head::at(line));
                            head.definitions += 1;
                            head.may_be_lost += u32::from(lost);
                        }
                        Some(Effect::DefinesOrChanges(..)) => {
                            heads.entry(id).or_insert(Head::at(line));
                        }
                        Some(Effect::Changes(_)) => {
                            used.insert(id);
                        }
                        None => {}
                    }
                    used.extend(references::of_record(stream, start, end as usize));
                    stream.line(end as usize - 1) + 1
                }
            };
            disturbed = false;
            steps += 1;
            covered += next - line;
            line = next;
        }
        let mostly = 20 * covered >= 13 * lines || (stretches <= 1 && steps >= 4) || lines < 12;
        let in_lines = steps > 0 && steps + 2 >= 3 * stretches && mostly;
        if !in_lines {
            // What looks like a record at the head of a line is one by chance.
            heads.clear();
            used.clear();
        }
        Witnesses {
            in_lines,
            ends,
            heads,
            used,
            voids_behind_records: voids_behind_records(stream),
        }
    }

    /// Whether a number is used as an ID elsewhere and defined by no line of its own: if a record
    /// begins with it, then it is that record's ID.
    pub fn is_missing(&self, id: i32) -> bool {
        self.used.contains(&id) && !self.heads.contains_key(&id)
    }

    /// Whether a line would be a complete record by itself.
    pub fn is_complete_line(&self, stream: &Stream, line: usize) -> bool {
        self.ends[line] as usize == stream.line_end(line)
    }

    fn is_void_line(&self, stream: &Stream, line: usize) -> bool {
        self.ends[line] > 0 && stream.sigs[stream.line_start(line)].int == Some(0)
    }

    /// Whether the record at tokens `start..end` takes its last parameters from the head of a line
    /// that says it is a record of its own. A line in a table of equally long lines says nothing.
    pub fn takes_over(&self, stream: &Stream, start: usize, end: usize) -> bool {
        let (first, last) = (stream.line(start), stream.line(end - 1));
        if first == last || self.ends[last] == 0 {
            return false;
        }
        let length = |l: usize| stream.line_end(l) - stream.line_start(l);
        !(last > first + 1 && length(last) == length(last - 1))
    }
}

/// Whether a record that begins with a line says something about the layout: it ends with a line
/// too, and it is no row of a table by chance. Short records over several lines are rare, and so is
/// an ID 1 without the type 9999.
fn testifies(stream: &Stream, start: usize, r: &Reading) -> bool {
    let one_line = stream.line(start) == stream.line(r.end - 1);
    let long = r.ty.is_counted() || r.ty.params.len() >= LONG;
    let render = (stream.sigs[start].int == Some(1)) == (r.ty.code == 9999);
    stream.ends_line(r.end)
        && r.end - start > 2
        && (one_line || long)
        && render
        && faults::values_allowed(stream, start, r)
}

/// Whether people here write `2 9 1 0 # a sphere #`: several do, or nobody does without the `0`.
fn voids_behind_records(stream: &Stream) -> bool {
    let (mut with, mut without) = (0, 0);
    for line in 0..stream.line_count() {
        let (start, end) = (stream.line_start(line), stream.line_end(line));
        let last = &stream.sigs[end - 1];
        if end - start > 2 && last.before_comment {
            let read = |end: usize| reader::read(stream, start).is_some_and(|r| r.end == end);
            if last.int == Some(0) && read(end - 1) {
                with += 1;
            } else if read(end) {
                without += 1;
            }
        }
    }
    with > 1 || without == 0
}

pub fn record_type(stream: &Stream, i: usize) -> Option<&'static RecordType> {
    RecordType::by_code(stream.sigs.get(i)?.int?.into())
}

/// Whether a line is a row of several records that ends with its last one.
fn run_to_line_end(stream: &Stream, line: usize) -> bool {
    let (mut i, end) = (stream.line_start(line), stream.line_end(line));
    while i < end {
        let sig = &stream.sigs[i];
        if sig.int == Some(0) && sig.before_comment {
            i += 1;
        } else if let Some(r) = reader::read(stream, i).filter(|r| r.end <= end && r.end > i + 2) {
            i = r.end;
        } else {
            return false;
        }
    }
    true
}

/// Whether a reading without faults leaves nothing to ask the layout: every record begins with a
/// line, and none takes over the head of a line that says it is a record of its own.
pub fn is_undisturbed(stream: &Stream, starts: impl Iterator<Item = (usize, usize)>) -> bool {
    let mut previous_void = false;
    let mut defined = HashMap::new();
    for (start, end) in starts {
        if let Some(Effect::Defines(_)) = record_type(stream, start + 1).map(|t| t.effect)
            && end > start + 1
            && let Some(other) = defined.insert(stream.sigs[start].int, (start, end))
            && [other, (start, end)]
                .iter()
                .any(|&(s, e)| faults::has_lost_id(stream, s, e))
        {
            return false;
        }
        if !stream.starts_line(start) && !previous_void {
            return false;
        }
        previous_void = end == start + 1 && stream.sigs[start].before_comment;
        let last = stream.line(end - 1);
        if last != stream.line(start) {
            let head = stream.line_start(last);
            let looks = stream.sigs[head].int == Some(0) && stream.sigs[head].before_comment
                || reader::read(stream, head).is_some_and(|r| stream.ends_line(r.end));
            if looks {
                return false;
            }
        }
    }
    true
}

/// A reading without faults as pieces.
pub fn whole_pieces(stream: &Stream, extents: impl Iterator<Item = (usize, usize)>) -> Vec<Piece> {
    extents
        .map(|(start, end)| Piece {
            start,
            end,
            verdict: match reader::read(stream, start) {
                Some(r) if r.end == end => Verdict::Whole(r),
                _ => Verdict::Void,
            },
        })
        .collect()
}

/// Whether a reading without faults has something in it that people do not write in a text laid out
/// in lines: a record that straddles, a VOID without a comment behind a record, a heading's `0`
/// taken for a number.
pub fn is_odd(stream: &Stream, witnesses: &Witnesses, pieces: &[Piece]) -> bool {
    witnesses.in_lines
        && pieces.iter().any(|p| {
            let behind = !stream.starts_line(p.start);
            let last = stream.line(p.end - 1);
            let over_lines = stream.line(p.start) != last;
            match p.verdict {
                Verdict::Void => behind,
                _ => {
                    (behind && (over_lines || p.end == p.start + 2))
                        || over_lines
                            && witnesses.is_void_line(stream, last)
                            && witnesses.takes_over(stream, p.start, p.end)
                }
            }
        })
}

/// The reading with the least damage.
pub fn cut(stream: &Stream, witnesses: &Witnesses, doubt_takeovers: bool) -> Vec<Piece> {
    let search = Search {
        stream,
        witnesses,
        bad_before: bad_before(stream),
        lines: LineSums::new(stream, witnesses),
        doubt_takeovers,
    };
    search.run()
}

/// For each token the number of bad tokens before it.
fn bad_before(stream: &Stream) -> Vec<u32> {
    sums(stream.sigs.iter().map(|s| s.kind.is_bad()))
}

/// Sums over lines, so that long stretches are judged at once.
struct LineSums {
    /// How many lines before each one say that they are records of their own.
    own_before: Vec<u32>,
    /// How many of those are complete, and no row of a table of equally long lines.
    complete_before: Vec<u32>,
    /// The last line of the table of numbers that begins behind each line; the line itself if none.
    table_end: Vec<u32>,
    /// For each token: its line is whole records up to it, or from it on.
    whole_until: Vec<bool>,
    whole_from: Vec<bool>,
}

impl LineSums {
    fn is_own(&self, line: usize) -> bool {
        self.own_before[line + 1] > self.own_before[line]
    }

    fn new(stream: &Stream, witnesses: &Witnesses) -> LineSums {
        let lines = 0..stream.line_count();
        let length = |l: usize| stream.line_end(l) - stream.line_start(l);
        let own = |l: usize| witnesses.ends[l] > 0 || looks_like_a_head(stream, l);
        let complete = |l: usize| {
            witnesses.is_complete_line(stream, l)
                && !witnesses.is_void_line(stream, l)
                && (l == 0 || length(l) != length(l - 1))
        };
        let mut table_end: Vec<u32> = lines.clone().map(|l| l as u32).collect();
        for l in lines.clone().rev().skip(1) {
            let row =
                !own(l + 1) && stream.all_numbers(stream.line_start(l + 1), stream.line_end(l + 1));
            if row {
                table_end[l] = table_end[l + 1];
            }
        }
        let (whole_until, whole_from) = whole(stream);
        LineSums {
            whole_until,
            whole_from,
            own_before: sums(lines.clone().map(own)),
            complete_before: sums(lines.map(complete)),
            table_end,
        }
    }
}

/// For each token (and the end): whether its line is whole records up to it, and from it on.
fn whole(stream: &Stream) -> (Vec<bool>, Vec<bool>) {
    let n = stream.len();
    let (mut until, mut from) = (vec![false; n + 1], vec![false; n + 1]);
    let step = |i: usize| {
        if stream.sigs[i].int == Some(0) {
            return stream.sigs[i].before_comment.then_some(i + 1);
        }
        let end = reader::read(stream, i)?.end;
        (end > i + 2 && end <= stream.line_end(stream.line(i))).then_some(end)
    };
    for i in (0..n).rev() {
        from[i] = step(i).is_some_and(|end| stream.ends_line(end) || from[end]);
    }
    for i in 0..n {
        until[i] |= stream.starts_line(i);
        if until[i]
            && let Some(end) = step(i).filter(|&e| e < n && !stream.starts_line(e))
        {
            until[end] = true;
        }
    }
    (until, from)
}

/// How often it was true before each place, and in all.
fn sums(flags: impl Iterator<Item = bool>) -> Vec<u32> {
    let mut n = 0;
    std::iter::once(0)
        .chain(flags.map(|f| {
            n += u32::from(f);
            n
        }))
        .collect()
}

/// Whether a line begins like a record that no table of numbers would begin like.
fn looks_like_a_head(stream: &Stream, line: usize) -> bool {
    let start = stream.line_start(line);
    let id = stream.sigs[start].int.is_some_and(|id| id > 0);
    id && record_type(stream, start + 1).is_some_and(|t| t.code <= -99 || t.code == 9999)
}

struct Search<'a, 's> {
    stream: &'a Stream<'s>,
    witnesses: &'a Witnesses,
    bad_before: Vec<u32>,
    lines: LineSums,
    doubt_takeovers: bool,
}

impl Search<'_, '_> {
    fn run(&self) -> Vec<Piece> {
        let n = self.stream.len();
        let mut price = vec![u64::MAX; n + 1];
        let mut from = vec![0u32; n + 1];
        price[0] = 0;
        let mut ends = Vec::new();
        for i in 0..n {
            if price[i] == u64::MAX {
                continue;
            }
            ends.clear();
            let exact = reader::read(self.stream, i);
            let mut offer = |end: usize, p: u32| {
                // In the low bits, to choose among equals: pieces that do not begin with a line.
                let hint = u64::from(!self.stream.starts_line(i));
                let total = price[i] + (u64::from(p) << HINT_BITS) + hint;
                if total < price[end] {
                    price[end] = total;
                    from[end] = i as u32;
                }
            };
            if self.stream.sigs[i].int == Some(0) {
                offer(i + 1, self.void_price(i));
            }
            if let Some(r) = &exact {
                offer(r.end, self.record_price(i, r));
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
            pieces.push(Piece {
                start,
                end,
                verdict: self.verdict(start, end),
            });
            end = start;
        }
        pieces.reverse();
        pieces
    }

    /// The verdict behind a step of the cheapest way.
    fn verdict(&self, start: usize, end: usize) -> Verdict {
        let fault = self.fault(start, end);
        if end == start + 1
            && self.stream.sigs[start].int == Some(0)
            && self.void_price(start) <= fault.1
        {
            return Verdict::Void;
        }
        match reader::read(self.stream, start) {
            Some(r) if r.end == end && self.record_price(start, &r) <= fault.1 => Verdict::Whole(r),
            _ => fault.0,
        }
    }

    fn in_lines(&self) -> bool {
        self.witnesses.in_lines
    }

    fn void_price(&self, i: usize) -> u32 {
        let behind = !self.stream.starts_line(i);
        if self.stream.sigs[i].before_comment {
            let odd = behind && self.in_lines() && !self.witnesses.voids_behind_records;
            return if odd && self.stream.ends_line(i + 1) {
                IMPLAUSIBLE
            } else {
                0
            };
        }
        match (self.in_lines(), behind) {
            (true, true) => IMPLAUSIBLE,
            (true, false) if self.stream.ends_line(i + 1) => 20,
            (true, false) => 150,
            (false, _) => 0,
        }
    }

    /// The price of a record that is right in form.
    fn record_price(&self, start: usize, r: &Reading) -> u32 {
        let stream = self.stream;
        let (first, last) = (stream.line(start), stream.line(r.end - 1));
        let behind = !stream.starts_line(start);
        if !behind && first == last && stream.ends_line(r.end) {
            // One of several definitions of an ID, on a line that also reads well without its ID.
            let id = stream.sigs[start].int.unwrap_or(0);
            let too_many = matches!(r.ty.effect, Effect::Defines(_))
                && (self.witnesses.heads.get(&id)).is_some_and(|h| {
                    h.definitions > 1 && (h.may_be_lost == 1 || h.first_line < first)
                });
            return if too_many && faults::has_lost_id(stream, start, r.end) {
                FAULT
            } else {
                0
            };
        }
        let mut price = 0;
        if behind {
            // The low bits of the sum count what begins behind something else.
            if r.end == start + 2 && r.ty.code == 0 && self.in_lines() {
                price += 400;
            }
        }
        if last > first {
            let witness = self.witnesses.takes_over(stream, start, r.end);
            price += match (self.in_lines(), behind, witness) {
                (true, true, true) => IMPLAUSIBLE,
                (true, false, true) if self.witnesses.is_void_line(stream, last) => IMPLAUSIBLE,
                (true, false, true) if self.doubt_takeovers => IMPLAUSIBLE,
                (true, false, true) if r.end == stream.line_end(last) => DOUBTFUL,
                (true, false, true) => IMPLAUSIBLE,
                (true, true, false) => 300,
                (true, false, false) if !stream.ends_line(r.end) => 200,
                (false, ..) | (true, false, false) => 0,
            };
            if self.in_lines() {
                // Complete records among its lines.
                let swallowed =
                    self.lines.complete_before[last] - self.lines.complete_before[first + 1];
                price += 400 * swallowed.min(8);
            }
        }
        // What the resolver would object to counts too, but never as much as a fault of form.
        price + self.objections(start, r)
    }

    fn objections(&self, start: usize, r: &Reading) -> u32 {
        let id = self.stream.sigs[start].int.unwrap_or(0);
        let mut price = 0;
        if (id == 1) != (r.ty.code == 9999) {
            price += 600;
        }
        let line = self.stream.line(start);
        let elsewhere = (self.witnesses.heads.get(&id)).is_some_and(|h| h.first_line != line);
        if matches!(r.ty.effect, Effect::Defines(_)) && elsewhere {
            price += 700;
        }
        if !faults::values_allowed(self.stream, start, r) {
            price += 500;
        }
        price.min(DOUBTFUL)
    }

    /// The price of tokens `start..end` as one broken stretch, and what is wrong with it.
    fn fault(&self, start: usize, end: usize) -> (Verdict, u32) {
        let stream = self.stream;
        let bad = |from: usize, to: usize| self.bad_before[to] - self.bad_before[from.min(to)];
        let is_id = |id: i32| self.witnesses.is_missing(id);
        let (verdict, mut price) = faults::judge(stream, start, end, bad, is_id);
        let (first, last) = (stream.line(start), stream.line(end - 1));
        // A single token that can be nothing is passed over wherever it stands. Else a fault is
        // likelier to be a whole line, unless the rest of the line is whole records.
        let passed_over = end == start + 1 && stream.sigs[start].kind.is_bad();
        if !passed_over {
            price += match (stream.starts_line(start), self.in_lines()) {
                (true, _) => 0,
                (false, true) if self.lines.whole_until[start] => 30,
                (false, true) => 300,
                (false, false) => 20,
            };
            price += match (stream.ends_line(end), self.in_lines()) {
                (true, _) => 0,
                (false, true) if self.lines.whole_from[end] => 30,
                (false, true) => 150,
                (false, false) => 20,
            };
        }
        // An unknown type ends with its line, unless whole records follow on it.
        if matches!(verdict, Verdict::UnknownType | Verdict::BadType) {
            let strong = |p: usize| {
                self.lines.whole_from[p]
                    && record_type(stream, p + 1).is_some_and(|t| t.code < 0 || t.code == 9999)
            };
            if (start + 2..end.min(start + 40)).any(strong) {
                price += 50;
            }
            price += (end - start).saturating_sub(LONGEST_FIXED).min(100_000) as u32;
        }
        if matches!(verdict, Verdict::BadCount { .. }) {
            price += (end - start).min(1_000_000) as u32 / 4;
        }
        if last > first {
            price += 5 * (last - first).min(12) as u32;
            if self.in_lines() && !(stream.starts_line(start) && stream.ends_line(end)) {
                price += 300;
            }
            // Lines that say they are records of their own.
            let mut own = self.lines.own_before[last + 1] - self.lines.own_before[first + 1];
            own += u32::from(
                stream.starts_line(start) && self.witnesses.is_complete_line(stream, first),
            );
            price += (FAULT + FAULT / 2) * own.min(8);
        }
        (verdict, price)
    }

    /// Where a broken stretch that begins at `i` may end.
    fn fault_ends(&self, i: usize, ends: &mut Vec<usize>) {
        let stream = self.stream;
        let line = stream.line(i);
        let line_end = stream.line_end(line);
        ends.push(line_end);
        let expected = faults::expected_ends(stream, i);
        // Where another record could begin.
        let reach = expected.iter().copied().max().unwrap_or(i + 2) + 6;
        for end in i + 1..reach.min(i + 40).min(stream.len()) {
            if end != line_end && reader::read(stream, end).is_some() {
                ends.push(end);
            }
        }
        // At the end of a later line, if the record was laid out over several.
        let on_line = line_end - i;
        for &e in &expected {
            if e <= line_end + 3 || 2 * on_line > (e - i) + 4 {
                continue;
            }
            let at = stream.line(e.min(stream.len()) - 1);
            for l in [at.saturating_sub(1), at, at + 1] {
                if l > line && l < stream.line_count() {
                    ends.push(stream.line_end(l));
                }
            }
        }
        // What is left of a short record may stand on the next line.
        if line + 1 < stream.line_count() && !self.lines.is_own(line + 1) {
            let next = stream.line_end(line + 1);
            let near = |&e: &usize| e.abs_diff(next) <= 1;
            if next - line_end <= 3 && expected.iter().any(near) {
                ends.push(next);
            }
        }
        if faults::is_counted(stream, i)
            && faults::expected_end(stream, i).is_none_or(|e| e > line_end)
        {
            // The table of points may be of any length.
            let l = self.lines.table_end[line] as usize;
            ends.push(stream.line_end(l));
        }
    }
}
