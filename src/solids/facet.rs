//! The facets of a geodesic sphere.

use super::shapes::circle::unit;
use crate::geometry::array::dot;
use crate::geometry::icosahedron;
use crate::geometry::line::Traced;
use crate::geometry::vec::Vec3;
use crate::scene;

/// The corners of the facet through which a direction goes, for a geodesic sphere of radius 1.
pub fn facet<R: Traced>(d: Vec3<R>, splits: u32) -> [Vec3<R>; 3] {
    let mut corners = corners::<R>();
    // The direction goes through the facet of the icosahedron whose corners are the three nearest ones.
    corners.sort_by(|a, b| {
        let order = b.dot(d).partial_cmp(&a.dot(d));
        order.unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut facet = [corners[0], corners[1], corners[2]];
    for _ in 0..splits {
        let [a, b, c] = facet;
        let middle = |p: Vec3<R>, q: Vec3<R>| {
            let sum = p + q;
            sum * sum.dot(sum).sqrt().recip()
        };
        let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
        // Planes through the middle of the sphere separate the four parts.
        let parts = [[a, p, r], [b, q, p], [c, r, q]];
        let through = |[corner, u, v]: &[Vec3<R>; 3]| {
            let n = u.cross(*v);
            n.dot(d) * n.dot(*corner) > R::ZERO
        };
        facet = parts.into_iter().find(through).unwrap_or([p, q, r]);
    }
    facet
}

/// The corners of the icosahedron, as [`icosahedron::vertices`] has them.
fn corners<R: Traced>() -> [Vec3<R>; 12] {
    let phi = (R::ONE + R::of(5.0).sqrt()) / R::of(2.0);
    let short = (R::ONE + phi * phi).sqrt().recip();
    let long = phi * short;
    icosahedron::vertices().map(|v| {
        Vec3(v.map(|x| {
            let size = match x.abs() {
                0.0 => R::ZERO,
                x if x < 0.7 => short,
                _ => long,
            };
            if x < 0.0 { -size } else { size }
        }))
    })
}

/// The corner that is nearest to a direction, for a geodesic sphere of radius 1.
pub fn corner(d: scene::Vec3, splits: u32) -> scene::Vec3 {
    let mut corners = icosahedron::vertices();
    let nearest_first = |a: &scene::Vec3, b: &scene::Vec3| dot(*b, d).total_cmp(&dot(*a, d));
    corners.sort_by(nearest_first);
    // The facet through which the direction goes is found first, then with each split the one of its four parts.
    let first = corners[0];
    let next_to = |a: scene::Vec3, b: &scene::Vec3| dot(a, *b) > 0.4 && dot(a, *b) < 0.9;
    let second = corners.iter().copied().find(|c| next_to(first, c));
    let second = second.unwrap_or(first);
    let third = (corners.iter().copied()).find(|c| next_to(first, c) && next_to(second, c));
    let mut facet = [first, second, third.unwrap_or(second)];
    for _ in 0..splits {
        let [a, b, c] = facet;
        let middle = |p: scene::Vec3, q: scene::Vec3| -> scene::Vec3 {
            unit(std::array::from_fn(|k| p[k] + q[k]))
        };
        let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
        let along = |f: &[scene::Vec3; 3]| -> f64 {
            dot(
                unit(std::array::from_fn(|k| f[0][k] + f[1][k] + f[2][k])),
                d,
            )
        };
        for part in [[a, p, r], [b, q, p], [c, r, q], [p, q, r]] {
            if facet == [a, b, c] || along(&part) > along(&facet) {
                facet = part;
            }
        }
    }
    facet.sort_by(nearest_first);
    facet[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Volume;
    use crate::solids::support::directions;

    /// The corners of the language's icosahedron, and of what it is split into: all at distance 1, the
    /// nearest one no further than half an edge's length away.
    #[test]
    fn corners_of_geodesic_spheres() {
        let phi = (1.0 + 5f64.sqrt()) / 2.0;
        let first = corner([0.1, 1.0, phi], 0);
        let expected = unit([0.0, 1.0, phi]);
        let all_around = Volume::Sphere {
            centre: [0.0; 3],
            radius: 1.0,
        };
        (0..3).for_each(|i| assert!((first[i] - expected[i]).abs() < 1e-15));
        for (splits, near) in [(0, 0.79), (1, 0.93), (2, 0.98), (5, 0.9995)] {
            for d in directions(&all_around) {
                let d = unit([d[0] + 0.1, d[1] + 0.2, d[2] - 0.3]);
                let c = corner(d, splits);
                assert!((dot(c, c) - 1.0).abs() < 1e-12);
                assert!(dot(c, d) > near, "{splits} {d:?} {}", dot(c, d));
            }
        }
    }
}
