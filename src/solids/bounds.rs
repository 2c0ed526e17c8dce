//! Bounds of the nodes of a scene: boxes that are never too small.

use super::shapes::facts::Facts;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, Scene};

/// The bounds of a node, in its own coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeBounds {
    /// The box that holds every point of the node's solids and surfaces.
    pub all: Aabb,
    /// The box of the bounded parts, if it is not the finite part of `all`. It is on the heap: there may be millions of
    /// nodes, and few have bounded parts beside unbounded ones.
    in_part: Option<Box<Aabb>>,
}

impl NodeBounds {
    fn new(all: Aabb, bounded: Aabb) -> NodeBounds {
        let in_part = (bounded != finite_part(all)).then(|| Box::new(bounded));
        NodeBounds { all, in_part }
    }

    /// The box of the node's bounded parts. It is always finite, and empty if there are none.
    pub fn bounded(&self) -> Aabb {
        match &self.in_part {
            Some(bounded) => **bounded,
            None => finite_part(self.all),
        }
    }
}

/// The kind of a node, for its bounds. A moved shape is bounded itself, since the box around a box would grow with each
/// rotation of a chain.
#[derive(Clone, Copy)]
enum Placed {
    /// A shape as it was defined.
    Still(u32),
    /// A shape in another place: its index, and the index of its matrix.
    Moved(u32, u32),
    /// Any other placed object.
    Other,
}

/// The bounds of every node of the arena, in one pass: children stand before their parents.
pub fn node_bounds(scene: &Scene) -> Vec<NodeBounds> {
    let mut out: Vec<NodeBounds> = Vec::with_capacity(scene.nodes.len());
    let mut placed: Vec<Placed> = Vec::with_capacity(scene.nodes.len());
    // Shapes that are never moved need no matrix.
    let mut matrices: Vec<Matrix> = Vec::new();
    let bounds = |shape: u32, m: &Matrix| {
        let all = scene.shapes[shape as usize].geometry.bounds(m);
        (all, finite_part(all))
    };
    for node in &scene.nodes {
        let of = |id: u32| &out[id as usize];
        let ((all, bounded), place) = match *node {
            Node::Shape(shape) => (bounds(shape, &Matrix::IDENTITY), Placed::Still(shape)),
            Node::Transform { child, matrix } => {
                let m = &scene.matrices[matrix as usize];
                let moved = match placed[child as usize] {
                    Placed::Still(shape) => Some((shape, *m)),
                    Placed::Moved(shape, before) => {
                        Some((shape, m.after(&matrices[before as usize])))
                    }
                    Placed::Other => None,
                };
                match moved {
                    Some((shape, m)) => {
                        matrices.push(m);
                        let place = Placed::Moved(shape, matrices.len() as u32 - 1);
                        (bounds(shape, &m), place)
                    }
                    None => {
                        let child = of(child);
                        let bounded = finite_part(child.bounded().transformed(m));
                        ((child.all.transformed(m), bounded), Placed::Other)
                    }
                }
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                ((of(child).all, of(child).bounded()), placed[child as usize])
            }
            Node::Union(a, b) => {
                let (a, b) = (of(a), of(b));
                let bounded = a.bounded().hull(&b.bounded());
                ((a.all.hull(&b.all), bounded), Placed::Other)
            }
            Node::Intersection(a, b) => {
                let (a, b) = (of(a), of(b));
                let bounded =
                    (a.bounded().intersection(&b.all)).hull(&b.bounded().intersection(&a.all));
                let all = a.all.intersection(&b.all);
                ((all, finite_part(bounded)), Placed::Other)
            }
            Node::Difference(a, _) => ((of(a).all, of(a).bounded()), Placed::Other),
            Node::Complement(_) => ((Aabb::ALL, Aabb::EMPTY), Placed::Other),
        };
        out.push(NodeBounds::new(all, bounded));
        placed.push(place);
    }
    out
}

fn finite_part(all: Aabb) -> Aabb {
    if all.is_bounded() { all } else { Aabb::EMPTY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Geometry, Vec3};

    fn near(a: Vec3, b: Vec3) -> bool {
        (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6)
    }

    #[test]
    fn a_turned_sphere_keeps_its_box() {
        let m = Matrix::rotation(45.0, 2).after(&Matrix::rotation(30.0, 0));
        let sphere = Geometry::Sphere {
            centre: [0.0; 3],
            radius: 2.0,
        };
        let b = sphere.bounds(&m);
        assert!(near(b.min, [-2.0; 3]) && near(b.max, [2.0; 3]));
        assert!(b.max[0] >= 2.0);
    }

    #[test]
    fn torus_and_cone() {
        let m = Matrix::rotation(90.0, 0);
        let torus = Geometry::Torus {
            major: 3.0,
            minor: 1.0,
        };
        assert!(near(torus.bounds(&m).max, [4.0, 4.0, 1.0]));
        let cone = Geometry::Cone {
            height: -2.0,
            radius: 1.0,
        };
        let b = cone.bounds(&Matrix::IDENTITY);
        assert!(near(b.min, [-1.0, -2.0, -1.0]) && near(b.max, [1.0, 0.0, 1.0]));
    }

    #[test]
    fn unbounded_parts_do_not_count() {
        use crate::scene::Shape;
        use crate::syntax::table::ShapeKind;
        let shape = |geometry, kind| Shape {
            id: 2,
            kind,
            geometry,
        };
        let scene = Scene {
            shapes: vec![
                shape(Geometry::Plane([0.0, 1.0, 0.0, 0.0]), ShapeKind::Plane),
                shape(
                    Geometry::Sphere {
                        centre: [1.0, 0.0, 0.0],
                        radius: 1.0,
                    },
                    ShapeKind::Sphere,
                ),
            ],
            nodes: vec![
                Node::Shape(0),
                Node::Shape(1),
                Node::Union(0, 1),
                Node::Complement(1),
                Node::Intersection(2, 3),
            ],
            ..Scene::default()
        };
        let b = node_bounds(&scene);
        assert!(near(b[2].bounded().min, [0.0, -1.0, -1.0]));
        assert!(!b[2].all.is_finite());
        assert!(near(b[4].bounded().max, [2.0, 1.0, 1.0]));
        assert!(b[3].bounded().is_empty());
    }
}
