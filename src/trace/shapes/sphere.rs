//! The sphere.

use super::error_bound::{fits, is_final, least, parameter_error};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::exponent::{exponent, shifted, shifted_vector};
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::support::Support;
use std::f64::consts::{PI, TAU};

#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    centre: Vec3,
    radius: f64,
    /// A bound on the coordinates of points within two radii of the centre.
    reach: f64,
}

impl Sphere {
    pub fn new(centre: Vec3, radius: f64) -> Sphere {
        Sphere {
            centre,
            radius,
            reach: centre.abs().max_component() + 2.0 * radius,
        }
    }

    /// The centre and the radius.
    pub fn numbers(&self) -> ([f64; 3], f64) {
        (self.centre.0, self.radius)
    }
}

impl Shape for Sphere {
    fn outline(&self) -> Outline {
        Outline::exact(Form::sphere(self.centre, self.radius))
    }

    fn bounds(&self) -> Aabb {
        let r = Vec3::ONE * self.radius;
        Aabb::new(self.centre - r, self.centre + r).padded()
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let p = point - self.centre;
        let v = libm::acos((-p[1] / self.radius).clamp(-1.0, 1.0)) / PI;
        [libm::atan2(-p[2], p[0]).rem_euclid(TAU) / TAU, v]
    }

    fn support(&self, _: u32) -> Option<Support> {
        Some(Support::Sphere {
            centre: self.centre.0,
            radius: self.radius,
        })
    }

    fn holds(&self, point: Vec3) -> bool {
        solids::sphere::Sphere {
            centre: self.centre.0,
            radius: self.radius,
        }
        .holds(point.0)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.centre.0.into_iter().for_each(&mut *sink);
        sink(self.radius);
    }
}

impl<R: Traced> Intersect<R> for Sphere {
    /// Most lines clearly pass or clearly meet the sphere: |r² − p²| > 2η(r² + p²) + 4e²/η. That exceeds the bound in
    /// [`Ball::chord`] whatever p is (2|p|₁e ≤ ηp² + 3e²/η, and the rest is below ηr² and 7e²), with
    /// e² ≤ 2(3γ₄²f² + 3.1 drift²). The other lines are close calls.
    #[inline]
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        const ETA: f64 = 1.0 / 1024.0;
        let (centre, radius) = (self.centre.cast::<R>(), R::of(self.radius));
        let drift = self.drift(line);
        let d = line.direction;
        let f = line.origin - centre;
        let a = d.dot(d);
        let b = -f.dot(d);
        let p = f + d * (b / a);
        let (p2, r2, f2) = (p.dot(p), radius * radius, f.dot(f));
        let discriminant = r2 - p2;
        let e2 = R::of(6.0) * R::gamma(4).square() * f2 + R::of(6.5) * drift * drift;
        let coarse = R::of(2.0 * ETA) * (r2 + p2) + R::of(4.0 / ETA) * e2;
        if discriminant.abs() > coarse && fits(a) && fits(r2) && f2 <= least::<R>().recip() {
            if discriminant > R::ZERO {
                let ball = Ball {
                    centre,
                    radius,
                    drift,
                };
                let (near, far) = ball.ends(line.origin, f, (a, b), discriminant);
                roots.chord((near, 0), (far, 0));
                roots.uncertain = roots.list.is_empty();
            }
        } else {
            self.close_call(line, drift, roots);
        }
    }

    fn speed(&self, _: &Line<R>, _: Root<R>) -> Option<R> {
        None
    }

    /// The line's point, pushed along the radius onto the sphere: off by at most γ₅|p| whatever t was (pbrt-v4,
    /// section 6.8.4), plus the rounding of adding the centre.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let (centre, radius) = (self.centre.cast(), R::of(self.radius));
        let from = (line.origin - centre) + line.direction * root.t;
        // Scaled to unit size first, so that a point that rounding has put close to the centre does not overflow.
        let normal = if from.is_finite() && from.any() {
            from / from.abs().max_component()
        } else {
            Vec3::new(R::ONE, R::ZERO, R::ZERO)
        };
        let p = normal * (radius / normal.dot(normal).sqrt());
        let point = centre + p;
        Located {
            point,
            error: p.abs() * R::gamma(5) + point.abs() * R::ROUNDOFF,
            normal,
        }
    }
}

