//! Where two programs see the surfaces of a scene: position, normal and shape, pixel by pixel.

use rayon::prelude::*;
use serde::Serialize;

use super::mitsuba::CHANNELS;
use crate::scene::{Aabb, Camera, Vec3};
use crate::trace::camera::View;
use crate::trace::ray::Ray;
use crate::trace::{Tracer, Walkers};
use crate::translate::mitsuba::{Output, ShapeInfo};

/// What is seen first through a pixel.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    pub point: Vec3,
    /// The shading normal, unit.
    pub normal: Vec3,
    pub distance: f64,
    /// As in [`crate::trace::Crossing`].
    pub shape: u32,
    pub object: u32,
}

/// What our tracer sees, row by row.
pub fn seen(tracer: &Tracer, camera: &Camera, (width, height): (u32, u32)) -> Vec<Option<Seen>> {
    let Some(view) = View::new(camera, width, height) else {
        return vec![None; width as usize * height as usize];
    };
    let rows = (0..height).into_par_iter().map_init(
        || tracer.walker(),
        |walkers: &mut Walkers<f64>, y| {
            let pixel = |x: u32| {
                let ray = view.ray(f64::from(x) + 0.5, f64::from(y) + 0.5)?;
                let probe = tracer.probe(walkers, &ray);
                probe.crossings.first().map(|c| Seen {
                    point: c.hit.point.0,
                    normal: c.hit.shading.0,
                    distance: c.hit.t * ray.line.direction.length(),
                    shape: c.shape,
                    object: c.object,
                })
            };
            (0..width).map(pixel).collect::<Vec<_>>()
        },
    );
    rows.flatten().collect()
}

/// Positions may differ by so much of the scene's size on exact shapes.
const EXACT: f64 = 1e-4;
/// What is so many sizes of the scene away is rounded more: single precision has seven digits.
const FAR: f64 = 30.0;
/// What is seen so near to where parts without end are cut off may be seen beyond that.
const HORIZON: f64 = 0.9;
/// By so much of the largest coordinate single precision may mistake a place, after a few operations.
const ROUNDED: f64 = 4.0 * f32::EPSILON as f64;

/// How two sights compare.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    pub pixels: usize,
    /// Where a neighbour shows another shape, another face or a fold, or where parts without end are
    /// cut off in the translation: not compared.
    pub silhouettes: usize,
    /// Where single precision, in which Mitsuba computes, does not tell what is seen from something
    /// else that is nearly there: not compared.
    pub undecided: usize,
    /// Another shape, or another place than allowed.
    pub wrong: usize,
    /// Of all pixels.
    pub share_wrong: f64,
    pub exact: Differences,
    pub meshes: Differences,
    #[serde(skip)]
    map: Vec<Pixel>,
}

/// The largest differences on shapes of a kind.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Differences {
    pub pixels: usize,
    /// Across our surface, in units of the scene.
    pub distance: f64,
    /// The same as a part of what is allowed.
    pub distance_by_allowed: f64,
    /// Between the shading normals, in degrees.
    pub angle: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Pixel {
    Silhouette,
    Undecided,
    Wrong,
    /// By how much of what is allowed it is off.
    Right(f64),
}

