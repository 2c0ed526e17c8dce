//! The light that comes back along a ray.

use super::arbiter::Arbiter;
use super::precision::Precision;
use super::ray::Ray;
use super::search::escalate::Walkers;
use super::search::hit::Hit;
use super::stats::{Cost, Counts, Intersections, Rays, Work};
use super::tracer::{Light, Tracer};
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::scene::{Optics, Rgb};

/// Limits beyond which a path of light is given up.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Rays deeper than this contribute nothing; a camera ray has depth 0.
    pub depth: u32,
    /// Rays whose weight is below this in every channel contribute nothing.
    pub cutoff: f64,
}

/// The parts of the shading code that a plan calls for. The others do not run.
#[derive(Debug, Clone, Copy)]
pub struct Features {
    pub shadows: bool,
    pub glass: bool,
    /// Whether there are mirrors and total reflection.
    pub mirrors: bool,
    pub dispersion: bool,
}

/// A ray that waits to be followed, and the weight of its light per channel.
#[derive(Debug, Clone, Copy)]
struct Branch<R: Precision> {
    ray: Ray<R>,
    weight: Vec3,
    depth: u32,
    /// The share of light that a sheet lets through, for a ray that looks for the face of a solid behind a sheet in the
    /// same place; `None` for other rays. The ray starts at the origin of the ray that met the sheet.
    sheet: Option<Vec3>,
}

/// Computes the light along rays, on one thread.
pub struct Shader<'t, R: Precision = f64> {
    tracer: &'t Tracer,
    /// The sum of the scene's ambient lights.
    ambient: Vec3,
    lights: &'t [Light],
    limits: Limits,
    features: Features,
    walkers: Walkers<'t, R>,
    rays: Rays,
    /// The number of rays that were sent on in some of the colour channels only.
    parted: u64,
    /// How often light has met a surface with different refractive indices before and behind it.
    media: u64,
    branches: Vec<Branch<R>>,
}

