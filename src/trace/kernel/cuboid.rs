//! Axis-aligned boxes: which of several boxes a line meets, and where each of several lines meets its box, computed as
//! in [`shapes::cuboid`](crate::trace::shapes).

use super::lanes::{ALL, LANES, Lanes, Number, V3, either, is_greater, is_less, mask};
use super::leaf::Leaf;
use super::probe::{Chords, Probe};
use super::resolved::{Meet, Resolved};
use crate::geometry::array::each;
use crate::geometry::vec::{Vec3, gamma};

/// Up to four boxes.
#[derive(Debug, Clone)]
pub struct Cuboids {
    min: [Lanes; 3],
    max: [Lanes; 3],
    /// The lanes with a box in them, as bits.
    present: u32,
}

/// A chord is in doubt if it is shorter than this share of the t of its ends. Rounding changes them by far less.
const RIM: f64 = 1e-12;

impl Cuboids {
    /// Packs up to four boxes: the lower corner of each, and then the upper corner.
    pub fn new(boxes: &[[f64; 6]]) -> Cuboids {
        let column = |i: usize| {
            let number = |k: usize| boxes.get(k).map_or(0.0, |b| b[i]);
            Lanes::new([number(0), number(1), number(2), number(3)])
        };
        Cuboids {
            min: [column(0), column(1), column(2)],
            max: [column(3), column(4), column(5)],
            present: (1 << boxes.len()) - 1,
        }
    }

    /// One box in all four lanes.
    #[inline(always)]
    pub fn of_one(leaf: &Leaf) -> Cuboids {
        Cuboids {
            min: leaf.first().map(Lanes::splat),
            max: leaf.upper().map(Lanes::splat),
            present: ALL,
        }
    }

    /// The chords in the boxes that lines may meet after t = `from` and before t = `to`.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let [x, y, z] = each(probe.inverse, N::abs);
        let steepest = x.greater(y).greater(z);
        if !is_less(steepest.wide(), splat(f64::INFINITY)).all() {
            return self.chords_along_an_axis(probe, from, to);
        }
        let (mut near, mut far) = (splat(f64::NEG_INFINITY), splat(f64::INFINITY));
        for i in 0..3 {
            let (o, inverse) = (probe.origins().0[i], probe.inverses().0[i]);
            let (a, b) = ((self.min[i] - o) * inverse, (self.max[i] - o) * inverse);
            near = near.fast_max(a.fast_min(b));
            far = far.fast_min(a.fast_max(b));
        }
        let slack = N::splat(4.0) * probe.slack * steepest;
        self.within(near, far, slack.wide(), [from, to])
    }

    /// The chords between these ends. `slack` is a bound on the errors of the ends besides rounding.
    #[inline(always)]
    fn within(&self, near: Lanes, far: Lanes, slack: Lanes, [from, to]: [Lanes; 2]) -> Chords {
        let splat = Lanes::splat;
        let rim = splat(RIM) * (near.abs() + far.abs()) + slack;
        let met = is_greater(far - near, -rim) & is_greater(far, from) & is_less(near, to);
        Chords {
            maybe: met.to_bitmask() & self.present,
            sure: is_greater(far - near, rim).to_bitmask(),
            near,
            far,
        }
    }

    /// Like [`chords`](Self::chords), for lines whose directions are zero along some axis. A box is in doubt if such a
    /// line may lie in one of its faces.
    #[cold]
    #[inline(never)]
    fn chords_along_an_axis<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let (zero, infinity) = (Lanes::ZERO, splat(f64::INFINITY));
        let (mut near, mut far) = (-infinity, infinity);
        let (mut beside, mut along, mut slack) = (0, 0, zero);
        for i in 0..3 {
            let (o, inverse) = (probe.origins().0[i], probe.inverses().0[i]);
            let (low, high) = (self.min[i] - o, self.max[i] - o);
            let moves = is_less(inverse.abs(), infinity);
            let hair =
                splat(RIM) * (self.min[i].abs() + self.max[i].abs() + o.abs()) + probe.slack.wide();
            let is_beside = is_greater(low, hair) | is_less(high, -hair);
            let is_within = is_less(low, -hair) & is_greater(high, hair);
            beside |= (is_beside & !moves).to_bitmask();
            along |= !(is_beside | is_within | moves).to_bitmask();
            let own = splat(4.0) * probe.slack.wide() * inverse.abs();
            slack = either(moves, slack.fast_max(own), slack);
            let (a, b) = (low * inverse, high * inverse);
            near = either(moves, near.fast_max(a.fast_min(b)), near);
            far = either(moves, far.fast_min(a.fast_max(b)), far);
        }
        let mut chords = self.within(near, far, slack, [from, to]);
        chords.maybe &= !beside;
        chords.sure &= !along;
        chords
    }
}

