//! What a line keeps of its way into the space it is in.
//!
//! A map rounds the line. What the shape then cannot decide in double-double is decided in
//! quad-double, which is of no use for a line that has lost those digits on its way. So a line in
//! double-double keeps where it comes from, and goes the way again if it is asked for more.

use super::affine::Affine;
use super::dd::Dd;
use super::number::Real;
use super::qd::Qd;
use super::ray::{Line, Slack};
use super::vec::Vec3;
use std::fmt::Debug;

/// What lines in one kind of number keep.
pub trait Way<R: Real>: Copy + Debug + Default + Send + Sync {
    /// That of a line which goes through a map.
    fn through(line: &Line<R>, map: &Affine<R>) -> Self;

    /// A line in quad-double.
    fn closer(line: &Line<R>) -> Line<Qd>;
}

/// Nothing: what these numbers have rounded stays as it is.
impl<R: Real<Way = ()>> Way<R> for () {
    #[inline]
    fn through(_: &Line<R>, _: &Affine<R>) {}

    fn closer(line: &Line<R>) -> Line<Qd> {
        line.cast()
    }
}

/// Of a line in double-double: the line before the last map, and the map.
#[derive(Debug, Clone, Copy)]
pub struct Before {
    origin: Vec3<Dd>,
    direction: Vec3<Dd>,
    slack: Slack<Dd>,
    map: Affine<Dd>,
}

impl Way<Dd> for Option<Before> {
    fn through(line: &Line<Dd>, map: &Affine<Dd>) -> Option<Before> {
        Some(Before {
            origin: line.origin,
            direction: line.direction,
            slack: line.slack,
            map: *map,
        })
    }

    /// What maps before the last one have rounded stays in the slack.
    fn closer(line: &Line<Dd>) -> Line<Qd> {
        let Some(before) = line.way.filter(|_| line.slack != Slack::default()) else {
            return line.cast();
        };
        let mut from: Line<Dd> = Line::new(before.origin, before.direction);
        from.slack = before.slack;
        let mut line = from.cast::<Qd>().through(&before.map.cast());
        // The bounds of the map are for products that do not underflow. Those here lose some tens
        // of the least double, of which this is 2⁵².
        let lost = Qd::of(f64::MIN_POSITIVE);
        line.slack.origin += lost;
        line.slack.direction += lost;
        line
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Geometry;
    use crate::trace::shapes::{Primitive, Roots};
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

    fn crossings(profile: &[[f64; 2]], line: &Line<Dd>) -> (usize, bool) {
        let shape = Primitive::new(&Geometry::Revolution {
            profile: profile.to_vec(),
            colours: Vec::new(),
        });
        let mut roots = Roots::default();
        shape.intersect::<Dd>().crossings(line, &mut roots);
        (roots.list.len(), roots.uncertain)
    }

    /// A waist of radius 1: with y = η where x is 0 the line is level with it at x ≈ −2η, and 2η²
    /// outside; on either side of that gap it is inside, and leaves at x ≈ ±4/3.
    ///
    /// (1 + 2u)(1 − 2u) 2ᵏ − 2ᵏ = −4u² 2ᵏ is η, exactly. The map rounds by as much as 2ᵏ⁻⁹⁸ in
    /// double-double, and by 2ᵏ⁻²⁰² in quad-double: the gap is less than that up to k = 5, and
    /// greater from k = 16 on by more than the factor, of some 2⁵, that is lost in the shape. What
    /// cannot be told from a touch is taken for one, from outside, which here is right.
    #[test]
    fn a_map_hides_no_gap_that_quad_double_can_tell() {
        let waist = [[2.0, -1.0], [1.0, 0.0], [2.0, 1.0]];
        for k in (-10..=5).chain(16..=50) {
            let size = 2f64.powi(k);
            let row = |v: [f64; 3]| Vec3(v).cast();
            let map = Affine::<Dd>::of(
                [
                    row([0.0, 0.0, 1.0]),
                    row([1.0 + 2.0 * U, -1.0, 0.0]),
                    row([0.0, 1.0, 0.0]),
                ],
                row([0.0, 0.0, 1.0 - size]),
            );
            let origin = [(1.0 - 2.0 * U) * size, size, 0.0];
            let line = Line::new(row(origin), row([0.5, 0.0, 1.0])).through(&map);
            assert_eq!(line.origin.0, [0.0, -4.0 * U * U * size, 1.0].map(Dd::of));
            assert_eq!(crossings(&waist, &line), (4, k <= 5), "{k}");
        }
    }

    /// Between two needles less than 1e-24 of the size apart: the counts are those of an evaluation
    /// in exact arithmetic, and the same for all lines within half a unit in the last place.
    #[test]
    fn known_lines_between_needles() {
        let needles = [
            [610.1970382894946, 13445.550970684242],
            [2.3039021357476412e-12, 13445.550970684239],
            [610.1970382893469, 13445.550970684242],
            [2.0463809320284318e-10, 13445.550970684239],
        ];
        for (rows, offset, origin, direction) in [
            (
                [
                    [0.05201895234447477, 0.2796996960636874, 0.14474766279379572],
                    [0.12428532895561777, -0.1530334243199005, 0.2510452256321984],
                    [
                        0.2893733969610534,
                        0.015447599431899642,
                        -0.13384388692956595,
                    ],
                ],
                [115479.78197162531, 206405.17373978999, 88802.39965498],
                [-546534.0751405447, -40653.45819600897, -522833.2575476998],
                [
                    -9.584750853973761e-12,
                    -4.1835582231592024e-13,
                    4.252937024148953e-12,
                ],
            ),
            (
                [
                    [
                        0.143308191324485,
                        -0.04962305053892292,
                        -0.07914212025035441,
                    ],
                    [
                        -0.062011381853202895,
                        -0.15892768473292526,
                        -0.01263881281186752,
                    ],
                    [
                        -0.06986065318307806,
                        0.03927726981154202,
                        -0.15112890278232774,
                    ],
                ],
                [-86036.74311175053, 145017.36347215637, -86761.0719999698],
                [9019297216.100077, -17133781645.91153, -20942320935.104115],
                [
                    -0.23105958462286943,
                    0.43898090464060374,
                    0.5365212355905316,
                ],
            ),
        ] {
            let map = Affine::<Dd>::of(rows.map(|row| Vec3(row).cast()), Vec3(offset).cast());
            let line = Line::new(Vec3(origin).cast(), Vec3(direction).cast());
            assert_eq!(crossings(&needles, &line.through(&map)), (4, false));
        }
    }
}
