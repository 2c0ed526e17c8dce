//! Shapes as POV-Ray has them: primitives and surface coordinates.

use std::collections::BTreeSet;
use std::fmt::{Result, Write};

use super::profile::Profile;
use super::text::vector;
use super::{poly, uv};
use crate::geometry::array::length;
use crate::scene::{Geometry, TriangleNormals, Vec3};
use crate::translate::number;

/// A primitive in the shape's own coordinates: a keyword, and what stands between its braces, one
/// line each.
pub(super) struct Primitive {
    pub keyword: &'static str,
    pub lines: Vec<String>,
}

impl Primitive {
    pub(super) fn new(keyword: &'static str, line: String) -> Primitive {
        Primitive {
            keyword,
            lines: vec![line],
        }
    }

    /// The primitive on one line.
    pub(super) fn line(&self) -> String {
        format!("{} {{ {} }}", self.keyword, self.lines.join(" "))
    }

    /// The primitive, scaled by `factor` after all its other lines.
    pub(super) fn scaled(mut self, factor: f64) -> Primitive {
        if factor != 1.0 {
            self.lines.push(format!("scale {}", number(factor)));
        }
        self
    }
}

/// The primitive that draws a shape.
pub(super) fn primitive(geometry: &Geometry) -> Primitive {
    // The division is done twice, since the square of `a` could overflow.
    let inverse = |a: f64| 1.0 / a / a;
    match geometry {
        Geometry::Sphere { centre, radius } => {
            Primitive::new("sphere", format!("{}, {}", vector(centre), number(*radius)))
        }
        Geometry::Ellipsoid { semi_axes } => {
            Primitive::new("sphere", format!("0, 1 scale {}", vector(semi_axes)))
        }
        Geometry::Box { min, max } => {
            Primitive::new("box", format!("{}, {}", vector(min), vector(max)))
        }
        Geometry::Plane(p) | Geometry::HalfSpace(p) => plane(p),
        Geometry::Rectangle { min, max } => {
            let corners = [
                [min[0], min[1], 0.0],
                [max[0], min[1], 0.0],
                [max[0], max[1], 0.0],
                [min[0], max[1], 0.0],
                [min[0], min[1], 0.0],
            ];
            let corners: Vec<String> = corners.iter().map(|c| vector(c)).collect();
            Primitive::new("polygon", format!("5, {}", corners.join(", ")))
        }
        Geometry::Triangle { vertices, normals } => match normals {
            TriangleNormals::Flat => {
                let corners: Vec<String> = vertices.iter().map(|c| vector(c)).collect();
                Primitive::new("triangle", corners.join(", "))
            }
            TriangleNormals::One(n) => smooth(vertices, &[*n; 3]),
            TriangleNormals::PerVertex(n) => smooth(vertices, n),
        },
        Geometry::Revolution { profile, .. } => Profile::of(profile).lathe(),
        Geometry::GeodesicSphere { radius, splits } => Primitive::new(
            "object",
            format!("{} scale {}", geodesic_name(*splits), number(*radius)),
        ),
        Geometry::Torus { major, minor } => torus(*major, *minor),
        Geometry::Cone { height, radius } => {
            Primitive::new("cone", cone_parameters(*height, *radius))
        }
        Geometry::DoubleCone { height, radius } => Primitive {
            keyword: "union",
            lines: [*height, -height]
                .map(|h| format!("cone {{ {} }}", cone_parameters(h, *radius)))
                .into(),
        },
        Geometry::Quadric(q) => poly::quadric(q),
        Geometry::ParabolicCylinder { a } => {
            poly::quadric(&poly::diagonal(inverse(*a), 0.0, 0.0, -1.0, 0.0))
        }
        Geometry::HyperbolicCylinder { a, b } => {
            let q = poly::diagonal(inverse(*a), -inverse(*b), 0.0, 0.0, -1.0);
            poly::quadric(&q)
        }
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let constant = if *sheets == 2 { 1.0 } else { -1.0 };
            let [a, b, c] = [*a, *b, *c].map(inverse);
            poly::quadric(&poly::diagonal(a, -b, c, 0.0, constant))
        }
        Geometry::HyperbolicParaboloid { a, b } => {
            let q = poly::diagonal(inverse(*a), 0.0, -inverse(*b), -1.0, 0.0);
            poly::quadric(&q)
        }
    }
}

