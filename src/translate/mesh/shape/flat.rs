//! Shapes with flat faces.

use super::super::triangle_mesh::Mesh;
use crate::geometry::Aabb;
use crate::geometry::array::{cross, dot, length, sub};
use crate::scene::Vec3;

/// A box between two corners.
pub fn cuboid(min: Vec3, max: Vec3) -> Mesh {
    let mut mesh = Mesh::default();
    for corner in 0..8 {
        let side = |axis: usize| {
            if corner >> axis & 1 == 0 {
                min[axis]
            } else {
                max[axis]
            }
        };
        mesh.point([side(0), side(1), side(2)]);
    }
    for quad in [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ] {
        mesh.quad(quad);
    }
    mesh
}

/// The part of ax + by + cz + d ≤ 0 near a region, as a box that stands on the plane. `Err` if the plane misses the
/// region: then the flag says whether the region lies in the half-space.
pub fn half_space([a, b, c, d]: [f64; 4], region: &Aabb) -> Result<Mesh, bool> {
    let largest = a.abs().max(b.abs()).max(c.abs());
    if largest == 0.0 {
        return Err(d <= 0.0);
    }
    let n = [a, b, c].map(|x| x / largest);
    let length = dot(n, n).sqrt();
    let (n, d) = (n.map(|x| x / length), d / largest / length);
    let (centre, radius) = (region.centre(), region.radius());
    let height = dot(n, centre) + d;
    if height.abs() > radius {
        return Err(height < 0.0);
    }
    let foot: Vec3 = std::array::from_fn(|i| centre[i] - height * n[i]);
    let reach = 1.05 * radius;
    let u = any_normal_to(n).map(|x| x * reach);
    let v = normal_to(n, u).map(|x| x * reach);
    let face = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[s, t]| std::array::from_fn(|i| foot[i] + s * u[i] + t * v[i]));
    Ok(slab(&face, n.map(|x| -2.0 * reach * x), true))
}

/// A flat convex face, extruded by `by`; the face is seen against that direction. Its triangles come first. With
/// `all`, every triangle is labelled 0; without, all but the face's are labelled [`super::DROPPED`].
pub fn slab(face: &[Vec3], by: Vec3, all: bool) -> Mesh {
    let mut mesh = Mesh::default();
    let n = face.len() as u32;
    for p in face {
        mesh.point(*p);
    }
    for p in face {
        mesh.point(std::array::from_fn(|i| p[i] + by[i]));
    }
    for i in 1..n - 1 {
        mesh.triangle([0, i, i + 1]);
    }
    let kept = mesh.triangles.len();
    for i in 1..n - 1 {
        mesh.triangle([n, n + i + 1, n + i]);
    }
    for i in 0..n {
        let j = (i + 1) % n;
        mesh.quad([j, i, n + i, n + j]);
    }
    if !all {
        mesh.labels[kept..].fill(super::DROPPED);
    }
    mesh
}

/// A flat surface as a slab behind it, so that it can be cut like a solid. `None` for a face without area.
pub fn surface(face: &[Vec3]) -> Option<Mesh> {
    let [a, b, c] = [face.first()?, face.get(1)?, face.get(2)?];
    let (e, f) = (sub(*b, *a), sub(*c, *a));
    let n = cross(e, f);
    let length = length(n);
    let size = dot(e, e).max(dot(f, f)).sqrt();
    // A face whose area is only a rounding of the cross product shows nothing.
    (length > 1e-12 * size * size).then(|| slab(face, n.map(|x| -x / length * size / 8.0), false))
}

/// A unit vector at right angles to `a` and `b`.
pub fn normal_to(a: Vec3, b: Vec3) -> Vec3 {
    unit(cross(unit(a), unit(b)))
}

/// A unit vector at right angles to `a`.
pub fn any_normal_to(a: Vec3) -> Vec3 {
    let least = (0..3).fold(0, |m, i| if a[i].abs() < a[m].abs() { i } else { m });
    let mut other = [0.0; 3];
    other[least] = 1.0;
    normal_to(a, other)
}

fn unit(v: Vec3) -> Vec3 {
    let length = length(v);
    if length > 0.0 {
        v.map(|x| x / length)
    } else {
        [0.0; 3]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_and_slabs_are_closed() {
        let mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
        assert!(mesh.is_closed());
        assert_eq!(mesh.volume(), 6.0);
        let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = slab(&face, [0.0, 0.0, -2.0], true);
        assert!(mesh.is_closed());
        assert!((mesh.volume() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_half_space_fills_its_side_of_the_region() {
        let region = Aabb::new([-1.0; 3], [1.0; 3]);
        let mesh = half_space([0.0, 2.0, 0.0, -1.0], &region).unwrap();
        assert!(mesh.is_closed() && mesh.volume() > 0.0);
        let bounds = mesh.bounds();
        assert_eq!(bounds.max[1], 0.5);
        assert!(bounds.min[1] < -1.0 && bounds.min[0] < -1.0 && bounds.max[2] > 1.0);
        assert_eq!(half_space([0.0, 1.0, 0.0, 5.0], &region), Err(false));
        assert_eq!(half_space([0.0, 1.0, 0.0, -5.0], &region), Err(true));
    }
}
