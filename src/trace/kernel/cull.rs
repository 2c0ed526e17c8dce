//! A test for four rays at once: which of them surely miss a shape, and which surely go through it. Only about the
//! others the shape itself is asked, ray by ray.
//!
//! In the shape's space the box around the shape cuts a piece out of each ray. On this piece the polynomial of the
//! shape's [`Outline`] is written in Bernstein's form. If no coefficient of either half is below a margin, the ray
//! misses the shape. The margins are those of [`quick_reject`](crate::trace::shapes::quick_reject), far above all
//! rounding. For a solid of revolution [`profile`] tells which pieces of the profile are crossed.

use super::lanes::{ALL, LANES, Lanes, V3, either, is_at_most, is_greater, is_less};
use super::maps::Maps;
use super::profile;
use super::way_in::{REL_ROUNDED, WayIn};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::quick_reject::{LINE_REL_ERROR, POLYNOMIAL_MARGIN};

/// A shape, and the way into its space.
#[derive(Debug, Clone)]
pub struct Cull {
    way: WayIn,
    /// The bounds of the shape, made larger by some room.
    around: Aabb,
    /// The bounds of the shape, made smaller by the same room.
    within: Aabb,
    outline: Outline,
    /// The largest coordinate in the bounds, in size.
    reach: f64,
    /// A value of the polynomial that is nearer to zero than this may have either sign.
    margin: f64,
}

/// How four rays pass a shape, as bits.
#[derive(Debug, Clone, Copy)]
pub struct Passing {
    /// The rays that surely cross nothing.
    pub beside: u32,
    /// The rays that surely go into the solid, and out of it.
    pub through: u32,
    /// The rays that surely do not meet the solid again if they leave it at their starts.
    pub leaves: u32,
}

impl Passing {
    const BESIDE: Passing = Passing {
        beside: ALL,
        through: 0,
        leaves: 0,
    };
}

impl Cull {
    /// Sets up the test for a shape below a chain of placements. `None` for a shape without bounds, and for unusual
    /// numbers.
    pub fn new(graph: &Graph, chain: &[u32], bounds: &Aabb, outline: Outline) -> Option<Cull> {
        let way = WayIn::new(graph, chain);
        let reach = bounds.reach();
        let margin = POLYNOMIAL_MARGIN
            * match &outline.form {
                Form::Constant => 1.0,
                Form::Quadric(c) => {
                    let sizes = |from: usize, to: usize| c[from..to].iter().map(|x| x.abs()).sum();
                    let [second, first, constant]: [f64; 3] =
                        [sizes(0, 6), sizes(6, 9), sizes(9, 10)];
                    (second * reach + first) * reach + constant
                }
                Form::Torus([major, minor]) => (major + minor).powi(4),
                Form::Profile(_) => reach * reach,
            };
        let room = Vec3::ONE * (POLYNOMIAL_MARGIN * reach);
        let [min, max] = [Vec3(bounds.min), Vec3(bounds.max)];
        let numbers = [reach, margin, way.sizes[0]];
        let is_usual = numbers.into_iter().all(f64::is_normal) && way.sizes[1].is_finite();
        (bounds.is_bounded() && is_usual).then(|| Cull {
            way,
            around: Aabb::new(min - room, max + room),
            within: Aabb::new(min + room, max - room),
            outline,
            reach,
            margin,
        })
    }

