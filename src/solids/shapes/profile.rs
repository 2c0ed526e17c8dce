//! Profiles of surfaces of revolution, (x, y) with x the distance from the axis.

use crate::geometry::sign::{Exact, Rounded, Scalar, at_most_zero};
use crate::scene::Vec3;

/// Whether the solid of a profile is convex: the profile, closed by discs where it does not end at the axis, goes one
/// way along the axis and turns to one side only.
pub fn is_convex(profile: &[[f64; 2]]) -> bool {
    let (first, last) = (profile[0], profile[profile.len() - 1]);
    if first[1] == last[1] {
        return false;
    }
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let points: Vec<[f64; 2]> = [&ends[..1], profile, &ends[1..]].concat();
    let up = last[1] > first[1];
    let along = points
        .windows(2)
        .all(|w| w[0][1] == w[1][1] || (w[1][1] > w[0][1]) == up);
    let turns = points.windows(3).all(|w| {
        let side = |i: usize| [w[i + 1][0] - w[i][0], w[i + 1][1] - w[i][1]];
        let ([a, b], [c, d]) = (side(0), side(1));
        if up {
            a * d - b * c >= 0.0
        } else {
            a * d - b * c <= 0.0
        }
    });
    along && turns
}

/// A number that is negative where a point is nearer to the axis than a piece of the profile, and zero where it is on
/// the piece. The height of the point is between those of the piece's ends, which differ.
fn before<N: Scalar>([low, high]: [[f64; 2]; 2], p: Vec3) -> N {
    let [a, b, c, d, y] = [low[0], low[1], high[0], high[1], p[1]].map(N::of);
    let across = N::of(p[0]).square() + N::of(p[2]).square();
    let rise = d - b.clone();
    let reach = a.clone() * rise.clone() + (y - b) * (c - a);
    across * rise.square() - reach.square()
}

/// Whether a point is in the solid of a profile or on its boundary, by the even-odd rule for the closed
/// profile: along the half-plane of the point straight outwards from it. A piece from (a, b) to (c, d) with
/// b ≤ y < d is met at the radius a + (y − b)(c − a) / (d − b).
pub fn holds(profile: &[[f64; 2]], p: Vec3) -> bool {
    let (Some(&first), Some(&last)) = (profile.first(), profile.last()) else {
        return false;
    };
    let mut inside = false;
    let mut met = false;
    for w in profile.windows(2) {
        let [low, high] = match w[0][1] <= w[1][1] {
            true => [w[0], w[1]],
            false => [w[1], w[0]],
        };
        // The axis is no surface.
        if !(low[1]..=high[1]).contains(&p[1]) || (low[0] == 0.0 && high[0] == 0.0) {
            continue;
        }
        if low[1] == high[1] {
            met = true;
            continue;
        }
        let further = at_most_zero(before([low, high], p), || before([low, high], p));
        met |= further && is_on([low, high], p);
        inside ^= further && p[1] < high[1];
    }
    inside || (met || p[1] == first[1] || p[1] == last[1]) && is_on_surface(profile, p)
}

/// Whether a point is on a piece of the profile, if it is not further out than the piece.
fn is_on(piece: [[f64; 2]; 2], p: Vec3) -> bool {
    at_most_zero(-before::<Rounded>(piece, p), || -before::<Exact>(piece, p))
}

