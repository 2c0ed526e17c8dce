//! W313: a surface where an operation wants a solid.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::parts::parts;
use crate::scene::{Node, NodeId};
use crate::solids::named;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let parts = parts(scene);
    let surface = |n: NodeId| parts[n as usize].surface.is_some();
    let mut findings: Vec<(NodeId, Case, usize)> = Vec::new();
    for (i, node) in scene.nodes.iter().enumerate() {
        let (case, operand) = match *node {
            Node::Intersection(a, b) => match (surface(a), surface(b)) {
                (true, true) if !parts[a as usize].solid && !parts[b as usize].solid => {
                    (Case::Both, 0)
                }
                (true, _) => (Case::Inside, 0),
                (false, true) => (Case::Inside, 1),
                _ => continue,
            },
            Node::Difference(_, b) if surface(b) => (Case::Tool, 1),
            Node::Difference(a, _) if surface(a) => (Case::Outside, 0),
            Node::Complement(a) if surface(a) => (Case::Complement, 0),
            _ => continue,
        };
        findings.push((i as NodeId, case, operand));
    }
    if findings.is_empty() {
        return;
    }
    let titles = context.titles();
    for (node, case, operand) in findings {
        let origin = scene.origins[node as usize];
        let Some(p) = context.params(origin.span) else {
            continue;
        };
        let child = scene.nodes[node as usize].children().nth(operand);
        let Some(part) = child.map(|c| parts[c as usize]) else {
            continue;
        };
        let Some(surface) = part.surface.and_then(|node| named(scene, node)) else {
            continue;
        };
        let id = |i: usize| u32::try_from(p.integer(i)).unwrap_or(0);
        let title = |i: usize| Value::Term(titles.get(&id(i)).copied().unwrap_or("object"));
        let d = Diagnostic::new(Code::W313, p.span_of(operand, 1))
            .case(case.name())
            .with("what", if part.solid { "part" } else { "whole" })
            .with("operand", title(operand))
            .with("operand-id", id(operand).to_string())
            .with("id", origin.id.to_string());
        let d = match p.len() {
            2 => d
                .with("other", title(1 - operand))
                .with("other-id", id(1 - operand).to_string()),
            _ => d,
        };
        out.push(
            d.with("shape", Value::Term(surface.title))
                .with("shape-id", surface.id.to_string())
                .label(surface.span, "surface"),
        );
    }
}

#[derive(Clone, Copy)]
enum Case {
    /// An intersection keeps the part of a surface that is inside of the other operand.
    Inside,
    /// A difference keeps the part of a surface that is outside of the other operand.
    Outside,
    /// The tool of a difference is a surface, which takes nothing away.
    Tool,
    /// Both operands are surfaces, without an inside in which a part of the other one could lie.
    Both,
    Complement,
}

impl Case {
    fn name(self) -> &'static str {
        match self {
            Case::Inside => "",
            Case::Outside => "outside",
            Case::Tool => "tool",
            Case::Both => "both",
            Case::Complement => "complement",
        }
    }
}
