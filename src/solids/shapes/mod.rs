//! The shapes, a file each: what is true of them without a ray ([`Facts`]).

mod around;
pub mod ball;
pub mod circle;
pub mod cone;
mod crossing;
pub mod cuboid;
pub mod ellipsoid;
pub mod facts;
pub mod geodesic_sphere;
pub mod half_space;
mod in_line;
pub mod lengthen;
pub mod offset;
pub mod profile;
mod quadric;
mod rectangle;
mod revolution;
pub mod sizes;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod torus;
mod triangle;

use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use facts::*;
use lengthen::Cut;
use quadric::Quadric;
use sizes::Sizes;

/// The same expression for every shape.
macro_rules! each {
    ($geometry:expr, $s:ident => $e:expr) => {
        match $geometry {
            Geometry::Revolution { profile, colours } => {
                let $s = revolution::Revolution { profile, colours };
                $e
            }
            &Geometry::Plane(abcd) => {
                let $s = half_space::HalfSpace { abcd, solid: false };
                $e
            }
            &Geometry::HalfSpace(abcd) => {
                let $s = half_space::HalfSpace { abcd, solid: true };
                $e
            }
            &Geometry::Rectangle { min, max } => {
                let $s = rectangle::Rectangle { min, max };
                $e
            }
            Geometry::Triangle { vertices, normals } => {
                let $s = triangle::Triangle {
                    vertices: **vertices,
                    normals,
                };
                $e
            }
            &Geometry::Sphere { centre, radius } => {
                let $s = sphere::Sphere { centre, radius };
                $e
            }
            &Geometry::Ellipsoid { semi_axes } => {
                let $s = ellipsoid::Ellipsoid { semi_axes };
                $e
            }
            &Geometry::Box { min, max } => {
                let $s = cuboid::Cuboid { min, max };
                $e
            }
            &Geometry::GeodesicSphere { radius, splits } => {
                let $s = geodesic_sphere::GeodesicSphere { radius, splits };
                $e
            }
            &Geometry::Torus { major, minor } => {
                let $s = torus::Torus { major, minor };
                $e
            }
            Geometry::Quadric(q) => {
                let $s = Quadric::General(q);
                $e
            }
            &Geometry::Cone { height, radius } => {
                let $s = cone::Cone {
                    height,
                    radius,
                    double: false,
                };
                $e
            }
            &Geometry::DoubleCone { height, radius } => {
                let $s = cone::Cone {
                    height,
                    radius,
                    double: true,
                };
                $e
            }
            &Geometry::ParabolicCylinder { a } => {
                let $s = Quadric::ParabolicCylinder { a };
                $e
            }
            &Geometry::HyperbolicCylinder { a, b } => {
                let $s = Quadric::HyperbolicCylinder { a, b };
                $e
            }
            &Geometry::Hyperboloid { a, b, c, sheets } => {
                let $s = Quadric::Hyperboloid { a, b, c, sheets };
                $e
            }
            &Geometry::HyperbolicParaboloid { a, b } => {
                let $s = Quadric::HyperbolicParaboloid { a, b };
                $e
            }
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

    fn hull(&self) -> Option<Vec<Vec3>> {
        each!(self, s => s.hull())
    }

    fn ball(&self) -> Option<Ball> {
        each!(self, s => s.ball())
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        each!(self, s => s.farthest(m, p))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        each!(self, s => s.support(d))
    }

    fn home(&self) -> (Vec3, f64) {
        each!(self, s => s.home())
    }

    fn place(&self) -> Option<Vec3> {
        each!(self, s => s.place())
    }

    fn sizes(&self, sizes: &mut Sizes) {
        each!(self, s => s.sizes(sizes))
    }

    fn holds(&self, p: Vec3) -> bool {
        each!(self, s => s.holds(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        each!(self, s => s.taylor(p))
    }

    fn pieces(&self) -> usize {
        each!(self, s => s.pieces())
    }

    fn faces(&self, out: &mut Faces) {
        each!(self, s => s.faces(out))
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        each!(self, s => s.quadric(part))
    }

    fn mantle(&self, part: Part) -> Option<Mantle> {
        each!(self, s => s.mantle(part))
    }

    fn samples(&self) -> Vec<Sample> {
        each!(self, s => s.samples())
    }

    fn plane(&self) -> Option<[f64; 4]> {
        each!(self, s => s.plane())
    }

    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        each!(self, s => s.flat_faces(m))
    }

    fn ends(&self, axis: usize) -> Vec<f64> {
        each!(self, s => s.ends(axis))
    }

    fn degenerate(&self) -> Option<Degenerate> {
        each!(self, s => s.degenerate())
    }

    fn crossing(&self) -> Option<Crossing> {
        each!(self, s => s.crossing())
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        each!(self, s => s.offset(by))
    }

    fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        each!(self, s => s.lengthened(longer))
    }

    fn written(&self, part: Part) -> Written {
        each!(self, s => s.written(part))
    }

    fn moved_out(&self, part: Part, share: f64, room: f64) -> Option<Vec<Moved>> {
        each!(self, s => s.moved_out(part, share, room))
    }
}
