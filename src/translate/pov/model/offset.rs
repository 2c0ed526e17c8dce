//! Shapes and profiles with their sides moved outwards.

use crate::scene::Geometry;
use crate::solids::shapes::AnyShape;
use crate::solids::shapes::ball;
use crate::solids::shapes::profile::{closed, twice_area};

/// The limit on how sharp a corner of a profile may be: its tip may move at most this many times as far as its sides.
const SHARP: f64 = 16.0;

/// A profile of a surface of revolution with its sides moved outwards by `by`. `None` if a corner is too sharp, a side
/// would vanish, or the profile crosses itself before or after the move.
fn offset_profile(profile: &[[f64; 2]], by: f64) -> Option<Vec<[f64; 2]>> {
    let ring = profile.first()? == profile.last()?;
    let closed = closed(profile);
    let n = closed.len();
    if n < 3 || crosses_itself(&closed) {
        return None;
    }
    // The outside is to the right of the direction of travel if the profile runs counter-clockwise.
    let side = twice_area(&closed).signum();
    let direction = |p: [f64; 2], q: [f64; 2]| {
        let d = [q[0] - p[0], q[1] - p[1]];
        let length = d[0].hypot(d[1]);
        d.map(|x| x / length)
    };
    let normal = |p: [f64; 2], q: [f64; 2]| {
        let d = direction(p, q);
        // A piece on the axis is no side of the solid, and stays where it is.
        match p[0] == 0.0 && q[0] == 0.0 {
            true => None,
            false => Some([side * d[1], -side * d[0]]),
        }
    };
    let mut out = Vec::with_capacity(n);
    for i in 0..n {
        let [before, here, after] = [closed[(i + n - 1) % n], closed[i], closed[(i + 1) % n]];
        let step = match (normal(before, here), normal(here, after)) {
            (Some(a), Some(b)) => {
                let sum = [0, 1].map(|k| a[k] + b[k]);
                let square = (sum[0] * sum[0] + sum[1] * sum[1]) / 4.0;
                if square * SHARP * SHARP < 1.0 {
                    return None;
                }
                sum.map(|x| by * x / 2.0 / square)
            }
            // A point on the axis moves along the axis, to where the moved side meets it.
            (Some(a), None) | (None, Some(a)) => {
                if a[1].abs() * SHARP < 1.0 {
                    return None;
                }
                [0.0, by / a[1]]
            }
            (None, None) => [0.0; 2],
        };
        out.push([(here[0] + step[0]).max(0.0), here[1] + step[1]]);
    }
    // A side that is too short for the move would be reversed.
    let same_way = |i: usize| {
        let j = (i + 1) % n;
        let [d, e] =
            [[closed[i], closed[j]], [out[i], out[j]]].map(|[p, q]| [q[0] - p[0], q[1] - p[1]]);
        d[0] * e[0] + d[1] * e[1] > 0.0
    };
    if !(0..n).all(same_way) || crosses_itself(&out) {
        return None;
    }
    if ring {
        out.extend(out.first().copied());
    }
    Some(out)
}

/// Whether two sides of a polygon that are no neighbours meet.
fn crosses_itself(polygon: &[[f64; 2]]) -> bool {
    let n = polygon.len();
    let side = |i: usize| [polygon[i], polygon[(i + 1) % n]];
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let apart = |[a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]| {
        (0..2).any(|k| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]))
            || turn(a, b, c) * turn(a, b, d) > 0.0
            || turn(c, d, a) * turn(c, d, b) > 0.0
    };
    (0..n).any(|i| (i + 2..n).any(|j| (j + 1) % n != i && !apart(side(i), side(j))))
}

