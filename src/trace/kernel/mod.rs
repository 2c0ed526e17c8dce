//! A quick way to draw scenes of simple shapes.
//!
//! Pictures have the bits of those that [`search`](super::search) and [`shade`](super::shade) draw, who are called the
//! arbiter here. The kernel takes on scenes of spheres, boxes, planes, half-spaces and rectangles, placed anywhere, in
//! one union, with plain colours and one sample a pixel, seen from outside. It knows of each ray whether rounding may have
//! decided anything about it. A pixel with such a ray is drawn by the arbiter. So is a whole picture of which the kernel
//! does not know enough.
//!
//! [`stage`] is the scene: shapes in blocks of four, blocks in a tree. [`search`] finds which shape a ray meets, with
//! bounds that are far wider than any rounding. [`sphere`] and the other shapes compute where, with the operations of the
//! arbiter in the arbiter's order, for four rays at once; [`place`] takes them into the spaces of shapes. [`wave`] sends
//! rays on and adds up the light. From inside of a transparent solid that is near no other shape, its other side comes
//! next, and nothing is searched.

mod cuboid;
mod lanes;
mod leaf;
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
