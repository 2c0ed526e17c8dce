//! W327: a transformation that moves nothing.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Value};
use crate::geometry::Matrix;
use crate::lint::Context;
use crate::scene::record::Params;
use crate::syntax::Record;
use crate::syntax::table::{Kind, RecordKind};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let all = || {
        let records = context.records().filter(|r| KINDS.contains(&r.kind));
        records.map(|r| (r, context.record_params(r)))
    };
    let mut idle: Vec<(&Record, Params)> = all().filter(|(_, p)| moves_nothing(p)).collect();
    if idle.is_empty() {
        return;
    }
    let entities = context.scene.entities.iter();
    let kinds: FxHashMap<u32, Kind> = entities.filter_map(|e| Some((e.id, e.kind?))).collect();
    // If the same type of transformation does move another entity of the same kind, this one is one of a series, and is
    // meant.
    let what = |p: &Params| {
        let axis = match p.ty.kind {
            RecordKind::Rotation => p.integer(1),
            _ => 0,
        };
        (kinds.get(&p.id).copied(), p.ty.kind, axis)
    };
    let done: FxHashSet<_> = all()
        .filter(|(_, p)| !moves_nothing(p))
        .map(|(_, p)| what(&p))
        .collect();
    idle.retain(|(_, p)| {
        let is_wrong = !p.check_constraints(&mut Vec::new());
        !is_wrong && kinds.contains_key(&p.id) && !done.contains(&what(p))
    });
    for (record, p) in idle {
        let d = Diagnostic::new(Code::W327, p.span_of(0, p.len()))
            .with("type", Value::Term(p.ty.title));
        out.push(
            match context.take_out(record, "fix", Applicability::Unsafe) {
                Some(fix) => d.fix(fix),
                None => d,
            },
        );
    }
}

const KINDS: [RecordKind; 4] = [
    RecordKind::Translation,
    RecordKind::Rotation,
    RecordKind::Scaling,
    RecordKind::RotationMatrix,
];

fn moves_nothing(p: &Params) -> bool {
    match p.ty.kind {
        RecordKind::Translation => p.numbers(0) == [0.0; 3],
        RecordKind::Rotation => p.number(0) % 360.0 == 0.0,
        RecordKind::Scaling => p.numbers(0) == [1.0; 3],
        _ => Matrix::from_rows(&p.numbers(0)) == Matrix::IDENTITY,
    }
}
