//! Colours of surfaces.

use super::graph::Graph;
use super::shapes::Shape;
use super::stats::Work;
use crate::geometry::vec::Vec3;
use crate::scene::{DEFAULT_COLOUR, Rgb, Texture};

/// A point on the surface of a shape.
pub struct SurfacePoint<'s> {
    pub shape: &'s dyn Shape,
    /// The point in the shape's space.
    pub point: Vec3,
    /// The number of the face that the point is on: see [`Root::face`](super::shapes::Root::face).
    pub face: u32,
}

impl SurfacePoint<'_> {
    fn uv(&self) -> [f64; 2] {
        self.shape.uv(self.point, self.face)
    }
}

impl Graph {
    /// The colour, linear RGB, that a texture gives a point. `texture` is an index into [`Graph::textures`]. `painted`
    /// computes the point in the space that the texture was given in.
    pub fn painted(
        &self,
        texture: u32,
        at: &SurfacePoint,
        painted: impl FnOnce() -> Vec3,
        work: &mut Work,
    ) -> Rgb {
        match &self.textures[texture as usize] {
            Texture::Colour(c) => *c,
            _ if self.without.textures => DEFAULT_COLOUR,
            Texture::Checkerboard { n, m, colours } => {
                work.checkerboard += 1;
                work.uv += 1;
                let uv = at.uv();
                Texture::cell_colour(colours, &[uv[0] * *n as f64, uv[1] * *m as f64])
            }
            Texture::Solid { colours, size } => {
                work.solid_texture += 1;
                Texture::cell_colour(colours, &(painted() / *size).0)
            }
            Texture::Image { .. } => match &self.bitmaps[texture as usize] {
                Some(bitmap) => {
                    work.image_texture += 1;
                    work.uv += 1;
                    bitmap.colour(at.uv())
                }
                None => DEFAULT_COLOUR,
            },
        }
    }

    /// The colour, linear RGB, that a shape without a texture gives a point itself.
    pub fn unpainted(&self, at: &SurfacePoint, work: &mut Work) -> Rgb {
        if self.without.textures {
            return DEFAULT_COLOUR;
        }
        let own = at.shape.colour(at.point, at.face);
        work.vertex_colour += u64::from(own.is_some());
        own.unwrap_or(DEFAULT_COLOUR)
    }
}
