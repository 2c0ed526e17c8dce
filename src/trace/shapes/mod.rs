//! The shapes: where a line crosses each of them, and the normal, the surface coordinates and the colour at the
//! crossing.
//!
//! A shape is one file here that implements [`Shape`] and [`Intersect`], one variant of [`Primitive`]
//! and one arm in each of its functions.

#[cfg(test)]
mod close_calls;
#[cfg(test)]
mod contract_tests;
pub mod convex_piece;
mod cuboid;
mod error_bound;
mod facet;
pub mod geodesic_sphere;
mod half_space;
pub mod outline;
mod plane;
mod quad_double;
pub mod quadric;
pub mod quick_reject;
#[cfg(test)]
mod quick_reject_tests;
mod rectangle;
mod revolution;
mod sphere;
pub mod support;
pub mod torus;
pub mod triangle;

use crate::geometry::aabb::Aabb;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::scene::{Geometry, Rgb};
use crate::solids::shapes::AnyShape;
use convex_piece::ConvexPiece;
use error_bound::is_final;
use outline::Outline;
use quick_reject::Pass;
use support::Support;

/// The bit that is set in a face of a surface of revolution where the outward normal is opposite to the segment's own.
/// The segment's own normal is (h, −w) if the segment rises by h over the width w, and (0, 1) if it is flat. In a
/// profile that crosses itself either side of a segment may be the outer one, in different places.
pub const FLIPPED: u32 = 1 << 31;

/// The largest displacement by maps with which a crossing is trusted, in unit roundoffs of the line's coordinates.
/// Beyond it a finer kind of number is asked. The bound for one rotation reaches 30; lines really move by a tenth of
/// their bounds.
pub const BLURRED: f64 = 32.0;

/// A crossing of a line with a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root<R = f64> {
    /// The line's parameter at the crossing; finite.
    pub t: R,
    /// The number of the part of the surface, for shapes that have several parts. Only the shape can interpret it.
    pub face: u32,
}

/// All crossings of a line with a shape, ascending in t. For a solid they alternate: the line is
/// inside before the first one exactly if `inside` says so, and changes sides at each.
#[derive(Debug, Clone, Default)]
pub struct Roots<R = f64> {
    /// Whether the line is inside the solid at t = −∞.
    pub inside: bool,
    /// Whether a decision was closer than the rounding errors behind it: the number of the crossings, or their order,
    /// may be wrong.
    pub uncertain: bool,
    /// Whether `uncertain` is set for one reason only: a crossing may be farther from the surface than 4 ε of the
    /// largest coordinate.
    pub coarse: bool,
    /// The normal of a flat face that the line lies in. Such a line does not cross the solid; but where the face of
    /// another solid lies against this face, the line may be inside the union of the two solids.
    pub along: Option<Vec3>,
    pub list: Vec<Root<R>>,
}

impl<R: Traced> Roots<R> {
    pub fn clear(&mut self) {
        self.inside = false;
        self.uncertain = false;
        self.coarse = false;
        self.along = None;
        self.list.clear();
    }

    /// Marks the crossings as uncertain if the maps into this space may have displaced the line at a crossing by more
    /// than [`BLURRED`] allows. That happens in a space that is pressed flat, where the line's direction nearly
    /// vanishes. Double-double and quad-double are never marked: there is no finer number to ask.
    #[inline]
    pub fn doubt_blurred(&mut self, line: &Line<R>) {
        let is_blurred = |root: &Root<R>| line.is_blurred_at(root.t, BLURRED);
        if !is_final::<R>() && !self.uncertain && self.list.iter().any(is_blurred) {
            (self.uncertain, self.coarse) = (true, true);
        }
    }

    /// The roots in another kind of number, rounded.
    pub fn cast<S: Traced>(&self) -> Roots<S> {
        let mut roots = Roots::default();
        roots.copy_from(self);
        roots
    }

    /// Copies roots from another kind of number, rounded; all but `coarse`.
    pub fn copy_from<S: Traced>(&mut self, other: &Roots<S>) {
        (self.inside, self.uncertain, self.along) = (other.inside, other.uncertain, other.along);
        self.list.clear();
        self.list.extend(other.list.iter().map(|root| Root {
            t: R::of_parts(root.t.parts()),
            face: root.face,
        }));
    }

    fn push(&mut self, t: R, face: u32) {
        self.list.push(Root { t, face });
    }

