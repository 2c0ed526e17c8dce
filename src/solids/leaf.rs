//! The leaves of a tree: shapes in the places where they occur.

use crate::geometry::{Aabb, Matrix};
use crate::scene::{NodeId, Scene};
use crate::solids::shapes::facts::Facts;
use crate::solids::{Named, named};

/// A shape where it occurs in a tree, or a part of the scene that is known as a whole only.
#[derive(Debug, Clone)]
pub struct Leaf {
    /// The leaf's own node.
    pub node: NodeId,
    /// Index into the scene's shapes; `None` for a part that is known as a whole.
    pub shape: Option<u32>,
    /// The ID under which the shape is written where it occurs: its own or that of a copy.
    pub id: u32,
    /// The map from the shape's coordinates into those of the root.
    pub matrix: Matrix,
    /// The bounds in place; infinite for an endless shape.
    pub bounds: Aabb,
    /// The longest side of the bounds.
    pub size: f64,
    /// Index into the places of the tree.
    pub place: u32,
}

impl Leaf {
    pub fn new(
        scene: &Scene,
        node: NodeId,
        shape: u32,
        copy: Option<u32>,
        matrix: Matrix,
        place: u32,
    ) -> Leaf {
        let written = &scene.shapes[shape as usize];
        Leaf {
            shape: Some(shape),
            id: copy.unwrap_or(written.id),
            ..Leaf::within(node, written.geometry.bounds(&matrix), matrix, place)
        }
    }

    /// A part that is known as a whole, with its bounds in its own coordinates.
    pub fn part(node: NodeId, bounds: Aabb, matrix: Matrix, place: u32) -> Leaf {
        Leaf::within(node, bounds.transformed(&matrix), matrix, place)
    }

    /// The shape's name and place in the file; `None` for a part that is known as a whole.
    pub fn written(&self, scene: &Scene) -> Option<Named> {
        self.shape.and_then(|_| named(scene, self.node))
    }

    fn within(node: NodeId, bounds: Aabb, matrix: Matrix, place: u32) -> Leaf {
        Leaf {
            node,
            shape: None,
            id: 0,
            matrix,
            bounds,
            size: (0..3).fold(0.0f64, |s, i| s.max(bounds.max[i] - bounds.min[i])),
            place,
        }
    }
}
