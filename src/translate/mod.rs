//! The scene for other programs: one folder per target, and what each translation costs
//! ([`fidelity`]) of what scenes consist of ([`feature`]).

pub mod feature;
pub mod fidelity;
pub mod json;
pub mod mesh;
pub mod mitsuba;
pub mod names;
pub mod pov;

pub use feature::{Effect, Feature};
pub use fidelity::{Fidelity, Report, Verdict};

use std::fmt;

use crate::diagnostics::{Complaint, Language, Span};
use crate::scene::Camera;

/// A file of a translation.
#[derive(Debug)]
pub struct File {
    /// What its name has before the extension, and other files of the translation have not.
    pub suffix: &'static str,
    pub text: String,
}

/// What a target cannot express.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsupported {
    /// The entity at fault; 0 where it is the scene as a whole.
    pub id: u32,
    /// Where it is written, if that is known.
    pub span: Option<Span>,
    pub message: Complaint,
}

impl Unsupported {
    /// A scene without a render record.
    fn nothing() -> Unsupported {
        Unsupported {
            id: 0,
            span: None,
            message: Complaint::new("draw-nothing"),
        }
    }

    /// A camera that there is no other one for; `message` names it as `id`.
    pub fn camera(camera: &Camera, message: &'static str) -> Unsupported {
        Unsupported {
            id: camera.id,
            span: None,
            message: Complaint::new(message).with("id", camera.id.to_string()),
        }
    }
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message.wording(Language::English))
    }
}

impl std::error::Error for Unsupported {}
