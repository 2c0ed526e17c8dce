//! W305: a shape without volume, or a surface without area.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::definite::{Verdict, judge};
use crate::scene::record::Params;
use crate::scene::{Geometry, Shape};

/// A determinant of differences of numbers that were rounded to doubles is off by half an ulp for
/// each number, and as much for the difference, the product and the sum: below 4 ε of its terms.
/// What is smaller is zero for all that the written numbers say.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

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
        Geometry::Triangle { vertices, .. } => is_needle(vertices),
        Geometry::Cone { height, .. } => *height == 0.0,
        Geometry::Quadric(q) => matches!(judge(q), Verdict::Flat(_)),
        Geometry::Revolution { profile, .. } => is_flat(profile),
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
        Geometry::Triangle { .. } => new("triangle", 0, 9),
        Geometry::Cone { .. } => new("cone", 0, 1),
        Geometry::Quadric(q) => match judge(q) {
            Verdict::Flat(0) => new("point", 0, 16),
            Verdict::Flat(1) => new("line", 0, 16),
            _ => new("plane", 0, 16),
        },
        Geometry::Revolution { profile, .. } => match profile.iter().all(|q| q[0] == 0.0) {
            true => new("axis", 1, 2 * p.count),
            false => new("profile", 1, 2 * p.count),
        },
        _ => new("", 0, p.len()),
    }
}

/// a·d − b·c, or exactly zero where that is all that its rounding allows to be said.
fn determinant(a: f64, b: f64, c: f64, d: f64, rounding: f64) -> f64 {
    let x = a * d - b * c;
    if x.abs() <= rounding { 0.0 } else { x }
}

/// Whether the corners of a triangle lie on one line.
fn is_needle(v: &[[f64; 3]; 3]) -> bool {
    // Scaled by the longest coordinate difference's power of two, lest squares overflow.
    let largest = v.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest == 0.0 {
        return true;
    }
    let v = v.map(|p| p.map(|x| x / largest));
    let (a, b): ([f64; 3], [f64; 3]) = (
        std::array::from_fn(|i| v[1][i] - v[0][i]),
        std::array::from_fn(|i| v[2][i] - v[0][i]),
    );
    let size: [f64; 3] = std::array::from_fn(|i| v.iter().fold(0.0f64, |m, p| m.max(p[i].abs())));
    (0..3).all(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let terms = size[j] * (a[k].abs() + b[k].abs()) + size[k] * (a[j].abs() + b[j].abs());
        determinant(a[j], a[k], b[j], b[k], ROUNDING * terms) == 0.0
    })
}

/// Whether all points of a profile, closed as the language closes it, lie on one line.
fn is_flat(profile: &[[f64; 2]]) -> bool {
    let (Some(&first), Some(&last)) = (profile.first(), profile.last()) else {
        return true;
    };
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let closing: &[[f64; 2]] = if first == last { &[] } else { &ends };
    let points = || profile.iter().chain(closing);
    let largest = points().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest == 0.0 {
        return true;
    }
    let scaled = || points().map(|p| p.map(|x| x / largest));
    // The direction to the point furthest from the first one is the best known.
    let from = first.map(|x| x / largest);
    let away = |p: [f64; 2]| [p[0] - from[0], p[1] - from[1]];
    let length = |d: [f64; 2]| d[0].hypot(d[1]);
    let far = scaled()
        .map(away)
        .max_by(|a, b| length(*a).total_cmp(&length(*b)))
        .unwrap_or([0.0; 2]);
    scaled().all(|p| {
        let d = away(p);
        let size = [0, 1].map(|i| p[i].abs().max(from[i].abs()));
        let terms = size[0] * (d[1].abs() + far[1].abs()) + size[1] * (d[0].abs() + far[0].abs());
        determinant(far[0], far[1], d[0], d[1], ROUNDING * terms) == 0.0
    })
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{found, messages};

    #[track_caller]
    fn pair(bad: &str, at: &str, good: &str) {
        assert_eq!(found(bad), [at], "{bad}");
        assert!(found(good).is_empty(), "{good}: {:?}", found(good));
    }

    #[test]
    fn flat_boxes_and_rectangles() {
        pair("2 12 0 0 0 1 0 1", "W305 1:8", "2 12 0 0 0 1 0.001 1");
        pair("2 5 1 1 1 3", "W305 1:5", "2 5 1 1 1.5 3");
        assert_eq!(
            messages("2 12 0 0 5 0 1 5"),
            ["the box 2 has no volume: xmin = xmax, zmin = zmax"]
        );
    }

    #[test]
    fn triangles_on_a_line() {
        // In doubles 0.1, 0.2 and 0.3 are not in proportion.
        pair(
            "2 6 0.1 0.1 0.2  0.2 0.2 0.4  0.3 0.3 0.6",
            "W305 1:5",
            "2 6 0.1 0.1 0.2  0.2 0.2 0.4  0.3 0.3 0.6000001",
        );
        pair(
            "2 6 1 2 3  1 2 3  4 5 7",
            "W305 1:5",
            "2 6 1 2 3  1 2 3.0001  4 5 7",
        );
        pair(
            "2 6 0 0 0 0 0 0 0 0 0",
            "W305 1:5",
            "2 6 0 0 0 1e-300 0 0 0 1e-300 0",
        );
    }

    #[test]
    fn cones_and_profiles() {
        pair("2 16 0 1", "W305 1:6", "2 16 -0.1 1");
        pair("2 1 2 0 0 0 5", "W305 1:7", "2 1 2 0 0 0.1 5");
        // A disc; a ring that goes there and back; a cylinder's profile is a straight line too.
        pair("2 1 2 0 1 3 1", "W305 1:7", "2 1 2 0 1 3 1.5");
        pair("2 1 3 1 0 2 1 1 0", "W305 1:7", "2 1 3 1 0 2 1 1 1");
        pair("2 1 2 1 0 1 0", "W305 1:7", "2 1 2 1 0 1 2");
    }

    #[test]
    fn quadrics_of_points_lines_and_planes() {
        let q = |d: [i32; 4]| {
            let [a, b, c, d] = d;
            format!("2 15 {a} 0 0 0 0 {b} 0 0 0 0 {c} 0 0 0 0 {d}")
        };
        pair(&q([1, 1, 1, 0]), "W305 1:6", &q([1, 1, -1, 0]));
        assert!(messages(&q([1, 0, 1, 0]))[0].ends_with("only the points of a line satisfy it"));
        assert!(messages(&q([0, 1, 0, 0]))[0].ends_with("only the points of a plane satisfy it"));
    }
}