impl Geometry {
    /// The shape with its surface moved outwards by `by`, or inwards if `by` is negative; no part of the surface moves
    /// the other way. `None` if no shape of the language is that, or nothing would be left.
    pub fn offset(&self, by: f64) -> Option<Geometry> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                if s.double {
                    return None;
                }
                Some(Geometry::Revolution {
                    profile: offset_profile(&[[0.0, 0.0], [s.radius, s.height]], by)?,
                    colours: Vec::new(),
                })
            }
            AnyShape::Cuboid(s) => {
                let (min, max) = (s.min, s.max);
                let grown = |x: f64| x + by > x / 2.0;
                let thick = (0..3).all(|i| grown((max[i] - min[i]) / 2.0));
                thick.then(|| Geometry::Box {
                    min: min.map(|x| x - by),
                    max: max.map(|x| x + by),
                })
            }
            AnyShape::Ellipsoid(s) => {
                let [a, b, c] = s.semi_axes.map(|x| ball::grown(x, by));
                Some(Geometry::Ellipsoid {
                    semi_axes: [a?, b?, c?],
                })
            }
            AnyShape::GeodesicSphere(s) => Some(Geometry::GeodesicSphere {
                radius: ball::grown(s.radius, by)?,
                splits: s.splits,
            }),
            AnyShape::HalfSpace(s) => {
                let [a, b, c, d] = s.abcd;
                let moved = [a, b, c, d - by * a.hypot(b).hypot(c)];
                s.solid.then_some(Geometry::HalfSpace(moved))
            }
            AnyShape::Revolution(s) => Some(Geometry::Revolution {
                profile: offset_profile(s.profile, by)?,
                colours: Vec::new(),
            }),
            AnyShape::Sphere(s) => Some(Geometry::Sphere {
                centre: s.centre,
                radius: ball::grown(s.radius, by)?,
            }),
            AnyShape::Torus(s) => {
                if s.major <= s.minor {
                    return None;
                }
                Some(Geometry::Torus {
                    major: s.major,
                    minor: ball::grown(s.minor, by).filter(|r| *r < s.major)?,
                })
            }
            AnyShape::Quadric(_) | AnyShape::Rectangle(_) | AnyShape::Triangle(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn profile(points: &[[f64; 2]], by: f64) -> Option<Vec<[f64; 2]>> {
        let round = |x: f64| (x * 1e9).round() / 1e9;
        let moved = offset_profile(points, by)?;
        Some(moved.into_iter().map(|p| p.map(round)).collect())
    }

    #[test]
    fn profiles_move_side_by_side() {
        let cylinder = [[1.0, 0.0], [1.0, 2.0]];
        let smaller = vec![[0.0, 0.25], [0.75, 0.25], [0.75, 1.75], [0.0, 1.75]];
        assert_eq!(profile(&cylinder, -0.25), Some(smaller));
        let downwards = [[1.0, 2.0], [1.0, 0.0]];
        let larger = vec![[0.0, 2.25], [1.25, 2.25], [1.25, -0.25], [0.0, -0.25]];
        assert_eq!(profile(&downwards, 0.25), Some(larger));
        // A cup with walls of 1/2: 1/4 would leave nothing of them.
        let cup = [[2.0, 0.0], [2.0, 3.0], [1.5, 3.0], [1.5, 0.5], [0.0, 0.5]];
        let thinner = [
            [0.0, 0.125],
            [1.875, 0.125],
            [1.875, 2.875],
            [1.625, 2.875],
            [1.625, 0.375],
            [0.0, 0.375],
        ];
        assert_eq!(profile(&cup, -0.125), Some(thinner.to_vec()));
        assert_eq!(profile(&cup, -0.25), None);
        // A ring stays one; one that crosses itself has no inside to speak of.
        let ring = [[2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 0.0]];
        let moved = profile(&ring, 0.5).unwrap();
        assert_eq!((moved.first(), moved.len()), (moved.last(), 5));
        assert!(moved.contains(&[3.5, -0.5]) && moved.contains(&[1.5, 1.5]));
        let eight = [[1.0, 0.0], [2.0, 1.0], [1.0, 1.0], [2.0, 0.0], [1.0, 0.0]];
        assert_eq!(profile(&eight, 0.01), None);
    }

    #[test]
    fn cones_keep_their_angle() {
        // The side runs from (0, 0) to (3, 4): its normal is (4, −3)/5, and the tip goes up by 5/3.
        let cone = Geometry::Cone {
            height: 4.0,
            radius: 3.0,
        };
        let Some(Geometry::Revolution { profile, .. }) = cone.offset(-0.3) else {
            panic!()
        };
        let [tip, rim, middle] = profile[..] else {
            panic!("{profile:?}")
        };
        let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12;
        assert!(near(tip, [0.0, 0.5]), "{tip:?}");
        assert!(near(rim, [0.75 * (3.7 - 0.5), 3.7]), "{rim:?}");
        assert!(near(middle, [0.0, 3.7]), "{middle:?}");
    }
}
