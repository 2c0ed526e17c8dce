//! The operands of nested operations of one kind, in one list, without operands of which nothing is seen.

use std::collections::{HashMap, HashSet};

use super::descend::End;
use super::descend::Stop;
use crate::scene::NodeId;
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::looks::Substance;
use crate::translate::pov::model::state::{Layer, State};

impl<'a> Model<'a> {
    /// The operands of a union and of the unions among them, in order. An operand that lies within earlier ones is left
    /// out.
    pub(crate) fn flat_union(&mut self, roots: &[NodeId], state: State) -> Vec<(NodeId, State)> {
        let mut todo: Vec<_> = roots.iter().rev().map(|&node| (node, state)).collect();
        let mut out = Vec::new();
        let mut surfaces = HashSet::new();
        let mut solids = HashSet::new();
        while let Some((node, state)) = todo.pop() {
            let descent = self.descend(node, state, Stop::AmongParts);
            match descent.end {
                End::Union(a, b, state) if descent.modifiers.is_empty() => {
                    todo.extend([(b, state), (a, state)]);
                }
                End::Nothing => {}
                _ => {
                    let facts = self.materials[node as usize];
                    let surface = facts.has_surface && state.layer != Layer::Solid;
                    let place = self.solids.place(node);
                    let is_new = if surface {
                        surfaces.insert((place, state.layer))
                    } else {
                        let known = self.solids.is_within(place, &solids);
                        self.solids.add(place, &mut solids);
                        !known
                    };
                    if is_new {
                        out.push((node, state));
                    }
                }
            }
        }
        let out = self.without_repeats(out);
        self.look_for_shared_faces(&out);
        out
    }

    /// Reports members with different looks that are made of the same solid, so that they have faces in one place.
    fn look_for_shared_faces(&mut self, members: &[(NodeId, State)]) {
        if !self.budget.spend(Limit::PartsShared, members.len()) {
            return;
        }
        let mut seen: HashMap<_, (Option<Substance>, NodeId, bool)> = HashMap::new();
        for &(node, state) in members {
            if self.materials[node as usize].has_surface {
                continue;
            }
            let substance = self.substance(node, state);
            let place = self.solids.place(node);
            let parts = self.solids.parts(place);
            let differing: HashSet<_> = (parts.iter())
                .filter_map(|p| seen.get(p))
                .filter(|known| known.0.is_none() || known.0 != substance)
                .map(|&(_, owner, clear)| (owner, clear))
                .collect();
            // Only opaque members are reported: faces within a member that is seen into are put a hair apart
            // (`separate::media`).
            if differing.iter().any(|(_, clear)| !clear) {
                self.faces_in_one_place(self.ids[node as usize]);
            }
            let clear = self.cut_open || self.is_transparent(node, state.look);
            for part in parts {
                seen.entry(part).or_insert((substance, node, clear));
            }
        }
    }

    /// Leaves out members that lie within later members of the same look and medium.
    fn without_repeats(&mut self, members: Vec<(NodeId, State)>) -> Vec<(NodeId, State)> {
        let mut later: HashMap<_, HashSet<_>> = HashMap::new();
        let mut out = Vec::with_capacity(members.len());
        for (node, state) in members.into_iter().rev() {
            let substance = self.substance(node, state);
            if let Some(substance) = substance
                && !self.materials[node as usize].has_surface
            {
                let place = self.solids.place(node);
                let set = later.entry((substance, state.layer)).or_default();
                if self.solids.is_within(place, set) {
                    continue;
                }
                self.solids.add(place, set);
            }
            out.push((node, state));
        }
        out.reverse();
        out
    }

    /// Leaves out operands of an intersection that contain another operand: they take nothing away, and may have faces
    /// in one place with it. By right these faces are those of the first of the two. So an operand that contains a
    /// later one stays, and is reported, unless both are of one look and medium.
    pub(crate) fn without_wider(
        &mut self,
        mut members: Vec<(NodeId, State)>,
    ) -> Vec<(NodeId, State)> {
        if !self.budget.spend(Limit::OperandsHeld, members.len())
            || members
                .iter()
                .any(|m| self.materials[m.0 as usize].has_surface)
        {
            return members;
        }
        let mut i = 0;
        while i < members.len() {
            let (node, state) = members[i];
            let own = self.substance(node, state);
            let (mut held, mut doubtful) = (false, false);
            for (j, &(other, state)) in members.iter().enumerate() {
                if j != i && self.is_within(other, &[node]) {
                    let alike = own.is_some() && own == self.substance(other, state);
                    held |= alike || j < i;
                    doubtful |= !alike && j > i;
                }
            }
            if held {
                members.remove(i);
                continue;
            }
            if doubtful {
                self.faces_in_one_place(self.ids[node as usize]);
            }
            i += 1;
        }
        members
    }

    /// Whether a node's solid certainly lies within the union of the solids of `others`.
    pub(crate) fn is_within(&mut self, node: NodeId, others: &[NodeId]) -> bool {
        let mut set = HashSet::new();
        for other in others {
            let place = self.solids.place(*other);
            self.solids.add(place, &mut set);
        }
        let place = self.solids.place(node);
        self.solids.is_within(place, &set)
    }

    pub(crate) fn flat_intersection(
        &mut self,
        a: NodeId,
        b: NodeId,
        state: State,
    ) -> Vec<(NodeId, State)> {
        let mut todo = vec![(b, state), (a, state)];
        let mut out = Vec::new();
        while let Some((node, state)) = todo.pop() {
            match self.descend(node, state, Stop::AtShared).bare() {
                Some(End::Intersection(a, b, state)) => todo.extend([(b, state), (a, state)]),
                _ => out.push((node, state)),
            }
        }
        out
    }
}
