//! What is taken away from a union is taken away from those of its parts that it reaches.
//!
//! A part that is worked on is a long chain of unions and differences in turn, each deep within the next, although most
//! of them have nothing to do with each other. With every tool at the parts that it reaches the chain is one union of
//! parts with few cuts each, of which a ray looks at those on its way.

use crate::geometry::aabb::Aabb;
use crate::trace::graph::Part;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use std::collections::VecDeque;

/// A part of a union, less some others.
#[derive(Debug, Clone)]
pub(super) struct UnionMember {
    pub part: Part,
    /// The bounds of the part.
    pub bounds: Aabb,
    pub cuts: Vec<Part>,
}

/// Most boxes that are held against each other in a scene; beyond that what is drafted stays nested.
pub(super) const MAX_BOX_COMPARISONS: usize = 1 << 24;
/// Most members that a cut may reach, on average.
const MAX_MEMBERS_PER_CUT: usize = 8;
/// Times that all members are looked through before they get an index.
const SCANS_BEFORE_INDEX: usize = 32;

/// The pieces of a union, in the order of its operands.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    all: VecDeque<UnionMember>,
    /// The number of the first one; pieces that come before it later have numbers below.
    first: i64,
    /// How many pieces have been looked at, one after another.
    looked_at: usize,
    index: Option<Index>,
}

/// Where pieces are, by their numbers.
#[derive(Debug, Default)]
struct Index {
    bounded: RTree<GeomWithData<Rectangle<[f64; 3]>, i64>>,
    others: Vec<i64>,
}

impl Index {
    fn insert(&mut self, bounds: &Aabb, number: i64) {
        match bounds.is_bounded() {
            true => {
                let corners = Rectangle::from_corners(bounds.min, bounds.max);
                self.bounded.insert(GeomWithData::new(corners, number));
            }
            false => self.others.push(number),
        }
    }
}

impl FromIterator<UnionMember> for Pieces {
    fn from_iter<I: IntoIterator<Item = UnionMember>>(pieces: I) -> Pieces {
        Pieces {
            all: pieces.into_iter().collect(),
            ..Pieces::default()
        }
    }
}

impl IntoIterator for Pieces {
    type Item = UnionMember;
    type IntoIter = std::collections::vec_deque::IntoIter<UnionMember>;

    fn into_iter(self) -> Self::IntoIter {
        self.all.into_iter()
    }
}

impl Pieces {
    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// Appends the members behind these. The fewer ones move, so that no chain is long because it is built from one
    /// end.
    pub(super) fn followed_by(mut self, mut next: Pieces) -> Pieces {
        if self.len() >= next.len() {
            next.all.into_iter().for_each(|piece| self.push_back(piece));
            return self;
        }
        (self.all.into_iter().rev()).for_each(|piece| next.push_front(piece));
        next
    }

    fn push_back(&mut self, piece: UnionMember) {
        let number = self.first + self.len() as i64;
        if let Some(index) = &mut self.index {
            index.insert(&piece.bounds, number);
        }
        self.all.push_back(piece);
    }

    fn push_front(&mut self, piece: UnionMember) {
        self.first -= 1;
        if let Some(index) = &mut self.index {
            index.insert(&piece.bounds, self.first);
        }
        self.all.push_front(piece);
    }

    /// Takes cuts, with their bounds, away from the pieces that they reach. Does nothing, and says `false`, where that
    /// would only repeat them: a single cut that reaches both of two parts is better taken away from the two together.
    pub(super) fn cut(&mut self, cuts: &[(Part, Aabb)], budget: &mut usize) -> bool {
        if self.len() == 1 {
            self.all[0].cuts.extend(cuts.iter().map(|(cut, _)| cut));
            return true;
        }
        let mut left = cuts.len() * (1 + self.len() / 4).min(MAX_MEMBERS_PER_CUT);
        let mut reached = Vec::with_capacity(cuts.len());
        for (_, bounds) in cuts {
            let Some(pieces) = self.reached(bounds, budget) else {
                return false;
            };
            match left.checked_sub(pieces.len()) {
                Some(rest) => left = rest,
                None => return false,
            }
            reached.push(pieces);
        }
        for ((cut, _), pieces) in cuts.iter().zip(reached) {
            for number in pieces {
                self.all[(number - self.first) as usize].cuts.push(*cut);
            }
        }
        true
    }

