//! Cameras and transformation records.

use super::model::{Camera, Vec3};
use super::record::Params;
use super::{checks, matrices};
use crate::diagnostics::{Code, Diagnostic};
use crate::geometry::array::{cross, unit};
use crate::geometry::{Matrix, exact};
use crate::syntax::table::RecordKind;

/// The camera of a -501 record.
pub(super) fn camera(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Camera> {
    let sound = p.check_constraints(out);
    let camera = Camera {
        id: p.id,
        position: p.numbers(0),
        direction: p.numbers(3),
        up: p.numbers(6),
        fovy: p.number(9),
        projection: None,
    };
    checks::non_zero(p, 3, "view direction", out)?;
    checks::non_zero(p, 6, "up vector", out)?;
    if parallel(camera.direction, camera.up) {
        let is_upright = [camera.up[0], camera.up[2]] == [0.0; 2];
        let case = match exact::parallel(camera.direction, camera.up) {
            true if !is_upright => "",
            true if camera.direction[1] < 0.0 => "down",
            true => "up",
            false => "nearly",
        };
        out.push(Diagnostic::new(Code::E207, p.span_of(3, 6)).case(case));
        return None;
    }
    sound.then_some(camera)
}

/// The camera that a projection matrix with a new ID defines: at the origin, looking along −z.
pub(super) fn projecting(id: u32, projection: Matrix) -> Camera {
    Camera {
        id,
        position: [0.0; 3],
        direction: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        fovy: 45.0,
        projection: Some(projection),
    }
}

/// A camera moved by an affine matrix. `None` if a number is not finite or the direction and the up vector become
/// parallel.
pub(super) fn moved(camera: &Camera, m: &Matrix) -> Option<Camera> {
    let camera = Camera {
        position: m.point(camera.position),
        direction: m.vector(camera.direction),
        up: m.vector(camera.up),
        ..*camera
    };
    let finite = [camera.position, camera.direction, camera.up]
        .iter()
        .flatten()
        .all(|x| x.is_finite());
    (finite && !parallel(camera.direction, camera.up)).then_some(camera)
}

/// Whether two vectors are parallel as far as double precision can tell: the sine of their angle is
/// within the rounding error of a normalised cross product.
fn parallel(a: Vec3, b: Vec3) -> bool {
    /// Each component of the cross product of unit vectors is off by at most 4 roundings.
    const SINE: f64 = 4.0 * f64::EPSILON;
    let (Some(a), Some(b)) = (unit(a), unit(b)) else {
        return true;
    };
    cross(a, b).iter().all(|x| x.abs() <= SINE)
}

/// The matrix of a -1 … -4 record.
pub fn transformation(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    if !p.check_constraints(out) {
        return None;
    }
    let [x, y, z] = p.numbers(0);
    match p.ty.kind {
        RecordKind::Translation => Some(Matrix::translation(x, y, z)),
        RecordKind::Rotation => Some(Matrix::rotation(x, p.integer(1) as usize - 1)),
        RecordKind::Scaling => Some(Matrix::scaling(x, y, z)),
        _ => matrices::affine(p, out),
    }
}
