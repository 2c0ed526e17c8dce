//! W323: an angle of view that is so small that it was hardly meant in degrees.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::scene::Camera;
use crate::scene::record::Params;
use crate::solids::distance;
use crate::syntax::table::RecordKind;

/// The angles that people know by heart in radians: they are known with two decimals.
const BY_HEART: [u32; 4] = [30, 45, 60, 90];

/// The smallest angle of view, in degrees, that someone who writes radians is believed to mean.
const SMALLEST: f64 = 10.0;

/// Most times that the angle of the picture is exceeded by the angle under which its objects are seen where the picture
/// was meant to be as narrow as it is. In radians it would be 57 times.
const FITS: f64 = 4.0;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let cameras = &context.scene.cameras;
    for record in context.records().filter(|r| r.kind == RecordKind::Camera) {
        let p = context.record_params(record);
        // Few numbers look like that.
        if in_degrees(&p).is_none() {
            continue;
        }
        let camera = cameras.iter().find(|c| c.id == p.id);
        let Some((degrees, case)) = camera.and_then(|c| meant(context, c, &p)) else {
            continue;
        };
        out.push(
            Diagnostic::new(Code::W323, p.span_of(FOVY, 1))
                .case(case)
                .with("angle", p.text_of(FOVY).to_owned())
                .with("degrees", degrees.clone())
                .with("about", Value::Decimal(degrees.clone()))
                .fix(Fix::replace(
                    "fix",
                    Applicability::Unsafe,
                    p.span_of(FOVY, 1),
                    degrees,
                )),
        );
    }
}

/// The place of the angle of view in the record.
const FOVY: usize = 9;

/// The angle in degrees that is meant by a camera, and by the record that defines it, whose angle of view looks like
/// radians; and which case that is.
pub(super) fn meant(
    context: &Context,
    camera: &Camera,
    p: &Params,
) -> Option<(String, &'static str)> {
    if p.ty.kind != RecordKind::Camera || camera.projection.is_some() {
        return None;
    }
    in_degrees(p).filter(|_| !fits(context, camera))
}

/// The angle of view in degrees that the number of a camera is in radians, and the case of the finding: a usual angle,
/// or any other that a camera may have.
fn in_degrees(p: &Params) -> Option<(String, &'static str)> {
    if let Some(degrees) = usual_view(p) {
        return Some((degrees.to_string(), ""));
    }
    let degrees = p.number(FOVY).to_degrees();
    let is_view = (SMALLEST..180.0).contains(&degrees);
    is_view.then(|| (((degrees * 100.0).round() / 100.0).to_string(), "unusual"))
}

/// The usual angle of view, in degrees, that the number of a camera is in radians.
fn usual_view(p: &Params) -> Option<u32> {
    let all = (2..=35).map(|k| 5 * k);
    usual(p.number(FOVY), p.text_of(FOVY), &BY_HEART, all)
}

/// The angle in degrees that a number is in radians, as far as its decimals go; rounded or cut off. With two decimals
/// it is one of those that people know `by_heart`, with more any of `all`.
pub(super) fn usual(
    x: f64,
    written: &str,
    by_heart: &[u32],
    mut all: impl Iterator<Item = u32>,
) -> Option<u32> {
    let (_, decimals) = written.split_once('.')?;
    if !decimals.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let is = |degrees: &u32, within: f64| {
        let more = f64::from(*degrees).to_radians() - x;
        -within / 2.0 <= more && more < within
    };
    match decimals.len() {
        0 | 1 => None,
        2 => by_heart.iter().copied().find(|d| is(d, 0.01)),
        // π may have been 3.14.
        _ => all.find(|d| is(d, 0.001)),
    }
}

/// Whether all finite parts of what is drawn fit into the picture as they are: small, or far away.
fn fits(context: &Context, camera: &Camera) -> bool {
    let Some(render) = context.scene.render else {
        return false;
    };
    let all = context.bounds()[render.root as usize].bounded();
    if !all.is_bounded() {
        return false;
    }
    let away = distance(all.centre(), camera.position);
    away > 0.0 && 2.0 * (all.radius() / away).atan().to_degrees() <= FITS * camera.fovy
}
