//! N607: a rotation by a usual angle in radians.

use std::cell::LazyCell;

use super::angle_in_radians::usual;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::syntax::table::RecordKind;

/// The angles that people know by heart in radians, as parts of π: they are known with two decimals.
const BY_HEART: [u32; 11] = [15, 30, 45, 60, 90, 120, 135, 150, 180, 270, 360];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let titles = LazyCell::new(|| context.titles());
    for record in context.records().filter(|r| r.kind == RecordKind::Rotation) {
        let p = context.record_params(record);
        let written = p.text_of(ANGLE);
        let parts = (1..=24).map(|k| 15 * k);
        let Some(degrees) = usual(p.number(ANGLE).abs(), written, &BY_HEART, parts) else {
            continue;
        };
        let sign = if p.number(ANGLE) < 0.0 { "-" } else { "" };
        let degrees = format!("{sign}{degrees}");
        let title = titles.get(&record.id).copied().unwrap_or("object");
        let place = p.span_of(ANGLE, 1);
        out.push(
            Diagnostic::new(Code::N607, place)
                .with("angle", written.to_owned())
                .with("degrees", degrees.clone())
                .with("type", Value::Term(title))
                .fix(Fix::replace("fix", Applicability::Unsafe, place, degrees)),
        );
    }
}

/// The place of the angle in the record.
const ANGLE: usize = 0;
