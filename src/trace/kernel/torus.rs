//! Solves a torus for four rays: the first places where they meet it, the same numbers as [`Torus`] computes, in the
//! same order.
//!
//! Hard rays count as unknown and are left to the torus itself: rays that nearly touch it, rays that may start in it or
//! close to it, and all rays to a torus that runs through itself. Unknown is not in doubt: the torus itself may be sure.

use super::chain::Local;
use super::lanes::{Lanes, V3, either, fused, is_at_most, is_greater, is_less, mask};
use crate::geometry::array::each;
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};
use crate::trace::shapes::quick_reject::LINE_REL_ERROR;
use crate::trace::shapes::torus::{MOST_ERROR, Torus};

/// The first places where four rays meet a torus.
pub struct First {
    /// The rays whose answer is known, as bits.
    pub known: u32,
    /// The known rays that meet the torus, as bits.
    pub met: u32,
    pub t: Lanes,
}

/// The least size of a direction's largest component; its reciprocal is the greatest. Other rays count as unknown.
const LEAST_DIRECTION: f64 = 1e-100;
/// The most steps of Newton's method or of bisection. A ray that needs more counts as unknown.
const MAX_STEPS: usize = 40;

/// Four polynomials c₄t⁴ + c₃t³ + c₂t² + c₁t + c₀, with c₄ first in the array.
struct Quartics([Lanes; 5]);

impl Quartics {
    /// The values at t, and the slopes.
    #[inline(always)]
    fn at(&self, t: Lanes) -> (Lanes, Lanes) {
        let [a, b, c, d, e] = self.0;
        let p = fused(a, t, b);
        let q = fused(a, t, p);
        let p = fused(p, t, c);
        let q = fused(q, t, p);
        let p = fused(p, t, d);
        let q = fused(q, t, p);
        (fused(p, t, e), q)
    }

    /// The slopes at t, and the second derivatives. a, b and c are the first three coefficients of the slope.
    #[inline(always)]
    fn slope_at(&self, [a, b, c]: [Lanes; 3], t: Lanes) -> (Lanes, Lanes) {
        let p = fused(a, t, b);
        let q = fused(a, t, p);
        let p = fused(p, t, c);
        (fused(p, t, self.0[3]), fused(q, t, p))
    }
}

/// A torus and four lines, in units in which the greater radius lies in [1, 2).
struct Scaled {
    major: f64,
    minor: f64,
    /// The point of each line that is nearest to the centre, where t is 0.
    near: V3,
    direction: V3,
    /// A bound on the errors of the points.
    error: Lanes,
}

impl Scaled {
    /// The points of the lines at t, and their distances from the axis.
    #[inline(always)]
    fn at(&self, t: Lanes) -> (V3, Lanes) {
        let (d, p) = (self.direction.0, self.near.0);
        let point = V3(each([0, 1, 2], |i: usize| fused(d[i], t, p[i])));
        let [x, _, z] = point.0;
        (point, (x * x + z * z).sqrt())
    }

    /// (ρ − R)² + y² − r² at t, where ρ is the distance from the axis, and its slope.
    #[inline(always)]
    fn distance(&self, t: Lanes) -> (Lanes, Lanes) {
        let splat = Lanes::splat;
        let (V3([x, y, z]), rho) = self.at(t);
        let d = self.direction.0;
        let h = rho - splat(self.major);
        let outwards = (x * d[0] + z * d[2]) / rho;
        let outwards = either(is_greater(rho, Lanes::ZERO), outwards, Lanes::ZERO);
        let minor = splat(self.minor);
        let value = fused(h, h, (y - minor) * (y + minor));
        (value, splat(2.0) * (h * outwards + y * d[1]))
    }

    /// Two masks: the lanes whose points at t are surely outside of the torus, and those whose points are surely in the
    /// tube.
    #[inline(always)]
    fn sides(&self, t: Lanes, most: Lanes) -> [Lanes; 2] {
        let splat = Lanes::splat;
        let (point, rho) = self.at(t);
        let unit = splat(UNIT_ROUNDOFF);
        let epsilon = self.error + unit * point.abs().max_component();
        let (y, minor, two) = (point.0[1], splat(self.minor), splat(2.0));
        let g = |centre: f64| {
            let h = rho - splat(centre);
            let value = fused(h, h, (y - minor) * (y + minor));
            let h_error = splat(1.5) * epsilon + unit * (splat(3.0) * rho + h.abs());
            let bound = two * (h.abs() * h_error + y.abs() * epsilon)
                + splat(gamma(3)) * (h * h + y * y + minor * minor);
            (value, value.abs() - two * bound)
        };
        let ((outer, outer_least), (inner, inner_least)) = (g(self.major), g(-self.major));
        let is_clear = is_greater(outer_least, Lanes::ZERO)
            & is_greater(inner_least, Lanes::ZERO)
            & is_greater(outer_least * inner_least, most);
        let is_outside = is_greater(outer, Lanes::ZERO);
        let is_tube = !is_outside & is_greater(inner, Lanes::ZERO);
        [is_clear & is_outside, is_clear & is_tube]
    }
}

