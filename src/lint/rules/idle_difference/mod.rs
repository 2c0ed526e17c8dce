//! W332: a difference that takes nothing away for certain: what is taken away lies apart.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::geometry::array::length;
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::lint::spelling::near;
use crate::scene::{Node, NodeId};
use crate::solids::named;
use crate::solids::proofs::Reason;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for Proven { node, what } in context.proven() {
        if let (Proof::Idle(reason), Node::Difference(a, b)) =
            (what, &context.scene.nodes[*node as usize])
        {
            out.extend(finding(context, *node, (*a, *b), reason));
        }
    }
}

fn finding(
    context: &Context,
    operation: NodeId,
    (a, b): (NodeId, NodeId),
    reason: &Reason,
) -> Option<Diagnostic> {
    let scene = context.scene;
    let (one, two) = (named(scene, a)?, named(scene, b)?);
    let record = scene.origins[operation as usize];
    let p = context.params(record.span)?;
    let d = Diagnostic::new(Code::W332, p.span_of(1, 1))
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.title))
        .with("one-id", one.id.to_string())
        .with("two", Value::Term(two.title))
        .with("two-id", two.id.to_string());
    // What is within something that was taken away already may touch what is left.
    let gap = match reason {
        Reason::Within | Reason::Same => return None,
        Reason::Apart { end, begin, .. } => Some(begin - end),
        Reason::Balls { between, radii } => Some(between - radii),
        Reason::Plane { normal, end, begin } => Some((begin - end) / length(*normal)),
        Reason::Beyond | Reason::Parts => None,
    };
    let d = match gap {
        Some(gap) => d.case("gap").with("gap", Value::Decimal(near(gap, gap))),
        None => d,
    };
    let same = one.span == two.span;
    let d = d.label(one.span, "one");
    Some(if same { d } else { d.label(two.span, "two") })
}
