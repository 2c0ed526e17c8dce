//! The shapes, a file each: what is true of them without a ray ([`Facts`]).

mod around;
pub mod ball;
pub mod circle;
pub mod cone;
pub mod cuboid;
pub mod ellipsoid;
pub mod facts;
pub mod geodesic_sphere;
pub mod half_space;
pub mod profile;
pub mod quadric;
pub mod rectangle;
pub mod revolution;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod torus;
pub mod triangle;

use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::face::Faces;
use cone::Cone;
use cuboid::Cuboid;
use ellipsoid::Ellipsoid;
use facts::{Ball, Character, Facts, Support, Taylor};
use geodesic_sphere::GeodesicSphere;
use half_space::HalfSpace;
use quadric::Quadric;
use rectangle::Rectangle;
use revolution::Revolution;
use sphere::Sphere;
use torus::Torus;
use triangle::Triangle;

/// A shape with the numbers of its record, as one of the shapes that have a file here. A question that few shapes
/// answer is a match over them where it is asked, and not a part of [`Facts`].
pub enum AnyShape<'a> {
    Cone(Cone),
    Cuboid(Cuboid),
    Ellipsoid(Ellipsoid),
    GeodesicSphere(GeodesicSphere),
    HalfSpace(HalfSpace),
    Quadric(Quadric<'a>),
    Rectangle(Rectangle),
    Revolution(Revolution<'a>),
    Sphere(Sphere),
    Torus(Torus),
    Triangle(Triangle<'a>),
}

impl AnyShape<'_> {
    pub fn of(geometry: &Geometry) -> AnyShape<'_> {
        match geometry {
            Geometry::Revolution { profile, colours } => {
                AnyShape::Revolution(Revolution { profile, colours })
            }
            &Geometry::Plane(abcd) => AnyShape::HalfSpace(HalfSpace { abcd, solid: false }),
            &Geometry::HalfSpace(abcd) => AnyShape::HalfSpace(HalfSpace { abcd, solid: true }),
            &Geometry::Rectangle { min, max } => AnyShape::Rectangle(Rectangle { min, max }),
            Geometry::Triangle { vertices, normals } => AnyShape::Triangle(Triangle {
                vertices: **vertices,
                normals,
            }),
            &Geometry::Sphere { centre, radius } => AnyShape::Sphere(Sphere { centre, radius }),
            &Geometry::Ellipsoid { semi_axes } => AnyShape::Ellipsoid(Ellipsoid { semi_axes }),
            &Geometry::Box { min, max } => AnyShape::Cuboid(Cuboid { min, max }),
            &Geometry::GeodesicSphere { radius, splits } => {
                AnyShape::GeodesicSphere(GeodesicSphere { radius, splits })
            }
            &Geometry::Torus { major, minor } => AnyShape::Torus(Torus { major, minor }),
            Geometry::Quadric(q) => AnyShape::Quadric(Quadric::General(q)),
            &Geometry::Cone { height, radius } => AnyShape::Cone(Cone {
                height,
                radius,
                double: false,
            }),
            &Geometry::DoubleCone { height, radius } => AnyShape::Cone(Cone {
                height,
                radius,
                double: true,
            }),
            &Geometry::ParabolicCylinder { a } => {
                AnyShape::Quadric(Quadric::ParabolicCylinder { a })
            }
            &Geometry::HyperbolicCylinder { a, b } => {
                AnyShape::Quadric(Quadric::HyperbolicCylinder { a, b })
            }
            &Geometry::Hyperboloid { a, b, c, sheets } => {
                AnyShape::Quadric(Quadric::Hyperboloid { a, b, c, sheets })
            }
            &Geometry::HyperbolicParaboloid { a, b } => {
                AnyShape::Quadric(Quadric::HyperbolicParaboloid { a, b })
            }
        }
    }
}

/// Evaluates one expression for the shape, of whichever kind it is.
macro_rules! each {
    ($geometry:expr, $s:ident => $e:expr) => {
        match AnyShape::of($geometry) {
            AnyShape::Cone($s) => $e,
            AnyShape::Cuboid($s) => $e,
            AnyShape::Ellipsoid($s) => $e,
            AnyShape::GeodesicSphere($s) => $e,
            AnyShape::HalfSpace($s) => $e,
            AnyShape::Quadric($s) => $e,
            AnyShape::Rectangle($s) => $e,
            AnyShape::Revolution($s) => $e,
            AnyShape::Sphere($s) => $e,
            AnyShape::Torus($s) => $e,
            AnyShape::Triangle($s) => $e,
        }
    };
}

impl Facts for Geometry {
    fn character(&self) -> Character {
        each!(self, s => s.character())
    }

    fn is_convex(&self) -> bool {
        each!(self, s => s.is_convex())
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        each!(self, s => s.bounds(m))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        each!(self, s => s.support(d))
    }

    fn holds(&self, p: Vec3) -> bool {
        each!(self, s => s.holds(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        each!(self, s => s.taylor(p))
    }

    fn faces(&self, out: &mut Faces) {
        each!(self, s => s.faces(out))
    }
}

impl Geometry {
    /// The ellipsoid that the shape is, or the sphere around a geodesic sphere. `None` for other shapes.
    pub fn ball(&self) -> Option<Ball> {
        match AnyShape::of(self) {
            AnyShape::Ellipsoid(s) => Some(Ball {
                centre: [0.0; 3],
                semi_axes: s.semi_axes,
                held: 1.0,
            }),
            AnyShape::GeodesicSphere(s) => Some(Ball {
                centre: [0.0; 3],
                semi_axes: [s.radius; 3],
                held: s.held(),
            }),
            AnyShape::Sphere(s) => Some(Ball {
                centre: s.centre,
                semi_axes: [s.radius; 3],
                held: 1.0,
            }),
            AnyShape::Cone(_)
            | AnyShape::Cuboid(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Revolution(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => None,
        }
    }

    /// The number of profile points that a test of a point goes through; 0 for shapes without a profile.
    pub fn pieces(&self) -> usize {
        match AnyShape::of(self) {
            AnyShape::Revolution(s) => s.profile.len(),
            AnyShape::Cone(_)
            | AnyShape::Cuboid(_)
            | AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => 0,
        }
    }

    /// a, b, c, d of the plane that the shape is, or that bounds a half-space. `None` for other shapes.
    pub fn plane(&self) -> Option<[f64; 4]> {
        match *self {
            Geometry::Plane(abcd) | Geometry::HalfSpace(abcd) => Some(abcd),
            _ => None,
        }
    }
}
