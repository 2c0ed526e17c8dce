//! Bounding volumes. Those that are proved to hold their objects help POV-Ray; others would cut the objects.

use std::collections::HashMap;

use crate::geometry::Aabb;
use crate::scene::{NodeId, Scene, Vec3, Volume};
use crate::solids::bounds::NodeBounds;

/// For each object the last of its volumes that certainly holds it, and whether that was written.
pub(super) type Volumes = HashMap<NodeId, (Volume, bool)>;

pub(super) fn proved(scene: &Scene, bounds: &[NodeBounds]) -> Volumes {
    let held = |node: NodeId, volume: &Volume| {
        let all = bounds[node as usize].all;
        all.is_finite() && holds(volume, &all)
    };
    (scene.promises.iter())
        .filter(|p| held(p.node, &p.volume))
        .map(|p| (p.node, (p.volume, false)))
        .collect()
}

/// The IDs of the objects whose volumes were left out, among those for whose nodes `drawn` is true.
pub(super) fn left_out(
    scene: &Scene,
    volumes: &Volumes,
    drawn: impl Fn(NodeId) -> bool,
) -> Vec<u32> {
    let written = |node| volumes.get(node).is_some_and(|(_, written)| *written);
    let promises = scene.promises.iter().filter(|p| drawn(p.node));
    let mut ids: Vec<u32> = promises
        .filter(|p| !written(&p.node))
        .map(|p| p.id)
        .collect();
    ids.dedup();
    ids
}

/// Whether a volume holds a box, up to the rounding of the box's own numbers.
fn holds(volume: &Volume, b: &Aabb) -> bool {
    // The bound allows for a few thousand roundings, of the matrices on the way to the box.
    const ROUNDING: f64 = 1e-12;
    let room = ROUNDING * b.radius();
    match volume {
        Volume::Box { min, max } => {
            (0..3).all(|i| b.min[i] >= min[i] - room && b.max[i] <= max[i] + room)
        }
        Volume::Sphere { centre, radius } => {
            let [x, y, z]: Vec3 = std::array::from_fn(|i| {
                (b.max[i] - centre[i])
                    .abs()
                    .max((b.min[i] - centre[i]).abs())
            });
            x.hypot(y).hypot(z) <= radius + room
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_have_to_be_within() {
        let cube = Aabb::new([-1.0; 3], [1.0; 3]);
        let sphere = |radius| Volume::Sphere {
            centre: [0.0; 3],
            radius,
        };
        assert!(holds(&sphere(1.74), &cube) && !holds(&sphere(1.73), &cube));
        let max = [1.0, 1.0, 0.9];
        assert!(!holds(
            &Volume::Box {
                min: [-1.0; 3],
                max
            },
            &cube
        ));
    }
}
