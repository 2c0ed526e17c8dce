//! Flush faces: faces of two meshes that lie in one plane, but for rounding. They are put into exactly one plane, and
//! then moved a hair apart.
//!
//! The library decides which of two flush faces is in front by the normals at their corners. Such a normal is made of
//! all faces around the corner, so beside a notch it may decide one way at one corner and another way at the next.

use super::csg::Operation;
use super::shape::DROPPED;
use super::triangle_mesh::Mesh;
use crate::geometry::Matrix;
use crate::geometry::array::{cross, dot, sub};
use crate::scene::Vec3;

/// Coordinates that differ by less than this, in sizes of the operands, are the same. They differ by the rounding of
/// rotations, some tens of roundings.
const ROUNDED: f64 = 1e-14;

/// Planes are the same if their unit normals differ by less than this, and so do their offsets, in sizes of the
/// operands. The normals of narrow triangles are rounded by more than coordinates.
const PLANE_EPS: f64 = 1e-13;

/// Relative distance within which a triangle of a result lies in the plane of a triangle that it was cut from, even
/// if the triangle of the result is narrow.
const CUT: f64 = 1e-9;

/// Two meshes whose flush faces are in exactly one plane.
pub(super) struct Aligned {
    pub a: Mesh,
    pub b: Mesh,
    /// Whether the meshes have flush faces.
    pub shared: bool,
    /// The map from the present coordinates back to the earlier ones, if the meshes were turned.
    pub back: Option<Matrix>,
}

/// Rotates both meshes so that flush faces lie along the axes, and makes coordinates equal that differ by roundings
/// only. `size` is the size of the operands.
pub(super) fn aligned(a: &Mesh, b: &Mesh, size: f64) -> Aligned {
    let (mut a, mut b) = (a.clone(), b.clone());
    let axes = axes(&a, &b, size);
    let mut back = None;
    if let Some(axes) = axes.filter(|axes| !axes.iter().all(is_along)) {
        let mut to = Matrix::IDENTITY;
        let mut from = Matrix::IDENTITY;
        for (i, axis) in axes.iter().enumerate() {
            for (k, x) in axis.iter().enumerate() {
                (to.0[i][k], from.0[k][i]) = (*x, *x);
            }
        }
        a.transform(&to);
        b.transform(&to);
        back = Some(from);
    }
    snap(&mut a, &mut b, ROUNDED * size);
    Aligned {
        a,
        b,
        shared: axes.is_some(),
        back,
    }
}

/// Whether a direction is along an axis, up to rounding.
fn is_along(n: &Vec3) -> bool {
    n.iter().any(|x| x.abs() > 1.0 - 1e-15)
}

/// Three axes at right angles. The first is the normal of the largest face of `a` that is flush with a face of `b`.
/// The second is the normal of the largest such face at right angles to the first; if there is none, of the largest
/// face that need not be flush. `None` if no face is flush.
fn axes(a: &Mesh, b: &Mesh, size: f64) -> Option<[Vec3; 3]> {
    let others = sorted(b, size);
    let shared = |p: &Plane| [*p, p.reversed()].iter().any(|p| p.is_among(&others));
    let largest = |wanted: &dyn Fn(&Plane) -> bool| {
        let planes = planes_of(a, size).map(|(_, p)| p).filter(wanted);
        planes
            .max_by(|p, q| p.area.total_cmp(&q.area))
            .map(|p| p.normal)
    };
    let first = largest(&shared)?;
    let upright = |p: &Plane| dot(p.normal, first).abs() < PLANE_EPS;
    let second = largest(&|p| upright(p) && shared(p))
        .or_else(|| largest(&upright))
        .unwrap_or_else(|| across(first));
    // The second axis is made orthogonal to the first up to rounding.
    let k = dot(first, second);
    let second = sub(second, first.map(|x| k * x));
    let length = dot(second, second).sqrt();
    let second = second.map(|x| x / length);
    Some([first, second, cross(first, second)])
}

/// A unit vector at right angles to `n` and to the coordinate axis that is farthest from the direction of `n`.
fn across(n: Vec3) -> Vec3 {
    let least = (0..3).min_by(|&i, &k| n[i].abs().total_cmp(&n[k].abs()));
    let mut axis = [0.0; 3];
    axis[least.unwrap_or(0)] = 1.0;
    let at = cross(n, axis);
    let length = dot(at, at).sqrt();
    at.map(|x| x / length)
}

