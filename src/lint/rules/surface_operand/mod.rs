//! W313: a surface where an operation wants a solid.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::parts::parts;
use crate::scene::{Node, NodeId};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
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
        let child = scene.nodes[node as usize].children()[operand];
        let Some(part) = child.map(|c| parts[c as usize]) else {
            continue;
        };
        let Some(shape) = part.surface.map(|s| &scene.shapes[s as usize]) else {
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
            d.with("shape", Value::Term(shape.ty.title))
                .with("shape-id", shape.id.to_string())
                .label(shape.span, "surface"),
        );
    }
}

#[derive(Clone, Copy)]
enum Case {
    /// Of a surface an intersection keeps what is inside the other operand.
    Inside,
    /// A difference keeps what is outside.
    Outside,
    /// A surface takes nothing away.
    Tool,
    /// Two surfaces have no inside that anything could be in.
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

#[cfg(test)]
mod tests {
    use crate::lint::testing::{found, messages};

    const SHAPES: &str = "2 9 5\n3 5 -1 -1 1 1\n4 3 0 1 0 0\n";

    fn scene(records: &str) -> String {
        SHAPES.to_owned() + records
    }

    #[test]
    fn says_what_happens() {
        let said = |records: &str| messages(&scene(records)).remove(0);
        assert_eq!(
            said("5 -102 3 2"),
            "the rectangle 3 is a surface: of it, the intersection 5 keeps what is inside the sphere at the origin 2"
        );
        assert_eq!(
            said("5 -103 3 2"),
            "the rectangle 3 is a surface: of it, the difference 5 keeps what is outside the sphere at the origin 2"
        );
        assert_eq!(
            said("5 -103 2 3"),
            "the rectangle 3 is a surface: taking it away from the sphere at the origin 2 changes nothing"
        );
        assert_eq!(
            said("5 -102 3 4"),
            "the rectangle 3 and the plane 4 are surfaces: their intersection 5 is empty"
        );
        assert_eq!(
            said("5 -104 4"),
            "the plane 4 is a surface: its complement 5 is all of space"
        );
    }

    #[test]
    fn the_operand_is_pointed_at() {
        assert_eq!(found(&scene("5 -102 2 3")), ["W313 4:10"]);
        // All of it lies within the other one.
        assert_eq!(found(&scene("5 -103 3 2")), ["W313 4:8", "W319 4:8"]);
    }

    #[test]
    fn unions_that_have_surfaces() {
        let both = scene("5 -101 2 3\n6 12 0 0 0 1 1 1\n7 -103 5 6");
        assert_eq!(found(&both), ["W313 6:8"]);
        assert_eq!(
            messages(&both),
            [
                "the union 5 has a surface in it: of that, the difference 7 keeps what is outside the box 6"
            ]
        );
        // Moved, copied and painted it is still a surface.
        let copy = scene("3 -1 0 1 0\n5 -105 3\n5 -701 1 0 0\n6 -103 2 5");
        assert_eq!(found(&copy), ["W313 7:10"]);
    }

    #[test]
    fn silent_otherwise() {
        for records in [
            "5 -101 2 3",
            "5 -101 3 4",
            "5 -105 3",
            "5 4 0 1 0 0\n6 -102 2 5",
            // What has been cut is not asked about again.
            "5 4 0 1 0 0\n6 -103 2 5\n7 -101 6 3",
        ] {
            assert!(found(&scene(records)).is_empty(), "{records}");
        }
        let again = scene("5 -102 3 2\n6 4 1 0 0 0\n7 -102 5 6");
        assert_eq!(found(&again), ["W313 4:8"]);
    }
}
