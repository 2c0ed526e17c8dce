//! Shapes that are tested together, and where a ray meets them, with bounds on the errors.

use super::cuboid::{self, Cuboids};
use super::cull::Cull;
use super::lanes::{LANES, Lanes, Number};
use super::leaf::{Kind, Leaf};
use super::plane::{self, Planes};
use super::probe::{Chords, Probe};
use super::quadric::{Quadric, Quadrics};
use super::query::{BENT, End, NONE};
use super::rectangle::Rectangles;
use super::sphere::Spheres;
use super::triangle::{self, Triangles};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;

/// Shapes that are tested together, in one space.
#[derive(Debug, Clone)]
pub struct Block {
    pub shapes: Shapes,
    /// The placement that all its leaves share: see [`Leaf::placement`].
    pub placement: u32,
    /// Numbers of the leaves in the lanes, filled up with [`NONE`].
    pub leaves: [u32; 4],
    /// The greatest extent of its leaves.
    pub extent: f64,
    /// A box around all its leaves, if the block is in a tree; otherwise everything.
    pub bounds: Aabb,
    /// Each of its convex solids of second degree by itself, in all four lanes. Empty for operands of an intersection.
    pub apart: Box<[Quadrics]>,
    /// Whether light gets no farther where it meets some of its leaves: see [`Leaf::is_dark`].
    pub is_dark: bool,
    /// For a leaf without lanes, the test which of four rays miss it, if there is such a test.
    pub cull: Option<Box<Cull>>,
}

#[derive(Debug, Clone)]
pub enum Shapes {
    Spheres(Spheres),
    Cuboids(Cuboids),
    Planes(Planes),
    Rectangles(Rectangles),
    /// The lines are in the scene's space; each quadric has its own map into the space of its shape.
    Quadrics(Box<Quadrics>),
    Triangles(Box<Triangles>),
    /// A single leaf, without lanes.
    Single,
}

/// Puts leaves with boxes around them into new blocks: up to four of one kind and one placement share a block.
pub fn in_blocks(leaves: &[Leaf], mut items: Vec<(u32, Aabb)>, blocks: &mut Vec<Block>) {
    let sort = |&(leaf, _): &(u32, Aabb)| {
        let leaf = &leaves[leaf as usize];
        (leaf.kind, leaf.placement)
    };
    items.sort_by_key(sort);
    for alike in items.chunk_by(|a, b| sort(a) == sort(b)) {
        let lanes = match leaves[alike[0].0 as usize].kind {
            Kind::Other | Kind::Csg => 1,
            _ => LANES,
        };
        blocks.extend(alike.chunks(lanes).map(|own| block(leaves, own)));
    }
}

/// Puts leaves without boxes into new blocks.
pub fn in_loose_blocks(leaves: &[Leaf], loose: &[u32], blocks: &mut Vec<Block>) {
    let items = loose.iter().map(|&leaf| (leaf, Aabb::ALL));
    in_blocks(leaves, items.collect(), blocks);
}

/// A block of up to four leaves of one kind and one placement.
fn block(leaves: &[Leaf], items: &[(u32, Aabb)]) -> Block {
    let all: Vec<&Leaf> = items.iter().map(|&(i, _)| &leaves[i as usize]).collect();
    let mut own = [NONE; LANES];
    for (own, &(leaf, _)) in own.iter_mut().zip(items) {
        *own = leaf;
    }
    Block {
        shapes: shapes(&all),
        placement: all[0].placement,
        leaves: own,
        extent: all.iter().fold(0.0, |most, leaf| leaf.extent.max(most)),
        bounds: (items.iter()).fold(Aabb::EMPTY, |all, (_, bounds)| all.hull(bounds)),
        apart: Box::default(),
        is_dark: all.iter().any(|leaf| leaf.is_dark()),
        cull: None,
    }
}

/// Packs up to four shapes of one kind into lanes.
pub fn shapes(all: &[&Leaf]) -> Shapes {
    let four = |leaf: &&Leaf| {
        let [a, b, c, d, ..] = leaf.numbers;
        [a, b, c, d]
    };
    match all[0].kind {
        Kind::Sphere => Shapes::Spheres(Spheres::new(&all.iter().map(four).collect::<Vec<_>>())),
        Kind::Cuboid => {
            let corners = |leaf: &&Leaf| {
                let [a, b, c, x, y, z, ..] = leaf.numbers;
                [a, b, c, x, y, z]
            };
            Shapes::Cuboids(Cuboids::new(&all.iter().map(corners).collect::<Vec<_>>()))
        }
        Kind::Plane | Kind::HalfSpace => {
            let plane = |leaf: &&Leaf| (four(leaf), leaf.kind == Kind::HalfSpace);
            Shapes::Planes(Planes::new(&all.iter().map(plane).collect::<Vec<_>>()))
        }
        Kind::Rectangle => {
            Shapes::Rectangles(Rectangles::new(&all.iter().map(four).collect::<Vec<_>>()))
        }
        Kind::Quadric => {
            let quadrics: Vec<&Quadric> = all.iter().filter_map(|l| l.quadric()).collect();
            Shapes::Quadrics(Box::new(Quadrics::new(&quadrics)))
        }
        Kind::Triangle => {
            let corners: Vec<&[Vec3; 3]> = all.iter().map(|leaf| leaf.corners()).collect();
            Shapes::Triangles(Box::new(Triangles::new(&corners)))
        }
        Kind::Other | Kind::Csg => Shapes::Single,
    }
}

