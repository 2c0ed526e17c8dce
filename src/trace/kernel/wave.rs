//! Rays of a few pixels, generation by generation.
//!
//! All rays that a tile's pixels send, mirror and refract at one time are a wave. Each is traced by itself; what happens
//! where they have met something is computed four at a time.

use super::cuboid::Cuboids;
use super::lanes::{ALL, Lanes, V3, WIDTH, either, gathered, is_greater, is_less, mask};
use super::leaf::{KINDS, Kind, Leaf};
use super::place;
use super::plane::Planes;
use super::rectangle::Rectangles;
use super::resolved::{Meet, Resolved};
use super::search::{DOUBT, Light, NONE, Scratch, Start, Tests};
use super::sphere::Spheres;
use super::stage::Stage;
use crate::geometry::vec::{UNIT_ROUNDOFF, Vec3, gamma};
use crate::trace::shade::{Features, Limits};
use crate::trace::stats::Counts;
use crate::trace::tracer;

/// What all rays of a picture have in common.
pub struct Scene<'t> {
    pub stage: &'t Stage<'t>,
    pub lights: &'t [tracer::Light],
    pub ambient: Vec3,
    pub background: Vec3,
    pub limits: Limits,
    pub features: Features,
    /// Whether what is outside of the shape is never in the way of a light: see
    /// [`Plan::lone_convex`](crate::trace::plan::Plan::lone_convex).
    pub is_alone: bool,
}

/// A ray of a wave.
#[derive(Debug, Clone, Copy)]
struct Ray {
    start: Start,
    /// How much its light counts.
    weight: [f64; 3],
    node: u32,
    pixel: u32,
    depth: u32,
    /// What it has met.
    met: u32,
}

/// The light of a ray, and the rays that go on from where it ends: the mirrored one and the refracted one.
#[derive(Debug, Clone, Copy)]
struct Node {
    light: Vec3,
    children: [u32; 2],
}

const LEAFLESS: Node = Node {
    light: Vec3::ZERO,
    children: [NONE; 2],
};

/// What a pixel has come to.
#[derive(Debug, Clone, Copy, Default)]
pub struct Drawn {
    /// Whether some ray was in doubt; then nothing else here means anything.
    pub is_doubtful: bool,
    pub light: Vec3,
    tests: Tests,
    shadow: u32,
    transparent: u32,
    reflection: u32,
    refraction: u32,
    total: u32,
    media: u32,
}

impl Drawn {
    /// Intersection tests.
    pub fn tests(&self) -> u32 {
        self.tests.boxes.saturating_add(self.tests.shapes)
    }

    /// Whether light was totally reflected.
    pub fn has_total_reflection(&self) -> bool {
        self.total > 0
    }

    /// Adds what it has cost.
    #[inline]
    pub fn count(&self, all: &mut Counts) {
        all.quick += 1;
        all.rays.camera += 1;
        all.intersections.boxes += u64::from(self.tests.boxes);
        all.intersections.shape += u64::from(self.tests.shapes);
        if self.shadow + self.reflection + self.refraction + self.total + self.media == 0 {
            return;
        }
        all.rays.shadow += u64::from(self.shadow);
        all.rays.reflection += u64::from(self.reflection);
        all.rays.refraction += u64::from(self.refraction);
        all.rays.total += u64::from(self.total);
        all.work.shadow += u64::from(self.shadow);
        all.work.transparent_shadow += u64::from(self.transparent);
        all.work.reflection += u64::from(self.reflection);
        all.work.refraction += u64::from(self.refraction);
        all.work.medium_change += u64::from(self.media);
    }
}

/// The scratch of one thread.
#[derive(Debug, Default)]
pub struct Tile {
    pixels: Vec<Drawn>,
    wave: Vec<Ray>,
    next: Vec<Ray>,
    nodes: Vec<Node>,
    /// Rays of the wave that have met a shape of each kind: see [`slot`].
    met: [Vec<u32>; 2 * KINDS.len()],
    /// For each light, what was in its way last.
    last: Vec<u32>,
    search: Scratch,
    pending: Vec<u32>,
}

