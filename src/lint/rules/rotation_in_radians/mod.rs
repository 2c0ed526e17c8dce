//! N607: a rotation by a usual angle in radians.

use std::cell::LazyCell;

use super::angle_in_radians::usual;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::syntax::table::RecordKind;

/// Angles in degrees whose radians people know by heart, as parts of π: two decimals are enough to recognise them.
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

/// The index of the angle among the record's parameters.
const ANGLE: usize = 0;
