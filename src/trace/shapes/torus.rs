//! The torus.
//!
//! In a half-plane through the axis, with ρ = √(x² + z²), the tube is a circle around (R, 0) and
//! its image beyond the axis one around (−R, 0):
//!
//! ```text
//! g₋ = (ρ − R)² + y² − r²,    g₊ = (ρ + R)² + y² − r² = g₋ + 4Rρ.
//! ```
//!
//! Their product is the quartic (x² + y² + z² + R² − r²)² − 4R²(x² + z²). With r > R the tube runs through itself, and
//! g₊ ≤ 0 in the lemon around the axis. The lemon is inside twice, hence outside by the even-odd rule, and the quartic
//! is positive there, too. The solid is where the quartic is not positive.

use super::error_bound::is_final;
use super::outline::{Form, Outline};
use super::quad_double::decide_closer;
use super::quick_reject::{
    Approach, Ball, LINE_REL_ERROR, POLYNOMIAL_MARGIN, Pass, is_quartic_above,
};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::exponent::{exponent, shifted, shifted_vector};
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::qd::Qd;
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::quartic::{Quartic, root_between};
use crate::trace::shapes::support::Support;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Faces of a torus: the outer surface, and the one around the lemon.
const OUTER: u32 = 0;
const LEMON: u32 = 1;

#[derive(Debug, Clone, PartialEq)]
pub struct Torus {
    record: solids::torus::Torus,
    /// The binary exponent of the greater radius. Lines are scaled by 2 to the power −`size`.
    size: i32,
}

/// The region, bounded by the two circles, that a point is in.
#[derive(Debug, Clone, Copy, PartialEq)]
enum TorusRegion {
    Outside,
    Tube,
    Lemon,
}

impl TorusRegion {
    fn is_inside(self) -> bool {
        self == TorusRegion::Tube
    }
}

/// A line in units in which the greater radius lies in [1, 2).
struct Scaled<R> {
    major: R,
    minor: R,
    /// The point of the line nearest to the centre, but for rounding along the line.
    near: Vec3<R>,
    /// The direction, whose largest component is in [1, 2).
    direction: Vec3<R>,
    /// Bound on the error of each component of a point near the torus, without the last rounding of the point itself:
    /// the error of moving the origin, and the line's own slack.
    error: R,
}

impl Torus {
    pub fn new(major: f64, minor: f64) -> Torus {
        Torus {
            record: solids::torus::Torus { major, minor },
            size: exponent(major.max(minor)),
        }
    }

    /// The unit of [`Torus::radii`] and its reciprocal; `None` if the radii are extremely large or small.
    pub fn unit(&self) -> Option<[f64; 2]> {
        const MOST: i32 = 100;
        let is_usual = self.size.abs() <= MOST;
        is_usual.then(|| each([self.size, -self.size], |k| shifted(1.0, k)))
    }

    /// R and r in units of a power of two, so that the greater one lies in [1, 2).
    pub fn radii<R: Traced>(&self) -> [R; 2] {
        each([self.record.major, self.record.minor], |r| {
            R::of(shifted(r, -self.size))
        })
    }

    /// The quartic of a line's points, the leading coefficient first: (at² + 2bt + k)² − 4R²(x² + z²). It is negative
    /// in the tube, and positive outside and in the lemon.
    fn quartic(&self, approach: &Approach) -> [f64; 5] {
        let (p, d) = (approach.point, approach.direction);
        let flat = |v: Vec3, w: Vec3| v[0] * w[0] + v[2] * w[2];
        let (a, b) = (d.dot(d), p.dot(d));
        let k = p.dot(p)
            + (self.record.major - self.record.minor) * (self.record.major + self.record.minor);
        let four = 4.0 * self.record.major * self.record.major;
        [
            a * a,
            4.0 * a * b,
            2.0 * a * k + 4.0 * b * b - four * flat(d, d),
            4.0 * b * k - 2.0 * four * flat(p, d),
            k * k - four * flat(p, p),
        ]
    }

