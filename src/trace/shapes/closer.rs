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
    decide(&line.cast(), &mut closer);
    roots.inside = closer.inside;
    roots.uncertain = closer.uncertain;
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
