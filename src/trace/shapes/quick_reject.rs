//! Cheap tests that find most lines which miss a shape, and no others; and many that go right through a solid.
//!
//! They compute in doubles, and leave to the shape whatever is closer than a margin beside which all roundings, and
//! what a line may be off by, are nothing: a line that is said to miss crosses nothing in any precision, and nobody
//! who asks the shape would be in doubt about that.

use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;

/// Largest error of a line's points, as a share of a shape's size, with which anything is said about the line.
pub const LINE_REL_ERROR: f64 = 1e-9;
/// Factor by which a ball around a shape is wider, and a slab too.
const BALL_WIDENING: f64 = 1.0 + 1.0 / 1024.0;
/// Values of polynomials that are nearer to zero than this count as zero. The polynomials are of first to fourth degree
/// in a line's points, in units of the shape's size. Their errors are less than a fiftieth of this.
pub const POLYNOMIAL_MARGIN: f64 = 1e-6;

/// How a line passes a shape, as far as a cheap test can tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// The line surely crosses nothing in the stretch that is asked for.
    Beside,
    /// The shape itself has to answer.
    Perhaps,
    /// The line surely is inside of the solid in the stretch, ahead of its origin, and later surely outside.
    Through,
}

/// A line in a ball around a shape: its points are `point` + t·`direction`.
#[derive(Debug, Clone, Copy)]
pub struct Approach {
    /// The point of the line that is nearest to the centre, from the centre.
    pub point: Vec3,
    /// A unit vector.
    pub direction: Vec3,
    /// The range of t in which the line is in the ball and in the stretch that is asked for.
    pub stretch: [f64; 2],
    /// The parameter of the line's origin.
    pub origin: f64,
    /// Whether the line leaves the ball in the stretch that is asked for.
    leaves: bool,
    /// Places on the line are known to this length.
    slack: f64,
}

/// The relation of a line to a ball.
#[derive(Debug, Clone, Copy)]
pub enum Ball {
    Misses,
    /// The line's numbers do not tell.
    Unknown,
    Meets(Approach),
}

impl Ball {
    /// The ball around a shape that is in `radius` of `centre`, and the line for t from `from` to `to`, or a little
    /// more.
    #[inline(always)]
    pub fn meets(line: &Line, [from, to]: [f64; 2], centre: Vec3, radius: f64) -> Ball {
        let start = line.origin - centre;
        let (square, along) = (
            line.direction.dot(line.direction),
            start.dot(line.direction),
        );
        // On the line whatever the quotient is.
        let point = start - line.direction * (along / square);
        let off = 8.0 * f64::EPSILON * start.abs().max_component() + line.drift(2.0 * radius);
        let reach = BALL_WIDENING * radius;
        let reach2 = reach * reach;
        // Written so that what is no number is unknown.
        if !(off <= LINE_REL_ERROR * radius
            && square.is_normal()
            && reach2.is_normal()
            && along.is_finite())
        {
            return Ball::Unknown;
        }
        let half = reach2 - point.dot(point);
        if half < 0.0 {
            return Ball::Misses;
        }
        let length = square.sqrt();
        let (direction, origin) = (line.direction * length.recip(), along / length);
        let (half, slack) = (half.sqrt(), POLYNOMIAL_MARGIN * radius);
        let from = (origin + from * length - slack).max(-half);
        let end = origin + to * length;
        let to = (end + slack).min(half);
        if from > to {
            return Ball::Misses;
        }
        Ball::Meets(Approach {
            point,
            direction,
            stretch: [from, to],
            origin,
            leaves: end - slack > half,
            slack,
        })
    }
}

impl Approach {
    /// Whether the line goes through: where a polynomial of the line's points, which is negative in the solid, is
    /// negative by its value in one place, on the stretch.
    #[inline]
    pub fn through(&self, at: f64, margin: f64, value: impl FnOnce(f64) -> f64) -> Pass {
        let is_told = self.leaves && at > self.origin + self.slack && margin.is_normal();
        match is_told && value(at) < -margin {
            true => Pass::Through,
            false => Pass::Perhaps,
        }
    }

    /// The part of the stretch in which a coordinate is between two numbers; `None` where there is none. They are at
    /// least a thousandth of the ball's radius apart, or all of the stretch is.
    pub fn between(&self, axis: usize, low: f64, high: f64) -> Option<[f64; 2]> {
        let (p, d) = (self.point[axis], self.direction[axis]);
        let [from, to] = self.stretch;
        let slack = (BALL_WIDENING - 1.0) * (high - low);
        // What the point is off by counts beside so thin a slab.
        if slack < POLYNOMIAL_MARGIN * (to - from) {
            return Some(self.stretch);
        }
        let (low, high) = (low - slack - p, high + slack - p);
        if d == 0.0 {
            return (low <= 0.0 && 0.0 <= high).then_some(self.stretch);
        }
        let (a, b) = (low / d, high / d);
        let (from, to) = (a.min(b).max(from), a.max(b).min(to));
        (from <= to).then_some([from, to])
    }
}

/// Whether a t² + 2b t + c is more than a margin on a stretch: so are the coefficients of Bernstein's polynomials on
/// both halves of it.
#[inline]
pub fn is_above([a, b, c]: [f64; 3], [from, to]: [f64; 2], margin: f64) -> bool {
    // The polar form, whose values at the ends and between are the coefficients.
    let polar = |s: f64, t: f64| a * s * t + b * (s + t) + c;
    let middle = 0.5 * (from + to);
    let all = [
        polar(from, from),
        polar(from, middle),
        polar(middle, middle),
        polar(middle, to),
        polar(to, to),
    ];
    margin.is_normal() && all.iter().all(|&x| x > margin)
}

/// The same of a polynomial of fourth degree, the leading coefficient first.
#[inline]
pub fn is_quartic_above(c: [f64; 5], [from, to]: [f64; 2], margin: f64) -> bool {
    let [c4, c3, c2, c1, c0] = c;
    let h = to - from;
    // Its derivatives at `from`, over the factorials and in units of the stretch.
    let d0 = (((c4 * from + c3) * from + c2) * from + c1) * from + c0;
    let d1 = (((4.0 * c4 * from + 3.0 * c3) * from + 2.0 * c2) * from + c1) * h;
    let d2 = ((6.0 * c4 * from + 3.0 * c3) * from + c2) * (h * h);
    let d3 = (4.0 * c4 * from + c3) * (h * h * h);
    let d4 = c4 * (h * h) * (h * h);
    let ends = [
        d0,
        d0 + d1 / 4.0,
        d0 + d1 / 2.0 + d2 / 6.0,
        d0 + 0.75 * d1 + d2 / 2.0 + d3 / 4.0,
        d0 + d1 + d2 + d3 + d4,
    ];
    // De Casteljau, at the middle.
    let mut row = ends;
    let mut least = ends[0].min(ends[4]);
    for last in (1..5).rev() {
        for i in 0..last {
            row[i] = 0.5 * (row[i] + row[i + 1]);
        }
        least = least.min(row[0]).min(row[last - 1]);
    }
    // What is no number loses here, but not in `min`.
    margin.is_normal() && least > margin && row[0] > margin && ends[4] > margin
}
