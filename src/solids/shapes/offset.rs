//! Profiles with their sides moved outwards.

/// A profile may be sharper than a right angle, but not so sharp that its tip would move so many times
/// as far as its sides.
const SHARP: f64 = 16.0;

/// What is nearer, as a part of their length, is in one line: what a few roundings may do.
const SAME: f64 = 1e-12;

/// Of profiles with more points nobody finds out whether they cross themselves.
const LONG: usize = 512;

/// Twice the area that a closed polygon runs around, negative where it does so clockwise.
pub fn twice_area(polygon: &[[f64; 2]]) -> f64 {
    let n = polygon.len();
    let sides = (0..n).map(|i| [polygon[i], polygon[(i + 1) % n]]);
    sides.map(|[p, q]| p[0] * q[1] - q[0] * p[1]).sum()
}

/// A profile closed over the axis, no point twice in a row.
fn closed(profile: &[[f64; 2]]) -> Vec<[f64; 2]> {
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

/// Which sides of a profile lie in sides of others; nothing where none does.
pub fn sides_within(profile: &[[f64; 2]], others: &[&[[f64; 2]]]) -> Option<Vec<bool>> {
    let own = closed(profile);
    let walls: Vec<[[f64; 2]; 2]> = (others.iter())
        .flat_map(|p| {
            let p = closed(p);
            let n = p.len();
            (0..n)
                .map(move |i| [p[i], p[(i + 1) % n]])
                .collect::<Vec<_>>()
        })
        .filter(|[a, b]| a[0] != 0.0 || b[0] != 0.0)
        .collect();
    if own.len() > LONG || walls.len() > LONG {
        return None;
    }
    let lies_in = |[p, q]: [[f64; 2]; 2]| {
        walls.iter().any(|[a, b]| {
            let d = [b[0] - a[0], b[1] - a[1]];
            let square = d[0] * d[0] + d[1] * d[1];
            [p, q].iter().all(|p| {
                let e = [p[0] - a[0], p[1] - a[1]];
                let along = (d[0] * e[0] + d[1] * e[1]) / square;
                let across = (d[0] * e[1] - d[1] * e[0]) / square;
                across.abs() < SAME && (-SAME..=1.0 + SAME).contains(&along)
            })
        })
    };
    let n = own.len();
    let sides: Vec<bool> = (0..n)
        .map(|i| [own[i], own[(i + 1) % n]])
        .map(|side| (side[0][0] != 0.0 || side[1][0] != 0.0) && lies_in(side))
        .collect();
    sides.contains(&true).then_some(sides)
}

/// A profile of a surface of revolution with its sides moved outwards: each by its own length.
pub fn offset_profile(profile: &[[f64; 2]], by: impl Fn(usize) -> f64) -> Option<Vec<[f64; 2]>> {
    let ring = profile.first()? == profile.last()?;
    let closed = closed(profile);
    let n = closed.len();
    if !(3..=LONG).contains(&n) || crosses_itself(&closed) {
        return None;
    }
    // To the right of the way if that runs counter-clockwise.
    let side = twice_area(&closed).signum();
    let direction = |p: [f64; 2], q: [f64; 2]| {
        let d = [q[0] - p[0], q[1] - p[1]];
        let length = d[0].hypot(d[1]);
        d.map(|x| x / length)
    };
    let normal = |p: [f64; 2], q: [f64; 2]| {
        let d = direction(p, q);
        // The axis is no side, and stays where it is.
        match p[0] == 0.0 && q[0] == 0.0 {
            true => None,
            false => Some([side * d[1], -side * d[0]]),
        }
    };
    let mut out = Vec::with_capacity(n);
    for i in 0..n {
        let [before, here, after] = [closed[(i + n - 1) % n], closed[i], closed[(i + 1) % n]];
        let (first, second) = (by((i + n - 1) % n), by(i));
        let step = match (normal(before, here), normal(here, after)) {
            (Some(a), Some(b)) => {
                let sum = [0, 1].map(|k| a[k] + b[k]);
                let square = (sum[0] * sum[0] + sum[1] * sum[1]) / 4.0;
                let cross = a[0] * b[1] - a[1] * b[0];
                if square * SHARP * SHARP < 1.0 {
                    return None;
                } else if first == second {
                    sum.map(|x| first * x / 2.0 / square)
                } else if cross.abs() * SHARP < 1.0 {
                    return None;
                } else {
                    // Where the two moved sides meet.
                    let x = (first * b[1] - second * a[1]) / cross;
                    let y = (second * a[0] - first * b[0]) / cross;
                    [x, y]
                }
            }
            // Along the axis, as far as the side goes.
            (Some(a), None) | (None, Some(a)) => {
                if a[1].abs() * SHARP < 1.0 {
                    return None;
                }
                let by = if normal(here, after).is_some() {
                    second
                } else {
                    first
                };
                [0.0, by / a[1]]
            }
            (None, None) => [0.0; 2],
        };
        out.push([(here[0] + step[0]).max(0.0), here[1] + step[1]]);
    }
    // A side that is shorter than that would turn round.
    let same_way = |i: usize| {
        let j = (i + 1) % n;
        let [d, e] =
            [[closed[i], closed[j]], [out[i], out[j]]].map(|[p, q]| [q[0] - p[0], q[1] - p[1]]);
        d[0] * e[0] + d[1] * e[1] > 0.0
    };
    if !(0..n).all(same_way) || crosses_itself(&out) {
        return None;
    }
    if ring {
        out.extend(out.first().copied());
    }
    Some(out)
}

/// Whether two sides of a polygon that are no neighbours meet.
fn crosses_itself(polygon: &[[f64; 2]]) -> bool {
    let n = polygon.len();
    let side = |i: usize| [polygon[i], polygon[(i + 1) % n]];
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let apart = |[a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]| {
        (0..2).any(|k| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]))
            || turn(a, b, c) * turn(a, b, d) > 0.0
            || turn(c, d, a) * turn(c, d, b) > 0.0
    };
    (0..n).any(|i| (i + 2..n).any(|j| (j + 1) % n != i && !apart(side(i), side(j))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Geometry;
    use crate::solids::shapes::facts::Facts;

    fn profile(points: &[[f64; 2]], by: f64) -> Option<Vec<[f64; 2]>> {
        let round = |x: f64| (x * 1e9).round() / 1e9;
        let moved = offset_profile(points, |_| by)?;
        Some(moved.into_iter().map(|p| p.map(round)).collect())
    }

    #[test]
    fn profiles_move_side_by_side() {
        let cylinder = [[1.0, 0.0], [1.0, 2.0]];
        let smaller = vec![[0.0, 0.25], [0.75, 0.25], [0.75, 1.75], [0.0, 1.75]];
        assert_eq!(profile(&cylinder, -0.25), Some(smaller));
        let downwards = [[1.0, 2.0], [1.0, 0.0]];
        let larger = vec![[0.0, 2.25], [1.25, 2.25], [1.25, -0.25], [0.0, -0.25]];
        assert_eq!(profile(&downwards, 0.25), Some(larger));
        // A cup with walls of 1/2: 1/4 would leave nothing of them.
        let cup = [[2.0, 0.0], [2.0, 3.0], [1.5, 3.0], [1.5, 0.5], [0.0, 0.5]];
        let thinner = [
            [0.0, 0.125],
            [1.875, 0.125],
            [1.875, 2.875],
            [1.625, 2.875],
            [1.625, 0.375],
            [0.0, 0.375],
        ];
        assert_eq!(profile(&cup, -0.125), Some(thinner.to_vec()));
        assert_eq!(profile(&cup, -0.25), None);
        // A ring stays one; one that crosses itself has no inside to speak of.
        let ring = [[2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 0.0]];
        let moved = profile(&ring, 0.5).unwrap();
        assert_eq!((moved.first(), moved.len()), (moved.last(), 5));
        assert!(moved.contains(&[3.5, -0.5]) && moved.contains(&[1.5, 1.5]));
        let eight = [[1.0, 0.0], [2.0, 1.0], [1.0, 1.0], [2.0, 0.0], [1.0, 0.0]];
        assert_eq!(profile(&eight, 0.01), None);
    }

    #[test]
    fn wine_reaches_into_the_glass() {
        let cup = [[2.0, 0.0], [2.0, 3.0], [1.5, 3.0], [1.0, 0.5], [0.0, 0.5]];
        // Up to half of its height, where its wall is at 1.25.
        let wine = [[0.0, 0.5], [1.0, 0.5], [1.25, 1.75]];
        let sides = sides_within(&wine, &[&cup]).unwrap();
        // Bottom, wall, level; then back along the axis.
        assert_eq!(sides, [true, true, false, false]);
        let by = |i: usize| if sides[i] { 0.01 } else { 0.0 };
        let larger = offset_profile(&wine, by).unwrap();
        // The wall rises five times as steeply as it opens: it is moved by 0.01·√26/5 at one height.
        let out = 0.01 * 26f64.sqrt() / 5.0;
        let expected = [
            [0.0, 0.49],
            [1.0 + out - 0.002, 0.49],
            [1.25 + out, 1.75],
            [0.0, 1.75],
        ];
        for (p, q) in larger.iter().zip(expected) {
            assert!((p[0] - q[0]).hypot(p[1] - q[1]) < 1e-12, "{p:?} {q:?}");
        }
        assert_eq!(sides_within(&[[0.5, 1.0], [0.5, 2.0]], &[&cup]), None);
    }

    #[test]
    fn cones_keep_their_angle() {
        // The side runs from (0, 0) to (3, 4): its normal is (4, −3)/5, and the tip goes up by 5/3.
        let cone = Geometry::Cone {
            height: 4.0,
            radius: 3.0,
        };
        let Some(Geometry::Revolution { profile, .. }) = cone.offset(-0.3) else {
            panic!()
        };
        let [tip, rim, middle] = profile[..] else {
            panic!("{profile:?}")
        };
        let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12;
        assert!(near(tip, [0.0, 0.5]), "{tip:?}");
        assert!(near(rim, [0.75 * (3.7 - 0.5), 3.7]), "{rim:?}");
        assert!(near(middle, [0.0, 3.7]), "{middle:?}");
    }
}
