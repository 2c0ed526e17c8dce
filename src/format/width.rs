//! How much room a text takes.

use unicode_width::UnicodeWidthStr;

/// The columns that a text takes on a terminal: two for most characters of East Asia, none for an accent
/// that combines with the letter before it (Unicode Standard Annex #11).
pub(super) fn display_width(text: &str) -> usize {
    match text.is_ascii() {
        true => text.len(),
        false => text.width(),
    }
}
