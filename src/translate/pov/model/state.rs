//! Decisions about a node on the way down to it.

use super::tables::TextureUse;
use crate::scene::NodeId;

/// The layers of a node: an operation treats the solids and the surfaces among its operands differently, so they may be
/// written separately.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Layer {
    All,
    Solid,
    Surface,
}

/// The source of a node's look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Appearance {
    /// The node itself, except for the texture or the optics given here, which a node above paints over it.
    Own {
        texture: Option<TextureUse>,
        optics: Option<u32>,
    },
    /// An object around the node, which gives the same look to all of it.
    Above { transparent: bool },
}

/// The source of the refractive index in a node's inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Medium {
    Own,
    Above,
}

/// All decisions about a node on the way from the root down to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct State {
    pub layer: Layer,
    pub look: Appearance,
    pub medium: Medium,
    /// The number of the change that is made to the node's shapes, which nobody sees.
    pub flush: Option<u32>,
}

impl State {
    /// The state of the root, without any decision.
    pub(crate) const ROOT: State = State {
        layer: Layer::All,
        look: Appearance::Own {
            texture: None,
            optics: None,
        },
        medium: Medium::Own,
        flush: None,
    };
    /// The state of a solid that serves as geometry only: it tells inside from outside, and has no look or medium.
    pub(crate) const GEOMETRY: State = State {
        layer: Layer::Solid,
        look: Appearance::Above { transparent: false },
        medium: Medium::Above,
        flush: None,
    };

    pub(crate) fn layer(self, layer: Layer) -> State {
        State { layer, ..self }
    }

    pub(crate) fn look(self, look: Appearance) -> State {
        State { look, ..self }
    }

    pub(crate) fn flush(self, flush: Option<u32>) -> State {
        State { flush, ..self }
    }

    pub(crate) fn medium(self, medium: Medium) -> State {
        State { medium, ..self }
    }
}

/// A node in a state. An object is declared for each key.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    pub node: NodeId,
    pub state: State,
}
