//! Evidence of the text's layout, from its lines.

use rustc_hash::{FxHashMap, FxHashSet};

use super::super::signature::Reading;
use super::super::table::{Effect, RecordKind, RecordType};
use super::damage;
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::faults;
use super::id_context::IdContext;
use super::order::Order;
use super::slips::{self, Slip};
use super::stretch::{MIN_LONG_PARAMS, Stretch};
use super::surroundings::Surroundings;

/// The evidence of a text's lines about its layout.
pub(crate) struct Witnesses<'a> {
    /// For each line the end of the record that it begins, one past the record's last token, if the record ends with a
    /// line or is a VOID with a comment; 0 where the line is no witness.
    pub ends: Vec<u32>,
    /// Whether each line would be a record of its own, but for a slip. Lines of a longer record are `false`.
    pub slips: Vec<bool>,
    /// Which IDs would be in order at the head of each line.
    pub order: Order,
    /// Whether the text is laid out with records beginning and ending with lines.
    pub in_lines: bool,
    /// For each ID the evidence of the witness lines that define it.
    heads: FxHashMap<i32, Head>,
    /// The IDs that witness lines use or change.
    used: FxHashSet<i32>,
    /// The IDs that are used and defined nowhere, in order.
    missing: Vec<i32>,
    around: &'a Surroundings,
    /// Whether a line begins with a type that can be no ID, and other lines are no records either: they may have lost
    /// theirs as well.
    ids_lost: bool,
    /// How many lines of the stretch are records but for a slip.
    slipped: usize,
    /// Whether comments behind a record on its line are introduced by `0` here.
    pub voids_behind_records: bool,
}

/// The lines that define one ID.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Head {
    /// The first of these lines; `None` if it stands before the stretch.
    pub first_line: Option<usize>,
    /// How many of these lines can only be definitions, so that all but one are too many. `may_be_lost` says how many
    /// of them may have lost their IDs: they would also be whole records with an ID in front.
    pub definitions: u32,
    pub may_be_lost: u32,
}

impl Head {
    fn at(first_line: usize) -> Head {
        Head {
            first_line: Some(first_line),
            definitions: 0,
            may_be_lost: 0,
        }
    }
}

