//! The accuracy that points lose by the numbers of a file.

use super::triangle_mesh::Mesh;
use crate::scene::Vec3;

/// The share of the tolerance that decimal digits may cost.
const PART: f64 = 0.01;

/// The places of a mesh's points as a file has them.
pub(super) struct Places<T> {
    pub all: Vec<[T; 3]>,
    /// Largest distance of a point from where it should be.
    pub off: f64,
}

impl<T> Places<T> {
    fn of(mesh: &Mesh, written: impl Fn(Vec3) -> ([T; 3], Vec3)) -> Places<T> {
        let mut off = 0.0f64;
        let mut largest = [0.0f64; 3];
        let mut all = Vec::with_capacity(mesh.points.len());
        for &p in &mesh.points {
            let (place, q) = written(p);
            off = off.max(length([0, 1, 2].map(|k| p[k] - q[k])));
            largest = [0, 1, 2].map(|k| largest[k].max(p[k].abs()));
            all.push(place);
        }
        // The mesh itself is made in doubles, which are rounded, too.
        off += f64::EPSILON * length(largest);
        Places { all, off }
    }
}

/// The places of points in single precision.
pub(super) fn single(mesh: &Mesh) -> Places<f32> {
    Places::of(mesh, |p| {
        let place = p.map(|x| x as f32);
        (place, place.map(f64::from))
    })
}

/// The places of points in decimal digits. A coordinate has the digits of single precision if those are exact enough,
/// else as few digits as are.
pub(super) fn decimal(mesh: &Mesh, tolerance: f64) -> Places<String> {
    let within = within(tolerance);
    Places::of(mesh, |p| {
        let place = p.map(|x| digits(x, within));
        let read = [0, 1, 2].map(|k| place[k].parse().unwrap_or(p[k]));
        (place, read)
    })
}

/// Whether single precision costs no more accuracy than decimal digits may.
pub(super) fn is_single_enough(mesh: &Mesh, tolerance: f64) -> bool {
    let largest = mesh
        .points
        .iter()
        .flatten()
        .fold(0.0f64, |l, x| l.max(x.abs()));
    f64::from(f32::EPSILON) / 2.0 * largest <= within(tolerance)
}

/// The largest error of one coordinate that a tolerance leaves.
fn within(tolerance: f64) -> f64 {
    PART * tolerance / 3f64.sqrt()
}

/// A number in decimal digits, off by no more than `within`.
fn digits(x: f64, within: f64) -> String {
    // A program that reads these digits as a double gets another number, so the check reads them as a double.
    let single = (x as f32).to_string();
    let is_near = |read: f64| (read - x).abs() <= within;
    if single.parse().is_ok_and(is_near) {
        return single;
    }
    let all = x.to_string();
    let places = (-(2.0 * within).log10()).ceil().max(0.0) as usize;
    let has = all.split_once('.').map_or(0, |(_, places)| places.len());
    if places >= has {
        return all;
    }
    let rounded = format!("{x:.places$}");
    match places {
        0 => rounded,
        _ => (rounded.trim_end_matches('0').trim_end_matches('.')).to_owned(),
    }
}

fn length(v: Vec3) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_digits_as_are_needed() {
        for (x, within, text) in [
            // Single precision does.
            (0.1, 1e-3, "0.1"),
            (std::f64::consts::FRAC_1_SQRT_2, 1e-5, "0.70710677"),
            (-0.0, 0.0, "-0"),
            (1e8, 1e-5, "100000000"),
            // It does not.
            (1e8 + 0.607_106_78, 1e-3, "100000000.607"),
            (1e8 + 0.999_999, 1e-3, "100000001"),
            (-1e8 - 0.25, 1e-6, "-100000000.25"),
            (123_456_789.0, 40.0, "123456790"),
            (123_456_792.0, 1.0, "123456792"),
            (123_456_789.0, 1e-9, "123456789"),
            (1e8 + 1.0, 0.0, "100000001"),
            (
                1e-50,
                1e-52,
                "0.00000000000000000000000000000000000000000000000001",
            ),
        ] {
            assert_eq!(digits(x, within), text);
        }
        assert_eq!(digits(1e39, 1.0).len(), 40);
    }
}
