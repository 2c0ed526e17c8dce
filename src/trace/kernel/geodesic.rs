//! Geodesic spheres: the first places where four rays meet one, the same numbers as
//! [`GeodesicSphere`] computes, in the same order.
//!
//! A ray comes through the shell between the spheres around and within all facets in a short stretch. Where the stretch
//! is in the cone of one quarter at every split, that facet is found in lanes. Other rays count as unknown and are left
//! to the shape itself: rays that may miss the inner sphere, and rays that come near an edge on the way down.

use super::chain::Local;
use super::facet::{Facet, Shear};
use super::lanes::{ALL, LANES, Lanes, V3, either, is_at_most, is_greater, is_less, mask};
use super::resolved::Resolved;
use crate::geometry::array::each;
use crate::geometry::icosahedron::FACES;
use crate::geometry::vec::{UNIT_ROUNDOFF, Vec3, gamma};
use crate::trace::shapes::geodesic_sphere::{GeodesicSphere, SEARCH_ROUNDOFFS, facets_above};

/// The first places where four rays meet a geodesic sphere.
pub struct First {
    /// The rays that surely meet the sphere, as bits. The answer about the others is not known.
    pub met: u32,
    pub t: Lanes,
    /// The cosines of the rays with the facets' normals, in size, times the lengths of the directions.
    pub speed: Lanes,
    pub faces: [u32; LANES],
}

/// √5 − 2. The product of a point with the normal of the plane through the centre and two vertices of a facet is in
/// proportion to its product with the third vertex, less this share of the sum of its products with all three.
const SHARE: f64 = 0.236_067_977_499_789_7;

/// Four lines as the facets of the unit sphere see them. All lengths are in radii.
struct View {
    shear: Shear,
    /// The points of the lines closest to the centre.
    nearest: V3,
    /// The depths of the nearest points, from the origins of the lines.
    depth: Lanes,
    /// The sum of the components of the origins, in size.
    size: Lanes,
}

impl View {
    #[inline(always)]
    fn of(local: &Local, radius: Lanes) -> View {
        let shear = Shear::along(local.direction);
        let e = shear.slope;
        let square = e.dot(e);
        let origin = local.origin.over(radius);
        let (mut nearest, mut depth) = (origin, Lanes::ZERO);
        for _ in 0..2 {
            let step = -nearest.dot(e) / square;
            nearest = nearest + e * step;
            depth += step;
        }
        let [x, y, z] = origin.abs().0;
        View {
            shear,
            nearest,
            depth,
            size: x + y + z,
        }
    }

    #[inline(always)]
    fn facet(&self, corners: [V3; 3]) -> Facet {
        Facet::new(each(corners, |at| self.shear.project(at - self.nearest)))
    }
}

/// Stretches of four lines between two ends. A point up to `tolerance` behind a plane counts as in front of it.
struct Stretches {
    ends: [V3; 2],
    tolerance: Lanes,
}

impl Stretches {
    /// The stretches that reach the side that `normal` points to, of planes through the centre; and those that reach
    /// the other side; both as bits.
    #[inline(always)]
    fn sides(&self, normal: V3) -> [u32; 2] {
        let [a, b] = each(self.ends, |end| normal.dot(end));
        let front = is_greater(-self.tolerance, a.fast_max(b));
        let back = is_greater(a.fast_min(b), self.tolerance);
        [front, back].map(|beside| !beside.to_bitmask() & ALL)
    }