/// Roots of f between two ends, and a mask of the lanes in which they were found: see
/// [`root_between`](crate::trace::quartic::root_between).
#[inline(always)]
fn root_between(
    f: impl Fn(Lanes) -> (Lanes, Lanes),
    [mut low, mut high]: [Lanes; 2],
    rising: Lanes,
    start: Lanes,
    precision: Lanes,
    lanes: Lanes,
) -> (Lanes, Lanes) {
    let half = Lanes::splat(0.5);
    let middle = |low: Lanes, high: Lanes| low + (high - low) * half;
    let is_between = is_greater(start, low) & is_less(start, high);
    let mut x = either(is_between, start, middle(low, high));
    let mut last = high - low;
    let mut open = lanes;
    for _ in 0..MAX_STEPS {
        let (value, slope) = f(x);
        open &= !value.simd_eq(Lanes::ZERO);
        if open.to_bitmask() == 0 {
            break;
        }
        let is_high = !(is_greater(value, Lanes::ZERO) ^ rising);
        high = either(is_high, x, high);
        low = either(is_high, low, x);
        let step = -value / slope;
        let newton = x + step;
        let is_good = is_at_most(low, newton)
            & is_at_most(newton, high)
            & is_at_most(step.abs(), last * half);
        let next = either(is_good, newton, middle(low, high));
        let size = either(is_good, step.abs(), (high - low) * half);
        let has_moved = !next.simd_eq(x);
        x = either(open, next, x);
        last = size;
        open &= has_moved & !is_at_most(size, precision);
    }
    (x, lanes & !open)
}

/// The roots of at² + bt + c, ascending. Without two roots, both numbers are the place of the extremum.
#[inline(always)]
fn quadratic(a: Lanes, b: Lanes, c: Lanes) -> [Lanes; 2] {
    let b = -b * Lanes::splat(0.5);
    let discriminant = difference_of_products(b, b, a, c);
    let s = discriminant.sqrt();
    let q = either(is_less(b, Lanes::ZERO), b - s, b + s);
    let (first, second) = (c / q, q / a);
    let in_order = is_less(first, second) | !second.simd_eq(second);
    let has_roots = is_greater(discriminant, Lanes::ZERO);
    let extremum = b / a;
    [
        either(has_roots, either(in_order, first, second), extremum),
        either(has_roots, either(in_order, second, first), extremum),
    ]
}

/// ab − cd, where the rounding of cd is made good: see
/// [`Real::difference_of_products`](crate::geometry::number::Real::difference_of_products).
#[inline(always)]
fn difference_of_products(a: Lanes, b: Lanes, c: Lanes, d: Lanes) -> Lanes {
    let product = c * d;
    let error = fused(-c, d, product);
    fused(a, b, -product) + error
}

