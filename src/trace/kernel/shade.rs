//! Where rays go from the surfaces that they meet, four at a time.

use super::lanes::{LANES, Lanes, V3, either, gathered, is_greater, is_less, lanes_where, mask};
use super::leaf::Leaf;
use super::look::Way;
use super::query::{Start, Within};
use super::resolved::Resolved;
use super::stage::Stage;
use super::wave::{Hit, MIRRORED, Ray, RayNode, Scene, Tile};
use crate::geometry::array::each;
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};

impl Tile {
    /// Sends rays on from the points where four rays have met something, and notes the points for the light of the
    /// lamps.
    #[inline(always)]
    pub(super) fn shade(&mut self, scene: &Scene, four: &Four, hits: &Hits) {
        if scene.features.glass || scene.features.mirrors {
            self.follow(scene, four, hits);
        }
        self.note_lit(scene, four, hits);
    }

    /// Sends on the mirrored rays and the rays that go through.
    #[inline(always)]
    fn follow(&mut self, scene: &Scene, four: &Four, hits: &Hits) {
        let splat = Lanes::splat;
        let weight = V3::gathered(four.rays, |ray| &ray.weight);
        let ks = V3::gathered(four.leaves, |leaf| &leaf.look.ks);
        let direction = four.direction;
        let mut mirrored = ks;
        let clear = hits.live & lanes_where(|lane| four.leaves[lane].is_clear);
        if scene.features.glass && clear != 0 {
            let from_one_into_another;
            let mut ways = each(four.leaves, |leaf| {
                &leaf.look.ways[..leaf.look.way_count as usize]
            });
            let is_between = |lane: usize| {
                let sides = four.hits[lane].sides;
                four.leaves[lane].is_solid && sides.iter().all(|side| !side.is_empty())
            };
            let between = clear & lanes_where(is_between);
            if between != 0 {
                from_one_into_another = self.ways_between(scene.stage, four);
                for lane in (0..LANES).filter(|lane| between >> lane & 1 != 0) {
                    let (all, count) = &from_one_into_another[lane];
                    ways[lane] = &all[..*count as usize];
                }
            }
            let most = ways.into_iter().fold(0, |most, ways| ways.len().max(most));
            for number in 0..most {
                let goes = clear & lanes_where(|lane| number < ways[lane].len());
                let ways = each(ways, |ways| ways.get(number).unwrap_or(&Way::NONE));
                let total = self.refract(scene, (four, hits), goes, (weight, ways, number));
                if total != 0 {
                    let kt = V3::gathered(ways, |way| &way.kt);
                    mirrored = V3::either(mask(total), mirrored + kt, mirrored);
                }
            }
            if most > 1 {
                for lane in (0..LANES).filter(|lane| clear >> lane & 1 != 0) {
                    let parted = ways[lane].len() as u32 - 1;
                    self.pixels[four.rays[lane].pixel as usize].parted += parted;
                }
            }
        }
        let reflects = hits.live & mirrored.any();
        if scene.features.mirrors && reflects != 0 {
            let normal = hits.shading;
            let reflected = direction - normal * (splat(2.0) * normal.dot(direction));
            let reflected = reflected.unit();
            let sent = self.send(
                scene,
                (four, hits),
                reflects,
                (reflected, weight.times(mirrored)),
                Goes::Back,
            );
            for lane in (0..LANES).filter(|lane| sent >> lane & 1 != 0) {
                self.pixels[four.rays[lane].pixel as usize].reflection += 1;
            }
        }
    }

    /// The ways of light through surfaces with a solid on both sides, and their number; no ways where a solid is
    /// missing.
    #[cold]
    fn ways_between(&self, stage: &Stage, four: &Four) -> [([Way; 3], u32); LANES] {
        each([0, 1, 2, 3], |lane: usize| {
            let owner = |side: Within| stage.leaves.get(side.owner() as usize);
            let [Some(before), Some(behind)] = four.hits[lane].sides.map(owner) else {
                return ([Way::NONE; 3], 0);
            };
            let kt = four.leaves[lane].look.kt;
            let may_part = !stage.graph.without.dispersion;
            let (ways, count) = Way::through(kt, before.look.index, behind.look.index, may_part);
            let both = |way: Way| Way {
                ratios: [way.ratios[0]; 2],
                ..way
            };
            (each(ways, both), count)
        })
    }

    /// Sends on the rays that go through by one of the ways of each leaf, which has the index `way`. Returns, as bits,
    /// the rays that are totally reflected.
    #[inline(always)]
    fn refract(
        &mut self,
        scene: &Scene,
        (four, hits): (&Four, &Hits),
        goes: u32,
        (weight, ways, way): (V3, [&Way; LANES], usize),
    ) -> u32 {
        let splat = Lanes::splat;
        let straight = lanes_where(|lane| ways[lane].is_straight);
        let inwards = gathered(ways, |way| way.ratios[0]);
        let outwards = gathered(ways, |way| way.ratios[1]);
        let ratio = either(mask(four.exits_solid), outwards, inwards);
        let (direction, facing) = (four.direction, hits.facing());
        let cosine = -direction.dot(facing);
        let sine2 = (splat(1.0) - cosine * cosine).fast_max(Lanes::ZERO);
        let square = splat(1.0) - ratio * ratio * sine2;
        let bent = facing * (ratio * cosine - square.fast_max(Lanes::ZERO).sqrt());
        let refracted = (direction * ratio + bent).unit();
        let through = V3::either(mask(straight), direction, refracted);
        let passes = straight | is_greater(square, Lanes::ZERO).to_bitmask();
        let total = goes & !passes;
        for lane in (0..LANES).filter(|lane| goes >> lane & 1 != 0) {
            let pixel = &mut self.pixels[four.rays[lane].pixel as usize];
            pixel.media += u32::from(straight >> lane & 1 == 0);
            pixel.total += total >> lane & 1;
        }
        let kt = V3::gathered(ways, |way| &way.kt);
        let sent = self.send(
            scene,
            (four, hits),
            goes & passes,
            (through, weight.times(kt)),
            Goes::Through { straight, way },
        );
        for lane in (0..LANES).filter(|lane| sent >> lane & 1 != 0) {
            self.pixels[four.rays[lane].pixel as usize].refraction += 1;
        }
        total
    }

