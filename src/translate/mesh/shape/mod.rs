//! Each shape of the language as closed meshes, in its own coordinates.

pub mod flat;
mod profile;
mod quadric;
mod sphere;
mod turned;

pub use quadric::eigen;

use super::budget::{Budget, TooMany};
use super::triangle_mesh::Mesh;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Geometry;
use crate::syntax::table::ShapeKind;
use std::f64::consts::TAU;
use turned::{Profile, sides, turned};

/// The label of triangles that only close a mesh so that it can be cut, and are not part of the result.
pub const DROPPED: u32 = u32::MAX;

/// A solid as meshes.
#[derive(Debug)]
pub struct Solid {
    /// Closed meshes that lie apart from each other, or touch in single points.
    pub meshes: Vec<Mesh>,
    /// Whether the solid is the space outside of the meshes.
    pub outside: bool,
    /// Whether the meshes are all of the shape: the region cut nothing off.
    pub bounded: bool,
}

impl Solid {
    fn of(mesh: Mesh) -> Solid {
        Solid {
            meshes: vec![mesh],
            outside: false,
            bounded: true,
        }
    }

    fn nothing() -> Solid {
        Solid {
            meshes: Vec::new(),
            outside: false,
            bounded: true,
        }
    }

    /// The solid of all space; with `outside`, the empty one.
    fn everything(outside: bool) -> Solid {
        Solid {
            outside: !outside,
            ..Solid::nothing()
        }
    }
}

/// Approximates a shape by triangles that are nowhere farther from its surface than `tolerance`. Shapes without end
/// reach beyond `region`, a finite box. A surface becomes a slab behind it; all triangles but those of the surface
/// itself are labelled [`DROPPED`].
pub fn tessellate(
    geometry: &Geometry,
    tolerance: f64,
    region: &Aabb,
    budget: &mut Budget,
) -> Result<Solid, TooMany> {
    let q = |entries: &[(usize, f64)]| {
        let mut q = [0.0; 16];
        for &(i, x) in entries {
            q[i] = x;
        }
        q
    };
    let squared = |a: f64| 1.0 / (a * a);
    let quadric = |entries: &[(usize, f64)], budget: &mut Budget| {
        quadric::quadric(&q(entries), tolerance, region, budget)
    };
    match *geometry {
        Geometry::Sphere { centre, radius } => ball(centre, [radius; 3], tolerance, budget),
        Geometry::Ellipsoid { semi_axes } => ball([0.0; 3], semi_axes, tolerance, budget),
        Geometry::GeodesicSphere { radius, splits } => {
            let mut mesh = sphere::geodesic(splits, budget)?;
            mesh.transform(&Matrix::scaling(radius, radius, radius));
            Ok(Solid::of(mesh))
        }
        Geometry::Box { min, max } => {
            if (0..3).any(|i| min[i] >= max[i]) {
                return Ok(Solid::nothing());
            }
            budget.spend(12.0)?;
            Ok(Solid::of(flat::cuboid(min, max)))
        }
        Geometry::Torus { major, minor } => {
            // The tube of a thin torus is made finer than the tolerance, so that it is still round.
            let half = (tolerance / 2.0).min(minor / 20.0);
            let around = sides(major + minor, half);
            let n = sides(minor, half);
            budget.spend(n)?;
            let profiles = ring_profiles(major, minor, n as usize);
            Ok(Solid::of(turned(&profiles, around, budget)?))
        }
        Geometry::Cone { height, radius } => {
            let point = [0.0, 0.0];
            let (rim, foot) = ([radius, height], [0.0, height]);
            let points = if height > 0.0 {
                vec![point, rim, foot]
            } else {
                vec![foot, rim, point]
            };
            lathe(vec![open(points)], tolerance, budget)
        }
        Geometry::DoubleCone { height, radius } => {
            let [low, high] = [-height, height].map(|y| ([radius, y], [0.0, y]));
            let profiles = vec![
                open(vec![[0.0, 0.0], high.0, high.1]),
                open(vec![low.1, low.0, [0.0, 0.0]]),
            ];
            lathe(profiles, tolerance, budget)
        }
        Geometry::Revolution { ref profile, .. } => {
            budget.spend(2.0 * profile.len() as f64)?;
            lathe(profile::simple(profile), tolerance, budget)
        }
        Geometry::HalfSpace(abcd) => {
            budget.spend(12.0)?;
            let meshes = match flat::half_space(abcd, region) {
                Ok(mesh) => vec![mesh],
                Err(true) => return Ok(Solid::everything(false)),
                Err(false) => Vec::new(),
            };
            Ok(Solid {
                meshes,
                outside: false,
                bounded: false,
            })
        }
        Geometry::Plane(abcd) => {
            budget.spend(12.0)?;
            let mut meshes = Vec::new();
            if let Ok(mut mesh) = flat::half_space(abcd, region) {
                mesh.labels[2..].fill(DROPPED);
                meshes.push(mesh);
            }
            Ok(Solid {
                meshes,
                outside: false,
                bounded: false,
            })
        }
        Geometry::Rectangle { min, max } => {
            budget.spend(12.0)?;
            let face = [
                [min[0], min[1], 0.0],
                [max[0], min[1], 0.0],
                [max[0], max[1], 0.0],
                [min[0], max[1], 0.0],
            ];
            Ok(flat::surface(&face).map_or(Solid::nothing(), Solid::of))
        }
        Geometry::Triangle { ref vertices, .. } => {
            budget.spend(8.0)?;
            Ok(flat::surface(&vertices[..]).map_or(Solid::nothing(), Solid::of))
        }
        Geometry::Quadric(ref q) => quadric::quadric(q, tolerance, region, budget),
        Geometry::ParabolicCylinder { a } => quadric(&[(0, squared(a)), (7, -1.0)], budget),
        Geometry::HyperbolicCylinder { a, b } => {
            quadric(&[(0, squared(a)), (5, -squared(b)), (15, -1.0)], budget)
        }
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let constant = if sheets == 2 { 1.0 } else { -1.0 };
            let entries = [
                (0, squared(a)),
                (5, -squared(b)),
                (10, squared(c)),
                (15, constant),
            ];
            quadric(&entries, budget)
        }
        Geometry::HyperbolicParaboloid { a, b } => {
            quadric(&[(0, squared(a)), (10, -squared(b)), (7, -1.0)], budget)
        }
    }
}

