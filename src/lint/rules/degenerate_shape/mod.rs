//! W305: a shape without volume, or a surface without area.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::geometry::exact;
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Geometry, Shape};
use crate::solids::definite::{Verdict, judge};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for shape in &context.scene.shapes {
        if is_degenerate(shape)
            && let Some(p) = context.params(shape.span)
        {
            out.push(finding(shape, &p));
        }
    }
}

fn is_degenerate(shape: &Shape) -> bool {
    match &shape.geometry {
        Geometry::Box { min, max } => (0..3).any(|i| min[i] == max[i]),
        Geometry::Rectangle { min, max } => (0..2).any(|i| min[i] == max[i]),
        Geometry::Triangle { vertices, .. } => in_line(vertices).is_some(),
        Geometry::Cone { height, .. } => *height == 0.0,
        Geometry::Quadric(q) => matches!(judge(q), Verdict::Flat(_)),
        Geometry::Revolution { profile, .. } => in_line(&closed(profile)).is_some(),
        _ => false,
    }
}

fn finding(shape: &Shape, p: &Params) -> Diagnostic {
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let new = |case, first, n| {
        Diagnostic::new(Code::W305, p.span_of(first, n))
            .case(case)
            .with("type", Value::Term(shape.ty.title))
            .with("id", shape.id.to_string())
    };
    match &shape.geometry {
        Geometry::Box { .. } | Geometry::Rectangle { .. } => {
            let half = p.len() / 2;
            let equal: Vec<usize> = (0..half)
                .filter(|&i| p.number(i) == p.number(i + half))
                .collect();
            let pairs: Vec<String> = equal
                .iter()
                .map(|&i| format!("{} = {}", name(i), name(i + half)))
                .collect();
            let first = equal.first().copied().unwrap_or(0);
            let case = match shape.geometry.is_solid() {
                true => "box",
                false => "rectangle",
            };
            new(case, first, 1)
                .with("pairs", pairs.join(", "))
                .with("lower", name(first))
                .with("upper", name(first + half))
                .label(p.span_of(first + half, 1), "other")
        }
        Geometry::Triangle { vertices, .. } => match in_line(vertices) {
            Some(Line::Exact) => new("triangle", 0, 9),
            _ => new("triangle-nearly", 0, 9),
        },
        Geometry::Cone { .. } => new("cone", 0, 1),
        Geometry::Quadric(q) => match judge(q) {
            Verdict::Flat(0) => new("point", 0, 16),
            Verdict::Flat(1) => new("line", 0, 16),
            _ => new("plane", 0, 16),
        },
        Geometry::Revolution { profile, .. } => match profile.iter().all(|q| q[0] == 0.0) {
            true => new("axis", 1, 2 * p.count),
            false => match in_line(&closed(profile)) {
                Some(Line::Exact) => new("profile", 1, 2 * p.count),
                _ => new("profile-nearly", 1, 2 * p.count),
            },
        },
        _ => new("", 0, p.len()),
    }
}

/// How points lie in one line.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Line {
    Exact,
    /// For all that the written numbers say: within what these were rounded by to be doubles.
    Rounded,
}

/// Whether points lie in one line.
fn in_line<const N: usize>(points: &[[f64; N]]) -> Option<Line> {
    let first = points.first()?;
    let away = |p: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| p[i] - first[i]) };
    // Coordinates of one size each: a line stays one.
    let size: [f64; N] = std::array::from_fn(|i| {
        let largest = points.iter().fold(0.0f64, |m, p| m.max(p[i].abs()));
        if largest > 0.0 { largest } else { 1.0 }
    });
    let length = |p: &[f64; N]| -> f64 {
        let d = away(p);
        (0..N).map(|i| (d[i] / size[i]).abs()).fold(0.0, f64::max)
    };
    // The direction to the point furthest from the first one is the best known.
    let far = (points.iter()).max_by(|a, b| length(a).total_cmp(&length(b)))?;
    if !points
        .iter()
        .all(|p| nearly_in_line([first, far, p], &size))
    {
        return None;
    }
    Some(match exact::collinear(points.iter().copied()) {
        true => Line::Exact,
        false => Line::Rounded,
    })
}

/// Whether the determinants of three points' differences are no larger than what rounds them: half an
/// ulp for each number, each difference and each product.
fn nearly_in_line<const N: usize>(points: [&[f64; N]; 3], size: &[f64; N]) -> bool {
    let [p, a, b] = points.map(|p| -> [f64; N] { std::array::from_fn(|i| p[i] / size[i]) });
    let way = |to: &[f64; N], i: usize| to[i] - p[i];
    let rounded = |to: &[f64; N], i: usize| to[i].abs() + p[i].abs() + way(to, i).abs();
    let cross = |i: usize, j: usize| {
        let ([ai, aj], [bi, bj]) = ([i, j].map(|k| way(&a, k)), [i, j].map(|k| way(&b, k)));
        let terms = rounded(&a, i) * bj.abs()
            + rounded(&b, j) * ai.abs()
            + rounded(&a, j) * bi.abs()
            + rounded(&b, i) * aj.abs();
        (ai * bj - aj * bi).abs() <= f64::EPSILON * terms
    };
    (0..N).all(|i| (i + 1..N).all(|j| cross(i, j)))
}

/// The points of a profile, closed as the language closes it.
fn closed(profile: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let ends = match (profile.first(), profile.last()) {
        (Some(first), Some(last)) if first != last => vec![[0.0, first[1]], [0.0, last[1]]],
        _ => Vec::new(),
    };
    profile.iter().copied().chain(ends).collect()
}
