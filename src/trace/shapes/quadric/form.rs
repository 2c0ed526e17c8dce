//! A polynomial of second degree, its value and its gradient.

use super::line::Bounded;
use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::trace::shapes::Located;
use crate::trace::shapes::error_bound::is_final;

/// F(x) = Σ squareᵢ xᵢ² + mixed·(xy, xz, yz) + linear·x + constant, where xᵢ is a coordinate divided by unitᵢ. So
/// semi-axes stay as they were given, and the coefficients of canonical forms are exact.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadricForm {
    pub(super) square: [f64; 3],
    pub(super) mixed: [f64; 3],
    pub(super) linear: [f64; 3],
    /// The rounding errors of the sums in the mixed and linear coefficients.
    pub(super) rest: [[f64; 3]; 2],
    pub(super) constant: f64,
    pub(super) unit: [f64; 3],
    /// The highest power in which each coordinate occurs.
    pub(super) degree: [u8; 3],
    /// The largest coefficient of the second degree.
    pub(super) second: f64,
    /// A bound on the sum of the slopes of w²·F(x/w) along the axes, for coordinates and w up to 1.
    pub(super) weight: f64,
    /// 1 / |unit|.
    pub(super) inverse: [f64; 3],
    /// Whether the terms may cancel at crossings more strongly than the usual error bounds allow.
    pub(super) cancels: bool,
}

/// The pairs of axes of `mixed`.
pub(super) const PAIRS: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// The number of roundings in a value of F, for error bounds. A value has ten terms of three factors each. A term
/// passes through two products, nine sums and the roundings of its coordinates (two each); five roundings are to spare
/// for the coefficients' own sums and roundings.
pub const OPERATIONS: u32 = 20;

