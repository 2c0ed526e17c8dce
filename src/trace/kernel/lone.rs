//! Shapes that are near no other.

use super::expand::Leaves;
use super::leaf::{Kind, Leaf};
use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::ControlFlow;

/// Finds out which shapes are lone: see [`Leaf::is_lone`].
pub fn find_lone(graph: &Graph, leaves: &mut Leaves) {
    let near = Neighbours::new(graph, leaves);
    let leaf = |number: u32| &leaves.all[number as usize];
    let each = || near.items();
    let mut lone: FxHashSet<u32> = each()
        .filter(|&i| !near.any(i, !leaf(i).is_clear, |_| true))
        .collect();
    // Light gets into something opaque where an earlier operand hides its face, and a later one is hidden in that in turn.
    let is_entered = |own: &Leaf, i: u32| {
        own.is_solid
            && !own.is_clear
            && near.any(i, true, |j| {
                leaf(j).is_solid && leaf(j).operand < own.operand
            })
    };
    let mut entered: Vec<u32> = each().filter(|&i| is_entered(leaf(i), i)).collect();
    let mut known: FxHashSet<u32> = entered.iter().copied().collect();
    while let Some(outer) = entered.pop() {
        let around = leaf(outer);
        near.any(outer, false, |i| {
            let own = leaf(i);
            let is_one = own.medium == around.medium;
            if own.is_solid && !own.is_clear && (is_one || around.operand < own.operand) {
                lone.remove(&i);
                if is_one && known.insert(i) {
                    entered.push(i);
                }
            }
            false
        });
    }
    let items: Vec<u32> = each().collect();
    for number in items {
        leaves.all[number as usize].is_lone = lone.contains(&number);
    }
}

/// The leaves of the scene's union, as neighbours of each other.
struct Neighbours {
    /// Those without bounds.
    flats: Vec<(u32, Option<Flat>)>,
    boxes: Vec<(u32, Aabb)>,
    bounds: FxHashMap<u32, Aabb>,
    balls: FxHashMap<u32, Ball>,
    /// Those with bounds: all, and the transparent ones.
    hierarchies: [Bvh; 2],
    clear: FxHashSet<u32>,
}

impl Neighbours {
    fn new(graph: &Graph, leaves: &Leaves) -> Neighbours {
        let leaf = |number: u32| &leaves.all[number as usize];
        let boxes = leaves.boxes.clone();
        let flat = |&i: &u32| (i, Flat::new(graph, leaf(i)));
        let ball = |(i, bounds): &(u32, Aabb)| Some((*i, Ball::new(graph, leaf(*i), bounds)?));
        let of = |clear: bool| {
            let like = boxes.iter().filter(|(i, _)| !clear || leaf(*i).is_clear);
            Bvh::new(like.copied().collect())
        };
        let flats: Vec<_> = leaves.loose.iter().map(flat).collect();
        let all = boxes
            .iter()
            .map(|(i, _)| *i)
            .chain(leaves.loose.iter().copied());
        Neighbours {
            clear: all.filter(|&i| leaf(i).is_clear).collect(),
            bounds: boxes.iter().copied().collect(),
            balls: boxes.iter().filter_map(ball).collect(),
            hierarchies: [of(false), of(true)],
            flats,
            boxes,
        }
    }

    fn items(&self) -> impl Iterator<Item = u32> {
        let boxes = self.boxes.iter().map(|(i, _)| *i);
        boxes.chain(self.flats.iter().map(|(i, _)| *i))
    }

    /// Whether some leaf near another is as wanted: of all, or of the transparent ones.
    fn any(&self, own: u32, is_clear: bool, mut wanted: impl FnMut(u32) -> bool) -> bool {
        let mut is_wanted =
            |i: u32| i != own && (!is_clear || self.clear.contains(&i)) && wanted(i);
        let Some(bounds) = self.bounds.get(&own) else {
            let flat = self.flats.iter().find(|(i, _)| *i == own);
            let flat = flat.and_then(|(_, flat)| flat.as_ref());
            let is_near = |bounds: &Aabb| flat.is_none_or(|flat| !flat.is_apart(&widened(bounds)));
            return (self.flats.iter()).any(|(i, _)| is_wanted(*i))
                || (self.boxes.iter()).any(|(i, bounds)| is_near(bounds) && is_wanted(*i));
        };
        let around = widened(bounds);
        let found = |i: u32| match self.is_near((own, bounds), i, &around) && is_wanted(i) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        if self.hierarchies[usize::from(is_clear)]
            .visit(&around, found)
            .is_break()
        {
            return true;
        }
        let is_near =
            |flat: &Option<Flat>| flat.as_ref().is_none_or(|flat| !flat.is_apart(&around));
        (self.flats.iter()).any(|(i, flat)| is_near(flat) && is_wanted(*i))
    }

    /// Whether a leaf with bounds is near another one with bounds, and room around them.
    fn is_near(&self, (own, bounds): (u32, &Aabb), other: u32, around: &Aabb) -> bool {
        match (self.balls.get(&own), self.balls.get(&other)) {
            (Some(a), Some(b)) => {
                let room = ROOM * bounds.reach();
                let is_apart = (a.centre - b.centre).length() > a.radius + b.radius + room;
                !is_apart
            }
            _ => self.bounds[&other].overlaps(around),
        }
    }
}

/// Shapes that are apart by more than this share of the numbers behind their bounds are far from each other: rays leave
/// them by far more than what makes them doubt.
const ROOM: f64 = 1e-4;

/// A box, and room around it.
fn widened(bounds: &Aabb) -> Aabb {
    let room = Vec3::ONE * (ROOM * bounds.reach());
    Aabb::new(Vec3(bounds.min) - room, Vec3(bounds.max) + room)
}

/// A sphere in the scene's space, roughly.
struct Ball {
    centre: Vec3,
    radius: f64,
}

impl Ball {
    /// `None` for what is no sphere, or is turned or stretched.
    fn new(graph: &Graph, leaf: &Leaf, bounds: &Aabb) -> Option<Ball> {
        let rows = &graph.placements[leaf.placement as usize].out.rows;
        let is_moved = (0..3).all(|i| (0..3).all(|j| rows[i].0[j] == f64::from(u8::from(i == j))));
        (leaf.kind == Kind::Sphere && is_moved).then(|| Ball {
            centre: Vec3(bounds.centre()),
            radius: bounds.extent()[0] / 2.0,
        })
    }
}

/// A plane in the scene's space, roughly.
struct Flat {
    normal: Vec3,
    d: f64,
    is_solid: bool,
}

impl Flat {
    /// `None` for what is neither a plane nor a half-space.
    fn new(graph: &Graph, leaf: &Leaf) -> Option<Flat> {
        if !matches!(leaf.kind, Kind::Plane | Kind::HalfSpace) {
            return None;
        }
        let back = &graph.placements[leaf.placement as usize].back;
        let normal = Vec3(*leaf.first());
        Some(Flat {
            normal: back.transposed(normal),
            d: normal.dot(back.offset) + leaf.numbers[3],
            is_solid: leaf.kind == Kind::HalfSpace,
        })
    }

    /// Whether all of a box is on one side, and outside.
    fn is_apart(&self, bounds: &Aabb) -> bool {
        let value = self.normal.dot(Vec3(bounds.centre())) + self.d;
        let reach = self.normal.abs().dot(Vec3(bounds.extent())) / 2.0;
        value > reach || (value < -reach && !self.is_solid)
    }
}