    /// Tells how four rays pass the shape, from t = −`before` to t = `to`.
    #[inline(never)]
    pub fn passing(&self, origin: V3, direction: V3, before: Lanes, to: Lanes) -> Passing {
        let splat = Lanes::splat;
        let back = Maps::gathered([&self.way.back; LANES], |map| map);
        let (o, d) = (back.point(origin), back.vector(direction));
        let inverse = V3(each(d.0, |d| splat(1.0) / d));
        let [near, far] = in_box(&self.around, o, inverse, [-before, to]);
        let [start, pace] = each([origin, direction], |v| v.abs().max_component());
        let size = splat(self.way.sizes[0]) * (start + pace * near.abs().fast_max(far.abs()));
        let error = splat(REL_ROUNDED) * (size + splat(self.way.sizes[1]));
        // The comparisons are written so that NaN leaves a ray undecided.
        let known = is_at_most(error, splat(LINE_REL_ERROR * self.reach));
        let misses = is_greater(near, far);
        let missed = (known & misses).to_bitmask();
        if missed == ALL {
            return Passing::BESIDE;
        }
        let [p, q] = [o + d * near, o + d * far];
        let mut leaves = 0;
        let (least, middle) = match &self.outline.form {
            Form::Constant => (splat(f64::NEG_INFINITY), splat(f64::NEG_INFINITY)),
            Form::Quadric(c) => of_quadric(c, p, q),
            &Form::Torus(radii) => {
                leaves = (known & Cull::is_outer_half(radii, o)).to_bitmask();
                of_torus(radii, p, q)
            }
            Form::Profile(points) => {
                let pace_here = d.abs().max_component();
                let turned = splat(REL_ROUNDED * self.way.sizes[0]) * pace;
                let known = known & is_at_most(turned, splat(LINE_REL_ERROR) * pace_here);
                let known = known.to_bitmask() & ALL;
                let crossed = profile::crossed(points, [p, q], d.over(pace_here), self.reach);
                let ahead = before + splat(POLYNOMIAL_MARGIN * self.reach) / pace_here;
                let is_before = is_less(far, to * splat(1.0 - POLYNOMIAL_MARGIN));
                let is_between = is_greater(near, ahead) & is_before;
                let beside = missed | (known & crossed.none);
                return Passing {
                    beside,
                    through: known & crossed.some & is_between.to_bitmask() & !beside,
                    leaves: known & crossed.at_most_one,
                };
            }
        };
        let beside = missed | (known & is_greater(least, splat(self.margin))).to_bitmask();
        if !self.outline.is_exact {
            return Passing {
                beside,
                through: 0,
                leaves,
            };
        }
        let half = splat(0.5);
        let (at, t) = ((p + q) * half, (near + far) * half);
        let mut through = known & is_less(middle, splat(-self.margin));
        for i in 0..3 {
            through = through
                & is_greater(at.0[i], splat(self.within.min[i]))
                & is_less(at.0[i], splat(self.within.max[i]));
        }
        let ahead = before + splat(POLYNOMIAL_MARGIN * self.reach) / d.abs().max_component();
        through =
            through & is_greater(t, ahead) & is_less(far, to * splat(1.0 - POLYNOMIAL_MARGIN));
        Passing {
            beside,
            through: through.to_bitmask() & !beside,
            leaves,
        }
    }

    /// Whether points on a torus are on its outer half: there the whole torus is on one side of the tangent plane.
    fn is_outer_half([major, minor]: [f64; 2], at: V3) -> Lanes {
        let size = major + minor;
        let most = match minor <= major {
            true => major * major + POLYNOMIAL_MARGIN * size * size,
            false => f64::INFINITY,
        };
        let [x, _, z] = at.0;
        is_greater(x * x + z * z, Lanes::splat(most))
    }
}

/// The t at which each of four rays enters a box, and the t at which it leaves, both cut to the stretch between `from`
/// and `to`. A ray misses the box if the first exceeds the second. `inverse` holds the reciprocals of the directions.
#[inline(always)]
pub fn in_box(bounds: &Aabb, origin: V3, inverse: V3, [from, to]: [Lanes; 2]) -> [Lanes; 2] {
    let (mut near, mut far) = (from, to);
    for i in 0..3 {
        let low = (Lanes::splat(bounds.min[i]) - origin.0[i]) * inverse.0[i];
        let high = (Lanes::splat(bounds.max[i]) - origin.0[i]) * inverse.0[i];
        near = low.fast_min(high).fast_max(near);
        far = low.fast_max(high).fast_min(far);
    }
    [near, far]
}

/// The least Bernstein coefficient of a quadric on the two halves of the piece from p to q, and the value in the middle
/// of the piece.
#[inline(always)]
fn of_quadric(c: &[f64; 10], p: V3, q: V3) -> (Lanes, Lanes) {
    let [xx, yy, zz, xy, xz, yz, x, y, z, one] = each(*c, Lanes::splat);
    let half = Lanes::splat(0.5);
    // The polar form of the polynomial gives Bernstein's coefficients.
    let polar = |[a, b, c]: [Lanes; 3], [u, v, w]: [Lanes; 3]| {
        let square = xx * a * u + yy * b * v + zz * c * w;
        let mixed = xy * (a * v + b * u) + xz * (a * w + c * u) + yz * (b * w + c * v);
        let linear = x * (a + u) + y * (b + v) + z * (c + w);
        square + half * (mixed + linear) + one
    };
    let ends = [polar(p.0, p.0), polar(p.0, q.0), polar(q.0, q.0)];
    let [a, b] = [half * (ends[0] + ends[1]), half * (ends[1] + ends[2])];
    let middle = half * (a + b);
    let least = ends[0]
        .fast_min(a)
        .fast_min(middle)
        .fast_min(b)
        .fast_min(ends[2]);
    (numbers(least, ends[0] + ends[1] + ends[2]), middle)
}