/// Bounds on the errors of the places `t` where lines meet a box, as in the arbiter's search: see
/// [`Walker::rough`](crate::trace::search::walk::Walker::rough).
#[inline(always)]
pub fn rough<N: Number>(
    probe: &Probe<N>,
    bounds: &[f64; 8],
    extent: f64,
    t: N,
    is_near: bool,
) -> N {
    let (zero, tiny) = (N::splat(0.0), N::splat(f64::MIN_POSITIVE));
    let mut speed = N::splat(f64::INFINITY);
    // The least speed across any of the faces that a line crosses at about t.
    for i in 0..3 {
        let (inverse, pace) = (probe.inverse[i], probe.direction[i].abs());
        let [low, high] = [N::splat(bounds[i]), N::splat(bounds[3 + i])];
        let [falling, rising] = if is_near { [high, low] } else { [low, high] };
        let side = inverse.if_less(zero, falling, rising);
        let at = (side - probe.origin[i]) * inverse;
        let room = N::splat(RIM) * (t.abs() + at.abs()) + tiny;
        let lesser = zero.if_less(pace, speed.lesser(pace), speed);
        speed = (at - t).abs().if_less(room, lesser, speed);
    }
    N::splat(SHARE) * (probe.reach + N::splat(extent) + t.abs() * probe.pace) / speed
}

/// The error of a crossing with a flat face, as a share of the numbers that it is computed from: a little more than in
/// [`Walker::rough`](crate::trace::search::walk::Walker::rough).
pub const SHARE: f64 = 4e-14;

/// The point where each line meets its box: at the far end of the chord where `exit` is set, elsewhere at the near end.
#[inline(always)]
pub fn resolve(origin: V3, d: V3, min: V3, max: V3, exit: Lanes) -> Resolved {
    let splat = Lanes::splat;
    let zero = Lanes::ZERO;
    let (mut near, mut far) = (splat(f64::NEG_INFINITY), splat(f64::INFINITY));
    // For each axis a mask: the lanes whose end of the chord is on a face across that axis.
    let mut entered = [zero; 3];
    let mut exited = [zero; 3];
    for i in 0..3 {
        let (o, d) = (origin.0[i], d.0[i]);
        let falls = is_less(d, zero);
        let (low, high) = ((min.0[i] - o) / d, (max.0[i] - o) / d);
        let moves = d.simd_ne(zero);
        let (a, b) = (either(falls, high, low), either(falls, low, high));
        let later = is_greater(a, near) & moves;
        let earlier = is_less(b, far) & moves;
        near = either(later, a, near);
        far = either(earlier, b, far);
        for j in 0..3 {
            let this = if i == j { mask(ALL) } else { zero };
            entered[j] = either(later, this, entered[j]);
            exited[j] = either(earlier, this, exited[j]);
        }
    }
    let t = either(exit, far, near);
    let step = d * t;
    let mut point = origin + step;
    let mut error = origin.abs() * splat(gamma(4)) + step.abs() * splat(gamma(4));
    let mut normal = V3([zero; 3]);
    for i in 0..3 {
        let across = either(exit, exited[i], entered[i]);
        // Lines that fall along the axis enter by the upper face; lines that rise leave by it.
        let upper = is_less(d.0[i], zero) ^ exit;
        let side = either(upper, max.0[i], min.0[i]);
        let p = point.0[i];
        let p = either(is_greater(min.0[i], p), min.0[i], p);
        let p = either(is_less(max.0[i], p), max.0[i], p);
        point.0[i] = either(across, side, p);
        error.0[i] = either(across, zero, error.0[i]);
        let outwards = either(upper, splat(1.0), splat(-1.0));
        normal.0[i] = either(across, outwards, zero);
    }
    let clear = is_greater(far - near, splat(RIM) * (near.abs() + far.abs()));
    Resolved {
        clear,
        t,
        point,
        error,
        normal,
    }
}

impl Meet for Cuboids {
    #[inline(always)]
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, exit: Lanes) -> Resolved {
        let min = V3::gathered(leaves, Leaf::first);
        let max = V3::gathered(leaves, Leaf::upper);
        resolve(origin, direction, min, max, exit)
    }

    fn face(normal: Vec3) -> u32 {
        let axis = (0..3).find(|&i| normal[i] != 0.0).unwrap_or(0);
        2 * axis as u32 + u32::from(normal[axis] > 0.0)
    }
}
