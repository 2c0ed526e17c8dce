//! Compares the surfaces that two programs see of a scene: position, normal and shape, pixel by pixel.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use serde::Serialize;

use super::compare::{ALIKE, alike};
use super::mitsuba::CHANNELS;
use super::whereabouts::Whereabouts;
use crate::geometry::Aabb;
use crate::geometry::array::{dot, sub};
use crate::parallel;
use crate::scene::{Camera, Vec3};
use crate::trace::camera::View;
use crate::trace::ray::Ray;
use crate::trace::{Tracer, Walkers};
use crate::translate::mitsuba::{Output, ShapeInfo};

/// The point that is seen first through a pixel.
#[derive(Debug, Clone, Copy)]
pub struct VisiblePoint {
    pub point: Vec3,
    /// The shading normal, of unit length. It points out of the solid, also on a face that a cut has made.
    pub normal: Vec3,
    /// Whether the surface bounds a solid. The normal of a surface without an inside may point to either side.
    pub is_of_solid: bool,
    pub distance: f64,
    /// The shape's number, as [`crate::trace::Crossing`] has it.
    pub shape: u32,
    pub object: u32,
}

impl VisiblePoint {
    /// The cosine of the angle between this normal and `normal`. On a surface without an inside the two may point to
    /// opposite sides: there, the cosine of the smaller angle.
    fn cosine(&self, normal: Vec3) -> f64 {
        let cosine = dot(normal, self.normal);
        match self.is_of_solid {
            true => cosine,
            false => cosine.abs(),
        }
    }
}

/// The point that our tracer sees first through the centre of each pixel, row by row; `None` where it sees nothing.
pub fn seen(
    tracer: &Tracer,
    camera: &Camera,
    (width, height): (u32, u32),
) -> Vec<Option<VisiblePoint>> {
    let Some(view) = View::new(camera, width, height) else {
        return vec![None; width as usize * height as usize];
    };
    let rows = parallel::map_with(
        height as usize,
        || tracer.walker(),
        |walkers: &mut Walkers<f64>, y| {
            let pixel = |x: u32| {
                let ray = view.ray(f64::from(x) + 0.5, y as f64 + 0.5)?;
                let probe = tracer.probe(walkers, &ray);
                probe.crossings.first().map(|c| VisiblePoint {
                    point: c.hit.point.0,
                    normal: match dot(c.hit.normal.0, c.normal.0) < 0.0 {
                        true => c.hit.shading.0.map(|x| -x),
                        false => c.hit.shading.0,
                    },
                    is_of_solid: c.entering.is_some(),
                    distance: c.hit.t * ray.line.direction.length(),
                    shape: c.shape,
                    object: c.object,
                })
            };
            (0..width).map(pixel).collect::<Vec<_>>()
        },
    );
    rows.concat()
}

/// The share of the scene's size by which positions on exact shapes may differ.
const EXACT: f64 = 1e-4;
/// The distance, in sizes of the scene, beyond which positions may differ by a share of the distance instead. This
/// share, `EXACT / FAR_SIZES`, is 28 units of single precision (2^-23): a point is transformed, met and transformed
/// back, with some operations each way.
const FAR_SIZES: f64 = 30.0;
/// The share of the distance at which endless shapes are cut off beyond which nothing is compared: a neighbouring pixel
/// may show the cut.
const HORIZON: f64 = 0.9;
/// Two surfaces are in one place if their distance is below this share of the largest coordinate: doubles are rounded
/// on the way through some matrices.
const IN_ONE_PLACE: f64 = 64.0 * f64::EPSILON;
/// The share of the largest coordinate by which single precision may misplace a point, after a few operations.
const ROUNDED: f64 = 4.0 * f32::EPSILON as f64;

/// The cosine of 25.8°. A surface counts as folded where the normals of neighbouring pixels differ by more. The normals
/// of a mesh may differ from ours by as much.
const FOLDED: f64 = 0.9;
/// The sine of 0.17°, the angle by which normals may differ on exact shapes: some roundings of its cosine in single
/// precision. Far away they may differ by more.
const TURNED: f64 = 3e-3;

/// The largest distance in pixels between a fold of a mesh and the same fold of our surface.
const FOLD_DISTANCE_PIXELS: usize = 2;