    /// Appends the crossings. The line's stretch in the bounding sphere is cut at the points where the quartic may turn
    /// ([`Quartic::pieces`]). For each point, the signs of g₋ and g₊ (see the head of this file) say in which region it
    /// is; the quartic does not, since its rounding errors do not shrink with the tube. Between two neighbours in
    /// different regions there is exactly one crossing: a root of the quartic, refined by Newton's method on the g that
    /// changes its sign. A point that is too close to the surface to tell its region counts as a touch.
    ///
    /// Stops after the first crossing beyond `enough`.
    fn decide<R: Traced>(&self, line: &Line<R>, enough: R, roots: &mut Roots<R>) {
        let longest = line.direction.abs().max_component();
        let unit = exponent(longest.to_f64());
        let origin = shifted_vector(line.origin, -self.size);
        let direction = shifted_vector(line.direction, -unit);
        let a = direction.dot(direction);

        // The origin moves twice: after the first time it is off along the line by the rounding of
        // t₀, which may be large, and after the second by that of a small t₁.
        let t0 = -(origin.dot(direction) / a);
        let first = direction.zip(origin, |d, o| d.mul_add(t0, o));
        let t1 = -(first.dot(direction) / a);
        let near = direction.zip(first, |d, o| d.mul_add(t1, o));
        if !near.is_finite() {
            // The line is too far away, or the torus too small, to tell.
            roots.uncertain = true;
            return;
        }

        // Each move rounds its result once if the product is not rounded before; else it rounds
        // the two terms as well, which are no longer than the origin.
        let moved = first.abs().max_component() + near.abs().max_component();
        let rounded = if is_final::<R>() {
            moved + R::of(4.0) * (origin.abs().max_component() + first.abs().max_component())
        } else {
            moved
        };
        let drift = line.drift(R::of(self.record.major + self.record.minor));
        let [major, minor] = self.radii();
        let scaled = Scaled {
            major,
            minor,
            near,
            direction,
            error: R::ROUNDOFF * rounded + shifted(drift, -self.size),
        };
        // Shifting by this many bits gives t in units of the given direction.
        let units = self.size - unit;
        scaled
            .crossings(|t, face| {
                let t = shifted(t0 + (t1 + t), units);
                match roots.list.last() {
                    Some(last) if t <= last.t => {
                        roots.list.pop();
                        roots.uncertain = true;
                    }
                    _ => roots.push(t, face),
                }
                match t > enough {
                    true => ControlFlow::Break(()),
                    false => ControlFlow::Continue(()),
                }
            })
            .then(|| roots.uncertain = true);
        if roots.list.iter().any(|root| !root.t.is_finite()) {
            roots.list.clear();
            roots.uncertain = true;
        }
    }
}

impl Shape for Torus {
    fn bounds(&self) -> Aabb {
        let reach = self.record.major + self.record.minor;
        let corner = Vec3::new(reach, self.record.minor, reach);
        Aabb::new(-corner, corner).padded()
    }

