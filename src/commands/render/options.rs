//! The options that say what a picture looks like, whoever draws it.

use std::str::FromStr;

use super::tile::Tile;
use crate::commands::camera::CameraArgs;
use crate::commands::frames::FrameArgs;
use crate::commands::help;
use crate::commands::size::Size;
use crate::commands::usage;
use crate::diagnostics::{Complaint, Error};
use crate::trace::{Crop, Numbers, Settings};

/// The options that a picture depends on.
#[derive(Debug, clap::Args)]
pub struct PictureArgs {
    /// Width and height in pixels
    #[arg(help_heading = help::PICTURE)]
    #[arg(
        long,
        value_name = "WxH",
        default_value = "640x480",
        allow_hyphen_values = true
    )]
    pub size: Size,

    /// How smooth edges are [default: draft]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_enum, value_name = "QUALITY", conflicts_with_all = ["samples", "adaptive"])]
    pub quality: Option<Quality>,

    /// Samples in each pixel; one lies in its centre
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "N", value_parser = samples, allow_negative_numbers = true)]
    pub samples: Option<u32>,

    /// Up to 1024 samples, until a pixel's estimated error in linear RGB is below this
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "TOL", value_parser = tolerance, allow_negative_numbers = true, conflicts_with = "samples")]
    pub adaptive: Option<f64>,

    /// Make everything so many times as bright
    #[arg(long, value_name = "TIMES", value_parser = exposure, allow_negative_numbers = true)]
    pub exposure: Option<f64>,

    /// How often a ray may be reflected or refracted
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    pub depth: u32,

    /// Leave out what counts for less than this; 0 leaves out nothing [default: 1/4096]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "W", value_parser = cutoff, allow_negative_numbers = true)]
    pub cutoff: Option<f64>,

    /// The numbers to compute with between a ray and what it hits
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_enum, default_value = "f64")]
    pub precision: Numbers,

    /// Draw this part of the picture only
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_name = "X,Y,W,H", allow_hyphen_values = true)]
    pub crop: Option<CropArg>,

    #[command(flatten)]
    pub camera: CameraArgs,

    #[command(flatten)]
    pub frames: FrameArgs,

    /// How the two pictures of a stereo camera are put [default: pair]
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_enum)]
    pub stereo: Option<Stereo>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Stereo {
    /// Two files, NAME_left and NAME_right
    #[default]
    Pair,
    /// One picture, left beside right
    SideBySide,
    /// One picture for red and cyan glasses
    Anaglyph,
}

/// Settings on the Pareto front of time and error, as `zpg accuracy` measures it; the reports are in `scenes/accuracy`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Quality {
    /// One sample in each pixel
    #[default]
    Draft,
    /// --adaptive 0.05: about ten times the time, a quarter of the error
    Good,
    /// --adaptive 0.01: about twenty times the time, a tenth of the error
    Final,
}

/// How many samples a pixel takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    Fixed(u32),
    Adaptive(f64),
}

impl Quality {
    fn sampling(self) -> Sampling {
        match self {
            Quality::Draft => Sampling::Fixed(1),
            Quality::Good => Sampling::Adaptive(0.05),
            Quality::Final => Sampling::Adaptive(0.01),
        }
    }
}

#[derive(Debug, Clone, Copy)]
pub struct CropArg(pub Crop);

impl FromStr for CropArg {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<CropArg, Complaint> {
        let numbers: Result<Vec<u32>, _> = s.split(',').map(|n| n.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x, y, width, height]) if width > 0 && height > 0 => Ok(CropArg(Crop {
                x,
                y,
                width,
                height,
            })),
            _ => Err(Complaint::new("expected-crop")),
        }
    }
}

fn samples(text: &str) -> Result<u32, Complaint> {
    usage::number(text, "expected-samples", |n| (1..=1_048_576).contains(&n))
}

/// Pictures of more pixels than this would need more memory than a machine can be taken to have.
const MAX_PIXELS: u64 = 1 << 28;

/// The bytes of memory that a pixel takes until it is in a file, with a fixed number of samples or an adaptive one.
/// Measured: up to 30 and 75.
const PIXEL_BYTES: f64 = 40.0;
const ADAPTIVE_PIXEL_BYTES: f64 = 96.0;

/// The bytes of memory that a pixel takes until it is in a file.
pub fn bytes_of_pixels(sampling: Sampling) -> f64 {
    match sampling {
        Sampling::Fixed(_) => PIXEL_BYTES,
        Sampling::Adaptive(_) => ADAPTIVE_PIXEL_BYTES,
    }
}

impl PictureArgs {
    /// The samples of each pixel, by `--samples`, `--adaptive` or `--quality`.
    pub fn sampling(&self) -> Sampling {
        match (self.samples, self.adaptive) {
            (Some(samples), _) => Sampling::Fixed(samples),
            (None, Some(tolerance)) => Sampling::Adaptive(tolerance),
            (None, None) => self.quality.unwrap_or_default().sampling(),
        }
    }

    /// The settings that draw the picture, or the band `tile` of it.
    ///
    /// # Errors
    ///
    /// The part of `--crop` is not within the picture, there are more bands than rows, or there are too many pixels.
    pub fn settings(&self, tile: Option<Tile>) -> Result<Settings, Error> {
        let Size { width, height } = self.size;
        let crop = self.crop.map(|c| c.0);
        if let Some(c) = crop {
            let fits = |at: u32, extent: u32, side: u32| {
                at.checked_add(extent).is_some_and(|end| end <= side)
            };
            if !fits(c.x, c.width, width) || !fits(c.y, c.height, height) {
                return Err(Complaint::new("crop-too-large")
                    .with("width", width.to_string())
                    .with("height", height.to_string())
                    .into());
            }
        }
        let rows = |height: u32| tile.map_or(Ok(0..height), |tile| tile.rows(height));
        let (w, h) = crop.map_or((width, height), |c| (c.width, c.height));
        if u64::from(w) * rows(h)?.len() as u64 > MAX_PIXELS {
            let max = MAX_PIXELS.to_string();
            return Err(Complaint::new("too-many-pixels").with("max", max).into());
        }
        let default = Settings::default();
        let (samples, tolerance) = match self.sampling() {
            Sampling::Fixed(samples) => (samples, None),
            Sampling::Adaptive(tolerance) => (1, Some(tolerance)),
        };
        Ok(Settings {
            width,
            height,
            crop,
            wanted: None,
            samples,
            tolerance,
            shift: [0.0; 2],
            depth: self.depth,
            cutoff: self.cutoff.unwrap_or(default.cutoff),
            numbers: self.precision,
            stop: None,
        })
    }
}

/// Reads a number from 0 to 1, or a fraction such as `1/4096`.
fn cutoff(text: &str) -> Result<f64, Complaint> {
    let number = |text: &str| usage::number(text, "expected-cutoff", |x: f64| x >= 0.0);
    let value = match text.split_once('/') {
        Some((part, whole)) => number(part)? / number(whole)?,
        None => number(text)?,
    };
    match (0.0..=1.0).contains(&value) {
        true => Ok(value),
        false => Err(Complaint::new("expected-cutoff")),
    }
}

fn tolerance(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-tolerance", |x| x > 0.0 && x <= 1.0)
}

fn exposure(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-exposure", |x: f64| x > 0.0 && x.is_finite())
}
