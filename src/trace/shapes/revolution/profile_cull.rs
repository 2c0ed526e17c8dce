//! A cheap test that tells which pieces of a profile a line surely misses. Four pieces are tested at once.
//!
//! [`path`](super::path) explains s, y, δ and along. At the height of a ring of radius r the line is inside of the ring
//! where along²(ρ² − r²) is negative. Over a piece with the ends 1 and 2 this is a quadratic in the height. Its
//! coefficients in Bernstein's basis are (along·s₁)(along·s₂) + along²(δ² − r₁r₂), and the same with end 1 twice and
//! with end 2 twice. If all three are positive the line passes outside of the piece. If the line is inside of both
//! rings it is inside of the frustum between them.
//!
//! The test computes in doubles, in units of the solid's size, from a line that
//! [`Ball::meets`](super::super::quick_reject::Ball::meets) knows well enough. A piece that is closer than a margin
//! counts as met, and the path decides.

use super::overlap_removal::Subsegment;
use super::tree::{self, Run};
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::trace::shapes::quick_reject::{Ball, POLYNOMIAL_MARGIN};
use wide::f64x4;

const LANES: usize = 4;

/// The ends of four pieces: radii, and heights above the centre.
#[derive(Debug, Clone, PartialEq)]
struct Block {
    radius: [f64x4; 2],
    height: [f64x4; 2],
}

/// Map from the scaled coordinates of a profile to those of blocks.
struct Units {
    scale: f64,
    centre: f64,
    size: f64,
}

impl Units {
    fn radius(&self, r: f64) -> f64 {
        r / self.scale / self.size
    }

    fn height(&self, y: f64) -> f64 {
        (y / self.scale - self.centre) / self.size
    }
}

/// The pieces of a profile, laid out for the test.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Beside {
    /// The centre and the radius of the ball around the solid.
    centre: f64,
    size: f64,
    /// The pieces of each leaf of the tree, four to a block, leaf after leaf.
    blocks: Vec<Block>,
    /// For each run of the tree, the first block at or after it.
    first: Vec<u32>,
    /// For each run, its least and greatest radius, and its lowest and highest height.
    boxes: Vec<[f64; 4]>,
}

/// A line in units of the solid's size, relative to the solid's centre. [`path`](super::path) explains its numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passing {
    /// along · s₀, where s₀ is the line's s at the height `height`.
    turn: f64,
    height: f64,
    across: f64,
    along2: f64,
    delta2: f64,
    /// The lowest and the highest height that matter.
    within: [f64; 2],
}

impl Passing {
    /// along · s at a height.
    fn offset(&self, height: f64) -> f64 {
        (height - self.height).mul_add(self.across, self.turn)
    }
}

impl Beside {
    /// The table for a profile whose points are `scale` times as large, and the tree over its pieces.
    pub(super) fn new(
        points: &[[f64; 2]],
        pieces: &[Subsegment],
        tree: &[Run],
        scale: f64,
    ) -> Beside {
        let Some(all) = tree.first() else {
            return Beside::default();
        };
        let [low, high] = each(all.y, |y| y / scale);
        let centre = 0.5 * low + 0.5 * high;
        let half = high - centre;
        let size = libm::hypot(half, all.radius[1] / scale);
        let units = Units {
            scale,
            centre,
            size,
        };
        let mut blocks = Vec::new();
        let first = tree.iter().map(|run| {
            let here = blocks.len() as u32;
            if run.is_leaf() {
                let pieces = &pieces[run.first as usize..run.end as usize];
                blocks.extend(pieces.chunks(LANES).map(|four| {
                    // Lanes without a piece of their own repeat the last one.
                    let piece = |lane: usize| &four[lane.min(four.len() - 1)];
                    let ends = each([0, 1, 2, 3], |lane| [piece(lane).from, piece(lane).to]);
                    let of = |end: usize, axis: usize, unit: fn(&Units, f64) -> f64| {
                        f64x4::new(each(ends, |e| unit(&units, points[e[end] as usize][axis])))
                    };
                    Block {
                        radius: each([0, 1], |end| of(end, 0, Units::radius)),
                        height: each([0, 1], |end| of(end, 1, Units::height)),
                    }
                }));
            }
            here
        });
        let first = first.collect();
        let boxes = tree.iter().map(|run| {
            let [inner, outer] = each(run.radius, |r| units.radius(r));
            let [low, high] = each(run.y, |y| units.height(y));
            [inner, outer, low, high]
        });
        Beside {
            centre,
            size,
            first,
            boxes: boxes.collect(),
            blocks,
        }
    }

    /// A line in units of the solid's size; `None` where the line misses the ball around the solid or is not known well
    /// enough. With `ahead` only what lies ahead of the line's origin matters: the heights from there on, upwards or
    /// downwards as the line goes.
    pub(super) fn passing(&self, line: &Line, ahead: bool) -> Option<Passing> {
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        let centre = Vec3::new(0.0, self.centre, 0.0);
        let Ball::Meets(approach) = Ball::meets(line, all, centre, self.size) else {
            return None;
        };
        let (p, d) = (approach.point / self.size, approach.direction);
        let across = (d[0] * d[0] + d[2] * d[2]).sqrt();
        // In the plan: the place along the line, and the line's distance from the axis with a sign.
        let (s, delta) = match across > 0.0 {
            true => (
                (p[0] * d[0] + p[2] * d[2]) / across,
                (p[0] * d[2] - p[2] * d[0]) / across,
            ),
            false => (p[0], p[2]),
        };
        let start = p[1] + d[1] * (approach.origin / self.size);
        let within = match ahead {
            false => all,
            true if d[1] > 0.0 => [start - POLYNOMIAL_MARGIN, f64::INFINITY],
            true => [f64::NEG_INFINITY, start + POLYNOMIAL_MARGIN],
        };
        Some(Passing {
            turn: d[1] * s,
            height: p[1],
            across,
            along2: d[1] * d[1],
            delta2: delta * delta,
            within,
        })
    }

