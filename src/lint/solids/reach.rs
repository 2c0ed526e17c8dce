//! How far things reach: points of their surface, known exactly or met by rays.

use std::cell::Cell;

use super::distance;
use super::inside::Inside;
use super::leaf::Leaf;
use super::tips::{Tip, tips, ways};
use super::tree::Tree;
use super::ways::NONE;
use crate::geometry::vec;
use crate::geometry::{Aabb, Matrix};
use crate::scene::bounds::NodeBounds;
use crate::scene::{Geometry, Node, NodeId, Render, Scene, Vec3, Volume};
use crate::trace::{Crossing, Ray, Tracer};

/// Rays for all searches of a rule together: some tenths of a second in the largest scenes.
pub const RAYS: usize = 6000;

/// How many leaves a search aims at, those first that reach furthest out.
const AIMS: usize = 24;

/// What is outside by less than this share of a volume's size is not reported: numbers in scenes
/// are often written with six or seven digits.
pub const WRITTEN: f64 = 1e-6;

/// Where rays go through a region, as shares of its sides: the middle first, where round things
/// reach furthest, and close to the borders, where those with corners do.
const SHARES: [f64; 5] = [0.5, 0.25, 0.75, 0.004, 0.996];

/// The geometry of single objects without looks, to be traced from any node: a boundary is then
/// nothing but where a solid ends.
pub struct Bare<'a> {
    scene: &'a Scene,
    /// For each node its number in what is being built, or [`NONE`].
    numbers: Vec<u32>,
}

impl<'a> Bare<'a> {
    pub fn new(scene: &'a Scene) -> Bare<'a> {
        Bare {
            scene,
            numbers: vec![NONE; scene.nodes.len()],
        }
    }

    /// What an object is made of and nothing else, itself last; `None` if that is more nodes than are
    /// left.
    pub fn of(&mut self, root: NodeId, left: &mut usize) -> Option<Scene> {
        let scene = self.scene;
        let mut nodes = Vec::new();
        let mut todo = vec![root];
        while let Some(node) = todo.pop() {
            // Any number: it is known.
            if std::mem::replace(&mut self.numbers[node as usize], 0) == NONE {
                nodes.push(node);
                todo.extend(scene.nodes[node as usize].children().into_iter().flatten());
            }
            if nodes.len() > *left {
                break;
            }
        }
        let all = nodes.len() <= *left;
        *left -= nodes.len().min(*left);
        let mut out = Scene::default();
        // Children stand before their parents.
        nodes.sort_unstable();
        for &node in nodes.iter().filter(|_| all) {
            self.numbers[node as usize] = self.add(node, &mut out);
        }
        nodes
            .iter()
            .for_each(|&node| self.numbers[node as usize] = NONE);
        all.then_some(out)
    }

    /// Adds a node whose children are there; says its number.
    fn add(&self, node: NodeId, out: &mut Scene) -> u32 {
        let at = |child: NodeId| self.numbers[child as usize];
        let node = match self.scene.nodes[node as usize] {
            Node::Shape(s) => {
                out.shapes.push(self.scene.shapes[s as usize].clone());
                Node::Shape(out.shapes.len() as u32 - 1)
            }
            Node::Transform { child, matrix } => {
                let child = at(child);
                out.matrices.push(self.scene.matrices[matrix as usize]);
                let matrix = out.matrices.len() as u32 - 1;
                Node::Transform { child, matrix }
            }
            Node::Paint { child, .. } => return at(child),
            Node::Copy { child, id } => Node::Copy {
                child: at(child),
                id,
            },
            Node::Union(a, b) => Node::Union(at(a), at(b)),
            Node::Intersection(a, b) => Node::Intersection(at(a), at(b)),
            Node::Difference(a, b) => Node::Difference(at(a), at(b)),
            Node::Complement(child) => Node::Complement(at(child)),
        };
        out.nodes.push(node);
        out.nodes.len() as u32 - 1
    }
}

/// A bare scene made ready.
pub fn tracer(mut bare: Scene) -> Option<Tracer> {
    bare.render = Some(Render {
        root: bare.nodes.len().checked_sub(1)? as NodeId,
        root_id: 0,
        background: [0.0; 3],
        clip: None,
        span: Default::default(),
    });
    Tracer::new(&bare).ok()
}

/// A point of a surface.
#[derive(Debug, Clone, Copy)]
pub struct Met {
    pub point: Vec3,
    /// The ID under which the surface is written.
    pub shape: u32,
}

/// By how much a point is outside of a volume; below zero inside.
pub fn beyond(volume: &Volume, p: Vec3) -> f64 {
    match volume {
        Volume::Box { min, max } => (0..3)
            .map(|i| (p[i] - max[i]).max(min[i] - p[i]))
            .fold(f64::NEG_INFINITY, f64::max),
        Volume::Sphere { centre, radius } => distance(p, *centre) - radius,
    }
}

/// The size that a volume's numbers are written with: its extent, and how far it is away.
pub fn size(volume: &Volume) -> f64 {
    let of = |points: [Vec3; 2]| points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    match volume {
        Volume::Box { min, max } => of([*min, *max]),
        Volume::Sphere { centre, radius } => of([*centre, [*radius; 3]]),
    }
}

/// The parts of a finite box that may be outside of a volume: what lies beyond each of the sides of
/// a box, or all of it.
pub fn regions(volume: &Volume, bounds: &Aabb) -> Vec<Aabb> {
    let Volume::Box { min, max } = volume else {
        return vec![*bounds];
    };
    let mut out = Vec::new();
    for i in 0..3 {
        let (mut above, mut below) = (*bounds, *bounds);
        above.min[i] = above.min[i].max(max[i]);
        below.max[i] = below.max[i].min(min[i]);
        out.extend([above, below].into_iter().filter(|r| r.min[i] < r.max[i]));
    }
    out
}

/// How many points of a kind are looked at, those first that reach furthest out.
const TIPS: usize = 16;

/// How far from the surface a point is tried, as a share of how far that is out of the volume.
const STEP: f64 = 0.01;

/// Directions in which shapes are asked how far they reach, for all searches of a rule together: some
/// tenths of a second.
pub const DIRECTIONS: usize = 3_000_000;

/// The exactly known points of an object: those where its leaves reach furthest.
pub struct Outline<'a> {
    /// How many directions are left.
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

