//! Alternative methods for the roots of tori and surfaces of revolution, in doubles.

use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::line::Line;
use crate::geometry::number::Real as _;
use crate::geometry::vec::Vec3;
use crate::scene::{Geometry, Scene};
use crate::study::naive::form::{self, NaiveShape};
use crate::study::naive::number::{Ray, dot};
use crate::study::naive::polynomial::Few;
use crate::trace::Tracer;
use crate::trace::shapes::{FLIPPED, Primitive, Root, Roots};
use crate::trace::switches::Solver;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The closed formula, with coefficients from the line's own origin.
    ClosedForm,
    /// The closed formula, after the origin was moved to the point of the line nearest to the shape's centre.
    Recentred,
    /// The tracer's roots, improved by Newton's method in double-double.
    Polished,
}

/// A shape whose roots can be found by other methods.
enum SolvableShape {
    Torus { major: f64, minor: f64 },
    Revolution(NaiveShape<f64>, Vec<[[f64; 2]; 2]>),
}

struct Other {
    method: Method,
    /// For each primitive of the graph: its shape and a copy of the primitive; `None` for shapes of other kinds.
    shapes: Vec<Option<(SolvableShape, Primitive)>>,
}

impl std::fmt::Debug for Other {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?}", self.method)
    }
}

fn known(geometry: &Geometry) -> Option<SolvableShape> {
    match geometry {
        &Geometry::Torus { major, minor } => Some(SolvableShape::Torus { major, minor }),
        Geometry::Revolution { .. } => {
            let form = NaiveShape::new(geometry)?;
            let pieces = match &form {
                NaiveShape::Revolution(pieces) => pieces.clone(),
                _ => return None,
            };
            Some(SolvableShape::Revolution(form, pieces))
        }
        _ => None,
    }
}

/// Whether a tracer draws a torus or a surface of revolution, whose roots depend on the method.
pub fn applies(scene: &Scene, tracer: &Tracer) -> bool {
    let geometry = |r: &u32| &scene.shapes[*r as usize].geometry;
    let mut all = tracer.graph.records.iter().map(geometry);
    all.any(|g| matches!(g, Geometry::Torus { .. } | Geometry::Revolution { .. }))
}

/// The solver with a method for the shapes that a tracer draws; `None` if no method applies to any of them.
pub fn of(scene: &Scene, tracer: &Tracer, method: Method) -> Option<Box<dyn Solver>> {
    let geometry = |r: &u32| &scene.shapes[*r as usize].geometry;
    let shapes = (tracer.graph.records.iter())
        .map(|r| known(geometry(r)).map(|k| (k, Primitive::new(geometry(r)))))
        .collect();
    applies(scene, tracer).then(|| Box::new(Other { method, shapes }) as Box<dyn Solver>)
}

/// The solver with a method for one shape, which gets the number 0; `None` if no method applies to the shape.
pub fn of_shape(geometry: &Geometry, method: Method) -> Option<Box<dyn Solver>> {
    let shape = (known(geometry)?, Primitive::new(geometry));
    let shapes = vec![Some(shape)];
    Some(Box::new(Other { method, shapes }))
}

impl Solver for Other {
    fn crossings(&self, primitive: u32, line: &Line, roots: &mut Roots) -> bool {
        let Some(Some((known, primitive))) = self.shapes.get(primitive as usize) else {
            return false;
        };
        if self.method == Method::Polished {
            primitive.intersect().crossings(line, roots);
            known.polish(line, roots);
            return true;
        }
        let (o, d) = (line.origin.0, line.direction.0);
        let moved = match self.method {
            Method::Recentred => -dot(o, d) / dot(d, d),
            _ => 0.0,
        };
        let ray = Ray {
            origin: each([0, 1, 2], |i| o[i] + moved * d[i]),
            direction: d,
        };
        known.cross(&ray, moved, roots);
        true
    }
}