impl<'a> Witnesses<'a> {
    pub(crate) fn new(stretch: &Stretch, around: &'a Surroundings) -> Witnesses<'a> {
        let lines = stretch.line_count();
        let mut ends = vec![0u32; lines];
        let mut heads = FxHashMap::default();
        for (line, end) in ends.iter_mut().enumerate() {
            let start = stretch.line_start(line);
            if stretch.sigs[start].int == Some(0) {
                let alone = stretch.line_end(line) == start + 1;
                if alone && stretch.sigs[start].before_comment {
                    *end = start as u32 + 1;
                }
            } else if let Some(r) = stretch.read(start)
                && testifies(stretch, start, r)
            {
                *end = r.end as u32;
            }
        }
        let mut order = Order::new(stretch, |line| ends[line] > 0);
        // A walk from record to record measures how much of the text is laid out in lines. One mistake disturbs one run
        // of lines, however long the record is that it spoils.
        let (mut line, mut covered, mut runs, mut disturbed) = (0, 0, 0, false);
        let mut steps = 0;
        let mut used = FxHashSet::default();
        let mut slips = vec![false; lines];
        let mut ids_lost = false;
        let (mut slipped, mut table_to, mut in_tables, mut perhaps) = (0, 0, 0, Vec::new());
        let mut prose = 0;
        while line < lines {
            let next = match ends[line] {
                0 if run_to_line_end(stretch, line) => line + 1,
                // A line of prose was meant as a comment, and is no evidence.
                0 if stretch.is_prose(line) => {
                    prose += 1;
                    line += 1;
                    continue;
                }
                0 => {
                    // Where the next line is a record, no rows follow.
                    let alone = ends.get(line + 1).is_some_and(|&end| end > 0)
                        || line + 1 < lines && slips::looks_like_a_head(stretch, line + 1);
                    if line >= table_to && !alone {
                        table_to = slips::rows_expected(stretch, line);
                    }
                    match slips::slip(stretch, line, line < table_to, &order) {
                        Slip::Yes => {
                            let head = &stretch.sigs[stretch.line_start(line)];
                            ids_lost |= head.int.is_some_and(|code| code < 0);
                            slips[line] = true;
                            slipped += 1;
                            let (start, end) = (stretch.line_start(line), stretch.line_end(line));
                            used.extend(damage::of_record(stretch, start, end));
                        }
                        Slip::Maybe => perhaps.push(line),
                        Slip::No => {}
                    }
                    in_tables += usize::from(line < table_to && !slips[line]);
                    runs += usize::from(!disturbed);
                    disturbed = true;
                    line += 1;
                    continue;
                }
                end => {
                    let start = stretch.line_start(line);
                    let id = stretch.sigs[start].int.unwrap_or(0);
                    match stretch.record_type(start + 1).map(|t| t.effect) {
                        Some(Effect::Defines(_)) => {
                            let lost = faults::has_lost_id(stretch, start, end as usize);
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
                    used.extend(damage::of_record(stretch, start, end as usize));
                    stretch.line(end as usize - 1) + 1
                }
            };
            disturbed = false;
            table_to = 0;
            steps += 1;
            covered += next - line;
            line = next;
        }
        for line in perhaps {
            let id = stretch.sigs[stretch.line_start(line)].int.unwrap_or(0);
            let elsewhere = u32::try_from(id).unwrap_or(0);
            slips[line] = (used.contains(&id) || around.is_used(elsewhere))
                && !(heads.contains_key(&id) || around.is_defined(elsewhere));
            slipped += usize::from(slips[line]);
        }
        // The rest of the text is laid out in lines, but for the other stretches.
        let lines = lines - prose + around.lines;
        covered += around.lines;
        steps += around.records;
        runs += around.stretches.saturating_sub(1);
        let told = covered + slipped + in_tables;
        let mostly = 20 * covered >= 13 * lines
            || (runs <= 1 && steps >= 4 || lines < 12) && 3 * told + 2 >= 2 * lines;
        let few = lines < 12 && 4 * told >= 3 * lines;
        // The same mistake on every line leaves no line as a witness that it was laid out in lines.
        let slips_in_lines = slipped > 0 && 20 * (covered + slipped) >= 17 * lines;
        let in_lines = steps > 0 && (steps + 2 >= 3 * runs && mostly || few) || slips_in_lines;
        if !in_lines {
            // What looks like a record at the head of a line is one by chance.
            heads.clear();
            used.clear();
            slips.fill(false);
            order = Order::none(stretch);
        }
        let mut witnesses = Witnesses {
            in_lines,
            ends,
            slips,
            order,
            heads,
            used,
            missing: Vec::new(),
            ids_lost: ids_lost && slipped > 1,
            slipped,
            voids_behind_records: around.voids_behind_records
                || voids_behind_records(stretch, around),
            around,
        };
        witnesses.missing = witnesses.find_missing();
        witnesses
    }

    /// Whether the optional group that begins at a token may be a broken record.
    pub(crate) fn is_doubted(&self, stretch: &Stretch, group: usize) -> bool {
        self.around.doubted == Some(stretch.in_text(group))
    }

    fn find_missing(&self) -> Vec<i32> {
        let dangling = self.around.dangling.iter().map(|&id| id as i32);
        let mut missing: Vec<i32> = (dangling.chain(self.used.iter().copied()))
            .filter(|&id| !self.is_defined(id))
            .collect();
        missing.sort_unstable();
        missing
    }

    fn elsewhere(&self, id: i32) -> Option<u32> {
        u32::try_from(id).ok().filter(|_| self.in_lines)
    }

    /// The evidence of the lines that define an ID.
    pub(crate) fn head(&self, stretch: &Stretch, id: i32) -> Option<Head> {
        let here = self.heads.get(&id).copied();
        let elsewhere = u32::try_from(id).ok().filter(|_| self.in_lines);
        let Some((at, ty)) = elsewhere.and_then(|id| stretch.defined_elsewhere(self.around, id))
        else {
            return here;
        };
        let mut head = here.unwrap_or(Head {
            first_line: None,
            definitions: 0,
            may_be_lost: 0,
        });
        head.definitions += u32::from(matches!(ty.effect, Effect::Defines(_)));
        if stretch.is_behind(at) {
            head.first_line = None;
        }
        Some(head)
    }

    /// Whether a line would be a complete record by itself.
    pub(crate) fn is_complete_line(&self, stretch: &Stretch, line: usize) -> bool {
        self.ends[line] as usize == stretch.line_end(line)
    }

    /// Whether a line is a complete record, of a type whose number is hardly a parameter.
    pub(crate) fn is_surely_a_record(&self, stretch: &Stretch, line: usize) -> bool {
        self.is_complete_line(stretch, line) && slips::looks_like_a_head(stretch, line)
    }

    pub(crate) fn is_void_line(&self, stretch: &Stretch, line: usize) -> bool {
        self.ends[line] > 0 && stretch.sigs[stretch.line_start(line)].int == Some(0)
    }

    /// Whether the record at tokens `start..end` takes its last parameters from the head of a line
    /// that says it is a record of its own. A line in a table of equally long lines says nothing.
    pub(crate) fn takes_over(&self, stretch: &Stretch, start: usize, end: usize) -> bool {
        let (first, last) = (stretch.line(start), stretch.line(end - 1));
        if first == last || self.ends[last] == 0 {
            return first != last && self.slips[last];
        }
        let length = |l: usize| stretch.line_end(l) - stretch.line_start(l);
        !(last > first + 1 && length(last) == length(last - 1))
            || [last - 1, last]
                .iter()
                .all(|&l| self.is_change_of(stretch, stretch.sigs[start].int, l))
    }

    /// Whether a line is a complete record that changes the object with an ID, which a row of numbers hardly is by chance.
    fn is_change_of(&self, stretch: &Stretch, id: Option<i32>, line: usize) -> bool {
        let [own, code] = stretch.head(line);
        let ty = code.and_then(|code| RecordType::by_code(code.into()));
        own == id
            && self.is_complete_line(stretch, line)
            && ty.is_some_and(|ty| !matches!(ty.effect, Effect::Defines(_)))
    }
}

/// The IDs according to the lines. If a record begins with a number that is a missing ID, this number is the record's
/// ID.
impl IdContext for Witnesses<'_> {
    fn is_missing(&self, id: i32) -> bool {
        let used =
            self.used.contains(&id) || self.elsewhere(id).is_some_and(|id| self.around.is_used(id));
        !self.ids_lost && used && !self.is_defined(id)
    }

    fn is_defined(&self, id: i32) -> bool {
        self.heads.contains_key(&id)
            || (u32::try_from(id)).is_ok_and(|id| self.around.is_defined(id))
    }

    fn is_defined_before(&self, stretch: &Stretch, line: usize, id: i32) -> bool {
        let here = self.heads.get(&id).and_then(|head| head.first_line);
        let elsewhere = u32::try_from(id).ok();
        let elsewhere = elsewhere.and_then(|id| stretch.defined_elsewhere(self.around, id));
        here.is_some_and(|first| first < line)
            || elsewhere.is_some_and(|(at, _)| stretch.is_behind(at))
    }

    fn is_in_order(&self, line: usize, id: i32) -> bool {
        self.order.has(line, id)
    }

    fn misses_another(&self, id: i32) -> bool {
        // Other lines may lack their IDs, too.
        let others = self.ids_lost || self.slipped > 1;
        others || self.missing.iter().any(|&other| other != id)
    }

    fn misses_next(&self, line: usize) -> bool {
        self.order.has_any(line, &self.missing)
    }
}

/// Whether a record that begins with a line says something about the layout: it ends with a line
/// too, and it is no row of a table by chance. Short records over several lines are rare, and so is
/// an ID 1 without the type 9999.
fn testifies(stretch: &Stretch, start: usize, r: &Reading) -> bool {
    let one_line = stretch.line(start) == stretch.line(r.end - 1);
    let long = r.ty.is_counted() || r.ty.params.len() >= MIN_LONG_PARAMS;
    let render = (stretch.sigs[start].int == Some(1)) == (r.ty.kind == RecordKind::Render);
    stretch.ends_line(r.end)
        && r.end - start > 2
        && (one_line || long)
        && render
        && stretch.values_allowed(start, r)
}

/// Whether people here write `2 9 1 0 # a sphere #`: several do, or nobody does without the `0`.
fn voids_behind_records(stretch: &Stretch, around: &Surroundings) -> bool {
    let (mut with, mut without) = (0, usize::from(around.records > 0));
    for line in 0..stretch.line_count() {
        let (start, end) = (stretch.line_start(line), stretch.line_end(line));
        let last = &stretch.sigs[end - 1];
        if end - start > 2 && last.before_comment {
            let read = |end: usize| stretch.read(start).is_some_and(|r| r.end == end);
            if last.int == Some(0) && read(end - 1) {
                with += 1;
            } else if read(end) {
                without += 1;
            }
        }
    }
    with > 1 || without == 0
}

/// Whether a line is a row of several records that ends with its last one.
fn run_to_line_end(stretch: &Stretch, line: usize) -> bool {
    let (mut i, end) = (stretch.line_start(line), stretch.line_end(line));
    while i < end {
        let sig = &stretch.sigs[i];
        if sig.int == Some(0) && sig.before_comment {
            i += 1;
        } else if let Some(r) = stretch.read(i).filter(|r| r.end <= end && r.end > i + 2) {
            i = r.end;
        } else {
            return false;
        }
    }
    true
}

/// Whether a reading gives the numbers of a render record's line to other records. The line is a render record by
/// itself, perhaps with a slip in its type.
pub(super) fn loses_render(
    stretch: &Stretch,
    witnesses: &Witnesses,
    pieces: &[RecordCandidate],
) -> bool {
    let is_render = |line: usize| {
        let ty = stretch.record_type(stretch.line_start(line) + 1);
        ty.is_some_and(|t| t.kind == RecordKind::Render)
            && witnesses.is_complete_line(stretch, line)
            || is_nearly_render(stretch, line)
    };
    let begins = |at: usize| pieces.binary_search_by_key(&at, |p| p.start).is_ok();
    (0..stretch.line_count()).any(|line| is_render(line) && !begins(stretch.line_start(line)))
}

/// Whether a line is a render record with a slip in its type, as `1 999 14 0`.
fn is_nearly_render(stretch: &Stretch, line: usize) -> bool {
    let (start, end) = (stretch.line_start(line), stretch.line_end(line));
    let ty = RecordType::of(RecordKind::Render);
    let least = 2 + ty.params.len();
    let fits = [least, least + ty.optional.len()].contains(&(end - start));
    let is_one = fits && stretch.sigs[start].int == Some(1);
    let written = || stretch.token(start + 1).text(stretch.text());
    is_one && strsim::osa_distance(written(), &ty.code.to_string()) == 1
}

/// Whether a reading without faults has something in it that people do not write in a text laid out in lines: a record
/// that begins inside of a line and ends on another one, a record that takes the line of an operation or a property, a
/// VOID without a comment behind a record, or the `0` of a heading taken for a number.
pub(super) fn is_odd(stretch: &Stretch, witnesses: &Witnesses, pieces: &[RecordCandidate]) -> bool {
    pieces.iter().any(|p| {
        let behind = !stretch.starts_line(p.start);
        let last = stretch.line(p.end - 1);
        let over_lines = stretch.line(p.start) != last;
        let is_record = || witnesses.is_surely_a_record(stretch, last);
        match p.verdict {
            Diagnosis::Void => behind,
            _ => {
                (behind && (over_lines || p.end == p.start + 2))
                    || over_lines
                        && (witnesses.is_void_line(stretch, last) || is_record())
                        && witnesses.takes_over(stretch, p.start, p.end)
            }
        }
    })
}