impl Block {
    /// The chords of four lines in `leaf`, which has the index `i` in the block, for t between `from` and `to`.
    #[inline(always)]
    pub fn chords_alone(
        &self,
        (i, leaf): (usize, &Leaf),
        probe: &Probe<Lanes>,
        [from, to]: [Lanes; 2],
    ) -> Chords {
        match leaf.kind {
            Kind::Sphere => Spheres::of_one(leaf).chords(probe, from, to),
            Kind::Cuboid => Cuboids::of_one(leaf).chords(probe, from, to),
            Kind::Plane | Kind::HalfSpace => Planes::of_one(leaf).chords(probe, from, to),
            Kind::Rectangle => Rectangles::of_one(leaf).chords(probe, from, to),
            Kind::Triangle => Triangles::of_one(leaf).chords(probe, from, to),
            Kind::Quadric => match self.apart.get(i) {
                Some(quadric) => quadric.chords(probe, from, to),
                None => Chords::NONE,
            },
            Kind::Other | Kind::Csg => Chords::NONE,
        }
    }

    /// The leaves of the block, each with its index in the block.
    #[inline(always)]
    pub fn each_leaf(&self) -> impl Iterator<Item = (usize, u32)> + '_ {
        let all = self.leaves.iter().copied().enumerate();
        all.take_while(|&(_, number)| number != NONE)
    }

    /// The chords of one line in the shapes of the block, for t between `from` and `to`. The shapes have lanes.
    #[inline(always)]
    pub fn chords(&self, probe: &Probe, from: f64, to: f64) -> Chords {
        (self.shapes).chords(probe, Lanes::splat(from), Lanes::splat(to))
    }
}

impl Shapes {
    /// The chords in shapes with lanes: each lane holds a shape and a line, or all lanes share one line.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        match self {
            Shapes::Spheres(spheres) => spheres.chords(probe, from, to),
            Shapes::Cuboids(cuboids) => cuboids.chords(probe, from, to),
            Shapes::Planes(planes) => planes.chords(probe, from, to),
            Shapes::Rectangles(rectangles) => rectangles.chords(probe, from, to),
            Shapes::Quadrics(quadrics) => quadrics.chords(probe, from, to),
            Shapes::Triangles(triangles) => triangles.chords(probe, from, to),
            Shapes::Single => Chords::NONE,
        }
    }
}

impl Leaf {
    /// The place `t` where a ray meets the leaf, with a bound on its error. `is_near`: whether it is the near end of
    /// the chord.
    #[inline(always)]
    pub fn rough(&self, probe: &Probe, t: f64, is_near: bool) -> End {
        End {
            t,
            error: self.errors(probe, t, is_near),
        }
    }

    /// Bounds on the errors of the places `t` where lines meet the leaf. `is_near`: whether they are the near ends of
    /// chords.
    #[inline(always)]
    pub fn errors<N: Number>(&self, probe: &Probe<N>, t: N, is_near: bool) -> N {
        let number = N::splat;
        let size = || (probe.reach + number(self.extent)) * probe.per_pace + t.abs();
        let error = match self.kind {
            Kind::Sphere | Kind::Other | Kind::Csg => number(BENT) * size(),
            Kind::Quadric => {
                let [x, y, z, stretch, ..] = self.numbers;
                let [dx, dy, dz] = probe.direction;
                let across = (number(x) * dx + number(y) * dy + number(z) * dz).abs();
                let has_ends = x != 0.0 || y != 0.0 || z != 0.0;
                let flat = match has_ends {
                    true => number(cuboid::SHARE) * probe.pace / across,
                    false => number(0.0),
                };
                (number(BENT) + flat) * number(stretch) * size()
            }
            Kind::Triangle => triangle::rough(probe, &self.numbers, self.extent, t),
            Kind::Cuboid => cuboid::rough(probe, &self.numbers, self.extent, t, is_near),
            Kind::Plane | Kind::HalfSpace => plane::rough(probe, *self.first(), self.extent, t),
            Kind::Rectangle => {
                let size = probe.reach + number(self.extent) + t.abs() * probe.pace;
                number(cuboid::SHARE) * size / probe.direction[2].abs()
            }
        };
        // An infinite t, for a place that is never met, has no error.
        number(f64::MAX).if_less(t.abs(), number(0.0), error)
    }

    /// The place where a ray that starts in the leaf comes out. `None` if the place is too near the start, or if the
    /// leaf is of a kind that is not solved here.
    #[inline(always)]
    pub fn way_out(&self, probe: &Probe, skin: f64) -> Option<End> {
        let t = match self.kind {
            Kind::Sphere => {
                let [x, y, z, radius, ..] = self.numbers;
                let to_centre = Vec3([x, y, z]) - Vec3(probe.origin);
                let middle = to_centre.dot(Vec3(probe.direction)) * probe.per_square;
                let depth = (radius * radius - to_centre.dot(to_centre)) * probe.per_square;
                middle + (middle * middle + depth).max(0.0).sqrt()
            }
            Kind::Cuboid => {
                let far = |i: usize| {
                    let [low, high] = each([i, 3 + i], |side: usize| {
                        (self.numbers[side] - probe.origin[i]) * probe.inverse[i]
                    });
                    low.max(high)
                };
                far(0).min(far(1)).min(far(2))
            }
            // These kinds let nothing through, have no way out, or leave it to the shape to find it.
            Kind::Plane
            | Kind::HalfSpace
            | Kind::Rectangle
            | Kind::Quadric
            | Kind::Triangle
            | Kind::Other
            | Kind::Csg => {
                return None;
            }
        };
        let out = self.rough(probe, t, false);
        (out.t > 2.0 * (skin + out.error)).then_some(out)
    }
}
