//! What kinds of things a document has, so that nobody looks for what is not there.

use super::ast::Item;
use super::lexer::Lexed;
use super::table::{RECORD_TYPES, RecordKind, RecordType};

#[derive(Debug, Clone, Copy, Default)]
pub struct Contents {
    /// A bit for each record type, in the order of the table.
    kinds: u64,
    /// There is something that could not be read.
    pub broken: bool,
    pub comments: bool,
    /// There is a comment over several lines.
    pub long_comments: bool,
    pub separators: bool,
}

impl Contents {
    pub(super) fn new(items: &[Item], lexed: &Lexed) -> Contents {
        let mut contents = Contents {
            comments: lexed.has_comment || lexed.has_unclosed,
            long_comments: lexed.has_long_comment,
            separators: lexed.has_separator,
            ..Contents::default()
        };
        for item in items {
            match item {
                Item::Record(r) => contents.kinds |= bit(r.kind),
                Item::Broken(_) => contents.broken = true,
                Item::Void { .. } => {}
            }
        }
        contents
    }

    /// Whether there is a record of one of these kinds that can be read.
    pub fn has(&self, kinds: &[RecordKind]) -> bool {
        kinds.iter().any(|&k| self.kinds & bit(k) != 0)
    }

    /// Whether there is a record that can be read of a type for which this holds.
    pub fn any(&self, holds: impl Fn(&RecordType) -> bool) -> bool {
        RECORD_TYPES
            .iter()
            .any(|ty| self.kinds & bit(ty.kind) != 0 && holds(ty))
    }
}

/// The bit of a kind.
fn bit(kind: RecordKind) -> u64 {
    debug_assert!(RECORD_TYPES.len() <= 64);
    1 << kind.place()
}
