//! Parts that overlap.

use std::collections::HashSet;

use super::unions::{Part, Unions};
use crate::lint::solids::boxes::Boxes;
use crate::lint::solids::inside::Inside;
use crate::scene::bounds::NodeBounds;
use crate::scene::{Aabb, Matrix, NodeId, Scene, Vec3};

/// Boxes looked at and steps up the unions, for all parts together: some hundredths of a second.
const STEPS: usize = 10_000_000;

/// Points tried for a pair of parts whose boxes overlap.
const POINTS: u32 = 24;

/// How far inside of both parts a point must be, as a share of the smaller one: what overlaps by less
/// is meant to touch, and written with six or seven digits.
const DEPTH: f64 = 1e-6;

/// Two parts that overlap.
pub(super) struct Found {
    /// The union of both.
    pub(super) union: NodeId,
    /// Indices of the parts, in the order of the operands.
    pub(super) parts: [u32; 2],
    /// A point of both, in the coordinates of the scene.
    pub(super) witness: Vec3,
}

pub(super) struct Search<'a> {
    scene: &'a Scene,
    unions: &'a Unions,
    inside: Inside<'a>,
    left: usize,
    /// Unions that have been spoken of.
    done: HashSet<NodeId>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        scene: &'a Scene,
        unions: &'a Unions,
        bounds: &'a [NodeBounds],
    ) -> Search<'a> {
        Search {
            scene,
            unions,
            inside: Inside::new(scene, bounds),
            left: STEPS,
            done: HashSet::new(),
        }
    }

    pub(super) fn all(&mut self) -> Vec<Found> {
        let unions = self.unions;
        let transmits = |p: &Part| unions.media[p.medium as usize].transmits();
        if unions.media.len() < 2 || !unions.parts.iter().any(transmits) {
            return Vec::new();
        }
        let parts = unions.parts.iter().enumerate();
        let boxes = Boxes::new(parts.map(|(i, p)| (i as u32, p.bounds)));
        let mut found = Vec::new();
        for (i, part) in unions.parts.iter().enumerate() {
            let i = i as u32;
            let mut near = Vec::new();
            let steps = match part.bounds.is_finite() {
                true => boxes.near(&part.bounds, &mut near),
                // Two without end: no place to look at.
                false if transmits(part) => boxes.near_finite(&part.bounds, &mut near),
                false => 0,
            };
            near.retain(|&j| unions.parts[j as usize].bounds.overlaps(&part.bounds));
            match self.left.checked_sub(steps + 1) {
                Some(left) => self.left = left,
                None => break,
            }
            for j in near {
                let other = &unions.parts[j as usize];
                // Each pair once.
                let turn = match (transmits(part), transmits(other)) {
                    (true, true) => i < j || !other.bounds.is_finite(),
                    (one, _) => one,
                };
                if !turn || part.medium == other.medium {
                    continue;
                }
                let Some(left) = self.left.checked_sub(POINTS as usize) else {
                    return found;
                };
                self.left = left;
                found.extend(self.pair([i.min(j), i.max(j)]));
            }
        }
        found
    }

    fn pair(&mut self, pair: [u32; 2]) -> Option<Found> {
        let parts = pair.map(|i| &self.unions.parts[i as usize]);
        let union = self.union(parts)?;
        if self.done.contains(&union) {
            return None;
        }
        let both = parts[0].bounds.intersection(&parts[1].bounds);
        let longest = |b: &Aabb| (0..3).fold(0.0f64, |m, i| m.max(b.max[i] - b.min[i]));
        let depth = DEPTH * longest(&parts[0].bounds).min(longest(&parts[1].bounds));
        if !both.is_finite() || (0..3).any(|i| both.max[i] - both.min[i] <= depth) {
            return None;
        }
        let [Some(a), Some(b)] = parts.map(|p| p.matrix.inverse()) else {
            return None;
        };
        for k in 0..POINTS {
            // Multiples of the powers of the root of x⁴ = x + 1, modulo 1: spread evenly, the
            // middle first.
            const STEP: [f64; 3] = [
                0.819_172_513_396_164_4,
                0.671_043_606_703_789_2,
                0.549_700_477_901_970_5,
            ];
            let p: Vec3 = std::array::from_fn(|i| {
                let share = (0.5 + f64::from(k) * STEP[i]).fract();
                both.min[i] + share * (both.max[i] - both.min[i])
            });
            if self.deep([(parts[0], &a), (parts[1], &b)], p, depth) {
                self.done.insert(union);
                let parts = pair;
                let witness = p;
                return Some(Found {
                    union,
                    parts,
                    witness,
                });
            }
        }
        None
    }

    /// Whether a point, and what is around it, is in both parts, and is drawn.
    fn deep(&mut self, parts: [(&Part, &Matrix); 2], p: Vec3, depth: f64) -> bool {
        let clip = self.scene.render.and_then(|r| r.clip);
        for k in 0..7 {
            let mut q = p;
            if k > 0 {
                let i = (k - 1) / 2;
                q[i] += if k % 2 == 0 { depth } else { -depth };
            }
            if clip.is_some_and(|(min, max)| !Aabb::new(min, max).contains(q)) {
                return false;
            }
            for (part, back) in parts {
                if self.inside.node(part.node, back.point(q)) != Some(true) {
                    return false;
                }
            }
            if let Some(root) = parts[0].0.cut
                && self.inside.node(root, q) != Some(true)
            {
                return false;
            }
        }
        true
    }

    /// The union that joins two parts, if there is one.
    fn union(&mut self, parts: [&Part; 2]) -> Option<NodeId> {
        let place = |i: u32| &self.unions.places[i as usize];
        let [mut a, mut b] = parts.map(|p| p.union);
        if place(a).top != place(b).top {
            return None;
        }
        while place(a).head != place(b).head {
            self.left = self.left.checked_sub(1)?;
            if place(place(a).head).depth < place(place(b).head).depth {
                std::mem::swap(&mut a, &mut b);
            }
            a = place(place(a).head).parent;
        }
        let upper = if place(a).depth < place(b).depth {
            a
        } else {
            b
        };
        Some(place(upper).node)
    }
}
