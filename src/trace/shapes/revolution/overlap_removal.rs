//! The profile without the stretches where it goes back over itself.
//!
//! By the even-odd rule two segments that lie in each other are a layer without thickness, which is no surface. In no
//! precision can a line in that layer be told from a line that passes between the two segments, so the layer is
//! removed before any line comes. Only exact overlaps are looked for: a layer one ulp thick is a layer.

use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::number::Real;
use crate::trace::shapes::outline::ProfilePoint;
use std::collections::BTreeSet;

/// A part of a segment, from one point of the profile to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Subsegment {
    pub from: u32,
    pub to: u32,
    /// The number of the segment, which begins at the point of that number and ends at the next.
    pub segment: u32,
}

/// Largest difference between the computed directions and distances of segments in one line. The coordinates are below
/// 2, a direction's two parts have one rounding each, its angle two more from the arctangent, and the distance from the
/// origin, below 3, five. Segments that differ by less are compared exactly.
const LINE_ABS_EPS: f64 = 64.0 * f64::EPSILON;

/// The segments between neighbouring points, without the stretches that lie in each other, which are removed in pairs.
/// The pieces are in the order of the profile; all coordinates must be below 2.
pub(super) fn pieces(points: &[[f64; 2]]) -> Vec<Subsegment> {
    let mut all = Vec::new();
    for line in lines(points) {
        if overlaps(points, &line) {
            thin_out(points, &line, &mut all);
        } else {
            all.extend(line.iter().map(|&i| Subsegment {
                from: i,
                to: i + 1,
                segment: i,
            }));
        }
    }
    let place = |piece: &Subsegment| {
        let forwards = along(points, piece.segment, piece.segment + 1) > 0.0;
        let at = height(points, piece.segment, piece.from);
        if forwards { at } else { -at }
    };
    all.sort_by(|a, b| {
        let within = place(a).total_cmp(&place(b));
        a.segment.cmp(&b.segment).then(within)
    });
    all
}

/// The coordinate of `point` that changes along a segment: its height, or its radius for a flat segment. The point
/// lies in the segment's line.
fn height(points: &[[f64; 2]], segment: u32, point: u32) -> f64 {
    let axis = usize::from(points[segment as usize][1] != points[segment as usize + 1][1]);
    points[point as usize][axis]
}

/// The change of the coordinate of [`height`] from one point to another, along the segment that begins at `from`.
fn along(points: &[[f64; 2]], from: u32, to: u32) -> f64 {
    height(points, from, to) - height(points, from, from)
}

/// The lower and the upper end of a segment, and their coordinates along it.
fn ends(points: &[[f64; 2]], segment: u32) -> [(f64, u32); 2] {
    let mut ends = each([segment, segment + 1], |point| {
        (height(points, segment, point), point)
    });
    if ends[0].0 > ends[1].0 {
        ends.swap(0, 1);
    }
    ends
}

/// The segments that have a length, grouped by the straight line that they lie in. Each group is ordered from below.
fn lines(points: &[[f64; 2]]) -> Vec<Vec<u32>> {
    // For each segment its angle in [0, π), the distance of the origin from its line, and its number.
    let mut all: Vec<(f64, f64, u32)> = Vec::new();
    for (i, pair) in points.windows(2).enumerate() {
        let (p, q) = (pair[0], pair[1]);
        let (w, h) = (q[0] - p[0], q[1] - p[1]);
        if w == 0.0 && h == 0.0 {
            continue;
        }
        let (w, h) = if h < 0.0 || (h == 0.0 && w < 0.0) {
            (-w, -h)
        } else {
            (w, h)
        };
        let long = libm::hypot(w, h);
        all.push((
            libm::atan2(h, w),
            p[0] * (h / long) - p[1] * (w / long),
            i as u32,
        ));
    }
    let mut found = Vec::new();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    for parallel in all.chunk_by_mut(|a, b| b.0 - a.0 <= LINE_ABS_EPS) {
        parallel.sort_by(|a, b| a.1.total_cmp(&b.1));
        for near in parallel.chunk_by(|a, b| b.1 - a.1 <= LINE_ABS_EPS) {
            if let [(.., alone)] = near {
                found.push(vec![*alone]);
                continue;
            }
            let mut rest: Vec<u32> = near.iter().map(|&(_, _, i)| i).collect();
            while let Some(&first) = rest.first() {
                let same = |&i: &u32| {
                    let ends = each([first, first + 1], |k| points[k as usize]);
                    (i..=i + 1).all(|k| is_straight(ends[0], ends[1], points[k as usize]))
                };
                let (mut line, others): (Vec<u32>, Vec<u32>) = rest.iter().partition(|i| same(i));
                line.sort_by(|&a, &b| {
                    let low = |i| ends(points, i)[0].0;
                    low(a).total_cmp(&low(b)).then(a.cmp(&b))
                });
                found.push(line);
                rest = others;
            }
        }
    }
    found
}

