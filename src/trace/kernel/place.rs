//! Placed shapes: four rays at once into the spaces of the shapes, and the points out of them.

use super::lanes::{LANES, Lanes, V3, is_greater};
use super::maps::Maps;
use super::resolved::Resolved;
use crate::geometry::affine::Placement;
use crate::geometry::vec::{UNIT_ROUNDOFF, gamma};

/// A ray is in doubt if maps may have moved its line by more than this many unit roundoffs. The arbiter allows a little
/// more: see `Roots::doubt_blurred` of [`shapes`](crate::trace::shapes).
const BLURRED: f64 = 31.0;

/// The points in the scene's space where rays meet placed shapes. `resolve` finds them for rays in the spaces of the
/// shapes.
#[inline(always)]
pub fn placed(
    places: [&Placement; LANES],
    origin: V3,
    direction: V3,
    resolve: impl FnOnce(V3, V3) -> Resolved,
) -> Resolved {
    let splat = Lanes::splat;
    let back = Maps::gathered(places, |p| &p.back);
    let out = Maps::gathered(places, |p| &p.out);
    let (local, way) = (back.point(origin), back.vector(direction));
    let Resolved {
        clear,
        t,
        point,
        error,
        normal,
    } = resolve(local, way);
    let turned = back.sizes(direction.abs()).max_component() * splat(gamma(5));
    let drift = turned * t.abs();
    let unit = splat(BLURRED * UNIT_ROUNDOFF);
    let at = local + way * t;
    let sharp = is_greater(unit * local.abs().max_component(), drift)
        | is_greater(unit * at.abs().max_component(), drift);
    let before = error * splat(1.0 + gamma(3)) + point.abs() * splat(gamma(4));
    Resolved {
        clear: clear & sharp,
        t,
        point: out.point(point),
        error: out.sizes(before) + out.offset.abs() * splat(gamma(4)),
        normal: back.transposed(normal).unit(),
    }
}
