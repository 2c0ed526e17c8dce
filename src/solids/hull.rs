//! Convex hulls of shapes, from outside: a few points whose hull holds all of a shape.

use super::shapes::revolution::MAX_EXAMINED_POINTS;
use super::shapes::{AnyShape, circle};
use crate::scene::{Geometry, Vec3};

/// Points whose convex hull holds the ball of radius 1 at the origin.
pub fn ball_hull() -> Vec<Vec3> {
    /// The number of corners of the polygon around a half circle from pole to pole.
    const HALF: usize = 12;
    let step = std::f64::consts::PI / HALF as f64;
    let reach = 1.0 / (step / 2.0).cos();
    let rims = (0..HALF).flat_map(|i| {
        let (x, y) = (step * (i as f64 + 0.5)).sin_cos();
        circle::around(reach * x, reach * y)
    });
    rims.collect()
}

impl Geometry {
    /// Points whose convex hull holds all of the shape: its corners, and those of polygons around its circles. `None`
    /// for shapes that have none, or for which a ball or a box serves as well.
    pub fn hull(&self) -> Option<Vec<Vec3>> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                let mut out: Vec<Vec3> = circle::around(s.radius, s.height).collect();
                match s.double {
                    true => out.extend(circle::around(s.radius, -s.height)),
                    false => out.push([0.0; 3]),
                }
                Some(out)
            }
            AnyShape::Cuboid(s) => Some((0..8).map(|k| s.corner(k)).collect()),
            AnyShape::Revolution(s) => {
                if s.profile.len() > MAX_EXAMINED_POINTS {
                    return None;
                }
                let rims = s.profile.iter();
                Some(rims.flat_map(|p| circle::around(p[0], p[1])).collect())
            }
            AnyShape::Torus(s) => {
                let out = s.major + s.minor;
                let rims = [s.minor, -s.minor].into_iter();
                Some(rims.flat_map(|y| circle::around(out, y)).collect())
            }
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Triangle(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::{Aabb, Matrix};
    use crate::solids::shapes::facts::Facts;
    use crate::testing::solids;

    /// In every direction the hull goes at least as far as the shape, whose box is exact.
    #[test]
    fn hulls_hold_their_shapes() {
        let hulls: Vec<_> = (solids().into_iter())
            .filter_map(|g| Some((g.hull()?, g)))
            .collect();
        assert_eq!(hulls.len(), 6);
        for (i, (points, g)) in hulls.iter().enumerate() {
            let turn = 23.0 * i as f64;
            let m = Matrix::rotation(turn, 0).after(&Matrix::rotation(turn + 5.0, 2));
            let around = points.iter().fold(Aabb::EMPTY, |b, p| {
                let p = m.point(*p);
                b.hull(&Aabb::new(p, p))
            });
            let own = g.bounds(&m);
            for k in 0..3 {
                let slack = 1e-12;
                assert!(around.min[k] <= own.min[k] + slack && own.max[k] <= around.max[k] + slack);
            }
        }
    }
}
