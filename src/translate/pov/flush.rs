//! Tools that end flush with what they cut: which of the two faces in one place POV-Ray takes for the
//! nearer one is up to rounding. Such a tool is written longer than it is. That changes nothing: what
//! is added lies outside of the thing that is cut.

use std::collections::HashMap;

use super::build::Builder;
use super::coplanar::Plane;
use super::matrices::Matrices;
use super::offset::{offset, offset_profile, stretched};
use super::piece::State;
use crate::scene::vector::{length, sub};
use crate::scene::{Aabb, Geometry, Matrix, Node, NodeId};

/// Faces that are this near, as a part of the numbers, are in one place: what a few hundred roundings may do.
pub const HAIR: f64 = 1e-13;
/// So many nodes of a tool are looked at.
const PATIENCE: u32 = 4096;

/// The part of its own length that a tool is made longer by, where nothing is in the way.
const HALF: f64 = 0.5;

/// Normals that are this near are one: what rotations may do.
const FLAT: f64 = 1e-9;
/// Planes that are nearer than this part of what they are moved by are one.
const NEAR: f64 = 1e-3;

/// What a solid may be longer than it is outside of.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    pub around: Aabb,
    /// By this part of its length.
    pub by: f64,
    /// By so much at most.
    pub most: f64,
}

impl Cut {
    /// As long as it may be.
    pub fn of(around: Aabb, by: f64) -> Cut {
        let most = f64::INFINITY;
        Cut { around, by, most }
    }

    /// How far the end of something of that length is moved out.
    fn step(&self, length: f64) -> f64 {
        (self.by * length).clamp(-self.most, self.most)
    }
}

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

    /// How thick a sheet is to one side by a change, and of which index, if it is a plate.
    pub fn plate(&self, number: u32) -> Option<(f64, u32)> {
        match self.get(number) {
            Change::Plate(by, index) => Some((by, index)),
            Change::Both(a, b) => self.plate(b).or_else(|| self.plate(a)),
            _ => None,
        }
    }

    pub fn get(&self, number: u32) -> Change {
        self.changes[number as usize]
    }

    /// The changed shape, if there is anything to change about it.
    pub fn changed(&self, number: u32, geometry: &Geometry) -> Option<Geometry> {
        match self.get(number) {
            Change::Longer(cut) => lengthened(geometry, &cut),
            Change::Offset(by) => offset(geometry, by),
            // It is no shape of the language, or those coordinates are not the shape's.
            Change::Plate(..) | Change::Within(..) => None,
            Change::Planes(planes) => with_planes_moved(geometry, &self.planes[planes as usize]),
            Change::Both(a, b) => {
                let first = self.changed(a, geometry);
                let second = self.changed(b, first.as_ref().unwrap_or(geometry));
                second.or(first)
            }
            Change::One(by, shape) => match self.shapes[shape as usize] == *geometry {
                true => offset(geometry, by),
                false => None,
            },
            Change::Skin(around, by) => {
                let within = with_ends_moved(geometry, around, -4.0 * by);
                offset(within.as_ref().unwrap_or(geometry), by / 2.0)
            }
            Change::Sides(by, sides) => {
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
                    true => most * stretched(m)?,
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

impl Builder<'_> {
    /// The number of the box around what is cut, for a tool that has a shape which ends flush with it.
    pub(super) fn flush(&mut self, tool: NodeId, around: Aabb) -> Option<u32> {
        self.flush_by(tool, Cut::of(around, HALF))
    }

    pub(super) fn flush_by(&mut self, tool: NodeId, all: Cut) -> Option<u32> {
        let Cut { around, by, most } = all;
        if around.is_empty()
            || around
                .min
                .iter()
                .chain(&around.max)
                .all(|x| x.is_infinite())
        {
            return None;
        }
        let mut todo = vec![(tool, around)];
        for _ in 0..PATIENCE {
            let (node, cut) = todo.pop()?;
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    let around = cut;
                    if lengthened(geometry, &Cut { around, by, most }).is_some() {
                        return Some(self.changes.number(Change::Longer(all)));
                    }
                }
                Node::Transform { child, matrix } => {
                    let matrix = &self.scene.matrices[matrix as usize];
                    todo.extend(moved_back(cut, matrix).map(|cut| (child, cut)));
                }
                other => {
                    let children = other.children();
                    todo.extend(children.into_iter().flatten().map(|child| (child, cut)));
                }
            }
        }
        None
    }
}

/// Of more tools none are compared with each other.
const MANY: usize = 256;

