//! The torus.
//!
//! In a half-plane through the axis, with ρ = √(x² + z²), the tube is a circle around (R, 0) and
//! its image beyond the axis one around (−R, 0):
//!
//! ```text
//! g₋ = (ρ − R)² + y² − r²,    g₊ = (ρ + R)² + y² − r² = g₋ + 4Rρ.
//! ```
//!
//! Their product is the quartic (x² + y² + z² + R² − r²)² − 4R²(x² + z²). With r > R the tube runs
//! through itself, and g₊ ≤ 0 in the lemon around the axis: that is inside twice, hence outside by
//! the even-odd rule, and there the quartic is positive too. The solid is where it is not.

use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::exponent::{exponent, shifted, shifted_vector};
use crate::trace::number::Real;
use crate::trace::quartic::{Quartic, root_between};
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;
use std::f64::consts::TAU;

/// Faces of a torus: the outer surface, and the one around the lemon.
const OUTER: u32 = 0;
const LEMON: u32 = 1;

#[derive(Debug, Clone, PartialEq)]
pub struct Torus {
    /// R.
    major: f64,
    /// r.
    minor: f64,
    /// The exponent of the greater of the two: rays are scaled by two to minus this.
    size: i32,
}

/// On which side of the two circles a point is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Side {
    Outside,
    Tube,
    Lemon,
}

impl Side {
    fn is_inside(self) -> bool {
        self == Side::Tube
    }
}

/// A line in units in which the greater radius lies in [1, 2).
struct Scaled<R> {
    major: R,
    minor: R,
    /// The point of the line nearest to the centre, but for rounding along the line.
    near: Vec3<R>,
    /// Its largest component is in [1, 2).
    direction: Vec3<R>,
    /// Bound on the error of each component of a point near the torus, from all but the last
    /// rounding of the point itself.
    error: R,
}

impl Torus {
    pub fn new(major: f64, minor: f64) -> Torus {
        Torus {
            major,
            minor,
            size: exponent(major.max(minor)),
        }
    }
}

impl Shape for Torus {
    fn bounds(&self) -> Bounds {
        let reach = self.major + self.minor;
        let corner = Vec3::new(reach, self.minor, reach);
        Bounds::new(-corner, corner).padded()
    }

    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let [x, y, z] = point.0;
        let rho = x.hypot(z);
        let across = if face == LEMON { -rho } else { rho };
        let turn = |angle: f64| angle.rem_euclid(TAU) / TAU;
        [turn((-z).atan2(x)), turn(y.atan2(across - self.major))]
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.major);
        sink(self.minor);
    }
}

impl<R: Real> Intersect<R> for Torus {
    /// The stretch of the line in the bounding sphere falls apart where the quartic may turn
    /// ([`Quartic::pieces`]). On which side these points are is read off g₋ and g₊, whose rounding
    /// errors shrink with the tube as those of the quartic's coefficients do not. Where two
    /// neighbours differ is one root: the quartic's, polished by Newton's method on the g that
    /// changes sign. A point too close to the surface to tell is taken for a touch.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
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
            // So far away, or so small, that it cannot be told.
            roots.uncertain = true;
            return;
        }

        // Each move rounds its result once if the product is not rounded before; else it rounds
        // the two terms as well, which are no longer than the origin.
        let moved = first.abs().max_component() + near.abs().max_component();
        let rounded = if multiply_add_rounds_once::<R>() {
            moved
        } else {
            moved + R::of(4.0) * (origin.abs().max_component() + first.abs().max_component())
        };
        let scaled = Scaled {
            major: shifted(R::of(self.major), -self.size),
            minor: shifted(R::of(self.minor), -self.size),
            near,
            direction,
            error: R::ROUNDOFF * rounded,
        };
        // In units of the direction given.
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
            })
            .then(|| roots.uncertain = true);
        if roots.list.iter().any(|root| !root.t.is_finite()) {
            roots.list.clear();
            roots.uncertain = true;
        }
    }

    /// The point on the line, pushed onto the circle in its half-plane.
    ///
    /// (h, y) = (ρ ∓ R, y), scaled to the length r, has components off by γ₆ of themselves from a
    /// point of the circle whatever t was: one half of the three roundings below the root, one for
    /// it, two for the scaling, two more for where a component is used. Adding R to h and turning
    /// by (x, z)/ρ, γ₅ with the root, rounds the rest (pbrt-v4, section 6.8.4).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let to_size = |v| shifted_vector(v, -self.size);
        let (major, minor) = (R::of(self.major), R::of(self.minor));
        let centre = shifted(if root.face == LEMON { -major } else { major }, -self.size);
        let radius = shifted(minor, -self.size);

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
        // Of unit size, since a tube may be so thin that the square of its radius is zero.
        let normal = Vec3::new(h * cos, y, h * sin).unit();
        let normal = if normal.any() {
            normal
        } else {
            Vec3::new(cos, R::ZERO, sin)
        };
        Located {
            point: shifted_vector(point, self.size),
            error: shifted_vector(error, self.size),
            // The solid is on the other side of the lemon's surface.
            normal: if root.face == LEMON { -normal } else { normal },
        }
    }
}

