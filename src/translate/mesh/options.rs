//! Options of a mesh.

use crate::scene::Vec3;

/// The choices that the scene itself does not make.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// How far a triangle may be from the surface it stands for, in scene units; by default
    /// [`DEFAULT_TOLERANCE`] of the scene's size.
    pub tolerance: Option<f64>,
    /// The place that the scene is seen from, if that matters: endless shapes reach that far, too.
    pub eye: Option<Vec3>,
    /// Whether textures are pictures, so that triangles need not be small for their sake.
    pub pictured: bool,
    /// Files have no colours, so that triangles need not be small for the sake of textures either.
    pub plain: bool,
    /// Files have as many digits as are needed, rather than single precision.
    pub digits: bool,
    /// How much memory triangles may take, in bytes, if that matters.
    pub memory: Option<u64>,
}

/// The tolerance by the radius of the sphere around the scene: a quarter of a pixel where the scene fills
/// a picture of 480 rows.
pub const DEFAULT_TOLERANCE: f64 = 1e-3;
