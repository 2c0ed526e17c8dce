//! Solids that stand on one another: which of the two faces in one place POV-Ray meets first is up to
//! rounding, and where light goes through one of them that can be seen. One of the two is made longer
//! into the other, so that its face is where nobody sees it.

use super::build::Builder;
use super::flush::HAIR;
use crate::scene::{Aabb, Geometry, NodeId};

/// Solids are made longer by half of this part of their length: far more than POV-Ray's tolerances,
/// and no more than a thin table has room for.
const PART: f64 = 0.125;

/// What is made longer may become so many times as wide: profiles go on as they end.
const WIDER: f64 = 2.0;

impl Builder<'_> {
    /// The number of the box that a solid has to stay within nowhere but where it stands on one of
    /// others, has a flat face there, and has room in it; if it stands on any. Where there is no room
    /// the report says so.
    pub(super) fn standing(&mut self, node: NodeId, others: &[NodeId]) -> Option<u32> {
        let own = self.box_of(node);
        if own.is_empty() || !own.radius().is_finite() {
            return None;
        }
        let mut free = Aabb::ALL;
        for &other in others {
            let room = self.box_of(other);
            for axis in 0..3 {
                for below in [true, false] {
                    let Some(freed) = freed(&own, &room, axis, below) else {
                        continue;
                    };
                    if self.flush(node, freed).is_none() {
                        continue;
                    }
                    let wider = match self.is_flat(node) {
                        true => 1.0,
                        false => WIDER,
                    };
                    let is_first =
                        (free.min[axis], free.max[axis]) == (f64::NEG_INFINITY, f64::INFINITY);
                    if is_first && self.is_flat(other) && holds(&room, &own, axis, wider) {
                        free = free.intersection(&freed);
                    } else {
                        self.faces_in_one_place(self.ids[node as usize]);
                    }
                }
            }
        }
        self.flush(node, free)
    }

    /// Whether a node is a box along the axes, or a half-space.
    fn is_flat(&self, node: NodeId) -> bool {
        self.along_the_axes(node)
            .is_some_and(|g| matches!(g, Geometry::Box { .. } | Geometry::HalfSpace(_)))
    }
}

/// All of space but what is beyond the end of a box, along an axis, where that is the end of another
/// one; it ends on the other side, too, not far away.
fn freed(own: &Aabb, room: &Aabb, axis: usize, below: bool) -> Option<Aabb> {
    let (at, end) = match below {
        true => (own.min[axis], room.max[axis]),
        false => (own.max[axis], room.min[axis]),
    };
    let length = own.max[axis] - own.min[axis];
    let hair = HAIR * at.abs().max(end.abs()).max(length);
    let beside = (0..3).filter(|i| *i != axis);
    let over = |i: usize| own.min[i].max(room.min[i]) < own.max[i].min(room.max[i]);
    if (at - end).abs() > hair || !beside.into_iter().all(over) {
        return None;
    }
    let depth = PART * length.min(room.max[axis] - room.min[axis]);
    let mut out = Aabb::ALL;
    (out.min[axis], out.max[axis]) = match below {
        true => (at, at + depth),
        false => (at - depth, at),
    };
    (depth > 0.0).then_some(out)
}

/// Whether a box reaches beyond another one in both directions beside an axis.
fn holds(room: &Aabb, own: &Aabb, axis: usize, wider: f64) -> bool {
    let centre = own.centre();
    (0..3).filter(|i| *i != axis).all(|i| {
        let half = wider * (own.max[i] - own.min[i]) / 2.0;
        room.min[i] < centre[i] - half && centre[i] + half < room.max[i]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_stand_on_tables() {
        let table = Aabb::new([-5.0, -1.0, -5.0], [5.0, 0.0, 5.0]);
        let cube = Aabb::new([-1.0, 0.0, -1.0], [1.0, 2.0, 1.0]);
        let free = freed(&cube, &table, 1, true).unwrap();
        assert_eq!((free.min[1], free.max[1]), (0.0, 0.125));
        assert_eq!(
            (free.min[0], free.max[2]),
            (f64::NEG_INFINITY, f64::INFINITY)
        );
        // The table against the cube above it.
        let free = freed(&table, &cube, 1, false).unwrap();
        assert_eq!((free.min[1], free.max[1]), (-0.125, 0.0));
        assert_eq!(freed(&cube, &table, 1, false), None);
        assert_eq!(freed(&cube, &table, 0, true), None);
        let beside = Aabb::new([6.0, 0.0, -1.0], [8.0, 2.0, 1.0]);
        assert_eq!(freed(&beside, &table, 1, true), None);
        assert!(holds(&table, &cube, 1, 4.9) && !holds(&table, &cube, 1, 5.0));
    }
}
