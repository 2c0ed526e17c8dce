//! The scene as a tree in which every shape is in its place, and the value of every part of it at a point.
//!
//! A node that occurs twice stands here twice. A point is outside of most shapes, and the value of an operation outside
//! of all its shapes is known beforehand. So only the few shapes whose bounds hold the point are looked at, however
//! long the chain of which they are parts.

use super::ancestry::{Ancestry, NONE};
use super::leaf::Leaf;
use crate::geometry::Matrix;
use crate::scene::{Node, NodeId, Scene, fold_up};
use crate::solids::bounds::NodeBounds;

/// The most nodes that are gone through for the second time or more. If shared parts would take more, the rest of them
/// are known as a whole only.
const MAX_REPEATED_NODES: u32 = 400_000;

/// An answer about a point: inside (`true`), outside (`false`), or not known.
pub type Answer = Option<bool>;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Join {
    Leaf,
    Or,
    And,
}

/// A leaf, or an operation with two operands. Transformations are in the leaves' matrices,
/// complements and the second operands of differences in `negated`.
#[derive(Debug, Clone, Copy)]
pub struct TreeNode {
    /// The scene's node.
    pub node: NodeId,
    join: Join,
    parent: u32,
    pub children: [u32; 2],
    /// The end of the places below: one more than the last.
    end: u32,
    depth: u32,
    /// Whether the parent is made of the complement of the node.
    pub negated: bool,
    /// Whether there is an odd number of complements on the way from the root.
    pub turned: bool,
    /// Whether the node is a difference or an intersection.
    pub cuts: bool,
    /// The topmost difference or intersection that the node is, or of which it is a part; else [`NONE`].
    pub group: u32,
    /// Whether a point outside of all shapes of the node is in the node.
    outside: bool,
    /// The depth of the lowest place above whose value does not depend on this node's, as long as the point is outside
    /// of all shapes of the other operands on the way; −1 if there is none.
    absorbing_depth: i64,
    /// The innermost copy of more than a single shape of which the node is a part: the copy's ID, and the depth at
    /// which it begins.
    copy: Option<(u32, u32)>,
}

pub struct Tree {
    /// The nodes. Parents stand before their children, and all parts of a first operand before the second operand.
    pub places: Vec<TreeNode>,
    ancestry: Ancestry,
    /// For each place, the highest place that is reached by way of unions alone.
    components: Vec<u32>,
    pub leaves: Vec<Leaf>,
}

/// A node that is still to be placed.
struct Task {
    node: NodeId,
    matrix: Matrix,
    negated: bool,
    parent: u32,
    operand: usize,
    copy: Option<(u32, u32)>,
    /// Whether the node is part of another one whose cost has been paid.
    paid: bool,
}

/// Costs of nodes that are gone through again.
struct Costs {
    /// Cost of each node with everything below, shared nodes as often as they occur.
    weights: Vec<u32>,
    seen: Vec<bool>,
    left: u32,
}

impl Tree {
    /// Builds the tree of these nodes and all their parts.
    pub fn new(scene: &Scene, bounds: &[NodeBounds], roots: &[NodeId]) -> Tree {
        let mut costs = Costs {
            weights: weights(scene),
            seen: vec![false; scene.nodes.len()],
            left: MAX_REPEATED_NODES,
        };
        let mut tree = Tree {
            places: Vec::new(),
            ancestry: Ancestry::default(),
            components: Vec::new(),
            leaves: Vec::new(),
        };
        let start = |&node: &NodeId| Task {
            node,
            matrix: Matrix::IDENTITY,
            negated: false,
            parent: NONE,
            operand: 0,
            copy: None,
            paid: false,
        };
        let mut todo: Vec<Task> = roots.iter().rev().map(start).collect();
        while let Some(task) = todo.pop() {
            tree.place(scene, bounds, task, &mut costs, &mut todo);
        }
        tree.finish();
        tree
    }

