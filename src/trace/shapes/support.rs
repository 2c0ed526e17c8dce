//! The surface in space that a face is a part of.
//!
//! Solids that fill each other, or stand on each other, have faces in one place. Where the numbers of the scene show
//! this, no ray has to be followed in double-double to find it out.

use crate::geometry::Matrix;
use crate::geometry::array::each;
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;

/// A surface without borders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Support {
    /// The plane where the coordinate along an axis is `at`.
    Level { axis: u8, at: f64 },
    /// The plane ax + by + cz + d = 0, signed so that the first nonzero number of a, b and c is positive.
    Plane([f64; 4]),
    /// The cylinder of this radius about the line along y through (x, z).
    Cylinder { axis: [f64; 2], radius: f64 },
    /// A segment turned about the line along y through (x, z). Each end is its distance from that line and its height;
    /// the lower end comes first.
    Frustum { axis: [f64; 2], ends: [[f64; 2]; 2] },
    /// The sphere of this centre and radius.
    Sphere { centre: [f64; 3], radius: f64 },
}

/// The support of a face in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// The support in the space of its shape.
    pub own: Support,
    /// A number that identifies the chain of maps from the shape's space to the scene's.
    pub chain: u64,
    /// The support in the outermost space that simple maps carry it to.
    pub carried: Support,
    /// Bound on the error of the numbers in `carried`. Maps are rounded where several records were combined into one.
    pub off: f64,
    /// A number that identifies the chain of maps from the space of `carried` to the scene's; 0 if `carried` is in the
    /// scene's space.
    pub above: u64,
}

impl Placed {
    /// A support in the space of its shape, not carried yet. `chain` identifies the maps from there to the scene's
    /// space.
    pub fn new(own: Support, chain: u64) -> Placed {
        Placed {
            own,
            chain,
            carried: own,
            off: 0.0,
            above: 0,
        }
    }

    /// Carries the support outwards by the next map, if that map and all before it are simple. Otherwise `chain` gives
    /// the number of the chain of maps that begins with the first map that is not simple.
    pub fn carry(&mut self, map: &Matrix, chain: impl FnOnce() -> u64) {
        if self.above != 0 {
            return;
        }
        match self.carried.moved(map, self.off) {
            Some(moved) => (self.carried, self.off) = moved,
            None => self.above = chain(),
        }
    }
}

/// How a line passes a support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    pub placed: Placed,
    /// Whether the line goes outwards through a curved support, which a line may cross twice; `None` for a flat one.
    pub outwards: Option<bool>,
}

impl Support {
    /// The plane ax + by + cz + d = 0.
    pub fn plane(abcd: [f64; 4]) -> Support {
        let normal = &abcd[..3];
        if let Some(axis) = (0..3).find(|&i| (0..3).all(|j| (normal[j] != 0.0) == (i == j))) {
            let at = -abcd[3] / normal[axis];
            if at.mul_add(normal[axis], abcd[3]) == 0.0 {
                let axis = axis as u8;
                return Support::Level { axis, at };
            }
        }
        let turned = normal.iter().find(|x| **x != 0.0).is_some_and(|x| *x < 0.0);
        Support::Plane(each(abcd, |x| if turned { -x } else { x }))
    }

    /// The surface that a segment between two points (x, y) becomes as it is turned about the y axis.
    pub fn turned([a, b]: [[f64; 2]; 2]) -> Support {
        let axis = [0.0; 2];
        match () {
            () if a[1] == b[1] => Support::Level { axis: 1, at: a[1] },
            () if a[0] == b[0] => Support::Cylinder { axis, radius: a[0] },
            () => Support::Frustum {
                axis,
                ends: if a[1] < b[1] { [a, b] } else { [b, a] },
            },
        }
    }