impl Sphere {
    /// Bound on how far a line may be, along each axis near the sphere, from the one that is meant. Where numbers are
    /// coarser than doubles, the centre is rounded, too.
    fn drift<R: Traced>(&self, line: &Line<R>) -> R {
        let reach = R::of(self.reach);
        line.drift(reach) + parameter_error::<R>() * reach
    }

    /// Decides about a line close to the sphere's rim, or about numbers whose squares overflow or underflow. The
    /// latter are computed in units of the largest length.
    #[cold]
    fn close_call<R: Traced>(&self, line: &Line<R>, drift: R, roots: &mut Roots<R>) {
        let ball = Ball {
            centre: self.centre.cast(),
            radius: R::of(self.radius),
            drift,
        };
        if let Some(chord) = ball.chord(line.origin, line.direction)
            && chord.fits
        {
            return chord.append(roots, 0);
        }
        let largest = |v: Vec3<R>| exponent(v.abs().max_component().to_f64());
        let size = largest(line.origin)
            .max(exponent(self.centre.abs().max_component()))
            .max(exponent(self.radius));
        let unit = largest(line.direction);
        let ball = Ball {
            centre: shifted_vector(self.centre, -size).cast(),
            radius: R::of(shifted(self.radius, -size)),
            drift: shifted(drift, -size),
        };
        let direction = shifted_vector(line.direction, -unit);
        match ball.chord(shifted_vector(line.origin, -size), direction) {
            Some(chord) => chord.append(roots, size - unit),
            None => roots.uncertain = true,
        }
    }
}

/// A sphere, and `drift`: how far, along each axis, lines near the sphere may be from the ones that are meant.
struct Ball<R> {
    centre: Vec3<R>,
    radius: R,
    drift: R,
}

/// The stretch of a line in a ball.
struct Chord<R> {
    /// Whether no square that the chord comes from can have overflowed or underflowed.
    fits: bool,
    /// Whether rounding may have decided if there is a chord.
    uncertain: bool,
    ends: Option<(R, R)>,
}

impl<R: Traced> Chord<R> {
    /// Appends the ends, times 2ᵏ, to the crossings.
    fn append(self, roots: &mut Roots<R>, k: i32) {
        roots.uncertain = self.uncertain;
        if let Some((near, far)) = self.ends {
            roots.chord((shifted(near, k), 0), (shifted(far, k), 0));
            // A chord whose ends are equal or not finite was dropped.
            roots.uncertain |= roots.list.is_empty();
        }
    }
}

