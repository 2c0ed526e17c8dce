//! A search for a point at which two functions are below zero, in the order of their least values.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::distance_field::Slope;
use crate::geometry::Aabb;
use crate::geometry::array::{dot, length};
use crate::scene::Vec3;

/// A box that is a part of the region.
struct Cell {
    /// The rank of the cell: the one with the lowest key is looked at first.
    key: f64,
    centre: Vec3,
    half: Vec3,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> Ordering {
        other.key.total_cmp(&self.key)
    }
}

/// A cell is left out if the value at its middle is at least this factor times the distance to its corners. The factor
/// is more than 1, since fields are rough.
const FIELD_SLACK: f64 = 1.5;

/// The factor of the distance from a cell's middle to its corners, in the key: values in the cell may be lower than at
/// the middle.
const HOPE: f64 = 0.5;

/// The number of first cells, from each of which the search descends.
const FIRST_DESCENT_CELLS: usize = 24;
/// The search descends from one of this many later cells.
const LATER_CELLS_PER_DESCENT: usize = 8;
/// The most steps of a descent.
const MAX_DESCENT_STEPS: usize = 12;

/// Finds a point of a finite region that `accept` accepts, among those where both slopes are below zero by more than
/// `least`. Cells are halved until they are smaller than `least`, or no more points are left.
pub fn lowest(
    region: &Aabb,
    least: f64,
    points: &mut usize,
    slopes: impl FnMut(Vec3) -> [Slope; 2],
    accept: impl FnMut(Vec3) -> bool,
) -> Option<Vec3> {
    let centre = region.centre();
    let half: Vec3 = std::array::from_fn(|i| region.max[i] - centre[i]);
    let mut search = Search {
        region,
        least,
        points,
        slopes,
        accept,
        cells: BinaryHeap::new(),
    };
    let mut found = search.look(centre, half)?;
    let mut count = 0;
    while found.is_none() {
        let cell = search.cells.pop()?;
        count += 1;
        if count <= FIRST_DESCENT_CELLS || count % LATER_CELLS_PER_DESCENT == 0 {
            found = search.descend(&cell)?;
        }
        let longest = (0..3).fold(0, |i, j| if cell.half[j] > cell.half[i] { j } else { i });
        let mut half = cell.half;
        half[longest] /= 2.0;
        for side in [-1.0, 1.0] {
            let mut centre = cell.centre;
            centre[longest] += side * half[longest];
            if found.is_none() {
                found = search.look(centre, half)?;
            }
        }
    }
    found
}

struct Search<'a, S, A> {
    region: &'a Aabb,
    least: f64,
    points: &'a mut usize,
    slopes: S,
    accept: A,
    cells: BinaryHeap<Cell>,
}

impl<S: FnMut(Vec3) -> [Slope; 2], A: FnMut(Vec3) -> bool> Search<'_, S, A> {
    /// The slopes at a point, and the point itself if it is low enough and accepted. `None` when no points are left.
    fn at(&mut self, p: Vec3) -> Option<([Slope; 2], Option<Vec3>)> {
        *self.points = self.points.checked_sub(1)?;
        let slopes = (self.slopes)(p);
        let low = slopes.iter().all(|s| s.distance < -self.least);
        let found = (low && (self.accept)(p)).then_some(p);
        Some((slopes, found))
    }

    /// Tries the middle of a cell, and keeps the cell if other points of it may be lower. Returns the middle if it is
    /// accepted; `None` when no points are left.
    fn look(&mut self, centre: Vec3, half: Vec3) -> Option<Option<Vec3>> {
        let ([a, b], found) = self.at(centre)?;
        let value = a.distance.max(b.distance);
        let reach = length(half);
        if value < FIELD_SLACK * reach && reach > self.least {
            self.cells.push(Cell {
                key: value - HOPE * reach,
                centre,
                half,
            });
        }
        Some(found)
    }

    /// Descends from a cell's middle along both slopes: each step aims at where both tangent planes are equally far
    /// below zero. Returns the point that is accepted, if there is one; `None` when no points are left.
    fn descend(&mut self, cell: &Cell) -> Option<Option<Vec3>> {
        let trust = 4.0 * length(cell.half);
        let mut p = cell.centre;
        for _ in 0..MAX_DESCENT_STEPS {
            let ([a, b], found) = self.at(p)?;
            if found.is_some() {
                return Some(found);
            }
            let deep = 2.0 * self.least + 0.25 * (a.distance + b.distance).abs();
            let (x, y) = (a.distance + deep, b.distance + deep);
            let c = dot(a.up, b.up);
            let area = 1.0 - c * c;
            // The shortest step that lowers the one distance by x and the other by y.
            let (s, t) = match area > 1e-9 {
                true => ((x - c * y) / area, (y - c * x) / area),
                false => (x / 2.0, y / 2.0),
            };
            let step: Vec3 = std::array::from_fn(|i| s * a.up[i] + t * b.up[i]);
            let length = length(step);
            let by = if length > trust { trust / length } else { 1.0 };
            let next: Vec3 = std::array::from_fn(|i| p[i] - by * step[i]);
            if !self.region.contains(next) || next == p {
                break;
            }
            p = next;
        }
        Some(None)
    }
}
