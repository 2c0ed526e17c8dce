//! Lines that would be records of their own but for a slip, and tables whose rows are none. Where the
//! same mistake stands on many lines, no line is right, and these are the witnesses.

use super::super::table::{RecordKind, RecordType};
use super::faults::{Unknown, has_lost_id, judge, lost_sign};
use super::heads::{expected_end, is_counted};
use super::order::Order;
use super::stretch::Stretch;
use super::verdict::Verdict;

/// Whether a line would be a record of its own but for a slip: a number more or less, one that is
/// malformed, a word for the type, a lost ID or sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slip {
    Yes,
    /// If its ID is used elsewhere and no other line defines it.
    Maybe,
    No,
}

/// What a line looks like by itself; a line that may be a row of a table must have a type that no row has, or begin with
/// an ID that is in order.
pub fn slip(stretch: &Stretch, line: usize, in_table: bool, order: &Order) -> Slip {
    let (start, end) = (stretch.line_start(line), stretch.line_end(line));
    let in_order = order.head(stretch, line).is_some();
    let has_next_id = || {
        stretch.sigs[start]
            .int
            .is_some_and(|id| order.has(line, id))
    };
    let code = stretch.sigs[start + 1..end]
        .first()
        .and_then(|s| s.int)
        .unwrap_or(0);
    let (ty, slip) = match judge(stretch, start, end, &Unknown).0 {
        Verdict::Damaged { ty } | Verdict::Reals { ty } => (Some(ty), Slip::Yes),
        Verdict::LostId { ty } => {
            return if in_table && ty.code > LEAST_HEAD {
                Slip::No
            } else {
                Slip::Yes
            };
        }
        Verdict::Swapped => (None, Slip::Yes),
        Verdict::Surplus { ty, .. } => (Some(ty), Slip::Yes),
        Verdict::LostSign { meant, .. } => (Some(meant), Slip::Yes),
        Verdict::BadId { ty: Some(ty) } if stretch.sigs[start].kind.is_bad() => {
            (Some(ty), Slip::Yes)
        }
        Verdict::WrongArity { ty, got, expected }
            if got.abs_diff(expected) <= SLIP_MAX.min(1 + expected / 4) =>
        {
            let head = got > 0 || ty.code <= LEAST_HEAD || in_order;
            (Some(ty), if head { Slip::Yes } else { Slip::Maybe })
        }
        Verdict::BadPointCount { ty } if end > start + 4 => (Some(ty), Slip::Yes),
        Verdict::BadType
            if (stretch.sigs[start + 1].kind.is_bad() || has_next_id()) && end > start + 2 =>
        {
            (None, Slip::Yes)
        }
        Verdict::UnknownType => {
            let signed = lost_sign(stretch, start, end);
            let meant = RecordType::by_code(-i64::from(code)).filter(|_| signed);
            let odd = code.abs() >= NO_COORDINATE && end > start + 2;
            let sure = signed || odd || has_next_id();
            (meant, if sure { Slip::Yes } else { Slip::Maybe })
        }
        _ => (None, Slip::No),
    };
    match ty {
        Some(ty) if ty.kind == RecordKind::Undefined => Slip::No,
        Some(ty) if in_table && ty.code > LEAST_HEAD && !in_order => Slip::No,
        None if in_table => Slip::No,
        _ => slip,
    }
}

/// Integers in tables of numbers are seldom as large as this.
const NO_COORDINATE: i32 = 20;

/// No table of numbers has a row that begins with an integer and a type as low as this.
pub const LEAST_HEAD: i32 = -99;

/// How many numbers more or less are a slip of the pen.
const SLIP_MAX: usize = 2;

/// One past the last line of the table that the record at the head of a line claims to have; the
/// line itself where it claims none, or most of it stands on the line.
pub fn rows_expected(stretch: &Stretch, line: usize) -> usize {
    let (start, end) = (stretch.line_start(line), stretch.line_end(line));
    if stretch.sigs[start].int.is_none_or(|id| id <= 0) {
        return line;
    }
    match (expected_end(stretch, start), is_counted(stretch, start)) {
        (Some(e), _) if e > end + SLIP_MAX && 2 * (end - start) <= e - start + 4 => {
            stretch.line(e.min(stretch.len()) - 1) + 2
        }
        (None, true) if end <= start + 3 && !has_lost_id(stretch, start, end) => {
            stretch.line_count()
        }
        _ => line,
    }
}
