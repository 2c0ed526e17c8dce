//! A shape of the scene as the kernel sees it.

/// Kinds of shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// x, y, z of the centre and the radius.
    Sphere,
    /// The lower corner and the upper one.
    Cuboid,
    /// a, b, c and d as written, and in units of the normal.
    Plane,
    /// The same, of what has something behind it.
    HalfSpace,
    /// The least x and y, and the greatest.
    Rectangle,
}

/// All kinds.
pub const KINDS: [Kind; 5] = [
    Kind::Sphere,
    Kind::Cuboid,
    Kind::Plane,
    Kind::HalfSpace,
    Kind::Rectangle,
];

/// A shape of the scene, and what it is made of.
#[derive(Debug, Clone)]
pub struct Leaf {
    pub kind: Kind,
    /// What makes it what it is: see [`Kind`].
    pub numbers: [f64; 8],
    /// Index into [`Graph::placements`](crate::trace::graph::Graph::placements); 0 stays where it is.
    pub placement: u32,
    /// See [`Graph::extents`](crate::trace::graph::Graph::extents).
    pub extent: f64,
    /// The share of diffuse light in the shape's colour.
    pub albedo: [f64; 3],
    pub ks: [f64; 3],
    pub kt: [f64; 3],
    /// The refractive index before the surface over the one behind it, on the way in and on the way out.
    pub ratios: [f64; 2],
    /// Whether the two are one number.
    pub is_straight: bool,
    /// Whether something goes through it.
    pub is_clear: bool,
    /// Whether no other shape is near, so that the way out of it is what comes next inside.
    pub is_lone: bool,
}

impl Leaf {
    /// The first three of its numbers.
    #[inline(always)]
    pub fn first(&self) -> &[f64; 3] {
        three(&self.numbers, 0)
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

/// Three of the numbers.
#[inline(always)]
fn three(numbers: &[f64; 8], from: usize) -> &[f64; 3] {
    numbers[from..].first_chunk().unwrap_or(&[0.0; 3])
}
