//! Ways to write shapes otherwise than they are where nobody sees it, by number.

use std::collections::HashMap;

use super::matrices::Matrices;
use super::plane::{Plane, with_planes_moved};
use super::stretch::stretched;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Geometry;
use crate::solids::shapes::facts::Facts as _;
use crate::solids::shapes::lengthen::{Cut, HAIR};
use crate::solids::shapes::offset::offset_profile;

/// How shapes are changed where nobody sees it.
#[derive(Debug, Clone, Copy)]
pub enum Change {
    /// Those that end flush with what is cut are longer than they are.
    Longer(Cut),
    /// Their surface lies so far outside of where it is, or inside.
    Offset(f64),
    /// Some sides of a profile do, by their number.
    Sides(f64, u32),
    /// That of the shape with this number does, of all that something is made of.
    One(f64, u32),
    /// The surface lies half as far outside, but where it ends with the box well inside.
    Skin(Aabb, f64),
    /// Flat faces in some planes, by their number, lie farther out.
    Planes(u32),
    /// A flat surface is a plate, so far from it on both sides, with the index of this number.
    Plate(f64, u32),
    /// One change after the other, by their numbers.
    Both(u32, u32),
    /// A change that is said in the coordinates that a matrix leads away from, both by their numbers.
    Within(u32, u32),
}

/// Changes, by number.
#[derive(Debug, Default)]
pub struct Changes {
    changes: Vec<Change>,
    /// For each side of a profile whether it is moved.
    sides: Vec<Vec<bool>>,
    /// The shapes of which there are many, by number.
    shapes: Vec<Geometry>,
    /// Planes, and how far out what lies in them is moved.
    planes: Vec<Vec<(Plane, f64)>>,
    plane_numbers: HashMap<Vec<u64>, u32>,
    /// What changes are within.
    matrices: Matrices,
    numbers: HashMap<[u64; 9], u32>,
}

impl Changes {
    pub fn number(&mut self, change: Change) -> u32 {
        let pair = |a: u32, b: u32| u64::from(a) << 32 | u64::from(b);
        let (kind, which, around, by) = match change {
            Change::Longer(Cut { around, by, most }) => (0, most.to_bits(), around, by),
            Change::Offset(by) => (1, 0, Aabb::ALL, by),
            Change::Sides(by, sides) => (2, u64::from(sides), Aabb::ALL, by),
            Change::One(by, shape) => (3, u64::from(shape), Aabb::ALL, by),
            Change::Skin(around, by) => (4, 0, around, by),
            Change::Both(a, b) => (5, pair(a, b), Aabb::ALL, 0.0),
            Change::Plate(by, index) => (6, u64::from(index), Aabb::ALL, by),
            Change::Planes(planes) => (7, u64::from(planes), Aabb::ALL, 0.0),
            Change::Within(matrix, number) => (8, pair(matrix, number), Aabb::ALL, 0.0),
        };
        let mut key = [kind; 9];
        key[1] = which;
        let numbers = around.min.iter().chain(&around.max).chain([&by]);
        for (k, x) in key[2..].iter_mut().zip(numbers) {
            *k = (x + 0.0).to_bits();
        }
        let next = self.changes.len() as u32;
        let number = *self.numbers.entry(key).or_insert(next);
        if number == next {
            self.changes.push(change);
        }
        number
    }

    /// The number of the change that moves some sides of a profile.
    pub fn of_sides(&mut self, by: f64, sides: Vec<bool>) -> u32 {
        let next = self.sides.len() as u32;
        self.sides.push(sides);
        self.number(Change::Sides(by, next))
    }

    /// The number of the change that moves the surface of one shape.
    pub fn of_one(&mut self, by: f64, shape: &Geometry) -> u32 {
        let next = self.shapes.len() as u32;
        self.shapes.push(shape.clone());
        self.number(Change::One(by, next))
    }

    /// The number of the change that moves the faces in some planes out.
    pub fn of_planes(&mut self, planes: Vec<(Plane, f64)>) -> u32 {
        let bits = |(p, by): &(Plane, f64)| [p.n[0], p.n[1], p.n[2], p.d, *by].map(f64::to_bits);
        let key = planes.iter().flat_map(bits).collect();
        let next = self.planes.len() as u32;
        let number = *self.plane_numbers.entry(key).or_insert(next);
        if number == next {
            self.planes.push(planes);
        }
        self.number(Change::Planes(number))
    }

    /// The number of a change that is said in the coordinates that a matrix leads away from.
    pub fn within(&mut self, m: &Matrix, number: u32) -> u32 {
        let matrix = self.matrices.number(m);
        self.number(Change::Within(matrix, number))
    }

    /// The number of one change after another, if there is that.
    pub fn both(&mut self, first: Option<u32>, second: u32) -> u32 {
        match first {
            Some(first) => self.number(Change::Both(first, second)),
            None => second,
        }
    }

