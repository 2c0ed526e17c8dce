//! Flat surfaces among solids that light goes through.
//!
//! What has no inside is a medium to POV-Ray all the same: a ray that goes through a sheet is in it from
//! then on. And where a sheet lies in a face of a solid, which of the two a ray meets first is up to
//! rounding; by right it is the sheet, from either side. So the sheet is written as a thin plate: one side
//! shows what there is to see, the other lets the ray out again, and the face that it lies in is within. The
//! plate is of the densest medium around, so that no light is totally reflected where it enters.

use super::aspects::DEFAULT;
use super::build::Builder;
use super::changes::Change;
use super::descend::End;
use super::piece::{Body, Look, Modifier, Piece, State};
use super::union::Members;
use crate::scene::{NodeId, Scene};
use crate::solids::shapes::facts::Facts as _;

/// For each node whether any is in it; nothing where no light goes through anything.
pub fn holders(scene: &Scene, clear: bool) -> Vec<bool> {
    let mut holds = vec![false; if clear { scene.nodes.len() } else { 0 }];
    for id in 0..holds.len() {
        holds[id] = match scene.nodes[id] {
            crate::scene::Node::Shape(shape) => {
                scene.shapes[shape as usize].geometry.character().is_flat
            }
            node => {
                let mut children = node.children().into_iter().flatten();
                children.any(|child| holds[child as usize])
            }
        };
    }
    holds
}

impl Builder<'_> {
    /// The change of a surface that makes a plate of it, if light goes through it and what is around it.
    pub(super) fn plate(
        &mut self,
        (node, state): (NodeId, State),
        groups: &[Members],
    ) -> Option<u32> {
        let holds = self.holds_sheets.get(node as usize) == Some(&true);
        if !holds || !self.is_transparent(node, state.look) {
            return None;
        }
        let own = self.box_of(node);
        let mut densest = None;
        for group in groups.iter().filter(|g| g.seen_into) {
            if !group.boxes.iter().any(|b| own.overlaps(b)) {
                continue;
            }
            let index = match group.medium {
                Some((_, index)) => index,
                None => self.densest,
            };
            let known = densest.unwrap_or(DEFAULT);
            densest = Some(self.aspects.denser(known, index));
        }
        let thick = state.flush.and_then(|f| self.changes.plate(f));
        let by = thick.map_or(self.hair / 2.0, |(by, _)| by);
        Some(self.changes.number(Change::Plate(by, densest?)))
    }

    /// Gives a sheet that is written as a plate its two sides and its inside.
    pub(super) fn with_sides(&mut self, mut piece: Piece, end: &End) -> Piece {
        let Body::Shape(shape, Some(change)) = piece.body else {
            return piece;
        };
        let Some((_, index)) = self.changes.plate(change) else {
            return piece;
        };
        let look = piece.modifiers.iter().find_map(|m| match m {
            Modifier::Look(look) => Some(*look),
            _ => None,
        });
        let clear = match (look, end) {
            (Some(look), _) => self.looks.is_transparent(&self.aspects, look),
            (None, End::Shape(_, state)) => state.look == (Look::Above { transparent: true }),
            _ => false,
        };
        match (clear, look) {
            (false, _) => piece,
            // Something around it gives it its look, which both sides would have.
            (true, None) => {
                piece.body = Body::Shape(shape, None);
                piece
            }
            (true, Some(_)) => {
                self.unseen = true;
                let within = (index != DEFAULT).then_some(Modifier::Interior(index));
                piece.with([Modifier::UnseenWithin]).with(within)
            }
        }
    }
}
