//! The icosahedron that geodesic spheres begin with.

/// The facets, counter-clockwise as seen from outside. The vertices 4i … 4i + 3 have 0, ±1, ±φ along
/// the axes i, i + 1, i + 2 (counted round), the signs in the order ++, +−, −+, −−.
pub const FACES: [[usize; 3]; 20] = [
    [0, 2, 4],
    [0, 4, 8],
    [0, 5, 2],
    [0, 8, 10],
    [0, 10, 5],
    [1, 3, 7],
    [1, 6, 3],
    [1, 7, 10],
    [1, 8, 6],
    [1, 10, 8],
    [2, 5, 11],
    [2, 9, 4],
    [2, 11, 9],
    [3, 6, 9],
    [3, 9, 11],
    [3, 11, 7],
    [4, 6, 8],
    [4, 9, 6],
    [5, 7, 11],
    [5, 10, 7],
];

/// The vertices, on the unit sphere.
pub fn vertices() -> [[f64; 3]; 12] {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let length = (1.0 + phi * phi).sqrt();
    std::array::from_fn(|v| {
        let (axis, signs) = (v / 4, v % 4);
        let sign = |negative: bool| if negative { -1.0 } else { 1.0 };
        let mut p = [0.0; 3];
        p[(axis + 1) % 3] = sign(signs & 2 != 0) / length;
        p[(axis + 2) % 3] = sign(signs & 1 != 0) * phi / length;
        p
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_edges_are_equal_and_facets_turn_outwards() {
        let v = vertices();
        let minus = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| a[i] - b[i]) };
        let dot = |a: [f64; 3], b: [f64; 3]| -> f64 { (0..3).map(|i| a[i] * b[i]).sum() };
        let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                a[j] * b[k] - a[k] * b[j]
            })
        };
        // 4 / (1 + φ²) for edges of length 2.
        let edge = 4.0 / (1.0 + 1.618_033_988_749_895_f64.powi(2));
        for [a, b, c] in FACES.map(|f| f.map(|i| v[i])) {
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let d = minus(p, q);
                assert!((dot(d, d) - edge).abs() < 1e-14);
            }
            assert!(dot(cross(minus(b, a), minus(c, a)), a) > 0.0);
        }
    }
}