/// Finds where the rays `live` first meet a torus, clearly after their starts. `line` holds them in the space of the
/// torus; up to t = `skin` a place may be the start.
#[inline(never)]
pub fn first(torus: &Torus, line: &Local, skin: Lanes, live: u32) -> First {
    let splat = Lanes::splat;
    let [major, minor]: [f64; 2] = torus.radii();
    let unknown = First {
        known: 0,
        met: 0,
        t: Lanes::ZERO,
    };
    let Some([up, down]) = torus.unit().filter(|_| minor <= major) else {
        return unknown;
    };
    let whole = splat((major + minor) * up);
    let longest = line.direction.abs().max_component();
    let is_usual = is_greater(longest, splat(LEAST_DIRECTION))
        & is_less(longest, splat(LEAST_DIRECTION.recip()));
    let start = line.origin.abs().max_component();
    let reach = start + whole;
    let length = reach / longest;
    let is_sharp = is_at_most(
        line.slack[0] + line.slack[1] * length,
        splat(LINE_REL_ERROR) * reach,
    );
    let mut known = mask(live) & is_usual & is_sharp;

    let unit = longest & splat(f64::INFINITY);
    let per_unit = splat(1.0) / unit;
    let origin = line.origin * splat(down);
    let direction = line.direction * per_unit;
    let d = direction.0;
    let a = direction.dot(direction);
    let t0 = -(origin.dot(direction) / a);
    let once = V3(each([0, 1, 2], |i: usize| fused(d[i], t0, origin.0[i])));
    let t1 = -(once.dot(direction) / a);
    let near = V3(each([0, 1, 2], |i: usize| fused(d[i], t1, once.0[i])));
    let moved = once.abs().max_component() + near.abs().max_component();
    let bend = line.slack[1] / longest;
    let share = bend * splat(1.75);
    let drift = line.slack[0] + share * start + share * whole;
    known &= is_at_most(bend, splat(0.25));
    let scaled = Scaled {
        major,
        minor,
        near,
        direction,
        error: splat(UNIT_ROUNDOFF) * moved + drift * splat(down),
    };
    let size = major + minor;
    known &= is_at_most(scaled.error, splat(size * MOST_ERROR));

    let [two, three, four] = [splat(2.0), splat(3.0), splat(4.0)];
    let (b, c) = (near.dot(direction), near.dot(near));
    let beyond = splat(32.0) * (splat(size) + four * scaled.error);
    let around = size * 1.0625;
    let discriminant = difference_of_products(b, b, a, c - splat(around * around));
    let comes_near =
        is_at_most(near.abs().max_component(), beyond) & is_greater(discriminant, Lanes::ZERO);
    let mut open = known & comes_near;
    if open.to_bitmask() == 0 {
        return First {
            known: known.to_bitmask(),
            ..unknown
        };
    }
    let s = discriminant.sqrt();
    let (from, to) = ((-b - s) / a, (-b + s) / a);
    let flat = |v: V3, w: V3| v.0[0] * w.0[0] + v.0[2] * w.0[2];
    let major2 = splat(major * major);
    let k = c + splat((major - minor) * (major + minor));
    let quartics = Quartics([
        a * a,
        four * a * b,
        two * a * k + four * (b * b - major2 * flat(direction, direction)),
        four * b * k - splat(8.0) * major2 * flat(near, direction),
        k * k - four * major2 * flat(near, near),
    ]);
    let slope_error =
        splat(64.0) * a.sqrt() * splat(size * size) * (splat(gamma(20) * size) + scaled.error);
    let most = three * slope_error * (to - from);

    // The last place outside, and the first place after it in the tube: the root is between them.
    let [mut low, mut high] = [from, from];
    let mut found = Lanes::ZERO;
    let mut visit = |t: Lanes, lanes: Lanes, open: &mut Lanes, known: &mut Lanes| {
        let lanes = lanes & *open & is_less(t, to);
        if lanes.to_bitmask() == 0 {
            return;
        }
        let [is_outside, is_tube] = scaled.sides(t, most);
        low = either(lanes & is_outside, t, low);
        high = either(lanes & is_tube, t, high);
        found |= lanes & is_tube;
        let is_lost = lanes & !(is_outside | is_tube);
        *known &= !is_lost;
        *open &= !(is_lost | (lanes & is_tube));
    };
    let [c4, c3, c2, ..] = quartics.0;
    let slope = [four * c4, three * c3, two * c2];
    let [first, second] = quadratic(three * slope[0], two * slope[1], slope[2]);
    let precision = splat(UNIT_ROUNDOFF) * (to - from);
    let mut last = from;
    let mut last_slope = quartics.slope_at(slope, from).0;
    for bend in [first, second, to] {
        let is_next = is_greater(bend, last) & is_at_most(bend, to);
        let own = quartics.slope_at(slope, bend).0;
        let zero = Lanes::ZERO;
        let turns = (is_less(last_slope, zero) & is_greater(own, zero))
            | (is_greater(last_slope, zero) & is_less(own, zero));
        let turns = is_next & turns & open;
        if turns.to_bitmask() != 0 {
            let f = |x: Lanes| quartics.slope_at(slope, x);
            let start = (last + bend) * splat(0.5);
            let rising = is_greater(own, zero);
            let (stationary, is_found) =
                root_between(f, [last, bend], rising, start, precision, turns);
            known &= is_found | !turns;
            open &= known;
            let is_later = turns & is_greater(stationary, last);
            visit(stationary, is_later, &mut open, &mut known);
            last = either(is_later, stationary, last);
        }
        visit(
            bend,
            is_next & is_greater(bend, last),
            &mut open,
            &mut known,
        );
        last = either(is_next, bend, last);
        last_slope = either(is_next, own, last_slope);
    }
    let found = found & known;
    if found.to_bitmask() == 0 {
        return First {
            known: known.to_bitmask(),
            ..unknown
        };
    }

    let (depth, height) = (quartics.at(high).0.abs(), quartics.at(low).0.abs());
    let start = high + (low - high) * (depth / (depth + height)).sqrt();
    let coarse = splat(UNIT_ROUNDOFF.sqrt()) * (high - low);
    let falls = Lanes::ZERO;
    let f = |t: Lanes| quartics.at(t);
    let (start, is_told) = root_between(f, [low, high], falls, start, coarse, found);
    let noise = splat(UNIT_ROUNDOFF * minor * (major + minor));
    let g = |t: Lanes| {
        let (value, slope) = scaled.distance(t);
        let value = either(is_at_most(value.abs(), noise), Lanes::ZERO, value);
        (value, slope)
    };
    let precision = splat(UNIT_ROUNDOFF) * low.abs().fast_max(high.abs());
    let (t, is_exact) = root_between(g, [low, high], falls, start, precision, found);
    let t = (t0 + (t1 + t)) * (splat(up) * per_unit);
    let enough = splat(1.5) * skin + length * splat(0.01);
    let is_met = found & is_told & is_exact & is_greater(t, enough) & line.is_sharp(t);
    First {
        known: (known & (is_met | !found)).to_bitmask(),
        met: is_met.to_bitmask(),
        t,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::affine::Slack;
    use crate::geometry::line::Line;
    use crate::geometry::vec::Vec3;
    use crate::trace::kernel::lanes::ALL;
    use crate::trace::kernel::tests::numbers;
    use crate::trace::shapes::{Intersect, Roots};

    /// What is known has the bits of what the torus finds, of lines from everywhere, also through the hole and along
    /// its axis, of thin tori and thick ones, large and small.
    #[test]
    fn rays_are_met_where_the_torus_finds() {
        let mut number = numbers();
        let [mut known, mut met, mut outside] = [0; 3];
        for i in 0..6_000 {
            let size = [1.0, 3.7e-9, 8.1e12][i % 3];
            let minor = [0.3, 0.01, 0.95, 1.0][i % 4] * size;
            let torus = Torus::new(size, minor);
            let lines: Vec<Line> = (0..4)
                .map(|lane| {
                    let mut vector = || Vec3::new(number(), number(), number());
                    let far = [3.0, 40.0, 1.0][(i + lane) % 3];
                    let (from, to) = (vector() * (far * size), vector() * (1.3 * size));
                    let mut way = to - from;
                    if (i + lane) % 11 == 0 {
                        way.0[lane % 3] = 0.0;
                    }
                    if (i + lane) % 17 == 0 {
                        way = Vec3::new(0.0, -from[1], 0.0);
                    }
                    Line::new(from, way * (1.0 + number().abs()))
                })
                .collect();
            let [a, b, c, d] = &lines[..] else {
                unreachable!()
            };
            let line = Local {
                origin: V3::gathered([a, b, c, d], |line| &line.origin.0),
                direction: V3::gathered([a, b, c, d], |line| &line.direction.0),
                slack: [Lanes::splat(1e-15 * size); 2],
            };
            let found = first(&torus, &line, Lanes::splat(1e-9), ALL);
            for (lane, line) in lines.iter().enumerate() {
                let slack = Slack {
                    origin: 1e-15 * size,
                    direction: 1e-15 * size,
                };
                let line = Line::within(slack, line.origin, line.direction);
                let mut roots = Roots::default();
                torus.first_crossings(&line, 1.5e-9, &mut roots);
                let is_known = found.known >> lane & 1 != 0;
                let is_outside = roots.list.first().is_none_or(|root| root.t > 0.05);
                outside += u32::from(is_outside);
                known += u32::from(is_known);
                if !is_known {
                    continue;
                }
                assert!(!roots.uncertain, "{torus:?} {line:?}");
                let own = roots.list.first().map(|root| (root.t, root.face));
                let t = found.t.to_array()[lane];
                let ours = (found.met >> lane & 1 != 0).then_some((t, 0));
                assert_eq!(ours, own, "{torus:?} {line:?}");
                met += u32::from(ours.is_some());
            }
        }
        assert!(
            known * 100 > outside * 95 && met * 4 > known,
            "{known} {met} {outside}"
        );
    }
}
