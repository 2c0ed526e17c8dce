//! Crossings of a line with a polynomial of second degree.

use super::form::{OPERATIONS, PAIRS, QuadricForm, power_of_two, reciprocal};
use super::refine::Sum;
use crate::geometry::affine::Slack;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::trace::shapes::Roots;
use crate::trace::shapes::error_bound::is_final;

/// A number and a bound on its error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounded<R> {
    pub value: R,
    pub error: R,
}

/// The size below which squares and products of coefficients have lost digits, or all of them, in doubles and in pairs
/// of doubles: where products reach below 2⁻¹⁰²²⁺⁵³, their errors are not normal numbers.
const UNDERFLOW: f64 = f64::MIN_POSITIVE / f64::EPSILON;

impl<R: Traced> Bounded<R> {
    /// Whether the true number may have another sign than the value.
    #[inline]
    pub(super) fn is_doubtful(self) -> bool {
        self.error > R::ZERO && self.value.abs() <= self.error
    }

    /// Whether the number counts as zero: where the value is zero, and, in final kinds of number, where the true
    /// number may be zero.
    #[inline]
    pub(super) fn is_zero(self) -> bool {
        self.value == R::ZERO || (is_final::<R>() && self.is_doubtful())
    }
}

/// The quotient x/y. Its error is computed only on demand.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quotient<R> {
    pub value: R,
    /// The error of x.
    error: R,
    y: Bounded<R>,
}

impl<R: Traced> Quotient<R> {
    #[inline]
    fn new(x: Bounded<R>, y: Bounded<R>) -> Quotient<R> {
        Quotient {
            value: x.value / y.value,
            error: x.error,
            y,
        }
    }

    /// The quotient with a bound on its error: the error of x plus the quotient times the error of y, both over the
    /// least size that y may have. The bound is infinite where that size is zero.
    pub(super) fn bounded(self) -> Bounded<R> {
        let Quotient { value, error, y } = self;
        let least = y.value.abs() - y.error;
        let error = if least > R::ZERO {
            (error + y.error * value.abs()) / least + R::gamma(2) * value.abs()
        } else {
            R::INFINITY
        };
        Bounded { value, error }
    }
}

/// The range in which F along a line is negative: a τ² + b τ + c < 0 for the line's own parameter τ.
#[derive(Debug, Clone, Copy)]
pub(super) enum Inside<R> {
    Nowhere,
    Everywhere,
    /// The points between the roots.
    Between(Quotient<R>, Quotient<R>),
    /// The points below the first root and above the second.
    Around(Quotient<R>, Quotient<R>),
    Below(Quotient<R>),
    Above(Quotient<R>),
}

/// A line in the units of a form, with its origin moved close to the form's origin. Its points are
/// (origin + τ·direction) / w. The origin, the direction and w are near 1 in size.
#[derive(Debug)]
pub(super) struct Chord<R> {
    pub origin: Vec3<R>,
    pub direction: Vec3<R>,
    pub w: R,
    /// Bounds on how far the origin and the direction are from those of the line that is meant,
    /// coordinate by coordinate, beside their own relative roundings.
    pub moved: Vec3<R>,
    pub turned: Vec3<R>,
    pub inside: Inside<R>,
    /// The coefficients a and b, which give the parabola's vertex; `None` where a is zero.
    vertex: Option<[Bounded<R>; 2]>,
    pub uncertain: bool,
    /// Whether the coefficients' errors are rough bounds, which [`Chord::sharpen`] can improve.
    rough: bool,
    /// t = (start + τ/(w·stretch)) / length.
    start: R,
    stretch: R,
    length: R,
}