    /// The facets of the icosahedron whose cones the stretches meet, and, as bits, the lines that surely meet the cone
    /// of no other: see [`GeodesicSphere`].
    #[inline(always)]
    fn base(&self, vertices: &[Vec3; 12]) -> ([u32; LANES], u32) {
        let height = |end: V3| each(*vertices, |vertex| V3::splat(vertex).dot(end));
        let heights = each(self.ends, height);
        let (mut faces, mut met, mut again) = ([0; LANES], 0, 0);
        for (face, corners) in (0..).zip(FACES) {
            let [from, to] = each([0, 1], |end: usize| {
                let of = each(corners, |i| heights[end][i]);
                let level = Lanes::splat(SHARE) * (of[0] + of[1] + of[2]);
                V3(each(of, |height| height - level))
            });
            let highest = V3(each([0, 1, 2], |i: usize| from.0[i].fast_max(to.0[i])));
            let before = is_greater(-self.tolerance, highest.min_component());
            let within = !before.to_bitmask() & ALL;
            again |= met & within;
            met |= within;
            for (lane, own) in faces.iter_mut().enumerate() {
                if within >> lane & 1 != 0 {
                    *own = face;
                }
            }
        }
        (faces, met & !again)
    }
}

/// Facets on the way down, one for each line.
struct Facets {
    faces: [u32; LANES],
    corners: [V3; 3],
}

impl Facets {
    /// Facets of the icosahedron.
    #[inline(always)]
    fn base(vertices: &[Vec3; 12], faces: [u32; LANES]) -> Facets {
        let corner = |k: usize| {
            let of = each(faces, |face| {
                &vertices[FACES[face as usize % FACES.len()][k]]
            });
            V3::gathered(of, |vertex| &vertex.0)
        };
        Facets {
            faces,
            corners: [corner(0), corner(1), corner(2)],
        }
    }

    /// The middles of the edges, which are opposite to the corners: from the table of the first levels, or computed.
    #[inline(always)]
    fn middles(&self, known: &[[Vec3; 3]], level: u32) -> [V3; 3] {
        let before = facets_above(level);
        if known.len() <= before as usize {
            let [a, b, c] = self.corners;
            return [middle(b, c), middle(c, a), middle(a, b)];
        }
        let of = each(self.faces, |face| &known[(before + face) as usize]);
        each([0, 1, 2], |k: usize| {
            V3::gathered(of, |middles| &middles[k].0)
        })
    }

    /// Goes down to one quarter each. `quarters` has the lines that take each quarter, as bits.
    #[inline(always)]
    fn quarter(&mut self, [bc, ca, ab]: [V3; 3], quarters: [u32; 4]) {
        let [a, b, c] = self.corners;
        let [first, second, third, _] = each(quarters, mask);
        let select = |[p, q, r, s]: [V3; 4]| {
            V3::either(first, p, V3::either(second, q, V3::either(third, r, s)))
        };
        self.corners = [
            select([a, ab, ca, bc]),
            select([ab, b, bc, ca]),
            select([ca, bc, c, ab]),
        ];
        for (lane, face) in self.faces.iter_mut().enumerate() {
            let taken = |quarter: &u32| quarters[*quarter as usize] >> lane & 1 != 0;
            *face = *face * 4 + (0..3).find(taken).unwrap_or(3);
        }
    }

    /// The facets with some numbers.
    #[inline(always)]
    fn with_numbers(sphere: &GeodesicSphere, faces: [u32; LANES]) -> Facets {
        let (_, splits) = sphere.numbers();
        let known = sphere.known_middles();
        let above = |level: u32| each(faces, |face| face >> (2 * (splits - level)));
        let mut facets = Facets::base(&sphere.icosahedron(), above(0));
        for level in 0..splits {
            let below = above(level + 1);
            let takes = |quarter: u32| {
                (0..LANES).fold(0, |bits, lane| {
                    bits | u32::from(below[lane] & 3 == quarter) << lane
                })
            };
            let middles = facets.middles(known, level);
            facets.quarter(middles, [takes(0), takes(1), takes(2), takes(3)]);
        }
        facets
    }
}

/// The middles of edges, pushed out to the sphere.
#[inline(always)]
fn middle(a: V3, b: V3) -> V3 {
    let sum = a + b;
    sum * (Lanes::splat(1.0) / sum.dot(sum).sqrt())
}

