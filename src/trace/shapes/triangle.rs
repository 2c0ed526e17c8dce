//! The triangle, a surface without inside.

use super::facet::{Facet, Shear, drift_across, lift, narrow};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::exponent::{exponent, shifted};
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::scene::TriangleNormals;
use crate::trace::shapes::support::Support;

#[derive(Debug, Clone, PartialEq)]
pub struct Triangle {
    vertices: [Vec3; 3],
    normals: TriangleNormals,
    /// The unit normal; `None` where the vertices lie on one line.
    normal: Option<Vec3<Dd>>,
    /// The largest coordinate of a vertex, by size.
    reach: f64,
}

/// A triangle as a line sees it, in the sheared space.
struct View<R> {
    facet: Facet<R>,
    /// Bound on the error of its projected coordinates.
    noise: R,
    /// The depth gained while t grows by 1.
    pace: R,
}

impl Triangle {
    pub fn new(vertices: [[f64; 3]; 3], normals: TriangleNormals) -> Triangle {
        let vertices = vertices.map(Vec3::from);
        Triangle {
            vertices,
            normals,
            normal: normal(vertices),
            reach: vertices
                .iter()
                .fold(0.0, |reach, v| v.abs().max_component().max(reach)),
        }
    }

    pub fn vertices(&self) -> [Vec3; 3] {
        self.vertices
    }

    /// The unit normal, rounded; `None` where the vertices lie on one line.
    pub fn normal(&self) -> Option<Vec3> {
        self.normal.map(|n| Vec3(each(n.0, narrow)))
    }

    /// Projects the triangle along the line. The projection is scaled by a power of two where its products could leave
    /// the range of the numbers: that is exact, and does not change the sign of an edge function.
    ///
    /// The line's origin is not moved: neighbouring triangles share edges, and their decisions must not depend on one
    /// triangle alone. Moving the origin would not help either, since it rounds as much as v − o does.
    fn view<R: Traced>(&self, line: &Line<R>) -> View<R> {
        let shear = Shear::along(line.direction);
        let offsets = each(self.vertices, |v| lift::<R>(v) - line.origin);
        let mut corners = each(offsets, |p| shear.project(p));
        let sum = |p: Vec3<R>| p[0].abs() + p[1].abs() + p[2].abs();
        let size = sum(offsets[0]).max(sum(offsets[1])).max(sum(offsets[2]));
        let mut scale = R::ONE;
        let widest = corners
            .iter()
            .fold(R::ZERO, |m, c| m.max(c.x.abs()).max(c.y.abs()))
            .to_f64();
        // Products of two such numbers, and their rounding errors, are normal even in f32.
        const COMFORTABLE: std::ops::Range<f64> = 1.0 / 4294967296.0..4294967296.0;
        if widest > 0.0 && widest.is_finite() && !COMFORTABLE.contains(&widest) {
            // The scaling takes two steps, as the factor for a subnormal number is itself out of range.
            let half = shifted(R::ONE, -exponent(widest) / 2);
            for c in &mut corners {
                c.x = c.x * half * half;
                c.y = c.y * half * half;
            }
            scale = half;
        }
        // Below this, what the projection rounds is no longer in proportion: products leave the
        // normal numbers, even those of the parts of a double-double number.
        const MIN_SIZE: f64 = 1e-280;
        let noise = if size >= R::of(MIN_SIZE) {
            // One rounding of v − o, one of the slope, of the product and of the difference.
            R::gamma(4) * size + drift_across(line, R::of(self.reach))
        } else {
            R::INFINITY
        };
        View {
            facet: Facet::new(corners),
            noise: noise * scale * scale,
            pace: shear.pace,
        }
    }

    /// The barycentric weights of the vertices at a point of the triangle.
    fn weights(&self, point: Vec3) -> [f64; 3] {
        const CENTRE: [f64; 3] = [1.0 / 3.0; 3];
        let Some(n) = self.normal else {
            return CENTRE;
        };
        // Seen along the normal's longest axis, where the triangle is at its largest; edges are
        // scaled so that no product leaves the range of doubles.
        let n: Vec3 = Vec3(each(n.0, narrow));
        let z = (0..3).fold(0, |z, i| if n[i].abs() > n[z].abs() { i } else { z });
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let [a, b, c] = self.vertices;
        let (ab, ac) = (b * 0.5 - a * 0.5, c * 0.5 - a * 0.5);
        let size = ab.abs().max_component().max(ac.abs().max_component());
        let [ab, ac, ap] = each([ab, ac, point * 0.5 - a * 0.5], |e| e / size);
        let area = |p: Vec3, q: Vec3| f64::difference_of_products(p[x], q[y], p[y], q[x]);
        let whole = area(ab, ac);
        let (second, third) = (area(ap, ac) / whole, area(ab, ap) / whole);
        if second.is_nan() || third.is_nan() {
            return CENTRE;
        }
        let second = second.clamp(0.0, 1.0);
        let third = third.clamp(0.0, 1.0 - second);
        [1.0 - second - third, second, third]
    }
}

