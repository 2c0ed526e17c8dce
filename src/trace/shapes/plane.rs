//! The plane, a surface without inside.

use super::error_bound::{fits, is_final, parameter_error};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::Slack;
use crate::geometry::exponent::{exponent, shifted, shifted_vector};
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::trace::shapes::support::Support;
use std::cmp::Ordering;

/// The surface ax + by + cz + d = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    normal: Vec3,
    d: f64,
}

impl Plane {
    pub fn new([a, b, c, d]: [f64; 4]) -> Plane {
        Plane {
            normal: Vec3::new(a, b, c),
            d,
        }
    }

    /// a, b, c, d as written.
    pub fn abcd(&self) -> [f64; 4] {
        let [a, b, c] = self.normal.0;
        [a, b, c, self.d]
    }

    /// The normal (a, b, c), of any length.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }
}

impl Shape for Plane {
    /// A flat box where the normal is along an axis. All of space otherwise, and where the plane's position overflows.
    fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::ALL;
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let level = -self.d / self.normal[i];
            if level.is_finite() && self.normal[j] == 0.0 && self.normal[k] == 0.0 {
                (bounds.min[i], bounds.max[i]) = (level, level);
            }
        }
        bounds.padded()
    }

    /// The plane's distance from the origin, or up to √3 times as much.
    fn extent(&self) -> f64 {
        (self.d / self.normal.abs().max_component()).abs()
    }

    /// Distances from the plane's point nearest to the origin, along two directions in the plane.
    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let n = self.normal.unit();
        // Where |n·y| exceeds this, the y axis is too close to the normal to say which way is up (the language).
        const UPRIGHT: f64 = 0.999;
        let up = if n[1].abs() > UPRIGHT {
            Vec3::new(0.0, 0.0, -1.0)
        } else {
            Vec3::new(0.0, 1.0, 0.0)
        };
        let u = up.cross(n).unit();
        let v = n.cross(u);
        [point.dot(u), point.dot(v)]
    }

    fn support(&self, _: u32) -> Option<Support> {
        let [a, b, c] = self.normal.0;
        Some(Support::plane([a, b, c, self.d]))
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.normal.0.into_iter().for_each(&mut *sink);
        sink(self.d);
    }
}

/// How a line runs with respect to a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PlaneRelation<R> {
    /// The line crosses the plane at t; `outwards` if it goes to the side that the normal points to.
    Across { t: R, outwards: bool },
    /// The line is parallel to the plane: behind it (less), in it or in front; `close` if rounding may have decided
    /// which.
    Along { side: Ordering, close: bool },
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting<R> {
    pub way: PlaneRelation<R>,
    /// Whether rounding may have decided if the line crosses.
    pub uncertain: bool,
}

/// The sum n·v + c, the sum of the sizes of its terms, and whether all terms are exactly zero.
struct Sum<R> {
    value: R,
    size: R,
    zero: bool,
}

impl<R: Traced> Sum<R> {
    fn new(n: Vec3<R>, v: Vec3<R>, c: R) -> Sum<R> {
        let size = n.abs().dot(v.abs()) + c.abs();
        let no_product = |i| n[i] == R::ZERO || v[i] == R::ZERO;
        Sum {
            value: n.dot(v) + c,
            size,
            zero: size == R::ZERO && (0..3).all(no_product),
        }
    }

    /// Whether no term has overflowed or underflowed.
    fn fits(&self) -> bool {
        self.zero || fits(self.size)
    }
}

impl Plane {
    /// How a line runs with respect to the plane.
    ///
    /// For nearly all lines the slope is surely not zero, see [`judge`], and nothing overflows or underflows. The
    /// other lines take a closer look.
    #[inline]
    pub(super) fn meet<R: Traced>(&self, line: &Line<R>) -> Meeting<R> {
        let n = self.normal.cast::<R>();
        let terms = n.times(line.direction);
        let slope = terms[0] + terms[1] + terms[2];
        let terms = terms.abs();
        let size = terms[0] + terms[1] + terms[2];
        let value = n.dot(line.origin) + R::of(self.d);
        let tilt = tilt(size, n, line.slack.direction);
        let t = -(value / slope);
        if slope.abs() > tilt && fits(size) && fits(value.abs()) && t.is_finite() {
            return Meeting {
                way: PlaneRelation::Across {
                    t,
                    outwards: slope > R::ZERO,
                },
                uncertain: false,
            };
        }
        self.meet_closely(line)
    }

    #[cold]
    fn meet_closely<R: Traced>(&self, line: &Line<R>) -> Meeting<R> {
        let n = self.normal.cast();
        let slope = Sum::new(n, line.direction, R::ZERO);
        let value = Sum::new(n, line.origin, R::of(self.d));
        if slope.fits() && value.fits() && same_zeros(self.normal, n) {
            return judge(&slope, &value, n, line.slack, 0);
        }
        self.meet_extreme(line)
    }

