//! Roots of polynomials by the formulas of textbooks: Cardano's and Ferrari's as in Schwarze, "Cubic and Quartic Roots"
//! (Graphics Gems, 1990). In numbers that have digits to spare, roots are found by halving between the roots of the
//! derivative.

use super::number::Number;

/// A list of at most four roots.
#[derive(Debug, Clone, Copy)]
pub struct Few<T> {
    list: [T; 4],
    count: usize,
}

impl<T: Number> Default for Few<T> {
    fn default() -> Few<T> {
        Few::new()
    }
}

impl<T: Number> Few<T> {
    pub fn new() -> Few<T> {
        Few {
            list: [T::of(0.0); 4],
            count: 0,
        }
    }

    pub fn push(&mut self, t: T) {
        if let Some(place) = self.list.get_mut(self.count) {
            *place = t;
            self.count += 1;
        }
    }

    pub fn all(&self) -> &[T] {
        &self.list[..self.count]
    }
}

/// Appends the real roots of ax² + bx + c.
pub fn quadratic<T: Number>(a: T, b: T, c: T, roots: &mut Few<T>) {
    if a.abs() < T::TINY {
        if b.abs() >= T::TINY {
            roots.push(-c / b);
        }
        return;
    }
    let discriminant = b * b - T::of(4.0) * a * c;
    if discriminant >= T::of(0.0) {
        let root = discriminant.sqrt();
        let twice = T::of(2.0) * a;
        roots.push((-b - root) / twice);
        roots.push((-b + root) / twice);
    }
}

/// A real root of x³ + ax² + bx + c, the first one that the formula gives.
fn cubic_root<T: Number>(a: T, b: T, c: T) -> T {
    let n = T::of;
    let p = (b - a * a / n(3.0)) / n(3.0);
    let q = (n(2.0 / 27.0) * a * a * a - a * b / n(3.0) + c) / n(2.0);
    let discriminant = q * q + p * p * p;
    let depressed = if discriminant < n(0.0) {
        let angle = (-q / (-p * p * p).sqrt()).acos() / n(3.0);
        n(2.0) * (-p).sqrt() * angle.cos()
    } else {
        let root = discriminant.sqrt();
        (root - q).cbrt() - (root + q).cbrt()
    };
    depressed - a / n(3.0)
}

/// Appends the real roots of x⁴ + ax³ + bx² + cx + d. The formula gives a double root twice.
pub fn quartic<T: Number>([a, b, c, d]: [T; 4], roots: &mut Few<T>) {
    if !T::TEXTBOOK {
        isolated([d, c, b, a, T::of(1.0)], roots);
        return;
    }
    let n = T::of;
    let aa = a * a;
    let p = b - n(0.375) * aa;
    let q = n(0.125) * aa * a - n(0.5) * a * b + c;
    let r = n(-3.0 / 256.0) * aa * aa + n(1.0 / 16.0) * aa * b - n(0.25) * a * c + d;
    let z = cubic_root(n(-0.5) * p, -r, n(0.5) * r * p - n(0.125) * q * q);
    let square_root = |x: T| match x {
        x if x.abs() < T::TINY => Some(n(0.0)),
        x if x > n(0.0) => Some(x.sqrt()),
        _ => None,
    };
    let (Some(u), Some(v)) = (square_root(z * z - r), square_root(n(2.0) * z - p)) else {
        return;
    };
    let v = if q < n(0.0) { -v } else { v };
    let first = roots.count;
    quadratic(n(1.0), v, z - u, roots);
    quadratic(n(1.0), -v, z + u, roots);
    for root in &mut roots.list[first..roots.count] {
        *root = *root - a / n(4.0);
    }
}

/// The value at `x` of a polynomial whose coefficients begin with the constant.
fn value<T: Number>(polynomial: &[T], x: T) -> T {
    let zero = T::of(0.0);
    polynomial.iter().rev().fold(zero, |sum, &c| sum * x + c)
}

