//! Numbers, vectors, maps, boxes and hierarchies of boxes: the ground on which all other modules stand.
//!
//! Nothing here knows what a scene is.
//!
//! - **Numbers.** [`number`]: the kinds of numbers with which the geometric kernel computes; [`dd`] and [`qd`] are
//!   double-double and quad-double, [`exponent`] scales by powers of two. [`exact`] and [`sign`] decide in numbers of
//!   any length what doubles cannot.
//! - **Vectors and maps.** [`vec`](mod@vec) is generic over the number, [`array`](mod@array) the algebra of plain
//!   `[f64; 3]`; [`matrix`] is 4×4, [`affine`] an affine map that knows what it rounds, [`line`](mod@line) a line that
//!   goes through such maps.
//! - **Boxes.** [`aabb`], the hierarchy [`bvh`] over them, and [`boxes`], which looks them up by place; [`wide_bvh`] is
//!   the hierarchy that rays walk.
//! - [`icosahedron`]: the facets that geodesic spheres begin with.

pub mod aabb;
pub mod affine;
pub mod array;
pub mod boxes;
pub mod bvh;
pub mod dd;
pub mod exact;
pub mod exponent;
pub mod icosahedron;
pub mod line;
pub mod matrix;
pub mod number;
pub mod qd;
pub mod shaft;
pub mod sign;
pub mod vec;
pub mod wide_bvh;

pub use aabb::Aabb;
pub use matrix::Matrix;
