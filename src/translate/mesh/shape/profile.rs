//! Profiles as scenes give them, made into simple ones: the boundaries of what they surround by the even-odd rule.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::turned::Profile;

type Point = [f64; 2];

/// Points are the same if their coordinates differ by no more than this share of the largest one: what a few
/// roundings may do.
const POINT_REL_EPS: f64 = 1e-14;

/// The boundary of what a profile of points (radius, height) surrounds. The profile is closed over the axis, unless
/// its last point is its first.
pub(super) fn simple(written: &[Point]) -> Vec<Profile> {
    let mut around: Vec<Point> = written.to_vec();
    if written.first() == written.last() {
        around.pop();
    } else if let (Some(first), Some(last)) = (written.first(), written.last()) {
        around.insert(0, [0.0, first[1]]);
        around.push([0.0, last[1]]);
    }
    // Adding zero turns −0 into 0.
    for p in around.iter_mut().flatten() {
        *p += 0.0;
    }
    around.dedup();
    while around.len() > 1 && around.first() == around.last() {
        around.pop();
    }
    if around.len() < 3 {
        return Vec::new();
    }
    let edges: Vec<[Point; 2]> = (0..around.len())
        .map(|i| [around[i], around[(i + 1) % around.len()]])
        .collect();
    let loops = if is_simple(&edges) {
        let mut around = around;
        let area: f64 = edges.iter().map(|[p, q]| p[0] * q[1] - q[0] * p[1]).sum();
        if area < 0.0 {
            around.reverse();
        }
        vec![around]
    } else {
        loops(oriented(split(&edges)))
    };
    loops.iter().flat_map(|l| off_the_axis(l)).collect()
}

/// Equal slices of the heights, and the indices of the edges in each slice.
struct Slices {
    low: f64,
    height: f64,
    edges: Vec<Vec<u32>>,
}

impl Slices {
    const MAX_SLICES: usize = 4096;

    fn of(edges: &[[Point; 2]]) -> Slices {
        let ys = || edges.iter().flatten().map(|p| p[1]);
        let low = ys().fold(f64::INFINITY, f64::min);
        let high = ys().fold(f64::NEG_INFINITY, f64::max);
        let n = edges.len().clamp(1, Slices::MAX_SLICES);
        let mut out = Slices {
            low,
            height: ((high - low) / n as f64).max(f64::MIN_POSITIVE),
            edges: vec![Vec::new(); n],
        };
        for (i, edge) in edges.iter().enumerate() {
            for slice in out.range(edge) {
                out.edges[slice].push(i as u32);
            }
        }
        out
    }

    fn at(&self, y: f64) -> usize {
        (((y - self.low) / self.height) as usize).min(self.edges.len() - 1)
    }

    fn range(&self, [p, q]: &[Point; 2]) -> std::ops::RangeInclusive<usize> {
        self.at(p[1].min(q[1]))..=self.at(p[1].max(q[1]))
    }
}

/// The points where edge `e` has to be split because it meets edge `f`, each with its share of the way along `e`.
fn meet(e: &[Point; 2], f: &[Point; 2]) -> Vec<(f64, Point)> {
    let [p, q] = *e;
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0] * d[0] + d[1] * d[1];
    let side = |x: Point| side_of(e, x);
    let share = |x: Point| ((x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1]) / length;
    let (a, b) = (side(f[0]), side(f[1]));
    let mut out = Vec::new();
    // Ends of `f` that lie on `e`.
    for (s, x) in [(a, f[0]), (b, f[1])] {
        if s == 0.0 && (0.0..1.0).contains(&share(x)) && x != p && x != q {
            out.push((share(x), x));
        }
    }
    let apart = |a: f64, b: f64| a != 0.0 && b != 0.0 && (a > 0.0) != (b > 0.0);
    // If an end of `e` only touches `f`, then `f` has to be split instead.
    if apart(a, b) && apart(side_of(f, p), side_of(f, q)) {
        // Both edges must get the same numbers, so the edge that is first in order is the first argument, whichever
        // edge asks.
        let (first, second) = if bits(e) <= bits(f) { (e, f) } else { (f, e) };
        let at = crossing(first, second);
        if let Some(at) = at
            && at != p
            && at != q
        {
            out.push((share(at), at));
        }
    }
    out
}

