//! Shapes that are near no other.

use super::expand::Leaves;
use super::leaf::{Kind, Leaf};
use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use rustc_hash::FxHashMap;
use std::ops::ControlFlow;

/// Finds out which shapes are lone: see [`Leaf::is_lone`].
pub fn find_lone(graph: &Graph, leaves: &mut Leaves) {
    let Leaves {
        all, loose, boxes, ..
    } = leaves;
    let is_clear = |leaf: u32| all[leaf as usize].is_clear;
    let flats: Vec<Option<Flat>> = loose
        .iter()
        .map(|&leaf| Flat::new(graph, &all[leaf as usize]))
        .collect();
    let balls: FxHashMap<u32, Ball> = (boxes.iter())
        .filter_map(|(i, bounds)| Some((*i, Ball::new(graph, &all[*i as usize], bounds)?)))
        .collect();
    let bounds_of: FxHashMap<u32, Aabb> = boxes.iter().copied().collect();
    // Whether a leaf without bounds concerns what is in a box.
    let is_near = |(flat, leaf): (&Option<Flat>, u32), (i, bounds): &(u32, Aabb)| {
        let is_apart = || matches!(flat, Some(flat) if flat.is_apart(&widened(bounds)));
        (is_clear(leaf) || is_clear(*i)) && !is_apart()
    };
    let mut lone = Vec::new();
    for (flat, &leaf) in flats.iter().zip(loose.iter()) {
        let mut others = loose.iter().filter(|&&other| other != leaf);
        let is_alone = !others.any(|&other| is_clear(leaf) || is_clear(other))
            && !boxes.iter().any(|item| is_near((flat, leaf), item));
        lone.push((leaf, is_alone));
    }
    let of = |clear: bool| {
        let like = boxes.iter().filter(|(i, _)| !clear || is_clear(*i));
        Bvh::new(like.copied().collect())
    };
    let hierarchies = [of(false), of(true)];
    for item @ (i, bounds) in boxes.iter() {
        let around = widened(bounds);
        let is_alone = |j: u32| {
            let is_apart = match (balls.get(i), balls.get(&j)) {
                (Some(a), Some(b)) => {
                    let room = ROOM * bounds.reach();
                    (a.centre - b.centre).length() > a.radius + b.radius + room
                }
                _ => !bounds_of[&j].overlaps(&around),
            };
            match j != *i && !is_apart {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        let near = &hierarchies[usize::from(!is_clear(*i))];
        let mut flats = flats.iter().zip(loose.iter().copied());
        let is_alone =
            near.visit(&around, is_alone).is_continue() && !flats.any(|flat| is_near(flat, item));
        lone.push((*i, is_alone));
    }
    for (leaf, is_lone) in lone {
        all[leaf as usize].is_lone = is_lone;
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
