//! Where a line meets a polynomial of second degree.

use super::form::{Form, OPERATIONS, PAIRS, power_of_two};
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::shapes::Roots;
use crate::trace::vec::Vec3;

/// A number and a bound on its error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounded<R> {
    pub value: R,
    pub error: R,
}

/// Where F along a line is negative: a τ² + b τ + c < 0 for the line's own parameter τ.
#[derive(Debug, Clone, Copy)]
pub(super) enum Inside<R> {
    Nowhere,
    Everywhere,
    /// Between the roots.
    Between(Bounded<R>, Bounded<R>),
    /// Below the first and above the second.
    Around(Bounded<R>, Bounded<R>),
    Below(Bounded<R>),
    Above(Bounded<R>),
}

/// A line in the units of a form, from its closest approach to the origin there on; its points are
/// (origin + τ·direction) / w. All of it is near 1 in size.
#[derive(Debug)]
pub(super) struct Chord<R> {
    pub origin: Vec3<R>,
    pub direction: Vec3<R>,
    pub w: R,
    pub inside: Inside<R>,
    /// The vertex of the parabola, −b/2a; zero where a is.
    pub middle: R,
    pub uncertain: bool,
    /// t = (start + τ/(w·stretch)) / length.
    start: R,
    stretch: R,
    length: R,
}

/// Whether products and sums of this number are rounded once, as in hardware, where the error of
/// a product is the result of a fused operation. Double-double numbers are far below this.
fn is_hardware<R: Real>() -> bool {
    R::ROUNDOFF > R::of(f64::EPSILON * f64::EPSILON)
}

impl<R: Real> Chord<R> {
    /// The quadratic a τ² + b τ + c of the line.
    ///
    /// The origin is moved with one rounding (a fused multiply-add), so that it is as exact as if
    /// the line had started there. The leading coefficient decides what is inside at infinity and
    /// vanishes along generators and asymptotes; it is summed in twice the working precision. The
    /// discriminant is Kahan's difference of products; the roots are q/a and c/q.
    pub fn new(form: &Form, line: &Line<R>) -> Chord<R> {
        let unit = form.units::<R>();
        let (d, length) = normalised(line.direction, 0.0);
        let (direction, stretch) = normalised(d.zip(unit, |x, s| x / s), 0.0);
        let (o, far) = normalised(line.origin, 1.0);
        let offset = o.zip(unit, |x, s| x / s);
        let back = -(offset.dot(direction) / direction.dot(direction)) * far / stretch;
        // As a double, so that its product with another one is exact in double-double, too.
        let back = R::of(back.to_f64());
        let moved = line.origin.zip(d, |o, d| d.mul_add(back, o));
        let (start, moved) = if moved.is_finite() && back.is_finite() {
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
            inside: Inside::Nowhere,
            middle: R::ZERO,
            uncertain: false,
            start,
            stretch,
            length,
        };
        // Where the move is not fused, its error is relative to what is added, unless that is exact.
        let lost = d.map(|x| {
            if is_hardware::<R>() || x == R::of(x.to_f64()) {
                R::ZERO
            } else {
                (x * back).abs() * R::gamma(4)
            }
        });
        let slack = (lost.zip(unit, |x, s| (x / s).abs()) * w).max_component();
        let slack = if slack.is_finite() { slack } else { R::ZERO };
        chord.solve(form, slack);
        chord
    }

    /// Bounds on errors: a's from [`leading`]; b and c have at most γₙ of the sizes of their terms,
    /// and what the point being off by `slack` changes. The discriminant's follows to first and
    /// second order, with 2u of its own rounding (u of all its terms where products are not
    /// fused); a root's from those of its two factors.
    fn solve(&mut self, form: &Form, slack: R) {
        let (p, d, w) = (self.origin, self.direction, self.w);
        let two = R::of(2.0);
        let four = R::of(4.0);
        let a = leading(form, d);
        let (c, c_size) = form.value(p, w);
        let (b, b_size) = cross(form, p, d, w);
        let reach = p.abs().max_component() + w;
        let weight = form.weight::<R>();
        let c = Bounded {
            value: c,
            error: R::gamma(OPERATIONS) * c_size + two * weight * reach * slack,
        };
        let b = Bounded {
            value: b,
            error: R::gamma(OPERATIONS) * b_size + two * weight * slack,
        };
        let (av, bv, cv) = (a.value, b.value, c.value);
        if !(av.is_finite() && bv.is_finite() && cv.is_finite()) {
            self.uncertain = true;
            return;
        }
        if av == R::ZERO {
            self.uncertain = a.error > R::ZERO || (bv.abs() <= b.error && b.error > R::ZERO);
            let t = -(cv / bv);
            self.inside = if bv == R::ZERO || !t.is_finite() {
                // A line in the surface has no inside, unless everything is.
                self.uncertain |= cv.abs() <= c.error && c.error > R::ZERO;
                if cv < R::ZERO || form.is_zero() {
                    Inside::Everywhere
                } else {
                    Inside::Nowhere
                }
            } else {
                let t = Bounded {
                    value: t,
                    error: (c.error + b.error * t.abs()) / bv.abs() + R::gamma(2) * t.abs(),
                };
                if bv > R::ZERO {
                    Inside::Below(t)
                } else {
                    Inside::Above(t)
                }
            };
            return;
        }
        let discriminant = R::difference_of_products(bv, bv, four * av, cv);
        let own = if is_hardware::<R>() {
            discriminant.abs()
        } else {
            bv * bv + four * (av * cv).abs()
        };
        let error = two * R::ROUNDOFF * own
            + two * bv.abs() * b.error
            + four * (av.abs() * c.error + cv.abs() * a.error)
            + b.error * b.error
            + four * a.error * c.error;
        self.uncertain = discriminant.abs() <= error || av.abs() <= a.error;
        self.middle = -(bv / (two * av));
        // In double-double numbers the decision is final: what cannot be told from a touch is one.
        let touch = if is_hardware::<R>() { R::ZERO } else { error };
        if discriminant <= touch || discriminant.is_nan() {
            self.inside = if av < R::ZERO {
                Inside::Everywhere
            } else {
                Inside::Nowhere
            };
            return;
        }
        let root = discriminant.sqrt();
        let q = if bv > R::ZERO {
            -(bv + root)
        } else {
            root - bv
        } / two;
        let q_error = (b.error + error / root) / two + R::gamma(3) * q.abs();
        let (x, y) = (q / av, cv / q);
        let x = Bounded {
            value: x,
            error: (q_error + a.error * x.abs()) / av.abs() + R::ROUNDOFF * x.abs(),
        };
        let y = Bounded {
            value: y,
            error: (c.error + q_error * y.abs()) / q.abs() + R::ROUNDOFF * y.abs(),
        };
        let (x, y) = if x.value <= y.value { (x, y) } else { (y, x) };
        self.inside = if av > R::ZERO {
            Inside::Between(x, y)
        } else {
            Inside::Around(x, y)
        };
    }

