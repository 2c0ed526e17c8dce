//! Values by number.

use std::collections::HashMap;
use std::hash::Hash;

use crate::geometry::Matrix;

/// Values by number. Values with equal keys have the same number.
#[derive(Debug)]
pub(crate) struct Numbered<K, T = K> {
    pub values: Vec<T>,
    numbers: HashMap<K, u32>,
}

impl<K, T> Default for Numbered<K, T> {
    fn default() -> Self {
        Numbered {
            values: Vec::new(),
            numbers: HashMap::new(),
        }
    }
}

impl<K: Eq + Hash, T> Numbered<K, T> {
    /// The number of the value with a key. If the key is new, the value is made.
    pub(crate) fn number(&mut self, key: K, value: impl FnOnce() -> T) -> u32 {
        *self.numbers.entry(key).or_insert_with(|| {
            self.values.push(value());
            self.values.len() as u32 - 1
        })
    }

    pub(crate) fn get(&self, number: u32) -> &T {
        &self.values[number as usize]
    }
}

/// Numbers as a key. Adding zero turns −0 into 0, so that both have the same key.
pub(crate) fn bits<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    numbers.into_iter().map(|x| (x + 0.0).to_bits()).collect()
}

impl Numbered<[u64; 16], Matrix> {
    pub(crate) fn matrix(&mut self, m: &Matrix) -> u32 {
        let key = std::array::from_fn(|k| (m.0[k / 4][k % 4] + 0.0).to_bits());
        self.number(key, || *m)
    }
}
