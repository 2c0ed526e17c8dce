//! A checkerboard whose fields all have one colour.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::record::Params;
use crate::syntax::quote;
use crate::syntax::table::{Kind, RecordKind};

/// The indices of the two colours among the parameters.
const COLOURS: [usize; 2] = [2, 3];

/// The checkerboards that name one colour twice.
pub(in crate::lint::rules) fn of_one_colour<'a>(
    context: &Context<'a>,
) -> impl Iterator<Item = Params<'a>> {
    let boards = (context.records()).filter(|r| r.kind == RecordKind::Checkerboard);
    let all = boards.map(|r| context.record_params(r));
    all.filter(|p| p.integer(COLOURS[0]) == p.integer(COLOURS[1]))
}

/// The findings about checkerboards of one colour. If exactly one colour above a checkerboard is unused, the fix names
/// that one.
pub(super) fn check(context: &Context) -> Vec<Diagnostic> {
    let mut boards = of_one_colour(context).peekable();
    if boards.peek().is_none() || context.has_broken() {
        return Vec::new();
    }
    let named: FxHashSet<u32> = (context.records())
        .flat_map(|r| context.references(r))
        .collect();
    let entities = context.scene.entities.iter();
    let colours = entities.filter(|e| e.kind == Some(Kind::Colour));
    let unused: Vec<&Entity> = colours.filter(|e| !named.contains(&e.id)).collect();
    boards.map(|p| finding(&p, &unused)).collect()
}

fn finding(p: &Params, unused: &[&Entity]) -> Diagnostic {
    let place = p.span_of(COLOURS[1], 1);
    let d = Diagnostic::new(Code::W333, place)
        .case("checkerboard")
        .with("one-id", p.integer(COLOURS[1]).to_string());
    let mut above = unused.iter().filter(|e| e.span.start < place.start);
    let (Some(one), None) = (above.next(), above.next()) else {
        return d;
    };
    let text = one.id.to_string();
    let fix = Fix::replace("fix-write", Applicability::Unsafe, place, text.clone());
    d.fix(fix.with("number", quote(&text)))
}
