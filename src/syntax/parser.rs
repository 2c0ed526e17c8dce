//! Text to tree.
//!
//! [chumsky](https://docs.rs/chumsky) drives a grammar of three rules: `(void | record | gap)*`. [`signature`] reads a
//! record. It is taken if the layout agrees: the record begins and ends with a line, or is one of several on a line
//! that ends with the last of them. A gap is everything else. The parser only measures a gap, up to where records agree
//! with the layout again; [`recovery`] reads it when the rest of the text is known.

use chumsky::error::Cheap;
use chumsky::extra::{self, SimpleState};
use chumsky::input::InputRef;
use chumsky::prelude::*;
use rayon::prelude::*;

use super::ast::{Document, Item, Record};
use super::lexed::{Lexed, Sig};
use super::lexer;
use super::recovery::respell::has_pair;
use super::recovery::{self, Recovered, Surroundings};
use super::signature::{self, Columns, Reading};
use super::table::{Effect, RecordKind, RecordType};
use crate::diagnostics::{self, Code, Diagnostic, Value};

/// Parses a scene text. It never fails: what cannot be read is in the findings, sorted by place,
/// and every character of the text is still in the document.
pub fn parse(text: &str) -> (Document, Vec<Diagnostic>) {
    let mut findings = Vec::new();
    let mut lexed = Lexed::new(text, &[]);
    if may_be_unclosed(&lexed, text) {
        let unclosed = recovery::comments::unclosed(text);
        if !unclosed.is_empty() && lexer::too_long(text, &unclosed).is_none() {
            lexed = Lexed::new(text, &unclosed);
        }
        recovery::report::comments(text, &lexed.tokens, &mut findings);
    }
    let mut glued = Vec::new();
    if lexed.has_bad || has_pair(text, &lexed) {
        let tokens = std::mem::take(&mut lexed.tokens);
        let (tokens, spans) = recovery::respell::respell(text, tokens);
        lexed = Lexed::of(text, tokens);
        glued = spans;
        recovery::respell::report(text, &lexed.tokens, &glued, &mut findings);
    }
    let columns = Columns {
        text,
        lexed: &lexed,
    };
    let mut plan = Plan::of(columns);
    if !plan.gaps.is_empty() {
        plan.fill(&mut findings);
    }
    if !glued.is_empty() {
        recovery::respell::broken(&mut plan.items, &lexed.tokens, &glued);
    }
    findings.append(&mut plan.notes);
    findings.extend(plan.items.iter().filter_map(|item| match item {
        Item::Record(r)
            if r.params as usize > r.ty().params.len() && !r.ty().optional.is_empty() =>
        {
            let start = r.value as usize - 2;
            let reading = signature::read(&columns, start, columns.len())?;
            two_ways(&columns, start, &reading)
        }
        _ => None,
    }));
    diagnostics::sort(&mut findings);
    let (items, searched) = (plan.items, plan.searched);
    let mut document = Document::new(lexed, items, searched);
    document.doubt(&findings);
    (document, findings)
}

/// The document of a text that needs no recovery; `None` for any other text.
pub fn parse_plain(text: &str) -> Option<Document> {
    let lexed = Lexed::new(text, &[]);
    if lexed.has_bad || has_pair(text, &lexed) || may_be_unclosed(&lexed, text) {
        return None;
    }
    let columns = Columns {
        text,
        lexed: &lexed,
    };
    let Plan { items, gaps, .. } = Plan::of(columns);
    gaps.is_empty().then(|| Document::new(lexed, items, 0))
}

/// Whether a comment may have lost its `#`, or a `#` may belong to a colour such as `#ff8000`.
fn may_be_unclosed(lexed: &Lexed, text: &str) -> bool {
    let is_odd = || lexed.has_word || recovery::comments::has_colour(text);
    lexed.has_unclosed || lexed.has_long_comment && is_odd()
}

/// The records that were read, and the stretches that could not be.
struct Plan<'s> {
    columns: Columns<'s>,
    items: Vec<Item>,
    gaps: Vec<Gap>,
    notes: Vec<Diagnostic>,
    /// The IDs that are defined, in the order of the file.
    defined: Vec<u32>,
    /// The significant token up to which the layout agrees with the records on the line.
    run_to: usize,
    /// The significant token that begins the optional group which may be a broken record.
    doubted: Option<usize>,
    /// How many more tokens may be looked at in search of the ends of gaps.
    budget: usize,
    /// The number of tokens that become [`Document::searched`].
    searched: usize,
}

