//! Scenes under study: what we see of a scene beside what another program does.
//!
//! [`povray`] has the real POV-Ray take the picture of a translation; [`silhouette`] finds the pixels
//! whose value is up to rounding; [`compare`] says how far two pictures are apart, and shows it.
//! [`mitsuba`] asks the real Mitsuba where it sees surfaces, and [`geometry`] compares that.

pub mod compare;
pub mod geometry;
pub mod mitsuba;
pub mod povray;
pub mod program;
pub mod silhouette;
