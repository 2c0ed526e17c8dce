//! Which shapes hold a point.

use super::boxes::Boxes;
use super::inside::Inside;
use super::tree::{Answer, Tree};
use crate::scene::bounds::NodeBounds;
use crate::scene::{Aabb, Matrix, Scene, Vec3};

/// Boxes looked at, for all points together: some tenths of a second.
const STEPS: usize = 30_000_000;

/// What placing a point in the coordinates of a shape costs, in steps.
const SHAPE_COST: usize = 4;

pub struct Points<'a> {
    scene: &'a Scene,
    tree: &'a Tree,
    inside: Inside<'a>,
    boxes: Boxes,
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
            left: STEPS,
        }
    }

    /// The leaves that hold a point or may do so, in the order of their places; `None` when no steps
    /// are left.
    pub fn at(&mut self, p: Vec3) -> Option<Vec<(u32, Answer)>> {
        let mut near: Vec<u32> = Vec::new();
        let mut steps = self.boxes.near(&Aabb::new(p, p), &mut near);
        near.retain(|&i| self.tree.leaves[i as usize].bounds.contains(p));
        near.sort_unstable();
        let mut out = Vec::new();
        for i in near {
            let leaf = &self.tree.leaves[i as usize];
            steps += SHAPE_COST;
            let local = local(&leaf.matrix, p)?;
            let answer = match leaf.shape {
                Some(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    self.inside.shape(geometry, local)
                }
                None => self.inside.node(leaf.node, local),
            };
            if answer != Some(false) {
                out.push((leaf.place, answer));
            }
        }
        self.left = self.left.checked_sub(steps)?;
        Some(out)
    }

    /// Whether a point is in the shape of a leaf.
    pub fn in_leaf(&mut self, leaf: u32, p: Vec3) -> Answer {
        self.left = self.left.checked_sub(SHAPE_COST)?;
        let leaf = &self.tree.leaves[leaf as usize];
        let geometry = &self.scene.shapes[leaf.shape? as usize].geometry;
        self.inside.shape(geometry, local(&leaf.matrix, p)?)
    }
}

fn local(m: &Matrix, p: Vec3) -> Option<Vec3> {
    match *m == Matrix::IDENTITY {
        true => Some(p),
        false => Some(m.inverse()?.point(p)),
    }
}
