//! Tools that end flush with what they cut: which of the two faces in one place POV-Ray takes for the
//! nearer one is up to rounding. Such a tool is written longer than it is. That changes nothing: what
//! is added lies outside of the thing that is cut.

use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Node, NodeId};
use crate::solids::shapes::facts::Facts as _;
use crate::solids::shapes::lengthen::{Cut, HAIR, HALF};
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::{Change, moved_back};
use crate::translate::pov::model::state::State;

/// So many nodes of a tool are looked at.
const PATIENCE: u32 = 4096;

impl Model<'_> {
    /// The number of the box around what is cut, for a tool that has a shape which ends flush with it.
    pub fn flush(&mut self, tool: NodeId, around: Aabb) -> Option<u32> {
        self.flush_by(tool, Cut::of(around, HALF))
    }

    pub fn flush_by(&mut self, tool: NodeId, all: Cut) -> Option<u32> {
        let Cut { around, by, most } = all;
        if around.is_empty()
            || around
                .min
                .iter()
                .chain(&around.max)
                .all(|x| x.is_infinite())
        {
            return None;
        }
        let mut todo = vec![(tool, around)];
        for _ in 0..PATIENCE {
            let (node, cut) = todo.pop()?;
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    let around = cut;
                    if geometry.lengthened(&Cut { around, by, most }).is_some() {
                        return Some(self.changes.number(Change::Longer(all)));
                    }
                }
                Node::Transform { child, matrix } => {
                    let matrix = &self.scene.matrices[matrix as usize];
                    todo.extend(moved_back(cut, matrix).map(|cut| (child, cut)));
                }
                other => {
                    let children = other.children();
                    todo.extend(children.into_iter().flatten().map(|child| (child, cut)));
                }
            }
        }
        None
    }
}

/// Of more tools none are compared with each other.
const MANY: usize = 256;

impl Model<'_> {
    /// Tools that end in one plane, from its two sides, would leave a skin there: one of them is made
    /// longer where it stays within the other. Where it does not, the report says so. `cut` is a box
    /// around what they are taken from.
    pub fn overlap_tools(&mut self, tools: &mut [(NodeId, State)], cut: Aabb) {
        if tools.len() > MANY {
            return;
        }
        for i in 0..tools.len() {
            for j in 0..tools.len() {
                for axis in 0..3 {
                    let (a, b) = (self.box_of(tools[i].0), self.box_of(tools[j].0));
                    if i != j && touch(&a, &b, axis) {
                        self.overlap_pair(tools, (i, j), axis, cut);
                    }
                }
            }
        }
    }

    /// The first of the pair ends where the second begins.
    fn overlap_pair(
        &mut self,
        tools: &mut [(NodeId, State)],
        (i, j): (usize, usize),
        axis: usize,
        cut: Aabb,
    ) {
        let [a, b] = [i, j].map(|k| self.box_of(tools[k].0));
        // They may end flush with that, too.
        let (mut below, mut above) = (cut, cut);
        below.max[axis] = a.max[axis];
        above.min[axis] = b.min[axis];
        let [Some(first), Some(second)] =
            [(i, below), (j, above)].map(|(k, half)| self.flush(tools[k].0, half))
        else {
            return;
        };
        for (k, other, flush) in [(i, j, first), (j, i, second)] {
            let (own, room) = (self.box_of(tools[k].0), self.box_of(tools[other].0));
            let fits = (0..3).all(|x| match x == axis {
                true => (own.max[x] - own.min[x]) / 2.0 < room.max[x] - room.min[x],
                false => own.min[x] >= room.min[x] && own.max[x] <= room.max[x],
            });
            let state = &mut tools[k].1;
            if fits && state.flush.is_none() && self.is_box(tools[other].0) {
                state.flush = Some(flush);
                return;
            }
        }
        self.faces_in_one_place(self.ids[tools[i].0 as usize]);
    }

    /// Whether a node is a box along the axes.
    fn is_box(&self, node: NodeId) -> bool {
        (self.along_the_axes(node)).is_some_and(|g| g.character().is_its_bounds)
    }

    /// The shape that a node is, if its axes are along those of the node.
    pub fn along_the_axes(&self, mut node: NodeId) -> Option<&Geometry> {
        loop {
            node = match self.scene.nodes[node as usize] {
                Node::Shape(shape) => return Some(&self.scene.shapes[shape as usize].geometry),
                Node::Paint { child, .. } | Node::Copy { child, .. } => child,
                Node::Transform { child, matrix } => {
                    if !is_along(&self.scene.matrices[matrix as usize]) {
                        return None;
                    }
                    child
                }
                _ => return None,
            }
        }
    }
}

/// Whether a matrix leaves the axes along the axes.
pub fn is_along(m: &Matrix) -> bool {
    let along = |row: &[f64; 4]| row[..3].iter().filter(|x| **x != 0.0).count() == 1;
    m.0.iter().take(3).all(along)
}

/// Whether one box ends along an axis where the other begins, with more than an edge in common.
fn touch(a: &Aabb, b: &Aabb, axis: usize) -> bool {
    let (end, start) = (a.max[axis], b.min[axis]);
    let size = end.abs().max(start.abs()).max(a.max[axis] - a.min[axis]);
    size.is_finite()
        && (end - start).abs() <= HAIR * size
        && (0..3).all(|i| i == axis || a.min[i].max(b.min[i]) < a.max[i].min(b.max[i]))
}
