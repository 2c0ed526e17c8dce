//! Where the nodes of a scene can be: boxes that are never too small.

use super::model::{Geometry, Node, Scene, Vec3};
use crate::geometry::array::length;
use crate::geometry::{Aabb, Matrix};

/// The bounds of a node, in its own coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeBounds {
    /// Holds every point of the node's solids and surfaces.
    pub all: Aabb,
    /// Holds the parts of the node that are bounded; always finite, empty where there are none.
    pub bounded: Aabb,
}

/// The bounds of every node of the arena, in one pass: children stand before their parents.
pub fn node_bounds(scene: &Scene) -> Vec<NodeBounds> {
    let mut out: Vec<NodeBounds> = Vec::with_capacity(scene.nodes.len());
    // For a node that is one shape, moved: the shape and where it is. Bounding the moved shape
    // itself keeps chains of rotations from blowing its box up.
    let mut moved: Vec<Option<(u32, Matrix)>> = Vec::with_capacity(scene.nodes.len());
    for node in &scene.nodes {
        let of = |id: u32| out[id as usize];
        let (all, bounded, placed) = match *node {
            Node::Shape(shape) => {
                let all = shape_bounds(&scene.shapes[shape as usize].geometry, &Matrix::IDENTITY);
                (all, finite_part(all), Some((shape, Matrix::IDENTITY)))
            }
            Node::Transform { child, matrix } => {
                let m = &scene.matrices[matrix as usize];
                match moved[child as usize] {
                    Some((shape, before)) => {
                        let m = m.after(&before);
                        let all = shape_bounds(&scene.shapes[shape as usize].geometry, &m);
                        (all, finite_part(all), Some((shape, m)))
                    }
                    None => (
                        of(child).all.transformed(m),
                        finite_part(of(child).bounded.transformed(m)),
                        None,
                    ),
                }
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                (of(child).all, of(child).bounded, moved[child as usize])
            }
            Node::Union(a, b) => (
                of(a).all.hull(&of(b).all),
                of(a).bounded.hull(&of(b).bounded),
                None,
            ),
            Node::Intersection(a, b) => {
                let (a, b) = (of(a), of(b));
                let bounded = a
                    .bounded
                    .intersection(&b.all)
                    .hull(&b.bounded.intersection(&a.all));
                (a.all.intersection(&b.all), finite_part(bounded), None)
            }
            Node::Difference(a, _) => (of(a).all, of(a).bounded, None),
            Node::Complement(_) => (Aabb::ALL, Aabb::EMPTY, None),
        };
        out.push(NodeBounds { all, bounded });
        moved.push(placed);
    }
    out
}

fn finite_part(all: Aabb) -> Aabb {
    if all.is_bounded() { all } else { Aabb::EMPTY }
}

/// Profiles longer than this are bounded before they are moved, to keep the work linear.
const LONG_PROFILE: usize = 64;

/// A box around a shape that was moved by an affine matrix.
pub fn shape_bounds(geometry: &Geometry, m: &Matrix) -> Aabb {
    let mut hull = Hull {
        matrix: m,
        out: Aabb::EMPTY,
    };
    match geometry {
        Geometry::Sphere { centre, radius } => hull.ellipsoid(*centre, [*radius; 3]),
        Geometry::Ellipsoid { semi_axes } => hull.ellipsoid([0.0; 3], *semi_axes),
        Geometry::GeodesicSphere { radius, .. } => hull.ellipsoid([0.0; 3], [*radius; 3]),
        Geometry::Torus { major, minor } => hull.torus(*major, *minor),
        Geometry::Box { min, max } => return Aabb::new(*min, *max).transformed(m),
        Geometry::Rectangle { min, max } => {
            return Aabb::new([min[0], min[1], 0.0], [max[0], max[1], 0.0]).transformed(m);
        }
        Geometry::Triangle { vertices, .. } => {
            vertices.iter().for_each(|v| hull.ellipsoid(*v, [0.0; 3]));
        }
        Geometry::Cone { height, radius } => {
            hull.ellipsoid([0.0; 3], [0.0; 3]);
            hull.ring(*height, *radius);
        }
        Geometry::DoubleCone { height, radius } => {
            hull.ring(*height, *radius);
            hull.ring(-*height, *radius);
        }
        Geometry::Revolution { profile, .. } if profile.len() <= LONG_PROFILE => {
            profile.iter().for_each(|p| hull.ring(p[1], p[0]));
        }
        Geometry::Revolution { profile, .. } => {
            let mut local = Hull {
                matrix: &Matrix::IDENTITY,
                out: Aabb::EMPTY,
            };
            profile.iter().for_each(|p| local.ring(p[1], p[0]));
            return local.out.transformed(m);
        }
        Geometry::Plane(p) => return plane_bounds(p, true).transformed(m),
        Geometry::HalfSpace(p) => return plane_bounds(p, false).transformed(m),
        Geometry::Quadric(q) => return quadric_bounds(q).transformed(m),
        Geometry::ParabolicCylinder { .. } => {
            let mut all = Aabb::ALL;
            all.min[1] = 0.0;
            return all.transformed(m);
        }
        Geometry::HyperbolicCylinder { .. }
        | Geometry::Hyperboloid { .. }
        | Geometry::HyperbolicParaboloid { .. } => return Aabb::ALL,
    }
    hull.out
}