    /// Appends both ends of a convex solid's chord, a t and a face each. A chord of no length is a touch without an
    /// inside, and is dropped.
    fn chord(&mut self, (t0, face0): (R, u32), (t1, face1): (R, u32)) {
        if t0 < t1 && t0.is_finite() && t1.is_finite() {
            self.push(t0, face0);
            self.push(t1, face1);
        }
    }
}

/// A point on a shape's surface, in the shape's space.
#[derive(Debug, Clone, Copy)]
pub struct Located<R = f64> {
    pub point: Vec3<R>,
    /// Bounds on the error of the point, component by component: the true surface meets this box around the point.
    pub error: Vec3<R>,
    /// The geometric normal, outwards for a solid, of any length but zero.
    pub normal: Vec3<R>,
}

/// The questions that the tracer asks of a shape, with rays of one kind of number. Everything is in the shape's own
/// space; directions are of any length.
pub trait Intersect<R: Traced = f64> {
    /// Appends all crossings to the cleared `roots`.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>);

    /// Like [`crossings`](Self::crossings), for a search that needs only the first crossing clearly after the start of
    /// a ray, and all crossings before it. A crossing is clearly after the start if its t exceeds `near` by a
    /// hundredth of (|o| + extent) / |d|, where |o| and |d| are the largest components of the line's origin and
    /// direction. Later crossings may be left out.
    fn first_crossings(&self, line: &Line<R>, _near: R, roots: &mut Roots<R>) {
        self.crossings(line, roots);
    }

    /// The point and the normal at one of the line's crossings.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R>;

    /// The speed, per unit of t, at which a point of the line passes through the surface at a crossing: |n·d| with the
    /// unit normal n, or as little as half of that. `None` for shapes that curve away from all their tangents: a line
    /// that surely crosses one is never so slow that it matters.
    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        let normal = self.locate(line, root).normal;
        Some(normal.unit().dot(line.direction).abs())
    }
}

/// The questions about a shape that do not depend on the kind of number that rays are made of.
pub trait Shape {
    /// A box that holds the shape, rounded outwards.
    fn bounds(&self) -> Aabb;

    /// The largest length, in the shape's space, that a crossing is computed from, besides the numbers of the line and
    /// of the crossing itself. Infinite where that is not known.
    fn extent(&self) -> f64 {
        self.bounds().reach()
    }

    /// How a line passes the shape for t between the ends of a stretch, if that is clear by far more than any
    /// rounding. A shape that cannot tell this at less cost than finding the crossings answers [`Pass::Perhaps`].
    fn pass(&self, _line: &Line, _stretch: [f64; 2]) -> Pass {
        Pass::Perhaps
    }

    /// A simple region that contains the shape, within the shape's bounds.
    fn outline(&self) -> Outline {
        Outline::BOUNDS
    }

    /// The solid as a convex piece of a surface of second degree; `None` if it is no such solid.
    fn convex_piece(&self) -> Option<ConvexPiece> {
        None
    }

    /// Whether a line that leaves the shape at its origin, a point of the surface, may cross the surface again ahead.
    /// A `false` is as certain as [`Pass::Beside`].
    fn is_met_again(&self, _line: &Line) -> bool {
        !self.is_convex()
    }

    /// Surface coordinates of a point on the surface.
    fn uv(&self, point: Vec3, face: u32) -> [f64; 2];

    /// The normal for shading, of any length and on either side of the surface; `None` if it is the geometric normal.
    fn shading_normal(&self, _point: Vec3, _face: u32) -> Option<Vec3> {
        None
    }

    /// The colour that the shape itself gives a point; `None` if it has no colours of its own.
    fn colour(&self, _point: Vec3, _face: u32) -> Option<Rgb> {
        None
    }

    /// Whether a point of finite coordinates is in the solid or on its boundary, decided exactly on the
    /// shape's numbers: see [`Facts::holds`](crate::solids::shapes::facts::Facts::holds).
    fn holds(&self, point: Vec3) -> bool;

    /// Whether a ray that starts on the surface and goes away from the shape can never meet the shape again.
    fn is_convex(&self) -> bool;

    /// The unbounded surface that a face is a part of, for comparison with faces of other shapes; `None` for kinds of
    /// surface that are not compared.
    fn support(&self, face: u32) -> Option<Support>;

