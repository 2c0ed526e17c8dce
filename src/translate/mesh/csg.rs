//! Union, intersection and difference of two solids as closed meshes.
//!
//! The work is done by `boolmesh`, which follows "Manifold" (Smith, "Towards Topologically Robust Boolean Operations
//! on Meshes", 2009–2024): the result is closed whatever the rounding. `boolmesh` does not check its operands, so
//! this module checks the results: each has to be closed and to have a possible volume.

use boolmesh::prelude::{Manifold, OpType, compute_boolean};
use std::cell::Cell;
use std::collections::HashSet;
use std::ops::{Add, Mul};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use super::flush::{self, Aligned, aligned};
use super::triangle_mesh::Mesh;
use crate::geometry::Matrix;

/// The operation on two solids.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operation {
    Union,
    Intersection,
    Difference,
}

/// The error of an operation that could not be carried out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Failed;

/// The least thickness of a part, in sizes of the operands. Thinner parts are what rounding left between faces in one
/// place. The value is half a million roundings, and a ten-millionth of the default tolerance.
const THINNEST: f64 = 1e-10;

/// A triangle's label, which `boolmesh` carries and interpolates as an attribute of each corner. `Add` and `Mul` are
/// such that interpolating between corners with the same label gives that label.
#[derive(Debug, Clone, PartialEq, Default)]
struct Tag(u32);

impl Add for Tag {
    type Output = Tag;

    fn add(self, other: Tag) -> Tag {
        Tag(self.0.max(other.0))
    }
}

impl Mul<f64> for Tag {
    type Output = Tag;

    fn mul(self, _: f64) -> Tag {
        self
    }
}

/// Combines two closed meshes. Triangles keep their labels. The result may be empty.
///
/// # Errors
/// The result was not closed or had an impossible volume, even after one of the meshes was moved by an invisible
/// distance.
pub(super) fn combine(a: &Mesh, b: &Mesh, operation: Operation) -> Result<Mesh, Failed> {
    let (of_a, of_b) = (a.volume(), b.volume());
    let size = a.bounds().radius().max(b.bounds().radius());
    let Aligned { a, b, shared, back } = &aligned(a, b, size);
    let finished = |mut mesh: Mesh| {
        if *shared && operation != Operation::Difference {
            flush::first_seen(&mut mesh, a, b, size);
        }
        mesh.drop_thin(THINNEST * size);
        if let Some(back) = back {
            mesh.transform(back);
        }
        mesh
    };
    let attempt =
        |b: &Mesh| attempt(a, b, operation).filter(|mesh| plausible(mesh, of_a, of_b, operation));
    if *shared
        && let Some((moved, planes)) = flush::apart(a, b, size, operation)
        && let Some(mut mesh) = attempt(&moved)
    {
        flush::put_back(&mut mesh, &planes, size);
        return Ok(finished(mesh));
    }
    // If an operation fails, then because of faces in one place, so one mesh is moved. The distances are in sizes of
    // the operands. Each is farther beyond the rounding of points than the last; the largest is still a
    // hundred-thousandth of the default tolerance.
    const NUDGES: [f64; 3] = [1e-11, -1e-9, 1e-8];
    if let Some(mesh) = attempt(b) {
        return Ok(finished(mesh));
    }
    for nudge in NUDGES {
        let mut other = b.clone();
        let by = nudge * size;
        other.transform(&Matrix::translation(by, 0.618 * by, -0.382 * by));
        if let Some(mesh) = attempt(&other) {
            return Ok(finished(mesh));
        }
    }
    Err(Failed)
}

fn attempt(a: &Mesh, b: &Mesh, operation: Operation) -> Option<Mesh> {
    let op = match operation {
        Operation::Union => OpType::Add,
        Operation::Intersection => OpType::Intersect,
        Operation::Difference => OpType::Subtract,
    };
    let result = without_panic(|| {
        let (a, b) = (manifold(a)?, manifold(b)?);
        compute_boolean(&a, &b, op)
    });
    match result? {
        Ok(m) => Some(back(&m)),
        // The library reports a result without triangles as this error.
        Err(e) if e.starts_with("empty ") => Some(Mesh::default()),
        Err(_) => None,
    }
}

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Calls the library and returns `None` if it panics: it asserts and unwraps what holds for exact numbers only. The
/// panics of this call are not printed; those of other threads are.
fn without_panic<T>(call: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |info| {
            if !QUIET.get() {
                before(info);
            }
        }));
    });
    QUIET.set(true);
    let result = catch_unwind(AssertUnwindSafe(call));
    QUIET.set(false);
    result.ok()
}

/// Converts a mesh for the library. The library would merge points in one place, so that faces that only touch in an
/// edge would share the edge. All points in one place but the first are moved by the least that makes them different.
fn manifold(mesh: &Mesh) -> Result<Manifold<Tag>, String> {
    let mut seen = HashSet::with_capacity(mesh.points.len());
    let mut points: Vec<f64> = Vec::with_capacity(3 * mesh.points.len());
    for &[x, y, z] in &mesh.points {
        // Adding zero turns −0 into 0.
        let mut p = [x + 0.0, y + 0.0, z + 0.0];
        while !seen.insert(p.map(f64::to_bits)) {
            p[0] = p[0].next_up();
        }
        points.extend(p);
    }
    let corners: Vec<usize> = mesh
        .triangles
        .iter()
        .flatten()
        .map(|&i| i as usize)
        .collect();
    let tags: Vec<Tag> = mesh
        .labels
        .iter()
        .flat_map(|&l| [Tag(l), Tag(l), Tag(l)])
        .collect();
    Manifold::new_with_values(&points, &corners, &tags)
}

