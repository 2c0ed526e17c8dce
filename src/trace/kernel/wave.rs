//! Waves: the rays of a tile of pixels, generation by generation.
//!
//! The first wave holds the camera rays of the pixels. Each next wave holds all rays that were mirrored or refracted
//! where the rays of the wave before ended. Rays that go nearly the same way are traced in packets of four, others one
//! by one. The places that they meet are computed and shaded four at a time.

use super::bundle::{Along, Around, BUNDLE_MIN_RAYS};
use super::cuboid::Cuboids;
use super::drawn::Drawn;
use super::lanes::{ALL, LANES, V3, mask};
use super::leaf::{KINDS, Kind, Leaf};
use super::light::Lit;
use super::look::Colour;
use super::packet::Packet;
use super::place;
use super::plane::Planes;
use super::quadric_point;
use super::query::{Crossing, NONE, Start, Tests, UNKNOWN_FACE, Within};
use super::rectangle::Rectangles;
use super::resolved::{Meet, Resolved};
use super::scratch::Scratch;
use super::search::Met;
use super::shade::{Four, Hits};
use super::sphere::Spheres;
use super::stage::Stage;
use super::triangle::Triangles;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use crate::trace::arbiter::Arbiter;
use crate::trace::shade::{Features, Limits};
use crate::trace::shapes::Root;
use crate::trace::stats::Work;
use crate::trace::tracer;

/// The scene and the settings that all rays of a picture share.
pub struct Scene<'t> {
    pub stage: &'t Stage<'t>,
    pub lights: &'t [tracer::Light],
    pub ambient: Vec3,
    pub background: Vec3,
    pub limits: Limits,
    pub features: Features,
    /// Whether the scene is one convex shape, so that nothing is in the way of light outside of it: see
    /// [`Plan::lone_convex`](crate::trace::plan::Plan::lone_convex).
    pub is_lone_convex: bool,
}

/// A ray of a wave.
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    pub start: Start,
    /// The share of its light that reaches the pixel, in each channel.
    pub weight: [f64; 3],
    /// The index of its [`RayNode`] in the tile.
    pub node: u32,
    pub pixel: u32,
    pub depth: u32,
}

/// Where a ray of a wave has met something.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    pub ray: u32,
    pub crossing: Crossing,
    /// The solids before and behind the crossing.
    pub sides: [Within; 2],
}

/// The light of a ray, and the nodes of the rays that go on from where it ends: one for each way through, then the
/// mirrored ray. [`NONE`] stands for no ray.
#[derive(Debug, Clone, Copy)]
pub struct RayNode {
    pub light: Vec3,
    pub children: [u32; 4],
}

/// The index of the mirrored ray among the children of a node.
pub const MIRRORED: usize = 3;

impl RayNode {
    /// A node without light and without rays that go on.
    pub const DARK: RayNode = RayNode {
        light: Vec3::ZERO,
        children: [NONE; 4],
    };
}

/// The memory in which one thread draws tiles of pixels, wave by wave.
#[derive(Debug, Default)]
pub struct Tile {
    pub(super) pixels: Vec<Drawn>,
    pub(super) wave: Vec<Ray>,
    pub(super) next: Vec<Ray>,
    pub(super) nodes: Vec<RayNode>,
    /// The hits of the wave, by the kind of shape and by whether the shape is placed: see [`slot`].
    by_kind: [Vec<Hit>; 2 * KINDS.len()],
    /// For each lamp, the block that was in the way of its light last, or [`NONE`].
    pub(super) last: Vec<u32>,
    pub(super) search: Scratch,
    pending: Vec<u32>,
    /// Rays of the wave that the kernel is in doubt about.
    doubtful: Vec<Ray>,
    /// The arbiter's answer about one doubtful ray.
    answer: Vec<Vec3>,
    /// The blocks that some ray of the wave may meet. Used only for waves whose rays are nearly parallel.
    pub(super) along: Along,
    /// Places of the wave that lamps may shine on.
    pub(super) lit: Vec<Lit>,
    /// The work on textures and normals of all samples since it was last taken.
    pub(super) work: Work,
}

/// The index in `by_kind` of hits with shapes of a kind: two for each kind, for shapes in the scene's space and for
/// placed ones.
#[inline(always)]
fn slot(kind: Kind, is_placed: bool) -> usize {
    2 * kind as usize + usize::from(is_placed)
}

/// Rays whose directions differ by more than this along some axis are no bundle.
const SPREAD: f64 = 0.3;

/// The most rays of one tile. A tile with more is lost: the arbiter draws its pixels.
const MAX_RAYS_IN_TILE: usize = 1 << 20;

impl Tile {
    /// The work on textures, normals and intersections of all samples since it was last taken.
    pub fn take_work(&mut self) -> Work {
        let merged = std::mem::take(&mut self.search.merges);
        let work = std::mem::take(&mut self.work);
        Work {
            csg_merge: merged,
            ..work
        }
    }

