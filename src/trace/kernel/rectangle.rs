//! Rectangles in the plane z = 0: which of several a line meets, and where several lines meet one each, as
//! [`shapes::rectangle`](crate::trace::shapes) computes it.

use super::lanes::{LANES, Lanes, V3, is_greater, is_less};
use super::leaf::Leaf;
use super::probe::{Chords, Probe};
use super::resolved::{Meet, Resolved};
use crate::geometry::vec::gamma;

/// Up to four rectangles.
#[derive(Debug, Clone)]
pub struct Rectangles {
    min: [Lanes; 2],
    max: [Lanes; 2],
    present: u32,
}

/// A crossing that is closer to the border than this share of the numbers behind it is in doubt.
const RIM: f64 = 1e-12;

impl Rectangles {
    /// Of the least and the greatest x and y.
    pub fn new(rectangles: &[[f64; 4]]) -> Rectangles {
        let column = |i: usize| {
            let number = |k: usize| rectangles.get(k).map_or(0.0, |r| r[i]);
            Lanes::new([number(0), number(1), number(2), number(3)])
        };
        Rectangles {
            min: [column(0), column(1)],
            max: [column(2), column(3)],
            present: (1 << rectangles.len()) - 1,
        }
    }

    /// The rectangles that a line may meet after `from` and before `to`.
    #[inline(always)]
    pub fn chords(&self, probe: &Probe, from: f64, to: f64) -> Chords {
        let splat = Lanes::splat;
        let [_, _, z] = probe.origin;
        let t = -z * probe.inverse[2];
        // A line in the plane, or nearly so, which may be elsewhere than where it is said to be.
        let is_parallel = !t.is_finite() || probe.direction[2].abs() <= RIM * probe.pace;
        if is_parallel {
            let is_apart = z.abs() > RIM * probe.reach + probe.slack && probe.direction[2] == 0.0;
            let maybe = if is_apart && probe.slack == 0.0 {
                0
            } else {
                self.present
            };
            return Chords {
                maybe,
                ..Chords::NONE
            };
        }
        if t <= from || t >= to {
            return Chords::NONE;
        }
        let (mut beside, mut within) = (Lanes::ZERO, Lanes::ZERO.simd_eq(Lanes::ZERO));
        for i in 0..2 {
            let (o, step) = (probe.origin[i], probe.direction[i] * t);
            let run = 1.0 + (probe.direction[i] * probe.inverse[2]).abs();
            let hair = splat(RIM * (o.abs() + step.abs()) + probe.slack * run);
            let p = splat(o + step);
            let (low, high) = (p - self.min[i], self.max[i] - p);
            beside = beside | is_less(low, -hair) | is_less(high, -hair);
            within = within & is_greater(low, hair) & is_greater(high, hair);
        }
        Chords {
            maybe: !beside.to_bitmask() & self.present,
            sure: within.to_bitmask(),
            near: [t; 4],
            far: [t; 4],
        }
    }
}

/// Where lines meet the plane z = 0.
#[inline(always)]
pub fn resolve(origin: V3, direction: V3) -> Resolved {
    let (zero, splat) = (Lanes::ZERO, Lanes::splat);
    let t = -origin.0[2] / direction.0[2];
    let step = direction * t;
    let mut point = origin + step;
    let mut error = origin.abs() * splat(gamma(4)) + step.abs() * splat(gamma(4));
    point.0[2] = zero;
    error.0[2] = zero;
    Resolved {
        clear: is_less(t.abs(), splat(f64::INFINITY)),
        t,
        point,
        error,
        normal: V3([zero, zero, splat(1.0)]),
    }
}

impl Meet for Rectangles {
    #[inline(always)]
    fn meet(_: [&Leaf; LANES], origin: V3, direction: V3, _: Lanes) -> Resolved {
        resolve(origin, direction)
    }
}
