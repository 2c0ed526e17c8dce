//! Solids that stand on one another: which of the two faces in one place POV-Ray meets first is up to
//! rounding, and where light goes through one of them that can be seen. One of the two is made longer
//! into the other, so that its face is where nobody sees it.

use super::tools::is_along;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, Vec3};
use crate::solids::shapes::facts::Facts as _;
use crate::solids::shapes::lengthen::{Cut, HAIR};
use crate::translate::pov::model::Model;
use crate::translate::pov::model::stretch::stretched;

/// Solids are made longer by this part of their length, or of what there is room for: far more than
/// POV-Ray's tolerances.
const PART: f64 = 1.0 / 16.0;

/// What is made longer may become so many times as wide, unless more is known.
const WIDER: f64 = 2.0;

/// So many moves that solids have in common are looked behind.
const MOVES: usize = 16;

/// So many parts of a solid are looked at.
const PATIENCE: u32 = 256;

/// What a solid may stand on.
enum Room {
    /// A box that it is beside.
    Full(Aabb),
    /// A part of a cone or cylinder, with flat ends.
    Round(Frustum),
    /// What is around a box that it is in, up to another one.
    Hollow { inner: Aabb, outer: Aabb },
    /// Something with these bounds that has another form.
    Other(Aabb),
}

/// A part of a cone or cylinder along an axis of the coordinates.
#[derive(Debug, Clone, Copy)]
struct Frustum {
    bounds: Aabb,
    axis: usize,
    /// At the lower end and at the upper one.
    radii: [f64; 2],
}

/// What stands on something.
struct Standing {
    bounds: Aabb,
    /// What is made longer may become so many times as wide.
    wider: f64,
    /// The axis that it is round about.
    round: Option<usize>,
}

/// What was found out about a solid that may stand on others.
#[derive(Default)]
pub struct Stand {
    /// The number of the cut that makes it longer, if it stands on any that have room for it.
    pub flush: Option<u32>,
    /// The others it is made longer into.
    pub held: Vec<NodeId>,
    /// Those it touches that have no room for it.
    pub loose: Vec<NodeId>,
}

