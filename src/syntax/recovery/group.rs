//! Optional groups that are lines of their own. The line of a group may be a broken record, and only the IDs show that.

use std::ops::Range;

use super::super::ast::Item;
use super::super::signature::Columns;
use super::super::table::{ParamKind, RecordKind};
use super::has_lost_id;
use super::surroundings::Surroundings;

/// Finds the item whose optional group is likelier a broken record. Returns its index, and the significant tokens of
/// the group. `None` if there are several of these items, since something else is wrong then.
///
/// The group then begins like the render record, or with an ID in order that is used and defined nowhere. Or the group
/// is a record that has lost an ID like that.
pub(crate) fn doubtful_group(columns: &Columns, items: &[Item]) -> Option<(usize, Range<usize>)> {
    let lines = || {
        (0..)
            .zip(items)
            .filter_map(|(i, item)| Some((i, GroupLine::new(columns, item)?)))
    };
    lines().next()?;
    let around = Surroundings::new(columns, items, 0, 0);
    let mut doubtful = lines().filter(|(_, line)| line.may_be_record(columns, &around));
    let (item, line) = doubtful.next()?;
    doubtful.next().is_none().then_some((item, line.tokens))
}

/// The optional group of a record, where it is a line of its own.
struct GroupLine {
    /// The ID of the record.
    id: u32,
    /// The significant tokens of the group.
    tokens: Range<usize>,
    /// Whether the group begins with a reference.
    refers: bool,
}

impl GroupLine {
    fn new(c: &Columns, item: &Item) -> Option<GroupLine> {
        let Item::Record(record) = item else {
            return None;
        };
        let first = record.ty().optional.first()?;
        let from = record.value as usize + record.ty().params.len();
        let to = (record.value + record.params) as usize;
        let is_line =
            from < to && c.starts_line(from) && !(from + 1..to).any(|at| c.starts_line(at));
        // Behind the render record there is no order of IDs.
        (is_line && record.kind != RecordKind::Render).then_some(GroupLine {
            id: record.id,
            tokens: from..to,
            refers: matches!(first.kind, ParamKind::Reference { .. }),
        })
    }

    fn may_be_record(&self, c: &Columns, around: &Surroundings) -> bool {
        let Range { start, end } = self.tokens;
        let id = |at| c.int(at).and_then(|id| u32::try_from(id).ok());
        let next = id(end).filter(|&next| next > 1).unwrap_or(u32::MAX);
        let in_order = |id: u32| self.id < id && id < next;
        let is_missing = |id: u32| {
            in_order(id) && (around.dangling.contains(&id) || self.refers && !around.is_defined(id))
        };
        // The ID 1 is the render record's.
        let is_no_reference = |id: u32| self.refers && id == 1;
        let another_is_missing = || around.dangling.iter().any(|&id| in_order(id));
        c.begins_render(start)
            || id(start).is_some_and(|id| is_missing(id) || is_no_reference(id))
            || another_is_missing() && has_lost_id(*c, start, end)
    }
}
