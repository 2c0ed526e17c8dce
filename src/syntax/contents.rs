//! Which kinds of things a document has. Callers skip the search for a kind that is absent.

use super::ast::Item;
use super::lexed::Lexed;
use super::table::{RECORD_TYPES, RecordKind, RecordType};

#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// How many records there are of each type, in the order of the table.
    counts: [u32; RECORD_TYPES.len()],
    /// Whether some part could not be read.
    pub broken: bool,
    pub comments: bool,
    /// Whether a comment goes over several lines.
    pub long_comments: bool,
    /// Whether a comment is meant for zpg.
    pub directives: bool,
    pub separators: bool,
}

impl Contents {
    pub(super) fn new(items: &[Item], lexed: &Lexed) -> Contents {
        let mut contents = Contents {
            comments: lexed.has_comment || lexed.has_unclosed,
            long_comments: lexed.has_long_comment,
            directives: lexed.has_directive,
            separators: lexed.has_separator,
            ..Contents::default()
        };
        for item in items {
            match item {
                Item::Record(r) => contents.counts[r.kind.place()] += 1,
                Item::Broken(_) => contents.broken = true,
                Item::Void { .. } => {}
            }
        }
        contents
    }

    /// Whether there is a record of one of these kinds that can be read.
    pub fn has(&self, kinds: &[RecordKind]) -> bool {
        kinds.iter().any(|k| self.counts[k.place()] > 0)
    }

    /// Whether a record could be read whose type fulfils `holds`.
    pub fn any(&self, holds: impl Fn(&RecordType) -> bool) -> bool {
        self.count(holds) > 0
    }

    /// The number of records that could be read and whose types fulfil `holds`.
    pub fn count(&self, holds: impl Fn(&RecordType) -> bool) -> usize {
        let counts = RECORD_TYPES.iter().zip(self.counts);
        let counts = counts.filter(|(ty, count)| *count > 0 && holds(ty));
        counts.map(|(_, count)| count as usize).sum()
    }
}

impl Default for Contents {
    fn default() -> Contents {
        Contents {
            counts: [0; RECORD_TYPES.len()],
            broken: false,
            comments: false,
            directives: false,
            long_comments: false,
            separators: false,
        }
    }
}
