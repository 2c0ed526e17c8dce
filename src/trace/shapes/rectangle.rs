//! The rectangle in the plane z = 0, a surface without inside.

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
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let t = -line.origin[2] / line.direction[2];
        if line.direction[2] == R::ZERO || !t.is_finite() {
            return;
        }
        let p = line.at(t);
        if (0..2).all(|i| R::of(self.min[i]) <= p[i] && p[i] <= R::of(self.max[i])) {
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
        Located {
            point,
            error,
            normal: Vec3::new(R::ZERO, R::ZERO, R::ONE),
        }
    }
}
