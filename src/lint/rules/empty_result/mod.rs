//! W319: an intersection or a difference that is empty for certain.
//!
//! An operation without unions is that everything of a list is to hold: some things, and the
//! complements of others. It is empty if two of the first lie apart, if one of the first lies within
//! one of the second, or is the same. Chains keep a few of their list only.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::spelling::near;
use crate::scene::{Node, NodeId};
use crate::solids::named;
use crate::solids::proofs::{Literals, Proofs, Reason};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    each(context, |_, _, operation| {
        if let Some((x, y, reason)) = &operation.proof {
            out.extend(finding(context, operation.node, (*x, *y), reason));
        }
    });
}

/// An intersection or a difference.
pub struct Operation {
    pub node: NodeId,
    pub operands: (NodeId, NodeId),
    pub is_difference: bool,
    /// An operand is empty, of which has been spoken.
    pub is_of_nothing: bool,
    /// That it is empty itself.
    pub proof: Option<(NodeId, NodeId, Reason)>,
}

/// Looks at each intersection and each difference, with a few of what is to hold in each node before it.
pub fn each(context: &Context, mut found: impl FnMut(&mut Proofs, &[Literals], Operation)) {
    let scene = context.scene;
    let bounds = context.bounds();
    let mut proofs = Proofs::new(scene, bounds);
    // What is empty has been spoken of, here or by the rules about shapes.
    let mut empty: Vec<bool> = Vec::with_capacity(scene.nodes.len());
    let mut lists: Vec<Literals> = Vec::with_capacity(scene.nodes.len());
    for (i, node) in scene.nodes.iter().enumerate() {
        let is_empty = |n: NodeId| empty[n as usize];
        let own = Literals::new((i as NodeId, false));
        let (nothing, list) = match *node {
            Node::Shape(_) => (bounds[i].all.is_empty(), own),
            Node::Transform { child, .. } => (is_empty(child), own),
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                (is_empty(child), lists[child as usize])
            }
            Node::Union(a, b) => (is_empty(a) && is_empty(b), own),
            Node::Complement(child) => match lists[child as usize][..] {
                [(n, turned)] => (false, Literals::new((n, !turned))),
                _ => (false, own),
            },
            Node::Intersection(a, b) | Node::Difference(a, b) => {
                let is_difference = matches!(node, Node::Difference(..));
                let first = lists[a as usize];
                let second = match is_difference {
                    true => proofs.complement(b, &lists),
                    false => lists[b as usize].to_vec(),
                };
                let known = is_empty(a) || (!is_difference && is_empty(b));
                let is_of_nothing = known || (is_difference && is_empty(b));
                let proof = match is_of_nothing {
                    true => None,
                    false => proofs.nothing(&first, &second, (!is_difference).then_some((a, b))),
                };
                let nothing = known || proof.is_some();
                let operation = Operation {
                    node: i as NodeId,
                    operands: (a, b),
                    is_difference,
                    is_of_nothing,
                    proof,
                };
                found(&mut proofs, &lists, operation);
                let mut all = first;
                all.extend(&second);
                (nothing, all)
            }
        };
        empty.push(nothing);
        lists.push(list);
    }
}

fn finding(
    context: &Context,
    operation: NodeId,
    (x, y): (NodeId, NodeId),
    reason: &Reason,
) -> Option<Diagnostic> {
    let scene = context.scene;
    let (one, two) = (named(scene, x)?, named(scene, y)?);
    let record = scene.origins[operation as usize];
    let operation = named(scene, operation)?;
    let p = context.params(record.span)?;
    let d = Diagnostic::new(Code::W319, p.span_of(0, 2))
        .with("operation", Value::Term(operation.title))
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.title))
        .with("one-id", one.id.to_string())
        .with("two", Value::Term(two.title))
        .with("two-id", two.id.to_string());
    let size = (begin_size(reason)).max(f64::MIN_POSITIVE);
    let d = match reason {
        Reason::Apart { axis, end, begin } => d
            .with("axis", ["x", "y", "z"][*axis])
            .with("end", near(*end, size))
            .with("begin", near(*begin, size)),
        Reason::Balls { between, radii } => d
            .case("balls")
            .with("between", near(*between, size))
            .with("radii", near(*radii, size)),
        Reason::Plane { normal, end, begin } => {
            let largest = normal.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            d.with("axis", sum(normal.map(|x| x / largest)))
                .with("end", near(*end / largest, size / largest))
                .with("begin", near(*begin / largest, size / largest))
        }
        Reason::Parts => d.case("parts"),
        Reason::Beyond => d.case("beyond"),
        Reason::Within => d.case("within"),
        Reason::Same if one.id == two.id && operation.title == "intersection" => d.case("both"),
        Reason::Same if one.id == two.id => d.case("itself"),
        Reason::Same => d.case("same"),
    };
    let same = one.span == two.span;
    let d = d.label(one.span, "one");
    Some(if same { d } else { d.label(two.span, "two") })
}

/// A product with the coordinates: `x - 0.5y`.
fn sum(factors: [f64; 3]) -> String {
    let mut out = String::new();
    for (factor, name) in factors.into_iter().zip(["x", "y", "z"]) {
        // So many digits that nobody misses the rest.
        let digits = near(factor.abs(), 1e-3);
        let sign = match (out.is_empty(), factor < 0.0) {
            _ if digits == "0" => continue,
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let digits = if digits == "1" { "" } else { &digits };
        out += &format!("{sign}{digits}{name}");
    }
    out
}

/// How far the numbers of a reason are apart: they are told so finely that they stay so.
fn begin_size(reason: &Reason) -> f64 {
    match reason {
        Reason::Apart { end, begin, .. } | Reason::Plane { end, begin, .. } => begin - end,
        Reason::Balls { between, radii } => between - radii,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{self};

    /// What this rule finds.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W319")).collect()
    }

    /// A ball in one of the gaps of a row: all 64 parts are looked at one by one.
    #[test]
    fn a_gap_in_a_long_row() {
        let row = |parts: usize, at: f64| {
            let balls = (0..parts).map(|i| format!("{} 11 {} 0 0 1\n", 10 + i, 3 * i));
            let sums = (1..parts).map(|i| match i {
                1 => "1001 -101 10 11\n".to_owned(),
                _ => format!("{} -101 {} {}\n", 1000 + i, 999 + i, 10 + i),
            });
            let sum: String = balls.chain(sums).collect();
            format!("{sum}2 11 {at} 0 0 0.4\n3 -102 2 {}\n", 999 + parts)
        };
        for gap in [0, 31, 62] {
            let middle = 3.0 * f64::from(gap) + 1.5;
            assert_eq!(found(&row(64, middle)).len(), 1, "gap {gap}");
            assert!(found(&row(64, middle + 0.2)).is_empty(), "gap {gap}");
        }
    }
}
