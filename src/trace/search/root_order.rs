//! Order of two places on a ray, and of a place and the ray's start: decisions that rounding errors may spoil, with the
//! bounds that tell when.

use super::context::Leaf;
use super::events::RayPoint;
use super::query::{Scale, Start};
use super::walk::Walker;
use crate::geometry::line::Line;
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Target;
use crate::trace::precision::{Doubt, Precision};
use crate::trace::ray::{Left, Ray};
use crate::trace::shapes::{Intersect, Root, Roots};
use std::cmp::Ordering;

/// Bound on the rounding error of a crossing's point across the surface, as a share of the numbers that the point is
/// computed from. It is more than any shape needs: the campaign measures 11 units in the last place.
fn share<R: Precision>() -> R {
    R::of(256.0) * R::ROUNDOFF * coarser()
}

/// The roundoff of doubles over that of R if R is double-double; else 1. The numbers of a scene are doubles, so even in
/// double-double, crossings that are closer than the rounding of doubles are looked at.
fn coarser<R: Precision>() -> R {
    match R::DOUBT {
        Doubt::Merges => R::of(f64::ROUNDOFF) / R::ROUNDOFF,
        Doubt::Stands | Doubt::GoesOn => R::ONE,
    }
}

impl<R: Precision> Scale<R> {
    /// `reach` is the size of the line's origin and of the shape, `pace` the greatest component of the line's
    /// direction. `extent` is the size of the shape.
    pub fn new(line: &Line<R>, extent: f64) -> Scale<R> {
        let greater = |a: R, b: R| if a > b { a } else { b };
        let largest = |v: Vec3<R>| {
            let [x, y, z] = v.abs().0;
            greater(greater(x, y), z)
        };
        Scale {
            reach: largest(line.origin) + R::of(extent),
            pace: largest(line.direction),
        }
    }
}

/// A rough bound on the error of a crossing's t: the rounding error across the surface, over the speed at which the ray
/// passes through it. Curved shapes do not tell the speed. Relative to the pace it is at least the root of the relative
/// rounding error, since these shapes report slower crossings as doubtful.
pub fn rough<R: Precision>(
    shape: &dyn Intersect<R>,
    Scale { reach, pace }: Scale<R>,
    line: &Line<R>,
    root: Root<R>,
) -> R {
    let t = root.t.abs();
    let error = match shape.speed(line, root) {
        Some(speed) => {
            let slack = line.slack.origin + t * line.slack.direction;
            (share::<R>() * (reach + t * pace) + R::of(2.0) * slack * coarser()) / speed
        }
        None => {
            // The error is the root of the rounding error, and of the slack as well.
            let size = reach / pace + t;
            let slack = (line.slack.origin / pace + t * line.slack.direction / pace) * coarser();
            R::of(4.0) * (share::<R>().sqrt() * size + (slack * size).sqrt())
        }
    };
    if error.is_nan() { R::INFINITY } else { error }
}