    fn place(
        &mut self,
        scene: &Scene,
        bounds: &[NodeBounds],
        mut task: Task,
        costs: &mut Costs,
        todo: &mut Vec<Task>,
    ) {
        let here = self.places.len() as u32;
        let above = (task.parent != NONE).then(|| self.places[task.parent as usize]);
        let depth = above.map_or(0, |p| p.depth + 1);
        // The ID of a copy. If the copy is of a single shape, the shape is known by this ID.
        let mut direct = None;
        let known = loop {
            let weight = costs.weights[task.node as usize];
            if weight > 1
                && !task.paid
                && std::mem::replace(&mut costs.seen[task.node as usize], true)
            {
                match costs.left.checked_sub(weight) {
                    Some(left) => (costs.left, task.paid) = (left, true),
                    None => break false,
                }
            }
            task.node = match scene.nodes[task.node as usize] {
                Node::Transform { child, matrix } => {
                    task.matrix = task.matrix.after(&scene.matrices[matrix as usize]);
                    child
                }
                Node::Paint { child, .. } => child,
                Node::Copy { child, id } => {
                    direct = direct.or(Some(id));
                    child
                }
                Node::Complement(child) => {
                    task.negated = !task.negated;
                    task.copy = direct.take().map(|id| (id, depth)).or(task.copy);
                    child
                }
                _ => break true,
            };
        };
        let node = scene.nodes[task.node as usize];
        let operands = node.operands().filter(|_| known);
        if operands.is_some() {
            task.copy = direct.take().map(|id| (id, depth)).or(task.copy);
        }
        let cuts = operands.is_some() && !matches!(node, Node::Union(..));
        let group = match above.map_or(NONE, |p| p.group) {
            NONE if cuts => here,
            group => group,
        };
        if let Some(above) = self.places.get_mut(task.parent as usize) {
            above.children[task.operand] = here;
        }
        self.places.push(TreeNode {
            node: task.node,
            join: match (operands, cuts) {
                (None, _) => Join::Leaf,
                (_, true) => Join::And,
                (_, false) => Join::Or,
            },
            parent: task.parent,
            children: [NONE; 2],
            end: here + 1,
            depth,
            negated: task.negated,
            turned: above.is_some_and(|p| p.turned) != task.negated,
            cuts,
            group,
            outside: false,
            absorbing_depth: -1,
            copy: task.copy,
        });
        match operands {
            Some(operands) => {
                for (operand, child) in operands.into_iter().enumerate().rev() {
                    todo.push(Task {
                        node: child,
                        matrix: task.matrix,
                        negated: operand == 1 && matches!(node, Node::Difference(..)),
                        parent: here,
                        operand,
                        copy: task.copy,
                        paid: task.paid,
                    });
                }
            }
            None => {
                let (node, matrix) = (task.node, task.matrix);
                self.leaves.push(match scene.nodes[node as usize] {
                    Node::Shape(shape) => Leaf::new(scene, node, shape, direct, matrix, here),
                    _ => Leaf::part(node, bounds[node as usize].all, matrix, here),
                });
            }
        }
    }

    /// Computes the values that follow from the places below, and then those that follow from the places above.
    fn finish(&mut self) {
        for i in (0..self.places.len()).rev() {
            let place = self.places[i];
            if place.join != Join::Leaf {
                let [a, b] = place.children.map(|c| self.places[c as usize]);
                let rest = [a, b].map(|p| p.outside != p.negated);
                let place = &mut self.places[i];
                place.end = b.end;
                place.outside = match place.join {
                    Join::Or => rest[0] || rest[1],
                    _ => rest[0] && rest[1],
                };
            }
        }
        let parents: Vec<u32> = self.places.iter().map(|p| p.parent).collect();
        self.ancestry = Ancestry::new(&parents);
        self.components = (0..self.places.len() as u32).collect();
        for i in 0..self.places.len() {
            let place = self.places[i];
            if place.join == Join::Leaf {
                continue;
            }
            let [a, b] = place.children;
            if place.join == Join::Or {
                for child in [a, b] {
                    self.components[child as usize] = self.components[i];
                }
            }
            for (child, other) in [(a, b), (b, a)] {
                let other = self.places[other as usize];
                // True settles an "or", false an "and".
                let settles = (other.outside != other.negated) == (place.join == Join::Or);
                self.places[child as usize].absorbing_depth = match settles {
                    true => i64::from(place.depth),
                    false => place.absorbing_depth,
                };
            }
        }
    }

