//! Matrices by number: those that are the same have the same one.

use std::collections::HashMap;

use crate::geometry::Matrix;

#[derive(Debug, Default)]
pub(super) struct Matrices {
    all: Vec<Matrix>,
    numbers: HashMap<[u64; 16], u32>,
}

impl Matrices {
    pub(super) fn number(&mut self, m: &Matrix) -> u32 {
        let mut key = [0; 16];
        for (k, x) in key.iter_mut().zip(m.0.iter().flatten()) {
            // Adding zero makes one of the two zeros.
            *k = (x + 0.0).to_bits();
        }
        let next = self.all.len() as u32;
        let number = *self.numbers.entry(key).or_insert(next);
        if number == next {
            self.all.push(*m);
        }
        number
    }

    pub(super) fn get(&self, number: u32) -> &Matrix {
        &self.all[number as usize]
    }
}