    /// The numbers of the pieces that a cut reaches; `None` where the budget does not suffice to find them.
    fn reached(&mut self, bounds: &Aabb, budget: &mut usize) -> Option<Vec<i64>> {
        if self.index.is_none() && self.looked_at > SCANS_BEFORE_INDEX * self.len() {
            let mut index = Index::default();
            for (number, piece) in (self.first..).zip(&self.all) {
                index.insert(&piece.bounds, number);
            }
            self.index = Some(index);
        }
        let reaches = |number: &i64| {
            let piece = &self.all[(number - self.first) as usize];
            piece.bounds.overlaps(bounds)
        };
        let near: Vec<i64> = match &self.index {
            Some(index) if bounds.is_bounded() => {
                let around = AABB::from_corners(bounds.min, bounds.max);
                let found = index.bounded.locate_in_envelope_intersecting(around);
                (found.map(|entry| entry.data))
                    .chain(index.others.iter().copied())
                    .collect()
            }
            _ => {
                self.looked_at += self.len();
                (self.first..self.first + self.len() as i64).collect()
            }
        };
        *budget = budget.checked_sub(near.len())?;
        Some(near.into_iter().filter(reaches).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing;
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

    fn row(count: u32) -> Pieces {
        (0..count)
            .map(|i| UnionMember {
                part: part(i),
                bounds: at(3.0 * f64::from(i)),
                cuts: Vec::new(),
            })
            .collect()
    }

    fn cuts(pieces: &Pieces) -> Vec<usize> {
        pieces.all.iter().map(|p| p.cuts.len()).collect()
    }

    #[test]
    fn tools_go_to_what_they_reach() {
        let mut pieces = row(3);
        let mut budget = 100;
        // The second one touches, the last one is nowhere.
        let tools = [0.5, 4.0, 6.0, 20.0].map(|x| (part(9), at(x)));
        assert!(pieces.cut(&tools, &mut budget));
        assert_eq!((cuts(&pieces), budget), (vec![1, 1, 1], 88));
        let all = (part(9), Aabb::ALL);
        assert!(!pieces.cut(&[all], &mut budget));
        assert_eq!(cuts(&pieces), [1, 1, 1]);
    }

    #[test]
    fn one_part_has_all_cuts_and_no_work_is_endless() {
        let mut one = row(1);
        let tools = [(part(9), at(50.0)), (part(8), at(0.0))];
        assert!(one.cut(&tools, &mut 0));
        assert_eq!(cuts(&one), [2]);
        assert!(!row(3).cut(&tools, &mut 5));
    }

    /// An index finds what looking through all finds, in whatever order pieces come.
    #[test]
    fn many_pieces_are_found_by_where_they_are() {
        let mut random = testing::random();
        let mut pieces = Pieces::default();
        // As they are expected: a list that is looked through.
        let mut plain: VecDeque<(Aabb, usize)> = VecDeque::new();
        let mut budget = MAX_BOX_COMPARISONS;
        for i in 0..3000u32 {
            let bounds = match i % 500 {
                7 => Aabb::ALL,
                _ => at(random(1000) as f64),
            };
            let one = || {
                let piece = UnionMember {
                    part: part(i),
                    bounds,
                    cuts: Vec::new(),
                };
                Pieces::from_iter([piece])
            };
            if i % 3 == 0 {
                pieces = one().followed_by(pieces);
                plain.push_front((bounds, 0));
            } else {
                pieces = pieces.followed_by(one());
                plain.push_back((bounds, 0));
            }
            let tool = at(random(1000) as f64);
            let reached = plain.iter().filter(|(b, _)| b.overlaps(&tool)).count();
            let is_cut = pieces.cut(&[(part(9), tool)], &mut budget);
            assert_eq!(
                is_cut,
                plain.len() == 1 || reached <= (1 + plain.len() / 4).min(MAX_MEMBERS_PER_CUT)
            );
            for (bounds, count) in plain.iter_mut().filter(|_| is_cut) {
                *count += usize::from(i == 0 || bounds.overlaps(&tool));
            }
        }
        assert!(pieces.index.is_some());
        let expected: Vec<usize> = plain.iter().map(|(_, count)| *count).collect();
        assert_eq!(cuts(&pieces), expected);
    }
}
