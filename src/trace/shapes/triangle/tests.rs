use super::super::facet::tests::{Random, solve, wild_line};
use super::*;

fn flat(vertices: [Vec3; 3]) -> Triangle {
    Triangle::new(vertices.map(|v| v.0), TriangleNormals::Flat)
}

fn roots<R: Traced>(triangle: &Triangle, line: &Line<R>) -> Roots<R> {
    let mut roots = Roots::default();
    triangle.crossings(line, &mut roots);
    roots
}

fn in_kind<R: Traced>(line: &Line) -> Line<R> {
    Line::new(lift(line.origin), lift(line.direction))
}

/// Against Möller and Trumbore's solution in 32 digits, wherever that is clear.
#[test]
fn agrees_with_the_solution_of_the_equations() {
    let mut random = Random(2);
    let mut met = 0;
    for i in 0..20_000 {
        let size = random.length(-3.0, 3.0);
        let vertices = [0; 3].map(|_| random.point(size));
        let target = (vertices[0] + vertices[1] + vertices[2]) / 3.0 + random.point(size);
        let away = size * random.length(0.0, [0.0, 3.0, 6.0][i % 3]);
        let direction = random.point(1.0).unit() * random.length(-6.0, 6.0);
        let line = Line::new(target - direction.unit() * away, direction);
        let triangle = flat(vertices);
        let Some((t, least)) = solve(&line, vertices.map(lift)) else {
            continue;
        };
        let found = roots(&triangle, &line);
        let exact = roots::<Dd>(&triangle, &in_kind(&line));
        assert_eq!(exact.list.len(), usize::from(least >= Dd::ZERO));
        if !found.uncertain {
            assert_eq!(found.list.len(), exact.list.len());
        }
        let [Root { t: found, face }] = found.list[..] else {
            continue;
        };
        if exact.list.is_empty() {
            continue;
        }
        met += 1;
        // t from the depth, which has the rounding of v − o and the weights behind it; the flatter
        // the line to the triangle the more of it.
        let normal: Vec3 = Vec3(triangle.normal.unwrap().0.map(narrow));
        let steep = normal.dot(direction.unit()).abs();
        let bound = 16.0 * f64::EPSILON * (away + 4.0 * size) / direction.length() / steep;
        assert!((Dd::of(found) - t).abs().to_f64() <= bound.max(1e-300));
        assert!((exact.list[0].t - t).abs().to_f64() <= bound * 1e-9);
        // The point is where the line meets the plane, within its error box along the normal.
        let located: Located = triangle.locate(&line, Root { t: found, face });
        let off = lift::<Dd>(located.point) - lift(vertices[0]);
        let off = off.dot(triangle.normal.unwrap()).abs().to_f64();
        assert!(off <= located.error.dot(normal.abs()));
    }
    assert!(met > 1_000, "{met}");
}

/// Row 35: vertices on one line, or all the same.
#[test]
fn degenerate_triangles_are_never_met() {
    let p = Vec3::new;
    let mut random = Random(3);
    for vertices in [
        [p(0.0, 0.0, 0.0); 3],
        [p(0.1, 0.2, 0.3); 3],
        [p(0.0, 0.0, 0.0), p(1.0, 1.0, 1.0), p(3.0, 3.0, 3.0)],
        [p(0.1, 0.2, 0.3), p(0.1, 0.2, 0.3), p(1.0, 5.0, -1.0)],
        [p(0.1, 0.1, 0.1), p(0.2, 0.2, 0.2), p(0.7, 0.7, 0.7)],
        [p(1e300, 0.0, 0.0), p(-1e300, 0.0, 0.0), p(1e308, 0.0, 0.0)],
    ] {
        let triangle = flat(vertices);
        for _ in 0..200 {
            let target = vertices[0] * 0.5 + vertices[2] * 0.5;
            let direction = random.point(1.0);
            let line = Line::new(target - direction * 3.0, direction);
            assert!(roots(&triangle, &line).list.is_empty());
            assert!(roots::<Dd>(&triangle, &in_kind(&line)).list.is_empty());
        }
        assert!(triangle.uv(vertices[0], 0).iter().all(|x| x.is_finite()));
    }
}

