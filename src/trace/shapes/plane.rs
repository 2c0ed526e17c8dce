//! The plane, a surface without inside.

use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;

/// ax + by + cz + d = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    normal: Vec3,
    d: f64,
}

impl Plane {
    pub fn new([a, b, c, d]: [f64; 4]) -> Plane {
        Plane {
            normal: Vec3::new(a, b, c),
            d,
        }
    }

    /// (a, b, c), of any length.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The left side of the equation.
    pub fn value<R: Real>(&self, p: Vec3<R>) -> R {
        self.normal.cast().dot(p) + R::of(self.d)
    }
}

impl Shape for Plane {
    /// Flat where the normal is along an axis; all of space otherwise.
    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EVERYTHING;
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            if self.normal[i] != 0.0 && self.normal[j] == 0.0 && self.normal[k] == 0.0 {
                bounds.min[i] = -self.d / self.normal[i];
                bounds.max[i] = bounds.min[i];
            }
        }
        bounds.padded()
    }

    /// The distance from the origin, but for a factor up to √3.
    fn extent(&self) -> f64 {
        (self.d / self.normal.abs().max_component()).abs()
    }

    /// Scene units from the point nearest the origin.
    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let n = self.normal.unit();
        // Beyond this the y axis is too close to the normal to say which way is up (the language).
        const UPRIGHT: f64 = 0.999;
        let up = if n[1].abs() > UPRIGHT {
            Vec3::new(0.0, 0.0, -1.0)
        } else {
            Vec3::new(0.0, 1.0, 0.0)
        };
        let u = up.cross(n).unit();
        let v = n.cross(u);
        [point.dot(u), point.dot(v)]
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.normal.0.into_iter().for_each(&mut *sink);
        sink(self.d);
    }
}

impl<R: Real> Intersect<R> for Plane {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let slope = self.normal.cast().dot(line.direction);
        let t = -self.value(line.origin) / slope;
        if slope != R::ZERO && t.is_finite() {
            roots.push(t, 0);
        }
    }

    /// The point on the line, moved along the normal by the distance it is found to be off. What
    /// remains is the rounding of that distance, γ₅(Σ|nᵢ pᵢ| + |d|) / |n|² along n, and of the
    /// point itself.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let n = self.normal.cast::<R>();
        let p = line.at(root.t);
        let square = n.dot(n);
        let point = p - n * (self.value(p) / square);
        let noise = R::gamma(5) * (n.abs().dot(p.abs()) + R::of(self.d.abs())) / square;
        Located {
            point,
            error: n.abs() * noise + point.abs() * R::ROUNDOFF,
            normal: n,
        }
    }
}
