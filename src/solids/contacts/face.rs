//! The faces of shapes, placed: flat ones as oriented planes with their outlines, round ones as
//! surfaces with a point that tells them from others.

use super::quadric;
use crate::geometry::Matrix;
use crate::geometry::array::{add, cross, dot, sub, unit};
use crate::scene::Vec3;
use crate::solids::shapes::profile;

/// A face of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FaceId {
    /// The whole surface.
    All,
    /// A side of a box: at right angles to an axis, at its lower or upper end.
    Side { axis: usize, upper: bool },
    /// The base of a cone; of a double cone the upper or lower one.
    Base { upper: bool },
    /// The lateral surface of a cone or double cone.
    Mantle,
    /// The piece of a profile from this point to the next.
    Piece(usize),
    /// The disc that closes a profile at this point's end.
    Cap(usize),
}

#[derive(Debug, Clone)]
pub enum FaceShape {
    Flat {
        /// Outwards, of length 1.
        normal: Vec3,
        /// The middle of the face, or any point of its plane.
        point: Vec3,
        /// The way from there to the middles of two sides that meet; `None` where it has no end.
        sides: Option<[Vec3; 2]>,
        /// The middle line of a disc or ring, as a share of the sides.
        ring: Option<f64>,
    },
    Round {
        /// The same for equal surfaces, whatever piece of them this is.
        anchor: Vec3,
        /// A length that is the same for equal surfaces.
        scale: f64,
        class: u8,
    },
}

impl FaceShape {
    /// Four corners around a flat face that ends.
    pub fn corners(&self) -> Option<[Vec3; 4]> {
        let FaceShape::Flat {
            point,
            sides: Some([u, v]),
            ..
        } = self
        else {
            return None;
        };
        let corner = |a: f64, b: f64| add(add(*point, *u, a), *v, b);
        Some([
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ])
    }

    /// Points of a flat face where the middle of the corners may not be one.
    pub fn samples(&self) -> impl Iterator<Item = Vec3> {
        let ring = match *self {
            FaceShape::Flat {
                point,
                sides: Some([u, v]),
                ring: Some(middle),
                ..
            } => Some((point, u, v, middle)),
            _ => None,
        };
        // Eight points in the middle of the ring, none on an axis.
        ring.into_iter().flat_map(|(point, u, v, middle)| {
            (0..8).map(move |i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_4 + 0.3).sin_cos();
                add(add(point, u, middle * cos), v, middle * sin)
            })
        })
    }
}

#[derive(Debug, Clone)]
pub struct Face {
    /// Index into the leaves of the tree.
    pub leaf: u32,
    pub part: FaceId,
    pub form: FaceShape,
    /// Whether the face is filed as what it is, not once more as a quadric.
    pub own: bool,
}

pub fn quadric_form(fingerprint: f64) -> FaceShape {
    FaceShape::Round {
        anchor: [fingerprint, 0.0, 0.0],
        scale: 0.0,
        class: QUADRIC,
    }
}

// Surfaces of different classes are never equal.
pub const BALL: u8 = 0;
pub const TORUS: u8 = 1;
pub const CONE: u8 = 2;
const CYLINDER: u8 = 3;
/// The class of quadrics, which have a number that stands for their matrix in the place of an anchor.
pub const QUADRIC: u8 = 4;

/// How far a flat face goes.
#[derive(Clone, Copy, PartialEq)]
enum Extent {
    Endless,
    Corners,
    /// See [`FaceShape::Flat`].
    Ring(f64),
}

/// Takes the faces of a leaf, in the coordinates of its shape.
pub struct Faces<'a> {
    pub leaf: u32,
    pub m: &'a Matrix,
    pub out: &'a mut Vec<Face>,
}

