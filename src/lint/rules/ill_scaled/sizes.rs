//! The lengths of a shape.

use crate::geometry::Matrix;
use crate::scene::{Geometry, Vec3};
use crate::solids::shapes::AnyShape;
use crate::solids::shapes::quadric::Quadric;

/// The ratio of the largest stretch to the smallest one above which a length is told with its axis. Lengths are told in
/// four digits; below this ratio the digits are the same for all axes.
const UNEVEN: f64 = 1.001;

/// A length of a shape, with the name that messages give it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Length {
    pub size: f64,
    pub what: &'static str,
    /// The axis of the shape that the length lies along, for messages. `None` where no axis need be told: the name
    /// tells it, or all axes are stretched alike.
    pub axis: Option<usize>,
}

/// Hands a shape's lengths, after a transformation by a matrix, to a closure.
pub(super) struct Sizes<'a> {
    pub matrix: &'a Matrix,
    /// For each axis the factor by which the matrix stretches lengths along it.
    pub stretch: [f64; 3],
    is_uneven: bool,
    take: &'a mut dyn FnMut(Length),
}

const RADIUS: &str = "its radius";

impl<'a> Sizes<'a> {
    pub(super) fn new(matrix: &'a Matrix, take: &'a mut dyn FnMut(Length)) -> Sizes<'a> {
        let m = &matrix.0;
        let stretch: [f64; 3] = std::array::from_fn(|j| m[0][j].hypot(m[1][j]).hypot(m[2][j]));
        let (least, most) = stretch
            .iter()
            .fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        Sizes {
            matrix,
            stretch,
            is_uneven: most > UNEVEN * least,
            take,
        }
    }

    /// Adds a length that is already stretched, without an axis.
    pub(super) fn add(&mut self, size: f64, what: &'static str) {
        let axis = None;
        (self.take)(Length { size, what, axis });
    }

    /// Adds a size along an axis, not stretched yet.
    pub(super) fn along(&mut self, axis: usize, size: f64, what: &'static str) {
        (self.take)(Length {
            size: size * self.stretch[axis],
            what,
            axis: self.is_uneven.then_some(axis),
        });
    }

    /// Adds a size along each axis, not stretched yet.
    pub(super) fn axes(&mut self, sizes: [f64; 3], what: [&'static str; 3]) {
        (0..3).for_each(|i| self.along(i, sizes[i], what[i]));
    }

    /// Adds a size along each axis, not stretched yet. Each name tells the axis.
    pub(super) fn named(&mut self, sizes: [f64; 3], what: [&'static str; 3]) {
        (0..3).for_each(|i| self.add(sizes[i] * self.stretch[i], what[i]));
    }
}

impl Geometry {
    /// Adds the shape's lengths after the transformation, under the names that people use.
    pub(super) fn sizes(&self, sizes: &mut Sizes) {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                sizes.axes(
                    [s.radius, s.height.abs(), s.radius],
                    [RADIUS, "its height", RADIUS],
                );
            }
            AnyShape::Cuboid(s) => {
                sizes.named(
                    std::array::from_fn(|i| s.max[i] - s.min[i]),
                    ["its width in x", "its height in y", "its depth in z"],
                );
            }
            AnyShape::Ellipsoid(s) => {
                sizes.named(
                    s.semi_axes,
                    ["its semi-axis a", "its semi-axis b", "its semi-axis c"],
                );
            }
            AnyShape::GeodesicSphere(s) => {
                sizes.axes([s.radius; 3], [RADIUS; 3]);
            }
            AnyShape::Quadric(s) => {
                const SEMI_AXES: [&str; 3] =
                    ["its semi-axis a", "its semi-axis b", "its semi-axis c"];
                let [a_axis, b_axis, _] = SEMI_AXES;
                match s {
                    Quadric::General(_) => {}
                    Quadric::ParabolicCylinder { a } => {
                        sizes.named([a, 0.0, 0.0], ["its half width a"; 3]);
                    }
                    Quadric::HyperbolicCylinder { a, b } => {
                        sizes.named([a, b, 0.0], [a_axis, b_axis, ""])
                    }
                    Quadric::Hyperboloid { a, b, c, .. } => sizes.named([a, b, c], SEMI_AXES),
                    Quadric::HyperbolicParaboloid { a, b } => {
                        sizes.named([a, 0.0, b], ["its half width a", "", "its half width b"]);
                    }
                }
            }
            AnyShape::Rectangle(s) => {
                let [width, height] = [0, 1].map(|i| s.max[i] - s.min[i]);
                sizes.named(
                    [width, height, 0.0],
                    ["its width in x", "its height in y", ""],
                );
            }
            AnyShape::Revolution(s) => {
                for axis in [0, 2] {
                    for p in s.profile {
                        sizes.along(axis, p[0], "a radius of its profile");
                    }
                    for w in s.profile.windows(2) {
                        let (dx, dy) = (
                            (w[1][0] - w[0][0]) * sizes.stretch[axis],
                            (w[1][1] - w[0][1]) * sizes.stretch[1],
                        );
                        sizes.add(dx.hypot(dy), "a piece of its profile");
                    }
                }
            }
            AnyShape::Sphere(s) => {
                sizes.axes([s.radius; 3], [RADIUS; 3]);
            }
            AnyShape::Torus(s) => {
                sizes.axes([s.major, 0.0, s.major], ["its ring's radius R"; 3]);
                sizes.axes([s.minor; 3], ["its tube's radius r"; 3]);
            }
            AnyShape::Triangle(s) => {
                let [a, b, c] = s.vertices.map(|v| sizes.matrix.point(v));
                let distance =
                    |p: [f64; 3], q: [f64; 3]| (p[0] - q[0]).hypot(p[1] - q[1]).hypot(p[2] - q[2]);
                for (p, q) in [(a, b), (b, c), (c, a)] {
                    sizes.add(distance(p, q), "an edge");
                }
            }
            AnyShape::HalfSpace(_) => {}
        }
    }

    /// A point that tells where the shape is, in its own coordinates: its centre or a vertex, or for a box and a
    /// rectangle the point nearest to the origin. `None` for planes, half-spaces and general quadrics.
    pub(super) fn place(&self) -> Option<Vec3> {
        match AnyShape::of(self) {
            AnyShape::Cone(_) => Some([0.0; 3]),
            AnyShape::Cuboid(s) => Some(std::array::from_fn(|i| 0f64.clamp(s.min[i], s.max[i]))),
            AnyShape::Ellipsoid(_) => Some([0.0; 3]),
            AnyShape::GeodesicSphere(_) => Some([0.0; 3]),
            AnyShape::Quadric(s) => match s {
                Quadric::General(_) => None,
                _ => Some([0.0; 3]),
            },
            AnyShape::Rectangle(s) => {
                let near = |i: usize| 0f64.clamp(s.min[i], s.max[i]);
                Some([near(0), near(1), 0.0])
            }
            AnyShape::Revolution(s) => s.profile.first().map(|p| [0.0, p[1], 0.0]),
            AnyShape::Sphere(s) => Some(s.centre),
            AnyShape::Torus(_) => Some([0.0; 3]),
            AnyShape::Triangle(s) => Some(s.vertices[0]),
            AnyShape::HalfSpace(_) => None,
        }
    }
}
