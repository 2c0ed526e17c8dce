//! Proofs that a convex shape holds all of something, with room around it, which rounding cannot upset.
//!
//! The room is a small share of the thing's size and its distance from the origin. It is far more than the rounding of
//! a test of a point. The rounding of the matrices is checked against the room: a point that was moved into a shape's
//! coordinates must come back to where it was.

use super::containment::in_shape;
use super::hull::ball_hull;
use super::shapes::facts::{self, Facts};
use crate::geometry::array::length;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};

/// Clearance of what lies apart or within, as a share of its size and place: more than the rounding of any test of a
/// point, and of the matrices before it.
pub const CLEARANCE_REL: f64 = 1e-9;

/// The relative rounding of a product of a matrix row and a point, with room to spare.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The room that something in a finite box needs.
pub fn room(thing: &Aabb) -> f64 {
    CLEARANCE_REL * (thing.radius() + far(&thing.min).max(far(&thing.max)))
}

/// The largest absolute value of a point's coordinates.
pub fn far(p: &Vec3) -> f64 {
    p.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// A shape in its place, which can be asked what it holds.
pub struct PlacedShape<'a> {
    geometry: &'a Geometry,
    matrix: Matrix,
    /// The map back into the shape's coordinates.
    back: Matrix,
    bounds: Aabb,
}

impl<'a> PlacedShape<'a> {
    /// Places a shape. `None` if the matrix has no inverse.
    pub fn new(geometry: &'a Geometry, matrix: Matrix) -> Option<PlacedShape<'a>> {
        Some(PlacedShape {
            geometry,
            back: matrix.inverse()?,
            bounds: geometry.bounds(&matrix),
            matrix,
        })
    }

    /// Whether the shape is convex and holds all of a thing, with room around it. `thing` is a box around the thing;
    /// `shape` is the thing itself with its matrix, if it is one shape.
    pub fn holds(&self, thing: &Aabb, shape: Option<(&Geometry, &Matrix)>) -> bool {
        let bounded = thing.is_finite() && !thing.is_empty();
        // The bounds of a shape that holds the corners of a box hold the box.
        if !bounded || !self.geometry.is_convex() || !self.bounds.holds(thing) {
            return false;
        }
        let room = room(thing);
        let corners = thing.corners();
        if corners.iter().all(|&p| self.has(p, room)) {
            return true;
        }
        let Some((geometry, matrix)) = shape else {
            return false;
        };
        if let (Some(inner), Some(outer)) = (
            Ball::around(geometry, matrix),
            Ball::within(self.geometry, &self.matrix),
        ) {
            return outer.holds(&inner, room);
        }
        let (points, m) = match (geometry.hull(), Ball::around(geometry, matrix)) {
            (Some(points), _) => (points, *matrix),
            (None, Some(ball)) => (ball_hull(), ball.unit),
            (None, None) => return false,
        };
        (points.iter()).all(|p| self.has(m.point(*p), room + rounding(&m, p)))
    }

    /// Whether the shape holds the corners of a cube around a point.
    fn has(&self, p: Vec3, room: f64) -> bool {
        around(p, room).iter().all(|&p| {
            let local = self.back.point(p);
            in_shape(self.geometry, local) && self.comes_back(local, p, room)
        })
    }

    fn comes_back(&self, local: Vec3, p: Vec3, room: f64) -> bool {
        let again = self.matrix.point(local);
        (0..3).all(|i| (again[i] - p[i]).abs() <= room / 2.0)
    }

    /// Whether a point and the corners of a cube around it are outside of the shape.
    pub fn is_clear_of(&self, p: Vec3) -> bool {
        let room = CLEARANCE_REL * self.bounds.far().max(far(&p));
        let apart = |i| p[i] + room < self.bounds.min[i] || self.bounds.max[i] + room < p[i];
        let outside = |p: &Vec3| {
            let local = self.back.point(*p);
            !in_shape(self.geometry, local) && self.comes_back(local, *p, room)
        };
        (0..3).any(apart) || (outside(&p) && around(p, room).iter().all(outside))
    }
}

/// The corners of a cube around a point.
fn around(p: Vec3, half: f64) -> [Vec3; 8] {
    Aabb::new(p.map(|x| x - half), p.map(|x| x + half)).corners()
}

/// A bound on how far a moved point is rounded, in each coordinate.
fn rounding(m: &Matrix, p: &Vec3) -> f64 {
    let of = |r: &[f64; 4]| (0..3).map(|j| (r[j] * p[j]).abs()).sum::<f64>() + r[3].abs();
    ROUNDING * m.0[..3].iter().map(of).fold(0.0, f64::max)
}

/// A ball that may be stretched to an ellipsoid.
struct Ball {
    /// The map from the ball of radius 1 at the origin to this one.
    unit: Matrix,
    /// Distance by which rounding may have moved the ball.
    slack: f64,
}

impl Ball {
    /// A ball that holds all of a shape and is hardly larger. `None` for shapes that are no balls.
    fn around(geometry: &Geometry, m: &Matrix) -> Option<Ball> {
        let facts::Ball {
            centre,
            semi_axes: axes,
            ..
        } = geometry.ball()?;
        let place = m.point(centre);
        let mut unit = *m;
        for (row, place) in unit.0.iter_mut().zip(place) {
            (0..3).for_each(|j| row[j] *= axes[j]);
            row[3] = place;
        }
        let ends = std::array::from_fn(|j| centre[j].abs() + axes[j]);
        let slack = rounding(m, &ends);
        Some(Ball { unit, slack })
    }