/// Where rays are kept that have met a shape of a kind, where it was defined or elsewhere.
#[inline(always)]
fn slot(kind: Kind, is_placed: bool) -> usize {
    2 * kind as usize + usize::from(is_placed)
}

/// More rays than this of one tile are too many to remember.
const MOST: usize = 1 << 20;

impl Tile {
    /// Draws pixels with a camera ray each, from outside of everything; the result is in their order.
    ///
    /// Of each the origin and the direction are given, which has the length 1.
    pub fn draw(&mut self, scene: &Scene, cameras: &[[Vec3; 2]]) -> &[Drawn] {
        self.pixels.clear();
        self.nodes.clear();
        self.wave.clear();
        self.last.clear();
        self.last.resize(scene.lights.len(), NONE);
        for (i, &[origin, direction]) in (0..).zip(cameras) {
            self.pixels.push(Drawn::default());
            self.nodes.push(LEAFLESS);
            self.wave.push(Ray {
                start: Start {
                    origin: origin.0,
                    direction: direction.0,
                    skin: 0.0,
                    left: NONE,
                    within: NONE,
                },
                weight: [1.0; 3],
                node: i,
                pixel: i,
                depth: 0,
                met: NONE,
            });
            if !(origin.is_finite() && direction.is_finite() && direction.any()) {
                self.pixels[i as usize].is_doubtful = true;
                self.wave.pop();
            }
        }
        while !self.wave.is_empty() {
            if self.nodes.len() > MOST {
                self.pixels.iter_mut().for_each(|p| p.is_doubtful = true);
                break;
            }
            self.step(scene);
            std::mem::swap(&mut self.wave, &mut self.next);
        }
        self.add_up();
        &self.pixels
    }

