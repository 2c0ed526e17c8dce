//! Scenes under study: how our picture of a scene compares with those of other programs, and what accuracy costs.
//!
//! [`povray`] runs the real POV-Ray on a translation; [`silhouette`] finds the pixels whose value depends on rounding;
//! [`compare`] measures how far two pictures are apart, and draws the differences. [`mitsuba`] asks the real Mitsuba
//! where it sees surfaces, and [`geometry`] compares these surfaces with ours. [`accuracy`] measures what accuracy
//! costs in time. [`naive`] is a textbook's ray tracer, in numbers of any kind; [`plain`] is a similar one over the
//! hierarchy of the tracer. [`page`] has the parts that all HTML pages share. [`whereabouts`] finds the shape that most
//! of the differing pixels show. [`program`] runs other programs.

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