/// The side of an edge that a point is on: positive to the left, negative to the right, zero on its line.
fn side_of([p, q]: &[Point; 2], x: Point) -> f64 {
    (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0])
}

fn bits(e: &[Point; 2]) -> [u64; 4] {
    [e[0][0], e[0][1], e[1][0], e[1][1]].map(f64::to_bits)
}

/// The crossing of two edges; an end of one of them if the crossing is there up to rounding. `None` if they do not
/// cross.
fn crossing([p, q]: &[Point; 2], [r, s]: &[Point; 2]) -> Option<Point> {
    let d = [q[0] - p[0], q[1] - p[1]];
    let e = [s[0] - r[0], s[1] - r[1]];
    let k = d[0] * e[1] - d[1] * e[0];
    let w = [r[0] - p[0], r[1] - p[1]];
    let t = (w[0] * e[1] - w[1] * e[0]) / k;
    let u = (w[0] * d[1] - w[1] * d[0]) / k;
    let within = (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u);
    let at = [p[0] + t * d[0] + 0.0, p[1] + t * d[1] + 0.0];
    let ends = [p, q, r, s];
    let size = ends
        .into_iter()
        .flatten()
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    let near = |x: f64, y: f64| (x - y).abs() <= POINT_REL_EPS * size;
    let mut ends = ends.into_iter().copied();
    let end = ends.find(|x| near(x[0], at[0]) && near(x[1], at[1]));
    within.then(|| end.unwrap_or(at))
}

/// Whether edges meet only where one follows the other, and no point is there twice.
fn is_simple(edges: &[[Point; 2]]) -> bool {
    let mut seen = HashSet::with_capacity(edges.len());
    if !edges.iter().all(|e| seen.insert(e[0].map(f64::to_bits))) {
        return false;
    }
    let slices = Slices::of(edges);
    slices.edges.iter().all(|slice| {
        slice.iter().enumerate().all(|(k, &i)| {
            slice[..k].iter().all(|&j| {
                let (e, f) = (&edges[i as usize], &edges[j as usize]);
                let apart = e[0][0].max(e[1][0]) < f[0][0].min(f[1][0])
                    || f[0][0].max(f[1][0]) < e[0][0].min(e[1][0]);
                apart || (meet(e, f).is_empty() && meet(f, e).is_empty())
            })
        })
    })
}

/// The edges, cut where they meet. An edge that is there an even number of times bounds nothing and is left out.
fn split(edges: &[[Point; 2]]) -> Vec<[Point; 2]> {
    let slices = Slices::of(edges);
    let mut count: BTreeMap<[u64; 4], ([Point; 2], u32)> = BTreeMap::new();
    for (i, e) in edges.iter().enumerate() {
        let mut others: Vec<u32> = slices
            .range(e)
            .flat_map(|s| slices.edges[s].iter().copied())
            .filter(|&j| j as usize != i)
            .collect();
        others.sort_unstable();
        others.dedup();
        let mut cuts: Vec<(f64, Point)> = others
            .iter()
            .flat_map(|&j| meet(e, &edges[j as usize]))
            .collect();
        cuts.push((1.0, e[1]));
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut at = e[0];
        for (_, to) in cuts {
            if to == at {
                continue;
            }
            let edge = if at.map(f64::to_bits) < to.map(f64::to_bits) {
                [at, to]
            } else {
                [to, at]
            };
            count.entry(bits(&edge)).or_insert((edge, 0)).1 += 1;
            at = to;
        }
    }
    let odd = count.into_values().filter(|(_, n)| n % 2 == 1);
    odd.map(|(edge, _)| edge).collect()
}