/// Compares what Mitsuba has written with what we see; `None` where it is of another size.
pub fn compare(
    tracer: &Tracer,
    camera: &Camera,
    ours: &[Option<Seen>],
    theirs: &[f32],
    (width, height): (u32, u32),
    translation: &Output,
) -> Option<Comparison> {
    if theirs.len() != CHANNELS * ours.len() {
        return None;
    }
    let Output { extent, frame, .. } = translation;
    let mut all = extent
        .region
        .hull(&Aabb::new(camera.position, camera.position));
    (all.min, all.max) = (frame.place(all.min), frame.place(all.max));
    let largest = all
        .min
        .iter()
        .chain(&all.max)
        .fold(0.0f64, |m, x| m.max(x.abs()));
    let sight = Sight {
        tracer,
        view: View::new(camera, width, height),
        ours,
        theirs,
        width: width as usize,
        translation,
        size: 2.0 * extent.radius,
        rounded: ROUNDED * largest / frame.scale,
    };
    let mut comparison = Comparison {
        pixels: ours.len(),
        silhouettes: 0,
        undecided: 0,
        wrong: 0,
        share_wrong: 0.0,
        exact: Differences::default(),
        meshes: Differences::default(),
        map: Vec::with_capacity(ours.len()),
    };
    for i in 0..ours.len() {
        let pixel = sight.pixel(i, &mut comparison);
        match pixel {
            Pixel::Silhouette => comparison.silhouettes += 1,
            Pixel::Undecided => comparison.undecided += 1,
            Pixel::Wrong => comparison.wrong += 1,
            Pixel::Right(_) => {}
        }
        comparison.map.push(pixel);
    }
    comparison.share_wrong = comparison.wrong as f64 / comparison.pixels.max(1) as f64;
    Some(comparison)
}

struct Sight<'a> {
    tracer: &'a Tracer,
    view: Option<View>,
    ours: &'a [Option<Seen>],
    theirs: &'a [f32],
    width: usize,
    translation: &'a Output,
    size: f64,
    /// By how much single precision may mistake a place.
    rounded: f64,
}

impl Sight<'_> {
    /// What of theirs is seen in a pixel: point, normal and shape.
    fn other(&self, i: usize) -> (Vec3, Vec3, Option<&ShapeInfo>) {
        let c = &self.theirs[CHANNELS * i..][..CHANNELS];
        let vector = |first: usize| std::array::from_fn(|k| f64::from(c[first + k]));
        let index = c[6].round() as usize;
        let shape = index.checked_sub(1);
        let info = shape.and_then(|s| self.translation.shapes.get(s));
        (self.translation.frame.back(vector(0)), vector(3), info)
    }

    fn pixel(&self, i: usize, account: &mut Comparison) -> Pixel {
        let (point, normal, info) = self.other(i);
        let here = self.ours[i];
        if here.is_some_and(|s| self.is_cut_off(s)) || !self.is_smooth(i) {
            return Pixel::Silhouette;
        }
        let wrong = || match self.is_nearly_seen(i, point, info) {
            true => Pixel::Undecided,
            false => Pixel::Wrong,
        };
        let (here, info) = match (here, info) {
            (None, None) => return Pixel::Right(0.0),
            (Some(here), Some(info)) => (here, info),
            _ => return wrong(),
        };
        let across = dot(minus(point, here.point), here.normal).abs();
        let allowed = self.allowed(here.distance, info);
        if across > allowed || (info.shape, info.object) != (here.shape, here.object) {
            return wrong();
        }
        let kind = match info.exact {
            true => &mut account.exact,
            false => &mut account.meshes,
        };
        let angle = dot(normal, here.normal).abs().min(1.0).acos().to_degrees();
        kind.pixels += 1;
        kind.distance = kind.distance.max(across);
        kind.distance_by_allowed = kind.distance_by_allowed.max(across / allowed);
        kind.angle = kind.angle.max(angle);
        Pixel::Right(across / allowed)
    }

    /// How far their place may be from ours.
    fn allowed(&self, distance: f64, info: &ShapeInfo) -> f64 {
        let rounding = EXACT * self.size.max(distance / FAR);
        match info.exact {
            true => rounding,
            false => self.translation.extent.tolerance + rounding,
        }
    }

    /// Whether we see what they show from a place that single precision does not tell from the ray's
    /// origin, or behind what we see and as near to it.
    fn is_nearly_seen(&self, i: usize, point: Vec3, info: Option<&ShapeInfo>) -> bool {
        let (x, y) = (i % self.width, i / self.width);
        let ray = |view: &View| view.ray(x as f64 + 0.5, y as f64 + 0.5);
        let Some(ray) = self.view.as_ref().and_then(ray) else {
            return false;
        };
        let mut walkers: Walkers<f64> = self.tracer.walker();
        let length = ray.line.direction.length();
        let mut sees = |by: Vec3, all: bool| {
            let origin = ray.line.origin + by.into();
            let crossings = self
                .tracer
                .probe(&mut walkers, &Ray::new(origin, ray.line.direction))
                .crossings;
            let Some(info) = info else {
                return crossings.is_empty();
            };
            let first = crossings.first().map_or(0.0, |c| c.hit.t * length);
            let mut near = crossings.iter().take(if all { usize::MAX } else { 1 });
            near.any(|c| {
                let distance = c.hit.t * length;
                let across = dot(minus(point, c.hit.point.0), c.hit.shading.0).abs();
                (c.shape, c.object) == (info.shape, info.object)
                    && distance <= first + self.rounded
                    && across <= self.allowed(distance, info)
            })
        };
        let aside = (0..6).any(|k| {
            let mut by = [0.0; 3];
            by[k / 2] = if k % 2 == 0 {
                self.rounded
            } else {
                -self.rounded
            };
            sees(by, false)
        });
        aside || sees([0.0; 3], true)
    }

    /// Parts without end are cut off somewhere, meshes at the region's end.
    fn is_cut_off(&self, seen: Seen) -> bool {
        let Output {
            extent,
            shapes,
            reach,
            ..
        } = self.translation;
        let same = |s: &&ShapeInfo| (s.shape, s.object) == (seen.shape, seen.object);
        let exact = shapes.iter().any(|s| same(&s)) && shapes.iter().filter(same).all(|s| s.exact);
        let d = minus(seen.point, extent.region.centre());
        dot(d, d).sqrt() > HORIZON * reach || !extent.region.contains(seen.point) && !exact
    }

    /// Whether all pixels around show the same face, and not a fold of it.
    fn is_smooth(&self, i: usize) -> bool {
        let (x, y) = (i % self.width, i / self.width);
        let height = self.ours.len() / self.width;
        let columns = x.saturating_sub(1)..(x + 2).min(self.width);
        let rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.flat_map(|y| columns.clone().map(move |x| y * self.width + x))
            .all(|j| match (self.ours[i], self.ours[j]) {
                (None, None) => true,
                (Some(a), Some(b)) => {
                    let d = minus(b.point, a.point);
                    // The neighbour is near the tangent plane.
                    let across = dot(d, a.normal).abs();
                    (a.shape, a.object) == (b.shape, b.object)
                        && dot(a.normal, b.normal) > 0.9
                        && across < 0.5 * dot(d, d).sqrt() + 1e-9 * self.size
                }
                _ => false,
            })
    }
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] - b[i])
}

