//! The rectangle in the plane z = 0, a surface without inside.

use super::error_bound::{is_final, least, parameter_error, share};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::trace::shapes::support::Support;

#[derive(Debug, Clone, PartialEq)]
pub struct Rectangle {
    min: [f64; 2],
    max: [f64; 2],
    /// The largest coordinate of a point of the rectangle, by size.
    reach: f64,
}

impl Rectangle {
    pub fn new(min: [f64; 2], max: [f64; 2]) -> Rectangle {
        let size = |[x, y]: [f64; 2]| x.abs().max(y.abs());
        Rectangle {
            min,
            max,
            reach: size(min).max(size(max)),
        }
    }

    /// The least and the greatest x and y.
    pub fn corners(&self) -> [[f64; 2]; 2] {
        [self.min, self.max]
    }
}

impl Shape for Rectangle {
    fn bounds(&self) -> Aabb {
        Aabb::new(
            Vec3::new(self.min[0], self.min[1], 0.0),
            Vec3::new(self.max[0], self.max[1], 0.0),
        )
        .padded()
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        each([0, 1], |i| share(point[i], self.min[i], self.max[i]))
    }

    fn support(&self, _: u32) -> Option<Support> {
        Some(Support::Level { axis: 2, at: 0.0 })
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.min.into_iter().for_each(&mut *sink);
        self.max.into_iter().for_each(&mut *sink);
    }
}

impl<R: Traced> Intersect<R> for Rectangle {
    /// The rectangle is closed: its border is part of it, so that rectangles side by side leave no
    /// gap. A line in its plane does not cross it.
    #[inline]
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let (o, d) = (line.origin[2], line.direction[2]);
        let drift = self.drift(line);
        if d == R::ZERO {
            // The line is parallel to the rectangle, or nearly so within the drift.
            roots.uncertain = drift > R::ZERO && o.abs() <= drift;
            return;
        }
        let t = -o / d;
        let ([x0, x1, ex], [y0, y1, ey]) = (
            self.clearance(line, t, drift, 0),
            self.clearance(line, t, drift, 1),
        );
        let inside = (x0 > ex) & (x1 > ex) & (y0 > ey) & (y1 > ey);
        let outside = (x0 < -ex) | (x1 < -ex) | (y0 < -ey) | (y1 < -ey);
        if !(inside | outside) || t.abs() < least() || !t.is_finite() {
            self.close_call(line, t, drift, roots);
        } else if inside {
            roots.push(t, 0);
        }
    }

    fn speed(&self, line: &Line<R>, _: Root<R>) -> Option<R> {
        Some(line.direction[2].abs())
    }

    /// The point has z = 0 exactly; x and y are computed as for the cuboid.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        let mut error = line.origin.abs() * R::gamma(4) + step.abs() * R::gamma(4);
        point[2] = R::ZERO;
        error[2] = R::ZERO;
        Located {
            point,
            error,
            normal: Vec3::new(R::ZERO, R::ZERO, R::ONE),
        }
    }
}

impl Rectangle {
    /// Bound on how far a line may be, along each axis, from the one that is meant, relative to the rectangle. Where
    /// numbers are coarser than doubles, the rectangle's corners are rounded, too.
    fn drift<R: Traced>(&self, line: &Line<R>) -> R {
        let reach = R::of(self.reach);
        line.drift(reach) + parameter_error::<R>() * reach
    }

    /// The distances from the lower and from the upper border, along axis `i`, of the crossing with the plane at t:
    /// positive on the inside. The third number is a bound on the error of both.
    ///
    /// t is rounded once, t d and the sum once more each, so that the point is off by at most
    /// γ₃|t d| + u|p|, and by a little where a product underflows. A drift of σ moves it by σ along
    /// each axis, and by σ/|d_z| in t, with two roundings for the inverse. Twice the roundings of
    /// the point's own pay for those of the bound.
    #[inline]
    fn clearance<R: Traced>(&self, line: &Line<R>, t: R, drift: R, i: usize) -> [R; 3] {
        let d = line.direction[i];
        let step = d * t;
        let p = line.origin[i] + step;
        let mut error = R::gamma(4) * step.abs() + R::gamma(2) * p.abs() + R::ROUNDOFF * least();
        if drift > R::ZERO {
            let run = (d * line.inverse[2]).abs() * (R::ONE + R::gamma(4));
            error += drift * (R::ONE + run);
        }
        [p - R::of(self.min[i]), R::of(self.max[i]) - p, error]
    }

    /// Decides about a line that crosses the plane at t, at the border or nearly so, or where t is so small that its
    /// rounding is not a share of itself. A line perpendicular to an axis, and without drift, keeps its origin's
    /// coordinate on that axis exactly.
    #[cold]
    fn close_call<R: Traced>(&self, line: &Line<R>, t: R, drift: R, roots: &mut Roots<R>) {
        let (mut meets, mut inside, mut outside) = (t.is_finite(), true, false);
        for i in 0..2 {
            let [low, high, mut error] = self.clearance(line, t, drift, i);
            if line.direction[i] == R::ZERO && drift == R::ZERO {
                error = R::ZERO;
            }
            meets &= low >= R::ZERO && high >= R::ZERO;
            inside &= low >= error && high >= error;
            outside |= low < -error || high < -error;
        }
        let sound = line.origin[2] == R::ZERO || (t.is_finite() && t.abs() >= least());
        if sound && (inside || outside) {
            meets = inside;
        } else {
            roots.uncertain = true;
            meets |= is_final::<R>() && !outside && t.is_finite();
        }
        if meets {
            roots.push(t, 0);
        }
    }
}