    /// The line is beside the torus if the quartic is positive wherever the line is in the slab and the ball around
    /// the torus.
    fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        let approach = match Ball::meets(
            line,
            stretch,
            Vec3::ZERO,
            self.record.major + self.record.minor,
        ) {
            Ball::Misses => return Pass::Beside,
            Ball::Unknown => return Pass::Perhaps,
            Ball::Meets(approach) => approach,
        };
        let Some(stretch) = approach.between(1, -self.record.minor, self.record.minor) else {
            return Pass::Beside;
        };
        let margin = POLYNOMIAL_MARGIN * (self.record.major + self.record.minor).powi(4);
        let quartic = self.quartic(&approach);
        if is_quartic_above(quartic, stretch, margin) {
            return Pass::Beside;
        }
        let value = |t: f64| quartic.into_iter().fold(0.0, |sum, c| sum * t + c);
        approach.through(0.5 * (stretch[0] + stretch[1]), margin, value)
    }

    fn outline(&self) -> Outline {
        Outline::exact(Form::Torus([self.record.major, self.record.minor]))
    }

    /// A tangent plane of the outer half has all of the torus on one side, so a ray that leaves there does not come
    /// back. A ray that leaves elsewhere does not come back if the quartic without its root at the origin is positive
    /// ahead.
    fn is_met_again(&self, line: &Line) -> bool {
        let size = self.record.major + self.record.minor;
        let [x, _, z] = line.origin.0;
        let is_outer =
            x * x + z * z > self.record.major * self.record.major + POLYNOMIAL_MARGIN * size * size;
        if is_outer
            && self.record.minor <= self.record.major
            && line.slack.origin <= LINE_REL_ERROR * size
        {
            return false;
        }
        let ahead = [0.0, f64::INFINITY];
        let Ball::Meets(approach) = Ball::meets(line, ahead, Vec3::ZERO, size) else {
            return true;
        };
        let [c4, c3, c2, c1, _] = self.quartic(&approach);
        // The quartic minus its value at s, divided by t − s.
        let s = approach.origin;
        let a = c4 * s + c3;
        let b = a * s + c2;
        let cubic = [0.0, c4, a, b, b * s + c1];
        let margin = POLYNOMIAL_MARGIN * size.powi(3);
        !is_quartic_above(cubic, [s, approach.stretch[1]], margin)
    }

    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let [x, y, z] = point.0;
        let rho = libm::hypot(x, z);
        let across = if face == LEMON { -rho } else { rho };
        let turn = |angle: f64| angle.rem_euclid(TAU) / TAU;
        [
            turn(libm::atan2(-z, x)),
            turn(libm::atan2(y, across - self.record.major)),
        ]
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn holds(&self, point: Vec3) -> bool {
        self.record.holds(point.0)
    }

    fn support(&self, _: u32) -> Option<Support> {
        None
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.record.major);
        sink(self.record.minor);
    }
}

impl<R: Traced> Intersect<R> for Torus {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        self.decide(line, R::INFINITY, roots);
        decide_closer(line, roots, |line, roots| {
            self.decide(line, Qd::INFINITY, roots);
        });
    }

    fn first_crossings(&self, line: &Line<R>, near: R, roots: &mut Roots<R>) {
        let reach =
            line.origin.abs().max_component() + R::of(self.record.major + self.record.minor);
        let size = reach / line.direction.abs().max_component();
        let slack = line.slack.origin + line.slack.direction * size;
        // Written so that NaN fails. Single precision does not know well enough where a line is.
        if R::ROUNDOFF <= R::of(f64::EPSILON) && slack <= R::of(LINE_REL_ERROR) * reach {
            self.decide(line, near + size * R::of(0.01), roots);
            if !roots.uncertain {
                return;
            }
            roots.clear();
        }
        self.crossings(line, roots);
    }

    fn speed(&self, _: &Line<R>, _: Root<R>) -> Option<R> {
        None
    }

    /// The line's point, pushed onto the circle in the point's half-plane.
    ///
    /// (h, y) = (ρ ∓ R, y), scaled to the length r, has components off by γ₆ of themselves from a
    /// point of the circle whatever t was: one half of the three roundings below the root, one for
    /// it, two for the scaling, two more for where a component is used. Adding R to h and turning
    /// by (x, z)/ρ, γ₅ with the root, rounds the rest (pbrt-v4, section 6.8.4).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let to_size = |v| shifted_vector(v, -self.size);
        let [major, radius]: [R; 2] = self.radii();
        let centre = if root.face == LEMON { -major } else { major };

        let [x, y, z] = to_size(line.at(root.t)).0;
        let rho = length(x, z);
        let (cos, sin) = if rho > R::ZERO && rho.is_finite() {
            (x / rho, z / rho)
        } else {
            (R::ONE, R::ZERO)
        };
        let h = rho - centre;
        let from_centre = length(h, y);
        let (h, y) = if from_centre > R::ZERO && from_centre.is_finite() {
            (h / from_centre * radius, y / from_centre * radius)
        } else {
            (radius, R::ZERO)
        };
        let rho = centre + h;
        let point = Vec3::new(rho * cos, y, rho * sin);
        let across = h.abs() * R::gamma(6);
        let error = Vec3::new(
            across * cos.abs() + point[0].abs() * R::gamma(6),
            y.abs() * R::gamma(6),
            across * sin.abs() + point[2].abs() * R::gamma(6),
        );
        // The normal is scaled to unit size, since a tube may be so thin that the square of its radius is zero.
        let normal = Vec3::new(h * cos, y, h * sin).unit();
        let normal = if normal.any() {
            normal
        } else {
            Vec3::new(cos, R::ZERO, sin)
        };
        Located {
            point: shifted_vector(point, self.size),
            error: shifted_vector(error, self.size),
            // The solid is outside of the circle at the lemon's surface.
            normal: if root.face == LEMON { -normal } else { normal },
        }
    }
}

