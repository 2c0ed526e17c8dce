//! Which operands of an operation have faces in one place.

use crate::geometry::array::{cross, dot, length, sub};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, TriangleNormals, Vec3};
use crate::solids::contacts::face::{FaceShape, Faces};
use crate::solids::contacts::quadric;
use crate::solids::shapes::AnyShape;
use crate::solids::shapes::facts::Facts as _;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::Layer;

/// Nodes of an operand that are looked at.
const MAX_NODES: usize = 256;
/// Faces that are this near, as a part of the coordinates, are in one place: what a few hundred roundings may do. Thicker
/// walls are walls.
const FACE_GAP: f64 = 1e-13;
/// Overlap of faces that have only an edge in common, as a part of the coordinates.
const EDGE_REL_OVERLAP: f64 = 1e-9;
/// Difference of normals, sizes and quadrics that are one, as a part of them: what turning may do.
const SURFACE_REL_EPS: f64 = 1e-12;

/// A face of an operand, in the coordinates of the operation.
pub(crate) struct Face {
    surface: Surface,
    /// The solid lies inside of the shape that has the face; it is no hole.
    pub is_outer: bool,
    /// Whether the face is a surface, and not that of a solid.
    pub is_sheet: bool,
    around: Aabb,
    /// Holds a flat face that ends, if its shape says so.
    outline: Option<Parallelogram>,
}

/// All points from the centre up to one side each way, and up to the other.
#[derive(Debug, Clone, Copy)]
struct Parallelogram {
    centre: Vec3,
    sides: [Vec3; 2],
}

impl Parallelogram {
    /// Whether it has no more than an edge in common with another one in a plane with this normal: some line in the plane
    /// along a side of one of them has each on another side of it, but for `edge`.
    fn is_beside(&self, other: &Parallelogram, normal: Vec3, edge: f64) -> bool {
        let [p, q] = self.sides;
        let [r, s] = other.sides;
        let way = sub(other.centre, self.centre);
        [p, q, r, s].iter().any(|side| {
            let across = cross(normal, *side);
            let reach: f64 = [p, q, r, s].iter().map(|v| dot(*v, across).abs()).sum();
            dot(way, across).abs() >= reach - edge * length(across)
        })
    }
}

enum Surface {
    /// The normal points out of the shape that has the face.
    Flat(Plane),
    /// A quadric, by a number that only equal ones have.
    Quadric(f64),
    Other {
        anchor: Vec3,
        scale: f64,
        class: u8,
    },
}

/// How two faces in one place lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contact {
    /// Both solids are on one side of it.
    Alike,
    /// One ends where the other begins.
    Opposed,
}

impl Face {
    pub(crate) fn plane(&self) -> Option<Plane> {
        match self.surface {
            Surface::Flat(plane) => Some(plane),
            _ => None,
        }
    }

    /// How another face lies in this one, if it does and more than an edge is in common.
    pub(crate) fn contact(&self, other: &Face) -> Option<Contact> {
        let ends = [&self.around, &other.around];
        let ends = ends.into_iter().flat_map(|b| [b.min, b.max]).flatten();
        let size = (ends.filter(|x| x.is_finite())).fold(0.0f64, |m, x| m.max(x.abs()));
        let (gap, edge) = (FACE_GAP * size, EDGE_REL_OVERLAP * size);
        // Along an axis that they lie across they are as thick as nothing; along others more than an edge has to be in
        // common.
        let over = |i: usize| {
            let [a, b] = [&self.around, &other.around];
            let common = a.max[i].min(b.max[i]) - a.min[i].max(b.min[i]);
            let flat = |b: &Aabb| b.max[i] - b.min[i] <= edge;
            common > if flat(a) && flat(b) { -edge } else { edge }
        };
        if !(0..3).all(over) {
            return None;
        }
        let same_side = match (&self.surface, &other.surface) {
            (Surface::Flat(a), Surface::Flat(b)) => {
                let along = dot(a.n, b.n).signum();
                let same = length(sub(a.n, b.n.map(|x| x * along))) <= SURFACE_REL_EPS
                    && (a.d - b.d * along).abs() <= gap;
                let outlines = self.outline.as_ref().zip(other.outline.as_ref());
                let are_beside = outlines.is_some_and(|(p, q)| p.is_beside(q, a.n, edge));
                (same && !are_beside).then_some(along > 0.0)?
            }
            (Surface::Quadric(a), Surface::Quadric(b)) => {
                ((a - b).abs() <= SURFACE_REL_EPS * a.abs()).then_some(true)?
            }
            (
                Surface::Other {
                    anchor,
                    scale,
                    class,
                },
                Surface::Other {
                    anchor: p,
                    scale: s,
                    class: c,
                },
            ) => {
                let same = class == c && (scale - s).abs() <= SURFACE_REL_EPS * scale;
                (same && length(sub(*anchor, *p)) <= SURFACE_REL_EPS * size).then_some(true)?
            }
            _ => return None,
        };
        Some(match same_side == (self.is_outer == other.is_outer) {
            true => Contact::Alike,
            false => Contact::Opposed,
        })
    }
}

