//! Spheres that overlap other parts, and may be written with the radius first.

use rustc_hash::FxHashSet;

use super::search::{MIN_REL_DEPTH, Overlap};
use super::unions::{UnionOperand, Unions};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::geometry::{Aabb, Matrix};
use crate::lint::{Context, live_nodes, roots};
use crate::scene::Node;
use crate::scene::record::Params;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::LeftOut;

/// Most shapes and parts with which opaque spheres are examined: each sphere is held against all parts.
const MAX_PARTS: usize = 1000;

/// Least number of overlaps that the other reading has to undo: that many are no coincidence.
const MIN_OVERLAPS: usize = 2;

/// A sphere cuts deep into an endless part if it reaches in by more than this share of its radius.
const DEEP_REL: f64 = 0.25;

/// The findings about opaque spheres that overlap several other parts deeply, and with the first number as the radius
/// would overlap none and touch one.
pub(super) fn opaque(context: &Context) -> Vec<Diagnostic> {
    let scene = context.scene;
    let is_sphere = |kind| kind == RecordKind::Shape(ShapeKind::Sphere);
    if scene.shapes.len() > MAX_PARTS || !context.records().any(|r| is_sphere(r.kind)) {
        return Vec::new();
    }
    let all = roots(scene, &live_nodes(scene));
    // No part is left out: parts that a sphere swallows count, too.
    let unions = Unions::new(scene, context.bounds(), &all, &LeftOut::default());
    if unions.parts.len() > MAX_PARTS {
        return Vec::new();
    }
    let parts = unions.parts.iter().enumerate();
    let mut told = FxHashSet::default();
    let found = parts.filter_map(|(i, ball)| {
        let is_clear = unions.media[ball.medium as usize].transmits();
        let p = sphere(context, ball).filter(|_| !is_clear && ball.cut.is_none())?;
        let others = (unions.parts.iter().enumerate()).filter(|(j, _)| *j != i);
        let others: Vec<&UnionOperand> = others.map(|(_, other)| other).collect();
        let overlapped: Vec<&UnionOperand> = (others.iter().copied())
            .filter(|other| is_deep_in(&p, &other.bounds))
            .collect();
        let is_touching = |other: &&UnionOperand| touches(context, &p, ball, &other.bounds);
        let is_better = overlapped.len() >= MIN_OVERLAPS
            && (others.iter()).all(|other| gap(&p, &other.bounds) >= -MIN_REL_DEPTH)
            && others.iter().any(is_touching)
            && told.insert(p.span());
        is_better.then(|| finding(&p, &overlapped))
    });
    found.collect()
}

fn finding(p: &Params, overlapped: &[&UnionOperand]) -> Diagnostic {
    let d = Diagnostic::new(Code::W307, p.span())
        .case("radius")
        .with("one-id", p.id.to_string())
        .with("count", Value::Count(overlapped.len() as u64));
    let spans = overlapped.iter().map(|part| part.named.span);
    let d = spans.take(MIN_OVERLAPS).fold(d, |d, s| d.label(s, "other"));
    d.fix(moved(p, false))
}

/// Whether a sphere as it is written overlaps another part deeply: it holds the middle of a bounded part, or cuts deep
/// into an endless one.
fn is_deep_in(p: &Params, other: &Aabb) -> bool {
    let [centre @ .., radius]: [f64; 4] = p.numbers(0);
    match other.is_finite() {
        true => {
            let off = |i: usize| (other.min[i] + other.max[i]) / 2.0 - centre[i];
            (0..3).map(|i| off(i).powi(2)).sum::<f64>().sqrt() < radius
        }
        false => distance(centre, other) < radius * (1.0 - DEEP_REL),
    }
}

/// The distance of a sphere, read with its radius first, from the box of another part, as a share of the radius.
/// Negative if the sphere reaches into the box.
fn gap(p: &Params, other: &Aabb) -> f64 {
    let [radius, centre @ ..]: [f64; 4] = p.numbers(0);
    (distance(centre, other) - radius) / radius
}

fn distance(point: [f64; 3], other: &Aabb) -> f64 {
    let off = |i: usize| point[i] - point[i].max(other.min[i]).min(other.max[i]);
    (0..3).map(|i| off(i).powi(2)).sum::<f64>().sqrt()
}

/// The spheres whose first number may be the radius: wider space sets that number apart, or the sphere then touches a
/// part instead of overlapping it.
pub(super) struct Readings(FxHashSet<Span>);

impl Readings {
    pub(super) fn new(context: &Context, unions: &Unions, found: &[Overlap]) -> Readings {
        let pairs = found.iter().flat_map(|f| {
            let [one, two] = f.parts.map(|i| &unions.parts[i as usize]);
            [(one, two), (two, one)]
        });
        let spheres = pairs.filter_map(|(ball, other)| {
            let p = sphere(context, ball)?;
            let is_one = is_set_apart(&p) || touches(context, &p, ball, &other.bounds);
            is_one.then(|| p.span())
        });
        Readings(spheres.collect())
    }

    /// The fix that reads the first number of a sphere, one of two overlapping parts, as its radius. `None` if the sphere
    /// then still overlaps the other part, unless wider space sets that number apart.
    pub(super) fn fix(&self, context: &Context, unions: &Unions, found: &Overlap) -> Option<Fix> {
        let [one, two] = found.parts.map(|i| &unions.parts[i as usize]);
        let of = |ball: &UnionOperand, other: &UnionOperand| {
            let p = sphere(context, ball).filter(|p| self.0.contains(&p.span()))?;
            let is_apart = is_set_apart(&p);
            (is_apart || gap(&p, &other.bounds) >= -MIN_REL_DEPTH).then(|| moved(&p, is_apart))
        };
        of(two, one).or_else(|| of(one, two))
    }
}

/// The record of a part that is a sphere whose first number may be a radius; `None` for other parts.
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

/// Whether the sphere, read with its radius first, and the box of another part have no more than their borders in
/// common.
fn touches(context: &Context, p: &Params, ball: &UnionOperand, other: &Aabb) -> bool {
    // The record of a sphere that is moved or scaled does not say where the sphere is.
    let is_there = context.scene.core(ball.node, ball.matrix).1 == Matrix::IDENTITY;
    is_there && gap(p, other).abs() <= MIN_REL_DEPTH
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
