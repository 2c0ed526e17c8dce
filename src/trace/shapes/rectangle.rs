//! The rectangle in the plane z = 0, a surface without inside.

use super::doubt::{is_final, least, parameter_error, within_numbers};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;

#[derive(Debug, Clone, PartialEq)]
pub struct Rectangle {
    min: [f64; 2],
    max: [f64; 2],
}

impl Rectangle {
    pub fn new(min: [f64; 2], max: [f64; 2]) -> Rectangle {
        Rectangle { min, max }
    }
}

impl Shape for Rectangle {
    fn bounds(&self) -> Bounds {
        Bounds::new(
            Vec3::new(self.min[0], self.min[1], 0.0),
            Vec3::new(self.max[0], self.max[1], 0.0),
        )
        .padded()
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        [0, 1].map(|i| {
            let extent = self.max[i] - self.min[i];
            if extent > 0.0 {
                (point[i] - self.min[i]) / extent
            } else {
                0.0
            }
        })
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.min.into_iter().for_each(&mut *sink);
        self.max.into_iter().for_each(&mut *sink);
    }
}

impl<R: Real> Intersect<R> for Rectangle {
    /// The rectangle is closed: its border is part of it, so that rectangles side by side leave no
    /// gap. A line in its plane does not cross it.
    ///
    /// t is rounded once, t d and the sum once more each, so that the point is off by at most
    /// γ₃|t d| + u|p|; by nothing along an axis that the line is across. A drift of σ moves it by σ
    /// along each axis, and by σ/|d_z| in t. Twice the roundings of the point's own pay for those of
    /// the bound.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let (o, d) = (line.origin, line.direction);
        let drift = self.drift(line);
        if d[2] == R::ZERO {
            // Parallel, and maybe not quite.
            roots.uncertain = drift > R::ZERO && o[2].abs() <= drift;
            return;
        }
        let t = -o[2] / d[2];
        let (mut inside, mut outside, mut meets) = (true, false, true);
        // More than a product loses by it.
        let underflow = R::ROUNDOFF * least();
        for i in 0..2 {
            let step = d[i] * t;
            let p = o[i] + step;
            let mut error = R::ZERO;
            if d[i] != R::ZERO {
                error = R::gamma(4) * step.abs() + R::gamma(2) * p.abs() + underflow;
            }
            if drift > R::ZERO {
                // By 1/|d_z|, two roundings more.
                let run = (d[i] * line.inverse[2]).abs() * (R::ONE + R::gamma(4));
                error += drift * (R::ONE + run);
            }
            let (min, max) = (R::of(self.min[i]), R::of(self.max[i]));
            meets &= min <= p && p <= max;
            inside &= min + error <= p && p <= max - error;
            outside |= p < min - error || p > max + error;
        }
        // A t too small to be rounded by a share of itself may hide a long way.
        let lost = o[2] != R::ZERO && t.abs() < least();
        let certain = (inside || outside) && !lost;
        roots.uncertain = !certain;
        if (meets || (!certain && !outside && is_final::<R>())) && t.is_finite() {
            roots.push(t, 0);
        }
    }

    /// z = 0 exactly; x and y as in the box.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        let mut error = (line.origin.abs() + step.abs()) * R::gamma(4);
        point[2] = R::ZERO;
        error[2] = R::ZERO;
        within_numbers(Located {
            point,
            error,
            normal: Vec3::new(R::ZERO, R::ZERO, R::ONE),
        })
    }
}

impl Rectangle {
    /// How far along each axis a line may be from the one that is meant, relative to the rectangle.
    /// Where numbers are coarser than the doubles that it is made of, its corners are off, too.
    fn drift<R: Real>(&self, line: &Line<R>) -> R {
        let size = |[x, y]: [f64; 2]| x.abs().max(y.abs());
        let reach = R::of(size(self.min).max(size(self.max)));
        line.drift(reach) + parameter_error::<R>() * reach
    }
}