/// The convex hull of moved ellipsoids, boxed.
struct Hull<'a> {
    matrix: &'a Matrix,
    out: Aabb,
}

impl Hull<'_> {
    /// An ellipsoid with axes along the coordinate axes: its image reaches |row · diag(axes)| from
    /// the image of its centre.
    fn ellipsoid(&mut self, centre: Vec3, axes: Vec3) {
        self.add(centre, |r| {
            length([r[0] * axes[0], r[1] * axes[1], r[2] * axes[2]])
        });
    }

    /// A circle about the y axis.
    fn ring(&mut self, y: f64, radius: f64) {
        self.ellipsoid([0.0, y, 0.0], [radius, 0.0, radius]);
    }

    /// The Minkowski sum of a circle about the y axis and a ball.
    fn torus(&mut self, major: f64, minor: f64) {
        self.add([0.0; 3], |r| {
            major * libm::hypot(r[0], r[2]) + minor * length([r[0], r[1], r[2]])
        });
    }

    fn add(&mut self, centre: Vec3, reach: impl Fn(&[f64; 4]) -> f64) {
        let c = self.matrix.point(centre);
        let rows = &self.matrix.0;
        let reach: Vec3 = std::array::from_fn(|i| reach(&rows[i]).abs());
        let magnitude: Vec3 = std::array::from_fn(|i| {
            let r = &rows[i];
            (0..3).map(|j| (r[j] * centre[j]).abs()).sum::<f64>() + r[3].abs() + reach[i]
        });
        let around = Aabb::new(
            std::array::from_fn(|i| c[i] - reach[i]),
            std::array::from_fn(|i| c[i] + reach[i]),
        );
        self.out = self.out.hull(&around.padded_by(magnitude));
    }
}

/// A plane or half-space bounds a coordinate only where it is at right angles to that axis.
fn plane_bounds(p: &[f64; 4], surface: bool) -> Aabb {
    let mut all = Aabb::ALL;
    for i in 0..3 {
        if p[i] != 0.0 && (0..3).all(|j| j == i || p[j] == 0.0) {
            let at = -p[3] / p[i];
            if surface || p[i] > 0.0 {
                all.max[i] = at;
            }
            if surface || p[i] < 0.0 {
                all.min[i] = at;
            }
            return all.padded_by([at.abs(); 3]);
        }
    }
    all
}

/// The largest residual of A·A⁻¹ at which the inverse is trusted, and by how much the ellipsoid's
/// half-widths are then grown: their relative error is of the order of the residual.
const TRUSTED_RESIDUAL: f64 = 1e-10;

