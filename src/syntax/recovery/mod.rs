//! Recovery of a stretch of text that cannot be read by arity alone, or whose reading looks odd.
//!
//! ```text
//!                  stretch        significant tokens of whole lines, and the record readable from each
//!                     │
//!   surroundings ─► witness       what its lines say: which are records of their own, perhaps but for a slip
//!                     │                                                   ◄─ order: which IDs are in order there
//!                     │
//!            is it laid out in lines?
//!              yes │        │ no
//!                  │        └──► free      the reading by arity if nothing speaks against it
//!                  │              │        (`partial_parses::is_sound`), else the cheapest way to cut it into pieces
//!                  │              │                                              ◄─ partial_parses: which IDs are defined by then
//!               layout            │        the cheapest way, line by line        ◄─ faults: what a piece costs
//!                  │              │                                              ◄─ sums: where a piece may begin
//!               damage            │        against the reading by arity, if there is one without errors
//!                  └──────┬───────┘
//!                      report              the pieces that are no records, in words
//! ```
//!
//! A missing, lost or surplus number is decided on in `judge_params` in [`faults`], which says what is wrong with a
//! piece and what that costs (`Diagnosis::WrongArity`), and in [`layout`], which chooses the pieces; where line breaks
//! say nothing, in `wrong_arity` in `free/mistakes.rs`. Whether a short record goes on in the next line is decided
//! earlier, by `Plan::agrees` in the parser, then by `sums::may_begin` and the prices of [`layout`]. A line that may be
//! a broken record, or else the optional group of the record before it, is found in [`group`] and decided on in
//! [`layout`]. The message is made in [`report`].
//!
//! Two questions about tokens come before there are stretches: which `#` closes which ([`comments`]), and which words
//! are several numbers ([`respell`]).

pub(super) mod comments;
mod damage;
mod diagnosis;
mod faults;
mod free;
mod group;
mod heads;
mod id_context;
mod integers;
mod layout;
mod order;
mod partial_parses;
mod prices;
pub(super) mod report;
pub(super) mod respell;
mod rows;
mod slips;
mod stretch;
mod sums;
mod surroundings;
mod witness;

use super::ast::Item;
use super::signature::Columns;
use crate::diagnostics::Diagnostic;
use diagnosis::{Diagnosis, RecordCandidate};
pub(super) use group::doubtful_group;
pub use slips::LEAST_HEAD;
use stretch::Stretch;
pub(super) use surroundings::Surroundings;
use witness::Witnesses;

/// The result of recovering a stretch of text.
pub(super) struct Recovered {
    pub items: Vec<Item>,
    /// The findings about what cannot be read.
    pub findings: Vec<Diagnostic>,
    /// How many tokens were cut into pieces by trying all ways; 0 for a stretch that is laid out in lines.
    pub searched: usize,
}

/// Reads significant tokens `from..to`, which are whole lines.
pub(super) fn recover(
    columns: Columns,
    (from, to): (usize, usize),
    around: &Surroundings,
) -> Recovered {
    let mut stretch = Stretch::new(columns, from, to);
    let witnesses = Witnesses::new(&stretch, around);
    stretch.is_free = !witnesses.in_lines;
    let pieces = pieces(&stretch, &witnesses, around);
    let mut findings = Vec::new();
    report::pieces(&stretch, &witnesses, &pieces, &mut findings);
    Recovered {
        items: pieces.iter().map(|p| p.item(&stretch)).collect(),
        findings,
        searched: if stretch.is_free { to - from } else { 0 },
    }
}

/// Warns of a record at significant tokens `from..to` that ends within a line which would be a record of its own.
pub(super) fn line_break(columns: Columns, (from, to): (usize, usize), out: &mut Vec<Diagnostic>) {
    let mut line_end = to;
    while !columns.ends_line(line_end) {
        line_end += 1;
    }
    let stretch = Stretch::new(columns, from, line_end);
    let around = Surroundings::default();
    let witnesses = Witnesses::new(&stretch, &around);
    if let Some(&reading) = stretch.read(0) {
        let piece = RecordCandidate {
            start: 0,
            end: reading.end,
            verdict: Diagnosis::Whole(reading),
        };
        report::pieces(&stretch, &witnesses, &[piece], out);
    }
}

/// Whether the record at significant tokens `from..to` may have lost its ID: the same tokens, taken for type and
/// parameters, would be a whole record with an ID in front.
pub(super) fn has_lost_id(columns: Columns, from: usize, to: usize) -> bool {
    let stretch = Stretch::new(columns, from, to);
    faults::has_lost_id(&stretch, 0, to - from)
}

fn pieces(stretch: &Stretch, witnesses: &Witnesses, around: &Surroundings) -> Vec<RecordCandidate> {
    let strict = by_arity(stretch);
    if !witnesses.in_lines {
        return match strict {
            Some(strict) if partial_parses::is_sound(stretch, around, &strict) => strict,
            _ => free::cut(stretch, around),
        };
    }
    let mut pieces = layout::cut(stretch, witnesses, strict.as_deref(), false);
    let takes_over = |p: &RecordCandidate| {
        matches!(p.verdict, Diagnosis::Whole(_)) && witnesses.takes_over(stretch, p.start, p.end)
    };
    let mut damage = damage::damage(stretch, around, &pieces);
    if damage > 0 && pieces.iter().any(takes_over) {
        // A record took numbers from a line that looks like a record of its own, and something else is wrong now. So
        // the line is believed if that costs no more errors.
        let doubting = layout::cut(stretch, witnesses, strict.as_deref(), true);
        let other = damage::damage(stretch, around, &doubting);
        if other <= damage {
            (pieces, damage) = (doubting, other);
        }
    }
    if damage > 0
        && !stretch.has_unclosed_comment(0, stretch.len())
        && let Some(strict) = strict
    {
        // There is a reading by arity without faults. If its meaning has no errors either, it is preferred to a reading
        // with two errors or more, and to one with a single error if it is not odd. Nobody means a reading that cuts up
        // the line of the render record.
        let sound = damage::damage(stretch, around, &strict) == 0
            && partial_parses::is_sound(stretch, around, &strict);
        let may_be_meant = match damage {
            1 => !witness::is_odd(stretch, witnesses, &strict),
            _ => !witness::loses_render(stretch, witnesses, &strict),
        };
        if sound && may_be_meant {
            pieces = strict;
        }
    }
    pieces
}

/// Reads the stretch by arity. `None` if some token cannot be read as part of a record.
fn by_arity(stretch: &Stretch) -> Option<Vec<RecordCandidate>> {
    let mut pieces = Vec::new();
    let mut start = 0;
    while start < stretch.len() {
        let (end, verdict) = match stretch.sigs[start].int {
            Some(0) => (start + 1, Diagnosis::Void),
            _ => stretch.read(start).map(|r| (r.end, Diagnosis::Whole(*r)))?,
        };
        pieces.push(RecordCandidate {
            start,
            end,
            verdict,
        });
        start = end;
    }
    Some(pieces)
}
