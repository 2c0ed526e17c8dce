//! The search for parts of unions that overlap.

use rustc_hash::FxHashSet;

use super::medium::texture;
use super::unions::{UnionOperand, Unions};
use crate::geometry::array::length;
use crate::geometry::boxes::Boxes;
use crate::geometry::{Aabb, Matrix};
use crate::lint::spelling::near;
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;
use crate::solids::distance_field::Field;
use crate::solids::inside::Inside;
use crate::solids::lowest::lowest;
use crate::solids::shapes::AnyShape;
use crate::solids::shapes::quadric::Quadric;

/// Most boxes examined and points tried, for all parts together: some tenths of a second.
const MAX_STEPS: usize = 10_000_000;

/// Number of points that are tried for a pair of parts with overlapping boxes.
const POINTS_PER_PAIR: u32 = 24;

/// Least depth of a point inside of both parts, as a share of the size of the smaller part. Parts that overlap by less
/// are meant to touch, and written with six or seven digits.
pub(super) const MIN_REL_DEPTH: f64 = 1e-6;

/// Most steps of the closer look at one pair for which no point was found.
const MAX_CLOSE_LOOK_STEPS: usize = 40_000;
/// Most steps of closer looks at all pairs together: some tenths of a second.
const MAX_CLOSE_LOOK_STEPS_IN_ALL: usize = 6_000_000;

/// Most pairs that are remembered for a closer look.
const MAX_PAIRS_REMEMBERED: usize = 100_000;
/// Most pairs of two endless parts that get a closer look.
const MAX_ENDLESS_PAIRS: usize = 2_000;

/// Two parts that overlap.
pub(super) struct Overlap {
    /// The innermost union that has both parts.
    pub(super) union: NodeId,
    /// Indices of the parts, in the order of the operands.
    pub(super) parts: [u32; 2],
    /// A point inside of both parts, in the coordinates of the scene, with as many digits as it takes to be inside of
    /// both.
    pub(super) witness: [String; 3],
    /// Whether the parts are opaque, and cut open at the point.
    pub(super) open: bool,
}

pub(super) struct Search<'a> {
    scene: &'a Scene,
    unions: &'a Unions,
    inside: Inside<'a>,
    left: usize,
    /// The unions that have a finding already.
    done: FxHashSet<NodeId>,
    bounds: &'a [NodeBounds],
    /// Steps that are left for closer looks.
    close: usize,
    /// Pairs whose first part lies within the second.
    nested: FxHashSet<[u32; 2]>,
}

