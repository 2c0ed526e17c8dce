//! N607: a rotation by a usual angle in radians.

use super::angle_in_radians::usual;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::syntax::table::RecordKind;

/// The angles that people know by heart in radians, as parts of π.
const BY_HEART: [u32; 4] = [90, 180, 270, 360];

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for record in context.records().filter(|r| r.kind == RecordKind::Rotation) {
        let p = context.record_params(record);
        let written = p.text_of(ANGLE);
        let parts = (1..=12)
            .flat_map(|k| [30 * k, 45 * k])
            .filter(|&d| d <= 360);
        let Some(degrees) = usual(p.number(ANGLE).abs(), written, &BY_HEART, parts) else {
            continue;
        };
        let sign = if p.number(ANGLE) < 0.0 { "-" } else { "" };
        let degrees = format!("{sign}{degrees}");
        let place = p.span_of(ANGLE, 1);
        out.push(
            Diagnostic::new(Code::N607, place)
                .with("angle", written.to_owned())
                .with("degrees", degrees.clone())
                .fix(Fix::replace("fix", Applicability::Unsafe, place, degrees)),
        );
    }
}

/// The place of the angle in the record.
const ANGLE: usize = 0;