impl<R: Real> Scaled<R> {
    /// Passes on the t of all crossings, ascending, and their faces; returns whether there may be
    /// others, or fewer.
    fn crossings(&self, mut crossing: impl FnMut(R, u32)) -> bool {
        let (two, four) = (R::of(2.0), R::of(4.0));
        let (p, d) = (self.near, self.direction);
        let a = d.dot(d);
        let b = p.dot(d);
        let c = p.dot(p);

        // The bounding sphere, so much wider that whatever is rounded here (by less than γ₁₆ of
        // R + r), its ends are outside of the torus.
        let reach = (self.major + self.minor) * (R::ONE + R::gamma(16)) + four * self.error;
        let discriminant = R::difference_of_products(b, b, a, c - reach * reach);
        if discriminant.is_nan() || discriminant <= R::ZERO {
            return false;
        }
        let s = discriminant.sqrt();
        let (from, to) = ((-b - s) / a, (-b + s) / a);
        if from.is_nan() || to.is_nan() || from >= to {
            return false;
        }

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
        let flat = self.flatness(a, b, k, from.abs().max(to.abs()));

        let points = quartic.pieces(from, to);
        let points = points.as_slice();
        let (mut last, mut undecided, mut uncertain) = ((from, Side::Outside), 0, false);
        for (i, &t) in points.iter().enumerate().skip(1) {
            let side = if i + 1 == points.len() {
                Side::Outside
            } else if let Some(side) = self.side(t, flat) {
                side
            } else {
                undecided += 1;
                continue;
            };
            let crosses = side.is_inside() != last.1.is_inside();
            // Between sides that differ, one point on either is still one crossing; between equal
            // sides it may be a pair.
            uncertain |= undecided > usize::from(crosses);
            undecided = 0;
            if crosses {
                let enters = side.is_inside();
                let lemon = side == Side::Lemon || last.1 == Side::Lemon;
                let t = self.root(&quartic, (last.0, t), enters, lemon);
                crossing(t, if lemon { LEMON } else { OUTER });
            }
            last = (t, side);
        }
        uncertain
    }

    /// The point at t with its ρ, and the slopes of both.
    fn at(&self, t: R) -> (Vec3<R>, R) {
        let point = self.direction.zip(self.near, |d, o| d.mul_add(t, o));
        (point, length_near_one(point[0], point[2]))
    }

    /// g₋ or g₊ at t, and its slope.
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

    /// On which side the point at t is; `None` where rounding may have decided it.
    ///
    /// Each component of the point is off by at most ε = u|p| + the error of the line, hence ρ by
    /// √2 ε + 3uρ and h = ρ ∓ R by u|h| more; then h² + (y − r)(y + r) by 2|h|Δh + 2|y|ε and by
    /// the rounding of the terms, γ₃(h² + y² + r²). All of it twice, for the products of errors.
    fn side(&self, t: R, flat: R) -> Option<Side> {
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
        if outer.abs() <= outer_bound || inner.abs() <= inner_bound || (outer * inner).abs() <= flat
        {
            return None;
        }
        Some(match (outer > R::ZERO, inner > R::ZERO) {
            (true, _) => Side::Outside,
            (false, true) => Side::Tube,
            (false, false) => Side::Lemon,
        })
    }

    /// How far from its true extremum the quartic may be at the point taken for it.
    ///
    /// The slope there is at most its own rounding error e ≤ γ₁₆ Σ|cᵢ| i |t|ⁱ⁻¹. Where e can be
    /// reached within w of the extremum, the slope, c₄(t − t₁)(t − t₂)(t − t₃) · 4 with the others
    /// as close as they can be, is at least c₄ w³, so that the value differs by at most
    /// e w ≤ e ∛(e/c₄).
    fn flatness(&self, a: R, b: R, k: R, t: R) -> R {
        let (two, four) = (R::of(2.0), R::of(4.0));
        // (at² + 2bt + k)² with nothing cancelled bounds both squares in the sphere, up to the
        // factor that the terms with R bring.
        let square = (a * t + two * b.abs()) * t + k.abs();
        let slope = two * (a * t + b.abs());
        let e = R::gamma(16) * two * slope * (square + four * self.major.square());
        e * R::of((e / (a * a)).to_f64().cbrt())
    }

    /// The one crossing in a bracket between two sides.
    fn root(&self, quartic: &Quartic<R>, bracket: (R, R), enters: bool, lemon: bool) -> R {
        let (low, high) = bracket;
        // One end, the one inside if the line grazes the torus, is where the quartic turns: a
        // parabola with its vertex there and through the other end is close to the root.
        let (inner, outer) = if enters { (high, low) } else { (low, high) };
        let (depth, height) = (quartic.at(inner).0.abs(), quartic.at(outer).0.abs());
        let start = inner + (outer - inner) * (depth / (depth + height)).sqrt();
        // What the quartic is good for is half of the digits; two Newton steps make the rest.
        let coarse = R::ROUNDOFF.sqrt() * (high - low);
        let start = root_between(|t| quartic.at(t), bracket, !enters, start, coarse);
        // Leaving the tube into the lemon, g₊ falls.
        let (centre, rising) = if lemon {
            (-self.major, enters)
        } else {
            (self.major, !enters)
        };
        let precision = R::ROUNDOFF * low.abs().max(high.abs());
        // The least that rounding a point on the surface, where |h| and |y| are up to r, does to
        // its g: nothing is to be gained below it.
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
fn length_near_one<R: Real>(x: R, z: R) -> R {
    (x * x + z * z).sqrt()
}

/// √(x² + z²) of any numbers.
fn length<R: Real>(x: R, z: R) -> R {
    Vec3::new(x, R::ZERO, z).length()
}

/// Whether a · b + c is rounded once only. (1 + 2ε)² has a part below the last place.
fn multiply_add_rounds_once<R: Real>() -> bool {
    let x = R::ONE + R::of(8.0) * R::ROUNDOFF;
    x.mul_add(x, -(x * x)) != R::ZERO
}

#[cfg(test)]
#[path = "torus_tests.rs"]
mod tests;
