//! A polynomial of second degree, its value and its gradient.

use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::shapes::Located;
use crate::trace::vec::Vec3;

/// F(x) = Σ squareᵢ xᵢ² + mixed·(xy, xz, yz) + linear·x + constant, where xᵢ is a coordinate divided
/// by unitᵢ: semi-axes stay as they were given, and the coefficients of canonical forms exact.
#[derive(Debug, Clone, PartialEq)]
pub struct Form {
    pub(super) square: [f64; 3],
    pub(super) mixed: [f64; 3],
    pub(super) linear: [f64; 3],
    pub(super) constant: f64,
    pub(super) unit: [f64; 3],
}

/// The pairs of axes of `mixed`.
pub(super) const PAIRS: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Ten terms of three factors each: products, sums and roundings of coordinates (two each), with
/// two to spare for the coefficients' own sums.
pub(super) const OPERATIONS: u32 = 18;

/// The largest power of two that does not exceed |x|, kept among the normal numbers; 1 for zero.
pub(super) fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    f64::from_bits(x.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

impl Form {
    /// A canonical form: no mixed terms, and y the only linear one.
    pub fn canonical(square: [f64; 3], y: f64, constant: f64, unit: [f64; 3]) -> Form {
        Form {
            square,
            mixed: [0.0; 3],
            linear: [0.0, y, 0.0],
            constant,
            unit,
        }
    }

    /// xᵀQx with x = (x, y, z, 1), divided by a power of two so that sums cannot overflow.
    pub fn symmetric_part(q: &[f64; 16]) -> Form {
        let largest = q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let scale = power_of_two(largest);
        let at = |i: usize, j: usize| q[4 * i + j] / scale;
        let both = |i: usize, j: usize| at(i, j) + at(j, i);
        Form {
            square: std::array::from_fn(|i| at(i, i)),
            mixed: PAIRS.map(|(i, j)| both(i, j)),
            linear: std::array::from_fn(|i| both(i, 3)),
            constant: at(3, 3),
            unit: [1.0; 3],
        }
    }

    pub fn feed(&self, sink: &mut dyn FnMut(f64)) {
        let Form {
            square,
            mixed,
            linear,
            constant,
            unit,
        } = self;
        for list in [square, mixed, linear, unit] {
            list.iter().copied().for_each(&mut *sink);
        }
        sink(*constant);
    }

    /// The greatest distance at which terms of different degrees are equal in size: much farther out
    /// only those of the second count, and what is lost to the others is small beside a point.
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

    /// Whether F is zero everywhere.
    pub(super) fn is_zero(&self) -> bool {
        let all = self.square.iter().chain(&self.mixed).chain(&self.linear);
        self.constant == 0.0 && all.into_iter().all(|&x| x == 0.0)
    }

    /// w²·F(x/w), and the sum of the sizes of its terms.
    pub(super) fn value<R: Real>(&self, x: Vec3<R>, w: R) -> (R, R) {
        let mut sum = R::of(self.constant) * w * w;
        let mut size = sum.abs();
        let mut add = |term: R| {
            sum += term;
            size += term.abs();
        };
        for i in 0..3 {
            add(R::of(self.square[i]) * x[i] * x[i]);
            add(R::of(self.linear[i]) * x[i] * w);
        }
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            add(R::of(self.mixed[k]) * x[i] * x[j]);
        }
        (sum, size)
    }

    /// The gradient of F at x, in the form's own units.
    fn gradient<R: Real>(&self, x: Vec3<R>) -> Vec3<R> {
        let mut g =
            Vec3([0, 1, 2].map(|i| R::of(2.0 * self.square[i]) * x[i] + R::of(self.linear[i])));
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            let m = R::of(self.mixed[k]);
            g[i] += m * x[j];
            g[j] += m * x[i];
        }
        g
    }

    pub(super) fn units<R: Real>(&self) -> Vec3<R> {
        Vec3(self.unit.map(R::of))
    }

    /// The point at t, moved along the gradient onto the surface by two steps of Newton's method.
    ///
    /// What remains is the rounding in the value F, at most γₙ times the sizes of its terms, over
    /// the length of the gradient, twice for the steps' own rounding; and of the point. Where the
    /// gradient is so small that a step could leave the neighbourhood in which Newton's method
    /// converges (4·|F|·|A| > |∇F|², Kantorovich's condition, |A| a bound on the second
    /// derivatives) the surface turns within √(|F|/|A|) of the point: it stays, with that error.
    pub(super) fn locate<R: Real>(&self, line: &Line<R>, t: R) -> Located<R> {
        let unit = self.units::<R>();
        let start = line.at(t);
        let curvature = [self.square, self.mixed]
            .iter()
            .flatten()
            .fold(R::ZERO, |sum, &x| sum + R::of(2.0 * x.abs()));
        let mut x = start.zip(unit, |p, s| p / s);
        let mut stuck = None;
        for _ in 0..2 {
            let (value, size) = self.value(x, R::ONE);
            let g = self.gradient(x);
            let square = g.dot(g);
            let off = value.abs() + R::gamma(OPERATIONS) * size;
            let step = g * (value / square);
            if R::of(4.0) * off * curvature > square || !step.is_finite() {
                stuck = Some(off);
                break;
            }
            x = x - step;
        }
        let (_, size) = self.value(x, R::ONE);
        let g = self.gradient(x);
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