/// The unit normal around which the vertices run counter-clockwise. `None` if the vertices are so close to one line
/// that even 32 digits cannot tell them from points of the line.
fn normal([a, b, c]: [Vec3; 3]) -> Option<Vec3<Dd>> {
    // Halved first, so that the difference of finite vertices is finite.
    let half = |v: Vec3| lift::<Dd>(v * 0.5);
    let scaled = |e: Vec3<Dd>| {
        let size = e.abs().max_component();
        (size > Dd::ZERO).then(|| e / size)
    };
    let (p, q) = (scaled(half(b) - half(a))?, scaled(half(c) - half(a))?);
    let cross = p.cross(q);
    // Components up to 1, each off by a subtraction and a division: their products and the
    // difference of two of these add up to γ₈ · 2.
    let told = Dd::of(2.0) * Dd::gamma(8);
    (cross.abs().max_component() > told).then(|| cross.unit())
}

impl Shape for Triangle {
    fn bounds(&self) -> Aabb {
        self.vertices
            .iter()
            .fold(Aabb::EMPTY, |b, &v| b.hull(&Aabb::new(v, v)))
            .padded()
    }

    /// The barycentric weights of the second and the third vertex.
    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let [_, u, v] = self.weights(point);
        [u, v]
    }

    fn shading_normal(&self, point: Vec3, _: u32) -> Option<Vec3> {
        match &self.normals {
            TriangleNormals::Flat => None,
            TriangleNormals::One(n) => Some(Vec3::from(*n)),
            TriangleNormals::PerVertex(n) => {
                let n = n.map(Vec3::from);
                let size = n
                    .iter()
                    .fold(0.0, |m: f64, n| m.max(n.abs().max_component()));
                let w = self.weights(point);
                Some((0..3).fold(Vec3::ZERO, |sum, i| sum + n[i] / size * w[i]))
            }
        }
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn support(&self, _: u32) -> Option<Support> {
        None
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.vertices.iter().flat_map(|v| v.0).for_each(&mut *sink);
        match &self.normals {
            TriangleNormals::Flat => {}
            TriangleNormals::One(n) => n.iter().copied().for_each(&mut *sink),
            TriangleNormals::PerVertex(n) => n.iter().flatten().copied().for_each(&mut *sink),
        }
    }
}

impl<R: Traced> Intersect<R> for Triangle {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        if self.normal.is_none() {
            return;
        }
        let view = self.view(line);
        let verdicts = view.facet.verdicts(view.noise);
        roots.uncertain =
            verdicts.iter().any(|v| v.possible) && !verdicts.iter().any(|v| v.certain);
        if let Some(passage) = view.facet.passage() {
            let t = passage.depth / view.pace;
            if t.is_finite() {
                roots.push(t, 0);
            } else {
                roots.uncertain = true;
            }
        }
    }

    /// The line's point, moved along the normal into the triangle's plane, also if the line runs nearly along the
    /// plane. The error is the rounding of the point's distance from the plane through the first vertex, γ₆
    /// Σ|nᵢ|(|pᵢ| + |aᵢ|) with the rounding of the normal, and the rounding of the point itself.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let normal = match self.normal {
            Some(n) => Vec3(each(n.0, narrow)),
            None => Vec3::new(R::ZERO, R::ZERO, R::ONE),
        };
        let (p, a) = (line.at(root.t), lift::<R>(self.vertices[0]));
        let point = p - normal * normal.dot(p - a);
        let noise = R::gamma(6) * normal.abs().dot(p.abs() + a.abs());
        Located {
            point,
            error: normal.abs() * noise + point.abs() * R::ROUNDOFF,
            normal,
        }
    }
}

#[cfg(test)]
mod tests;
