//! A quick way to draw pictures.
//!
//! Pictures have the bits of those that [`search`](super::search) and [`shade`](super::shade) draw, who are called the
//! arbiter here. The kernel takes on scenes that are seen from outside: unions of shapes, intersections and differences,
//! placed anywhere. A ray that starts in a solid is the arbiter's, and so is a picture from within one, or of a scene that a
//! render box cuts open. A place may be inside of four solids at most. The kernel knows of each ray whether rounding may have
//! decided anything about it. The arbiter is asked about such a ray ([`Arbiter`](super::arbiter::Arbiter), [`provenance`]).
//!
//! The scene: [`expand`] takes the graph apart into leaves, each a shape with its looks ([`leaf`]). [`stage`] puts leaves of
//! one kind into blocks of four ([`block`]), and blocks into a tree. [`lone`] finds what is near nothing else.
//!
//! The rays of some pixels that are traced together are a wave: [`wave`]. Each wave goes through three phases.
//!
//! 1. [`search`] finds the leaf that each ray meets first, with bounds that are far wider than any rounding. Spheres, boxes,
//!    planes, rectangles and convex solids of second degree have lanes ([`sphere`], [`cuboid`], [`plane`], [`rectangle`],
//!    [`quadric`]): a ray is held against four at once. Other shapes are asked one by one by the arbiter's own formulas
//!    ([`scalar`]). [`csg`] merges what a ray meets of an intersection; of a few shapes with lanes the first place is found
//!    without that ([`spans`]). Rays that go nearly the same way share one walk through the tree ([`bundle`]), and four of
//!    them at a time are held against a shape ([`packet`], [`packet_search`]). A shape without lanes is asked about those
//!    that [`cull`] does not tell, with the pieces of a [`profile`]. [`torus`] is solved for four rays.
//! 2. Where a leaf is met is computed with the operations of the arbiter in the arbiter's order, for four rays at once;
//!    [`place`] and [`chain`] take rays into the spaces of shapes, and [`quadric_point`] finds points of solids of second
//!    degree.
//!    [`shade`] sends on what is mirrored and refracted: the next wave.
//! 3. [`light`] adds up the light of the lamps, one lamp after the other for all places of the wave; [`shadow`] says how much
//!    of it gets through.
//!
//! In the search of a ray by itself the four lanes are four shapes; in a packet, and in the other phases, they are four rays.
//! A formula is written once for both ([`Probe`](probe::Probe), [`Number`](lanes::Number)).
//!
//! From inside of a transparent solid that is near nothing else its other side comes next, and nothing is searched. Inside of
//! others the ray also crosses surfaces that are not seen: an earlier operand of the union hides what is in it
//! ([`Within`](query::Within)).
//!
//! A ray is in doubt
//!
//! - where it grazes a shape, or two crossings are nearer to each other than the bounds on their errors;
//! - where a crossing is so near its start that it may lie before it;
//! - where a crossing says that it starts inside of a solid, and what the ray carries says that it does not, or the reverse;
//! - where five solids would be in one place, or one medium is on both sides of a surface;
//! - where the point that it meets is not known well enough.
//!
//! The arbiter follows such a ray and all rays that come of it, or says how much of a lamp's light gets along it. The other
//! rays of the sample go on.

mod block;
mod bundle;
mod chain;
mod csg;
mod cuboid;
mod cull;
mod drawn;
mod expand;
mod lanes;
mod leaf;
mod light;
mod lone;
mod maps;
mod packet;
mod packet_search;
mod place;
mod plane;
mod probe;
mod profile;
mod provenance;
mod quadric;
mod quadric_point;
mod query;
mod rectangle;
mod resolved;
mod scalar;
mod scratch;
mod search;
mod shade;
mod shadow;
mod spans;
mod sphere;
mod stage;
#[cfg(test)]
mod tests;
mod torus;
mod wave;
mod way_in;

pub use stage::Stage;
pub use wave::{Scene, Tile};

/// So many columns and rows are drawn together.
pub const TILE: [usize; 2] = [16, 4];