impl<R: Traced> Chord<R> {
    /// The chord of a line, with the quadratic a τ² + b τ + c solved.
    ///
    /// The origin is moved with one rounding (a fused multiply-add), so that it is as exact as if
    /// the line had started there. The leading coefficient decides what is inside at infinity and
    /// vanishes along generators and asymptotes; it is summed in twice the working precision. The
    /// discriminant is Kahan's difference of products; the roots are q/a and c/q.
    pub(super) fn new(form: &QuadricForm, line: &Line<R>) -> Chord<R> {
        let unit = form.units::<R>();
        let (d, length) = normalised(line.direction, 0.0);
        let (direction, stretch) = normalised(d.zip(unit, |x, s| x / s), 0.0);
        let offset = line.origin.zip(unit, |x, s| x / s);
        let back = closest(form, offset, direction * stretch);
        // `back` is rounded to a double, so that its product with another double is exact in double-double, too.
        let back = R::of(back.to_f64());
        let moved = line.origin.zip(d, |o, d| d.mul_add(back, o));
        // If the line's direction in the form's own coordinates is nothing but slack, the closest approach means
        // nothing, and a move there would lose the line's place.
        let astray = line.slack.direction * (back / length).abs();
        let near = astray <= line.origin.abs().max_component();
        let (start, moved) = if near && moved.is_finite() && back.is_finite() {
            (back, moved)
        } else {
            (R::ZERO, line.origin)
        };
        let (p, scale) = normalised(moved, 1.0);
        let (origin, again) = normalised(p.zip(unit, |x, s| x / s), 1.0);
        let w = R::ONE / scale / again;
        let mut chord = Chord {
            origin,
            direction,
            w,
            moved: Vec3::ZERO,
            turned: Vec3::ZERO,
            inside: Inside::Nowhere,
            vertex: None,
            uncertain: false,
            rough: false,
            start,
            stretch,
            length,
        };
        if is_final::<R>() || line.slack != Slack::default() {
            chord.stray(form, line, d);
        }
        let coefficients = chord.coefficients(form);
        if chord.uncertain || !(chord.moved.any() || chord.turned.any()) {
            chord.solve(form, coefficients);
            return chord;
        }
        chord.rough = true;
        chord.solve(form, chord.strayed_roughly(form, coefficients));
        if chord.uncertain {
            chord.sharpen(form);
        }
        chord
    }

    /// Solves the quadratic once more, with closer bounds on errors, which cost more. Returns `false` if that has been
    /// done.
    pub(super) fn sharpen(&mut self, form: &QuadricForm) -> bool {
        if !self.rough {
            return false;
        }
        (self.rough, self.uncertain) = (false, false);
        self.solve(form, self.strayed(form, self.coefficients(form)));
        true
    }

    /// Sets the bounds on how far the computed line is from the one that is meant. At t = start/length, where the
    /// origin is moved to, that is the line's slack. Where that move is not fused, its product is rounded, too, unless
    /// it is exact.
    fn stray(&mut self, form: &QuadricForm, line: &Line<R>, d: Vec3<R>) {
        let Slack {
            origin,
            direction: turn,
        } = line.slack;
        let drift = origin + turn * (self.start / self.length).abs();
        let lost = d.map(|x| {
            if !is_final::<R>() || x == R::of(x.to_f64()) {
                R::ZERO
            } else {
                (x * self.start).abs() * R::gamma(4)
            }
        });
        let inverse = Vec3(each(form.inverse, R::of));
        self.moved = lost.zip(inverse, |x, s| (x + drift) * s) * self.w;
        self.turned = inverse * (turn / self.length / self.stretch);
        if !(self.moved.is_finite() && self.turned.is_finite()) {
            (self.moved, self.turned) = (Vec3::ZERO, Vec3::ZERO);
            self.uncertain = true;
        }
    }

    /// The coefficients a, b and c with their rounding errors: that of a is from [`leading`], and those of b and c are
    /// at most γₙ of the sizes of their terms. The errors that the line's displacement causes are not included.
    fn coefficients(&self, form: &QuadricForm) -> [Bounded<R>; 3] {
        let (p, d, w) = (self.origin, self.direction, self.w);
        let a = leading(form, d);
        let (c, c_size) = form.value(p, w);
        let (b, b_size) = cross(form, p, d, w);
        let b = Bounded {
            value: b,
            error: R::gamma(OPERATIONS) * b_size,
        };
        let c = Bounded {
            value: c,
            error: R::gamma(OPERATIONS) * c_size,
        };
        [a, b, c]
    }

