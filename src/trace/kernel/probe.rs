//! Probes: rays that are set up for tests against blocks of shapes.

use super::lanes::{LANES, Lanes, Number, V3};
use super::maps::Maps;
use crate::geometry::affine::Affine;
use crate::geometry::array::{dot, each};
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;

/// A line from t = 0 on, with the numbers that several tests need; or four lines, one in each lane of the numbers.
#[derive(Debug, Clone, Copy)]
pub struct Probe<N = f64> {
    pub origin: [N; 3],
    pub direction: [N; 3],
    /// The reciprocals of the direction.
    pub inverse: [N; 3],
    /// The square of the direction's length, and its reciprocal.
    pub square: N,
    pub per_square: N,
    /// The largest component of the origin, in size.
    pub reach: N,
    /// The largest component of the direction, in size, and its reciprocal.
    pub pace: N,
    pub per_pace: N,
    /// A bound on how far points of the line may be off along each axis, since the map into this space rounds; 0 in the
    /// scene's space.
    pub slack: N,
}

/// A bound on the rounding of a map, as a share of the sizes of the terms of a point.
const ROUNDED: f64 = 1e-13;

/// The largest component, in size.
#[inline(always)]
fn largest(v: [f64; 3]) -> f64 {
    let greater = |a: f64, b: f64| if a > b { a } else { b };
    greater(greater(v[0].abs(), v[1].abs()), v[2].abs())
}

impl Probe {
    /// A probe in place of a ray.
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

impl Probe<Lanes> {
    #[inline(always)]
    pub fn of_four(origin: V3, direction: V3) -> Probe<Lanes> {
        let one = Lanes::splat(1.0);
        let square = direction.dot(direction);
        let pace = direction.abs().max_component();
        Probe {
            origin: origin.0,
            direction: direction.0,
            inverse: each(direction.0, |d| one / d),
            square,
            per_square: one / square,
            reach: origin.abs().max_component(),
            pace,
            per_pace: one / pace,
            slack: Lanes::ZERO,
        }
    }

    /// The same lines in another space.
    #[inline(always)]
    pub fn four_through(&self, map: &Affine) -> Probe<Lanes> {
        let map = Maps::gathered([map; LANES], |map| map);
        let origin = V3(self.origin);
        let sizes = map.sizes(origin.abs()) + map.offset.abs();
        Probe {
            slack: Lanes::splat(ROUNDED) * sizes.max_component(),
            ..Probe::of_four(map.point(origin), map.vector(V3(self.direction)))
        }
    }
}

impl<N: Number> Probe<N> {
    /// The origin, in all lanes.
    #[inline(always)]
    pub fn origins(&self) -> V3 {
        V3(each(self.origin, N::wide))
    }

    #[inline(always)]
    pub fn directions(&self) -> V3 {
        V3(each(self.direction, N::wide))
    }

    #[inline(always)]
    pub fn inverses(&self) -> V3 {
        V3(each(self.inverse, N::wide))
    }
}

/// Where lines go into convex solids and out of them, lane by lane. A surface without inside is met at one place.
#[derive(Debug, Clone, Copy)]
pub struct Chords {
    /// The solids that the line may meet in the stretch that was asked for, as bits.
    pub maybe: u32,
    /// The solids that the line surely meets if it may meet them, whatever is rounded, as bits.
    pub sure: u32,
    pub near: Lanes,
    pub far: Lanes,
}

impl Chords {
    pub const NONE: Chords = Chords {
        maybe: 0,
        sure: 0,
        near: Lanes::ZERO,
        far: Lanes::ZERO,
    };
}
