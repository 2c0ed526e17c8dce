//! Unions. Opaque ones are plain: what lies inside is never seen. In transparent ones the faces
//! inside have to go, except where two media meet; there the first medium owns the overlap.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::aspects::DEFAULT;
use super::build::{Builder, inside_medium};
use super::grouping::{self, meet_each_other};
use super::standing::Stand;
use super::state::{Layer, Look, Medium, State};
use super::tree::{Modifier, Object, Operation};
use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::fidelity::Fidelity;

/// Unions of more solids are not searched for those that stand on each other.
const MANY: usize = 512;

/// Operands of an operation.
type Operands = Vec<(NodeId, State)>;

/// The optics and index of a solid, if it is of one medium, and whether faces inside of it can be seen.
pub(super) type Kind = (Option<(u32, u32)>, bool);

/// Operands of a union that are one medium.
pub(super) struct Members {
    /// Optics and index; `None` where the one operand is of several media by itself.
    pub medium: Option<(u32, u32)>,
    pub nodes: Operands,
    pub boxes: Vec<Aabb>,
    pub seen_into: bool,
    pub transparent: bool,
    /// A later medium begins where it ends: POV-Ray has to know its index, even if that is 1.
    pub bounds_media: bool,
}

impl Members {
    /// The operation that joins them.
    pub fn kind(&self) -> Operation {
        match self.seen_into && self.nodes.len() > 1 && meet_each_other(&self.boxes) {
            true => Operation::Merge,
            false => Operation::Union,
        }
    }
}

/// Which solids are longer where later ones are clipped by them.
#[derive(Default)]
pub(super) struct Reaching {
    /// The numbers of their changes.
    by: HashMap<NodeId, u32>,
    /// Each with those that it is made longer into.
    into: HashSet<(NodeId, NodeId)>,
    /// Solids that have faces in one place, the earlier of the two first.
    pub contacts: Vec<(NodeId, NodeId)>,
}

impl Reaching {
    /// Whether any of a group is made longer.
    pub fn any_of(&self, group: &Members) -> bool {
        group
            .nodes
            .iter()
            .any(|(node, _)| self.by.contains_key(node))
    }

    /// The change of a solid where later ones are clipped by it.
    pub fn of(&self, node: NodeId) -> Option<u32> {
        self.by.get(&node).copied()
    }

    /// Whether any of a group is made longer into any of a later one.
    pub fn has(&self, earlier: &Members, later: &Members) -> bool {
        let mut earlier = earlier.nodes.iter().map(|n| n.0);
        let later = || later.nodes.iter().map(|n| n.0);
        !self.into.is_empty() && earlier.any(|a| later().any(|b| self.into.contains(&(a, b))))
    }
}

