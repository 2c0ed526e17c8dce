//! The IDs that the text around a piece uses and defines, where the piece is no record.

use super::stretch::Stretch;

/// The IDs of the text around a piece.
pub(super) trait IdContext {
    /// Whether a number is used as an ID elsewhere and defined by no line of its own.
    fn is_missing(&self, id: i32) -> bool;
    /// Whether an ID is defined elsewhere.
    fn is_defined(&self, id: i32) -> bool;
    /// Whether an ID is defined before a line.
    fn is_defined_before(&self, stretch: &Stretch, line: usize, id: i32) -> bool;
    /// Whether an ID at the head of a line would be between the IDs before and behind the line.
    fn is_in_order(&self, line: usize, id: i32) -> bool;
    /// Whether an ID that would be in order at the head of a line is used elsewhere and defined by no line of its own.
    fn misses_next(&self, line: usize) -> bool;
    /// Whether some other ID is used elsewhere and defined by no line of its own.
    fn misses_another(&self, id: i32) -> bool;
}

/// A context in which no ID is known.
pub(super) struct Unknown;

impl IdContext for Unknown {
    fn is_missing(&self, _: i32) -> bool {
        false
    }

    fn is_defined(&self, _: i32) -> bool {
        false
    }

    fn is_defined_before(&self, _: &Stretch, _: usize, _: i32) -> bool {
        false
    }

    fn is_in_order(&self, _: usize, _: i32) -> bool {
        false
    }

    fn misses_next(&self, _: usize) -> bool {
        false
    }

    fn misses_another(&self, _: i32) -> bool {
        true
    }
}
