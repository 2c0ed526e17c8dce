//! Translations of scenes for other programs, with a folder for each target ([`target`]). A report says how well a
//! translation keeps ([`fidelity`]) the features of a scene ([`feature`]).

pub mod feature;
pub mod fidelity;
pub mod json;
mod lens;
pub mod mesh;
pub mod mitsuba;
pub mod names;
pub mod plain;
pub mod pov;
pub mod registry;
pub mod target;

pub use feature::{Effect, Feature};
pub use fidelity::{FeatureSupport, Fidelity, Report};

use crate::diagnostics::Complaint;
use crate::scene::Camera;

/// A file of a translation.
#[derive(Debug)]
pub struct File {
    /// The end of the file's name before its extension, which tells the file from the others of the translation.
    pub suffix: &'static str,
    /// The text of the file.
    pub text: String,
}

/// A complaint about a camera that the target cannot have. The message with the name `message` mentions the camera's ID
/// as `id`.
pub fn about_camera(camera: &Camera, message: &'static str) -> Complaint {
    Complaint::new(message).with("id", camera.id.to_string())
}

/// The shortest decimal that reads back as the same number.
fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-5..1e15).contains(&size) {
        // Numbers of this size have no exponent, as people write them, since one would not be shorter; whole numbers to
        // 2⁵³ are exact.
        x.to_string()
    } else {
        format!("{x:e}")
    }
}
