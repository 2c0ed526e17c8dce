//! W307: parts of a union that overlap and are of different media.
//!
//! Opaque solids that overlap are everyday modelling, and the picture does not depend on it: all
//! that can be seen of each is what lies outside of the other. It does where light gets in: what
//! both hold belongs to the first operand, and the second one's surface is not seen in there.

mod medium;
mod search;
mod unions;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::solids::{near, operation_of, roots};
use crate::lint::{Context, live_nodes};
use crate::scene::bounds::node_bounds;
use crate::scene::record::Params;
use crate::scene::{Node, OperationRecord, Optics};
use crate::syntax::Item;
use search::{Found, Search};
use unions::Unions;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let glass = |o: &Optics| o.kt.iter().any(|&k| k > 0.0);
    if !(scene.paints.iter().filter_map(|p| p.optics.as_ref())).any(glass)
        || !scene.nodes.iter().any(|n| matches!(n, Node::Union(..)))
    {
        return;
    }
    let bounds = node_bounds(scene);
    let roots = roots(scene, &live_nodes(scene));
    let unions = Unions::new(scene, &bounds, &roots);
    let mut fresh = largest_id(context);
    let mut search = Search::new(scene, &unions, &bounds);
    for found in search.all() {
        if let Some(record) = operation_of(scene, found.union)
            && let Some(p) = context.params(record.span)
        {
            out.push(finding(&unions, &p, record, &found, &mut fresh));
        }
    }
}

fn finding(
    unions: &Unions,
    p: &Params,
    record: &OperationRecord,
    found: &Found,
    fresh: &mut u32,
) -> Diagnostic {
    let [one, two] = found.parts.map(|i| &unions.parts[i as usize]);
    let size = (0..3).fold(f64::INFINITY, |m, i| {
        let both = one.bounds.intersection(&two.bounds);
        m.min(both.max[i] - both.min[i])
    });
    let [x, y, z] = found.witness.map(|x| near(x, size));
    let d = Diagnostic::new(Code::W307, p.span_of(0, 2))
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.named.title))
        .with("one-id", one.named.id.to_string())
        .with("two", Value::Term(two.named.title))
        .with("two-id", two.named.id.to_string())
        .with("x", x)
        .with("y", y)
        .with("z", z)
        .label(one.named.span, "first")
        .label(two.named.span, "second");
    match split(p, fresh) {
        Some(fix) => d.fix(fix),
        None => d,
    }
}

/// The largest ID of the file.
fn largest_id(context: &Context) -> u32 {
    let ids = context.document.items.iter().map(|item| match item {
        Item::Record(r) => r.id,
        Item::Broken(b) => b.id.unwrap_or(0),
        Item::Void { .. } => 0,
    });
    ids.max().unwrap_or(0)
}

/// The largest ID that the language knows.
const ID_MAX: u32 = i32::MAX as u32;

/// A ∪ B as (A − B) ∪ (B − A) ∪ (A ∩ B): the pieces come first, the record keeps its place and its
/// comments.
fn split(p: &Params, fresh: &mut u32) -> Option<Fix> {
    let first = fresh.checked_add(1).filter(|f| *f <= ID_MAX - 3)?;
    let (a, b) = (p.text_of(0), p.text_of(1));
    let ids: [u32; 4] = std::array::from_fn(|i| first + i as u32);
    *fresh = ids[3];
    let [only_a, only_b, both, either] = ids;
    let at = crate::diagnostics::Span::new(p.id_span.start, p.id_span.start);
    let edit = |span, text| Edit { span, text };
    Some(Fix {
        title: "fix",
        applicability: Applicability::Unsafe,
        edits: vec![
            edit(
                at,
                format!(
                    "{only_a} -103 {a} {b}\n{only_b} -103 {b} {a}\n{both} -102 {a} {b}\n{either} -101 {only_a} {only_b}\n"
                ),
            ),
            edit(p.span_of(0, 1), either.to_string()),
            edit(p.span_of(1, 1), both.to_string()),
        ],
    })
}

#[cfg(test)]
mod tests;
