//! Diagnostics of a scene: [`Diagnostic`]s with a stable [`Code`], spans, notes, help and fixes; their texts
//! ([`wording`]); and the ways to print them ([`render`]). A message about no place in a scene is a [`Complaint`]; the
//! reason why a request is not met is an [`Error`].
//!
//! Nothing here knows the scene language: the other modules make diagnostics, this one carries them.

pub mod code;
pub mod complaint;
pub mod diagnostic;
pub mod error;
pub mod fixes;
pub mod language;
pub mod layout;
pub mod render;
pub mod source;
pub mod span;
pub mod wording;

pub use code::{Code, Severity};
pub use complaint::Complaint;
pub use diagnostic::{Applicability, Diagnostic, Edit, Fix, Label, sort};
pub use error::Error;
pub use language::Language;
pub use source::SourceFile;
pub use span::Span;
pub use wording::{Value, Wording};