/// The first places where `rays` meet a sphere. `skin` is the t beyond which a place cannot be taken for a ray's start.
#[inline(never)]
pub fn first(sphere: &GeodesicSphere, local: &Local, skin: Lanes, rays: u32) -> First {
    let splat = Lanes::splat;
    let (size, splits) = sphere.numbers();
    let radius = splat(size);
    let view = View::of(local, radius);
    let (slope, nearest, pace) = (view.shear.slope, view.nearest, view.shear.pace);

    // Wider than the bounds of the shape.
    let search = splat(SEARCH_ROUNDOFFS * UNIT_ROUNDOFF);
    let fastest = local.direction.abs().max_component();
    let bend = local.slack[1] / fastest;
    let reach = local.origin.abs().max_component() + radius;
    let drift = local.slack[0] + splat(4.0) * bend * reach;
    let noise = splat(gamma(24)) * view.size + search + splat(4.0) * drift / radius;
    let finest = splat(1.0 / 16.0 / f64::from(1 << splits));
    let slack = search + noise;

    let square = slope.dot(slope);
    let aside = nearest.dot(slope);
    let middle = -aside / square;
    let distance = nearest.dot(nearest) + aside * middle;
    let far = splat(16.0) * slack;
    let inner = sphere.inner();
    let outside = splat(1.0) + far - distance;
    let inside = splat(inner * inner) - far - distance;
    let goes_through = is_greater(inside, Lanes::ZERO) & is_at_most(noise, finest);
    let mut live = rays & goes_through.to_bitmask();
    let none = First {
        met: 0,
        t: Lanes::ZERO,
        speed: Lanes::ZERO,
        faces: [0; LANES],
    };
    if live == 0 {
        return none;
    }
    let [out, start] = each([outside, inside], |x| {
        (x.fast_max(Lanes::ZERO) / square).sqrt()
    });
    let falls = is_less(pace, Lanes::ZERO);
    let ends = [
        either(falls, middle + start, middle - out),
        either(falls, middle + out, middle - start),
    ];
    let stretches = Stretches {
        ends: each(ends, |depth| nearest + slope * depth),
        tolerance: splat(4.0) * slack,
    };

    let vertices = sphere.icosahedron();
    let (faces, alone) = stretches.base(&vertices);
    live &= alone;
    let mut facets = Facets::base(&vertices, faces);
    let known = sphere.known_middles();
    for level in 0..splits {
        if live == 0 {
            return none;
        }
        let middles = facets.middles(known, level);
        let [bc, ca, ab] = middles;
        let normals = [ab.cross(ca), bc.cross(ab), ca.cross(bc)];
        let [a, b, c] = each(normals, |normal| stretches.sides(normal));
        let inmost = a[1] & b[1] & c[1];
        let quarters = [a[0], b[0], c[0], inmost];
        let (mut met, mut again) = (0, 0);
        for lines in quarters {
            again |= met & lines;
            met |= lines;
        }
        live &= met & !again;
        facets.quarter(middles, quarters);
    }

    let facet = view.facet(facets.corners);
    let [goes_in, goes_out] = facet.certain(noise);
    let certain = either(falls, goes_out, goes_in);
    let t = (view.depth + facet.depth(facet.weights())) * radius / pace;
    let [a, b, c] = facets.corners;
    let speed = (b - a).cross(c - a).unit().dot(local.direction).abs();
    // The shape looks at both stretches where this one is that near.
    let least = splat(1.5) * skin + splat(0.02) * reach / fastest;
    let is_ahead = is_greater(t, least) & is_less(t, splat(f64::INFINITY));
    First {
        met: live & (certain & is_ahead & local.is_sharp(t)).to_bitmask(),
        t,
        speed,
        faces: facets.faces,
    }
}

