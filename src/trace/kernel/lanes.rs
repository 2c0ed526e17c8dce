//! Four doubles at once. Each lane has the bits that the same operations give one double at a time.

use crate::geometry::vec::Vec3;
use std::ops::{Add, Div, Mul, Neg, Sub};
pub use wide::f64x4 as Lanes;

/// A double, or a double in each lane.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn splat(x: f64) -> Self;

    /// The number as lanes: a double is put in all four.
    fn wide(self) -> Lanes;

    fn abs(self) -> Self;

    /// The lesser of two numbers; neither may be NaN.
    fn lesser(self, other: Self) -> Self;

    /// The greater of two numbers; neither may be NaN.
    fn greater(self, other: Self) -> Self;

    /// Selects `then` where this is less than `than`, and `or` elsewhere.
    fn if_less(self, than: Self, then: Self, or: Self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn splat(x: f64) -> f64 {
        x
    }

    #[inline(always)]
    fn wide(self) -> Lanes {
        Lanes::splat(self)
    }

    #[inline(always)]
    fn abs(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn lesser(self, other: f64) -> f64 {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn greater(self, other: f64) -> f64 {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn if_less(self, than: f64, then: f64, or: f64) -> f64 {
        if self < than { then } else { or }
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn splat(x: f64) -> Lanes {
        Lanes::splat(x)
    }

    #[inline(always)]
    fn wide(self) -> Lanes {
        self
    }

    #[inline(always)]
    fn abs(self) -> Lanes {
        Lanes::abs(self)
    }

    #[inline(always)]
    fn lesser(self, other: Lanes) -> Lanes {
        self.fast_min(other)
    }

    #[inline(always)]
    fn greater(self, other: Lanes) -> Lanes {
        self.fast_max(other)
    }

    #[inline(always)]
    fn if_less(self, than: Lanes, then: Lanes, or: Lanes) -> Lanes {
        either(is_less(self, than), then, or)
    }
}

/// The number of lanes.
pub const LANES: usize = 4;
/// All lanes, as bits.
pub const ALL: u32 = (1 << LANES) - 1;

/// Packs a number of each of four things into lanes.
#[inline(always)]
pub fn gathered<T>(of: [&T; LANES], number: impl Fn(&T) -> f64) -> Lanes {
    let [a, b, c, d] = of;
    Lanes::new([number(a), number(b), number(c), number(d)])
}

#[inline(always)]
pub fn is_less(a: Lanes, b: Lanes) -> Lanes {
    a.simd_lt(b)
}

#[inline(always)]
pub fn is_greater(a: Lanes, b: Lanes) -> Lanes {
    a.simd_gt(b)
}

#[inline(always)]
pub fn is_at_most(a: Lanes, b: Lanes) -> Lanes {
    a.simd_le(b)
}

/// The lanes for which `holds` is true, as bits.
#[inline(always)]
pub fn lanes_where(holds: impl Fn(usize) -> bool) -> u32 {
    (0..LANES).fold(0, |bits, lane| bits | u32::from(holds(lane)) << lane)
}

/// The mask of a set of lanes: all bits of a lane are set if its bit is set in `bits`, and none otherwise.
#[inline(always)]
pub fn mask(bits: u32) -> Lanes {
    MASKS[(bits & ALL) as usize]
}

/// The masks of all sets of lanes.
const MASKS: [Lanes; 1 << LANES] = {
    let mut masks = [Lanes::ZERO; 1 << LANES];
    let mut bits = 0;
    while bits < masks.len() {
        let mut lanes = [0.0; LANES];
        let mut lane = 0;
        while lane < LANES {
            lanes[lane] = f64::from_bits(((bits >> lane & 1) as u64).wrapping_neg());
            lane += 1;
        }
        masks[bits] = Lanes::new(lanes);
        bits += 1;
    }
    masks
};

/// The lanes of `a` where the mask is set, and else those of `b`.
#[inline(always)]
pub fn either(mask: Lanes, a: Lanes, b: Lanes) -> Lanes {
    mask.select(a, b)
}

/// a · b + c, rounded once on every machine.
#[inline(always)]
pub fn fused(a: Lanes, b: Lanes, c: Lanes) -> Lanes {
    if cfg!(target_feature = "fma") {
        return a.mul_add(b, c);
    }
    let (a, b, c) = (a.to_array(), b.to_array(), c.to_array());
    let lane = |i: usize| a[i].mul_add(b[i], c[i]);
    Lanes::new([lane(0), lane(1), lane(2), lane(3)])
}

/// Four vectors.
#[derive(Debug, Clone, Copy)]
pub struct V3(pub [Lanes; 3]);

impl V3 {
    #[inline(always)]
    pub fn splat(v: Vec3) -> V3 {
        V3([Lanes::splat(v[0]), Lanes::splat(v[1]), Lanes::splat(v[2])])
    }

    /// Packs a vector of each of four things into lanes.
    #[inline(always)]
    pub fn gathered<T>(of: [&T; LANES], vector: impl Fn(&T) -> &[f64; 3]) -> V3 {
        let [a, b, c, d] = [vector(of[0]), vector(of[1]), vector(of[2]), vector(of[3])];
        V3([
            Lanes::new([a[0], b[0], c[0], d[0]]),
            Lanes::new([a[1], b[1], c[1], d[1]]),
            Lanes::new([a[2], b[2], c[2], d[2]]),
        ])
    }

    /// The x, y and z components, each as an array of the four lanes.
    #[inline(always)]
    pub fn columns(self) -> [[f64; LANES]; 3] {
        [
            self.0[0].to_array(),
            self.0[1].to_array(),
            self.0[2].to_array(),
        ]
    }

    #[inline(always)]
    pub fn either(mask: Lanes, a: V3, b: V3) -> V3 {
        V3([
            either(mask, a.0[0], b.0[0]),
            either(mask, a.0[1], b.0[1]),
            either(mask, a.0[2], b.0[2]),
        ])
    }

    #[inline(always)]
    pub fn dot(self, other: V3) -> Lanes {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    #[inline(always)]
    pub fn cross(self, other: V3) -> V3 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        V3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The product, component by component.
    #[inline(always)]
    pub fn times(self, other: V3) -> V3 {
        V3([
            self.0[0] * other.0[0],
            self.0[1] * other.0[1],
            self.0[2] * other.0[2],
        ])
    }

    #[inline(always)]
    pub fn over(self, by: Lanes) -> V3 {
        V3([self.0[0] / by, self.0[1] / by, self.0[2] / by])
    }

    #[inline(always)]
    pub fn abs(self) -> V3 {
        V3([self.0[0].abs(), self.0[1].abs(), self.0[2].abs()])
    }

    /// The greatest component; no component may be NaN.
    #[inline(always)]
    pub fn max_component(self) -> Lanes {
        self.0[0].fast_max(self.0[1]).fast_max(self.0[2])
    }

    /// The least component; no component may be NaN.
    #[inline(always)]
    pub fn min_component(self) -> Lanes {
        self.0[0].fast_min(self.0[1]).fast_min(self.0[2])
    }

    /// The vectors scaled to length 1; NaN for vectors of length 0.
    #[inline(always)]
    pub fn unit(self) -> V3 {
        let v = self.over(self.abs().max_component());
        v.over(v.dot(v).sqrt())
    }

    /// The lanes in which some component differs from zero, as bits.
    #[inline(always)]
    pub fn any(self) -> u32 {
        let is_zero = |x: Lanes| is_at_most(x.abs(), Lanes::ZERO);
        !(is_zero(self.0[0]) & is_zero(self.0[1]) & is_zero(self.0[2])).to_bitmask() & ALL
    }
}

impl Add for V3 {
    type Output = V3;
    #[inline(always)]
    fn add(self, other: V3) -> V3 {
        V3([
            self.0[0] + other.0[0],
            self.0[1] + other.0[1],
            self.0[2] + other.0[2],
        ])
    }
}

impl Sub for V3 {
    type Output = V3;
    #[inline(always)]
    fn sub(self, other: V3) -> V3 {
        V3([
            self.0[0] - other.0[0],
            self.0[1] - other.0[1],
            self.0[2] - other.0[2],
        ])
    }
}

impl Mul<Lanes> for V3 {
    type Output = V3;
    #[inline(always)]
    fn mul(self, by: Lanes) -> V3 {
        V3([self.0[0] * by, self.0[1] * by, self.0[2] * by])
    }
}

impl Neg for V3 {
    type Output = V3;
    #[inline(always)]
    fn neg(self) -> V3 {
        V3([-self.0[0], -self.0[1], -self.0[2]])
    }
}
