//! A few points whose convex hull holds a round shape.

use crate::geometry::array::each;
use crate::geometry::icosahedron;
use crate::geometry::vec::Vec3;
use std::f64::consts::FRAC_PI_4;

/// The corners of an octagon around a circle are so many times as far out: 1 / cos 22.5°, rounded up.
const AROUND_CIRCLE: f64 = 1.0824;
/// The corners of an icosahedron around a ball are so many times as far out: √(15 − 6√5), rounded up.
const AROUND_BALL: f64 = 1.2585;

/// Around circles about the y axis, of these radii at these heights.
pub(super) fn of_circles<const N: usize>(circles: [[f64; 2]; N]) -> Vec<[f64; 3]> {
    let sides: [(f64, f64); 8] = std::array::from_fn(|i| libm::sincos(i as f64 * FRAC_PI_4));
    let around = |[radius, y]: [f64; 2]| {
        let out = radius * AROUND_CIRCLE;
        each(sides, |(sin, cos)| [out * cos, y, out * sin])
    };
    circles.into_iter().flat_map(around).collect()
}

/// Around an ellipsoid with axes along the coordinate axes.
pub(super) fn of_ellipsoid(centre: Vec3, semi_axes: Vec3) -> Vec<[f64; 3]> {
    let corners = icosahedron::vertices().into_iter();
    corners
        .map(|v| (centre + semi_axes.times(Vec3(v)) * AROUND_BALL).0)
        .collect()
}

#[cfg(test)]
mod tests {
    use crate::geometry::array::dot;
    use crate::scene::{Geometry, TriangleNormals};
    use crate::solids::shapes::facts::Facts;
    use crate::testing::{random, solids};
    use crate::trace::shapes::Primitive;

    /// Geometries that are no usual solid.
    fn others() -> [Geometry; 4] {
        [
            Geometry::Rectangle {
                min: [-1.0, 0.0],
                max: [3.0, 0.5],
            },
            Geometry::Triangle {
                vertices: Box::new([[1.0, 0.0, 2.0], [0.0, 3.0, 1.0], [-1.0, 0.5, 0.0]]),
                normals: TriangleNormals::Flat,
            },
            Geometry::GeodesicSphere {
                radius: 2.0,
                splits: 2,
            },
            Geometry::Torus {
                major: 0.5,
                minor: 2.0,
            },
        ]
    }

    /// In every direction the points go at least as far as the shape, and at most half of its width farther.
    #[test]
    fn shapes_are_between_their_hull_points() {
        let mut next = random();
        let mut number = || next(2_000_001) as f64 / 1e6 - 1.0;
        for geometry in solids().into_iter().chain(others()) {
            let points = Primitive::new(&geometry).shape().hull_points();
            let mut most = 0.0f64;
            for _ in 0..20_000 {
                let d = [number(), number(), number()];
                let reach = |d| dot(geometry.support(d).expect("it ends").point, d);
                let far = reach(d);
                let width = far + reach(d.map(|x| -x));
                let out = points.iter().map(|c| dot(*c, d)).fold(f64::MIN, f64::max);
                assert!(out >= far - 1e-12, "{geometry:?} {d:?} {out} {far}");
                most = most.max((out - far) / width);
            }
            assert!(most < 0.5, "{geometry:?} {most}");
        }
    }
}