/// The largest error of points, as a share of R + r, with which anything is decided about a line. Products of errors
/// are then far below the errors, and the ends of the stretch in the sphere are outside of the torus.
pub const MOST_ERROR: f64 = 1.0 / 256.0;

/// A bound on how far the quartic at one of the points of [`Quartic::pieces`] is from its true extremum nearby.
struct Flatness<'a, R> {
    quartic: &'a Quartic<R>,
    /// Bound on the error of the slope: e.
    slope_error: R,
    /// A bound that holds for every point, since an extremum is not farther away than the ends.
    most: R,
}

impl<R: Traced> Flatness<'_, R> {
    /// Whether the bound at t, one of the points of [`Quartic::pieces`], is below a value of the quartic there.
    #[inline]
    fn is_below(&self, value: R, t: R) -> bool {
        value > self.most || value > self.at(t)
    }

    /// The bound at t. The points are exact for a quartic whose slope is off by e. A true extremum t′ without a point
    /// of its own is one of a pair around an inflection point, where the true slope changes its sign and the computed
    /// slope does not: between t′ and the inflection point the slope is at most 3e. The same holds between t′ and its
    /// own point, where it has one.
    ///
    /// Nothing hides near a point where the slope exceeds 8e. Where the curvature κ is enough to change the slope by
    /// 16e within w = 16e/κ, with half of the third derivative and the fourth taking away less than a quarter, the
    /// curvature keeps its sign over that stretch: there is one extremum, at most (|slope| + e) / ¾κ away, and the
    /// slope only falls on the way to it. Elsewhere, the slope is a cubic that is at most 3e over the stretch w
    /// between: 4c₄ · 2(w/4)³ ≤ 3e (Chebyshev), hence w < 3∛(e/c₄).
    #[cold]
    fn at(&self, t: R) -> R {
        let e = self.slope_error;
        let [slope, curvature, third] = each(self.quartic.derivatives(t), R::abs);
        if slope > R::of(8.0) * e {
            return R::ZERO;
        }
        let leading = self.quartic.c[0];
        let w = R::of(16.0) * e / curvature;
        let bending = (third * R::of(0.5) + R::of(4.0) * leading * w) * w;
        if bending <= curvature * R::of(0.25) {
            (slope + e).square() / (R::of(0.75) * curvature)
        } else {
            R::of(9.0) * e * R::of(libm::cbrt((e / leading).to_f64()))
        }
    }
}

