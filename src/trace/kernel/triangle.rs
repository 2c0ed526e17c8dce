//! Triangles: which of several triangles a line meets, after Möller and Trumbore, "Fast, minimum storage ray/triangle
//! intersection", JGT 2(1), 1997; and where each of several lines meets its own, computed as in
//! [`shapes::triangle`](crate::trace::shapes).

use super::cuboid::SHARE;
use super::facet::{Facet, Shear};
use super::lanes::{ALL, LANES, Lanes, Number, V3, is_at_most, is_greater, is_less};
use super::leaf::Leaf;
use super::probe::{Chords, Probe};
use super::resolved::{Meet, Resolved};
use crate::geometry::array::each;
use crate::geometry::vec::{UNIT_ROUNDOFF, Vec3, gamma};

/// Up to four triangles.
#[derive(Debug, Clone)]
pub struct Triangles {
    /// The first vertices.
    corner: V3,
    /// The edges from the first vertex to the second and to the third.
    edges: [V3; 2],
    /// The largest component of the two edges, in size.
    width: Lanes,
    /// The largest coordinate of the vertices, in size.
    extent: Lanes,
    present: u32,
}

/// A line is in doubt if a volume that it spans with an edge is below this share of the numbers that the volume is
/// computed from. The three volumes are sums of at most twelve products, so that rounding changes them by less than
/// 2⁻⁴⁶ of these numbers; and the arbiter is sure of its edge functions above 2⁻⁴⁴ of the same numbers.
const RIM: f64 = 1e-12;

/// The largest component of some vectors, in size.
fn largest<const N: usize>(vectors: [Vec3; N]) -> f64 {
    vectors
        .iter()
        .fold(0.0, |most, v| v.abs().max_component().max(most))
}

impl Triangles {
    /// Packs up to four triangles by their vertices.
    pub fn new(triangles: &[&[Vec3; 3]]) -> Triangles {
        let four = |number: &dyn Fn(&[Vec3; 3]) -> f64| {
            let lane = |k: usize| triangles.get(k).map_or(0.0, |t| number(t));
            Lanes::new([lane(0), lane(1), lane(2), lane(3)])
        };
        let vectors = |vector: fn(&[Vec3; 3]) -> Vec3| {
            V3(each([0, 1, 2], |i: usize| four(&|t| vector(t)[i])))
        };
        Triangles {
            corner: vectors(|t| t[0]),
            edges: [vectors(|t| t[1] - t[0]), vectors(|t| t[2] - t[0])],
            width: four(&|t| largest([t[1] - t[0], t[2] - t[0]])),
            extent: four(&|&t| largest(t)),
            present: (1 << triangles.len()) - 1,
        }
    }

    /// One triangle in all four lanes.
    #[inline(always)]
    pub fn of_one(leaf: &Leaf) -> Triangles {
        let [a, b, c] = *leaf.corners();
        let [.., width, extent, _, _] = leaf.numbers;
        Triangles {
            corner: V3::splat(a),
            edges: [V3::splat(b - a), V3::splat(c - a)],
            width: Lanes::splat(width),
            extent: Lanes::splat(extent),
            present: ALL,
        }
    }

    /// The crossings with the triangles that lines may meet after t = `from` and before t = `to`; near and far ends are
    /// equal.
    #[inline(always)]
    pub fn chords<N: Number>(&self, probe: &Probe<N>, from: Lanes, to: Lanes) -> Chords {
        let splat = Lanes::splat;
        let direction = probe.directions();
        let [ab, ac] = self.edges;
        let s = probe.origins() - self.corner;
        // Volumes: six times those of the tetrahedra between a piece of the line and an edge, and between that piece
        // and the triangle. The line meets the triangle if the three of the edges have the same sign.
        let p = direction.cross(ac);
        let q = s.cross(ab);
        let (whole, second, third) = (ab.dot(p), s.dot(p), direction.dot(q));
        let first = whole - second - third;
        let pace = probe.pace.wide();
        let reach = probe.reach.wide() + self.extent;
        let off = splat(RIM) * reach + splat(8.0) * probe.slack.wide();
        let hair = pace * self.width * off;
        let least = first.fast_min(second).fast_min(third);
        let greatest = first.fast_max(second).fast_max(third);
        let beside = is_less(least, -hair) & is_greater(greatest, hair);
        let open = !beside.to_bitmask() & self.present;
        if open == 0 {
            return Chords::NONE;
        }
        let per_whole = splat(1.0) / whole;
        let t = ac.dot(q) * per_whole;
        let size = splat(SHARE) * (reach + t.abs() * pace) + splat(4.0) * probe.slack.wide();
        let error = self.width * self.width * size * per_whole.abs();
        // Written so that NaN counts as ahead.
        let passed = is_at_most(t + error, from) | is_at_most(to, t - error);
        Chords {
            maybe: open & !passed.to_bitmask(),
            sure: (is_greater(least, hair) | is_less(greatest, -hair)).to_bitmask(),
            near: t,
            far: t,
        }
    }
}

/// Bounds on the errors of the places `t` where lines meet a triangle with these numbers: see
/// [`Kind::Triangle`](super::leaf::Kind::Triangle).
#[inline(always)]
pub fn rough<N: Number>(probe: &Probe<N>, numbers: &[f64; 8], extent: f64, t: N) -> N {
    let number = N::splat;
    let [a, b, c, stretch, ..] = *numbers;
    let [x, y, z] = probe.direction;
    let across = (number(a) * x + number(b) * y + number(c) * z).abs();
    let size = probe.reach + number(extent) + t.abs() * probe.pace;
    (number(SHARE * stretch) * size + number(4.0) * probe.slack) / across
}