impl Model<'_> {
    /// Whether a solid stands on others with a flat face, and on which of them.
    pub fn standing(&mut self, node: NodeId, others: &[NodeId]) -> Stand {
        self.stand(node, others, 0.0)
    }

    /// Made longer by so much, too, where it ends as others do, if that is not 0. What was turned as others
    /// were is looked at beside them as before that.
    pub fn stand(&mut self, node: NodeId, others: &[NodeId], by: f64) -> Stand {
        let mut stand = Stand::default();
        let (mut node, mut by) = (node, by);
        // Each with what it was before the moves that all of them have in common.
        let mut others: Vec<_> = others.iter().map(|other| (*other, *other)).collect();
        // The moves, the last first, with the change before each.
        let mut moves: Vec<(Matrix, Option<u32>)> = Vec::new();
        loop {
            let turned = (self.last_move(node))
                .filter(|_| moves.len() < MOVES && !is_along(&self.core(node).1))
                .and_then(|(child, m)| Some((child, m, stretched(&m)?)));
            let (mut alike, mut rest) = (Vec::new(), Vec::new());
            for (other, named) in others {
                let before = self.last_move(other);
                match before.filter(|(_, n)| turned.is_some_and(|(_, m, _)| *n == m)) {
                    Some((before, _)) => alike.push((before, named)),
                    None => rest.push((other, named)),
                }
            }
            let flush = self.stand_here(node, &rest, by, &mut stand);
            match turned.filter(|_| !alike.is_empty()) {
                Some((child, m, factor)) => {
                    moves.push((m, flush));
                    (node, by, others) = (child, by * factor, alike);
                }
                None => {
                    stand.flush = flush;
                    break;
                }
            }
        }
        for (m, before) in moves.into_iter().rev() {
            stand.flush = match stand.flush {
                Some(within) => {
                    let within = self.changes.within(&m, within);
                    Some(self.changes.both(before, within))
                }
                None => before,
            };
        }
        stand
    }

    /// The same, by boxes along the axes. The others have the names behind them.
    fn stand_here(
        &mut self,
        node: NodeId,
        others: &[(NodeId, NodeId)],
        by: f64,
        stand: &mut Stand,
    ) -> Option<u32> {
        let own = self.box_of(node);
        if own.is_empty() || !own.radius().is_finite() {
            return None;
        }
        let thing = Standing {
            bounds: own,
            wider: self.wider(node),
            round: self.frustum(node).map(|f| f.axis),
        };
        let mut free = Cut::of(Aabb::ALL, PART);
        for &(other, named) in others {
            if !self.box_of(other).overlaps(&own) {
                continue;
            }
            let rooms = self.rooms(other);
            for axis in 0..3 {
                for below in [true, false] {
                    if by > 0.0
                        && let Some(end) = self.ends_alike(&own, other, axis, below)
                    {
                        match below {
                            true => free.around.min[axis] = end,
                            false => free.around.max[axis] = end,
                        }
                        free.most = free.most.min(by);
                    }
                    let under = |room| Some((room, Room::under(room, &own, axis, below)?));
                    let Some((room, (end, depth))) = rooms.iter().find_map(under) else {
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
                    if (self.flush_by(node, Cut::of(alone, PART))).is_none() {
                        continue;
                    }
                    let length = own.max[axis] - own.min[axis];
                    if room.holds(&thing, axis, below) {
                        cut.by = cut.by.min(PART * depth / length);
                        // Half-spaces have no length.
                        cut.most = cut.most.min(PART * depth);
                        free = cut;
                        stand.held.push(named);
                    } else if by > 0.0 {
                        // By so little that nobody sees what it reaches beside the other.
                        cut.most = cut.most.min(by);
                        free = cut;
                        stand.held.push(named);
                    } else {
                        stand.loose.push(named);
                    }
                }
            }
        }
        self.flush_by(node, free)
    }

    /// Whether something with that box stands on a solid with its end along an axis.
    pub fn stands_on(&self, own: &Aabb, on: NodeId, axis: usize, below: bool) -> bool {
        (self.rooms(on).iter()).any(|room| room.under(own, axis, below).is_some())
    }

    /// How many times as wide a solid becomes at most where it is made longer.
    fn wider(&self, node: NodeId) -> f64 {
        let mut todo = vec![node];
        let mut most = 1.0f64;
        for _ in 0..PATIENCE {
            let Some(node) = todo.pop() else {
                return most;
            };
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    let wider = 1.0 + geometry.widened(PART);
                    most = most.max(wider);
                }
                Node::Union(a, b) => todo.extend([a, b]),
                // What is taken away is not made longer.
                Node::Difference(a, _) => todo.push(a),
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push(child),
                // It is longer along an axis of the coordinates only where that is one of its own.
                Node::Transform { child, .. } => todo.push(child),
                _ => most = most.max(WIDER),
            }
        }
        WIDER
    }

    /// Where a solid ends along an axis, given its box, if another one that it overlaps ends there, too.
    pub fn ends_alike(&self, own: &Aabb, other: NodeId, axis: usize, below: bool) -> Option<f64> {
        let end = ends_alike(own, &self.box_of(other), axis, below)?;
        // What is round is there in a point, or along a line.
        let is_round = match self.scene.nodes[self.core(other).0 as usize] {
            Node::Shape(shape) => {
                let geometry = &self.scene.shapes[shape as usize].geometry;
                geometry.character().ends_round
            }
            _ => false,
        };
        (!is_round).then_some(end)
    }

    /// A node as a part of a cone or cylinder along an axis, if it is one.
    fn frustum(&self, node: NodeId) -> Option<Frustum> {
        let (y, radii) = self.along_the_axes(node)?.frustum()?;
        let bounds = self.box_of(node);
        let size: [f64; 3] = std::array::from_fn(|i| bounds.max[i] - bounds.min[i]);
        // The place of the two ends tells the axis, and which of them is the lower one.
        let (_, place) = self.core(node);
        let ends = y.map(|y| place.point([0.0, y, 0.0]));
        let axis = (0..3).find(|i| (ends[1][*i] - ends[0][*i]).abs() > size[*i] / 2.0)?;
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
        let wide = size[a].max(size[b]);
        // As wide as it is deep but for what its placement was rounded: the axis stands upright.
        if (size[a] - size[b]).abs() > 1e-9 * wide {
            return None;
        }
        let largest = radii[0].max(radii[1]);
        let mut radii = radii.map(|r| r / largest * wide / 2.0);
        if ends[0][axis] > ends[1][axis] {
            radii.reverse();
        }
        Some(Frustum {
            bounds,
            axis,
            radii,
        })
    }

    /// What a node was before it was moved last, and how it was.
    fn last_move(&self, mut node: NodeId) -> Option<(NodeId, Matrix)> {
        loop {
            node = match self.scene.nodes[node as usize] {
                Node::Paint { child, .. } | Node::Copy { child, .. } => child,
                Node::Transform { child, matrix } => {
                    return Some((child, self.scene.matrices[matrix as usize]));
                }
                _ => return None,
            }
        }
    }

    /// The shape or operation that a node is, and from its coordinates to those of the node.
    fn core(&self, mut node: NodeId) -> (NodeId, Matrix) {
        let mut all = Matrix::IDENTITY;
        loop {
            node = match self.scene.nodes[node as usize] {
                Node::Paint { child, .. } | Node::Copy { child, .. } => child,
                Node::Transform { child, matrix } => {
                    all = all.after(&self.scene.matrices[matrix as usize]);
                    child
                }
                _ => return (node, all),
            }
        }
    }

    /// Whether a node is a box along the axes, or a half-space.
    fn is_flat(&self, node: NodeId) -> bool {
        self.along_the_axes(node)
            .is_some_and(|g| g.character().is_its_bounds || g.is_solid() && g.plane().is_some())
    }

    /// What there is to stand on of a solid; within what is hollow before outside of it.
    fn rooms(&self, node: NodeId) -> Vec<Room> {
        let bounds = self.box_of(node);
        if self.is_flat(node) {
            return vec![Room::Full(bounds)];
        }
        if let Some(frustum) = self.frustum(node) {
            return vec![Room::Round(frustum)];
        }
        let (at, m) = self.core(node);
        let moved = |node: NodeId| self.box_of(node).transformed(&m);
        let hollow = match self.scene.nodes[at as usize] {
            _ if !is_along(&m) => None,
            Node::Complement(b) if self.is_flat(b) => Some((moved(b), Aabb::ALL)),
            Node::Difference(a, b) if self.is_flat(a) && self.is_flat(b) => {
                Some((moved(b), moved(a)))
            }
            _ => None,
        };
        let hollow = hollow.map(|(inner, outer)| Room::Hollow { inner, outer });
        hollow.into_iter().chain([Room::Other(bounds)]).collect()
    }
}

