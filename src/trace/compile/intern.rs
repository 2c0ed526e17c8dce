//! Interning: equal values get equal indices in the tables of a graph.

use crate::geometry::Matrix;
use crate::geometry::affine::{Affine, Placement};
use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::scene::{Optics, Rgb};
use crate::trace::graph::{Coat, Graph};
use crate::trace::shapes::Primitive;
use rustc_hash::FxHashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Fills the tables of a [`Graph`], each value once. Values are equal if they compare equal, so
/// that 0 and −0 are one number here.
#[derive(Default)]
pub(crate) struct Interner {
    primitives: FxHashMap<u64, u32>,
    matrices: FxHashMap<[u64; 12], u32>,
    paints: FxHashMap<Coat, u32>,
    optics: FxHashMap<[u64; 9], u32>,
    indices: FxHashMap<[u64; 3], u32>,
}

/// The bits of a number, the same for both zeros.
fn bits(x: f64) -> u64 {
    (x + 0.0).to_bits()
}

impl Interner {
    /// Fills index 0 of the tables: no placement, no paint, default optics, default refractive index.
    pub(crate) fn new(graph: &mut Graph) -> Interner {
        let mut interner = Interner::default();
        interner.matrix(graph, &Matrix::IDENTITY);
        interner.paint(graph, Coat::default());
        interner.optics(graph, Optics::default());
        interner.index(graph, crate::scene::DEFAULT_INDEX);
        interner
    }

    /// The index of a shape with the index of its record. Shapes are found by a hash of their numbers. If two different
    /// shapes have the same hash, the later one is added each time it occurs, which costs sharing and nothing else.
    pub(crate) fn primitive(
        &mut self,
        graph: &mut Graph,
        primitive: Primitive,
        record: u32,
    ) -> u32 {
        let mut hasher = DefaultHasher::new();
        std::mem::discriminant(&primitive).hash(&mut hasher);
        primitive.shape().feed(&mut |x| bits(x).hash(&mut hasher));
        let here = graph.primitives.len() as u32;
        let found = *self.primitives.entry(hasher.finish()).or_insert(here);
        if found != here && graph.primitives[found as usize] == primitive {
            return found;
        }
        graph.extents.push(primitive.shape().extent());
        graph.records.push(record);
        graph.primitives.push(primitive);
        here
    }

    /// Forgets by which hashes shapes are found, once no more are asked for. There may be millions.
    pub(crate) fn forget_primitives(&mut self) {
        self.primitives = FxHashMap::default();
    }

    /// The index of a matrix; `None` if its inverse is not finite.
    pub(crate) fn matrix(&mut self, graph: &mut Graph, m: &Matrix) -> Option<u32> {
        let key = std::array::from_fn(|i| bits(m.0[i / 4][i % 4]));
        if let Some(&found) = self.matrices.get(&key) {
            return Some(found);
        }
        let here = graph.matrices.len() as u32;
        // The inverse is computed in double-double, so that each of its numbers is as good as a double can be.
        let back = Affine::<Dd>::new(m).inverse()?.cast();
        self.matrices.insert(key, here);
        graph.matrices.push(*m);
        graph.placements.push(Placement {
            out: Affine::new(m),
            back,
        });
        Some(here)
    }

    pub(crate) fn paint(&mut self, graph: &mut Graph, paint: Coat) -> u32 {
        *self.paints.entry(paint).or_insert_with(|| {
            graph.paints.push(paint);
            graph.paints.len() as u32 - 1
        })
    }

    pub(crate) fn optics(&mut self, graph: &mut Graph, o: Optics) -> u32 {
        let all = [o.kd, o.ks, o.kt];
        let key = std::array::from_fn(|i| bits(all[i / 3][i % 3]));
        *self.optics.entry(key).or_insert_with(|| {
            graph.optics.push(o);
            graph.optics.len() as u32 - 1
        })
    }

    pub(crate) fn index(&mut self, graph: &mut Graph, index: Rgb) -> u32 {
        *self.indices.entry(each(index, bits)).or_insert_with(|| {
            graph.indices.push(index);
            graph.indices.len() as u32 - 1
        })
    }
}