    /// Draws pixels with one camera ray each; the results are in the order of the rays.
    ///
    /// `cameras` holds the origin and the direction of each ray. Origins are outside of every solid; directions have
    /// length 1.
    pub fn draw(
        &mut self,
        scene: &Scene,
        arbiter: &mut dyn Arbiter,
        cameras: &[[Vec3; 2]],
    ) -> &[Drawn] {
        self.pixels.clear();
        self.nodes.clear();
        self.wave.clear();
        self.last.clear();
        self.last.resize(scene.lights.len(), NONE);
        for (i, &[origin, direction]) in (0..).zip(cameras) {
            self.pixels.push(Drawn::default());
            self.nodes.push(RayNode::DARK);
            self.wave.push(Ray {
                start: Start::outside(origin, direction),
                weight: [1.0; 3],
                node: i,
                pixel: i,
                depth: 0,
            });
            if !(origin.is_finite() && direction.is_finite() && direction.any()) {
                self.pixels[i as usize].is_lost = true;
                self.wave.pop();
            }
        }
        while !self.wave.is_empty() {
            if self.nodes.len() > MAX_RAYS_IN_TILE {
                self.pixels.iter_mut().for_each(|p| p.is_lost = true);
                break;
            }
            self.step(scene, arbiter);
            std::mem::swap(&mut self.wave, &mut self.next);
        }
        self.add_up();
        &self.pixels
    }

    /// Adds up the light of all rays of each pixel, in the order of a tracer that follows one ray after the other.
    fn add_up(&mut self) {
        for (root, pixel) in (0..).zip(&mut self.pixels) {
            let first = self.nodes[root as usize];
            let mut sum = first.light;
            let push = |pending: &mut Vec<u32>, node: RayNode| {
                pending.extend(node.children.into_iter().filter(|&child| child != NONE));
            };
            push(&mut self.pending, first);
            while let Some(number) = self.pending.pop() {
                let node = self.nodes[number as usize];
                sum = sum + node.light;
                push(&mut self.pending, node);
            }
            pixel.light = sum;
        }
    }

    /// Traces a wave, and makes the next one.
    #[inline(never)]
    fn step(&mut self, scene: &Scene, arbiter: &mut dyn Arbiter) {
        self.next.clear();
        self.by_kind.iter_mut().for_each(Vec::clear);
        self.lit.clear();
        match self.find_along(scene) {
            true => self.meet_in_packets(scene),
            false => (0..self.wave.len()).for_each(|i| self.meet_alone(scene, i)),
        }
        let wave = std::mem::take(&mut self.wave);
        for kind in KINDS {
            for is_placed in [false, true] {
                let slot = slot(kind, is_placed);
                let mut met = std::mem::take(&mut self.by_kind[slot]);
                if kind == Kind::Other {
                    // Hits on one shape are located together.
                    let leaves = &scene.stage.leaves;
                    met.sort_by_key(|hit| leaves[hit.crossing.surface as usize].primitive);
                }
                for some in met.chunks(LANES) {
                    let four = Four::new(&wave, &scene.stage.leaves, some);
                    let live = ALL >> (LANES - some.len());
                    match kind {
                        Kind::Sphere => self.hits::<Spheres>(scene, (&four, live), is_placed),
                        Kind::Cuboid => self.hits::<Cuboids>(scene, (&four, live), is_placed),
                        Kind::Plane | Kind::HalfSpace => {
                            self.hits::<Planes>(scene, (&four, live), is_placed);
                        }
                        Kind::Rectangle => self.hits::<Rectangles>(scene, (&four, live), is_placed),
                        Kind::Triangle => self.hits::<Triangles>(scene, (&four, live), is_placed),
                        Kind::Quadric => self.hits_of_quadrics(scene, &wave, &four, live),
                        Kind::Other | Kind::Csg => {
                            self.hits_one_by_one(scene, (&four, live));
                        }
                    }
                }
                self.by_kind[slot] = met;
            }
        }
        self.wave = wave;
        self.illuminate(scene, arbiter);
        let mut doubtful = std::mem::take(&mut self.doubtful);
        for ray in doubtful.drain(..) {
            self.ask(scene, arbiter, &ray);
        }
        self.doubtful = doubtful;
    }