/// The points where four lines pass facets of a sphere, as the shape itself locates them. `clear` are the lines that
/// surely pass their facets.
#[inline(never)]
pub fn locate(sphere: &GeodesicSphere, local: &Local, faces: [u32; LANES]) -> Resolved {
    let splat = Lanes::splat;
    let (radius, splits) = sphere.numbers();
    let radius = splat(radius);
    let view = View::of(local, radius);
    let corners = Facets::with_numbers(sphere, faces).corners;
    let facet = view.facet(corners);
    let weights = facet.weights();
    let zero = V3::splat(Vec3::ZERO);
    let (mut point, mut size) = (zero, zero);
    for (v, w) in corners.into_iter().zip(weights.0) {
        point = point + v * w;
        size = size + v.abs() * w;
    }
    let [a, b, c] = corners;
    let of_corners = V3::splat(Vec3::ONE * gamma(8 * (splits + 1)));
    Resolved {
        clear: facet.is_passed(),
        t: Lanes::ZERO,
        point: point * radius,
        error: (size * splat(gamma(8)) + of_corners) * radius,
        normal: (b - a).cross(c - a),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::affine::Slack;
    use crate::geometry::line::Line;
    use crate::trace::kernel::tests::numbers;
    use crate::trace::shapes::{Intersect, Roots};

    /// What is known has the bits of what the shape finds, of lines from everywhere, also along axes and through
    /// vertices, to spheres with all numbers of splits.
    #[test]
    fn rays_are_met_where_the_shape_finds() {
        let mut number = numbers();
        let [mut met, mut all] = [0; 2];
        for i in 0..4_000 {
            let size = [1.0, 3.7e-9, 8.1e12][i % 3];
            let sphere = GeodesicSphere::new(size, (i / 3 % 10) as u32);
            let lines = each([0, 1, 2, 3], |lane: usize| {
                let mut vector = || Vec3::new(number(), number(), number());
                let far = [3.0, 40.0, 1.5][(i + lane) % 3];
                let (from, mut to) = (vector().unit() * (far * size), vector() * (0.6 * size));
                if (i + lane).is_multiple_of(13) {
                    to = sphere.icosahedron()[i % 12] * (0.7 * size);
                }
                let mut way = to - from;
                if (i + lane).is_multiple_of(11) {
                    way.0[lane % 3] = 0.0;
                }
                Line::new(from, way * (1.0 + number().abs()))
            });
            let local = Local {
                origin: V3::gathered(lines.each_ref(), |line| &line.origin.0),
                direction: V3::gathered(lines.each_ref(), |line| &line.direction.0),
                slack: [Lanes::splat(1e-17 * size); 2],
            };
            let found = first(&sphere, &local, Lanes::splat(1e-9), ALL);
            let places = locate(&sphere, &local, found.faces);
            let lane_of = |v: V3, lane: usize| Vec3(v.columns().map(|column| column[lane]));
            for (lane, line) in lines.iter().enumerate() {
                let slack = Slack {
                    origin: 1e-17 * size,
                    direction: 1e-17 * size,
                };
                let line = Line::within(slack, line.origin, line.direction);
                let mut roots = Roots::default();
                sphere.first_crossings(&line, 1.5e-9, &mut roots);
                let is_ahead = roots.list.first().is_some_and(|root| root.t > 0.05);
                all += u32::from(is_ahead);
                if found.met >> lane & 1 == 0 {
                    continue;
                }
                assert!(!roots.uncertain, "{sphere:?} {line:?}");
                let root = roots.list[0];
                let t = found.t.to_array()[lane];
                assert_eq!(
                    (t, found.faces[lane]),
                    (root.t, root.face),
                    "{sphere:?} {line:?}"
                );
                let speed = sphere.speed(&line, root).expect("facets are flat");
                assert!((found.speed.to_array()[lane] - speed).abs() <= 1e-9 * speed);
                assert!(places.clear.to_bitmask() >> lane & 1 != 0);
                let own = sphere.locate(&line, root);
                assert_eq!(
                    lane_of(places.point, lane),
                    own.point,
                    "{sphere:?} {line:?}"
                );
                assert_eq!(
                    lane_of(places.error, lane),
                    own.error,
                    "{sphere:?} {line:?}"
                );
                assert_eq!(
                    lane_of(places.normal, lane),
                    own.normal,
                    "{sphere:?} {line:?}"
                );
                met += 1;
            }
        }
        assert!(met * 10 > all * 8, "{met} of {all}");
    }
}
