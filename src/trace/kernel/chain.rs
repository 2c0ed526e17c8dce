//! Chains of placements: they take four rays into the spaces of four shapes, and points out of these spaces. The chains
//! may differ in length.
//!
//! Points, directions and normals have the same bits as for one ray at a time. Bounds on errors are wider and cheaper.

use super::cuboid::SHARE;
use super::lanes::{LANES, Lanes, V3, either, is_at_most, is_greater, lanes_where, mask};
use super::leaf::Leaf;
use super::maps::Maps;
use super::query::BENT;
use crate::geometry::affine::{Placement, Slack};
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::{UNIT_ROUNDOFF, Vec3, gamma};
use crate::trace::shapes::BLURRED;

/// The factor that widens bounds, since bounds are rounded, too.
const ROOM: f64 = 1.01;
/// The least size of a mapped normal: smaller normals count as unknown.
const LEAST_NORMAL: f64 = 1e-60;

/// The chains of four leaves.
pub struct Chains<'s> {
    ways: [&'s [u32]; LANES],
    placements: &'s [Placement],
    /// The length of the longest chain.
    depth: usize,
}

/// Four rays in the spaces of their leaves. `slack` bounds the errors of their origins and of their directions: see
/// [`Slack`].
pub struct Local {
    pub origin: V3,
    pub direction: V3,
    pub slack: [Lanes; 2],
}

/// Points of surfaces, in some space.
pub struct Located {
    pub point: V3,
    pub error: V3,
    pub normal: V3,
    /// A mask: the lanes in which the point, its error and the normal are known.
    pub known: Lanes,
}

impl<'s> Chains<'s> {
    /// The chains of four leaves, out of the list of all chains and the list of all placements.
    pub fn of(
        leaves: [&Leaf; LANES],
        chains: &'s [Vec<u32>],
        placements: &'s [Placement],
    ) -> Chains<'s> {
        let ways = each(leaves, |leaf| &chains[leaf.chain as usize][..]);
        Chains {
            ways,
            placements,
            depth: ways.iter().fold(0, |most, way| way.len().max(most)),
        }
    }

    /// The placements at a depth of the chains, and a mask of the chains that reach the depth. The lanes of shorter
    /// chains hold an arbitrary placement.
    #[inline(always)]
    fn level(&self, depth: usize) -> ([&Placement; LANES], Lanes) {
        let any = self.ways.iter().find_map(|way| way.get(depth));
        let place = |lane: usize| {
            let number = self.ways[lane].get(depth).or(any);
            &self.placements[number.copied().unwrap_or(0) as usize]
        };
        let goes = lanes_where(|lane| depth < self.ways[lane].len());
        (each([0, 1, 2, 3], place), mask(goes))
    }

    /// Takes four rays into the spaces of the leaves.
    #[inline(always)]
    pub fn enter(&self, origin: V3, direction: V3) -> Local {
        let mut line = Local {
            origin,
            direction,
            slack: [Lanes::ZERO; 2],
        };
        for depth in 0..self.depth {
            let (places, goes) = self.level(depth);
            line = line.through(&places, goes);
        }
        line
    }

    /// Takes points of the leaves into the scene's space. The normals are unit vectors in the lanes that are known.
    #[inline(always)]
    pub fn leave(&self, located: Located) -> Located {
        let mut located = located;
        for depth in (0..self.depth).rev() {
            let (places, goes) = self.level(depth);
            located = located.out(&places, goes);
        }
        let normal = located.normal.unit();
        let sizes = located.point.abs() + located.error + normal.abs();
        let size = sizes.0[0] + sizes.0[1] + sizes.0[2];
        let is_finite = is_greater(Lanes::splat(f64::INFINITY), size);
        Located {
            normal,
            known: located.known & is_finite,
            ..located
        }
    }
}

