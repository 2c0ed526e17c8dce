//! Decisions that are too close for double-double.
//!
//! Where a surface turns back on itself, as at a corner of a profile or where a torus is pinched, a line may pass at a
//! distance whose square, or fourth power, decides what the line crosses. The square of the least distance between
//! doubles is below the digits of double-double.

use super::{Root, Roots};
use crate::geometry::dd::Dd;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::qd::Qd;

/// Whether R is quad-double, after which there is no finer number to ask. What quad-double cannot tell from a touch
/// counts as a touch.
pub(super) fn is_last<R: Traced>() -> bool {
    R::ROUNDOFF <= R::of(Qd::ROUNDOFF.to_f64())
}

/// Replaces uncertain crossings in double-double by those that `decide` finds in quad-double. Crossings that are
/// certain, or in other kinds of number, stay.
///
/// Crossings that are in order in quad-double may have the same t in double-double. They get neighbouring numbers, and
/// so keep their order.
pub(super) fn decide_closer<R: Traced>(
    line: &Line<R>,
    roots: &mut Roots<R>,
    decide: impl FnOnce(&Line<Qd>, &mut Roots<Qd>),
) {
    if !roots.uncertain || R::ROUNDOFF > R::of(Dd::ROUNDOFF.to_f64()) || is_last::<R>() {
        return;
    }
    let mut closer = Roots::default();
    decide(&line.closer(), &mut closer);
    roots.inside = closer.inside;
    roots.uncertain = closer.uncertain;
    roots.along = closer.along;
    roots.list.clear();
    for Root { t, face } in closer.list {
        let t = R::of_parts(t.parts());
        let t = match roots.list.last() {
            Some(last) if t <= last.t => after(last.t),
            _ => t,
        };
        roots.push(t, face);
    }
}

/// A number greater than `t` by little more than the rounding error of `t`.
fn after<R: Traced>(t: R) -> R {
    let step = t.abs() * R::ROUNDOFF;
    // A double-double number can add the least double to any number.
    t + (step + step).max(R::of(f64::from_bits(1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::affine::Affine;
    use crate::geometry::vec::Vec3;
    use crate::scene::Geometry;
    use crate::trace::shapes::Primitive;

    #[test]
    fn only_double_double_in_doubt_goes_on() {
        fn asked<R: Traced>(uncertain: bool) -> bool {
            let line = Line::new(Vec3::ZERO, Vec3::new(R::ONE, R::ZERO, R::ZERO));
            let mut roots = Roots {
                uncertain,
                ..Roots::default()
            };
            let mut asked = false;
            decide_closer(&line, &mut roots, |_, _| asked = true);
            assert_eq!(roots.uncertain, uncertain && !asked);
            asked
        }
        assert!(asked::<Dd>(true) && !asked::<Dd>(false));
        assert!(!asked::<f64>(true) && !asked::<f32>(true) && !asked::<Qd>(true));
        assert!(is_last::<Qd>() && !is_last::<Dd>());
    }

    #[test]
    fn crossings_closer_than_the_digits_of_t_stay_in_order() {
        let line = Line::new(Vec3::ZERO, Vec3::new(Dd::ONE, Dd::ZERO, Dd::ZERO));
        for t in [0.0, 5.0, -5.0, 1e300, -1e300, 1e-320, -f64::MIN_POSITIVE] {
            let mut roots = Roots {
                uncertain: true,
                ..Roots::default()
            };
            // What a quad-double tells apart, if it is large enough for that.
            let close = Qd::of(t) * Qd::ROUNDOFF * Qd::of(16.0);
            decide_closer(&line, &mut roots, |_, closer| {
                for (face, n) in (0..).zip([-1.0, 0.0, 1.0]) {
                    closer.push(Qd::of(t) + close.abs() * Qd::of(n), face);
                }
            });
            let faces: Vec<u32> = roots.list.iter().map(|root| root.face).collect();
            assert_eq!(faces, [0, 1, 2]);
            for pair in roots.list.windows(2) {
                assert!(pair[0].t < pair[1].t, "{t}");
            }
            for root in &roots.list {
                let off = (root.t - Dd::of(t)).abs().to_f64();
                assert!(off <= 4.0 * Dd::ROUNDOFF.to_f64() * t.abs() + 1e-323);
            }
        }
    }

    const U: f64 = f64::EPSILON / 2.0;

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
