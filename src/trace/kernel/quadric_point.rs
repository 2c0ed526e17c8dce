//! The exact places where each of four rays meets its convex solid of second degree: the same numbers as in
//! [`shapes::quadric`](crate::trace::shapes::quadric), computed in the same order.
//!
//! Bounds on errors are wider and cheaper than in the shape. Where rounding may have decided something by these bounds,
//! the place counts as unknown, and the shape itself is asked.

use super::chain::{Local, Located};
use super::lanes::{
    ALL, LANES, Lanes, V3, either, fused, gathered, is_at_most, is_greater, is_less, lanes_where,
    mask,
};
use super::leaf::Leaf;
use super::query::{Crossing, SKINS, Start, UNKNOWN_FACE};
use super::resolved::Resolved;
use super::stage::Stage;
use crate::geometry::array::each;
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};
use crate::trace::shapes::quadric::{Axial, OPERATIONS};

/// Where four rays meet their leaves.
pub struct Found {
    /// A bit for each ray whose meeting point was found with certainty.
    pub known: u32,
    /// The rays that meet a flat end, as bits.
    pub flat: u32,
    pub resolved: Resolved,
    /// The points in the spaces of their leaves.
    pub local: V3,
}

/// A ray, and its crossing with its leaf, known roughly.
pub type Met<'w> = (&'w Start, &'w Crossing);

/// Four polynomials; see [`Axial`].
struct Forms {
    square: V3,
    linear: V3,
    constant: Lanes,
    unit: V3,
    curves: V3,
    weight: Lanes,
    height: Lanes,
}

/// The stretches of four lines in their solids: the t of both ends, and for each end a mask of the lanes where it is on
/// a flat end of the solid.
struct Chords {
    known: Lanes,
    t: [Lanes; 2],
    flat: [Lanes; 2],
}

/// A number and a bound on its error.
#[derive(Clone, Copy)]
struct Bounded {
    value: Lanes,
    error: Lanes,
}

/// The factor that widens bounds, since bounds are rounded, too.
const ROOM: f64 = 1.01;
/// The least power of two that lines are divided by; its reciprocal is the greatest. Other lines count as unknown.
const LEAST_SCALE: f64 = 1e-100;

