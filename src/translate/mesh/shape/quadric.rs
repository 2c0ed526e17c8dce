//! Surfaces of second degree. Each is brought to its principal axes, where it is a profile turned or extruded, a
//! ball, a saddle, a half-space, all of space or nothing.

use super::super::budget::{Budget, TooMany};
use super::super::triangle_mesh::Mesh;
use super::turned::{Profile, drawn_out, flattened, sides, turned};
use super::{Solid, sphere};
use crate::geometry::{Aabb, Matrix};

/// The curve that bounds a profile, as a condition on the radius ρ at the height y.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Curve {
    /// ρ ≤ 1.
    Straight,
    /// ρ² ≤ y² + 1.
    Waist,
    /// ρ² ≤ y² − 1.
    Branches,
    /// ρ² ≤ y².
    Cross,
    /// ρ² ≤ y.
    Parabola,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum CanonicalQuadric {
    Nothing,
    Everything,
    /// |x| ≤ 1.
    Ball,
    /// The profile, turned about the y axis.
    Turned(Curve),
    /// The profile between x = −ρ and x = ρ, extruded along z.
    DrawnOut(Curve),
    /// x² − z² ≤ y.
    Saddle,
    /// y ≤ 0.
    HalfSpace,
}

/// A quadric brought to its principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Canonical {
    form: CanonicalQuadric,
    /// Whether the solid is the space outside of the form.
    outside: bool,
    /// The map from the coordinates of the form to those of the quadric.
    out: Matrix,
}

/// Values below this share of the numbers that they were computed from are taken for zero: some hundreds of
/// roundings, as many as eigenvalues and products of matrices take.
const ROUNDING: f64 = 1e-13;

/// The solid xᵀQx ≤ 0 as far as the region reaches.
pub(super) fn quadric(
    q: &[f64; 16],
    tolerance: f64,
    region: &Aabb,
    budget: &mut Budget,
) -> Result<Solid, TooMany> {
    let c = canonical(q);
    let Some(back) = c.out.inverse() else {
        return Ok(Solid::nothing());
    };
    let near = region.transformed(&back);
    // The solid is made beyond the region, so that none of its faces lies in a face of the region.
    let pad: [f64; 3] = std::array::from_fn(|i| 0.05 * (near.max[i] - near.min[i]));
    let low: [f64; 3] = std::array::from_fn(|i| near.min[i] - pad[i]);
    let high: [f64; 3] = std::array::from_fn(|i| near.max[i] + pad[i]);
    let scale = |axis: usize| {
        let m = &c.out.0;
        m[0][axis].hypot(m[1][axis]).hypot(m[2][axis])
    };
    let all = scale(0).max(scale(1)).max(scale(2));
    let mut bounded = false;
    let mut meshes = Vec::new();
    match c.form {
        CanonicalQuadric::Nothing => {}
        CanonicalQuadric::Everything => return Ok(Solid::everything(c.outside)),
        CanonicalQuadric::Ball => {
            meshes.push(sphere::sphere(tolerance / all, budget)?);
            bounded = true;
        }
        CanonicalQuadric::Turned(curve) => {
            let half = tolerance / 2.0;
            for points in profiles(curve, [low[1], high[1]], half / all, budget)? {
                let widest = points.iter().fold(0.0f64, |m, p| m.max(p[0]));
                let n = sides(widest, half / scale(0).max(scale(2)));
                let points = closed_over_the_axis(points);
                let ring = false;
                meshes.push(turned(&[Profile { points, ring }], n, budget)?);
            }
        }
        CanonicalQuadric::DrawnOut(curve) => {
            let flat = scale(0).max(scale(1));
            let middle = (low[2] + high[2]) / 2.0;
            let along = Matrix::translation(0.0, 0.0, middle).after(&Matrix::scaling(
                1.0,
                1.0,
                high[2] - middle,
            ));
            for points in profiles(curve, [low[1], high[1]], tolerance / flat, budget)? {
                let mut mesh = drawn_out(&points, budget)?;
                mesh.transform(&along);
                meshes.push(mesh);
            }
        }
        CanonicalQuadric::Saddle => meshes.push(saddle(low, high, tolerance / scale(1), budget)?),
        CanonicalQuadric::HalfSpace => {
            if low[1] < 0.0 {
                let max = [high[0], 0.0, high[2]];
                meshes.push(super::flat::cuboid(low, max));
            }
        }
    }
    for mesh in &mut meshes {
        mesh.transform(&c.out);
    }
    Ok(Solid {
        meshes,
        outside: c.outside,
        bounded,
    })
}

