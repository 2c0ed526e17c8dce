//! Whether faces within opaque solids can be seen.

use super::materials::Material;
use super::tables::Tables;
use crate::geometry::vec::Vec3;
use crate::scene::{Node, NodeId, Scene};
use crate::trace::members;

/// The largest number of nodes that are searched for one that holds a camera. Beyond it the camera is taken to be in an
/// opaque solid.
const PARTS: usize = 256;

/// Whether a camera is in an opaque solid, or may be in one: it sees faces that are inside of others.
pub(super) fn camera_is_walled_in(scene: &Scene, facts: &[Material], tables: &Tables) -> bool {
    let root = facts.len() as NodeId - 1;
    let is_walled_in = |point: Vec3| {
        let mut todo = vec![(root, point)];
        for _ in 0..PARTS {
            let Some((node, point)) = todo.pop() else {
                return false;
            };
            if !members(scene, node, point).is_ok_and(|m| m.in_root) {
                continue;
            }
            let optics = facts[node as usize].optics;
            match scene.nodes[node as usize] {
                _ if optics.uniform => {
                    if !tables.is_transparent(optics.first) {
                        return true;
                    }
                }
                Node::Union(a, b) => todo.extend([(a, point), (b, point)]),
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push((child, point)),
                Node::Transform { child, matrix } => {
                    let Some(back) = scene.matrices[matrix as usize].inverse() else {
                        return true;
                    };
                    todo.push((child, back.point(point.0).into()));
                }
                _ => return true,
            }
        }
        true
    };
    (scene.chosen_cameras()).any(|camera| is_walled_in(camera.position.into()))
}