    /// Passes the numbers that define the shape to `sink`; equal shapes pass equal numbers.
    fn feed(&self, sink: &mut dyn FnMut(f64));
}

/// A shape of the language. Large shapes are boxed, so that the small ones, of which there may be millions, stay
/// small.
#[derive(Debug, Clone, PartialEq)]
pub enum Primitive {
    Revolution(Box<revolution::Revolution>),
    Plane(plane::Plane),
    HalfSpace(half_space::HalfSpace),
    Rectangle(rectangle::Rectangle),
    Triangle(Box<triangle::Triangle>),
    Sphere(sphere::Sphere),
    Ellipsoid(Box<quadric::ellipsoid::Ellipsoid>),
    Cuboid(cuboid::Cuboid),
    GeodesicSphere(Box<geodesic_sphere::GeodesicSphere>),
    Torus(torus::Torus),
    Quadric(Box<quadric::Quadric>),
    Cone(Box<quadric::cone::Cone>),
}

/// The shape in any variant, as a reference to a trait object.
macro_rules! each {
    ($primitive:expr) => {
        match $primitive {
            Primitive::Revolution(s) => &**s,
            Primitive::Plane(s) => s,
            Primitive::HalfSpace(s) => s,
            Primitive::Rectangle(s) => s,
            Primitive::Triangle(s) => &**s,
            Primitive::Sphere(s) => s,
            Primitive::Ellipsoid(s) => &**s,
            Primitive::Cuboid(s) => s,
            Primitive::GeodesicSphere(s) => &**s,
            Primitive::Torus(s) => s,
            Primitive::Quadric(s) => &**s,
            Primitive::Cone(s) => &**s,
        }
    };
}

impl Primitive {
    pub fn new(geometry: &Geometry) -> Primitive {
        match AnyShape::of(geometry) {
            AnyShape::Revolution(s) => {
                let shape = revolution::Revolution::new(s.profile, s.colours);
                Primitive::Revolution(Box::new(shape))
            }
            AnyShape::HalfSpace(s) if s.solid => {
                Primitive::HalfSpace(half_space::HalfSpace::new(s.abcd))
            }
            AnyShape::HalfSpace(s) => Primitive::Plane(plane::Plane::new(s.abcd)),
            AnyShape::Rectangle(s) => Primitive::Rectangle(rectangle::Rectangle::new(s.min, s.max)),
            AnyShape::Triangle(s) => {
                let shape = triangle::Triangle::new(s.vertices, s.normals.clone());
                Primitive::Triangle(Box::new(shape))
            }
            AnyShape::Sphere(s) => {
                Primitive::Sphere(sphere::Sphere::new(s.centre.into(), s.radius))
            }
            AnyShape::Ellipsoid(s) => {
                Primitive::Ellipsoid(Box::new(quadric::ellipsoid::Ellipsoid::new(s)))
            }
            AnyShape::Cuboid(s) => {
                Primitive::Cuboid(cuboid::Cuboid::new(s.min.into(), s.max.into()))
            }
            AnyShape::GeodesicSphere(s) => {
                let shape = geodesic_sphere::GeodesicSphere::new(s.radius, s.splits);
                Primitive::GeodesicSphere(Box::new(shape))
            }
            AnyShape::Torus(s) => Primitive::Torus(torus::Torus::new(s.major, s.minor)),
            AnyShape::Quadric(s) => {
                Primitive::Quadric(Box::new(quadric::Quadric::new(geometry, &s)))
            }
            AnyShape::Cone(s) => Primitive::Cone(Box::new(quadric::cone::Cone::new(s))),
        }
    }

    /// The shape's answers about lines in one kind of number.
    pub fn intersect<R: Traced>(&self) -> &dyn Intersect<R> {
        each!(self)
    }

    /// Whether the shape has an inside.
    pub fn is_solid(&self) -> bool {
        match self {
            Primitive::Plane(_) | Primitive::Rectangle(_) | Primitive::Triangle(_) => false,
            Primitive::Revolution(_)
            | Primitive::HalfSpace(_)
            | Primitive::Sphere(_)
            | Primitive::Ellipsoid(_)
            | Primitive::Cuboid(_)
            | Primitive::GeodesicSphere(_)
            | Primitive::Torus(_)
            | Primitive::Quadric(_)
            | Primitive::Cone(_) => true,
        }
    }

    pub fn shape(&self) -> &dyn Shape {
        each!(self)
    }
}