/// Where two solids that overlap both end along an axis, if they do.
fn ends_alike(own: &Aabb, other: &Aabb, axis: usize, below: bool) -> Option<f64> {
    let end = |b: &Aabb| if below { b.min[axis] } else { b.max[axis] };
    let hair = HAIR * end(own).abs().max(own.max[axis] - own.min[axis]);
    let over = |i: usize| own.min[i].max(other.min[i]) < own.max[i].min(other.max[i]);
    ((end(own) - end(other)).abs() <= hair && (0..3).all(over)).then(|| end(own))
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
            // Only its ends are flat.
            Room::Round(f) if f.axis != axis => return None,
            Room::Round(f) => (ends(&f.bounds).1, ends(&f.bounds).0, &f.bounds),
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

    /// Whether it holds all that is beyond an end of what stands on it, not far away.
    fn holds(&self, thing: &Standing, axis: usize, below: bool) -> bool {
        let own = &thing.bounds;
        let centre = own.centre();
        let half: [f64; 3] = std::array::from_fn(|i| thing.wider * (own.max[i] - own.min[i]) / 2.0);
        if let Room::Round(frustum) = self {
            return frustum.holds(centre, half, thing.round == Some(axis), below);
        }
        (0..3).filter(|i| *i != axis).all(|i| {
            let (low, high) = (centre[i] - half[i], centre[i] + half[i]);
            match self {
                Room::Full(b) => b.min[i] < low && high < b.max[i],
                // It is in the box, and there is something around that.
                Room::Hollow { inner, outer } => {
                    let within = inner.min[i] <= own.min[i] && own.max[i] <= inner.max[i];
                    within && outer.min[i] < low && high < outer.max[i]
                }
                Room::Round(_) | Room::Other(_) => false,
            }
        })
    }
}

