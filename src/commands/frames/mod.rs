//! Frames: scenes that are the same but for some numbers, which vary from one to the next.

mod motion;
mod table;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::help;
use super::usage;
use crate::analysis::parameters::Name;
use crate::diagnostics::{Complaint, Value};

pub use motion::Frames;

/// The most frames: more than an hour at 25 frames a second.
const MOST_FRAMES: u32 = 100_000;

/// The options that say how a scene's numbers vary.
#[derive(Debug, Default, clap::Args)]
pub struct FrameArgs {
    /// Draw a picture for each of these frames, as in 0-47: NAME.0000.png and so on, or one .apng. A single number is that
    /// frame alone
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "A-B")]
    frames: Option<Range>,

    /// Let a number vary from the first frame to the last, as in `9.fovy=30..60`, `5.x[3]=1..2` or `5@7.x=0..4`, where
    /// 7 is a line; the names are those that `zpg explain` lists
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "ID.PARAM=FROM..TO")]
    set: Vec<Set>,

    /// Take numbers from a table: a column for each, which its first row names, and a row for each frame
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "TABLE.csv")]
    frames_from: Option<PathBuf>,

    /// Turn a camera, or the two of a stereo camera, around what it looks at; 360 degrees make a loop
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "ID,DEGREES", conflicts_with = "view")]
    orbit: Vec<Orbit>,

    /// Draw only these of the frames
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "I-J")]
    only: Option<Range>,

    /// Frames a second of an .apng [default: 25]
    #[arg(help_heading = help::FRAMES)]
    #[arg(long, value_name = "N", value_parser = fps, allow_negative_numbers = true)]
    fps: Option<u16>,
}

/// A range of frames, with both ends among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range {
    pub first: u32,
    pub last: u32,
}

/// A number of the scene that varies evenly from the first frame to the last.
#[derive(Debug, Clone)]
struct Set {
    name: Name,
    from: f64,
    to: f64,
}

/// A camera that goes around what it looks at.
#[derive(Debug, Clone, Copy)]
struct Orbit {
    camera: u32,
    degrees: f64,
}

impl Range {
    fn count(self) -> u32 {
        self.last - self.first + 1
    }

    fn has(self, other: Range) -> bool {
        self.first <= other.first && other.last <= self.last
    }
}

impl Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}-{}", self.first, self.last)
    }
}

impl FromStr for Range {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Range, Complaint> {
        let wrong = || Complaint::new("expected-frames");
        let (first, last) = text.split_once('-').unwrap_or((text, text));
        let number = |text: &str| usage::number::<u32>(text, "expected-frames", |_| true);
        let (first, last) = (number(first)?, number(last)?);
        match last.checked_sub(first).ok_or_else(wrong)? {
            steps if steps < MOST_FRAMES => Ok(Range { first, last }),
            _ => Err(too_many()),
        }
    }
}

fn too_many() -> Complaint {
    Complaint::new("too-many-frames").with("most", MOST_FRAMES.to_string())
}

impl FromStr for Set {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Set, Complaint> {
        let wrong = || Complaint::new("expected-set");
        let (name, values) = text.split_once('=').ok_or_else(wrong)?;
        let (from, to) = values.split_once("..").ok_or_else(wrong)?;
        let number = |text| usage::number(text, "expected-set", |x: f64| x.is_finite());
        Ok(Set {
            name: name.parse()?,
            from: number(from)?,
            to: number(to)?,
        })
    }
}

impl FromStr for Orbit {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Orbit, Complaint> {
        let wrong = || Complaint::new("expected-orbit");
        let (camera, degrees) = text.split_once(',').ok_or_else(wrong)?;
        Ok(Orbit {
            camera: usage::number(camera, "expected-orbit", |_| true)?,
            degrees: usage::number(degrees.trim(), "expected-orbit", |x: f64| x.is_finite())?,
        })
    }
}

