//! Scenes under study: our picture of a scene beside another program's.
//!
//! [`povray`] has the real POV-Ray take the picture of a translation; [`silhouette`] finds the pixels
//! whose value is up to rounding; [`compare`] says how far two pictures are apart, and shows it.

pub mod compare;
pub mod povray;
pub mod program;
pub mod silhouette;
