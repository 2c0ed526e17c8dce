//! Cheap tests that recognise most lines that miss a shape, and many lines that go right through a solid.
//!
//! The tests compute in doubles, and leave every case to the shape that is closer than a margin. Rounding errors and
//! the error of the line itself are negligible beside the margin. So a line that is said to miss crosses nothing in
//! any precision, and the shape itself would answer this without doubt.

use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;

/// The largest error of a line's points, as a share of the shape's size, with which the tests say anything about the
/// line.
pub const LINE_REL_ERROR: f64 = 1e-9;
/// Factor by which the ball around a shape is enlarged. A slab is widened by the same share of its thickness, on each
/// side.
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

/// A line that meets the ball around a shape. Its points, relative to the ball's centre, are `point` + t·`direction`.
#[derive(Debug, Clone, Copy)]
pub struct Approach {
    /// The line's point nearest to the centre.
    pub point: Vec3,
    /// A unit vector.
    pub direction: Vec3,
    /// The range of t in which the line is in the ball and in the stretch that is asked for; t is a length here.
    pub stretch: [f64; 2],
    /// The t of the line's own origin.
    pub origin: f64,
    /// Whether the line leaves the ball in the stretch that is asked for.
    leaves: bool,
    /// Bound on the error of places along the line, a length.
    slack: f64,
}

/// The relation of a line to a ball.
#[derive(Debug, Clone, Copy)]
pub enum Ball {
    Misses,
    /// The line's numbers are too inexact, too large or too small to tell.
    Unknown,
    Meets(Approach),
}

impl Ball {
    /// How a line meets the ball of radius `radius` about `centre`, which holds a shape. Only the line from t = `from`
    /// to t = `to` counts, and a little beyond.
    #[inline(always)]
    pub fn meets(line: &Line, [from, to]: [f64; 2], centre: Vec3, radius: f64) -> Ball {
        let start = line.origin - centre;
        let (square, along) = (
            line.direction.dot(line.direction),
            start.dot(line.direction),
        );
        // The point is on the line, however the quotient is rounded.
        let point = start - line.direction * (along / square);
        let off = 8.0 * f64::EPSILON * start.abs().max_component() + line.drift(2.0 * radius);
        let reach = BALL_WIDENING * radius;
        let reach2 = reach * reach;
        // Written so that NaN is unknown.
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
    /// Tells whether the line goes through the solid, by the value in one place of a polynomial of the line's points
    /// that is negative in the solid. `at` is a t in the stretch. The line goes through if `at` is ahead of its
    /// origin, the value there is below −`margin`, and the line leaves the ball later.
    #[inline]
    pub fn through(&self, at: f64, margin: f64, value: impl FnOnce(f64) -> f64) -> Pass {
        let is_told = self.leaves && at > self.origin + self.slack && margin.is_normal();
        match is_told && value(at) < -margin {
            true => Pass::Through,
            false => Pass::Perhaps,
        }
    }

    /// The part of the stretch in which the coordinate along `axis`, from the centre, is between `low` and `high`;
    /// `None` if there is no such part. For a slab thinner than about a thousandth of the stretch it is the whole
    /// stretch.
    pub fn between(&self, axis: usize, low: f64, high: f64) -> Option<[f64; 2]> {
        let (p, d) = (self.point[axis], self.direction[axis]);
        let [from, to] = self.stretch;
        let slack = (BALL_WIDENING - 1.0) * (high - low);
        // The error of the point is not negligible beside so thin a slab.
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

/// Whether a t² + 2b t + c is found to be more than `margin` on a whole stretch: all its coefficients in Bernstein's
/// basis, on both halves of the stretch, are.
#[inline]
pub fn is_above([a, b, c]: [f64; 3], [from, to]: [f64; 2], margin: f64) -> bool {
    // The polar form: its values at pairs of ends are the coefficients in Bernstein's basis.
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

/// Like [`is_above`], for a polynomial of fourth degree. The leading coefficient comes first.
#[inline]
pub fn is_quartic_above(c: [f64; 5], [from, to]: [f64; 2], margin: f64) -> bool {
    let [c4, c3, c2, c1, c0] = c;
    let h = to - from;
    // The derivatives at `from`, divided by the factorials and in units of the stretch.
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
    // De Casteljau's algorithm at the middle gives the coefficients on both halves.
    let mut row = ends;
    let mut least = ends[0].min(ends[4]);
    for last in (1..5).rev() {
        for i in 0..last {
            row[i] = 0.5 * (row[i] + row[i + 1]);
        }
        least = least.min(row[0]).min(row[last - 1]);
    }
    // NaN fails these comparisons, but `min` drops it.
    margin.is_normal() && least > margin && row[0] > margin && ends[4] > margin
}
