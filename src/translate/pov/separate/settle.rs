//! The remedies for faces in one place among the solids of a union, one after the other.

use std::collections::{BTreeSet, HashMap, HashSet};

use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::contacts::{Contact, Orientation};
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::State;

/// The operands of an operation, each with the decisions made on the way down to it.
pub(crate) type Operands = Vec<(NodeId, State)>;

/// The optics and index of a solid, if it is of one medium, and whether faces inside of it can be seen.
pub(crate) type Kind = (Option<(u32, u32)>, bool);

/// The solids that are made two hairs larger where they clip later ones.
#[derive(Default)]
pub(crate) struct SolidExtensions {
    /// The number of the change of each such solid.
    by: HashMap<NodeId, u32>,
    /// The pairs of a solid and a later one that it is made larger into.
    into: HashSet<(NodeId, NodeId)>,
    /// The pairs of solids that lie against each other, the earlier one first.
    pub contacts: Vec<(NodeId, NodeId)>,
}

impl SolidExtensions {
    /// Whether any solid of a group is made larger.
    pub(crate) fn any_of(&self, group: &[(NodeId, State)]) -> bool {
        group.iter().any(|(node, _)| self.by.contains_key(node))
    }

    /// The number of the change of a solid where it clips later ones; `None` if it has none.
    pub(crate) fn of(&self, node: NodeId) -> Option<u32> {
        self.by.get(&node).copied()
    }

    /// Whether any solid of a group is made larger into a solid of a later group.
    pub(crate) fn has(&self, earlier: &[(NodeId, State)], later: &[(NodeId, State)]) -> bool {
        let mut earlier = earlier.iter().map(|n| n.0);
        let later = || later.iter().map(|n| n.0);
        !self.into.is_empty() && earlier.any(|a| later().any(|b| self.into.contains(&(a, b))))
    }
}

impl<'a> Model<'a> {
    /// Applies the remedies to the solids of a union. Returns the kind of each solid, and the solids that are made
    /// larger where they clip later ones.
    pub(crate) fn settled(&mut self, solids: &mut Operands) -> (Vec<Kind>, SolidExtensions) {
        let mut kinds: Vec<Kind> = (solids.iter())
            .map(|&(node, state)| (self.medium(node, state), self.is_seen_into(node, state)))
            .collect();
        if !self.budget.spend(Limit::SolidsSettled, solids.len()) {
            return (kinds, SolidExtensions::default());
        }
        for i in self.opened(solids, &kinds) {
            kinds[i].1 = true;
        }
        let reaching = self.settle(solids, &kinds);
        (kinds, reaching)
    }

    /// The positions of opaque solids that are seen into all the same. Such a solid overlaps or lies against an earlier
    /// solid that is seen into and has the common face, and faces of other solids could be seen in it. Solids of the
    /// same medium that touch it are one with it, and included.
    fn opened(&self, solids: &Operands, kinds: &[Kind]) -> BTreeSet<usize> {
        let boxes: Vec<Aabb> = solids.iter().map(|(node, _)| self.box_of(*node)).collect();
        // Boxes may touch though the solids do not: a ball on a floor has no more than a point in common with it.
        let touch = |i: usize, j: usize| {
            let common = boxes[i].intersection(&boxes[j]);
            let overlap = (0..3).all(|axis| common.max[axis] - common.min[axis] > self.hair);
            boxes[i].touches(&boxes[j])
                && (overlap || !self.contacts(solids[i].0, solids[j].0).is_empty())
        };
        let mut opened = BTreeSet::new();
        for i in (0..solids.len()).filter(|i| !kinds[*i].1) {
            if !(0..i).any(|j| kinds[j].1 && touch(i, j)) {
                continue;
            }
            let alike = |j: &usize| kinds[i].0.is_some() && kinds[i].0 == kinds[*j].0;
            let others = (0..solids.len()).filter(|j| *j != i && touch(i, *j));
            if others.clone().any(|j| j > i || alike(&j)) {
                opened.insert(i);
                opened.extend(others.filter(alike));
            }
        }
        opened
    }

    /// Finds which solids have faces in one place. Later ones are clipped by an earlier one that is made two hairs
    /// larger, and solids of one medium that lie against each other are made to overlap.
    fn settle(&mut self, solids: &mut Operands, kinds: &[Kind]) -> SolidExtensions {
        let mut reaching = SolidExtensions::default();
        let boxes: Vec<Aabb> = solids.iter().map(|s| self.box_of(s.0)).collect();
        let by = 2.0 * self.hair;
        for j in 0..solids.len() {
            let mut grows = false;
            let mut into: Vec<(Plane, f64)> = Vec::new();
            for i in 0..j {
                // Nobody sees between two opaque solids.
                if !(kinds[i].1 || kinds[j].1) || !boxes[i].touches(&boxes[j]) {
                    continue;
                }
                let [a, b] = [i, j].map(|k| solids[k].0);
                let found = self.contacts(a, b);
                if found.is_empty() {
                    continue;
                }
                let opposed = found.iter().any(|c| c.orientation == Orientation::Opposed);
                if opposed {
                    reaching.contacts.push((a, b));
                }
                let differs = |k: usize| kinds[i].0.is_none() || kinds[i].0 != kinds[k].0;
                // A solid of another medium that comes between the two in the order may keep them from being joined.
                if !differs(j) && !(i + 1..j).any(differs) {
                    grows |= opposed;
                } else if let (false, Some(planes)) = (kinds[i].1, standing(&found)) {
                    into.extend(planes.into_iter().map(|plane| (plane, by)));
                } else if self.has_offset(a, by) {
                    let larger = self.changes.number(Change::Offset(by));
                    reaching.by.insert(a, larger);
                    reaching.into.insert((a, b));
                    grows |= opposed && !differs(j);
                } else {
                    self.faces_in_one_place(self.ids[b as usize]);
                }
            }
            let into = self.changes.of_planes(into);
            self.changes.add(&mut solids[j].1, into);
            if grows && self.has_offset(solids[j].0, self.hair) {
                let larger = self.changes.number(Change::Offset(self.hair));
                self.changes.add(&mut solids[j].1, Some(larger));
            }
        }
        reaching
    }

    /// The number of the change of a solid that `others` are clipped by: two hairs larger, so that they lose the faces
    /// that they have in one place with it. `None` if there are no such faces, or it cannot be made larger.
    pub(crate) fn reach(&mut self, node: NodeId, others: &[NodeId]) -> Option<u32> {
        let by = 2.0 * self.hair;
        let touches = others.iter().any(|o| !self.contacts(node, *o).is_empty());
        (touches && self.has_offset(node, by)).then(|| self.changes.number(Change::Offset(by)))
    }
}

/// The planes of the faces with which a later solid stands on an earlier one. The later solid may be made longer there,
/// into the earlier one, since nobody sees into that. `None` if the two touch in any other faces.
fn standing(found: &[Contact]) -> Option<Vec<Plane>> {
    let plane = |Contact {
                     orientation,
                     faces: [_, face],
                 }: &Contact| {
        let stands = *orientation == Orientation::Opposed && face.is_outer;
        face.plane().filter(|_| stands)
    };
    found.iter().map(plane).collect()
}
