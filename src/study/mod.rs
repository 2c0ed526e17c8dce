//! Scenes under study: what we see of a scene beside what others do, and what that costs.
//!
//! [`povray`] has the real POV-Ray take the picture of a translation; [`silhouette`] finds the pixels
//! whose value is up to rounding; [`compare`] says how far two pictures are apart, and shows it.
//! [`mitsuba`] asks the real Mitsuba where it sees surfaces, and [`geometry`] compares that.
//! [`accuracy`] says what accuracy costs in time. [`naive`] is a ray tracer as textbooks have it, in numbers
//! of any kind; [`plain`] is the same over the hierarchy of the tracer. [`page`] is what pages of HTML have in common.
//! [`whereabouts`] says where most of what differs is.

pub mod accuracy;
pub mod compare;
pub mod geometry;
pub mod mitsuba;
pub mod naive;
pub mod page;
pub mod plain;
pub mod povray;
pub mod program;
pub mod silhouette;
pub mod whereabouts;
