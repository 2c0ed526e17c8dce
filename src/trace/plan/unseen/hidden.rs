//! Parts that lie strictly inside a solid which lets no light through.
//!
//! The solid hides the parts inside only if no ray gets in. The first operand of a union owns a point, and its surface
//! is the one that is seen: a ray can pass into an opaque solid from within glass that reaches into it or touches it,
//! and from there into any solid that the opaque one touches. So opaque solids that touch stand and fall together. A
//! group of them is closed if
//!
//! - no ray of a camera starts in one of them, and the region that is drawn cuts none of them open;
//! - whatever else touches one of them lies strictly inside one of them, or is an opaque surface.
//!
//! Any ray that comes from outside then meets, where it first enters the group, the surface of one of its solids and
//! nothing else: it ends there. Whether parts touch is decided by their boxes. Only convex shapes are known to hold
//! anything. The work is bounded: of very many opaque shapes only the largest are looked at, and groups that are too
//! large count as open.

use super::members::Member;
use super::starts::Starts;
use crate::geometry::Aabb;
use crate::geometry::boxes::Boxes;
use crate::parallel;
use crate::scene::{Geometry, Scene};
use crate::solids::shapes::facts::Facts;
use crate::solids::within::{CLEARANCE_REL, PlacedShape};
use rustc_hash::FxHashMap;

/// The most opaque shapes that are tested for what they hold: the largest ones.
const MAX_HOLDERS: usize = 4096;

/// The most comparisons of boxes, in each of the two searches. They take some hundredths of a second.
const MAX_STEPS: usize = 4_000_000;

/// The most tests of whether a part lies in a shape, for all parts together.
const MAX_PROOFS: usize = 200_000;

/// The number of parts whose surroundings all threads together look for at a time.
const BATCH: usize = 1024;

pub(super) struct Hidden<'a, F: Fn(&Member) -> bool> {
    scene: &'a Scene,
    all: &'a [Member],
    starts: &'a Starts,
    /// Whether the region that is drawn cuts nothing off a part.
    whole: F,
    /// For each part that lies strictly inside of another, the index of that other part.
    holders: FxHashMap<u32, u32>,
    steps: usize,
    /// The share by which balls are taken to be smaller.
    less: f64,
}

impl<'a, F: Fn(&Member) -> bool> Hidden<'a, F> {
    /// The parts among `left` that are hidden, ascending, each with a part that it lies in. Balls are taken to be
    /// smaller by the share `less`, so that things which they touch in a single point do not count.
    pub(super) fn find(
        scene: &'a Scene,
        (all, left): (&'a [Member], &[u32]),
        starts: &'a Starts,
        whole: F,
        less: f64,
    ) -> Vec<(u32, u32)> {
        let mut hidden = Hidden {
            scene,
            all,
            starts,
            whole,
            holders: FxHashMap::default(),
            steps: MAX_STEPS,
            less,
        };
        hidden.hold(left);
        if hidden.holders.is_empty() {
            return Vec::new();
        }
        let closed = hidden.closed(left);
        let mut out: Vec<(u32, u32)> = hidden.holders.into_iter().collect();
        out.retain(|(_, holder)| closed.get(holder) == Some(&true));
        out.sort_unstable();
        out
    }

    /// The share by which balls are taken to be smaller beside a part. The flat faces of half-spaces and boxes touch a
    /// ball in a single point. Beside other shapes the share is 0, since another ball may touch in more: it may be the
    /// same ball.
    fn less_beside(&self, i: u32) -> f64 {
        match self.all[i as usize].geometry(self.scene) {
            Some(Geometry::HalfSpace { .. } | Geometry::Box { .. }) => self.less,
            _ => 0.0,
        }
    }

    fn standing(&self, i: u32) -> Option<PlacedShape<'a>> {
        let member = &self.all[i as usize];
        PlacedShape::new(member.geometry(self.scene)?, *member.matrix())
    }

