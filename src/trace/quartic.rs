//! Quartics on an interval, by the cascade of their derivatives.
//!
//! A polynomial is monotone between two neighbouring roots of its derivative, so these bracket its own roots. The
//! cascade goes up by one degree at a time. Newton's method finds the root in a bracket, and bisection keeps it inside
//! (Yuksel, "High-Performance Polynomial Root Finding for Graphics", Proc. ACM Comput. Graph. Interact. Tech. 5(3),
//! 2022; the safeguard is that of Press et al., Numerical Recipes, section 9.4).

use crate::geometry::number::Real;
use std::ops::ControlFlow;

/// c₄t⁴ + c₃t³ + c₂t² + c₁t + c₀. Any of the coefficients may vanish.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quartic<R> {
    /// c₄ first.
    pub c: [R; 5],
}

impl<R: Real> Quartic<R> {
    /// The value and the slope at t.
    #[inline]
    pub(super) fn at(&self, t: R) -> (R, R) {
        let [a, b, c, d, e] = self.c;
        let (p, q) = (a, a);
        let p = p.mul_add(t, b);
        let q = q.mul_add(t, p);
        let p = p.mul_add(t, c);
        let q = q.mul_add(t, p);
        let p = p.mul_add(t, d);
        let q = q.mul_add(t, p);
        (p.mul_add(t, e), q)
    }

    /// The first three derivatives at t.
    pub(super) fn derivatives(&self, t: R) -> [R; 3] {
        let [a, b, c, ..] = self.c;
        let (two, three, four) = (R::of(2.0), R::of(3.0), R::of(4.0));
        let (first, second) = self.slope_at([four * a, three * b, two * c], t);
        [first, second, R::of(6.0) * (four * a * t + b)]
    }

    /// The slope at t and its derivative. `[a, b, c]` are 4c₄, 3c₃ and 2c₂.
    #[inline]
    fn slope_at(&self, [a, b, c]: [R; 3], t: R) -> (R, R) {
        let d = self.c[3];
        let p = a.mul_add(t, b);
        let q = a.mul_add(t, p);
        let p = p.mul_add(t, c);
        (p.mul_add(t, d), q.mul_add(t, p))
    }

    /// Divides the interval from `from` to `to` into pieces on which the quartic is monotone and its curvature keeps
    /// its sign, as far as rounding tells. Visits the ends of the pieces, ascending, from `from` to `to`, until the
    /// visitor breaks off. If rounding hides a pair of stationary points, they are so close to each other and to a
    /// visited point that the slope between is as small as its own rounding error.
    ///
    /// # Inputs
    /// `from < to`, both finite. Whatever the coefficients, the points are numbers in between.
    #[inline]
    pub(super) fn pieces(&self, from: R, to: R, mut visit: impl FnMut(R) -> ControlFlow<()>) {
        let [a, b, c, ..] = self.c;
        let (two, three) = (R::of(2.0), R::of(3.0));
        let slope = [R::of(4.0) * a, three * b, two * c];
        let mut last = from;
        let mut last_slope = self.slope_at(slope, from).0;
        if visit(from).is_break() {
            return;
        }
        let [first, second] = quadratic(three * slope[0], two * slope[1], slope[2]);
        for bend in [first, second, to] {
            // Only a number beyond the last point divides the interval; a NaN fails the comparison.
            if !(bend > last && bend <= to) {
                continue;
            }
            let s = self.slope_at(slope, bend).0;
            if last_slope < R::ZERO && s > R::ZERO || last_slope > R::ZERO && s < R::ZERO {
                let precision = R::ROUNDOFF * (to - from);
                let start = (last + bend) * R::of(0.5);
                let f = |x| self.slope_at(slope, x);
                let stationary = root_between(f, (last, bend), s > R::ZERO, start, precision);
                if stationary > last && visit(stationary).is_break() {
                    return;
                }
                last = last.max(stationary);
            }
            if bend > last && visit(bend).is_break() {
                return;
            }
            (last, last_slope) = (bend, s);
        }
    }
}

/// The roots of at² + bt + c, ascending. If the discriminant is not above 0, the place of the extremum, twice: near the
/// roots if rounding has hidden them. At least one of the two is not finite if a vanishes.
fn quadratic<R: Real>(a: R, b: R, c: R) -> [R; 2] {
    let b = -b * R::of(0.5);
    let discriminant = R::difference_of_products(b, b, a, c);
    if discriminant > R::ZERO {
        let s = discriminant.sqrt();
        let q = if b < R::ZERO { b - s } else { b + s };
        let (t0, t1) = (c / q, q / a);
        if t0 < t1 || t1.is_nan() {
            [t0, t1]
        } else {
            [t1, t0]
        }
    } else {
        [b / a; 2]
    }
}