    /// The line's t at τ.
    pub fn t(&self, tau: R) -> R {
        (self.start + tau / self.w / self.stretch) / self.length
    }

    /// The crossings of the whole solid.
    pub fn append(&self, roots: &mut Roots<R>) {
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

/// Appends crossings, ascending. Two at the same t are a touch and cancel; one beyond the finite
/// numbers is at infinity, which changes what is inside there or is never reached.
pub(super) fn push_all<R: Real, const N: usize>(roots: &mut Roots<R>, list: [(R, u32); N]) {
    for (t, face) in list {
        if t.is_finite() {
            if roots.list.last().is_some_and(|last| last.t >= t) {
                roots.list.pop();
            } else {
                roots.push(t, face);
            }
        } else if t < R::ZERO {
            roots.inside = !roots.inside;
        }
    }
}

/// A vector divided by a power of two not below `least`, so that its largest component is in
/// [1, 2), or below 2 where `least` holds it back; and that power. Exact.
fn normalised<R: Real>(v: Vec3<R>, least: f64) -> (Vec3<R>, R) {
    let scale = R::of(power_of_two(v.abs().max_component().to_f64()).max(least));
    (v / scale, scale)
}

/// dᵀAd by compensated summation: the errors of products come from fused multiply-adds, those of
/// sums from Knuth's two-sum (Ogita, Rump and Oishi, "Accurate Sum and Dot Product", 2005). The
/// error is at most 2u of the result plus γₙ² of the sizes of the terms (γₙ of them where products
/// are not fused), plus 2u of them where a coordinate was rounded in a division by its unit.
fn leading<R: Real>(form: &Form, d: Vec3<R>) -> Bounded<R> {
    let (mut sum, mut lost, mut size) = (R::ZERO, R::ZERO, R::ZERO);
    let mut divided = R::ZERO;
    let mut add = |k: f64, i: usize, j: usize| {
        if k == 0.0 {
            return;
        }
        let k = R::of(k);
        let half = k * d[i];
        let half_error = k.mul_add(d[i], -half);
        let term = half * d[j];
        let term_error = half.mul_add(d[j], -term) + half_error * d[j];
        let next = sum + term;
        let back = next - sum;
        lost += (sum - (next - back)) + (term - back) + term_error;
        sum = next;
        size += term.abs();
        if form.unit[i] != 1.0 || form.unit[j] != 1.0 {
            divided += term.abs();
        }
    };
    for i in 0..3 {
        add(form.square[i], i, i);
    }
    for (k, (i, j)) in PAIRS.into_iter().enumerate() {
        add(form.mixed[k], i, j);
    }
    let value = sum + lost;
    let gamma = R::gamma(OPERATIONS);
    let noise = if is_hardware::<R>() {
        gamma * gamma
    } else {
        gamma
    };
    let two_u = R::gamma(2);
    Bounded {
        value,
        error: if size == R::ZERO {
            R::ZERO
        } else {
            two_u * value.abs() + noise * size + two_u * divided
        },
    }
}

/// The derivative at p along d, times w: the coefficient of τ; and the sizes of its terms.
fn cross<R: Real>(form: &Form, p: Vec3<R>, d: Vec3<R>, w: R) -> (R, R) {
    let (mut sum, mut size) = (R::ZERO, R::ZERO);
    let mut add = |term: R| {
        sum += term;
        size += term.abs();
    };
    for i in 0..3 {
        add(R::of(2.0 * form.square[i]) * p[i] * d[i]);
        add(R::of(form.linear[i]) * d[i] * w);
    }
    for (k, (i, j)) in PAIRS.into_iter().enumerate() {
        let m = R::of(form.mixed[k]);
        add(m * p[i] * d[j]);
        add(m * p[j] * d[i]);
    }
    (sum, size)
}

impl Form {
    /// A bound on |F(x + e) − F(x)| / (|e| (2|x| + 1)) to first order, by maximum norms.
    fn weight<R: Real>(&self) -> R {
        let all = [self.square, self.mixed, self.linear];
        all.iter()
            .flatten()
            .fold(R::ZERO, |sum, &x| sum + R::of(2.0 * x.abs()))
    }
}
