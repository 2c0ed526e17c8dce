//! Roots in closed form: the formulas of the schoolbook, Cardano and Ferrari, the latter two as in
//! Schwarze, "Cubic and Quartic Roots" (Graphics Gems, 1990).

use super::number::Number;

/// Appends the real roots of ax² + bx + c.
pub fn quadratic<T: Number>(a: T, b: T, c: T, roots: &mut Vec<T>) {
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

/// Some real root of x³ + ax² + bx + c, the first one that the formula gives.
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

/// Appends the real roots of x⁴ + ax³ + bx² + cx + d; double roots come twice.
pub fn quartic<T: Number>([a, b, c, d]: [T; 4], roots: &mut Vec<T>) {
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
    let first = roots.len();
    quadratic(n(1.0), v, z - u, roots);
    quadratic(n(1.0), -v, z + u, roots);
    for root in &mut roots[first..] {
        *root = *root - a / n(4.0);
    }
}