    /// Whether nothing reaches out of a box at all if [`outside`](Self::outside) finds nothing.
    pub fn is_exact(&self, volume: &Volume) -> bool {
        let ways = ways(volume);
        let whole = |leaf: &Leaf| {
            let ends = |g| {
                tips(g, &leaf.matrix, volume, &ways, self.left)
                    .next()
                    .is_some()
            };
            self.is_whole(leaf) && self.geometry(leaf).is_some_and(ends)
        };
        matches!(volume, Volume::Box { .. }) && self.tree.leaves.iter().all(whole)
    }

    /// A point of the surface outside of a volume by more than rounding, of those the furthest.
    pub fn outside(&self, volume: &Volume) -> Option<Met> {
        let slack = WRITTEN * size(volume);
        self.first(volume, slack, |b| farthest_out(volume, b), |by| by)
    }

    /// A point of the surface inside of a volume by more than rounding.
    pub fn inside(&self, volume: &Volume) -> Option<Met> {
        let slack = WRITTEN * size(volume);
        self.first(volume, slack, |_| f64::INFINITY, |by| -by)
    }

    /// The tip to which the most is given, by how far out it is, of those that are worth more than
    /// `least` and are part of the surface. `most`: what nothing in a box is worth more than.
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
        let ways = ways(volume);
        let mut all: Vec<(f64, &Leaf, Tip)> = Vec::new();
        for (most, leaf) in leaves {
            let Some(geometry) = self.geometry(leaf) else {
                continue;
            };
            if all.len() > 4 * TIPS {
                best_first(&mut all);
                // Nothing in the boxes that are left is worth more.
                if all[TIPS - 1].0 >= most {
                    break;
                }
            }
            if self.left.get() < ways.len() {
                self.left.set(0);
                break;
            }
            for tip in tips(geometry, &leaf.matrix, volume, &ways, self.left) {
                let by = worth(beyond(volume, tip.point));
                if by > least {
                    all.push((by, leaf, tip));
                }
            }
        }
        best_first(&mut all);
        let mut inside = Inside::new(self.scene, self.bounds);
        let mut is_part = |&(by, leaf, tip): &(f64, &Leaf, Tip)| {
            let at = |step: f64| match tip.inwards {
                None => tip.point,
                Some(v) => {
                    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
                    std::array::from_fn(|i| tip.point[i] + step * STEP * by / length * v[i])
                }
            };
            // Where the same piece of a profile is gone over twice there is nothing.
            let plain = !matches!(self.geometry(leaf), Some(Geometry::Revolution { .. }));
            let sheet = tip.inwards.is_none();
            let held = match self.is_whole(leaf) && plain {
                true => true,
                false if sheet => false,
                false => {
                    let p = at(1.0);
                    worth(beyond(volume, p)) > least && inside.node(self.root, p) == Some(true)
                }
            };
            // Nothing else holds what is around it.
            held && inside.node(self.root, at(-1.0)) == Some(false)
        };
        let (_, leaf, tip) = all.iter().find(|c| is_part(c))?;
        Some(Met {
            point: tip.point,
            shape: leaf.id,
        })
    }
}

