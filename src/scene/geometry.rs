//! The shapes of the language: how a record makes them, and how they are written as records.

use super::checks::{non_zero, ordered};
use super::model::{Rgb, Vec3};
use super::record::Params;
use crate::diagnostics::Diagnostic;
use crate::syntax::table::ShapeKind;

/// The shapes of the language with their parameters as written. Large and rare variants are boxed, so that scenes of
/// millions of spheres take less memory.
#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// Types 1 and 2: `profile[i]` is (x, y); `colours` is empty or as long as the profile.
    Revolution {
        profile: Vec<[f64; 2]>,
        colours: Vec<Rgb>,
    },
    /// a, b, c, d of ax + by + cz + d = 0.
    Plane([f64; 4]),
    /// a, b, c, d of ax + by + cz + d ≤ 0.
    HalfSpace([f64; 4]),
    Rectangle {
        min: [f64; 2],
        max: [f64; 2],
    },
    /// Types 6 to 8: no normal, one normal for the whole triangle, or one a vertex.
    Triangle {
        vertices: Box<[Vec3; 3]>,
        normals: TriangleNormals,
    },
    /// Types 9 and 11.
    Sphere {
        centre: Vec3,
        radius: f64,
    },
    Ellipsoid {
        semi_axes: Vec3,
    },
    Box {
        min: Vec3,
        max: Vec3,
    },
    GeodesicSphere {
        radius: f64,
        splits: u32,
    },
    Torus {
        major: f64,
        minor: f64,
    },
    /// Q of xᵀQx ≤ 0, row by row as written.
    Quadric(Box<[f64; 16]>),
    Cone {
        height: f64,
        radius: f64,
    },
    DoubleCone {
        height: f64,
        radius: f64,
    },
    ParabolicCylinder {
        a: f64,
    },
    HyperbolicCylinder {
        a: f64,
        b: f64,
    },
    Hyperboloid {
        a: f64,
        b: f64,
        c: f64,
        sheets: u32,
    },
    HyperbolicParaboloid {
        a: f64,
        b: f64,
    },
}

#[derive(Debug, Clone, PartialEq)]
pub enum TriangleNormals {
    Flat,
    One(Vec3),
    PerVertex(Box<[Vec3; 3]>),
}

/// A parameter of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Parameter {
    Real(f64),
    Integer(u32),
}

impl Geometry {
    /// Whether the shape has an inside.
    pub fn is_solid(&self) -> bool {
        match self {
            Geometry::Plane(_) | Geometry::Rectangle { .. } | Geometry::Triangle { .. } => false,
            Geometry::Revolution { .. }
            | Geometry::HalfSpace(_)
            | Geometry::Sphere { .. }
            | Geometry::Ellipsoid { .. }
            | Geometry::Box { .. }
            | Geometry::GeodesicSphere { .. }
            | Geometry::Torus { .. }
            | Geometry::Quadric(_)
            | Geometry::Cone { .. }
            | Geometry::DoubleCone { .. }
            | Geometry::ParabolicCylinder { .. }
            | Geometry::HyperbolicCylinder { .. }
            | Geometry::Hyperboloid { .. }
            | Geometry::HyperbolicParaboloid { .. } => true,
        }
    }

