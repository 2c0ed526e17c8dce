//! Cameras with a projection matrix, for programs that describe cameras in other ways.

use crate::geometry::array::{add, cross, dot, length, sub};
use crate::scene::sight::Sight;
use crate::scene::{Camera, Vec3};
use crate::solids::staging::Basis;
use crate::trace::camera::View;

/// A camera by its rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lens {
    /// Rays through one point.
    Pinhole(Pinhole),
    /// Parallel rays: the start of the ray in the middle, the vectors from there to the starts at the middles of the
    /// right and the upper edge, and the unit direction of the rays.
    Parallel([Vec3; 4]),
}

/// Rays through one point, and a picture at right angles to the optical axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pinhole {
    pub position: Vec3,
    /// Unit vectors: to the right and upwards in the picture, and along the optical axis.
    pub right: Vec3,
    pub up: Vec3,
    pub forward: Vec3,
    /// The vertical field of view, in degrees.
    pub field_of_view: f64,
    /// The middle of the picture as seen from the optical axis, to the right and upwards, in units of half the width
    /// and height.
    pub shift: [f64; 2],
    /// The distance of the near plane from the eye, along the optical axis: nothing nearer is seen.
    pub near: f64,
    /// Width of a pixel by its height; `None` where pixels have no right angles.
    pub pixel: Option<f64>,
}

impl Pinhole {
    /// Whether the pixels are squares.
    pub(super) fn is_exact(&self) -> bool {
        // Over thousands of pixels, 1e-6 adds up to a hundredth of a pixel, which is as exact as single precision.
        self.pixel.is_some_and(|p| (p - 1.0).abs() < 1e-6)
    }
}

impl Lens {
    /// The lens of a camera with a projection matrix; `None` where its rays neither come from one point nor are
    /// parallel.
    pub(super) fn of(camera: &Camera, width: u32, height: u32) -> Option<Lens> {
        let sight = Sight::of(camera.projection.as_ref()?).ok()?;
        let view = View::new(camera, width, height)?;
        let (w, h) = (f64::from(width), f64::from(height));
        let middle = view.ray(w / 2.0, h / 2.0)?;
        if sight.is_parallel() {
            let right = view.ray(w, h / 2.0)?.line.origin.0;
            let top = view.ray(w / 2.0, 0.0)?.line.origin.0;
            let start = middle.line.origin.0;
            return Some(Lens::Parallel([
                start,
                sub(right, start),
                sub(top, start),
                middle.line.direction.unit().0,
            ]));
        }
        let basis = Basis::of(camera)?;
        let position = add(camera.position, basis.turned(sight.eye()?), 1.0);
        let [centre, along_x, along_y] = sight.direction().map(|v| basis.turned(v));
        let (width_there, height_there) = (length(along_x), length(along_y));
        let right = along_x.map(|x| x / width_there);
        let up = along_y.map(|x| x / height_there);
        let across = cross(right, up);
        let facing = if dot(across, centre) < 0.0 { -1.0 } else { 1.0 };
        let forward = across.map(|x| facing * x / length(across));
        let depth = dot(centre, forward);
        // The unit vectors count as perpendicular within 1e-9: more than the rounding of the inverse, less than single
        // precision.
        let square = dot(right, up).abs() < 1e-9;
        let out = Pinhole {
            position,
            right,
            // Where the pixels are skewed, this is the perpendicular vector that is nearest.
            up: cross(forward, right).map(|x| {
                x * if dot(cross(forward, right), up) < 0.0 {
                    -1.0
                } else {
                    1.0
                }
            }),
            forward,
            field_of_view: 2.0 * (height_there / depth).atan().to_degrees(),
            shift: [
                dot(centre, right) / width_there,
                dot(centre, up) / height_there,
            ],
            near: dot(sub(middle.line.origin.0, position), forward),
            pixel: square.then_some(width_there / height_there * h / w),
        };
        let numbers = [out.field_of_view, out.near, out.shift[0], out.shift[1]];
        let finite = numbers
            .iter()
            .chain(&right)
            .chain(&forward)
            .all(|x| x.is_finite());
        (finite && depth > 0.0).then_some(Lens::Pinhole(out))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Matrix;

    fn pinhole(rows: &[f64; 16], width: u32, height: u32) -> Pinhole {
        let camera = Camera {
            id: 1,
            position: [0.0; 3],
            direction: [0.0, 0.0, -1.0],
            up: [0.0, 1.0, 0.0],
            fovy: 45.0,
            projection: Some(Matrix::from_rows(rows)),
        };
        match Lens::of(&camera, width, height) {
            Some(Lens::Pinhole(p)) => p,
            other => panic!("{other:?}"),
        }
    }

    /// glFrustum of OpenGL 1.0, section 2.10.2.
    fn frustum([l, r, b, t, n, f]: [f64; 6]) -> [f64; 16] {
        [
            2.0 * n / (r - l),
            0.0,
            (r + l) / (r - l),
            0.0,
            0.0,
            2.0 * n / (t - b),
            (t + b) / (t - b),
            0.0,
            0.0,
            0.0,
            (n + f) / (n - f),
            2.0 * f * n / (n - f),
            0.0,
            0.0,
            -1.0,
            0.0,
        ]
    }

    #[test]
    fn a_frustum_beside_the_axis() {
        // Seen at distance 1: from x = 0 to 2 and y = −1 to ½.
        let p = pinhole(&frustum([0.0, 1.0, -0.5, 0.25, 0.5, 9.0]), 80, 60);
        assert!((p.near - 0.5).abs() < 1e-12, "{p:?}");
        assert!((p.field_of_view - 2.0 * 0.75f64.atan().to_degrees()).abs() < 1e-9);
        assert!((p.shift[0] - 1.0).abs() < 1e-12 && (p.shift[1] + 1.0 / 3.0).abs() < 1e-12);
        assert!(p.is_exact(), "{p:?}");
        assert!((p.forward[2] + 1.0).abs() < 1e-12 && (p.right[0] - 1.0).abs() < 1e-12);
        assert!(!pinhole(&frustum([0.0, 1.0, -0.5, 0.25, 0.5, 9.0]), 60, 60).is_exact());
    }

    #[test]
    fn skewed_pixels_are_noticed() {
        let mut rows = frustum([-1.0, 1.0, -1.0, 1.0, 1.0, 9.0]);
        rows[1] = 0.2;
        assert_eq!(pinhole(&rows, 60, 60).pixel, None);
    }
}
