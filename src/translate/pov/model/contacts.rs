//! Contacts of nodes that have faces in one place: found once for each two nodes, and read by all that is done about
//! them.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use super::Model;
use super::plane::Plane;
use super::state::Layer;
use crate::geometry::array::{cross, dot, length, sub};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, TriangleNormals, Vec3};
use crate::solids::contacts::face::{FaceShape, Faces, QUADRIC};
use crate::solids::contacts::quadric;
use crate::solids::shapes::AnyShape;
use crate::solids::shapes::facts::Facts as _;
use crate::translate::pov::budget::Limit;

/// Faces that are this near, as a part of the coordinates, are in one place: what a few hundred roundings may do. Thicker
/// walls are walls.
const FACE_GAP: f64 = 1e-13;
/// Overlap of faces that have only an edge in common, as a part of the coordinates.
const EDGE_REL_OVERLAP: f64 = 1e-9;
/// Difference of normals, sizes and quadrics that are one, as a part of them: what turning may do.
const SURFACE_REL_EPS: f64 = 1e-12;

/// A face of a node, in the coordinates that it is placed in.
#[derive(Clone, Copy)]
pub(crate) struct Face {
    surface: Surface,
    /// Whether the solid lies inside of the shape that has the face; it is no hole.
    pub is_outer: bool,
    /// Whether the face is a surface, and not that of a solid.
    pub is_sheet: bool,
    around: Aabb,
}

#[derive(Clone, Copy)]
enum Surface {
    /// The normal points out of the shape that has the face; a parallelogram that holds it if it ends and its shape says
    /// so.
    Flat(Plane, Option<Parallelogram>),
    /// Anchor, scale and class, as [`FaceShape::Round`] has them.
    Round(Vec3, f64, u8),
}

/// A centre, and the ways to the middles of two sides that meet.
type Parallelogram = [Vec3; 3];

/// Whether two parallelograms in a plane with this normal have no more than an edge in common: some line in the plane along
/// a side of one of them has each on another side of it, but for `edge`.
fn are_beside([a, p, q]: Parallelogram, [b, r, s]: Parallelogram, normal: Vec3, edge: f64) -> bool {
    let way = sub(b, a);
    [p, q, r, s].iter().any(|side| {
        let across = cross(normal, *side);
        let reach: f64 = [p, q, r, s].iter().map(|v| dot(*v, across).abs()).sum();
        dot(way, across).abs() >= reach - edge * length(across)
    })
}

/// How two faces in one place lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Orientation {
    /// A face with both solids on one side.
    Alike,
    /// A face at which one solid ends and the other begins.
    Opposed,
}

/// Two faces in one place.
pub(crate) struct Contact {
    pub orientation: Orientation,
    pub faces: [Face; 2],
}

/// The results so far for a node and another key.
type Found<K, T> = RefCell<HashMap<(NodeId, K), Rc<[T]>>>;

/// All faces and contacts that were asked for so far.
#[derive(Default)]
pub(crate) struct Contacts {
    faces: Found<Layer, Face>,
    found: Found<NodeId, Contact>,
}

impl Face {
    pub(crate) fn plane(&self) -> Option<Plane> {
        match self.surface {
            Surface::Flat(plane, _) => Some(plane),
            Surface::Round(..) => None,
        }
    }

    /// How another face lies in this one, if it does and more than an edge is in common.
    pub(crate) fn contact(&self, other: &Face) -> Option<Orientation> {
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
            (Surface::Flat(a, around), Surface::Flat(b, other)) => {
                let along = dot(a.n, b.n).signum();
                let same = length(sub(a.n, b.n.map(|x| x * along))) <= SURFACE_REL_EPS
                    && (a.d - b.d * along).abs() <= gap;
                let both = around.zip(*other);
                let beside = both.is_some_and(|(p, q)| are_beside(p, q, a.n, edge));
                (same && !beside).then_some(along > 0.0)?
            }
            (Surface::Round(p, a, class), Surface::Round(q, b, c)) => {
                let size = if *class == QUADRIC { p[0].abs() } else { size };
                let near = |by: f64, size: f64| by <= SURFACE_REL_EPS * size;
                let same = class == c && near((a - b).abs(), *a) && near(length(sub(*p, *q)), size);
                same.then_some(true)?
            }
            _ => return None,
        };
        Some(match same_side == (self.is_outer == other.is_outer) {
            true => Orientation::Alike,
            false => Orientation::Opposed,
        })
    }
}

impl Model<'_> {
    /// The faces that the solids of two nodes have in one place, the first node's first.
    pub(crate) fn contacts(&self, a: NodeId, b: NodeId) -> Rc<[Contact]> {
        if let Some(known) = self.contacts.found.borrow().get(&(a, b)) {
            return known.clone();
        }
        let [own, other] = [a, b].map(|node| self.faces_of(node, Layer::Solid));
        let meet = |f: &Face, g: &Face| {
            let (orientation, faces) = (f.contact(g)?, [*f, *g]);
            Some(Contact { orientation, faces })
        };
        let found = own
            .iter()
            .flat_map(|f| other.iter().filter_map(|g| meet(f, g)));
        let found: Rc<[Contact]> = found.collect();
        self.contacts
            .found
            .borrow_mut()
            .insert((a, b), found.clone());
        found
    }

    /// The faces of the solids that a node is made of, of its surfaces, or of both, as far as these are looked at.
    pub(crate) fn faces_of(&self, node: NodeId, layer: Layer) -> Rc<[Face]> {
        let known = self.contacts.faces.borrow().get(&(node, layer)).cloned();
        known.unwrap_or_else(|| {
            let faces: Rc<[Face]> = self.find_faces(node, layer).into();
            self.contacts
                .faces
                .borrow_mut()
                .insert((node, layer), faces.clone());
            faces
        })
    }

    fn find_faces(&self, node: NodeId, layer: Layer) -> Vec<Face> {
        let own = self.box_of(node);
        let mut faces = Vec::new();
        let mut todo = vec![(node, Matrix::IDENTITY, true)];
        let mut looked_at = 0;
        while let Some((node, m, is_outer)) = todo.pop() {
            looked_at += 1;
            if !self.budget.spend(Limit::NodesWithFaces, looked_at) {
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
            if let Surface::Flat(Plane { n, d }, _) = &face.surface
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
            hole.plane().is_some() && found.any(|c| c == Some(Orientation::Opposed))
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
                    surface: Surface::Flat(plane, None),
                    is_outer,
                    is_sheet: true,
                    around: geometry.bounds(m),
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
            let number = quadric.and_then(|q| quadric::fingerprint(&q, m));
            let around = face.form.corners().map_or(bounds, |corners| {
                let grown = |hull: Aabb, p: &Vec3| hull.hull(&Aabb::new(*p, *p));
                corners.iter().fold(Aabb::EMPTY, grown)
            });
            let surface = match (face.form, number) {
                (FaceShape::Round { .. }, Some(number)) => {
                    Surface::Round([number, 0.0, 0.0], 0.0, QUADRIC)
                }
                (
                    FaceShape::Round {
                        anchor,
                        scale,
                        class,
                    },
                    None,
                ) => Surface::Round(anchor, scale, class),
                (
                    FaceShape::Flat {
                        normal,
                        point,
                        sides,
                        ..
                    },
                    _,
                ) => {
                    let (n, d) = (normal, -dot(normal, point));
                    Surface::Flat(Plane { n, d }, sides.map(|[u, v]| [point, u, v]))
                }
            };
            out.push(Face {
                surface,
                is_outer,
                is_sheet: false,
                around,
            });
        }
    }
}
