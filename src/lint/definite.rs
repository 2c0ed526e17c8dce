//! What a quadratic form can be, proved: xᵀQx with x = (x, y, z, 1), by eliminating one variable
//! after the other in arithmetic that bounds its own rounding.

use std::ops::{Mul, Sub};

/// What is certain about the set xᵀQx ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The form is positive everywhere: no point at all.
    Empty,
    /// The form is nowhere positive, and not zero everywhere: all of space, with no surface.
    Full,
    /// The form is nowhere negative, and zero on a flat of this many dimensions, 0 to 2.
    Flat(u32),
    /// All 16 numbers cancel: the form is zero everywhere.
    Zero,
    /// It has an inside and an outside, or that could not be told.
    Other,
}

/// An interval that holds the true value; a point where no rounding has happened.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: f64,
    high: f64,
}

/// Products smaller than this may have lost their error term to underflow.
const SAFE_PRODUCT: f64 = 1e-280;

impl Bounds {
    fn exactly(x: f64) -> Bounds {
        Bounds { low: x, high: x }
    }

    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// The hull of results that were rounded to nearest, each with its rounding error.
    fn hull(results: &[(f64, f64)]) -> Bounds {
        let mut out = Bounds {
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
        };
        for &(x, error) in results {
            // An error that is not a number comes of overflow: nothing is known then.
            let (low, high) = match error {
                0.0 => (x, x),
                e if e.is_finite() => (x.next_down(), x.next_up()),
                _ => (f64::NEG_INFINITY, f64::INFINITY),
            };
            out.low = out.low.min(low);
            out.high = out.high.max(high);
        }
        out
    }

    /// self / other for an `other` above zero.
    fn over(self, other: Bounds) -> Bounds {
        let quotient = |a: f64, b: f64| {
            let q = a / b;
            (q, lost(a != 0.0, q * b, q.mul_add(-b, a)))
        };
        Bounds::hull(&[
            quotient(self.low, other.low),
            quotient(self.low, other.high),
            quotient(self.high, other.low),
            quotient(self.high, other.high),
        ])
    }
}

/// The error of a product that came out as `p`: not trusted where it can have underflowed.
fn lost(nonzero: bool, p: f64, error: f64) -> f64 {
    if nonzero && p.abs() < SAFE_PRODUCT {
        return f64::MIN_POSITIVE;
    }
    error
}

impl Mul for Bounds {
    type Output = Bounds;
    fn mul(self, other: Bounds) -> Bounds {
        let product = |a: f64, b: f64| {
            let p = a * b;
            (p, lost(a != 0.0 && b != 0.0, p, a.mul_add(b, -p)))
        };
        Bounds::hull(&[
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ])
    }
}

impl Sub for Bounds {
    type Output = Bounds;
    fn sub(self, other: Bounds) -> Bounds {
        // a − b = s + e exactly (Knuth).
        let difference = |a: f64, b: f64| {
            let s = a - b;
            let back = s - a;
            (s, (a - (s - back)) - (b + back))
        };
        Bounds::hull(&[
            difference(self.low, other.high),
            difference(self.high, other.low),
        ])
    }
}

/// What is certain about the quadric with these 16 numbers, row by row.
pub fn judge(q: &[f64; 16]) -> Verdict {
    // Divided by a power of two, which is exact, so that products neither overflow nor vanish.
    let largest = q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest == 0.0 {
        return Verdict::Zero;
    }
    let down = 2f64.powi(-largest.log2().floor().clamp(-1000.0, 1000.0) as i32);
    let mut form = [[Bounds::exactly(0.0); 4]; 4];
    for (i, row) in form.iter_mut().enumerate() {
        for (j, x) in row.iter_mut().enumerate() {
            let (a, b) = (q[4 * i + j] * down, -q[4 * j + i] * down);
            *x = (Bounds::exactly(a) - Bounds::exactly(b)) * Bounds::exactly(0.5);
        }
    }
    if form.iter().flatten().all(|x| x.is_zero()) {
        return Verdict::Zero;
    }
    let negative = form.map(|row| row.map(|x| Bounds::exactly(0.0) - x));
    match (lowest(form), lowest(negative)) {
        (Some((least, _)), _) if least.low > 0.0 => Verdict::Empty,
        (_, Some((least, _))) if least.low > 0.0 => Verdict::Full,
        (Some((least, rank @ 1..)), _) if least.is_zero() => Verdict::Flat(3 - rank),
        // Zero on a flat, negative elsewhere: the flat has the object on both sides.
        (_, Some((least, 1..))) if least.is_zero() => Verdict::Full,
        _ => Verdict::Other,
    }
}

