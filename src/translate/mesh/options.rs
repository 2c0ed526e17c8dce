//! Options of a mesh.

use crate::scene::Vec3;

/// The choices that the scene itself does not make.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// How far a triangle may be from the surface it stands for, in scene units. `None`: [`DEFAULT_TOLERANCE`] times
    /// the radius of the sphere around the scene.
    pub tolerance: Option<f64>,
    /// The place that the scene is seen from, if it matters: endless shapes reach as far as that place.
    pub eye: Option<Vec3>,
    /// Whether textures are pictures, so that triangles need not be small for their sake.
    pub pictured: bool,
    /// Whether files have no colours, so that triangles need not be small for the sake of textures either.
    pub plain: bool,
    /// Whether files have as many decimal digits as are needed, rather than single precision.
    pub digits: bool,
    /// The memory that triangles may take, in bytes; `None` for the usual limit.
    pub memory: Option<u64>,
}

/// The default tolerance, in radii of the sphere around the scene: a quarter of a pixel where the scene fills a
/// picture of 480 rows.
pub const DEFAULT_TOLERANCE: f64 = 1e-3;