    /// The difference or intersection that joins two places. `None` if a union joins them, or they have different
    /// roots.
    pub fn cut(&self, a: u32, b: u32) -> Option<u32> {
        // Most places that are near each other are parts of one union.
        if self.components[a as usize] == self.components[b as usize] {
            return None;
        }
        let join = self.ancestry.join(a, b)?;
        self.places[join as usize].cuts.then_some(join)
    }

    /// Whether only differences and intersections are between a place and an operation of which it is a part, so that
    /// no more is left of the operand than of the place.
    pub fn only_cuts_between(&self, mut place: u32, operation: u32) -> bool {
        loop {
            place = self.places[place as usize].parent;
            if place == operation || place == NONE {
                return place == operation;
            }
            if !self.places[place as usize].cuts {
                return false;
            }
        }
    }

    /// The ID of the copy by which a place is known within an operation that it is part of. `None` if there is none.
    pub fn copy_within(&self, place: u32, operation: u32) -> Option<u32> {
        let (id, depth) = self.places[place as usize].copy?;
        (depth > self.places[operation as usize].depth).then_some(id)
    }

    /// The value of the place `to` above `from` if `from` has the value `x` and the point is outside of all other
    /// leaves of `to`.
    fn lift(&self, from: u32, to: u32, x: Answer) -> Answer {
        let (from, to) = (&self.places[from as usize], &self.places[to as usize]);
        if from.absorbing_depth >= i64::from(to.depth) {
            return Some(to.outside);
        }
        x.map(|x| x != (from.turned != to.turned))
    }

    /// The value of `top` if the places in `answers` have the values given there and the point is outside of all other
    /// leaves. The places stand in their order, and none is part of another. Places that are no part of `top` are
    /// passed over.
    pub fn value(&self, top: u32, answers: &[(u32, Answer)]) -> Answer {
        let end = self.places[top as usize].end;
        let start = answers.partition_point(|a| a.0 < top);
        // Each entry has the place where it meets the entry below it.
        let mut stack: Vec<(u32, Answer, u32)> = Vec::new();
        for &(place, answer) in answers[start..].iter().take_while(|a| a.0 < end) {
            let mut meet = top;
            if let Some(last) = stack.last() {
                meet = self.ancestry.join(last.0, place).unwrap_or(top);
                self.reduce(&mut stack, i64::from(self.places[meet as usize].depth));
            }
            stack.push((place, answer, meet));
        }
        self.reduce(&mut stack, -1);
        match stack.pop() {
            Some((place, answer, _)) => self.lift(place, top, answer),
            None => Some(self.places[top as usize].outside),
        }
    }

    /// Joins the last entries of the stack as long as they meet deeper than `depth`.
    fn reduce(&self, stack: &mut Vec<(u32, Answer, u32)>, depth: i64) {
        while let [.., one, two] = stack.as_slice() {
            let meet = self.places[two.2 as usize];
            if i64::from(meet.depth) <= depth {
                break;
            }
            let [a, b] = meet.children;
            let side = |of: (u32, Answer, u32), child: u32| {
                let x = self.lift(of.0, child, of.1);
                x.map(|x| x != self.places[child as usize].negated)
            };
            let (x, y) = (side(*one, a), side(*two, b));
            let answer = match meet.join {
                Join::Or => either(x, y),
                _ => both(x, y),
            };
            let joined = (two.2, answer, one.2);
            stack.truncate(stack.len() - 2);
            stack.push(joined);
        }
    }

    /// The value of the root if the place has the value false, provided that the place decides the value of the root.
    /// `None` if it does not, or this is not known.
    pub fn decides(&self, place: u32, answers: &[(u32, Answer)]) -> Answer {
        let end = self.places[place as usize].end;
        let before = answers.partition_point(|a| a.0 < place);
        let after = answers.partition_point(|a| a.0 < end);
        let mut others = answers[..before].to_vec();
        others.push((place, None));
        others.extend_from_slice(&answers[after..]);
        let root = self.ancestry.root(place);
        let [without, with] = [false, true].map(|x| {
            others[before].1 = Some(x);
            self.value(root, &others)
        });
        (with? != without?).then_some(without?)
    }
}

