use super::super::facet::lift;
use super::super::facet::tests::{Random, solve, wild_line};
use super::*;
use std::collections::BTreeMap;

fn roots<R: Traced>(sphere: &GeodesicSphere, line: &Line<R>) -> Roots<R> {
    let mut roots = Roots::default();
    sphere.crossings(line, &mut roots);
    for pair in roots.list.windows(2) {
        assert!(pair[0].t < pair[1].t);
    }
    assert!(!roots.inside && [0, 2].contains(&roots.list.len()));
    roots
}

fn in_kind<R: Traced>(line: &Line) -> Line<R> {
    Line::new(lift(line.origin), lift(line.direction))
}

/// The facets by the definition: a list of vertices, the triples of nearest ones, and lists of
/// edges that are halved.
fn mesh(splits: u32) -> (Vec<Vec3<Dd>>, Vec<[usize; 3]>) {
    let phi = (Dd::ONE + Dd::of(5.0).sqrt()) / Dd::of(2.0);
    let mut vertices = Vec::new();
    for i in 0..3 {
        for (one, long) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let v = [Dd::ZERO, Dd::of(one), phi * Dd::of(long)];
            vertices.push(Vec3([v[i], v[(i + 1) % 3], v[(i + 2) % 3]]).unit());
        }
    }
    let apart = |a: usize, b: usize| (vertices[a] - vertices[b]).length().to_f64();
    let edge = (1..12).map(|b| apart(0, b)).fold(f64::INFINITY, f64::min);
    let joined = |a: usize, b: usize| a < b && apart(a, b) < edge * 1.001;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in 0..12 {
            for c in 0..12 {
                if joined(a, b) && joined(b, c) && joined(a, c) {
                    faces.push([a, b, c]);
                }
            }
        }
    }
    for _ in 0..splits {
        let mut middles = BTreeMap::new();
        let mut next = Vec::new();
        for [a, b, c] in faces {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| {
                *middles.entry((p.min(q), p.max(q))).or_insert_with(|| {
                    vertices.push((vertices[p] + vertices[q]).unit());
                    vertices.len() - 1
                })
            });
            next.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        faces = next;
    }
    (vertices, faces)
}

#[test]
fn has_the_facets_of_the_definition() {
    for splits in 0..=3 {
        let sphere = GeodesicSphere::new(1.0, splits);
        let (vertices, faces) = mesh(splits);
        let count = 20 * 4usize.pow(splits);
        assert_eq!(faces.len(), count);
        // Euler: V = E − F + 2 with 3F = 2E.
        assert_eq!(vertices.len(), count / 2 + 2);
        let key = |corners: [Vec3; 3]| {
            let mut key = corners.map(|c| c.0.map(|x| (x * 1e9).round() as i64));
            key.sort();
            key
        };
        let mut expected: Vec<_> = faces
            .iter()
            .map(|f| key(f.map(|i| Vec3(vertices[i].0.map(narrow)))))
            .collect();
        let mut found: Vec<_> = (0..count as u32)
            .map(|face| key(sphere.corners(face)))
            .collect();
        expected.sort();
        found.sort();
        assert_eq!(found, expected);
        for face in 0..count as u32 {
            let [a, b, c] = sphere.corners::<f64>(face);
            let n = (b - a).cross(c - a).unit();
            assert!(n.dot(a) > 0.0);
            // Convex: all other vertices are behind the facet, and by more than rounding.
            for v in &vertices {
                let v: Vec3 = Vec3(v.0.map(narrow));
                let corner = [a, b, c].iter().any(|&c| (c - v).length() < 1e-9);
                assert!(corner || n.dot(v - a) < -1e-6);
            }
        }
    }
}

/// Every edge is convex, so the whole is: the far corner of the neighbour lies behind the facet.
/// Neighbours across a facet's own split, at all depths.
#[test]
fn is_convex_at_every_depth() {
    let mut random = Random(6);
    for splits in 1..=MAX_SPLITS {
        let sphere = GeodesicSphere::new(1.0, splits);
        for _ in 0..2000 {
            let parent = random.next() as u32 % (20 << (2 * (splits - 1)));
            let [a, b, c] = sphere.corners::<Dd>(4 * parent + 3);
            let n = (b - a).cross(c - a);
            for corner in 0..3 {
                for v in sphere.corners::<Dd>(4 * parent + corner) {
                    let shared = [a, b, c].contains(&v);
                    assert!(shared || n.dot(v - a) < Dd::ZERO);
                }
            }
        }
    }
}

