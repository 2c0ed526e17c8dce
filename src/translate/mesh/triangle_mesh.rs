//! Triangles with shared points.

use std::collections::HashMap;

use super::union_find::UnionFind;
use crate::geometry::array::{cross, dot, sub};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;

/// Triangles with shared points. Corners run counter-clockwise as seen from outside. Each triangle has a label: a
/// number that stands for what the triangle shows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    pub points: Vec<Vec3>,
    /// Indices into `points`.
    pub triangles: Vec<[u32; 3]>,
    /// Labels of the triangles, beside `triangles`.
    pub labels: Vec<u32>,
}

impl Mesh {
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Adds a point and returns its index.
    pub fn point(&mut self, p: Vec3) -> u32 {
        self.points.push(p);
        self.points.len() as u32 - 1
    }

    /// Adds a triangle labelled 0. Does nothing if two of the corners are the same point.
    pub fn triangle(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners;
        if a != b && b != c && c != a {
            self.triangles.push(corners);
            self.labels.push(0);
        }
    }

    /// Adds a quadrilateral as two triangles.
    pub fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// The places of a triangle's corners.
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|i| self.points[i as usize])
    }

    pub fn bounds(&self) -> Aabb {
        let mut out = Aabb::EMPTY;
        for p in &self.points {
            out.min = std::array::from_fn(|i| out.min[i].min(p[i]));
            out.max = std::array::from_fn(|i| out.max[i].max(p[i]));
        }
        out
    }

    /// The volume that a closed mesh surrounds; negative if the mesh is inside out.
    pub fn volume(&self) -> f64 {
        let bounds = self.bounds();
        if bounds.is_empty() {
            return 0.0;
        }
        // Volumes are reckoned from the mesh's centre: far from the origin, large terms would cancel and lose digits.
        let from = bounds.centre();
        let six: f64 = (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t).map(|p| sub(p, from));
                dot(a, cross(b, c))
            })
            .sum();
        six / 6.0
    }

    /// Maps all points. If the map mirrors, all triangles are reversed as well, so that their outsides stay outside.
    pub fn transform(&mut self, m: &Matrix) {
        for p in &mut self.points {
            *p = m.point(*p);
        }
        if m.determinant3() < 0.0 {
            self.flip();
        }
    }

    /// Reverses all triangles, so that inside and outside are exchanged.
    pub fn flip(&mut self) {
        for t in &mut self.triangles {
            t.swap(1, 2);
        }
    }

    pub fn append(&mut self, other: &Mesh) {
        let offset = self.points.len() as u32;
        self.points.extend_from_slice(&other.points);
        let moved = other.triangles.iter().map(|t| t.map(|i| i + offset));
        self.triangles.extend(moved);
        self.labels.extend_from_slice(&other.labels);
    }

    pub fn label_all(&mut self, label: u32) {
        self.labels.fill(label);
    }

    /// The triangles whose label is wanted, with the points they need.
    pub fn only(&self, wanted: impl Fn(u32) -> bool) -> Mesh {
        const NONE: u32 = u32::MAX;
        let mut out = Mesh::default();
        let mut numbers = vec![NONE; self.points.len()];
        for (t, &label) in self.triangles.iter().zip(&self.labels) {
            if !wanted(label) {
                continue;
            }
            let corners = t.map(|i| {
                let number = &mut numbers[i as usize];
                if *number == NONE {
                    *number = out.point(self.points[i as usize]);
                }
                *number
            });
            out.triangles.push(corners);
            out.labels.push(label);
        }
        out
    }

    /// Drops connected parts whose volume is less than `thickness` times their surface area.
    pub fn drop_thin(&mut self, thickness: f64) {
        let mut sets = UnionFind::new(self.points.len());
        for &[a, b, c] in &self.triangles {
            sets.join(a, b);
            sets.join(b, c);
        }
        // For each part its first point, its volume (reckoned from that point) and its area.
        let mut sizes: HashMap<u32, (Vec3, f64, f64)> = HashMap::new();
        for (t, corners) in self.triangles.iter().enumerate() {
            let [a, b, c] = self.corners(t);
            let size = sizes.entry(sets.find(corners[0])).or_insert((a, 0.0, 0.0));
            let n = cross(sub(b, a), sub(c, a));
            size.1 += dot(n, sub(a, size.0)) / 6.0;
            size.2 += dot(n, n).sqrt() / 2.0;
        }
        let thin = |i: u32| {
            let (_, volume, area) = sizes[&i];
            volume.abs() < thickness * area
        };
        if sizes.keys().any(|&i| thin(i)) {
            let kept: Vec<bool> = self
                .triangles
                .iter()
                .map(|t| !thin(sets.find(t[0])))
                .collect();
            let mut all = std::mem::take(self);
            let labels = std::mem::take(&mut all.labels);
            all.labels = kept.iter().map(|&k| u32::from(k)).collect();
            *self = all.only(|k| k == 1);
            let kept = labels.into_iter().zip(kept).filter(|(_, k)| *k);
            self.labels = kept.map(|(l, _)| l).collect();
        }
    }

    /// Whether every edge belongs to two triangles that pass it in opposite directions.
    pub fn is_closed(&self) -> bool {
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(3 * self.triangles.len());
        for t in &self.triangles {
            edges.extend((0..3).map(|i| [t[i], t[(i + 1) % 3]]));
        }
        edges.sort_unstable();
        let once = edges.windows(2).all(|w| w[0] != w[1]);
        once && edges
            .iter()
            .all(|&[a, b]| edges.binary_search(&[b, a]).is_ok())
    }
}