    /// A change that moves ends so little, instead of one that may move them farther.
    pub fn small(&mut self, number: u32, by: f64) -> u32 {
        match self.get(number) {
            Change::Longer(cut) => {
                let most = cut.most.min(by);
                self.number(Change::Longer(Cut { most, ..cut }))
            }
            Change::Both(a, b) => {
                let (a, b) = (self.small(a, by), self.small(b, by));
                self.number(Change::Both(a, b))
            }
            Change::Within(matrix, inner) => {
                let factor = stretched(self.matrices.get(matrix));
                let inner = self.small(inner, factor.map_or(0.0, |f| by * f));
                self.number(Change::Within(matrix, inner))
            }
            _ => number,
        }
    }

    /// Whether no face is moved so far that it can be seen.
    pub fn is_small(&self, number: u32) -> bool {
        match self.get(number) {
            Change::Planes(_) | Change::Plate(..) => true,
            Change::Longer(cut) => cut.most.is_finite(),
            Change::Both(a, b) => self.is_small(a) && self.is_small(b),
            Change::Within(_, inner) => self.is_small(inner),
            _ => false,
        }
    }

    /// The part of a change that moves whole surfaces, of what is taken away, too.
    pub fn offset(&self, number: u32) -> Option<u32> {
        match self.get(number) {
            Change::Offset(_) | Change::One(..) | Change::Skin(..) => Some(number),
            Change::Both(a, b) => self.offset(a).or_else(|| self.offset(b)),
            Change::Longer(_)
            | Change::Sides(..)
            | Change::Plate(..)
            | Change::Planes(_)
            | Change::Within(..) => None,
        }
    }

    /// By how much a solid is larger all around.
    pub fn larger_by(&self, number: u32) -> f64 {
        match self.get(number) {
            Change::Offset(by) => by.max(0.0),
            Change::Both(a, b) => self.larger_by(a).max(self.larger_by(b)),
            _ => 0.0,
        }
    }

    /// How thick a sheet is to one side by a change, and of which index, if it is a plate.
    pub fn plate(&self, number: u32) -> Option<(f64, u32)> {
        match self.get(number) {
            Change::Plate(by, index) => Some((by, index)),
            Change::Both(a, b) => self.plate(b).or_else(|| self.plate(a)),
            _ => None,
        }
    }

    /// What a comment says of a shape that is changed so.
    pub fn note(&self, number: u32) -> &'static str {
        match self.get(number) {
            Change::Longer(_)
            | Change::Sides(..)
            | Change::Both(..)
            | Change::Planes(_)
            | Change::Within(..) => ": made longer, since it ends flush with something",
            Change::Offset(by) | Change::One(by, _) if by < 0.0 => ": a hair smaller",
            Change::Offset(_) | Change::One(..) | Change::Skin(..) => ": a hair larger",
            Change::Plate(..) => ": a hair thick",
        }
    }

    pub fn get(&self, number: u32) -> Change {
        self.changes[number as usize]
    }

    /// The changed shape, if there is anything to change about it.
    pub fn changed(&self, number: u32, geometry: &Geometry) -> Option<Geometry> {
        match self.get(number) {
            Change::Longer(cut) => geometry.lengthened(&cut),
            Change::Offset(by) => geometry.offset(by),
            // It is no shape of the language, or those coordinates are not the shape's.
            Change::Plate(..) | Change::Within(..) => None,
            Change::Planes(planes) => with_planes_moved(geometry, &self.planes[planes as usize]),
            Change::Both(a, b) => {
                let first = self.changed(a, geometry);
                let second = self.changed(b, first.as_ref().unwrap_or(geometry));
                second.or(first)
            }
            Change::One(by, shape) => match self.shapes[shape as usize] == *geometry {
                true => geometry.offset(by),
                false => None,
            },
            Change::Skin(around, by) => {
                let within = geometry.with_ends_moved(around, -4.0 * by);
                within.as_ref().unwrap_or(geometry).offset(by / 2.0)
            }
            Change::Sides(by, sides) => {
                // Made of what a surface of revolution is filled with, which is another.
                let Geometry::Revolution { profile, colours } = geometry else {
                    return None;
                };
                let sides = &self.sides[sides as usize];
                let by = |i: usize| if sides.get(i) == Some(&true) { by } else { 0.0 };
                let profile = offset_profile(profile, by).filter(|_| colours.is_empty())?;
                Some(Geometry::Revolution {
                    profile,
                    colours: Vec::new(),
                })
            }
        }
    }

    /// The same change in the coordinates that a matrix leads away from, if there is one.
    pub fn moved_back(&mut self, number: u32, m: &Matrix) -> Option<u32> {
        let change = match self.get(number) {
            Change::Both(a, b) => {
                return match (self.moved_back(a, m), self.moved_back(b, m)) {
                    (Some(a), Some(b)) => Some(self.number(Change::Both(a, b))),
                    (a, b) => a.or(b),
                };
            }
            Change::Longer(Cut { around, by, most }) => {
                let around = moved_back(around, m)?;
                let most = match most.is_finite() {
                    true => most * stretched(m).unwrap_or_else(|| shortest(m)),
                    false => most,
                };
                Change::Longer(Cut { around, by, most })
            }
            Change::Within(matrix, inner) => {
                return (self.matrices.get(matrix) == m).then_some(inner);
            }
            Change::Offset(by) => Change::Offset(by * stretched(m)?),
            Change::Plate(by, index) => Change::Plate(by * stretched(m)?, index),
            Change::Planes(planes) => {
                let planes = self.planes[planes as usize].clone();
                let moved = planes.into_iter().filter_map(|(plane, by)| {
                    let (plane, factor) = plane.moved_back(m)?;
                    Some((plane, by * factor))
                });
                let moved = moved.collect();
                return Some(self.of_planes(moved));
            }
            Change::Sides(by, sides) => Change::Sides(by * stretched(m)?, sides),
            Change::One(by, shape) => Change::One(by * stretched(m)?, shape),
            Change::Skin(around, by) => {
                // Without ends that are known there are none that would have to be moved.
                let around = moved_back(around, m).unwrap_or(Aabb::ALL);
                Change::Skin(around, by * stretched(m)?)
            }
        };
        Some(self.number(change))
    }

    /// The change of what something is the complement of, or what is taken from it.
    pub fn turned(&mut self, number: u32) -> u32 {
        match self.get(number) {
            Change::Longer(_)
            | Change::Sides(..)
            | Change::Plate(..)
            | Change::Planes(_)
            | Change::Within(..) => number,
            Change::Offset(by) => self.number(Change::Offset(-by)),
            Change::Both(a, b) => {
                let (a, b) = (self.turned(a), self.turned(b));
                self.number(Change::Both(a, b))
            }
            Change::One(by, shape) => self.number(Change::One(-by, shape)),
            Change::Skin(_, by) => self.number(Change::Offset(-by / 2.0)),
        }
    }
}

