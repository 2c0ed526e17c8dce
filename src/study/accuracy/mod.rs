//! Cost of accuracy: the time that each step of accuracy of a picture takes, and the gain.
//!
//! [`configurations`] are the settings that are tried, on axes of four kinds of error that are never mixed; [`axes`]
//! finds the axes that a scene calls for, and [`facets`] makes scenes of flat pieces. [`sample_tiles`] chooses the
//! parts of a picture that are measured, [`runner`] draws and times them, [`measure`] and [`timing`] compute errors and
//! noise. [`check`] compares the reference with an independent tracer. [`run()`] does all this within a budget and
//! fills a [`report`]; [`advice`] recommends settings, and [`mod@print`] writes the report for people, with the
//! [`number_format`] of their language. [`shapes`] measures shapes without a scene, [`cost`] the shares of a picture's
//! time, and [`mod@pilot`] predicts the time of a picture.

pub mod advice;
pub mod axes;
pub mod check;
pub mod configurations;
pub mod cost;
pub mod facets;
pub mod measure;
pub mod number_format;
pub mod pilot;
pub mod print;
pub mod report;
pub mod run;
pub mod runner;
pub mod sample_tiles;
pub mod shapes;
pub mod timing;

pub use report::Report;
pub use run::{Options, run};