/// Whether three points lie in a straight line, exactly but for underflow: whether the sum of p × q, q × r and r × p
/// is zero.
fn is_straight(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> bool {
    // Parts that do not overlap (Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997):
    // their sum is zero only if all are.
    let mut parts: Vec<f64> = Vec::with_capacity(12);
    for (a, b) in [(p, q), (q, r), (r, p)] {
        for (x, y) in [(a[0], b[1]), (-a[1], b[0])] {
            let product = x * y;
            for mut term in [x.mul_add(y, -product), product] {
                for part in &mut parts {
                    (term, *part) = Dd::sum(term, *part).parts();
                }
                parts.push(term);
            }
        }
    }
    parts.iter().all(|&part| part == 0.0)
}

/// Whether any two segments of a line have more than an end in common.
fn overlaps(points: &[[f64; 2]], line: &[u32]) -> bool {
    let mut top = f64::NEG_INFINITY;
    line.iter().any(|&i| {
        let [(low, _), (high, _)] = ends(points, i);
        let over = low < top;
        top = top.max(high);
        over
    })
}

/// Appends the parts of a line that lie in an odd number of its segments.
fn thin_out(points: &[[f64; 2]], line: &[u32], all: &mut Vec<Subsegment>) {
    // Where a segment begins or ends.
    let mut places: Vec<(f64, u32, u32)> = Vec::new();
    for &i in line {
        places.extend(each(ends(points, i), |(at, point)| (at, point, i)));
    }
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut here: BTreeSet<u32> = BTreeSet::new();
    let mut open: Option<Subsegment> = None;
    for place in places.chunk_by(|a, b| a.0 == b.0) {
        let point = place[0].1;
        for &(_, _, i) in place {
            if !here.remove(&i) {
                here.insert(i);
            }
        }
        let odd = here.len() % 2 == 1;
        let goes_on = |piece: &Subsegment| odd && here.contains(&piece.segment);
        if open.as_ref().is_some_and(goes_on) {
            continue;
        }
        if let Some(piece) = open.take() {
            let (from, to) = if along(points, piece.segment, piece.segment + 1) > 0.0 {
                (piece.from, point)
            } else {
                (point, piece.from)
            };
            all.push(Subsegment { from, to, ..piece });
        }
        if let (true, Some(&segment)) = (odd, here.first()) {
            open = Some(Subsegment {
                from: point,
                to: point,
                segment,
            });
        }
    }
}

/// The ends of pieces as points of an outline. The given points are `scale` times as large.
pub(super) fn outline(points: &[[f64; 2]], pieces: &[Subsegment], scale: f64) -> Vec<ProfilePoint> {
    let point = |number: u32, is_joined: bool| {
        let [radius, height] = each(points[number as usize], |x| x / scale);
        ProfilePoint {
            radius,
            height,
            is_joined,
        }
    };
    let mut ends = Vec::new();
    let mut last = None;
    for piece in pieces {
        if last != Some(piece.from) {
            ends.push(point(piece.from, false));
        }
        ends.push(point(piece.to, true));
        last = Some(piece.to);
    }
    ends
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends of each stretch that is left, and the number of its segment.
    fn left(points: &[[f64; 2]]) -> Vec<([f64; 2], [f64; 2], u32)> {
        let at = |i: u32| points[i as usize];
        let all = pieces(points);
        all.iter()
            .map(|p| (at(p.from), at(p.to), p.segment))
            .collect()
    }

    #[test]
    fn plain_profiles_stay() {
        let points = [[0.0, 1.5], [1.0, 1.0], [1.0, 1.0], [1.0, 0.5], [1.0, 0.0]];
        let all: Vec<_> = pieces(&points).iter().map(|p| p.segment).collect();
        assert_eq!(all, [0, 2, 3]);
    }

    #[test]
    fn there_and_back_leaves_nothing_and_half_way_back_the_rest() {
        let [a, b, c] = [[0.0, 0.0], [0.5, 0.25], [1.0, 0.5]];
        assert_eq!(left(&[a, c, a]), []);
        assert_eq!(left(&[a, c, b, a]), []);
        assert_eq!(left(&[a, c, b]), [(a, b, 0)]);
        assert_eq!(left(&[b, c, a]), [(b, a, 1)]);
        // Three layers are one.
        assert_eq!(left(&[a, c, a, c]), [(a, c, 0)]);
        // Two overlapping: what only one of them covers.
        let d = [1.5, 0.75];
        assert_eq!(left(&[a, c, [0.0, 1.0], d, b]).len(), 4);
        assert_eq!(left(&[a, c, [0.0, 1.0], d, b])[0], (a, b, 0));
        assert_eq!(left(&[a, c, [0.0, 1.0], d, b])[3], (d, c, 3));
        // Upright and level.
        assert_eq!(left(&[[1.0, 0.0], [1.0, 1.0], [1.0, 0.0]]), []);
        assert_eq!(
            left(&[[0.0, 1.0], [1.0, 1.0], [0.25, 1.0]]),
            [([0.0, 1.0], [0.25, 1.0], 0)]
        );
    }

    #[test]
    fn one_ulp_beside_the_line_is_beside_it() {
        let third = 1.0 / 3.0;
        for (r, straight) in [
            ([1.0, 1.0], true),
            ([1.0, 1.0f64.next_up()], false),
            ([1.0f64.next_down(), 1.0], false),
            ([third, third], true),
            ([third, third.next_up()], false),
        ] {
            assert_eq!(is_straight([0.25, 0.25], [1.75, 1.75], r), straight);
            assert_eq!(is_straight(r, [0.25, 0.25], [1.75, 1.75]), straight);
        }
        let thin = [[0.0, 0.0], [1.0, 1.0], [0.5, 0.5f64.next_up()], [0.0, 0.0]];
        assert_eq!(pieces(&thin).len(), 3);
    }
}
