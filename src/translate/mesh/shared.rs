//! Pieces that show one surface in one place: what is made of a shape, beside the shape itself.

use std::collections::HashMap;

use super::Parts;
use super::sets::Sets;
use super::shape::DROPPED;

impl Parts {
    /// For each piece, the number of the group of solids that hang together by surfaces in one place;
    /// `None` for one that has its surfaces for itself.
    pub fn sharing(&self) -> Vec<Option<u32>> {
        let mut sets = Sets::new(self.pieces.len());
        let mut shares = vec![false; self.pieces.len()];
        let mut first: HashMap<(u32, [u64; 16]), usize> = HashMap::new();
        for (i, piece) in self.pieces.iter().enumerate() {
            if piece.surface {
                continue;
            }
            let mut labels = piece.mesh.labels.clone();
            labels.sort_unstable();
            labels.dedup();
            for label in labels.into_iter().filter(|l| *l != DROPPED) {
                let Some(skin) = self.skins.get(label as usize) else {
                    continue;
                };
                let Some(primitive) = skin.primitive else {
                    continue;
                };
                let mut place = [0; 16];
                for (bits, x) in place.iter_mut().zip(skin.matrix.0.iter().flatten()) {
                    // Adding zero makes one of the two zeros.
                    *bits = (x + 0.0).to_bits();
                }
                let j = *first.entry((primitive, place)).or_insert(i);
                if j != i {
                    sets.join(i as u32, j as u32);
                    (shares[i], shares[j]) = (true, true);
                }
            }
        }
        (0..shares.len())
            .map(|i| shares[i].then(|| sets.find(i as u32)))
            .collect()
    }
}
