//! Removal of needles: triangles without area in the numbers of a file, mostly single precision. Closed meshes stay
//! closed: an edge without length is collapsed; an edge that passes through the third corner is flipped into the
//! triangle behind it; if neither can be done, a point is moved by a few steps of the precision.

use std::collections::HashMap;

use super::triangle_mesh::Mesh;
use crate::geometry::array::{cross, length, sub};
use crate::geometry::exact;
use crate::scene::Vec3;

/// The most times that each triangle is looked at.
const MAX_ROUNDS: usize = 16;

/// The kind of numbers that points are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    Single,
    /// Doubles, or decimal digits that are as good as exact.
    Double,
}

impl Precision {
    /// The point as it is written: rounded to this precision.
    fn written(self, p: Vec3) -> Vec3 {
        match self {
            Precision::Single => p.map(|x| f64::from(x as f32)),
            Precision::Double => p,
        }
    }

    /// The number `steps` representable numbers above `x`, or below `x` if `up` is false.
    fn stepped(self, x: f64, steps: u32, up: bool) -> f64 {
        let mut single = x as f32;
        let mut double = x;
        for _ in 0..steps {
            (single, double) = match up {
                true => (single.next_up(), double.next_up()),
                false => (single.next_down(), double.next_down()),
            };
        }
        match self {
            Precision::Single => f64::from(single),
            Precision::Double => double,
        }
    }
}

/// Whether a triangle has no area once its corners are rounded: exactly, or as a reader computes it in single
/// precision.
fn is_needle(corners: [Vec3; 3], precision: Precision) -> bool {
    let p = corners.map(|p| precision.written(p));
    let away = |i: usize, j: usize| length(sub(p[i], p[j]));
    let longest = away(0, 1).max(away(1, 2)).max(away(2, 0));
    // For shorter edges, single-precision products underflow to 0 whatever the shape of the triangle.
    const MIN_EDGE_LENGTH: f64 = 1e-15;
    let single = |i: usize| {
        let way = |j: usize| [0, 1, 2].map(|k| p[j % 3][k] as f32 - p[i][k] as f32);
        let (a, b) = (way(i + 1), way(i + 2));
        let part = |j: usize, k: usize| a[j] * b[k] - a[k] * b[j];
        part(1, 2) == 0.0 && part(2, 0) == 0.0 && part(0, 1) == 0.0
    };
    if precision == Precision::Single && longest > MIN_EDGE_LENGTH && (0..3).any(single) {
        return true;
    }
    let (u, v) = (sub(p[1], p[0]), sub(p[2], p[0]));
    // A cross product far above the rounding of doubles is not zero; only the others are computed exactly.
    length(cross(u, v)) <= 1e-12 * length(u) * length(v) && exact::collinear(p)
}

impl Mesh {
    /// Removes triangles without area, and moves no point farther than `most` for that. Returns the largest distance
    /// that a point was moved.
    pub fn drop_needles(&mut self, precision: Precision, most: f64) -> f64 {
        let all = 0..self.triangles.len();
        let mut todo: Vec<usize> = all
            .filter(|&t| is_needle(self.corners(t), precision))
            .collect();
        if todo.is_empty() {
            return 0.0;
        }
        let mut net = Net::new(self, precision, most);
        for _ in 0..MAX_ROUNDS {
            for t in std::mem::take(&mut todo) {
                if net.is_there(t) && is_needle(net.corners(t), precision) {
                    net.mend(t, &mut todo);
                }
            }
            if todo.is_empty() {
                break;
            }
        }
        net.finish()
    }
}

/// A mesh with the triangles at each of its edges and points.
struct Net<'a> {
    mesh: &'a mut Mesh,
    gone: Vec<bool>,
    /// The triangle that has the edge in this direction.
    edges: HashMap<[u32; 2], usize>,
    around: HashMap<u32, Vec<usize>>,
    precision: Precision,
    most: f64,
    /// The original places of points that have been moved.
    before: HashMap<u32, Vec3>,
}

