//! Surroundings of a stretch that has to be recovered: the IDs that the rest of the text defines and uses, and whether
//! it is laid out in lines. The rest is read once for all stretches.

use super::super::ast::{Item, Record};
use super::super::ids::IdTable;
use super::super::signature::Columns;
use super::super::table::{Effect, ParamKind, RecordType};

/// The part of a text that was read without a doubt.
#[derive(Default)]
pub(crate) struct Surroundings {
    /// For each ID the significant token at which this part defines it first.
    defined: IdTable,
    /// The IDs that this part uses or changes.
    used: IdTable,
    /// The IDs that this part uses or changes and does not define, in ascending order.
    pub dangling: Vec<u32>,
    /// How many lines this part takes, and how many records it has.
    pub lines: usize,
    pub records: usize,
    /// Whether a `0` introduces comments behind a record on its line in this part.
    pub voids_behind_records: bool,
    /// How many stretches have to be recovered.
    pub stretches: usize,
    /// Whether an ID that is defined nowhere here may be defined in another stretch, or in another part of a long one.
    pub others: bool,
    /// The significant token at which an optional group begins that may be a broken record.
    pub doubted: Option<usize>,
}

/// The most undefined IDs that are kept as evidence.
const DANGLING_MAX: usize = 64;

impl Surroundings {
    /// Collects the IDs of `items`, which were read outside of the stretches. They take `lines` lines.
    pub(crate) fn new(
        columns: &Columns,
        items: &[Item],
        lines: usize,
        stretches: usize,
    ) -> Surroundings {
        let mut all = Surroundings {
            defined: IdTable::new(items.len()),
            used: IdTable::new(items.len()),
            dangling: Vec::new(),
            lines,
            records: 0,
            voids_behind_records: false,
            stretches,
            others: false,
            doubted: None,
        };
        let mut used = Vec::new();
        for item in items {
            let record = match item {
                Item::Record(record) => record,
                Item::Void { token } => {
                    let before = token
                        .checked_sub(1)
                        .map(|i| columns.lexed.tokens[i as usize]);
                    all.voids_behind_records |= before.is_some_and(|t| !t.kind().is_trivia());
                    continue;
                }
                Item::Broken(_) => continue,
            };
            all.records += 1;
            match record.ty().effect {
                Effect::Changes(_) => used.push(record.id),
                Effect::Defines(_) | Effect::DefinesOrChanges(..) => {
                    all.defined.get_or_insert(record.id, record.value - 2);
                }
            }
            used.extend(references(columns, record));
        }
        for &id in &used {
            all.used.insert(id, 0);
        }
        used.retain(|&id| all.defined.get(id).is_none());
        used.sort_unstable();
        used.dedup();
        used.truncate(DANGLING_MAX);
        all.dangling = used;
        all
    }

    /// The significant token at which an ID is defined first, and the type of the record that does.
    pub(crate) fn definition(
        &self,
        columns: &Columns,
        id: u32,
    ) -> Option<(usize, &'static RecordType)> {
        let at = self.defined.get(id)? as usize;
        let ty = RecordType::by_code(columns.int(at + 1)?.into())?;
        Some((at, ty))
    }

    pub(crate) fn is_defined(&self, id: u32) -> bool {
        self.defined.get(id).is_some()
    }

    pub(crate) fn is_used(&self, id: u32) -> bool {
        self.used.get(id).is_some()
    }
}

/// The IDs that a record refers to.
fn references(columns: &Columns, record: &Record) -> impl Iterator<Item = u32> {
    let values = &columns.lexed.values[record.value as usize..];
    (values.iter().zip(record.ty().params))
        .filter(|(_, p)| matches!(p.kind, ParamKind::Reference { .. }))
        .map(|(&value, _)| value as u32)
        .filter(|&id| id > 0)
}
