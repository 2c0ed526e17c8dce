//! W307: parts of a union that overlap and are of different media, or are cut open where they overlap.
//!
//! Overlapping opaque solids are everyday modelling, and the picture does not depend on the overlap: only the part of
//! each solid outside of the other is seen. The picture depends on it in two cases. Where light gets in, the overlap
//! belongs to the first operand, and the second one's surface is not seen in there. Where a difference cuts through the
//! overlap, the cut face looks like the first operand. (Where an intersection cuts, the face looks like the shape that
//! cuts.)

mod floor;
mod medium;
mod radius;
mod search;
mod split;
mod unions;

use rustc_hash::FxHashSet;

use super::{camera_in_solid, lamp_in_solid};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::lint::properties::Properties;
use crate::lint::roots;
use crate::lint::{Context, live_nodes};
use crate::parallel;
use crate::scene::record::Params;
use crate::scene::{Node, Optics, Origin};
use crate::trace::plan::unseen::{self, LeftOut};
use floor::Floors;
use search::{Overlap, Search};
use split::{Pieces, Splitter};
use unions::Unions;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let glass = |o: &Optics| o.kt.iter().any(|&k| k > 0.0);
    let opens = |n: &Node| matches!(n, Node::Difference(..));
    out.extend(radius::opaque(context));
    if !(scene.paints.iter().filter_map(|p| p.optics.as_ref())).any(glass)
        && !scene.nodes.iter().any(opens)
        || !scene.nodes.iter().any(|n| matches!(n, Node::Union(..)))
    {
        return;
    }
    let bounds = context.bounds();
    let roots = roots(scene, &live_nodes(scene));
    let left_out = match scene.render {
        Some(render) => unseen::find(scene, render.root).left_out,
        None => LeftOut::default(),
    };
    let unions = Unions::new(scene, bounds, &roots, &left_out);
    let mut search = Search::new(scene, &unions, bounds);
    let mut found = search.all();
    if found.is_empty() {
        return;
    }
    // A solid that holds a camera or a lamp is hardly where it should be, and W325 and W326 report it.
    let is_one_of = |found: &Overlap, solids: &FxHashSet<Span>| {
        let parts = found.parts.map(|i| unions.parts[i as usize].named.span);
        parts.iter().any(|span| solids.contains(span))
    };
    let around_cameras = camera_in_solid::solids(context);
    found.retain(|f| !is_one_of(f, &around_cameras));
    let around_lamps = lamp_in_solid::solids(context);
    // Not in parallel, since each fix takes new IDs of its own.
    let mut splitter = Splitter::new(context, bounds);
    let pieces = found.iter().map(|f| match is_one_of(f, &around_lamps) {
        true => None,
        false => splitter.pieces(f.union),
    });
    let pieces: Vec<Option<Pieces>> = pieces.collect();
    let properties = Properties::new(context);
    let floors = Floors::new(context, &unions, &found);
    let readings = radius::Readings::new(context, &unions, &found);
    let said = parallel::map(found.len(), |i| {
        let found = &found[i];
        let record = &scene.origins[found.union as usize];
        let p = context.params(record.span)?;
        let d = finding(&unions, &p, record, found);
        let fix = (pieces[i].as_ref()).and_then(|pieces| pieces.fix(context, &properties, &p));
        let other_sign = floors.fix(&unions, found);
        let radius = readings.fix(context, &unions, found);
        // With several fixes nobody can tell which one was meant.
        let fix = fix.map(|fix| match other_sign.is_some() || radius.is_some() {
            true => Fix {
                applicability: Applicability::Choice,
                ..fix
            },
            false => fix,
        });
        let fixes = radius.into_iter().chain(other_sign).chain(fix);
        Some(fixes.fold(d, Diagnostic::fix))
    });
    out.extend(said.into_iter().flatten());
}

fn finding(unions: &Unions, p: &Params, record: &Origin, found: &Overlap) -> Diagnostic {
    let [one, two] = found.parts.map(|i| &unions.parts[i as usize]);
    let [x, y, z] = found.witness.clone();
    Diagnostic::new(Code::W307, p.span_of(0, 2))
        .case(if found.open { "open" } else { "" })
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.named.title))
        .with("one-id", one.named.id.to_string())
        .with("two", Value::Term(two.named.title))
        .with("two-id", two.named.id.to_string())
        .with("x", Value::Decimal(x))
        .with("y", Value::Decimal(y))
        .with("z", Value::Decimal(z))
        .label(one.named.span, "first")
        .label(two.named.span, "second")
}

#[cfg(test)]
mod tests;
