//! Points of an object's surface that are known exactly: those where its shapes reach furthest.

use std::cell::Cell;

use super::ancestry::NONE;
use super::extent::{WRITTEN, beyond, farthest_out, size};
use super::inside::Inside;
use super::leaf::Leaf;
use super::shapes::facts::{Facts, Support};
use super::support::{directions, support_points};
use super::tree::Tree;
use crate::geometry::Aabb;
use crate::scene::{Geometry, NodeId, Scene, Vec3, Volume};
use crate::solids::bounds::NodeBounds;

/// A point of a surface.
#[derive(Debug, Clone, Copy)]
pub struct Met {
    pub point: Vec3,
    /// The ID under which the surface is written.
    pub shape: u32,
}

/// The most points that are looked at, those first that reach furthest out.
const SUPPORTS: usize = 16;

/// The distance from the surface at which a point is tried, as a share of the distance of the surface from the volume.
const STEP: f64 = 0.01;

/// The most directions in which shapes are asked how far they reach, for all searches that share a budget: some tenths
/// of a second.
pub const DIRECTIONS: usize = 3_000_000;

/// The exactly known points of an object: those where its leaves reach furthest.
pub struct Outline<'a> {
    /// The number of directions that are left.
    pub left: &'a Cell<usize>,
    pub scene: &'a Scene,
    pub bounds: &'a [NodeBounds],
    pub tree: &'a Tree,
    pub root: NodeId,
}

impl Outline<'_> {
    fn geometry(&self, leaf: &Leaf) -> Option<&Geometry> {
        Some(&self.scene.shapes[leaf.shape? as usize].geometry)
    }

    /// Whether all of a leaf is part of the object: no operation cuts anything off.
    fn is_whole(&self, leaf: &Leaf) -> bool {
        let place = &self.tree.places[leaf.place as usize];
        place.group == NONE && !place.turned
    }

    /// Whether the volume is a box and [`outside`](Self::outside) finds every part that reaches out of it at all.
    pub fn is_exact(&self, volume: &Volume) -> bool {
        let directions = directions(volume);
        let whole = |leaf: &Leaf| {
            let ends = |g| {
                support_points(g, &leaf.matrix, volume, &directions, self.left)
                    .next()
                    .is_some()
            };
            self.is_whole(leaf) && self.geometry(leaf).is_some_and(ends)
        };
        matches!(volume, Volume::Box { .. }) && self.tree.leaves.iter().all(whole)
    }

    /// The point of the surface that is furthest outside of a volume, if it is outside by more than rounding.
    pub fn outside(&self, volume: &Volume) -> Option<Met> {
        let slack = WRITTEN * size(volume);
        self.first(volume, slack, |b| farthest_out(volume, b), |by| by)
    }

    /// A point of the surface inside of a volume by more than rounding.
    pub fn inside(&self, volume: &Volume) -> Option<Met> {
        let slack = WRITTEN * size(volume);
        self.first(volume, slack, |_| f64::INFINITY, |by| -by)
    }

    /// The support of the greatest worth that is part of the surface and is worth more than `least`. `worth` rates a
    /// point by its distance out of the volume. `most` is an upper bound on the worth of the points in a box.
    fn first(
        &self,
        volume: &Volume,
        least: f64,
        most: impl Fn(&Aabb) -> f64,
        worth: impl Fn(f64) -> f64,
    ) -> Option<Met> {
        let leaves = self.tree.leaves.iter().map(|l| (most(&l.bounds), l));
        let mut leaves: Vec<(f64, &Leaf)> = leaves.filter(|l| l.0 > least).collect();
        leaves.sort_by(|a, b| b.0.total_cmp(&a.0));
        let directions = directions(volume);
        let mut all: Vec<(f64, &Leaf, Support)> = Vec::new();
        for (most, leaf) in leaves {
            let Some(geometry) = self.geometry(leaf) else {
                continue;
            };
            if all.len() > 4 * SUPPORTS {
                best_first(&mut all);
                // Nothing in the boxes that are left is worth more.
                if all[SUPPORTS - 1].0 >= most {
                    break;
                }
            }
            if self.left.get() < directions.len() {
                self.left.set(0);
                break;
            }
            for support in support_points(geometry, &leaf.matrix, volume, &directions, self.left) {
                let by = worth(beyond(volume, support.point));
                if by > least {
                    all.push((by, leaf, support));
                }
            }
        }
        best_first(&mut all);
        let mut inside = Inside::new(self.scene, self.bounds);
        let mut is_part = |&(by, leaf, support): &(f64, &Leaf, Support)| {
            let at = |step: f64| match support.inwards {
                None => support.point,
                Some(v) => {
                    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
                    std::array::from_fn(|i| support.point[i] + step * STEP * by / length * v[i])
                }
            };
            // Where a profile runs along the same piece twice there is no surface.
            let plain = !(self.geometry(leaf)).is_some_and(|g| g.character().may_cover_itself);
            let sheet = support.inwards.is_none();
            let held = match self.is_whole(leaf) && plain {
                true => true,
                false if sheet => false,
                false => {
                    let p = at(1.0);
                    worth(beyond(volume, p)) > least && inside.node(self.root, p) == Some(true)
                }
            };
            // No other part of the object may hold a point just outside.
            held && inside.node(self.root, at(-1.0)) == Some(false)
        };
        let (_, leaf, support) = all.iter().find(|c| is_part(c))?;
        Some(Met {
            point: support.point,
            shape: leaf.id,
        })
    }
}

fn best_first(all: &mut Vec<(f64, &Leaf, Support)>) {
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.truncate(SUPPORTS);
}
