//! Errors: the reasons why a request is not met.

#![warn(missing_docs)]

use std::fmt;

use super::complaint::Complaint;
use super::diagnostic::Diagnostic;
use super::span::Span;

/// The reason why a scene is not drawn, asked or translated. Every function that may refuse a request returns this
/// type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Error {
    /// An error in the scene that stands in the way.
    Scene {
        /// The reason.
        why: Complaint,
        /// The place in the text; `None` for the scene as a whole.
        span: Option<Span>,
    },
    /// A finding is the reason: a picture that the scene names cannot be used.
    Finding(Box<Diagnostic>),
    /// The request cannot be met: its arguments do not fit, or a file cannot be read or written.
    Request(Complaint),
    /// Somebody has pressed Ctrl-C.
    Interrupted,
}

impl Error {
    /// The error that the scene as a whole stands in the way.
    pub fn scene(why: Complaint) -> Error {
        Error::Scene { why, span: None }
    }

    /// The error that a record of the scene stands in the way, at its span.
    pub fn at(span: Span, why: Complaint) -> Error {
        Error::Scene {
            why,
            span: Some(span),
        }
    }

    /// The error that the scene has no render record.
    pub fn nothing_to_draw() -> Error {
        Error::scene(Complaint::new("draw-nothing"))
    }
}

impl From<Complaint> for Error {
    fn from(why: Complaint) -> Error {
        Error::Request(why)
    }
}

impl From<Box<Diagnostic>> for Error {
    fn from(finding: Box<Diagnostic>) -> Error {
        Error::Finding(finding)
    }
}

/// Writes the error in English, for those who do not ask for a language.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Scene { why, .. } | Error::Request(why) => why.fmt(f),
            Error::Finding(finding) => f.write_str(&finding.wording(Default::default()).message),
            Error::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl std::error::Error for Error {}
