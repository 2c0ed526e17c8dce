//! Distribution of differences: a solid that is taken away from a union is taken away only from the parts that it
//! reaches.
//!
//! A workpiece is often a long chain of unions and differences, nested in one another, although most of the tools and
//! parts have nothing to do with each other. Here each tool goes to the parts that it reaches. The chain becomes one
//! union of parts with few cuts each, and a ray looks only at the parts on its way.

use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::trace::graph::Part;
use std::collections::VecDeque;
use std::ops::ControlFlow;

/// A part of a union, less the parts that are cut out of it.
#[derive(Debug, Clone)]
pub(super) struct UnionMember {
    pub part: Part,
    /// The bounds of the part.
    pub bounds: Aabb,
    pub cuts: Vec<Part>,
}

/// The most comparisons of boxes in a scene. Differences that are finished after that stay nested.
pub(super) const MAX_BOX_COMPARISONS: usize = 1 << 24;
/// The most members that a cut may reach, on average.
const MAX_MEMBERS_PER_CUT: usize = 8;
/// How often all members are looked through before they get an index.
const SCANS_BEFORE_INDEX: usize = 32;
/// The number of new pieces that are put together into a tree; fewer are looked through.
const NEW_PIECES: usize = 32;

/// The pieces of a union, in the order of its operands.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    all: VecDeque<UnionMember>,
    /// The number of the first piece. Pieces that are put before it later have smaller numbers, which may be below 0.
    first: i64,
    /// How many pieces have been looked at one after another, without the index.
    looked_at: usize,
    index: Option<Index>,
}

/// Index of the pieces by place: trees of doubling sizes, so that pieces can be added (Bentley and Saxe, "Decomposable
/// searching problems I", J. Algorithms 1, 1980).
#[derive(Debug, Default)]
struct Index {
    /// The trees, the largest first. Their items are the last 32 bits of the numbers of pieces.
    trees: Vec<Bvh>,
    /// Pieces that are in no tree yet.
    new: Vec<(u32, Aabb)>,
    /// Pieces without bounds.
    others: Vec<u32>,
}

impl Index {
    /// Adds the piece with a number. `boxes` returns the bounds of a piece that has been added.
    fn insert(&mut self, bounds: &Aabb, number: u32, boxes: impl Fn(u32) -> Aabb) {
        if !bounds.is_bounded() {
            self.others.push(number);
            return;
        }
        self.new.push((number, *bounds));
        if self.new.len() < NEW_PIECES {
            return;
        }
        let mut all = std::mem::take(&mut self.new);
        while let Some(tree) = self.trees.pop_if(|tree| tree.items.len() <= all.len()) {
            all.extend(tree.items.into_iter().map(|number| (number, boxes(number))));
        }
        self.trees.push(Bvh::new(all));
    }

    /// The numbers of all pieces that may reach a box.
    fn near(&self, around: &Aabb) -> Vec<u32> {
        let mut near = self.others.clone();
        near.extend(self.new.iter().map(|(number, _)| number));
        for tree in &self.trees {
            let _ = tree.visit(around, |number| {
                near.push(number);
                ControlFlow::Continue(())
            });
        }
        near
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

    /// Appends `next` behind these pieces. The shorter list moves into the longer one, so that building a long chain
    /// from either end takes little time.
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
        self.all.push_back(piece);
        self.note(number);
    }

    fn push_front(&mut self, piece: UnionMember) {
        self.first -= 1;
        self.all.push_front(piece);
        self.note(self.first);
    }

    /// Adds a piece to the index, if there is one.
    fn note(&mut self, number: i64) {
        let Pieces {
            all, first, index, ..
        } = self;
        if let Some(index) = index {
            let bounds = |number: u32| all[number.wrapping_sub(*first as u32) as usize].bounds;
            let number = number as u32;
            index.insert(&bounds(number), number, bounds);
        }
    }

    /// Takes cuts, given with their bounds, away from the pieces that they reach. Does nothing and returns `false` if
    /// the cuts would be repeated too often, or if the budget does not suffice. For example, a single cut that reaches
    /// both of two pieces is better taken away from the two together.
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
            for place in pieces {
                self.all[place].cuts.push(*cut);
            }
        }
        true
    }

    /// The places of the pieces that a cut reaches; `None` where the budget does not suffice to find them.
    fn reached(&mut self, bounds: &Aabb, budget: &mut usize) -> Option<Vec<usize>> {
        if self.index.is_none() && self.looked_at > SCANS_BEFORE_INDEX * self.len() {
            self.index = Some(Index::default());
            (self.first..self.first + self.len() as i64).for_each(|number| self.note(number));
        }
        let place = |number: u32| number.wrapping_sub(self.first as u32) as usize;
        let near: Vec<usize> = match &self.index {
            Some(index) if bounds.is_bounded() => {
                index.near(bounds).into_iter().map(place).collect()
            }
            _ => {
                self.looked_at += self.len();
                (0..self.len()).collect()
            }
        };
        *budget = budget.checked_sub(near.len())?;
        let reaches = |&place: &usize| self.all[place].bounds.overlaps(bounds);
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

    /// The box from x to x + 1.
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
