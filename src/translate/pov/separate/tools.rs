//! Holes that end flush with what they are in: which of the two faces in one place POV-Ray takes for the nearer one is up
//! to rounding. The tool of such a hole is written longer than it is. That changes nothing: what is added lies outside
//! of the thing that is cut.

use super::contacts::{Contact, Face, contacts};
use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::State;

/// Hairs that tools are made longer by: more than faces are moved by for other reasons.
const LONGER: f64 = 32.0;
/// Hairs that tools are made longer by into each other, which may be seen beside the other one.
const LONGER_INTO_EACH_OTHER: f64 = 2.0;
/// Operands of larger operations are not compared with each other.
const MAX_OPERANDS: usize = 256;

impl Model<'_> {
    /// The number of the change of a tool that makes it longer where it ends flush with what is cut.
    pub(crate) fn longer_tool(&mut self, tool: NodeId, base: NodeId) -> Option<u32> {
        let (tool, base) = (self.faces_of(tool), self.faces_of(base));
        let by = LONGER * self.hair;
        let planes = contacts(&tool, &base).filter_map(|(contact, [face, _])| {
            let is_flush = face.is_outer && contact == Contact::Alike;
            Some((face.plane().filter(|_| is_flush)?, by))
        });
        let planes = planes.collect();
        self.moved_out(planes)
    }

    /// Makes tools longer that end where others begin: they would leave a skin there.
    pub(crate) fn overlap_tools(&mut self, tools: &mut [(NodeId, State)], cut: Aabb) {
        if tools.len() > MAX_OPERANDS {
            return self.budget_is_spent();
        }
        let faces: Vec<_> = tools.iter().map(|t| self.faces_of(t.0)).collect();
        for (i, j) in self.touching(tools, &cut) {
            let by = LONGER_INTO_EACH_OTHER * self.hair;
            let planes = contacts(&faces[i], &faces[j]).filter_map(|(contact, [face, _])| {
                let is_end = face.is_outer && contact == Contact::Opposed;
                Some((face.plane().filter(|_| is_end)?, by))
            });
            let planes = planes.collect();
            if let Some(change) = self.moved_out(planes) {
                let state = &mut tools[i].1;
                state.flush = Some(self.changes.both(state.flush, change));
            }
        }
    }

    /// Makes the holes in operands of an intersection longer where they end flush with other operands.
    pub(crate) fn longer_holes(&mut self, operands: &mut [(NodeId, State)]) {
        if operands.len() > MAX_OPERANDS {
            return self.budget_is_spent();
        }
        let faces: Vec<_> = operands.iter().map(|o| self.faces_of(o.0)).collect();
        for (i, j) in self.touching(operands, &Aabb::ALL) {
            for (k, other) in [(i, j), (j, i)] {
                let planes = self.ends_of_holes(&faces[k], &faces[other]);
                if let Some(change) = self.moved_out(planes) {
                    let state = &mut operands[k].1;
                    state.flush = Some(self.changes.both(state.flush, change));
                }
            }
        }
    }

    fn ends_of_holes(&self, own: &[Face], other: &[Face]) -> Vec<(Plane, f64)> {
        let by = LONGER * self.hair;
        let planes = contacts(own, other).filter_map(|(contact, [face, _])| {
            let is_hole = !face.is_outer && contact == Contact::Opposed;
            Some((face.plane().filter(|_| is_hole)?, by))
        });
        planes.collect()
    }

    /// The pairs of operands whose boxes touch, where that can be seen.
    fn touching(&self, operands: &[(NodeId, State)], seen: &Aabb) -> Vec<(usize, usize)> {
        let boxes: Vec<_> = operands.iter().map(|o| self.box_of(o.0)).collect();
        let pairs = (0..boxes.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let touch = |(i, j): &(usize, usize)| {
            boxes[*i].touches(&boxes[*j]) && boxes[*i].touches(seen) && boxes[*j].touches(seen)
        };
        pairs.filter(touch).collect()
    }

    fn moved_out(&mut self, planes: Vec<(Plane, f64)>) -> Option<u32> {
        (!planes.is_empty()).then(|| self.changes.of_planes(planes))
    }
}