/// Like [`of_quadric`], for the quartic of a torus.
#[inline(always)]
fn of_torus([major, minor]: [f64; 2], p: V3, q: V3) -> (Lanes, Lanes) {
    let splat = Lanes::splat;
    let k = splat((major - minor) * (major + minor));
    let s = [p.dot(p) + k, p.dot(q) + k, q.dot(q) + k];
    let flat = |a: V3, b: V3| a.0[0] * b.0[0] + a.0[2] * b.0[2];
    let e = [flat(p, p), flat(p, q), flat(q, q)];
    let four = splat(4.0 * major * major);
    let [third, half, sixth] = [1.0 / 3.0, 0.5, 1.0 / 6.0].map(splat);
    let mut row = [
        s[0] * s[0] - four * e[0],
        s[0] * s[1] - four * half * (e[0] + e[1]),
        third * (s[0] * s[2] + (s[1] + s[1]) * s[1])
            - four * sixth * (e[0] + splat(4.0) * e[1] + e[2]),
        s[1] * s[2] - four * half * (e[1] + e[2]),
        s[2] * s[2] - four * e[2],
    ];
    let sum = row[0] + row[1] + row[2] + row[3] + row[4];
    // De Casteljau's algorithm splits the piece in the middle.
    let mut least = row[0].fast_min(row[4]);
    for last in (1..5).rev() {
        for i in 0..last {
            row[i] = half * (row[i] + row[i + 1]);
        }
        least = least.fast_min(row[0]).fast_min(row[last - 1]);
    }
    (numbers(least, sum), row[0])
}