/// The root of a function that changes sign between the two ends of a bracket, to within the given precision; if it
/// does not change sign, some number between them. `f` returns the value and the slope; `rising` is whether the sign
/// changes from below 0 to above.
///
/// Newton's method from `start`; it bisects wherever a step would leave the bracket or exceeds half
/// of the one before, so that every step halves either the steps or the bracket.
#[inline]
pub(super) fn root_between<R: Real>(
    f: impl Fn(R) -> (R, R),
    (mut low, mut high): (R, R),
    rising: bool,
    start: R,
    precision: R,
) -> R {
    // Twice the bits of the finest number, since a bracket that tight has nothing left to halve.
    const MOST_STEPS: u32 = 256;
    let half = R::of(0.5);
    let middle = |low: R, high: R| low + (high - low) * half;
    let mut x = if start > low && start < high {
        start
    } else {
        middle(low, high)
    };
    let mut last = high - low;
    for _ in 0..MOST_STEPS {
        let (value, slope) = f(x);
        if value == R::ZERO {
            break;
        }
        if (value > R::ZERO) == rising {
            high = x;
        } else {
            low = x;
        }
        let step = -value / slope;
        let newton = x + step;
        // A NaN fails the comparisons.
        let (next, size) = if newton >= low && newton <= high && step.abs() <= last * half {
            (newton, step.abs())
        } else {
            (middle(low, high), (high - low) * half)
        };
        let moved = next != x;
        x = next;
        if size <= precision || !moved {
            break;
        }
        last = size;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dd::Dd;

    /// All points that an interval falls apart at.
    fn points<R: Real>(q: &Quartic<R>, from: R, to: R) -> Vec<R> {
        let mut all = Vec::new();
        q.pieces(from, to, |t| {
            all.push(t);
            ControlFlow::Continue(())
        });
        // Who breaks off has seen the first of them.
        for count in 1..=all.len() {
            let mut seen = Vec::new();
            q.pieces(from, to, |t| {
                seen.push(t);
                match seen.len() < count {
                    true => ControlFlow::Continue(()),
                    false => ControlFlow::Break(()),
                }
            });
            assert!(seen == all[..count]);
        }
        all
    }

    /// All roots, by the sign of the quartic at the points its interval falls apart at.
    fn roots<R: Real>(c: [f64; 5], from: f64, to: f64) -> Vec<f64> {
        let q = Quartic { c: c.map(R::of) };
        points(&q, R::of(from), R::of(to))
            .windows(2)
            .filter_map(|p| {
                let (a, b) = (q.at(p[0]).0, q.at(p[1]).0);
                let precision = R::ROUNDOFF * R::of(to - from);
                ((a < R::ZERO) != (b < R::ZERO)).then(|| {
                    let start = (p[0] + p[1]) * R::of(0.5);
                    let f = |t| q.at(t);
                    root_between(f, (p[0], p[1]), b > a, start, precision).to_f64()
                })
            })
            .collect()
    }

    /// t⁴ + 2t³ + 3t² + 4t + 5 at 2: 32 + 24 + 12 + 4, 48 + 24 + 6 and 48 + 12.
    #[test]
    fn derivatives_by_hand() {
        let q = Quartic {
            c: [1.0, 2.0, 3.0, 4.0, 5.0],
        };
        assert_eq!(q.derivatives(2.0), [72.0, 78.0, 60.0]);
    }

    #[test]
    fn two_quartics_that_closed_forms_get_wrong() {
        let c = [1.0, -240.0, 25449.0, -1325880.0, 26471900.25];
        for found in [roots::<f64>(c, -1e3, 1e3), roots::<Dd>(c, -1e3, 1e3)] {
            assert_eq!(found.len(), 2);
            assert!((found[0] - 50.6451127).abs() < 1e-7, "{found:?}");
            assert!((found[1] - 69.3548873).abs() < 1e-7, "{found:?}");
        }
        let c = [1.0, -198.995, 15006.6, -508127.0, 6.52025e6];
        assert!(roots::<f64>(c, -1e3, 1e3).is_empty());
        assert!(roots::<Dd>(c, -1e3, 1e3).is_empty());
    }

    /// (t − 1)(t − 2)(t − 3)(t − 4) and those with fewer factors, over twice the range of scales
    /// of a float.
    #[test]
    fn lower_degrees_and_scales() {
        let all = [1.0, -10.0, 35.0, -50.0, 24.0];
        let cases: [([f64; 5], &[f64]); 5] = [
            (all, &[1.0, 2.0, 3.0, 4.0]),
            ([0.0, 1.0, -6.0, 11.0, -6.0], &[1.0, 2.0, 3.0]),
            ([0.0, 0.0, 1.0, -3.0, 2.0], &[1.0, 2.0]),
            ([0.0, 0.0, 0.0, 2.0, -3.0], &[1.5]),
            ([0.0; 5], &[]),
        ];
        for (c, expected) in cases {
            for scale in [1e-80, 1.0, 1e80] {
                for stretch in [1e-15, 1.0, 1e15f64] {
                    let c: [f64; 5] =
                        std::array::from_fn(|i| scale * c[i] * stretch.powi(i as i32));
                    let found = roots::<f64>(c, -10.0 * stretch, 9.0 * stretch);
                    assert_eq!(found.len(), expected.len(), "{c:?}");
                    for (x, y) in found.iter().zip(expected) {
                        assert!((x / stretch - y).abs() < 1e-12, "{x} {y} {stretch}");
                    }
                }
            }
        }
    }

    #[test]
    fn points_are_numbers_in_order_whatever_the_coefficients() {
        let values = [
            0.0,
            1.0,
            -1.0,
            1e-320,
            -1e308,
            1e308,
            1e-160,
            f64::NAN,
            f64::INFINITY,
        ];
        let n = values.len();
        for i in 0..n.pow(5) {
            let c = std::array::from_fn(|k| values[i / n.pow(k as u32) % n]);
            let q = Quartic { c };
            let p = points(&q, -3.0, 1e9);
            assert!(p.first() == Some(&-3.0) && p.last() == Some(&1e9));
            assert!(p.windows(2).all(|w| w[0] < w[1]), "{c:?} {p:?}");
            let root = root_between(|t| q.at(t), (-3.0, 1e9), true, 0.0, 1e-7);
            assert!((-3.0..=1e9).contains(&root));
        }
    }
}
