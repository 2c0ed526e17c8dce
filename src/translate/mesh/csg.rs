//! Solids joined, cut and taken away from each other, as meshes.
//!
//! The work is done by `boolmesh`, which follows "Manifold" (Smith, "Towards Topologically Robust
//! Boolean Operations on Meshes", 2009–2024): the result is closed whatever the rounding. It takes what
//! it is given on trust, so that its answers are checked here: closed, and of a volume that can be.

use boolmesh::prelude::{Manifold, OpType, compute_boolean};
use std::cell::Cell;
use std::collections::HashSet;
use std::ops::{Add, Mul};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use super::soup::Mesh;
use crate::scene::vector::{cross, dot, sub};
use crate::scene::{Matrix, Vec3};

/// What two solids make.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    Union,
    Intersection,
    Difference,
}

/// The operation could not be carried out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Failed;

/// Parts thinner than this, by the size of the operands, are what rounding left between faces in one
/// place: half a million roundings, and a ten-millionth of the default tolerance.
const THINNEST: f64 = 1e-10;

/// A label carried along: what lies between corners of one label has this label.
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

/// Combines two closed meshes; triangles keep their labels. May be empty.
///
/// # Errors
/// What came out was not closed, or had a volume that cannot be; also with one of the two moved by
/// less than matters.
pub fn combine(a: &Mesh, b: &Mesh, operation: Operation) -> Result<Mesh, Failed> {
    let (of_a, of_b) = (a.volume(), b.volume());
    let size = a.bounds().radius().max(b.bounds().radius());
    let (a, b, back) = &aligned(a, b, size);
    // Faces in one place are what fails, if anything. By the size of the operands: each time more beyond
    // what points are rounded, and at last still a hundred-thousandth of the default tolerance.
    const NUDGES: [f64; 4] = [0.0, 1e-11, -1e-9, 1e-8];
    for nudge in NUDGES {
        let moved;
        let b = if nudge == 0.0 {
            b
        } else {
            let mut other = b.clone();
            let by = nudge * size;
            other.transform(&Matrix::translation(by, 0.618 * by, -0.382 * by));
            moved = other;
            &moved
        };
        if let Some(mut mesh) = attempt(a, b, operation)
            && plausible(&mesh, of_a, of_b, operation)
        {
            mesh.drop_thin(THINNEST * size);
            if let Some(back) = back {
                mesh.transform(back);
            }
            return Ok(mesh);
        }
    }
    Err(Failed)
}

/// Coordinates that are nearer to each other than this, by the size of the operands, are the same: they
/// differ by what rotations were rounded, some tens of roundings.
const ROUNDED: f64 = 1e-14;

/// The two with the first one's faces along the axes, so that faces of both in one plane are in one
/// plane of the numbers too; and the way back, if they were turned.
fn aligned(a: &Mesh, b: &Mesh, size: f64) -> (Mesh, Mesh, Option<Matrix>) {
    let (mut a, mut b) = (a.clone(), b.clone());
    let turned = axes(&a);
    if let Some(turned) = &turned {
        let mut to = Matrix::IDENTITY;
        let mut back = Matrix::IDENTITY;
        for (i, axis) in turned.iter().enumerate() {
            for (k, x) in axis.iter().enumerate() {
                (to.0[i][k], back.0[k][i]) = (*x, *x);
            }
        }
        a.transform(&to);
        b.transform(&to);
        snap(&mut a, &mut b, ROUNDED * size);
        return (a, b, Some(back));
    }
    snap(&mut a, &mut b, ROUNDED * size);
    (a, b, None)
}

/// The directions of a mesh's largest faces, at right angles; `None` where they are the axes, or there
/// are no two such faces.
fn axes(mesh: &Mesh) -> Option<[Vec3; 3]> {
    let normal = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        let n = cross(sub(b, a), sub(c, a));
        (dot(n, n).sqrt(), n)
    };
    let largest = |wanted: &dyn Fn(f64, Vec3) -> bool| {
        let mut best = (0.0, [0.0; 3]);
        for t in 0..mesh.triangles.len() {
            let (area, n) = normal(t);
            if area > best.0 && wanted(area, n) {
                best = (area, n);
            }
        }
        (best.0 > 0.0).then(|| best.1.map(|x| x / best.0))
    };
    // At right angles, and along an axis, but for some roundings: of the sine, and of the cosine.
    let first = largest(&|_, _| true)?;
    let second = largest(&|area, n| dot(n, first).abs() < 1e-12 * area)?;
    let along = |n: Vec3| n.iter().any(|x| x.abs() > 1.0 - 1e-15);
    if along(first) && along(second) {
        return None;
    }
    // At right angles as far as numbers go.
    let k = dot(first, second);
    let second = sub(second, first.map(|x| k * x));
    let length = dot(second, second).sqrt();
    let second = second.map(|x| x / length);
    Some([first, second, cross(first, second)])
}

/// Makes coordinates that are within `least` of each other the same, axis by axis.
fn snap(a: &mut Mesh, b: &mut Mesh, least: f64) {
    for axis in 0..3 {
        let points = a.points.iter().chain(&b.points);
        let mut places: Vec<f64> = points.map(|p| p[axis]).collect();
        places.sort_unstable_by(f64::total_cmp);
        let mut from = f64::NEG_INFINITY;
        places.retain(|&x| {
            let new = x - from > least;
            if new {
                from = x;
            }
            new
        });
        for p in a.points.iter_mut().chain(&mut b.points) {
            let next = places.partition_point(|&x| x <= p[axis]);
            if let Some(&place) = next.checked_sub(1).and_then(|i| places.get(i)) {
                p[axis] = place;
            }
        }
    }
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
        // It has no other word for a result without triangles.
        Err(e) if e.starts_with("empty ") => Some(Mesh::default()),
        Err(_) => None,
    }
}

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// The library asserts and unwraps what holds for exact numbers only. That ends in `None` here, and
/// without a word: panics of this call alone are kept from being printed.
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

/// Points of one place would become one point there, and faces that touch in an edge would share it:
/// all but the first are moved by the least that makes them different.
fn manifold(mesh: &Mesh) -> Result<Manifold<Tag>, String> {
    let mut seen = HashSet::with_capacity(mesh.points.len());
    let mut points: Vec<f64> = Vec::with_capacity(3 * mesh.points.len());
    for &[x, y, z] in &mesh.points {
        // Adding zero makes one of the two zeros.
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
        // All three are the same, but where a corner was rounded off its triangle: most of them are.
        mesh.labels.push(if tags[1] == tags[2] {
            tags[1].0
        } else {
            tags[0].0
        });
    }
    mesh
}

/// Whether a mesh can be what the operation makes of solids with these volumes.
fn plausible(mesh: &Mesh, a: f64, b: f64, operation: Operation) -> bool {
    let volume = mesh.volume();
    // Rounding, and what thin parts lose when short edges are collapsed; what fails is off by more, since
    // whole parts are lost or there twice.
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