/// Significant tokens `from..to`, which recovery reads. Their items come before item `item`.
#[derive(Debug, Clone, Copy)]
struct Gap {
    from: usize,
    to: usize,
    item: usize,
}

type Extra<'s> = extra::Full<Cheap, SimpleState<Plan<'s>>, ()>;
type Input<'s, 'p> = InputRef<'s, 'p, &'s [Sig], Extra<'s>>;

/// The grammar. It puts the items that it reads into the state, the [`Plan`].
fn scene<'s>() -> impl Parser<'s, &'s [Sig], (), Extra<'s>> {
    let part = |read: fn(&mut Plan<'s>, usize) -> Option<usize>| {
        custom(move |input: &mut Input<'s, '_>| {
            let before = input.cursor();
            let start = *before.inner();
            let Some(end) = read(input.state(), start) else {
                return Err(Cheap::new(input.span_since(&before)));
            };
            for _ in start..end {
                input.skip();
            }
            Ok(())
        })
    };
    choice((part(Plan::record), part(Plan::void), part(Plan::gap)))
        .repeated()
        .then_ignore(end())
}

/// How many items in a row must agree with the layout to end a gap.
const AGREEING: usize = 3;
/// How many items before a gap, and behind it, are read once more with it.
const CONTEXT: usize = 2;
/// A text has no layout if more records than this are read by arity and none agrees with the layout.
const WITHOUT_LAYOUT: usize = 12;
/// How often each token may be looked at in search of the ends of gaps, on average.
const LOOKS: usize = 16;

