//! The kernel under test, in one place.

use super::exact::Exact;
use super::lines::Case;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::line::{Line, Traced};
use zpg::internals::geometry::number::Real;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Geometry;
use zpg::internals::trace::shapes::{Primitive, Roots};

/// The kinds of numbers that lines are traced with.
pub trait Number: Traced {
    const NAME: &'static str;
    /// The machine epsilon that errors are measured in.
    const EPSILON: f64;
    /// The digits of numbers that move what is given by half a unit in the last place: ± this many
    /// below the highest one.
    const HALF_ULP: i64;

    fn exact(self) -> Exact;
}

impl Number for f32 {
    const NAME: &'static str = "f32";
    const EPSILON: f64 = f32::EPSILON as f64;
    const HALF_ULP: i64 = 24;

    fn exact(self) -> Exact {
        Exact::of(f64::from(self))
    }
}

impl Number for f64 {
    const NAME: &'static str = "f64";
    const EPSILON: f64 = f64::EPSILON;
    const HALF_ULP: i64 = 53;

    fn exact(self) -> Exact {
        Exact::of(self)
    }
}

impl Number for Dd {
    const NAME: &'static str = "dd";
    /// 2⁻¹⁰⁰, as its operations are not rounded correctly.
    const EPSILON: f64 = 1.0 / (1u128 << 100) as f64;
    const HALF_ULP: i64 = 106;

    fn exact(self) -> Exact {
        let (high, low) = self.parts();
        Exact::of(high) + Exact::of(low)
    }
}

pub fn primitive(geometry: &Geometry) -> Primitive {
    Primitive::new(geometry)
}

/// Where the line of a case crosses, by one kind of number.
pub fn crossings<R: Number>(primitive: &Primitive, case: &Case, roots: &mut Roots<R>) {
    let line = Line::new(
        Vec3(case.origin.map(R::of)),
        Vec3(case.direction.map(R::of)),
    );
    let line = match case.affine::<R>() {
        Some(map) => line.through(&map),
        None => line,
    };
    roots.clear();
    primitive.intersect::<R>().crossings(&line, roots);
    roots.doubt_blurred(&line);
}
