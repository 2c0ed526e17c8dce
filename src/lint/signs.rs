//! A lost sign in the coordinates of a place.

use super::Context;
use super::spelling::opposite;
use crate::scene::Vec3;
use crate::scene::record::Params;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::view::{Held, held};

/// The one coordinate whose other sign frees a place from `holder`, a half-space or box, and the text of the coordinate
/// with that sign. `None` if no coordinate or several do so, or if the first three numbers of the record `place` are
/// not `position`.
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