/// The indices of two parts, and whether both are opaque.
type Pair = ([u32; 2], bool);

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
            left: MAX_STEPS,
            done: FxHashSet::default(),
            bounds,
            close: MAX_CLOSE_LOOK_STEPS_IN_ALL,
            nested: FxHashSet::default(),
        }
    }

    pub(super) fn all(&mut self) -> Vec<Overlap> {
        let unions = self.unions;
        let transmits = |p: &UnionOperand| unions.media[p.medium as usize].transmits();
        let concerns = |p: &UnionOperand| p.opened || transmits(p) && unions.media.len() > 1;
        if !unions.parts.iter().any(concerns) {
            return Vec::new();
        }
        let parts = unions.parts.iter().enumerate();
        let boxes = Boxes::new(parts.map(|(i, p)| (i as u32, p.bounds)));
        let mut found = Vec::new();
        let mut rest: Vec<Pair> = Vec::new();
        'parts: for (i, part) in unions.parts.iter().enumerate() {
            if !concerns(part) {
                continue;
            }
            let i = i as u32;
            let mut near = Vec::new();
            let steps = match part.bounds.is_finite() {
                true => boxes.near(&part.bounds, &mut near),
                // Pairs of two endless parts come later.
                false => boxes.near_finite(&part.bounds, &mut near),
            };
            match self.left.checked_sub(steps + near.len() + 1) {
                Some(left) => self.left = left,
                None => break,
            }
            near.retain(|&j| unions.parts[j as usize].bounds.overlaps(&part.bounds));
            for j in near {
                let Some(pair) = self.differ(i, j) else {
                    continue;
                };
                let Some(left) = self.left.checked_sub(POINTS_PER_PAIR as usize) else {
                    break 'parts;
                };
                self.left = left;
                match self.pair(pair) {
                    Some(one) => found.push(one),
                    None if rest.len() < MAX_PAIRS_REMEMBERED => rest.push(pair),
                    None => {}
                }
            }
        }
        let endless = |i: &u32| !unions.parts[*i as usize].bounds.is_finite();
        let endless: Vec<u32> = (0..unions.parts.len() as u32).filter(endless).collect();
        let pairs = (endless.iter()).flat_map(|&i| endless.iter().map(move |&j| (i, j)));
        let pairs = pairs.filter(|(i, j)| i < j).take(MAX_ENDLESS_PAIRS);
        rest.extend(pairs.filter_map(|(i, j)| self.differ(i, j).or_else(|| self.differ(j, i))));
        for pair in rest {
            found.extend(self.closely(pair));
        }
        found
    }

    /// The pair of the parts `i` and `j`, if the picture depends on their order. `None` if it does not, or if the pair
    /// comes up as `j` and `i`.
    fn differ(&self, i: u32, j: u32) -> Option<Pair> {
        let unions = self.unions;
        let transmits = |p: &UnionOperand| unions.media[p.medium as usize].transmits();
        let (part, other) = (&unions.parts[i as usize], &unions.parts[j as usize]);
        // Of the two orders in which a pair comes up, only one counts.
        let opaque = !transmits(part) && !transmits(other);
        let turn = match (transmits(part), transmits(other)) {
            (true, true) => i < j || part.bounds.is_finite() && !other.bounds.is_finite(),
            (false, false) => i < j && part.opened && other.opened,
            (one, _) => one,
        };
        let differ = match opaque {
            true => self.look_different(part, other),
            false => part.medium != other.medium,
        };
        (turn && differ).then_some(([i.min(j), i.max(j)], opaque))
    }

    /// Whether two opaque parts differ in colour or in optical property, as far as that is known.
    fn look_different(&self, one: &UnionOperand, two: &UnionOperand) -> bool {
        let optics = |p: &UnionOperand| self.unions.media[p.medium as usize].optics;
        let [Some(a), Some(b)] =
            [one, two].map(|p| p.colouring.and_then(|c| texture(self.scene, c)))
        else {
            return false;
        };
        optics(one) != optics(two) || a != b
    }

    /// The innermost union of two parts; `None` if a finding names that union already.
    fn union(&self, parts: [&UnionOperand; 2]) -> Option<NodeId> {
        let place = self.unions.ancestry.join(parts[0].union, parts[1].union)?;
        let union = self.unions.places[place as usize];
        (!self.done.contains(&union)).then_some(union)
    }

    fn pair(&mut self, (pair, opaque): Pair) -> Option<Overlap> {
        let parts = pair.map(|i| &self.unions.parts[i as usize]);
        let union = self.union(parts)?;
        let both = parts[0].bounds.intersection(&parts[1].bounds);
        let longest = |b: &Aabb| (0..3).fold(0.0f64, |m, i| m.max(b.max[i] - b.min[i]));
        let depth = MIN_REL_DEPTH * longest(&parts[0].bounds).min(longest(&parts[1].bounds));
        if !both.is_finite() || (0..3).any(|i| both.max[i] - both.min[i] <= depth) {
            return None;
        }
        let [Some(a), Some(b)] = parts.map(|p| p.matrix.inverse()) else {
            return None;
        };
        let both_parts = [(parts[0], &a), (parts[1], &b)];
        let mut halves = [None, None];
        for k in 0..POINTS_PER_PAIR {
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
                return self.found(union, (pair, opaque), both_parts, witness, (&both, depth));
            }
        }
        None
    }

    fn found(
        &mut self,
        union: NodeId,
        (parts, open): Pair,
        both_parts: [(&UnionOperand, &Matrix); 2],
        witness: Vec3,
        (within, depth): (&Aabb, f64),
    ) -> Option<Overlap> {
        /// Most powers of ten by which the digits of the point become finer: an overlap of less than a millionth is not
        /// reported.
        const FINER: usize = 7;
        if self.is_nested((parts, open), both_parts, (within, depth)) {
            self.nested.insert(parts);
            return None;
        }
        self.done.insert(union);
        let sides = (0..3).map(|i| within.max[i] - within.min[i]);
        let size = sides.fold(f64::INFINITY, f64::min);
        let told = |k: usize| witness.map(|x| near(x, size / 10f64.powi(k as i32)));
        let holds = |k: &usize| {
            let number = |x: String| x.parse().unwrap_or(f64::NAN);
            self.deep(both_parts, told(*k).map(number), depth, !open)
        };
        Some(Overlap {
            union,
            parts,
            witness: told((0..FINER).find(holds).unwrap_or(FINER)),
            open,
        })
    }

    /// Whether the first of two parts lies within the second, and the second is larger. This order is meant: the first
    /// part owns all of itself, and the second what is around it. The other order would leave nothing of the inner
    /// part.
    fn is_nested(
        &mut self,
        (pair, open): Pair,
        both_parts: [(&UnionOperand, &Matrix); 2],
        within: (&Aabb, f64),
    ) -> bool {
        let [one, two] = both_parts;
        let [i, j] = pair;
        self.reaches_out(([i, j], open), [one, two], within) == Some(false)
            && self.reaches_out(([j, i], open), [two, one], within) == Some(true)
    }

    /// Whether a point of the first part is found that is outside of the second by `depth`. `None` if the search is not
    /// possible, or no steps are left.
    fn reaches_out(
        &mut self,
        (pair, open): Pair,
        both_parts: [(&UnionOperand, &Matrix); 2],
        (both, depth): (&Aabb, f64),
    ) -> Option<bool> {
        let [inner, outer] = pair.map(|i| &self.unions.parts[i as usize]);
        let mut within = match (inner.bounds.is_finite(), outer.bounds.is_finite()) {
            (true, _) => inner.bounds,
            (false, true) => return Some(true),
            (false, false) => *both,
        };
        if let Some((min, max)) = self.scene.render.and_then(|r| r.clip) {
            within = within.intersection(&Aabb::new(min, max));
        }
        let fields = [inner, outer].map(|part| Field::new(self.scene, part.node, &part.matrix));
        let [Some(mut one), Some(mut two)] = fields else {
            return None;
        };
        let cut = inner.cut.filter(|_| !open);
        let mut left = cut.and_then(|root| Field::new(self.scene, root, &Matrix::IDENTITY));
        let cost = one.cost + two.cost + left.as_ref().map_or(0, |f| f.cost);
        let share = MAX_CLOSE_LOOK_STEPS.min(self.close) / cost.max(1);
        if share == 0 {
            return None;
        }
        let mut points = share;
        let slopes = |p: Vec3| {
            let (a, b) = (one.at(p), two.at(p).turned());
            match left.as_mut().map(|left| left.at(p)) {
                Some(c) => [a.both(c), b],
                None => [a, b],
            }
        };
        let out = |p: Vec3| self.sticks_out(both_parts, p, depth, !open);
        let witness = lowest(&within, depth, &mut points, slopes, out);
        self.close = self.close.saturating_sub(cost * (share - points));
        Some(witness.is_some())
    }

    /// A closer look at a pair of parts that overlap by little or are both endless. `None` if no common point is found.
    fn closely(&mut self, (pair, opaque): Pair) -> Option<Overlap> {
        let parts = pair.map(|i| &self.unions.parts[i as usize]);
        let union = (self.union(parts)).filter(|_| !opaque && !self.nested.contains(&pair))?;
        let mut within = parts[0].bounds.intersection(&parts[1].bounds);
        if parts.iter().all(|p| !p.bounds.is_finite()) {
            let [a, b] = parts.map(|p| self.anchor(p));
            within = within.intersection(&a.hull(&b));
        }
        if let Some((min, max)) = self.scene.render.and_then(|r| r.clip) {
            within = within.intersection(&Aabb::new(min, max));
        }
        if within.is_empty() || !within.is_finite() {
            return None;
        }
        let size = |b: &Aabb| {
            let b = if b.is_finite() { b } else { &within };
            (0..3).fold(0.0f64, |m, i| m.max(b.max[i] - b.min[i]))
        };
        let depth = MIN_REL_DEPTH * size(&parts[0].bounds).min(size(&parts[1].bounds));
        if (0..3).any(|i| within.max[i] - within.min[i] <= depth) {
            return None;
        }
        let [Some(a), Some(b)] = parts.map(|p| p.matrix.inverse()) else {
            return None;
        };
        let both_parts = [(parts[0], &a), (parts[1], &b)];
        let [mut one, mut two] = [
            Field::new(self.scene, parts[0].node, &parts[0].matrix)?,
            Field::new(self.scene, parts[1].node, &parts[1].matrix)?,
        ];
        // The object that the cut leaves, if something cuts the parts.
        let cut = parts[0].cut;
        let mut left = cut.and_then(|root| Field::new(self.scene, root, &Matrix::IDENTITY));
        let cost = one.cost + two.cost + left.as_ref().map_or(0, |f| f.cost);
        let share = MAX_CLOSE_LOOK_STEPS.min(self.close) / cost.max(1);
        let mut points = share;
        let slopes = |p: Vec3| {
            let [a, b] = [one.at(p), two.at(p)];
            let Some(c) = left.as_mut().map(|left| left.at(p)) else {
                return [a, b];
            };
            // The search takes two slopes: the larger two of the three count.
            match a.distance < b.distance {
                true => [a.both(c), b],
                false => [a, b.both(c)],
            }
        };
        let deep = |p: Vec3| self.deep(both_parts, p, depth, true);
        let witness = lowest(&within, depth, &mut points, slopes, deep);
        self.close = self.close.saturating_sub(cost * (share - points));
        self.found(
            union,
            (pair, opaque),
            both_parts,
            witness?,
            (&within, depth),
        )
    }

    /// The box in which to look for a part: its bounds, or for an endless shape a box around its own origin, several
    /// times its size.
    fn anchor(&self, part: &UnionOperand) -> Aabb {
        const TIMES: f64 = 4.0;
        let bounded = self.bounds[part.node as usize].bounded();
        if !bounded.is_empty() {
            return bounded.transformed(&part.matrix);
        }
        let scene = self.scene;
        let (core, matrix) = scene.core(part.node, part.matrix);
        let geometry = match scene.nodes[core as usize] {
            Node::Shape(s) => Some(&scene.shapes[s as usize].geometry),
            _ => None,
        };
        let (middle, size) = geometry.map_or(([0.0; 3], 1.0), Geometry::home);
        let reach = TIMES * size;
        let around = Aabb::new(middle.map(|x| x - reach), middle.map(|x| x + reach));
        around.transformed(&matrix)
    }

    /// Searches for a point inside of both parts on a cut, between the new point `p` and an earlier one. `halves` keeps
    /// two points inside of both parts: one that the cut leaves, and one that it takes away.
    fn opened(
        &mut self,
        parts: [(&UnionOperand, &Matrix); 2],
        p: Vec3,
        depth: f64,
        halves: &mut [Option<Vec3>; 2],
    ) -> Option<Vec3> {
        /// Number of times that the way between the two points is halved.
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
        // The parts need not be convex, so the point on the cut may be outside of them.
        let cut = middle(left, off);
        (self.deep(parts, cut, depth, false)).then_some(cut)
    }

    /// Whether a point, and the points around it at the distance `depth`, are in both parts and in the box of the
    /// render record. With `left`, no cut may take them away.
    fn deep(
        &mut self,
        parts: [(&UnionOperand, &Matrix); 2],
        p: Vec3,
        depth: f64,
        left: bool,
    ) -> bool {
        self.holds([(parts[0], true), (parts[1], true)], p, depth, left)
    }

    /// Like `deep`, for a point in the first part and outside of the second.
    fn sticks_out(
        &mut self,
        parts: [(&UnionOperand, &Matrix); 2],
        p: Vec3,
        depth: f64,
        left: bool,
    ) -> bool {
        self.holds([(parts[0], true), (parts[1], false)], p, depth, left)
    }

    /// Whether a point, and the points around it at the distance `depth`, are in each part with the flag `true`,
    /// outside of each part with `false`, and in the box of the render record. With `left`, no cut may take them away.
    fn holds(
        &mut self,
        parts: [((&UnionOperand, &Matrix), bool); 2],
        p: Vec3,
        depth: f64,
        left: bool,
    ) -> bool {
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
            for ((part, back), holds) in parts {
                if self.inside.node(part.node, back.point(q)) != Some(holds) {
                    return false;
                }
            }
            if let Some(root) = parts[0].0.0.cut.filter(|_| left)
                && self.inside.node(root, q) != Some(true)
            {
                return false;
            }
        }
        true
    }
}