    /// Finds what the rays of the wave meet, in packets of four. The rays go nearly the same way.
    fn meet_in_packets(&mut self, scene: &Scene) {
        let boxes = self.along.boxes.div_ceil(self.wave.len() as u32);
        let last = self.wave.len() - 1;
        for first in (0..self.wave.len()).step_by(LANES) {
            let numbers = each([0, 1, 2, 3], |lane: usize| (first + lane).min(last));
            let live = ALL >> (LANES - (last + 1 - first).min(LANES));
            let starts = each(numbers, |i: usize| &self.wave[i].start);
            let packet = Packet::new(starts, live);
            let mut tests = [Tests { boxes, shapes: 0 }; LANES];
            let met =
                (scene.stage).first_of_four(&self.along, &packet, &mut self.search, &mut tests);
            for (lane, met) in met.into_iter().enumerate().take(last + 1 - first) {
                let i = first + lane;
                let ray = &self.wave[i];
                if !ray.start.within.is_empty() {
                    self.meet_alone(scene, i);
                    continue;
                }
                self.pixels[ray.pixel as usize].tests.add(tests[lane]);
                self.note_met(scene, i, met);
            }
        }
    }

    /// Finds what ray `i` of the wave meets, by itself.
    #[inline(always)]
    fn meet_alone(&mut self, scene: &Scene, i: usize) {
        let ray = &self.wave[i];
        let tests = &mut self.pixels[ray.pixel as usize].tests;
        let met = (scene.stage).first(&ray.start, &mut self.search, tests);
        self.note_met(scene, i, met);
    }

    /// Notes what ray `i` of the wave has met: its light if it has met nothing, a hit, or a doubtful ray.
    #[inline(always)]
    fn note_met(&mut self, scene: &Scene, i: usize, met: Met) {
        let ray = &self.wave[i];
        match met {
            Met::Doubt => self.doubtful.push(*ray),
            Met::Nothing => {
                let light = scene.background.times(Vec3(ray.weight));
                self.nodes[ray.node as usize].light = light;
            }
            Met::Surface(crossing, sides) => {
                let leaf = &scene.stage.leaves[crossing.surface as usize];
                self.by_kind[slot(leaf.kind, leaf.placement != 0)].push(Hit {
                    ray: i as u32,
                    crossing,
                    sides,
                });
            }
        }
    }

    /// Asks the arbiter for the light of a ray, and of all rays that follow from it.
    #[cold]
    fn ask(&mut self, scene: &Scene, arbiter: &mut dyn Arbiter, ray: &Ray) {
        self.answer.clear();
        let start = scene.stage.ray(&ray.start);
        self.pixels[ray.pixel as usize].asked +=
            arbiter.radiance(&start, Vec3(ray.weight), ray.depth, &mut self.answer);
        // The answers become a chain of nodes, so that they are added up in their order.
        let mut node = ray.node;
        for (i, &light) in self.answer.iter().enumerate() {
            if i > 0 {
                let next = self.nodes.len() as u32;
                self.nodes.push(RayNode::DARK);
                self.nodes[node as usize].children = [next, NONE, NONE, NONE];
                node = next;
            }
            self.nodes[node as usize].light = light;
        }
    }

    /// Finds the blocks that the rays of the wave may meet. `false` if the rays do not go nearly the same way, or if it
    /// does not pay to share the blocks.
    fn find_along(&mut self, scene: &Scene) -> bool {
        if self.wave.len() < BUNDLE_MIN_RAYS {
            return false;
        }
        let (mut origins, mut directions) = (Around::NOTHING, Around::NOTHING);
        for ray in &self.wave {
            origins.add(ray.start.origin);
            directions.add(ray.start.direction);
            if directions.spread() > SPREAD {
                return false;
            }
        }
        let (start, directions) = (origins.bounds(), directions.bounds());
        let steps = [Vec3(directions.min), Vec3(directions.max)];
        (self.along).find(scene.stage, &start, steps, f64::INFINITY)
    }

    /// Shades the points where four rays have met shapes of one kind with lanes. `is_placed`: whether placements move
    /// the shapes.
    #[inline(never)]
    fn hits<S: Meet>(&mut self, scene: &Scene, (four, live): (&Four, u32), is_placed: bool) {
        let (origin, direction, exit) = (four.origin, four.direction, mask(four.exits_leaf));
        let mut local = None;
        let resolved = match is_placed {
            false => *local.insert(S::meet(four.leaves, origin, direction, exit)),
            true => {
                let place = |leaf: &Leaf| &scene.stage.graph.placements[leaf.placement as usize];
                let [a, b, c, d] = four.leaves;
                let places = [place(a), place(b), place(c), place(d)];
                place::placed(places, origin, direction, |origin, direction| {
                    *local.insert(S::meet(four.leaves, origin, direction, exit))
                })
            }
        };
        let live = self.known(four, live, &resolved);
        let mut hits = Hits::new(four, live, &resolved);
        let is_painted = four
            .leaves
            .iter()
            .any(|leaf| leaf.look.colour != Colour::Plain);
        let lane =
            |columns: &[[f64; LANES]; 3], i: usize| Vec3(each([0, 1, 2], |k: usize| columns[k][i]));
        if let Some(local) = local.filter(|_| S::IS_SMOOTH) {
            let points = local.point.columns();
            let place = |i: usize| (lane(&points, i), 0);
            let normal = hits.shading;
            hits.shading =
                (scene.stage).smoothed((four.leaves, live), place, normal, &mut self.work);
        }
        if let Some(local) = local.filter(|_| is_painted) {
            let [point, normal] = [local.point, local.normal].map(V3::columns);
            let place = |i: usize| (lane(&point, i), S::face(lane(&normal, i)));
            hits.albedo = self.albedo(scene.stage, (four, live), &hits, place);
        }
        self.shade(scene, four, &hits);
    }

