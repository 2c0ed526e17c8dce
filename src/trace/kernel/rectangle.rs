//! Rectangles in the plane z = 0: which of several rectangles a line meets, and where each of several lines meets its
//! own, computed as in [`shapes::rectangle`](crate::trace::shapes).

use super::lanes::{ALL, LANES, Lanes, Number, V3, is_at_most, is_greater, is_less};
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
    /// Packs up to four rectangles: the least x and y of each, and then the greatest x and y.
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

    /// One rectangle in all four lanes.
    #[inline(always)]
    pub fn of_one(leaf: &Leaf) -> Rectangles {
        let [a, b, x, y, ..] = leaf.numbers;
        Rectangles {
            min: [a, b].map(Lanes::splat),
            max: [x, y].map(Lanes::splat),
            present: ALL,
        }
    }

    /// The crossings with the rectangles that lines may meet after t = `from` and before t = `to`; near and far ends
    /// are equal.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let zero = Lanes::ZERO;
        let [dx, dy, dz] = probe.directions().0;
        let [x, y, z] = probe.origins().0;
        let per_dz = probe.inverses().0[2];
        let t = -z * per_dz;
        // A line in the plane, or nearly in it, may cross the plane far from the computed place.
        let is_parallel = !is_less(t.abs(), splat(f64::INFINITY))
            | is_at_most(dz.abs(), splat(RIM) * probe.pace.wide());
        let is_apart = is_greater(z.abs(), splat(RIM) * probe.reach.wide())
            & is_at_most(dz.abs(), zero)
            & is_at_most(probe.slack.wide(), zero);
        let ahead = is_greater(t, from) & is_less(t, to);
        let open = (is_parallel & !is_apart) | (ahead & !is_parallel);
        if !open.any() {
            return Chords::NONE;
        }
        let (mut beside, mut within) = (zero, zero.simd_eq(zero));
        for (i, (o, d)) in [(x, dx), (y, dy)].into_iter().enumerate() {
            let step = d * t;
            let run = splat(1.0) + (d * per_dz).abs();
            let hair = splat(RIM) * (o.abs() + step.abs()) + probe.slack.wide() * run;
            let p = o + step;
            let (low, high) = (p - self.min[i], self.max[i] - p);
            beside = beside | is_less(low, -hair) | is_less(high, -hair);
            within = within & is_greater(low, hair) & is_greater(high, hair);
        }
        Chords {
            maybe: (open & (is_parallel | !beside)).to_bitmask() & self.present & ALL,
            sure: (within & !is_parallel).to_bitmask(),
            near: t,
            far: t,
        }
    }
}

/// The points where lines meet the plane z = 0.
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