impl<R: Traced> Scaled<R> {
    /// Calls `crossing` with the t and the face of each crossing, in ascending order, until `crossing` breaks off.
    /// Returns whether rounding may have added or lost a crossing up to there.
    fn crossings(&self, mut crossing: impl FnMut(R, u32) -> ControlFlow<()>) -> bool {
        let (two, four) = (R::of(2.0), R::of(4.0));
        let (p, d) = (self.near, self.direction);
        let a = d.dot(d);
        let b = p.dot(d);
        let c = p.dot(p);

        // The sphere around the torus is a sixteenth wider: the ends of the stretch in it are outside of the torus by
        // far more than any error here, and the quartic is far from zero there.
        let size = self.major + self.minor;
        let reach = size * R::of(1.0625);
        // The point nearest to the centre is off along the line by less than 16 errors.
        let beyond = R::of(32.0) * (size + four * self.error);
        if p.abs().max_component() > beyond {
            return false;
        }
        // False for NaN.
        let is_known = self.error <= size * R::of(MOST_ERROR);
        if !is_known {
            return true;
        }
        let discriminant = R::difference_of_products(b, b, a, c - reach * reach);
        if discriminant <= R::ZERO {
            return false;
        }
        let s = discriminant.sqrt();
        let (from, to) = ((-b - s) / a, (-b + s) / a);

        // (at² + 2bt + k)² − 4R²(eₐt² + 2e_b t + e_c), k = c + R² − r².
        let (major2, e) = (self.major.square(), |v: Vec3<R>, w: Vec3<R>| {
            v[0] * w[0] + v[2] * w[2]
        });
        let k = c + (self.major - self.minor) * (self.major + self.minor);
        let (ea, eb, ec) = (e(d, d), e(p, d), e(p, p));
        let quartic = Quartic {
            c: [
                a * a,
                four * a * b,
                two * a * k + four * (b * b - major2 * ea),
                four * b * k - four * two * major2 * eb,
                k * k - four * major2 * ec,
            ],
        };
        let slope_error = self.slope_error(a);
        let flatness = Flatness {
            quartic: &quartic,
            slope_error,
            most: R::of(3.0) * slope_error * (to - from),
        };

        let (mut last, mut uncertain) = (None, false);
        quartic.pieces(from, to, |t| {
            let Some(before) = last else {
                last = Some((from, TorusRegion::Outside));
                return ControlFlow::Continue(());
            };
            let side = match t < to {
                true => self.side(t, &flatness),
                false => Some(TorusRegion::Outside),
            };
            let Some(side) = side else {
                uncertain = true;
                return ControlFlow::Continue(());
            };
            last = Some((t, side));
            if side.is_inside() == before.1.is_inside() {
                return ControlFlow::Continue(());
            }
            let enters = side.is_inside();
            let lemon = side == TorusRegion::Lemon || before.1 == TorusRegion::Lemon;
            let root = self.root(&quartic, (before.0, t), enters, lemon);
            crossing(root, if lemon { LEMON } else { OUTER })
        });
        uncertain
    }

    /// The point at t and its distance ρ from the axis.
    fn at(&self, t: R) -> (Vec3<R>, R) {
        let point = self.direction.zip(self.near, |d, o| d.mul_add(t, o));
        (point, length_near_one(point[0], point[2]))
    }

    /// The value and the slope at t of g₋ (`centre` is R) or of g₊ (`centre` is −R).
    fn distance(&self, t: R, centre: R) -> (R, R) {
        let (point, rho) = self.at(t);
        let h = rho - centre;
        let d = self.direction;
        let outwards = if rho > R::ZERO {
            (point[0] * d[0] + point[2] * d[2]) / rho
        } else {
            R::ZERO
        };
        let y = point[1];
        // r² first, so that of the three squares the small ones are added last.
        let value = h.mul_add(h, (y - self.minor) * (y + self.minor));
        (value, R::of(2.0) * (h * outwards + y * d[1]))
    }