/// Whether a point lies on the surface. Where an even number of pieces coincide there is no surface, nor is there one
/// on the axis. So the pieces that leave the point in each direction are counted.
fn is_on_surface(profile: &[[f64; 2]], p: Vec3) -> bool {
    let (Some(&first), Some(&last)) = (profile.first(), profile.last()) else {
        return false;
    };
    let discs = [[[0.0, first[1]], first], [last, [0.0, last[1]]]];
    let discs = discs.iter().filter(|_| first != last);
    let pieces = profile.windows(2).map(|w| [w[0], w[1]]);
    let square = Exact::of(p[0]).square() + Exact::of(p[2]).square();
    // Compares the distance `x` from the axis with that of the point.
    let side = |x: f64| Exact::of(x).square().cmp(&square);
    // The directions of the pieces that leave the point upwards, and downwards. Two equal ones cancel each other out.
    let mut leaving: [Vec<[Exact; 2]>; 2] = [Vec::new(), Vec::new()];
    let mut level = [false; 2];
    for w in pieces.chain(discs.copied()) {
        let [low, high] = match w[0][1] <= w[1][1] {
            true => [w[0], w[1]],
            false => [w[1], w[0]],
        };
        if !(low[1]..=high[1]).contains(&p[1]) || (low[0] == 0.0 && high[0] == 0.0) {
            continue;
        }
        if low[1] == high[1] {
            let ends = [low, high].map(|q| side(q[0]));
            level[0] ^= ends.iter().any(|e| e.is_gt()) && ends.iter().any(|e| e.is_le());
            level[1] ^= ends.iter().any(|e| e.is_lt()) && ends.iter().any(|e| e.is_ge());
            continue;
        }
        let further = at_most_zero(before([low, high], p), || before([low, high], p));
        if !further || !is_on([low, high], p) {
            continue;
        }
        let way = [0, 1].map(|k| Exact::of(high[k]) - Exact::of(low[k]));
        for (is_there, leaving) in [p[1] < high[1], low[1] < p[1]]
            .into_iter()
            .zip(&mut leaving)
        {
            if is_there {
                let same = |other: &[Exact; 2]| {
                    other[0].clone() * way[1].clone() == way[0].clone() * other[1].clone()
                };
                match leaving.iter().position(same) {
                    Some(twin) => drop(leaving.swap_remove(twin)),
                    None => leaving.push(way.clone()),
                }
            }
        }
    }
    level.contains(&true) || leaving.iter().any(|l| !l.is_empty())
}

/// The points before and behind point `i` of a profile that is closed, over the axis or in itself.
pub fn neighbours(profile: &[[f64; 2]], i: usize) -> [[f64; 2]; 2] {
    let last = profile.len() - 1;
    let ring = profile[0] == profile[last];
    let [x, y] = profile[i];
    // On the axis the other side is the mirror image.
    let closed = |other: usize| match x {
        0.0 => [-profile[other][0], profile[other][1]],
        _ => [0.0, y],
    };
    let before = match i {
        0 if ring => profile[last.saturating_sub(1)],
        0 => closed(1.min(last)),
        i => profile[i - 1],
    };
    let behind = match i {
        i if i == last && ring => profile[1.min(last)],
        i if i == last => closed(last.saturating_sub(1)),
        i => profile[i + 1],
    };
    [before, behind]
}

/// The distance of a point from a profile, closed as the language closes it, and the components of the unit vector from
/// the nearest point of the profile to the point.
pub fn nearest(profile: &[[f64; 2]], x: f64, y: f64) -> (f64, f64, f64) {
    let (first, last) = (profile[0], profile[profile.len() - 1]);
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let pieces = profile.windows(2).map(|w| (w[0], w[1]));
    let closing = (first != last).then_some([(ends[0], first), (last, ends[1])]);
    let mut best = (f64::INFINITY, 1.0, 0.0);
    for (a, b) in pieces.chain(closing.into_iter().flatten()) {
        let (u, v) = (b[0] - a[0], b[1] - a[1]);
        let square = u * u + v * v;
        // A piece on the axis is no surface.
        if square == 0.0 || a[0] == 0.0 && b[0] == 0.0 {
            continue;
        }
        let t = (((x - a[0]) * u + (y - a[1]) * v) / square).clamp(0.0, 1.0);
        let (dx, dy) = (x - a[0] - t * u, y - a[1] - t * v);
        let away = dx.hypot(dy);
        if away < best.0 {
            best = match away > 0.0 {
                true => (away, dx / away, dy / away),
                false => (0.0, 1.0, 0.0),
            };
        }
    }
    best
}

/// Twice the area of a polygon, negative if the polygon goes around clockwise.
pub fn twice_area(polygon: &[[f64; 2]]) -> f64 {
    let n = polygon.len();
    let sides = (0..n).map(|i| [polygon[i], polygon[(i + 1) % n]]);
    sides.map(|[p, q]| p[0] * q[1] - q[0] * p[1]).sum()
}

