//! Faces in one place: faces of two operands, of which the boundary of the operation's result can have only one.

pub mod directions;
pub mod face;
mod planes;
pub mod quadric;
mod round;
mod sample;
pub mod search;

use crate::scene::Scene;
use crate::solids::bounds::NodeBounds;
use search::search;

/// Pairs of shapes in the drawn object that have faces in one place where this can be seen, as indices of
/// [`Scene::shapes`].
pub fn pairs(scene: &Scene, bounds: &[NodeBounds]) -> Vec<[u32; 2]> {
    let roots: Vec<_> = scene.render.iter().map(|r| r.root).collect();
    let found = search(scene, bounds, &roots);
    found.iter().map(|f| f.sides.map(|s| s.shape)).collect()
}