impl Comparison {
    /// As a picture of 8-bit RGB, row by row: green up to what is allowed, red where it is wrong, blue
    /// where single precision decides, grey for silhouettes.
    pub fn picture(&self) -> Vec<u8> {
        let colour = |pixel: &Pixel| match *pixel {
            Pixel::Silhouette => [60; 3],
            Pixel::Undecided => [0, 90, 255],
            Pixel::Wrong => [255, 0, 0],
            Pixel::Right(share) => [0, (200.0 * share) as u8, 0],
        };
        self.map.iter().flat_map(colour).collect()
    }
}

/// Our normals as colours, as 8-bit RGB: each coordinate from −1 to 1.
pub fn our_normals(seen: &[Option<Seen>]) -> Vec<u8> {
    let colour = |s: &Option<Seen>| s.map_or([0; 3], |s| s.normal.map(shade));
    seen.iter().flat_map(colour).collect()
}

/// Theirs.
pub fn their_normals(theirs: &[f32]) -> Vec<u8> {
    let colour = |c: &[f32]| match c[6] > 0.0 {
        true => [c[3], c[4], c[5]].map(|x| shade(f64::from(x))),
        false => [0; 3],
    };
    theirs.chunks_exact(CHANNELS).flat_map(colour).collect()
}

fn shade(x: f64) -> u8 {
    (127.5 * (x.clamp(-1.0, 1.0) + 1.0)).round() as u8
}
