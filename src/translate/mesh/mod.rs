//! The scene as triangles, for every program that reads meshes.
//!
//! [`shape`] approximates each shape by triangles within a tolerance. [`assemble`] places and combines the shapes as
//! the scene says; [`operate`] carries out the operations. [`csg`] combines two solids, [`unite`] joins many,
//! [`overlap_components`] finds those that overlap, and [`assign_owner`] separates solids of different media.
//! [`shared`] finds surfaces that are in one place; [`surface_label`] tells what each triangle shows; [`precision`]
//! measures the accuracy that the numbers of a file cost; [`ply`], [`obj`] and [`glb`] write files.

mod assemble;
mod assign_owner;
mod budget;
mod colour;
pub mod corners;
mod csg;
mod degenerate_triangles;
mod extent;
mod flush;
pub mod glb;
mod glb_scenery;
mod material;
mod model;
pub mod obj;
mod operate;
mod options;
mod overlap_components;
mod parts;
pub mod picture;
pub mod ply;
mod precision;
mod refine;
pub mod shape;
mod shared;
mod stl;
mod surface_label;
pub mod target;
#[cfg(test)]
mod tests;
mod triangle_mesh;
mod union_find;
mod unite;
mod verdict;

pub use assemble::MeshPart;
pub use assign_owner::Medium;
pub use degenerate_triangles::Precision;
pub use extent::Extent;
pub use material::{Coloured, Material};
pub use model::{Model, model, report};
pub use options::{DEFAULT_TOLERANCE, Options};
pub use parts::Parts;
pub use shape::is_faceted;
pub use surface_label::SurfaceLabel;
pub use triangle_mesh::Mesh;
pub use verdict::within;