/// Turns each edge so that the inside lies to its left.
fn oriented(edges: Vec<[Point; 2]>) -> Vec<[Point; 2]> {
    let slices = Slices::of(&edges);
    let mut out = Vec::with_capacity(edges.len());
    for (i, &[p, q]) in edges.iter().enumerate() {
        let middle = [p[0] / 2.0 + q[0] / 2.0, p[1] / 2.0 + q[1] / 2.0];
        // How many edges lie to the right of the middle of this one, at its height. A level edge is
        // looked at along the vertical instead.
        let level = p[1] == q[1];
        let beyond = |[a, b]: [Point; 2]| {
            let (u, v) = if level { (1, 0) } else { (0, 1) };
            let spans = (a[v] <= middle[v]) != (b[v] <= middle[v]);
            spans && a[u] + (middle[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]) > middle[u]
        };
        let count = if level {
            let all = edges.iter().enumerate();
            all.filter(|&(j, e)| j != i && beyond(*e)).count()
        } else {
            let near = &slices.edges[slices.at(middle[1])];
            let others = near.iter().filter(|&&j| j as usize != i);
            others.filter(|&&j| beyond(edges[j as usize])).count()
        };
        // If the number is odd, the inside lies to the right of the edge, or above it.
        let inside_beyond = count % 2 == 1;
        let keep = if level {
            // Left of an edge that leads to the right is above it.
            (q[0] > p[0]) == inside_beyond
        } else {
            // Left of an edge that leads down is to the right.
            (q[1] < p[1]) == inside_beyond
        };
        out.push(if keep { [p, q] } else { [q, p] });
    }
    out
}

/// Links edges into loops. If several edges leave a point, a loop goes on with the first one clockwise from the edge
/// that it came by: the inside lies on that side.
fn loops(edges: Vec<[Point; 2]>) -> Vec<Vec<Point>> {
    let key = |p: Point| p.map(f64::to_bits);
    let mut from: HashMap<[u64; 2], Vec<u32>> = HashMap::new();
    for (i, e) in edges.iter().enumerate() {
        from.entry(key(e[0])).or_default().push(i as u32);
    }
    let mut used = vec![false; edges.len()];
    let mut out = Vec::new();
    for start in 0..edges.len() {
        let mut around = Vec::new();
        let mut at = start;
        while !used[at] {
            used[at] = true;
            let [p, q] = edges[at];
            around.push(p);
            let back = (p[1] - q[1]).atan2(p[0] - q[0]);
            let turn = |i: u32| {
                let [a, b] = edges[i as usize];
                let way = (b[1] - a[1]).atan2(b[0] - a[0]);
                (back - way).rem_euclid(std::f64::consts::TAU)
            };
            let next = from.get(&key(q)).into_iter().flatten().copied();
            let next = next
                .filter(|&i| !used[i as usize])
                .min_by(|&i, &j| turn(i).total_cmp(&turn(j)));
            match next {
                Some(i) => at = i as usize,
                None => break,
            }
        }
        if around.len() > 2 {
            out.push(around);
        }
    }
    out
}