/// A profile closed over the axis as a polygon, without equal points in a row.
pub fn closed(profile: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut closed: Vec<[f64; 2]> = Vec::with_capacity(profile.len() + 2);
    let (Some(&first), Some(&last)) = (profile.first(), profile.last()) else {
        return closed;
    };
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let points = match first == last {
        true => profile[1..].to_vec(),
        false => [&ends[..1], profile, &ends[1..]].concat(),
    };
    for p in points {
        if closed.last() != Some(&p) {
            closed.push(p);
        }
    }
    closed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profiles() {
        let convex = |p: &[[f64; 2]]| {
            let turned: Vec<[f64; 2]> = p.iter().rev().copied().collect();
            assert_eq!(is_convex(p), is_convex(&turned), "{p:?}");
            is_convex(p)
        };
        assert!(convex(&[[1.0, 0.0], [1.0, 2.0]]));
        assert!(convex(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]]));
        assert!(convex(&[[0.5, 0.0], [1.0, 1.0], [0.0, 2.0]]));
        // A waist, an edge that hangs down, a ring, a hollow from above.
        assert!(!convex(&[[1.0, 0.0], [0.5, 1.0], [1.0, 2.0]]));
        assert!(!convex(&[[1.0, 0.0], [2.0, -1.0], [1.0, 2.0]]));
        assert!(!convex(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.0]]));
        assert!(!convex(&[[1.0, 0.0], [1.0, 2.0], [0.0, 1.0]]));
        // Level all along: no inside.
        assert!(!convex(&[[1.0, 0.0], [0.0, 0.0], [2.0, 0.0]]));
    }

    #[test]
    fn profiles_by_even_odd() {
        // A cylinder of radius 1, a ring, a cone's profile.
        let cylinder = [[1.0, 0.0], [1.0, 2.0]];
        assert!(holds(&cylinder, [0.9, 1.0, 0.0]) && !holds(&cylinder, [1.1, 1.0, 0.0]));
        assert!(!holds(&cylinder, [0.5, 2.1, 0.0]) && !holds(&cylinder, [0.5, -0.1, 0.0]));
        let ring = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        assert!(holds(&ring, [1.5, 0.5, 0.0]) && !holds(&ring, [0.5, 0.5, 0.0]));
        let cone = [[0.0, 1.0], [1.0, 0.0]];
        assert!(holds(&cone, [0.4, 0.5, 0.0]) && !holds(&cone, [0.6, 0.5, 0.0]));
    }

    /// Points on every face are inside, and on none that is gone over twice.
    #[test]
    fn boundaries_belong_to_the_solid() {
        let ring = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        for on in [
            [1.0, 0.5],
            [2.0, 0.5],
            [1.5, 0.0],
            [1.5, 1.0],
            [1.0, 0.0],
            [2.0, 1.0],
        ] {
            assert!(holds(&ring, [on[0], on[1], 0.0]), "{on:?}");
        }
        assert!(!holds(&ring, [0.5, 0.0, 0.0]) && !holds(&ring, [2.5, 1.0, 0.0]));
        // A cylinder with a fin of no thickness, and its closing discs.
        let finned = [[1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0]];
        assert!(holds(&finned, [1.0, 1.0, 0.0]) && holds(&finned, [0.0, 2.0, 0.5]));
        assert!(!holds(&finned, [1.5, 1.0, 0.0]) && !holds(&finned, [2.0, 1.0, 0.0]));
        // The axis is no surface, whether it is written or not.
        let along = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        for y in [0.0, 0.5, 1.0] {
            assert!(holds(&along, [0.0, y, 0.0]) && holds(&along[2..], [0.0, y, 0.0]));
        }
        assert!(!holds(&along, [0.0, 1.5, 0.0]));
        // A wall in two pieces, and one that goes back down in itself.
        let straight = [[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]];
        assert!(holds(&straight, [1.0, 1.0, 0.0]));
        let folded = [[1.0, 0.0], [1.0, 1.0], [2.0, 3.0], [1.0, 1.0], [0.0, 1.0]];
        assert!(!holds(&folded, [1.5, 2.0, 0.0]) && holds(&folded, [1.0, 1.0, 0.0]));
    }
}