fn best_first(all: &mut Vec<(f64, &Leaf, Tip)>) {
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.truncate(TIPS);
}

/// By how much the point of a box that is furthest out is outside of a volume.
fn farthest_out(volume: &Volume, b: &Aabb) -> f64 {
    match volume {
        Volume::Box { .. } => beyond(volume, b.min).max(beyond(volume, b.max)),
        Volume::Sphere { centre, radius } => farthest(b, *centre) - radius,
    }
}

/// A search for points of a node's surface in some place.
pub struct Search<'a> {
    pub tracer: &'a Tracer,
    /// How many rays are left.
    pub rays: &'a mut usize,
}

impl Search<'_> {
    /// A point of the surface outside of a volume by more than rounding, of those that `counts` lets
    /// pass; the furthest of those met first. `aims` are finite boxes that hold what is looked for.
    pub fn outside(
        &mut self,
        volume: &Volume,
        mut aims: Vec<Aabb>,
        counts: impl Fn(u32) -> bool,
    ) -> Option<Met> {
        let slack = WRITTEN * size(volume);
        let excess = |b: &Aabb| farthest_out(volume, b);
        aims.retain(|b| excess(b) > slack);
        aims.sort_by(|a, b| excess(b).total_cmp(&excess(a)));
        aims.truncate(AIMS);
        for region in aims.iter().flat_map(|b| regions(volume, b)) {
            let best = self.best(&region, |c| {
                let by = beyond(volume, c.hit.point.0);
                (by > slack + SKINS * c.hit.skin && counts(c.shape)).then_some(by)
            });
            if best.is_some() {
                return best;
            }
        }
        None
    }

    /// A point of the surface inside of a box by more than rounding.
    pub fn inside(&mut self, volume: &Volume, mut aims: Vec<Aabb>) -> Option<Met> {
        let Volume::Box { min, max } = volume else {
            return None;
        };
        let slack = WRITTEN * size(volume);
        let region = Aabb::new(*min, *max);
        aims.iter_mut().for_each(|b| *b = b.intersection(&region));
        aims.retain(|b| !b.is_empty());
        aims.truncate(AIMS);
        aims.push(region);
        aims.iter().find_map(|aim| {
            self.best(aim, |c| {
                let by = -beyond(volume, c.hit.point.0);
                (by > slack + SKINS * c.hit.skin).then_some(by)
            })
        })
    }

    /// The crossing of some rays through a region to which the most is given.
    fn best(&mut self, region: &Aabb, worth: impl Fn(&Crossing) -> Option<f64>) -> Option<Met> {
        let mut walkers = self.tracer.walker::<f64>();
        let mut best: Option<(f64, Met)> = None;
        let side = |i: usize| region.max[i] - region.min[i];
        // Rays start before the region, and flat things have no thickness to start before.
        let lead = 0.01 * side(0).max(side(1)).max(side(2));
        for axis in 0..3 {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            for (a, b) in SHARES.iter().flat_map(|a| SHARES.map(|b| (*a, b))) {
                *self.rays = self.rays.checked_sub(1)?;
                let mut origin = region.min;
                origin[axis] -= lead;
                origin[j] += a * side(j);
                origin[k] += b * side(k);
                let direction = std::array::from_fn(|i| f64::from(u8::from(i == axis)));
                let ray = Ray::new(vec::Vec3(origin), vec::Vec3(direction));
                for c in self.tracer.crossings(&mut walkers, &ray) {
                    let point = c.hit.point.0;
                    if point[axis] > region.max[axis] + lead {
                        break;
                    }
                    if let Some(by) = worth(&c)
                        && best.is_none_or(|b| by > b.0)
                    {
                        let shape = c.shape;
                        best = Some((by, Met { point, shape }));
                    }
                }
            }
        }
        best.map(|b| b.1)
    }
}