impl SolvableShape {
    fn cross(&self, ray: &Ray<f64>, moved: f64, roots: &mut Roots) {
        match self {
            &SolvableShape::Torus { major, minor } => {
                let mut few = Few::new();
                form::torus(major, minor, ray, &mut few);
                for &t in few.all() {
                    let p = ray.at(t);
                    let rho = p[0].hypot(p[2]);
                    let tube = |across: f64| ((across - major).hypot(p[1]) - minor).abs();
                    let face = u32::from(minor > major && tube(-rho) < tube(rho));
                    roots.list.push(Root { t: t + moved, face });
                }
            }
            SolvableShape::Revolution(form, pieces) => {
                let mut found = form::Roots::default();
                form.cross(ray, &mut found);
                for (i, (t, face)) in found.list.into_iter().enumerate() {
                    // The normal of the piece as if its profile rose. The root is marked as flipped where this normal
                    // points inwards: on entering it then points along the ray, on leaving against it.
                    let [[x0, y0], [x1, y1]] = pieces[face as usize];
                    let p = ray.at(t);
                    let rho = p[0].hypot(p[2]).max(f64::MIN_POSITIVE);
                    let (w, h) = if y1 < y0 {
                        (x0 - x1, y0 - y1)
                    } else {
                        (x1 - x0, y1 - y0)
                    };
                    let normal = match h == 0.0 {
                        true => [0.0, 1.0, 0.0],
                        false => [h * p[0] / rho, -w, h * p[2] / rho],
                    };
                    let against = (dot(normal, ray.direction) < 0.0) != (i % 2 == 0);
                    let flipped = if against { FLIPPED } else { 0 };
                    let t = t + moved;
                    let face = face | flipped;
                    roots.list.push(Root { t, face });
                }
            }
        }
        roots.list.retain(|r| r.t.is_finite());
        roots.list.sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    /// Improves each root by two steps of Newton's method on `value`, in double-double.
    fn polish(&self, line: &Line, roots: &mut Roots) {
        let (o, d): (Vec3<Dd>, Vec3<Dd>) = (line.origin.cast(), line.direction.cast());
        for root in &mut roots.list {
            let mut t = Dd::of(root.t);
            for _ in 0..2 {
                let p = o + d * t;
                let Some((value, slope)) = self.value(p, d, root.face) else {
                    break;
                };
                let step = value / slope;
                // Where the line only touches the surface, the slope is zero and the step boundless.
                let most = Dd::of(1e-3 * root.t.abs());
                if step.abs() > most || step.to_f64().is_nan() {
                    break;
                }
                t -= step;
            }
            root.t = t.to_f64();
        }
        roots.list.sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    /// The value of a face's equation at a point, 0 on the face, and its derivative along `d`. `None` if there is no
    /// such face.
    fn value(&self, p: Vec3<Dd>, d: Vec3<Dd>, face: u32) -> Option<(Dd, Dd)> {
        let two = Dd::of(2.0);
        let square = p[0] * p[0] + p[2] * p[2];
        let turns = p[0] * d[0] + p[2] * d[2];
        match self {
            &SolvableShape::Torus { major, minor } => {
                let rho = square.sqrt();
                let centre = Dd::of(if face == 1 { -major } else { major });
                let across = rho - centre;
                let value = across * across + p[1] * p[1] - Dd::of(minor) * Dd::of(minor);
                Some((value, two * (across * turns / rho + p[1] * d[1])))
            }
            SolvableShape::Revolution(_, pieces) => {
                let [[x0, y0], [x1, y1]] = *pieces.get((face & !FLIPPED) as usize)?;
                if y0 == y1 {
                    return Some((p[1] - Dd::of(y0), d[1]));
                }
                let slope = (Dd::of(x1) - Dd::of(x0)) / (Dd::of(y1) - Dd::of(y0));
                let radius = Dd::of(x0) + slope * (p[1] - Dd::of(y0));
                Some((
                    square - radius * radius,
                    two * (turns - radius * slope * d[1]),
                ))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (ρ − 1)² + y² = 1/16 along z at x = 0.9, y = 0: from the outside in, the ring twice.
    #[test]
    fn all_methods_find_the_roots_of_a_torus_nearby() {
        let torus = Geometry::Torus {
            major: 1.0,
            minor: 0.25,
        };
        let line = Line::new([0.7, 0.0, -4.0].into(), [0.0, 0.0, 1.0].into());
        // z² = 1.25² − 0.49 and 0.75² − 0.49.
        let (far, near) = (1.0725f64.sqrt(), 0.0725f64.sqrt());
        let meant = [4.0 - far, 4.0 - near, 4.0 + near, 4.0 + far];
        for (method, most) in [
            (Method::ClosedForm, 1e-6),
            (Method::Recentred, 1e-9),
            (Method::Polished, 1e-15),
        ] {
            let mut roots = Roots::default();
            let solver = of_shape(&torus, method).unwrap();
            assert!(solver.crossings(0, &line, &mut roots));
            assert_eq!(roots.list.len(), 4, "{method:?} {roots:?}");
            for (root, meant) in roots.list.iter().zip(meant) {
                assert!(
                    (root.t - meant).abs() < most,
                    "{method:?} {} {meant}",
                    root.t
                );
            }
        }
    }

    #[test]
    fn faces_of_a_lathe_are_those_of_the_tracer() {
        let lathe = Geometry::Revolution {
            profile: vec![[0.5, -1.0], [1.0, 0.0], [0.25, 1.0], [0.0, 1.0]],
            colours: Vec::new(),
        };
        let primitive = Primitive::new(&lathe);
        for (o, d) in [
            ([-3.0, 0.5, 0.1], [1.0, 0.02, 0.0]),
            ([0.1, 4.0, 0.05], [0.01, -1.0, 0.02]),
            ([0.3, -4.0, 0.0], [0.0, 1.0, 0.1]),
        ] {
            let line = Line::new(o.into(), d.into());
            let mut ours = Roots::default();
            primitive.intersect().crossings(&line, &mut ours);
            assert_eq!(ours.list.len(), 2);
            for method in [Method::ClosedForm, Method::Recentred, Method::Polished] {
                let mut roots = Roots::default();
                of_shape(&lathe, method)
                    .unwrap()
                    .crossings(0, &line, &mut roots);
                let faces = |r: &Roots| r.list.iter().map(|r| r.face).collect::<Vec<_>>();
                assert_eq!(faces(&roots), faces(&ours), "{method:?} {line:?}");
                for (a, b) in roots.list.iter().zip(&ours.list) {
                    assert!((a.t - b.t).abs() < 1e-12, "{method:?} {a:?} {b:?}");
                }
            }
        }
    }
}
