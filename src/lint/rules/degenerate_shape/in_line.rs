//! Points on one line.

use crate::geometry::exact;

/// The accuracy with which points lie on one line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum InLine {
    Exactly,
    /// The points may lie on one line exactly: they are off it by no more than the rounding of the written numbers to
    /// doubles.
    Rounded,
}

/// Whether points lie on one line, and how accurately; `None` if they do not.
pub(super) fn in_line<const N: usize>(points: &[[f64; N]]) -> Option<InLine> {
    let first = points.first()?;
    let away = |p: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| p[i] - first[i]) };
    // Each coordinate is divided by its largest size, under which a line stays a line.
    let size: [f64; N] = std::array::from_fn(|i| {
        let largest = points.iter().fold(0.0f64, |m, p| m.max(p[i].abs()));
        if largest > 0.0 { largest } else { 1.0 }
    });
    let length = |p: &[f64; N]| -> f64 {
        let d = away(p);
        (0..N).map(|i| (d[i] / size[i]).abs()).fold(0.0, f64::max)
    };
    // The direction to the point that is furthest from the first one is known best.
    let far = (points.iter()).max_by(|a, b| length(a).total_cmp(&length(b)))?;
    if !points
        .iter()
        .all(|p| nearly_in_line([first, far, p], &size))
    {
        return None;
    }
    Some(match exact::collinear(points.iter().copied()) {
        true => InLine::Exactly,
        false => InLine::Rounded,
    })
}

/// Whether the determinants of three points' differences are no larger than their rounding: half an ulp for each
/// number, each difference and each product.
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
