//! What lies against an earlier part of a union in the place of a later one: the later one is not seen there,
//! and has no face behind that of the earlier one.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::between::Meetings;
use super::build::Builder;
use super::changes::Change;
use super::state::State;
use super::tree::{Object, Operation};
use super::union::{Members, Reaching};
use crate::geometry::Aabb;
use crate::scene::NodeId;

/// Neighbours of parts of a union, which are groups by position.
pub(super) struct Neighbours {
    /// By two groups, the earlier one first, those of their solids that lie against each other.
    contacts: BTreeMap<(usize, usize), Vec<(NodeId, NodeId)>>,
    /// For each group the opaque ones before it that it touches.
    walls: HashMap<usize, Vec<usize>>,
    /// The pairs of groups that touch, with the earlier one first, of which the later one is a wall.
    walled: HashSet<(usize, usize)>,
}

impl Neighbours {
    /// Of groups, given the pairs of those that touch.
    pub fn of(groups: &[Members], pairs: &[(usize, usize)], reaching: &Reaching) -> Neighbours {
        let owners: HashMap<NodeId, usize> = (groups.iter().enumerate())
            .flat_map(|(i, group)| group.nodes.iter().map(move |(node, _)| (*node, i)))
            .collect();
        let mut contacts: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for &(a, b) in &reaching.contacts {
            if let (Some(&i), Some(&j)) = (owners.get(&a), owners.get(&b)) {
                contacts.entry((i, j)).or_default().push((a, b));
            }
        }
        for pairs in contacts.values_mut() {
            pairs.sort_unstable();
            pairs.dedup();
        }
        let mut walls: HashMap<_, Vec<_>> = HashMap::new();
        let mut walled = HashSet::new();
        for &(earlier, later) in pairs {
            if !groups[earlier].transparent {
                walls.entry(later).or_default().push(earlier);
            }
            if !groups[later].transparent {
                walled.insert((earlier, later));
            }
        }
        Neighbours {
            contacts,
            walls,
            walled,
        }
    }
}

impl<'a> Builder<'a> {
    /// What is not a group's although it would be behind the faces of those within which it ends: opaque
    /// groups there, and the places where those lie against each other, or against what is opaque.
    pub(super) fn owned_by_neighbours(
        &mut self,
        groups: &[Members],
        meetings: &Meetings,
        later: usize,
        reaching: &Reaching,
    ) -> Vec<Object<'a>> {
        let around: Vec<usize> = meetings.around(later).collect();
        let neighbours = &meetings.neighbours;
        let walls = neighbours.walls.get(&later).map_or(&[][..], |w| &w[..]);
        let hull = |group: &Members| group.boxes.iter().fold(Aabb::EMPTY, |h, b| h.hull(b));
        let own = hull(&groups[later]);
        let mut pieces = Vec::new();
        // Those that are seen into were taken away as a whole.
        let is_taken = |wall: usize| {
            let mut met = meetings.of_later(later).iter();
            groups[wall].seen_into && met.any(|m| m.earlier == wall && !m.apart)
        };
        for &wall in walls.iter().filter(|w| !is_taken(**w)) {
            let touched = around
                .iter()
                .filter(|e| neighbours.walled.contains(&(**e, wall)));
            let place = touched
                .fold(Aabb::EMPTY, |h, e| h.hull(&hull(&groups[*e])))
                .intersection(&own);
            let group = &groups[wall];
            let near = group
                .nodes
                .iter()
                .zip(&group.boxes)
                .filter(|(_, b)| b.overlaps(&place));
            let members: Vec<_> = near
                .map(|((node, _), _)| (*node, State::GEOMETRY.flush(reaching.of(*node))))
                .collect();
            pieces.extend(self.pieces(&members));
        }
        for &i in &around {
            for &j in around.iter().chain(walls) {
                let contacts = neighbours.contacts.get(&(i.min(j), i.max(j)));
                for &(a, b) in contacts
                    .filter(|_| i < j || walls.contains(&j))
                    .into_iter()
                    .flatten()
                {
                    if self.box_of(a).touches(&own) && self.box_of(b).touches(&own) {
                        pieces.extend(self.contact(a, b));
                    }
                }
            }
        }
        pieces
    }

    /// The layers along the faces where solids of one group lie against each other: what is a hair smaller than
    /// each of them leaves these out.
    pub(super) fn joints(&mut self, neighbours: &Neighbours, group: usize) -> Vec<Object<'a>> {
        let contacts = neighbours.contacts.get(&(group, group));
        let pairs = contacts.into_iter().flatten();
        pairs.filter_map(|(a, b)| self.contact(*a, *b)).collect()
    }

    /// The layer along the faces that two solids have in one place: farther to both sides than the faces that
    /// are a hair behind theirs.
    fn contact(&mut self, a: NodeId, b: NodeId) -> Option<Object<'a>> {
        let by = 2.0 * self.hair;
        if !(self.has_offset(a, by) && self.has_offset(b, by)) {
            return None;
        }
        let larger = self.changes.number(Change::Offset(by));
        let both = [a, b].map(|node| (node, State::GEOMETRY.flush(Some(larger))));
        Some(Object::of(Operation::Intersection, self.pieces(&both)))
    }
}
