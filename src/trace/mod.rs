//! The reference ray tracer.
//!
//! [`compile`] turns a [`Scene`](crate::scene::Scene) into a [`graph`] in which shared parts stay shared. A [`Tracer`]
//! holds the graph and everything else that a picture needs, and knows what cannot be drawn before the first ray. In
//! the order in which a pixel comes about: [`camera`] and [`sampling`] make rays, [`search`] finds what they meet in
//! the graph, along trees of boxes, [`shapes`] knows where a line crosses a shape, [`shade`] adds up the light,
//! [`film`] keeps it. [`probe`] and [`membership`] answer questions about single rays and points. The quick [`kernel`]
//! draws the pictures of most scenes, with the same bits as the code above.
//!
//! All code between a ray and its hits is generic over its kind of number ([`precision`], and
//! [`geometry`](crate::geometry) for the numbers themselves). Every decision knows a bound on its rounding errors. If a
//! decision in doubles is closer than its bound, [`search::escalate`] asks again in double-double; some shapes ask once
//! more in quad-double.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod adaptive;
mod arbiter;
pub mod bitmap;
pub mod camera;
mod compile;
pub mod costs;
pub mod decode;
mod depth_complexity;
pub mod film;
pub mod graph;
pub mod image;
#[allow(unreachable_pub)]
mod kernel;
pub mod membership;
mod memory_limit;
mod orientation;
mod picture;
pub mod pixels;
pub mod plan;
pub mod precision;
mod probe;
mod quartic;
pub mod ray;
pub mod sampling;
pub mod search;
pub mod shade;
pub mod shapes;
pub mod stats;
pub mod surfaces;
pub mod switches;
mod texture;
mod tracer;

pub use costs::CostMap;
pub use film::Film;
pub use image::Images;
pub use membership::{Membership, members};
pub use picture::{Crop, Numbers, Picture, Settings, selected_camera};
pub use probe::{Crossing, Probe};
pub use ray::Ray;
pub use search::escalate::Walkers;
pub use search::hit::Hit;
pub use stats::Samples;
pub use tracer::Tracer;
