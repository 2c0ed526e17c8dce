//! Shapes as POV-Ray's primitives.

use super::text::{number, vector};
use crate::scene::{Geometry, Shape};
use crate::translate::Unsupported;

/// The keyword and the parameters of the primitive that is the shape.
///
/// # Errors
/// The shape has no translation.
pub fn primitive(shape: &Shape) -> Result<(&'static str, String), Unsupported> {
    match &shape.geometry {
        Geometry::Sphere { centre, radius } => {
            Ok(("sphere", format!("{}, {}", vector(centre), number(*radius))))
        }
        Geometry::Box { min, max } => Ok(("box", format!("{}, {}", vector(min), vector(max)))),
        Geometry::Plane(p) | Geometry::HalfSpace(p) => {
            // Their plane is n·x = distance with a unit normal, the inside where n·x is less.
            let length = p[0].hypot(p[1]).hypot(p[2]);
            let normal = [p[0] / length, p[1] / length, p[2] / length];
            // 0 − d: never a negative zero.
            let distance = number((0.0 - p[3]) / length);
            Ok(("plane", format!("{}, {distance}", vector(&normal))))
        }
        Geometry::Rectangle { min, max } => {
            let corners = [
                [min[0], min[1], 0.0],
                [max[0], min[1], 0.0],
                [max[0], max[1], 0.0],
                [min[0], max[1], 0.0],
                [min[0], min[1], 0.0],
            ];
            let corners: Vec<String> = corners.iter().map(|c| vector(c)).collect();
            Ok(("polygon", format!("5, {}", corners.join(", "))))
        }
        _ => Err(Unsupported {
            id: shape.id,
            span: Some(shape.span),
            message: format!(
                "the {} {} cannot be translated to POV-Ray yet",
                shape.ty.title, shape.id
            ),
        }),
    }
}
