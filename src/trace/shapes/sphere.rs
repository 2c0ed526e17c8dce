//! The sphere.

use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;
use std::f64::consts::{PI, TAU};

#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    centre: Vec3,
    radius: f64,
}

impl Sphere {
    pub fn new(centre: Vec3, radius: f64) -> Sphere {
        Sphere { centre, radius }
    }
}

impl Shape for Sphere {
    fn bounds(&self) -> Bounds {
        let r = Vec3::ONE * self.radius;
        Bounds::new(self.centre - r, self.centre + r).padded()
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let p = point - self.centre;
        let v = (-p[1] / self.radius).clamp(-1.0, 1.0).acos() / PI;
        [(-p[2]).atan2(p[0]).rem_euclid(TAU) / TAU, v]
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.centre.0.into_iter().for_each(&mut *sink);
        sink(self.radius);
    }
}

impl<R: Real> Intersect<R> for Sphere {
    /// The discriminant comes from the part of the centre's offset that is perpendicular to the
    /// line, which is where the origin would be at its closest approach (Haines, Günther and
    /// Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
    /// chapter 7); the root near the origin from the product of the roots, so that it does not
    /// lose its digits to the far one.
    #[inline]
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let f = line.origin - self.centre.cast();
        let d = line.direction;
        let a = d.dot(d);
        let b = -f.dot(d);
        let perpendicular = f + d * (b / a);
        let r = R::of(self.radius);
        let discriminant = r * r - perpendicular.dot(perpendicular);
        if discriminant > R::ZERO {
            let s = (a * discriminant).sqrt();
            let q = if b < R::ZERO { b - s } else { b + s };
            let c = self.power(line.origin, f);
            let (near, far) = (c / q, q / a);
            roots.chord((near.min(far), 0), (near.max(far), 0));
        }
    }

    /// The point on the line, pushed along the radius onto the sphere: off by at most γ₅|p|
    /// whatever t was (pbrt-v4, section 6.8.4), plus the rounding of adding the centre.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let (centre, radius) = (self.centre.cast(), R::of(self.radius));
        let p = (line.origin - centre) + line.direction * root.t;
        let p = p * (radius / p.length());
        let p = if p.is_finite() {
            p
        } else {
            Vec3::new(radius, R::ZERO, R::ZERO)
        };
        let point = centre + p;
        Located {
            point,
            error: p.abs() * R::gamma(5) + point.abs() * R::ROUNDOFF,
            normal: p,
        }
    }
}

impl Sphere {
    /// |o − c|² − r², the product of the roots times |d|².
    ///
    /// Close to the surface the terms cancel and the rounding of f = o − c shows; there the sum is
    /// done in twice the working precision (Ogita, Rump and Oishi, "Accurate Sum and Dot Product",
    /// 2005, algorithm 5.3), with the part of f that the subtraction lost.
    fn power<R: Real>(&self, origin: Vec3<R>, f: Vec3<R>) -> R {
        let radius = R::of(self.radius);
        let r2 = radius * radius;
        let plain = f.dot(f) - r2;
        // Half of the digits at stake: below that the plain sum is as good as the compensated one
        // to within 2⁻¹⁰ of its own size at worst, hence better than the square root that follows.
        const CANCELLED: f64 = 1.0 / 1024.0;
        if plain.abs() > R::of(CANCELLED) * r2 {
            return plain;
        }
        let (mut sum, mut lost) = (-r2, -radius.mul_add(radius, -r2));
        for i in 0..3 {
            let square = f[i] * f[i];
            let square_error = f[i].mul_add(f[i], -square);
            // o − c = f + e exactly (Knuth's two-sum).
            let c = R::of(-self.centre[i]);
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
        sum + lost
    }
}
