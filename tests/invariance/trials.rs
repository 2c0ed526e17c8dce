//! Trials: a random scene and ray, both moved, turned or scaled by up to 1e6, and whether the ray
//! still meets the scene as often.

use super::trace_support::{Builder, Random};
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::{Geometry, NodeId};
use zpg::internals::trace::{Ray, Tracer};

/// How trials have ended.
#[derive(Debug, Default)]
pub struct Tally {
    pub trials: u64,
    /// Trials whose ray meets something.
    pub met: u64,
    /// Left out: the answer itself changes within the rounding of the changed ray.
    pub excluded: u64,
    /// One line each.
    pub wrong: Vec<String>,
}

impl Tally {
    pub fn add(&mut self, other: Tally) {
        self.trials += other.trials;
        self.met += other.met;
        self.excluded += other.excluded;
        self.wrong.extend(other.wrong);
    }
}

/// A multiple of 2⁻¹⁶ within ±`size`, so that what is done to it below is exact in doubles.
fn short(r: &mut Random, size: u64) -> f64 {
    let steps = size << 16;
    (r.below(2 * steps + 1) as f64 - steps as f64) / 65536.0
}

/// In (0, `size`].
fn positive(r: &mut Random, size: u64) -> f64 {
    (1 + r.below(size << 16)) as f64 / 65536.0
}

fn shape(b: &mut Builder, r: &mut Random) -> NodeId {
    let three = |r: &mut Random, size: u64| [0; 3].map(|_| positive(r, size));
    let geometry = match r.below(14) {
        0 => Geometry::Box {
            min: three(r, 1).map(|x| -x),
            max: three(r, 1),
        },
        1 => Geometry::Ellipsoid {
            semi_axes: three(r, 2),
        },
        2 => Geometry::Torus {
            major: positive(r, 2),
            minor: positive(r, 1),
        },
        3 => Geometry::Cone {
            height: -positive(r, 2),
            radius: positive(r, 1),
        },
        4 => Geometry::DoubleCone {
            height: positive(r, 2),
            radius: positive(r, 1),
        },
        5 => Geometry::HyperbolicCylinder {
            a: positive(r, 1),
            b: positive(r, 1),
        },
        6 => {
            let [a, b, c] = three(r, 1);
            let sheets = 1 + r.below(2) as u32;
            Geometry::Hyperboloid { a, b, c, sheets }
        }
        7 => Geometry::HyperbolicParaboloid {
            a: positive(r, 1),
            b: positive(r, 1),
        },
        8 => Geometry::Quadric(Box::new(std::array::from_fn(|_| short(r, 1)))),
        9 => Geometry::HalfSpace([short(r, 1), short(r, 1), positive(r, 1), short(r, 1)]),
        10 => {
            let n = 2 + r.below(5);
            let points = (0..n).map(|_| [positive(r, 1), short(r, 2)]);
            Geometry::Revolution {
                profile: points.collect(),
                colours: Vec::new(),
            }
        }
        11 => Geometry::GeodesicSphere {
            radius: positive(r, 2),
            splits: r.below(3) as u32,
        },
        _ => Geometry::Sphere {
            centre: [0; 3].map(|_| short(r, 1)),
            radius: positive(r, 2),
        },
    };
    b.shape(geometry)
}

/// One to three shapes and operations on them.
fn solid(b: &mut Builder, r: &mut Random) -> NodeId {
    let mut root = shape(b, r);
    for _ in 0..r.below(3) {
        let other = shape(b, r);
        root = match r.below(3) {
            0 => b.union(root, other),
            1 => b.intersection(root, other),
            _ => b.difference(root, other),
        };
    }
    root
}

fn quarter_turns(r: &mut Random) -> Matrix {
    let mut m = Matrix::IDENTITY;
    for _ in 0..3 {
        let turn = Matrix::rotation(90.0 * r.below(4) as f64, r.below(3) as usize);
        m = turn.after(&m);
    }
    m
}

/// Changes that doubles hold exactly, with their inverses and the numbers of the rays: whole steps of
/// up to 1e6, powers of two within 1e±6, quarter turns.
fn exact_change(r: &mut Random) -> Matrix {
    let step = |r: &mut Random| r.below(2_000_001) as f64 - 1e6;
    match r.below(3) {
        0 => Matrix::translation(step(r), step(r), step(r)),
        1 => {
            let s = 2f64.powi(r.below(39) as i32 - 19);
            Matrix::scaling(s, s, s)
        }
        _ => quarter_turns(r),
    }
}

