//! Lines, and what they keep of their history.
//!
//! A map into the space of an object rounds a line. What the shape there cannot decide in double-double is decided in
//! quad-double, which is of no use if the map has rounded the further digits away. So a line in double-double keeps the
//! line before the last map, and goes through that map again when more digits are needed.

use super::affine::{Affine, Slack};
use super::dd::Dd;
use super::number::Real;
use super::qd::Qd;
use super::vec::Vec3;
use std::borrow::Cow;
use std::fmt::Debug;

/// A line o + t·d. Affine maps keep t, so all spaces share one parameter.
#[derive(Debug, Clone, Copy)]
pub struct Line<R: Traced = f64> {
    pub origin: Vec3<R>,
    /// A vector of any length but zero.
    pub direction: Vec3<R>,
    /// 1 / direction, component by component; infinite where the direction's component is zero.
    pub inverse: Vec3<R>,
    pub slack: Slack<R>,
    history: R::History,
}

/// A number that lines are traced in.
pub trait Traced: Real {
    /// The record that a line keeps of the space from which it comes.
    type History: Copy + Debug + Default + Send + Sync;

    /// The history of the image of a line under a map.
    fn remember(line: &Line<Self>, map: &Affine<Self>) -> Self::History;

    /// The line in quad-double, in the space where it is, with as many digits as its history allows.
    fn closer(line: &Line<Self>) -> Line<Qd>;

    /// The image of a line under a map. Its slack includes what the map rounds.
    fn image(line: &Line<Self>, map: &Affine<Self>) -> Line<Self> {
        Line {
            slack: map.slack(line.origin, line.direction, line.slack),
            history: Self::remember(line, map),
            ..Line::new(map.point(line.origin), map.vector(line.direction))
        }
    }

    /// The line in doubles, in which bounds are tested at every precision. Its slack includes the digits that are lost.
    fn coarse(line: &Line<Self>) -> Cow<'_, Line> {
        let mut coarse: Line = line.cast();
        let lost = |exact: Vec3<Self>, rounded: Vec3| {
            let off = (exact - rounded.cast()).abs().max_component();
            off.to_f64() * 2.0
        };
        coarse.slack.origin += lost(line.origin, coarse.origin);
        coarse.slack.direction += lost(line.direction, coarse.direction);
        Cow::Owned(coarse)
    }
}

/// Implements [`Traced`] for numbers whose lines keep no history: the digits that maps round away are lost.
macro_rules! without_history {
    ($($number:ty $(as $same:ty)?),+) => {$(
        impl Traced for $number {
            type History = ();

            #[inline]
            fn remember(_: &Line<$number>, _: &Affine<$number>) {}

            fn closer(line: &Line<$number>) -> Line<Qd> {
                line.cast()
            }

            $(
                fn image(line: &Line<$same>, map: &Affine<$same>) -> Line<$same> {
                    let (slack, origin, direction, inverse) = map.image(line.origin, line.direction, line.slack);
                    Line { origin, direction, inverse, slack, history: () }
                }

                #[inline(always)]
                fn coarse(line: &Line<$same>) -> Cow<'_, Line> {
                    Cow::Borrowed(line)
                }
            )?
        }
    )+};
}

without_history!(f32, f64 as f64, Qd);

/// The line before the last map, and the map.
#[derive(Debug, Clone, Copy)]
pub struct Before {
    origin: Vec3<Dd>,
    direction: Vec3<Dd>,
    slack: Slack<Dd>,
    map: Affine<Dd>,
}

impl Traced for Dd {
    type History = Option<Before>;

    fn remember(line: &Line<Dd>, map: &Affine<Dd>) -> Option<Before> {
        Some(Before {
            origin: line.origin,
            direction: line.direction,
            slack: line.slack,
            map: *map,
        })
    }

    /// The line in quad-double, taken through the last map anew. The roundings of earlier maps stay in the slack.
    fn closer(line: &Line<Dd>) -> Line<Qd> {
        let Some(before) = line.history.filter(|_| line.slack != Slack::default()) else {
            return line.cast();
        };
        let mut from: Line<Dd> = Line::new(before.origin, before.direction);
        from.slack = before.slack;
        let mut line = from.cast::<Qd>().through(&before.map.cast());
        // The map's bounds hold for products that do not underflow. Those that do lose some tens of the least double;
        // the number added here is 2⁵² times the least double.
        let lost = Qd::of(f64::MIN_POSITIVE);
        line.slack.origin += lost;
        line.slack.direction += lost;
        line
    }
}

