//! Shapes that are tested together, and where a ray meets them, with bounds on the errors.

use super::cuboid::{self, Cuboids};
use super::cull::Cull;
use super::lanes::{Lanes, Number};
use super::leaf::{Kind, Leaf};
use super::plane::{self, Planes};
use super::probe::{Chords, Probe};
use super::quadric::{Quadric, Quadrics};
use super::query::{BENT, End};
use super::rectangle::Rectangles;
use super::sphere::Spheres;
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;

/// Shapes that are tested together, in one space.
#[derive(Debug, Clone)]
pub struct Block {
    pub shapes: Shapes,
    /// Of all of them; see [`Leaf::placement`].
    pub placement: u32,
    /// Numbers of the leaves in the lanes.
    pub leaves: [u32; 4],
    /// The greatest extent of its leaves.
    pub extent: f64,
    /// Of all of them, if it is in a tree.
    pub bounds: Aabb,
    /// Of what is not in an intersection: each of its leaves with lanes in all four, for four rays at once.
    pub apart: Box<[Shapes]>,
    /// Whether light that meets some of its leaves gets no farther.
    pub is_dark: bool,
    /// Of a leaf without lanes: which of four rays miss it.
    pub cull: Option<Box<Cull>>,
}

#[derive(Debug, Clone)]
pub enum Shapes {
    Spheres(Spheres),
    Cuboids(Cuboids),
    Planes(Planes),
    Rectangles(Rectangles),
    /// In the scene's space: each has a space of its own besides.
    Quadrics(Box<Quadrics>),
    /// A single leaf, without lanes.
    Single,
}

/// Puts shapes of one kind in one space into a block.
pub fn in_blocks(leaves: &[Leaf], items: &[u32], blocks: &mut Vec<Block>) {
    let mut rest: Vec<u32> = items.to_vec();
    while let Some(&first) = rest.first() {
        let like = |i: &u32| {
            let [a, b] = [first, *i].map(|i| &leaves[i as usize]);
            a.kind == b.kind && a.placement == b.placement
        };
        let lanes = match leaves[first as usize].kind {
            Kind::Other | Kind::Csg => 1,
            _ => 4,
        };
        let own: Vec<u32> = rest.iter().copied().filter(like).take(lanes).collect();
        rest.retain(|i| !own.contains(i));
        blocks.push(block(leaves, &own));
    }
}

/// Of up to four leaves of one kind.
fn block(leaves: &[Leaf], numbers: &[u32]) -> Block {
    let all: Vec<&Leaf> = numbers.iter().map(|&i| &leaves[i as usize]).collect();
    let mut own = [u32::MAX; 4];
    own[..numbers.len()].copy_from_slice(numbers);
    Block {
        shapes: shapes(&all),
        placement: all[0].placement,
        leaves: own,
        extent: all.iter().fold(0.0, |most, leaf| leaf.extent.max(most)),
        bounds: Aabb::ALL,
        apart: Box::default(),
        is_dark: all.iter().any(|leaf| leaf.is_dark()),
        cull: None,
    }
}

/// Up to four shapes of one kind.
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
            let quadrics: Vec<&Quadric> = all.iter().filter_map(|l| l.quadric.as_deref()).collect();
            Shapes::Quadrics(Box::new(Quadrics::new(&quadrics)))
        }
        Kind::Other | Kind::Csg => Shapes::Single,
    }
}

impl Block {
    /// The chords of its shapes, which have lanes.
    #[inline(always)]
    pub fn chords(&self, probe: &Probe, from: f64, to: f64) -> Chords {
        (self.shapes).chords(probe, Lanes::splat(from), Lanes::splat(to))
    }
}

impl Shapes {
    /// The chords of shapes with lanes: of each on the line in its lane.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        match self {
            Shapes::Spheres(spheres) => spheres.chords(probe, from, to),
            Shapes::Cuboids(cuboids) => cuboids.chords(probe, from, to),
            Shapes::Planes(planes) => planes.chords(probe, from, to),
            Shapes::Rectangles(rectangles) => rectangles.chords(probe, from, to),
            Shapes::Quadrics(quadrics) => quadrics.chords(probe, from, to),
            Shapes::Single => Chords::NONE,
        }
    }
}

impl Leaf {
    /// A place where a ray meets it, with a bound on its error.
    #[inline(always)]
    pub fn rough(&self, probe: &Probe, t: f64, is_near: bool) -> End {
        End {
            t,
            error: self.errors(probe, t, is_near),
        }
    }

    /// Bounds on the errors of places where lines meet it.
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
            Kind::Cuboid => cuboid::rough(probe, &self.numbers, self.extent, t, is_near),
            Kind::Plane | Kind::HalfSpace => plane::rough(probe, *self.first(), self.extent, t),
            Kind::Rectangle => {
                let size = probe.reach + number(self.extent) + t.abs() * probe.pace;
                number(cuboid::SHARE) * size / probe.direction[2].abs()
            }
        };
        // Of what is never met nothing is rounded.
        number(f64::MAX).if_less(t.abs(), number(0.0), error)
    }

    /// Where a ray that starts in it comes out of it.
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
            // Nothing goes through these, there is no way out, or the shape itself finds it.
            Kind::Plane
            | Kind::HalfSpace
            | Kind::Rectangle
            | Kind::Quadric
            | Kind::Other
            | Kind::Csg => {
                return None;
            }
        };
        let out = self.rough(probe, t, false);
        (out.t > 2.0 * (skin + out.error)).then_some(out)
    }
}
