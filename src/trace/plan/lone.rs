//! Scenes of one convex shape, in which nothing can be in the way of anything.

use crate::scene::{Matrix, Node, NodeId, Scene, View};
use crate::trace::ray::Line;
use crate::trace::shapes::{Primitive, Roots};
use crate::trace::vec::Vec3;

/// Whether the scene is one convex shape and no camera is in it.
pub fn lone_convex(scene: &Scene, root: NodeId) -> bool {
    let (mut node, mut matrix) = (root, Matrix::IDENTITY);
    let shape = loop {
        match scene.nodes[node as usize] {
            Node::Shape(shape) => break &scene.shapes[shape as usize],
            Node::Union(a, b) if a == b => node = a,
            Node::Transform { child, matrix: m } => {
                matrix = matrix.after(&scene.matrices[m as usize]);
                node = child;
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => node = child,
            _ => return false,
        }
    };
    let primitive = Primitive::new(&shape.geometry);
    if !primitive.shape().is_convex() {
        return false;
    }
    if !primitive.shape().is_solid() {
        return true;
    }
    let automatic = matches!(scene.view, View::Automatic);
    if automatic && !primitive.shape().bounds().is_finite() {
        return false;
    }
    // An automatic camera stands outside of what it frames. Any other may be chosen.
    let Some(back) = matrix.inverse() else {
        return false;
    };
    scene.cameras.iter().all(|camera| {
        // Behind a projection matrix rays start anywhere.
        camera.projection.is_none() && {
            let line = Line::new(back.point(camera.position).into(), Vec3::new(0.0, 0.0, 1.0));
            let mut roots = Roots::<f64>::default();
            primitive.intersect().crossings(&line, &mut roots);
            // A camera in the surface counts as inside.
            let crossed = roots.list.iter().filter(|r| r.t < 0.0).count();
            let on_surface = roots.list.iter().any(|r| r.t == 0.0);
            !on_surface && roots.inside == (crossed % 2 == 1)
        }
    })
}
