//! The choice between two readings of a camera without an up vector: it looks along a direction, or at a point. The ray
//! through the middle of the picture tells which of the two shows something.

use super::Trial;
use super::candidates::cameras::{DIRECTION_TITLE, POINT_TITLE, is_unit};
use super::judge::{self, Left};
use crate::geometry::array::{dot, length, unit};
use crate::scene::{Camera, Scene};
use crate::trace::camera::View;
use crate::trace::plan::unseen::view::USUAL;
use crate::trace::{Tracer, Walkers};

/// The length below which three numbers are rather a direction than a point.
const MAX_DIRECTION_LENGTH: f64 = 1.5;
/// Cosine of the angle up to which both readings look the same way: 60 degrees.
const MIN_COSINE: f64 = 0.5;

/// Puts the likelier one of both readings of a camera first, where both show something. Returns whether neither of them
/// is clearly likelier.
pub(super) fn settle(judged: &mut [(Left, Trial)], camera: Option<u32>) -> bool {
    let at = |title| {
        judged
            .iter()
            .position(|(_, t)| t.candidate.fix.title == title)
    };
    let (Some(along), Some(to)) = (at(DIRECTION_TITLE), at(POINT_TITLE)) else {
        return false;
    };
    let scenes = [along, to].map(|i| &judged[i].1.scene.scene);
    let is_told = judged[along].0.in_vain != judged[to].0.in_vain;
    if is_told || !judge::is_small(scenes[0]) {
        return false;
    }
    let own = |scene: &Scene| scene.cameras.iter().find(|c| Some(c.id) == camera).cloned();
    let [Some(direction), Some(point)] = scenes.map(own) else {
        return false;
    };
    let cameras = [&direction, &point];
    let [direction_meets, point_meets] = [0, 1].map(|i| meets(scenes[i], cameras[i]));
    let [way, to_point] = cameras.map(|c| unit(c.direction).unwrap_or_default());
    let agree = dot(way, to_point) > MIN_COSINE;
    let is_unit = is_unit(direction.direction);
    let is_short = is_unit || length(direction.direction) < MAX_DIRECTION_LENGTH;
    let is_direction = direction_meets && (agree || !point_meets) || is_short && agree;
    if is_direction && along > to {
        judged[to..=along].rotate_right(1);
    }
    // A vector of unit length is hardly a point.
    let is_clear = is_unit
        || match is_direction {
            true => direction_meets && !point_meets,
            false => point_meets && !direction_meets,
        };
    !is_clear && (direction_meets || point_meets)
}

/// Whether the ray through the middle of the picture meets anything.
fn meets(scene: &Scene, camera: &Camera) -> bool {
    let [width, height] = USUAL;
    let ray = View::new(camera, width, height)
        .and_then(|view| view.ray(f64::from(width) / 2.0, f64::from(height) / 2.0));
    let (Some(ray), Ok(tracer)) = (ray, Tracer::new(scene)) else {
        return false;
    };
    let mut walkers: Walkers<f64> = tracer.walker();
    tracer.hit(&mut walkers, &ray).is_some()
}