/// The outcome of comparing what Mitsuba sees with what our tracer sees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    pub pixels: usize,
    /// Number of pixels that are not compared, since a neighbour shows another shape, another face or a fold.
    pub silhouettes: usize,
    /// Number of pixels that are not compared, since endless shapes are cut off there in the translation.
    pub cut_off: usize,
    /// Number of pixels that are not compared, since single precision, in which Mitsuba computes, does not tell the
    /// surface from another one that is nearly there.
    pub undecided: usize,
    /// Number of pixels that are not compared, since the surfaces of two shapes are in one place, and Mitsuba shows the
    /// other one.
    pub in_one_place: usize,
    /// The pairs of shapes whose surfaces are in one place, the pair of the most pixels first.
    pub shared: Vec<Shared>,
    /// Number of pixels where Mitsuba shows another shape than our tracer, or a position or normal outside of the
    /// bounds.
    pub wrong: usize,
    /// The wrong pixels as a share of all pixels.
    pub share_wrong: f64,
    /// The shape that most of the wrong pixels show.
    pub mostly: Option<Whereabouts>,
    pub exact: Differences,
    pub meshes: Differences,
    #[serde(skip)]
    map: Vec<Pixel>,
}

/// Two shapes with surfaces in one place, where the programs show different ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Shared {
    /// The IDs of the shape that our tracer shows and of the shape that Mitsuba shows.
    pub shapes: [u32; 2],
    pub pixels: usize,
}

/// The largest differences on one kind of shapes, exact ones or meshes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Differences {
    pub pixels: usize,
    /// Distance of Mitsuba's point from the tangent plane of our surface, in units of the scene.
    pub distance: f64,
    /// The distance divided by the distance that is allowed at its pixel.
    pub distance_by_allowed: f64,
    /// Angle between the shading normals, in degrees.
    pub angle: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Pixel {
    Silhouette,
    CutOff,
    Undecided,
    /// A pixel where the surfaces of two shapes are in one place: our tracer shows the first, Mitsuba the second.
    InOnePlace([u32; 2]),
    Wrong,
    Right {
        /// Whether Mitsuba has the shape itself, not a mesh of it.
        exact: bool,
        /// Distance of Mitsuba's point from the tangent plane of our surface, in units of the scene.
        distance: f64,
        /// The distance that is allowed.
        allowed: f64,
        /// Angle between the shading normals, in degrees.
        angle: f64,
    },
    /// A pixel where neither program shows a surface.
    Empty,
}

/// Compares Mitsuba's channels of all pixels, `theirs`, with the points that our tracer sees. `None` if the pictures
/// have different sizes.
pub fn compare(
    tracer: &Tracer,
    camera: &Camera,
    ours: &[Option<VisiblePoint>],
    theirs: &[f32],
    (width, height): (u32, u32),
    translation: &Output,
) -> Option<Comparison> {
    if theirs.len() != CHANNELS * ours.len() {
        return None;
    }
    let Output { extent, frame, .. } = translation;
    let all = extent
        .region
        .hull(&Aabb::new(camera.position, camera.position));
    let largest = |corners: [Vec3; 2]| {
        let coordinates = corners.as_flattened().iter();
        coordinates.fold(0.0f64, |m, x| m.max(x.abs()))
    };
    let mut exact = FxHashMap::default();
    for s in &translation.shapes {
        *exact.entry((s.shape, s.object)).or_insert(true) &= s.exact;
    }
    let sight = Sight {
        tracer,
        view: View::new(camera, width, height),
        ours,
        theirs,
        width: width as usize,
        translation,
        exact,
        size: 2.0 * extent.radius,
        rounded: ROUNDED * largest([all.min, all.max].map(|p| frame.place(p))) / frame.scale,
        in_one_place: IN_ONE_PLACE * largest([all.min, all.max]),
    };
    let mut comparison = Comparison {
        map: parallel::map_with(
            ours.len(),
            || tracer.walker(),
            |walkers, i| sight.pixel(i, walkers),
        ),
        pixels: ours.len(),
        silhouettes: 0,
        cut_off: 0,
        undecided: 0,
        in_one_place: 0,
        shared: Vec::new(),
        wrong: 0,
        share_wrong: 0.0,
        mostly: None,
        exact: Differences::default(),
        meshes: Differences::default(),
    };
    let mut shared: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for pixel in &comparison.map {
        match *pixel {
            Pixel::Silhouette => comparison.silhouettes += 1,
            Pixel::CutOff => comparison.cut_off += 1,
            Pixel::Undecided => comparison.undecided += 1,
            Pixel::InOnePlace(shapes) => {
                comparison.in_one_place += 1;
                *shared.entry(shapes).or_default() += 1;
            }
            Pixel::Wrong => comparison.wrong += 1,
            Pixel::Empty => {}
            Pixel::Right {
                exact,
                distance,
                allowed,
                angle,
            } => {
                let kind = match exact {
                    true => &mut comparison.exact,
                    false => &mut comparison.meshes,
                };
                kind.pixels += 1;
                kind.distance = kind.distance.max(distance);
                kind.distance_by_allowed = kind.distance_by_allowed.max(distance / allowed);
                kind.angle = kind.angle.max(angle);
            }
        }
    }
    let pairs = shared.into_iter();
    comparison.shared = pairs
        .map(|(shapes, pixels)| Shared { shapes, pixels })
        .collect();
    comparison.shared.sort_by_key(|s| Reverse(s.pixels));
    comparison.share_wrong = comparison.wrong as f64 / comparison.pixels.max(1) as f64;
    let is_wrong = |i: &usize| matches!(comparison.map[*i], Pixel::Wrong);
    let wrong: Vec<usize> = (0..ours.len()).filter(is_wrong).collect();
    comparison.mostly = Whereabouts::of(tracer, camera, (width, height), &wrong);
    Some(comparison)
}

