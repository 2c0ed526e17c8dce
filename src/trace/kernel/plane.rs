//! Planes and half-spaces: where a line meets several of them, and where each of several lines meets its own, computed
//! as in [`shapes::plane`](crate::trace::shapes).

use super::lanes::{
    ALL, LANES, Lanes, Number, V3, either, gathered, is_at_most, is_greater, is_less, mask,
};
use super::leaf::Leaf;
use super::probe::{Chords, Probe};
use super::resolved::{Meet, Resolved};
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};

/// Up to four planes, or faces of half-spaces.
#[derive(Debug, Clone)]
pub struct Planes {
    normal: [Lanes; 3],
    d: Lanes,
    /// The lanes with half-spaces, as bits.
    solid: u32,
    /// The lanes with a plane or a half-space, as bits.
    present: u32,
}

/// A line is in doubt if it is nearly parallel to a plane: its slope against the plane is at most this share of the
/// sizes of the slope's terms.
const RIM: f64 = 1e-10;

impl Planes {
    /// Packs up to four planes ax + by + cz + d = 0. The flag is true for the face of a half-space, false for a plane
    /// without an inside.
    pub fn new(planes: &[([f64; 4], bool)]) -> Planes {
        let column = |i: usize| {
            let number = |k: usize| planes.get(k).map_or(1.0, |p| p.0[i]);
            Lanes::new([number(0), number(1), number(2), number(3)])
        };
        let solid = (0..).zip(planes).map(|(k, p)| u32::from(p.1) << k);
        Planes {
            normal: [column(0), column(1), column(2)],
            d: column(3),
            solid: solid.sum(),
            present: (1 << planes.len()) - 1,
        }
    }

    /// One plane or half-space in all four lanes.
    #[inline(always)]
    pub fn of_one(leaf: &Leaf) -> Planes {
        let [a, b, c, d, ..] = leaf.numbers;
        Planes {
            normal: [a, b, c].map(Lanes::splat),
            d: Lanes::splat(d),
            solid: if leaf.is_solid { ALL } else { 0 },
            present: ALL,
        }
    }

    /// The chords of the planes and half-spaces that lines may meet after t = `from` and before t = `to`.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let (zero, infinity) = (Lanes::ZERO, splat(f64::INFINITY));
        let (mut slope, mut steep) = (zero, zero);
        let (mut value, mut size) = (self.d, self.d.abs());
        for i in 0..3 {
            let step = self.normal[i] * probe.directions().0[i];
            slope += step;
            steep += step.abs();
            let term = self.normal[i] * probe.origins().0[i];
            value += term;
            size += term.abs();
        }
        let t = -(value / slope);
        let solid = mask(self.solid);
        let rises = is_greater(slope, zero);
        let near = either(solid & rises, -infinity, t);
        let far = either(solid & !rises, infinity, t);
        // A line that is exactly parallel to the plane does not meet it, nor the half-space that it is in front of.
        let still = is_at_most(steep, zero) & (is_greater(value, splat(RIM) * size) | !solid);
        let still = still & !is_greater(probe.slack.wide(), zero);
        let flat = !is_greater(slope.abs(), splat(RIM) * steep);
        let ahead = is_greater(far, from) & is_less(near, to);
        Chords {
            maybe: (ahead | flat).to_bitmask() & self.present & !still.to_bitmask(),
            sure: !flat.to_bitmask(),
            near,
            far,
        }
    }
}

/// Bounds on the errors of the places `t` where lines meet a plane: see
/// [`Walker::rough`](crate::trace::search::walk::Walker::rough).
#[inline(always)]
pub fn rough<N: Number>(probe: &Probe<N>, normal: [f64; 3], extent: f64, t: N) -> N {
    let [a, b, c] = normal;
    let [x, y, z] = probe.direction;
    let across = (N::splat(a) * x + N::splat(b) * y + N::splat(c) * z).abs();
    let length = 1.75 * a.abs().max(b.abs()).max(c.abs());
    let size = probe.reach + N::splat(extent) + t.abs() * probe.pace;
    N::splat(super::cuboid::SHARE * length) * size / across
}

/// Four planes: `normal` and `d` as written, `unit` and `c` scaled by a power of two: see
/// [`Kind::Plane`](super::leaf::Kind::Plane).
pub struct Plane {
    pub normal: V3,
    pub d: Lanes,
    pub unit: V3,
    pub c: Lanes,
}

/// The point where each line meets its plane.
#[inline(always)]
pub fn resolve(origin: V3, direction: V3, plane: &Plane) -> Resolved {
    let splat = Lanes::splat;
    let terms = plane.normal.times(direction);
    let slope = terms.0[0] + terms.0[1] + terms.0[2];
    let value = plane.normal.dot(origin) + plane.d;
    let t = -(value / slope);
    let p = origin + direction * t;
    let n = plane.unit;
    let square = n.dot(n);
    let point = p - n * ((n.dot(p) + plane.c) / square);
    let noise = splat(gamma(5)) * (n.abs().dot(p.abs()) + plane.c.abs()) / square;
    Resolved {
        clear: is_less(t.abs(), splat(f64::INFINITY)),
        t,
        point,
        error: n.abs() * noise + point.abs() * splat(UNIT_ROUNDOFF),
        normal: n,
    }
}

impl Meet for Planes {
    #[inline(always)]
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, _: Lanes) -> Resolved {
        let plane = Plane {
            normal: V3::gathered(leaves, Leaf::first),
            d: gathered(leaves, |leaf| leaf.numbers[3]),
            unit: V3::gathered(leaves, Leaf::unit),
            c: gathered(leaves, |leaf| leaf.numbers[7]),
        };
        resolve(origin, direction, &plane)
    }
}
