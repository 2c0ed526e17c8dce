//! Scenes of one convex shape, in which nothing can be in the way of anything.

use super::unseen::LeftOut;
use crate::geometry::Matrix;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::scene::{Node, NodeId, Scene, Shape, View};
use crate::trace::shapes::{Primitive, Roots};
use rustc_hash::FxHashMap;

/// Whether the scene is one convex shape without a camera inside.
pub(super) fn lone_convex(scene: &Scene, root: NodeId, left_out: &LeftOut) -> bool {
    let Some((shape, matrix)) = lone(scene, root, left_out) else {
        return false;
    };
    let primitive = Primitive::new(&shape.geometry);
    if !primitive.shape().is_convex() {
        return false;
    }
    if !primitive.is_solid() {
        return true;
    }
    let automatic = matches!(scene.view, View::Automatic);
    if automatic && !primitive.shape().bounds().is_bounded() {
        return false;
    }
    // An automatic camera stands outside of what it frames. Any camera that is written may be chosen, so all are
    // tested.
    let Some(back) = matrix.inverse() else {
        return false;
    };
    scene.cameras.iter().all(|camera| {
        // The rays of a projection matrix may start anywhere.
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

/// The only shape of a scene, and its placement; `None` if there are others. Equal shapes that are placed equally count
/// as one.
fn lone<'s>(scene: &'s Scene, root: NodeId, left_out: &LeftOut) -> Option<(&'s Shape, Matrix)> {
    if left_out.all() {
        return None;
    }
    let mut found: Option<(&Shape, Matrix)> = None;
    // The placement at which each node has been met, so that shared nodes are looked into once.
    let mut seen: FxHashMap<NodeId, Matrix> = FxHashMap::default();
    let mut stack = vec![(root, Matrix::IDENTITY)];
    while let Some((node, matrix)) = stack.pop() {
        match seen.insert(node, matrix) {
            Some(before) if before == matrix => continue,
            Some(_) => return None,
            None => {}
        }
        match scene.nodes[node as usize] {
            Node::Shape(shape) => {
                let shape = &scene.shapes[shape as usize];
                match found {
                    Some((one, at)) if one.geometry != shape.geometry || at != matrix => {
                        return None;
                    }
                    _ => found = Some((shape, matrix)),
                }
            }
            Node::Union(a, b) => {
                stack.extend(left_out.kept(node, [a, b]).map(|operand| (operand, matrix)));
            }
            Node::Transform { child, matrix: m } => {
                stack.push((child, matrix.after(&scene.matrices[m as usize])));
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => stack.push((child, matrix)),
            _ => return None,
        }
    }
    found
}
