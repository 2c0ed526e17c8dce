//! What fills something and has its form: stones in holes, wine in a glass. Faces of two solids are in one
//! place there; the filling is made a hair larger, so that its own is where nobody sees it.

use super::build::Builder;
use super::flush::Change;
use super::offset::sides_within;
use super::standing::Stand;
use crate::scene::{Geometry, NodeId};

impl Builder<'_> {
    /// Whether a solid fills a hole that others have in its form: it is then made a hair larger, into what
    /// is around the hole, so that the face that it has in one place with theirs is theirs.
    pub(super) fn plug(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let mut stand = Stand::default();
        // Well within what is a hair smaller.
        let by = 2.0 * self.hair;
        if !(by > 0.0 && self.has_offset(node, by)) {
            return stand;
        }
        let place = self.sets.place(node);
        for &other in others {
            let whole = self.sets.place(other);
            if self.box_of(other).overlaps(&self.box_of(node))
                && self.sets.taken(whole).contains(&place)
            {
                stand.held.push(other);
            }
        }
        if !stand.held.is_empty() {
            stand.flush = Some(self.changes.number(Change::Offset(by)));
        }
        stand
    }

    /// Whether a surface of revolution has faces in one place with others on its axis, into which it is
    /// then made to reach: what a glass is filled with.
    pub(super) fn filling(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let mut stand = Stand::default();
        let scene = self.scene;
        let profile = |shape: Option<u32>| match &scene.shapes[shape? as usize].geometry {
            Geometry::Revolution { profile, .. } => Some(&profile[..]),
            _ => None,
        };
        let place = self.sets.place(node);
        let Some(own) = profile(self.sets.shape(place)) else {
            return stand;
        };
        let mut all = Vec::new();
        for &other in others {
            if !self.box_of(other).overlaps(&self.box_of(node)) {
                continue;
            }
            let mut walls = Vec::new();
            for part in self.sets.parts(self.sets.place(other)) {
                if part.is_placed_as(place) {
                    walls.extend(profile(self.sets.shape(part)));
                }
            }
            if sides_within(own, &walls).is_some() {
                stand.held.push(other);
                all.extend(walls);
            }
        }
        // Well within what is a hair smaller.
        let by = 2.0 * self.hair;
        stand.flush = sides_within(own, &all).map(|sides| self.changes.of_sides(by, sides));
        stand
    }
}