impl Builder<'_> {
    /// Tools that end in one plane, from its two sides, would leave a skin there: one of them is made
    /// longer where it stays within the other. Where it does not, the report says so. `cut` is a box
    /// around what they are taken from.
    pub(super) fn overlap_tools(&mut self, tools: &mut [(NodeId, State)], cut: Aabb) {
        if tools.len() > MANY {
            return;
        }
        for i in 0..tools.len() {
            for j in 0..tools.len() {
                for axis in 0..3 {
                    let (a, b) = (self.box_of(tools[i].0), self.box_of(tools[j].0));
                    if i != j && touch(&a, &b, axis) {
                        self.overlap_pair(tools, (i, j), axis, cut);
                    }
                }
            }
        }
    }

    /// The first of the pair ends where the second begins.
    fn overlap_pair(
        &mut self,
        tools: &mut [(NodeId, State)],
        (i, j): (usize, usize),
        axis: usize,
        cut: Aabb,
    ) {
        let [a, b] = [i, j].map(|k| self.box_of(tools[k].0));
        // They may end flush with that, too.
        let (mut below, mut above) = (cut, cut);
        below.max[axis] = a.max[axis];
        above.min[axis] = b.min[axis];
        let [Some(first), Some(second)] =
            [(i, below), (j, above)].map(|(k, half)| self.flush(tools[k].0, half))
        else {
            return;
        };
        for (k, other, flush) in [(i, j, first), (j, i, second)] {
            let (own, room) = (self.box_of(tools[k].0), self.box_of(tools[other].0));
            let fits = (0..3).all(|x| match x == axis {
                true => (own.max[x] - own.min[x]) / 2.0 < room.max[x] - room.min[x],
                false => own.min[x] >= room.min[x] && own.max[x] <= room.max[x],
            });
            let state = &mut tools[k].1;
            if fits && state.flush.is_none() && self.is_box(tools[other].0) {
                state.flush = Some(flush);
                return;
            }
        }
        self.faces_in_one_place(self.ids[tools[i].0 as usize]);
    }

    /// Whether a node is a box along the axes.
    fn is_box(&self, node: NodeId) -> bool {
        matches!(self.along_the_axes(node), Some(Geometry::Box { .. }))
    }

    /// The shape that a node is, if its axes are along those of the node.
    pub(super) fn along_the_axes(&self, mut node: NodeId) -> Option<&Geometry> {
        loop {
            node = match self.scene.nodes[node as usize] {
                Node::Shape(shape) => return Some(&self.scene.shapes[shape as usize].geometry),
                Node::Paint { child, .. } | Node::Copy { child, .. } => child,
                Node::Transform { child, matrix } => {
                    if !is_along(&self.scene.matrices[matrix as usize]) {
                        return None;
                    }
                    child
                }
                _ => return None,
            }
        }
    }
}

/// Whether a matrix leaves the axes along the axes.
pub fn is_along(m: &Matrix) -> bool {
    let along = |row: &[f64; 4]| row[..3].iter().filter(|x| **x != 0.0).count() == 1;
    m.0.iter().take(3).all(along)
}

/// Whether one box ends along an axis where the other begins, with more than an edge in common.
fn touch(a: &Aabb, b: &Aabb, axis: usize) -> bool {
    let (end, start) = (a.max[axis], b.min[axis]);
    let size = end.abs().max(start.abs()).max(a.max[axis] - a.min[axis]);
    size.is_finite()
        && (end - start).abs() <= HAIR * size
        && (0..3).all(|i| i == axis || a.min[i].max(b.min[i]) < a.max[i].min(b.max[i]))
}

/// A box seen from before an affine change, with the ends of it that are at right angles to an axis.
fn moved_back(b: Aabb, m: &Matrix) -> Option<Aabb> {
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
        let ends = [b.min[j], b.max[j]].map(|x| row[j] * x + row[3]);
        (out.min[i], out.max[i]) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    }
    (out != Aabb::ALL).then_some(out)
}

/// Where a face goes that is flush with an end of what is cut: a step away from it.
fn outward(at: f64, (low, high): (f64, f64), hair: f64, step: f64) -> Option<f64> {
    if (at - high).abs() <= hair {
        Some(step)
    } else if (at - low).abs() <= hair {
        Some(-step)
    } else {
        None
    }
}