    /// Adds up the light of all rays of each pixel, in the order in which one ray after the other would bring it.
    fn add_up(&mut self) {
        for (root, pixel) in (0..).zip(&mut self.pixels) {
            let first = self.nodes[root as usize];
            let mut sum = first.light;
            let push = |pending: &mut Vec<u32>, node: Node| {
                let [mirrored, refracted] = node.children;
                if refracted != NONE {
                    pending.push(refracted);
                }
                if mirrored != NONE {
                    pending.push(mirrored);
                }
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
    fn step(&mut self, scene: &Scene) {
        self.next.clear();
        self.met.iter_mut().for_each(Vec::clear);
        for (i, ray) in (0..).zip(&mut self.wave) {
            let pixel = &mut self.pixels[ray.pixel as usize];
            let met = (scene.stage).first(&ray.start, &mut self.search, &mut pixel.tests);
            ray.met = met;
            match met {
                DOUBT => pixel.is_doubtful = true,
                NONE => {
                    let light = scene.background.times(Vec3(ray.weight));
                    self.nodes[ray.node as usize].light = light;
                }
                leaf => {
                    let leaf = &scene.stage.leaves[leaf as usize];
                    self.met[slot(leaf.kind, leaf.placement != 0)].push(i);
                }
            }
        }
        let wave = std::mem::take(&mut self.wave);
        for kind in KINDS {
            for is_placed in [false, true] {
                let slot = slot(kind, is_placed);
                let met = std::mem::take(&mut self.met[slot]);
                for some in met.chunks(WIDTH) {
                    let mut all = [some[0]; WIDTH];
                    all[..some.len()].copy_from_slice(some);
                    let four = Four::new(&wave, &scene.stage.leaves, all);
                    let live = ALL >> (WIDTH - some.len());
                    match kind {
                        Kind::Sphere => self.hits::<Spheres>(scene, (&four, live), is_placed),
                        Kind::Cuboid => self.hits::<Cuboids>(scene, (&four, live), is_placed),
                        Kind::Plane | Kind::HalfSpace => {
                            self.hits::<Planes>(scene, (&four, live), is_placed);
                        }
                        Kind::Rectangle => self.hits::<Rectangles>(scene, (&four, live), is_placed),
                    }
                }
                self.met[slot] = met;
            }
        }
        self.wave = wave;
    }

    /// What happens where four rays have met something.
    #[inline(never)]
    fn hits<S: Meet>(&mut self, scene: &Scene, (four, live): (&Four, u32), is_placed: bool) {
        let (origin, direction, exit) = (four.origin, four.direction, mask(four.exit));
        let resolved = match is_placed {
            false => S::meet(four.leaves, origin, direction, exit),
            true => {
                let place = |leaf: &Leaf| &scene.stage.placements[leaf.placement as usize];
                let [a, b, c, d] = four.leaves;
                let places = [place(a), place(b), place(c), place(d)];
                place::placed(places, origin, direction, |origin, direction| {
                    S::meet(four.leaves, origin, direction, exit)
                })
            }
        };
        let doubtful = live & !resolved.clear.to_bitmask();
        if doubtful != 0 {
            for lane in (0..WIDTH).filter(|lane| doubtful >> lane & 1 != 0) {
                self.pixels[four.rays[lane].pixel as usize].is_doubtful = true;
            }
        }
        let hits = Hits::new(four, live & !doubtful, &resolved);
        if scene.features.glass || scene.features.mirrors {
            self.follow(scene, four, &hits);
        }
        self.direct(scene, four, &hits);
    }

    /// Sends on what is mirrored and what goes through.
    #[inline(always)]
    fn follow(&mut self, scene: &Scene, four: &Four, hits: &Hits) {
        let splat = Lanes::splat;
        let weight = V3::gathered(four.rays, |ray| &ray.weight);
        let ks = V3::gathered(four.leaves, |leaf| &leaf.ks);
        let direction = four.direction;
        let mut mirrored = ks;
        let mut clear = 0;
        for lane in 0..WIDTH {
            clear |= u32::from(four.leaves[lane].is_clear) << lane;
        }
        clear &= hits.live;
        if scene.features.glass && clear != 0 {
            let kt = V3::gathered(four.leaves, |leaf| &leaf.kt);
            let mut straight = 0;
            for lane in 0..WIDTH {
                straight |= u32::from(four.leaves[lane].is_straight) << lane;
            }
            let inwards = gathered(four.leaves, |leaf| leaf.ratios[0]);
            let outwards = gathered(four.leaves, |leaf| leaf.ratios[1]);
            let ratio = either(hits.entering, inwards, outwards);
            let cosine = -direction.dot(hits.facing);
            let sine2 = (splat(1.0) - cosine * cosine).fast_max(Lanes::ZERO);
            let square = splat(1.0) - ratio * ratio * sine2;
            let bent = hits.facing * (ratio * cosine - square.fast_max(Lanes::ZERO).sqrt());
            let refracted = (direction * ratio + bent).unit();
            let through = V3::either(mask(straight), direction, refracted);
            let passes = straight | is_greater(square, Lanes::ZERO).to_bitmask();
            let total = clear & !passes;
            if total != 0 {
                mirrored = V3::either(mask(total), ks + kt, ks);
            }
            for lane in (0..WIDTH).filter(|lane| clear >> lane & 1 != 0) {
                let pixel = &mut self.pixels[four.rays[lane].pixel as usize];
                pixel.media += u32::from(straight >> lane & 1 == 0);
                pixel.total += total >> lane & 1;
            }
            let sent = self.send(
                scene,
                (four, hits),
                clear & passes,
                (through, weight.times(kt)),
                Way::Through { straight },
            );
            for lane in (0..WIDTH).filter(|lane| sent >> lane & 1 != 0) {
                self.pixels[four.rays[lane].pixel as usize].refraction += 1;
            }
        }
        let reflects = hits.live & mirrored.any();
        if scene.features.mirrors && reflects != 0 {
            let normal = hits.normal;
            let reflected = direction - normal * (splat(2.0) * normal.dot(direction));
            let reflected = reflected.unit();
            let sent = self.send(
                scene,
                (four, hits),
                reflects,
                (reflected, weight.times(mirrored)),
                Way::Back,
            );
            for lane in (0..WIDTH).filter(|lane| sent >> lane & 1 != 0) {
                self.pixels[four.rays[lane].pixel as usize].reflection += 1;
            }
        }
    }

    /// Sends rays on unless they are too deep or count for too little; returns which are sent.
    #[inline(always)]
    fn send(
        &mut self,
        scene: &Scene,
        (four, hits): (&Four, &Hits),
        goes: u32,
        (direction, weight): (V3, V3),
        way: Way,
    ) -> u32 {
        let cutoff = Lanes::splat(scene.limits.cutoff);
        let too_little = is_less(weight.max_component(), cutoff).to_bitmask();
        let mut sent = goes & weight.any() & !too_little;
        let origins = hits.point.columns();
        let directions = direction.columns();
        let weights = weight.columns();
        let skins = hits.skin.to_array();
        let entering = hits.entering.to_bitmask();
        for lane in 0..WIDTH {
            if sent >> lane & 1 == 0 {
                continue;
            }
            let from = four.rays[lane];
            let (is_straight, within, child) = match way {
                Way::Through { straight } => {
                    let within = if entering >> lane & 1 != 0 {
                        from.met
                    } else {
                        NONE
                    };
                    (straight >> lane & 1 != 0, within, 1)
                }
                Way::Back => (false, from.start.within, 0),
            };
            let depth = from.depth + u32::from(!is_straight);
            if depth > scene.limits.depth {
                sent &= !(1 << lane);
                continue;
            }
            let node = self.nodes.len() as u32;
            self.nodes.push(LEAFLESS);
            self.nodes[from.node as usize].children[child] = node;
            let at = |columns: &[[f64; WIDTH]; 3]| {
                [columns[0][lane], columns[1][lane], columns[2][lane]]
            };
            self.next.push(Ray {
                start: Start {
                    origin: at(&origins),
                    direction: at(&directions),
                    skin: skins[lane],
                    left: from.met,
                    within,
                },
                weight: at(&weights),
                node,
                pixel: from.pixel,
                depth,
                met: NONE,
            });
        }
        match way {
            // Straight on is always counted.
            Way::Through { straight } => sent | (goes & straight),
            Way::Back => sent,
        }
    }

    /// kd·C·(Σ ambient + Σ I·max(0, n·l)·V)
    #[inline(always)]
    fn direct(&mut self, scene: &Scene, four: &Four, hits: &Hits) {
        let splat = Lanes::splat;
        let albedo = V3::gathered(four.leaves, |leaf| &leaf.albedo);
        let lit = hits.live & albedo.any();
        if lit == 0 {
            return;
        }
        let mut light = V3::splat(scene.ambient);
        let points = hits.point.columns();
        let skins = hits.skin.to_array();
        for (number, lamp) in scene.lights.iter().enumerate() {
            if !lamp.power.any() {
                continue;
            }
            let way = V3::splat(lamp.position) - hits.point;
            let lean = hits.facing.dot(way);
            let length = way.abs().max_component();
            let sure = length * splat(UNIT_ROUNDOFF.sqrt()) + splat(UNIT_ROUNDOFF.powi(4));
            let cosine = hits.facing.dot(way.unit());
            let faces =
                is_greater(lean, sure) | (is_greater(cosine, Lanes::ZERO) & !is_less(lean, -sure));
            let faces = lit & faces.to_bitmask();
            if faces == 0 {
                continue;
            }
            let ways = way.columns();
            let mut seen = [[0.0; WIDTH]; 3];
            for lane in 0..WIDTH {
                if faces >> lane & 1 == 0 {
                    continue;
                }
                let ray = four.rays[lane];
                let is_seen =
                    !scene.features.shadows || (scene.is_alone && ray.start.within == NONE);
                let share = if is_seen {
                    Vec3::ONE
                } else {
                    let start = Start {
                        origin: [points[0][lane], points[1][lane], points[2][lane]],
                        direction: [ways[0][lane], ways[1][lane], ways[2][lane]],
                        skin: skins[lane],
                        left: ray.met,
                        within: ray.start.within,
                    };
                    let pixel = &mut self.pixels[ray.pixel as usize];
                    pixel.shadow += 1;
                    let last = &mut self.last[number];
                    match (scene.stage).light(&start, last, &mut self.search, &mut pixel.tests) {
                        Light::Dark => Vec3::ZERO,
                        Light::Seen(share) => {
                            pixel.transparent +=
                                u32::from(share != Vec3::ONE || ray.start.within != NONE);
                            share
                        }
                        Light::Doubtful => {
                            pixel.is_doubtful = true;
                            Vec3::ZERO
                        }
                    }
                };
                for i in 0..3 {
                    seen[i][lane] = share[i];
                }
            }
            let seen = V3([
                Lanes::new(seen[0]),
                Lanes::new(seen[1]),
                Lanes::new(seen[2]),
            ]);
            let visible = mask(faces & seen.any());
            let brighter = light + V3::splat(lamp.power).times(seen) * cosine;
            light = V3::either(visible, brighter, light);
        }
        let weight = V3::gathered(four.rays, |ray| &ray.weight);
        let light = albedo.times(light).times(weight).columns();
        for lane in (0..WIDTH).filter(|lane| lit >> lane & 1 != 0) {
            let node = &mut self.nodes[four.rays[lane].node as usize];
            node.light = Vec3([light[0][lane], light[1][lane], light[2][lane]]);
        }
    }
}

/// Where a ray goes from a surface.
#[derive(Clone, Copy)]
enum Way {
    /// To the other side, and where the bits are set as if there were nothing.
    Through {
        straight: u32,
    },
    Back,
}

/// Four rays and what they have met.
struct Four<'a> {
    rays: [&'a Ray; WIDTH],
    leaves: [&'a Leaf; WIDTH],
    origin: V3,
    direction: V3,
    /// The rays that come out of what they meet, as bits.
    exit: u32,
}

impl<'a> Four<'a> {
    #[inline(always)]
    fn new(wave: &'a [Ray], leaves: &'a [Leaf], [a, b, c, d]: [u32; WIDTH]) -> Four<'a> {
        let ray = |i: u32| &wave[i as usize];
        let rays = [ray(a), ray(b), ray(c), ray(d)];
        let leaf = |ray: &Ray| &leaves[ray.met as usize];
        let mut exit = 0;
        for (lane, ray) in rays.iter().enumerate() {
            exit |= u32::from(ray.start.within != NONE) << lane;
        }
        Four {
            rays,
            leaves: [leaf(rays[0]), leaf(rays[1]), leaf(rays[2]), leaf(rays[3])],
            origin: V3::gathered(rays, |ray| &ray.start.origin),
            direction: V3::gathered(rays, |ray| &ray.start.direction),
            exit,
        }
    }
}

/// Points of surfaces that four rays have met.
struct Hits {
    /// Lanes that count, as bits.
    live: u32,
    point: V3,
    normal: V3,
    /// The normals on the sides where the rays come from.
    facing: V3,
    skin: Lanes,
    /// Which rays go against the normal, as a mask.
    entering: Lanes,
}

impl Hits {
    #[inline(always)]
    fn new(four: &Four, live: u32, resolved: &Resolved) -> Hits {
        let splat = Lanes::splat;
        let Resolved { t, error, .. } = *resolved;
        let normal = resolved.normal.unit();
        let on_line = four.origin + four.direction * t;
        let terms = four.origin.abs() + (four.direction * t).abs();
        let off = (resolved.point - on_line).abs();
        // Points that a shape has found far from the line are taken from the line: see `strayed` in search/hit.rs.
        let most =
            terms * splat(8.0 * UNIT_ROUNDOFF) + four.direction.abs() * splat(f64::from_bits(1));
        let strays = is_greater(off.0[0], most.0[0])
            | is_greater(off.0[1], most.0[1])
            | is_greater(off.0[2], most.0[2]);
        let on_surface = normal.abs().dot(error);
        let in_line = normal
            .abs()
            .dot(terms * splat(8.0 * gamma(3)) + (off + error) * splat(4.0));
        let entering = is_less(normal.dot(four.direction), Lanes::ZERO);
        Hits {
            live,
            point: V3::either(strays, on_line, resolved.point),
            normal,
            facing: V3::either(entering, normal, -normal),
            skin: either(strays, in_line, on_surface),
            entering,
        }
    }
}