impl<'a> Builder<'a> {
    /// The union of operands that are no unions themselves.
    pub(super) fn union(&mut self, members: Vec<(NodeId, State)>) -> Option<Object<'a>> {
        let seen_into = |&(node, state): &(NodeId, State)| {
            self.facts[node as usize].has_solid
                && state.layer != Layer::Surface
                && self.is_seen_into(node, state)
        };
        if !members.iter().any(seen_into) {
            let mut members = members;
            let kinds = vec![(None, false); members.len()];
            self.level(&mut members, &kinds);
            let pieces = self.pieces(&members);
            return non_empty(Operation::Union, pieces);
        }
        let (mut solids, mut surfaces) = self.by_part(&members);
        let (kinds, mut reaching) = self.settled(&mut solids);
        let level = self.level_all(&mut solids, &mut surfaces, &kinds);
        reaching.contacts.extend(level);
        let mut groups = self.by_medium(&solids, &kinds);
        let meetings = self.meetings(&mut groups, &reaching);
        let mut pieces = Vec::new();
        for i in 0..groups.len() {
            let mut clips = Vec::new();
            for meeting in meetings.of_later(i) {
                let earlier = &groups[meeting.earlier];
                clips.extend(self.outside_of(earlier, &reaching));
                if !meeting.apart && earlier.transparent {
                    self.overlap(earlier, &groups[i]);
                }
            }
            let mut hidden = self.skin(&groups, &meetings, i, &reaching);
            let (outer, rest) = self.outer_sides(&groups, &meetings, i, &reaching);
            hidden.extend(outer.into_iter().map(|p| p.with(clips.clone())));
            clips.extend(rest);
            pieces.extend(self.one_medium_union(&mut groups[i], clips, hidden));
        }
        for surface in &mut surfaces {
            let plate = self.plate(*surface, &groups);
            surface.1.flush = plate.or(surface.1.flush);
        }
        pieces.extend(self.pieces(&surfaces));
        non_empty(Operation::Union, pieces)
    }

    fn level_all(
        &mut self,
        solids: &mut Operands,
        surfaces: &mut Operands,
        kinds: &[Kind],
    ) -> Vec<(NodeId, NodeId)> {
        let mut parts = solids.clone();
        parts.extend(surfaces.iter().copied());
        let mut kinds = kinds.to_vec();
        kinds.resize(parts.len(), (None, false));
        let contacts = self.level(&mut parts, &kinds);
        surfaces.copy_from_slice(&parts[solids.len()..]);
        parts.truncate(solids.len());
        *solids = parts;
        contacts
    }

    /// What solids are made of, and how they are settled.
    fn settled(&mut self, solids: &mut Operands) -> (Vec<Kind>, Reaching) {
        let mut kinds: Vec<Kind> = (solids.iter())
            .map(|&(node, state)| (self.medium(node, state), self.is_seen_into(node, state)))
            .collect();
        if solids.len() > MANY {
            return (kinds, Reaching::default());
        }
        for i in self.opened(solids, &kinds) {
            kinds[i].1 = true;
        }
        let reaching = self.settle(solids, &kinds);
        (kinds, reaching)
    }

    /// The opaque ones among solids that are seen into where earlier ones that light goes through have the
    /// face, since they overlap or lie against them, if there are faces of others to be seen in them; and
    /// those of their medium there, with which they are one.
    fn opened(&self, solids: &Operands, kinds: &[Kind]) -> BTreeSet<usize> {
        let boxes: Vec<Aabb> = solids.iter().map(|(node, _)| self.box_of(*node)).collect();
        let touch = |i: usize, j: usize| boxes[i].touches(&boxes[j]);
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

    /// Makes solids longer that stand on earlier ones and would show the face between, and gives by
    /// which boxes solids are to be longer where later ones are clipped by them.
    fn settle(&mut self, solids: &mut Operands, kinds: &[Kind]) -> Reaching {
        let mut reaching = Reaching::default();
        let (mut held, mut loose) = (HashSet::new(), Vec::new());
        // What is changed about all of them comes after what is changed among them.
        let whole: Vec<_> = solids.iter_mut().map(|s| s.1.flush.take()).collect();
        for i in 0..solids.len() {
            let node = solids[i].0;
            let (medium, seen) = kinds[i];
            // Between what is opaque nobody sees.
            let counts = |j: &usize| seen || kinds[*j].1;
            let differs = |j: &usize| medium.is_none() || medium != kinds[*j].0;
            // What comes between parts of one medium may keep them from being joined.
            let is_beyond = |j: &usize| differs(j) || (i + 1..*j).any(|k| differs(&k));
            let nodes = |which: &mut dyn Iterator<Item = usize>| -> Vec<NodeId> {
                which.map(|j| solids[j].0).collect()
            };
            let clear = nodes(&mut (0..i).filter(|j| kinds[*j].1));
            let before = nodes(&mut (0..i).filter(counts));
            let after = nodes(&mut (i + 1..solids.len()).filter(counts).filter(is_beyond));
            let alike = nodes(&mut (i + 1..solids.len()).filter(counts).filter(|j| !differs(j)));
            let reach = self.reach(node, &after);
            let contacts = &mut reaching.contacts;
            contacts.extend(reach.held.iter().map(|other| (node, *other)));
            let mut note = |stand: Stand| {
                let pair = |other: NodeId| (node.min(other), node.max(other));
                held.extend(stand.held.into_iter().map(pair));
                loose.extend(stand.loose.into_iter().map(pair));
                stand.flush
            };
            reaching
                .into
                .extend(reach.held.iter().map(|other| (node, *other)));
            if let Some(flush) = note(reach) {
                reaching.by.insert(node, flush);
            }
            let plug = self.plug(node, &clear);
            contacts.extend(plug.held.iter().map(|other| (*other, node)));
            if plug.flush.is_some() {
                solids[i].1.flush = note(plug);
            }
            if solids[i].1.flush.is_none() {
                let around = [&before[..], &alike].concat();
                let filling = note(self.filling(node, &around));
                let standing = self.standing(node, &before);
                contacts.extend(standing.held.iter().map(|other| (*other, node)));
                solids[i].1.flush = match note(standing) {
                    Some(standing) => Some(self.changes.both(filling, standing)),
                    None => filling,
                };
            }
        }
        for ((node, state), whole) in solids.iter_mut().zip(whole) {
            if let Some(whole) = whole {
                state.flush = Some(self.changes.both(state.flush, whole));
            }
            if self.may_be_laid_out(*node, state.look) {
                let by = 2.0 * self.hair;
                state.flush = state.flush.map(|f| self.changes.small(f, by));
            }
        }
        let joined = self.join_neighbours(solids, kinds);
        reaching.contacts.extend(joined.iter().copied());
        held.extend(joined);
        // One of the two is enough.
        if let Some((_, above)) = loose.iter().find(|pair| !held.contains(pair)) {
            self.faces_in_one_place(self.ids[*above as usize]);
        }
        reaching
    }

    /// Makes of solids of one medium that lie on the two sides of one face one larger; gives the pairs. What each
    /// is made of stands beside it.
    fn join_neighbours(&mut self, solids: &mut Operands, kinds: &[Kind]) -> Vec<(NodeId, NodeId)> {
        let mut joined = Vec::new();
        for i in 0..solids.len() {
            for j in 0..i {
                let (medium, seen) = kinds[i];
                if !seen || medium.is_none() || medium != kinds[j].0 {
                    continue;
                }
                let (a, b) = (solids[j].0, solids[i].0);
                if let Some((inside, change)) = self.neighbours(a, b) {
                    let state = &mut solids[if inside == b { i } else { j }].1;
                    state.flush = state.flush.or(Some(change));
                    joined.push((a.min(b), a.max(b)));
                }
            }
        }
        joined
    }

    /// Solids and surfaces apart: a merge has no place for surfaces.
    fn by_part(&self, members: &[(NodeId, State)]) -> (Operands, Operands) {
        let (mut solids, mut surfaces) = (Vec::new(), Vec::new());
        for &(node, state) in members {
            let f = self.facts[node as usize];
            if f.has_solid && state.layer != Layer::Surface {
                solids.push((node, state.layer(Layer::Solid)));
            }
            if f.has_surface && state.layer != Layer::Solid {
                surfaces.push((node, state.layer(Layer::Surface)));
            }
        }
        (solids, surfaces)
    }

    fn by_medium(&self, solids: &[(NodeId, State)], kinds: &[Kind]) -> Vec<Members> {
        let operands: Vec<_> = solids
            .iter()
            .zip(kinds)
            .map(|(&(node, _), kind)| (kind.0, self.box_of(node)))
            .collect();
        let members = |group: &Vec<usize>| Members {
            medium: group.first().and_then(|i| operands[*i].0),
            nodes: group.iter().map(|i| solids[*i]).collect(),
            boxes: group.iter().map(|i| operands[*i].1).collect(),
            transparent: group.iter().any(|i| {
                let (node, state) = solids[*i];
                self.is_transparent(node, state.look)
            }),
            bounds_media: false,
            seen_into: group.iter().any(|i| kinds[*i].1),
        };
        grouping::in_order(&operands).iter().map(members).collect()
    }

    /// Whether faces inside a node can be seen.
    fn is_seen_into(&self, node: NodeId, state: State) -> bool {
        self.cut_open || self.is_transparent(node, state.look)
    }

    /// The optics and index of a node that is one medium. What an object around the node gives is
    /// the same for all operands and counts as the default.
    fn medium(&self, node: NodeId, state: State) -> Option<(u32, u32)> {
        let f = &self.facts[node as usize];
        let optics = match state.look {
            Look::Above { .. } => Some(DEFAULT),
            Look::Own {
                optics: Some(o), ..
            } => Some(o),
            Look::Own { optics: None, .. } => f.optics.uniform.then_some(f.optics.first),
        };
        let index = match state.medium {
            Medium::Above => Some(DEFAULT),
            Medium::Own => f.index.uniform.then_some(f.index.first),
        };
        optics.zip(index)
    }

    /// Operands of one medium as one object; its inside is one, too. `clips` are what is kept of what
    /// is seen from both sides, `others` the rest of its surface.
    fn one_medium_union(
        &mut self,
        group: &mut Members,
        clips: Vec<Modifier<'a>>,
        others: Vec<Object<'a>>,
    ) -> Option<Object<'a>> {
        let kind = group.kind();
        if kind == Operation::Union && others.is_empty() && !group.bounds_media {
            let pieces = self.pieces(&group.nodes);
            return Some(non_empty(Operation::Union, pieces)?.with(clips));
        }
        let index = group.medium.map_or(DEFAULT, |(_, index)| index);
        for (_, state) in &mut group.nodes {
            *state = inside_medium(*state);
        }
        let pieces = self.pieces(&group.nodes);
        let seen = non_empty(kind, pieces)?.with(clips);
        let all = std::iter::once(seen).chain(others).collect();
        let piece = Object::of(Operation::Union, all);
        let says = index != DEFAULT || group.bounds_media;
        Some(piece.with(says.then(|| self.index(index))))
    }

    /// Keeps of an object what no operand of a group holds.
    fn outside_of(&mut self, group: &Members, reaching: &Reaching) -> Option<Modifier<'a>> {
        let by = non_empty(Operation::Union, self.longer(group, reaching))?;
        Some(Modifier::outside(by))
    }

    /// The solids of a group, longer as they are where later ones are clipped by them.
    pub(super) fn longer(&mut self, group: &Members, reaching: &Reaching) -> Vec<Object<'a>> {
        // What is within something opaque is not seen anyway, but for faces that are in one place with its.
        let members: Vec<_> = (group.nodes.iter())
            .map(|(node, _)| (*node, State::GEOMETRY.flush(reaching.of(*node))))
            .filter(|(_, state)| group.seen_into || state.flush.is_some())
            .collect();
        self.pieces(&members)
    }

    /// The bare solids of a group, changed.
    pub(super) fn bare(
        &mut self,
        group: &Members,
        change: impl Fn(NodeId, State) -> Option<u32>,
    ) -> Vec<Object<'a>> {
        let members: Vec<_> = (group.nodes.iter())
            .map(|&(node, state)| (node, State::GEOMETRY.flush(change(node, state))))
            .collect();
        self.pieces(&members)
    }

    /// Says what two overlapping media cost.
    pub(super) fn overlap(&mut self, earlier: &Members, later: &Members) {
        let index = |g: &Members| g.medium.map(|(_, index)| index);
        // What is opaque, or bends no light by itself, is no medium to POV-Ray.
        if index(later) != Some(DEFAULT) && later.transparent {
            self.media_are_approximate();
        }
        if earlier.medium.is_some() && earlier.medium == later.medium {
            self.report.count(
                "parts of one medium that overlap, with another medium between them",
                Fidelity::approximate("what is seen through the overlap may be another picture"),
                "",
            );
        }
    }
}

pub(super) fn non_empty<'a>(kind: Operation, pieces: Vec<Object<'a>>) -> Option<Object<'a>> {
    (!pieces.is_empty()).then(|| Object::of(kind, pieces))
}
