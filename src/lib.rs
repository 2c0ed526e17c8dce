//! zpg: a toolchain for the ZPG scene language.
//!
//! The modules, in the order they may import each other (each only what stands before it):
//!
//! - [`allocator`]: what becomes of freed memory.
//! - [`parallel`]: runs work on all threads, a thin layer over rayon.
//! - [`diagnostics`]: findings with stable codes, spans, fixes; printed for people and machines.
//! - [`syntax`]: bytes to tokens to a typed tree. `syntax/table.rs` is *the* table of record types.
//! - [`mod@format`]: the pretty-printer; it needs the syntax alone.
//! - [`geometry`]: numbers, vectors, maps, boxes and their hierarchies; it knows nothing of scenes.
//! - [`scene`]: the tree read as a program of assignments: nodes in an arena, lights, cameras.
//! - [`solids`]: what is true of solids without a ray.
//! - [`trace`]: the reference ray tracer.
//! - [`picture_files`]: pictures as PNG and OpenEXR, row by row, with what they say of themselves.
//! - [`lint`]: rules over the tree and the scene, one folder a rule; those about geometry prove what they
//!   say with the tracer's means.
//! - [`analysis`]: a file's bytes to source, document, scene and findings, with the settings of its folder.
//! - [`translate`]: the scene for other programs.
//! - [`study`]: compares our pictures: with what POV-Ray and Mitsuba draw of a translation, and with more accurate ones.
//! - [`features`]: what an editor shows of a scene, without a protocol.
//! - [`lsp`]: the language server: the protocol's types, the open files and the loop.
//! - [`commands`]: one file per subcommand of the command line.

pub mod allocator;
pub mod analysis;
pub mod commands;
pub mod diagnostics;
pub mod features;
pub mod format;
pub mod geometry;
pub mod lint;
pub mod lsp;
pub mod parallel;
pub mod picture_files;
pub mod scene;
pub mod solids;
pub mod study;
pub mod syntax;
pub mod trace;
pub mod translate;

#[cfg(test)]
mod testing;
