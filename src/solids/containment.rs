//! Whether a point is in a shape, in the shape's coordinates.

use super::distance;
use super::facet::facet;
use crate::geometry::array::{cross, dot, sub, unit};
use crate::scene::{Geometry, Vec3};

/// The ball that a geodesic sphere holds, as a share of its circumscribed one: that of the least of all,
/// the icosahedron, and a little less.
pub const HELD_BY_GEODESIC: f64 = 0.79;

/// `None` where that is not known.
pub fn in_shape(geometry: &Geometry, p: Vec3) -> Option<bool> {
    let [x, y, z] = p;
    let square = |v: f64, unit: f64| (v / unit) * (v / unit);
    Some(match geometry {
        Geometry::Revolution { profile, .. } => in_profile(profile, x.hypot(z), y),
        // A surface has no inside, and what it is taken away from stays what it was.
        Geometry::Plane(_) | Geometry::Rectangle { .. } | Geometry::Triangle { .. } => false,
        Geometry::HalfSpace([a, b, c, d]) => a * x + b * y + c * z + d <= 0.0,
        Geometry::Sphere { centre, radius } => distance(p, *centre) <= *radius,
        Geometry::Ellipsoid {
            semi_axes: [a, b, c],
        } => square(x, *a) + square(y, *b) + square(z, *c) <= 1.0,
        Geometry::Box { min, max } => (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i]),
        Geometry::GeodesicSphere { radius, splits } => {
            let away = x.hypot(y).hypot(z);
            match away {
                a if a > *radius => false,
                a if a <= HELD_BY_GEODESIC * radius => true,
                _ => return in_facet(facet(p, *splits), p.map(|x| x / radius)),
            }
        }
        Geometry::Torus { major, minor } => {
            // By the even-odd rule in half a plane through the axis: inside of one of the circles
            // about ±R, not of both.
            let away = x.hypot(z);
            let near = (away - major).hypot(y) <= *minor;
            near != ((away + major).hypot(y) <= *minor)
        }
        Geometry::Quadric(q) => {
            let v = [x, y, z, 1.0];
            let terms: [f64; 16] = std::array::from_fn(|k| q[k] * v[k / 4] * v[k % 4]);
            return at_most_zero(&terms);
        }
        Geometry::Cone { height, radius } => {
            let share = y / height;
            (0.0..=1.0).contains(&share) && x.hypot(z) <= radius * share
        }
        Geometry::DoubleCone { height, radius } => {
            let share = (y / height).abs();
            share <= 1.0 && x.hypot(z) <= radius * share
        }
        Geometry::ParabolicCylinder { a } => square(x, *a) <= y,
        Geometry::HyperbolicCylinder { a, b } => square(x, *a) - square(y, *b) <= 1.0,
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let side = if *sheets == 1 { 1.0 } else { -1.0 };
            square(x, *a) - square(y, *b) + square(z, *c) <= side
        }
        Geometry::HyperbolicParaboloid { a, b } => square(x, *a) - square(z, *b) <= y,
    })
}

/// Whether a sum is at most zero; `None` where rounding may be all that there is of it.
fn at_most_zero(terms: &[f64; 16]) -> Option<bool> {
    // Two roundings in a term, one for each sum.
    const ROUNDED: f64 = 18.0 * f64::EPSILON;
    let value: f64 = terms.iter().sum();
    let size: f64 = terms.iter().map(|t| t.abs()).sum();
    (value == 0.0 || value.abs() > ROUNDED * size).then_some(value <= 0.0)
}

/// Whether a point that is seen from the middle through a facet lies below it, both of the sphere of radius
/// 1.
fn in_facet([a, b, c]: [Vec3; 3], p: Vec3) -> Option<bool> {
    /// More than the corners are rounded by, after any number of splits.
    const ROUNDED: f64 = 1e-13;
    let n = unit(cross(sub(b, a), sub(c, a)))?;
    let out = (dot(n, p) - dot(n, a)) * dot(n, a).signum();
    (out.abs() > ROUNDED).then_some(out < 0.0)
}

/// The even-odd rule for a profile closed over the axis: how many of its pieces are further out at
/// this height. The discs that close it are level and have no height of their own.
pub fn in_profile(profile: &[[f64; 2]], radius: f64, y: f64) -> bool {
    let outside = profile.windows(2).filter(|w| {
        let ([x0, y0], [x1, y1]) = (w[0], w[1]);
        (y0 > y) != (y1 > y) && x0 + (x1 - x0) * ((y - y0) / (y1 - y0)) > radius
    });
    outside.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profiles_by_even_odd() {
        // A cylinder of radius 1, a ring, a cone's profile.
        let cylinder = [[1.0, 0.0], [1.0, 2.0]];
        assert!(in_profile(&cylinder, 0.9, 1.0) && !in_profile(&cylinder, 1.1, 1.0));
        assert!(!in_profile(&cylinder, 0.5, 2.1) && !in_profile(&cylinder, 0.5, -0.1));
        let ring = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        assert!(in_profile(&ring, 1.5, 0.5) && !in_profile(&ring, 0.5, 0.5));
        let cone = [[0.0, 1.0], [1.0, 0.0]];
        assert!(in_profile(&cone, 0.4, 0.5) && !in_profile(&cone, 0.6, 0.5));
    }

    #[test]
    fn shapes() {
        let inside = |g: &Geometry, p| in_shape(g, p);
        let spindle = Geometry::Torus {
            major: 0.5,
            minor: 1.0,
        };
        // The lemon about the axis is outside.
        assert_eq!(inside(&spindle, [0.0, 0.1, 0.0]), Some(false));
        assert_eq!(inside(&spindle, [1.0, 0.1, 0.0]), Some(true));
        let down = Geometry::Cone {
            height: -2.0,
            radius: 1.0,
        };
        assert_eq!(inside(&down, [0.4, -1.0, 0.0]), Some(true));
        assert_eq!(inside(&down, [0.4, 1.0, 0.0]), Some(false));
        let geodesic = Geometry::GeodesicSphere {
            radius: 1.0,
            splits: 0,
        };
        // An edge's middle is 0.85065 away.
        assert_eq!(inside(&geodesic, [0.0, 0.86, 0.0]), Some(false));
        assert_eq!(inside(&geodesic, [0.0, 0.85, 0.0]), Some(true));
    }
}