    /// The image of the support under a map, and a bound on the error of its numbers; `off` is the bound before the
    /// map. `None` if the map is not simple. A map is simple for a level if some coordinate of the image depends only on
    /// the coordinate that is constant on the level; for a curved support, if it is a translation; for any other plane,
    /// never.
    pub fn moved(self, map: &Matrix, off: f64) -> Option<(Support, f64)> {
        let rows = &map.0;
        let rounded = |size: f64| f64::EPSILON * size;
        if let Support::Level { axis, at } = self {
            // The new coordinate that depends on the level's coordinate alone.
            let from = axis as usize;
            let only = |to: &usize| (0..3).all(|j| (rows[*to][j] != 0.0) == (j == from));
            let to = (0..3).find(only)?;
            let (step, move_by) = (rows[to][from] * at, rows[to][3]);
            let (axis, at) = (to as u8, step + move_by);
            let off = off * rows[to][from].abs() + rounded(step.abs() + move_by.abs());
            return Some((Support::Level { axis, at }, off));
        }
        let kept = |i: usize, j: usize| rows[i][j] == f64::from(u8::from(i == j));
        if !(0..9).all(|k| kept(k / 3, k % 3)) {
            return None;
        }
        let [x, y, z] = each([0, 1, 2], |i| rows[i][3]);
        let sizes = |all: &[f64]| rounded(all.iter().fold(0.0, |sum, x| sum + x.abs()));
        let across = |axis: [f64; 2]| [axis[0] + x, axis[1] + z];
        Some(match self {
            Support::Level { .. } | Support::Plane(_) => return None,
            Support::Cylinder { axis, radius } => {
                let off = off + sizes(&[axis[0], axis[1], x, z]);
                let axis = across(axis);
                (Support::Cylinder { axis, radius }, off)
            }
            Support::Frustum { axis, ends: [a, b] } => {
                let off = off + sizes(&[axis[0], axis[1], a[1], b[1], x, y, z]);
                let ends = [[a[0], a[1] + y], [b[0], b[1] + y]];
                let axis = across(axis);
                (Support::Frustum { axis, ends }, off)
            }
            Support::Sphere { centre, radius } => {
                let off = off + sizes(&[centre[0], centre[1], centre[2], x, y, z]);
                let centre = [centre[0] + x, centre[1] + y, centre[2] + z];
                (Support::Sphere { centre, radius }, off)
            }
        })
    }

    /// Whether two supports are in one place. Their positions may differ by `off`; radii, and planes of any slope,
    /// have to be equal.
    pub fn is(&self, other: &Support, off: f64) -> bool {
        let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= off);
        match (self, other) {
            (Support::Level { axis: i, at }, Support::Level { axis: j, at: there }) => {
                i == j && near(&[*at], &[*there])
            }
            (Support::Plane(a), Support::Plane(b)) => a == b,
            (
                Support::Cylinder { axis, radius },
                Support::Cylinder {
                    axis: there,
                    radius: r,
                },
            ) => radius == r && near(axis, there),
            (
                Support::Frustum { axis, ends },
                Support::Frustum {
                    axis: there,
                    ends: others,
                },
            ) => near(axis, there) && in_one_line(ends, others, off),
            (
                Support::Sphere { centre, radius },
                Support::Sphere {
                    centre: there,
                    radius: r,
                },
            ) => radius == r && near(centre, there),
            _ => false,
        }
    }

    /// The normal at a point on a curved support, outwards and of any length but zero; `None` for a flat one, which no
    /// line crosses twice.
    pub fn outwards<R: Real>(&self, point: Vec3<R>) -> Option<Vec3<R>> {
        let about = |axis: [f64; 2]| {
            let out = point - Vec3::new(axis[0], 0.0, axis[1]).cast();
            Vec3::new(out[0], R::ZERO, out[2])
        };
        match *self {
            Support::Level { .. } | Support::Plane(_) => None,
            Support::Cylinder { axis, .. } => Some(about(axis)),
            Support::Frustum {
                axis,
                ends: [[r, y], [s, z]],
            } => {
                let (w, h) = (R::of(s) - R::of(r), R::of(z) - R::of(y));
                let out = about(axis).unit();
                Some(Vec3::new(out[0] * h, -w, out[2] * h))
            }
            Support::Sphere { centre, .. } => Some(point - Vec3(centre).cast()),
        }
    }
}

/// Whether two segments lie in one line, but for `off` and the rounding of their ends.
fn in_one_line(a: &[[f64; 2]; 2], b: &[[f64; 2]; 2], off: f64) -> bool {
    let step = |[p, q]: &[[f64; 2]; 2]| [q[0] - p[0], q[1] - p[1]];
    let length = |ends| {
        let [w, h] = step(ends);
        libm::hypot(w, h)
    };
    let (long, short) = if length(a) < length(b) {
        (b, a)
    } else {
        (a, b)
    };
    let ([w, h], length) = (step(long), length(long));
    let sizes = a.iter().chain(b).flatten().map(|x| x.abs());
    let digits = 4.0 * f64::EPSILON * sizes.fold(0.0, f64::max);
    short.iter().all(|p| {
        let across = (p[0] - long[0][0]) * h - (p[1] - long[0][1]) * w;
        across.abs() <= (off + digits) * length
    })
}