#[test]
fn no_line_yields_a_root_that_is_not_finite() {
    fn check<R: Traced>(random: &mut Random) {
        for _ in 0..5_000 {
            let vertices = [0; 3].map(|_| wild_line::<f64>(random).origin);
            let triangle = flat(vertices);
            let line = wild_line::<R>(random);
            if !line.direction.any() || !line.direction.is_finite() || !line.origin.is_finite() {
                continue;
            }
            for root in roots(&triangle, &line).list {
                assert!(root.t.is_finite());
            }
        }
    }
    check::<f32>(&mut Random(4));
    check::<f64>(&mut Random(4));
    check::<Dd>(&mut Random(4));
}

/// A closed cone of triangles around its tip: every line from above through the tip, through an
/// edge or through any point of the disc meets at least one of them.
#[test]
fn nothing_slips_between_triangles() {
    fn check<R: Traced>(random: &mut Random) {
        for _ in 0..40 {
            let (n, size) = (4 + random.next() as usize % 12, random.length(-3.0, 3.0));
            let centre = random.point(size * 10.0);
            let rim: Vec<Vec3> = (0..n)
                .map(|i| {
                    let a = TAU * (i as f64 + random.within(0.0, 0.2)) / n as f64;
                    centre + Vec3::new(a.cos(), random.within(-0.1, 0.1), a.sin()) * size
                })
                .collect();
            let tip = centre + Vec3::new(0.0, 0.3, 0.0) * size;
            let fan: Vec<Triangle> = (0..n)
                .map(|i| flat([tip, rim[i], rim[(i + 1) % n]]))
                .collect();
            for i in 0..100 {
                let along = [0.0, random.within(0.0, 0.9)][i % 2];
                let target = tip + (rim[i % n] - tip) * along;
                let origin = centre
                    + (random.point(1.0) + Vec3::new(0.0, 5.0, 0.0))
                        * (size * random.length(0.0, 3.0));
                let direction = (target - origin) * random.length(-6.0, 6.0);
                let line = in_kind::<R>(&Line::new(origin, direction));
                assert!(fan.iter().any(|t| !roots(t, &line).list.is_empty()));
            }
        }
    }
    use std::f64::consts::TAU;
    check::<f32>(&mut Random(5));
    check::<f64>(&mut Random(5));
    check::<Dd>(&mut Random(5));
}

#[test]
fn weights_are_surface_coordinates() {
    let vertices = [
        Vec3::new(1.0, 2.0, 3.0),
        Vec3::new(3.0, 2.0, 3.0),
        Vec3::new(1.0, 2.0, 7.0),
    ];
    let triangle = flat(vertices);
    assert_eq!(triangle.uv(vertices[0], 0), [0.0, 0.0]);
    assert_eq!(triangle.uv(vertices[1], 0), [1.0, 0.0]);
    assert_eq!(triangle.uv(vertices[2], 0), [0.0, 1.0]);
    assert_eq!(triangle.uv(Vec3::new(1.5, 2.0, 5.0), 0), [0.25, 0.5]);
}

#[test]
fn shading_normals_are_interpolated() {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |normals, x, y| {
        Triangle::new(corners, normals)
            .shading_normal(Vec3::new(x, y, 0.0), 0)
            .map(|n| n.unit().0)
    };
    assert_eq!(at(TriangleNormals::Flat, 0.2, 0.2), None);
    let one = |n| at(TriangleNormals::One(n), 0.2, 0.2);
    assert_eq!(one([0.0, 0.0, 4.0]), Some([0.0, 0.0, 1.0]));
    assert_eq!(one([3.0, 0.0, -4.0]), Some([0.6, 0.0, -0.8]));
    assert_eq!(one([0.0, 0.0, 1e308]), Some([0.0, 0.0, 1.0]));
    let up = [0.0, 0.0, 1.0];
    let each = TriangleNormals::PerVertex(Box::new([up, [1.0, 0.0, 1.0], [1e-200, 1.0, 1.0]]));
    assert_eq!(at(each.clone(), 0.0, 0.0), Some(up));
    let half = Vec3::new(0.5, 0.0, 1.0).unit();
    assert_eq!(at(each.clone(), 0.5, 0.0), Some(half.0));
    // They cancel in the middle.
    let opposite = TriangleNormals::PerVertex(Box::new([up, [0.0, 0.0, -1.0], up]));
    assert_eq!(at(opposite.clone(), 0.5, 0.0), Some([0.0; 3]));
}
