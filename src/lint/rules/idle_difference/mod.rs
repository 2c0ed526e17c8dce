//! W332: a difference that certainly takes nothing away: the tool lies apart from the first operand, or merely touches
//! it; and one whose tool is a union with a part that lies apart.

mod parts;
pub(in crate::lint::rules) mod touching;

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::geometry::array::length;
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::lint::rules::{overridden_property::MAX_PROPOSED, turned_about_origin};
use crate::lint::spelling::near;
use crate::scene::record::Params;
use crate::scene::{Node, NodeId};
use crate::solids::named;
use crate::solids::proofs::Reason;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut proposed = 0;
    for Proven { node, what } in context.proven() {
        if let (Proof::Idle(reason), Node::Difference(a, b)) =
            (what, &context.scene.nodes[*node as usize])
        {
            let found = finding(context, *node, (*a, *b), reason);
            out.extend(found.map(|d| {
                proposed += 1;
                let fix = (proposed <= MAX_PROPOSED).then(|| turned_first(context, &d, (*a, *b)));
                fix.flatten().into_iter().fold(d, Diagnostic::fix)
            }));
        }
    }
    let proven: FxHashSet<NodeId> = context.proven().iter().map(|p| p.node).collect();
    for (node, made) in (0..).zip(&context.scene.nodes) {
        if let Node::Difference(a, b) = *made
            && !proven.contains(&node)
            && touching::touch(context, a, b)
        {
            out.extend(touch(context, node, (a, b)));
        }
    }
    parts::check(context, &proven, out);
}

/// The finding about operands that merely touch. The fix makes a union of the difference, which is rather meant. `None`
/// if the record is no difference.
fn touch(context: &Context, operation: NodeId, operands: (NodeId, NodeId)) -> Option<Diagnostic> {
    let (d, p) = about(context, operation, operands)?;
    let union = RecordType::of(RecordKind::Union).code.to_string();
    let fix = Fix::replace(
        "fix-union",
        Applicability::Choice,
        p.type_span(),
        union.clone(),
    );
    let fix = fix.with("number", quote(&union));
    (p.ty.kind == RecordKind::Difference).then(|| d.case("touch").fix(fix))
}

fn finding(
    context: &Context,
    operation: NodeId,
    operands: (NodeId, NodeId),
    reason: &Reason,
) -> Option<Diagnostic> {
    let (d, _) = about(context, operation, operands)?;
    // A tool within a solid that was taken away before may still touch what is left.
    let gap = match reason {
        Reason::Within | Reason::Same => return None,
        Reason::Apart { end, begin, .. } => Some(begin - end),
        Reason::Balls { between, radii } => Some(between - radii),
        Reason::Plane { normal, end, begin } => Some((begin - end) / length(*normal)),
        Reason::Beyond | Reason::Parts => None,
    };
    Some(match gap {
        Some(gap) => d.case("gap").with("gap", Value::Decimal(near(gap, gap))),
        None => d,
    })
}

/// The guess that an operand is turned before it is moved. `None` if its box then does not meet that of the other operand.
fn turned_first(context: &Context, d: &Diagnostic, (a, b): (NodeId, NodeId)) -> Option<Fix> {
    let scene = context.scene;
    [(a, b), (b, a)].into_iter().find_map(|(own, other)| {
        let swap = turned_about_origin::swap(context, named(scene, own)?.id, d.span.start)?;
        let other = context.bounds()[other as usize].all;
        let meets =
            (0..3).all(|i| swap.bounds.min[i] < other.max[i] && other.min[i] < swap.bounds.max[i]);
        let title = "fix-turn";
        meets.then_some(Fix { title, ..swap.fix })
    })
}

/// Begins the finding about a difference, with the names of its operands. Returns the record of the difference, too.
fn about<'c>(
    context: &'c Context,
    operation: NodeId,
    (a, b): (NodeId, NodeId),
) -> Option<(Diagnostic, Params<'c>)> {
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
    let same = one.span == two.span;
    let d = d.label(one.span, "one");
    Some((if same { d } else { d.label(two.span, "two") }, p))
}