/// The shape with its flush faces farther out, if it has any that can be moved.
pub fn lengthened(geometry: &Geometry, longer: &Cut) -> Option<Geometry> {
    let cut = &longer.around;
    let finite = |a: f64, b: f64| {
        if (a - b).is_finite() {
            (a - b).abs()
        } else {
            0.0
        }
    };
    match geometry {
        Geometry::Box { min, max } => {
            let (mut low, mut high) = (*min, *max);
            let mut any = false;
            for i in 0..3 {
                let size = max[i] - min[i];
                let hair = HAIR * size.max(finite(cut.max[i], cut.min[i]));
                let step = longer.step(size);
                for end in [&mut low[i], &mut high[i]] {
                    if let Some(by) = outward(*end, (cut.min[i], cut.max[i]), hair, step) {
                        *end += by;
                        any = true;
                    }
                }
            }
            any.then_some(Geometry::Box {
                min: low,
                max: high,
            })
        }
        Geometry::HalfSpace([a, b, c, d]) => {
            let n = [*a, *b, *c];
            let mut along = (0..3).filter(|i| n[*i] != 0.0);
            let (Some(i), None) = (along.next(), along.next()) else {
                return None;
            };
            let at = -d / n[i];
            let size = finite(cut.max[i], cut.min[i]);
            let hair = HAIR * size.max(at.abs());
            let step = (size.max(1.0) / 2.0).min(longer.most);
            let at = at + outward(at, (cut.min[i], cut.max[i]), hair, step)?;
            Some(Geometry::HalfSpace([*a, *b, *c, -at * n[i]]))
        }
        Geometry::Cone { height, radius } => {
            let size = height.abs().max(finite(cut.max[1], cut.min[1]));
            let near = |y: f64| (height - y).abs() <= HAIR * size;
            let flush = (*height > 0.0 && near(cut.max[1])) || (*height < 0.0 && near(cut.min[1]));
            let by = 1.0 + longer.step(height.abs()) / height.abs();
            flush.then_some(Geometry::Cone {
                height: by * height,
                radius: by * radius,
            })
        }
        Geometry::Revolution { profile, colours } if colours.is_empty() => {
            Some(Geometry::Revolution {
                profile: longer_profile(profile, longer)?,
                colours: Vec::new(),
            })
        }
        _ => None,
    }
}

/// The shape with its flat faces in some planes farther out, if it has any there.
fn with_planes_moved(geometry: &Geometry, planes: &[(Plane, f64)]) -> Option<Geometry> {
    let mut out: Option<Geometry> = None;
    for (plane, by) in planes {
        let now = out.as_ref().unwrap_or(geometry);
        let near = |a: f64, b: f64| (a - b).abs() <= NEAR * by;
        if let Geometry::HalfSpace([a, b, c, d]) = now {
            let n = [*a, *b, *c];
            let here = Plane::of(n, *d)?;
            if length(sub(here.n, plane.n)) <= FLAT && near(here.d, plane.d) {
                let d = d - by * length(n);
                out = Some(Geometry::HalfSpace([*a, *b, *c, d]));
            }
            continue;
        }
        // All others have such faces across their axes only.
        let Some(axis) = (0..3).find(|i| plane.n[*i].abs() > 1.0 - FLAT) else {
            continue;
        };
        let sign = plane.n[axis].signum();
        let at = -plane.d * sign;
        let Some(end) = ends(now, axis).into_iter().find(|end| near(*end, at)) else {
            continue;
        };
        let mut around = Aabb::ALL;
        match sign > 0.0 {
            true => around.max[axis] = end,
            false => around.min[axis] = end,
        }
        let most = *by;
        out = lengthened(
            now,
            &Cut {
                around,
                by: HALF,
                most,
            },
        )
        .or(out);
    }
    out
}

/// Where a shape has flat faces along an axis.
fn ends(geometry: &Geometry, axis: usize) -> Vec<f64> {
    match geometry {
        Geometry::Box { min, max } => vec![min[axis], max[axis]],
        Geometry::Cone { height, .. } if axis == 1 => vec![*height],
        Geometry::Revolution { profile, .. } if axis == 1 => profile.iter().map(|p| p[1]).collect(),
        _ => Vec::new(),
    }
}

/// The shape with the flat faces that are flush with the box moved outwards by so much.
fn with_ends_moved(geometry: &Geometry, around: Aabb, by: f64) -> Option<Geometry> {
    if let Geometry::Box { min, max } = *geometry {
        // One axis at a time: a change is a part of a length.
        let mut moved = (min, max);
        for i in 0..3 {
            let mut one = Aabb::ALL;
            (one.min[i], one.max[i]) = (around.min[i], around.max[i]);
            let by = by / (max[i] - min[i]);
            if let Some(Geometry::Box { min, max }) = lengthened(geometry, &Cut::of(one, by)) {
                (moved.0[i], moved.1[i]) = (min[i], max[i]);
            }
        }
        let (min, max) = moved;
        return Some(Geometry::Box { min, max });
    }
    let height = match geometry {
        Geometry::Cone { height, .. } => height.abs(),
        Geometry::Revolution { profile, .. } => {
            let ys = || profile.iter().map(|p| p[1]);
            ys().fold(f64::NEG_INFINITY, f64::max) - ys().fold(f64::INFINITY, f64::min)
        }
        _ => return None,
    };
    let by = by / height;
    lengthened(geometry, &Cut::of(around, by))
}

