//! From pixels to rays.

use super::ray::Ray;
use super::vec::Vec3;
use crate::scene::frame::Basis;
use crate::scene::{Camera, Matrix};

/// A camera set up for pictures of one size.
#[derive(Debug, Clone)]
pub struct View {
    position: Vec3,
    width: f64,
    height: f64,
    lens: Lens,
}

#[derive(Debug, Clone)]
enum Lens {
    /// A pinhole: the direction to the picture's centre, and to the right and upper edges of a
    /// picture at distance 1.
    Perspective {
        forward: Vec3,
        right: Vec3,
        up: Vec3,
    },
    /// From clip coordinates to the scene.
    Matrix(Box<Matrix>),
}

impl View {
    /// Sets a camera up; `None` where its direction and up are parallel or its projection matrix
    /// cannot be inverted.
    pub fn new(camera: &Camera, width: u32, height: u32) -> Option<View> {
        let position = Vec3::from(camera.position);
        let basis = Basis::of(camera)?;
        let [forward, right, up] = [basis.forward, basis.right, basis.up].map(Vec3::from);
        let (width, height) = (width as f64, height as f64);
        let lens = match &camera.projection {
            Some(projection) => {
                let row = |v: Vec3| [v[0], v[1], v[2], -v.dot(position)];
                let view = Matrix([row(right), row(up), row(-forward), [0.0, 0.0, 0.0, 1.0]]);
                Lens::Matrix(Box::new(projection.after(&view).inverse()?))
            }
            None => {
                let half = (camera.fovy.to_radians() / 2.0).tan();
                Lens::Perspective {
                    forward,
                    right: right * (half * width / height),
                    up: up * half,
                }
            }
        };
        Some(View {
            position,
            width,
            height,
            lens,
        })
    }

    pub fn position(&self) -> Vec3 {
        self.position
    }

    /// From clip coordinates to the scene, of a camera with a projection matrix.
    pub fn unprojection(&self) -> Option<&Matrix> {
        match &self.lens {
            Lens::Perspective { .. } => None,
            Lens::Matrix(back) => Some(back),
        }
    }

    /// Whether all rays start at the camera's position.
    pub fn is_pinhole(&self) -> bool {
        matches!(self.lens, Lens::Perspective { .. })
    }

    /// The ray through a point of the picture, in pixels from its upper left corner; the centre of
    /// the first pixel is (½, ½). `None` where a projection matrix has no ray there.
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        let ndc = [2.0 * x / self.width - 1.0, 1.0 - 2.0 * y / self.height];
        match &self.lens {
            Lens::Perspective { forward, right, up } => {
                let direction = *forward + *right * ndc[0] + *up * ndc[1];
                Some(Ray::new(self.position, direction.unit()))
            }
            Lens::Matrix(back) => {
                let unproject = |z: f64| {
                    let clip = [ndc[0], ndc[1], z, 1.0];
                    let [x, y, z, w] =
                        std::array::from_fn(|i| (0..4).map(|j| back.0[i][j] * clip[j]).sum());
                    Vec3::new(x, y, z) / w
                };
                let (near, far) = (unproject(-1.0), unproject(1.0));
                let direction = (far - near).unit();
                (near.is_finite() && direction.any()).then(|| Ray::new(near, direction))
            }
        }
    }
}
