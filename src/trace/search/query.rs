//! Queries: the aim of a search, the nodes that wait in it, the start of a ray, and the notes of a search besides its
//! answer.

use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::Child;
use crate::trace::graph::Holds;
use crate::trace::precision::Precision;
use crate::trace::shapes::support::Passage;

/// The event that a search wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// The first event.
    First,
    /// Any event.
    Any,
    /// Any event with an opaque object.
    AnyOpaque,
    /// Any event with a transparent object.
    AnyClear,
}

impl Search {
    /// Whether the search depends on the material of an object.
    pub(in crate::trace) fn is_picky(self) -> bool {
        matches!(self, Search::AnyOpaque | Search::AnyClear)
    }

    /// Whether the search looks at a part that holds these sorts of media.
    pub(in crate::trace) fn wants(self, holds: Holds) -> bool {
        match self {
            Search::First | Search::Any => true,
            Search::AnyOpaque => holds.opaque,
            Search::AnyClear => holds.clear,
        }
    }
}

/// A node to be visited, and the least t at which it may be met.
#[derive(Debug, Clone, Copy)]
pub(in crate::trace) struct PendingNode {
    pub(in crate::trace) near: f64,
    pub(in crate::trace) context: u32,
    /// A node of the tree of the context's object, or a part of the object.
    pub(in crate::trace) child: Child,
}

/// The sizes of the numbers that a crossing is computed from: `reach` of the coordinates, `pace` of the line's
/// direction.
#[derive(Debug, Clone, Copy, Default)]
pub struct Scale<R> {
    pub(in crate::trace) reach: R,
    pub(in crate::trace) pace: R,
}

/// The start of a ray, and how exactly it is known.
#[derive(Debug, Clone, Copy)]
pub struct Start<R> {
    pub(in crate::trace) t: R,
    /// Bound on the error of t.
    pub(in crate::trace) error: R,
    /// The number of the chain of maps that places the surface of the start, and how far, in t, the surface may be
    /// misplaced; `None` for a start on no surface.
    pub(in crate::trace) chain: Option<(u64, R)>,
    /// How the ray passes the surface that its starting face is a part of.
    pub(in crate::trace) passage: Option<Passage>,
}

impl<R: Precision> Start<R> {
    pub(in crate::trace) fn exact(t: R) -> Start<R> {
        Start {
            t,
            error: R::ZERO,
            chain: None,
            passage: None,
        }
    }
}

/// The findings about the present question besides its answer.
#[derive(Debug, Clone, Copy)]
pub struct QueryStatus<R = f64> {
    /// Whether a decision was closer than its rounding errors.
    pub uncertain: bool,
    /// Whether some surface could not be told from the one that the ray has left.
    pub skin_met: bool,
    /// The crossing of the ray with the surface that it has left, if there is one; in double-double only.
    pub start: Option<Start<R>>,
    /// A flat face that the ray lies in.
    pub along: Option<Along>,
}

impl<R> Default for QueryStatus<R> {
    fn default() -> QueryStatus<R> {
        QueryStatus {
            uncertain: false,
            skin_met: false,
            start: None,
            along: None,
        }
    }
}

/// A flat face that a ray lies in.
#[derive(Debug, Clone, Copy)]
pub struct Along {
    /// The unit normal of the face, in the scene's space.
    pub normal: Vec3,
    /// A bound on the sizes of the numbers that the face was found with.
    pub reach: f64,
}
