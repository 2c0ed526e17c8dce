//! Shapes that are near no other.

use super::expand::Leaves;
use super::leaf::{Kind, Leaf};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::bvh::Bvh;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use crate::trace::shapes::Primitive;
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
    // Light gets into an opaque solid where an earlier transparent operand hides its face. The opaque solid may hide a
    // later one in turn.
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
            let is_one = own.look.medium == around.look.medium;
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
    /// The leaves without bounds, with a plane for those that are planes or half-spaces.
    flats: Vec<(u32, Option<Flat>)>,
    boxes: Vec<(u32, Aabb)>,
    bounds: FxHashMap<u32, Aabb>,
    balls: FxHashMap<u32, Ball>,
    /// Two trees of leaves with bounds: all of them, and the transparent ones.
    hierarchies: [Bvh; 2],
    clear: FxHashSet<u32>,
}

impl Neighbours {
    fn new(graph: &Graph, leaves: &Leaves) -> Neighbours {
        let leaf = |number: u32| &leaves.all[number as usize];
        let boxes = leaves.boxes.clone();
        let flat = |&i: &u32| (i, Flat::new(graph, leaf(i)));
        let chain = |i: u32| &leaves.chains[leaf(i).chain as usize];
        let ball = |(i, _): &(u32, Aabb)| Some((*i, Ball::new(graph, chain(*i), leaf(*i))?));
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

    /// Whether some leaf near leaf `own` is `wanted`. If `is_clear`, only transparent leaves are asked.
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

    /// Whether leaf `own` is near leaf `other`, both with bounds; `around` is the box of `own` with room.
    fn is_near(&self, (own, bounds): (u32, &Aabb), other: u32, around: &Aabb) -> bool {
        let room = ROOM * bounds.reach();
        let balls = self.balls.get(&own).zip(self.balls.get(&other));
        let is_apart =
            balls.is_some_and(|(a, b)| (a.centre - b.centre).length() > a.radius + b.radius + room);
        !is_apart && self.bounds[&other].overlaps(around)
    }
}

/// Shapes are far from each other if the gap exceeds this share of the largest coordinate of their bounds. Such a gap
/// is far longer than the distances at which a ray is in doubt.
const ROOM: f64 = 1e-4;

/// The box with room around it.
fn widened(bounds: &Aabb) -> Aabb {
    let room = Vec3::ONE * (ROOM * bounds.reach());
    Aabb::new(Vec3(bounds.min) - room, Vec3(bounds.max) + room)
}

/// A ball in the scene's space that holds a shape, roughly.
struct Ball {
    centre: Vec3,
    radius: f64,
}

impl Ball {
    /// `None` for intersections and differences.
    fn new(graph: &Graph, chain: &[u32], leaf: &Leaf) -> Option<Ball> {
        if leaf.kind == Kind::Csg {
            return None;
        }
        let primitive = &graph.primitives[leaf.primitive as usize];
        let bounds = primitive.shape().bounds();
        let extent = Vec3(bounds.extent());
        let is_round = matches!(
            primitive,
            Primitive::Sphere(_) | Primitive::Ellipsoid(_) | Primitive::Torus(_)
        );
        let width = match is_round {
            true => extent.max_component(),
            false => extent.length(),
        };
        let ball = Ball {
            centre: Vec3(bounds.centre()),
            radius: width / 2.0,
        };
        let outwards = |ball: Ball, &placement: &u32| {
            let out = &graph.placements[placement as usize].out;
            Ball {
                centre: out.point(ball.centre),
                radius: ball.radius * stretch(&out.rows),
            }
        };
        Some(chain.iter().rev().fold(ball, outwards))
    }
}

/// A bound on the factor by which a map lengthens vectors; exact for a map whose columns are at right angles.
fn stretch(rows: &[Vec3; 3]) -> f64 {
    let column = |i: usize| Vec3(each([0, 1, 2], |row: usize| rows[row][i]));
    let squares = each([0, 1, 2], |i: usize| {
        let products = each([0, 1, 2], |j: usize| column(i).dot(column(j)));
        Vec3(products).abs().dot(Vec3::ONE)
    });
    Vec3(squares).max_component().sqrt()
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

    /// Whether the whole box is on one side of the plane, and outside of a half-space.
    fn is_apart(&self, bounds: &Aabb) -> bool {
        let value = self.normal.dot(Vec3(bounds.centre())) + self.d;
        let reach = self.normal.abs().dot(Vec3(bounds.extent())) / 2.0;
        value > reach || (value < -reach && !self.is_solid)
    }
}
