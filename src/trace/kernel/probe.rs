//! A ray as blocks of shapes see it.

use crate::geometry::affine::Affine;
use crate::geometry::array::dot;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;

/// A line from t = 0 on, with what several tests ask of it.
#[derive(Debug, Clone, Copy)]
pub struct Probe {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    /// The reciprocals of the direction.
    pub inverse: [f64; 3],
    /// The square of the direction's length, and its reciprocal.
    pub square: f64,
    pub per_square: f64,
    /// The largest component of the origin, in size.
    pub reach: f64,
    /// That of the direction, and its reciprocal.
    pub pace: f64,
    pub per_pace: f64,
    /// More than how far its points may be off along each axis, in units of the numbers behind them, because it was
    /// moved into another space; 0 where it was not.
    pub slack: f64,
}

/// More than a map rounds, as a share of the numbers behind a point.
const ROUNDED: f64 = 1e-13;

/// The largest component, in size.
#[inline(always)]
fn largest(v: [f64; 3]) -> f64 {
    let greater = |a: f64, b: f64| if a > b { a } else { b };
    greater(greater(v[0].abs(), v[1].abs()), v[2].abs())
}

impl Probe {
    /// Of no ray.
    pub const NONE: Probe = Probe {
        origin: [0.0; 3],
        direction: [0.0; 3],
        inverse: [0.0; 3],
        square: 0.0,
        per_square: 0.0,
        reach: 0.0,
        pace: 0.0,
        per_pace: 0.0,
        slack: 0.0,
    };

    #[inline(always)]
    pub fn new(line: &Line) -> Probe {
        let (origin, direction) = (line.origin.0, line.direction.0);
        let square = dot(direction, direction);
        let pace = largest(direction);
        Probe {
            origin,
            direction,
            inverse: line.inverse.0,
            square,
            per_square: 1.0 / square,
            reach: largest(origin),
            pace,
            per_pace: 1.0 / pace,
            slack: 0.0,
        }
    }

    /// The same ray in another space.
    #[inline(never)]
    pub fn through(&self, map: &Affine) -> Probe {
        let origin = Vec3(self.origin);
        let sizes = map.sizes(origin) + map.offset.abs();
        Probe {
            slack: ROUNDED * largest(sizes.0),
            ..Probe::new(&Line::new(
                map.point(origin),
                map.vector(Vec3(self.direction)),
            ))
        }
    }
}

/// Where a line goes into convex solids and out of them, lane by lane. A surface without inside is met at one place.
#[derive(Debug, Clone, Copy)]
pub struct Chords {
    /// The solids that the line may meet in the stretch that was asked for, as bits.
    pub maybe: u32,
    /// Those that it surely meets: rounding has nothing to do with it.
    pub sure: u32,
    pub near: [f64; 4],
    pub far: [f64; 4],
}

impl Chords {
    pub const NONE: Chords = Chords {
        maybe: 0,
        sure: 0,
        near: [0.0; 4],
        far: [0.0; 4],
    };
}