/// Finds the exact places where four rays meet their leaves: the far end of the chord for a ray that comes out, the
/// near end for others. `None` unless each leaf has an [`Axial`] form.
#[inline(never)]
pub fn meet(stage: &Stage, leaves: [&Leaf; LANES], met: [Met<'_>; LANES]) -> Option<Found> {
    let axial = |lane: usize| leaves[lane].quadric()?.axial.as_ref();
    let [Some(a), Some(b), Some(c), Some(d)] = each([0, 1, 2, 3], axial) else {
        return None;
    };
    let forms = Forms::gathered([a, b, c, d]);
    let chains = stage.chains_of(leaves);
    let starts = each(met, |(start, _)| start);
    let crossings = each(met, |(_, crossing)| crossing);
    let origin = V3::gathered(starts, |start| &start.origin);
    let direction = V3::gathered(starts, |start| &start.direction);
    let line = chains.enter(origin, direction);
    let chords = forms.chords(&line);
    let exit = mask(lanes_where(|lane| crossings[lane].is_exit));
    let [rough, error, t] = [
        gathered(crossings, |crossing| crossing.end.t),
        gathered(crossings, |crossing| crossing.end.error),
        gathered(crossings, |crossing| crossing.root.t),
    ];
    let located = mask(lanes_where(|lane| {
        crossings[lane].root.face != UNKNOWN_FACE
    }));
    let located_flat = mask(lanes_where(|lane| crossings[lane].root.face != 0));
    let own = either(exit, chords.t[1], chords.t[0]);
    let other = either(exit, chords.t[0], chords.t[1]);
    let is_near = is_at_most((own - rough).abs(), error + error);
    // The other end of the chord may be the ray's start: it must be clearly elsewhere, unless the ray starts on the
    // leaf.
    let skin = gathered(starts, |start| start.skin * SKINS);
    let left = lanes_where(|lane| starts[lane].left == leaves[lane].twin);
    let splat = Lanes::splat;
    let far = skin / direction.abs().max_component() + splat(4.0) * error;
    let is_apart = is_greater(other.abs(), far + far) | mask(left);
    let told = chords.known & is_near & is_apart & line.is_sharp(own) & line.is_sharp(other);
    let t = either(located, t, own);
    let flat = either(
        located,
        located_flat,
        either(exit, chords.flat[1], chords.flat[0]),
    );
    let place = forms.locate(&line, t, flat);
    let local = place.point;
    let place = chains.leave(place);
    let known = (told | located) & place.known;
    Some(Found {
        known: known.to_bitmask(),
        flat: flat.to_bitmask(),
        resolved: Resolved {
            clear: known,
            t,
            point: place.point,
            error: place.error,
            normal: place.normal,
        },
        local,
    })
}

/// Divides each of the vectors by a power of two of its own, but by no less than `least`, so that no component reaches
/// 2 in size. Returns the vectors and the divisors.
#[inline(always)]
fn normalised(v: V3, least: f64) -> (V3, Lanes) {
    let exponent = v.abs().max_component() & Lanes::splat(f64::INFINITY);
    let scale = exponent.fast_max(Lanes::splat(least));
    (v * (Lanes::splat(1.0) / scale), scale)
}

impl Bounded {
    /// x/y, for a y that is surely not zero.
    #[inline(always)]
    fn quotient(x: Bounded, y: Bounded) -> Bounded {
        let value = x.value / y.value;
        let splat = Lanes::splat;
        let carried = (x.error + y.error * value.abs()) / y.value.abs();
        Bounded {
            value,
            error: splat(2.0) * carried + splat(gamma(3)) * value.abs(),
        }
    }

    /// A mask: the lanes in which the sign of the value is surely right.
    #[inline(always)]
    fn is_sure(self) -> Lanes {
        is_greater(self.value.abs(), self.error + self.error)
    }
}

impl Forms {
    #[inline(always)]
    fn gathered(of: [&Axial; LANES]) -> Forms {
        Forms {
            square: V3::gathered(of, |form| &form.square),
            linear: V3::gathered(of, |form| &form.linear),
            constant: gathered(of, |form| form.constant),
            unit: V3::gathered(of, |form| &form.unit),
            curves: V3::gathered(of, |form| &form.curves),
            weight: gathered(of, |form| form.weight),
            height: gathered(of, |form| form.height),
        }
    }

    /// A vector in units of the form.
    #[inline(always)]
    fn scaled(&self, v: V3) -> V3 {
        V3(each([0, 1, 2], |i: usize| v.0[i] / self.unit.0[i]))
    }

    /// w²·F(x/w), and the sum of the sizes of its terms.
    #[inline(always)]
    fn value(&self, x: V3, w: Lanes) -> (Lanes, Lanes) {
        let mut sum = self.constant * w * w;
        let mut size = sum.abs();
        for i in 0..3 {
            let square = self.square.0[i] * x.0[i] * x.0[i];
            let linear = self.linear.0[i] * x.0[i] * w;
            sum = sum + square + linear;
            size = size + square.abs() + linear.abs();
        }
        (sum, size)
    }

    /// The gradient of F at x, in the form's own units.
    #[inline(always)]
    fn gradient(&self, x: V3) -> V3 {
        let two = Lanes::splat(2.0);
        V3(each([0, 1, 2], |i: usize| {
            two * self.square.0[i] * x.0[i] + self.linear.0[i]
        }))
    }

    /// The stretches of lines in their solids, computed as in `Chord` of
    /// [`shapes::quadric`](crate::trace::shapes::quadric).
    #[inline(always)]
    fn chords(&self, line: &Local) -> Chords {
        let splat = Lanes::splat;
        let (zero, one, two, four) = (Lanes::ZERO, splat(1.0), splat(2.0), splat(4.0));
        let (d, length) = normalised(line.direction, 0.0);
        let (direction, stretch) = normalised(self.scaled(d), 0.0);
        let (offset, shrink) = normalised(self.scaled(line.origin), 1.0);
        let heavy = direction.times(self.curves);
        let back = -(offset.dot(heavy) / direction.dot(heavy)) * (shrink / stretch);
        let moved = V3(each([0, 1, 2], |i: usize| {
            fused(d.0[i], back, line.origin.0[i])
        }));
        let away = line.slack[1] * (back / length).abs();
        let (p, scale) = normalised(moved, 1.0);
        let (p, again) = normalised(self.scaled(p), 1.0);
        let w = one / scale / again;
        let usual = |scale: Lanes| {
            is_greater(scale, splat(LEAST_SCALE)) & is_less(scale, splat(LEAST_SCALE.recip()))
        };
        let usual = usual(length) & usual(stretch) & usual(shrink) & usual(scale) & usual(again);
        let usual = usual & is_at_most(away, line.origin.abs().max_component());

        // How far the rounded line may be from the exact one.
        let inverse = V3(each(self.unit.0, |unit| splat(ROOM) / unit.abs())).max_component();
        let strays = (line.slack[0] + away) * inverse * w;
        let turns = line.slack[1] / length / stretch * inverse;
        let a = {
            let (value, size) = self.leading(direction);
            Bounded {
                value,
                error: splat(8.0 * UNIT_ROUNDOFF) * size + self.weight * turns * (two + turns),
            }
        };
        let rounded = splat(ROOM * gamma(OPERATIONS));
        let b = {
            let (mut sum, mut size) = (zero, zero);
            for i in 0..3 {
                let square = two * self.square.0[i] * p.0[i] * direction.0[i];
                let linear = self.linear.0[i] * direction.0[i] * w;
                sum = sum + square + linear;
                size = size + square.abs() + linear.abs();
            }
            Bounded {
                value: sum,
                error: rounded * size + self.weight * (two * (strays + turns) + strays * turns),
            }
        };
        let c = {
            let (value, size) = self.value(p, w);
            Bounded {
                value,
                error: rounded * size + self.weight * strays * (two + strays),
            }
        };
        let discriminant = {
            let twice = four * a.value;
            let product = twice * c.value;
            let error = fused(-twice, c.value, product);
            let value = fused(b.value, b.value, -product) + error;
            let terms = a.value.abs() * c.error + c.value.abs() * a.error;
            Bounded {
                value,
                error: splat(ROOM)
                    * (splat(2.0 * UNIT_ROUNDOFF) * value.abs()
                        + two * b.value.abs() * b.error
                        + four * terms
                        + b.error * b.error
                        + four * a.error * c.error)
                    + splat(f64::MIN_POSITIVE / UNIT_ROUNDOFF),
            }
        };
        let root = discriminant.value.sqrt();
        let q = {
            let sum = either(is_greater(b.value, zero), -(b.value + root), root - b.value);
            let value = sum / two;
            Bounded {
                value,
                error: (b.error + discriminant.error / root) / two + splat(gamma(4)) * value.abs(),
            }
        };
        let (x, y) = (Bounded::quotient(q, a), Bounded::quotient(c, q));
        let ordered = is_at_most(x.value, y.value);
        let [first, last] = [(x, y), (y, x)].map(|(x, y)| Bounded {
            value: either(ordered, x.value, y.value),
            error: either(ordered, x.error, y.error),
        });
        let told = usual
            & is_greater(discriminant.value, discriminant.error + discriminant.error)
            & a.is_sure()
            & q.is_sure();
        let (ends, flat, is_in) = self.cut(
            [p.0[1], direction.0[1], w],
            (a, b),
            [first, last],
            [strays, turns],
        );
        let t = each(ends, |tau| (back + tau / w / stretch) / length);
        let known = told & is_in & is_less(t[0], t[1]) & is_less(t[1] - t[0], splat(f64::INFINITY));
        Chords { known, t, flat }
    }

    /// dᵀAd in twice the working precision, and the sum of the sizes of its terms.
    #[inline(always)]
    fn leading(&self, d: V3) -> (Lanes, Lanes) {
        let (mut sum, mut lost, mut size) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
        for i in 0..3 {
            let (k, x) = (self.square.0[i], d.0[i]);
            let half = k * x;
            let half_error = fused(k, x, -half);
            let term = half * x;
            let term_error = fused(half, x, -term) + half_error * x;
            let next = sum + term;
            let back = next - sum;
            let rest = (sum - (next - back)) + (term - back) + term_error;
            lost += rest;
            sum = next;
            size += term.abs();
        }
        (sum + lost, size)
    }

    /// Cuts the stretches in which the polynomials are negative down to the stretches in the solids: for a cone to the
    /// part between apex and base, for other solids not at all. Returns the ends, masks of the ends that are flat, and
    /// a mask of the lanes where all this is known.
    #[inline(always)]
    fn cut(
        &self,
        [height, rising, w]: [Lanes; 3],
        (a, b): (Bounded, Bounded),
        [first, last]: [Bounded; 2],
        [strays, turns]: [Lanes; 2],
    ) -> ([Lanes; 2], [Lanes; 2], Lanes) {
        let splat = Lanes::splat;
        let (zero, infinity) = (Lanes::ZERO, splat(f64::INFINITY));
        let closed = is_greater(a.value, zero);
        let is_cone = is_greater(self.height.abs(), zero);
        if !is_cone.any() {
            return ([first.value, last.value], [zero; 2], closed);
        }
        // The solid is the half of the double cone where y is positive. A bounded stretch is in the half that its
        // middle is in. Of two unbounded stretches, the solid has the one that the line rises into.
        let two = splat(2.0);
        let middle = Bounded::quotient(
            Bounded {
                value: -b.value,
                error: b.error,
            },
            Bounded {
                value: two * a.value,
                error: two * a.error,
            },
        );
        let off = |end: Bounded| {
            rising.abs() * end.error + strays + turns * (end.value.abs() + end.error)
        };
        let step = middle.value * rising;
        let y = height + step;
        let y_error = splat(gamma(5)) * (height.abs() + step.abs()) + off(middle);
        let is_upper = is_greater(y, y_error + y_error);
        let falls = is_less(rising, zero);
        let from = |finite: Lanes, end: Bounded, infinite: Lanes| Bounded {
            value: either(finite, end.value, infinite),
            error: either(finite, end.error, zero),
        };
        let starts = from(closed | !falls, either_of(closed, first, last), -infinity);
        let stops = from(closed | falls, either_of(closed, last, first), infinity);
        let below = |end: Bounded| {
            let finite = is_less(end.value.abs(), infinity);
            let step = rising * end.value;
            let left = w - height - step;
            let error = splat(gamma(7)) * (w + height.abs() + step.abs()) + off(end);
            let sure = is_greater(left.abs(), error + error);
            (finite & is_greater(left, zero), sure | !finite)
        };
        let (starts_below, start_is_sure) = below(starts);
        let (stops_below, stop_is_sure) = below(stops);
        let at = (w - height) / rising;
        let ends = [
            either(starts_below, starts.value, at),
            either(stops_below, stops.value, at),
        ];
        let ends = [
            either(is_cone, ends[0], first.value),
            either(is_cone, ends[1], last.value),
        ];
        let known =
            (is_upper | !closed) & start_is_sure & stop_is_sure & (starts_below | stops_below);
        let flat = [is_cone & !starts_below, is_cone & !stops_below];
        (ends, flat, either(is_cone, known, closed))
    }

    /// The points of lines at t, moved onto the surfaces. In the lanes of the mask `flat` the surface is the plane of a
    /// flat end.
    #[inline(always)]
    fn locate(&self, line: &Local, t: Lanes, flat: Lanes) -> Located {
        let splat = Lanes::splat;
        let rounded = splat(gamma(OPERATIONS));
        let two = splat(2.0);
        let squares = self.square.abs();
        let curvature = Lanes::ZERO + two * squares.0[0] + two * squares.0[1] + two * squares.0[2];
        let mut x = self.scaled(line.at(t));
        let mut known = mask(ALL);
        for _ in 0..2 {
            let (value, size) = self.value(x, splat(1.0));
            let g = self.gradient(x);
            let square = g.dot(g);
            let off = value.abs() + rounded * size;
            let step = g * (value / square);
            known &= is_at_most(splat(4.0) * off * curvature, square);
            x = x - step;
        }
        let (_, size) = self.value(x, splat(1.0));
        let g = self.gradient(x);
        let square = g.dot(g);
        let error = g.abs() * (splat(2.0) * rounded * size / square);
        let error = error.times(self.unit);
        let point = x.times(self.unit);
        let normal = self.scaled(g.unit());
        let curved = Located {
            point,
            error: error + point.abs() * splat(gamma(3)),
            normal,
            known: known & mask(point.any()),
        };
        if !flat.any() {
            return curved;
        }
        let zero = Lanes::ZERO;
        let step = line.direction * t;
        let mut point = line.origin + step;
        point.0[1] = self.height;
        let mut error = (line.origin.abs() + step.abs()) * splat(gamma(8));
        error.0[1] = zero;
        Located {
            point: V3::either(flat, point, curved.point),
            error: V3::either(flat, error, curved.error),
            normal: V3::either(flat, V3([zero, self.height, zero]), curved.normal),
            known: curved.known | flat,
        }
    }
}

#[inline(always)]
fn either_of(mask: Lanes, a: Bounded, b: Bounded) -> Bounded {
    Bounded {
        value: either(mask, a.value, b.value),
        error: either(mask, a.error, b.error),
    }
}

#[cfg(test)]
mod tests;
