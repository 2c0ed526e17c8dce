//! The shapes that hold a point.

use rustc_hash::FxHashMap;

use super::inside::Inside;
use super::tree::{Answer, Tree};
use crate::geometry::boxes::Boxes;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Scene, Vec3};
use crate::solids::bounds::NodeBounds;

/// The most steps for all points together, such as boxes that are looked at: some tenths of a second.
const STEPS: usize = 12_000_000;

/// The cost of moving a point into a shape's coordinates, in steps. [`HELD_COST`] comes on top if the point may be
/// inside: the operations above the shape are then gone through.
const SHAPE_COST: usize = 4;
const HELD_COST: usize = 12;

pub struct Points<'a> {
    scene: &'a Scene,
    tree: &'a Tree,
    inside: Inside<'a>,
    boxes: Boxes,
    /// The maps from the coordinates of the root into those of leaves that have been asked for.
    inverses: FxHashMap<u32, Option<Matrix>>,
    left: usize,
}

impl<'a> Points<'a> {
    pub fn new(scene: &'a Scene, bounds: &'a [NodeBounds], tree: &'a Tree) -> Points<'a> {
        let leaves = tree.leaves.iter().enumerate();
        Points {
            scene,
            tree,
            inside: Inside::new(scene, bounds),
            boxes: Boxes::new(leaves.map(|(i, l)| (i as u32, l.bounds))),
            inverses: FxHashMap::default(),
            left: STEPS,
        }
    }

    /// The leaves that may hold a point of a box, in the order of their places; `None` when no steps
    /// are left.
    pub fn near(&mut self, around: &Aabb) -> Option<Vec<u32>> {
        let mut near: Vec<u32> = Vec::new();
        let steps = self.boxes.near(around, &mut near);
        self.spend(steps + near.len())?;
        near.retain(|&i| self.tree.leaves[i as usize].bounds.overlaps(around));
        near.sort_unstable();
        Some(near)
    }

    /// The places of the leaves among `near` that hold a point or may hold it, with the answers. `None` when no steps
    /// are left.
    pub fn at(&mut self, p: Vec3, near: &[u32]) -> Option<Vec<(u32, Answer)>> {
        self.spend(near.len())?;
        let mut out = Vec::new();
        for &i in near {
            let leaf = &self.tree.leaves[i as usize];
            if !leaf.bounds.contains(p) {
                continue;
            }
            self.spend(SHAPE_COST)?;
            let local = self.local(i, p)?;
            let answer = match leaf.shape {
                Some(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    self.inside.shape(geometry, local)
                }
                None => self.inside.node(leaf.node, local),
            };
            if answer != Some(false) {
                self.spend(HELD_COST)?;
                out.push((leaf.place, answer));
            }
        }
        Some(out)
    }

    /// Whether a point is in the shape of a leaf.
    pub fn in_leaf(&mut self, leaf: u32, p: Vec3) -> Answer {
        self.spend(SHAPE_COST)?;
        let local = self.local(leaf, p)?;
        let shape = self.tree.leaves[leaf as usize].shape?;
        let geometry = &self.scene.shapes[shape as usize].geometry;
        self.inside.shape(geometry, local)
    }

    /// Whether there are no steps left for any more points.
    pub fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Takes steps from the budget. If too few are left, takes all of them and returns `None`.
    fn spend(&mut self, steps: usize) -> Option<()> {
        let left = self.left.checked_sub(steps);
        self.left = left.unwrap_or(0);
        left.map(|_| ())
    }

    fn local(&mut self, leaf: u32, p: Vec3) -> Option<Vec3> {
        let m = &self.tree.leaves[leaf as usize].matrix;
        if *m == Matrix::IDENTITY {
            return Some(p);
        }
        let back = self.inverses.entry(leaf).or_insert_with(|| m.inverse());
        Some(back.as_ref()?.point(p))
    }
}
