//! Ways to write shapes otherwise than they are where nobody sees it, by number.

use super::numbered::Numbered;
use super::plane::{Plane, with_planes_moved};
use super::state::State;
use super::stretch::stretched;
use crate::geometry::Matrix;
use crate::scene::Geometry;

/// How shapes are changed where nobody sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Change {
    /// The surface lies this far outside of where it is; inside where the number is negative.
    Offset(f64),
    /// Flat faces in some planes, by their number, lie farther out.
    Planes(u32),
    /// A flat surface is a plate, so far from it on both sides, with the index of this number.
    Plate(f64, u32),
    /// One change after the other, by their numbers.
    Both(u32, u32),
}

/// Changes, by number.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    changes: Numbered<[u64; 3], Change>,
    /// Planes, and how far out what lies in them is moved.
    planes: Numbered<Vec<u64>, Vec<(Plane, f64)>>,
}

impl Changes {
    pub(crate) fn number(&mut self, change: Change) -> u32 {
        let key = match change {
            Change::Offset(by) => [0, (by + 0.0).to_bits(), 0],
            Change::Planes(planes) => [1, u64::from(planes), 0],
            Change::Plate(by, index) => [2, by.to_bits(), u64::from(index)],
            Change::Both(a, b) => [3, u64::from(a), u64::from(b)],
        };
        self.changes.number(key, || change)
    }

    /// The number of the change that moves the faces in some planes out, if there are any.
    pub(crate) fn of_planes(&mut self, planes: Vec<(Plane, f64)>) -> Option<u32> {
        if planes.is_empty() {
            return None;
        }
        let bits = |(p, by): &(Plane, f64)| [p.n[0], p.n[1], p.n[2], p.d, *by].map(f64::to_bits);
        let key = planes.iter().flat_map(bits).collect();
        let number = self.planes.number(key, || planes);
        Some(self.number(Change::Planes(number)))
    }

    /// The number of one change after another, if there is that.
    pub(crate) fn both(&mut self, first: Option<u32>, second: u32) -> u32 {
        match first {
            Some(first) => self.number(Change::Both(first, second)),
            None => second,
        }
    }

    /// Makes changes to a solid after those that are made to it already.
    pub(crate) fn add(&mut self, state: &mut State, changes: impl IntoIterator<Item = u32>) {
        for change in changes {
            state.flush = Some(self.both(state.flush, change));
        }
    }

    /// The part of a change that moves whole surfaces, of what is taken away, too.
    pub(crate) fn offset(&self, number: u32) -> Option<u32> {
        match self.get(number) {
            Change::Offset(_) => Some(number),
            Change::Both(a, b) => self.offset(a).or_else(|| self.offset(b)),
            Change::Plate(..) | Change::Planes(_) => None,
        }
    }

    /// By how much a solid is larger all around.
    pub(crate) fn larger_by(&self, number: u32) -> f64 {
        match self.get(number) {
            Change::Offset(by) => by.max(0.0),
            Change::Both(a, b) => self.larger_by(a).max(self.larger_by(b)),
            Change::Plate(..) | Change::Planes(_) => 0.0,
        }
    }

    /// How thick a sheet is to one side by a change, and of which index, if it is a plate.
    pub(crate) fn plate(&self, number: u32) -> Option<(f64, u32)> {
        match self.get(number) {
            Change::Plate(by, index) => Some((by, index)),
            Change::Both(a, b) => self.plate(b).or_else(|| self.plate(a)),
            Change::Offset(_) | Change::Planes(_) => None,
        }
    }

    /// The text of a comment on a shape that is changed so.
    pub(crate) fn note(&self, number: u32) -> &'static str {
        match self.get(number) {
            Change::Both(..) | Change::Planes(_) => {
                ": made longer, since it ends flush with something"
            }
            Change::Offset(by) if by < 0.0 => ": a hair smaller",
            Change::Offset(_) => ": a hair larger",
            Change::Plate(..) => ": a hair thick",
        }
    }

    pub(crate) fn get(&self, number: u32) -> Change {
        *self.changes.get(number)
    }

    /// The changed shape, if there is anything to change about it.
    pub(crate) fn changed(&self, number: u32, geometry: &Geometry) -> Option<Geometry> {
        match self.get(number) {
            Change::Offset(by) => geometry.offset(by),
            // It is no shape of the language.
            Change::Plate(..) => None,
            Change::Planes(planes) => with_planes_moved(geometry, self.planes.get(planes)),
            Change::Both(a, b) => {
                let first = self.changed(a, geometry);
                let second = self.changed(b, first.as_ref().unwrap_or(geometry));
                second.or(first)
            }
        }
    }

    /// The same change in the coordinates that a matrix leads away from, if there is one.
    pub(crate) fn moved_back(&mut self, number: u32, m: &Matrix) -> Option<u32> {
        let change = match self.get(number) {
            Change::Offset(by) => Change::Offset(by * stretched(m)?),
            Change::Plate(by, index) => Change::Plate(by * stretched(m)?, index),
            Change::Planes(planes) => {
                let planes = self.planes.get(planes).clone();
                let moved = planes.into_iter().filter_map(|(plane, by)| {
                    let (plane, factor) = plane.moved_back(m)?;
                    Some((plane, by * factor))
                });
                return self.of_planes(moved.collect());
            }
            Change::Both(a, b) => {
                return match (self.moved_back(a, m), self.moved_back(b, m)) {
                    (Some(a), Some(b)) => Some(self.number(Change::Both(a, b))),
                    (a, b) => a.or(b),
                };
            }
        };
        Some(self.number(change))
    }

    /// The change of what something is the complement of, or what is taken from it.
    pub(crate) fn turned(&mut self, number: u32) -> u32 {
        match self.get(number) {
            Change::Plate(..) | Change::Planes(_) => number,
            Change::Offset(by) => self.number(Change::Offset(-by)),
            Change::Both(a, b) => {
                let (a, b) = (self.turned(a), self.turned(b));
                self.number(Change::Both(a, b))
            }
        }
    }
}
