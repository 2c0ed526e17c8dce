//! Faces of two nodes that lie in one place. They are found once for each pair of nodes; all remedies for faces in one
//! place read them here.

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

/// The largest distance of two faces that count as one place, as a fraction of the largest coordinate: a few hundred
/// roundings may move faces this far. Faces that are farther apart are the two sides of a real wall.
const FACE_REL_GAP: f64 = 1e-13;
/// The largest overlap of two faces that counts as no more than a common edge, as a fraction of the largest coordinate.
const EDGE_REL_OVERLAP: f64 = 1e-9;
/// The largest relative difference of normals, sizes and quadrics that count as equal: rotations may round by this
/// much.
const SURFACE_REL_EPS: f64 = 1e-12;

/// A face of a shape that a node is made of, in the coordinates that the node is placed in.
#[derive(Clone, Copy)]
pub(crate) struct Face {
    surface: Surface,
    /// Whether the node's solid lies inside of the shape that has the face. False for a hole: the shape is taken away.
    pub is_outer: bool,
    /// Whether the face belongs to a surface, which has no inside; false for a face of a solid.
    pub is_sheet: bool,
    around: Aabb,
}

#[derive(Clone, Copy)]
enum Surface {
    /// A flat face. The plane's normal points out of the shape; the parallelogram holds the face. It is `None` for a
    /// face without end, or if the shape does not tell it.
    Flat(Plane, Option<Parallelogram>),
    /// A curved face: anchor, scale and class, as in [`FaceShape::Round`]. For the class `QUADRIC` the anchor's first
    /// number is the quadric's fingerprint.
    Round(Vec3, f64, u8),
}

/// A parallelogram: its centre, and the vectors from there to the midpoints of two sides that meet.
type Parallelogram = [Vec3; 3];

/// Whether two parallelograms in a plane with this normal have at most an edge in common: a line parallel to one of the
/// sides separates them, up to an overlap of `edge` across the line.
fn are_beside([a, p, q]: Parallelogram, [b, r, s]: Parallelogram, normal: Vec3, edge: f64) -> bool {
    let way = sub(b, a);
    [p, q, r, s].iter().any(|side| {
        let across = cross(normal, *side);
        let reach: f64 = [p, q, r, s].iter().map(|v| dot(*v, across).abs()).sum();
        dot(way, across).abs() >= reach - edge * length(across)
    })
}

/// The sides on which the two solids of faces in one place lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Orientation {
    /// Both solids lie on the same side of the face.
    Alike,
    /// One solid ends at the face and the other begins there.
    Opposed,
}

/// Two faces in one place.
pub(crate) struct Contact {
    pub orientation: Orientation,
    pub faces: [Face; 2],
}

/// Results that are already known, by a node and a second key.
type Found<K, T> = RefCell<HashMap<(NodeId, K), Rc<[T]>>>;

/// The faces and contacts that were already looked for: faces by node and layer, contacts by pair of nodes.
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

    /// The orientation of two faces in one place. `None` if they are not in one place, or have no more than an edge in
    /// common.
    pub(crate) fn contact(&self, other: &Face) -> Option<Orientation> {
        let ends = [&self.around, &other.around];
        let ends = ends.into_iter().flat_map(|b| [b.min, b.max]).flatten();
        let size = (ends.filter(|x| x.is_finite())).fold(0.0f64, |m, x| m.max(x.abs()));
        let (gap, edge) = (FACE_REL_GAP * size, EDGE_REL_OVERLAP * size);
        // Along an axis on which both faces are flat, their extents need only meet; along any other axis they have to
        // overlap by more than an edge.
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
    /// The pairs of faces that the solids of nodes `a` and `b` have in one place. In each pair the face of `a` comes
    /// first.
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

    /// The faces of the shapes that a node is made of: its solids, its surfaces, or both, as the layer says. Nodes
    /// beyond the limit `NodesWithFaces` are not looked at.
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
            // The box around an endless plane across an axis is made flat, too, like that of a bounded face.
            if let Surface::Flat(Plane { n, d }, _) = &face.surface
                && let Some(axis) = (0..3).find(|i| n[*i].abs() == 1.0)
            {
                let at = -d * n[axis];
                (face.around.min[axis], face.around.max[axis]) = (at, at);
            }
        }
        // Where a hole ends flush with the solid around it, the hole is open and has no face.
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
                // A triangle counts as flat only if its shading normals are those of its plane.
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
