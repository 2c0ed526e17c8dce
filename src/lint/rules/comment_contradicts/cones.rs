//! A cone whose comment says that its tip is up, and whose tip is down.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::spelling::opposite;
use crate::scene::axes::words;
use crate::scene::record::Params;
use crate::scene::sizes;
use crate::syntax::table::{Family, RecordKind};
use crate::syntax::{Record, quote};

/// Beginnings of words for the tip of a cone, without accents.
const TIP: [&str; 6] = ["tip", "apex", "spick", "spic", "vrchol", "hrot"];
/// Words for upwards, without accents.
const UP: [&str; 8] = [
    "up", "upward", "upwards", "upright", "top", "nahoru", "nahore", "vzhuru",
];
/// Beginnings of words by which a comment says something else of the tip, without accents.
const OTHERS: [&str; 9] = [
    "down", "dol", "dole", "not", "neni", "upside", "turn", "rot", "otoc",
];

/// Whether a comment on the record says that the tip of a cone is up.
pub(super) fn has_tip_up(p: &Params) -> bool {
    p.number(0) > 0.0 && p.own_comments().any(is_tip_up)
}

fn is_tip_up(comment: &str) -> bool {
    let words = words(comment);
    let begins = |any: &[&str]| words.iter().any(|w| any.iter().any(|b| w.starts_with(b)));
    let is_up = words.iter().any(|w| UP.contains(&w.as_str()));
    is_up && begins(&TIP) && !begins(&OTHERS)
}

/// The findings about `cones`: comments say that their tips are up, and their bases are above their tips. Cones that
/// something may turn are left out.
pub(super) fn check(context: &Context, cones: &[&Record], out: &mut Vec<Diagnostic>) {
    let mut cameras = context.scene.cameras.iter();
    if cones.is_empty() || !cameras.all(|camera| camera.up[1] > 0.0) {
        return;
    }
    let is_move = |r: &Record| r.ty().family == Family::Transformation;
    let turned = context.with_parts(|r| is_move(r) && r.kind != RecordKind::Translation);
    let mut moves: FxHashMap<u32, Vec<&Record>> = FxHashMap::default();
    for record in context.records().filter(|r| is_move(r)) {
        moves.entry(record.id).or_default().push(record);
    }
    for cone in cones.iter().filter(|cone| !turned.contains(&cone.id)) {
        let p = context.record_params(cone);
        let moved = match moves.get(&cone.id).map(Vec::as_slice) {
            None => None,
            Some([only]) => Some(context.record_params(only)),
            Some(_) => continue,
        };
        let height = p.number(0);
        let text = opposite(&p, 0);
        let mut fix = Fix::replace("fix", Applicability::Unsafe, p.span_of(0, 1), text.clone());
        fix = fix.with("number", quote(&text));
        if let Some(translation) = moved.filter(|translation| translation.len() == 3) {
            // The base comes to where the tip was.
            let raised = sizes::sum(translation.number(1), height);
            let shown = [translation.text_of(0), &raised, translation.text_of(2)].join(" ");
            fix.title = "fix-moved";
            fix.edits.push(Edit {
                span: translation.span_of(1, 1),
                text: raised,
            });
            fix = fix.with("place", quote(&shown));
        }
        out.push(
            Diagnostic::new(Code::W344, p.span_of(0, 1))
                .case("tip")
                .with("id", p.id.to_string())
                .with("height", p.text_of(0).to_owned())
                .fix(fix),
        );
    }
}
