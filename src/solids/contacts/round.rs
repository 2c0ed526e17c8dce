//! Round faces: the quadric or the piece of a profile that a face is, and points on it.

use super::directions::{Sample, turn};
use super::face::FaceId;
use super::quadric::{self, QuadricMatrix};
use crate::scene::Geometry;
use crate::solids::shapes::{AnyShape, ball, circle};

/// (radius, height) of the two ends of a piece of a cone or cylinder about the y axis.
pub(super) type Mantle = ((f64, f64), (f64, f64));

impl Geometry {
    /// The symmetric matrix of the quadric in which a face lies. `None` if it lies in no quadric.
    pub fn quadric(&self, part: FaceId) -> Option<QuadricMatrix> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                (part == FaceId::Mantle).then(|| circle::cone(s.radius / s.height, 0.0))
            }
            AnyShape::Ellipsoid(s) => {
                if part != FaceId::All {
                    return None;
                }
                let mut out = [[0.0; 4]; 4];
                (0..3).for_each(|i| out[i][i] = 1.0 / (s.semi_axes[i] * s.semi_axes[i]));
                out[3][3] = -1.0;
                Some(out)
            }
            AnyShape::Quadric(s) => (part == FaceId::All).then(|| s.matrix()),
            AnyShape::Revolution(s) => {
                let FaceId::Piece(i) = part else {
                    return None;
                };
                let ([x0, y0], [x1, y1]) = (*s.profile.get(i)?, *s.profile.get(i + 1)?);
                let slope = (x1 - x0) / (y1 - y0);
                Some(circle::cone(slope, x0 - slope * y0))
            }
            AnyShape::Sphere(s) => {
                if part != FaceId::All {
                    return None;
                }
                let mut out = [[0.0; 4]; 4];
                let square: f64 = s.centre.iter().map(|c| c * c).sum();
                (0..3).for_each(|i| {
                    out[i][i] = 1.0;
                    (out[i][3], out[3][i]) = (-s.centre[i], -s.centre[i]);
                });
                out[3][3] = square - s.radius * s.radius;
                Some(out)
            }
            AnyShape::Cuboid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => None,
        }
    }

    /// A round face about the y axis as a piece of a profile. `None` for faces that are none.
    pub fn mantle(&self, part: FaceId) -> Option<Mantle> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                (part == FaceId::Mantle).then_some(((0.0, 0.0), (s.radius, s.height)))
            }
            AnyShape::Revolution(s) => {
                let FaceId::Piece(i) = part else {
                    return None;
                };
                let ([a, b], [c, d]) = (*s.profile.get(i)?, *s.profile.get(i + 1)?);
                Some(((a, b), (c, d)))
            }
            AnyShape::Cuboid(_)
            | AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => None,
        }
    }

    /// Points of the surface with normals, for shapes that are one round face and no mantle. Empty for other shapes.
    pub fn samples(&self) -> Vec<Sample> {
        match AnyShape::of(self) {
            AnyShape::Ellipsoid(s) => ball::samples([0.0; 3], s.semi_axes),
            AnyShape::Quadric(s) => quadric::samples(&s.matrix()),
            AnyShape::Sphere(s) => ball::samples(s.centre, [s.radius; 3]),
            AnyShape::Torus(s) => {
                let (major, minor) = (s.major, s.minor);
                (0..24)
                    .map(|i| {
                        let (su, cu) = turn(i);
                        let (sv, cv) = (f64::from(i) * 1.137 + 0.2).sin_cos();
                        let ring = major + minor * cv;
                        ([ring * cu, minor * sv, ring * su], [cv * cu, sv, cv * su])
                    })
                    .collect()
            }
            AnyShape::Cone(_)
            | AnyShape::Cuboid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Revolution(_)
            | AnyShape::Triangle(_) => Vec::new(),
        }
    }
}
