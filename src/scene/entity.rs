//! The values of IDs while the file is read.

use super::model::*;
use crate::syntax::table::Kind;

/// The parts of an optical property. A part that is not given keeps its default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct OpticsParts {
    pub optics: Option<Optics>,
    pub index: Option<Rgb>,
}

/// The value of an ID. The number in `Object` is a node. The other numbers are indices into the lists of [`Values`]. No
/// two IDs share a value.
#[derive(Debug, Clone, Copy)]
pub(super) enum State {
    Undefined,
    Object(NodeId),
    Optics(u32),
    Texture(u32),
    Colour(u32),
    AmbientLight(u32),
    PointLight(u32),
    Camera(u32),
    Selection,
    Render,
    /// An ID that a broken record defines. A reference to it is an error only if the kind is known and does not fit.
    Broken(Option<Kind>),
    /// An ID whose value is in the scene already.
    Stored,
}

// A large scene has millions of these values.
const _: () = assert!(size_of::<State>() == 8);

/// The values of all entities that are not objects.
#[derive(Debug, Default)]
pub(super) struct Values {
    pub optics: Vec<OpticsParts>,
    pub textures: Vec<Texture>,
    pub colours: Vec<Rgb>,
    pub ambient_lights: Vec<AmbientLight>,
    pub point_lights: Vec<PointLight>,
    pub cameras: Vec<Camera>,
}

/// Adds a value and returns its index.
pub(super) fn keep<T>(values: &mut Vec<T>, value: T) -> u32 {
    values.push(value);
    values.len() as u32 - 1
}

/// Adds a copy of the value at index `at` and returns the index of the copy.
pub(super) fn again<T: Clone>(values: &mut Vec<T>, at: u32) -> u32 {
    let value = values[at as usize].clone();
    keep(values, value)
}

impl State {
    pub(super) fn kind(self) -> Option<Kind> {
        Some(match self {
            State::Undefined => Kind::Undefined,
            State::Object(_) => Kind::Object,
            State::Optics(_) => Kind::Optics,
            State::Texture(_) => Kind::Texture,
            State::Colour(_) => Kind::Colour,
            State::AmbientLight(_) => Kind::AmbientLight,
            State::PointLight(_) => Kind::PointLight,
            State::Camera(_) => Kind::Camera,
            State::Selection => Kind::Selection,
            State::Render => Kind::Render,
            State::Broken(kind) => return kind,
            State::Stored => return None,
        })
    }
}