/// The lanes, with NaN in place of those where `sum` is NaN or infinite.
#[inline(always)]
fn numbers(lanes: Lanes, sum: Lanes) -> Lanes {
    either(
        is_less(sum.abs(), Lanes::splat(f64::INFINITY)),
        lanes,
        Lanes::splat(f64::NAN),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Matrix;
    use crate::geometry::line::Line;
    use crate::scene::Geometry;
    use crate::trace::kernel::tests::{numbers, placed_by};
    use crate::trace::shapes::{Primitive, Roots};

    fn shapes() -> Vec<Primitive> {
        let quadric = [
            2.0, 0.0, 0.0, 0.3, 0.0, 1.5, 0.4, 0.0, 0.0, 0.4, 3.0, 0.0, 0.3, 0.0, 0.0, -1.0,
        ];
        let geometries = [
            Geometry::Revolution {
                profile: vec![[0.1, -1.0], [0.7, -0.4], [0.2, 0.3], [0.5, 0.9]],
                colours: Vec::new(),
            },
            Geometry::Triangle {
                vertices: Box::new([[0.0; 3], [1.0, 0.2, 0.1], [0.3, 0.9, -0.4]]),
                normals: crate::scene::TriangleNormals::Flat,
            },
            Geometry::Sphere {
                centre: [0.3, -0.2, 0.1],
                radius: 0.7,
            },
            Geometry::Ellipsoid {
                semi_axes: [0.9, 0.5, 0.2],
            },
            Geometry::Box {
                min: [-0.6, -0.5, -0.4],
                max: [0.6, 0.5, 0.1],
            },
            Geometry::GeodesicSphere {
                radius: 0.8,
                splits: 2,
            },
            Geometry::Torus {
                major: 0.8,
                minor: 0.3,
            },
            Geometry::Torus {
                major: 0.4,
                minor: 0.6,
            },
            Geometry::Quadric(Box::new(quadric)),
            Geometry::Cone {
                height: 0.9,
                radius: 0.5,
            },
            Geometry::DoubleCone {
                height: 0.7,
                radius: 0.4,
            },
        ];
        geometries.iter().map(Primitive::new).collect()
    }

    /// Answers about rays are what the shape itself finds. Most rays that miss a shape get one, and most that go
    /// through one with an exact outline.
    #[test]
    fn rays_that_are_told_apart_are_told_right() {
        let mut number = numbers();
        for shape in shapes() {
            let [mut beside, mut through, mut missed, mut met] = [0; 4];
            for i in 0..20_000 {
                let mut vector = || Vec3::new(number(), number(), number());
                let [o, to, x, y] = [vector() * 2.5, vector(), vector(), vector()];
                let out = Matrix::translation(x[0], x[1], x[2])
                    .after(&Matrix::rotation(360.0 * y[0], i % 3))
                    .after(&Matrix::rotation(360.0 * y[1], (i + 1) % 3))
                    .after(&Matrix::scaling(1.0, 1.5 + y[2], 1.0));
                let graph = placed_by(&out);
                let chain: &[u32] = if i % 2 == 0 { &[] } else { &[0] };
                let (bounds, outline) = (shape.shape().bounds(), shape.shape().outline());
                let cull = Cull::new(&graph, chain, &bounds, outline).expect("usual numbers");
                let line = Line::new(o, (to - o) * (1.0 + x[1].abs()));
                let passing = cull.passing(
                    V3::splat(line.origin),
                    V3::splat(line.direction),
                    Lanes::ZERO,
                    Lanes::splat(1.0),
                );
                let mut roots = Roots::default();
                let own = chain
                    .iter()
                    .fold(line, |line, _| line.through(&graph.placements[0].back));
                shape.intersect::<f64>().crossings(&own, &mut roots);
                let ahead = roots
                    .list
                    .iter()
                    .filter(|root| (0.0..=1.0).contains(&root.t))
                    .count();
                match passing {
                    Passing {
                        beside: ALL,
                        through: 0,
                        ..
                    } => {
                        assert_eq!(ahead, 0, "{shape:?} {line:?}");
                        beside += 1;
                    }
                    Passing {
                        beside: 0,
                        through: ALL,
                        ..
                    } => {
                        assert!(ahead > 0, "{shape:?} {line:?} {roots:?}");
                        through += 1;
                    }
                    Passing {
                        beside: 0,
                        through: 0,
                        ..
                    } => {}
                    odd => panic!("{odd:?}"),
                }
                missed += u32::from(ahead == 0);
                met += u32::from(ahead > 1);
            }
            assert!(beside > missed * 6 / 10, "{shape:?}: {beside} of {missed}");
            let is_exact = shape.shape().outline().is_exact;
            assert_eq!(through > met / 2, is_exact, "{shape:?}: {through} of {met}");
        }
    }
    /// A ray that is said to leave a solid for good does not meet it again, and most that do not are said to.
    #[test]
    fn rays_that_leave_for_good() {
        let mut number = numbers();
        let solids = shapes()
            .into_iter()
            .filter(|s| matches!(s.shape().outline().form, Form::Torus(_) | Form::Profile(_)));
        for (i, solid) in solids.enumerate() {
            let graph = Graph::default();
            let (bounds, outline) = (solid.shape().bounds(), solid.shape().outline());
            let cull = Cull::new(&graph, &[], &bounds, outline).expect("usual numbers");
            let [mut told, mut all] = [0; 2];
            for _ in 0..20_000 {
                let mut vector = || Vec3::new(number(), number(), number());
                let [o, to] = [vector() * 2.5, vector()];
                let line = Line::new(o, to - o);
                let mut roots = Roots::default();
                solid.intersect::<f64>().crossings(&line, &mut roots);
                // From each way out on.
                for out in (1..roots.list.len()).step_by(2) {
                    let start = line.at(roots.list[out].t);
                    let [o, d] = [start, line.direction].map(V3::splat);
                    let leaves = cull
                        .passing(o, d, Lanes::splat(1e-9), Lanes::splat(1.0))
                        .leaves;
                    let is_last = out + 1 == roots.list.len();
                    assert!(
                        leaves == 0 || leaves == ALL && is_last,
                        "{solid:?} {line:?}"
                    );
                    told += u32::from(leaves == ALL);
                    all += u32::from(is_last);
                }
            }
            // All of the torus that runs through itself is left to the arbiter.
            let least = [9, 5, 0][i];
            assert!(told * 10 >= all * least, "{solid:?}: {told} of {all}");
        }
    }
}