    /// The region that the point at t is in; `None` where rounding may have decided it.
    ///
    /// Each component of the point is off by at most ε = u|p| + the error of the line, hence ρ by
    /// √2 ε + 3uρ and h = ρ ∓ R by u|h| more; then h² + (y − r)(y + r) by 2|h|Δh + 2|y|ε and by
    /// the rounding of the terms, γ₃(h² + y² + r²). All of it twice, for the products of errors.
    ///
    /// The quartic, the product of both, must also be farther from zero than it may be from its extremum nearby: the
    /// bound of [`Flatness`].
    fn side(&self, t: R, flatness: &Flatness<R>) -> Option<TorusRegion> {
        let (point, rho) = self.at(t);
        let (u, two) = (R::ROUNDOFF, R::of(2.0));
        let epsilon = self.error + u * point.abs().max_component();
        let y = point[1];
        let g = |centre: R| {
            let h = rho - centre;
            let value = h.mul_add(h, (y - self.minor) * (y + self.minor));
            let h_error = R::of(1.5) * epsilon + u * (R::of(3.0) * rho + h.abs());
            let bound = two * (h.abs() * h_error + y.abs() * epsilon)
                + R::gamma(3) * (h * h + y * y + self.minor.square());
            (value, two * bound)
        };
        let ((outer, outer_bound), (inner, inner_bound)) = (g(self.major), g(-self.major));
        let (outer_least, inner_least) = (outer.abs() - outer_bound, inner.abs() - inner_bound);
        // Written so that NaN is in doubt.
        let is_clear = outer_least > R::ZERO && inner_least > R::ZERO;
        if !is_clear || !flatness.is_below(outer_least * inner_least, t) {
            return None;
        }
        Some(match (outer > R::ZERO, inner > R::ZERO) {
            (true, _) => TorusRegion::Outside,
            (false, true) => TorusRegion::Tube,
            (false, false) => TorusRegion::Lemon,
        })
    }

    /// A bound on how far the computed slope of the quartic in the sphere may be from that of the
    /// line that is meant.
    ///
    /// Only points close to the torus matter: they are within S = R + r of the centre, and so are
    /// the nearest point and t|d|. As b is zero but for rounding, the slope's terms,
    /// 2(at² + k)(2at) and 4R²(2eₐt + 2e_b), add up to 2 · 3S² · 2|d|S + 4S² · 4|d|S = 28|d|S³ at
    /// most; the coefficients have 12 roundings behind them and their evaluation 8 more. The
    /// gradient of the quartic, 4(|p|² + R² − r²)p − 8R²(x, 0, z), is up to 16S³ and changes by up
    /// to 24S² times the distance, so that moving points by ε along each axis, and the direction by
    /// less than ε|d|/S, changes the slope by (24√3 + 16)|d|S²ε < 58|d|S²ε.
    fn slope_error(&self, a: R) -> R {
        let size = self.major + self.minor;
        R::of(64.0) * a.sqrt() * size.square() * (R::gamma(20) * size + self.error)
    }

    /// The only crossing in a bracket whose ends are in different regions.
    fn root(&self, quartic: &Quartic<R>, bracket: (R, R), enters: bool, lemon: bool) -> R {
        let (low, high) = bracket;
        // One end, the one inside if the line grazes the torus, is where the quartic turns: a
        // parabola with its vertex there and through the other end is close to the root.
        let (inner, outer) = if enters { (high, low) } else { (low, high) };
        let (depth, height) = (quartic.at(inner).0.abs(), quartic.at(outer).0.abs());
        let start = inner + (outer - inner) * (depth / (depth + height)).sqrt();
        // The quartic gives half of the digits; two Newton steps on g give the rest.
        let coarse = R::ROUNDOFF.sqrt() * (high - low);
        let start = root_between(|t| quartic.at(t), bracket, !enters, start, coarse);
        // On the way from the tube into the lemon g₊ falls.
        let (centre, rising) = if lemon {
            (-self.major, enters)
        } else {
            (self.major, !enters)
        };
        let precision = R::ROUNDOFF * low.abs().max(high.abs());
        // The least that rounding a point on the surface, where |h| and |y| are up to r, changes g by: nothing is to
        // be gained below it.
        let noise = R::ROUNDOFF * self.minor * (self.major + self.minor);
        let g = |t| {
            let (value, slope) = self.distance(t, centre);
            let value = if value.abs() <= noise { R::ZERO } else { value };
            (value, slope)
        };
        root_between(g, bracket, rising, start, precision)
    }
}

/// √(x² + z²), where neither is so large or so small that its square is not a number or zero.
fn length_near_one<R: Traced>(x: R, z: R) -> R {
    (x * x + z * z).sqrt()
}

/// √(x² + z²) of any numbers.
fn length<R: Traced>(x: R, z: R) -> R {
    Vec3::new(x, R::ZERO, z).length()
}

#[cfg(test)]
#[path = "torus_tests.rs"]
mod tests;
