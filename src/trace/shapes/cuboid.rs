//! The axis-aligned box.

use super::{Intersect, Located, Root, Roots, Shape};
use crate::trace::bounds::Bounds;
use crate::trace::ray::Line;
use crate::trace::vec::{Vec3, gamma};

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

impl Intersect for Cuboid {
    fn crossings(&self, line: &Line, roots: &mut Roots) {
        let mut near = (f64::NEG_INFINITY, 0);
        let mut far = (f64::INFINITY, 0);
        for i in 0..3 {
            let (o, d) = (line.origin[i], line.direction[i]);
            if d == 0.0 {
                if o < self.min[i] || o > self.max[i] {
                    return;
                }
                continue;
            }
            let mut a = ((self.min[i] - o) / d, 2 * i as u32);
            let mut b = ((self.max[i] - o) / d, 2 * i as u32 + 1);
            if d < 0.0 {
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
    fn locate(&self, line: &Line, root: Root) -> Located {
        let (axis, upper) = (root.face as usize / 2, root.face % 2 == 1);
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        let mut error = (line.origin.abs() + step.abs()) * gamma(4);
        for i in 0..3 {
            point[i] = point[i].max(self.min[i]).min(self.max[i]);
        }
        point[axis] = if upper {
            self.max[axis]
        } else {
            self.min[axis]
        };
        error[axis] = 0.0;
        let mut normal = Vec3::ZERO;
        normal[axis] = if upper { 1.0 } else { -1.0 };
        Located {
            point,
            error,
            normal,
        }
    }
}