    /// Finds parts that lie strictly inside of an opaque shape, and notes their holders.
    fn hold(&mut self, left: &[u32]) {
        let (scene, all, less) = (self.scene, self.all, self.less);
        let opaque = |&i: &u32| {
            let member = &all[i as usize];
            let geometry = member.geometry(scene);
            !member.clear && geometry.is_some_and(Facts::is_convex) && !member.bounds.is_empty()
        };
        let sized = |&i: &u32| match &all[i as usize].bounds {
            b if b.is_finite() => (b.radius(), i),
            _ => (f64::INFINITY, i),
        };
        let mut holders: Vec<(f64, u32)> = left.iter().filter(|i| opaque(i)).map(sized).collect();
        holders.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        holders.truncate(MAX_HOLDERS);
        // A shape is placed when it is first needed; the inner `None` stands for one that cannot hide anything.
        let mut standing: Vec<Option<Option<PlacedShape>>> = holders.iter().map(|_| None).collect();
        let numbered = (0u32..).zip(&holders);
        let boxes = Boxes::new(numbered.map(|(k, h)| (k, all[h.1 as usize].bounds)));
        // The shapes whose boxes hold the box of a part, and the number of steps of the search for them.
        let around = |i: u32| {
            let bounds = all[i as usize].bounds_less(scene, less);
            let mut near = Vec::new();
            if !bounds.is_finite() || bounds.is_empty() {
                return (near, 0);
            }
            let centre = bounds.centre();
            let steps = boxes.near(&Aabb::new(centre, centre), &mut near) + near.len();
            near.retain(|&k| {
                let holder = holders[k as usize].1;
                holder != i && all[holder as usize].bounds.holds(&bounds)
            });
            // Smaller numbers are larger shapes, which are tried first.
            near.sort_unstable();
            (near, steps)
        };
        let mut proofs = MAX_PROOFS;
        for batch in left.chunks(BATCH) {
            let found = parallel::map(batch.len(), |k| around(batch[k]));
            for (&i, (near, steps)) in batch.iter().zip(found) {
                match self.steps.checked_sub(steps) {
                    Some(rest) => self.steps = rest,
                    None => return,
                }
                let member = &all[i as usize];
                for k in near {
                    let holder = holders[k as usize].1;
                    let known = &mut standing[k as usize];
                    if known.is_none() {
                        *known = Some(self.standing(holder).filter(|s| self.is_dark(holder, s)));
                    }
                    let Some(Some(standing)) = known else {
                        continue;
                    };
                    match proofs.checked_sub(1) {
                        Some(rest) => proofs = rest,
                        None => return,
                    }
                    let less = self.less_beside(holder);
                    let bounds = member.bounds_less(scene, less);
                    let matrix = member.matrix_less(scene, less);
                    let shape = member.geometry(scene).map(|g| (g, &matrix));
                    if standing.holds(&bounds, shape) {
                        self.holders.insert(i, holder);
                        break;
                    }
                }
            }
        }
    }

    /// Whether no camera and no lamp is in an opaque shape, and the region that is drawn does not cut the shape open.
    fn is_dark(&self, i: u32, standing: &PlacedShape) -> bool {
        let member = &self.all[i as usize];
        (self.whole)(member)
            && self.starts.are_clear_of(&member.bounds, Some(standing))
            && (self.scene.point_lights.iter()).all(|l| standing.is_clear_of(l.position))
    }

    /// For each part that holds something, and for all opaque parts that are connected with these: whether no ray gets
    /// in.
    fn closed(&mut self, left: &[u32]) -> FxHashMap<u32, bool> {
        self.steps = MAX_STEPS;
        let boxes = Boxes::new(left.iter().map(|&i| (i, self.all[i as usize].bounds)));
        let mut first: Vec<u32> = self.holders.values().copied().collect();
        first.sort_unstable();
        first.dedup();
        let mut groups: FxHashMap<u32, usize> = FxHashMap::default();
        let mut closed: Vec<bool> = Vec::new();
        for i in first {
            if groups.contains_key(&i) {
                continue;
            }
            let group = closed.len();
            groups.insert(i, group);
            let mut todo = vec![i];
            let mut is_closed = true;
            while let (true, Some(i)) = (is_closed, todo.pop()) {
                let Some(others) = self.around(i, &boxes) else {
                    is_closed = false;
                    break;
                };
                for other in others {
                    match groups.get(&other) {
                        None => {
                            groups.insert(other, group);
                            todo.push(other);
                        }
                        // The other group has not reached this one, so it is open and was given up early; this one is
                        // open, too.
                        Some(&known) => is_closed &= known == group,
                    }
                }
            }
            closed.push(is_closed);
        }
        groups
            .into_iter()
            .map(|(i, group)| (i, closed[group]))
            .collect()
    }

    /// The opaque solids that touch a part; `None` if a ray may get into the part, or no steps are left.
    fn around(&mut self, i: u32, boxes: &Boxes) -> Option<Vec<u32>> {
        let member = &self.all[i as usize];
        let standing = self.standing(i);
        let open =
            !(self.whole)(member) || !self.starts.are_clear_of(&member.bounds, standing.as_ref());
        let mut near = Vec::new();
        let steps = boxes.near(&grown(&member.bounds), &mut near) + near.len();
        self.steps = self.steps.saturating_sub(steps);
        if open || self.steps == 0 {
            return None;
        }
        let mut out = Vec::new();
        let less = self.less_beside(i);
        for other in near {
            let thing = &self.all[other as usize];
            if other == i
                || self.holders.get(&other) == Some(&i)
                || !thing.bounds_less(self.scene, less).touches(&member.bounds)
            {
                continue;
            }
            match (thing.clear, thing.sheet) {
                (false, false) => out.push(other),
                (false, true) => {}
                // The part that holds this transparent part touches part `i`, too, so nothing is lost.
                (true, _) if self.holders.contains_key(&other) => {}
                (true, _) => return None,
            }
        }
        Some(out)
    }
}

/// A box that is larger by more than rounding errors, so that it meets all boxes that may touch it.
fn grown(b: &Aabb) -> Aabb {
    let hair = 4.0 * CLEARANCE_REL * b.far();
    Aabb::new(b.min.map(|x| x - hair), b.max.map(|x| x + hair))
}
