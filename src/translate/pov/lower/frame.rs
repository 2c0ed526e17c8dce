//! Placement of the scene: POV-Ray's tolerances are absolute, so the scene is moved about the origin and scaled.

use super::camera::Eye;
use super::sight_range::SightRange;
use crate::diagnostics::{Complaint, Value};
use crate::geometry::Aabb;
use crate::scene::Vec3;
use crate::translate::fidelity::{Fidelity, Report};
use crate::translate::pov::model::stretch::power_of_two_about;
use crate::translate::pov::tree::Frame;

/// The size, in POV-Ray's units, that the scene is scaled to. POV-Ray's tolerances, 1e-6 to 1e-3, are small beside it,
/// and its limits, 1e7, are far away.
const SIZE: f64 = 32.0;

/// The hair in POV-Ray's units: the distance by which faces in one place are put apart. It is a few times POV-Ray's
/// tolerances.
const FACE_OFFSET: f64 = 1.0 / 512.0;

/// The distance, in POV-Ray's units, within which shadow rays overlook surfaces.
const OVERLOOKED: f64 = 1e-3;

/// The largest distance of the camera, in POV-Ray's units: POV-Ray sees nothing beyond 1e7.
const MAX_CAMERA_DISTANCE: f64 = 1e6;

/// The largest distance, in POV-Ray's units, that a scene may reach when it is enlarged for the sake of near things.
const FAR_FOR_NEAR: f64 = 262_144.0;

/// Distance from the origin, in sizes of the scene, beyond which the coordinates are moved.
const OFF: f64 = 16.0;

/// The frame in which the scene has about the size [`SIZE`], or less if the camera is far away. The scene is larger
/// where things that are seen would be too near for the tolerances. `seen` is a box around what the cameras see.
pub(super) fn frame(
    seen: Aabb,
    eyes: &[Eye],
    range: Option<SightRange>,
    report: &mut Report,
) -> Frame {
    let locations = || eyes.iter().map(|eye| eye.lens.location);
    let middle = match seen.is_empty() {
        true => [0.0; 3],
        false => seen.centre(),
    };
    let away = |p: Vec3| (0..3).fold(0.0f64, |m, i| m.max((p[i] - middle[i]).abs()));
    let distance = locations().map(away).fold(0.0, f64::max);
    let size = match seen.is_empty() {
        true => distance,
        false => seen.radius(),
    };
    let mut unit = power_of_two_about((SIZE / size).min(MAX_CAMERA_DISTANCE / distance));
    if let Some(range) = range {
        let wanted = (SIZE / range.near).max(SIZE * OVERLOOKED / range.gap);
        if wanted > unit {
            unit = unit.max(power_of_two_about(wanted.min(FAR_FOR_NEAR / range.far)));
        }
        let overlooked = OVERLOOKED / unit;
        let nearer = |message| {
            let length = Value::Decimal(format!("{overlooked:.1e}"));
            Fidelity::Approximate(Complaint::new(message).with("length", length))
        };
        if range.near * unit < SIZE * OVERLOOKED {
            report.state(
                "things that are small beside what is far away",
                nearer("fidelity-overlooked"),
                "",
            );
        }
        if range.gap < overlooked {
            report.state(
                "narrow gaps behind transparent surfaces",
                nearer("fidelity-overlooked-behind"),
                "",
            );
        }
    }
    let step = power_of_two_about(size);
    let is_off = middle.iter().any(|x| x.abs() > OFF * size);
    let centre = match is_off && step > 0.0 {
        true => middle.map(|x| (x / step).round() * step),
        false => [0.0; 3],
    };
    Frame { centre, unit }
}

/// The hair in the scene's coordinates: the distance by which faces in one place are put apart. It is less than can be
/// seen and more than POV-Ray's tolerances.
pub(super) fn hair(frame: &Frame) -> f64 {
    FACE_OFFSET / frame.unit
}