    /// The leaves of a tree that a line may meet, each with a mask of the pieces that the line may cross: a bit each,
    /// from the lowest.
    #[inline]
    pub(super) fn met<'a>(
        &'a self,
        tree: &'a [Run],
        line: &'a Passing,
    ) -> impl Iterator<Item = (&'a Run, u32)> {
        let leaves = tree::leaves(tree, |here, _| self.misses(here, line));
        leaves.map(|(here, run)| (run, self.met_of(here, run, line)))
    }

    /// Whether a line surely misses all pieces of a run.
    fn misses(&self, run: usize, line: &Passing) -> bool {
        let [inner, outer, low, high] = self.boxes[run];
        let (a, b) = (line.offset(low), line.offset(high));
        let (least, most) = match (a < 0.0) == (b < 0.0) {
            true => (a.abs().min(b.abs()), a.abs().max(b.abs())),
            false => (0.0, a.abs().max(b.abs())),
        };
        let outside = least * least + line.along2 * (line.delta2 - outer * outer);
        let inside = most * most + line.along2 * (line.delta2 - inner * inner);
        let [bottom, top] = line.within;
        outside > POLYNOMIAL_MARGIN || inside < -POLYNOMIAL_MARGIN || high < bottom || low > top
    }

    #[inline]
    fn met_of(&self, here: usize, run: &Run, line: &Passing) -> u32 {
        let (first, count) = (self.first[here] as usize, (run.end - run.first) as usize);
        let blocks = &self.blocks[first..first + count.div_ceil(LANES)];
        let of_line = [
            line.turn,
            line.height,
            line.across,
            line.along2,
            line.delta2,
        ];
        let [turn, height, across, along2, delta2] = each(of_line, f64x4::splat);
        let [margin, bottom, top] = each(
            [POLYNOMIAL_MARGIN, line.within[0], line.within[1]],
            f64x4::splat,
        );
        let mut met = 0;
        for block in blocks.iter().rev() {
            let offset = |end: usize| (block.height[end] - height).mul_add(across, turn);
            let (a, b) = (offset(0), offset(1));
            let [r, q] = block.radius;
            let form =
                |x: f64x4, y: f64x4, r: f64x4, q: f64x4| x.mul_add(y, along2 * (delta2 - r * q));
            let (first, last) = (form(a, a, r, r), form(b, b, q, q));
            let between = form(a, b, r, q);
            let outside = first.simd_gt(margin) & last.simd_gt(margin) & between.simd_gt(margin);
            let inside = first.simd_lt(-margin) & last.simd_lt(-margin);
            let [one, other] = block.height;
            let apart = (one.simd_lt(bottom) & other.simd_lt(bottom))
                | (one.simd_gt(top) & other.simd_gt(top));
            met = (met << LANES) | (!(outside | inside | apart).to_bitmask() & 15);
        }
        met & (u32::MAX >> (u32::BITS as usize - count))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Revolution;
    use super::super::path::Path;
    use super::*;
    use crate::trace::shapes::facet::tests::Random;

    /// Pieces that are said to be missed have no crossing, and rings that are sure.
    #[test]
    fn pieces_that_are_missed_are_not_crossed() {
        let mut random = Random(17);
        for case in 0..60 {
            let size = random.length(-6.0, 6.0);
            let middle = if case % 2 == 0 { 0.0 } else { size * 50.0 };
            let count = 2 + case * 3;
            let profile: Vec<[f64; 2]> = (0..count)
                .map(|_| {
                    let p = random.point(size);
                    [p[0].abs(), p[1] + middle]
                })
                .collect();
            let solid = Revolution::new(&profile, &[]);
            let (mut all, mut missed) = (0, 0);
            for _ in 0..100 {
                let aim = random.point(size) + Vec3::new(0.0, middle, 0.0);
                let direction = random.point(1.0);
                let line = Line::new(aim - direction * random.length(-2.0, 3.0) * size, direction);
                let Some(passing) = solid.beside.passing(&line, false) else {
                    continue;
                };
                let mut met = vec![false; solid.pieces.len()];
                for (run, bits) in solid.beside.met(&solid.tree, &passing) {
                    for i in (run.first..run.end).filter(|i| bits >> (i - run.first) & 1 == 1) {
                        met[i as usize] = true;
                    }
                }
                let path = Path::new(&line, solid.scale, solid.centre).unwrap();
                for (piece, met) in solid.pieces.iter().zip(met) {
                    all += 1;
                    if met {
                        continue;
                    }
                    missed += 1;
                    let rings = [piece.from, piece.to].map(|i| path.ring(solid.points[i as usize]));
                    let cuts = path.segment(&rings[0], &rings[1]);
                    let sure = !cuts.uncertain && rings.iter().all(|r| !r.is_uncertain());
                    assert!(
                        sure && cuts.list.iter().all(Option::is_none),
                        "{profile:?} {line:?}"
                    );
                }
            }
            assert!(missed * 2 > all, "{case}: {missed} of {all}");
        }
    }
}
