//! Cost of accuracy: the time that each step of accuracy of a picture takes, and the gain.
//!
//! [`configurations`] are the settings that are tried, on axes of four kinds that are never mixed; [`axes`] says which
//! a scene calls for, [`facets`] makes the scenes of flat pieces. [`sample_tiles`] are what is measured of a picture,
//! [`runner`] draws them and takes the time, [`measure`] and [`timing`] say what came out. [`check`] asks an
//! independent tracer about the reference. [`run()`] does all this within a budget and fills a [`report`];
//! [`shapes`] does so without a scene, [`cost`] in short, [`mod@pilot`] for the time of a picture alone. [`advice`] says what to set, and [`mod@print`] writes it down for people with the [`number_format`] of their language.

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