    /// [`Plane::meet`] with the normal, the direction and the origin in units of their own, where products of the
    /// numbers given would overflow or underflow.
    #[cold]
    fn meet_extreme<R: Traced>(&self, line: &Line<R>) -> Meeting<R> {
        let largest = |v: Vec3<R>| exponent(v.abs().max_component().to_f64());
        let steep = exponent(self.normal.abs().max_component());
        let unit = largest(line.direction);
        let size = largest(line.origin).max(exponent(self.d) - steep);
        let n = shifted_vector(self.normal, -steep).cast::<R>();
        let c = R::of(shifted(self.d, -(steep + size)));
        let direction = shifted_vector(line.direction, -unit);
        let origin = shifted_vector(line.origin, -size);
        let slope = Sum::new(n, direction, R::ZERO);
        let value = Sum::new(n, origin, c);
        let slack = Slack {
            origin: shifted(line.slack.origin, -size),
            direction: shifted(line.slack.direction, -unit),
        };
        let kept = same_zeros(self.normal, n)
            && same_zeros(line.direction, direction)
            && same_zeros(line.origin, origin)
            && (c == R::ZERO) == (self.d == 0.0);
        let mut meeting = judge(&slope, &value, n, slack, size - unit);
        meeting.uncertain |= !(kept && slope.fits() && value.fits());
        meeting
    }
}

/// Whether no component that was not zero before has become zero.
fn same_zeros<R: Traced, S: Traced>(before: Vec3<R>, after: Vec3<S>) -> bool {
    (0..3).all(|i| (before[i] == R::ZERO) == (after[i] == S::ZERO))
}

/// Error bound of a slope n·d whose terms add up to `size`. The slope has three roundings, and changes by at most
/// Σ|nᵢ| times `slack`, the error of the line's direction. One rounding more pays for those of the bound. Where
/// numbers are coarser than doubles, each number of the plane is off by one rounding more.
fn tilt<R: Traced>(size: R, n: Vec3<R>, slack: R) -> R {
    let spread = n.abs().dot(Vec3::ONE) * (R::ONE + R::gamma(4));
    (R::gamma(4) + parameter_error()) * size + spread * slack
}

/// Error bound of the plane's equation at the line's origin: [`tilt`] with one rounding more.
fn offset<R: Traced>(size: R, n: Vec3<R>, slack: R) -> R {
    tilt(size, n, slack) + R::gamma(1) * size
}

/// Decides how a line runs, if the plane's equation along it is value + t·2⁻ᵏ slope. A slope that may be zero is in
/// doubt; final kinds of number take it for zero, and the line for parallel. A line is surely parallel only where all
/// terms of the slope are zero.
fn judge<R: Traced>(
    slope: &Sum<R>,
    value: &Sum<R>,
    n: Vec3<R>,
    slack: Slack<R>,
    k: i32,
) -> Meeting<R> {
    let tilt = tilt(slope.size, n, slack.direction);
    let off = offset(value.size, n, slack.origin);
    let crosses = slope.value.abs() > tilt;
    let parallel = slope.zero && tilt == R::ZERO;
    let t = shifted(-(value.value / slope.value), k);
    let drop = is_final::<R>() && !crosses;
    if slope.value != R::ZERO && t.is_finite() && !drop {
        return Meeting {
            way: PlaneRelation::Across {
                t,
                outwards: slope.value > R::ZERO,
            },
            uncertain: !crosses,
        };
    }
    let touch = if is_final::<R>() { off } else { R::ZERO };
    let side = match value.value.abs() <= touch {
        true => Ordering::Equal,
        false => value.value.partial_cmp(&R::ZERO).unwrap_or(Ordering::Equal),
    };
    Meeting {
        way: PlaneRelation::Along {
            side,
            close: value.value.abs() <= off || value.value.is_nan(),
        },
        uncertain: !parallel,
    }
}

impl<R: Traced> Intersect<R> for Plane {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let meeting = self.meet(line);
        roots.uncertain = meeting.uncertain;
        if let PlaneRelation::Across { t, .. } = meeting.way {
            roots.push(t, 0);
        }
    }

    /// The speed across the plane, with 1.75 times the normal's greatest component for its length, which is up to √3
    /// times that component.
    fn speed(&self, line: &Line<R>, _: Root<R>) -> Option<R> {
        let across = self.normal.cast::<R>().dot(line.direction).abs();
        Some(across / (R::of(1.75 * self.normal.abs().max_component())))
    }

    /// The line's point, moved along the normal onto the plane. The remaining error is the rounding of the distance
    /// moved, γ₅(Σ|nᵢ pᵢ| + |d|) / |n|² along n, and of the point itself.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        // The normal is scaled to unit size, since |n|² may overflow or underflow.
        let steep = exponent(self.normal.abs().max_component());
        let n = shifted_vector(self.normal, -steep).cast::<R>();
        let c = R::of(shifted(self.d, -steep));
        let p = line.at(root.t);
        let square = n.dot(n);
        let point = p - n * ((n.dot(p) + c) / square);
        let noise = R::gamma(5) * (n.abs().dot(p.abs()) + c.abs()) / square;
        Located {
            point,
            error: n.abs() * noise + point.abs() * R::ROUNDOFF,
            normal: n,
        }
    }
}
