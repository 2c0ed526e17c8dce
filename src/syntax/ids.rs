//! A number for each ID. IDs are nearly always small and dense: these have a table, of a size in proportion to
//! the file. The others, up to 2 147 483 647, are hashed and cost no more than themselves.

use std::fmt;

use rustc_hash::FxHashMap;

#[derive(Clone, Default)]
pub struct IdTable {
    /// The number + 1, 0 for none. Pages that nobody touches take no memory.
    dense: Vec<u32>,
    sparse: FxHashMap<u32, u32>,
}

/// How large a table is says nothing.
impl fmt::Debug for IdTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("IdTable").finish_non_exhaustive()
    }
}

impl IdTable {
    /// A table for the IDs of so many records.
    pub fn new(records: usize) -> IdTable {
        IdTable {
            dense: vec![0; 4 * records + 64],
            sparse: FxHashMap::default(),
        }
    }

    #[inline]
    pub fn get(&self, id: u32) -> Option<u32> {
        match self.dense.get(id as usize) {
            Some(&number) => number.checked_sub(1),
            None => self.sparse.get(&id).copied(),
        }
    }

    /// `number` is less than 2³² − 1.
    pub fn insert(&mut self, id: u32, number: u32) {
        match self.dense.get_mut(id as usize) {
            Some(entry) => *entry = number + 1,
            None => drop(self.sparse.insert(id, number)),
        }
    }

    /// The number of an ID, which is this one from now on if it had none.
    pub fn get_or_insert(&mut self, id: u32, number: u32) -> u32 {
        match self.get(id) {
            Some(number) => number,
            None => {
                self.insert(id, number);
                number
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_and_large_ids() {
        let mut table = IdTable::new(2);
        for id in [0, 1, 71, 72, 1_000, i32::MAX as u32] {
            assert_eq!(table.get(id), None);
            table.insert(id, id + 1);
            assert_eq!(table.get(id), Some(id + 1));
            assert_eq!(table.get_or_insert(id, 5), id + 1);
        }
        assert_eq!(table.get_or_insert(2, 5), 5);
        assert_eq!(table.get(2), Some(5));
    }
}
