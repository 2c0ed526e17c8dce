//! The kernel: a quick way to draw pictures.
//!
//! Pictures have the same bits as those of [`search`](super::search) and [`shade`](super::shade), which are called the
//! arbiter here. The kernel takes scenes that are seen from outside: unions of shapes, intersections and differences,
//! placed anywhere. The arbiter draws pictures by a camera in a solid, and of a scene that a render box cuts open; it
//! also follows camera rays that start in a solid. At most four solids may share a place.
//!
//! - A **wave** is one generation of the rays of a tile: of up to 64 samples of neighbouring pixels. The first wave
//!   holds the camera rays; each next wave holds all rays that were mirrored or refracted where the rays of the wave
//!   before ended ([`wave`]).
//! - A ray is **in doubt** where rounding may have decided something about it. The kernel finds such rays by bounds on
//!   its errors, and asks the arbiter about them ([`Arbiter`](super::arbiter::Arbiter), [`provenance`]). The cases are
//!   listed below.
//! - A **lane** is one of four doubles that are computed with at once ([`lanes`]). A shape has lanes if the kernel has
//!   a formula for four of its kind. Other shapes are asked one ray at a time.
//! - A **torus** is solved in [`torus`], for four rays of a bundle at once, if they start outside of all solids and not
//!   on the torus. Rays that [`cull`] shows to miss it are not solved at all. All other rays, and those that nearly
//!   touch the torus, are solved one by one with the arbiter's own formulas ([`scalar`]). A **geodesic sphere** is
//!   solved in the same way in [`geodesic`]; rays that come near an edge of a facet are left to the arbiter's formulas.
//!
//! The scene: [`expand`] takes the graph apart into leaves, each a shape with its look ([`leaf`], [`look`]). [`stage`]
//! puts leaves of one kind into blocks of four ([`block`]), and blocks into a tree. [`lone`] finds the leaves that are
//! near no other.
//!
//! Each wave goes through three phases.
//!
//! 1. [`search`] finds the leaf that each ray meets first, with bounds that are far wider than any rounding. Spheres,
//!    boxes, planes, rectangles, triangles and convex solids of second degree have lanes ([`sphere`], [`cuboid`],
//!    [`plane`], [`rectangle`], [`triangle`], [`quadric`]): a ray is tested against four of them at once. Other shapes
//!    are asked one by one, by the arbiter's own formulas ([`scalar`]). [`csg`] merges the crossings of a ray with the
//!    operands of an intersection; if the operands are a few shapes with lanes, [`spans`] finds the first place without
//!    a merge. Rays that go nearly the same way are a bundle: they share one walk through the tree ([`bundle`]), and
//!    four of them at a time are tested against a shape ([`packet`], [`packet_search`]). Before a shape without lanes
//!    is asked, [`cull`] sorts out rays that surely miss it; for a solid of revolution it looks at the pieces of the
//!    [`profile`].
//! 2. The exact places are computed with the operations of the arbiter in the arbiter's order, for four rays at once.
//!    [`place`] and [`chain`] take rays into the spaces of shapes, [`quadric_point`] finds points of solids of second
//!    degree, and [`facet`] those of triangles and of the facets of geodesic spheres. [`shade`] sends on the mirrored
//!    and the refracted rays: they are the next wave.
//! 3. [`light`] adds up the light of the lamps, one lamp after the other for all places of the wave; [`shadow`] says
//!    how much of it gets through.
//!
//! In the search of a single ray the four lanes are four shapes; in a packet, and in the other phases, they are four
//! rays. A formula is written once for both ([`Probe`](probe::Probe), [`Number`](lanes::Number)).
//!
//! A ray inside of a transparent solid that is near nothing else meets the other side of that solid next, without a
//! search. A ray inside of other solids also crosses surfaces that are not seen: an earlier operand of the union hides
//! the solids in it ([`Within`](query::Within)).
//!
//! A ray is in doubt
//!
//! - where it grazes a shape, or where the distance of two crossings is within the bounds on their errors;
//! - where a crossing is so near the ray's start that it may lie before it;
//! - where a crossing shows that the ray starts inside of a solid, but the solids noted with the ray
//!   ([`Within`](query::Within)) say that it does not, or the reverse;
//! - where five solids would share a place, or where one medium is on both sides of a surface;
//! - where the point that it meets is not known well enough.
//!
//! The arbiter follows such a ray and all rays that come of it. If the ray goes to a lamp, the arbiter says how much of
//! the lamp's light gets along it. The other rays of the sample stay with the kernel.

mod block;
mod bundle;
mod chain;
mod csg;
mod cuboid;
mod cull;
mod drawn;
mod expand;
mod facet;
mod geodesic;
mod lanes;
mod leaf;
mod light;
mod lone;
mod look;
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
mod triangle;
mod wave;
mod way_in;

pub use stage::Stage;
pub use wave::{Scene, Tile};

/// The columns and rows of pixels that a tile draws together, with one sample each.
pub const TILE: [usize; 2] = [16, 4];
