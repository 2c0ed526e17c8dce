//! Ways to write shapes otherwise than they are where nobody sees it, by number.

use super::numbered::Numbered;
use super::plane::{Plane, with_plane_moved};
use super::state::State;
use super::stretch::stretched;
use crate::geometry::Matrix;
use crate::scene::Geometry;

/// A change of a shape where nobody sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Change {
    /// The surface lies this far outside of where it is; inside where the number is negative.
    Offset(f64),
    /// A flat face in a plane lies this much farther out.
    Plane(Plane, f64),
    /// A flat surface is a plate, so far from it on both sides, with the index of this number.
    Plate(f64, u32),
}

impl Change {
    fn bits(self) -> [u64; 6] {
        let bits = f64::to_bits;
        match self {
            Change::Offset(by) => [0, bits(by + 0.0), 0, 0, 0, 0],
            Change::Plane(Plane { n: [x, y, z], d }, by) => {
                [1, bits(x), bits(y), bits(z), bits(d), bits(by)]
            }
            Change::Plate(by, index) => [2, bits(by), u64::from(index), 0, 0, 0],
        }
    }

    /// The same in the coordinates that a matrix leads away from.
    fn moved_back(self, m: &Matrix) -> Option<Change> {
        Some(match self {
            Change::Offset(by) => Change::Offset(by * stretched(m)?),
            Change::Plate(by, index) => Change::Plate(by * stretched(m)?, index),
            Change::Plane(plane, by) => {
                let (plane, factor) = plane.moved_back(m)?;
                Change::Plane(plane, by * factor)
            }
        })
    }
}

/// Changes, one after the other, by number.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    changes: Numbered<Vec<[u64; 6]>, Vec<Change>>,
}

impl Changes {
    pub(crate) fn number(&mut self, change: Change) -> u32 {
        self.number_all(vec![change])
    }

    fn number_all(&mut self, changes: Vec<Change>) -> u32 {
        let key = changes.iter().map(|change| change.bits()).collect();
        self.changes.number(key, || changes)
    }

    /// The number of the change that moves the faces in some planes out, if there are any.
    pub(crate) fn of_planes(&mut self, planes: Vec<(Plane, f64)>) -> Option<u32> {
        let planes = planes.into_iter();
        let changes: Vec<_> = planes.map(|(plane, by)| Change::Plane(plane, by)).collect();
        (!changes.is_empty()).then(|| self.number_all(changes))
    }

    /// The number of one change after another, if there is that.
    pub(crate) fn both(&mut self, first: Option<u32>, second: u32) -> u32 {
        let numbers = first.into_iter().chain([second]);
        let changes = numbers.flat_map(|number| self.changes.get(number)).copied();
        let changes = changes.collect();
        self.number_all(changes)
    }

    /// Makes changes to a solid after those that are made to it already.
    pub(crate) fn add(&mut self, state: &mut State, changes: impl IntoIterator<Item = u32>) {
        for change in changes {
            state.flush = Some(self.both(state.flush, change));
        }
    }

    /// The part of a change that moves whole surfaces, of what is taken away, too.
    pub(crate) fn offset(&mut self, number: u32) -> Option<u32> {
        let mut changes = self.changes.get(number).iter();
        let offset = *changes.find(|change| matches!(change, Change::Offset(_)))?;
        Some(self.number(offset))
    }

    /// Distance by which a solid is larger all around.
    pub(crate) fn larger_by(&self, number: u32) -> f64 {
        let changes = self.changes.get(number).iter();
        changes.fold(0.0, |most, change| match change {
            Change::Offset(by) => by.max(most),
            Change::Plate(..) | Change::Plane(..) => most,
        })
    }

    /// How thick a sheet is to one side by a change, and of which index, if it is a plate.
    pub(crate) fn plate(&self, number: u32) -> Option<(f64, u32)> {
        let mut changes = self.changes.get(number).iter().rev();
        changes.find_map(|change| match change {
            Change::Plate(by, index) => Some((*by, *index)),
            Change::Offset(_) | Change::Plane(..) => None,
        })
    }

    /// Whether a change is more than that of a whole surface.
    pub(crate) fn is_longer(&self, number: u32) -> bool {
        !matches!(
            self.changes.get(number)[..],
            [Change::Offset(_) | Change::Plate(..)]
        )
    }

    /// The text of a comment on a shape that is changed so.
    pub(crate) fn note(&self, number: u32) -> &'static str {
        match self.changes.get(number)[..] {
            [Change::Offset(by)] if by < 0.0 => ": a hair smaller",
            [Change::Offset(_)] => ": a hair larger",
            [Change::Plate(..)] => ": a hair thick",
            _ => ": made longer, since it ends flush with something",
        }
    }

    /// The changed shape, if there is anything to change about it.
    pub(crate) fn changed(&self, number: u32, geometry: &Geometry) -> Option<Geometry> {
        let changes = self.changes.get(number).iter();
        changes.fold(None, |out: Option<Geometry>, change| {
            let now = out.as_ref().unwrap_or(geometry);
            let next = match change {
                Change::Offset(by) => now.offset(*by),
                // It is no shape of the language.
                Change::Plate(..) => None,
                Change::Plane(plane, by) => with_plane_moved(now, plane, *by),
            };
            next.or(out)
        })
    }

    /// The same change in the coordinates that a matrix leads away from, if there is one.
    pub(crate) fn moved_back(&mut self, number: u32, m: &Matrix) -> Option<u32> {
        let changes = self.changes.get(number).iter();
        let moved: Vec<_> = changes.filter_map(|change| change.moved_back(m)).collect();
        (!moved.is_empty()).then(|| self.number_all(moved))
    }

    /// The change of what something is the complement of, or what is taken from it.
    pub(crate) fn turned(&mut self, number: u32) -> u32 {
        let changes = self.changes.get(number).iter();
        let turned = changes.map(|change| match *change {
            Change::Offset(by) => Change::Offset(-by),
            change => change,
        });
        let turned = turned.collect();
        self.number_all(turned)
    }
}
