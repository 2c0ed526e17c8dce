//! How far things reach: points of their surface, met by rays.

use super::leaf::Leaf;
use super::tree::Tree;
use crate::scene::{Aabb, Geometry, Matrix, NodeId, Paint, Render, Scene, Vec3, Volume};
use crate::trace::{Crossing, Ray, Tracer, vec};

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

/// The scene's geometry without looks, to be traced from any node: a boundary is then nothing but
/// where a solid ends.
pub fn bare(scene: &Scene) -> Scene {
    let plain = |p: &Paint| Paint {
        owner: p.owner,
        ..Paint::default()
    };
    Scene {
        nodes: scene.nodes.clone(),
        shapes: scene.shapes.clone(),
        matrices: scene.matrices.clone(),
        paints: scene.paints.iter().map(plain).collect(),
        entities: scene.entities.clone(),
        ..Scene::default()
    }
}

/// The node of a bare scene made ready.
pub fn tracer(bare: &mut Scene, root: NodeId) -> Option<Tracer> {
    bare.render = Some(Render {
        root,
        root_id: 0,
        background: [0.0; 3],
        clip: None,
        span: Default::default(),
    });
    Tracer::new(bare).ok()
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

pub fn distance(p: Vec3, q: Vec3) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1]).hypot(p[2] - q[2])
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
fn regions(volume: &Volume, bounds: &Aabb) -> Vec<Aabb> {
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
        let excess = |b: &Aabb| match volume {
            Volume::Box { .. } => beyond(volume, b.min).max(beyond(volume, b.max)),
            Volume::Sphere { centre, radius } => farthest(b, *centre) - radius,
        };
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
    let column = |j: usize| -> Vec3 { std::array::from_fn(|i| m.0[i][j]) };
    let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let c: [Vec3; 3] = std::array::from_fn(column);
    let scale = dot(c[0], c[0]);
    // How far from even a product of rotations may be.
    const EVEN: f64 = 1e-12;
    let even = (1..3).all(|i| (dot(c[i], c[i]) - scale).abs() <= EVEN * scale)
        && (0..3).all(|i| dot(c[i], c[(i + 1) % 3]).abs() <= EVEN * scale);
    // The deviation is added to the radius, so that the ball holds the image.
    even.then(|| (m.point(centre), radius * scale.sqrt() * (1.0 + EVEN)))
}

/// A distance from a point that nothing of the leaves exceeds, and its rounding.
pub fn farthest_leaf(scene: &Scene, tree: &Tree, whole: &Aabb, p: Vec3) -> f64 {
    let of = |leaf: &Leaf| {
        let round = leaf.shape.and_then(|s| ball(scene, s, &leaf.matrix));
        let boxed = farthest(&leaf.bounds, p);
        round.map_or(boxed, |(c, r)| boxed.min(distance(c, p) + r))
    };
    let leaves = tree.leaves.iter().map(of).fold(0.0, f64::max);
    leaves.min(farthest(whole, p))
}
