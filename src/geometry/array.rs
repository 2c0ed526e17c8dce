//! Vector algebra on plain arrays of doubles, as far as a scene's geometry needs it, and a function of every element.

/// Applies a function to every element. `[T; N]::map` and `array::from_fn` compute the same, but are inlined only where
/// the compiler has put them into the codegen unit of their caller. An empty array does not compile.
#[inline]
pub fn each<T: Copy, U: Copy, const N: usize>(all: [T; N], mut f: impl FnMut(T) -> U) -> [U; N] {
    const { assert!(N > 0) };
    let mut images = [f(all[0]); N];
    for i in 1..N {
        images[i] = f(all[i]);
    }
    images
}

/// a + `times` · b.
#[inline]
pub fn add(a: [f64; 3], b: [f64; 3], times: f64) -> [f64; 3] {
    each([0, 1, 2], |i| a[i] + b[i] * times)
}

#[inline]
pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    add(a, b, -1.0)
}

#[inline]
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The length, however large or small the components.
pub fn length(a: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(a[0], a[1]), a[2])
}

/// The unit vector in the direction of a vector of any length. `None` if the vector is zero or not finite.
pub fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let largest = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let v = each(v, |x| x / largest);
    let length = dot(v, v).sqrt();
    Some(each(v, |x| x / length))
}

/// Two vectors at right angles to a unit vector and to each other; the first is no shorter than √⅔, the
/// second as long.
pub fn across(n: [f64; 3]) -> [[f64; 3]; 2] {
    let least = (0..3).fold(0, |i, j| if n[j].abs() < n[i].abs() { j } else { i });
    let axis = each([0, 1, 2], |i| f64::from(u8::from(i == least)));
    let u = cross(n, axis);
    [u, cross(n, u)]
}

pub fn middle(points: &[[f64; 3]]) -> [f64; 3] {
    let n = points.len().max(1) as f64;
    points.iter().fold([0.0; 3], |sum, p| add(sum, *p, 1.0 / n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_of_any_length() {
        for size in [5e-324, 1e-200, 1.0, 1e200] {
            let n = unit([3.0 * size, 0.0, 4.0 * size]).unwrap();
            assert!((length(n) - 1.0).abs() < 1e-15);
        }
        assert_eq!(unit([0.0; 3]), None);
        assert_eq!(unit([f64::INFINITY, 0.0, 0.0]), None);
        assert_eq!(unit([f64::NAN; 3]), None);
    }

    #[test]
    fn what_is_across_stands_upright_on_it() {
        for n in [[1.0, 0.0, 0.0], [0.6, 0.0, -0.8], [0.48, 0.6, 0.64]] {
            let [u, v] = across(n);
            for (a, b) in [(n, u), (n, v), (u, v)] {
                assert!(dot(a, b).abs() < 1e-15);
            }
            assert!(length(u) >= (2.0f64 / 3.0).sqrt() - 1e-15);
            assert!((length(u) - length(v)).abs() < 1e-15);
        }
    }
}
