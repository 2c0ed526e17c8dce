//! The plane, and the half-space below one.

use super::facts::*;
use super::lengthen::Cut;
use super::lengthen::{HAIR, outward};
use super::sizes::Sizes;
use crate::geometry::array::{across, length, unit};
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

pub struct HalfSpace {
    pub abcd: [f64; 4],
    /// Whether it has an inside.
    pub solid: bool,
}

impl HalfSpace {
    fn normal(&self) -> Vec3 {
        let [a, b, c, _] = self.abcd;
        [a, b, c]
    }

    /// ax + by + cz + d.
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        (0..3).fold(N::of(self.abcd[3]), |sum, i| {
            sum + N::of(self.abcd[i]) * N::of(p[i])
        })
    }

    /// It bounds a coordinate only where it is at right angles to that axis.
    fn local_bounds(&self) -> Aabb {
        let mut all = Aabb::ALL;
        let p = &self.abcd;
        for i in 0..3 {
            if p[i] != 0.0 && (0..3).all(|j| j == i || p[j] == 0.0) {
                let at = -p[3] / p[i];
                if !self.solid || p[i] > 0.0 {
                    all.max[i] = at;
                }
                if !self.solid || p[i] < 0.0 {
                    all.min[i] = at;
                }
                return all.padded_by([at.abs(); 3]);
            }
        }
        all
    }
}

impl Facts for HalfSpace {
    fn character(&self) -> Character {
        Character {
            is_round: false,
            is_flat: !self.solid,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        self.solid
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        self.local_bounds().transformed(m)
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, _: &Matrix, _: Vec3) -> Option<f64> {
        None
    }

    fn support(&self, _: Vec3) -> Option<Support> {
        None
    }

    fn home(&self) -> (Vec3, f64) {
        let [a, b, c, d] = self.abcd;
        if !self.solid {
            return ([0.0; 3], 1.0);
        }
        let square = a * a + b * b + c * c;
        let foot = [a, b, c].map(|x| -d * x / square);
        (foot, 1.0f64.max(length(foot)))
    }

    fn place(&self) -> Option<Vec3> {
        None
    }

    fn sizes(&self, _: &mut Sizes) {}

    fn holds(&self, p: Vec3) -> bool {
        self.solid && at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let [x, y, z] = p;
        let [a, b, c, d] = self.abcd;
        match self.solid {
            true => Taylor::flat(a * x + b * y + c * z + d, [a, b, c]),
            false => Taylor::nowhere(),
        }
    }

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        let Some(n) = unit(self.normal()).filter(|_| self.solid) else {
            return;
        };
        let point = n.map(|x| -x * (self.abcd[3] / length(self.normal())));
        // Any two directions in the plane.
        out.endless(Part::All, point, across(n).into(), n);
    }

    fn quadric(&self, _: Part) -> Option<Form> {
        None
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        Vec::new()
    }

    fn plane(&self) -> Option<[f64; 4]> {
        Some(self.abcd)
    }

    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        let surface = HalfSpace {
            solid: false,
            ..*self
        };
        vec![FlatFace {
            n: self.normal(),
            d: self.abcd[3],
            around: surface.bounds(m),
        }]
    }

    fn ends(&self, _: usize) -> Vec<f64> {
        Vec::new()
    }

    fn degenerate(&self) -> Option<Degenerate> {
        None
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        let [a, b, c, d] = self.abcd;
        let moved = [a, b, c, d - by * a.hypot(b).hypot(c)];
        self.solid.then_some(Geometry::HalfSpace(moved))
    }

    fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        let [a, b, c, d] = self.abcd;
        let n = self.normal();
        let mut along = (0..3).filter(|i| n[*i] != 0.0);
        let (true, Some(i), None) = (self.solid, along.next(), along.next()) else {
            return None;
        };
        let cut = &longer.around;
        let at = -d / n[i];
        let size = longer.size(i);
        let hair = HAIR * size.max(at.abs());
        let step = (size.max(1.0) / 2.0).min(longer.most);
        let at = at + outward(at, (cut.min[i], cut.max[i]), hair, step)?;
        Some(Geometry::HalfSpace([a, b, c, -at * n[i]]))
    }

    fn written(&self, _: Part) -> Written {
        match self.solid {
            true => Written::at(0, 4, "boundary"),
            false => Written::ALL,
        }
    }

    fn moved_out(&self, part: Part, _: f64, room: f64) -> Option<Vec<Moved>> {
        let hair = room * length(self.normal());
        let moves = self.solid && part == Part::All;
        moves.then(|| vec![(3, self.abcd[3] - hair, hair)])
    }
}
