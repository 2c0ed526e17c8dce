//! Lowering of the scene to the objects that POV-Ray is to draw.

mod camera;
mod descend;
mod difference;
mod distribute;
mod frame;
mod lights;
mod nodes;
mod operands;
mod operations;
mod reorder;
mod rewrite;
mod sight_range;
mod triangle;
mod union;
mod volumes;

use std::borrow::Cow;
use std::collections::HashMap;

use super::budget::Budget;
use super::model::Model;
use super::model::materials::Facts;
use super::separate::backward_normals;
use super::tree::{Document, Lens, Tree, Uses};
use super::{MAX_TRACE_LEVEL, Options};
use crate::diagnostics::Error;
use crate::geometry::Aabb;
use crate::scene::Scene;
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::solids::shapes::facts::Facts as _;
use crate::solids::staging::seen_box;
use crate::translate::fidelity::Report;
use nodes::Lower;

/// The scene with operations in another order, and distributed over unions, where POV-Ray needs it; and the facts about
/// its nodes. `None` if nothing is drawn.
pub(super) fn rewritten<'a>(
    scene: &'a Scene,
    bounds: &'a [NodeBounds],
    budget: &Budget,
) -> Option<(Cow<'a, Scene>, Facts<'a>)> {
    let facts = Facts::of(scene, Cow::Borrowed(bounds))?;
    let mut known = (Cow::Borrowed(scene), facts);
    for rewrite in [reorder::reordered, distribute::distributed] {
        if let Some(other) = rewrite(&known.0, &known.1, budget) {
            let facts = Facts::of(&other, node_bounds(&other).into())?;
            known = (Cow::Owned(other), facts);
        }
    }
    Some(known)
}

/// The document that is to be printed, the lenses that take the pictures, and the report.
///
/// # Errors
/// A part of the scene has no translation.
pub(super) fn lower<'a>(
    scene: &'a Scene,
    facts: Facts<'a>,
    options: &'a Options,
    budget: &'a Budget,
    mut report: Report,
) -> Result<(Document<'a>, Vec<Lens>, Report), Error> {
    let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
    let bounds = &facts.bounds;
    let whole = match render.clip {
        Some((min, max)) => Aabb::new(min, max),
        None => bounds[render.root as usize].all,
    };
    let seen = seen_box(scene, bounds);
    let eyes = camera::eyes(scene, whole, options, &mut report)?;
    let frame = frame::frame(
        seen,
        &eyes,
        sight_range::sight_range(scene, &eyes, whole),
        &mut report,
    );
    let hair = frame::hair(&frame);
    let lights_in_group = lights::is_any_on_surface(scene, bounds, render.root);

    let is_clear = facts.is_clear();
    let mut model = Model::new(scene, facts, hair, budget, report);
    if is_clear {
        model.beside_clear = distribute::beside_clear(&model, render.root);
        let is_flat = |shape: u32| scene.shapes[shape as usize].geometry.character().is_flat;
        model.holds_sheets = model.holders(is_flat);
    }
    let mut backward = HashMap::new();
    if let Some(eye) = eyes.first() {
        backward = backward_normals::backward(&model, eye.camera.position);
        model.holds_backward_normals = model.holders(|shape| backward.contains_key(&shape));
    }
    let mut lower = Lower::new(model, &options.captions, backward);
    let objects = lower.objects(render.root);
    lower.report_what_is_left();
    let Model {
        textures,
        tables,
        cut_open,
        report,
        ..
    } = lower.model;
    let (textures, images) = textures.values(&tables, scene, &options.pictures);
    let document = Document {
        title: options.captions.title(),
        size: options.size,
        levels: options.depth.saturating_add(1).min(MAX_TRACE_LEVEL),
        light_scale: 1.0,
        frame,
        background: render.background,
        ambient: lights::ambient(scene),
        lights: lights::point_lights(scene, &options.captions),
        lights_in_group,
        tree: Tree {
            images,
            textures,
            root: objects.len().checked_sub(1),
            objects,
            uses: Uses::default(),
        },
        caption: options.captions.entity(render.root_id),
        // The box is a hair larger, so that a face of the scene in a face of the box is drawn, too.
        clip: (render.clip).map(|(min, max)| (min.map(|x| x - hair), max.map(|x| x + hair))),
        cut_open,
    };
    let lenses = eyes.into_iter().map(|eye| eye.lens).collect();
    Ok((document, lenses, report))
}