/// The least value of a form that is convex for certain, and the rank of its square part; `None`
/// where that cannot be told.
fn lowest(mut s: [[Bounds; 4]; 4]) -> Option<(Bounds, u32)> {
    let mut left = vec![0usize, 1, 2];
    let mut rank = 0;
    while !left.is_empty() {
        let best = left
            .iter()
            .copied()
            .max_by(|&i, &j| s[i][i].low.total_cmp(&s[j][j].low))?;
        if s[best][best].low > 0.0 {
            // Completing the square in this variable.
            left.retain(|&i| i != best);
            rank += 1;
            let others: Vec<usize> = left.iter().copied().chain([3]).collect();
            for &i in &others {
                for &j in &others {
                    s[i][j] = s[i][j] - (s[best][i] * s[best][j]).over(s[best][best]);
                }
            }
        } else {
            // The rest must not depend on any variable that is left.
            let constant = |i: usize| left.iter().chain(&[3]).all(|&j| s[i][j].is_zero());
            return left.iter().all(|&i| constant(i)).then_some((s[3][3], rank));
        }
    }
    Some((s[3][3], rank))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagonal(d: [f64; 4]) -> [f64; 16] {
        let mut q = [0.0; 16];
        (0..4).for_each(|i| q[5 * i] = d[i]);
        q
    }

    #[test]
    fn canonical_forms() {
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, 1.0])), Verdict::Empty);
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, -1.0])), Verdict::Other);
        assert_eq!(judge(&diagonal([1.0, 0.0, 0.0, 1e-300])), Verdict::Empty);
        assert_eq!(judge(&diagonal([-1.0, 0.0, -2.0, -1.0])), Verdict::Full);
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, 0.0])), Verdict::Flat(0));
        assert_eq!(judge(&diagonal([1.0, 0.0, 2.0, 0.0])), Verdict::Flat(1));
        assert_eq!(judge(&diagonal([0.0, 0.1, 0.0, 0.0])), Verdict::Flat(2));
        assert_eq!(judge(&diagonal([1.0, 1.0, -1.0, 5.0])), Verdict::Other);
        assert_eq!(judge(&[0.0; 16]), Verdict::Zero);
    }

    #[test]
    fn turned_round_a_flat_fills_space() {
        for d in [
            [-1.0, -1.0, -1.0, 0.0],
            [-1.0, 0.0, -2.0, 0.0],
            [0.0, -0.1, 0.0, 0.0],
        ] {
            assert_eq!(judge(&diagonal(d)), Verdict::Full, "{d:?}");
        }
        // −(x − 2)² + e, with e none, half an ulp of 4 either way.
        let moved = |c: f64| {
            let mut q = diagonal([-1.0, 0.0, 0.0, c]);
            (q[3], q[12]) = (2.0, 2.0);
            q
        };
        assert_eq!(judge(&moved(-4.0)), Verdict::Full);
        assert_eq!(judge(&moved((-4.0f64).next_down())), Verdict::Full);
        assert_eq!(judge(&moved((-4.0f64).next_up())), Verdict::Other);
        // −(x − 0.1)²: 0.1·0.1 is rounded, so that nothing is known.
        let mut odd = diagonal([-1.0, 0.0, 0.0, -(0.1 * 0.1)]);
        (odd[3], odd[12]) = (0.1, 0.1);
        assert_eq!(judge(&odd), Verdict::Other);
        // −x² + y, −x² + z²: surfaces.
        let mut bowl = diagonal([-1.0, 0.0, 0.0, 0.0]);
        (bowl[7], bowl[13]) = (0.5, 0.5);
        assert_eq!(judge(&bowl), Verdict::Other);
        assert_eq!(judge(&diagonal([-1.0, 0.0, 1.0, 0.0])), Verdict::Other);
    }

    #[test]
    fn at_the_edge_it_is_silent_or_right() {
        // (x − 0.1)² + e: 0.1 is no double, so that the square's constant is not the square of 0.1.
        let moved = |e: f64| {
            let mut q = diagonal([1.0, 0.0, 0.0, 0.1 * 0.1 + e]);
            (q[3], q[12]) = (-0.1, -0.1);
            q
        };
        assert_eq!(judge(&moved(0.0)), Verdict::Other);
        assert_eq!(judge(&moved(1e-16)), Verdict::Empty);
        assert_eq!(judge(&moved(-1e-16)), Verdict::Other);
        // (x − 2)² exactly, a plane; and with an asymmetric matrix of the same symmetric part.
        let mut plane = diagonal([1.0, 0.0, 0.0, 4.0]);
        plane[3] = -4.0;
        assert_eq!(judge(&plane), Verdict::Flat(2));
        // (x + y)² + z + 1 has points wherever z < −1.
        let mut trough = diagonal([1.0, 1.0, 0.0, 1.0]);
        (trough[1], trough[4], trough[14]) = (1.0, 1.0, 1.0);
        assert_eq!(judge(&trough), Verdict::Other);
        trough[14] = 0.0;
        assert_eq!(judge(&trough), Verdict::Empty);
    }

    #[test]
    fn extreme_numbers_decide_nothing_wrongly() {
        for scale in [1e-320, 1e-300, 1e300, f64::MAX] {
            assert_eq!(judge(&diagonal([scale; 4])), Verdict::Empty, "{scale}");
            let ball = diagonal([scale, scale, scale, -scale]);
            assert_eq!(judge(&ball), Verdict::Other, "{scale}");
        }
        // x² + 2·1e-200·x: negative between −2e-200 and 0, though the square underflows.
        let mut q = diagonal([1.0, 0.0, 0.0, 0.0]);
        q[3] = 2e-200;
        assert_eq!(judge(&q), Verdict::Other);
    }
}
