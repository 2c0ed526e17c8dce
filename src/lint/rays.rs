//! The search with rays for points of an object's surface.

use crate::geometry::Aabb;
use crate::geometry::vec;
use crate::scene::{Node, NodeId, Render, Scene, Volume};
use crate::solids::ancestry::NONE;
use crate::solids::extent::{WRITTEN, beyond, farthest_out, size};
use crate::solids::outline::Met;
use crate::trace::{Crossing, Ray, Tracer};

/// Most rays for all searches of a rule together: some tenths of a second in the largest scenes.
pub(super) const RAYS: usize = 6000;

/// Most boxes that a search aims at: those that reach furthest out come first.
const AIMS: usize = 24;

/// Places at which rays go through a region, as shares of its sides. The middle comes first, where round shapes reach
/// furthest; then places close to the borders, where shapes with corners do.
const SHARES: [f64; 5] = [0.5, 0.25, 0.75, 0.004, 0.996];

/// Extracts single objects as scenes of their own, without paints. A boundary is then nothing but where a solid ends.
pub(super) struct Bare<'a> {
    scene: &'a Scene,
    /// For each node its number in the scene that is being built, or [`NONE`].
    numbers: Vec<u32>,
}

impl<'a> Bare<'a> {
    pub(super) fn new(scene: &'a Scene) -> Bare<'a> {
        Bare {
            scene,
            numbers: vec![NONE; scene.nodes.len()],
        }
    }

    /// The scene of a single object and all that it is made of, the object's node last. `None` if that is more nodes
    /// than `left`. The nodes are subtracted from `left`.
    pub(super) fn of(&mut self, root: NodeId, left: &mut usize) -> Option<Scene> {
        let scene = self.scene;
        let mut nodes = Vec::new();
        let mut todo = vec![root];
        while let Some(node) = todo.pop() {
            // Any number but `NONE` marks the node as known.
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

    /// Adds a node whose children have been added. Returns its number in `out`.
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

/// A tracer of a bare scene, with its last node as the root; `None` if the scene cannot be traced.
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

/// The parts of a finite box that may be outside of a volume: for a bounding box, the part of `bounds` beyond each of
/// its sides; for a sphere, all of `bounds`.
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

/// A search with rays for points of an object's surface outside or inside of a volume.
pub(super) struct Search<'a> {
    pub tracer: &'a Tracer,
    /// The number of rays that are left.
    pub rays: &'a mut usize,
}

impl Search<'_> {
    /// A point of the surface that is outside of a volume by more than rounding, on a shape whose ID `counts` accepts:
    /// the furthest one in the first region in which there are any. `aims` are finite boxes that hold what is looked
    /// for.
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

    /// A point of the surface that is inside of a box by more than rounding. `None` if none is found, and for a sphere.
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

    /// The crossing that is worth most, of those that rays along the three axes have in a region. A crossing for which
    /// `worth` is `None` does not count.
    fn best(&mut self, region: &Aabb, worth: impl Fn(&Crossing) -> Option<f64>) -> Option<Met> {
        let mut walkers = self.tracer.walker::<f64>();
        let mut best: Option<(f64, Met)> = None;
        let side = |i: usize| region.max[i] - region.min[i];
        // Rays start before the region, by a share of its longest side: a flat region has no thickness of its own.
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

/// The number of its error bounds by which a crossing must be clear of a boundary: one for the error, one for the two
/// roundings of the comparison.
const SKINS: f64 = 2.0;
