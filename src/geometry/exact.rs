//! Exact signs of numbers that are made of doubles by sums and products alone.

use std::array;

use dashu_int::{IBig, Sign};

/// Finite doubles as whole numbers: all are multiplied by one power of two.
pub fn whole<const N: usize>(numbers: [f64; N]) -> [IBig; N] {
    let parts = numbers.map(parts);
    let exponents = parts.iter().filter(|p| p.0 != 0).map(|p| p.1);
    let least = exponents.min().unwrap_or(0);
    let mut parts = parts.into_iter();
    array::from_fn(|_| match parts.next() {
        None | Some((0, _)) => IBig::ZERO,
        Some((mantissa, exponent)) => IBig::from(mantissa) << (exponent - least) as usize,
    })
}

/// The whole number m and the exponent e of a finite double m · 2ᵉ.
fn parts(x: f64) -> (i64, i32) {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = x.to_bits();
    let field = (bits >> FRACTION & 0x7ff) as i32;
    let fraction = (bits & ((1 << FRACTION) - 1)) as i64;
    let (mantissa, exponent) = match field {
        0 => (fraction, 1),
        _ => (fraction | 1 << FRACTION, field),
    };
    let mantissa = if x < 0.0 { -mantissa } else { mantissa };
    (mantissa, exponent - 1075)
}

/// The sign of a number: 1, -1 or 0.
pub fn sign(x: &IBig) -> i32 {
    match x.sign() {
        _ if x.is_zero() => 0,
        Sign::Positive => 1,
        Sign::Negative => -1,
    }
}

/// The determinant of a matrix of doubles, times a power of two, by elimination without fractions (Bareiss,
/// "Sylvester's identity and multistep integer-preserving Gaussian elimination", 1968).
pub fn determinant<const N: usize>(rows: [[f64; N]; N]) -> IBig {
    // Each row is multiplied by a power of two of its own, so that large numbers in one row make no other row longer.
    let mut m = rows.map(whole);
    let mut before = IBig::ONE;
    let mut swapped = false;
    for step in 0..N {
        let Some(row) = (step..N).find(|&i| !m[i][step].is_zero()) else {
            return IBig::ZERO;
        };
        swapped ^= row != step;
        m.swap(step, row);
        let (done, rest) = m.split_at_mut(step + 1);
        let pivot = &done[step];
        for row in rest {
            for j in (step + 1..N).rev() {
                row[j] = (&pivot[step] * &row[j] - &row[step] * &pivot[j]) / &before;
            }
        }
        before = pivot[step].clone();
    }
    if swapped { -before } else { before }
}

/// Whether two vectors point along one line, in equal or opposite directions, or one of them is zero.
pub fn parallel(a: [f64; 3], b: [f64; 3]) -> bool {
    let (a, b) = (whole(a), whole(b));
    (0..3).all(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] == &a[k] * &b[j]
    })
}

/// Whether all points lie in one line, as fewer than three always do.
pub fn collinear<const N: usize>(points: impl IntoIterator<Item = [f64; N]>) -> bool {
    let mut points = points.into_iter();
    let Some(first) = points.next() else {
        return true;
    };
    let mut along: Option<[f64; N]> = None;
    points.filter(|p| *p != first).all(|p| {
        let second = *along.get_or_insert(p);
        in_line(first, second, p)
    })
}

fn in_line<const N: usize>(a: [f64; N], b: [f64; N], c: [f64; N]) -> bool {
    // Each coordinate is multiplied by a power of two of its own, which turns lines into lines.
    let differences: [[IBig; 2]; N] = array::from_fn(|i| {
        let [a, b, c] = whole([a[i], b[i], c[i]]);
        [b - &a, c - a]
    });
    let cross = |i: usize, j: usize| {
        &differences[i][0] * &differences[j][1] == &differences[j][0] * &differences[i][1]
    };
    (0..N).all(|i| (i + 1..N).all(|j| cross(i, j)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    /// Numbers of which sums cancel often, and those at the ends of what a double can be.
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => (-3..4i32).prop_map(f64::from),
            2 => (-9..10i32).prop_map(|x| f64::from(x) / 10.0),
            1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
            1 => Just(5e-324),
            1 => Just(f64::MAX),
        ]
    }

    fn exact(x: f64) -> RBig {
        RBig::try_from(x).unwrap()
    }

    fn rational_sign(x: &RBig) -> i32 {
        i32::from(*x > RBig::ZERO) - i32::from(*x < RBig::ZERO)
    }

    /// The determinant by Laplace's expansion.
    fn plain_determinant(m: &[Vec<RBig>]) -> RBig {
        if m.is_empty() {
            return RBig::ONE;
        }
        (0..m.len()).fold(RBig::ZERO, |sum, j| {
            let minor: Vec<Vec<RBig>> = (m[1..].iter())
                .map(|row| [&row[..j], &row[j + 1..]].concat())
                .collect();
            let term = &m[0][j] * plain_determinant(&minor);
            if j % 2 == 0 { sum + term } else { sum - term }
        })
    }

    proptest! {
        #[test]
        fn determinants(numbers in prop::collection::vec(number(), 16), twice in any::<bool>()) {
            let mut rows: [[f64; 4]; 4] = array::from_fn(|i| array::from_fn(|j| numbers[4 * i + j]));
            if twice {
                rows[3] = rows[1].map(|x| x / 2.0);
            }
            let plain = rows.map(|row| row.map(exact).to_vec());
            prop_assert_eq!(sign(&determinant(rows)), rational_sign(&plain_determinant(&plain)));
        }

        #[test]
        fn lines_and_directions(n in prop::collection::vec(number(), 6), along in any::<bool>()) {
            let (a, b) = ([n[0], n[1]], [n[2], n[3]]);
            let half = |x: f64, y: f64| x / 2.0 + y / 2.0;
            let p = if along { [half(a[0], b[0]), half(a[1], b[1])] } else { [n[4], n[5]] };
            let d = |p: [f64; 2], i: usize| exact(p[i]) - exact(a[i]);
            let cross = d(b, 0) * d(p, 1) - d(b, 1) * d(p, 0);
            prop_assert_eq!(collinear([a, b, p]), cross == RBig::ZERO);
            let flat = |p: [f64; 2]| [p[0], p[1], 0.0];
            let zero = exact(b[0]) * exact(p[1]) == exact(b[1]) * exact(p[0]);
            prop_assert_eq!(parallel(flat(b), flat(p)), zero);
        }
    }

    #[test]
    fn what_rounding_hides() {
        assert!(collinear([[0.1, 0.1], [0.2, 0.2], [0.4, 0.4]]));
        assert!(!collinear([
            [0.1, 0.2],
            [0.2, 0.4],
            [0.3, 0.6000000000000001]
        ]));
        assert_eq!(sign(&determinant([[1e-200, 0.0], [0.0, 1e-200]])), 1);
        assert_eq!(
            sign(&determinant([
                [1.0, 2.0, 3.0],
                [4.0, 5.0, 6.0],
                [7.0, 8.0, 9.0]
            ])),
            0
        );
    }
}