/// The plane of a triangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    /// A unit vector.
    normal: Vec3,
    /// The distance of the plane from the origin along the normal, in sizes of the operands.
    offset: f64,
    area: f64,
    /// A number to sort by: planes that are nearly the same have nearly the same keys.
    key: f64,
}

/// The planes of all triangles that have an area, each with the triangle's index.
fn planes_of(mesh: &Mesh, size: f64) -> impl Iterator<Item = (usize, Plane)> {
    (0..mesh.triangles.len()).filter_map(move |t| {
        let [a, b, c] = mesh.corners(t);
        let n = cross(sub(b, a), sub(c, a));
        let area = dot(n, n).sqrt();
        let normal = n.map(|x| x / area);
        let offset = dot(normal, a) / size;
        let plane = Plane {
            normal,
            offset,
            area,
            // The coefficients add up to less than two, so keys of two planes differ by less than twice what their
            // numbers do.
            key: dot(normal, [0.618, 0.277, 0.151]) + 0.414 * offset,
        };
        offset.is_finite().then_some((t, plane))
    })
}

impl Plane {
    fn same(&self, other: &Plane) -> bool {
        self.near(other, PLANE_EPS)
    }

    fn near(&self, other: &Plane, within: f64) -> bool {
        let near = |x: f64, y: f64| (x - y).abs() < within;
        near(self.offset, other.offset) && (0..3).all(|i| near(self.normal[i], other.normal[i]))
    }

    fn reversed(&self) -> Plane {
        Plane {
            normal: self.normal.map(|x| -x),
            offset: -self.offset,
            area: self.area,
            key: -self.key,
        }
    }

    /// Whether the plane is in a list, which is sorted by keys.
    fn is_among(&self, planes: &[Plane]) -> bool {
        let key = self.key;
        let from = planes.partition_point(|p| p.key < key - 2.0 * PLANE_EPS);
        let mut near = planes[from..]
            .iter()
            .take_while(|p| p.key < key + 2.0 * PLANE_EPS);
        near.any(|p| self.same(p))
    }
}

/// Makes coordinates that are within `least` of each other the same, axis by axis.
fn snap(a: &mut Mesh, b: &mut Mesh, least: f64) {
    for axis in 0..3 {
        let points = a.points.iter().chain(&b.points);
        let mut places: Vec<f64> = points.map(|p| p[axis]).collect();
        places.sort_unstable_by(f64::total_cmp);
        let mut from = f64::NEG_INFINITY;
        places.retain(|&x| {
            let new = x - from > least;
            if new {
                from = x;
            }
            new
        });
        for p in a.points.iter_mut().chain(&mut b.points) {
            let next = places.partition_point(|&x| x <= p[axis]);
            if let Some(&place) = next.checked_sub(1).and_then(|i| places.get(i)) {
                p[axis] = place;
            }
        }
    }
}

/// The most planes that are moved: meshes with more flush planes are round.
const MAX_PLANES: usize = 16;

/// The distance that faces are moved, in sizes of the operands: far more than points are rounded, and a
/// hundred-millionth of the default tolerance.
const FACE_REL_SHIFT: f64 = 1e-11;

