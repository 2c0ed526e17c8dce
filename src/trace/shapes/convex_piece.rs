//! Convex solids of second degree, in a form in which several are tested at once.

/// A convex solid: the points between two heights where a polynomial of second degree is not positive.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPiece {
    /// The coefficients, in the order of [`Form::Quadric`](super::outline::Form::Quadric).
    pub polynomial: [f64; 10],
    /// The lower and the upper end along the y axis; infinite where there is no end.
    pub heights: [f64; 2],
    /// The height of the apex, if the piece is a part of a cone: the polynomial's quadratic part then has both signs.
    /// `None` for other pieces.
    pub apex: Option<f64>,
}

impl ConvexPiece {
    /// A whole quadric as a piece; `None` if it is not convex, that is, if its matrix of second degree has a negative
    /// eigenvalue or is zero.
    pub fn all_of(&polynomial: &[f64; 10]) -> Option<ConvexPiece> {
        let [xx, yy, zz, xy, xz, yz, ..] = polynomial;
        let [xy, xz, yz] = [xy, xz, yz].map(|x| 0.5 * x);
        let minors = [
            xx,
            yy,
            zz,
            xx * yy - xy * xy,
            xx * zz - xz * xz,
            yy * zz - yz * yz,
            xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz),
        ];
        let is_convex = minors.iter().all(|&minor| minor >= 0.0) && xx + yy + zz > 0.0;
        is_convex.then_some(ConvexPiece {
            polynomial,
            heights: [f64::NEG_INFINITY, f64::INFINITY],
            apex: None,
        })
    }

    /// The frustum or cylinder that a segment between two points (x, y) surrounds as it is turned about the y axis;
    /// `None` for a disc, or a segment on the axis.
    pub fn turned([[r, y], [s, z]]: [[f64; 2]; 2]) -> Option<ConvexPiece> {
        let slope = (s - r) / (z - y);
        let at_zero = r - slope * y;
        let is_solid = y != z && (r > 0.0 || s > 0.0) && slope.is_finite() && at_zero.is_finite();
        is_solid.then(|| ConvexPiece {
            polynomial: [
                1.0,
                -slope * slope,
                1.0,
                0.0,
                0.0,
                0.0,
                0.0,
                -2.0 * slope * at_zero,
                0.0,
                -at_zero * at_zero,
            ],
            heights: [y.min(z), y.max(z)],
            apex: (slope != 0.0).then(|| -at_zero / slope),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(piece: &ConvexPiece, [x, y, z]: [f64; 3]) -> f64 {
        let c = piece.polynomial;
        c[0] * x * x
            + c[1] * y * y
            + c[2] * z * z
            + c[3] * x * y
            + c[4] * x * z
            + c[5] * y * z
            + c[6] * x
            + c[7] * y
            + c[8] * z
            + c[9]
    }

    #[test]
    fn a_frustum_has_its_radii_at_its_heights() {
        let piece = ConvexPiece::turned([[0.5, 1.0], [2.0, -1.0]]).unwrap();
        assert_eq!(piece.heights, [-1.0, 1.0]);
        // The radius falls by 0.75 a unit of height.
        assert!((piece.apex.unwrap() - (1.0 + 0.5 / 0.75)).abs() < 1e-12);
        for (radius, y) in [(0.5, 1.0), (2.0, -1.0), (1.25, 0.0)] {
            assert!(value(&piece, [radius, y, 0.0]).abs() < 1e-12);
            assert!(value(&piece, [0.0, y, 0.9 * radius]) < 0.0);
        }
        let cylinder = ConvexPiece::turned([[0.5, 0.0], [0.5, 2.0]]).unwrap();
        assert_eq!(cylinder.apex, None);
        assert_eq!(ConvexPiece::turned([[0.5, 1.0], [0.2, 1.0]]), None);
        assert_eq!(ConvexPiece::turned([[0.0, 1.0], [0.0, 2.0]]), None);
    }

    #[test]
    fn what_is_not_convex_is_no_piece() {
        let all = |polynomial| ConvexPiece::all_of(&polynomial).is_some();
        let tube = [1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.25];
        let ellipsoid = [2.0, 1.5, 3.0, 0.1, 0.0, 0.2, 0.3, 0.0, 0.0, -1.0];
        let hyperboloid = [1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
        // x² + 4xy + y² has eigenvalues 3 and -1.
        let saddle = [1.0, 1.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
        assert!(all(tube) && all(ellipsoid));
        assert!(!all(hyperboloid) && !all(saddle) && !all([0.0; 10]));
    }
}
