//! W339: a triangle whose normals lie in its own plane, as where each corner has been written with its normal behind
//! it.

use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::array::{cross, dot, sub, unit};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Geometry, TriangleNormals, Vec3};

/// A normal lies in the plane if the cosine of the angle between it and the plane's normal is below this.
const IN_PLANE_COS: f64 = 1e-6;
/// The cosine of 60 degrees, the largest angle from the plane's normal at which a normal may still round off a mesh.
const ROUNDING_COS: f64 = 0.5;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        let Geometry::Triangle { vertices, normals } = &shape.geometry else {
            continue;
        };
        let (normals, interleaved) = match normals {
            TriangleNormals::Flat => continue,
            TriangleNormals::One(normal) => (std::slice::from_ref(normal), false),
            TriangleNormals::PerVertex(all) => (&all[..], is_interleaved(vertices, all)),
        };
        let Some(cosines) = cosines(vertices, normals) else {
            continue;
        };
        let in_plane = cosines.iter().filter(|cos| **cos < IN_PLANE_COS).count();
        let is_told = in_plane == normals.len() || in_plane > 0 && interleaved;
        let Some(p) = context.params(span).filter(|_| is_told) else {
            continue;
        };
        let d = Diagnostic::new(Code::W339, p.span_of(9, 3 * normals.len()))
            .case(if interleaved { "interleaved" } else { "" })
            .with("type", Value::Term(shape.ty().title))
            .with("id", shape.id.to_string());
        out.push(match interleaved {
            true => d.fix(sorted(&p)),
            false => d,
        });
    }
}

/// The cosines of the angles between the normals and the plane's normal, without their signs. `None` if the triangle
/// has no plane, or a normal no direction.
fn cosines(vertices: &[Vec3; 3], normals: &[Vec3]) -> Option<Vec<f64>> {
    let [a, b, c] = *vertices;
    let plane = unit(cross(sub(b, a), sub(c, a)))?;
    let cosine = |normal: &Vec3| Some(dot(unit(*normal)?, plane).abs());
    normals.iter().map(cosine).collect()
}

/// Whether the numbers make sense if each corner is followed by its normal: all three normals are then near the plane's
/// normal.
fn is_interleaved(vertices: &[Vec3; 3], normals: &[Vec3; 3]) -> bool {
    let [a, first, b] = *vertices;
    let [second, c, third] = *normals;
    let cosines = cosines(&[a, b, c], &[first, second, third]);
    cosines.is_some_and(|all| all.iter().all(|cos| *cos > ROUNDING_COS))
}

/// The fix that puts the corners first and their normals behind them.
fn sorted(p: &Params) -> Fix {
    let order = [0, 2, 4, 1, 3, 5].into_iter().enumerate();
    let moved = order.flat_map(|(to, from)| (0..3).map(move |i| (3 * to + i, 3 * from + i)));
    let changed = moved.filter(|&(to, from)| p.text_of(to) != p.text_of(from));
    let edit = |(to, from)| Edit {
        span: p.span_of(to, 1),
        text: p.text_of(from).to_owned(),
    };
    Fix::guess("fix", changed.map(edit).collect())
}
