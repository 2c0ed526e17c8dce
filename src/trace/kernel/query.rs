//! Rays, and what is known about where they meet something.

use super::probe::Probe;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::trace::shapes::Root;

/// The number that stands for no leaf.
pub const NONE: u32 = u32::MAX;

/// A ray, and what it knows about where it starts.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    /// A bound on the distance of the origin from the surface that the ray starts on.
    pub skin: f64,
    /// The first leaf with the surface that the ray starts on, or [`NONE`]: see
    /// [`Leaf::twin`](super::leaf::Leaf::twin).
    pub left: u32,
    /// The face of that leaf that the ray starts on, for a leaf without lanes.
    pub face: u32,
    /// Whether the ray goes against the normal of that surface.
    pub goes_in: bool,
    pub within: Within,
}

impl Start {
    /// A ray that starts outside of everything, on no surface.
    #[inline(always)]
    pub fn outside(origin: Vec3, direction: Vec3) -> Start {
        Start {
            origin: origin.0,
            direction: direction.0,
            skin: 0.0,
            left: NONE,
            face: 0,
            goes_in: false,
            within: Within::NOTHING,
        }
    }
}

/// The solids that hold a place, as numbers of leaves: up to [`DEEPEST`] of them, filled up with [`NONE`]. Earlier
/// operands come first; the first solid owns the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Within(pub [u32; DEEPEST]);

/// The most solids that may hold one place.
pub const DEEPEST: usize = 4;

impl Within {
    pub const NOTHING: Within = Within([NONE; DEEPEST]);

    #[inline(always)]
    pub fn one(solid: u32) -> Within {
        let mut within = Within::NOTHING;
        within.0[0] = solid;
        within
    }

    /// The solid that owns the place, or [`NONE`] where there is no solid.
    #[inline(always)]
    pub fn owner(self) -> u32 {
        self.0[0]
    }

    #[inline(always)]
    pub fn is_empty(self) -> bool {
        self.0[0] == NONE
    }

    #[inline(always)]
    pub fn has(self, solid: u32) -> bool {
        solid != NONE && self.0.contains(&solid)
    }

    /// All solids but `solid`.
    #[inline(always)]
    pub fn without(self, solid: u32) -> Within {
        let mut within = self;
        if let Some(at) = self.0.iter().position(|&other| other == solid) {
            within.0.copy_within(at + 1.., at);
            within.0[DEEPEST - 1] = NONE;
        }
        within
    }

    /// Adds a solid before those that it precedes; `None` where there are too many.
    pub fn with(self, solid: u32, precedes: impl Fn(u32) -> bool) -> Option<Within> {
        let at = self
            .0
            .iter()
            .position(|&other| other == NONE || precedes(other))?;
        let mut within = self;
        within.0.copy_within(at..DEEPEST - 1, at + 1);
        within.0[at] = solid;
        (self.0[DEEPEST - 1] == NONE).then_some(within)
    }
}

/// A crossing that is nearer to the start than this many skins cannot be told from the start. The number is a little
/// more than one over the root of the unit roundoff.
pub const SKINS: f64 = 1.2e8;

/// A bound on the error of t for any surface, as a share of the numbers that t is computed from: a little more than the
/// bound of [`rough`](crate::trace::search::root_order::rough) for curved surfaces.
pub const BENT: f64 = 9e-7;

/// A ray, set up for a search.
#[derive(Debug)]
pub struct Query<'r> {
    pub start: &'r Start,
    pub line: Line,
    pub probe: Probe,
    /// The t beyond which a place cannot be taken for the ray's start.
    pub skin: f64,
}

impl Query<'_> {
    #[inline(always)]
    pub fn new(start: &Start) -> Query<'_> {
        let line = Line::new(Vec3(start.origin), Vec3(start.direction));
        let probe = Probe::new(&line);
        // The length of the direction is between its largest component and 1.8 times that component.
        let skin = start.skin * SKINS * probe.per_pace;
        Query {
            start,
            line,
            probe,
            skin,
        }
    }
}

/// A place on a ray, with a bound on its error.
#[derive(Debug, Clone, Copy)]
pub struct End {
    pub t: f64,
    pub error: f64,
}

impl End {
    /// A place that is never reached.
    pub const NEVER: End = End {
        t: f64::INFINITY,
        error: 0.0,
    };

    /// Whether this place is before `other`, whatever the errors.
    #[inline(always)]
    pub fn is_before(&self, other: End) -> bool {
        self.t + self.error < other.t - other.error
    }
}

/// A place where a ray meets a surface.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// The leaf whose surface it is.
    pub surface: u32,
    /// The crossing as the arbiter finds it; for a leaf with lanes a rough place.
    pub root: Root,
    pub end: End,
    /// Whether the ray comes out of the leaf.
    pub is_exit: bool,
}

/// The face of a crossing whose place is known only roughly.
pub const UNKNOWN_FACE: u32 = u32::MAX;

impl Crossing {
    /// The crossing of a ray that meets nothing.
    pub const NONE: Crossing = Crossing {
        surface: NONE,
        root: Root { t: 0.0, face: 0 },
        end: End::NEVER,
        is_exit: false,
    };
}

/// The crossings of a ray with a leaf that are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ask {
    First,
    All,
    /// Nothing but whether there is a crossing.
    Any,
}

/// How a ray crosses a leaf ahead of its start.
pub enum Crossed {
    Nothing,
    /// The ray surely goes through, and nobody has asked where.
    Somewhere,
    /// Rounding may have decided something.
    Doubt,
    /// The ray crosses at the places in [`Scratch::ahead`](super::scratch::Scratch::ahead).
    Ahead,
}

/// The numbers of tests that were made against boxes and shapes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tests {
    pub boxes: u32,
    pub shapes: u32,
}

impl Tests {
    /// Adds the numbers of `more`.
    #[inline(always)]
    pub fn add(&mut self, more: Tests) {
        self.boxes += more.boxes;
        self.shapes += more.shapes;
    }
}
