//! Unions. A union of opaque parts stays a plain union, since faces inside of it are never seen. In transparent parts
//! the faces inside have to go, except where two media meet; there the first medium owns the overlap.

use crate::scene::NodeId;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::grouping::{self};
use crate::translate::pov::model::state::{Layer, Medium, State};
use crate::translate::pov::model::tables::DEFAULT;
use crate::translate::pov::separate::media::Members;
use crate::translate::pov::separate::settle::{Kind, Operands};
use crate::translate::pov::tree::{Modifier, Object, Operation};

impl<'a> Model<'a> {
    /// The union of operands that are no unions themselves; `None` if there are no operands.
    pub(crate) fn union(&mut self, mut members: Vec<(NodeId, State)>) -> Option<Object<'a>> {
        let seen_into = |&(node, state): &(NodeId, State)| {
            self.materials[node as usize].has_solid
                && state.layer != Layer::Surface
                && self.is_seen_into(node, state)
        };
        if !members.iter().any(seen_into) {
            self.level(&mut members, &[]);
            let pieces = self.refer_all(members);
            return Object::unless_empty(Operation::Union, pieces);
        }
        let (mut parts, surfaces) = self.by_part(&members);
        let (kinds, extensions) = self.settled(&mut parts);
        parts.extend(surfaces);
        self.level(&mut parts, &kinds);
        let (solids, surfaces) = parts.split_at_mut(kinds.len());
        let groups = self.by_medium(solids, &kinds);
        let union = self.meetings(groups, extensions);
        let mut pieces = Vec::new();
        for (i, group) in union.groups.iter().enumerate() {
            let mut clips = Vec::new();
            for meeting in union.of_later(i) {
                let earlier = &union.groups[meeting.earlier];
                clips.extend(self.outside_of(&union, earlier));
                if !meeting.apart && earlier.transparent {
                    self.overlap(earlier, group);
                }
            }
            let mut hidden = self.skin(&union, i);
            let (outer, rest) = self.outer_sides(&union, i);
            hidden.extend(outer.into_iter().map(|p| p.with(clips.clone())));
            clips.extend(rest);
            pieces.extend(self.one_medium_union(group, clips, hidden));
        }
        for surface in surfaces.iter_mut() {
            let plate = self.plate(*surface, &union.groups);
            surface.1.flush = plate.or(surface.1.flush);
        }
        pieces.extend(self.refer_all(surfaces.iter().copied()));
        Object::unless_empty(Operation::Union, pieces)
    }

    /// Splits members into solids and surfaces: a merge has no place for surfaces.
    fn by_part(&self, members: &[(NodeId, State)]) -> (Operands, Operands) {
        let (mut solids, mut surfaces) = (Vec::new(), Vec::new());
        for &(node, state) in members {
            let f = self.materials[node as usize];
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
        let operands = (solids.iter().zip(kinds))
            .map(|(solid, kind)| (kind.0, (*solid, kind.1), self.box_of(solid.0)));
        let is_clear = |(node, state): (NodeId, State)| self.is_transparent(node, state.look);
        let groups = grouping::in_order(operands, self.budget).into_iter();
        groups
            .map(|group| Members {
                medium: group.key,
                seen_into: group.members.iter().any(|(_, seen_into)| *seen_into),
                transparent: group.members.iter().any(|(solid, _)| is_clear(*solid)),
                nodes: group.members.into_iter().map(|(solid, _)| solid).collect(),
                boxes: group.boxes,
                bounds_media: false,
            })
            .collect()
    }

    /// Operands of one medium as one object, whose inside is one, too. `clips` keep the part of its faces that looks
    /// the same from both sides; `others` are the pieces of the remaining faces.
    fn one_medium_union(
        &mut self,
        group: &Members,
        clips: Vec<Modifier<'a>>,
        others: Vec<Object<'a>>,
    ) -> Option<Object<'a>> {
        let kind = group.kind();
        if kind == Operation::Union && others.is_empty() && !group.bounds_media {
            let pieces = self.refer_all(group.nodes.iter().copied());
            return Some(Object::unless_empty(Operation::Union, pieces)?.with(clips));
        }
        let index = group.medium.map_or(DEFAULT, |(_, index)| index);
        let within = |(node, state): &(NodeId, State)| (*node, state.medium(Medium::Above));
        let pieces = self.refer_all(group.nodes.iter().map(within));
        let seen = Object::unless_empty(kind, pieces)?.with(clips);
        let all = std::iter::once(seen).chain(others).collect();
        let piece = Object::of(Operation::Union, all);
        let says = index != DEFAULT || group.bounds_media;
        Some(piece.with(says.then(|| self.index(index))))
    }
}