/// The expressions for the surface coordinates of a point on a shape.
pub(super) fn coordinates(geometry: &Geometry) -> uv::Coordinates {
    let [u, v] = match geometry {
        Geometry::Sphere { centre, radius } => {
            let [x, y, z] = uv::from_centre(*centre);
            [
                uv::turn(&x, &z),
                uv::polar(&format!("{y}/{}", number(*radius))),
            ]
        }
        Geometry::Ellipsoid { semi_axes } => [
            uv::around(),
            uv::polar(&format!("y/{}", number(semi_axes[1]))),
        ],
        Geometry::GeodesicSphere { .. } => [uv::around(), uv::polar("y/sqrt(x*x + y*y + z*z)")],
        Geometry::Box { min, max } => uv::box_faces(*min, *max),
        Geometry::Rectangle { min, max } => [
            uv::along("x", min[0], max[0]),
            uv::along("y", min[1], max[1]),
        ],
        Geometry::Plane(p) | Geometry::HalfSpace(p) => uv::plane(p),
        Geometry::Triangle { vertices, .. } => uv::weights(vertices),
        Geometry::Torus { major, minor } => [uv::around(), uv::tube(*major, *minor)],
        // On the cone's side, y/h equals ρ/r.
        Geometry::Cone { radius, .. } => [uv::around(), format!("{}/{}", uv::RHO, number(*radius))],
        Geometry::DoubleCone { height, radius } => {
            [uv::around(), uv::double_cone(*height, *radius)]
        }
        Geometry::Quadric(_)
        | Geometry::ParabolicCylinder { .. }
        | Geometry::HyperbolicCylinder { .. }
        | Geometry::Hyperboloid { .. }
        | Geometry::HyperbolicParaboloid { .. } => [uv::around(), "y".to_owned()],
        Geometry::Revolution { profile, .. } => {
            return uv::Coordinates {
                // A lathe's own coordinate runs round the axis the other way.
                u: "mod(1 - x, 1)".to_owned(),
                v: uv::Along::Pattern(Profile::of(profile).arc_pattern()),
            };
        }
    };
    uv::Coordinates {
        u,
        v: uv::Along::Expression(v),
    }
}

fn smooth(vertices: &[Vec3; 3], normals: &[Vec3; 3]) -> Primitive {
    let corner = |i: usize| format!("{}, {}", vector(&vertices[i]), vector(&normals[i]));
    Primitive::new("smooth_triangle", [0, 1, 2].map(corner).join(", "))
}

/// A plane or half-space: n·x = distance with a unit normal, the inside where n·x is less.
fn plane(p: &[f64; 4]) -> Primitive {
    // The numbers are divided by the largest first, since their squares could overflow.
    let largest = p[..3].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let n = [p[0] / largest, p[1] / largest, p[2] / largest];
    let length = length(n);
    // 0 − d is never a negative zero.
    let distance = (0.0 - p[3]) / largest / length;
    let normal = n.map(|x| x / length);
    Primitive::new(
        "plane",
        format!("{}, {}", vector(&normal), number(distance)),
    )
}

fn cone_parameters(height: f64, radius: f64) -> String {
    format!("0, 0, <0, {}, 0>, {}", number(height), number(radius))
}

/// A torus. With a tube wider than its ring, the inside of POV-Ray's primitive includes the lemon about the centre, and
/// that of the quartic does not, so the quartic is written.
fn torus(major: f64, minor: f64) -> Primitive {
    // The tube's smallest radius in units of the primitive: sixteen times the tolerance of 1e-3.
    const MIN_TUBE_RADIUS: f64 = 1.0 / 64.0;
    let unit = match size_unit(major + minor) {
        unit if minor < MIN_TUBE_RADIUS * unit => power_of_two(minor / MIN_TUBE_RADIUS),
        unit => unit,
    };
    let (major, minor) = (major / unit, minor / unit);
    if major >= minor {
        return Primitive::new(
            "torus",
            format!("{}, {} sturm", number(major), number(minor)),
        )
        .scaled(unit);
    }
    poly::quartic_torus(major, minor).scaled(unit)
}