    /// Shades the points where four rays have met convex solids of second degree.
    #[inline(never)]
    fn hits_of_quadrics(&mut self, scene: &Scene, wave: &[Ray], four: &Four, live: u32) {
        let stage = scene.stage;
        let met = each(four.hits, |hit| {
            (&wave[hit.ray as usize].start, &hit.crossing)
        });
        let found = quadric_point::meet(stage, four.leaves, met);
        let told = live & found.as_ref().map_or(0, |found| found.known);
        let mut hits = each(four.hits, Hit::clone);
        let mut lost = 0;
        for lane in (0..LANES).filter(|lane| live >> lane & 1 != 0) {
            let crossing = &mut hits[lane].crossing;
            match &found {
                Some(found) if told >> lane & 1 != 0 => {
                    crossing.root = Root {
                        t: found.resolved.t.to_array()[lane],
                        face: found.flat >> lane & 1,
                    };
                }
                _ if crossing.root.face != UNKNOWN_FACE => {}
                _ => {
                    let ray = four.rays[lane];
                    if !stage.sharpen(&ray.start, crossing, &mut self.search.roots) {
                        self.doubtful.push(*ray);
                        lost |= 1 << lane;
                    }
                }
            }
        }
        let live = live & !lost;
        let four = &Four::new(wave, &stage.leaves, &hits);
        match found {
            Some(found) if live == told => {
                let mut of = Hits::new(four, live, &found.resolved);
                of.shading = found.resolved.normal;
                if four
                    .leaves
                    .iter()
                    .any(|leaf| leaf.look.colour != Colour::Plain)
                {
                    let local = found.local.columns();
                    let place = |lane: usize| {
                        let local = Vec3(each([0, 1, 2], |i: usize| local[i][lane]));
                        (local, hits[lane].crossing.root.face)
                    };
                    of.albedo = self.albedo(stage, (four, live), &of, place);
                }
                self.shade(scene, four, &of);
            }
            _ => self.hits_one_by_one(scene, (four, live)),
        }
    }

    /// Shades the points where four rays have met leaves without lanes.
    #[inline(never)]
    fn hits_one_by_one(&mut self, scene: &Scene, (four, live): (&Four, u32)) {
        let stage = scene.stage;
        let roots = each(four.hits, |hit| hit.crossing.root);
        let rays = (four.origin, four.direction);
        let places = stage.locate(four.leaves, rays, roots, live, &mut self.work);
        let resolved = places.resolved;
        let live = self.known(four, live, &resolved);
        let mut hits = Hits::new(four, live, &resolved);
        hits.shading = places.shading;
        let place = |lane: usize| (places.local[lane], four.hits[lane].crossing.root.face);
        hits.albedo = self.albedo(stage, (four, live), &hits, place);
        self.shade(scene, four, &hits);
    }

    /// The shares of diffuse light at four points. `place` gives for each lane the point in the space of its shape, and
    /// the face.
    #[inline]
    fn albedo(
        &mut self,
        stage: &Stage,
        (four, live): (&Four, u32),
        hits: &Hits,
        place: impl Fn(usize) -> (Vec3, u32),
    ) -> V3 {
        let points = hits.point.columns();
        let mut albedo = each(four.leaves, |leaf| leaf.look.albedo);
        for lane in (0..LANES).filter(|lane| live >> lane & 1 != 0) {
            let leaf = four.leaves[lane];
            if leaf.look.colour != Colour::Plain {
                let point = Vec3::new(points[0][lane], points[1][lane], points[2][lane]);
                let (local, face) = place(lane);
                albedo[lane] = stage.albedo(leaf, face, [point, local], &mut self.work);
            }
        }
        V3::gathered(albedo.each_ref(), |albedo| albedo)
    }

    /// Notes the rays among `live` whose points are in doubt; returns the others, as bits.
    #[inline(always)]
    fn known(&mut self, four: &Four, live: u32, resolved: &Resolved) -> u32 {
        let doubtful = live & !resolved.clear.to_bitmask();
        if doubtful != 0 {
            let lanes = (0..LANES).filter(|lane| doubtful >> lane & 1 != 0);
            self.doubtful.extend(lanes.map(|lane| *four.rays[lane]));
        }
        live & !doubtful
    }
}