/// Any translation, turn and scaling by up to 1e6, one at a time; and the turn of the (3, 4, 5)
/// triangle, five times as large, which has rays without rounding but an inverse with.
fn any_change(r: &mut Random) -> Matrix {
    match r.below(4) {
        0 => {
            let far = 10f64.powf(r.within(0.0, 6.0));
            let p = r.point(far);
            Matrix::translation(p[0], p[1], p[2])
        }
        1 => Matrix::rotation(r.within(-180.0, 180.0), r.below(3) as usize),
        2 => {
            let s = 10f64.powf(r.within(-6.0, 6.0));
            Matrix::scaling(s, s, s)
        }
        _ => {
            let (i, j) = [(0, 1), (1, 2), (2, 0)][r.below(3) as usize];
            let mut turn = Matrix::scaling(5.0, 5.0, 5.0);
            (turn.0[i][i], turn.0[i][j]) = (3.0, -4.0);
            (turn.0[j][i], turn.0[j][j]) = (4.0, 3.0);
            turn.after(&quarter_turns(r))
        }
    }
}

/// Which way a ray crosses boundaries, in order.
fn sides(tracer: &Tracer, ray: &Ray) -> (bool, Vec<Option<bool>>) {
    let probe = tracer.probe(&mut tracer.walker(), ray);
    let sides = probe.crossings.iter().map(|c| c.entering);
    (probe.inside_at_origin, sides.collect())
}

/// A ray of short numbers that comes close to the shapes.
fn ray(r: &mut Random) -> Ray {
    let origin = Vec3([0; 3].map(|_| short(r, 8)));
    let mut direction = Vec3([0; 3].map(|_| short(r, 2))) - origin;
    if r.below(8) == 0 {
        // Along an axis.
        let i = r.below(3) as usize;
        direction = Vec3(std::array::from_fn(
            |j| if i == j { direction[i] } else { 0.0 },
        ));
    }
    if !direction.any() {
        direction = Vec3::new(0.0, 0.0, 1.0);
    }
    Ray::new(origin, direction)
}

/// `scenes` scenes with 50 rays each and one exact change a scene: not one count may differ.
pub fn exact_trials(seed: u64, scenes: u64) -> Tally {
    trials(seed, scenes, exact_change, false)
}

/// The same with changes that round. A ray is left out if its count changes when the unchanged ray
/// is moved by as much as the rounding can move the changed one near the shapes.
pub fn rounded_trials(seed: u64, scenes: u64) -> Tally {
    trials(seed, scenes, any_change, true)
}

fn trials(seed: u64, scenes: u64, change: fn(&mut Random) -> Matrix, rounded: bool) -> Tally {
    let mut r = Random(seed << 32);
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let mut b = Builder::default();
        let root = solid(&mut b, &mut r);
        let matrix = change(&mut r);
        let moved = b.moved(root, matrix);
        let (plain, changed) = (b.tracer_of(root), b.tracer_of(moved));
        for _ in 0..50 {
            let before = ray(&mut r);
            let (o, d) = (before.line.origin, before.line.direction);
            let after = Ray::new(Vec3(matrix.point(o.0)), Vec3(matrix.vector(d.0)));
            let (right, found) = (sides(&plain, &before), sides(&changed, &after));
            tally.trials += 1;
            tally.met += u64::from(!right.1.is_empty());
            if right == found {
                continue;
            }
            if rounded && is_close(&plain, &before, &matrix, &right) {
                tally.excluded += 1;
                continue;
            }
            let geometries = b.scene.shapes.iter().map(|s| format!("{:?}", s.geometry));
            let geometries: Vec<String> = geometries.collect();
            tally.wrong.push(format!(
                "{} {:?}, {matrix:?}, o {o:?} d {d:?}: {right:?} and {found:?}",
                geometries.join(" | "),
                b.scene.nodes,
            ));
        }
    }
    tally
}

/// Whether the count changes within the rounding of the changed ray, in the unchanged space.
///
/// The changed origin and direction are rounded three times a coordinate, relative to the sizes of
/// the terms, so by at most γ₄ (|M||o| + |m|) and γ₄|M||d|; the map back scales that by 1/s. The
/// numbers of M are rounded as well, but those are the tracer's own too. Where the set of rays with
/// another count comes within η of a ray, its border is straight at that scale, so that one of the
/// rays moved by 4η along ±x, ±y, ±z, or turned so, is on its other side: 4/√3 η of that is across the
/// border, and moving and turning together come to 2η.
fn is_close(plain: &Tracer, ray: &Ray, m: &Matrix, right: &(bool, Vec<Option<bool>>)) -> bool {
    let gamma = 2.0 * f64::EPSILON;
    let scale = m.determinant3().abs().cbrt();
    let way = (0..3).map(|i| m.0[i][3].abs()).fold(0.0, f64::max);
    let (o, d) = (ray.line.origin, ray.line.direction);
    let at_origin = gamma * (3.0 * o.abs().max_component() + way / scale);
    let of_direction = gamma * 3.0 * d.abs().max_component();
    for axis in 0..3 {
        let e = Vec3(std::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 }));
        for side in [-4.0, 4.0] {
            let shifted = Ray::new(o + e * (side * at_origin), d);
            let turned = Ray::new(o, d + e * (side * of_direction));
            if [shifted, turned].iter().any(|x| sides(plain, x) != *right) {
                return true;
            }
        }
    }
    false
}