/// Moves the faces of `b` that are flush with faces of `a` by a hair, so that the operation leaves what is meant:
/// solids that only share a face have no intersection, and no skin is left where a tool ends flush with the solid.
/// Returns the moved `b` and the planes, for [`put_back`]. `None` for a union, and if no plane or too many are to be
/// moved.
pub(super) fn apart(
    a: &Mesh,
    b: &Mesh,
    size: f64,
    operation: Operation,
) -> Option<(Mesh, Vec<Plane>)> {
    let by = match operation {
        Operation::Union => return None,
        Operation::Intersection => -FACE_REL_SHIFT * size,
        Operation::Difference => FACE_REL_SHIFT * size,
    };
    let (of_a, of_b) = (sorted(a, size), sorted(b, size));
    let wanted = |p: &Plane| {
        let (alike, against) = (p.is_among(&of_a), p.reversed().is_among(&of_a));
        let right = match by < 0.0 {
            true => against,
            false => alike && !against,
        };
        right && !p.reversed().is_among(&of_b)
    };
    let planes: Vec<Plane> = of_b.iter().copied().filter(wanted).collect();
    if planes.is_empty() || planes.len() > MAX_PLANES {
        return None;
    }
    let mut on = vec![[false; MAX_PLANES]; b.points.len()];
    for (t, plane) in planes_of(b, size) {
        let Some(k) = planes.iter().position(|p| p.same(&plane)) else {
            continue;
        };
        for corner in b.triangles[t] {
            on[corner as usize][k] = true;
        }
    }
    let mut moved = b.clone();
    for (point, on) in moved.points.iter_mut().zip(on) {
        for (plane, _) in planes.iter().zip(on).filter(|(_, on)| *on) {
            for (x, n) in point.iter_mut().zip(plane.normal) {
                *x += by * n;
            }
        }
    }
    Some((moved, planes))
}

/// Moves points of the result that [`apart`] has moved back into the planes.
pub(super) fn put_back(mesh: &mut Mesh, planes: &[Plane], size: f64) {
    for point in &mut mesh.points {
        for plane in planes {
            let off = dot(plane.normal, *point) - plane.offset * size;
            if off.abs() < 2.0 * FACE_REL_SHIFT * size {
                *point = sub(*point, plane.normal.map(|n| off * n));
            }
        }
    }
}

/// The most comparisons of triangles with others in their planes, in one call.
const MAX_TRIANGLE_COMPARISONS: usize = 4_000_000;

/// Relabels the triangles of `mesh`, a result of `a` and `b`, that lie in a triangle of `a`: where faces are in one
/// place, the first operand's face is seen. Dropped triangles stay dropped. After [`MAX_TRIANGLE_COMPARISONS`], the
/// rest is left as it was.
pub(super) fn first_seen(mesh: &mut Mesh, a: &Mesh, b: &Mesh, size: f64) {
    let both = a.bounds().intersection(&b.bounds());
    let slack = CUT * size;
    let is_shared =
        |p: Vec3| (0..3).all(|i| both.min[i] - slack <= p[i] && p[i] <= both.max[i] + slack);
    let mut planes: Vec<(usize, Plane)> = planes_of(a, size)
        .filter(|(t, _)| a.labels[*t] != DROPPED)
        .collect();
    planes.sort_unstable_by(|(_, p), (_, q)| p.key.total_cmp(&q.key));
    let made: Vec<(usize, Plane)> = planes_of(mesh, size).collect();
    let mut compared = 0;
    for (t, plane) in made {
        let middle = centre(&mesh.corners(t));
        if mesh.labels[t] == DROPPED || !is_shared(middle) {
            continue;
        }
        let key = plane.key;
        let from = planes.partition_point(|(_, p)| p.key < key - 2.0 * CUT);
        let near = planes[from..]
            .iter()
            .take_while(|(_, p)| p.key < key + 2.0 * CUT);
        let mut near = near.inspect(|_| compared += 1);
        if let Some((i, _)) = near.find(|(i, p)| p.near(&plane, CUT) && holds(a, *i, p, middle)) {
            mesh.labels[t] = a.labels[*i];
        }
        if compared > MAX_TRIANGLE_COMPARISONS {
            return;
        }
    }
}

fn centre(corners: &[Vec3; 3]) -> Vec3 {
    std::array::from_fn(|i| corners.iter().map(|p| p[i] / 3.0).sum())
}

/// Whether a point in the plane of triangle `t` lies in the triangle.
fn holds(mesh: &Mesh, t: usize, plane: &Plane, point: Vec3) -> bool {
    let corners = mesh.corners(t);
    (0..3).all(|i| {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        dot(cross(sub(to, from), sub(point, from)), plane.normal) >= 0.0
    })
}

/// The planes of a mesh, each once, in the order of their keys.
fn sorted(mesh: &Mesh, size: f64) -> Vec<Plane> {
    let mut planes: Vec<Plane> = planes_of(mesh, size).map(|(_, p)| p).collect();
    planes.sort_unstable_by(|p, q| p.key.total_cmp(&q.key));
    planes.dedup_by(|p, q| p.same(q));
    planes
}
