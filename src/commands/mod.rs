//! One file per subcommand of the command line. Each has `Args`, derived for clap, and `run`.

pub mod convert;

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

// Stand-ins, until the modules that load and report are there.

impl Loaded {
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }

    pub fn require_render(&mut self) -> Option<crate::scene::Render> {
        self.scene.render
    }
}

#[derive(Debug, Clone, Copy)]
pub enum ColorChoice {
    Auto,
}

pub fn complain(message: &str) {
    eprintln!("error: {message}");
}

pub fn load(path: &std::path::Path) -> std::io::Result<Loaded> {
    Ok(Loaded {
        source: SourceFile::new(path.to_string_lossy(), std::fs::read(path)?),
        document: Document {
            tokens: Vec::new(),
            items: Vec::new(),
        },
        scene: Scene::default(),
        diagnostics: Vec::new(),
    })
}

pub fn report(_: &Loaded, _: ColorChoice) {}