fn back(m: &Manifold<Tag>) -> Mesh {
    let mut mesh = Mesh {
        points: m.ps.iter().map(|p| [p.x, p.y, p.z]).collect(),
        ..Mesh::default()
    };
    for (corners, tags) in m.hs.chunks_exact(3).zip(m.vals.chunks_exact(3)) {
        mesh.triangles
            .push([0, 1, 2].map(|i| corners[i].tail as u32));
        // The three tags are the same, unless a corner was rounded off its triangle; then two of them are the same.
        mesh.labels.push(if tags[1] == tags[2] {
            tags[1].0
        } else {
            tags[0].0
        });
    }
    mesh
}

/// Whether a mesh is closed and has a volume that the operation can make of solids with the volumes `a` and `b`.
fn plausible(mesh: &Mesh, a: f64, b: f64, operation: Operation) -> bool {
    let volume = mesh.volume();
    // The slack covers rounding, and the volume that thin parts lose when short edges are collapsed. A failed
    // operation is off by more, since it loses or doubles whole parts.
    let slack = 1e-6 * (a + b);
    let (least, most) = match operation {
        Operation::Union => (a.max(b), a + b),
        Operation::Intersection => (0.0, a.min(b)),
        Operation::Difference => (a - b, a),
    };
    (least - slack..=most + slack).contains(&volume) && mesh.is_closed()
}

#[cfg(test)]
mod tests {
    use super::super::shape::flat::cuboid;
    use super::*;
    use crate::geometry::array::{cross, dot, sub};

    #[test]
    fn panics_are_answers() {
        assert_eq!(without_panic(|| 3), Some(3));
        assert_eq!(without_panic(|| -> i32 { panic!("not a word") }), None);
        assert!(!QUIET.get());
    }

    #[test]
    fn faces_in_one_place_and_turned() {
        // A pit that ends where the block does, in any position: open, with five walls.
        for (angle, axis) in [(30.0, 2), (2.0, 1), (77.7, 0), (123.4, 1)] {
            let turn = Matrix::rotation(angle, axis).after(&Matrix::rotation(8.0, (axis + 1) % 3));
            let mut block = cuboid([-1.0, 0.0, -1.0], [1.0, 1.0, 1.0]);
            let mut tool = cuboid([-0.8, 0.5, -0.8], [-0.1, 1.0, -0.1]);
            block.transform(&turn);
            tool.transform(&turn);
            tool.label_all(7);
            let made = combine(&block, &tool, Operation::Difference).unwrap();
            assert!(made.is_closed());
            assert!((made.volume() - (4.0 - 0.49 * 0.5)).abs() < 1e-9);
            let area: f64 = (0..made.triangles.len())
                .filter(|&t| made.labels[t] == 7)
                .map(|t| {
                    let [a, b, c] = made.corners(t);
                    let n = cross(sub(b, a), sub(c, a));
                    dot(n, n).sqrt() / 2.0
                })
                .sum();
            assert!((area - (0.49 + 4.0 * 0.35)).abs() < 1e-9, "{area}");
        }
    }

    #[test]
    fn a_hollow_is_open_where_what_closes_it_is_cut_off() {
        for (angle, axis) in [(0.0, 0), (30.0, 0), (30.0, 1), (77.7, 2)] {
            let mut block = cuboid([-1.4; 3], [1.4; 3]);
            block.transform(&Matrix::rotation(angle, axis));
            let mut hollow = cuboid([-0.5, -0.5, -0.5], [0.5, 1.0, 0.5]);
            hollow.label_all(7);
            let left = combine(&block, &hollow, Operation::Difference).unwrap();
            let half = cuboid([-2.0, -2.0, -2.0], [2.0, 1.0, 2.0]);
            let made = combine(&left, &half, Operation::Intersection).unwrap();
            // Nothing lies across the opening.
            let lids = (0..made.triangles.len()).filter(|&t| {
                let corners = made.corners(t);
                let middle = [0, 2].map(|i| corners.iter().map(|p| p[i]).sum::<f64>() / 3.0);
                corners.iter().all(|p| (p[1] - 1.0).abs() < 1e-9)
                    && middle.iter().all(|x| x.abs() < 0.5)
            });
            assert_eq!(lids.count(), 0, "{angle} {axis}");
        }
    }

    #[test]
    fn faces_in_one_place() {
        let block = cuboid([0.0; 3], [2.0, 1.0, 1.0]);
        // Flush, flush on three sides, equal, and touching.
        for (min, max, operation, volume) in [
            ([1.0, 0.0, 0.0], [2.0, 1.0, 1.0], Operation::Difference, 1.0),
            ([1.0, 0.5, 0.0], [3.0, 1.0, 1.0], Operation::Difference, 1.5),
            ([0.0; 3], [2.0, 1.0, 1.0], Operation::Difference, 0.0),
            ([0.0; 3], [2.0, 1.0, 1.0], Operation::Intersection, 2.0),
            ([0.0; 3], [2.0, 1.0, 1.0], Operation::Union, 2.0),
            ([2.0, 0.0, 0.0], [3.0, 1.0, 1.0], Operation::Union, 3.0),
            (
                [2.0, 0.0, 0.0],
                [3.0, 1.0, 1.0],
                Operation::Intersection,
                0.0,
            ),
            ([2.0, 1.0, 0.0], [3.0, 2.0, 1.0], Operation::Union, 3.0),
        ] {
            let made = combine(&block, &cuboid(min, max), operation).unwrap();
            assert!(made.is_closed());
            assert!(
                (made.volume() - volume).abs() < 1e-6,
                "{min:?} {}",
                made.volume()
            );
        }
    }
}