/// A profile whose flat ends are moved out where they are flush with the box.
fn longer_profile(profile: &[[f64; 2]], longer: &Cut) -> Option<Vec<[f64; 2]>> {
    let cut = &longer.around;
    let heights = || profile.iter().map(|p| p[1]);
    let low = heights().fold(f64::INFINITY, f64::min);
    let high = heights().fold(f64::NEG_INFINITY, f64::max);
    let hair = HAIR * (high - low);
    let step = longer.step(high - low);
    // A ring begins anywhere: only profiles from the axis to the axis, one flat piece at each end.
    if profile.first() == profile.last() || low == high {
        return None;
    }
    let mut out = profile.to_vec();
    let mut any = false;
    for (end, at, by) in [(low, cut.min[1], -step), (high, cut.max[1], step)] {
        if (end - at).abs() > hair {
            continue;
        }
        let level = |p: &[f64; 2]| p[1] == end;
        let first = out.iter().position(level)?;
        let last = out.iter().rposition(level)?;
        if !out[first..=last].iter().all(level) {
            continue;
        }
        let beyond = |p: [f64; 2], before: Option<[f64; 2]>| match before {
            // On along the piece that ends there: a point at this height would be one too many, since
            // POV-Ray cannot tell on which side of the profile others at its height are.
            Some(q) => {
                let slope = (p[0] - q[0]) / (p[1] - q[1]);
                // It becomes half as wide at least, and twice as wide at most.
                let most = if slope * by < 0.0 {
                    p[0] / 2.0 / -slope
                } else if slope * by > 0.0 && p[0] > 0.0 {
                    p[0] / slope
                } else {
                    by
                };
                let by = if most.abs() < by.abs() { most } else { by };
                [p[0] + slope * by, p[1] + by]
            }
            None => [p[0], end + by],
        };
        let before = first.checked_sub(1).map(|i| out[i]);
        let after = out.get(last + 1).copied();
        if first == last && before.is_some() && after.is_some() {
            continue;
        }
        let run = out[first..=last].to_vec();
        let count = run.len();
        let moved = run.iter().enumerate().map(|(i, p)| match i {
            0 if count == 1 => beyond(*p, before.or(after)),
            0 => beyond(*p, before),
            i if i + 1 == count => beyond(*p, after),
            _ => beyond(*p, None),
        });
        out.splice(first..=last, moved);
        any = true;
    }
    any.then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: Aabb = Aabb {
        min: [-1.0, 0.0, -1.0],
        max: [1.0, 2.0, 1.0],
    };

    fn made_longer(geometry: &Geometry) -> Option<Geometry> {
        lengthened(geometry, &Cut::of(CUT, HALF))
    }

    #[test]
    fn flush_faces_move_away_from_what_is_cut() {
        let tool = Geometry::Box {
            min: [-0.5, 1.0, -1.0],
            max: [0.5, 2.0, 0.0],
        };
        let longer = Geometry::Box {
            min: [-0.5, 1.0, -1.5],
            max: [0.5, 2.5, 0.0],
        };
        assert_eq!(made_longer(&tool), Some(longer));
        let inside = Geometry::Box {
            min: [-0.5, 0.5, -0.5],
            max: [0.5, 1.5, 0.5],
        };
        assert_eq!(made_longer(&inside), None);
        // One that lies against it from outside moves away from it.
        let against = Geometry::Box {
            min: [-0.5, 2.0, -0.5],
            max: [0.5, 4.0, 0.5],
        };
        let away = Geometry::Box {
            min: [-0.5, 3.0, -0.5],
            max: [0.5, 4.0, 0.5],
        };
        assert_eq!(made_longer(&against), Some(away));
    }

    #[test]
    fn flat_ends_of_profiles_grow_straight() {
        let tool = |profile: &[[f64; 2]]| Geometry::Revolution {
            profile: profile.to_vec(),
            colours: Vec::new(),
        };
        let cylinder = tool(&[[0.5, 0.0], [0.5, 2.0]]);
        let longer = [[0.5, -1.0], [0.5, 3.0]];
        assert_eq!(made_longer(&cylinder), Some(tool(&longer)));
        let cup = tool(&[[0.0, 1.0], [0.25, 2.0], [0.5, 2.0], [0.5, 0.5]]);
        let taller = [[0.0, 1.0], [0.4375, 2.75], [0.5, 2.75], [0.5, 0.5]];
        assert_eq!(made_longer(&cup), Some(tool(&taller)));
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