/// The power of two by which something of this size is written smaller, so that POV-Ray's absolute
/// tolerances fit; 1 where they fit anyway.
pub(super) fn size_unit(size: f64) -> f64 {
    // The sizes at which tolerances of 1e-6 to 1e-3 are not seen, and fourth powers keep their digits.
    const FITTING: std::ops::RangeInclusive<f64> = 0.25..=64.0;
    if FITTING.contains(&size) || !(size > 0.0 && size.is_finite()) {
        return 1.0;
    }
    power_of_two(size)
}

/// The largest power of two that is not above `x`, limited so that neither it nor its inverse leaves the normal
/// numbers.
fn power_of_two(x: f64) -> f64 {
    x.log2().floor().clamp(-1000.0, 1000.0).exp2()
}

/// The name of the geodesic sphere of radius 1 with this number of splits.
fn geodesic_name(splits: u32) -> String {
    format!("Geodesic_{splits}")
}

/// Writes the macro that makes geodesic spheres, and the declarations of those with the given numbers of splits.
pub(super) fn geodesics(out: &mut dyn Write, splits: &BTreeSet<u32>) -> Result {
    if !splits.is_empty() {
        out.write_str(GEODESIC)?;
    }
    for n in splits {
        writeln!(out, "#declare {} = Geodesic({n})", geodesic_name(*n))?;
    }
    Ok(())
}

const GEODESIC: &str = "\
// A facet, split into four N times; new corners are pushed out to the unit sphere.
#macro Geodesic_Facet(A, B, C, N)
  #if (N = 0)
    triangle { A, B, C }
  #else
    #local D = vnormalize(B + C);
    #local E = vnormalize(C + A);
    #local F = vnormalize(A + B);
    Geodesic_Facet(A, F, E, N - 1)
    Geodesic_Facet(F, B, D, N - 1)
    Geodesic_Facet(E, D, C, N - 1)
    Geodesic_Facet(D, E, F, N - 1)
  #end
#end
// All facets run the same way round: that tells the outer side of the sphere from the inner one.
#macro Geodesic_Face(A, B, C, N)
  #if (vdot(vcross(B, C), A) > 0)
    Geodesic_Facet(A, C, B, N)
  #else
    Geodesic_Facet(A, B, C, N)
  #end
#end
// A geodesic sphere of radius 1: an icosahedron whose 20 facets are split N times.
#macro Geodesic(N)
  #local Phi = (1 + sqrt(5))/2;
  #local S = 1/sqrt(1 + Phi*Phi);
  #local L = Phi*S;
  mesh {
    #local I = 0;
    #while (I < 8)
      // One facet in each octant, and one at each of twelve edges below.
      #local X = (mod(I, 2) ? -1 : 1);
      #local Y = (mod(floor(I/2), 2) ? -1 : 1);
      #local Z = (floor(I/4) ? -1 : 1);
      Geodesic_Face(<0, S*Y, L*Z>, <S*X, L*Y, 0>, <L*X, 0, S*Z>, N)
      #local I = I + 1;
    #end
    #local I = 0;
    #while (I < 4)
      #local P = (mod(I, 2) ? -1 : 1);
      #local Q = (floor(I/2) ? -1 : 1);
      Geodesic_Face(<0, S, L*Q>, <0, -S, L*Q>, <L*P, 0, S*Q>, N)
      Geodesic_Face(<S, L*Q, 0>, <-S, L*Q, 0>, <0, S*Q, L*P>, N)
      Geodesic_Face(<L*Q, 0, S>, <L*Q, 0, -S>, <S*Q, L*P, 0>, N)
      #local I = I + 1;
    #end
    inside_vector <0.31, 0.91, 0.27>
  }
#end
";
