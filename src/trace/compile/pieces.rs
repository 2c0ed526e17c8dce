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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::graph::Target;

    fn part(shape: u32) -> Part {
        Part {
            target: Target::Shape(shape),
            placement: 0,
            paint: 0,
            inverted: false,
            shape,
            owner: 0,
        }
    }

    /// From x to x + 1.
    fn at(x: f64) -> Aabb {
        Aabb::new([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0])
    }

    fn row(count: u32) -> Vec<Piece> {
        (0..count)
            .map(|i| Piece {
                part: part(i),
                bounds: at(3.0 * f64::from(i)),
                cuts: Vec::new(),
            })
            .collect()
    }

    fn cuts(pieces: &[Piece]) -> Vec<usize> {
        pieces.iter().map(|p| p.cuts.len()).collect()
    }

    #[test]
    fn tools_go_to_what_they_reach() {
        let mut pieces = row(3);
        let mut budget = 100;
        // The second one touches, the last one is nowhere.
        let tools = [0.5, 4.0, 6.0, 20.0].map(|x| (part(9), at(x)));
        assert!(cut(&mut pieces, &tools, &mut budget));
        assert_eq!((cuts(&pieces), budget), (vec![1, 1, 1], 88));
        let all = (part(9), Aabb::ALL);
        assert!(!cut(&mut pieces, &[all], &mut budget));
        assert_eq!(cuts(&pieces), [1, 1, 1]);
    }

    #[test]
    fn one_part_has_all_cuts_and_no_work_is_endless() {
        let mut one = row(1);
        let tools = [(part(9), at(50.0)), (part(8), at(0.0))];
        assert!(cut(&mut one, &tools, &mut 0));
        assert_eq!(cuts(&one), [2]);
        assert!(!cut(&mut row(3), &tools, &mut 5));
    }
}
