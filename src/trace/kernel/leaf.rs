//! A shape of the scene as the kernel sees it.

use super::look::Look;
use super::quadric::Quadric;
use super::way_in::WayIn;
use crate::geometry::affine::{Affine, Placement};
use crate::geometry::exponent::{exponent, shifted};
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use crate::trace::shapes::Primitive;
use crate::trace::shapes::quadric::Axial;
use crate::trace::shapes::triangle::Triangle;
use std::sync::Arc;

/// Kinds of shapes. Each kind says what [`Leaf::numbers`] holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// x, y, z of the centre and the radius.
    Sphere,
    /// The lower corner and the upper one.
    Cuboid,
    /// a, b, c and d of the plane as written; then the four scaled by a power of two, so that the greatest of a, b and
    /// c is between 1 and 2.
    Plane,
    /// The numbers are those of a plane. The shape has an inside.
    HalfSpace,
    /// The least x and y, and the greatest x and y.
    Rectangle,
    /// A vector across the flat ends, with a largest component of 1, or zeros; then how much more the map stretches
    /// along one axis than along another. See [`Leaf::form`].
    Quadric,
    /// The unit normal; the square of the width, divided by twice the area; the width, which is the largest component
    /// of two edges, in size; and the largest coordinate, in size. See [`Leaf::form`].
    Triangle,
    /// A shape without lanes, which is asked one ray at a time by the arbiter's formulas.
    Other,
    /// An intersection or a difference of shapes.
    Csg,
}

/// All kinds.
pub const KINDS: [Kind; 9] = [
    Kind::Sphere,
    Kind::Cuboid,
    Kind::Plane,
    Kind::HalfSpace,
    Kind::Rectangle,
    Kind::Quadric,
    Kind::Triangle,
    Kind::Other,
    Kind::Csg,
];

/// What a kind needs besides its numbers.
#[derive(Debug, Clone)]
pub enum Form {
    /// The numbers say all, or the shape has no lanes.
    Plain,
    Quadric(Box<Quadric>),
    /// The vertices of a triangle.
    Triangle(Box<[Vec3; 3]>),
}

/// A shape of the scene, and what it is made of.
#[derive(Debug, Clone)]
pub struct Leaf {
    pub kind: Kind,
    /// The parameters of its kind: see [`Kind`].
    pub numbers: [f64; 8],
    pub form: Form,
    /// Index into [`Graph::primitives`](crate::trace::graph::Graph::primitives), or into
    /// [`Stage::csgs`](super::stage::Stage::csgs).
    pub primitive: u32,
    /// Index into [`Stage::chains`](super::stage::Stage::chains).
    pub chain: u32,
    /// For a leaf with lanes, the only placement of its chain: an index into
    /// [`Graph::placements`](crate::trace::graph::Graph::placements). 0 if its numbers are in the scene's space.
    pub placement: u32,
    /// The leaf whose boundary this surface belongs to: itself, or the intersection that has this leaf as an operand.
    pub solid: u32,
    /// For an operand of an intersection, the index of its gate there: see [`Gate`](super::expand::Gate).
    pub gate: u32,
    /// For an operand of an intersection, whether it is a cut of its gate.
    pub is_cut: bool,
    /// The number of the first leaf with the same shape and chain of placements: copies in one place share it.
    pub twin: u32,
    /// See [`Graph::extents`](crate::trace::graph::Graph::extents).
    pub extent: f64,
    /// The place of the leaf in the order of the scene's union. Of two solids the one with the lower number owns the
    /// points that both hold.
    pub operand: u32,
    /// Whether it has an inside.
    pub is_solid: bool,
    pub is_convex: bool,
    pub look: Arc<Look>,
    /// Whether some light goes through the leaf.
    pub is_clear: bool,
    /// For a transparent leaf, whether no other leaf is near it. For an opaque leaf, whether no transparent leaf is
    /// near it, and it is not hidden in an opaque leaf that is near a transparent one. So a ray in lone glass meets the
    /// other side next, and light gets to a lone opaque leaf only through the open.
    pub is_lone: bool,
}

impl Leaf {
    /// The first three of its numbers.
    #[inline(always)]
    pub fn first(&self) -> &[f64; 3] {
        three(&self.numbers, 0)
    }

    /// The form of a convex solid of second degree; `None` for other kinds.
    #[inline(always)]
    pub fn quadric(&self) -> Option<&Quadric> {
        match &self.form {
            Form::Quadric(quadric) => Some(quadric),
            Form::Plain | Form::Triangle(_) => None,
        }
    }

    /// The vertices of a triangle; zeros for other kinds.
    #[inline(always)]
    pub fn corners(&self) -> &[Vec3; 3] {
        match &self.form {
            Form::Triangle(corners) => corners,
            Form::Plain | Form::Quadric(_) => &[Vec3::ZERO; 3],
        }
    }

    /// Whether light that meets it gets no farther: it is opaque, and nothing transparent is near it.
    #[inline(always)]
    pub fn is_dark(&self) -> bool {
        self.is_lone && !self.is_clear
    }

    /// The upper corner of a box.
    #[inline(always)]
    pub fn upper(&self) -> &[f64; 3] {
        three(&self.numbers, 3)
    }

    /// The normal of a plane, whose greatest component is between 1 and 2.
    #[inline(always)]
    pub fn unit(&self) -> &[f64; 3] {
        three(&self.numbers, 4)
    }
}

