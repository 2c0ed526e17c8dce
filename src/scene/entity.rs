//! What an ID stands for while the file is read.

use super::*;

/// The parts of an optical property; what is not given stays the default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct OpticsParts {
    pub optics: Option<Optics>,
    pub index: Option<Rgb>,
}

#[derive(Debug, Clone)]
pub enum State {
    Undefined,
    Object(NodeId),
    Optics(OpticsParts),
    Texture(Texture),
    Colour(Rgb),
    AmbientLight(AmbientLight),
    PointLight(PointLight),
    Camera(Camera),
    Selection,
    Render,
    /// Defined by a record that could not be read: references to it are no errors.
    Broken(Option<Kind>),
}

impl State {
    pub fn kind(&self) -> Option<Kind> {
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
            State::Broken(kind) => return *kind,
        })
    }
}
