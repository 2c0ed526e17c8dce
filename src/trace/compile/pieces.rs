//! What is taken away from a union is taken away from those of its parts that it reaches.
//!
//! A part that is worked on is a long chain of unions and differences in turn, each deep within the next, although most
//! of them have nothing to do with each other. With every tool at the parts that it reaches the chain is one union of
//! parts with few cuts each, of which a ray looks at those on its way.

use crate::geometry::aabb::Aabb;
use crate::trace::graph::Part;

/// A part of a union, less some others.
#[derive(Debug, Clone)]
pub struct Piece {
    pub part: Part,
    /// Of the part.
    pub bounds: Aabb,
    pub cuts: Vec<Part>,
}

/// So many boxes are held against each other in a scene; beyond that what is drafted stays nested.
pub const BUDGET: usize = 1 << 24;
/// So many parts may be reached by a cut, on average.
const MOST: usize = 8;

/// Takes cuts, with their bounds, away from the pieces that they reach. Does nothing, and says `false`, where that
/// would only repeat them: a single cut that reaches both of two parts is better taken away from the two together.
pub fn cut(pieces: &mut [Piece], cuts: &[(Part, Aabb)], budget: &mut usize) -> bool {
    if let [only] = pieces {
        only.cuts.extend(cuts.iter().map(|(cut, _)| cut));
        return true;
    }
    let Some(left) = budget.checked_sub(pieces.len() * cuts.len()) else {
        return false;
    };
    *budget = left;
    let reaches = |piece: &Piece, bounds: &Aabb| piece.bounds.overlaps(bounds);
    let reached = |(_, bounds): &(Part, Aabb)| pieces.iter().filter(|p| reaches(p, bounds)).count();
    let all: usize = cuts.iter().map(reached).sum();
    if all > cuts.len() * (1 + pieces.len() / 4).min(MOST) {
        return false;
    }
    for piece in pieces {
        let own: Vec<Part> = (cuts.iter())
            .filter(|(_, bounds)| reaches(piece, bounds))
            .map(|(cut, _)| *cut)
            .collect();
        piece.cuts.extend(own);
    }
    true
}