/// The faces of two solids that are in one place.
pub(super) fn contacts<'f>(
    a: &'f [Face],
    b: &'f [Face],
) -> impl Iterator<Item = (Contact, [&'f Face; 2])> {
    a.iter()
        .flat_map(move |f| b.iter().filter_map(move |g| Some((f.contact(g)?, [f, g]))))
}

impl Model<'_> {
    /// The faces of the solids that a node is made of, as far as these are looked at.
    pub(crate) fn faces_of(&mut self, node: NodeId) -> Vec<Face> {
        self.faces_of_layer(node, Layer::Solid)
    }

    /// The faces of the solids, of the surfaces, or of both.
    pub(crate) fn faces_of_layer(&mut self, node: NodeId, layer: Layer) -> Vec<Face> {
        let own = self.box_of(node);
        let mut faces = Vec::new();
        let mut todo = vec![(node, Matrix::IDENTITY, true)];
        let mut looked_at = 0;
        while let Some((node, m, is_outer)) = todo.pop() {
            looked_at += 1;
            if looked_at > MAX_NODES {
                self.budget_is_spent();
                break;
            }
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => self.faces_of_shape(shape, layer, (&m, is_outer), &mut faces),
                Node::Transform { child, matrix } => {
                    let m = m.after(&self.scene.matrices[matrix as usize]);
                    todo.push((child, m, is_outer));
                }
                Node::Complement(a) => todo.push((a, m, !is_outer)),
                Node::Difference(a, b) => todo.extend([(b, m, !is_outer), (a, m, is_outer)]),
                node => todo.extend(node.children().rev().map(|child| (child, m, is_outer))),
            }
        }
        for face in &mut faces {
            face.around = face.around.intersection(&own);
            // Endless ones are thin, too.
            if let Surface::Flat(Plane { n, d }) = &face.surface
                && let Some(axis) = (0..3).find(|i| n[*i].abs() == 1.0)
            {
                let at = -d * n[axis];
                (face.around.min[axis], face.around.max[axis]) = (at, at);
            }
        }
        // Where a hole ends flush with what it is in, it has no end.
        let (outer, mut holes): (Vec<_>, Vec<_>) = faces.into_iter().partition(|f| f.is_outer);
        let is_end = |hole: &Face| {
            let mut found = outer.iter().map(|face| face.contact(hole));
            hole.plane().is_some() && found.any(|c| c == Some(Contact::Opposed))
        };
        holes.retain(|hole| !is_end(hole));
        outer.into_iter().chain(holes).collect()
    }

    fn faces_of_shape(
        &self,
        shape: u32,
        layer: Layer,
        (m, is_outer): (&Matrix, bool),
        out: &mut Vec<Face>,
    ) {
        let geometry = &self.scene.shapes[shape as usize].geometry;
        if layer != Layer::All && geometry.is_solid() != (layer == Layer::Solid) {
            return;
        }
        if !geometry.is_solid() {
            let normal = match AnyShape::of(geometry) {
                AnyShape::HalfSpace(s) => Some((s.normal(), s.abcd[3])),
                AnyShape::Rectangle(_) => Some(([0.0, 0.0, 1.0], 0.0)),
                // Only where its normals are those of its plane.
                AnyShape::Triangle(s) if *s.normals == TriangleNormals::Flat => {
                    let [p, q, r] = s.vertices;
                    let n = cross(sub(q, p), sub(r, p));
                    Some((n, -dot(n, p)))
                }
                AnyShape::Cone(_)
                | AnyShape::Cuboid(_)
                | AnyShape::Ellipsoid(_)
                | AnyShape::GeodesicSphere(_)
                | AnyShape::Quadric(_)
                | AnyShape::Revolution(_)
                | AnyShape::Sphere(_)
                | AnyShape::Torus(_)
                | AnyShape::Triangle(_) => None,
            };
            out.extend(normal.and_then(|(n, d)| {
                let plane = Plane::of(n, d)?.moved_back(&m.inverse()?)?.0;
                Some(Face {
                    surface: Surface::Flat(plane),
                    is_outer,
                    is_sheet: true,
                    around: geometry.bounds(m),
                    outline: None,
                })
            }));
            return;
        }
        let mut all = Vec::new();
        geometry.faces(&mut Faces {
            leaf: 0,
            m,
            out: &mut all,
        });
        let bounds = geometry.bounds(m);
        for face in all {
            let quadric = geometry.quadric(face.part);
            let corners = face.form.corners();
            let outline = match face.form {
                FaceShape::Flat {
                    point,
                    sides: Some(sides),
                    ..
                } => Some(Parallelogram {
                    centre: point,
                    sides,
                }),
                _ => None,
            };
            let surface = match face.form {
                FaceShape::Flat { normal, point, .. } => Surface::Flat(Plane {
                    n: normal,
                    d: -dot(normal, point),
                }),
                FaceShape::Round {
                    anchor,
                    scale,
                    class,
                } => match quadric.and_then(|q| quadric::fingerprint(&q, m)) {
                    Some(number) => Surface::Quadric(number),
                    None => Surface::Other {
                        anchor,
                        scale,
                        class,
                    },
                },
            };
            let around = match corners {
                Some(corners) => {
                    let grown = |hull: Aabb, p: &Vec3| hull.hull(&Aabb::new(*p, *p));
                    corners.iter().fold(Aabb::EMPTY, grown)
                }
                None => bounds,
            };
            out.push(Face {
                surface,
                is_outer,
                is_sheet: false,
                around,
                outline,
            });
        }
    }
}
