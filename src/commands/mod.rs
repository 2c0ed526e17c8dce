//! One file per subcommand of the command line. Each has `Args`, derived for clap, and `run`.

use crate::diagnostics::{Diagnostic, SourceFile};
use crate::scene::Scene;
use crate::syntax::Document;

/// How a command ended; its number is the exit status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// Done and clean.
    Clean = 0,
    /// The scene has errors, or the answer is "no".
    Negative = 1,
    /// Wrong usage, unreadable or unwritable file.
    Failure = 2,
}

/// A scene read as far as it goes, with everything there is to say about it.
pub struct Loaded {
    pub source: SourceFile,
    pub document: Document,
    pub scene: Scene,
    pub diagnostics: Vec<Diagnostic>,
}