/// Whether a shape consists of flat faces with an end, so that triangles are exact. Other shapes keep within the
/// tolerance, or end where the region does.
pub fn is_faceted(kind: ShapeKind) -> bool {
    match kind {
        ShapeKind::Rectangle
        | ShapeKind::Triangle
        | ShapeKind::TriangleWithNormal
        | ShapeKind::TriangleWithVertexNormals
        | ShapeKind::Box
        | ShapeKind::GeodesicSphere => true,
        ShapeKind::SurfaceOfRevolution
        | ShapeKind::ColouredSurfaceOfRevolution
        | ShapeKind::SphereAtOrigin
        | ShapeKind::Ellipsoid
        | ShapeKind::Sphere
        | ShapeKind::Torus
        | ShapeKind::Cone
        | ShapeKind::DoubleCone
        | ShapeKind::Plane
        | ShapeKind::HalfSpace
        | ShapeKind::Quadric
        | ShapeKind::ParabolicCylinder
        | ShapeKind::HyperbolicCylinder
        | ShapeKind::Hyperboloid
        | ShapeKind::HyperbolicParaboloid => false,
    }
}

fn open(points: Vec<[f64; 2]>) -> Profile {
    Profile {
        points,
        ring: false,
    }
}

fn ball(
    centre: [f64; 3],
    axes: [f64; 3],
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Solid, TooMany> {
    let longest = axes[0].max(axes[1]).max(axes[2]);
    let mut mesh = sphere::sphere(tolerance / longest, budget)?;
    let [x, y, z] = centre;
    mesh.transform(
        &Matrix::translation(x, y, z).after(&Matrix::scaling(axes[0], axes[1], axes[2])),
    );
    Ok(Solid::of(mesh))
}

/// Turns profiles with straight edges about the y axis.
fn lathe(profiles: Vec<Profile>, tolerance: f64, budget: &mut Budget) -> Result<Solid, TooMany> {
    let radii = profiles.iter().flat_map(|p| &p.points).map(|p| p[0]);
    let n = sides(radii.fold(0.0, f64::max), tolerance);
    let mesh = turned(&profiles, n, budget)?;
    Ok(if mesh.volume() > 0.0 {
        Solid::of(mesh)
    } else {
        Solid::nothing()
    })
}

/// The profiles of a torus whose tube has `n` sides. A tube that reaches over the axis has a second profile: the
/// lemon in its middle, which is left out by the even-odd rule.
fn ring_profiles(major: f64, minor: f64, n: usize) -> Vec<Profile> {
    let at = |a: f64| [major + minor * a.cos(), minor * a.sin()];
    if minor < major {
        let points = (0..n).map(|k| at(TAU * k as f64 / n as f64)).collect();
        return vec![Profile { points, ring: true }];
    }
    // The angle at which the circle meets the axis.
    let meets = (-major / minor).acos();
    let height = (minor * minor - major * major).max(0.0).sqrt();
    let arc = |from: f64, to: f64| {
        let steps = ((n as f64 * (to - from) / TAU).ceil() as usize).max(2);
        (1..steps).map(move |k| at(from + (to - from) * k as f64 / steps as f64))
    };
    let mut apple = vec![[0.0, -height]];
    apple.extend(arc(-meets, meets));
    apple.push([0.0, height]);
    let mut out = vec![open(apple)];
    if height > 0.0 {
        let mut lemon = vec![[0.0, height]];
        lemon.extend(arc(meets, TAU - meets).map(|[x, y]| [-x, y]));
        lemon.push([0.0, -height]);
        out.push(open(lemon));
    }
    out
}

/// How much longer a matrix makes a vector at most: its largest singular value.
pub fn stretch(m: &Matrix) -> f64 {
    let size = m.0[..3].iter().flat_map(|r| &r[..3]);
    let size = size.fold(0.0f64, |s, x| s.max(x.abs()));
    if size == 0.0 {
        return 0.0;
    }
    let entry = |i: usize, j: usize| {
        (0..3)
            .map(|k| m.0[k][i] / size * (m.0[k][j] / size))
            .sum::<f64>()
    };
    let product = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let (values, _) = eigen(product);
    size * values.iter().fold(0.0f64, |s, v| s.max(*v)).sqrt()
}

#[cfg(test)]
mod tests;