impl<R: Precision> Walker<'_, R> {
    /// The sizes of the numbers, besides t, that the crossings of a line with a shape are computed from.
    pub(in crate::trace) fn scale(&self, line: &Line<R>, primitive: u32) -> Scale<R> {
        Scale::new(line, self.graph.extents[primitive as usize])
    }

    /// A rough bound on the error of a crossing with the shape that has been met last.
    pub(in crate::trace) fn rough(&self, line: &Line<R>, primitive: u32, root: Root<R>) -> R {
        let shape = self.graph.primitives[primitive as usize].intersect();
        rough(shape, self.scale, line, root)
    }

    /// A bound on the error of a crossing's t: the error of its point across the surface, over the speed at which the
    /// ray goes through the surface. It is doubled because the surface may bend away; a surface that bends away by more
    /// is reported as doubtful by its shape. It is 0 for a place out of the range of numbers, where the ray ends.
    pub(in crate::trace) fn error(&self, leaf: Leaf, line: &Line<R>, root: Root<R>) -> R {
        let located = self.primitive(leaf).intersect().locate(line, root);
        let point = line.at(root.t);
        if !(point.is_finite() && located.point.is_finite()) {
            return R::ZERO;
        }
        let normal = located.normal.unit();
        let step = line.direction * root.t;
        let rounded = line.origin.abs() * R::gamma(3) + step.abs() * R::gamma(3);
        let drift = line.drift(point.abs().max_component());
        let off = (point - located.point).abs() + located.error + rounded + Vec3::ONE * drift;
        let error = R::of(2.0) * normal.abs().dot(off) / normal.dot(line.direction).abs();
        if error.is_nan() { R::INFINITY } else { error }
    }

    /// The distance, in t, that a leaf's surface may be from where the scene's numbers put it: its maps are doubles,
    /// rounded where records were combined into one. Surfaces with the same chain of maps are off together. Between
    /// surfaces with other chains, a gap thinner than this is a rounding error and not meant.
    pub(in crate::trace) fn misplaced(&self, leaf: Leaf, root: Root<R>) -> R {
        let line = self.line(leaf);
        let located = self.primitive(leaf).intersect().locate(&line, root);
        let mut point: Vec3 = located.point.cast();
        let mut normal: Vec3 = located.normal.cast().unit();
        let mut error = Vec3::ZERO;
        self.climb(leaf, |_, placement| {
            let maps = &self.graph.placements[placement as usize];
            error = maps.out.point_error(point, error);
            point = maps.out.point(point);
            normal = maps.back.unit_normal(normal);
        });
        let direction: Vec3 = self.contexts[0].line.direction.cast();
        let off = normal.abs().dot(error) / normal.dot(direction).abs();
        let placed = point.is_finite() && !off.is_nan();
        R::of(if placed { off } else { 0.0 })
    }

    /// The order of two crossings. Crossings of one surface are equal, and so are crossings that cannot be told apart
    /// in the finest numbers.
    pub(in crate::trace) fn order(&mut self, a: &RayPoint<R>, b: &RayPoint<R>) -> Ordering {
        let (s, t) = (a.root.t, b.root.t);
        let rounded = s.partial_cmp(&t).unwrap_or(Ordering::Equal);
        let gap = (s - t).abs();
        if gap > a.error + b.error {
            return rounded;
        }
        if gap == R::ZERO && self.surface(a.leaf) == self.surface(b.leaf) {
            return Ordering::Equal;
        }
        if self.in_one_place(a, b) {
            return Ordering::Equal;
        }
        let placed = match self.chain(a.leaf) == self.chain(b.leaf) {
            true => R::ZERO,
            false => self.misplaced(a.leaf, a.root) + self.misplaced(b.leaf, b.root),
        };
        let error = self.error(a.leaf, &self.line(a.leaf), a.root)
            + self.error(b.leaf, &self.line(b.leaf), b.root);
        if gap <= error + placed && self.doubt() {
            return Ordering::Equal;
        }
        rounded
    }

    /// Whether a crossing cannot be told from a known place on the ray.
    #[inline]
    fn is_at(&self, leaf: Leaf, line: &Line<R>, root: Root<R>, place: &Start<R>) -> bool {
        if !self.is_near(leaf, line, root, place.t) {
            return false;
        }
        if self.goes_on(leaf, line, root, place.passage) {
            return true;
        }
        let gap = (root.t - place.t).abs();
        let placed = match place.chain {
            Some((chain, misplaced)) if chain != self.chain(leaf) => {
                misplaced + self.misplaced(leaf, root)
            }
            _ => R::ZERO,
        };
        gap <= self.error(leaf, line, root) + place.error + placed
    }

    /// Whether rounding may affect the order of a crossing and a place on the ray, given by its t. The crossing must be
    /// with the shape that has been met last.
    fn is_near(&self, leaf: Leaf, line: &Line<R>, root: Root<R>, place: R) -> bool {
        match self.part(leaf.part).target {
            Target::Shape(primitive) => (root.t - place).abs() <= self.rough(line, primitive, root),
            Target::Object(_) => false,
        }
    }

    /// The number of a leaf's crossings that lie before the ray's start, which is at `from`.
    pub(in crate::trace) fn behind(
        &mut self,
        ray: &Ray<R>,
        leaf: Leaf,
        line: &Line<R>,
        roots: &Roots<R>,
        from: R,
    ) -> usize {
        let passed = roots.list.partition_point(|r| r.t <= from);
        let Some(left) = ray.left.filter(|_| from <= R::ZERO) else {
            let exact = Start::exact(from);
            return self.before_place(leaf, line, &roots.list, passed, &exact);
        };
        if self.surface(leaf) == left.surface {
            let solid = self.primitive(leaf).is_solid();
            let Some(behind) = before_left(roots, left.entering, solid) else {
                return passed;
            };
            if R::DOUBT == Doubt::Merges {
                let root = roots.list[behind - 1];
                self.status.start = Some(Start {
                    t: root.t,
                    error: self.error(leaf, line, root),
                    chain: Some((self.chain(leaf), self.misplaced(leaf, root))),
                    passage: left.passage,
                });
            }
            return behind;
        }
        match self.start {
            Some(start) => {
                let passed = roots.list.partition_point(|r| r.t <= start.t);
                self.before_place(leaf, line, &roots.list, passed, &start)
            }
            None => self.before_skin(leaf, line, &roots.list, passed, &left),
        }
    }

    /// The number of crossings before a known place. Crossings that cannot be told from the place count as before it.
    /// `passed` is the number of crossings up to the place by their rounded t.
    fn before_place(
        &mut self,
        leaf: Leaf,
        line: &Line<R>,
        roots: &[Root<R>],
        passed: usize,
        place: &Start<R>,
    ) -> usize {
        let mut behind = passed;
        if passed > 0 && self.is_at(leaf, line, roots[passed - 1], place) {
            self.doubt();
        }
        while let Some(&root) = roots.get(behind) {
            if !(self.is_at(leaf, line, root, place) && self.doubt()) {
                break;
            }
            behind += 1;
        }
        behind
    }

    /// The number of crossings behind the start of a ray that starts on another shape. `passed` is the number up to the
    /// start by their rounded t. Crossings after those count as behind if they are the starting point or cannot be told
    /// from it.
    ///
    /// A surface at distance h from the starting point, measured along the surface's normal n, is met at t = h / |n·d|;
    /// the starting point itself is known up to the skin.
    fn before_skin(
        &mut self,
        leaf: Leaf,
        line: &Line<R>,
        roots: &[Root<R>],
        passed: usize,
        left: &Left<R>,
    ) -> usize {
        // If the ray is flatter than √u to a surface, half of the digits of n·d are noise and the distance h says
        // nothing. So the t of a crossing beyond this distance is believed, unless the crossing's own error reaches the
        // start.
        let farthest = left.skin / R::ROUNDOFF.sqrt();
        let direction = self.contexts[0].line.direction;
        let length = direction.length();
        let near = |walker: &Self, root: Root<R>| {
            root.t.abs() * length <= farthest || walker.is_near(leaf, line, root, R::ZERO)
        };
        // A face in the surface that the ray leaves is met at the start and nowhere else.
        let goes_on = |walker: &Self, root| walker.goes_on(leaf, line, root, left.passage);
        let within = |walker: &Self, root: Root<R>| {
            let steep = walker.world_normal(leaf, line, root).dot(direction).abs();
            let error = walker.error(leaf, line, root) + walker.misplaced(leaf, root);
            root.t.abs() * steep <= left.skin + error * steep
        };
        let mut behind = passed;
        let mut met = passed > 0 && {
            let root = roots[passed - 1];
            near(self, root) && !goes_on(self, root) && within(self, root)
        };
        while let Some(&root) = roots.get(behind).filter(|&&root| near(self, root)) {
            debug_assert!(root.t.is_finite());
            if !goes_on(self, root) {
                if !within(self, root) {
                    break;
                }
                met = true;
            }
            behind += 1;
        }
        if met {
            self.status.skin_met = true;
            self.doubt();
        }
        behind
    }

    /// The unit normal at a root, outwards, in the scene's space.
    fn world_normal(&self, leaf: Leaf, line: &Line<R>, root: Root<R>) -> Vec3<R> {
        let mut normal = self.primitive(leaf).intersect().locate(line, root).normal;
        self.climb(leaf, |_, placement| {
            normal = R::back(&self.maps, self.graph, placement).unit_normal(normal);
        });
        normal.unit()
    }
}

/// The number of roots up to the starting point, for a ray that starts on the surface itself. The starting point is the
/// root nearest to the origin among those that cross in the right sense; `None` if there are none.
pub fn before_left<R: Precision>(roots: &Roots<R>, entering: bool, solid: bool) -> Option<usize> {
    let fits = |i: usize| !solid || (roots.inside == (i % 2 == 1)) == entering;
    let distance = |i: usize| roots.list[i].t.abs();
    (0..roots.list.len())
        .filter(|&i| fits(i))
        .min_by(|&i, &j| {
            distance(i)
                .partial_cmp(&distance(j))
                .unwrap_or(Ordering::Equal)
        })
        .map(|i| i + 1)
}
