//! The objects that are written: what they are made of and what is said about them.

use super::aspects::TextureUse;
use crate::geometry::Matrix;
use crate::scene::NodeId;

/// Which part of a node is meant: an operation treats the solids and the surfaces among its
/// operands differently.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    All,
    Solid,
    Surface,
}

/// Who says what a node looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Look {
    /// The node itself, except for what is painted over it from above.
    Own {
        texture: Option<TextureUse>,
        optics: Option<u32>,
    },
    /// An object around it, all of it alike.
    Above { transparent: bool },
}

/// Who says what index the inside of a node has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Medium {
    Own,
    Above,
}

/// All that the way from the root down to a node decides about it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct State {
    pub part: Part,
    pub look: Look,
    pub medium: Medium,
    /// The number of the change that is made to its shapes.
    pub flush: Option<u32>,
}

impl State {
    /// Nothing is decided.
    pub const ROOT: State = State {
        part: Part::All,
        look: Look::Own {
            texture: None,
            optics: None,
        },
        medium: Medium::Own,
        flush: None,
    };
    /// A solid that only tells inside from outside.
    pub const GEOMETRY: State = State {
        part: Part::Solid,
        look: Look::Above { transparent: false },
        medium: Medium::Above,
        flush: None,
    };

    pub fn part(self, part: Part) -> State {
        State { part, ..self }
    }

    pub fn look(self, look: Look) -> State {
        State { look, ..self }
    }

    pub fn flush(self, flush: Option<u32>) -> State {
        State { flush, ..self }
    }

    pub fn medium(self, medium: Medium) -> State {
        State { medium, ..self }
    }
}

/// A node in a state: what one `#declare` is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    pub node: NodeId,
    pub state: State,
}

/// Something said about an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Modifier {
    Matrix(Matrix),
    /// Number of a look.
    Look(u32),
    /// Number of a look, of the side that the normals are not on, lit from behind.
    Behind(u32),
    /// All light goes through, and nothing is seen.
    Unseen,
    /// All light goes through where it comes from inside; what is seen from outside was said before.
    UnseenWithin,
    /// Number of an index.
    Interior(u32),
    Inverse,
    /// Only what lies inside is there; or only what lies outside.
    Clip {
        by: std::boxed::Box<Piece>,
        outside: bool,
    },
}

/// An object.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    pub body: Body,
    /// In the order they apply: the innermost first.
    pub modifiers: Vec<Modifier>,
    /// The entity it comes from, 0 where it has none of its own.
    pub id: u32,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Index of a shape, and the number of the change that is made to it.
    Shape(u32, Option<u32>),
    Declared(Key),
    /// All of space.
    Everything,
    Group {
        kind: Group,
        members: Vec<Piece>,
    },
}

/// POV-Ray's operations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    Union,
    Merge,
    Intersection,
    Difference,
    /// A difference whose cut faces take the texture of the part they cut.
    CutawayDifference,
}

impl Piece {
    pub fn new(body: Body, id: u32) -> Piece {
        Piece {
            body,
            modifiers: Vec::new(),
            id,
        }
    }

    /// One object of several; of a single one itself, unless something is taken from it.
    pub fn group(kind: Group, mut members: Vec<Piece>) -> Piece {
        match (members.len(), members.pop()) {
            (1, Some(only)) => only,
            (_, last) => {
                members.extend(last);
                Piece::new(Body::Group { kind, members }, 0)
            }
        }
    }

    pub fn with(mut self, modifiers: impl IntoIterator<Item = Modifier>) -> Piece {
        self.modifiers.extend(modifiers);
        self
    }

    /// Calls `f` with the declared objects that this one needs.
    pub fn for_each_declared(&self, f: &mut impl FnMut(Key)) {
        // Groups nest a few levels deep at most: deeper operations are declared objects.
        match &self.body {
            Body::Declared(key) => f(*key),
            Body::Group { members, .. } => members.iter().for_each(|m| m.for_each_declared(f)),
            Body::Shape(..) | Body::Everything => {}
        }
        for modifier in &self.modifiers {
            if let Modifier::Clip { by, .. } = modifier {
                by.for_each_declared(f);
            }
        }
    }
}