impl<R: Traced> Line<R> {
    /// A line without slack: it is exactly the one that is meant.
    #[inline]
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Line<R> {
        Line {
            origin,
            direction,
            inverse: direction.map(R::recip),
            slack: Slack::default(),
            history: R::History::default(),
        }
    }

    /// A line that may be off by some slack.
    #[inline]
    pub fn within(slack: Slack<R>, origin: Vec3<R>, direction: Vec3<R>) -> Line<R> {
        let mut line = Line::new(origin, direction);
        line.slack = slack;
        line
    }

    /// Whether all numbers of the line are finite and its direction is not zero.
    #[inline]
    pub fn is_sound(&self) -> bool {
        self.origin.is_finite() && self.direction.is_finite() && self.direction.any()
    }

    #[inline]
    pub fn at(&self, t: R) -> Vec3<R> {
        self.origin + self.direction * t
    }

    /// The line in another kind of number, rounded.
    pub fn cast<S: Traced>(&self) -> Line<S> {
        Line {
            slack: Slack {
                origin: S::of_parts(self.slack.origin.parts()),
                direction: S::of_parts(self.slack.direction.parts()),
            },
            ..Line::new(self.origin.cast(), self.direction.cast())
        }
    }

    /// The image of the line in another space. Its slack includes what the map rounds.
    #[inline]
    pub fn through(&self, map: &Affine<R>) -> Line<R> {
        if map.moves() {
            // A map that only moves is the usual case, and the cheapest.
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
                history: R::remember(self, map),
                ..*self
            };
        }
        R::image(self, map)
    }

    /// The line in quad-double, in this space, with as many digits as its history allows.
    pub fn closer(&self) -> Line<Qd> {
        R::closer(self)
    }

    /// Whether the maps into this space may have moved the point of the line at `t` by more than `roundoffs` unit
    /// roundoffs of the distance of the point, or of the line's origin if that is larger, from the origin of this
    /// space.
    #[inline]
    pub fn is_blurred_at(&self, t: R, roundoffs: f64) -> bool {
        if self.slack.direction == R::ZERO {
            return false;
        }
        let (drift, unit) = (
            self.slack.direction * t.abs(),
            R::of(roundoffs) * R::ROUNDOFF,
        );
        // On most lines the origin is farther away than the point, and it is tested more quickly.
        let reaches = |p: Vec3<R>| (0..3).any(|i| drift <= unit * p[i].abs());
        !reaches(self.origin) && !reaches(self.at(t))
    }

    /// A bound on how far, along each axis, the line is from the one that is meant, at those of its points whose
    /// coordinates are at most `reach` in absolute value. Infinite if there is no bound.
    ///
    /// Such a point is at |t| ≤ √3 (|o| + reach) / |d|, by largest components. There is no bound where the slack of the
    /// direction is more than a quarter of its largest component.
    #[inline]
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
        // The factor is applied before the sum, lest the largest sizes overflow.
        let share = bend * R::of(1.75);
        let drift = self.slack.origin + share * o + share * reach;
        if bend <= R::of(0.25) && drift.is_finite() {
            drift
        } else {
            R::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    const U: f64 = f64::EPSILON / 2.0;

    /// Numbers of all sizes that a vector may have side by side.
    fn vector(least: i32) -> impl Strategy<Value = Vec3<Dd>> {
        let number = (-1.0..1.0f64, 0..60i32, -0.5..0.5f64, 0..3u8);
        let numbers = [number.clone(), number.clone(), number];
        (numbers, least..100i32).prop_map(|(numbers, top)| {
            Vec3(numbers.map(|(x, below, low, kind)| {
                let high = x * 2f64.powi(top) * 0.5f64.powi(below);
                match kind {
                    0 => Dd::of(high),
                    1 => Dd::sum(high, high * low * U),
                    _ => Dd::of(high) * Dd::of(low),
                }
            }))
        })
    }

    /// A number in double-double or quad-double, exactly.
    fn exact<R: Real>(x: R) -> RBig {
        let (high, low) = x.parts();
        let part = |x: f64| RBig::try_from(x).unwrap();
        if (high, low) == (0.0, 0.0) {
            return RBig::ZERO;
        }
        part(high) + part(low) + exact(x - R::of_parts((high, low)))
    }

    fn image(map: &Affine<Dd>, v: Vec3<Dd>, moves: bool) -> [RBig; 3] {
        [0, 1, 2].map(|i| {
            let terms = (0..3).map(|j| exact(map.rows[i][j]) * exact(v[j]));
            let offset = if moves {
                exact(map.offset[i])
            } else {
                RBig::ZERO
            };
            terms.fold(offset, |sum, x| sum + x)
        })
    }

    /// Whether two vectors are no farther apart than this in any component.
    fn within(got: Vec3<Qd>, meant: &[RBig; 3], slack: Qd) -> bool {
        let slack = exact(slack);
        let off = |i: usize| exact(got[i]) - &meant[i];
        (0..3).all(|i| off(i) <= slack && -off(i) <= slack)
    }

    proptest! {
        /// The exact image by the map is within the slack, down to where products underflow; and the
        /// slack is of quad-double rounding.
        #[test]
        fn images_are_exact_but_for_the_slack(
            rows in [vector(-60), vector(-60), vector(-60)],
            offset in vector(-900),
            origin in vector(-900),
            direction in vector(-900),
        ) {
            let map = Affine::of(rows, offset);
            let line = Line::new(origin, direction).through(&map);
            prop_assume!(line.slack.origin > Dd::ZERO);
            let closer = line.closer();
            prop_assert!(within(closer.origin, &image(&map, origin, true), closer.slack.origin));
            let meant = image(&map, direction, false);
            prop_assert!(within(closer.direction, &meant, closer.slack.direction));

            let least = f64::MIN_POSITIVE * 1.01;
            let sizes = map.sizes(origin) + offset.abs();
            for (slack, size) in [
                (closer.slack.origin, sizes.max_component()),
                (closer.slack.direction, map.sizes(direction).max_component()),
            ] {
                prop_assert!(slack.to_f64() <= 2f64.powi(-203) * size.to_f64() + least);
            }
        }
    }

    fn third() -> Dd {
        Dd::ONE / Dd::of(3.0)
    }

    #[test]
    fn what_was_uncertain_before_the_last_map_stays_so() {
        let two = Vec3::ONE * Dd::of(2.0);
        let map = Affine::of([two, two, two], Vec3::ONE * third());
        let once = Line::new(Vec3::ONE * third(), Vec3::ONE).through(&map);
        let twice = once.through(&map);
        let slack = twice.closer().slack;
        // 2 + 2 + 2 times as much, and a little.
        for (before, after) in [
            (once.slack.origin, slack.origin),
            (once.slack.direction, slack.direction),
        ] {
            let share = after.to_f64() / (6.0 * before.to_f64());
            assert!((1.0..1.0 + 1e-9).contains(&share), "{share}");
        }
        assert!(once.closer().slack.origin.to_f64() < 1e-55);
    }

    #[test]
    fn lines_that_are_not_rounded_stay_what_they_are() {
        let moved = Affine::of(
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|r| Vec3(r).cast()),
            Vec3::new(0.1, 0.2, 0.3).cast(),
        );
        let line: Line<Dd> = Line::new(Vec3::new(0.7, 1e9, 3.0), Vec3::ONE).cast();
        for line in [line, line.through(&moved)] {
            assert_eq!(line.closer().slack, Slack::default());
            assert_eq!(line.closer().origin, line.origin.cast());
        }
        // A sum that is: the third of the origin has no last digit.
        let rounded = Line::new(Vec3::ONE * third(), Vec3::ONE).through(&moved);
        let slack = rounded.closer().slack;
        assert!(slack.origin > Qd::ZERO && slack.origin.to_f64() < 1e-60);
        // Doubles keep nothing.
        let plain: Line = rounded.cast();
        assert_eq!(plain.closer().origin, plain.origin.cast());
        assert_eq!(plain.closer().slack, plain.cast::<Qd>().slack);
    }
}
