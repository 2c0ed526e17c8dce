//! The faces of shapes in their places. A flat face is an oriented plane with an outline. A round face is a surface
//! with a point and a length that tell it from other surfaces.

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
    /// The disc that closes a profile at this end point.
    Cap(usize),
}

#[derive(Debug, Clone)]
pub enum FaceShape {
    Flat {
        /// The outward normal, of length 1.
        normal: Vec3,
        /// The middle of the face, or any point of its plane.
        point: Vec3,
        /// The vectors from the middle to the middles of two adjacent sides of the outline. `None` if the face is
        /// infinite.
        sides: Option<[Vec3; 2]>,
        /// The radius halfway between the edges of a disc or ring, as a share of the sides. `None` for other faces.
        ring: Option<f64>,
    },
    Round {
        /// A point that is the same for equal surfaces, whichever piece of the surface the face is.
        anchor: Vec3,
        /// A length that is the same for equal surfaces.
        scale: f64,
        class: u8,
    },
}

impl FaceShape {
    /// The four corners of the parallelogram around a flat face. `None` for round faces and infinite ones.
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

    /// Points of a disc or ring, whose middle may be in its hole. None for other faces.
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
    /// Whether the face is filed as itself. A round face is filed once more as the quadric in which it lies.
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
/// The class of quadrics. In the place of an anchor they have a number that stands for their matrix.
pub const QUADRIC: u8 = 4;

/// The outline of a flat face.
#[derive(Clone, Copy, PartialEq)]
enum Extent {
    Endless,
    Corners,
    /// A disc or ring, with the value of `ring` in [`FaceShape::Flat`].
    Ring(f64),
}

/// Collects the faces of a leaf. The methods take a face in the coordinates of the shape, and `m` maps it to its place.
pub struct Faces<'a> {
    pub leaf: u32,
    pub m: &'a Matrix,
    pub out: &'a mut Vec<Face>,
}

impl Faces<'_> {
    /// Adds the parallelogram centre ± sides.
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

    /// Adds a surface that is one quadric.
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

    /// Adds the parallelogram centre ± sides, a disc or ring in it, or all of its plane.
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

    /// Adds a disc or ring about the y axis. `up` is 1 if its outward normal points upwards, and −1 if downwards.
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

    /// Adds a round face. `anchor` and `scale` tell its surface from others of its class.
    pub fn round(&mut self, part: FaceId, anchor: Vec3, scale: f64, class: u8) {
        self.out.push(Face {
            leaf: self.leaf,
            part,
            form: FaceShape::Round {
                anchor: self.m.point(anchor),
                // The map stretches volumes by the determinant, and lengths by its cube root on average.
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
        // A step that leads from a level piece surely to one side of it: no other level piece has a height in between.
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
            // Where an even number of level pieces coincide, both sides are the same and there is no face.
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
                // The anchor is the point of the axis that is nearest to the origin, where the leaf is placed.
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
