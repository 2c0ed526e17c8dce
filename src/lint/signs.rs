//! A sign that is lost in a place.

use super::Context;
use super::spelling::opposite;
use crate::scene::Vec3;
use crate::scene::record::Params;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::view::{Held, held};

/// The coordinate that gets the other sign, and its text then, where one sign alone frees a place of the half-space or box
/// that holds it. The place is what the first three numbers of a record say.
pub fn sign_that_frees(
    context: &Context,
    position: Vec3,
    holder: &Held,
    place: &Params,
) -> Option<(usize, String)> {
    let scene = context.scene;
    let root = scene.render?.root;
    let has_faces = context.params(holder.solid.span).is_some_and(|p| {
        let shapes = [ShapeKind::HalfSpace, ShapeKind::Box].map(RecordKind::Shape);
        shapes.contains(&p.ty.kind)
    });
    let written: Vec3 = place.numbers(0);
    if !has_faces || written != position {
        return None;
    }
    let places = [0, 1, 2].map(|i| {
        let mut turned = written;
        turned[i] = -turned[i];
        turned
    });
    let held = held(scene, context.bounds(), root, &places);
    let mut free = (0..3).filter(|&i| held[i].is_none() && written[i] != 0.0);
    match (free.next(), free.next()) {
        (Some(axis), None) => Some((axis, opposite(place, axis))),
        _ => None,
    }
}