/// How many times its own bound a crossing's error may be exceeded: the bound is one, this is for the
/// two roundings of the comparison.
const SKINS: f64 = 2.0;

/// The largest distance of a box's points from a point.
pub fn farthest(b: &Aabb, p: Vec3) -> f64 {
    if b.is_empty() {
        return 0.0;
    }
    let reach: Vec3 = std::array::from_fn(|i| (b.max[i] - p[i]).abs().max((p[i] - b.min[i]).abs()));
    // Five roundings in a row, upwards.
    reach[0].hypot(reach[1]).hypot(reach[2]) * (1.0 + 8.0 * f64::EPSILON)
}

/// A ball and its place, where a leaf is one: spheres that are moved, turned and scaled evenly.
pub fn ball(scene: &Scene, shape: u32, m: &Matrix) -> Option<(Vec3, f64)> {
    let Geometry::Sphere { centre, radius } = scene.shapes[shape as usize].geometry else {
        return None;
    };
    Some((m.point(centre), radius * even_scale(m)?))
}

/// How far from even a product of rotations may be.
const EVEN: f64 = 1e-12;

/// The factor of a matrix that moves, turns and scales evenly, and a little more: what it stretches
/// most is stretched by less.
fn even_scale(m: &Matrix) -> Option<f64> {
    let column = |j: usize| -> Vec3 { std::array::from_fn(|i| m.0[i][j]) };
    let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let c: [Vec3; 3] = std::array::from_fn(column);
    let scale = dot(c[0], c[0]);
    let even = (1..3).all(|i| (dot(c[i], c[i]) - scale).abs() <= EVEN * scale)
        && (0..3).all(|i| dot(c[i], c[(i + 1) % 3]).abs() <= EVEN * scale);
    even.then(|| scale.sqrt() * (1.0 + EVEN))
}

/// A distance from a point that nothing of a moved shape exceeds by more than rounding, where that is
/// known more closely than by a box.
fn farthest_point(geometry: &Geometry, m: &Matrix, p: Vec3) -> Option<f64> {
    let of = |points: &[Vec3]| {
        let each = points.iter().map(|&q| distance(m.point(q), p));
        Some(each.fold(0.0, f64::max))
    };
    match *geometry {
        Geometry::Sphere { centre, radius } => {
            Some(distance(m.point(centre), p) + radius * even_scale(m)?)
        }
        Geometry::GeodesicSphere { radius, .. } => {
            Some(distance(m.point([0.0; 3]), p) + radius * even_scale(m)?)
        }
        Geometry::Torus { major, minor } => {
            let scale = even_scale(m)?;
            // The point of the tube's core that is furthest away, and from there as much further.
            let [x, y, z] = m.inverse()?.point(p);
            Some(scale * ((x.hypot(z) + major).hypot(y) + minor))
        }
        Geometry::Box { min, max } => of(&std::array::from_fn::<_, 8, _>(|k| {
            std::array::from_fn(|i| if k >> i & 1 == 0 { min[i] } else { max[i] })
        })),
        Geometry::Rectangle { min, max } => of(&std::array::from_fn::<_, 4, _>(|k| {
            let x = if k & 1 == 0 { min[0] } else { max[0] };
            [x, if k & 2 == 0 { min[1] } else { max[1] }, 0.0]
        })),
        Geometry::Triangle { ref vertices, .. } => of(vertices),
        _ => None,
    }
}

/// A distance from a point that nothing of the leaves exceeds, and its rounding.
pub fn farthest_leaf(scene: &Scene, tree: &Tree, whole: &Aabb, p: Vec3) -> f64 {
    let of = |leaf: &Leaf| {
        let geometry = leaf.shape.map(|s| &scene.shapes[s as usize].geometry);
        let closer = geometry.and_then(|g| farthest_point(g, &leaf.matrix, p));
        let boxed = farthest(&leaf.bounds, p);
        closer.map_or(boxed, |d| boxed.min(d))
    };
    let leaves = tree.leaves.iter().map(of).fold(0.0, f64::max);
    leaves.min(farthest(whole, p))
}
