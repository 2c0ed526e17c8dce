//! W319: an intersection or a difference that is certainly empty.

use std::cell::LazyCell;

use super::duplicate_operand;
use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::lint::spelling::near;
use crate::scene::NodeId;
use crate::solids::named;
use crate::solids::proofs::Reason;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let unused = LazyCell::new(|| duplicate_operand::unused(context));
    // An operation that names one object twice is rather meant for an object that nothing uses.
    let other = |operation: NodeId| {
        let span = context.scene.origins[operation as usize].span;
        let p = context.params(span)?;
        let is_twice = p.integer(0) == p.integer(1);
        (is_twice.then(|| duplicate_operand::instead(&p, span, &unused))).flatten()
    };
    for Proven { node, what } in context.proven() {
        if let Proof::Empty(x, y, reason) = what
            && let Some(mut finding) = finding(context, *node, (*x, *y), reason)
        {
            finding.fixes.extend(other(*node));
            out.push(finding);
        }
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
            .with("between", Value::Decimal(near(*between, size)))
            .with("radii", Value::Decimal(near(*radii, size))),
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

/// Writes the scalar product of the factors and the coordinates: `x - 0.5y`.
fn sum(factors: [f64; 3]) -> String {
    let mut out = String::new();
    for (factor, name) in factors.into_iter().zip(["x", "y", "z"]) {
        // With more digits than anybody needs.
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

/// The difference of the two numbers of a reason. The message writes them finely enough that they still differ.
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

    /// The findings of this rule.
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
