//! Solids from a profile: turned about the y axis, or drawn out along z.

use super::super::budget::{Budget, TooMany};
use super::super::triangle_mesh::Mesh;
use std::f64::consts::{PI, TAU};

/// A profile of points (radius, height); the solid lies to its left. It leads from the axis to the axis. A ring leads
/// back to its first point, which is not repeated.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Profile {
    pub points: Vec<[f64; 2]>,
    pub ring: bool,
}

/// The fewest sides of a polygon that stands for a circle: with fewer it would have no room inside.
const FEWEST_SIDES: f64 = 6.0;
/// The most sides: more than the budget of triangles allows, and still a whole number.
const MOST_SIDES: f64 = 1e9;

/// The number of sides with which a polygon keeps within the tolerance of its circle.
pub(super) fn sides(radius: f64, tolerance: f64) -> f64 {
    if radius <= 0.0 {
        return FEWEST_SIDES;
    }
    let sunk = (tolerance / radius).min(0.5);
    // For smaller numbers cos x ≈ 1 − x²/2 holds to all digits, whereas 1 − sunk would lose most digits of sunk.
    let angle = if sunk < 1e-8 {
        (2.0 * sunk).sqrt()
    } else {
        (1.0 - sunk).acos()
    };
    (PI / angle).ceil().clamp(FEWEST_SIDES, MOST_SIDES)
}

/// Turns profiles about the y axis, all with the same number of sides.
pub(super) fn turned(profiles: &[Profile], n: f64, budget: &mut Budget) -> Result<Mesh, TooMany> {
    let segments: usize = profiles.iter().map(|p| p.points.len()).sum();
    budget.spend(2.0 * n * segments as f64)?;
    let n = n as usize;
    let circle: Vec<[f64; 2]> = (0..n)
        .map(|k| TAU * k as f64 / n as f64)
        .map(|a| [a.sin(), a.cos()])
        .collect();
    let mut mesh = Mesh::default();
    for profile in profiles {
        let mut rings: Vec<Vec<u32>> = Vec::with_capacity(profile.points.len());
        for &[radius, y] in &profile.points {
            rings.push(if radius == 0.0 {
                vec![mesh.point([0.0, y, 0.0])]
            } else {
                let on = |[s, c]: &[f64; 2]| mesh.point([radius * s, y, radius * c]);
                circle.iter().map(on).collect()
            });
        }
        let steps = rings.len() - usize::from(!profile.ring);
        for i in 0..steps {
            let (low, high) = (&rings[i], &rings[(i + 1) % rings.len()]);
            for k in 0..n {
                let next = (k + 1) % n;
                match (low.len(), high.len()) {
                    (1, 1) => {}
                    (1, _) => mesh.triangle([low[0], high[next], high[k]]),
                    (_, 1) => mesh.triangle([low[k], low[next], high[0]]),
                    _ => mesh.quad([low[k], low[next], high[next], high[k]]),
                }
            }
        }
    }
    Ok(mesh)
}

/// The solid between x = −radius and x = radius at each height of the profile, extruded from z = −1 to z = 1. The
/// profile rises.
pub(super) fn drawn_out(profile: &[[f64; 2]], budget: &mut Budget) -> Result<Mesh, TooMany> {
    budget.spend(8.0 * profile.len() as f64)?;
    let mut mesh = Mesh::default();
    // Left back, right back, right front, left front.
    let mut corners: Vec<[u32; 4]> = Vec::with_capacity(profile.len());
    for &[x, y] in profile {
        corners.push(if x == 0.0 {
            let [back, front] = [-1.0, 1.0].map(|z| mesh.point([0.0, y, z]));
            [back, back, front, front]
        } else {
            [[-x, -1.0], [x, -1.0], [x, 1.0], [-x, 1.0]].map(|[x, z]| mesh.point([x, y, z]))
        });
    }
    for pair in corners.windows(2) {
        let (low, high) = (pair[0], pair[1]);
        for i in 0..4 {
            // As seen from outside, the next corner is to the left.
            let j = (i + 1) % 4;
            mesh.quad([low[j], low[i], high[i], high[j]]);
        }
    }
    if let (Some(&[a, b, c, d]), Some(&top)) = (corners.first(), corners.last()) {
        mesh.quad([a, b, c, d]);
        mesh.quad([top[3], top[2], top[1], top[0]]);
    }
    Ok(mesh)
}

/// Points on a curve, ends included, whose chords are nowhere farther from it than the tolerance.
pub(super) fn flattened(
    curve: impl Fn(f64) -> [f64; 2],
    [from, to]: [f64; 2],
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Vec<[f64; 2]>, TooMany> {
    /// The least share of the curve's parameter for a chord: a shorter one is taken as it is. The number of chords is
    /// within the budget of triangles.
    const FINEST: f64 = 1.0 / (1u32 << 24) as f64;
    let first = curve(from);
    let mut out = vec![first];
    let start = (from, first);
    let mut at = start;
    // Ends still to be reached, the next one on top.
    let mut ends: Vec<f64> = (0..8)
        .map(|i| to + (from - to) * f64::from(i) / 8.0)
        .collect();
    while let Some(&end) = ends.last() {
        let there = curve(end);
        let between = |s: f64| curve(at.0 + (end - at.0) * s);
        let fits = [0.25, 0.5, 0.75]
            .into_iter()
            .all(|s| off(at.1, there, between(s)) <= tolerance);
        if fits || (end - at.0).abs() <= FINEST * (to - from).abs() {
            budget.spend(1.0)?;
            out.push(there);
            at = (end, there);
            ends.pop();
        } else {
            ends.push(at.0 + (end - at.0) / 2.0);
        }
    }
    Ok(out)
}

/// The distance of `p` from the line through `a` and `b`.
fn off(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let (px, py) = (p[0] - a[0], p[1] - a[1]);
    let length = dx.hypot(dy);
    if length == 0.0 {
        return px.hypot(py);
    }
    (dx * py - dy * px).abs() / length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_triangle_is_a_cone() {
        let profile = Profile {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 3.0]],
            ring: false,
        };
        let n = sides(1.0, 1e-4);
        let mesh = turned(&[profile], n, &mut Budget::default()).unwrap();
        assert!(mesh.is_closed());
        assert!((mesh.volume() - PI).abs() < 1e-3 * PI);
    }

    #[test]
    fn a_prism_is_closed_and_outside_out() {
        let mesh = drawn_out(
            &[[0.0, 0.0], [1.0, 1.0], [2.0, 4.0]],
            &mut Budget::default(),
        )
        .unwrap();
        assert!(mesh.is_closed());
        // The triangle and the trapezoid, twice as long as they are wide.
        assert!((mesh.volume() - 2.0 * (1.0 + 9.0)).abs() < 1e-12);
    }

    #[test]
    fn chords_stay_near() {
        let curve = |t: f64| [t, t * t];
        let points = flattened(curve, [0.0, 3.0], 1e-3, &mut Budget::default()).unwrap();
        for w in points.windows(2) {
            let (h, slope) = (w[1][0] - w[0][0], w[0][0] + w[1][0]);
            // A chord is h²/4 above the parabola, measured upright.
            assert!(h * h / 4.0 / (1.0 + slope * slope).sqrt() <= 1.05e-3);
        }
        assert_eq!(points.last(), Some(&[3.0, 9.0]));
    }
}