/// A box seen from before an affine change, with the ends of it that are at right angles to an axis.
pub fn moved_back(b: Aabb, m: &Matrix) -> Option<Aabb> {
    let back = m.inverse()?;
    let mut out = Aabb::ALL;
    for (i, row) in back.0.iter().take(3).enumerate() {
        let largest = row[..3].iter().fold(0.0f64, |m, x| m.max(x.abs()));
        // What is smaller is what rotations by right angles and the inverse were rounded.
        let mut along = (0..3).filter(|j| row[*j].abs() > 1e-12 * largest);
        // Along an axis that is turned there is no end.
        let (Some(j), None) = (along.next(), along.next()) else {
            continue;
        };
        let ends = [b.min[j], b.max[j]].map(|x| {
            let end = row[j] * x + row[3];
            // What is left of larger numbers is what they were rounded.
            if end.abs() <= HAIR * row[3].abs() {
                0.0
            } else {
                end
            }
        });
        (out.min[i], out.max[i]) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    }
    (out != Aabb::ALL).then_some(out)
}

/// What a length of 1 is at least in the coordinates that a matrix leads away from.
fn shortest(m: &Matrix) -> f64 {
    let rows = m.0.iter().take(3).flat_map(|row| &row[..3]);
    1.0 / rows.map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: Aabb = Aabb {
        min: [-1.0, 0.0, -1.0],
        max: [1.0, 2.0, 1.0],
    };

    #[test]
    fn ends_through_the_origin_go_back_there() {
        // As boxes are rounded, that of a dome whose flat face goes through the origin of its own coordinates.
        let low = 0.5f64.next_down().next_down();
        let b = Aabb::new([-1.0, low, -1.0], [1.0, 2.0, 1.0]);
        let b = moved_back(b, &Matrix::translation(0.0, 0.5, 0.5)).unwrap();
        assert_eq!((b.min[1], b.max[1]), (0.0, 1.5));
    }

    #[test]
    fn ends_stay_where_the_axes_do() {
        let m = Matrix::translation(1.0, 2.0, 3.0).after(&Matrix::rotation(90.0, 1));
        let b = moved_back(CUT, &m).unwrap();
        assert!((b.max[1] - b.min[1] - 2.0).abs() < 1e-12);
        let b = moved_back(CUT, &Matrix::rotation(30.0, 1)).unwrap();
        assert_eq!((b.min[1], b.max[1], b.max[0]), (0.0, 2.0, f64::INFINITY));
        let askew = Matrix::rotation(30.0, 1)
            .after(&Matrix::rotation(20.0, 0))
            .after(&Matrix::rotation(40.0, 2));
        assert_eq!(moved_back(CUT, &askew), None);
    }
}