impl<'s> Plan<'s> {
    fn of(columns: Columns<'s>) -> Plan<'s> {
        let plan = Plan {
            columns,
            // Hardly any record has fewer than three tokens.
            items: Vec::with_capacity(columns.len() / 3),
            gaps: Vec::new(),
            notes: Vec::new(),
            defined: Vec::new(),
            run_to: 0,
            doubted: None,
            budget: LOOKS * columns.len() + 1000,
            searched: 0,
        };
        let mut state = SimpleState::from(plan);
        let sigs = columns.lexed.sigs.as_slice();
        let done = scene().parse_with_state(sigs, &mut state);
        debug_assert!(!done.has_errors(), "a gap takes anything");
        let mut plan = state.0;
        if plan.lost_an_id() {
            plan.items.clear();
            plan.notes.clear();
            plan.gaps = vec![Gap {
                from: 0,
                to: columns.len(),
                item: 0,
            }];
        } else {
            plan.doubt_group();
        }
        plan
    }

    /// Makes a record a gap if its optional group is likelier a broken record and the text has no other gap.
    fn doubt_group(&mut self) {
        if !self.gaps.is_empty() {
            return;
        }
        let Some((item, group)) = recovery::doubtful_group(&self.columns, &self.items) else {
            return;
        };
        let gap = Gap {
            from: group.end - significant(&self.items[item]),
            to: group.end,
            item,
        };
        self.items.remove(item);
        self.gaps.push(gap);
        self.doubted = Some(group.start);
    }

    /// Reads a VOID, a `0` where a record may begin. Returns the token behind it.
    fn void(&mut self, start: usize) -> Option<usize> {
        let c = &self.columns;
        let there = c.int(start)? == 0 && (c.starts_line(start) || start < self.run_to);
        there.then(|| {
            let token = c.lexed.sigs[start].token();
            self.items.push(Item::Void { token });
            start + 1
        })
    }

    /// Reads a record with which the layout agrees. Returns the token behind it.
    fn record(&mut self, start: usize) -> Option<usize> {
        let c = self.columns;
        let reading = signature::read(&c, start, c.len())?;
        if start >= self.run_to {
            if !c.starts_line(start) && !self.follows_void(start) {
                return None;
            }
            self.run_to = self.agrees(start, &reading)?;
        }
        if defines(reading.ty) {
            self.defined.push(c.int(start)? as u32);
        }
        self.items.push(Item::Record(whole(&c, start, &reading)));
        Some(reading.end)
    }

    /// Whether a token follows a `0` and its comment, which may stand before a record on its line.
    fn follows_void(&self, start: usize) -> bool {
        let c = &self.columns;
        start > 0
            && c.int(start - 1) == Some(0)
            && c.before_comment(start - 1)
            && matches!(self.items.last(), Some(Item::Void { .. }))
    }

    /// The end of the records on the last line of a record, which begins with a line, if the layout agrees with it.
    fn agrees(&self, start: usize, reading: &Reading) -> Option<usize> {
        let c = &self.columns;
        let first_break = (start + 1..reading.end).find(|&i| c.starts_line(i));
        if let Some(second) = first_break {
            let whole = c.ends_line(reading.end) && !self.takes_lines(start, second, reading.end);
            return whole.then_some(reading.end);
        }
        let mut end = reading.end;
        while !c.ends_line(end) {
            // More records follow on the line, or a `0` with a comment.
            if c.int(end) == Some(0) {
                if !c.before_comment(end) {
                    return None;
                }
                end += 1;
                continue;
            }
            let next = signature::read(c, end, c.len())?;
            let crosses = (end + 1..next.end).any(|i| c.starts_line(i));
            if crosses || next.end == end + 2 || signature::is_odd(c, end, &next) {
                return None;
            }
            end = next.end;
        }
        Some(end)
    }

    /// Whether a line of the record at tokens `head..end`, from its second line on, looks like a record of its own.
    fn takes_lines(&self, head: usize, second_line: usize, end: usize) -> bool {
        let c = &self.columns;
        let (mut line, mut length_before) = (second_line, 0);
        loop {
            let next = (line + 1..end).find(|&i| c.starts_line(i)).unwrap_or(end);
            let last = next == end;
            let looks = match c.int(line) {
                _ if signature::begins_again(c, head, line) => true,
                Some(0) => last && c.before_comment(line),
                Some(1..) => signature::read(c, line, c.len()).is_some_and(|r| match last {
                    true => c.ends_line(r.end),
                    false => r.end == next && next - line != length_before && r.ty.code < 0,
                }),
                _ => false,
            };
            if looks || last {
                return looks;
            }
            length_before = next - line;
            line = next;
        }
    }

    /// Plans a gap from `start` on, where neither a VOID nor a record can be read. The items just before join the gap.
    fn gap(&mut self, start: usize) -> Option<usize> {
        if start == self.columns.len() {
            return None;
        }
        let mut from = start;
        let least = self.gaps.last().map_or(0, |g| g.to);
        // The gap goes back to the beginning of a line, some items before `start`.
        let mut context = CONTEXT;
        while from > least && (context > 0 || !self.columns.starts_line(from)) {
            let Some(item) = self.items.pop() else { break };
            from -= significant(&item);
            if matches!(item, Item::Record(r) if defines(r.ty())) {
                self.defined.pop();
            }
            context = context.saturating_sub(usize::from(self.columns.starts_line(from)));
        }
        let (to, by_arity) = self.end_of_gap(start);
        let all = from == 0 && to == self.columns.len() && by_arity;
        if all && self.has_no_layout() && self.take_all() {
            self.run_to = to;
            return Some(to);
        }
        match self.gaps.last_mut() {
            // No item lies between this gap and the last one.
            Some(last) if last.to == from => last.to = to,
            _ => self.gaps.push(Gap {
                from,
                to,
                item: self.items.len(),
            }),
        }
        self.run_to = to;
        Some(to)
    }

    /// The end of a gap: where the reading by arity agrees with the layout again, or else where lines are records
    /// again. The flag says whether the reading by arity got there.
    fn end_of_gap(&mut self, start: usize) -> (usize, bool) {
        let c = self.columns;
        let n = c.len();
        let (mut at, mut records) = (start, 0);
        loop {
            if at > start
                && c.starts_line(at)
                && let Some(end) = self.agreeing(at)
            {
                return (end, true);
            }
            if at >= n || self.budget == 0 {
                return (n, at >= n);
            }
            self.budget = self.budget.saturating_sub(1);
            if c.int(at) == Some(0) {
                at += 1;
            } else if let Some(r) = signature::read(&c, at, n) {
                at = r.end;
                records += 1;
            } else {
                break;
            }
        }
        if records > WITHOUT_LAYOUT {
            return (n, false);
        }
        let lines = (start + 1..n).filter(|&i| c.starts_line(i));
        for line in lines {
            if let Some(end) = self.agreeing(line) {
                return (end, false);
            }
            if self.budget == 0 {
                break;
            }
        }
        (n, false)
    }

    /// Whether a line is a record but for a number or two.
    fn is_nearly_a_record(&self, line: usize, end: usize) -> bool {
        const MAX_NUMBERS_OFF: u64 = 2;
        let c = &self.columns;
        let id = c.int(line).is_some_and(|id| id > 0);
        let code = c.int(line + 1).filter(|_| end > line + 2);
        let ty = code
            .and_then(|code| RecordType::by_code(code.into()))
            .filter(|_| id);
        ty.is_some_and(|ty| {
            let count = c.int(line + 2).filter(|_| ty.is_counted()).unwrap_or(0);
            let arity = ty.arity(u64::try_from(count).unwrap_or(0));
            let got = (end - line - 2) as u64;
            let off = got
                .abs_diff(arity)
                .min(got.abs_diff(arity + ty.optional.len() as u64));
            off <= MAX_NUMBERS_OFF && 2 * off <= got
        })
    }

    /// Whether hardly any line of a text is a record.
    fn has_no_layout(&self) -> bool {
        let c = &self.columns;
        let (mut lines, mut own) = (0, 0);
        let mut line = 0;
        while line < c.len() {
            let next = (line + 1..c.len())
                .find(|&i| c.starts_line(i))
                .unwrap_or(c.len());
            lines += 1;
            own += usize::from(self.is_nearly_a_record(line, next));
            line = next;
        }
        3 * own < lines
    }

    /// Reads the whole text by arity. Keeps the items and returns `true` if nothing is wrong with them.
    fn take_all(&mut self) -> bool {
        let c = self.columns;
        self.items.clear();
        self.defined.clear();
        let (mut at, mut odd) = (0, false);
        loop {
            if c.int(at) == Some(0) {
                let token = c.lexed.sigs[at].token();
                self.items.push(Item::Void { token });
                at += 1;
                continue;
            }
            let Some(reading) = signature::read(&c, at, c.len()) else {
                break;
            };
            if defines(reading.ty) {
                self.defined.extend(c.int(at).map(|id| id as u32));
            }
            self.items.push(Item::Record(whole(&c, at, &reading)));
            odd |= signature::is_odd(&c, at, &reading);
            let last_line = (at + 1..reading.end).rev().find(|&i| c.starts_line(i));
            if last_line.is_some_and(|line| self.takes_lines(at, line, reading.end)) {
                recovery::line_break(c, (at, reading.end), &mut self.notes);
            }
            at = reading.end;
        }
        let dangling = || !Surroundings::new(&c, &self.items, 0, 0).dangling.is_empty();
        let sound = !odd && self.defined_twice().is_empty() && !dangling();
        if !sound {
            self.items.clear();
            self.defined.clear();
            self.notes.clear();
        }
        sound
    }

    /// If [`AGREEING`] items from a line on agree with the layout: the end of the first [`CONTEXT`] of them.
    fn agreeing(&mut self, line: usize) -> Option<usize> {
        let c = self.columns;
        let mut at = line;
        let mut context = line;
        for k in 0..AGREEING {
            if at == c.len() {
                break;
            }
            self.budget = self.budget.saturating_sub(8);
            let end = match c.int(at) {
                Some(0) => c.ends_line(at + 1).then_some(at + 1)?,
                _ => {
                    let r = signature::read(&c, at, c.len())?;
                    self.budget = self.budget.saturating_sub(r.end - at);
                    if signature::is_odd(&c, at, &r) || r.end == at + 2 {
                        return None;
                    }
                    self.agrees(at, &r)?
                }
            };
            at = end;
            if k < CONTEXT {
                context = at;
            }
        }
        Some(context)
    }

    /// The IDs that are defined twice, in order.
    fn defined_twice(&self) -> Vec<u32> {
        // Most files have their IDs in order.
        if self.defined.is_sorted_by(|a, b| a < b) {
            return Vec::new();
        }
        let mut sorted = self.defined.clone();
        sorted.sort_unstable();
        let twice = sorted.windows(2).filter(|two| two[0] == two[1]);
        let mut twice: Vec<u32> = twice.map(|two| two[0]).collect();
        twice.dedup();
        twice
    }

    /// Whether an ID is defined twice, and one of its records may be another one that has lost its ID.
    fn lost_an_id(&self) -> bool {
        let twice = self.defined_twice();
        if twice.is_empty() {
            return false;
        }
        self.items.iter().any(|item| match item {
            Item::Record(r) => {
                let start = r.value as usize - 2;
                defines(r.ty())
                    && twice.binary_search(&r.id).is_ok()
                    && recovery::has_lost_id(self.columns, start, start + significant(item))
            }
            _ => false,
        })
    }

    /// Has [`recovery`] read the gaps, and puts their items in place.
    fn fill(&mut self, findings: &mut Vec<Diagnostic>) {
        let c = self.columns;
        let lines = |from: usize, to: usize| {
            let sigs = &c.lexed.sigs[from..to];
            sigs.iter().filter(|s| s.starts_line()).count()
        };
        let in_gaps: usize = self.gaps.iter().map(|g| lines(g.from, g.to)).sum();
        let outside = lines(0, c.len()) - in_gaps;
        let mut around = Surroundings::new(&c, &self.items, outside, self.gaps.len());
        let parts: Vec<(usize, usize)> = (self.gaps.iter())
            .flat_map(|gap| self.parts(gap.from, gap.to))
            .collect();
        around.others = parts.len() > 1;
        around.doubted = self.doubted;
        let read: Vec<Recovered> = (parts.par_iter().with_min_len(PARTS))
            .map(|&part| recovery::recover(c, part, &around))
            .collect();
        self.searched = read.iter().map(|r| r.searched).sum();
        let mut read = parts.into_iter().zip(read).peekable();
        let mut items = Vec::with_capacity(self.items.len() + self.gaps.len());
        let mut done = 0;
        for gap in &self.gaps {
            items.extend_from_slice(&self.items[done..gap.item]);
            done = gap.item;
            while let Some((_, mut recovered)) = read.next_if(|(part, _)| part.1 <= gap.to) {
                items.append(&mut recovered.items);
                findings.append(&mut recovered.findings);
            }
        }
        items.extend_from_slice(&self.items[done..]);
        self.items = items;
    }

    /// Cuts a gap into parts that are not too long, between lines that are records each, but for a number or two.
    fn parts(&self, from: usize, to: usize) -> Vec<(usize, usize)> {
        let c = &self.columns;
        let mut parts = Vec::new();
        let mut start = from;
        while to - start > LONGEST_PART {
            let lines = (start + LONGEST_PART / 2..to).filter(|&i| c.starts_line(i));
            let lines: Vec<usize> = lines.take(LINES_TRIED).collect();
            let alone = |i: usize| self.is_nearly_a_record(lines[i], lines[i + 1]);
            let cut = (2..lines.len()).find(|&i| alone(i - 2) && alone(i - 1));
            let Some(cut) = cut else { break };
            parts.push((start, lines[cut - 1]));
            start = lines[cut - 1];
        }
        parts.push((start, to));
        parts
    }
}

/// How many parts of gaps one thread reads at least.
const PARTS: usize = 16;
/// Gaps with more significant tokens are cut, if there is a place.
const LONGEST_PART: usize = 30_000;
const LINES_TRIED: usize = 200;

/// N605: an optional group on the record's line that could be whole records as well.
fn two_ways(c: &Columns, start: usize, reading: &Reading) -> Option<Diagnostic> {
    let base = start + 2 + reading.ty.params.len();
    if !reading.two_ways || reading.end == base {
        return None;
    }
    let mut at = base;
    while at < reading.end {
        at = match c.int(at)? {
            0 => at + 1,
            _ => signature::read(c, at, reading.end)?.end,
        };
    }
    let span = c.token(base).span().to(c.token(reading.end - 1).span());
    Some(Diagnostic::new(Code::N605, span).with("type", Value::Term(reading.ty.title)))
}

/// Whether records of a type define something that has an ID of its own.
fn defines(ty: &RecordType) -> bool {
    matches!(ty.effect, Effect::Defines(_)) && ty.kind != RecordKind::Render
}

/// The number of significant tokens of an item that was read.
fn significant(item: &Item) -> usize {
    match item {
        Item::Record(r) => 2 + r.params as usize,
        Item::Void { .. } | Item::Broken(_) => 1,
    }
}

/// The tree's record for a reading.
fn whole(c: &Columns, start: usize, reading: &Reading) -> Record {
    Record {
        id: c.int(start).unwrap_or(0) as u32,
        kind: reading.ty.kind,
        first: c.lexed.sigs[start].token(),
        last: c.lexed.sigs[reading.end - 1].token(),
        params: (reading.end - start - 2) as u32,
        value: start as u32 + 2,
    }
}