impl Faces<'_> {
    /// The parallelogram centre ± sides.
    pub fn parallelogram(
        &mut self,
        part: FaceId,
        centre: Vec3,
        sides: (Vec3, Vec3),
        outwards: Vec3,
    ) {
        self.flat(part, centre, sides, outwards, Extent::Corners);
    }

    /// Adds the whole plane through a point along two directions.
    pub fn endless(&mut self, part: FaceId, point: Vec3, along: (Vec3, Vec3), outwards: Vec3) {
        self.flat(part, point, along, outwards, Extent::Endless);
    }

    /// A surface that is one quadric.
    pub fn quadric(&mut self, form: &quadric::QuadricMatrix) {
        if let Some(at) = quadric::fingerprint(form, self.m) {
            self.out.push(Face {
                leaf: self.leaf,
                part: FaceId::All,
                form: quadric_form(at),
                own: true,
            });
        }
    }

    /// The parallelogram centre ± sides, what lies in it, or all of its plane.
    fn flat(
        &mut self,
        part: FaceId,
        centre: Vec3,
        (u, v): (Vec3, Vec3),
        outwards: Vec3,
        extent: Extent,
    ) {
        let (u, v) = (self.m.vector(u), self.m.vector(v));
        let Some(normal) = unit(cross(u, v)) else {
            return;
        };
        let side = dot(normal, self.m.vector(outwards)).signum();
        self.out.push(Face {
            leaf: self.leaf,
            part,
            form: FaceShape::Flat {
                normal: normal.map(|x| x * side),
                point: self.m.point(centre),
                sides: (extent != Extent::Endless).then_some([u, v]),
                ring: match extent {
                    Extent::Ring(middle) => Some(middle),
                    _ => None,
                },
            },
            own: true,
        });
    }

    /// A disc or ring about the y axis.
    pub fn disc(&mut self, part: FaceId, y: f64, (inner, outer): (f64, f64), up: f64) {
        let middle = (inner / 2.0 + outer / 2.0) / outer;
        let sides = ([outer, 0.0, 0.0], [0.0, 0.0, outer]);
        self.flat(
            part,
            [0.0, y, 0.0],
            sides,
            [0.0, up, 0.0],
            Extent::Ring(middle),
        );
    }

    /// A round face, by what tells its surface from others of its class.
    pub fn round(&mut self, part: FaceId, anchor: Vec3, scale: f64, class: u8) {
        self.out.push(Face {
            leaf: self.leaf,
            part,
            form: FaceShape::Round {
                anchor: self.m.point(anchor),
                // Volumes grow by the determinant.
                scale: scale * self.m.determinant3().abs().cbrt(),
                class,
            },
            own: true,
        });
    }

    /// Adds the faces of a solid of revolution with this profile.
    pub fn revolution(&mut self, points: &[[f64; 2]]) {
        let n = points.len();
        let top = points.iter().fold(0.0f64, |m, p| m.max(p[1].abs()));
        // Far enough from a level piece to be on one side of it for certain: the height of no other
        // level piece lies between.
        let step = |y: f64| {
            let others = points.iter().map(|p| (p[1] - y).abs()).filter(|d| *d > 0.0);
            others.fold(top.max(f64::MIN_POSITIVE), f64::min) / 2.0
        };
        let mut level = |part: FaceId, y: f64, (a, b): (f64, f64)| {
            let radii = (a.min(b), a.max(b));
            let middle = radii.0 / 2.0 + radii.1 / 2.0;
            let h = step(y).min((radii.1 - radii.0) / 4.0);
            let (above, below) = (
                profile::holds(points, [middle, y + h, 0.0]),
                profile::holds(points, [middle, y - h, 0.0]),
            );
            // Level pieces that lie in one another do not change sides.
            if above != below && radii.0 < radii.1 {
                self.disc(part, y, radii, if below { 1.0 } else { -1.0 });
            }
        };
        if points[0] != points[n - 1] {
            level(FaceId::Cap(0), points[0][1], (0.0, points[0][0]));
            level(
                FaceId::Cap(n - 1),
                points[n - 1][1],
                (0.0, points[n - 1][0]),
            );
        }
        for i in 0..n - 1 {
            let ([x0, y0], [x1, y1]) = (points[i], points[i + 1]);
            if y0 == y1 {
                level(FaceId::Piece(i), y0, (x0, x1));
            }
        }
        for i in 0..n - 1 {
            let ([x0, y0], [x1, y1]) = (points[i], points[i + 1]);
            if y0 == y1 || (x0 == 0.0 && x1 == 0.0) {
                continue;
            }
            if x0 == x1 {
                // The point of the axis that is nearest to the origin of the search.
                let (at, axis) = (self.m.point([0.0; 3]), self.m.vector([0.0, 1.0, 0.0]));
                let back = dot(at, axis) / dot(axis, axis);
                self.round(FaceId::Piece(i), [0.0; 3], 0.0, CYLINDER);
                if let Some(Face {
                    form: FaceShape::Round { anchor, .. },
                    ..
                }) = self.out.last_mut()
                {
                    *anchor = sub(at, axis.map(|x| x * back));
                }
            } else {
                let apex = y0 - x0 * ((y1 - y0) / (x1 - x0));
                self.round(FaceId::Piece(i), [0.0, apex, 0.0], 0.0, CONE);
            }
        }
    }
}
