//! zpg reads, checks, formats, draws and translates scenes of the ZPG language.
//!
//! The findings of a text, as `zpg check` prints them:
//!
//! ```
//! use zpg::{Analysis, Look, write_findings};
//!
//! let analysis = Analysis::new("ball.zpg", b"2 11 0 0 1\n".to_vec());
//! let mut printed = Vec::new();
//! write_findings(&mut printed, &analysis.source, analysis.findings(), Look::default())?;
//! assert!(String::from_utf8_lossy(&printed).contains("error[E008]: too few numbers"));
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! A picture of a scene. Where it has no camera, one is chosen:
//!
//! ```
//! use zpg::{Analysis, Settings, Tracer, selected_camera};
//!
//! let scene = b"2 11 0 0 0 1\n50 -402 1\n50 -1 3 5 9\n1 9999 2 0\n";
//! let analysis = Analysis::new("ball.zpg", scene.to_vec());
//! let tracer = Tracer::new(&analysis.scene)?;
//! let settings = Settings { width: 40, height: 30, ..Settings::default() };
//! let camera = selected_camera(&analysis.scene, 40.0 / 30.0);
//! let picture = tracer.render(&camera, &settings, || ())?;
//! let [red, _, _] = picture.film.pixel(20, 15);
//! assert!(red > 0.0);
//! # Ok::<(), zpg::Error>(())
//! ```
//!
//! A translation, with the report of what the other program shows exactly:
//!
//! ```
//! use zpg::{Analysis, Prepared, TranslationOptions, target};
//!
//! let analysis = Analysis::new("ball.zpg", b"2 11 0 0 0 1\n1 9999 2 0\n".to_vec());
//! let pov = target("pov").unwrap();
//! let output = pov.write(&Prepared::new(&analysis), &TranslationOptions::default())?;
//! let text = String::from_utf8_lossy(&output.files[0].1);
//! assert!(text.contains("sphere"));
//! # Ok::<(), zpg::Error>(())
//! ```
//!
//! The folder `examples` has longer programs. Errors are values with a message in two languages; no function here
//! panics on what a scene says.

// Not in Cargo.toml, whose lints hold for tests and benches, too: there, nothing is reachable.
#![warn(unreachable_pub)]
// Only `commands` and `lsp` write to a terminal, to what they are given.
#![warn(clippy::print_stdout, clippy::print_stderr)]

// The modules, each of which imports only what stands before it.

// What becomes of freed memory.
mod allocator;

// Runs work on all threads, a thin layer over rayon.
mod parallel;

// Findings with stable codes, spans, fixes; printed for people and machines.
mod diagnostics;

// Bytes to tokens to a typed tree. `syntax/table.rs` is *the* table of record types.
mod syntax;

// The pretty-printer; it needs the syntax alone.
mod format;

// Numbers, vectors, maps, boxes and their hierarchies; it knows nothing of scenes.
mod geometry;

// The tree read as a program of assignments: nodes in an arena, lights, cameras.
mod scene;

// What is true of solids without a ray.
mod solids;

// The reference ray tracer.
mod trace;

// Pictures as PNG and OpenEXR, row by row, with what they say of themselves.
mod picture_files;

// Rules over the tree and the scene, one folder a rule; those about geometry prove what they say with the tracer's
// means.
mod lint;

// A file's bytes to source, document, scene and findings, with the settings of its folder.
mod analysis;

// The scene for other programs.
mod translate;

// Compares our pictures: with what POV-Ray and Mitsuba draw of a translation, and with more accurate ones.
mod study;

// What an editor shows of a scene, without a protocol.
mod features;

// The language server: the protocol's types, the open files and the loop.
mod lsp;

// One file per subcommand of the command line.
mod commands;

#[cfg(test)]
mod testing;

pub use analysis::Analysis;
pub use diagnostics::render::human::{Look, write as write_findings};
pub use diagnostics::{
    Applicability, Code, Complaint, Diagnostic, Edit, Error, Fix, Label, Language, Severity,
    SourceFile, Span,
};
pub use format::{Options as FormatOptions, format};
pub use geometry::vec::Vec3;
pub use scene::{Camera, Scene};
pub use syntax::Document;
pub use trace::film::Packing;
pub use trace::{
    Crop, Crossing, Film, Images, Numbers, Picture, Probe, Ray, Settings, Tracer, selected_camera,
};
pub use translate::Report;
pub use translate::registry::{TARGETS, named as target};
pub use translate::target::{Options as TranslationOptions, Output, Prepared, Target};

/// All modules, for the command line, tests, benches and fuzz targets. They change without notice.
#[doc(hidden)]
pub mod internals {
    pub mod allocator {
        pub use crate::allocator::*;
    }
    pub mod analysis {
        pub use crate::analysis::*;
    }
    pub mod commands {
        pub use crate::commands::*;
    }
    pub mod diagnostics {
        pub use crate::diagnostics::*;
    }
    pub mod features {
        pub use crate::features::*;
    }
    pub mod format {
        pub use crate::format::*;
    }
    pub mod geometry {
        pub use crate::geometry::*;
    }
    pub mod lint {
        pub use crate::lint::*;
    }
    pub mod lsp {
        pub use crate::lsp::*;
    }
    pub mod parallel {
        pub use crate::parallel::*;
    }
    pub mod picture_files {
        pub use crate::picture_files::*;
    }
    pub mod scene {
        pub use crate::scene::*;
    }
    pub mod solids {
        pub use crate::solids::*;
    }
    pub mod study {
        pub use crate::study::*;
    }
    pub mod syntax {
        pub use crate::syntax::*;
    }
    pub mod trace {
        pub use crate::trace::*;
    }
    pub mod translate {
        pub use crate::translate::*;
    }
}
