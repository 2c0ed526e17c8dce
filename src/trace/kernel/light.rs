//! The light of lamps on the places that a wave has met.

use super::bundle::{Around, BUNDLE_MIN_RAYS};
use super::lanes::{LANES, Lanes, V3, is_greater, is_less, mask};
use super::packet::Packet;
use super::query::Start;
use super::shade::{Four, Hits};
use super::shadow::Light;
use super::wave::{Scene, Tile};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::{UNIT_ROUNDOFF, Vec3};
use crate::trace::arbiter::Arbiter;
use crate::trace::tracer;

/// Four places that lamps may shine on.
#[derive(Debug)]
pub struct Lit {
    /// The lanes that hold a place, as bits.
    live: u32,
    point: V3,
    /// The normals on the sides where the rays come from.
    facing: V3,
    /// The starts of rays to lamps.
    starts: [Start; LANES],
    albedo: V3,
    weight: V3,
    /// The light that has been added up: the ambient light and the lamps that are done.
    light: V3,
    pixels: [u32; LANES],
    nodes: [u32; LANES],
}

impl Tile {
    /// Notes four places for [`illuminate`](Self::illuminate).
    #[inline(always)]
    pub(super) fn note_lit(&mut self, scene: &Scene, four: &Four, hits: &Hits) {
        let live = hits.live & hits.albedo.any();
        if live == 0 {
            return;
        }
        let points = hits.point.columns();
        let skins = hits.skin.to_array();
        let entering = hits.entering.to_bitmask();
        self.lit.push(Lit {
            live,
            point: hits.point,
            facing: hits.facing(),
            starts: each([0, 1, 2, 3], |lane: usize| Start {
                origin: [points[0][lane], points[1][lane], points[2][lane]],
                direction: [0.0; 3],
                skin: skins[lane],
                left: four.leaves[lane].twin,
                face: four.hits[lane].crossing.root.face,
                goes_in: entering >> lane & 1 == 0,
                within: four.hits[lane].sides[0],
            }),
            albedo: hits.albedo,
            weight: V3::gathered(four.rays, |ray| &ray.weight),
            light: V3::splat(scene.ambient),
            pixels: each(four.rays, |ray| ray.pixel),
            nodes: each(four.rays, |ray| ray.node),
        });
    }

    /// Computes kd·C·(Σ ambient + Σ I·max(0, n·l)·V), the diffuse light, for all places of the wave.
    #[inline(never)]
    pub(super) fn illuminate(&mut self, scene: &Scene, arbiter: &mut dyn Arbiter) {
        let mut lit = std::mem::take(&mut self.lit);
        let (mut around, mut count) = (Around::NOTHING, 0);
        if scene.features.shadows {
            for four in &lit {
                for lane in (0..LANES).filter(|lane| four.live >> lane & 1 != 0) {
                    around.add(four.starts[lane].origin);
                    count += 1;
                }
            }
        }
        let is_bundle = count >= BUNDLE_MIN_RAYS;
        let around = around.bounds();
        for (number, lamp) in scene.lights.iter().enumerate() {
            if !lamp.power.any() {
                continue;
            }
            let is_known = is_bundle && self.find_shaft(scene, &around, lamp);
            for four in &mut lit {
                self.shine((scene, arbiter), (number, lamp), four, is_known);
            }
        }
        for four in &lit {
            let light = four.albedo.times(four.light).times(four.weight).columns();
            for lane in (0..LANES).filter(|lane| four.live >> lane & 1 != 0) {
                let node = &mut self.nodes[four.nodes[lane] as usize];
                node.light = Vec3([light[0][lane], light[1][lane], light[2][lane]]);
            }
        }
        self.lit = lit;
    }

    /// Finds the blocks between a lamp and all places in the box `around`; `false` if it does not pay to share them.
    fn find_shaft(&mut self, scene: &Scene, around: &Aabb, lamp: &tracer::Light) -> bool {
        let steps = each([around.min, around.max], |corner| {
            lamp.position - Vec3(corner)
        });
        self.along.find(scene.stage, around, steps, 1.0)
    }

    /// Adds the light of a lamp to four places. `is_known`: whether `along` holds the blocks between them and the lamp.
    #[inline(always)]
    fn shine(
        &mut self,
        (scene, arbiter): (&Scene, &mut dyn Arbiter),
        (number, lamp): (usize, &tracer::Light),
        four: &mut Lit,
        is_known: bool,
    ) {
        let splat = Lanes::splat;
        let way = V3::splat(lamp.position) - four.point;
        let lean = four.facing.dot(way);
        let length = way.abs().max_component();
        let sure = length * splat(UNIT_ROUNDOFF.sqrt()) + splat(UNIT_ROUNDOFF.powi(4));
        let cosine = four.facing.dot(way.unit());
        let faces =
            is_greater(lean, sure) | (is_greater(cosine, Lanes::ZERO) & !is_less(lean, -sure));
        let faces = four.live & faces.to_bitmask();
        if faces == 0 {
            return;
        }
        let ways = way.columns();
        for (lane, start) in four.starts.iter_mut().enumerate() {
            start.direction = [ways[0][lane], ways[1][lane], ways[2][lane]];
        }
        let mut dark = 0;
        if is_known {
            let packet = Packet::new(four.starts.each_ref(), faces);
            dark = scene.stage.shadows_of_four(&mut self.along, &packet);
        }
        let mut seen = [Vec3::ZERO; LANES];
        for (lane, seen) in seen.iter_mut().enumerate() {
            if faces >> lane & 1 == 0 {
                continue;
            }
            let start = &four.starts[lane];
            let is_seen =
                !scene.features.shadows || (scene.is_lone_convex && start.within.is_empty());
            *seen = if is_seen {
                Vec3::ONE
            } else {
                let pixel = &mut self.pixels[four.pixels[lane] as usize];
                pixel.shadow += 1;
                let last = &mut self.last[number];
                let along = is_known.then_some(&self.along.blocks[lane][..]);
                let scratch = &mut self.search;
                if dark >> lane & 1 != 0 {
                    continue;
                }
                match (scene.stage).light(start, along, last, scratch, &mut pixel.tests) {
                    Light::Dark => Vec3::ZERO,
                    Light::Seen(share) => {
                        let is_through = share != Vec3::ONE || !start.within.is_empty();
                        pixel.transparent += u32::from(is_through);
                        share
                    }
                    Light::Doubtful => {
                        let (share, cost) = arbiter.visibility(&scene.stage.ray(start));
                        pixel.asked += cost;
                        share
                    }
                }
            };
        }
        let seen = V3::gathered(seen.each_ref(), |share| &share.0);
        let visible = mask(faces & seen.any());
        let brighter = four.light + V3::splat(lamp.power).times(seen) * cosine;
        four.light = V3::either(visible, brighter, four.light);
    }
}