struct Sight<'a> {
    tracer: &'a Tracer,
    view: Option<View>,
    ours: &'a [Option<VisiblePoint>],
    theirs: &'a [f32],
    width: usize,
    translation: &'a Output,
    /// For each pair of shape and object in the translation: whether Mitsuba has all its occurrences exactly, none as a
    /// mesh.
    exact: FxHashMap<(u32, u32), bool>,
    size: f64,
    /// Distance by which single precision may misplace a point, in units of the scene.
    rounded: f64,
    /// Distance up to which two surfaces count as in one place, in units of the scene.
    in_one_place: f64,
}

impl Sight<'_> {
    /// The point, normal and shape that Mitsuba shows in pixel `i`; no shape where it shows nothing.
    fn other(&self, i: usize) -> (Vec3, Vec3, Option<&ShapeInfo>) {
        let c = &self.theirs[CHANNELS * i..][..CHANNELS];
        let vector = |first: usize| std::array::from_fn(|k| f64::from(c[first + k]));
        let index = c[6].round() as usize;
        let shape = index.checked_sub(1);
        let info = shape.and_then(|s| self.translation.shapes.get(s));
        (self.translation.frame.back(vector(0)), vector(3), info)
    }

    fn pixel(&self, i: usize, walkers: &mut Walkers<f64>) -> Pixel {
        let (point, normal, info) = self.other(i);
        let here = self.ours[i];
        if self
            .around(i, 1)
            .any(|j| self.ours[j].is_some_and(|seen| self.is_cut_off(seen)))
        {
            return Pixel::CutOff;
        }
        if !self.is_smooth(i) {
            return Pixel::Silhouette;
        }
        let (here, info) = match (here, info) {
            (None, None) => return Pixel::Empty,
            (Some(here), Some(info)) => (here, info),
            _ => return self.unlike(i, point, info, walkers),
        };
        let across = dot(sub(point, here.point), here.normal).abs();
        let allowed = self.allowed(here.distance, info);
        if across > allowed || (info.shape, info.object) != (here.shape, here.object) {
            return self.unlike(i, point, Some(info), walkers);
        }
        let cosine = here.cosine(normal);
        // The bound grows with the distance, like the bound on positions.
        let sine = TURNED * f64::max(1.0, here.distance / (FAR_SIZES * self.size));
        // Where roundings turn a normal by more than a right angle, it may point anywhere.
        let exact = match sine < 1.0 {
            true => (1.0 - sine * sine).sqrt(),
            false => -1.0,
        };
        if cosine < if info.exact { exact } else { exact.min(FOLDED) } {
            // A fold of a mesh may lie beside the fold of the shape, by up to the tolerance.
            return match !info.exact && self.is_near(i, &here, normal) {
                true => Pixel::Silhouette,
                false => Pixel::Wrong,
            };
        }
        Pixel::Right {
            exact: info.exact,
            distance: across,
            allowed,
            angle: cosine.min(1.0).acos().to_degrees(),
        }
    }

    /// Classifies a pixel in which the two programs show different things.
    fn unlike(
        &self,
        i: usize,
        point: Vec3,
        info: Option<&ShapeInfo>,
        walkers: &mut Walkers<f64>,
    ) -> Pixel {
        let Some(ray) = self.ray(i) else {
            return Pixel::Wrong;
        };
        if let (Some(here), Some(info)) = (self.ours[i], info) {
            let across = dot(sub(point, here.point), here.normal).abs();
            let places = [
                (
                    self.in_one_place,
                    Pixel::InOnePlace([here.shape, info.shape]),
                ),
                (self.rounded, Pixel::Undecided),
            ];
            for (gap, pixel) in places {
                if across <= self.allowed(here.distance, info) + gap
                    && self.is_within(gap, &ray, &here, info, walkers)
                {
                    return pixel;
                }
            }
        }
        match self.is_nearly_seen(&ray, point, info, walkers) {
            true => Pixel::Undecided,
            false => Pixel::Wrong,
        }
    }

    /// The allowed distance of Mitsuba's point from our tangent plane, for a point at `distance` from the camera.
    fn allowed(&self, distance: f64, info: &ShapeInfo) -> f64 {
        let rounding = EXACT * self.size.max(distance / FAR_SIZES);
        match info.exact {
            true => rounding,
            false => self.translation.extent.tolerance + rounding,
        }
    }

    /// The ray through the centre of pixel `i`.
    fn ray(&self, i: usize) -> Option<Ray> {
        let (x, y) = (i % self.width, i / self.width);
        (self.view.as_ref()?).ray(x as f64 + 0.5, y as f64 + 0.5)
    }

    /// Whether the ray meets the surface that Mitsuba shows no farther than `gap` from the surface that we see.
    /// Operations may have removed Mitsuba's surface there.
    fn is_within(
        &self,
        gap: f64,
        ray: &Ray,
        here: &VisiblePoint,
        info: &ShapeInfo,
        walkers: &mut Walkers<f64>,
    ) -> bool {
        let direction = ray.line.direction;
        let length = direction.length();
        let slope = dot(direction.0, here.normal).abs() / length;
        let by = gap / slope.max(1e-3) / length;
        let t = here.distance / length;
        let met = self.tracer.surfaces(walkers, ray, t - by, t + by);
        let mut ours = met.iter().filter(|s| s.shape == here.shape);
        ours.any(|a| {
            met.iter()
                .any(|b| b.leaf != a.leaf && b.shape == info.shape)
        })
    }

    /// Whether our tracer sees what Mitsuba shows from another origin that single precision cannot tell from the ray's,
    /// or behind our first surface at a distance that single precision cannot tell from its distance.
    fn is_nearly_seen(
        &self,
        ray: &Ray,
        point: Vec3,
        info: Option<&ShapeInfo>,
        walkers: &mut Walkers<f64>,
    ) -> bool {
        let length = ray.line.direction.length();
        let mut sees = |by: Vec3, all: bool| {
            let origin = ray.line.origin + by.into();
            let crossings = self
                .tracer
                .probe(walkers, &Ray::new(origin, ray.line.direction))
                .crossings;
            let Some(info) = info else {
                return crossings.is_empty();
            };
            let first = crossings.first().map_or(0.0, |c| c.hit.t * length);
            let mut near = crossings.iter().take(if all { usize::MAX } else { 1 });
            near.any(|c| {
                let distance = c.hit.t * length;
                let across = dot(sub(point, c.hit.point.0), c.hit.shading.0).abs();
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

    /// Whether the translation may cut the surface off here: endless shapes near their cut, meshes outside of the
    /// region.
    fn is_cut_off(&self, seen: VisiblePoint) -> bool {
        let Output { extent, reach, .. } = self.translation;
        let exact = self.exact.get(&(seen.shape, seen.object));
        let d = sub(seen.point, extent.region.centre());
        dot(d, d).sqrt() > HORIZON * reach
            || !extent.cut.contains(seen.point) && exact != Some(&true)
    }

    /// Whether a pixel near pixel `i` shows the same shape with a normal close to `normal`.
    fn is_near(&self, i: usize, here: &VisiblePoint, normal: Vec3) -> bool {
        self.around(i, FOLD_DISTANCE_PIXELS).any(|j| {
            self.ours[j].is_some_and(|seen| {
                let same = (seen.shape, seen.object) == (here.shape, here.object);
                same && seen.cosine(normal) > FOLDED
            })
        })
    }

    /// Pixel `i` and the pixels at most `by` columns and rows from it.
    fn around(&self, i: usize, by: usize) -> impl Iterator<Item = usize> {
        let (x, y) = (i % self.width, i / self.width);
        let height = self.ours.len() / self.width;
        let columns = x.saturating_sub(by)..(x + by + 1).min(self.width);
        let rows = y.saturating_sub(by)..(y + by + 1).min(height);
        let width = self.width;
        rows.flat_map(move |y| columns.clone().map(move |x| y * width + x))
    }

    /// Whether pixel `i` and its neighbours all show one face without a fold, or all show nothing.
    fn is_smooth(&self, i: usize) -> bool {
        self.around(i, 1)
            .all(|j| match (self.ours[i], self.ours[j]) {
                (None, None) => true,
                (Some(a), Some(b)) => {
                    let d = sub(b.point, a.point);
                    // The neighbour is near the tangent plane.
                    let across = dot(d, a.normal).abs();
                    (a.shape, a.object) == (b.shape, b.object)
                        && dot(a.normal, b.normal) > FOLDED
                        && across < 0.5 * dot(d, d).sqrt() + 1e-9 * self.size
                }
                _ => false,
            })
    }
}

impl Comparison {
    /// The number of pixels that are not compared.
    pub fn left_out(&self) -> usize {
        self.silhouettes + self.cut_off + self.undecided + self.in_one_place
    }

    /// Whether the comparison is conclusive: apart from silhouettes, no more pixels are left out than are right.
    pub fn tells(&self) -> bool {
        let right = self.exact.pixels + self.meshes.pixels;
        self.cut_off + self.undecided + self.in_one_place <= right
    }

    /// Draws the comparison in 8-bit RGB, row by row. Right pixels are green, the brighter the larger their error;
    /// wrong ones red; silhouettes grey. Blue pixels are left out: something is cut off, single precision does not
    /// decide, or surfaces are in one place.
    pub fn picture(&self) -> Vec<u8> {
        let colour = |pixel: &Pixel| match *pixel {
            Pixel::Silhouette => SILHOUETTE,
            Pixel::CutOff | Pixel::Undecided | Pixel::InOnePlace(_) => LEFT_OUT,
            Pixel::Wrong => WRONG,
            Pixel::Right {
                distance, allowed, ..
            } => alike(distance / allowed),
            Pixel::Empty => [0; 3],
        };
        self.map.iter().flat_map(colour).collect()
    }
}

const SILHOUETTE: [u8; 3] = [60; 3];
const LEFT_OUT: [u8; 3] = [0, 90, 255];
const WRONG: [u8; 3] = [255, 0, 0];

/// The colours of [`Comparison::picture`], each with the message that explains it.
pub const LEGEND: [([u8; 3], &str); 4] = [
    (ALIKE, "crosscheck-legend-alike"),
    (WRONG, "crosscheck-legend-differing"),
    (SILHOUETTE, "crosscheck-legend-silhouettes"),
    (LEFT_OUT, "crosscheck-legend-left-out"),
];

/// Draws our normals in 8-bit RGB: each coordinate from −1 to 1 becomes a channel. Black where nothing is seen.
pub fn our_normals(seen: &[Option<VisiblePoint>]) -> Vec<u8> {
    let colour = |s: &Option<VisiblePoint>| s.map_or([0; 3], |s| s.normal.map(shade));
    seen.iter().flat_map(colour).collect()
}

/// Draws Mitsuba's normals like [`our_normals`]. On a surface without an inside they are turned to the side of ours.
pub fn their_normals(seen: &[Option<VisiblePoint>], theirs: &[f32]) -> Vec<u8> {
    let colour = |(here, c): (&Option<VisiblePoint>, &[f32])| {
        if c[6] <= 0.0 {
            return [0; 3];
        }
        let normal = [c[3], c[4], c[5]].map(f64::from);
        let other_side = here.is_some_and(|s| !s.is_of_solid && dot(s.normal, normal) < 0.0);
        normal.map(|x| shade(if other_side { -x } else { x }))
    };
    let pixels = seen.iter().zip(theirs.chunks_exact(CHANNELS));
    pixels.flat_map(colour).collect()
}

fn shade(x: f64) -> u8 {
    (127.5 * (x.clamp(-1.0, 1.0) + 1.0)).round() as u8
}

#[cfg(test)]
mod tests;
