//! The fix that makes a tool reach a hair beyond the face that it shares.

use crate::diagnostics::{Edit, Fix};
use crate::geometry::array::length;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;
use crate::scene::record::Params;
use crate::solids::contacts::face::FaceId;
use crate::solids::contacts::search::ContactSide;
use crate::solids::shapes::{AnyShape, profile};

/// Share of its own length, or of the workpiece, by which a tool becomes longer: too little to be seen, and a million
/// times what counts as flush.
const TOOL_REL_EXTENSION: f64 = 1e-3;

/// The fix that moves the given faces of a tool outwards. `workpiece` is the size of the solid that the tool cuts.
/// `None` if no parameter moves one of the faces.
pub(super) fn lengthen(
    p: &Params,
    geometry: &Geometry,
    tool: &[ContactSide],
    workpiece: f64,
) -> Option<Fix> {
    // The new value of each parameter, and the distance by which it moves.
    let mut moved: Vec<Moved> = Vec::new();
    for side in tool {
        let room = TOOL_REL_EXTENSION * workpiece / side.stretch;
        moved.extend(geometry.moved_out(side.part, TOOL_REL_EXTENSION, room)?);
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
    Some(Fix::guess("fix", edits))
}

/// Writes the moved number `x` with just enough digits to show `hair`, the distance of the move.
fn short(x: f64, hair: f64) -> Option<String> {
    let decimals = (2.0 - hair.log10().floor()).clamp(0.0, 300.0) as usize;
    format!("{x:.decimals$}").parse().ok().map(spelled)
}

/// The index of a parameter, its new value, and the amount of the change.
pub(super) type Moved = (usize, f64, f64);

impl Geometry {
    /// The changes of parameters that move a face outwards: by `share` of the shape's own length, or by `room` for a
    /// half-space, which has no length. `None` if no parameter moves the face.
    fn moved_out(&self, part: FaceId, share: f64, room: f64) -> Option<Vec<Moved>> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                if !matches!(part, FaceId::Base { .. }) {
                    return None;
                }
                // Height and radius grow together, so the mantle stays where it is.
                let numbers = [s.height, s.radius].into_iter().enumerate();
                let moved = numbers.map(|(i, x)| (i, x + share * x, (share * x).abs()));
                Some(moved.collect())
            }
            AnyShape::Cuboid(s) => {
                let FaceId::Side { axis, upper } = part else {
                    return None;
                };
                let hair = share * (s.max[axis] - s.min[axis]);
                let moved = match upper {
                    true => (axis + 3, s.max[axis] + hair, hair),
                    false => (axis, s.min[axis] - hair, hair),
                };
                Some(vec![moved])
            }
            AnyShape::HalfSpace(s) => {
                let hair = room * length(s.normal());
                let moves = s.solid && part == FaceId::All;
                moves.then(|| vec![(3, s.abcd[3] - hair, hair)])
            }
            AnyShape::Revolution(s) => {
                let points = level_points(s.profile, part, share)?;
                let moved = points.into_iter().map(|(i, y, hair)| (2 + 2 * i, y, hair));
                Some(moved.collect())
            }
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => None,
        }
    }
}

/// Moves a level piece of a profile, or a disc that closes it, outwards. Returns for each point its index, its new
/// height, and the amount of the change. `None` if the piece is not level, or has no clear outside.
fn level_points(points: &[[f64; 2]], part: FaceId, share: f64) -> Option<Vec<(usize, f64, f64)>> {
    let last = points.len() - 1;
    let (from, to, radii) = match part {
        FaceId::Cap(i) => (i, i, (0.0, points[i][0])),
        FaceId::Piece(i) => (i, i + 1, (points[i][0], points[i + 1][0])),
        _ => return None,
    };
    let y = points[from][1];
    if points[to][1] != y {
        return None;
    }
    // Neighbours at the same height lie in the same plane.
    let level = |i: &usize| points[*i][1] == y;
    let start = (0..=from).rev().take_while(level).last()?;
    let end = (to..=last).take_while(level).last()?;
    let mut moved: Vec<usize> = (start..=end).collect();
    if points[0] == points[last] && (start == 0 || end == last) {
        moved.extend([0, last]);
    }
    let heights = || points.iter().map(|p| p[1]);
    let all = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let hair = share * all;
    let middle = radii.0 / 2.0 + radii.1 / 2.0;
    let up = profile::holds(points, [middle, y - hair, 0.0]);
    // Another piece of the profile is so near that both sides are inside, or both outside.
    if up == profile::holds(points, [middle, y + hair, 0.0]) {
        return None;
    }
    let to = if up { y + hair } else { y - hair };
    moved.sort_unstable();
    moved.dedup();
    Some(moved.into_iter().map(|i| (i, to, hair)).collect())
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
        let up = level_points(&ring, FaceId::Piece(2), 1e-3).unwrap();
        assert_eq!(up, [(2, 1.001, 0.001), (3, 1.001, 0.001)]);
        let down = level_points(&ring, FaceId::Piece(0), 1e-3).unwrap();
        assert_eq!(down.iter().map(|p| p.0).collect::<Vec<_>>(), [0, 1, 4]);
        assert!(down.iter().all(|p| p.1 == -0.001));
        assert!(level_points(&ring, FaceId::Piece(1), 1e-3).is_none());
    }
}