    /// Adds to the coefficients' errors those that the displacements e of the origin and f of the direction cause.
    /// With g and h, the slopes of F along the axes at p and of its second degree at d, the coefficients change
    ///
    ///   a by h·f + A(f, f),  b by h·e + g·f + 2A(e, f),  c by g·e + A(e, e).
    fn strayed(
        &self,
        form: &QuadricForm,
        [mut a, mut b, mut c]: [Bounded<R>; 3],
    ) -> [Bounded<R>; 3] {
        let (e, f) = (self.moved, self.turned);
        let g = form.slopes(self.origin, self.w);
        let h = form.slopes(self.direction, R::ZERO);
        let half = R::of(0.5);
        a.error += h.dot(f) + half * form.twice(f, f);
        b.error += h.dot(e) + g.dot(f) + form.twice(e, f);
        c.error += g.dot(e) + half * form.twice(e, e);
        [a, b, c]
    }

    /// Like [`Chord::strayed`], with larger bounds at less cost: all coordinates are below 2, so that the slopes add
    /// up to at most twice the form's weight.
    fn strayed_roughly(
        &self,
        form: &QuadricForm,
        [mut a, mut b, mut c]: [Bounded<R>; 3],
    ) -> [Bounded<R>; 3] {
        let (e, f) = (self.moved.max_component(), self.turned.max_component());
        let weight = R::of(form.weight);
        let two = R::of(2.0);
        a.error += weight * f * (two + f);
        b.error += weight * (two * (e + f) + e * f);
        c.error += weight * e * (two + e);
        [a, b, c]
    }

    /// Solves the quadratic. The discriminant's error follows from those of the coefficients to first and second
    /// order, with 2u of its own rounding (u of all its terms where products are not fused). A root's error follows
    /// from those of its two factors.
    ///
    /// In double-double numbers the decision is final: a number that cannot be told from zero counts as zero, so that
    /// a chord that cannot be told from a touch counts as a touch.
    fn solve(&mut self, form: &QuadricForm, [a, b, c]: [Bounded<R>; 3]) {
        let two = R::of(2.0);
        let four = R::of(4.0);
        let (av, bv, cv) = (a.value, b.value, c.value);
        if !(av.is_finite() && bv.is_finite() && cv.is_finite()) {
            self.uncertain = true;
            return;
        }
        if a.is_zero() {
            self.uncertain |= a.is_doubtful() || b.is_doubtful();
            let t = -(cv / bv);
            self.inside = if b.is_zero() || !t.is_finite() {
                // A line in the surface has no inside, unless F is zero everywhere.
                self.uncertain |= c.is_doubtful();
                if (cv < R::ZERO && !c.is_zero()) || form.is_zero() {
                    Inside::Everywhere
                } else {
                    Inside::Nowhere
                }
            } else {
                let t = Quotient::new(
                    Bounded {
                        value: -cv,
                        error: c.error,
                    },
                    b,
                );
                if bv > R::ZERO {
                    Inside::Below(t)
                } else {
                    Inside::Above(t)
                }
            };
            return;
        }
        let discriminant = R::difference_of_products(bv, bv, four * av, cv);
        let own = if !is_final::<R>() {
            discriminant.abs()
        } else {
            bv * bv + four * (av * cv).abs()
        };
        let error = two * R::ROUNDOFF * own
            + two * bv.abs() * b.error
            + four * (av.abs() * c.error + cv.abs() * a.error)
            + b.error * b.error
            + four * a.error * c.error
            + R::of(UNDERFLOW);
        let discriminant = Bounded {
            value: discriminant,
            error,
        };
        self.uncertain |= discriminant.is_doubtful() || a.is_doubtful();
        self.vertex = Some([a, b]);
        if discriminant.is_zero() || discriminant.value <= R::ZERO || discriminant.value.is_nan() {
            self.inside = if av < R::ZERO {
                Inside::Everywhere
            } else {
                Inside::Nowhere
            };
            return;
        }
        let root = discriminant.value.sqrt();
        let q = if bv > R::ZERO {
            -(bv + root)
        } else {
            root - bv
        } / two;
        let q = Bounded {
            value: q,
            error: (b.error + error / root) / two + R::gamma(3) * q.abs(),
        };
        let (x, y) = (Quotient::new(q, a), Quotient::new(c, q));
        let (x, y) = if x.value <= y.value { (x, y) } else { (y, x) };
        self.inside = if av > R::ZERO {
            Inside::Between(x, y)
        } else {
            Inside::Around(x, y)
        };
    }

