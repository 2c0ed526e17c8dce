//! A map from IDs to numbers. IDs are nearly always small and dense: small IDs have a table, whose size is in
//! proportion to the file. Larger IDs, up to 2 147 483 647, are hashed.

use std::fmt;

use rustc_hash::FxHashMap;

#[derive(Clone, Default)]
pub struct IdTable {
    /// For each small ID its number + 1, or 0 if it has none. Pages of memory that nobody touches cost nothing.
    dense: Vec<u32>,
    sparse: FxHashMap<u32, u32>,
}

/// Prints the name alone: the entries would be as many as the records of a file.
impl fmt::Debug for IdTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("IdTable").finish_non_exhaustive()
    }
}

impl IdTable {
    /// An empty map for a file with so many records.
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

    /// Sets the number of an ID. `number` must be less than 2³² − 1.
    pub fn insert(&mut self, id: u32, number: u32) {
        match self.dense.get_mut(id as usize) {
            Some(entry) => *entry = number + 1,
            None => drop(self.sparse.insert(id, number)),
        }
    }

    /// Returns the number of an ID. An ID without a number gets `number` first.
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