impl<'t, R: Precision> Shader<'t, R> {
    pub fn new(
        tracer: &'t Tracer,
        lights: &'t [Light],
        limits: Limits,
        features: Features,
    ) -> Shader<'t, R> {
        Shader {
            tracer,
            ambient: tracer.ambient,
            lights,
            limits,
            features,
            walkers: tracer.walker(),
            rays: Rays::default(),
            parted: 0,
            media: 0,
            branches: Vec::new(),
        }
    }

    /// Sets all counts to 0.
    pub fn reset(&mut self) {
        self.rays = Rays::default();
        (self.parted, self.media) = (0, 0);
        self.walkers.reset();
    }

    /// The counts since the last reset.
    pub fn counts(&self) -> Counts {
        let Rays {
            shadow,
            reflection,
            refraction,
            ..
        } = self.rays;
        Counts {
            rays: self.rays,
            intersections: self.walkers.intersections(),
            work: Work {
                shadow,
                reflection,
                refraction,
                channel_split: self.parted,
                medium_change: self.media,
                ..self.walkers.work()
            },
            uncertain: self.walkers.uncertain(),
            quick: 0,
        }
    }

    /// Intersection tests since the last reset, and how often light was totally reflected.
    pub fn spent(&self) -> [u64; 2] {
        let Intersections { boxes, shape } = self.walkers.intersections();
        [boxes + shape, self.rays.total]
    }

    /// The cost of a sample, or of a part of one, that began when [`spent`](Self::spent) returned `before`.
    pub fn cost_since(&self, before: [u64; 2]) -> Cost {
        let [tests, total] = self.spent();
        Cost {
            tests: u32::try_from(tests - before[0]).unwrap_or(u32::MAX),
            total_reflection: total > before[1],
            slow: 1,
        }
    }

    /// The light along a camera ray.
    ///
    /// Reflected and refracted rays wait on a stack with their weights. Nothing is recursive, so any depth is possible.
    pub fn radiance(&mut self, ray: &Ray<R>) -> Rgb {
        self.rays.camera += 1;
        let mut sum = self.light_along(ray, (Vec3::ONE, 0));
        self.follow_branches(|light| sum = sum + light);
        sum.0
    }

    /// Follows the rays that wait, and the rays that these give rise to. Calls `add` with the light of each.
    fn follow_branches(&mut self, mut add: impl FnMut(Vec3)) {
        while let Some(Branch {
            ray,
            weight,
            depth,
            sheet,
        }) = self.branches.pop()
        {
            add(match sheet {
                None => self.light_along(&ray, (weight, depth)),
                Some(kt) => self.light_behind_sheet(&ray, (weight, depth), kt),
            });
        }
    }

    /// The light that the first surface on a ray sends back by itself, or that of the background, times the weight.
    /// Reflected and refracted rays are put on the stack.
    fn light_along(&mut self, ray: &Ray<R>, (weight, depth): (Vec3, u32)) -> Vec3 {
        let hit = match self.features.glass {
            false => self.walkers.first_hit::<false>(ray),
            true => self.walkers.first_hit::<true>(ray),
        };
        let light = match &hit {
            Some(hit) => {
                if self.features.glass || self.features.mirrors {
                    self.follow(ray, (weight, depth), hit, None);
                }
                self.direct(hit, None)
            }
            None => self.tracer.background,
        };
        light.times(weight)
    }

    /// The light of the face of a solid that a sheet lies in, times the weight. Lamps light the face through the sheet,
    /// and what the face mirrors goes back through the sheet. The face's mirror image of the sheet's underside is left
    /// out.
    #[inline(never)]
    fn light_behind_sheet(&mut self, ray: &Ray<R>, (weight, depth): (Vec3, u32), kt: Vec3) -> Vec3 {
        match self.walkers.face_behind_sheet(ray) {
            Some(hit) => {
                self.follow(ray, (weight, depth), &hit, Some(kt));
                self.direct(&hit, Some(kt)).times(weight)
            }
            None => self.tracer.background.times(weight),
        }
    }

    /// The diffuse light of a surface of colour C: kd·C·(Σ ambient + Σ I·max(0, n·l)·V), with I the power of a point
    /// light, l the direction to it and V its visibility.
    ///
    /// `sheet` is the share of light that a sheet before the surface lets through, if there is one. Point lights are
    /// seen through the sheet.
    fn direct(&mut self, hit: &Hit<R>, sheet: Option<Vec3>) -> Vec3 {
        let albedo = Vec3(self.optics(hit).kd).times(Vec3(hit.colour));
        if !albedo.any() {
            return Vec3::ZERO;
        }
        let normal = hit.facing();
        // All shadow rays leave the surface in the same way, so one ray serves for all and only its line is replaced.
        let mut ray = hit.leave(normal, false);
        let mut light = self.ambient;
        for &Light { position, power } in self.lights {
            let way = position.cast() - hit.point;
            // The unit vector to a light is needed only if the light is seen. The sign of `lean` tells whether the
            // light is behind the surface: it is the sign of the cosine, unless `lean` is small beside the length of
            // the way.
            let lean = normal.dot(way);
            let length = way.abs().max_component();
            let sure = length * R::ROUNDOFF.sqrt() + R::ROUNDOFF.square().square();
            if lean < -sure || !power.any() {
                continue;
            }
            let cosine = || normal.dot(way.unit()).to_f64();
            if lean > sure || cosine() > 0.0 {
                ray.line = Line::new(hit.point, way);
                let seen = self.visibility(hit, &ray);
                if seen.any() {
                    let power = sheet.map_or(power, |kt| power.times(kt));
                    light = light + power.times(seen) * cosine();
                }
            }
        }
        albedo.times(light)
    }

    fn optics(&self, hit: &Hit<R>) -> &'t Optics {
        &self.tracer.graph.optics[hit.optics as usize]
    }

    /// The share of light, per channel, that reaches a hit from a lamp at t = 1 on `ray`. Nothing is in the way if
    /// there are no shadows, or outside of a lone convex shape.
    fn visibility(&mut self, hit: &Hit<R>, ray: &Ray<R>) -> Vec3 {
        if !self.features.shadows || (self.tracer.plan.lone_convex && !hit.inside[0]) {
            return Vec3::ONE;
        }
        self.rays.shadow += 1;
        self.share(ray)
    }

    /// The share of light, per channel, that the surfaces on a ray up to t = 1 let through.
    fn share(&mut self, ray: &Ray<R>) -> Vec3 {
        let clear = self.features.glass && !self.tracer.graph.without.transparent_shadows;
        match clear {
            false => self.walkers.visibility::<false>(ray),
            true => self.walkers.visibility::<true>(ray),
        }
    }

    /// Puts the reflected and the refracted rays of a hit on the stack. `sheet` is the share of light that a sheet
    /// before the surface lets through, if there is one. Reflected light goes back through the sheet.
    fn follow(
        &mut self,
        ray: &Ray<R>,
        (weight, depth): (Vec3, u32),
        hit: &Hit<R>,
        sheet: Option<Vec3>,
    ) {
        let direction = ray.line.direction;
        let optics = self.optics(hit);
        let mut mirrored = Vec3(optics.ks);
        let mut todo = match self.features.glass {
            false => Vec3::ZERO,
            true => Vec3(optics.kt),
        };
        let indices = &self.tracer.graph.indices;
        let around = each(hit.indices, |index| indices[index as usize]);
        while let Some(c) = (0..3).find(|&c| todo[c] != 0.0) {
            // Colour channels with the same refraction are followed as one ray.
            let ratio = |c: usize| (around[0][c], around[1][c]);
            let mut through = Vec3::ZERO;
            if !self.features.dispersion {
                through = std::mem::replace(&mut todo, Vec3::ZERO);
            } else {
                let all = todo;
                // A channel with one index on both sides is not bent, whatever the index is. So all those channels go
                // on as one ray.
                let bend = |c: usize| Some(ratio(c)).filter(|(before, behind)| before != behind);
                for other in (c..3).filter(|&o| bend(o) == bend(c)) {
                    through[other] = std::mem::take(&mut todo[other]);
                }
                self.parted += u64::from(through != all);
            }
            let (before, behind) = ratio(c);
            self.media += u64::from(before != behind);
            if before == behind {
                // Light that is not bent does not count towards the depth.
                let weight = weight.times(through);
                match hit.in_face {
                    // A ray that left the sheet could not tell the face, which is in the same place, from its own
                    // start. So the search for the face starts at the origin of this ray.
                    true => self.branch(*ray, weight, depth, Some(Vec3(optics.kt))),
                    false => self.branch(hit.leave(direction, true), weight, depth, None),
                };
                self.rays.refraction += 1;
            } else if let Some(refracted) =
                refract(direction, hit.facing(), R::of(before) / R::of(behind))
            {
                let ray = hit.leave(refracted, true);
                if self.branch(ray, weight.times(through), depth + 1, None) {
                    self.rays.refraction += 1;
                }
            } else {
                mirrored = mirrored + through;
                self.rays.total += 1;
            }
        }
        if self.features.mirrors && mirrored.any() {
            let normal = hit.shading;
            let reflected = direction - normal * (R::of(2.0) * normal.dot(direction));
            let ray = hit.leave(reflected.unit(), false);
            let mirrored = sheet.map_or(mirrored, |kt| mirrored.times(kt));
            if self.branch(ray, weight.times(mirrored), depth + 1, None) {
                self.rays.reflection += 1;
            }
        }
    }

    /// Puts a ray on the stack unless it is too deep or its weight is too small. Returns whether it did. For `sheet`
    /// see [`Branch`].
    fn branch(&mut self, ray: Ray<R>, weight: Vec3, depth: u32, sheet: Option<Vec3>) -> bool {
        let counts = weight.any() && weight.max_component() >= self.limits.cutoff;
        let goes = counts && depth <= self.limits.depth && ray.line.direction.any();
        if goes {
            self.branches.push(Branch {
                ray,
                weight,
                depth,
                sheet,
            });
        }
        goes
    }
}

impl<R: Precision> Arbiter for Shader<'_, R> {
    fn radiance(&mut self, ray: &Ray, weight: Vec3, depth: u32, light: &mut Vec<Vec3>) -> Cost {
        let before = self.spent();
        light.push(self.light_along(&ray.cast(), (weight, depth)));
        self.follow_branches(|more| light.push(more));
        self.cost_since(before)
    }

    fn visibility(&mut self, ray: &Ray) -> (Vec3, Cost) {
        let before = self.spent();
        let share = self.share(&ray.cast());
        (share, self.cost_since(before))
    }
}

/// Snell's law: the unit direction of a ray behind a surface; `None` if all light is reflected. `d` is the unit
/// direction before the surface, `n` the unit normal on the side that the ray comes from, and `ratio` the refractive
/// index before the surface over the index behind it.
pub fn refract<R: Real>(d: Vec3<R>, n: Vec3<R>, ratio: R) -> Option<Vec3<R>> {
    let cosine = -d.dot(n);
    let square = R::ONE - ratio * ratio * (R::ONE - cosine * cosine).max(R::ZERO);
    (square > R::ZERO).then(|| (d * ratio + n * (ratio * cosine - square.sqrt())).unit())
}
