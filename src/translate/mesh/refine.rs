//! Division of triangles where one colour a triangle is not enough.

use std::collections::HashMap;

use super::triangle_mesh::Mesh;
use crate::geometry::array::{dot, sub};
use crate::scene::Vec3;

/// The number of triangles at which no more are made.
const MAX_TRIANGLES: usize = 1 << 22;

/// The middle between two points.
fn middle(p: Vec3, q: Vec3) -> Vec3 {
    std::array::from_fn(|i| p[i] / 2.0 + q[i] / 2.0)
}

impl Mesh {
    /// Halves the edges of triangles whose label is `wanted`, until no edge is longer than `longest` allows at its
    /// middle. A closed mesh stays closed, and the surface stays where it is.
    pub fn refine(&mut self, wanted: impl Fn(u32) -> bool, longest: impl Fn(Vec3) -> f64) {
        loop {
            let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
            for (t, &label) in self.triangles.iter().zip(&self.labels) {
                if !wanted(label) {
                    continue;
                }
                for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
                    let [p, q] = [a, b].map(|i| self.points[i as usize]);
                    let d = sub(q, p);
                    let longest = longest(middle(p, q));
                    if dot(d, d) > longest * longest {
                        middles.entry((a.min(b), a.max(b))).or_insert(0);
                    }
                }
            }
            // On a closed surface each halved edge makes two more triangles.
            if middles.is_empty() || self.triangles.len() + 2 * middles.len() > MAX_TRIANGLES {
                return;
            }
            let mut edges: Vec<(u32, u32)> = middles.keys().copied().collect();
            edges.sort_unstable();
            for (a, b) in edges {
                let [p, q] = [a, b].map(|i| self.points[i as usize]);
                let middle = self.point(middle(p, q));
                middles.insert((a, b), middle);
            }
            self.split(&middles);
        }
    }

    fn split(&mut self, middles: &HashMap<(u32, u32), u32>) {
        let triangles = std::mem::take(&mut self.triangles);
        let labels = std::mem::take(&mut self.labels);
        for (t, label) in triangles.into_iter().zip(labels) {
            let middle = |a: u32, b: u32| middles.get(&(a.min(b), a.max(b))).copied();
            // The corners are rotated until the edges that are split come first.
            let turns = [t, [t[1], t[2], t[0]], [t[2], t[0], t[1]]];
            let split = |[a, b, c]: [u32; 3]| [middle(a, b), middle(b, c), middle(c, a)];
            let made = turns.into_iter().find_map(|t| {
                let [a, b, c] = t;
                match split(t) {
                    [None, None, None] => Some(vec![t]),
                    [Some(m), None, None] => Some(vec![[a, m, c], [m, b, c]]),
                    [Some(m), Some(n), None] => Some(vec![[m, b, n], [a, m, n], [a, n, c]]),
                    [Some(m), Some(n), Some(o)] => {
                        Some(vec![[a, m, o], [m, b, n], [o, n, c], [m, n, o]])
                    }
                    _ => None,
                }
            });
            for t in made.unwrap_or_default() {
                self.triangles.push(t);
                self.labels.push(label);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::flat::cuboid;

    #[test]
    fn what_is_near_is_finer() {
        let mut mesh = cuboid([-1000.0, -1.0, -1000.0], [1000.0, 0.0, 1000.0]);
        let far = |p: [f64; 3]| p[0].hypot(p[1]).hypot(p[2]).max(1.0);
        mesh.refine(|_| true, far);
        assert!(mesh.is_closed());
        assert!((mesh.volume() - 4e6).abs() < 1e-3);
        assert!(mesh.triangles.len() < 4000);
        for t in 0..mesh.triangles.len() {
            let [a, b, _] = mesh.corners(t);
            let d: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
            let middle = std::array::from_fn(|i| (a[i] + b[i]) / 2.0);
            assert!(d[0].hypot(d[1]).hypot(d[2]) <= far(middle));
        }
    }

    #[test]
    fn a_box_stays_a_box() {
        let mut mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
        // The top alone, and what is next to it.
        mesh.labels[6..8].fill(1);
        mesh.refine(|l| l == 1, |_| 0.3);
        assert!(mesh.is_closed());
        assert!((mesh.volume() - 6.0).abs() < 1e-12);
        let top: Vec<usize> = (0..mesh.triangles.len())
            .filter(|&t| mesh.labels[t] == 1)
            .collect();
        assert!(top.len() > 100);
        for t in top {
            let [a, b, c] = mesh.corners(t);
            assert!([a, b, c].iter().all(|p| p[1] == 2.0));
            for (p, q) in [(a, b), (b, c), (c, a)] {
                assert!((p[0] - q[0]).hypot(p[2] - q[2]) <= 0.3);
            }
        }
    }
}
