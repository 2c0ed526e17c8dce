//! A ray as blocks of shapes see it.

use crate::geometry::array::dot;

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
}

impl Probe {
    #[inline(always)]
    pub fn new(origin: [f64; 3], direction: [f64; 3]) -> Probe {
        let square = dot(direction, direction);
        let largest = |v: [f64; 3]| {
            let greater = |a: f64, b: f64| if a > b { a } else { b };
            greater(greater(v[0].abs(), v[1].abs()), v[2].abs())
        };
        let pace = largest(direction);
        let [x, y, z] = direction;
        Probe {
            origin,
            direction,
            inverse: [1.0 / x, 1.0 / y, 1.0 / z],
            square,
            per_square: 1.0 / square,
            reach: largest(origin),
            pace,
            per_pace: 1.0 / pace,
        }
    }
}

/// Where a line goes into convex solids and out of them, lane by lane.
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
