//! Affine maps with their inverses, and what they do to rounding errors.

use super::array::each;
use super::exponent::{exponent, shifted, shifted_vector};
use super::matrix::Matrix;
use super::number::Real;
use super::vec::Vec3;
use wide::f64x4;

/// A bound on how far a line may be from the one that is meant, since the maps into this space have rounded it. Each
/// number bounds every component.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Slack<R = f64> {
    pub origin: R,
    pub direction: R,
}

/// An affine map x ↦ rows · x + offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine<R = f64> {
    pub rows: [Vec3<R>; 3],
    pub offset: Vec3<R>,
    /// For each row, whether it takes a single coordinate, as it is or times a power of two: the products of such a row
    /// are not rounded.
    plain: [bool; 3],
    /// The greatest of the sums Σⱼ|mᵢⱼ|: an upper bound on the factor by which the largest component of a vector grows.
    spread: R,
    /// Whether the map is a translation.
    moves: bool,
}

impl<R: Real> Affine<R> {
    pub fn new(m: &Matrix) -> Affine<R> {
        let row = |i: usize| Vec3::new(m.0[i][0], m.0[i][1], m.0[i][2]).cast();
        Affine::of(
            [row(0), row(1), row(2)],
            Vec3::new(m.0[0][3], m.0[1][3], m.0[2][3]).cast(),
        )
    }

    pub fn of(rows: [Vec3<R>; 3], offset: Vec3<R>) -> Affine<R> {
        let plain = each(rows, |row| {
            let mut numbers = row.0.into_iter().filter(|&x| x != R::ZERO);
            let only = numbers.next().filter(|_| numbers.next().is_none());
            only.is_some_and(|x| x.abs() == shifted(R::ONE, exponent(x.to_f64())))
        });
        let spread = Vec3(each(rows, |row| row.abs().dot(Vec3::ONE))).max_component();
        Affine {
            rows,
            offset,
            plain,
            spread,
            moves: rows == Affine::<R>::STILL,
        }
    }

    /// The rows of a map that turns and stretches nothing.
    const STILL: [Vec3<R>; 3] = [
        Vec3([R::ONE, R::ZERO, R::ZERO]),
        Vec3([R::ZERO, R::ONE, R::ZERO]),
        Vec3([R::ZERO, R::ZERO, R::ONE]),
    ];

    #[inline]
    pub fn moves(&self) -> bool {
        self.moves
    }

    #[inline]
    pub fn point(&self, p: Vec3<R>) -> Vec3<R> {
        self.vector(p) + self.offset
    }

    #[inline]
    pub fn vector(&self, v: Vec3<R>) -> Vec3<R> {
        Vec3::new(
            self.rows[0].dot(v),
            self.rows[1].dot(v),
            self.rows[2].dot(v),
        )
    }

    /// The image of a normal under the inverse of this map: the transpose times n.
    #[inline]
    pub fn transposed(&self, n: Vec3<R>) -> Vec3<R> {
        self.rows[0] * n[0] + self.rows[1] * n[1] + self.rows[2] * n[2]
    }

    /// The unit normal into which the inverse of this map turns a normal. It is zero only where the numbers of the map
    /// have been lost.
    #[inline]
    pub fn unit_normal(&self, n: Vec3<R>) -> Vec3<R> {
        let image = self.transposed(n);
        let size = image.abs().max_component();
        // If the image is above u⁴, products lose far less than a unit in the last place by underflow.
        if size >= R::ROUNDOFF.square().square() && image.is_finite() {
            return image.unit();
        }
        self.unit_normal_scaled(n)
    }

    /// [`Affine::unit_normal`] where products overflow or underflow: each row and each component is scaled by a power
    /// of two of its own.
    #[cold]
    fn unit_normal_scaled(&self, n: Vec3<R>) -> Vec3<R> {
        let size = |v: Vec3<R>| exponent(v.abs().max_component().to_f64());
        let part = |i: usize| size(self.rows[i]) + exponent(n[i].to_f64());
        let largest = (0..3)
            .filter(|&i| n[i] != R::ZERO && self.rows[i].any())
            .map(part)
            .max();
        let terms = [0, 1, 2].map(|i| {
            let (row, of_n) = (size(self.rows[i]), exponent(n[i].to_f64()));
            let term = shifted_vector(self.rows[i], -row) * shifted(n[i], -of_n);
            largest.map_or(Vec3::ZERO, |k| shifted_vector(term, row + of_n - k))
        });
        let image = terms[0] + terms[1] + terms[2];
        if image.is_finite() {
            image.unit()
        } else {
            Vec3::ZERO
        }
    }

    /// The sizes of the terms of `vector(v)`, added up: Σ|mᵢⱼ vⱼ|.
    #[inline]
    pub fn sizes(&self, v: Vec3<R>) -> Vec3<R> {
        let v = v.abs();
        let size = |i: usize| self.rows[i].abs().dot(v);
        Vec3([size(0), size(1), size(2)])
    }

