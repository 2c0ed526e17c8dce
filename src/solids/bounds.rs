//! Where the nodes of a scene can be: boxes that are never too small.

use super::shapes::facts::Facts;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, Scene};

/// The bounds of a node, in its own coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeBounds {
    /// Holds every point of the node's solids and surfaces.
    pub all: Aabb,
    /// Holds the parts of the node that are bounded; always finite, empty where there are none.
    pub bounded: Aabb,
}

/// The bounds of every node of the arena, in one pass: children stand before their parents.
pub fn node_bounds(scene: &Scene) -> Vec<NodeBounds> {
    let mut out: Vec<NodeBounds> = Vec::with_capacity(scene.nodes.len());
    // For a node that is one shape, moved: the shape and where it is. Bounding the moved shape
    // itself keeps chains of rotations from blowing its box up.
    let mut moved: Vec<Option<(u32, Matrix)>> = Vec::with_capacity(scene.nodes.len());
    for node in &scene.nodes {
        let of = |id: u32| out[id as usize];
        let (all, bounded, placed) = match *node {
            Node::Shape(shape) => {
                let all = scene.shapes[shape as usize]
                    .geometry
                    .bounds(&Matrix::IDENTITY);
                (all, finite_part(all), Some((shape, Matrix::IDENTITY)))
            }
            Node::Transform { child, matrix } => {
                let m = &scene.matrices[matrix as usize];
                match moved[child as usize] {
                    Some((shape, before)) => {
                        let m = m.after(&before);
                        let all = scene.shapes[shape as usize].geometry.bounds(&m);
                        (all, finite_part(all), Some((shape, m)))
                    }
                    None => (
                        of(child).all.transformed(m),
                        finite_part(of(child).bounded.transformed(m)),
                        None,
                    ),
                }
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                (of(child).all, of(child).bounded, moved[child as usize])
            }
            Node::Union(a, b) => (
                of(a).all.hull(&of(b).all),
                of(a).bounded.hull(&of(b).bounded),
                None,
            ),
            Node::Intersection(a, b) => {
                let (a, b) = (of(a), of(b));
                let bounded = a
                    .bounded
                    .intersection(&b.all)
                    .hull(&b.bounded.intersection(&a.all));
                (a.all.intersection(&b.all), finite_part(bounded), None)
            }
            Node::Difference(a, _) => (of(a).all, of(a).bounded, None),
            Node::Complement(_) => (Aabb::ALL, Aabb::EMPTY, None),
        };
        out.push(NodeBounds { all, bounded });
        moved.push(placed);
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
        use crate::diagnostics::Span;
        use crate::scene::Shape;
        use crate::syntax::table::RecordType;
        let shape = |geometry, code| Shape {
            id: 2,
            ty: RecordType::by_code(code).unwrap(),
            span: Span::default(),
            geometry,
        };
        let scene = Scene {
            shapes: vec![
                shape(Geometry::Plane([0.0, 1.0, 0.0, 0.0]), 3),
                shape(
                    Geometry::Sphere {
                        centre: [1.0, 0.0, 0.0],
                        radius: 1.0,
                    },
                    11,
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
        assert!(near(b[2].bounded.min, [0.0, -1.0, -1.0]));
        assert!(!b[2].all.is_finite());
        assert!(near(b[4].bounded.max, [2.0, 1.0, 1.0]));
        assert!(b[3].bounded.is_empty());
    }
}
