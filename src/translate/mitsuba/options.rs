//! What a translation is asked to be.

use crate::solids::staging::Viewpoint;
use crate::syntax::Captions;

/// What Mitsuba is to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Integrator {
    /// A picture, by path tracing.
    #[default]
    Path,
    /// Of what is seen through the middle of each pixel: position (channels 0 to 2), shading normal
    /// (3 to 5), and the number of the shape in [`Output::shapes`](super::Output::shapes), from 1, 0 for none (6).
    Aov,
}

/// What the scene itself does not say.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// Who takes the picture.
    pub viewpoint: Viewpoint,
    /// How often a ray may be mirrored or refracted.
    pub depth: u32,
    /// As in [`mesh::Options`](crate::translate::mesh::Options).
    pub tolerance: Option<f64>,
    /// As there.
    pub memory: Option<u64>,
    pub integrator: Integrator,
    /// What the names of meshes begin with.
    pub stem: String,
    /// What the scene says of its objects, which stands beside them.
    pub captions: Captions,
}