/// The number of nodes of which each node is made, shared ones counted as often as they occur.
fn weights(scene: &Scene) -> Vec<u32> {
    fold_up(&scene.nodes, |_, node, out| {
        let children = node.children();
        children.fold(1u32, |w, c| w.saturating_add(out[c as usize]))
    })
}

/// Kleene's "or": true if one of the answers is true, not known if that depends on unknown answers.
pub fn either(a: Answer, b: Answer) -> Answer {
    match (a, b) {
        (Some(true), _) | (_, Some(true)) => Some(true),
        (Some(false), Some(false)) => Some(false),
        _ => None,
    }
}

pub fn both(a: Answer, b: Answer) -> Answer {
    either(a.map(|x| !x), b.map(|x| !x)).map(|x| !x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::SourceFile;
    use crate::solids::bounds::node_bounds;
    use crate::testing::random;
    use crate::{scene, syntax};

    /// The value of a node where these leaves hold the point, one operation after the other.
    fn plainly(tree: &Tree, held: &[(u32, Answer)], forced: Option<(u32, Answer)>) -> Vec<Answer> {
        let mut out = vec![Some(false); tree.places.len()];
        for i in (0..tree.places.len()).rev() {
            let place = &tree.places[i];
            if place.join == Join::Leaf {
                if let Some(h) = held.iter().find(|h| h.0 == i as u32) {
                    out[i] = h.1;
                }
            } else {
                let [a, b] = place.children.map(|c| {
                    let c = c as usize;
                    out[c].map(|x| x != tree.places[c].negated)
                });
                out[i] = match place.join {
                    Join::Or => either(a, b),
                    _ => both(a, b),
                };
            }
            if let Some((at, answer)) = forced
                && at == i as u32
            {
                out[i] = answer;
            }
        }
        out
    }

    fn tree(text: &str) -> Tree {
        let source = SourceFile::new("t.zpg", text.into());
        let mut all = Vec::new();
        let (document, _) = syntax::parse(&source.text);
        let scene = scene::resolve(&document, &source, &mut all);
        assert!(
            all.iter()
                .all(|d| !d.code.as_str().starts_with('E') || d.code.as_str() == "E106")
        );
        let root = scene.entities.last().and_then(|e| e.node()).unwrap();
        Tree::new(&scene, &node_bounds(&scene), &[root])
    }

    /// Random trees, all of whose operations and some of whose leaves are asked for.
    #[test]
    fn jumps_come_to_what_single_steps_do() {
        let mut random = random();
        for _ in 0..300 {
            let count = 2 + random(12);
            let mut text = String::new();
            let mut parts: Vec<u64> = (2..2 + count).collect();
            parts.iter().for_each(|i| text += &format!("{i} 9 1\n"));
            let mut next = 2 + count;
            while parts.len() > 1 {
                let a = parts.swap_remove(random(parts.len() as u64) as usize);
                let b = parts.swap_remove(random(parts.len() as u64) as usize);
                text += &format!("{next} -10{} {a} {b}\n", 1 + random(3));
                if random(4) == 0 {
                    text += &format!("{} -104 {next}\n", next + 1);
                    next += 1;
                }
                parts.push(next);
                next += 1;
            }
            let tree = tree(&text);
            for _ in 0..8 {
                let mut held: Vec<(u32, Answer)> = Vec::new();
                for leaf in &tree.leaves {
                    match random(5) {
                        0 => held.push((leaf.place, None)),
                        1 | 2 => held.push((leaf.place, Some(true))),
                        _ => {}
                    }
                }
                let expected = plainly(&tree, &held, None);
                for i in 0..tree.places.len() as u32 {
                    assert_eq!(
                        tree.value(i, &held),
                        expected[i as usize],
                        "{text}\n{held:?} {i}"
                    );
                    let [without, with] =
                        [false, true].map(|x| plainly(&tree, &held, Some((i, Some(x))))[0]);
                    let decides = match (without, with) {
                        (Some(a), Some(b)) if a != b => Some(a),
                        _ => None,
                    };
                    assert_eq!(tree.decides(i, &held), decides, "{text}\n{held:?} {i}");
                }
            }
        }
    }
}
