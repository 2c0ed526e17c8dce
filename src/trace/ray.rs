//! Lines in an object's space, and rays with what they know about where they start.

use super::affine::Affine;
use super::number::Real;
use super::qd::Qd;
use super::shapes::support::Passage;
use super::vec::Vec3;
use super::way::Way;

/// A line o + t·d. Affine maps keep t, so all spaces share one parameter.
#[derive(Debug, Clone, Copy)]
pub struct Line<R: Real = f64> {
    pub origin: Vec3<R>,
    /// Of any length but zero.
    pub direction: Vec3<R>,
    /// 1 / direction, component by component; infinite where that is zero.
    pub inverse: Vec3<R>,
    pub slack: Slack<R>,
    pub way: R::Way,
}

/// How far a line may be from the one that is meant: what its way into this space has rounded.
/// Both bound every component.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Slack<R = f64> {
    pub origin: R,
    pub direction: R,
}

impl<R: Real> Line<R> {
    /// A line that is exactly what is meant.
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Line<R> {
        Line {
            origin,
            direction,
            inverse: direction.map(R::recip),
            slack: Slack::default(),
            way: R::Way::default(),
        }
    }

    /// Whether all of its numbers are finite and it has a direction.
    pub fn is_sound(&self) -> bool {
        self.origin.is_finite() && self.direction.is_finite() && self.direction.any()
    }

    pub fn at(&self, t: R) -> Vec3<R> {
        self.origin + self.direction * t
    }

    /// In another kind of number, rounded.
    pub fn cast<S: Real>(&self) -> Line<S> {
        Line {
            slack: Slack {
                origin: S::of_parts(self.slack.origin.parts()),
                direction: S::of_parts(self.slack.direction.parts()),
            },
            ..Line::new(self.origin.cast(), self.direction.cast())
        }
    }

    /// The line in another space, with what the map rounds.
    pub fn through(&self, map: &Affine<R>) -> Line<R> {
        if map.moves() {
            // The usual case, and the cheapest.
            let size = self.origin.abs() + map.offset.abs();
            let mut rounded = R::gamma(4) * (size[0] + size[1] + size[2]);
            if (0..3).all(|i| map.moves_exactly(i, self.origin)) {
                rounded = R::ZERO;
            }
            return Line {
                origin: self.origin + map.offset,
                slack: Slack {
                    origin: self.slack.origin + rounded,
                    direction: self.slack.direction,
                },
                way: R::Way::through(self, map),
                ..*self
            };
        }
        Line {
            slack: map.slack(self),
            way: R::Way::through(self, map),
            ..Line::new(map.point(self.origin), map.vector(self.direction))
        }
    }

    /// In quad-double, as it has come into this space.
    pub fn closer(&self) -> Line<Qd> {
        R::Way::closer(self)
    }

    /// A bound on how far, along each axis, the line is from the one that is meant, at its points
    /// whose coordinates are at most `reach` in size.
    ///
    /// Such a point is at |t| ≤ √3 (|o| + reach) / |d|, by largest components. There is no bound
    /// where a quarter of the direction is in doubt.
    pub fn drift(&self, reach: R) -> R {
        if self.slack == Slack::default() {
            return R::ZERO;
        }
        let [x, y, z] = self.origin.map(R::abs).0;
        let greater = |a: R, b: R| if a > b { a } else { b };
        let o = greater(greater(x, y), z);
        let [x, y, z] = self.inverse.map(R::abs).0;
        let lesser = |a: R, b: R| if a < b { a } else { b };
        let inverse = lesser(lesser(x, y), z);
        let bend = self.slack.direction * inverse;
        // Small before they are added up, lest the largest sizes overflow.
        let share = bend * R::of(1.75);
        let drift = self.slack.origin + share * o + share * reach;
        if bend <= R::of(0.25) && drift.is_finite() {
            drift
        } else {
            R::INFINITY
        }
    }
}

/// A line as bounding boxes see it, in doubles whatever its own numbers are: with its origin moved
/// towards the lower and the upper sides as far as it may be off near the boxes.
#[derive(Debug, Clone, Copy)]
pub struct Beam {
    pub low: Vec3,
    pub high: Vec3,
    pub inverse: Vec3,
}

impl Beam {
    /// For boxes whose coordinates are at most `reach` in size.
    pub fn new(line: &Line, reach: f64) -> Beam {
        let drift = line.drift(reach);
        if drift == 0.0 {
            return Beam::exact(line);
        }
        // The sums below are rounded, too.
        let margin = Vec3::ONE * drift + line.origin.abs() * f64::EPSILON;
        Beam {
            low: line.origin + margin,
            high: line.origin - margin,
            inverse: line.inverse,
        }
    }

    /// Of a line that is exactly what is meant.
    pub fn exact(line: &Line) -> Beam {
        Beam {
            low: line.origin,
            high: line.origin,
            inverse: line.inverse,
        }
    }
}

/// The surface a ray starts on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Left<R = f64> {
    /// Which surface: the shape's geometry and the way it is placed.
    pub surface: u64,
    /// Whether the ray goes into the surface's solid. Crossings alternate, so this and being
    /// nearest to the origin single out the root that is the starting point itself.
    pub entering: bool,
    /// Bound on the distance of the starting point from the true surface. What lies closer to the
    /// starting point than this, along its own normal, cannot be told from it and is behind it.
    pub skin: R,
    /// How it passes the surface that the face it starts on is a part of; `None` where other shapes have
    /// no faces in that.
    pub passage: Option<Passage>,
}

/// A ray: a line from t = 0 on.
#[derive(Debug, Clone, Copy)]
pub struct Ray<R: Real = f64> {
    pub line: Line<R>,
    pub left: Option<Left<R>>,
    /// Known to start outside of every solid.
    pub outside: bool,
}

impl<R: Real> Ray<R> {
    /// A ray that starts anywhere.
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Ray<R> {
        Ray {
            line: Line::new(origin, direction),
            left: None,
            outside: false,
        }
    }

    /// In another kind of number, rounded.
    pub fn cast<S: Real>(&self) -> Ray<S> {
        Ray {
            line: self.line.cast(),
            left: self.left.map(|left| Left {
                surface: left.surface,
                entering: left.entering,
                skin: S::of_parts(left.skin.parts()),
                passage: left.passage,
            }),
            outside: self.outside,
        }
    }
}
