//! The scene for other programs: one folder per target ([`target`]), and what each translation costs
//! ([`fidelity`]) of what scenes consist of ([`feature`]).

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
    /// The end of the file's name before its extension, which other files of the translation do not have.
    pub suffix: &'static str,
    /// The text of the file.
    pub text: String,
}

/// A camera that there is no other one for; `message` names it as `id`.
pub fn about_camera(camera: &Camera, message: &'static str) -> Complaint {
    Complaint::new(message).with("id", camera.id.to_string())
}

/// The shortest decimal that reads back as the same number.
fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-5..1e15).contains(&size) {
        // As people write it, where an exponent would not be shorter; whole numbers to 2⁵³ are exact.
        x.to_string()
    } else {
        format!("{x:e}")
    }
}
