//! The order of IDs. Most files have their IDs in order, and a row of a table hardly ever begins with a number that is
//! just between two IDs.

use super::super::table::{Effect, RecordKind, RecordType};
use super::stretch::Stretch;

/// How many lines before and behind a stretch are searched for an ID.
const AROUND: usize = 8;
/// How many numbers behind the highest ID count as the next ones.
const NEXT: i32 = 4;

/// The ID that a line surely defines, given its first two tokens; `None` if its type may change an ID.
fn defined(head: [Option<i32>; 2]) -> Option<i32> {
    let is_new = |ty: &RecordType| matches!(ty.effect, Effect::Defines(_));
    named(head).filter(|_| type_of(head).is_some_and(is_new))
}

/// The ID that a line may define, given its first two tokens; `None` for changes and for render records.
fn named(head: [Option<i32>; 2]) -> Option<i32> {
    let is_new =
        |ty: &RecordType| !matches!(ty.effect, Effect::Changes(_)) && ty.kind != RecordKind::Render;
    head[0].filter(|&id| id > 1 && type_of(head).is_some_and(is_new))
}

fn type_of([_, code]: [Option<i32>; 2]) -> Option<&'static RecordType> {
    RecordType::by_code(code?.into())
}

/// For each line of a stretch the last ID that is defined before it and the next one behind it.
pub(crate) struct Order {
    bounds: Vec<[i32; 2]>,
}

impl Order {
    /// The order of a text that is not laid out in lines: nothing is in order.
    pub(crate) fn none(stretch: &Stretch) -> Order {
        Order {
            bounds: vec![[0, 0]; stretch.line_count()],
        }
    }

    /// Finds, for each line of a stretch, between which two IDs an ID at its head would be in order. `is_read` says of
    /// a line whether a record can be read at its head.
    pub(crate) fn new(stretch: &Stretch, is_read: impl Fn(usize) -> bool) -> Order {
        let lines = stretch.line_count();
        let known = |line: usize| is_read(line).then(|| defined(stretch.head(line))).flatten();
        let mut next = stretch.heads_behind().take(AROUND).find_map(defined);
        let mut behind = vec![None; lines];
        for line in (0..lines).rev() {
            behind[line] = next;
            next = known(line).or(next);
        }
        let mut order = Order {
            bounds: Vec::with_capacity(lines),
        };
        let before = stretch.heads_before().take(AROUND).filter_map(named);
        let mut last = before.max().unwrap_or(1);
        for (line, behind) in behind.into_iter().enumerate() {
            let end = behind.unwrap_or(last.saturating_add(NEXT + 1));
            order.bounds.push([last, end]);
            let own = known(line).or_else(|| order.head(stretch, line));
            let named = named(stretch.head(line)).filter(|&id| is_read(line) && id > last);
            last = own.or(named).unwrap_or(last);
        }
        order
    }

    /// Whether an ID at the head of a line would be between the IDs before and behind the line.
    pub(crate) fn has(&self, line: usize, id: i32) -> bool {
        let [before, behind] = self.bounds[line];
        before < id && id < behind
    }

    /// Like [`has`](Self::has), for any of some IDs, which are sorted.
    pub(crate) fn has_any(&self, line: usize, sorted: &[i32]) -> bool {
        let [before, behind] = self.bounds[line];
        let next = sorted.partition_point(|&id| id <= before);
        sorted.get(next).is_some_and(|&id| id < behind)
    }

    /// The ID at the head of a line, if it is in order and a type follows. A token that is no ID may stand before it.
    pub(crate) fn head(&self, stretch: &Stretch, line: usize) -> Option<i32> {
        let head = match stretch.head(line) {
            head @ [Some(1..), _] => head,
            _ => stretch.head_behind_first(line),
        };
        let ty = type_of(head)?;
        head[0].filter(|&id| ty.kind != RecordKind::Undefined && self.has(line, id))
    }
}