impl<R: Traced> Ball<R> {
    /// The chord of a line in the sphere; `None` where numbers overflow. The discriminant comes from the part of the
    /// centre's offset that is perpendicular to the line, which is where the origin would be at its closest approach
    /// (Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
    /// chapter 7). The root near the origin comes from the product of the roots, so that it does not lose its digits
    /// to the far one.
    ///
    /// The error bound, with f = o − c and p = f + k d, k = −f·d/|d|²: f, k d and p are rounded once each and none is
    /// longer than f, so that p is off by at most e = γ₄|f|, plus the drift, √3 of it by length. p is also off along
    /// the line by the rounding of k, less than γ₁₀|f|; that error is perpendicular to p and adds its square to p²
    /// only. So the discriminant r² − p² is off by at most
    ///
    /// ```text
    /// 2(|p| + e)e + e² + (γ₁₀|f|)² + γ₄ p² + γ₂ r²
    /// ```
    ///
    /// with γ₃ of p² from its own operations and the rest from the subtraction. Sums of sizes of components stand for
    /// lengths, which they exceed. Where numbers are coarser than the double that r is, the bound is 2u r² more. The
    /// bound holds unless both squares are so small that what they lose by underflow counts.
    fn chord(&self, origin: Vec3<R>, d: Vec3<R>) -> Option<Chord<R>> {
        let two = R::of(2.0);
        let f = origin - self.centre;
        let a = d.dot(d);
        let b = -f.dot(d);
        let perpendicular = f + d * (b / a);
        let (square, r2) = (perpendicular.dot(perpendicular), self.radius * self.radius);
        let discriminant = r2 - square;

        let reach = f.abs().dot(Vec3::ONE);
        let along = R::gamma(10) * reach;
        let e = R::gamma(4) * reach + R::of(1.75) * self.drift;
        let own = R::gamma(4) * square + (R::gamma(2) + two * parameter_error()) * r2;
        let off = two * perpendicular.abs().dot(Vec3::ONE) + R::of(3.0) * e;
        let bound = off * e + along * along + own;
        if !(bound.is_finite() && discriminant.is_finite()) {
            return None;
        }

        let touch = if is_final::<R>() { bound } else { R::ZERO };
        let ends = (discriminant > touch).then(|| self.ends(origin, f, (a, b), discriminant));
        Some(Chord {
            fits: fits(a) && fits(r2) && reach <= least::<R>().recip(),
            uncertain: discriminant.abs() <= bound || square.max(r2) < least(),
            ends,
        })
    }

    /// The ends of the chord, from |d|² = a, −f·d = b and the discriminant.
    #[inline]
    fn ends(&self, origin: Vec3<R>, f: Vec3<R>, (a, b): (R, R), discriminant: R) -> (R, R) {
        let s = (a * discriminant).sqrt();
        let q = if b < R::ZERO { b - s } else { b + s };
        let (c, close) = self.power(origin, f);
        let (mut near, far) = (c / q, q / a);
        if close {
            // t is small, and c is more exact than the discriminant. In a t² − 2bt + c the error of b is now the
            // greatest, with a weight of t, and a step of Newton's method corrects the root.
            let two = R::of(2.0);
            let step = (c - near * (two * b - a * near)) / (two * (a * near - b));
            if step.is_finite() {
                near -= step;
            }
        }
        (near.min(far), near.max(far))
    }

    /// The power of the origin, |o − c|² − r², which is the product of the roots times |d|². The flag is true if the
    /// origin is so close to the sphere that the power is far less than either square.
    ///
    /// Close to the surface the terms cancel and the rounding of f = o − c shows; there the sum is
    /// done in twice the working precision (Ogita, Rump and Oishi, "Accurate Sum and Dot Product",
    /// 2005, algorithm 5.3), with the part of f that the subtraction lost.
    fn power(&self, origin: Vec3<R>, f: Vec3<R>) -> (R, bool) {
        let radius = self.radius;
        let r2 = radius * radius;
        let plain = f.dot(f) - r2;
        // Half of the digits at stake: below that the plain sum is as good as the compensated one
        // to within 2⁻¹⁰ of its own size at worst, hence better than the square root that follows.
        const CANCELLED: f64 = 1.0 / 1024.0;
        if plain.abs() > R::of(CANCELLED) * r2 {
            return (plain, false);
        }
        let (mut sum, mut lost) = (-r2, -radius.mul_add(radius, -r2));
        for i in 0..3 {
            let square = f[i] * f[i];
            let square_error = f[i].mul_add(f[i], -square);
            // o − c = f + e exactly (Knuth's two-sum).
            let c = -self.centre[i];
            let back = f[i] - origin[i];
            let e = (origin[i] - (f[i] - back)) + (c - back);
            let next = sum + square;
            let carried = next - sum;
            lost += (sum - (next - carried))
                + (square - carried)
                + square_error
                + R::of(2.0) * f[i] * e;
            sum = next;
        }
        (sum + lost, true)
    }
}