fn edges_of([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

impl<'a> Net<'a> {
    fn new(mesh: &'a mut Mesh, precision: Precision, most: f64) -> Net<'a> {
        let mut net = Net {
            gone: vec![false; mesh.triangles.len()],
            edges: HashMap::new(),
            around: HashMap::new(),
            precision,
            most,
            before: HashMap::new(),
            mesh,
        };
        for t in 0..net.gone.len() {
            net.join(t);
        }
        net
    }

    fn is_there(&self, t: usize) -> bool {
        !self.gone[t]
    }

    fn corners(&self, t: usize) -> [Vec3; 3] {
        self.mesh.corners(t)
    }

    fn join(&mut self, t: usize) {
        let corners = self.mesh.triangles[t];
        for edge in edges_of(corners) {
            self.edges.insert(edge, t);
        }
        for i in corners {
            self.around.entry(i).or_default().push(t);
        }
    }

    fn part(&mut self, t: usize) {
        let corners = self.mesh.triangles[t];
        for edge in edges_of(corners) {
            if self.edges.get(&edge) == Some(&t) {
                self.edges.remove(&edge);
            }
        }
        for i in corners {
            if let Some(all) = self.around.get_mut(&i) {
                all.retain(|&other| other != t);
            }
        }
    }

    fn drop(&mut self, t: usize) {
        self.part(t);
        self.gone[t] = true;
    }

    fn replace(&mut self, t: usize, corners: [u32; 3], label: u32) {
        self.part(t);
        self.mesh.triangles[t] = corners;
        self.mesh.labels[t] = label;
        self.join(t);
    }

    fn place(&self, i: u32) -> Vec3 {
        self.precision.written(self.mesh.points[i as usize])
    }

    /// Removes the triangle `t`, which has no area. Adds triangles that have to be looked at again to `todo`.
    fn mend(&mut self, t: usize, todo: &mut Vec<usize>) {
        let corners = self.mesh.triangles[t];
        let short = |[a, b]: [u32; 2]| length(sub(self.place(a), self.place(b)));
        let mut edges = edges_of(corners);
        edges.sort_by(|a, b| short(*a).total_cmp(&short(*b)));
        let [shortest, _, longest] = edges;
        if short(shortest) == 0.0 && self.collapse(shortest) || self.flip(t, longest, todo) {
            return;
        }
        self.nudge(t, longest);
    }

    /// Merges the point `lost` into `kept`. Returns `false`, and changes nothing, if other triangles would come to
    /// lie on each other.
    fn collapse(&mut self, [kept, lost]: [u32; 2]) -> bool {
        let beside = |i: u32| -> Vec<u32> {
            let all = self.around[&i].iter().flat_map(|&t| self.mesh.triangles[t]);
            let mut all: Vec<u32> = all.filter(|&j| j != i).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        let (one, other) = (beside(kept), beside(lost));
        let common = one
            .iter()
            .filter(|i| other.binary_search(i).is_ok())
            .count();
        let between: Vec<usize> = (self.around[&lost].iter().copied())
            .filter(|&t| self.mesh.triangles[t].contains(&kept))
            .collect();
        if common != between.len() || self.around[&lost].len() + self.around[&kept].len() < 6 {
            return false;
        }
        between.into_iter().for_each(|t| self.drop(t));
        for t in self.around[&lost].clone() {
            let corners = self.mesh.triangles[t].map(|i| if i == lost { kept } else { i });
            self.replace(t, corners, self.mesh.labels[t]);
        }
        true
    }

    /// Flips edge `[a, b]` of the needle triangle `t`: the needle and its neighbour become two triangles that share
    /// the edge between their third corners. At the border of a surface, drops the needle. Returns `false` if it
    /// changes nothing.
    fn flip(&mut self, t: usize, [a, b]: [u32; 2], todo: &mut Vec<usize>) -> bool {
        let Some(&behind) = self.edges.get(&[b, a]) else {
            // The edge is on the border of a surface. Without the needle, the border passes through the third corner.
            self.drop(t);
            return true;
        };
        let third = |t: usize| {
            self.mesh.triangles[t]
                .into_iter()
                .find(|&i| i != a && i != b)
        };
        let (Some(c), Some(d)) = (third(t), third(behind)) else {
            return false;
        };
        if c == d || self.edges.contains_key(&[c, d]) || self.edges.contains_key(&[d, c]) {
            return false;
        }
        let made = [[a, d, c], [d, b, c]];
        let needles =
            made.map(|t| is_needle(t.map(|i| self.mesh.points[i as usize]), self.precision));
        if needles == [true; 2] {
            return false;
        }
        let label = self.mesh.labels[behind];
        for (t, (corners, needle)) in [t, behind].into_iter().zip(made.into_iter().zip(needles)) {
            self.replace(t, corners, label);
            if needle {
                todo.push(t);
            }
        }
        true
    }

    /// Moves the corner of triangle `t` that lies on its longest edge by a few steps of the precision, if no triangle
    /// at the corner is a needle then.
    fn nudge(&mut self, t: usize, longest: [u32; 2]) {
        let on_it = self.mesh.triangles[t]
            .into_iter()
            .find(|i| !longest.contains(i));
        let Some(c) = on_it else { return };
        let old = self.mesh.points[c as usize];
        let first = self.before.get(&c).copied().unwrap_or(old);
        for step in 0..5 {
            for k in 0..6 {
                let mut new = old;
                new[k / 2] = self.precision.stepped(old[k / 2], 1 << step, k % 2 == 0);
                if length(sub(new, first)) > self.most {
                    continue;
                }
                self.mesh.points[c as usize] = new;
                let needle = |t: &usize| is_needle(self.mesh.corners(*t), self.precision);
                if !self.around[&c].iter().any(needle) {
                    self.before.insert(c, first);
                    return;
                }
                self.mesh.points[c as usize] = old;
            }
        }
    }

    fn finish(self) -> f64 {
        let Net {
            mesh, gone, before, ..
        } = self;
        let moved = |(i, first): (&u32, &Vec3)| length(sub(mesh.points[*i as usize], *first));
        let moved = before.iter().map(moved).fold(0.0, f64::max);
        // For `only`, labels say which triangles stay: 0 for those that do, 1 for the others.
        let labels = std::mem::take(&mut mesh.labels);
        mesh.labels = gone.iter().map(|&g| u32::from(g)).collect();
        let mut left = mesh.only(|gone| gone == 0);
        let labels = labels.into_iter().zip(gone).filter(|l| !l.1);
        left.labels = labels.map(|l| l.0).collect();
        *mesh = left;
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::made;
    use super::*;
    use dashu_ratio::RBig;

    fn needle(corners: [Vec3; 3]) -> bool {
        is_needle(corners, Precision::Single)
    }

    /// Whether the triangle has no area: in fractions.
    fn is_flat(corners: [Vec3; 3]) -> bool {
        let exact = |x: f64| RBig::try_from(f64::from(x as f32)).unwrap();
        let [a, b, c] = corners.map(|p| p.map(exact));
        let cross = |i: usize, j: usize| {
            (&b[i] - &a[i]) * (&c[j] - &a[j]) == (&b[j] - &a[j]) * (&c[i] - &a[i])
        };
        cross(0, 1) && cross(1, 2) && cross(2, 0)
    }

    #[test]
    fn needles_and_caps() {
        let flat = |z: f64| needle([[0.0; 3], [1.0, 1.0, 0.0], [3.0, 3.0, z]]);
        assert!(flat(0.0) && flat(1e-60) && !flat(1e-6));
        assert!(needle([
            [1.0, 0.0, 0.0],
            [1.0 + 1e-9, 0.0, 0.0],
            [0.0, 1.0, 0.0]
        ]));
        assert!(!needle([
            [1e-20, 0.0, 0.0],
            [0.0, 1e-20, 0.0],
            [0.0, 0.0, 1e-20]
        ]));
    }

    #[test]
    fn what_is_a_needle_depends_on_the_numbers() {
        let far = |x: f64, y: f64| [1e8 + x, 1e8 + y, 0.0];
        let corners = [far(0.0, 0.0), far(1.0, 0.0), far(0.0, 1.0)];
        assert!(needle(corners) && !is_needle(corners, Precision::Double));
        let flat = [far(0.0, 0.0), far(1.0, 1.0), far(2.0, 2.0)];
        assert!(is_needle(flat, Precision::Double));
    }

    /// A tetrahedron with a point on an edge, and one with an edge without length.
    #[test]
    fn a_closed_mesh_stays_closed() {
        let apex = |second: Vec3| {
            let mut mesh = Mesh {
                points: vec![
                    [0.0; 3],
                    [2.0, 0.0, 0.0],
                    [0.0, 2.0, 0.0],
                    [0.0, 0.0, 2.0],
                    second,
                ],
                ..Mesh::default()
            };
            // The base is fanned from the first point; 4 is on the edge from 0 to 1, or in 1.
            for t in [
                [0, 2, 1],
                [0, 1, 4],
                [0, 4, 3],
                [4, 1, 3],
                [1, 2, 3],
                [2, 0, 3],
            ] {
                mesh.triangle(t);
            }
            assert!(mesh.is_closed());
            let volume = mesh.volume();
            mesh.drop_needles(Precision::Single, f64::INFINITY);
            assert!(mesh.is_closed(), "{mesh:?}");
            assert!((mesh.volume() - volume).abs() < 1e-6);
            assert!(!(0..mesh.triangles.len()).any(|t| is_flat(mesh.corners(t))));
        };
        apex([1.0, 0.0, 0.0]);
        apex([2.0, 0.0, 0.0]);
        apex([2.0, 0.0, 1e-12]);
    }

    /// Solids that end at a few heights, turned about the way up: their faces lie in each other, and edges
    /// go through corners.
    fn scene(random: &mut impl FnMut(u64) -> u64) -> String {
        let mut text = String::new();
        let count = 2 + random(4);
        for id in 2..2 + count {
            let low = random(4);
            let high = low + 1 + random(4 - low);
            let [low, high] = [low, high].map(|h| h as f64 / 2.0 - 1.0);
            let [x, z] = [0; 2].map(|_| random(5) as f64 / 4.0 - 0.5);
            let [w, d] = [0; 2].map(|_| (1 + random(4)) as f64 / 4.0);
            let place = format!("{id} -1 {x} 0 {z}\n");
            text += &match random(5) {
                0 | 1 => format!(
                    "{id} 12 {} {low} {} {} {high} {}\n",
                    x - w,
                    z - d,
                    x + w,
                    z + d
                ),
                2 => format!("{id} 1 2 {w} {low} {w} {high}\n{place}"),
                3 => format!("{id} 1 4 0 {low} {w} {low} {d} {high} 0 {high}\n{place}"),
                _ => format!("{id} 16 {} {w}\n{id} -1 {x} {low} {z}\n", high - low),
            };
            if random(5) < 3 {
                let angle = [15, 30, 45, 37, 60, 90][random(6) as usize];
                text += &format!("{id} -2 {angle} 2\n");
            }
        }
        let mut last = 2;
        for id in 3..2 + count {
            text += &format!("{} -10{} {last} {id}\n", id + 100, 1 + random(3));
            last = id + 100;
        }
        if random(2) == 0 {
            let angle = [30, 45, 90, 20][random(4) as usize];
            text += &format!("{last} -2 {angle} {}\n", 1 + random(3));
        }
        if random(3) == 0 {
            text += &format!("{last} -3 1 0.7 1.3\n");
        }
        text + &format!("1 9999 {last} 0\n")
    }

    #[test]
    fn scenes_with_faces_in_each_other_have_none() {
        let mut random = crate::testing::random();
        let mut count = 0;
        for _ in 0..150 {
            let text = scene(&mut random);
            let model = made(&text, 1e-2);
            let mesh = &model.mesh;
            assert!(mesh.is_closed(), "{text}");
            let flat = (0..mesh.triangles.len()).filter(|&t| {
                let corners = mesh.corners(t);
                is_flat(corners) || needle(corners)
            });
            assert_eq!(flat.count(), 0, "{text}");
            count += usize::from(!mesh.is_empty());
        }
        assert!(count > 60, "{count}");
    }
}
