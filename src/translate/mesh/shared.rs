//! Surfaces in one place: pieces that show the same surface of the same shape, as a shape and an object cut from it
//! do.

use std::collections::HashMap;

use super::Parts;
use super::assemble::MeshPart;
use super::shape::DROPPED;
use super::surface_label::SurfaceLabel;
use super::union_find::UnionFind;
use crate::geometry::Matrix;
use crate::scene::{Geometry, Scene};
use crate::trace::graph::Graph;

impl Parts {
    /// For each piece, the number of its group of solids, which are connected by surfaces in one place; `None` for a
    /// piece that shares no surface.
    pub fn sharing(&self) -> Vec<Option<u32>> {
        let mut sets = UnionFind::new(self.pieces.len());
        let mut shares = vec![false; self.pieces.len()];
        let mut first: HashMap<(u32, [u64; 16]), usize> = HashMap::new();
        for (i, piece) in self.pieces.iter().enumerate() {
            for (skin, primitive) in self.shown(piece) {
                let j = *first.entry((primitive, skin.place())).or_insert(i);
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

    /// The number of surfaces that two solids have in one place and that are seen from both sides, since one of the
    /// solids is `seen_into`. The triangles of the two may differ. A ball that is rotated about its centre is in one
    /// place with itself.
    pub fn clashes(
        &self,
        scene: &Scene,
        graph: &Graph,
        seen_into: impl Fn(&MeshPart) -> bool,
    ) -> u64 {
        let mut first: HashMap<(u32, [i64; 12]), (usize, bool)> = HashMap::new();
        let mut clashes = 0;
        for (i, piece) in self.pieces.iter().enumerate() {
            for (skin, primitive) in self.shown(piece) {
                let record = graph.records[primitive as usize];
                let geometry = &scene.shapes[record as usize].geometry;
                let place = round_place(geometry, &skin.matrix);
                let open = seen_into(piece);
                let (j, other) = *first.entry((primitive, place)).or_insert((i, open));
                clashes += u64::from(j != i && (open || other));
            }
        }
        clashes
    }

    /// The skins that a solid shows and that belong to shapes, each with the index of its primitive. Empty for a
    /// surface.
    fn shown(&self, piece: &MeshPart) -> impl Iterator<Item = (&SurfaceLabel, u32)> {
        let mut labels = match piece.surface {
            true => Vec::new(),
            false => piece.mesh.labels.clone(),
        };
        labels.sort_unstable();
        labels.dedup();
        labels
            .into_iter()
            .filter(|l| *l != DROPPED)
            .filter_map(|label| {
                let skin = self.skins.get(label as usize)?;
                Some((skin, skin.primitive?))
            })
    }
}

/// The place of a shape to six digits: the same where matrices differ by roundings, and for a ball that is rotated
/// about its centre.
fn round_place(geometry: &Geometry, matrix: &Matrix) -> [i64; 12] {
    let mut matrix = *matrix;
    if let Geometry::Sphere { centre, .. } = geometry
        && let Some(scale) = matrix.uniform_scale()
    {
        let [x, y, z] = matrix.point(*centre);
        matrix = Matrix::translation(x, y, z).after(&Matrix::scaling(scale, scale, scale));
    }
    let entries = || matrix.0.iter().take(3).flatten();
    let size = entries().fold(0.0f64, |s, x| s.max(x.abs()));
    // Powers of two, so that sizes that differ by a rounding do not count in different steps.
    let step = size.log2().floor().exp2() * 1e-6;
    let mut place = [0; 12];
    for (number, x) in place.iter_mut().zip(entries()) {
        *number = (x / step).round() as i64;
    }
    place
}