/// The largest power of two that does not exceed |x|, kept among the normal numbers; 1 for zero.
#[inline]
pub(super) fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    f64::from_bits(x.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

/// 1/x of a [power of two](power_of_two); zero where that is no normal number.
#[inline]
pub(super) fn reciprocal(x: f64) -> f64 {
    // The exponents of the two add up to this.
    const EXPONENTS: u64 = 0x7fe0_0000_0000_0000;
    f64::from_bits(EXPONENTS - x.to_bits())
}

/// The sum of a double and its rounding error `rest`, if this kind of number has digits for both; else the double
/// alone.
fn whole<R: Traced>(x: f64, rest: f64) -> R {
    if !is_final::<R>() {
        R::of(x)
    } else {
        R::of(x) + R::of(rest)
    }
}

impl QuadricForm {
    /// A canonical form: no mixed terms, and y the only linear one.
    pub fn canonical(square: [f64; 3], y: f64, constant: f64, unit: [f64; 3]) -> QuadricForm {
        QuadricForm {
            square,
            mixed: [0.0; 3],
            linear: [0.0, y, 0.0],
            rest: [[0.0; 3]; 2],
            constant,
            unit,
            degree: [0; 3],
            second: 0.0,
            weight: 0.0,
            inverse: [1.0; 3],
            cancels: false,
        }
        .completed()
    }

    /// The coefficients of the polynomial: see [`Form::Quadric`](crate::trace::shapes::outline::Form::Quadric).
    pub fn polynomial(&self) -> [f64; 10] {
        let per = each(self.unit, |unit| 1.0 / unit);
        let [xx, yy, zz] = each([0, 1, 2], |i| self.square[i] * per[i] * per[i]);
        let [xy, xz, yz] = each([0, 1, 2], |i| {
            let (a, b) = PAIRS[i];
            self.mixed[i] * per[a] * per[b]
        });
        let [x, y, z] = each([0, 1, 2], |i| self.linear[i] * per[i]);
        [xx, yy, zz, xy, xz, yz, x, y, z, self.constant]
    }

    /// The form xᵀQx with x = (x, y, z, 1), divided by a power of two so that sums cannot overflow.
    pub fn symmetric_part(q: &[f64; 16]) -> QuadricForm {
        let largest = q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let scale = power_of_two(largest);
        let at = |i: usize, j: usize| q[4 * i + j] / scale;
        let both = |i: usize, j: usize| Dd::sum(at(i, j), at(j, i)).parts();
        let (mixed, linear) = (
            each(PAIRS, |(i, j)| both(i, j)),
            each([0, 1, 2], |i| both(i, 3)),
        );
        let mut form = QuadricForm {
            square: each([0, 1, 2], |i| at(i, i)),
            mixed: each(mixed, |x| x.0),
            linear: each(linear, |x| x.0),
            rest: each([mixed, linear], |list| each(list, |x| x.1)),
            constant: at(3, 3),
            unit: [1.0; 3],
            degree: [0; 3],
            second: 0.0,
            weight: 0.0,
            inverse: [1.0; 3],
            cancels: false,
        }
        .completed();
        form.cancels = form.may_cancel();
        form
    }

    /// Whether some axes of the quadric are much longer than others, or the quadric is far from the origin beside its
    /// size. Canonical forms are not asked: each of their axes has a unit of its own, and they are at the origin.
    fn may_cancel(&self) -> bool {
        /// The bound below which a product of the three eigenvalues, in units of the sum of all squares to the 3/2, is
        /// that of a stretched quadric. Axes four to eight times as long as others are at the bound.
        const STRETCHED: f64 = 5e-3;
        /// The square of the centre's distance from the origin, in units of the squared size, above which a quadric is
        /// far away.
        const AWAY: f64 = 10.0;
        if self.second == 0.0 {
            return false;
        }
        // Axes without a second power do not count: they get the coefficient 1, as the largest one.
        let is_curved = each(self.degree, |n| n == 2);
        let square = each([0, 1, 2], |i| match is_curved[i] {
            true => self.square[i] / self.second,
            false => 1.0,
        });
        let [xy, xz, yz] = each(self.mixed, |x| 0.5 * x / self.second);
        let rows = [
            [square[0], xy, xz],
            [xy, square[1], yz],
            [xz, yz, square[2]],
        ]
        .map(Vec3);
        // The columns of the adjugate.
        let others = each([0, 1, 2], |i| rows[(i + 1) % 3].cross(rows[(i + 2) % 3]));
        let determinant = rows[0].dot(others[0]);
        let all: f64 = rows.iter().map(|row| row.dot(*row)).sum();
        if determinant.abs() < STRETCHED * all * all.sqrt() {
            return true;
        }
        let half = |i: usize| match is_curved[i] {
            true => 0.5 * self.linear[i] / self.second,
            false => 0.0,
        };
        let half = Vec3(each([0, 1, 2], half));
        let centre = -Vec3(each(others, |column| column.dot(half))) / determinant;
        let straight = (0..3).filter(|&i| !is_curved[i]);
        let straight = straight.map(|i| self.linear[i].abs()).fold(0.0, f64::max) / self.second;
        let size = (self.constant / self.second + half.dot(centre)).abs() + straight * straight;
        centre.dot(centre) > AWAY * size
    }

    /// The form with the values that follow from its coefficients.
    fn completed(mut self) -> QuadricForm {
        let sum = |list: &[f64; 3]| list.iter().map(|x| x.abs()).sum::<f64>();
        self.weight = 2.0 * sum(&self.square) + 2.0 * sum(&self.mixed) + sum(&self.linear);
        let curved = self.square.iter().chain(&self.mixed);
        self.second = curved.fold(0.0f64, |m, x| m.max(x.abs()));
        self.inverse = each(self.unit, |s| s.abs().recip());
        for i in 0..3 {
            self.degree[i] = u8::from(self.linear[i] != 0.0);
            let mut pairs = PAIRS.iter().zip(self.mixed);
            if self.square[i] != 0.0 || pairs.any(|(&(j, k), m)| m != 0.0 && (i == j || i == k)) {
                self.degree[i] = 2;
            }
        }
        self
    }

    pub fn feed(&self, sink: &mut dyn FnMut(f64)) {
        let QuadricForm {
            square,
            mixed,
            linear,
            rest: [mixed_rest, linear_rest],
            constant,
            unit,
            degree: _,
            second: _,
            weight: _,
            inverse: _,
            cancels: _,
        } = self;
        for list in [square, mixed, linear, mixed_rest, linear_rest, unit] {
            list.iter().copied().for_each(&mut *sink);
        }
        sink(*constant);
    }

    /// The greatest distance at which terms of different degrees are equal in size. Much farther out only the terms of
    /// second degree count, and the digits lost by the others are small beside a point's coordinates.
    pub(super) fn extent(&self) -> f64 {
        let of = |list: &[f64]| list.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let linear = of(&self.linear);
        let unit = of(&self.unit);
        let coefficients = self.square.iter().chain(&self.mixed);
        let least = coefficients
            .filter(|&&x| x != 0.0)
            .fold(f64::INFINITY, |m, x| m.min(x.abs()));
        let by_linear = if linear > 0.0 {
            (self.constant / linear).abs()
        } else {
            0.0
        };
        let by_square = (linear / least).max((self.constant.abs() / least).sqrt());
        unit * by_linear.max(by_square)
    }

    /// The coefficient of the pair of axes `k`, as exact as this kind of number can hold it.
    #[inline]
    pub(super) fn mixed<R: Traced>(&self, k: usize) -> R {
        whole(self.mixed[k], self.rest[0][k])
    }

    /// The linear coefficient of axis `i`, as exact as this kind of number can hold it.
    #[inline]
    pub(super) fn linear<R: Traced>(&self, i: usize) -> R {
        whole(self.linear[i], self.rest[1][i])
    }

    /// Whether this kind of number rounds a coefficient of second degree: that of pair `i`, or of the square of axis
    /// `i`.
    #[inline]
    pub(super) fn is_rounded<R: Traced>(&self, i: usize, pair: bool) -> bool {
        let (x, rest) = match pair {
            true => (self.mixed[i], self.rest[0][i]),
            false => (self.square[i], 0.0),
        };
        !is_final::<R>() && (rest != 0.0 || R::of(x).to_f64() != x)
    }

    /// Whether F is zero everywhere.
    pub(super) fn is_zero(&self) -> bool {
        let all = self.square.iter().chain(&self.mixed).chain(&self.linear);
        self.constant == 0.0 && all.into_iter().all(|&x| x == 0.0)
    }

    /// w²·F(x/w), and the sum of the sizes of its terms.
    #[inline]
    pub(super) fn value<R: Traced>(&self, x: Vec3<R>, w: R) -> (R, R) {
        let mut sum = R::of(self.constant) * w * w;
        let mut size = sum.abs();
        let mut add = |term: R| {
            sum += term;
            size += term.abs();
        };
        for i in 0..3 {
            add(R::of(self.square[i]) * x[i] * x[i]);
            add(self.linear::<R>(i) * x[i] * w);
        }
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            add(self.mixed::<R>(k) * x[i] * x[j]);
        }
        (sum, size)
    }

    /// The coefficients of F(p + t·d), the leading one first.
    #[inline]
    pub(super) fn along(&self, p: Vec3, d: Vec3) -> [f64; 3] {
        let (a, _) = self.value(d, 0.0);
        let (c, _) = self.value(p, 1.0);
        [a, self.gradient(p).dot(d), c]
    }

    /// The summed sizes of the terms of second, of first and of no degree, for coordinates up to 1 before the division
    /// by their units.
    pub(super) fn sizes(&self) -> [f64; 3] {
        let inverse = self.inverse;
        let (mut second, mut first) = (0.0, 0.0);
        for (i, scale) in inverse.into_iter().enumerate() {
            second += self.square[i].abs() * scale * scale;
            first += self.linear[i].abs() * scale;
        }
        for ((i, j), mixed) in PAIRS.into_iter().zip(self.mixed) {
            second += mixed.abs() * inverse[i] * inverse[j];
        }
        [second, first, self.constant.abs()]
    }

    /// The gradient of F at x, in the form's own units.
    #[inline]
    fn gradient<R: Traced>(&self, x: Vec3<R>) -> Vec3<R> {
        let mut g = Vec3(each([0, 1, 2], |i| {
            R::of(2.0 * self.square[i]) * x[i] + self.linear::<R>(i)
        }));
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            let m = self.mixed::<R>(k);
            g[i] += m * x[j];
            g[j] += m * x[i];
        }
        g
    }

    /// F at a point near the surface, and its error bound divided by γₙ, where n is [`OPERATIONS`]: the sum of the
    /// sizes of its terms, or less.
    #[inline]
    fn value_at<R: Traced>(&self, x: Vec3<R>) -> (R, R) {
        if !self.is_summed_closely::<R>() {
            return self.value(x, R::ONE);
        }
        let Bounded { value, error } = self.closely(x);
        (value, error / R::gamma(OPERATIONS))
    }

    /// The gradient at a point near the surface.
    #[inline]
    fn gradient_at<R: Traced>(&self, x: Vec3<R>) -> Vec3<R> {
        if !self.is_summed_closely::<R>() {
            return self.gradient(x);
        }
        Vec3(each([0, 1, 2], |axis| self.slope_closely(x, axis).value))
    }

    #[inline]
    pub(super) fn units<R: Traced>(&self) -> Vec3<R> {
        Vec3(each(self.unit, R::of))
    }

    /// The speed at which a line goes through the surface at t ([`Intersect::speed`]), computed from the gradient at
    /// the line's point; zero where the gradient does not give a number.
    ///
    /// [`Intersect::speed`]: crate::trace::shapes::Intersect::speed
    #[inline]
    pub(super) fn speed<R: Traced>(&self, line: &Line<R>, t: R) -> R {
        let unit = self.units::<R>();
        let gradient = self.gradient_at(line.at(t).zip(unit, |p, s| p / s));
        let normal = gradient.zip(unit, |g, s| g / s);
        // The length is up to √3 of the greatest component.
        let speed = normal.dot(line.direction).abs() / (R::of(1.75) * normal.abs().max_component());
        if speed.is_finite() { speed } else { R::ZERO }
    }

    /// The line's point at t, moved along the gradient onto the surface by two steps of Newton's method.
    ///
    /// The remaining error is the rounding in the value F, at most γₙ times the sizes of its terms, over the length of
    /// the gradient, twice for the steps' own rounding; and the rounding of the point. Where the gradient is so small
    /// that a step could leave the neighbourhood in which Newton's method converges (4·|F|·|A| > |∇F|², Kantorovich's
    /// condition, |A| a bound on the second derivatives) the surface turns within √(|F|/|A|) of the point. The point
    /// then stays where it is, with that error.
    pub(super) fn locate<R: Traced>(&self, line: &Line<R>, t: R) -> Located<R> {
        let unit = self.units::<R>();
        let start = line.at(t);
        let curvature = [self.square, self.mixed]
            .iter()
            .flatten()
            .fold(R::ZERO, |sum, &x| sum + R::of(2.0 * x.abs()));
        let mut x = start.zip(unit, |p, s| p / s);
        let mut stuck = None;
        for _ in 0..2 {
            let (value, size) = self.value_at(x);
            let g = self.gradient_at(x);
            let square = g.dot(g);
            let off = value.abs() + R::gamma(OPERATIONS) * size;
            let step = g * (value / square);
            if R::of(4.0) * off * curvature > square || !step.is_finite() {
                stuck = Some(off);
                break;
            }
            x = x - step;
        }
        let (_, size) = self.value_at(x);
        let g = self.gradient_at(x);
        let square = g.dot(g);
        let mut error = match stuck {
            None => g.abs() * (R::of(2.0) * R::gamma(OPERATIONS) * size / square),
            Some(off) if curvature > R::ZERO => Vec3::ONE * (off / curvature).sqrt(),
            Some(_) => Vec3::ZERO,
        };
        error = error.times(unit);
        let mut point = x.times(unit);
        if !point.is_finite() {
            point = start;
        }
        if !error.is_finite() {
            error = Vec3::ZERO;
        }
        // Divided by the gradient's size first: units and gradients may both be extreme.
        let mut normal = g.unit().zip(unit, |g, s| g / s);
        if !normal.any() || !normal.is_finite() {
            normal = -line.direction.unit();
        }
        Located {
            point,
            error: error + point.abs() * R::gamma(3),
            normal,
        }
    }
}
