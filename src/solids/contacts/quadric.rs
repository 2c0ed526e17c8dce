//! Quadrics as faces: a number that tells them apart, and points at which they are tried.

use super::directions::{Sample, direction};
use crate::geometry::Matrix;
use crate::geometry::array::{add, dot, length};
use crate::scene::Vec3;

/// A symmetric matrix Q of xᵀQx = 0.
pub type QuadricMatrix = [[f64; 4]; 4];

/// A number that tells a quadric, moved by `m`, from others. It does not depend on a factor of the matrix. `None` if
/// `m` has no inverse.
pub fn fingerprint(form: &QuadricMatrix, m: &Matrix) -> Option<f64> {
    let back = m.inverse()?.0;
    // One weight for each entry, none a multiple of another.
    let weight = |i: usize, j: usize| ((i * j) as f64 + 1.0).sqrt() + (i + j) as f64 * 0.377;
    let (mut sum, mut squares) = (0.0, 0.0);
    for i in 0..4 {
        for j in 0..4 {
            let entry: f64 = (0..16)
                .map(|k| back[k / 4][i] * form[k / 4][k % 4] * back[k % 4][j])
                .sum();
            sum += weight(i, j) * entry;
            squares += entry * entry;
        }
    }
    Some((sum / squares.sqrt()).abs())
}

/// Points of the surface near its centre with normals, in the shape's coordinates: the crossings of irregular lines.
pub fn samples(form: &QuadricMatrix) -> Vec<Sample> {
    let rows: [Vec3; 4] = form.map(|r| [r[0], r[1], r[2]]);
    let linear: Vec3 = rows[3];
    // Half the gradient.
    let slope = |p: Vec3| -> Vec3 { std::array::from_fn(|i| dot(rows[i], p) + linear[i]) };
    let value = |p: Vec3| dot(slope(p), p) + dot(linear, p) + form[3][3];
    let curved = rows[..3].iter().map(|r| length(*r)).fold(0.0, f64::max);
    let mut square = Matrix::IDENTITY;
    for (i, row) in rows[..3].iter().enumerate() {
        square.0[i][..3].copy_from_slice(row);
    }
    let centre = square.inverse().map(|m| m.vector(linear.map(|x| -x)));
    let centre = centre.filter(|c| c.iter().all(|x| x.is_finite()));
    let centre = centre.unwrap_or([0.0; 3]);
    // A characteristic length of the surface; a cone and a plane through the origin have none.
    let lengths = [
        (value(centre).abs() / curved).sqrt(),
        length(slope(centre)) / curved,
        form[3][3].abs() / length(linear),
    ];
    let usable = |l: &f64| l.is_finite() && *l > 0.0;
    let scale = lengths.into_iter().find(usable).unwrap_or(1.0);
    /// The number of lines that are tried.
    const MAX_LINES_TRIED: u32 = 24;
    /// The greatest distance of a usable crossing from the start of its line, in characteristic lengths.
    const MAX_CROSSING_DISTANCE: f64 = 10.0;
    let mut out = Vec::new();
    for i in 0..MAX_LINES_TRIED {
        let along = direction(i, MAX_LINES_TRIED);
        let start = add(
            centre,
            direction((i + 9) % MAX_LINES_TRIED, MAX_LINES_TRIED),
            0.6 * scale,
        );
        let turn: Vec3 = std::array::from_fn(|k| dot(rows[k], along));
        let (a, b, c) = (dot(turn, along), dot(slope(start), along), value(start));
        let root = (b * b - a * c).sqrt();
        let q = -(b + root.copysign(b));
        for t in [q / a, c / q] {
            if t.abs() <= MAX_CROSSING_DISTANCE * scale {
                let p = add(start, along, t);
                out.push((p, slope(p)));
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Geometry;
    use crate::solids::contacts::face::FaceId;

    fn form(geometry: &Geometry) -> Option<QuadricMatrix> {
        geometry.quadric(FaceId::All)
    }

    #[test]
    fn samples_lie_on_the_surface() {
        let shapes = [
            Geometry::ParabolicCylinder { a: 2.0 },
            Geometry::HyperbolicCylinder { a: 1.0, b: 3.0 },
            Geometry::Hyperboloid {
                a: 1.0,
                b: 2.0,
                c: 3.0,
                sheets: 1,
            },
            Geometry::Hyperboloid {
                a: 1e3,
                b: 1e3,
                c: 1e3,
                sheets: 2,
            },
            Geometry::HyperbolicParaboloid { a: 1.0, b: 1.0 },
            // A cone.
            Geometry::Quadric(Box::new([
                1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            ])),
        ];
        for shape in shapes {
            let form = form(&shape).unwrap();
            let points = samples(&form);
            assert!(points.len() >= 4, "{shape:?}: {}", points.len());
            for (p, n) in points {
                let x = [p[0], p[1], p[2], 1.0];
                let terms = (0..16).map(|k| form[k / 4][k % 4] * x[k / 4] * x[k % 4]);
                let (value, size) = terms.fold((0.0, 0.0f64), |(v, s), t| (v + t, s + t.abs()));
                assert!(value.abs() <= 1e-12 * size, "{shape:?} {p:?}");
                assert!(length(n) > 0.0);
            }
        }
    }

    #[test]
    fn fingerprints_of_equal_surfaces() {
        let bowl = form(&Geometry::ParabolicCylinder { a: 2.0 }).unwrap();
        let other = bowl.map(|r| r.map(|x| -3.0 * x));
        let m = Matrix::translation(1.0, -2.0, 3.0).after(&Matrix::rotation(31.0, 2));
        let [a, b] = [bowl, other].map(|f| fingerprint(&f, &m).unwrap());
        assert!((a - b).abs() <= 1e-14 * a, "{a} {b}");
        let wider = form(&Geometry::ParabolicCylinder { a: 2.1 }).unwrap();
        assert!((a - fingerprint(&wider, &m).unwrap()).abs() > 1e-4);
    }
}
