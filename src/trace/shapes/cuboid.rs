//! The axis-aligned box.

use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;

#[derive(Debug, Clone, PartialEq)]
pub struct Cuboid {
    min: Vec3,
    max: Vec3,
}

impl Cuboid {
    pub fn new(min: Vec3, max: Vec3) -> Cuboid {
        Cuboid { min, max }
    }
}

/// Face 2i is the lower one across axis i, face 2i + 1 the upper.
impl Shape for Cuboid {
    fn bounds(&self) -> Bounds {
        Bounds::new(self.min, self.max).padded()
    }

    /// To the right and up as each face is seen from outside; on top and bottom u follows x.
    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let share = |i: usize| {
            let extent = self.max[i] - self.min[i];
            if extent > 0.0 {
                (point[i] - self.min[i]) / extent
            } else {
                0.0
            }
        };
        let (x, y, z) = (share(0), share(1), share(2));
        match face {
            0 => [z, y],
            1 => [1.0 - z, y],
            2 => [x, z],
            3 => [x, 1.0 - z],
            4 => [1.0 - x, y],
            _ => [x, y],
        }
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.min.0.into_iter().for_each(&mut *sink);
        self.max.0.into_iter().for_each(&mut *sink);
    }
}

impl<R: Real> Intersect<R> for Cuboid {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let mut near = (-R::INFINITY, 0);
        let mut far = (R::INFINITY, 0);
        let (min, max) = (self.min.cast::<R>(), self.max.cast::<R>());
        for i in 0..3 {
            let (o, d) = (line.origin[i], line.direction[i]);
            if d == R::ZERO {
                if o < min[i] || o > max[i] {
                    return;
                }
                continue;
            }
            let mut a = ((min[i] - o) / d, 2 * i as u32);
            let mut b = ((max[i] - o) / d, 2 * i as u32 + 1);
            if d < R::ZERO {
                std::mem::swap(&mut a, &mut b);
            }
            if a.0 > near.0 {
                near = a;
            }
            if b.0 < far.0 {
                far = b;
            }
        }
        roots.chord(near, far);
    }

    /// The coordinate across the face is the face's own, exactly. The others come from a t of two
    /// roundings, times d and added to o: off by at most γ₄(|o| + |t d|).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let (axis, upper) = (root.face as usize / 2, root.face % 2 == 1);
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        let mut error = (line.origin.abs() + step.abs()) * R::gamma(4);
        let (min, max) = (self.min.cast::<R>(), self.max.cast::<R>());
        for i in 0..3 {
            point[i] = point[i].max(min[i]).min(max[i]);
        }
        point[axis] = if upper { max[axis] } else { min[axis] };
        error[axis] = R::ZERO;
        let mut normal = Vec3::ZERO;
        normal[axis] = if upper { R::ONE } else { -R::ONE };
        Located {
            point,
            error,
            normal,
        }
    }
}