/// The parts of a loop that become a surface: those that do not run along the axis.
fn off_the_axis(around: &[Point]) -> Vec<Profile> {
    let n = around.len();
    let Some(start) = around.iter().position(|p| p[0] == 0.0) else {
        return vec![Profile {
            points: around.to_vec(),
            ring: true,
        }];
    };
    let mut out = Vec::new();
    let mut points = vec![around[start]];
    for k in 1..=n {
        let p = around[(start + k) % n];
        points.push(p);
        if p[0] == 0.0 {
            if points.len() > 2 {
                out.push(Profile {
                    points: std::mem::take(&mut points),
                    ring: false,
                });
            }
            points = vec![p];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_simple_profile_rises() {
        let down = simple(&[[1.0, 2.0], [1.0, 0.0]]);
        let up = simple(&[[1.0, 0.0], [1.0, 2.0]]);
        let points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]];
        let ring = false;
        assert_eq!(up, [Profile { points, ring }]);
        assert_eq!(down.len(), 1);
        assert_eq!(down[0].points.len(), 4);
        assert_eq!(down[0].points[1], [1.0, 0.0]);
    }

    #[test]
    fn a_bow_is_two_pieces() {
        // A ring that crosses itself at (2, 1).
        let bow = [[1.0, 0.0], [3.0, 2.0], [3.0, 0.0], [1.0, 2.0], [1.0, 0.0]];
        let pieces = simple(&bow);
        assert_eq!(pieces.len(), 2);
        assert!(pieces.iter().all(|p| p.ring && p.points.len() == 3));
        for p in &pieces {
            let n = p.points.len();
            let area: f64 = (0..n)
                .map(|i| (p.points[i], p.points[(i + 1) % n]))
                .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
                .sum();
            assert!((area / 2.0 - 1.0).abs() < 1e-12, "{area}");
        }
    }

    #[test]
    fn a_hole_runs_the_other_way() {
        // A square, and along the same path a smaller one in it: a bridge is passed twice.
        let path = [
            [1.0, 0.0],
            [5.0, 0.0],
            [5.0, 4.0],
            [1.0, 4.0],
            [1.0, 0.0],
            [2.0, 1.0],
            [3.0, 1.0],
            [3.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 0.0],
        ];
        let pieces = simple(&path);
        assert_eq!(pieces.len(), 2);
        let total: f64 = pieces
            .iter()
            .flat_map(|p| {
                let n = p.points.len();
                (0..n).map(move |i| (p.points[i], p.points[(i + 1) % n]))
            })
            .map(|(a, b)| (a[0] * b[1] - b[0] * a[1]) / 2.0)
            .sum();
        assert!((total - 15.0).abs() < 1e-12);
    }

    #[test]
    fn what_touches_the_axis_is_in_two() {
        let pieces = simple(&[[0.0, 0.0], [1.0, 1.0], [0.0, 2.0], [1.0, 3.0], [0.0, 4.0]]);
        assert_eq!(pieces.len(), 2);
        assert!(pieces.iter().all(|p| !p.ring && p.points.len() == 3));
        assert!(simple(&[[1.0, 1.0], [1.0, 1.0]]).is_empty());
        assert!(simple(&[[0.0, 0.0], [0.0, 3.0]]).is_empty());
    }

    /// Twice the moment of what profiles surround about the axis: its volume when turned, over π.
    fn volume(pieces: &[Profile]) -> f64 {
        let of = |p: &Profile| -> f64 {
            let n = p.points.len();
            let steps = (0..n).map(|i| (p.points[i], p.points[(i + 1) % n]));
            steps
                .map(|(a, b)| (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 3.0 * (b[1] - a[1]))
                .sum()
        };
        pieces.iter().map(of).sum()
    }

    #[test]
    fn rising_profiles_surround_frusta() {
        let mut written: Vec<Vec<Point>> = vec![
            vec![[0.0, -0.847], [0.0, -0.844], [0.613, 0.594], [0.475, 0.901]],
            vec![
                [0.419, -0.761],
                [0.0, -0.51],
                [0.445, -0.285],
                [1.15, -0.141],
            ],
            vec![
                [0.0, -0.69],
                [0.0, -0.465],
                [0.371, -0.414],
                [0.0, 0.216],
                [0.518, 0.978],
            ],
        ];
        let mut state = 1u64;
        let mut random = |n: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) % n
        };
        for _ in 0..500 {
            let mut y = -1.0;
            let points = (0..2 + random(7)).map(|_| {
                y += (1 + random(300)) as f64 / 1000.0;
                let radius = random(900).saturating_sub(300) as f64 / 600.0;
                [radius, y]
            });
            written.push(points.collect());
        }
        for profile in &written {
            let frusta: f64 = profile
                .windows(2)
                .map(|w| (w[0], w[1]))
                .map(|(a, b)| (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 3.0 * (b[1] - a[1]))
                .sum();
            let pieces = simple(profile);
            assert!(
                (volume(&pieces) - frusta).abs() < 1e-12,
                "{profile:?}: {pieces:?}"
            );
        }
    }
}
