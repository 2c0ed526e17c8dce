//! Search along a ray for the surfaces that it meets.
//!
//! [`escalate`] takes a question about a ray. A [`Walker`](walk::Walker), which goes down the graph along the ray,
//! answers it. If the answer is doubtful, the question is asked again in double-double. For the first hit, [`hit`] asks
//! [`nearest`] for the nearest crossing. If the ray starts outside of every solid and that crossing is opaque, it is
//! the answer. Else [`spans`] finds the stretches of the ray on which each part is, and [`merge`] joins the stretches
//! into boundaries; `nearest` has them find the boundaries of intersections. [`root_order`] tells which of two
//! crossings comes first, and which lie before the ray's start. [`surface_identity`] tells whether two crossings are on
//! one surface.
//!
//! A crossing is a place where the ray goes through a shape's surface ([`events`]). An event is a crossing with the
//! state of the object after it. An event is a boundary if the solid begins or ends there, a sheet if the surface has
//! no inside, else silent. A hit is an event with all that shading needs. [`context`] has the types for where in the
//! graph a shape occurs, [`query`] those for what a search wants.

pub mod context;
pub mod escalate;
pub mod events;
pub mod hit;
mod merge;
mod nearest;
pub mod query;
pub mod root_order;
mod spans;
mod surface_identity;
pub mod walk;
