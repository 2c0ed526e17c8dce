//! Convex solids of second degree, with or without flat ends: roughly where a line goes into them and out of them. Each
//! solid has its own map into its space, so that solids with different placements share a test.
//!
//! Let q be the point of a line that is nearest to the middle of a solid. Along the line, from q on, the polynomial is
//! a t² + 2 b t + c. Its values are taken to be known to a margin of a millionth of the sizes of the terms
//! ([`POLYNOMIAL_MARGIN`]): far more than what is rounded, here or by the arbiter. A line is said to meet a solid if
//! the least value is below −margin. So the line passes through the surface at a slope of more than a millionth, and
//! [`BENT`](super::query::BENT) bounds the errors.

use super::lanes::{ALL, Lanes, Number, V3, either, gathered, is_at_most, is_greater, is_less};
use super::probe::{Chords, Probe};
use super::way_in::{REL_ROUNDED, WayIn};
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::Affine;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use crate::trace::shapes::convex_piece::ConvexPiece;
use crate::trace::shapes::quadric::Axial;
use crate::trace::shapes::quick_reject::{LINE_REL_ERROR, POLYNOMIAL_MARGIN};

/// A convex solid of second degree.
#[derive(Debug, Clone)]
pub struct Quadric {
    way: WayIn,
    /// The middle of the solid's bounds; zero for a solid without bounds.
    middle: Vec3,
    /// The square of the radius of a ball around the solid; infinite for a solid without bounds.
    ball: f64,
    /// The polynomial about the middle: see [`Form::Quadric`](crate::trace::shapes::outline::Form::Quadric).
    polynomial: [f64; 10],
    /// The heights of the flat ends, relative to the middle; infinite where there is no end.
    heights: [f64; 2],
    /// For a part of a cone: 1 if the part is above the apex, −1 if it is below. 1 for other solids.
    side: f64,
    /// The size of the solid, which roundings are compared with.
    reach: f64,
    /// The form that its crossings are computed from, which some quadrics have.
    pub axial: Option<Axial>,
}

/// A line is nearly along a generator of a cone, or the axis of a cylinder, if |a| is at most this share of the
/// coefficients. Only the flat ends can tell how such a line passes the solid.
const LEAST_CURVE: f64 = 1e-6;

impl Quadric {
    /// Sets up a piece with these bounds; `way` leads into its space. `None` for unusual numbers.
    pub fn new(piece: &ConvexPiece, bounds: &Aabb, way: WayIn) -> Option<Quadric> {
        let (middle, ball, reach) = match bounds.is_bounded() {
            true => {
                let radius = bounds.radius();
                let wide = 1.001 * radius;
                (Vec3(bounds.centre()), wide * wide, radius)
            }
            false => {
                // The distance at which terms of different degrees are equal in size, about.
                let size = |c: &[f64]| c.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                let c = &piece.polynomial;
                let [second, first] = [size(&c[..6]), size(&c[6..9])];
                let reach = (c[9].abs() / second).sqrt().max(first / second);
                (Vec3::ZERO, f64::INFINITY, reach)
            }
        };
        let quadric = Quadric {
            way,
            middle,
            ball,
            polynomial: about(&piece.polynomial, middle),
            heights: each(piece.heights, |y| y - middle[1]),
            side: match piece.apex {
                Some(apex)
                    if apex > piece.heights[0] + 0.5 * (piece.heights[1] - piece.heights[0]) =>
                {
                    -1.0
                }
                _ => 1.0,
            },
            reach,
            axial: None,
        };
        let are_usual = quadric.polynomial.iter().all(|x| x.is_finite());
        (are_usual && reach.is_normal() && ball > 0.0).then_some(quadric)
    }