    /// The slack of the image of a line: the slack before, carried along, and what the map rounds, the map's own
    /// numbers included. The map rounds at most γ₅ of the sizes of the terms of each component. Where a coordinate is
    /// only moved, γ₄ is taken. This is more than the sum rounds, but the scene's numbers may have been rounded before.
    /// Nothing is rounded where a coordinate stays, or where the sum is known to be exact.
    #[inline]
    pub fn slack(&self, origin: Vec3<R>, direction: Vec3<R>, before: Slack<R>) -> Slack<R> {
        let (o, d) = (origin.abs(), direction.abs());
        let (mut point, mut vector) = (R::ZERO, R::ZERO);
        let greater = |a: R, b: R| if a > b { a } else { b };
        for i in 0..3 {
            let (row, offset) = (self.rows[i].abs(), self.offset[i].abs());
            if !self.plain[i] {
                point = greater(point, R::gamma(5) * (row.dot(o) + offset));
                vector = greater(vector, R::gamma(5) * row.dot(d));
            } else if offset != R::ZERO && !self.moves_exactly(i, origin) {
                point = greater(point, R::gamma(4) * (row.dot(o) + offset));
            }
        }
        self.carried(point, vector, before)
    }

    /// The slack behind the map: the roundings `point` and `vector` of the map, and the slack before it, carried along.
    #[inline]
    fn carried(&self, mut point: R, mut vector: R, before: Slack<R>) -> Slack<R> {
        if before != Slack::default() {
            let spread = self.spread * (R::ONE + R::gamma(5));
            point += spread * before.origin;
            vector += spread * before.direction;
        }
        Slack {
            origin: point,
            direction: vector,
        }
    }

    /// Whether a coordinate that this map only moves, and perhaps scales by a power of two, is known
    /// not to be rounded.
    #[inline]
    pub fn moves_exactly(&self, i: usize, p: Vec3<R>) -> bool {
        self.rows[i].dot(p).adds_exactly(self.offset[i])
    }

    /// A bound on the error of `point(p)` where p is off by at most `error`:
    /// (γ₃ + 1)|M| error + γ₄(|M||p| + |offset|) (pbrt-v4, section 6.8.6).
    #[inline]
    pub fn point_error(&self, p: Vec3<R>, error: Vec3<R>) -> Vec3<R> {
        // The factors are applied before the sum: sizes of terms may overflow whose errors do not.
        let before = error * (R::ONE + R::gamma(3)) + p.abs() * R::gamma(4);
        self.sizes(before) + self.offset.abs() * R::gamma(4)
    }

    /// The map in another kind of number, rounded.
    pub fn cast<S: Real>(&self) -> Affine<S> {
        Affine::of(each(self.rows, Vec3::cast), self.offset.cast())
    }

    /// The map that undoes this one, by elimination with complete pivoting: exact for maps that
    /// only move, and one division an axis for those that also scale. `None` where it is singular
    /// or not finite.
    pub fn inverse(&self) -> Option<Affine<R>> {
        let mut a = each(self.rows, |row| row.0);
        let mut inverse = [[R::ZERO; 3]; 3];
        let mut columns = [0usize, 1, 2];
        for (i, row) in inverse.iter_mut().enumerate() {
            row[i] = R::ONE;
        }
        for step in 0..3 {
            let (mut row, mut column, mut best) = (step, step, R::ZERO);
            for (i, r) in a.iter().enumerate().skip(step) {
                for (j, x) in r.iter().enumerate().skip(step) {
                    if x.abs() > best {
                        (row, column, best) = (i, j, x.abs());
                    }
                }
            }
            if best == R::ZERO || !best.is_finite() {
                return None;
            }
            a.swap(step, row);
            inverse.swap(step, row);
            for r in &mut a {
                r.swap(step, column);
            }
            columns.swap(step, column);
            let pivot = a[step][step];
            for j in 0..3 {
                a[step][j] = a[step][j] / pivot;
                inverse[step][j] = inverse[step][j] / pivot;
            }
            for i in (0..3).filter(|&i| i != step) {
                let factor = a[i][step];
                if factor != R::ZERO {
                    for j in 0..3 {
                        a[i][j] -= factor * a[step][j];
                        inverse[i][j] -= factor * inverse[step][j];
                    }
                }
            }
        }
        let mut rows = [Vec3::ZERO; 3];
        for (i, &c) in columns.iter().enumerate() {
            rows[c] = Vec3(inverse[i]);
        }
        let linear = Affine::of(rows, Vec3::ZERO);
        // The subtraction from zero avoids −0, which might turn up as an origin.
        let offset = linear.vector(self.offset).map(|x| R::ZERO - x);
        let finite = offset.is_finite() && rows.iter().all(|row| row.is_finite());
        finite.then(|| Affine::of(rows, offset))
    }
}

