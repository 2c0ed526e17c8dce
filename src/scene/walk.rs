//! Ways through a scene: down the states of one object, up from the shapes, and down from a root. None of them is
//! recursive, so a scene may be deep.

use super::model::{Node, NodeId, Scene};
use crate::geometry::Matrix;

impl Node {
    /// Whether the node is a later state of its child's object: the child moved or painted.
    pub fn is_change(self) -> bool {
        matches!(self, Node::Transform { .. } | Node::Paint { .. })
    }

    /// The child of a node that moves, paints or copies it. `None` for a shape, an operation or a complement.
    pub fn earlier(self) -> Option<NodeId> {
        match self {
            Node::Transform { child, .. }
            | Node::Paint { child, .. }
            | Node::Copy { child, .. } => Some(child),
            _ => None,
        }
    }

    /// The two operands of a union, intersection or difference. `None` for other nodes.
    pub fn operands(self) -> Option<[NodeId; 2]> {
        match self {
            Node::Union(a, b) | Node::Intersection(a, b) | Node::Difference(a, b) => Some([a, b]),
            _ => None,
        }
    }

    /// The node with each child replaced by what `of` returns for it.
    pub fn with_children(self, of: impl Fn(NodeId) -> NodeId) -> Node {
        match self {
            Node::Shape(_) => self,
            Node::Union(a, b) => Node::Union(of(a), of(b)),
            Node::Intersection(a, b) => Node::Intersection(of(a), of(b)),
            Node::Difference(a, b) => Node::Difference(of(a), of(b)),
            Node::Complement(child) => Node::Complement(of(child)),
            Node::Transform { child, matrix } => Node::Transform {
                child: of(child),
                matrix,
            },
            Node::Paint { child, paint } => Node::Paint {
                child: of(child),
                paint,
            },
            Node::Copy { child, id } => Node::Copy {
                child: of(child),
                id,
            },
        }
    }
}

/// Computes a value for each node, in order. `value` gets the number of the node, the node, and the values of all nodes
/// before it, among which are its children.
pub fn fold_up<T>(nodes: &[Node], mut value: impl FnMut(NodeId, Node, &[T]) -> T) -> Vec<T> {
    let mut done = Vec::with_capacity(nodes.len());
    for (id, &node) in (0..).zip(nodes) {
        done.push(value(id, node, &done));
    }
    done
}

impl Scene {
    /// The nodes of the arena up to the root, which is the last one. All parts of the root are among them.
    pub fn up_to(&self, root: NodeId) -> &[Node] {
        &self.nodes[..=root as usize]
    }

    /// The node, all earlier states of its object, and those of the object that it is a copy of. The last one is a
    /// shape, an operation or a complement.
    pub fn states(&self, node: NodeId) -> impl Iterator<Item = (NodeId, Node)> {
        let mut next = Some(node);
        std::iter::from_fn(move || {
            let id = next?;
            let node = self.nodes[id as usize];
            next = node.earlier();
            Some((id, node))
        })
    }

    /// The node that the defining record of an object made: the object before later moves and paints.
    pub fn defined(&self, node: NodeId) -> NodeId {
        let mut states = self.states(node).filter(|(_, n)| !n.is_change());
        states.next().map_or(node, |(id, _)| id)
    }

    /// The core of a node: the shape, operation or complement below all moves, paints and copies. `matrix` leads from
    /// the node's coordinates to others; the returned matrix leads to the same ones from the core's coordinates.
    pub fn core(&self, node: NodeId, matrix: Matrix) -> (NodeId, Matrix) {
        self.states(node)
            .fold((node, matrix), |(_, m), (id, node)| match node {
                Node::Transform { matrix, .. } => (id, m.after(&self.matrices[matrix as usize])),
                _ => (id, m),
            })
    }

    /// For each node up to the root, how often it is a child within the object of the root. The root itself counts
    /// once.
    pub fn uses(&self, root: NodeId) -> Vec<u32> {
        let mut uses = vec![0u32; root as usize + 1];
        uses[root as usize] = 1;
        for (id, node) in self.up_to(root).iter().enumerate().rev() {
            if uses[id] > 0 {
                for child in node.children() {
                    let uses = &mut uses[child as usize];
                    *uses = uses.saturating_add(1);
                }
            }
        }
        uses
    }

    /// The root and all its parts, parents before their children.
    pub fn below(&self, root: NodeId) -> impl Iterator<Item = (NodeId, Node)> {
        let uses = self.uses(root);
        let nodes = (0..=root).rev().zip(self.up_to(root).iter().rev());
        nodes.filter_map(move |(id, &node)| (uses[id as usize] > 0).then_some((id, node)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    #[test]
    fn a_core_is_below_all_changes_and_copies() {
        let scene = scene("2 11 0 0 0 1\n2 -1 1 2 3\n3 -105 2\n3 -1 0 0 4\n1 9999 3 0");
        let root = scene.render.unwrap().root;
        let (core, m) = scene.core(root, Matrix::IDENTITY);
        assert!(matches!(scene.nodes[core as usize], Node::Shape(0)));
        assert_eq!(m.point([0.0; 3]), [1.0, 2.0, 7.0]);
        assert_eq!(scene.below(root).count(), scene.nodes.len());
    }
}