    /// Sends rays on unless they are too deep or count for too little. Returns, as bits, the rays that are sent, and
    /// all that go straight on.
    #[inline(always)]
    fn send(
        &mut self,
        scene: &Scene,
        (four, hits): (&Four, &Hits),
        goes: u32,
        (direction, weight): (V3, V3),
        goes_on: Goes,
    ) -> u32 {
        let cutoff = Lanes::splat(scene.limits.cutoff);
        let too_little = is_less(weight.max_component(), cutoff).to_bitmask();
        let mut sent = goes & weight.any() & !too_little;
        let origins = hits.point.columns();
        let directions = direction.columns();
        let weights = weight.columns();
        let skins = hits.skin.to_array();
        let entering = hits.entering.to_bitmask();
        for lane in 0..LANES {
            if sent >> lane & 1 == 0 {
                continue;
            }
            let (from, hit) = (four.rays[lane], four.hits[lane]);
            let (is_straight, within, child) = match goes_on {
                Goes::Through { straight, way } => (straight >> lane & 1 != 0, hit.sides[1], way),
                Goes::Back => (false, hit.sides[0], MIRRORED),
            };
            let is_entering = entering >> lane & 1 != 0;
            let depth = from.depth + u32::from(!is_straight);
            if depth > scene.limits.depth {
                sent &= !(1 << lane);
                continue;
            }
            let node = self.nodes.len() as u32;
            self.nodes.push(RayNode::DARK);
            self.nodes[from.node as usize].children[child] = node;
            let at = |columns: &[[f64; LANES]; 3]| {
                [columns[0][lane], columns[1][lane], columns[2][lane]]
            };
            self.next.push(Ray {
                start: Start {
                    origin: at(&origins),
                    direction: at(&directions),
                    skin: skins[lane],
                    left: four.leaves[lane].twin,
                    face: hit.crossing.root.face,
                    goes_in: is_entering == matches!(goes_on, Goes::Through { .. }),
                    within,
                },
                weight: at(&weights),
                node,
                pixel: from.pixel,
                depth,
            });
        }
        match goes_on {
            // A ray that goes straight on counts as refracted, sent or not.
            Goes::Through { straight, .. } => sent | (goes & straight),
            Goes::Back => sent,
        }
    }
}

/// Where rays go from a surface.
#[derive(Clone, Copy)]
enum Goes {
    /// To the other side, by the way of each leaf with the index `way`. `straight` are the rays, as bits, that go on
    /// without being bent.
    Through {
        straight: u32,
        way: usize,
    },
    Back,
}

/// Four rays and what they have met.
pub struct Four<'a> {
    pub rays: [&'a Ray; LANES],
    pub hits: [&'a Hit; LANES],
    pub leaves: [&'a Leaf; LANES],
    pub origin: V3,
    pub direction: V3,
    /// The rays that come out of the leaf that they meet, as bits.
    pub exits_leaf: u32,
    /// The rays that come out of a solid that they start in, as bits.
    pub exits_solid: u32,
}

impl<'a> Four<'a> {
    /// Packs one to four hits. The lanes that are left over repeat the last hit.
    #[inline(always)]
    pub fn new(wave: &'a [Ray], leaves: &'a [Leaf], hits: &'a [Hit]) -> Four<'a> {
        let hits = each([0, 1, 2, 3], |lane: usize| &hits[lane.min(hits.len() - 1)]);
        let rays = each(hits, |hit| &wave[hit.ray as usize]);
        let solids = each(hits, |hit| &leaves[hit.crossing.surface as usize]);
        Four {
            rays,
            hits,
            leaves: solids,
            origin: V3::gathered(rays, |ray| &ray.start.origin),
            direction: V3::gathered(rays, |ray| &ray.start.direction),
            exits_leaf: lanes_where(|lane| hits[lane].crossing.is_exit),
            exits_solid: lanes_where(|lane| rays[lane].start.within.has(solids[lane].solid)),
        }
    }
}

/// Points of surfaces that four rays have met.
pub struct Hits {
    /// The lanes that hold a hit, as bits.
    pub live: u32,
    pub point: V3,
    /// The unit normals for shading.
    pub shading: V3,
    /// The share of diffuse light.
    pub albedo: V3,
    pub skin: Lanes,
    /// The rays that go against the normal, as a mask.
    pub entering: Lanes,
}

impl Hits {
    #[inline(always)]
    pub fn new(four: &Four, live: u32, resolved: &Resolved) -> Hits {
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
            shading: normal,
            albedo: V3::gathered(four.leaves, |leaf| &leaf.look.albedo),
            skin: either(strays, in_line, on_surface),
            entering,
        }
    }
    /// The normals on the sides where the rays come from.
    #[inline(always)]
    pub fn facing(&self) -> V3 {
        V3::either(self.entering, self.shading, -self.shading)
    }
}
