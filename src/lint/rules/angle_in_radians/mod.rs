//! W323: an angle of view that is so small that it was hardly meant in degrees.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::scene::Camera;
use crate::scene::record::Params;
use crate::solids::distance;
use crate::syntax::table::RecordKind;

/// Angles in degrees whose radians people know by heart: two decimals are enough to recognise them.
const BY_HEART: [u32; 4] = [30, 45, 60, 90];

/// The smallest angle of view, in degrees, that someone who writes radians is believed to mean.
const SMALLEST: f64 = 10.0;

/// The largest ratio of the angle under which the objects are seen to the angle of view, for a narrow picture that may
/// be meant. If the angle was meant in radians, the picture is 57 times too narrow.
const FITS: f64 = 4.0;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let cameras = &context.scene.cameras;
    for record in context.records().filter(|r| r.kind == RecordKind::Camera) {
        let p = context.record_params(record);
        // Few numbers look like an angle in radians, so the costlier test of the objects comes later.
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

/// The index of the angle of view among the record's parameters.
const FOVY: usize = 9;

/// The angle of view in degrees that a camera may mean, and the case of the finding. `p` is the record that defines the
/// camera. `None` if the angle does not look like radians, or if the objects fit into the picture as it is.
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

/// The angle of view, converted from radians to degrees, and the case of the finding: a usual angle, or any other that
/// a camera may have. `None` if the result is no angle of view.
fn in_degrees(p: &Params) -> Option<(String, &'static str)> {
    if let Some(degrees) = usual_view(p) {
        return Some((degrees.to_string(), ""));
    }
    let degrees = p.number(FOVY).to_degrees();
    let is_view = (SMALLEST..180.0).contains(&degrees);
    is_view.then(|| (((degrees * 100.0).round() / 100.0).to_string(), "unusual"))
}

/// The usual angle of view, in degrees, whose radians are the number of a camera.
fn usual_view(p: &Params) -> Option<u32> {
    let all = (2..=35).map(|k| 5 * k);
    usual(p.number(FOVY), p.text_of(FOVY), &BY_HEART, all)
}

/// The angle in degrees whose radians are `x`, to the decimals of the text `written`, rounded or cut off. A text with
/// two decimals may only be an angle of `by_heart`, one with more decimals any of `all`. `None` if no angle fits.
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
        // The writer may have taken 3.14 for π.
        _ => all.find(|d| is(d, 0.001)),
    }
}

/// Whether all finite parts of the scene fit into the picture or nearly so, within [`FITS`] times its angle: the
/// objects are small or far away, and the small angle may be meant.
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
