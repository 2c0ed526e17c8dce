//! The choice of the camera: one of the scene, or one that looks at it from a side.

use super::help;
use super::size::Size;
use super::terminal::{LookChoice, note};
use super::usage;
use crate::diagnostics::{Complaint, Error};
use crate::scene::{Camera, Scene};
use crate::solids::staging::{self, Side, Viewpoint};
use clap::ValueEnum;
use clap::builder::PossibleValue;
use std::borrow::Cow;

/// The options that choose a camera.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct CameraArgs {
    /// Take the picture with this camera of the scene
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_name = "ID", value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    camera: Option<u32>,

    /// Look at the scene from this side instead, whatever its cameras are
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_enum, value_name = "SIDE", conflicts_with = "camera")]
    view: Option<Side>,
}

impl ValueEnum for Side {
    fn value_variants<'a>() -> &'a [Side] {
        &[
            Side::Front,
            Side::Back,
            Side::Left,
            Side::Right,
            Side::Top,
            Side::Bottom,
            Side::Iso,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Side::Front => ("front", "Along −z"),
            Side::Back => ("back", "Along +z"),
            Side::Left => ("left", "Along +x"),
            Side::Right => ("right", "Along −x"),
            Side::Top => ("top", "Along −y"),
            Side::Bottom => ("bottom", "Along +y"),
            Side::Iso => ("iso", "From the right, the front and above alike"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

/// The most cameras that are listed in the complaint that no camera has the ID.
const NAMED: usize = 20;

impl CameraArgs {
    /// Whether a camera or a side was asked for.
    pub fn is_given(self) -> bool {
        self.camera.is_some() || self.view.is_some()
    }

    /// Whether a side was asked for.
    pub fn is_side(self) -> bool {
        self.view.is_some()
    }

    /// The viewpoint that the options choose: a camera of the scene, a side, or what the scene itself chooses.
    ///
    /// # Errors
    ///
    /// There is no camera with the ID. The error lists the scene's cameras.
    pub fn viewpoint(self, scene: &Scene) -> Result<Viewpoint, Error> {
        match (self.camera, self.view) {
            (Some(id), _) => Ok(Viewpoint::Camera(number(scene, id)?)),
            (None, Some(side)) => Ok(Viewpoint::Side(side)),
            (None, None) => Ok(Viewpoint::Scene),
        }
    }

    /// The scene as it is drawn in a picture of this size: with the chosen camera, and with a light if it has none.
    ///
    /// # Errors
    ///
    /// The same errors as [`viewpoint`](Self::viewpoint).
    pub fn staged(self, scene: &Scene, size: Size) -> Result<Cow<'_, Scene>, Error> {
        let aspect = f64::from(size.width) / f64::from(size.height);
        Ok(staging::staged(scene, self.viewpoint(scene)?, aspect))
    }
}

/// The camera that takes the picture of a staged scene. Of a stereo pair it is the left camera, and a note says so.
///
/// # Errors
///
/// The scene has no camera that takes the picture.
pub(super) fn one_camera(staged: &Scene, look: LookChoice) -> Result<Camera, Error> {
    let mut cameras = staged.chosen_cameras();
    let camera = *cameras.next().ok_or_else(Error::nothing_to_draw)?;
    if cameras.next().is_some() {
        note(
            look,
            &Complaint::new("note-left-eye").with("id", camera.id.to_string()),
        );
    }
    Ok(camera)
}

/// The index of the camera with this ID among the scene's cameras.
///
/// # Errors
///
/// No camera has the ID. The error lists the scene's cameras.
pub(super) fn number(scene: &Scene, id: u32) -> Result<usize, Error> {
    let cameras = &scene.cameras;
    if let Some(number) = cameras.iter().position(|c| c.id == id) {
        return Ok(number);
    }
    let mut named: Vec<String> = (cameras.iter().take(NAMED))
        .map(|c| c.id.to_string())
        .collect();
    if cameras.len() > NAMED {
        named.push("…".to_owned());
    }
    let message = match cameras.len() {
        0 => "no-cameras",
        _ => "no-such-camera",
    };
    let complaint = Complaint::new(message).with("id", id.to_string());
    Err(Error::Request(match named.is_empty() {
        true => complaint,
        false => complaint.with("cameras", named.join(", ")),
    }))
}