/// Closes the ends of a profile that are not on the axis by discs.
fn closed_over_the_axis(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
        if first[0] > 0.0 {
            points.insert(0, [0.0, first[1]]);
        }
        if last[0] > 0.0 {
            points.push([0.0, last[1]]);
        }
    }
    points
}

/// The profiles of a curve between two heights, rising.
fn profiles(
    curve: Curve,
    [low, high]: [f64; 2],
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Vec<Vec<[f64; 2]>>, TooMany> {
    let mut out = Vec::new();
    match curve {
        Curve::Straight => out.push(vec![[1.0, low], [1.0, high]]),
        Curve::Waist => {
            let arc = |t: f64| [t.cosh(), t.sinh()];
            out.push(flattened(
                arc,
                [low.asinh(), high.asinh()],
                tolerance,
                budget,
            )?);
        }
        Curve::Branches => {
            let arc = |t: f64| [t.sinh(), t.cosh()];
            for (end, upper) in [(high, true), (-low, false)] {
                if end > 1.0 {
                    let points = flattened(arc, [0.0, end.acosh()], tolerance, budget)?;
                    out.push(if upper { points } else { mirrored(points) });
                }
            }
        }
        Curve::Cross => {
            for (end, upper) in [(high, true), (-low, false)] {
                if end > 0.0 {
                    let points = vec![[0.0, 0.0], [end, end]];
                    out.push(if upper { points } else { mirrored(points) });
                }
            }
        }
        Curve::Parabola => {
            if high > 0.0 {
                let arc = |t: f64| [t, t * t];
                out.push(flattened(arc, [0.0, high.sqrt()], tolerance, budget)?);
            }
        }
    }
    Ok(out)
}

fn mirrored(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.into_iter().rev().map(|[x, y]| [x, -y]).collect()
}

/// The solid x² − z² ≤ y, closed by a lid.
fn saddle(
    low: [f64; 3],
    high: [f64; 3],
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Mesh, TooMany> {
    // Between two points h apart a parabola rises h²/4 above its chord.
    let step = 2.0 * tolerance.sqrt();
    // The limit keeps the product of two such numbers finite, so that the budget can refuse it.
    let cells = |axis: usize| ((high[axis] - low[axis]) / step).ceil().clamp(1.0, 1e9);
    let (nx, nz) = (cells(0), cells(2));
    budget.spend(4.0 * nx * nz)?;
    let (nx, nz) = (nx as usize, nz as usize);
    let at = |axis: usize, i: usize, n: usize| {
        low[axis] + (high[axis] - low[axis]) * i as f64 / n as f64
    };
    let peak = low[0].abs().max(high[0].abs()).powi(2);
    // The lid lies above the whole saddle; how far above does not matter.
    let lid = high[1].max(peak) + (high[1] - low[1]).abs().max(peak) * 0.1;
    let mut mesh = Mesh::default();
    let mut grid = |y: &dyn Fn(f64, f64) -> f64| -> Vec<Vec<u32>> {
        let xs = 0..=nx;
        xs.map(|i| {
            let x = at(0, i, nx);
            let zs = (0..=nz).map(|k| at(2, k, nz));
            zs.map(|z| mesh.point([x, y(x, z), z])).collect()
        })
        .collect()
    };
    let floor = grid(&|x, z| x * x - z * z);
    let top = grid(&|_, _| lid);
    for i in 0..nx {
        for k in 0..nz {
            let cell = |g: &Vec<Vec<u32>>| [g[i][k], g[i + 1][k], g[i + 1][k + 1], g[i][k + 1]];
            mesh.quad(cell(&floor));
            let [a, b, c, d] = cell(&top);
            mesh.quad([d, c, b, a]);
        }
        mesh.quad([floor[i + 1][0], floor[i][0], top[i][0], top[i + 1][0]]);
        mesh.quad([floor[i][nz], floor[i + 1][nz], top[i + 1][nz], top[i][nz]]);
    }
    for k in 0..nz {
        mesh.quad([floor[0][k], floor[0][k + 1], top[0][k + 1], top[0][k]]);
        mesh.quad([floor[nx][k + 1], floor[nx][k], top[nx][k], top[nx][k + 1]]);
    }
    Ok(mesh)
}

/// Brings the solid xᵀQx ≤ 0 to its principal axes.
fn canonical(q: &[f64; 16]) -> Canonical {
    let largest = q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let s = |i: usize, j: usize| (q[4 * i + j] / 2.0 + q[4 * j + i] / 2.0) / largest;
    if largest == 0.0 {
        return Canonical::plain(CanonicalQuadric::Everything, false);
    }
    let a: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| s(i, j)));
    let (values, axes) = eigen(a);
    let greatest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let b = [s(0, 3), s(1, 3), s(2, 3)];
    // 2b·x in the coordinates of the axes.
    let mut linear: [f64; 3] = axes.map(|v| v[0] * b[0] + v[1] * b[1] + v[2] * b[2]);
    let (mut constant, mut size) = (s(3, 3), s(3, 3).abs());
    let mut curved: Vec<(f64, usize)> = Vec::new();
    let mut centre = [0.0; 3];
    for i in 0..3 {
        if values[i].abs() > ROUNDING * greatest {
            curved.push((values[i], i));
            centre[i] = -linear[i] / values[i];
            constant += linear[i] * centre[i];
            size += (linear[i] * centre[i]).abs();
            linear[i] = 0.0;
        } else if linear[i].abs() <= ROUNDING {
            linear[i] = 0.0;
        }
    }
    if constant.abs() <= ROUNDING * size {
        constant = 0.0;
    }
    // If more eigenvalues are negative than positive, the solid is the outside of the same form with all signs
    // reversed.
    let minus = curved.iter().filter(|c| c.0 < 0.0).count();
    let outside = 2 * minus > curved.len();
    let sign = if outside { -1.0 } else { 1.0 };
    let slope = linear[0].hypot(linear[1]).hypot(linear[2]);
    let constant = sign * constant;
    for c in &mut curved {
        c.0 *= sign;
    }
    // Positive ones first.
    curved.sort_by(|x, y| y.0.total_cmp(&x.0));
    let plus = curved.iter().filter(|c| c.0 > 0.0).count();
    let flat: Vec<usize> = (0..3)
        .filter(|i| curved.iter().all(|c| c.1 != *i))
        .collect();
    let axis = |i: usize, length: f64| axes[i].map(|x| x * length);
    let unit = |c: (f64, usize), of: f64| axis(c.1, (of / c.0.abs()).sqrt());

    if slope > 0.0 {
        // `along` is the direction in which the linear part falls. `start` is the point where the form has its
        // origin: there the linear part cancels the constant.
        let along: [f64; 3] = std::array::from_fn(|k| {
            let parts = flat.iter().map(|&i| axes[i][k] * linear[i] * sign / slope);
            -parts.sum::<f64>()
        });
        let start: [f64; 3] = std::array::from_fn(|k| {
            let middle = (0..3).map(|i| axes[i][k] * centre[i]).sum::<f64>();
            middle + along[k] * constant / (2.0 * slope)
        });
        let y = along.map(|x| x / (2.0 * slope));
        let (form, columns) = match (curved.len(), plus) {
            (2, 2) => (
                CanonicalQuadric::Turned(Curve::Parabola),
                [unit(curved[0], 1.0), y, unit(curved[1], 1.0)],
            ),
            (2, _) => (
                CanonicalQuadric::Saddle,
                [unit(curved[0], 1.0), y, unit(curved[1], 1.0)],
            ),
            (1, _) => {
                let x = unit(curved[0], 1.0);
                (
                    CanonicalQuadric::DrawnOut(Curve::Parabola),
                    [x, y, super::flat::normal_to(x, y)],
                )
            }
            _ => {
                // −y of the canonical form points into the half-space.
                let down = along.map(|x| -x);
                let x = super::flat::any_normal_to(down);
                (
                    CanonicalQuadric::HalfSpace,
                    [x, down, super::flat::normal_to(x, down)],
                )
            }
        };
        return Canonical::new(form, outside, columns, start);
    }
    let start: [f64; 3] =
        std::array::from_fn(|k| (0..3).map(|i| axes[i][k] * centre[i]).sum::<f64>());
    let of = if constant == 0.0 { 1.0 } else { constant.abs() };
    let columns = |order: [Option<usize>; 3]| {
        let mut free = flat.iter();
        order.map(|c| match c {
            Some(c) => unit(curved[c], of),
            None => axis(free.next().copied().unwrap_or(0), 1.0),
        })
    };
    let crossed = |constant: f64| match constant {
        c if c < 0.0 => Curve::Waist,
        c if c > 0.0 => Curve::Branches,
        _ => Curve::Cross,
    };
    let (form, columns) = match (curved.len(), plus) {
        (3, 3) if constant < 0.0 => (CanonicalQuadric::Ball, columns([Some(0), Some(1), Some(2)])),
        (3, 2) => (
            CanonicalQuadric::Turned(crossed(constant)),
            columns([Some(0), Some(2), Some(1)]),
        ),
        (2, 2) if constant < 0.0 => (
            CanonicalQuadric::Turned(Curve::Straight),
            columns([Some(0), None, Some(1)]),
        ),
        (2, 1) => (
            CanonicalQuadric::DrawnOut(crossed(constant)),
            columns([Some(0), Some(1), None]),
        ),
        (1, 1) if constant < 0.0 => (
            CanonicalQuadric::DrawnOut(Curve::Straight),
            columns([Some(0), None, None]),
        ),
        (0, _) if constant <= 0.0 => {
            return Canonical::plain(CanonicalQuadric::Everything, outside);
        }
        _ => return Canonical::plain(CanonicalQuadric::Nothing, outside),
    };
    Canonical::new(form, outside, columns, start)
}

