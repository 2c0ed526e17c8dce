//! W344: a record whose comment names another light, axis, colour, height, side, tip or point to look at than
//! its numbers.

mod above;
mod axes;
mod colours;
mod cones;
mod heights;
mod lights;
mod targets;

use crate::diagnostics::Diagnostic;
use crate::lint::Context;
use crate::syntax::table::{RecordKind, ShapeKind};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    let mut lamps = Vec::new();
    let mut planes = Vec::new();
    let mut cones = Vec::new();
    for record in context.records() {
        let p = || context.record_params(record);
        match record.kind {
            RecordKind::Rotation => out.extend(axes::check(context, &p())),
            RecordKind::Colour => out.extend(colours::check(&p())),
            RecordKind::PointLight if p().own_comments().any(lights::is_ambient) => {
                lamps.push(record);
            }
            RecordKind::Shape(ShapeKind::Cone) if cones::has_tip_up(&p()) => cones.push(record),
            RecordKind::Shape(ShapeKind::Plane | ShapeKind::HalfSpace) => {
                planes.extend(heights::said(&p()).map(|said| (record, said)));
            }
            _ => {}
        }
    }
    // What cannot be read may move anything.
    if !context.has_broken() {
        above::check(context, out);
        cones::check(context, &cones, out);
        lights::check(context, &lamps, out);
        heights::check(context, &planes, out);
        targets::check(context, out);
    }
}