    /// Two numbers: how far the solid reaches in the scene's space, and how much more its map stretches along one axis
    /// than along another. The map `out` leads into the scene's space.
    pub fn extent(&self, out: &Affine) -> [f64; 2] {
        let spread = |map: &Affine| {
            let sums = map.rows.map(|row| row.abs().dot(Vec3::ONE));
            sums.into_iter().fold(0.0, f64::max)
        };
        let size = out.point(self.middle).abs().max_component() + spread(out) * self.reach;
        // For a mere turn the product may be 3.
        [size, (spread(out) * spread(&self.way.back) / 3.0).max(1.0)]
    }

    /// The direction across the flat ends, in the scene's space, with a largest component of 1; zero for a solid
    /// without flat ends.
    pub fn across(&self) -> Vec3 {
        let row = self.way.back.rows[1];
        match self.heights[0].is_finite() {
            true => row / row.abs().max_component(),
            false => Vec3::ZERO,
        }
    }

    /// The sums of the sizes of the coefficients of second degree, of first degree, and of degree zero.
    fn degrees(&self) -> [f64; 3] {
        let sum = |from: usize, to: usize| self.polynomial[from..to].iter().map(|x| x.abs()).sum();
        [sum(0, 6), sum(6, 9), sum(9, 10)]
    }
}

/// Turns the coefficients of a polynomial of p into those of the same polynomial, written in p − m.
fn about(c: &[f64; 10], m: Vec3) -> [f64; 10] {
    let [xx, yy, zz, xy, xz, yz, x, y, z, one] = *c;
    let Vec3([a, b, d]) = m;
    let first = [
        x + 2.0 * xx * a + xy * b + xz * d,
        y + 2.0 * yy * b + xy * a + yz * d,
        z + 2.0 * zz * d + xz * a + yz * b,
    ];
    let value =
        one + (x + xx * a + xy * b) * a + (y + yy * b + yz * d) * b + (z + zz * d + xz * a) * d;
    let [x, y, z] = first;
    [xx, yy, zz, xy, xz, yz, x, y, z, value]
}

/// Up to four convex solids of second degree.
#[derive(Debug, Clone)]
pub struct Quadrics {
    rows: [V3; 3],
    offset: V3,
    sizes: [Lanes; 2],
    middle: V3,
    ball: Lanes,
    polynomial: [Lanes; 10],
    degrees: [Lanes; 3],
    heights: [Lanes; 2],
    side: Lanes,
    reach: Lanes,
}

impl Quadrics {
    /// Packs one to four solids. No line meets the lanes without a solid.
    pub fn new(all: &[&Quadric]) -> Quadrics {
        let at = |k: usize| all[k.min(all.len() - 1)];
        let four = [at(0), at(1), at(2), at(3)];
        let ball = |k: usize| all.get(k).map_or(-1.0, |quadric| quadric.ball);
        let degrees = each(four, Quadric::degrees);
        Quadrics {
            rows: each([0, 1, 2], |i: usize| {
                V3::gathered(four, |q| &q.way.back.rows[i].0)
            }),
            offset: V3::gathered(four, |q| &q.way.back.offset.0),
            sizes: each([0, 1], |i: usize| gathered(four, |q| q.way.sizes[i])),
            middle: V3::gathered(four, |q| &q.middle.0),
            ball: Lanes::new([ball(0), ball(1), ball(2), ball(3)]),
            polynomial: each([0, 1, 2, 3, 4, 5, 6, 7, 8, 9], |i: usize| {
                gathered(four, |q| q.polynomial[i])
            }),
            degrees: each([0, 1, 2], |i: usize| gathered(degrees.each_ref(), |d| d[i])),
            heights: each([0, 1], |i: usize| gathered(four, |q| q.heights[i])),
            side: gathered(four, |q| q.side),
            reach: gathered(four, |q| q.reach),
        }
    }