#[test]
fn agrees_with_all_facets_one_by_one() {
    let mut random = Random(7);
    for (splits, rays) in [(0, 4000), (1, 1500), (2, 500), (3, 150)] {
        let (vertices, faces) = mesh(splits);
        let mut met = 0;
        for i in 0..rays {
            let radius = random.length(-3.0, 3.0);
            let scaled = |v: Vec3<Dd>| v * Dd::of(radius);
            let sphere = GeodesicSphere::new(radius, splits);
            let away = radius * random.length(0.0, [0.0, 3.0, 6.0][i % 3]);
            let target = random.point(radius * 0.8);
            let direction = random.point(1.0).unit() * random.length(-6.0, 6.0);
            let line = Line::new(target - direction.unit() * away, direction);
            let mut expected: Vec<Dd> = faces
                .iter()
                .filter_map(|f| solve(&line, f.map(|i| scaled(vertices[i]))))
                .filter(|(_, least)| *least >= Dd::ZERO)
                .map(|(t, _)| t)
                .collect();
            expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
            let found = roots(&sphere, &line);
            let exact = roots::<Dd>(&sphere, &in_kind(&line));
            assert_eq!(exact.list.len(), expected.len());
            if found.uncertain {
                continue;
            }
            assert_eq!(found.list.len(), expected.len());
            for ((f, e), t) in found.list.iter().zip(&exact.list).zip(&expected) {
                assert_eq!(f.face, e.face);
                let corners = sphere.corners::<f64>(f.face);
                let [a, b, c] = corners;
                let n = (b - a).cross(c - a).unit();
                // The point on the plane: off by the rounding of the line, over its steepness.
                let steep = n.dot(direction.unit()).abs();
                let bound = 32.0 * f64::EPSILON * (away + 4.0 * radius) / steep;
                let bound = bound / direction.length();
                let off = (Dd::of(f.t) - *t).abs().to_f64();
                assert!(
                    off <= bound,
                    "{splits}: {off:e} {bound:e} {steep:e} {away:e} {radius:e}"
                );
                assert!((e.t - *t).abs().to_f64() <= bound * 1e-9);
                let located: Located = sphere.locate(&line, *f);
                let off = lift::<Dd>(located.point) - scaled(sphere.corners::<Dd>(f.face)[0]);
                assert!(off.dot(lift(n)).abs().to_f64() <= located.error.dot(n.abs()));
                assert!(located.normal.dot(n) > 0.0);
                met += 1;
            }
        }
        assert!(met > rays / 2, "{met} of {rays}");
    }
}

/// Row 36: lines through a corner, an edge and a point inside the solid always cross it, once in
/// and once out, in every kind of number.
#[test]
fn nothing_slips_between_facets() {
    fn check<R: Traced>(random: &mut Random, far: f64) {
        for splits in 0..=MAX_SPLITS {
            let radius = random.length(-3.0, 3.0);
            let sphere = GeodesicSphere::new(radius, splits);
            for i in 0..400 {
                let face = random.next() as u32 % (20 << (2 * splits));
                let [a, b, _] = sphere.corners::<f64>(face);
                let along = [0.0, 0.5, random.within(0.0, 1.0)][i % 3];
                let target = (a + (b - a) * along) * radius;
                let inner = random.point(radius * 0.4);
                let out = (target - inner) * random.length(-1.0, far);
                let line = Line::new(target + out, (inner - target) * random.length(-6.0, 6.0));
                assert_eq!(roots(&sphere, &in_kind::<R>(&line)).list.len(), 2);
                // The other end of the axis through it.
                let axis = Line::new(target * 3.0, -target);
                let list = roots(&sphere, &in_kind::<R>(&axis)).list;
                assert_eq!(list.len(), 2);
            }
        }
    }
    check::<f32>(&mut Random(8), 2.0);
    check::<f64>(&mut Random(8), 6.0);
    check::<Dd>(&mut Random(8), 6.0);
}

