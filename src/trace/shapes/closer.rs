//! Decisions that are too close for double-double.
//!
//! Where a surface turns back on itself, as at a corner of a profile or where a torus is pinched,
//! a line may pass at a distance whose square, or the square of that, decides what it crosses.
//! Squares of what two doubles can be apart by are below the digits of double-double.

use super::{Root, Roots};
use crate::trace::dd::Dd;
use crate::trace::number::Real;
use crate::trace::qd::Qd;
use crate::trace::ray::Line;

/// Whether there is no finer number to ask even here: what this one cannot tell from a touch is
/// one.
pub(super) fn is_last<R: Real>() -> bool {
    R::ROUNDOFF <= R::of(Qd::ROUNDOFF.to_f64())
}

/// Decides what double-double could not in quad-double.
///
/// Crossings farther apart than no rounding, but closer than the digits of t, are told apart by
/// their order: at neighbouring numbers.
pub(super) fn decide_closer<R: Real>(
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

/// A number that is greater by little more than its rounding error.
fn after<R: Real>(t: R) -> R {
    let step = t.abs() * R::ROUNDOFF;
    // Double-double has a place for the least double beside every number.
    t + (step + step).max(R::of(f64::from_bits(1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::vec::Vec3;

    #[test]
    fn only_double_double_in_doubt_goes_on() {
        fn asked<R: Real>(uncertain: bool) -> bool {
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
}