    /// The name of the shape in plans.
    pub fn name(&self) -> &'static str {
        match self {
            Geometry::Revolution { .. } => "surface-of-revolution",
            Geometry::Plane(_) => "plane",
            Geometry::HalfSpace(_) => "half-space",
            Geometry::Rectangle { .. } => "rectangle",
            Geometry::Triangle { .. } => "triangle",
            Geometry::Sphere { .. } => "sphere",
            Geometry::Ellipsoid { .. } => "ellipsoid",
            Geometry::Box { .. } => "box",
            Geometry::GeodesicSphere { .. } => "geodesic-sphere",
            Geometry::Torus { .. } => "torus",
            Geometry::Quadric(_) => "quadric",
            Geometry::Cone { .. } => "cone",
            Geometry::DoubleCone { .. } => "double-cone",
            Geometry::ParabolicCylinder { .. } => "parabolic-cylinder",
            Geometry::HyperbolicCylinder { .. } => "hyperbolic-cylinder",
            Geometry::Hyperboloid { .. } => "hyperboloid",
            Geometry::HyperbolicParaboloid { .. } => "hyperbolic-paraboloid",
        }
    }

    /// The record type that the shape has when it is written, and its parameters. A sphere at the origin has the type
    /// without a centre.
    pub fn record(&self) -> (ShapeKind, Vec<Parameter>) {
        fn reals(parts: &[&[f64]]) -> Vec<Parameter> {
            let all = parts.iter().copied().flatten();
            all.map(|x| Parameter::Real(*x)).collect()
        }
        match self {
            Geometry::Revolution { profile, colours } => {
                let count = Parameter::Integer(profile.len() as u32);
                let points = profile.iter().flatten().copied();
                let all = points.chain(colours.iter().flatten().copied());
                let params = std::iter::once(count).chain(all.map(Parameter::Real));
                let kind = match colours.is_empty() {
                    true => ShapeKind::SurfaceOfRevolution,
                    false => ShapeKind::ColouredSurfaceOfRevolution,
                };
                (kind, params.collect())
            }
            Geometry::Plane(p) => (ShapeKind::Plane, reals(&[p])),
            Geometry::HalfSpace(p) => (ShapeKind::HalfSpace, reals(&[p])),
            Geometry::Rectangle { min, max } => (ShapeKind::Rectangle, reals(&[min, max])),
            Geometry::Triangle { vertices, normals } => {
                let (kind, normals) = match normals {
                    TriangleNormals::Flat => (ShapeKind::Triangle, &[][..]),
                    TriangleNormals::One(n) => {
                        (ShapeKind::TriangleWithNormal, std::slice::from_ref(n))
                    }
                    TriangleNormals::PerVertex(all) => {
                        (ShapeKind::TriangleWithVertexNormals, &all[..])
                    }
                };
                (
                    kind,
                    reals(&[vertices.as_flattened(), normals.as_flattened()]),
                )
            }
            Geometry::Sphere { centre, radius } if *centre == [0.0; 3] => {
                (ShapeKind::SphereAtOrigin, reals(&[&[*radius]]))
            }
            Geometry::Sphere { centre, radius } => {
                (ShapeKind::Sphere, reals(&[centre, &[*radius]]))
            }
            Geometry::Ellipsoid { semi_axes } => (ShapeKind::Ellipsoid, reals(&[semi_axes])),
            Geometry::Box { min, max } => (ShapeKind::Box, reals(&[min, max])),
            Geometry::GeodesicSphere { radius, splits } => (
                ShapeKind::GeodesicSphere,
                vec![Parameter::Real(*radius), Parameter::Integer(*splits)],
            ),
            Geometry::Torus { major, minor } => (ShapeKind::Torus, reals(&[&[*major, *minor]])),
            Geometry::Quadric(q) => (ShapeKind::Quadric, reals(&[&q[..]])),
            Geometry::Cone { height, radius } => (ShapeKind::Cone, reals(&[&[*height, *radius]])),
            Geometry::DoubleCone { height, radius } => {
                (ShapeKind::DoubleCone, reals(&[&[*height, *radius]]))
            }
            Geometry::ParabolicCylinder { a } => (ShapeKind::ParabolicCylinder, reals(&[&[*a]])),
            Geometry::HyperbolicCylinder { a, b } => {
                (ShapeKind::HyperbolicCylinder, reals(&[&[*a, *b]]))
            }
            Geometry::Hyperboloid { a, b, c, sheets } => {
                let mut params = reals(&[&[*a, *b, *c]]);
                params.push(Parameter::Integer(*sheets));
                (ShapeKind::Hyperboloid, params)
            }
            Geometry::HyperbolicParaboloid { a, b } => {
                (ShapeKind::HyperbolicParaboloid, reals(&[&[*a, *b]]))
            }
        }
    }
}

