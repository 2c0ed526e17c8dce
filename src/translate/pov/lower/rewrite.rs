//! Rewriting of scenes that leaves their meaning as it is: new nodes take the places of old ones.

use std::collections::HashMap;

use crate::scene::{Node, NodeId, Scene};
use crate::translate::pov::budget::{Budget, Limit};

/// The modifications of a node, which are the nodes that move or paint it: the last first.
pub(super) type Modifications = Vec<NodeId>;

/// The modifications of a node, and the node that they modify. This is a shape or operation, unless there are more
/// modifications than the limit.
pub(super) fn below(scene: &Scene, node: NodeId, budget: &Budget) -> (Modifications, NodeId) {
    let mut modifications = Modifications::new();
    for (steps, (id, state)) in scene.states(node).enumerate() {
        let is_core = !(state.is_change() || matches!(state, Node::Copy { .. }));
        if is_core || !budget.spend(Limit::Modifications, steps + 1) {
            return (modifications, id);
        }
        // A copy is no modification: it only gives its parts new names.
        if state.is_change() {
            modifications.push(id);
        }
    }
    (modifications, node)
}

/// A copy of a scene in which new nodes have taken the places of old ones.
pub(super) struct Rewrite {
    pub scene: Scene,
    new: HashMap<NodeId, NodeId>,
}

impl Rewrite {
    pub(super) fn of(scene: &Scene) -> Rewrite {
        Rewrite {
            scene: scene.clone(),
            new: HashMap::new(),
        }
    }

    /// Adds a node, and returns its number. As its origin it has the record that made the node `like`.
    pub(super) fn push(&mut self, node: Node, like: NodeId) -> NodeId {
        self.scene.nodes.push(node);
        self.scene.origins.push(self.scene.origins[like as usize]);
        self.scene.nodes.len() as NodeId - 1
    }

    /// A node to which modifications are applied. `way` has them, the last first.
    pub(super) fn done(&mut self, way: &[NodeId], mut node: NodeId) -> NodeId {
        for &step in way.iter().rev() {
            let next = self.scene.nodes[step as usize].with_children(|_| node);
            node = self.push(next, step);
        }
        node
    }

    /// The node that has taken the place of a node, or that node itself.
    pub(super) fn now(&self, node: NodeId) -> NodeId {
        self.new.get(&node).copied().unwrap_or(node)
    }

    pub(super) fn replace(&mut self, node: NodeId, by: NodeId) {
        self.new.insert(node, by);
    }

    /// The node with its operands replaced by the nodes that have taken their places.
    pub(super) fn renew(&mut self, node: NodeId) -> Node {
        self.scene.nodes[node as usize].with_children(|child| self.now(child))
    }

    /// Puts a renewed node in the place of the old one, if the two differ.
    pub(super) fn settle(&mut self, node: NodeId, renewed: Node) {
        if renewed != self.scene.nodes[node as usize] {
            let by = self.push(renewed, node);
            self.replace(node, by);
        }
    }

    /// The finished scene, in which every reference to a node leads to the node in its place.
    pub(super) fn finish(self) -> Scene {
        let Rewrite { mut scene, new } = self;
        let now = |node: &mut NodeId| *node = new.get(node).copied().unwrap_or(*node);
        scene.render.iter_mut().for_each(|r| now(&mut r.root));
        (scene.promises.iter_mut()).for_each(|p| now(&mut p.node));
        for entity in &mut scene.entities {
            if let Some(mut node) = entity.node() {
                now(&mut node);
                entity.set_node(node);
            }
        }
        scene
    }
}
