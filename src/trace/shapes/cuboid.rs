//! The axis-aligned box.

use super::error_bound::{is_final, least, parameter_error, share};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::support::Support;

#[derive(Debug, Clone, PartialEq)]
pub struct Cuboid {
    min: Vec3,
    max: Vec3,
    /// The largest coordinate of a point of the box, by size.
    reach: f64,
    /// Whether the cuboid has no thickness along some axis, hence no inside.
    flat: bool,
}

impl Cuboid {
    pub fn new(min: Vec3, max: Vec3) -> Cuboid {
        Cuboid {
            min,
            max,
            reach: min.abs().max_component().max(max.abs().max_component()),
            flat: (0..3).any(|i| min[i] >= max[i]),
        }
    }

    /// The lower and the upper corner.
    pub fn corners(&self) -> [[f64; 3]; 2] {
        [self.min.0, self.max.0]
    }
}

/// Face 2i is the lower one across axis i, face 2i + 1 the upper.
impl Shape for Cuboid {
    fn outline(&self) -> Outline {
        Outline::exact(Form::Constant)
    }

    fn bounds(&self) -> Aabb {
        Aabb::new(self.min, self.max).padded()
    }

    /// Texture coordinates to the right and up as each face is seen from outside; on top and bottom u follows x.
    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let share = |i: usize| share(point[i], self.min[i], self.max[i]);
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

    fn support(&self, face: u32) -> Option<Support> {
        let end = [self.min, self.max][(face % 2) as usize];
        let axis = face as u8 / 2;
        let at = end[axis as usize];
        Some(Support::Level { axis, at })
    }

    fn holds(&self, point: Vec3) -> bool {
        solids::cuboid::Cuboid {
            min: self.min.0,
            max: self.max.0,
        }
        .holds(point.0)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.min.0.into_iter().for_each(&mut *sink);
        self.max.0.into_iter().for_each(&mut *sink);
    }
}

impl<R: Traced> Intersect<R> for Cuboid {
    /// A line in a face does not cross the box: see [`Roots::along`].
    ///
    /// Each t = (m − o)/d is rounded twice, so that near and far are off by at most γ₂ of themselves, and by the drift
    /// times 1/|d|, for the axis where that factor is greatest. If near and far are farther apart than this, their
    /// order is certain. Twice the roundings pay for the rest.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        if self.flat {
            return;
        }
        let drift = self.drift(line);
        let mut near = (-R::INFINITY, 0);
        let mut far = (R::INFINITY, 0);
        let (mut beside, mut certain) = (false, true);
        let mut within = false;
        let (min, max) = (self.min.cast::<R>(), self.max.cast::<R>());
        for i in 0..3 {
            let (o, d) = (line.origin[i], line.direction[i]);
            if d == R::ZERO {
                beside |= o < min[i] || o > max[i];
                if drift == R::ZERO && beside {
                    return;
                }
                within |= o == min[i] || o == max[i];
                certain &= drift == R::ZERO;
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
        let mut noise = R::gamma(4) * (near.0.abs() + far.0.abs()) + least();
        if drift > R::ZERO {
            let steps = line.inverse.zip(line.direction, |inverse, d| {
                if d == R::ZERO { R::ZERO } else { inverse.abs() }
            });
            noise += R::of(2.0) * drift * steps.max_component();
        }
        certain &= (far.0 - near.0).abs() > noise;
        let mut meets = far.0 > near.0 && !beside;
        if !certain {
            let (maybe, surely) = (
                self.meets(line, drift, true),
                self.meets(line, -drift, false),
            );
            roots.uncertain = maybe != surely;
            meets = surely || (meets && maybe && !is_final::<R>());
            if is_final::<R>() && maybe && !surely {
                roots.along = self.along(line, drift);
            }
        }
        if meets && within && drift == R::ZERO {
            roots.along = self.along(line, drift);
            // The faces that lie against this one are looked at only where decisions are final.
            roots.uncertain = !is_final::<R>();
            return;
        }
        if meets {
            roots.chord(near, far);
            // A chord whose ends are equal or not finite was dropped.
            roots.uncertain |= roots.list.is_empty();
        }
    }

    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        Some(line.direction[root.face as usize / 2].abs())
    }

    /// The coordinate across the face is the face's own, exactly. The others come from a t of two
    /// roundings, times d and added to o: off by at most γ₄(|o| + |t d|).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let (axis, upper) = (root.face as usize / 2, root.face % 2 == 1);
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        let mut error = line.origin.abs() * R::gamma(4) + step.abs() * R::gamma(4);
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

impl Cuboid {
    /// Bound on how far a line may be, along each axis, from the one that is meant, relative to the box. Where numbers
    /// are coarser than doubles, the box's corners are rounded, too.
    fn drift<R: Traced>(&self, line: &Line<R>) -> R {
        let reach = R::of(self.reach);
        line.drift(reach) + parameter_error::<R>() * reach
    }

    /// The normal of the face that a line lies in, within `drift`; a normal between those of both faces where it lies
    /// in two, and `None` where it lies in none.
    #[cold]
    fn along<R: Traced>(&self, line: &Line<R>, drift: R) -> Option<Vec3> {
        // Any unequal weights will do: between two faces at right angles lies no third face.
        const WEIGHTS: [f64; 3] = [1.0, 0.75, 0.5];
        let mut normal = Vec3::ZERO;
        for i in 0..3 {
            let beside = |side: f64| (line.origin[i] - R::of(side)).abs() <= drift;
            if line.direction[i].abs() <= line.slack.direction {
                let sides = [beside(self.min[i]), beside(self.max[i])];
                normal[i] = match sides {
                    [true, _] => -WEIGHTS[i],
                    [_, true] => WEIGHTS[i],
                    _ => 0.0,
                };
            }
        }
        normal.any().then_some(normal)
    }

    /// Whether the line, taken as exact, meets the box with every side moved outwards by `by`, which may be negative.
    /// Each side is moved farther, outwards or inwards, by what t is rounded: γ₂ of the distance from the origin to
    /// the side, which is γ₄ with the rounding of the sum. A true line within the drift meets the box itself if this
    /// line meets the smaller box, and misses the box if this line misses the larger one.
    #[cold]
    fn meets<R: Traced>(&self, line: &Line<R>, by: R, outwards: bool) -> bool {
        let (mut near, mut far) = (-R::INFINITY, R::INFINITY);
        for i in 0..3 {
            let (o, d) = (line.origin[i], line.direction[i]);
            let (low, high) = (R::of(self.min[i]) - o, R::of(self.max[i]) - o);
            let rounding = if outwards { R::gamma(4) } else { -R::gamma(4) };
            let low = low - (by + low.abs() * rounding);
            let high = high + (by + high.abs() * rounding);
            if !(low.is_finite() && high.is_finite()) {
                return outwards;
            }
            if d == R::ZERO {
                if low > R::ZERO || high < R::ZERO {
                    return false;
                }
                continue;
            }
            let (a, b) = if d > R::ZERO {
                (low, high)
            } else {
                (high, low)
            };
            near = near.max(a / d);
            far = far.min(b / d);
        }
        // Where t is so small that it is not rounded by a share of itself, or so large that it is
        // infinite, nothing is certain.
        let chord = far - near;
        if outwards {
            chord > -least::<R>() || chord.is_nan()
        } else {
            chord > least()
        }
    }
}