/// Finds the roots at which the sign of a polynomial changes, ascending. The coefficients have the constant first, and
/// the leading one is 1. Between two roots of the derivative in a row, or an end, there is one root or none, which
/// halving finds.
fn isolated<T: Number>(polynomial: [T; 5], roots: &mut Few<T>) {
    let zero = T::of(0.0);
    // Cauchy: no root is farther from zero.
    let most = polynomial[..4]
        .iter()
        .fold(zero, |m, c| if c.abs() > m { c.abs() } else { m });
    let bound = most + T::of(1.0);
    // The derivatives, from the linear one up.
    let mut chain = vec![polynomial.to_vec()];
    while let Some(last) = chain.last().filter(|p| p.len() > 2) {
        let derived = (last.iter().enumerate().skip(1)).map(|(i, &c)| c * T::of(i as f64));
        let derived = derived.collect();
        chain.push(derived);
    }
    let mut ends: Vec<T> = Vec::new();
    for polynomial in chain.iter().rev() {
        let mut found = Vec::new();
        let mut low = -bound;
        for high in ends.iter().copied().chain([bound]) {
            if let Some(root) = halved(polynomial, low, high) {
                found.push(root);
            }
            low = high;
        }
        ends = found;
    }
    ends.into_iter().for_each(|t| roots.push(t));
}

/// The root between `low` and `high`; `None` if the polynomial has the same sign at both.
fn halved<T: Number>(polynomial: &[T], mut low: T, mut high: T) -> Option<T> {
    let zero = T::of(0.0);
    let rises = value(polynomial, low) < zero;
    if rises == (value(polynomial, high) < zero) {
        return None;
    }
    let derived: Vec<T> = (polynomial.iter().enumerate().skip(1))
        .map(|(i, &c)| c * T::of(i as f64))
        .collect();
    let half = T::of(0.5);
    let mut x = (low + high) * half;
    // Newton's step is taken where it stays between the ends, halving otherwise.
    for _ in 0..400 {
        let here = value(polynomial, x);
        if (here < zero) == rises {
            low = x;
        } else {
            high = x;
        }
        let next = x - here / value(&derived, x);
        let within = next > low && next < high;
        let next = if within { next } else { (low + high) * half };
        if next == x || low >= high {
            break;
        }
        let step = (next - x).abs();
        x = next;
        if step <= T::TINY * (T::of(1.0) + x.abs()) {
            break;
        }
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::super::number::Wide;
    use super::*;

    #[test]
    fn four_roots_two_close_ones_and_none() {
        // (x − 1)(x + 2)(x − 3)(x − 3.000001), and (x² + 1)(x² + 4).
        let w = Wide::of;
        let product = |roots: [f64; 4]| {
            let mut p = vec![w(1.0)];
            for root in roots {
                let mut next = vec![w(0.0); p.len() + 1];
                for (i, &c) in p.iter().enumerate() {
                    next[i + 1] = next[i + 1] + c;
                    next[i] = next[i] - c * w(root);
                }
                p = next;
            }
            [p[3], p[2], p[1], p[0]]
        };
        let mut roots = Few::new();
        quartic(product([1.0, -2.0, 3.0, 3.000_001]), &mut roots);
        let found: Vec<f64> = roots.all().iter().map(|r| r.wide()).collect();
        assert_eq!(found.len(), 4, "{found:?}");
        for (found, meant) in found.iter().zip([-2.0, 1.0, 3.0, 3.000_001]) {
            assert!((found - meant).abs() < 1e-14, "{found} {meant}");
        }
        let mut roots = Few::new();
        quartic([0.0, 5.0, 0.0, 4.0].map(w), &mut roots);
        assert!(roots.all().is_empty());
        // The formula agrees where that is easy.
        let mut roots = Few::new();
        quartic([-2.0, -13.0, 14.0, 24.0], &mut roots);
        let mut found = roots.all().to_vec();
        found.sort_by(f64::total_cmp);
        for (found, meant) in found.iter().zip([-3.0, -1.0, 2.0, 4.0]) {
            assert!((found - meant).abs() < 1e-9, "{found}");
        }
    }
}
