//! Finds lines that would be records of their own but for a slip, and tables, whose rows are no records. Where the same
//! mistake stands on many lines, no line is right, and only the slips show that the text is laid out in lines.

use super::super::table::{RecordKind, RecordType};
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::faults::{has_lost_id, judge, lost_sign};
use super::heads::{end_of, expected_end, is_counted, type_behind_stray};
use super::id_context::Unknown;
use super::order::Order;
use super::stretch::Stretch;

/// Whether a line would be a record of its own but for a slip: a number more or less, one that is
/// malformed, a word for the type, a lost ID or sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slip {
    Yes,
    /// A record if its ID is used elsewhere and no other line defines it.
    Maybe,
    No,
}

/// Whether a line by itself is a record but for a slip. A line that may be a row of a table must have a type that no
/// row has, or begin with an ID that is in order.
pub(super) fn slip(stretch: &Stretch, line: usize, in_table: bool, order: &Order) -> Slip {
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
        Diagnosis::Damaged { ty } | Diagnosis::Reals { ty } => (Some(ty), Slip::Yes),
        Diagnosis::LostId { ty } => {
            return if in_table && ty.code > LEAST_HEAD {
                Slip::No
            } else {
                Slip::Yes
            };
        }
        Diagnosis::Swapped => (None, Slip::Yes),
        Diagnosis::Surplus { ty, .. } => (Some(ty), Slip::Yes),
        Diagnosis::LostSign { meant, .. } => (Some(meant), Slip::Yes),
        Diagnosis::BadId { ty: Some(ty) } if stretch.sigs[start].kind.is_bad() => {
            (Some(ty), Slip::Yes)
        }
        Diagnosis::WrongArity { ty, got, expected }
            if got.abs_diff(expected) <= most_off(expected) =>
        {
            let head = got > 0 || ty.code <= LEAST_HEAD || in_order;
            (Some(ty), if head { Slip::Yes } else { Slip::Maybe })
        }
        // Words for numbers, as in `2 -701 red`, or a missing vector, as in a camera without its up vector. No row of a
        // table has this type.
        Diagnosis::WrongArity { ty, got, expected } if ty.code <= LEAST_HEAD => {
            let has_word = stretch.bad(start + 2, end) > 0;
            let is_short = got < expected && 2 * got > expected;
            let slip = if has_word || is_short {
                Slip::Yes
            } else {
                Slip::No
            };
            (Some(ty), slip)
        }
        Diagnosis::BadPointCount { ty } if end > start + 4 => (Some(ty), Slip::Yes),
        Diagnosis::BadType
            if (stretch.sigs[start + 1].kind.is_bad() || has_next_id()) && end > start + 2 =>
        {
            (None, Slip::Yes)
        }
        Diagnosis::UnknownType => {
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

/// The greatest type number that tables do not have: no row begins with an integer and a second number as low as this.
pub const LEAST_HEAD: i32 = -99;

/// Whether a line begins like a record that no table of numbers would begin like.
pub(super) fn looks_like_a_head(stretch: &Stretch, line: usize) -> bool {
    let start = stretch.line_start(line);
    let id = stretch.sigs[start].int.is_some_and(|id| id > 0);
    id && stretch
        .record_type(start + 1)
        .is_some_and(|t| t.code <= LEAST_HEAD || t.kind == RecordKind::Render)
}

/// How many numbers more or less are a slip of the pen.
const SLIP_MAX: usize = 2;

/// The end of the table of numbers that the record at the head of a line should have below, one past the table's last
/// line. The line itself if the record needs no table, or has most of its numbers on the line.
pub(super) fn rows_expected(stretch: &Stretch, line: usize) -> usize {
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

/// Whether a piece that is no record is one slip of the pen away from one.
pub(super) fn is_slip(stretch: &Stretch, piece: &RecordCandidate) -> bool {
    let RecordCandidate {
        start,
        end,
        verdict,
    } = *piece;
    let code = (start + 1 < end).then(|| stretch.sigs[start + 1].int);
    // No table of numbers has a type like these.
    let is_no_row = |code: i32| {
        let ty = RecordType::by_code(code.into());
        code <= LEAST_HEAD || ty.is_some_and(|ty| ty.kind == RecordKind::Render)
    };
    if code.flatten().is_some_and(is_no_row) {
        return true;
    }
    let is_record = |ty: &RecordType| ty.kind != RecordKind::Undefined;
    match verdict {
        Diagnosis::Void | Diagnosis::Whole(_) | Diagnosis::Swapped => true,
        Diagnosis::Damaged { ty }
        | Diagnosis::Reals { ty }
        | Diagnosis::Surplus { ty, .. }
        | Diagnosis::LostSign { meant: ty, .. }
        | Diagnosis::LostId { ty }
        | Diagnosis::CutOff { ty: Some(ty) } => is_record(ty),
        Diagnosis::WrongArity { ty, got, expected } => {
            let is_cut_off = end == stretch.len() && got < expected;
            is_record(ty) && (is_cut_off || got.abs_diff(expected) <= most_off(expected))
        }
        Diagnosis::BadPointCount { .. } => end > start + 4,
        Diagnosis::BadId { ty: Some(ty) } => {
            is_record(ty) && end_of(stretch, start + 2, ty) == Some(end as u64)
        }
        Diagnosis::BadType => {
            let ty = type_behind_stray(stretch, start + 1);
            let is_right = |ty| end_of(stretch, start + 3, ty) == Some(end as u64);
            // A word for the type, and then hardly anything but numbers.
            let params = &stretch.sigs[(start + 2).min(end)..end];
            let numbers = params.iter().filter(|s| s.kind.is_numeric()).count();
            let has_numbers = numbers > 0 && 2 * numbers >= params.len();
            stretch.sigs[start].int.is_some() && has_numbers || ty.is_some_and(is_right)
        }
        Diagnosis::UnknownType => lost_sign(stretch, start, end),
        // The text may end in the middle of its first record.
        Diagnosis::MissingType | Diagnosis::CutOff { ty: None } => {
            end == stretch.len() && end - start < 2
        }
        Diagnosis::BadId { ty: None } => false,
    }
}

/// How many numbers more or less are a slip of the pen in a record that takes `expected` parameters.
fn most_off(expected: usize) -> usize {
    SLIP_MAX.min(1 + expected / 4)
}
