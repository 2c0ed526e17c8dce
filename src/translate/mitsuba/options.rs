//! Options of a translation.

use crate::solids::staging::Viewpoint;
use crate::syntax::Captions;

/// The values that Mitsuba is to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Integrator {
    /// A picture, by path tracing.
    #[default]
    Path,
    /// Values at what is seen through the middle of each pixel: position (channels 0 to 2), shading normal (3 to 5),
    /// and the number of the shape in [`Output::shapes`](super::Output::shapes), from 1, 0 for none (6).
    Aov,
}

/// The choices that the scene itself does not make.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// The camera that takes the picture.
    pub viewpoint: Viewpoint,
    /// The most times that a ray is mirrored or refracted.
    pub depth: u32,
    /// The tolerance, as in [`mesh::Options`](crate::translate::mesh::Options).
    pub tolerance: Option<f64>,
    /// The memory, as in [`mesh::Options`](crate::translate::mesh::Options).
    pub memory: Option<u64>,
    pub integrator: Integrator,
    /// The beginning of the names of meshes.
    pub stem: String,
    /// The scene's names of its objects, for comments beside them.
    pub captions: Captions,
}
