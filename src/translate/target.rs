//! The trait of the targets of translations.
//!
//! A target is a folder beside this file with an implementation of [`Target`], and a line in
//! [`registry`](super::registry). The command line has its name and its help from there.

#![warn(missing_docs)]

use std::cell::OnceCell;
use std::fmt;
use std::path::{Path, PathBuf};

use super::fidelity::Report;
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Error, Language};
use crate::scene::Scene;
use crate::solids::bounds::NodeBounds;
use crate::solids::staging::Viewpoint;
use crate::syntax::Captions;
use crate::trace::{Images, Settings, Tracer};

/// A program, or a kind of file, that scenes are translated for.
pub trait Target: fmt::Debug + Sync {
    /// The name of the target, as `--to` has it; by default also the extension of its files.
    fn name(&self) -> &'static str;

    /// The extension of the main file's name, without the dot.
    fn ending(&self) -> &'static str {
        self.name()
    }

    /// The line about the target in `--help`.
    fn help(&self) -> &'static str;

    /// Whether the target writes scenes in the language that people write them in.
    fn makes_scenes(&self) -> bool {
        false
    }

    /// Whether the target writes out a camera and lights for a scene that lacks them.
    fn adds_what_is_lacking(&self) -> bool {
        false
    }

    /// Whether the target refuses a scene in which there is nothing to draw.
    fn draws(&self) -> bool;

    /// The kind of output that is written.
    fn form(&self) -> OutputKind {
        OutputKind::Text
    }

    /// Translates a scene. The report says of every feature that the scene uses what became of it.
    ///
    /// # Errors
    ///
    /// A part of the scene or of the request has no translation.
    fn write(&self, scene: &Prepared, options: &Options) -> Result<Output, Error>;
}

/// The kinds of translations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputKind {
    /// Text: standard output has it unless a file is named.
    Text,
    /// A file that is no text: standard output has it where that is asked for.
    Binary,
    /// Files that name each other.
    Files,
}

/// A scene, and facts about it that are computed once, when a target first asks for them.
pub struct Prepared<'a> {
    /// The scene file with its scene.
    pub analysis: &'a Analysis,
    /// The comments that name entities.
    pub captions: Captions,
    tracer: OnceCell<Tracer>,
}

impl<'a> Prepared<'a> {
    /// The scene of an analysis.
    pub fn new(analysis: &'a Analysis) -> Prepared<'a> {
        Prepared {
            analysis,
            captions: Captions::of(&analysis.document, &analysis.source.text),
            tracer: OnceCell::new(),
        }
    }

    /// The scene itself.
    pub fn scene(&self) -> &'a Scene {
        &self.analysis.scene
    }

    /// The bounds of each node of the scene.
    pub fn bounds(&self) -> &'a [NodeBounds] {
        self.analysis.bounds()
    }

    /// The scene compiled, with its pictures.
    ///
    /// # Errors
    ///
    /// A part of the scene cannot be drawn, or a picture cannot be read.
    pub fn tracer(&self) -> Result<&Tracer, Error> {
        if let Some(tracer) = self.tracer.get() {
            return Ok(tracer);
        }
        let tracer = Tracer::with_images(self.scene(), &self.images()?)?;
        Ok(self.tracer.get_or_init(|| tracer))
    }

    /// The pictures that are laid on the objects that are drawn.
    ///
    /// # Errors
    ///
    /// A picture that cannot be read.
    pub fn images(&self) -> Result<Images, Error> {
        Images::load(self.scene(), self.folder()).map_err(Error::from)
    }

    /// The folder of the scene's pictures.
    pub fn folder(&self) -> &Path {
        self.analysis.source.folder().unwrap_or(Path::new("."))
    }
}

/// The choices that the scene itself does not make.
pub struct Options<'a> {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// The camera that takes the picture.
    pub viewpoint: Viewpoint,
    /// How often a ray may be mirrored or refracted.
    pub depth: u32,
    /// How far meshes may be from curved surfaces, in scene units; `None` if the user did not say.
    pub tolerance: Option<f64>,
    /// The most memory that triangles may take, in bytes; `None` for no limit.
    pub memory: Option<u64>,
    /// A check that refuses a scene in which rays would need too much memory, since too much lies in one place.
    pub confine: &'a dyn Fn(&Scene) -> Result<(), Complaint>,
    /// The language of comments.
    pub language: Language,
    /// The path of the scene.
    pub file: &'a Path,
    /// The path to write to, if one was given.
    pub output: Option<&'a Path>,
}

impl Default for Options<'_> {
    /// A picture of 640 × 480 pixels by the scene's camera, as deep as `zpg render` goes, with no limit of memory and
    /// without a file.
    fn default() -> Self {
        let settings = Settings::default();
        Options {
            size: (settings.width, settings.height),
            viewpoint: Viewpoint::default(),
            depth: settings.depth,
            tolerance: None,
            memory: None,
            confine: &|_| Ok(()),
            language: Language::English,
            file: Path::new(""),
            output: None,
        }
    }
}

impl Options<'_> {
    /// The file to write with a suffix before its extension; `None` for standard output.
    pub fn suffixed(&self, suffix: &str) -> Option<PathBuf> {
        let path = self.output?;
        if suffix.is_empty() {
            return Some(path.to_owned());
        }
        let mut name = path.file_stem().unwrap_or_default().to_owned();
        name.push(suffix);
        if let Some(extension) = path.extension() {
            name.push(".");
            name.push(extension);
        }
        Some(path.with_file_name(name))
    }
}

/// A finished translation.
#[derive(Debug)]
pub struct Output {
    /// The files to write; standard output where there is no path.
    pub files: Vec<(Option<PathBuf>, Vec<u8>)>,
    /// The report on each feature of the scene.
    pub report: Report,
}