/// The points where lines meet triangles, given by their vertices and unit normals.
#[inline(always)]
pub fn resolve(origin: V3, direction: V3, vertices: [V3; 3], normal: V3) -> Resolved {
    let splat = Lanes::splat;
    let shear = Shear::along(direction);
    let facet = Facet::new(each(vertices, |vertex| shear.project(vertex - origin)));
    let t = facet.depth(facet.weights()) / shear.pace;
    // The shape scales other corners before it computes their edge functions.
    let widest = facet.widest();
    let is_comfortable =
        is_greater(widest, splat(1.0 / 4294967296.0)) & is_less(widest, splat(4294967296.0));

    let p = origin + direction * t;
    let point = p - normal * normal.dot(p - vertices[0]);
    let noise = splat(gamma(6)) * normal.abs().dot(p.abs() + vertices[0].abs());
    Resolved {
        clear: facet.is_passed() & is_comfortable & is_less(t.abs(), splat(f64::INFINITY)),
        t,
        point,
        error: normal.abs() * noise + point.abs() * splat(UNIT_ROUNDOFF),
        normal,
    }
}

impl Meet for Triangles {
    const IS_SMOOTH: bool = true;

    #[inline(always)]
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, _: Lanes) -> Resolved {
        let corners = each(leaves, Leaf::corners);
        let vertices = each([0, 1, 2], |i: usize| {
            V3::gathered(corners, |corners| &corners[i].0)
        });
        let normal = V3::gathered(leaves, Leaf::first);
        resolve(origin, direction, vertices, normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dd::Dd;
    use crate::geometry::line::Line;
    use crate::scene::TriangleNormals;
    use crate::trace::kernel::leaf::{Form, of_triangle};
    use crate::trace::kernel::tests::numbers;
    use crate::trace::shapes::triangle::Triangle;
    use crate::trace::shapes::{Intersect, Roots};

    /// What is said without doubt is what the shape finds: a line that is beside crosses nothing, and the shape is sure
    /// of a line that surely crosses, and finds the same place. Lines are aimed anywhere, at edges, at vertices, a hair
    /// beside them, and along the triangle.
    #[test]
    fn lines_that_are_told_apart_are_told_right() {
        let mut number = numbers();
        let [mut told, mut met, mut lines] = [0; 3];
        for i in 0..200_000 {
            let mut vector = || Vec3::new(number(), number(), number());
            let [at, b, c, from, aim] = [vector(), vector(), vector(), vector(), vector()];
            let size = [1.0, 1e-3, 1e3][i % 3];
            let far = [1.5, 30.0, 1e4][i / 3 % 3];
            let corners = [at, at + b, at + c].map(|v| v * size);
            let triangle = Triangle::new(corners.map(|v| v.0), TriangleNormals::Flat);
            let Some((_, numbers, Form::Triangle(vertices))) = of_triangle(&triangle) else {
                continue;
            };
            let share = [0.0, 1.0, aim[0].abs(), 0.5 * aim[0].abs()][i / 9 % 4];
            let hair = [0.0, 1e-16, 1e-13, 1e-10, 1e-3][i / 36 % 5];
            let target = match i % 7 {
                0 => at + aim,
                1..=3 => at + b * share + aim * hair,
                _ => at + b * aim[0].abs() + c * (aim[1].abs() * (1.0 - aim[0].abs())) + aim * hair,
            } * size;
            let origin = match i % 11 {
                // In the triangle's plane, but for rounding.
                0 => (at + b * 3.0 + c * (2.0 * aim[2])) * size,
                _ => target + from * (far * size),
            };
            let line = Line::new(origin, target - origin);
            if !line.direction.any() {
                continue;
            }
            let everywhere = [f64::NEG_INFINITY, f64::INFINITY].map(Lanes::splat);
            let [least, most] = everywhere;
            let probe = Probe::new(&line);
            let chords = Triangles::new(&[&vertices]).chords(&probe, least, most);
            let extent = vertices
                .iter()
                .fold(0.0, |most: f64, v| v.abs().max_component().max(most));
            let (mut roots, mut exact) = (Roots::default(), Roots::default());
            Intersect::<f64>::crossings(&triangle, &line, &mut roots);
            Intersect::<Dd>::crossings(&triangle, &line.cast(), &mut exact);
            assert_eq!(chords.maybe >> 1, 0);
            lines += 1;
            if chords.maybe & 1 == 0 {
                assert!(exact.list.is_empty(), "{corners:?} {line:?} {chords:?}");
                told += 1;
            } else if chords.sure & 1 != 0 {
                let [root] = roots.list[..] else {
                    panic!("{corners:?} {line:?} {chords:?}");
                };
                assert!(!roots.uncertain, "{corners:?} {line:?} {chords:?}");
                let t = chords.near.to_array()[0];
                let error = rough(&probe, &numbers, extent, t);
                assert!(
                    (t - root.t).abs() <= error,
                    "{corners:?} {line:?} {t} {error}"
                );
                [told, met] = [told + 1, met + 1];
            }
        }
        // Many lines are aimed at edges.
        assert!(told * 10 > lines * 6, "{told} of {lines}");
        assert!(met * 10 > lines * 3, "{met} of {lines}");
    }
}