impl Canonical {
    fn plain(form: CanonicalQuadric, outside: bool) -> Canonical {
        Canonical {
            form,
            outside,
            out: Matrix::IDENTITY,
        }
    }

    fn new(
        form: CanonicalQuadric,
        outside: bool,
        columns: [[f64; 3]; 3],
        start: [f64; 3],
    ) -> Canonical {
        let mut out = Matrix::IDENTITY;
        for k in 0..3 {
            for (axis, column) in columns.iter().enumerate() {
                out.0[k][axis] = column[k];
            }
            out.0[k][3] = start[k];
        }
        Canonical { form, outside, out }
    }
}

/// Eigenvalues and unit eigenvectors of a symmetric matrix, by Jacobi's rotations (Golub, Van Loan,
/// "Matrix Computations", 8.5).
pub fn eigen(mut a: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Convergence is quadratic: a handful of sweeps is enough.
    for _ in 0..32 {
        let off = a[0][1].abs() + a[0][2].abs() + a[1][2].abs();
        if off == 0.0 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let t = if theta == 0.0 { 1.0 } else { t };
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
                // Row k of v is eigenvector k.
                (v[p][k], v[q][k]) = (c * v[p][k] - s * v[q][k], s * v[p][k] + c * v[q][k]);
            }
            (a[p][q], a[q][p]) = (0.0, 0.0);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v)
}
