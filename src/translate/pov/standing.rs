//! Solids that stand on one another: which of the two faces in one place POV-Ray meets first is up to
//! rounding, and where light goes through one of them that can be seen. One of the two is made longer
//! into the other, so that its face is where nobody sees it.

use super::build::Builder;
use super::flush::{Cut, HAIR};
use crate::scene::{Aabb, Geometry, Node, NodeId};

/// Solids are made longer by this part of their length, or of what there is room for: far more than
/// POV-Ray's tolerances.
const PART: f64 = 1.0 / 16.0;

/// What is made longer may become so many times as wide: profiles go on as they end.
const WIDER: f64 = 2.0;

/// What a solid may stand on.
enum Room {
    /// A box that it is beside.
    Full(Aabb),
    /// What is around a box that it is in, up to another one.
    Hollow { inner: Aabb, outer: Aabb },
    /// Something with these bounds that has another form.
    Other(Aabb),
}

impl Builder<'_> {
    /// The number of the cut that makes a solid longer where it stands on others with a flat face, if it
    /// stands on any that have room for it. Where there is no room the report says so.
    pub(super) fn standing(&mut self, node: NodeId, others: &[NodeId]) -> Option<u32> {
        let own = self.box_of(node);
        if own.is_empty() || !own.radius().is_finite() {
            return None;
        }
        let wider = match self.is_flat(node) {
            true => 1.0,
            false => WIDER,
        };
        let mut free = Cut {
            around: Aabb::ALL,
            by: PART,
        };
        for &other in others {
            let room = self.room(other);
            for axis in 0..3 {
                for below in [true, false] {
                    let Some((end, depth)) = room.under(&own, axis, below) else {
                        continue;
                    };
                    let mut cut = free;
                    match below {
                        true => cut.around.min[axis] = end,
                        false => cut.around.max[axis] = end,
                    }
                    let mut alone = Aabb::ALL;
                    (alone.min[axis], alone.max[axis]) = match below {
                        true => (end, f64::INFINITY),
                        false => (f64::NEG_INFINITY, end),
                    };
                    let around = alone;
                    if (self.flush_by(node, Cut { around, by: PART })).is_none() {
                        continue;
                    }
                    if room.holds(&own, axis, wider) {
                        let share = depth / (own.max[axis] - own.min[axis]);
                        cut.by = cut.by.min(PART * share);
                        free = cut;
                    } else {
                        self.faces_in_one_place(self.ids[node as usize]);
                    }
                }
            }
        }
        self.flush_by(node, free)
    }

    /// Whether a node is a box along the axes, or a half-space.
    fn is_flat(&self, node: NodeId) -> bool {
        self.along_the_axes(node)
            .is_some_and(|g| matches!(g, Geometry::Box { .. } | Geometry::HalfSpace(_)))
    }

    fn room(&self, node: NodeId) -> Room {
        let bounds = self.box_of(node);
        if self.is_flat(node) {
            return Room::Full(bounds);
        }
        let mut at = node;
        while let Node::Paint { child, .. } | Node::Copy { child, .. } =
            self.scene.nodes[at as usize]
        {
            at = child;
        }
        match self.scene.nodes[at as usize] {
            Node::Complement(b) if self.is_flat(b) => Room::Hollow {
                inner: self.box_of(b),
                outer: Aabb::ALL,
            },
            Node::Difference(a, b) if self.is_flat(a) && self.is_flat(b) => Room::Hollow {
                inner: self.box_of(b),
                outer: self.box_of(a),
            },
            _ => Room::Other(bounds),
        }
    }
}

impl Room {
    /// Where a box stands on it with its end along an axis, and how deep it is there.
    fn under(&self, own: &Aabb, axis: usize, below: bool) -> Option<(f64, f64)> {
        let ends = |b: &Aabb| match below {
            true => (b.min[axis], b.max[axis]),
            false => (b.max[axis], b.min[axis]),
        };
        let at = ends(own).0;
        let (end, far, bounds) = match self {
            Room::Full(b) | Room::Other(b) => (ends(b).1, ends(b).0, b),
            Room::Hollow { inner, outer } => (ends(inner).0, ends(outer).0, outer),
        };
        let length = own.max[axis] - own.min[axis];
        // Some have no end there.
        let hair = HAIR * at.abs().max(length);
        let over = |i: usize| own.min[i].max(bounds.min[i]) < own.max[i].min(bounds.max[i]);
        let beside = (0..3).filter(|i| *i != axis).all(over);
        let depth = if below { end - far } else { far - end }.min(length);
        ((at - end).abs() <= hair && beside && depth > 0.0).then_some((at, depth))
    }

    /// Whether it holds all that is beyond the end of a box, not far away.
    fn holds(&self, own: &Aabb, axis: usize, wider: f64) -> bool {
        let centre = own.centre();
        (0..3).filter(|i| *i != axis).all(|i| {
            let half = wider * (own.max[i] - own.min[i]) / 2.0;
            let (low, high) = (centre[i] - half, centre[i] + half);
            match self {
                Room::Full(b) => b.min[i] < low && high < b.max[i],
                // It is in the box, and there is something around that.
                Room::Hollow { inner, outer } => {
                    let within = inner.min[i] <= own.min[i] && own.max[i] <= inner.max[i];
                    within && outer.min[i] < low && high < outer.max[i]
                }
                Room::Other(_) => false,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_stand_on_tables() {
        let table = Aabb::new([-5.0, -1.0, -5.0], [5.0, 0.0, 5.0]);
        let cube = Aabb::new([-1.0, 0.0, -1.0], [1.0, 2.0, 1.0]);
        let room = Room::Full(table);
        assert_eq!(room.under(&cube, 1, true), Some((0.0, 1.0)));
        assert_eq!(room.under(&cube, 1, false), None);
        assert_eq!(room.under(&cube, 0, true), None);
        let ground = Aabb::new([f64::NEG_INFINITY; 3], [f64::INFINITY, 0.0, f64::INFINITY]);
        let ground = Room::Full(ground);
        assert_eq!(ground.under(&cube, 1, true), Some((0.0, 2.0)));
        assert_eq!(ground.under(&cube, 1, false), None);
        assert!(ground.holds(&cube, 1, 2.0));
        // The table against the cube above it.
        assert_eq!(Room::Full(cube).under(&table, 1, false), Some((0.0, 1.0)));
        let beside = Aabb::new([6.0, 0.0, -1.0], [8.0, 2.0, 1.0]);
        assert_eq!(room.under(&beside, 1, true), None);
        assert!(room.holds(&cube, 1, 4.9) && !room.holds(&cube, 1, 5.0));
    }

    #[test]
    fn water_stands_in_a_tank() {
        let outer = Aabb::new([-3.0, 0.0, -2.0], [3.0, 3.0, 2.0]);
        let inner = Aabb::new([-2.5, 0.25, -1.5], [2.5, 3.5, 1.5]);
        let tank = Room::Hollow { inner, outer };
        let water = Aabb::new([-2.5, 0.25, -1.5], [2.5, 2.0, 1.5]);
        assert_eq!(tank.under(&water, 1, true), Some((0.25, 0.25)));
        assert_eq!(tank.under(&water, 1, false), None);
        assert_eq!(tank.under(&water, 0, false), Some((2.5, 0.5)));
        assert!(tank.holds(&water, 1, 1.0) && tank.holds(&water, 0, 1.0));
        // Something on the rim is not within.
        let lid = Aabb::new([-3.0, 3.0, -2.0], [3.0, 3.5, 2.0]);
        assert_eq!(tank.under(&lid, 1, true), None);
    }
}