impl Geometry {
    /// The place of an endless shape's features, in its own coordinates, and the size of these features. Shapes that
    /// end get a default, since nobody asks them.
    fn home(&self) -> (Vec3, f64) {
        match AnyShape::of(self) {
            AnyShape::HalfSpace(s) => {
                let [a, b, c, d] = s.abcd;
                if !s.solid {
                    return ([0.0; 3], 1.0);
                }
                let square = a * a + b * b + c * c;
                let foot = [a, b, c].map(|x| -d * x / square);
                (foot, 1.0f64.max(length(foot)))
            }
            AnyShape::Quadric(s) => {
                let size = match s {
                    Quadric::General(q) => {
                        let largest =
                            |of: &[usize]| of.iter().fold(0.0f64, |m, &k| m.max(q[k].abs()));
                        let square = largest(&[0, 1, 2, 4, 5, 6, 8, 9, 10]).max(f64::MIN_POSITIVE);
                        let linear = largest(&[3, 7, 11, 12, 13, 14]) / square;
                        linear + (largest(&[15]) / square).sqrt() + 1.0
                    }
                    Quadric::ParabolicCylinder { a } => a.max(1.0),
                    Quadric::HyperbolicCylinder { a, b }
                    | Quadric::HyperbolicParaboloid { a, b } => a.max(b),
                    Quadric::Hyperboloid { a, b, c, .. } => a.max(b).max(c),
                };
                ([0.0; 3], size)
            }
            AnyShape::Cone(_)
            | AnyShape::Cuboid(_)
            | AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Revolution(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => ([0.0; 3], 1.0),
        }
    }
}
