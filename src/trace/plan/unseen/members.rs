//! The parts of the outermost union, with their placements.

use crate::diagnostics::Span;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3, fold_up};
use crate::solids::bounds::NodeBounds;
use crate::solids::named;
use crate::solids::shapes::facts::Facts;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The share by which a ball is taken to be smaller, so that it is apart from things that it touches in a single point.
/// It is far more than rounding errors.
pub(super) const TOUCHING_SHARE: f64 = 1e-6;

/// The place in the scene's unions where a part is written.
#[derive(Debug, Clone, Copy)]
pub(super) enum Slot {
    /// The root, which is itself the only part.
    Root,
    /// A union, and the number of the operand, 0 or 1.
    Operand(NodeId, usize),
}

/// A part of the outermost union: a shape or anything that is no union, or a union that occurs more
/// than once.
#[derive(Debug, Clone)]
pub(super) struct Member {
    pub slot: Slot,
    /// The operand node, with its transformations and properties.
    pub node: NodeId,
    /// Index into the scene's shapes, if the part is a single shape.
    pub shape: Option<u32>,
    /// The matrix that moves the part; `None` if nothing moves it.
    moved: Option<Arc<Matrix>>,
    /// The bounds in the coordinates of the scene.
    pub bounds: Aabb,
    /// Whether any of the part may let light through, by the properties that apply after overriding.
    pub clear: bool,
    /// Whether the part is a single shape without inside.
    pub sheet: bool,
}

impl Member {
    /// The map from the coordinates below the member's transformations into the coordinates of the scene.
    pub(super) fn matrix(&self) -> &Matrix {
        self.moved.as_deref().unwrap_or(&Matrix::IDENTITY)
    }

    /// The bounds of the part. A ball or an ellipsoid is made smaller about its centre by a share.
    pub(super) fn bounds_less(&self, scene: &Scene, share: f64) -> Aabb {
        match self.is_ball(scene, share) {
            true => {
                let (centre, factor) = (self.bounds.centre(), 1.0 - share);
                let less = |p: Vec3| [0, 1, 2].map(|i| centre[i] + factor * (p[i] - centre[i]));
                Aabb::new(less(self.bounds.min), less(self.bounds.max))
            }
            false => self.bounds,
        }
    }

    /// Like [`matrix`](Self::matrix), but a ball or an ellipsoid is made smaller about its centre by a share.
    pub(super) fn matrix_less(&self, scene: &Scene, share: f64) -> Matrix {
        match self.is_ball(scene, share) {
            true => {
                let ([x, y, z], factor) = (self.bounds.centre(), 1.0 - share);
                let less = Matrix::scaling(factor, factor, factor);
                let about = less.after(&Matrix::translation(-x, -y, -z));
                Matrix::translation(x, y, z)
                    .after(&about)
                    .after(self.matrix())
            }
            false => *self.matrix(),
        }
    }

    fn is_ball(&self, scene: &Scene, share: f64) -> bool {
        let has_size = self.bounds.is_finite() && !self.bounds.is_empty();
        let is_ball = |g: &Geometry| g.ball().is_some();
        share > 0.0 && has_size && self.geometry(scene).is_some_and(is_ball)
    }

    pub(super) fn geometry<'s>(&self, scene: &'s Scene) -> Option<&'s Geometry> {
        Some(&scene.shapes[self.shape? as usize].geometry)
    }

    /// The ID by which the operand is written in the union.
    pub(super) fn id(&self, scene: &Scene) -> u32 {
        match named(scene, self.node) {
            Some(named) => named.id,
            None => scene.origins.get(self.node as usize).map_or(0, |o| o.id),
        }
    }
}

/// The way down from the root to a part.
#[derive(Clone)]
struct PathToPart {
    node: NodeId,
    slot: Slot,
    operand: NodeId,
    /// The matrix of the transformations on the way; `None` if there are none, as for most parts. A matrix is large, so
    /// parts that move together share it.
    moved: Option<Arc<Matrix>>,
    /// Whether the paints above let light through; `None` if they have no optics.
    clear: Option<bool>,
    /// Whether some node on the way is used elsewhere too.
    shared: bool,
}

/// All members of the union at the root, in the order of the operands.
pub(super) fn members(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> Vec<Member> {
    let uses = scene.uses(root);
    let clear = clear(scene, root);
    let mut out = Vec::new();
    let mut todo = vec![PathToPart {
        node: root,
        slot: Slot::Root,
        operand: root,
        moved: None,
        clear: None,
        shared: false,
    }];
    while let Some(mut way) = todo.pop() {
        let at = way.node as usize;
        way.shared |= uses[at] > 1;
        match scene.nodes[at] {
            Node::Transform { child, matrix } => {
                let matrix = &scene.matrices[matrix as usize];
                let moved = way.moved.map_or(*matrix, |above| above.after(matrix));
                way.moved = Some(Arc::new(moved));
                way.node = child;
                todo.push(way);
            }
            Node::Copy { child, .. } => {
                way.node = child;
                todo.push(way);
            }
            Node::Paint { child, paint } => {
                let optics = scene.paints[paint as usize].optics;
                way.clear = way.clear.or(optics.map(|o| o.kt != [0.0; 3]));
                way.node = child;
                todo.push(way);
            }
            Node::Union(a, b) if !way.shared => {
                for (operand, node) in [a, b].into_iter().enumerate().rev() {
                    let slot = Slot::Operand(way.node, operand);
                    todo.push(PathToPart {
                        node,
                        slot,
                        operand: node,
                        ..way.clone()
                    });
                }
            }
            node => {
                let shape = match node {
                    Node::Shape(shape) => Some(shape),
                    _ => None,
                };
                let geometry = shape.map(|s| &scene.shapes[s as usize].geometry);
                out.push(Member {
                    slot: way.slot,
                    node: way.operand,
                    shape,
                    bounds: match (geometry, way.moved.as_deref()) {
                        (Some(geometry), Some(matrix)) => geometry.bounds(matrix),
                        (Some(_), None) => bounds[at].all,
                        (None, matrix) => bounds[at]
                            .all
                            .transformed(matrix.unwrap_or(&Matrix::IDENTITY)),
                    },
                    moved: way.moved,
                    clear: way.clear.unwrap_or(clear[at][0]),
                    sheet: geometry.is_some_and(|g| !g.is_solid()),
                });
            }
        }
    }
    out
}

/// For each node and for its complement, whether any of it may let light through, if no paint above changes that.
fn clear(scene: &Scene, root: NodeId) -> Vec<[bool; 2]> {
    fold_up(scene.up_to(root), |_, node, out: &[[bool; 2]]| {
        let of = |n: NodeId| out[n as usize];
        match node {
            Node::Shape(_) => [false; 2],
            Node::Union(a, b) | Node::Intersection(a, b) => {
                [0, 1].map(|turned| of(a)[turned] || of(b)[turned])
            }
            // Nothing is left of the solid that is taken away; −(A − B) is −A ∪ B.
            Node::Difference(a, b) => [of(a)[0], of(a)[1] || of(b)[0]],
            Node::Complement(child) => [of(child)[1], of(child)[0]],
            Node::Transform { child, .. } | Node::Copy { child, .. } => of(child),
            Node::Paint { child, paint } => match scene.paints[paint as usize].optics {
                Some(optics) => [optics.kt != [0.0; 3]; 2],
                None => of(child),
            },
        }
    })
}

/// For each ID, the place in the text where its entity is defined.
pub(super) fn definitions(scene: &Scene) -> FxHashMap<u32, Span> {
    scene.entities.iter().map(|e| (e.id, e.span)).collect()
}
