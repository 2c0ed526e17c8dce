//! What fills something and has its form: stones in holes, wine in a glass. Faces of two solids are in one
//! place there; the filling is made a hair larger, so that its own is where nobody sees it.

use super::extend::Stand;
use crate::geometry::Matrix;
use crate::scene::{Geometry, Node, NodeId};
use crate::solids::shapes::facts::Facts as _;
use crate::solids::shapes::offset::sides_within;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::{Interner, Occurrence};
use std::collections::HashSet;

/// So many nodes of a solid are looked at.
const PATIENCE: usize = 64;

/// A shape that a solid is made of.
struct Side {
    place: Occurrence,
    shape: u32,
    /// Whether the solid is inside of it where it has its face.
    inside: bool,
}

impl Model<'_> {
    /// Whether a solid fills a hole that others have in its form: it is then made a hair larger, into what
    /// is around the hole, so that the face that it has in one place with theirs is theirs.
    pub fn plug(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let place = self.solids.place(node);
        self.larger(node, others, |sets, other| {
            sets.taken(other).contains(&place)
        })
    }

    /// Whether a solid is made of something that others are made of, too, so that it has faces in one place
    /// with them; it is then made a hair larger.
    pub fn twin(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let place = self.solids.place(node);
        let parts: HashSet<Occurrence> = self.solids.parts(place).into_iter().collect();
        self.larger(node, others, |sets, other| {
            sets.parts(other).iter().any(|p| parts.contains(p))
        })
    }

    /// Makes a solid a hair larger if it can be and lies within reach of others that are meant.
    fn larger(
        &mut self,
        node: NodeId,
        others: &[NodeId],
        mut is_meant: impl FnMut(&mut Interner, Occurrence) -> bool,
    ) -> Stand {
        let mut stand = Stand::default();
        // Well within what is a hair smaller.
        let by = 2.0 * self.hair;
        if !(by > 0.0 && self.has_offset(node, by)) {
            return stand;
        }
        let own = self.box_of(node);
        for &other in others {
            let place = self.solids.place(other);
            if self.box_of(other).overlaps(&own) && is_meant(&mut self.solids, place) {
                stand.held.push(other);
            }
        }
        if !stand.held.is_empty() {
            stand.flush = Some(self.changes.number(Change::Offset(by)));
        }
        stand
    }

    /// Of two solids of one medium that lie on the two sides of one shape: which of them is inside of it, and
    /// the change that makes it a hair larger there. The face between them is then in neither's way.
    pub fn neighbours(&mut self, a: NodeId, b: NodeId) -> Option<(NodeId, u32)> {
        let by = 2.0 * self.hair;
        if !(by > 0.0 && self.box_of(a).overlaps(&self.box_of(b))) {
            return None;
        }
        let [of_a, of_b] = [a, b].map(|node| self.sides(node));
        let (own, other) = of_a.iter().find_map(|own| {
            let other = of_b.iter().find(|o| o.place == own.place)?;
            (own.inside != other.inside).then_some((own, other))
        })?;
        let (node, side) = if own.inside { (a, own) } else { (b, other) };
        let geometry = &self.scene.shapes[side.shape as usize].geometry;
        geometry.offset(by)?;
        Some((node, self.changes.of_one(by, geometry)))
    }

    /// The shapes that a solid is made of, as far as patience goes.
    fn sides(&mut self, node: NodeId) -> Vec<Side> {
        let mut todo = vec![(node, Matrix::IDENTITY, true)];
        let mut sides = Vec::new();
        let mut at = 0;
        while at < todo.len() && todo.len() < PATIENCE {
            let (node, m, inside) = todo[at];
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => sides.push(Side {
                    place: self.solids.placed(node, &m),
                    shape,
                    inside,
                }),
                Node::Transform { child, matrix } => {
                    let m = m.after(&self.scene.matrices[matrix as usize]);
                    todo.push((child, m, inside));
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => {
                    todo.push((child, m, inside));
                }
                Node::Complement(a) => todo.push((a, m, !inside)),
                Node::Union(a, b) | Node::Intersection(a, b) => {
                    todo.extend([(a, m, inside), (b, m, inside)]);
                }
                Node::Difference(a, b) => todo.extend([(a, m, inside), (b, m, !inside)]),
            }
            at += 1;
        }
        sides
    }

    /// Whether a surface of revolution has faces in one place with others on its axis, into which it is
    /// then made to reach: what a glass is filled with.
    pub fn filling(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        let mut stand = Stand::default();
        let scene = self.scene;
        // What is filled, and what fills it, are profiles: others are put a hair apart like all solids.
        let profile = |shape: Option<u32>| match &scene.shapes[shape? as usize].geometry {
            Geometry::Revolution { profile, .. } => Some(&profile[..]),
            _ => None,
        };
        let place = self.solids.place(node);
        let Some(own) = profile(self.solids.shape(place)) else {
            return stand;
        };
        let mut all = Vec::new();
        for &other in others {
            if !self.box_of(other).overlaps(&self.box_of(node)) {
                continue;
            }
            let mut walls = Vec::new();
            for part in self.solids.parts(self.solids.place(other)) {
                if part.is_placed_as(place) {
                    walls.extend(profile(self.solids.shape(part)));
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
