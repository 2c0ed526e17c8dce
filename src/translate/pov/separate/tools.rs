//! Holes that end flush with the solid that they are in. Rounding decides which of the two faces in one place POV-Ray
//! takes for the nearer one. So the tool of such a hole is written longer than it is. This changes nothing else: the
//! part that is added lies outside of the solid that is cut.

use super::settle::Operands;
use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::contacts::{Contact, Face, Orientation};

/// The distance, in units of `Model::hair`, by which tools are made longer: more than faces are moved by for other
/// reasons.
const LONGER: f64 = 32.0;
/// The distance, in units of `Model::hair`, by which tools are made longer into each other. The added part may be seen
/// beside the other tool, so it is short.
const LONGER_INTO_EACH_OTHER: f64 = 2.0;

impl Model<'_> {
    /// The number of the change that makes a tool longer where it ends flush with the base that it cuts; `None` if it
    /// does so nowhere.
    pub(crate) fn longer_tool(&mut self, tool: NodeId, base: NodeId) -> Option<u32> {
        let is_flush = |face: &Face, way| face.is_outer && way == Orientation::Alike;
        self.moved_out(tool, base, LONGER, is_flush)
    }

    /// Makes tools longer that end where other tools begin: a skin would be left between them otherwise. `cut` is the
    /// box of the solid that is cut.
    pub(crate) fn overlap_tools(&mut self, tools: &mut Operands, cut: Aabb) {
        let is_end = |face: &Face, way| face.is_outer && way == Orientation::Opposed;
        for (i, j) in self.touching(tools, &cut) {
            let longer = self.moved_out(tools[i].0, tools[j].0, LONGER_INTO_EACH_OTHER, is_end);
            self.changes.add(&mut tools[i].1, longer);
        }
    }

    /// Makes the holes in operands of an intersection longer where they end flush with other operands.
    pub(crate) fn longer_holes(&mut self, operands: &mut Operands) {
        let is_hole = |face: &Face, way| !face.is_outer && way == Orientation::Opposed;
        for (i, j) in self.touching(operands, &Aabb::ALL) {
            for (of, other) in [(i, j), (j, i)] {
                let longer = self.moved_out(operands[of].0, operands[other].0, LONGER, is_hole);
                self.changes.add(&mut operands[of].1, longer);
            }
        }
    }

    /// The pairs of operands, by position, whose boxes touch each other and the box `seen`.
    fn touching(&self, operands: &Operands, seen: &Aabb) -> Vec<(usize, usize)> {
        if !self.budget.spend(Limit::OperandsFlush, operands.len()) {
            return Vec::new();
        }
        let boxes: Vec<_> = operands.iter().map(|o| self.box_of(o.0)).collect();
        let pairs = (0..boxes.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let touch = |(i, j): &(usize, usize)| {
            boxes[*i].touches(&boxes[*j]) && boxes[*i].touches(seen) && boxes[*j].touches(seen)
        };
        pairs.filter(touch).collect()
    }

    /// The number of the change that moves flat faces of a node out, by a number of hairs: those that are in one place
    /// with a face of `other`, and for which `is_meant` holds. `None` if there are none.
    fn moved_out(
        &mut self,
        node: NodeId,
        other: NodeId,
        hairs: f64,
        is_meant: impl Fn(&Face, Orientation) -> bool,
    ) -> Option<u32> {
        let contacts = self.contacts(node, other);
        let plane = |Contact {
                         orientation,
                         faces: [face, _],
                     }: &Contact| {
            Some((
                face.plane().filter(|_| is_meant(face, *orientation))?,
                hairs * self.hair,
            ))
        };
        let planes = contacts.iter().filter_map(plane).collect();
        self.changes.of_planes(planes)
    }
}
