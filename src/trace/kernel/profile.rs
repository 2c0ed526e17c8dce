//! Crossings of four rays with the pieces of a solid of revolution's profile.
//!
//! A ray passes the ring of a profile's point inside of it or outside: with the point p and the direction d of the ray, and
//! with the height y above p of a ring of radius r, |d_y (p_x, p_z) + y (d_x, d_z)|² − (d_y r)² is negative inside. A piece
//! between two rings that are passed on two sides is crossed. It is not crossed if the ray passes inside of both, nor if the
//! three coefficients in Bernstein's basis say that the ray is outside all the way. `profile_cull` of
//! `shapes::revolution` says the same of one ray and four pieces.

use super::lanes::{ALL, Lanes, V3, either, is_greater, is_less};
use crate::trace::shapes::outline::ProfilePoint;
use crate::trace::shapes::quick_reject::POLYNOMIAL_MARGIN;

/// Sets of four rays by how many pieces of a profile they cross, as bits.
#[derive(Debug, Clone, Copy)]
pub struct Crossed {
    /// The rays that surely cross no piece up to where they end.
    pub none: u32,
    /// The rays that surely cross no more than one, perhaps twice, however far they go.
    pub at_most_one: u32,
    /// The rays that surely cross some piece.
    pub some: u32,
}

/// A ring as four rays pass it.
#[derive(Clone, Copy)]
struct Ring {
    x: Lanes,
    z: Lanes,
    radius: Lanes,
    inside: Lanes,
    outside: Lanes,
    /// Whether it is before the rays' starts, or beyond their ends.
    is_before: Lanes,
    is_beyond: Lanes,
}

impl Ring {
    const NONE: Ring = Ring {
        x: Lanes::ZERO,
        z: Lanes::ZERO,
        radius: Lanes::ZERO,
        inside: Lanes::ZERO,
        outside: Lanes::ZERO,
        is_before: Lanes::ZERO,
        is_beyond: Lanes::ZERO,
    };
}

/// Of rays from p on, which end at q. The largest component of d is 1 or −1. Heights and powers that are nearer to zero than a margin, in
/// units of `reach` and of its square, are not told from it.
#[inline(always)]
pub fn crossed(points: &[ProfilePoint], [p, q]: [V3; 2], d: V3, reach: f64) -> Crossed {
    let splat = Lanes::splat;
    let [dx, dy, dz] = d.0;
    let [x, z] = [p.0[0] * dy - p.0[1] * dx, p.0[2] * dy - p.0[1] * dz];
    let square = dy * dy;
    let (near, never) = (splat(POLYNOMIAL_MARGIN * reach), splat(f64::INFINITY));
    let climbs = is_greater(dy, Lanes::ZERO);
    let [low, high] = [
        either(climbs, p.0[1] - near, -never),
        either(climbs, never, p.0[1] + near),
    ];
    let [bottom, top] = [
        either(climbs, -never, q.0[1] - near),
        either(climbs, q.0[1] + near, never),
    ];
    let most = splat(POLYNOMIAL_MARGIN * reach * reach);
    let least = -most;
    let none = Lanes::ZERO;
    let (mut here, mut once, mut twice, mut some) = (none, none, none, none);
    let mut a = Ring::NONE;
    for point in points {
        let (radius, height) = (splat(point.radius), splat(point.height));
        let (x, z) = (x + height * dx, z + height * dz);
        let power = x * x + z * z - square * (radius * radius);
        let b = Ring {
            x,
            z,
            radius,
            inside: is_less(power, least),
            outside: is_greater(power, most),
            is_before: is_less(height, low) | is_greater(height, high),
            is_beyond: is_less(height, bottom) | is_greater(height, top),
        };
        if point.is_joined {
            let between = a.x * b.x + a.z * b.z - square * (a.radius * b.radius);
            let is_missed = (a.outside & b.outside & is_greater(between, most))
                | (a.inside & b.inside)
                | (a.is_before & b.is_before);
            let met = !is_missed;
            here |= met & !(a.is_beyond & b.is_beyond);
            twice |= once & met;
            once |= met;
            some |= (a.inside & b.outside) | (a.outside & b.inside);
        }
        a = b;
    }
    Crossed {
        none: !here.to_bitmask() & ALL,
        at_most_one: !twice.to_bitmask() & ALL,
        some: some.to_bitmask() & ALL,
    }
}
