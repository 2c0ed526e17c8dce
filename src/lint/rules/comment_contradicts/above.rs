//! A point light that a comment places above something, and that lies below all that is drawn.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::geometry::Aabb;
use crate::lint::Context;
use crate::lint::spelling::opposite;
use crate::scene::axes::words;
use crate::syntax::table::{Family, RecordKind};
use crate::syntax::{Record, quote};
use crate::trace::plan::unseen::sides::boxes;

/// Words for a place above something, and for other places, without accents.
const ABOVE: [&str; 6] = ["above", "over", "overhead", "nad", "shora", "nahore"];
const OTHERS: [&str; 9] = [
    "not", "below", "under", "beneath", "from", "neni", "pod", "zdola", "zespodu",
];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let lamps: FxHashSet<u32> = scene.point_lights.iter().map(|light| light.id).collect();
    if lamps.is_empty() {
        return;
    }
    let mut said: FxHashSet<u32> = FxHashSet::default();
    let mut moves: FxHashMap<u32, Vec<&Record>> = FxHashMap::default();
    for record in context.records().filter(|r| lamps.contains(&r.id)) {
        if record.ty().family == Family::Transformation {
            moves.entry(record.id).or_default().push(record);
        }
        if context.record_params(record).own_comments().any(is_above) {
            said.insert(record.id);
        }
    }
    if said.is_empty() {
        return;
    }
    let boxes = boxes(scene, context.bounds(), render.root);
    let all = boxes.iter().fold(Aabb::EMPTY, |all, b| all.hull(b));
    if !all.is_bounded() {
        return;
    }
    for light in scene.point_lights.iter().filter(|l| said.contains(&l.id)) {
        let Some([only]) = moves.get(&light.id).map(Vec::as_slice) else {
            continue;
        };
        let y = light.position[1];
        if only.kind != RecordKind::Translation || y >= all.min[1] || -y <= all.max[1] {
            continue;
        }
        let p = context.record_params(only);
        let text = opposite(&p, 1);
        let shown = quote(&[p.text_of(0), &text, p.text_of(2)].join(" "));
        let span = p.span_of(1, 1);
        let fix = Fix::replace("fix", Applicability::Unsafe, span, text);
        out.push(
            Diagnostic::new(Code::W344, p.span_of(0, 3))
                .case("above")
                .with("id", p.id.to_string())
                .fix(fix.with("number", shown)),
        );
    }
}

fn is_above(comment: &str) -> bool {
    let words = words(comment);
    let has = |any: &[&str]| words.iter().any(|w| any.contains(&w.as_str()));
    has(&ABOVE) && !has(&OTHERS)
}