    /// The line's t at τ.
    #[inline]
    pub(super) fn t(&self, tau: R) -> R {
        (self.start + tau / self.w / self.stretch) / self.length
    }

    /// The τ of the parabola's vertex, −b/2a; zero where a is zero.
    pub(super) fn middle(&self) -> Bounded<R> {
        let Some([a, b]) = self.vertex else {
            return Bounded {
                value: R::ZERO,
                error: R::ZERO,
            };
        };
        let two = R::of(2.0);
        let b = Bounded {
            value: -b.value,
            error: b.error,
        };
        let twice = Bounded {
            value: two * a.value,
            error: two * a.error,
        };
        Quotient::new(b, twice).bounded()
    }

    /// Appends the crossings with the whole solid F ≤ 0.
    pub(super) fn append(&self, roots: &mut Roots<R>) {
        roots.uncertain |= self.uncertain;
        match self.inside {
            Inside::Nowhere => {}
            Inside::Everywhere => roots.inside = true,
            Inside::Between(x, y) => push_all(roots, [(self.t(x.value), 0), (self.t(y.value), 0)]),
            Inside::Around(x, y) => {
                roots.inside = true;
                push_all(roots, [(self.t(x.value), 0), (self.t(y.value), 0)]);
            }
            Inside::Below(x) => {
                roots.inside = true;
                push_all(roots, [(self.t(x.value), 0)]);
            }
            Inside::Above(x) => push_all(roots, [(self.t(x.value), 0)]),
        }
    }
}

/// Appends crossings, ascending. Two at the same t are a touch and cancel, in doubt, since a finer number might tell
/// them apart. A crossing at t = −∞ swaps inside and outside there, and one at t = +∞ is never reached.
#[inline]
pub(super) fn push_all<R: Traced, const N: usize>(roots: &mut Roots<R>, list: [(R, u32); N]) {
    for (t, face) in list {
        if t.is_finite() {
            if roots.list.last().is_some_and(|last| last.t >= t) {
                roots.list.pop();
                roots.uncertain = true;
            } else {
                roots.push(t, face);
            }
        } else if t < R::ZERO {
            roots.inside = !roots.inside;
        }
    }
}

/// The τ at which o + τ·d is so close to the origin that the terms of F are small there. Coordinates with a second
/// power weigh 1, and coordinates that are not in F weigh nothing. With the terms s·x² and l·y, of which T is the
/// largest at a first approach, their sum is about (s·x² + (l·y)²/T), so that a coordinate y with only a first power
/// weighs l²/sT times as much as x.
fn closest<R: Traced>(form: &QuadricForm, o: Vec3<R>, d: Vec3<R>) -> R {
    let (o, shrink) = normalised(o, 1.0);
    let (d, stretch) = normalised(d, 0.0);
    let at = |weight: Vec3<R>| {
        let heavy = d.times(weight);
        -(o.dot(heavy) / d.dot(heavy)) * (shrink / stretch)
    };
    let degree = form.degree;
    let first = at(Vec3(each(degree, |n| if n > 0 { R::ONE } else { R::ZERO })));
    if !degree.contains(&1) || !first.is_finite() {
        return first;
    }
    let there = o * shrink + d * (stretch * first);
    let second = R::of(form.second);
    let linear = each(form.linear, R::of);
    let largest = (0..3).fold(R::ZERO, |largest, i| match degree[i] {
        0 => largest,
        1 => largest.max((linear[i] * there[i]).abs()),
        _ => largest.max(second * there[i].square()),
    });
    let weight = |i: usize| match degree[i] {
        0 => R::ZERO,
        1 => (linear[i] / largest) * (linear[i] / second),
        _ => R::ONE,
    };
    let second = at(Vec3(each([0, 1, 2], weight)));
    if second.is_finite() { second } else { first }
}

