//! Crossings of four rays with the pieces of a solid of revolution's profile.
//!
//! A point of the profile turns about the axis in a ring. Let p be a point of the ray and d its direction, r the radius
//! of the ring and y its height above p. Then |d_y (p_x, p_z) + y (d_x, d_z)|² − (d_y r)² is negative if the ray passes
//! inside of the ring, and positive if it passes outside. If the ray passes inside of one ring and outside of the next
//! one, it crosses the piece between them. It does not cross the piece if it passes inside of both, or if the three
//! coefficients in Bernstein's basis show that it is outside all the way. `profile_cull` of `shapes::revolution` does
//! the same for one ray and four pieces.

use super::lanes::{ALL, Lanes, V3, either, is_greater, is_less};
use crate::trace::shapes::outline::ProfilePoint;
use crate::trace::shapes::quick_reject::POLYNOMIAL_MARGIN;

/// Four rays, sorted by how many pieces of a profile they cross. Each set of rays is a number of bits.
#[derive(Debug, Clone, Copy)]
pub struct Crossed {
    /// The rays that surely cross no piece before they end.
    pub none: u32,
    /// The rays that surely cross at most one piece, perhaps that one twice, however far they go.
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
    /// The rays that surely pass inside of the ring, as a mask.
    inside: Lanes,
    /// The rays that surely pass outside of the ring, as a mask.
    outside: Lanes,
    /// The rays that pass the height of the ring before they start, as a mask.
    is_before: Lanes,
    /// The rays that pass the height of the ring after they end, as a mask.
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

/// Sorts four rays from p to q by the pieces of a profile that they cross. The largest component of their direction d
/// is 1 or −1. A height within a margin of zero, in units of `reach`, may have either sign; so may a power of a point,
/// in units of the square of `reach`.
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
