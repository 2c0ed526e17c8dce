//! Parts that overlap.

use rustc_hash::FxHashSet;

use super::medium::texture;
use super::unions::{Part, Unions};
use crate::lint::solids::boxes::Boxes;
use crate::lint::solids::inside::Inside;
use crate::scene::bounds::NodeBounds;
use crate::scene::{Aabb, Matrix, NodeId, Scene, Vec3};

/// Boxes looked at and points tried, for all parts together: some tenths of a second.
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
    /// Whether they are opaque, and cut open at the point.
    pub(super) open: bool,
}

pub(super) struct Search<'a> {
    scene: &'a Scene,
    unions: &'a Unions,
    inside: Inside<'a>,
    left: usize,
    /// Unions that have been spoken of.
    done: FxHashSet<NodeId>,
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
            done: FxHashSet::default(),
        }
    }

    pub(super) fn all(&mut self) -> Vec<Found> {
        let unions = self.unions;
        let transmits = |p: &Part| unions.media[p.medium as usize].transmits();
        let concerns = |p: &Part| p.opened || transmits(p) && unions.media.len() > 1;
        if !unions.parts.iter().any(concerns) {
            return Vec::new();
        }
        let parts = unions.parts.iter().enumerate();
        let boxes = Boxes::new(parts.map(|(i, p)| (i as u32, p.bounds)));
        let mut found = Vec::new();
        for (i, part) in unions.parts.iter().enumerate() {
            if !concerns(part) {
                continue;
            }
            let i = i as u32;
            let mut near = Vec::new();
            let steps = match part.bounds.is_finite() {
                true => boxes.near(&part.bounds, &mut near),
                // Two without end: no place to look at.
                false => boxes.near_finite(&part.bounds, &mut near),
            };
            match self.left.checked_sub(steps + near.len() + 1) {
                Some(left) => self.left = left,
                None => break,
            }
            near.retain(|&j| unions.parts[j as usize].bounds.overlaps(&part.bounds));
            for j in near {
                let other = &unions.parts[j as usize];
                // Each pair once.
                let opaque = !transmits(part) && !transmits(other);
                let turn = match (transmits(part), transmits(other)) {
                    (true, true) => i < j || !other.bounds.is_finite(),
                    (false, false) => i < j && part.opened && other.opened,
                    (one, _) => one,
                };
                let differ = match opaque {
                    true => self.look_different(part, other),
                    false => part.medium != other.medium,
                };
                if !turn || !differ {
                    continue;
                }
                let Some(left) = self.left.checked_sub(POINTS as usize) else {
                    return found;
                };
                self.left = left;
                found.extend(self.pair([i.min(j), i.max(j)], opaque));
            }
        }
        found
    }

    /// Whether two opaque parts differ in colour or in optical property, as far as that is known.
    fn look_different(&self, one: &Part, two: &Part) -> bool {
        let optics = |p: &Part| self.unions.media[p.medium as usize].optics;
        let [Some(a), Some(b)] =
            [one, two].map(|p| p.colouring.and_then(|c| texture(self.scene, c)))
        else {
            return false;
        };
        optics(one) != optics(two) || a != b
    }

    fn pair(&mut self, pair: [u32; 2], opaque: bool) -> Option<Found> {
        let parts = pair.map(|i| &self.unions.parts[i as usize]);
        let place = self.unions.ways.join(parts[0].union, parts[1].union)?;
        let union = self.unions.places[place as usize];
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
        let both_parts = [(parts[0], &a), (parts[1], &b)];
        let mut halves = [None, None];
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
            let witness = match opaque {
                false => self.deep(both_parts, p, depth, true).then_some(p),
                true => self.opened(both_parts, p, depth, &mut halves),
            };
            if let Some(witness) = witness {
                self.done.insert(union);
                return Some(Found {
                    union,
                    parts: pair,
                    witness,
                    open: opaque,
                });
            }
        }
        None
    }

    /// A point of both parts at which something cuts, between one more point of both and the ones
    /// before: `halves` are a point that is left and one that is cut off.
    fn opened(
        &mut self,
        parts: [(&Part, &Matrix); 2],
        p: Vec3,
        depth: f64,
        halves: &mut [Option<Vec3>; 2],
    ) -> Option<Vec3> {
        /// So often is the way between two points halved.
        const HALVINGS: u32 = 40;
        let root = parts[0].0.cut?;
        if !self.deep(parts, p, depth, false) {
            return None;
        }
        match self.inside.node(root, p)? {
            true => halves[0] = Some(p),
            false => halves[1] = Some(p),
        }
        let [Some(mut left), Some(mut off)] = *halves else {
            return None;
        };
        let middle = |a: Vec3, b: Vec3| -> Vec3 { std::array::from_fn(|i| (a[i] + b[i]) / 2.0) };
        for _ in 0..HALVINGS {
            let between = middle(left, off);
            match self.inside.node(root, between)? {
                true => left = between,
                false => off = between,
            }
        }
        // Parts need not be convex.
        let cut = middle(left, off);
        (self.deep(parts, cut, depth, false)).then_some(cut)
    }

    /// Whether a point, and what is around it, is in both parts and in the box of the render record,
    /// and, if asked for, left by whatever cuts.
    fn deep(&mut self, parts: [(&Part, &Matrix); 2], p: Vec3, depth: f64, left: bool) -> bool {
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
            if let Some(root) = parts[0].0.cut.filter(|_| left)
                && self.inside.node(root, q) != Some(true)
            {
                return false;
            }
        }
        true
    }
}