/// xᵀAx + 2bᵀx + c ≤ 0 with a positive definite A is an ellipsoid about −A⁻¹b whose half-width
/// along axis i is √(k·(A⁻¹)ᵢᵢ), k = bᵀA⁻¹b − c. Every other quadric may be unbounded.
fn quadric_bounds(q: &[f64; 16]) -> Aabb {
    let s = |i: usize, j: usize| q[4 * i + j] / 2.0 + q[4 * j + i] / 2.0;
    let mut a = Matrix::IDENTITY;
    for i in 0..3 {
        for j in 0..3 {
            a.0[i][j] = s(i, j);
        }
    }
    let minor = s(0, 0) * s(1, 1) - s(0, 1) * s(0, 1);
    if !(s(0, 0) > 0.0 && minor > 0.0 && a.determinant3() > 0.0) {
        return Aabb::ALL;
    }
    let Some(inverse) = a.inverse() else {
        return Aabb::ALL;
    };
    let product = a.after(&inverse);
    let residual = (0..9)
        .map(|k| (product.0[k / 3][k % 3] - Matrix::IDENTITY.0[k / 3][k % 3]).abs())
        .fold(0.0, f64::max);
    let b = [s(0, 3), s(1, 3), s(2, 3)];
    let centre = inverse.vector(b).map(|x| -x);
    let terms: Vec3 = std::array::from_fn(|i| -b[i] * centre[i]);
    let k = terms.iter().sum::<f64>() - s(3, 3);
    let magnitude = terms.iter().map(|t| t.abs()).sum::<f64>() + s(3, 3).abs();
    let k = k + TRUSTED_RESIDUAL * magnitude;
    let trusted = residual < TRUSTED_RESIDUAL;
    if !trusted || !k.is_finite() || (0..3).any(|i| inverse.0[i][i] <= 0.0) {
        return Aabb::ALL;
    }
    if k < 0.0 {
        return Aabb::EMPTY;
    }
    let reach: Vec3 = std::array::from_fn(|i| {
        (k * inverse.0[i][i]).sqrt() * (1.0 + TRUSTED_RESIDUAL) + TRUSTED_RESIDUAL * centre[i].abs()
    });
    Aabb::new(
        std::array::from_fn(|i| centre[i] - reach[i]),
        std::array::from_fn(|i| centre[i] + reach[i]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Vec3, b: Vec3) -> bool {
        (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6)
    }

    #[test]
    fn a_turned_sphere_keeps_its_box() {
        let m = Matrix::rotation(45.0, 2).after(&Matrix::rotation(30.0, 0));
        let sphere = Geometry::Sphere {
            centre: [0.0; 3],
            radius: 2.0,
        };
        let b = shape_bounds(&sphere, &m);
        assert!(near(b.min, [-2.0; 3]) && near(b.max, [2.0; 3]));
        assert!(b.max[0] >= 2.0);
    }

    #[test]
    fn torus_and_cone() {
        let m = Matrix::rotation(90.0, 0);
        let torus = Geometry::Torus {
            major: 3.0,
            minor: 1.0,
        };
        assert!(near(shape_bounds(&torus, &m).max, [4.0, 4.0, 1.0]));
        let cone = Geometry::Cone {
            height: -2.0,
            radius: 1.0,
        };
        let b = shape_bounds(&cone, &Matrix::IDENTITY);
        assert!(near(b.min, [-1.0, -2.0, -1.0]) && near(b.max, [1.0, 0.0, 1.0]));
    }

    #[test]
    fn an_ellipsoid_among_the_quadrics() {
        // (x − 1)² + 4y² + z² − 4 ≤ 0.
        let q = [
            1.0, 0.0, 0.0, -1.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, -3.0,
        ];
        let b = quadric_bounds(&q);
        assert!(near(b.min, [-1.0, -1.0, -2.0]) && near(b.max, [3.0, 1.0, 2.0]));
        assert_eq!(quadric_bounds(&q.map(|x| -x)), Aabb::ALL);
    }

    #[test]
    fn unbounded_parts_do_not_count() {
        use crate::diagnostics::Span;
        use crate::scene::Shape;
        use crate::syntax::table::RecordType;
        let shape = |geometry, code| Shape {
            id: 2,
            ty: RecordType::by_code(code).unwrap(),
            span: Span::default(),
            geometry,
        };
        let scene = Scene {
            shapes: vec![
                shape(Geometry::Plane([0.0, 1.0, 0.0, 0.0]), 3),
                shape(
                    Geometry::Sphere {
                        centre: [1.0, 0.0, 0.0],
                        radius: 1.0,
                    },
                    11,
                ),
            ],
            nodes: vec![
                Node::Shape(0),
                Node::Shape(1),
                Node::Union(0, 1),
                Node::Complement(1),
                Node::Intersection(2, 3),
            ],
            ..Scene::default()
        };
        let b = node_bounds(&scene);
        assert!(near(b[2].bounded.min, [0.0, -1.0, -1.0]));
        assert!(!b[2].all.is_finite());
        assert!(near(b[4].bounded.max, [2.0, 1.0, 1.0]));
        assert!(b[3].bounded.is_empty());
    }
}