impl Local {
    /// Takes the rays into the spaces of placements, in the lanes of the mask `goes`.
    #[inline(always)]
    fn through(&self, places: &[&Placement; LANES], goes: Lanes) -> Local {
        let maps = Maps::gathered(*places, |place| &place.back);
        let Local {
            origin,
            direction,
            slack,
        } = *self;
        let turns = goes & mask(lanes_where(|lane| !places[lane].back.moves()));
        let spread = maps.sizes(V3::splat(Vec3::ONE)).max_component();
        let room = Lanes::splat(ROOM);
        let [x, y, z] = (maps.sizes(origin.abs()) + maps.offset.abs()).0;
        let vector = maps.sizes(direction.abs()).max_component();
        let lost = each([x + y + z, vector], |size| {
            Lanes::splat(ROOM * gamma(5)) * size
        });
        Local {
            origin: V3::either(goes, maps.point(origin), origin),
            direction: V3::either(turns, maps.vector(direction), direction),
            slack: [
                either(goes, lost[0] + room * spread * slack[0], slack[0]),
                either(turns, lost[1] + room * spread * slack[1], slack[1]),
            ],
        }
    }

    #[inline(always)]
    pub fn at(&self, t: Lanes) -> V3 {
        self.origin + self.direction * t
    }

    /// A mask: the lanes in which the maps into this space have surely moved the line no more than a little at t. See
    /// [`Line::is_blurred_at`](crate::geometry::line::Line::is_blurred_at).
    #[inline(always)]
    pub fn is_sharp(&self, t: Lanes) -> Lanes {
        let drift = self.slack[1] * t.abs();
        let reach = self.origin.abs().max_component();
        let at = self.at(t).abs().max_component();
        is_at_most(
            drift,
            Lanes::splat(BLURRED * UNIT_ROUNDOFF) * reach.fast_max(at),
        )
    }

    /// Bounds on the errors of crossings at t with a curved shape of this extent: see
    /// [`rough`](crate::trace::search::root_order::rough).
    #[inline(always)]
    pub fn bent_error(&self, extent: f64, t: Lanes) -> Lanes {
        let splat = Lanes::splat;
        let pace = self.direction.abs().max_component();
        let reach = self.origin.abs().max_component() + splat(extent);
        let size = reach / pace + t.abs();
        let slack = self.slack[0] / pace + t.abs() * self.slack[1] / pace;
        let error = splat(BENT) * size + splat(4.0) * (slack * size).sqrt();
        either(error.simd_eq(error), error, splat(f64::INFINITY))
    }

    /// Bounds on the errors of crossings at t with a flat face that the lines pass at these speeds: see
    /// [`rough`](crate::trace::search::root_order::rough).
    #[inline(always)]
    pub fn flat_error(&self, extent: f64, t: Lanes, speed: Lanes) -> Lanes {
        let splat = Lanes::splat;
        let pace = self.direction.abs().max_component();
        let reach = self.origin.abs().max_component() + splat(extent);
        let slack = self.slack[0] + t.abs() * self.slack[1];
        let error = (splat(SHARE) * (reach + t.abs() * pace) + splat(4.0) * slack) / speed;
        either(error.simd_eq(error), error, splat(f64::INFINITY))
    }

    /// The line in each lane.
    #[inline(always)]
    pub fn lines(&self) -> [Line; LANES] {
        let (origin, direction) = (self.origin.columns(), self.direction.columns());
        let slack = [self.slack[0].to_array(), self.slack[1].to_array()];
        let vector = |columns: &[[f64; LANES]; 3], lane: usize| {
            Vec3::new(columns[0][lane], columns[1][lane], columns[2][lane])
        };
        each([0, 1, 2, 3], |lane: usize| {
            let slack = Slack {
                origin: slack[0][lane],
                direction: slack[1][lane],
            };
            Line::within(slack, vector(&origin, lane), vector(&direction, lane))
        })
    }
}

impl Located {
    /// Takes the points out of the spaces of placements, in the lanes of the mask `goes`.
    #[inline(always)]
    fn out(&self, places: &[&Placement; LANES], goes: Lanes) -> Located {
        let splat = Lanes::splat;
        let back = Maps::gathered(*places, |place| &place.back);
        let out = Maps::gathered(*places, |place| &place.out);
        let before = self.error * splat(1.0 + gamma(3)) + self.point.abs() * splat(gamma(4));
        let error = out.sizes(before.abs()) + out.offset.abs() * splat(gamma(4));
        let normal = back.transposed(self.normal);
        // Beside normals of this size, underflow in the products does not count.
        let is_usual = is_greater(normal.abs().max_component(), splat(LEAST_NORMAL));
        Located {
            point: V3::either(goes, out.point(self.point), self.point),
            error: V3::either(goes, error, self.error),
            normal: V3::either(goes, normal.unit(), self.normal),
            known: self.known & (is_usual | !goes),
        }
    }
}