impl Affine<f64> {
    /// The [`slack`](Self::slack), the images of a point and a vector, and the reciprocals of the vector's image. The
    /// numbers are those of the single functions, but the three axes are computed side by side.
    #[inline]
    pub fn image(&self, origin: Vec3, direction: Vec3, before: Slack) -> (Slack, Vec3, Vec3, Vec3) {
        let lanes = |v: Vec3| f64x4::new([v[0], v[1], v[2], 0.0]);
        let vector = |lanes: f64x4| {
            let [x, y, z, _] = lanes.to_array();
            Vec3::new(x, y, z)
        };
        let columns = each([0, 1, 2], |j| lanes(Vec3(each(self.rows, |row| row[j]))));
        let sizes = each(columns, f64x4::abs);
        let dot = |columns: [f64x4; 3], v: Vec3| {
            let [x, y, z] = each(v.0, f64x4::splat);
            columns[0] * x + columns[1] * y + columns[2] * z
        };
        let moved = dot(columns, origin) + lanes(self.offset);
        let turned = dot(columns, direction);
        let inverse = f64x4::ONE / turned;
        let slack = match self.plain == [false; 3] {
            true => {
                let gamma = f64x4::splat(<f64 as Real>::gamma(5));
                let point = gamma * (dot(sizes, origin.abs()) + lanes(self.offset.abs()));
                let vector = gamma * dot(sizes, direction.abs());
                let greatest = |lanes: f64x4| {
                    let greater = |a: f64, b: f64| if a > b { a } else { b };
                    let [x, y, z, _] = lanes.to_array();
                    greater(greater(greater(0.0, x), y), z)
                };
                self.carried(greatest(point), greatest(vector), before)
            }
            false => self.slack(origin, direction, before),
        };
        (slack, vector(moved), vector(turned), vector(inverse))
    }
}

/// A map from an object's space into its parent's, and back.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    pub out: Affine,
    pub back: Affine,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dd::Dd;
    use crate::geometry::line::Line;

    fn linear(rows: [[f64; 3]; 3]) -> Affine {
        Affine::of(rows.map(Vec3), Vec3::ZERO)
    }

    #[test]
    fn normals_whose_products_leave_the_numbers() {
        let map = linear([[1e308, 1e308, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1e-320]]);
        let normal = |x, y, z| map.unit_normal(Vec3::new(x, y, z)).0;
        let half = 0.5f64.sqrt();
        for (got, meant) in [
            (normal(0.0, 0.0, 1.0), [0.0, 0.0, 1.0]),
            (normal(0.0, 0.0, -1e-20), [0.0, 0.0, -1.0]),
            (normal(1e200, 0.0, 0.0), [half, half, 0.0]),
            (normal(1e200, 1.0, 1.0), [half, half, 0.0]),
            (
                normal(1e-308, 2.0, 0.0),
                [1.0 / 10f64.sqrt(), 3.0 / 10f64.sqrt(), 0.0],
            ),
            (normal(0.0, 0.0, 0.0), [0.0; 3]),
        ] {
            for i in 0..3 {
                assert!(
                    (got[i] - meant[i]).abs() <= 4.0 * f64::EPSILON,
                    "{got:?} {meant:?}"
                );
            }
        }
    }

    /// Normals of vectors on both sides of the least size that is turned as it is.
    #[test]
    fn normals_about_the_least_size() {
        let least = f64::ROUNDOFF.powi(4);
        for size in [least, least / 2.0] {
            let map = linear([[3.0 * size, 4.0 * size, 0.0], [0.0; 3], [0.0; 3]]);
            let n = map.unit_normal(Vec3::new(0.25, 0.0, 0.0));
            assert!((n - Vec3::new(0.6, 0.8, 0.0)).abs().max_component() <= f64::EPSILON);
        }
    }

    /// Two doubles are a double-double; three need not be.
    #[test]
    fn moving_doubles_rounds_no_double_double() {
        let third = Dd::ONE / Dd::of(3.0);
        for row in [1.0, -4.0] {
            let rows = [[row, 0.0, 0.0], [0.0, row, 0.0], [0.0, 0.0, row]];
            let offset = Vec3::new(1e-30, 0.1, 0.0);
            let map = Affine::of(rows.map(|r| Vec3(r.map(Dd::of))), offset.cast());
            let line = Line::new(Vec3::new(1e30, 0.7, 2.0), Vec3::ONE).cast::<Dd>();
            assert_eq!(line.through(&map).slack, Slack::default());
            let moved = Line::new(Vec3::new(third, Dd::ONE, Dd::ONE), line.direction);
            let slack = moved.through(&map).slack;
            assert!(slack.origin > Dd::ZERO && slack.direction == Dd::ZERO);
            let plain = Line::new(Vec3::new(1.0, 0.7, 2.0), Vec3::ONE);
            assert!(plain.through(&map.cast::<f64>()).slack.origin > 0.0);
        }
    }

    #[test]
    fn errors_of_the_largest_points_are_numbers() {
        let map = linear([[1.0; 3]; 3]);
        let error = map.point_error(Vec3::ONE * (f64::MAX / 2.0), Vec3::ZERO);
        let meant = <f64 as Real>::gamma(4) * 1.5 * f64::MAX;
        assert!((error[0] / meant - 1.0).abs() < 1e-12);
    }
}
