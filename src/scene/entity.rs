//! What an ID stands for while the file is read.

use super::model::*;
use crate::syntax::table::Kind;

/// The parts of an optical property; what is not given stays the default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct OpticsParts {
    pub optics: Option<Optics>,
    pub index: Option<Rgb>,
}

/// Almost all of a large scene are objects: what is large and rare is boxed.
#[derive(Debug, Clone)]
pub enum State {
    Undefined,
    Object(NodeId),
    Optics(Box<OpticsParts>),
    Texture(Box<Texture>),
    Colour(Box<Rgb>),
    AmbientLight(Box<AmbientLight>),
    PointLight(Box<PointLight>),
    Camera(Box<Camera>),
    Selection,
    Render,
    /// Defined by a record that could not be read: references to it are no errors.
    Broken(Option<Kind>),
    /// It is in the scene already.
    Stored,
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
            State::Stored => return None,
        })
    }
}