    /// A ball that a shape holds, and that is hardly smaller. `None` for shapes that are no balls.
    fn within(geometry: &Geometry, m: &Matrix) -> Option<Ball> {
        let mut ball = Ball::around(geometry, m)?;
        let held = geometry.ball()?.held;
        for row in &mut ball.unit.0[..3] {
            (0..3).for_each(|j| row[j] *= held);
        }
        Some(ball)
    }

    /// Whether the ball holds another one and this much room around it.
    fn holds(&self, inner: &Ball, room: f64) -> bool {
        let Some(back) = self.unit.inverse() else {
            return false;
        };
        // The other ball in coordinates in which this one is the ball of radius 1, and the rounding on the way.
        let local = back.after(&inner.unit);
        let again = self.unit.after(&local);
        let lost = |i: usize| -> f64 {
            let off = |j: usize| (again.0[i][j] - inner.unit.0[i][j]).abs();
            (0..4).map(off).sum()
        };
        let lost = (0..3).map(lost).fold(0.0, f64::max);
        let entries = |m: &Matrix| -> [f64; 9] { std::array::from_fn(|k| m.0[k / 3][k % 3]) };
        // No length grows by more than this factor on the way into those coordinates.
        let factor = entries(&back).iter().map(|x| x * x).sum::<f64>().sqrt();
        let need = 3f64.sqrt() * (room + lost + self.slack + inner.slack) * factor;
        // The longest semi-axis: the square root of the largest eigenvalue of AᵀA, by Gershgorin.
        let product = |i: usize, j: usize| (0..3).map(|k| local.0[k][i] * local.0[k][j]).sum();
        let row = |i: usize| -> f64 { (0..3).map(|j| f64::abs(product(i, j))).sum() };
        let longest = (0..3).map(row).fold(0.0, f64::max).sqrt();
        let away = length(std::array::from_fn(|i| local.0[i][3]));
        away + longest + need < 1.0 - ROUNDING
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn held(outer: &Geometry, m: Matrix, inner: &Geometry, n: Matrix) -> bool {
        let standing = PlacedShape::new(outer, m).unwrap();
        standing.holds(&inner.bounds(&n), Some((inner, &n)))
    }

    fn sphere(centre: Vec3, radius: f64) -> Geometry {
        Geometry::Sphere { centre, radius }
    }

    #[test]
    fn balls_within_balls() {
        let one = Matrix::IDENTITY;
        let big = sphere([0.0; 3], 1.0);
        assert!(held(&big, one, &sphere([0.0; 3], 0.999), one));
        assert!(held(&big, one, &sphere([0.3, 0.3, 0.3], 0.48), one));
        assert!(!held(&big, one, &sphere([0.3, 0.3, 0.3], 0.481), one));
        // It touches from within.
        assert!(!held(&big, one, &sphere([0.5, 0.0, 0.0], 0.5), one));
        assert!(!held(&big, one, &big, one));
        // Far away, as far as the numbers go.
        let moved = Matrix::translation(1e12, 0.0, 0.0);
        assert!(!held(&big, moved, &sphere([0.0; 3], 0.999), moved));
        assert!(held(&big, moved, &sphere([0.0; 3], 1e-2), moved) == (1e12 * CLEARANCE_REL < 0.5));
    }

    #[test]
    fn where_the_numbers_are_lost_nothing_is_proved() {
        // Its own coordinates have no room for its size.
        let lost = sphere([1e15, 0.0, 0.0], 1.0);
        let back = Matrix::translation(-1e15, 0.0, 0.0);
        assert!(!held(&lost, back, &sphere([0.0; 3], 0.9), Matrix::IDENTITY));
        let square = Geometry::Box {
            min: [1e15, -1.0, -1.0],
            max: [1e15 + 2.0, 1.0, 1.0],
        };
        let small = sphere([1.0, 0.0, 0.0], 0.9);
        assert!(!held(&square, back, &small, Matrix::IDENTITY));
    }

    #[test]
    fn points_beside_shapes() {
        let turned = Matrix::rotation(45.0, 2);
        let square = Geometry::Box {
            min: [-1.0; 3],
            max: [1.0; 3],
        };
        let standing = PlacedShape::new(&square, turned).unwrap();
        // In its box, and not in it.
        assert!(standing.is_clear_of([1.2, 1.2, 0.0]));
        assert!(!standing.is_clear_of([1.3, 0.0, 0.0]) && !standing.is_clear_of([0.0; 3]));
        // On a face.
        assert!(!standing.is_clear_of([0.0, 0.0, 1.0]));
        assert!(standing.is_clear_of([0.0, 0.0, 1.0001]));
    }

    /// A shape that is held has all of its points inside, and one that is not has a point outside or close to it:
    /// random shapes in random places, against many points of the inner one.
    #[test]
    fn proofs_are_right_and_few_are_missed() {
        let mut state = 7u64;
        let mut random = move |low: f64, high: f64| {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            low + (high - low) * ((state >> 11) as f64 / (1u64 << 53) as f64)
        };
        let (mut proved, mut missed) = (0, 0);
        for _ in 0..4000 {
            let mut shape = |size: f64| {
                let mut r = |low: f64, high: f64| size * random(low, high);
                let g = match r(0.0, 5.999 / size) as u32 {
                    0 => sphere([r(-0.2, 0.2), 0.0, 0.0], r(0.5, 1.0)),
                    1 => Geometry::Ellipsoid {
                        semi_axes: [r(0.5, 1.0), r(0.5, 1.0), r(0.5, 1.0)],
                    },
                    2 => Geometry::Box {
                        min: [r(-1.0, -0.5), r(-1.0, -0.5), r(-1.0, -0.5)],
                        max: [r(0.5, 1.0), r(0.5, 1.0), r(0.5, 1.0)],
                    },
                    3 => Geometry::Cone {
                        height: r(1.0, 2.0),
                        radius: r(0.5, 1.0),
                    },
                    4 => Geometry::Revolution {
                        profile: vec![[r(0.5, 1.0), r(-1.0, -0.5)], [r(0.5, 1.0), r(0.5, 1.0)]],
                        colours: Vec::new(),
                    },
                    _ => Geometry::GeodesicSphere {
                        radius: r(0.5, 1.0),
                        splits: 2,
                    },
                };
                let m = Matrix::rotation(random(0.0, 360.0), 0)
                    .after(&Matrix::rotation(random(0.0, 360.0), 1))
                    .after(&Matrix::scaling(random(0.5, 2.0), 1.0, random(0.5, 2.0)));
                let by: Vec3 = std::array::from_fn(|_| size * random(-0.5, 0.5));
                (g, Matrix::translation(by[0], by[1], by[2]).after(&m))
            };
            let ((inner, n), (outer, m)) = (shape(0.4), shape(1.5));
            let back = m.inverse().unwrap();
            // Points of the hull reach furthest.
            let (points, to) = match inner.hull() {
                Some(points) => (points, n),
                None => (ball_hull(), Ball::around(&inner, &n).unwrap().unit),
            };
            let shrunk = |by: f64| {
                let inside = |p: &Vec3| {
                    let p = back.point(to.point(p.map(|x| x * by)));
                    in_shape(&outer, p)
                };
                points.iter().all(inside)
            };
            match held(&outer, m, &inner, n) {
                true => {
                    proved += 1;
                    assert!(shrunk(0.97), "{inner:?} {n:?} {outer:?} {m:?}");
                }
                false => missed += u32::from(shrunk(1.0)),
            }
        }
        assert!(proved > 500 && missed < proved / 3, "{proved} {missed}");
    }
}
