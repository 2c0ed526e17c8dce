//! Spheres that overlap other parts, and may have their radius first.

use super::search::{MIN_REL_DEPTH, Overlap};
use super::unions::{UnionOperand, Unions};
use crate::diagnostics::{Applicability, Fix};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::scene::Node;
use crate::scene::record::Params;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, ShapeKind};

/// The fix of a sphere that is one of two parts: its first number as the radius, where spaces set that apart, or where the
/// sphere then touches the other part instead of overlapping it.
pub(super) fn fix(context: &Context, unions: &Unions, found: &Overlap) -> Option<Fix> {
    let [one, two] = found.parts.map(|i| &unions.parts[i as usize]);
    let of = |ball: &UnionOperand, other: &UnionOperand| {
        let p = sphere(context, ball)?;
        let is_apart = is_set_apart(&p);
        (is_apart || touches(context, &p, ball, &other.bounds)).then(|| moved(&p, is_apart))
    };
    of(two, one).or_else(|| of(one, two))
}

/// The record of a part that is a sphere whose first number may be a radius.
fn sphere<'c>(context: &'c Context, part: &UnionOperand) -> Option<Params<'c>> {
    let (core, _) = context.scene.core(part.node, part.matrix);
    if !matches!(context.scene.nodes[core as usize], Node::Shape(_)) {
        return None;
    }
    let p = context.params(part.named.span)?;
    let is_one = p.ty.kind == RecordKind::Shape(ShapeKind::Sphere) && p.number(0) > 0.0;
    (is_one && p.id == part.named.id).then_some(p)
}

/// Whether more spaces stand behind the first number than between the other three.
fn is_set_apart(p: &Params) -> bool {
    let gap = |i: usize| &p.text[p.span_of(i, 1).end as usize..p.span_of(i + 1, 1).start as usize];
    let is_wide = gap(0).len() > 1 && gap(0).bytes().all(|c| c == b' ');
    is_wide && gap(1) == " " && gap(2) == " "
}

/// Whether the sphere with its radius first and the box of another part have no more than their borders in common.
fn touches(context: &Context, p: &Params, ball: &UnionOperand, other: &Aabb) -> bool {
    // What is moved or scaled is where nobody reads it from the record.
    let is_there = context.scene.core(ball.node, ball.matrix).1 == Matrix::IDENTITY;
    let [radius, centre @ ..]: [f64; 4] = p.numbers(0);
    let off = |i: usize| centre[i] - centre[i].max(other.min[i]).min(other.max[i]);
    let distance = (0..3).map(|i| off(i).powi(2)).sum::<f64>().sqrt();
    is_there && (distance - radius).abs() <= MIN_REL_DEPTH * radius
}

fn moved(p: &Params, is_apart: bool) -> Fix {
    let texts: Vec<&str> = [1, 2, 3, 0].iter().map(|&i| p.text_of(i)).collect();
    let new = texts.join(" ");
    let applicability = match is_apart {
        true => Applicability::Unsafe,
        false => Applicability::Choice,
    };
    let fix = Fix::replace("fix-radius", applicability, p.span_of(0, 4), new.clone());
    fix.with("number", quote(&new))
}
