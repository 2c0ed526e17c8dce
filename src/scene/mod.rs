//! Reads the syntax tree as a program of assignments, in file order. The [`Scene`] holds the value of every ID at the
//! end of the file, and what is drawn, lit and seen.
//!
//! Objects are nodes of an arena that never change once they are made: an operation names its
//! operands' nodes as they are at that point, and a later change of an operand makes a new node.
//! Shared operands are shared nodes; nothing is ever copied or expanded, and children always have
//! smaller indices than their parents.

pub(crate) mod axes;
pub mod background;
mod camera;
mod change;
mod checks;
mod define;
mod entity;
pub mod geometry;
pub(crate) mod image_file;
mod matrices;
mod misread;
pub mod model;
pub mod names;
mod proposals;
pub(crate) mod record;
mod references;
mod resolve;
pub mod sight;
pub(crate) mod sizes;
pub(crate) mod target;
pub mod walk;

pub use camera::transformation;
pub use geometry::{Geometry, TriangleNormals};
pub use model::*;
pub use resolve::{resolve, resolve_with};
pub use walk::fold_up;
