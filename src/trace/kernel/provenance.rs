//! Doubtful rays of the kernel in the arbiter's form, and the arbiter's knowledge of faces in one plane.

use super::leaf::{Kind, Leaf};
use super::query::{Crossing, NONE, Query, Start, UNKNOWN_FACE};
use super::stage::Stage;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::trace::ray::{Left, Ray};
use crate::trace::search::walk::{placed_key, surface_key};
use crate::trace::shapes::support::{Passage, Placed};
use crate::trace::shapes::{Root, Roots};

impl Stage<'_> {
    /// Turns a ray of the kernel into a ray of the arbiter.
    #[cold]
    pub fn ray(&self, start: &Start) -> Ray {
        let line = Line::new(Vec3(start.origin), Vec3(start.direction));
        Ray {
            line,
            left: (start.left != NONE).then(|| self.left(start, &line)),
            is_outside: start.within.is_empty(),
        }
    }

    /// The surface that a ray starts on, in the arbiter's form.
    fn left(&self, start: &Start, line: &Line) -> Left {
        let leaf = &self.leaves[start.left as usize];
        let keys = self.keys(leaf.chain);
        let chain = keys.last().copied().unwrap_or(0);
        Left {
            surface: surface_key(chain, leaf.primitive),
            primitive: leaf.primitive,
            entering: start.goes_in,
            skin: start.skin,
            passage: self.passage(start, line, &keys),
        }
    }

    /// The arbiter's keys for a chain of placements: a key for its first placement alone, a key for its first two, and
    /// so on.
    fn keys(&self, chain: u32) -> Vec<u64> {
        let below = |key: &mut u64, &placement: &u32| {
            *key = placed_key(*key, placement);
            Some(*key)
        };
        self.chains[chain as usize].iter().scan(0, below).collect()
    }

    /// How a ray passes the support of the face that it starts on; `None` if no other shape may have a face in the
    /// support.
    fn passage(&self, start: &Start, line: &Line, keys: &[u64]) -> Option<Passage> {
        let leaf = &self.leaves[start.left as usize];
        let shape = self.graph.primitives[leaf.primitive as usize].intersect();
        let line = self.line_through(line, leaf.chain);
        let face = face_at(leaf, start.face, line.origin);
        let placed = self.placed_support(leaf, face, keys)?;
        let located = shape.locate(&line, Root { t: 0.0, face });
        let outwards = placed.own.outwards(located.point);
        Some(Passage {
            placed,
            outwards: outwards.map(|n| (n.dot(located.normal) > 0.0) != start.goes_in),
        })
    }

    /// The support of a face in the scene's space; `None` if no other shape may have a face in the support.
    fn placed_support(&self, leaf: &Leaf, face: u32, keys: &[u64]) -> Option<Placed> {
        let primitive = &self.graph.primitives[leaf.primitive as usize];
        let own = primitive.shape().support(face)?;
        let chain = &self.chains[leaf.chain as usize];
        let mut placed = Placed::new(own, keys.last().copied().unwrap_or(0));
        for (&placement, &key) in chain.iter().zip(keys).rev() {
            placed.carry(&self.graph.matrices[placement as usize], || key);
        }
        Some(placed)
    }

    /// Whether two crossings that are near each other are of flat faces in one plane, by the numbers of the scene.
    #[cold]
    pub fn are_flush(&self, query: &Query, crossings: [&Crossing; 2]) -> bool {
        let flat = |crossing: &Crossing| {
            let leaf = &self.leaves[crossing.surface as usize];
            let mut crossing = *crossing;
            if leaf.kind == Kind::Quadric && crossing.root.face == UNKNOWN_FACE {
                let is_known = self.sharpen(query.start, &mut crossing, &mut Roots::default());
                is_known.then_some(())?;
            }
            let line = self.line_through(&query.line, leaf.chain);
            let point = line.at(crossing.root.t);
            let face = face_at(leaf, crossing.root.face, point);
            let placed = self.placed_support(leaf, face, &self.keys(leaf.chain))?;
            placed.own.outwards(point).is_none().then_some(placed)
        };
        let [a, b] = crossings.map(flat);
        a.zip(b).is_some_and(|(a, b)| a.is(&b))
    }
}

/// The face of a leaf that a point in the space of the shape is on. A box finds its face from the point; other leaves
/// know `face`, or have a single face.
fn face_at(leaf: &Leaf, face: u32, point: Vec3) -> u32 {
    match leaf.kind {
        Kind::Cuboid => nearest_face([*leaf.first(), *leaf.upper()], point),
        Kind::Quadric | Kind::Other => face,
        _ => 0,
    }
}

/// The number of the face nearest to `point` of the box with these lower and upper corners: twice the axis, plus 1 for
/// the upper face.
fn nearest_face(corners: [[f64; 3]; 2], point: Vec3) -> u32 {
    let distance = |face: &u32| {
        let axis = *face as usize / 2;
        (corners[*face as usize % 2][axis] - point[axis]).abs()
    };
    let nearest = (0..6).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.unwrap_or(0)
}
