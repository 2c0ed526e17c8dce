//! The answers as JSON. No number in them is NaN or infinite, and no zero negative.

use std::io::{self, Write};

use serde::Serialize;

use crate::commands::numbers::{Writable, Written};
use crate::diagnostics::Complaint;
use crate::geometry::vec::Vec3;
use crate::trace::{Crossing, Membership, Ray, Tracer, Walkers};

/// The answer about a ray: the boundary crossings on it.
#[derive(Debug, Serialize)]
pub(super) struct RayAnswer {
    ray: RayJson,
    inside_at_origin: bool,
    hits: Vec<HitJson>,
}

#[derive(Debug, Serialize)]
struct RayJson {
    origin: [f64; 3],
    direction: [f64; 3],
}

#[derive(Debug, Serialize)]
struct HitJson {
    t: Written,
    point: [Written; 3],
    normal: [Written; 3],
    uv: [f64; 2],
    object: u32,
    shape: u32,
    entering: Option<bool>,
}

/// The answer about a pixel: the boundary crossings on the ray through its centre, and its colour in linear RGB.
#[derive(Debug, Serialize)]
pub(super) struct PixelAnswer {
    pixel: [u32; 2],
    color: [f32; 3],
    #[serde(flatten)]
    ray: RayAnswer,
}

/// The answer about a point: the solids that contain it.
#[derive(Debug, Serialize)]
pub(super) struct PointAnswer {
    point: [f64; 3],
    inside: Vec<u32>,
    in_scene: bool,
}

/// The numbers, with a zero that has no sign.
fn plain<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    numbers.map(|x| x + 0.0)
}

impl RayAnswer {
    /// Traces a ray in the precision `R`. `Err` if numbers of the ray or of its crossings are out of range.
    pub(super) fn new<R: Writable>(
        tracer: &Tracer,
        walkers: &mut Walkers<R>,
        ray: &Ray,
    ) -> Result<RayAnswer, Complaint> {
        let rounded: Ray<R> = ray.cast();
        if !rounded.line.is_sound() {
            return Err(Complaint::new("ray-out-of-range"));
        }
        let probe = tracer.probe(walkers, &rounded);
        let hits: Option<Vec<HitJson>> = probe.crossings.iter().map(HitJson::new).collect();
        Ok(RayAnswer {
            ray: RayJson {
                origin: plain(ray.line.origin.0),
                direction: plain(ray.line.direction.0),
            },
            inside_at_origin: probe.inside_at_origin,
            hits: hits.ok_or_else(|| Complaint::new("hits-out-of-range"))?,
        })
    }
}

impl HitJson {
    /// `None` where a number is out of range.
    fn new<R: Writable>(crossing: &Crossing<R>) -> Option<HitJson> {
        let Crossing {
            hit, normal, uv, ..
        } = crossing;
        let finite = hit.t.is_finite()
            && hit.point.is_finite()
            && normal.is_finite()
            && uv.iter().all(|x| x.is_finite());
        finite.then(|| HitJson {
            t: hit.t.written(),
            point: hit.point.0.map(R::written),
            normal: normal.0.map(R::written),
            uv: plain(*uv),
            object: crossing.object,
            shape: crossing.shape,
            entering: crossing.entering,
        })
    }
}

impl PixelAnswer {
    pub(super) fn new(pixel: [u32; 2], color: [f32; 3], ray: RayAnswer) -> PixelAnswer {
        PixelAnswer { pixel, color, ray }
    }
}

impl PointAnswer {
    /// `shown`: the point lies in the region that is drawn.
    pub(super) fn new(point: Vec3, found: Membership, shown: bool) -> PointAnswer {
        PointAnswer {
            point: plain(point.0),
            inside: found.inside.into_iter().collect(),
            in_scene: found.in_root && shown,
        }
    }
}

/// Writes an answer on a line of its own.
pub(super) fn write(out: &mut dyn Write, answer: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *out, answer)?;
    writeln!(out)
}