/// The geometry of a shape record. `None` if a parameter is wrong; findings go to `out`.
pub fn shape(kind: ShapeKind, p: &Params, out: &mut Vec<Diagnostic>) -> Option<Geometry> {
    let sound = p.check_constraints(out);
    let geometry = match kind {
        ShapeKind::SurfaceOfRevolution | ShapeKind::ColouredSurfaceOfRevolution => {
            let points = |first: usize, i: usize, n: usize| first + i * n;
            Geometry::Revolution {
                profile: (0..p.count).map(|i| p.numbers(points(1, i, 2))).collect(),
                colours: match kind {
                    ShapeKind::ColouredSurfaceOfRevolution => (0..p.count)
                        .map(|i| p.numbers(points(1 + 2 * p.count, i, 3)))
                        .collect(),
                    _ => Vec::new(),
                },
            }
        }
        ShapeKind::Plane | ShapeKind::HalfSpace => {
            non_zero(p, 0, "normal", out)?;
            match kind {
                ShapeKind::Plane => Geometry::Plane(p.numbers(0)),
                _ => Geometry::HalfSpace(p.numbers(0)),
            }
        }
        ShapeKind::Rectangle => {
            ordered(p, 0, 2, out)?;
            Geometry::Rectangle {
                min: p.numbers(0),
                max: p.numbers(2),
            }
        }
        ShapeKind::Triangle
        | ShapeKind::TriangleWithNormal
        | ShapeKind::TriangleWithVertexNormals => {
            let vertices = [p.numbers(0), p.numbers(3), p.numbers(6)];
            for i in 0..(p.len() - 9) / 3 {
                non_zero(p, 9 + 3 * i, "normal", out)?;
            }
            let normals = match kind {
                ShapeKind::Triangle => TriangleNormals::Flat,
                ShapeKind::TriangleWithNormal => TriangleNormals::One(p.numbers(9)),
                _ => TriangleNormals::PerVertex(Box::new([
                    p.numbers(9),
                    p.numbers(12),
                    p.numbers(15),
                ])),
            };
            Geometry::Triangle {
                vertices: Box::new(vertices),
                normals,
            }
        }
        ShapeKind::SphereAtOrigin => Geometry::Sphere {
            centre: [0.0; 3],
            radius: p.number(0),
        },
        ShapeKind::Ellipsoid => Geometry::Ellipsoid {
            semi_axes: p.numbers(0),
        },
        ShapeKind::Sphere => Geometry::Sphere {
            centre: p.numbers(0),
            radius: p.number(3),
        },
        ShapeKind::Box => {
            ordered(p, 0, 3, out)?;
            Geometry::Box {
                min: p.numbers(0),
                max: p.numbers(3),
            }
        }
        ShapeKind::GeodesicSphere => Geometry::GeodesicSphere {
            radius: p.number(0),
            splits: p.integer(1) as u32,
        },
        ShapeKind::Torus => Geometry::Torus {
            major: p.number(0),
            minor: p.number(1),
        },
        ShapeKind::Quadric => Geometry::Quadric(Box::new(p.numbers(0))),
        ShapeKind::Cone => Geometry::Cone {
            height: p.number(0),
            radius: p.number(1),
        },
        ShapeKind::DoubleCone => Geometry::DoubleCone {
            height: p.number(0),
            radius: p.number(1),
        },
        ShapeKind::ParabolicCylinder => Geometry::ParabolicCylinder { a: or_one(p, 0) },
        ShapeKind::HyperbolicCylinder => Geometry::HyperbolicCylinder {
            a: or_one(p, 0),
            b: or_one(p, 1),
        },
        ShapeKind::Hyperboloid => Geometry::Hyperboloid {
            a: or_one(p, 0),
            b: or_one(p, 1),
            c: or_one(p, 2),
            sheets: or_one(p, 3) as u32,
        },
        ShapeKind::HyperbolicParaboloid => Geometry::HyperbolicParaboloid {
            a: or_one(p, 0),
            b: or_one(p, 1),
        },
    };
    sound.then_some(geometry)
}

/// An optional parameter whose default is 1.
fn or_one(p: &Params, i: usize) -> f64 {
    if i < p.len() { p.number(i) } else { 1.0 }
}
