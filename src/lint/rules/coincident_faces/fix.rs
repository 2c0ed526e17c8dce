//! A tool that reaches a hair further.

use crate::diagnostics::{Applicability, Edit, Fix};
use crate::geometry::array::length;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;
use crate::scene::record::Params;
use crate::solids::contacts::face::Part;
use crate::solids::contacts::search::Side;
use crate::solids::containment::in_profile;

/// How much longer a tool becomes: too little to be seen, and a million times what counts as flush.
const HAIR: f64 = 1e-3;

/// Moves the given faces of a tool outwards. `workpiece` is the size of what it cuts.
pub fn lengthen(p: &Params, geometry: &Geometry, tool: &[Side], workpiece: f64) -> Option<Fix> {
    // What each parameter becomes, and how far it is moved.
    let mut moved: Vec<(usize, f64, f64)> = Vec::new();
    for side in tool {
        match (geometry, side.part) {
            (Geometry::Box { min, max }, Part::Side { axis, upper }) => {
                let hair = HAIR * (max[axis] - min[axis]);
                moved.push(match upper {
                    true => (axis + 3, max[axis] + hair, hair),
                    false => (axis, min[axis] - hair, hair),
                });
            }
            (Geometry::HalfSpace([a, b, c, d]), Part::All) => {
                let hair = HAIR * workpiece / side.stretch * length([*a, *b, *c]);
                moved.push((3, d - hair, hair));
            }
            // Both numbers together keep the mantle where it is.
            (
                Geometry::Cone { height, radius } | Geometry::DoubleCone { height, radius },
                Part::Base { .. },
            ) => {
                for (i, x) in [*height, *radius].into_iter().enumerate() {
                    moved.push((i, x + HAIR * x, (HAIR * x).abs()));
                }
            }
            (Geometry::Revolution { profile, .. }, part) => {
                for (i, x, hair) in level_points(profile, part)? {
                    moved.push((2 + 2 * i, x, hair));
                }
            }
            _ => return None,
        }
    }
    moved.sort_by_key(|m| m.0);
    moved.dedup_by_key(|m| m.0);
    let edits: Option<Vec<Edit>> = moved
        .into_iter()
        .map(|(i, x, hair)| {
            Some(Edit {
                span: p.span_of(i, 1),
                text: short(x, hair)?,
            })
        })
        .collect();
    let edits = edits.filter(|e| !e.is_empty())?;
    Some(Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Unsafe,
        edits,
    })
}

/// The points of a level piece of a profile or a disc that closes it: index, new height, and by how
/// much it has changed.
fn level_points(profile: &[[f64; 2]], part: Part) -> Option<Vec<(usize, f64, f64)>> {
    let last = profile.len() - 1;
    let (from, to, radii) = match part {
        Part::Cap(i) => (i, i, (0.0, profile[i][0])),
        Part::Piece(i) => (i, i + 1, (profile[i][0], profile[i + 1][0])),
        _ => return None,
    };
    let y = profile[from][1];
    if profile[to][1] != y {
        return None;
    }
    // Neighbours at the same height lie in the same plane.
    let level = |i: &usize| profile[*i][1] == y;
    let start = (0..=from).rev().take_while(level).last()?;
    let end = (to..=last).take_while(level).last()?;
    let mut points: Vec<usize> = (start..=end).collect();
    if profile[0] == profile[last] && (start == 0 || end == last) {
        points.extend([0, last]);
    }
    let heights = || profile.iter().map(|p| p[1]);
    let all = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let hair = HAIR * all;
    let middle = radii.0 / 2.0 + radii.1 / 2.0;
    let up = in_profile(profile, middle, y - hair);
    // Not where something else of the profile is that near.
    if up == in_profile(profile, middle, y + hair) {
        return None;
    }
    let to = if up { y + hair } else { y - hair };
    points.sort_unstable();
    points.dedup();
    Some(points.into_iter().map(|i| (i, to, hair)).collect())
}

/// A number with no more digits than it takes to tell by how much it was moved.
fn short(x: f64, hair: f64) -> Option<String> {
    let decimals = (2.0 - hair.log10().floor()).clamp(0.0, 300.0) as usize;
    format!("{x:.decimals$}").parse().ok().map(spelled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_short() {
        assert_eq!(short(0.3 + 0.1 + 0.2 + 0.001, 0.001).unwrap(), "0.601");
        assert_eq!(short(-1.0015, 0.0015).unwrap(), "-1.0015");
        assert_eq!(short(2.002e-7, 2e-10).unwrap(), "2.002e-7");
        assert_eq!(short(123_456_789.4, 123.0).unwrap(), "123456789");
    }

    #[test]
    fn the_end_of_a_profile_moves_as_a_whole() {
        // A tube's upper end is a ring; a ring's first point is its last.
        let ring = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let up = level_points(&ring, Part::Piece(2)).unwrap();
        assert_eq!(up, [(2, 1.001, 0.001), (3, 1.001, 0.001)]);
        let down = level_points(&ring, Part::Piece(0)).unwrap();
        assert_eq!(down.iter().map(|p| p.0).collect::<Vec<_>>(), [0, 1, 4]);
        assert!(down.iter().all(|p| p.1 == -0.001));
        assert!(level_points(&ring, Part::Piece(1)).is_none());
    }
}
