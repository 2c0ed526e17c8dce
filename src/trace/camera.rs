//! Rays of the camera, from pixels.

#![warn(missing_docs)]

use super::ray::Ray;
use crate::geometry::vec::Vec3;
use crate::scene::Camera;
use crate::scene::sight::Sight;
use crate::solids::staging::Basis;

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
    /// A pinhole: the unit vector to the centre of a picture at distance 1, and the vectors from there to its right and
    /// upper edges.
    Perspective {
        forward: Vec3,
        right: Vec3,
        up: Vec3,
    },
    /// A projection matrix.
    Matrix { sight: Box<Sight>, basis: Basis },
}

impl View {
    /// Sets a camera up; `None` where its direction and up are parallel or its projection matrix
    /// takes no picture: see [`Sight::of`].
    pub fn new(camera: &Camera, width: u32, height: u32) -> Option<View> {
        let position = Vec3::from(camera.position);
        let basis = Basis::of(camera)?;
        let [forward, right, up] = [basis.forward, basis.right, basis.up].map(Vec3::from);
        let (width, height) = (width as f64, height as f64);
        let lens = match &camera.projection {
            Some(projection) => Lens::Matrix {
                sight: Box::new(Sight::of(projection).ok()?),
                basis,
            },
            None => {
                let half = libm::tan(camera.fovy.to_radians() / 2.0);
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

    /// The position of the camera.
    pub fn position(&self) -> Vec3 {
        self.position
    }

    /// Whether all rays start at the camera's position.
    pub fn is_pinhole(&self) -> bool {
        matches!(self.lens, Lens::Perspective { .. })
    }

    /// The ray through a point of the picture, in pixels from its upper left corner; the centre of
    /// the first pixel is (½, ½). `None` where its numbers are out of range.
    #[inline]
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        let [origin, direction] = self.line(x, y)?;
        Some(Ray::new(origin, direction))
    }

    /// The origin and the unit direction of the ray that [`ray`](Self::ray) returns.
    #[inline]
    pub fn line(&self, x: f64, y: f64) -> Option<[Vec3; 2]> {
        let ndc = [2.0 * x / self.width - 1.0, 1.0 - 2.0 * y / self.height];
        match &self.lens {
            Lens::Perspective { forward, right, up } => {
                let direction = *forward + *right * ndc[0] + *up * ndc[1];
                Some([self.position, direction.unit()])
            }
            Lens::Matrix { sight, basis } => {
                let (start, direction) = sight.ray(ndc[0], ndc[1])?;
                let start = self.position + basis.turned(start).into();
                let direction = Vec3(basis.turned(Vec3(direction).unit().0)).unit();
                (start.is_finite() && direction.any()).then_some([start, direction])
            }
        }
    }
}
