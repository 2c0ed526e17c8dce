//! Solids of revolution: a closed profile turned about the y axis, the cones among them.

use super::exact::{Exact, Point, along};
use super::roots::{Root, between, sorted};

/// The inside is what the closed profile surrounds by the even-odd rule.
pub struct Turned {
    segments: Vec<Segment>,
}

/// From one (x, y) to another.
struct Segment {
    from: [Exact; 2],
    to: [Exact; 2],
    /// The two, rounded.
    about: [[f64; 2]; 2],
    /// y rises by h over w.
    w: Exact,
    h: Exact,
}

impl Segment {
    fn new(from: [f64; 2], to: [f64; 2]) -> Segment {
        let (p, q) = (from.map(Exact::of), to.map(Exact::of));
        Segment {
            w: &q[0] - &p[0],
            h: &q[1] - &p[1],
            from: p,
            to: q,
            about: [from, to],
        }
    }

    /// The lower and the upper end's y.
    fn heights(&self) -> (&Exact, &Exact) {
        let (a, b) = (&self.from[1], &self.to[1]);
        if a < b { (a, b) } else { (b, a) }
    }

    /// h times the profile's x at a height.
    fn radius_times_h(&self, y: &Exact) -> Exact {
        &self.from[0] * &self.h + (y - &self.from[1]) * &self.w
    }

    /// How far (ρ, y) is from the segment.
    fn distance(&self, rho: &Exact, y: &Exact) -> f64 {
        let from = [rho - &self.from[0], y - &self.from[1]];
        let back = [rho - &self.to[0], y - &self.to[1]];
        let on = |v: &[Exact; 2]| &v[0] * &self.w + &v[1] * &self.h;
        let size = |v: &[Exact; 2]| v[0].about().hypot(v[1].about());
        if !on(&from).is_positive() {
            size(&from)
        } else if !on(&back).is_negative() {
            size(&back)
        } else {
            let across = &from[0] * &self.h - &from[1] * &self.w;
            across.about().abs() / self.w.about().hypot(self.h.about())
        }
    }

    /// The same, roughly.
    fn rough_distance(&self, rho: f64, y: f64) -> f64 {
        let [p, q] = self.about;
        let (w, h) = (q[0] - p[0], q[1] - p[1]);
        let square = w * w + h * h;
        let share = ((rho - p[0]) * w + (y - p[1]) * h) / square;
        let share = if square > 0.0 {
            share.clamp(0.0, 1.0)
        } else {
            0.0
        };
        (rho - p[0] - share * w).hypot(y - p[1] - share * h)
    }
}

impl Turned {
    pub fn new(profile: &[[f64; 2]]) -> Turned {
        let mut points = profile.to_vec();
        let (first, last) = (points[0], points[points.len() - 1]);
        if first != last {
            points.insert(0, [0.0, first[1]]);
            points.push([0.0, last[1]]);
        }
        let pairs = points.windows(2).filter(|w| w[0] != w[1]);
        Turned {
            segments: pairs.map(|w| Segment::new(w[0], w[1])).collect(),
        }
    }

    /// Whether a point is inside, and not in the surface: whether the way from it straight away
    /// from the axis meets the profile an odd number of times, be it a little higher or lower, and
    /// be it a little nearer to the axis or further away.
    pub fn holds(&self, p: &Point) -> bool {
        let (square, y) = (p[0].square() + p[2].square(), &p[1]);
        let mut odd = [false; 4];
        for s in &self.segments {
            let (low, high) = s.heights();
            if y < low || high < y || low == high {
                continue;
            }
            let beyond = s.radius_times_h(y).square().cmp(&(&square * s.h.square()));
            for (k, odd) in odd.iter_mut().enumerate() {
                let meets = if k & 1 == 0 { y < high } else { low < y };
                let further = beyond.is_gt() || k & 2 == 0 && beyond.is_eq();
                *odd ^= meets && further;
            }
        }
        odd == [true; 4]
    }

    /// The places where a line could change sides are those where it meets a segment, or that
    /// segment's line beyond its ends or the axis. Whether it does is seen from points between.
    pub fn crossings(&self, o: &Point, d: &Point) -> usize {
        let flat = |v: &Point, w: &Point| &v[0] * &w[0] + &v[2] * &w[2];
        let (a, b, c) = (flat(d, d), flat(o, d), flat(o, o));
        let mut places = Vec::new();
        for segment in &self.segments {
            let mut found = if segment.h.is_zero() {
                // y = the segment's
                let linear = d[1].shifted(-1);
                Root::quadratic(Exact::zero(), linear, &o[1] - &segment.from[1])
            } else {
                // ρ² h² = (x h)²
                let h2 = segment.h.square();
                let slope = &d[1] * &segment.w;
                let offset = segment.radius_times_h(&o[1]);
                Root::quadratic(
                    &a * &h2 - slope.square(),
                    &b * &h2 - &slope * &offset,
                    &c * &h2 - offset.square(),
                )
            };
            let (low, high) = segment.heights();
            found.retain(|root| {
                let ys = [&root.low, &root.high].map(|t| &o[1] + &d[1] * t);
                let (y0, y1) = if ys[0] < ys[1] {
                    (&ys[0], &ys[1])
                } else {
                    (&ys[1], &ys[0])
                };
                y1 >= low && y0 <= high
            });
            places.extend(found);
        }
        let places = sorted(places);
        let mut inside = false;
        let mut changes = 0;
        for pair in places.windows(2) {
            let t = between(&pair[0].high, &pair[1].low);
            let p = along(o, d, &t);
            let now = self.holds(&p);
            changes += usize::from(now != inside);
            inside = now;
        }
        changes + usize::from(inside)
    }

    pub fn distance(&self, p: &Point) -> f64 {
        /// Digits of ρ.
        const DIGITS: i64 = 256;
        /// What segments may seem further away than the nearest one, and be it, in units of the
        /// coordinates of the point and of all segments.
        const ROUGHLY: f64 = 1e-9;
        let rho = (p[0].square() + p[2].square()).root(DIGITS).0;
        let (x, y) = (rho.about(), p[1].about());
        let rough: Vec<f64> = (self.segments.iter())
            .map(|s| s.rough_distance(x, y))
            .collect();
        let nearest = rough.iter().copied().fold(f64::INFINITY, f64::min);
        let coordinates = self.segments.iter().flat_map(|s| s.about).flatten();
        let reach = coordinates.fold(x + y.abs(), |m, c| m.max(c.abs()));
        let limit = nearest + ROUGHLY * reach;
        let near = self
            .segments
            .iter()
            .zip(&rough)
            .filter(|(_, r)| **r <= limit);
        near.map(|(s, _)| s.distance(&rho, &p[1]))
            .fold(f64::INFINITY, f64::min)
    }
}