impl Placed {
    /// Whether two supports are in one place, as far as the numbers of the scene tell.
    pub fn is(&self, other: &Placed) -> bool {
        if self.chain == other.chain {
            // The same maps move both, so that their rounding cancels.
            return self.own.is(&other.own, 0.0);
        }
        self.above == other.above && self.carried.is(&other.carried, self.off + other.off)
    }
}

impl Passage {
    /// Whether two passages that are near each other are one crossing: through the same surface in the same direction.
    pub fn is(&self, other: &Passage) -> bool {
        self.outwards == other.outwards && self.placed.is(&other.placed)
    }

    /// The passage; with `back`, the one in the opposite direction.
    pub fn turned(self, back: bool) -> Passage {
        Passage {
            outwards: self.outwards.map(|outwards| outwards != back),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(axis: u8, at: f64) -> Support {
        Support::Level { axis, at }
    }

    #[test]
    fn planes_across_an_axis_are_levels() {
        assert_eq!(Support::plane([0.0, -2.0, 0.0, 3.0]), level(1, 1.5));
        // A third is no double.
        let third = [0.0, 3.0, 0.0, -1.0];
        assert_eq!(Support::plane(third), Support::Plane(third));
        let slanted = Support::plane([1.0, 2.0, 0.0, 3.0]);
        assert_eq!(Support::plane([-1.0, -2.0, 0.0, -3.0]), slanted);
        assert_eq!(Support::turned([[1.0, 2.0], [0.0, 2.0]]), level(1, 2.0));
    }

    #[test]
    fn levels_go_with_maps_along_the_axes() {
        let quarter = Matrix::rotation(90.0, 2);
        // x = 2 becomes y = 2.
        let (turned, off) = level(0, 2.0).moved(&quarter, 0.0).unwrap();
        assert!(turned == level(1, 2.0) && off < 1e-15);
        assert_eq!(level(0, 2.0).moved(&Matrix::rotation(30.0, 2), 0.0), None);
        // Off together with what it is scaled by.
        let (far, off) = level(2, 0.1)
            .moved(&Matrix::scaling(1.0, 1.0, -3.0), 1e-3)
            .unwrap();
        assert!(far.is(&level(2, -0.3), 1e-15) && (off - 3e-3).abs() < 1e-12);
    }

    #[test]
    fn digits_that_doubles_do_not_have() {
        let up = |y: f64| Matrix::translation(0.0, y, 0.0);
        let [(a, ea), (b, eb)] =
            [(0.5, 0.3), (0.1, 0.7)].map(|(at, y)| level(1, at).moved(&up(y), 0.0).unwrap());
        assert!(a != b && a.is(&b, ea + eb));
        assert!(!a.is(&level(1, 0.8 + 1e-14), ea));
        assert!(!a.is(&level(0, 0.8), 1.0));
    }

    #[test]
    fn segments_in_one_line() {
        let wall = Support::turned([[0.65, 1.62], [0.75, 2.6]]);
        // Halfway up, from either end.
        assert!(wall.is(&Support::turned([[0.65, 1.62], [0.7, 2.11]]), 0.0));
        assert!(Support::turned([[0.75, 2.6], [0.7, 2.11]]).is(&wall, 0.0));
        assert!(!wall.is(&Support::turned([[0.65, 1.62], [0.700001, 2.11]]), 0.0));
        let cylinder = Support::turned([[0.65, 0.0], [0.65, 1.0]]);
        assert!(cylinder.is(&Support::turned([[0.65, 5.0], [0.65, 3.0]]), 0.0));
        assert!(!cylinder.is(&wall, 1.0));
        // Beside each other.
        let (moved, off) = cylinder
            .moved(&Matrix::translation(1.0, 7.0, 0.0), 0.0)
            .unwrap();
        assert!(!cylinder.is(&moved, off));
    }

    #[test]
    fn bent_ones_know_their_outside() {
        let out = |s: &Support, p: [f64; 3], q: [f64; 3]| {
            s.outwards(Vec3(p)).is_some_and(|n| n.dot(Vec3(q)) > 0.0)
        };
        let cone = Support::turned([[2.0, 0.0], [1.0, 1.0]]);
        assert!(out(&cone, [1.5, 0.5, 0.0], [1.0, 0.9, 0.0]));
        assert!(!out(&cone, [1.5, 0.5, 0.0], [1.0, -1.1, 0.0]));
        let ball = Support::Sphere {
            centre: [1.0, 0.0, 0.0],
            radius: 1.0,
        };
        assert!(out(&ball, [0.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        assert_eq!(level(0, 1.0).outwards(Vec3::<f64>::ZERO), None);
    }
}