impl Frustum {
    /// Whether it holds a box, or what is round in that, beyond its upper or its lower end.
    fn holds(&self, centre: Vec3, half: Vec3, round: bool, upper: bool) -> bool {
        let [a, b] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        let here = self.bounds.centre();
        let off = (centre[a] - here[a]).hypot(centre[b] - here[b]);
        let reach = match round {
            true => half[a].max(half[b]),
            false => half[a].hypot(half[b]),
        };
        let [low, high] = self.radii;
        let (near, far) = if upper { (high, low) } else { (low, high) };
        // As deep as something goes into it at most, it may be narrower.
        off + reach < near.min(near + PART * (far - near))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_stand_on_tables() {
        let beneath = |bounds, wider| Standing {
            bounds,
            wider,
            round: None,
        };
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
        assert!(ground.holds(&beneath(cube, 2.0), 1, true));
        // The table against the cube above it.
        assert_eq!(Room::Full(cube).under(&table, 1, false), Some((0.0, 1.0)));
        let beside = Aabb::new([6.0, 0.0, -1.0], [8.0, 2.0, 1.0]);
        assert_eq!(room.under(&beside, 1, true), None);
        assert!(room.holds(&beneath(cube, 4.9), 1, true));
        assert!(!room.holds(&beneath(cube, 5.0), 1, true));
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
        let filling = Standing {
            bounds: water,
            wider: 1.0,
            round: None,
        };
        assert!(tank.holds(&filling, 1, true) && tank.holds(&filling, 0, false));
        // Something on the rim is not within.
        let lid = Aabb::new([-3.0, 3.0, -2.0], [3.0, 3.5, 2.0]);
        assert_eq!(tank.under(&lid, 1, true), None);
    }

    #[test]
    fn discs_hold_what_stands_within_them() {
        // A cone's lower part from y = 0 to 1, of radius 2 below and 1 above.
        let bounds = Aabb::new([-2.0, 0.0, -2.0], [2.0, 1.0, 2.0]);
        let room = Room::Round(Frustum {
            bounds,
            axis: 1,
            radii: [2.0, 1.0],
        });
        let on = |half: f64, at: f64, round: bool| Standing {
            bounds: Aabb::new([at - half, 1.0, -half], [at + half, 3.0, half]),
            wider: 1.0,
            round: round.then_some(1),
        };
        let cube = on(0.7, 0.0, false);
        assert_eq!(room.under(&cube.bounds, 1, true), Some((1.0, 1.0)));
        // What is beside it touches it along a line.
        assert_eq!(room.under(&cube.bounds, 0, true), None);
        // Corners are √2 as far out as sides.
        assert!(room.holds(&cube, 1, true));
        assert!(!room.holds(&on(0.75, 0.0, false), 1, true));
        assert!(room.holds(&on(0.75, 0.0, true), 1, true));
        assert!(!room.holds(&on(0.75, 0.25, true), 1, true));
        // Below it is wider, but narrower a little above: 2 − 1/16.
        assert!(room.holds(&on(1.9, 0.0, true), 1, false));
        assert!(!room.holds(&on(1.95, 0.0, true), 1, false));
    }
}
