//! Shape records as geometry, with the checks that concern several parameters at once.

use super::model::{Geometry, TriangleNormals};
use super::record::Params;
use super::sight::{Blind, Sight};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::Matrix;
use crate::syntax::table::ShapeKind;

/// The geometry of a shape record; findings go to `out`. A value comes back even so, where one can
/// be made.
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
                _ => TriangleNormals::PerVertex([p.numbers(9), p.numbers(12), p.numbers(15)]),
            };
            Geometry::Triangle { vertices, normals }
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
        ShapeKind::Quadric => Geometry::Quadric(p.numbers(0)),
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

/// E203 unless the three parameters from `first` on make a vector with a direction.
pub fn non_zero(
    p: &Params,
    first: usize,
    what: &'static str,
    out: &mut Vec<Diagnostic>,
) -> Option<()> {
    if p.numbers::<3>(first).iter().any(|&x| x != 0.0) {
        return Some(());
    }
    out.push(
        Diagnostic::new(Code::E203, p.span_of(first, 3))
            .with("vector", Value::Term(what))
            .with("type", Value::Term(p.ty.title)),
    );
    None
}

/// E202 unless each of `n` lower bounds from `first` on is below its upper bound, `n` further on.
pub fn ordered(p: &Params, first: usize, n: usize, out: &mut Vec<Diagnostic>) -> Option<()> {
    let inverted: Vec<usize> = (first..first + n)
        .filter(|&i| p.number(i) > p.number(i + n))
        .collect();
    if inverted.is_empty() {
        return Some(());
    }
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let mut edits: Vec<Edit> = (inverted.iter())
        .flat_map(|&i| [(i, i + n), (i + n, i)])
        .map(|(to, from)| Edit {
            span: p.span_of(to, 1),
            text: p.text_of(from).to_owned(),
        })
        .collect();
    edits.sort_by_key(|e| e.span);
    let at = inverted[0];
    out.push(
        Diagnostic::new(Code::E202, p.span_of(at, 1))
            .with("lower", name(at))
            .with("upper", name(at + n))
            .with("type", Value::Term(p.ty.title))
            .with("others", Value::Count(inverted.len() as u64 - 1))
            .label(p.span_of(at + n, 1), "other")
            .fix(Fix {
                title: "fix",
                values: Vec::new(),
                applicability: Applicability::Safe,
                edits,
            }),
    );
    None
}

/// E204 unless the matrix is affine (last row 0 0 0 1) and can be inverted.
pub fn affine(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    let m = Matrix::from_rows(&p.numbers(0));
    if m.0[3] != [0.0, 0.0, 0.0, 1.0] {
        out.push(Diagnostic::new(Code::E204, p.span_of(12, 4)).case("row"));
        return None;
    }
    invertible(p, m, out)
}

/// The matrix of a -99 record: E204 unless it can be inverted, E207 unless it has a ray for every
/// point of the picture.
pub fn projection(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    let m = Matrix::from_rows(&p.numbers(0));
    match Sight::of(&m) {
        Ok(_) => Some(m),
        Err(Blind::Singular) => {
            singular(p, "", out);
            None
        }
        Err(Blind::InPart) => {
            out.push(Diagnostic::new(Code::E207, p.span_of(0, 16)).case("projection"));
            None
        }
    }
}

/// E204 unless the matrix can be inverted.
fn invertible(p: &Params, m: Matrix, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    match (m.is_singular(), m.inverse()) {
        (false, Some(_)) => return Some(m),
        (true, _) => singular(p, "", out),
        (false, None) => singular(p, "rounded", out),
    }
    None
}

fn singular(p: &Params, case: &'static str, out: &mut Vec<Diagnostic>) {
    out.push(
        Diagnostic::new(Code::E204, p.span_of(0, 16))
            .case(case)
            .with("type", Value::Term(p.ty.title)),
    );
}
