//! Options of the layout.

#![warn(missing_docs)]

/// The style of the layout. The default is the recommended one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The columns that a line should take at most: longer profiles wrap, and alignment hardly goes further.
    pub width: usize,
    /// Whether numbers and comments stand under each other.
    pub align: bool,
    /// Whether the vectors of a record are set off by double spaces.
    pub group: bool,
    /// How numbers are spelled.
    pub numbers: Numbers,
}

/// How numbers are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// Every number gets the shortest spelling of its value.
    Shortest,
    /// Numbers stay as they are written.
    Keep,
}

impl Options {
    /// The widths that can be set.
    pub const WIDTHS: std::ops::RangeInclusive<usize> = 20..=1000;
}

impl Default for Options {
    fn default() -> Self {
        Options {
            width: 100,
            align: true,
            group: true,
            numbers: Numbers::Shortest,
        }
    }
}