/// Three of the numbers, from index `from` on.
#[inline(always)]
fn three(numbers: &[f64; 8], from: usize) -> &[f64; 3] {
    numbers[from..].first_chunk().unwrap_or(&[0.0; 3])
}

/// Numbers of a shape with lanes are between this and its reciprocal, or zero.
const LEAST: f64 = 1e-30;
/// Maps that stretch by more than this along one axis, compared with another, are not for lanes.
const STRETCH: f64 = 100.0;

/// The kind, the numbers and the form of a shape that has lanes; `None` for other shapes and for unusual numbers.
pub fn with_lanes(primitive: &Primitive, is_clear: bool) -> Option<(Kind, [f64; 8], Form)> {
    let (kind, numbers, sizes) = match primitive {
        Primitive::Sphere(sphere) => {
            let ([x, y, z], r) = sphere.numbers();
            (Kind::Sphere, [x, y, z, r, 0.0, 0.0, 0.0, 0.0], vec![r])
        }
        Primitive::Cuboid(cuboid) => {
            let [min, max] = cuboid.corners();
            let sizes = (0..3).map(|i| max[i] - min[i]).collect();
            let ([a, b, c], [x, y, z]) = (min, max);
            (Kind::Cuboid, [a, b, c, x, y, z, 0.0, 0.0], sizes)
        }
        Primitive::Rectangle(rectangle) => {
            let [[a, b], [x, y]] = rectangle.corners();
            let numbers = [a, b, x, y, 0.0, 0.0, 0.0, 0.0];
            (Kind::Rectangle, numbers, vec![x - a, y - b])
        }
        Primitive::Plane(plane) => (Kind::Plane, of_plane(plane.abcd()), Vec::new()),
        // A ray in a transparent half-space may find no way out.
        Primitive::HalfSpace(solid) if !is_clear => {
            (Kind::HalfSpace, of_plane(solid.abcd()), Vec::new())
        }
        Primitive::Triangle(triangle) => return of_triangle(triangle),
        _ => return None,
    };
    let usual = |x: &f64| (LEAST..LEAST.recip()).contains(x);
    let are_usual = numbers.iter().all(|&x| x == 0.0 || usual(&x.abs()));
    (are_usual && sizes.iter().all(usual)).then_some((kind, numbers, Form::Plain))
}

/// The least and the greatest width of a triangle that has lanes.
const WIDTHS: [f64; 2] = [1e-6, 1e6];
/// The most times that the square of the width may exceed twice the area of a triangle that has lanes.
const MAX_STRETCH: f64 = 1e4;

/// The kind, the numbers and the form of a triangle: see [`Kind::Triangle`]. `None` for unusual triangles.
pub fn of_triangle(triangle: &Triangle) -> Option<(Kind, [f64; 8], Form)> {
    let [a, b, c] = triangle.vertices();
    let Vec3([x, y, z]) = triangle.normal()?;
    let (ab, ac) = (b - a, c - a);
    let largest = |vectors: &[Vec3]| {
        let sizes = vectors.iter().map(|v| v.abs().max_component());
        sizes.fold(0.0, f64::max)
    };
    let (width, extent) = (largest(&[ab, ac]), largest(&[a, b, c]));
    let cross = ab.cross(ac);
    let stretch = width * width / cross.dot(cross).sqrt();
    let is_usual = (WIDTHS[0]..WIDTHS[1]).contains(&width) && stretch <= MAX_STRETCH;
    let numbers = [x, y, z, stretch, width, extent, 0.0, 0.0];
    is_usual.then(|| (Kind::Triangle, numbers, Form::Triangle(Box::new([a, b, c]))))
}

/// A convex solid of second degree below a chain of placements, with its numbers and its extent. `None` for other
/// shapes and for unusual numbers.
pub fn quadric(
    graph: &Graph,
    chain: &[u32],
    primitive: &Primitive,
) -> Option<(Box<Quadric>, [f64; 8], f64)> {
    let shape = primitive.shape();
    let piece = shape.convex_piece()?;
    let way = WayIn::new(graph, chain);
    let (out, back) = (way.back.inverse()?, way.back);
    let mut quadric = Quadric::new(&piece, &shape.bounds(), way)?;
    quadric.axial = Axial::new(primitive);
    let [extent, stretch] = quadric.extent(&out);
    let Vec3([x, y, z]) = quadric.across();
    let numbers = [x, y, z, stretch, 0.0, 0.0, 0.0, 0.0];
    is_usual(&Placement { out, back }).then(|| (Box::new(quadric), numbers, extent))
}

/// The numbers of a plane: a, b, c and d as written, and the four scaled by a power of two: see [`Kind::Plane`].
fn of_plane([a, b, c, d]: [f64; 4]) -> [f64; 8] {
    let steep = exponent(a.abs().max(b.abs()).max(c.abs()));
    let [x, y, z, w] = [a, b, c, d].map(|number| shifted(number, -steep));
    [a, b, c, d, x, y, z, w]
}

/// Whether a map stretches along no axis much more than along another, and makes no number unusually large.
pub fn is_usual(placement: &Placement) -> bool {
    let spread = |map: &Affine| {
        let rows = map.rows.map(|row| row.abs().dot(Vec3::ONE));
        rows[0].max(rows[1]).max(rows[2])
    };
    let [out, back] = [&placement.out, &placement.back].map(spread);
    let sizes = [out, back].into_iter().chain(placement.out.offset.abs().0);
    out * back <= STRETCH && sizes.into_iter().all(|x| x <= LEAST.recip().sqrt())
}