/// A vector divided by a power of two, and that power, which is not below `least`. The largest component is then in
/// [1, 2), or below 2 where `least` bounds the power. The division is exact.
#[inline]
fn normalised<R: Traced>(v: Vec3<R>, least: f64) -> (Vec3<R>, R) {
    let scale = power_of_two(v.abs().max_component().to_f64()).max(least);
    let (inverse, scale) = (R::of(reciprocal(scale)), R::of(scale));
    // A product is quicker than a division, and gives the same where the inverse is a number.
    let shrunk = match !is_final::<R>() && inverse.is_finite() && inverse > R::ZERO {
        true => v * inverse,
        false => v / scale,
    };
    (shrunk, scale)
}

/// The leading coefficient dᵀAd, summed in twice the working precision. The error is that of the [sum](Sum), plus 3u
/// of the sizes of the terms whose coefficient was rounded, or a coordinate by the division by its unit. Where nothing
/// was rounded the error is zero.
pub(super) fn leading<R: Traced>(form: &QuadricForm, d: Vec3<R>) -> Bounded<R> {
    let (mut sum, mut divided) = (Sum::new(), R::ZERO);
    let mut add = |k: R, rounded: bool, i: usize, j: usize| {
        if k == R::ZERO {
            return;
        }
        let size = sum.add(k, d[i], d[j]);
        if rounded || form.unit[i] != 1.0 || form.unit[j] != 1.0 {
            divided += size;
        }
    };
    for i in 0..3 {
        add(R::of(form.square[i]), form.is_rounded::<R>(i, false), i, i);
    }
    for (k, (i, j)) in PAIRS.into_iter().enumerate() {
        add(form.mixed(k), form.is_rounded::<R>(k, true), i, j);
    }
    let value = sum.value();
    let (two_u, three_u) = (R::gamma(2), R::gamma(3));
    Bounded {
        value,
        error: if sum.exact {
            three_u * divided
        } else {
            two_u * value.abs() + three_u * divided + sum.noise()
        },
    }
}

/// The coefficient of τ, which is the derivative at p along d, times w; and the sum of the sizes of its terms.
fn cross<R: Traced>(form: &QuadricForm, p: Vec3<R>, d: Vec3<R>, w: R) -> (R, R) {
    let (mut sum, mut size) = (R::ZERO, R::ZERO);
    let mut add = |term: R| {
        sum += term;
        size += term.abs();
    };
    for i in 0..3 {
        add(R::of(2.0 * form.square[i]) * p[i] * d[i]);
        add(form.linear::<R>(i) * d[i] * w);
    }
    for (k, (i, j)) in PAIRS.into_iter().enumerate() {
        let m = form.mixed::<R>(k);
        add(m * p[i] * d[j]);
        add(m * p[j] * d[i]);
    }
    (sum, size)
}

impl QuadricForm {
    /// Bounds on how steep w²·F(x/w) is along each axis: the derivatives and their roundings, four
    /// terms of at most two products.
    fn slopes<R: Traced>(&self, x: Vec3<R>, w: R) -> Vec3<R> {
        let mut value = [R::ZERO; 3];
        let mut size = [R::ZERO; 3];
        let mut add = |i: usize, term: R| {
            value[i] += term;
            size[i] += term.abs();
        };
        for i in 0..3 {
            add(i, R::of(2.0 * self.square[i]) * x[i]);
            add(i, R::of(self.linear[i]) * w);
        }
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            let m = R::of(self.mixed[k]);
            add(i, m * x[j]);
            add(j, m * x[i]);
        }
        Vec3(each([0, 1, 2], |i| value[i].abs() + R::gamma(8) * size[i]))
    }

    /// 2A(e, f), where A is the matrix of second degree with its numbers' absolute values; e and f are not negative.
    fn twice<R: Traced>(&self, e: Vec3<R>, f: Vec3<R>) -> R {
        let mut sum = R::ZERO;
        for i in 0..3 {
            sum += R::of(2.0 * self.square[i].abs()) * e[i] * f[i];
        }
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            sum += R::of(self.mixed[k].abs()) * (e[i] * f[j] + e[j] * f[i]);
        }
        sum
    }
}
