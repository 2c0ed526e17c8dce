//! The remedies for faces in one place among the solids of a union, one after the other.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::extend::Stand;
use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::state::State;

/// Unions of more solids are not searched for those that stand on each other.
const MANY: usize = 512;

/// Operands of an operation.
pub type Operands = Vec<(NodeId, State)>;

/// The optics and index of a solid, if it is of one medium, and whether faces inside of it can be seen.
pub type Kind = (Option<(u32, u32)>, bool);

/// Which solids are longer where later ones are clipped by them.
#[derive(Default)]
pub struct Reaching {
    /// The numbers of their changes.
    by: HashMap<NodeId, u32>,
    /// Each with those that it is made longer into.
    into: HashSet<(NodeId, NodeId)>,
    /// Solids that have faces in one place, the earlier of the two first.
    pub contacts: Vec<(NodeId, NodeId)>,
}

impl Reaching {
    /// Whether any of a group is made longer.
    pub fn any_of(&self, group: &[(NodeId, State)]) -> bool {
        group.iter().any(|(node, _)| self.by.contains_key(node))
    }

    /// The change of a solid where later ones are clipped by it.
    pub fn of(&self, node: NodeId) -> Option<u32> {
        self.by.get(&node).copied()
    }

    /// Whether any of a group is made longer into any of a later one.
    pub fn has(&self, earlier: &[(NodeId, State)], later: &[(NodeId, State)]) -> bool {
        let mut earlier = earlier.iter().map(|n| n.0);
        let later = || later.iter().map(|n| n.0);
        !self.into.is_empty() && earlier.any(|a| later().any(|b| self.into.contains(&(a, b))))
    }
}

impl<'a> Model<'a> {
    /// What solids are made of, and how they are settled.
    pub fn settled(&mut self, solids: &mut Operands) -> (Vec<Kind>, Reaching) {
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

    /// The change of a solid that others are clipped by, so that they lose the faces that they have in one
    /// place with it: where it stands on them, fills them, or ends as they do.
    pub fn reach(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let mut stand = self.stand(node, others, 2.0 * self.hair);
        let filling = self.filling(node, others);
        stand.held.extend(filling.held);
        stand.flush = match (filling.flush, stand.flush) {
            (Some(a), Some(b)) => Some(self.changes.number(Change::Both(a, b))),
            (a, b) => a.or(b),
        };
        let twin = self.twin(node, others);
        stand.held.extend(twin.held);
        stand.flush = match twin.flush {
            Some(twin) => Some(self.changes.both(stand.flush, twin)),
            None => stand.flush,
        };
        stand
    }
}
