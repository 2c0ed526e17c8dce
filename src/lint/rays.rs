//! Points of an object's surface that rays meet.

use crate::geometry::Aabb;
use crate::geometry::vec;
use crate::scene::{Node, NodeId, Render, Scene, Volume};
use crate::solids::ancestry::NONE;
use crate::solids::extent::{WRITTEN, beyond, farthest_out, size};
use crate::solids::outline::Met;
use crate::trace::{Crossing, Ray, Tracer};

/// Rays for all searches of a rule together: some tenths of a second in the largest scenes.
pub(super) const RAYS: usize = 6000;

/// How many leaves a search aims at, those first that reach furthest out.
const AIMS: usize = 24;

/// Places at which rays go through a region, as shares of its sides: the middle first, where round things reach
/// furthest, and close to the borders, where those with corners do.
const SHARES: [f64; 5] = [0.5, 0.25, 0.75, 0.004, 0.996];

/// The geometry of single objects without looks, to be traced from any node: a boundary is then
/// nothing but where a solid ends.
pub(super) struct Bare<'a> {
    scene: &'a Scene,
    /// For each node its number in what is being built, or [`NONE`].
    numbers: Vec<u32>,
}

impl<'a> Bare<'a> {
    pub(super) fn new(scene: &'a Scene) -> Bare<'a> {
        Bare {
            scene,
            numbers: vec![NONE; scene.nodes.len()],
        }
    }

    /// An object with all that it is made of and nothing else, itself last; `None` if that is more nodes than are left.
    pub(super) fn of(&mut self, root: NodeId, left: &mut usize) -> Option<Scene> {
        let scene = self.scene;
        let mut nodes = Vec::new();
        let mut todo = vec![root];
        while let Some(node) = todo.pop() {
            // Any number: it is known.
            if std::mem::replace(&mut self.numbers[node as usize], 0) == NONE {
                nodes.push(node);
                todo.extend(scene.nodes[node as usize].children());
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
        let origin = self.scene.origins[node as usize];
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
            node => node.with_children(at),
        };
        out.nodes.push(node);
        out.origins.push(origin);
        out.nodes.len() as u32 - 1
    }
}

/// A bare scene made ready.
pub(super) fn tracer(mut bare: Scene) -> Option<Tracer> {
    bare.render = Some(Render {
        root: bare.nodes.len().checked_sub(1)? as NodeId,
        root_id: 0,
        background: [0.0; 3],
        clip: None,
        span: Default::default(),
    });
    Tracer::new(&bare).ok()
}

/// The parts of a finite box that may be outside of a volume: what lies beyond each of the sides of
/// a box, or all of it.
pub(super) fn regions(volume: &Volume, bounds: &Aabb) -> Vec<Aabb> {
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
pub(super) struct Search<'a> {
    pub tracer: &'a Tracer,
    /// How many rays are left.
    pub rays: &'a mut usize,
}

impl Search<'_> {
    /// A point of the surface outside of a volume by more than rounding, of those that `counts` lets
    /// pass; the furthest of those met first. `aims` are finite boxes that hold what is looked for.
    pub(super) fn outside(
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
    pub(super) fn inside(&mut self, volume: &Volume, mut aims: Vec<Aabb>) -> Option<Met> {
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
