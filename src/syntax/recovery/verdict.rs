//! What a piece of a stretch is.

use super::super::signature::Reading;
use super::super::table::RecordType;

/// The price of one error. All other prices are in relation to this one.
pub const FAULT: u32 = 1000;

/// One piece of a stretch: tokens `start..end`.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    pub start: usize,
    pub end: usize,
    pub verdict: Verdict,
}

/// What a piece of the text is.
#[derive(Debug, Clone, Copy)]
pub enum Verdict {
    Void,
    Whole(Reading),
    /// A record with the right number of parameters, some of them reported by themselves; tokens
    /// that can be no parameter are passed over.
    Damaged {
        ty: &'static RecordType,
    },
    /// A line that is a record but for integers that are spelled as reals, `2.0 9.0 1`.
    Reals {
        ty: &'static RecordType,
    },
    /// Too few or too many parameters.
    Count {
        ty: &'static RecordType,
        got: usize,
        expected: usize,
    },
    /// A number in front of a whole record.
    Surplus {
        ty: &'static RecordType,
        expected: usize,
    },
    /// A record of another type but for the sign of its type.
    LostSign {
        ty: &'static RecordType,
        meant: &'static RecordType,
        got: usize,
        expected: usize,
    },
    /// The count of a counted type is missing or cannot be used.
    BadCount {
        ty: &'static RecordType,
    },
    /// There is no such type.
    UnknownType,
    /// The token in the type's place is no integer.
    BadType,
    /// Nothing behind the ID.
    MissingType,
    /// A complete record but for the ID in front.
    LostId {
        ty: &'static RecordType,
    },
    /// The render record with ID and type in each other's place.
    Swapped,
    /// The token in the ID's place cannot be one; the rest may be right.
    BadId {
        ty: Option<&'static RecordType>,
    },
    /// The record was cut off by a comment that nobody closed, which is error enough.
    CutOff {
        ty: Option<&'static RecordType>,
    },
}