    /// The chords in the solids that lines may meet after t = `from` and before t = `to`.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let zero = Lanes::ZERO;
        let into = |v: V3| V3(each([0, 1, 2], |i: usize| self.rows[i].dot(v)));
        let o = into(probe.origins()) + self.offset - self.middle;
        let d = into(probe.directions());
        let square = d.dot(d);
        let shift = -o.dot(d) / square;
        let q = o + d * shift;
        let start = probe.reach.wide() + probe.pace.wide() * shift.abs();
        let error = splat(REL_ROUNDED)
            * (self.sizes[0] * start + self.sizes[1] + self.middle.abs().max_component());
        let is_known = is_at_most(error, splat(LINE_REL_ERROR) * self.reach);
        let beside = is_known & is_greater(q.dot(q), self.ball);
        if beside.to_bitmask() == ALL {
            return Chords::NONE;
        }
        let [xx, yy, zz, xy, xz, yz, x, y, z, one] = self.polynomial;
        let half = splat(0.5);
        // Half of the gradient of second degree, at q and along d.
        let half_gradient = |v: V3| {
            let [a, b, c] = v.0;
            V3([
                xx * a + half * (xy * b + xz * c),
                yy * b + half * (xy * a + yz * c),
                zz * c + half * (xz * a + yz * b),
            ])
        };
        let linear = V3([x, y, z]);
        let (at_q, at_d) = (half_gradient(q), half_gradient(d));
        let a = at_d.dot(d);
        let b = at_q.dot(d) + half * linear.dot(d);
        let c = at_q.dot(q) + linear.dot(q) + one;
        let discriminant = b * b - a * c;
        let root = discriminant.fast_max(zero).sqrt();
        // One root is a sum of two sizes; the other root follows from the product of both.
        let sum = either(is_less(b, zero), root - b, -root - b);
        let (one_root, other_root) = (sum / a, c / sum);
        let (low, high) = (one_root.fast_min(other_root), one_root.fast_max(other_root));
        let opens = is_less(a, zero);
        // Where the line meets both halves of a double cone, only the half with the solid counts.
        let rises = is_greater(d.0[1] * self.side, zero);
        let infinite = splat(f64::INFINITY);
        let near = either(opens, either(rises, high, -infinite), low);
        let far = either(opens, either(rises, infinite, low), high);
        let per_rise = splat(1.0) / d.0[1];
        let ends = each(self.heights, |height| (height - q.0[1]) * per_rise);
        let near = near.fast_max(ends[0].fast_min(ends[1]));
        let far = far.fast_min(ends[0].fast_max(ends[1]));
        // How far the numbers reach where the line is in the solid.
        let pace = d.abs().max_component();
        let is_bounded = is_less(self.ball, infinite);
        let reach = q.abs().max_component()
            + either(is_bounded, self.reach, (root / a).abs() * pace + self.reach);
        let [second, first, constant] = self.degrees;
        let margin = splat(POLYNOMIAL_MARGIN) * ((second * reach + first) * reach + constant);
        let told = a.abs() * margin;
        let curve = splat(LEAST_CURVE) * second * square;
        let slack = splat(POLYNOMIAL_MARGIN) * reach / pace;
        let is_curved = is_greater(a.abs(), curve);
        // Written so that NaN is neither missed nor sure.
        let crosses = is_curved & is_greater(discriminant, told);
        let mut misses = beside
            | (is_less(discriminant, -told) & is_greater(a, curve))
            | (crosses & is_greater(near - far, slack));
        let mut sure = crosses & is_greater(far - near, slack);
        let (mut near, mut far) = (near, far);
        if !is_curved.all() {
            // Along the axis of a cylinder, or a generator of a cone, the ends decide.
            let [enter, leave] = [ends[0].fast_min(ends[1]), ends[0].fast_max(ends[1])];
            let reach = q.abs().max_component() + self.reach;
            let margin =
                splat(2.0 * POLYNOMIAL_MARGIN) * ((second * reach + first) * reach + constant);
            let is_still = is_at_most(a.abs() + b.abs(), zero);
            let value = |t: Lanes| either(is_still, c, (b + b) * t + c);
            let values = [value(enter), value(leave)];
            let is_long = is_greater(leave - enter, slack);
            let [is_in, is_out] = [
                is_less(values[0].fast_max(values[1]), -margin),
                is_greater(values[0].fast_min(values[1]), margin),
            ];
            let has_ends = is_bounded | is_still;
            let straight =
                is_known & has_ends & is_less(curve, infinite) & is_at_most(a.abs(), curve);
            misses |= straight & is_out;
            let along = straight & is_in & is_long;
            (near, far) = (either(along, enter, near), either(along, leave, far));
            sure |= along;
        }
        let (near, far) = (near + shift, far + shift);
        let around = ((self.ball - q.dot(q)) / square).sqrt();
        let elsewhere = (sure & (is_less(far, from) | is_greater(near, to)))
            | is_less(shift + around, from)
            | is_greater(shift - around, to);
        let absent = is_less(self.ball, zero);
        Chords {
            maybe: ALL & !((is_known & (misses | elsewhere)) | absent).to_bitmask(),
            sure: (is_known & sure).to_bitmask(),
            near,
            far,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Matrix;
    use crate::geometry::line::Line;
    use crate::scene::Geometry;
    use crate::trace::graph::Graph;
    use crate::trace::kernel::tests::{numbers, placed_by};
    use crate::trace::shapes::{Primitive, Roots};

    fn shapes() -> Vec<Primitive> {
        let tube = [
            1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, -0.25,
        ];
        let ellipsoid = [
            2.0, 0.0, 0.0, 0.3, 0.0, 1.5, 0.4, 0.0, 0.0, 0.4, 3.0, 0.0, 0.3, 0.0, 0.0, -1.0,
        ];
        let bowl = [
            1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ];
        let turned = |a: [f64; 2], b: [f64; 2]| Geometry::Revolution {
            profile: vec![a, b],
            colours: Vec::new(),
        };
        let geometries = [
            Geometry::Quadric(Box::new(tube)),
            Geometry::Quadric(Box::new(ellipsoid)),
            Geometry::Quadric(Box::new(bowl)),
            Geometry::Ellipsoid {
                semi_axes: [0.9, 0.5, 0.2],
            },
            Geometry::Cone {
                height: 0.9,
                radius: 0.5,
            },
            Geometry::Cone {
                height: -0.4,
                radius: 0.6,
            },
            turned([0.5, -0.7], [0.5, 0.7]),
            turned([0.2, 0.9], [0.6, 0.1]),
            turned([0.1, -0.5], [0.7, 0.4]),
        ];
        geometries.iter().map(Primitive::new).collect()
    }

    /// A line from so far that rounding counts beside the size of the solid is neither missed nor sure.
    #[test]
    fn lines_from_too_far_are_not_known() {
        let shape = Primitive::new(&Geometry::Ellipsoid {
            semi_axes: [0.9, 0.5, 0.2],
        });
        let piece = shape.shape().convex_piece().expect("it is one");
        let way = WayIn::new(&Graph::default(), &[]);
        let quadric = Quadric::new(&piece, &shape.shape().bounds(), way).expect("usual numbers");
        for (distance, told) in [(1e3, true), (1e12, false)] {
            let line = Line::new(Vec3::new(5.0, 0.0, distance), Vec3::new(0.0, 0.0, -1.0));
            let found = Quadrics::new(&[&quadric]).chords(
                &Probe::new(&line),
                Lanes::ZERO,
                Lanes::splat(f64::INFINITY),
            );
            assert_eq!([found.maybe & 1 == 0, found.sure & 1 == 0], [told, true]);
        }
    }

    /// Answers about lines are what the shape itself finds, and nearly all lines get one. Lines are aimed anywhere,
    /// along axes and generators, and at points of the surface.
    #[test]
    fn lines_that_are_told_apart_are_told_right() {
        let mut number = numbers();
        for shape in shapes() {
            let (mut told, mut met, mut count) = (0, 0, 0);
            for i in 0..8_000 {
                let mut vector = || Vec3::new(number(), number(), number());
                let [o, to, x, y] = [vector() * 2.5, vector(), vector(), vector()];
                let turn = |angle: f64, axis| match i % 5 {
                    // Quarter turns leave axes along axes.
                    0 => Matrix::rotation(90.0 * (4.0 * angle).round(), axis),
                    _ => Matrix::rotation(360.0 * angle, axis),
                };
                let out = Matrix::translation(3.0 * x[0], x[1], x[2])
                    .after(&turn(y[0], i % 3))
                    .after(&turn(y[1], (i + 1) % 3))
                    .after(&Matrix::scaling(1.0, 1.5 + y[2], 1.0));
                let graph = placed_by(&out);
                let chain: &[u32] = if i % 2 == 0 { &[] } else { &[0] };
                let local = Line::new(o, (to - o) * (1.0 + x[1].abs()));
                let axis = Vec3(each([0, 1, 2], |k| f64::from(u8::from(k == i / 7 % 3))));
                let local = match i % 7 {
                    0 => Line::new(o, axis * (1.0 + x[1].abs())),
                    _ => local,
                };
                let maps = &graph.placements[0].out;
                let line = match chain.is_empty() {
                    true => local,
                    false => Line::new(maps.point(local.origin), maps.vector(local.direction)),
                };
                let piece = shape.shape().convex_piece().expect("it is one");
                let bounds = shape.shape().bounds();
                let way = WayIn::new(&graph, chain);
                let quadric = Quadric::new(&piece, &bounds, way).expect("usual numbers");
                let [from, to] = [-0.5, 1.0].map(Lanes::splat);
                let chords = Quadrics::new(&[&quadric]).chords(&Probe::new(&line), from, to);
                let (near, far) = (chords.near.to_array()[0], chords.far.to_array()[0]);
                assert_eq!(chords.maybe >> 1, 0);
                let mut roots = Roots::default();
                let own = chain
                    .iter()
                    .fold(line, |line, _| line.through(&graph.placements[0].back));
                shape.intersect::<f64>().crossings(&own, &mut roots);
                let inside = roots.inside;
                let ends = match (inside, &roots.list[..]) {
                    (false, []) => None,
                    (false, [a, b]) => Some([a.t, b.t]),
                    (false, [a]) => Some([a.t, f64::INFINITY]),
                    (true, []) => Some([f64::NEG_INFINITY, f64::INFINITY]),
                    (true, [b]) => Some([f64::NEG_INFINITY, b.t]),
                    odd => panic!("{shape:?} {odd:?}"),
                };
                count += 1;
                if chords.maybe & 1 == 0 {
                    let is_there = ends.is_some_and(|[a, b]| b > -0.5 + 1e-5 && a < 1.0 - 1e-5);
                    assert!(!is_there, "{shape:?} {line:?} {ends:?} {chords:?}");
                    told += 1;
                } else if chords.sure & 1 != 0 {
                    let [a, b] = ends.unwrap_or_else(|| panic!("{shape:?} {line:?} {chords:?}"));
                    let is_near = |x: f64, y: f64| x == y || (x - y).abs() < 1e-7 * (1.0 + x.abs());
                    assert!(
                        is_near(a, near) && is_near(b, far),
                        "{shape:?} {line:?} {ends:?} {chords:?}"
                    );
                    (told, met) = (told + 1, met + 1);
                }
            }
            // Of lines along the axis of what has no end nothing is said, but for those exactly along a tube.
            let least = if shape.shape().bounds().is_bounded() {
                99
            } else {
                95
            };
            assert!(told * 100 > count * least, "{shape:?}: {told} of {count}");
            assert!(met * 10 > count, "{shape:?}: {met} of {count}");
        }
    }
}
