//! Spheres: which of several spheres a line meets, and where each of several lines meets its sphere, computed as in
//! [`shapes::sphere`](crate::trace::shapes).

use super::lanes::{
    LANES, Lanes, Number, V3, either, fused, gathered, is_at_most, is_greater, is_less,
};
use super::leaf::Leaf;
use super::probe::{Chords, Probe};
use super::resolved::{Meet, Resolved};
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};

/// Up to four spheres.
#[derive(Debug, Clone)]
pub struct Spheres {
    centre: [Lanes; 3],
    /// Squares of the radii; a large negative number where there is no sphere.
    square: Lanes,
    radius: Lanes,
}

/// A line is in doubt if it nearly touches a sphere: the two squares that are compared differ by at most this share of
/// their sizes. Rounding changes them by far less, by a share below 2⁻⁴⁶.
const RIM: f64 = 4e-12;

impl Spheres {
    /// Packs up to four spheres: x, y and z of each centre, and then the radius.
    pub fn new(spheres: &[[f64; 4]]) -> Spheres {
        let column = |i: usize| {
            let number = |k: usize| spheres.get(k).map_or(0.0, |s| s[i]);
            Lanes::new([number(0), number(1), number(2), number(3)])
        };
        let radius = column(3);
        let square = |k: usize| spheres.get(k).map_or(-1e200, |s| s[3] * s[3]);
        Spheres {
            centre: [column(0), column(1), column(2)],
            square: Lanes::new([square(0), square(1), square(2), square(3)]),
            radius,
        }
    }

    /// One sphere in all four lanes.
    #[inline(always)]
    pub fn of_one(leaf: &Leaf) -> Spheres {
        let [x, y, z, radius, ..] = leaf.numbers;
        Spheres {
            centre: [x, y, z].map(Lanes::splat),
            square: Lanes::splat(radius * radius),
            radius: Lanes::splat(radius),
        }
    }

    /// The chords in the spheres that lines may meet after t = `from` and before t = `to`.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let f = probe.origins() - V3(self.centre);
        let b = -f.dot(probe.directions());
        let f2 = f.dot(f);
        let a = probe.square.wide();
        let discriminant = b * b - a * (f2 - self.square);
        let per_square = N::splat(RIM) * probe.square;
        let per_radius = N::splat(4.0) * probe.slack * probe.square;
        let rim = per_square.wide() * (f2 + self.square.abs()) + per_radius.wide() * self.radius;
        let met = is_greater(discriminant, -rim);
        if !met.any() {
            return Chords::NONE;
        }
        let root = discriminant.fast_max(Lanes::ZERO).sqrt();
        let (near, far) = (
            (b - root) * probe.per_square.wide(),
            (b + root) * probe.per_square.wide(),
        );
        let ahead = is_greater(far, from) & is_less(near, to);
        Chords {
            maybe: (met & ahead).to_bitmask(),
            sure: is_greater(discriminant, rim).to_bitmask(),
            near,
            far,
        }
    }
}

/// The point where each line meets its sphere: at the far end of the chord where `exit` is set, elsewhere at the near
/// end.
#[inline(always)]
pub fn resolve(origin: V3, d: V3, centre: V3, radius: Lanes, exit: Lanes) -> Resolved {
    let splat = Lanes::splat;
    let f = origin - centre;
    let a = d.dot(d);
    let b = -f.dot(d);
    let p = f + d * (b / a);
    let (p2, r2, f2) = (p.dot(p), radius * radius, f.dot(f));
    let discriminant = r2 - p2;
    // A discriminant above this is positive, whatever was rounded.
    let clear = is_greater(discriminant, splat(RIM) * (f2 + r2));

    let s = (a * discriminant).sqrt();
    let q = either(is_less(b, Lanes::ZERO), b - s, b + s);
    let plain = f2 - r2;
    let far = q / a;
    // Close to the surface the sum is done in twice the precision.
    let close = is_at_most(plain.abs(), splat(1.0 / 1024.0) * r2);
    let near = if close.any() {
        let c = either(close, closer(origin, centre, f, radius, r2), plain);
        let near = c / q;
        let two = splat(2.0);
        let step = (c - near * (two * b - a * near)) / (two * (a * near - b));
        let counts = close & is_less(step.abs(), splat(f64::INFINITY));
        either(counts, near - step, near)
    } else {
        plain / q
    };
    let (t0, t1) = (near.fast_min(far), near.fast_max(far));
    let t = either(exit, t1, t0);

    let from = f + d * t;
    let normal = from.over(from.abs().max_component());
    let length = normal.dot(normal).sqrt();
    let p = normal * (radius / length);
    let point = centre + p;
    Resolved {
        clear: clear & is_less(t0, t1),
        t,
        point,
        error: p.abs() * splat(gamma(5)) + point.abs() * splat(UNIT_ROUNDOFF),
        normal,
    }
}

/// |o − c|² − r² with the digits that f = o − c and the products lose.
#[inline(always)]
fn closer(origin: V3, centre: V3, f: V3, radius: Lanes, r2: Lanes) -> Lanes {
    let (mut sum, mut lost) = (-r2, -fused(radius, radius, -r2));
    for i in 0..3 {
        let square = f.0[i] * f.0[i];
        let square_error = fused(f.0[i], f.0[i], -square);
        let c = -centre.0[i];
        let back = f.0[i] - origin.0[i];
        let e = (origin.0[i] - (f.0[i] - back)) + (c - back);
        let next = sum + square;
        let carried = next - sum;
        lost += (sum - (next - carried))
            + (square - carried)
            + square_error
            + Lanes::splat(2.0) * f.0[i] * e;
        sum = next;
    }
    sum + lost
}

impl Meet for Spheres {
    #[inline(always)]
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, exit: Lanes) -> Resolved {
        let centre = V3::gathered(leaves, Leaf::first);
        let radius = gathered(leaves, |leaf| leaf.numbers[3]);
        resolve(origin, direction, centre, radius, exit)
    }
}