fn fps(text: &str) -> Result<u16, Complaint> {
    usage::number(text, "expected-fps", |n| (1..=1000).contains(&n))
}

impl FrameArgs {
    /// Whether frames are asked for, and not one picture.
    pub fn are_given(&self) -> bool {
        self.frames.is_some() || self.frames_from.is_some()
    }

    /// The table that numbers come from.
    pub fn table(&self) -> Option<&Path> {
        self.frames_from.as_deref()
    }

    /// Whether `--fps` is given.
    pub fn has_fps(&self) -> bool {
        self.fps.is_some()
    }

    /// Frames a second.
    pub fn fps(&self) -> u16 {
        self.fps.unwrap_or(25)
    }

    /// The number of the first frame; 0 if `--frames` does not say.
    pub fn first(&self) -> u32 {
        self.frames.map_or(0, |frames| frames.first)
    }

    /// The note for `--frames 5`: it draws frame 5 alone, and the user may have meant the first five. `None` for a
    /// range, and for frames 0 and 1.
    pub fn note(&self) -> Option<Complaint> {
        let frame = self.frames.filter(|f| f.first == f.last && f.first > 1)?;
        let last = frame.last - 1;
        Some(
            Complaint::new("note-one-frame")
                .with("frame", Value::Count(frame.first.into()))
                .with("last", last.to_string()),
        )
    }

    /// Makes sure that the options go together.
    ///
    /// # Errors
    ///
    /// Some say how frames differ, and none says which frames there are; or the other way round.
    pub fn check(&self) -> Result<(), Complaint> {
        let varies = [
            ("--set", !self.set.is_empty()),
            ("--orbit", !self.orbit.is_empty()),
        ];
        let others = [("--only", self.only.is_some()), ("--fps", self.has_fps())];
        let mut all = varies.iter().chain(&others);
        if !self.are_given() {
            return match all.find(|(_, is_given)| *is_given) {
                Some((arg, _)) => Err(Complaint::new("no-frames").with("arg", (*arg).to_owned())),
                None => Ok(()),
            };
        }
        let is_varied = self.frames_from.is_some() || varies.iter().any(|v| v.1);
        match is_varied {
            true => Ok(()),
            false => Err(Complaint::new("frames-alike")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges() {
        let range = |first, last| Ok(Range { first, last });
        assert_eq!("0-99".parse(), range(0, 99));
        assert_eq!("7".parse(), range(7, 7));
        assert_eq!(
            "4000000000-4000000001".parse(),
            range(4_000_000_000, 4_000_000_001)
        );
        for wrong in [
            "9-3",
            "-3",
            "3-",
            "a",
            "1-2-3",
            "",
            "0-100000",
            "0-4294967295",
        ] {
            assert!(wrong.parse::<Range>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn sets_and_orbits() {
        let ends = |text: &str| {
            text.parse::<Set>()
                .map(|s| (s.name.to_string(), s.from, s.to))
        };
        assert_eq!(ends("9.fovy=30..60"), Ok(("9.fovy".into(), 30.0, 60.0)));
        assert_eq!(ends("5.x[3]=-1.5..1e2"), Ok(("5.x[3]".into(), -1.5, 100.0)));
        for wrong in [
            "9.fovy",
            "9.fovy=30",
            "9.fovy=30..",
            "9.fovy=0..inf",
            "9=1..2",
            "9.x=nan..1",
        ] {
            assert!(ends(wrong).is_err(), "{wrong}");
        }
        let turn = |text: &str| text.parse::<Orbit>().map(|o| (o.camera, o.degrees));
        assert_eq!(turn("9,360"), Ok((9, 360.0)));
        assert_eq!(turn("9,-45.5"), Ok((9, -45.5)));
        for wrong in ["9", "9,", ",360", "9,inf", "x,3"] {
            assert!(turn(wrong).is_err(), "{wrong}");
        }
    }
}