/// A vertex of the icosahedron, r · (0, 1, φ) / √(1 + φ²), and the centre of an edge, (0, 0, ±1).
#[test]
fn known_crossings() {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let long = phi / (1.0 + phi * phi).sqrt();
    let along = |sphere: &GeodesicSphere| {
        let line = Line::new(Vec3::new(0.0, 0.0, 5.0), Vec3::new(0.0, 0.0, -1.0));
        let list = roots(sphere, &line).list;
        [list[0].t, list[1].t]
    };
    // The middle of an edge is at height φ / √(1 + φ²); once split, on the sphere.
    for (found, expected) in along(&GeodesicSphere::new(1.0, 0))
        .into_iter()
        .zip([5.0 - long, 5.0 + long])
    {
        assert!((found - expected).abs() < 4.0 * f64::EPSILON * 5.0);
    }
    for splits in 1..=MAX_SPLITS {
        assert_eq!(along(&GeodesicSphere::new(1.0, splits)), [4.0, 6.0]);
    }
    // Of the facets on both sides of an edge, 0 and 2 above, 5 and 6 below, the first one is met.
    let line = Line::new(Vec3::new(0.0, 0.0, 5.0), Vec3::new(0.0, 0.0, -1.0));
    for line in [line, Line::new(-line.origin, -line.direction)] {
        let mut faces: Vec<u32> = (roots(&GeodesicSphere::new(1.0, 0), &line).list)
            .iter()
            .map(|root| root.face)
            .collect();
        faces.sort_unstable();
        assert_eq!(faces, [0, 5]);
    }
}

/// Row 38: a scale by a power of two changes no bit, and no other scale a decision.
#[test]
fn scale_does_not_matter() {
    let mut random = Random(9);
    let one = GeodesicSphere::new(1.0, 4);
    for _ in 0..500 {
        let line = Line::new(random.point(3.0), random.point(1.0));
        let plain = roots(&one, &line);
        for scale in [1e-6, 1e6, 0.5f64.powi(20), 2f64.powi(600)] {
            let sphere = GeodesicSphere::new(scale, 4);
            let moved = Line::new(line.origin * scale, line.direction * scale);
            let found = roots(&sphere, &moved);
            if scale.log2().fract() == 0.0 {
                assert_eq!(found.list, plain.list);
            }
            if plain.uncertain || found.uncertain {
                continue;
            }
            assert_eq!(found.list.len(), plain.list.len());
            for (f, p) in found.list.iter().zip(&plain.list) {
                let [a, b, c] = one.corners::<f64>(p.face);
                let steep = (b - a).cross(c - a).unit().dot(line.direction).abs();
                // Lengths up to 6, a few roundings.
                let bound = 6.0 * 32.0 * f64::EPSILON / steep;
                assert!(
                    (f.t - p.t).abs() <= bound,
                    "{f:?} {p:?} {bound:e} {steep:e}"
                );
            }
        }
    }
}

/// Lines that pass the outline within rounding say so; lines that do not, do not.
#[test]
fn doubts_what_rounding_may_change() {
    let mut random = Random(10);
    for splits in 0..=MAX_SPLITS {
        let sphere = GeodesicSphere::new(1.0, splits);
        let mut doubted = 0;
        for _ in 0..1000 {
            let line = Line::new(random.point(3.0), random.point(1.0));
            doubted += usize::from(roots(&sphere, &line).uncertain);
        }
        assert_eq!(doubted, 0);
        // Through an edge of the outline: the x axis is perpendicular to the line.
        let vertex = sphere.icosahedron::<f64>()[0];
        let touch = Line::new(vertex + Vec3::new(5.0, 0.0, 0.0), Vec3::new(-1.0, 0.0, 0.0));
        assert!(roots(&sphere, &touch).uncertain);
    }
}

#[test]
fn no_line_yields_a_root_that_is_not_finite() {
    fn check<R: Traced>(random: &mut Random) {
        for i in 0..5_000 {
            let sphere = GeodesicSphere::new(random.length(-300.0, 300.0), i % 4);
            let line = wild_line::<R>(random);
            if !line.direction.any() || !line.direction.is_finite() || !line.origin.is_finite() {
                continue;
            }
            for root in roots(&sphere, &line).list {
                assert!(root.t.is_finite());
                let located = sphere.locate(&line, root);
                assert!(located.point.is_finite() && located.normal.any());
            }
        }
    }
    check::<f32>(&mut Random(11));
    check::<f64>(&mut Random(11));
    check::<Dd>(&mut Random(11));
}

#[test]
fn surface_coordinates_are_the_spheres() {
    let sphere = GeodesicSphere::new(2.0, 1);
    assert_eq!(sphere.uv(Vec3::new(0.0, 0.0, -1.9), 0), [0.25, 0.5]);
    assert_eq!(sphere.uv(Vec3::new(0.0, 1.9, 0.0), 0)[1], 1.0);
    assert_eq!(sphere.uv(Vec3::new(0.0, -1.9, 0.0), 0)[1], 0.0);
}
