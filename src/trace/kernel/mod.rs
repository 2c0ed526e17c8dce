//! A quick way to draw scenes of simple shapes.
//!
//! Pictures have the bits of those that [`search`](super::search) and [`shade`](super::shade) draw, who are called the
//! arbiter here. The kernel takes on scenes whose parts are spheres and boxes in one union, with plain colours. It knows
//! of each ray whether rounding may have decided anything about it. A pixel with such a ray is drawn by the arbiter.
//!
//! [`stage`] is the scene: shapes in blocks of four, blocks in a tree. [`search`] finds which shape a ray meets, with
//! bounds that are far wider than any rounding. [`sphere`] and [`cuboid`] compute where, with the operations of the
//! arbiter in the arbiter's order, for four rays at once. [`wave`] sends rays on and adds up the light.

mod cuboid;
mod lanes;
mod place;
mod plane;
mod probe;
mod rectangle;
mod resolved;
mod search;
mod sphere;
mod stage;
#[cfg(test)]
mod tests;
mod wave;

pub use stage::Stage;
pub use wave::{Scene, Tile};

/// So many columns and rows are drawn together.
pub const TILE: [usize; 2] = [16, 4];
