//! Small changes of shapes that nobody sees: surfaces and faces moved by a hair, and plates instead of flat surfaces.
//! Each list of changes has a number.

use super::numbered::Numbered;
use super::plane::{Plane, with_plane_moved};
use super::state::State;
use super::stretch::stretched;
use crate::geometry::Matrix;
use crate::scene::Geometry;

/// A change of a shape that nobody sees. Its distances are in the coordinates of the node that has the change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Change {
    /// Moves the whole surface outwards by this distance; inwards if it is negative.
    Offset(f64),
    /// Moves the flat face in this plane outwards by this distance.
    Plane(Plane, f64),
    /// Makes a plate of a flat surface: its reach to each side of the surface, and the number of its refractive index.
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

    /// The change in the coordinates that `m` maps from. `None` if `m` is degenerate, or stretches too unevenly for one
    /// distance.
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

/// Lists of changes, by number. The changes of a list are made one after the other.
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

    /// The number of the change that moves the face in each of the planes out by the distance beside it. `None` if
    /// there are no planes.
    pub(crate) fn of_planes(&mut self, planes: Vec<(Plane, f64)>) -> Option<u32> {
        let planes = planes.into_iter();
        let changes: Vec<_> = planes.map(|(plane, by)| Change::Plane(plane, by)).collect();
        (!changes.is_empty()).then(|| self.number_all(changes))
    }

    /// The number of the changes of `first`, if it is given, followed by those of `second`.
    pub(crate) fn both(&mut self, first: Option<u32>, second: u32) -> u32 {
        let numbers = first.into_iter().chain([second]);
        let changes = numbers.flat_map(|number| self.changes.get(number)).copied();
        let changes = changes.collect();
        self.number_all(changes)
    }

    /// Adds changes to the state of a solid, after those that it has already.
    pub(crate) fn add(&mut self, state: &mut State, changes: impl IntoIterator<Item = u32>) {
        for change in changes {
            state.flush = Some(self.both(state.flush, change));
        }
    }

    /// The number of that part of a change that moves the whole surface; `None` if no part does. If a difference is
    /// changed, the solids that it takes away have this part only.
    pub(crate) fn offset(&mut self, number: u32) -> Option<u32> {
        let mut changes = self.changes.get(number).iter();
        let offset = *changes.find(|change| matches!(change, Change::Offset(_)))?;
        Some(self.number(offset))
    }

    /// The distance by which a change makes a solid larger all around; 0 if it does not.
    pub(crate) fn larger_by(&self, number: u32) -> f64 {
        let changes = self.changes.get(number).iter();
        changes.fold(0.0, |most, change| match change {
            Change::Offset(by) => by.max(most),
            Change::Plate(..) | Change::Plane(..) => most,
        })
    }

    /// The plate that a change makes of a sheet: its reach to each side, and the number of its index. `None` if the
    /// change makes no plate.
    pub(crate) fn plate(&self, number: u32) -> Option<(f64, u32)> {
        let mut changes = self.changes.get(number).iter().rev();
        changes.find_map(|change| match change {
            Change::Plate(by, index) => Some((*by, *index)),
            Change::Offset(_) | Change::Plane(..) => None,
        })
    }

    /// Whether a change is more than one offset or one plate: it moves single faces, or has several steps.
    pub(crate) fn is_longer(&self, number: u32) -> bool {
        !matches!(
            self.changes.get(number)[..],
            [Change::Offset(_) | Change::Plate(..)]
        )
    }

    /// The end of the comment that the POV-Ray file has on a shape with this change.
    pub(crate) fn note(&self, number: u32) -> &'static str {
        match self.changes.get(number)[..] {
            [Change::Offset(by)] if by < 0.0 => ": a hair smaller",
            [Change::Offset(_)] => ": a hair larger",
            [Change::Plate(..)] => ": a hair thick",
            _ => ": made longer, since it ends flush with something",
        }
    }

    /// The changed shape. `None` if no part of the change applies to it.
    pub(crate) fn changed(&self, number: u32, geometry: &Geometry) -> Option<Geometry> {
        let changes = self.changes.get(number).iter();
        changes.fold(None, |out: Option<Geometry>, change| {
            let now = out.as_ref().unwrap_or(geometry);
            let next = match change {
                Change::Offset(by) => now.offset(*by),
                // A plate is no shape of the scene language; `separate::plates` makes it.
                Change::Plate(..) => None,
                Change::Plane(plane, by) => with_plane_moved(now, plane, *by),
            };
            next.or(out)
        })
    }

    /// The number of the change in the coordinates that `m` maps from. Parts that do not exist there are left out;
    /// `None` if none is left.
    pub(crate) fn moved_back(&mut self, number: u32, m: &Matrix) -> Option<u32> {
        let changes = self.changes.get(number).iter();
        let moved: Vec<_> = changes.filter_map(|change| change.moved_back(m)).collect();
        (!moved.is_empty()).then(|| self.number_all(moved))
    }

    /// The change of a complement's operand, or of a solid that is taken away, when the result has the change with this
    /// number: offsets change their sign.
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
