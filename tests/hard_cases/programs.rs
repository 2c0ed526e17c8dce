//! Rows that are many rays about shapes.

use super::ask::{Precision, Ray, Said, Written, all_held, ask, data, exact, held, orderly};
use super::cases;
use super::exact::algebra::to_f64;
use super::trace_support::Random;
use zpg::internals::geometry::vec::Vec3;

/// A random ray from `away` to near the origin.
fn towards(r: &mut Random, away: f64, aim: f64) -> Ray {
    let origin = r.point(1.0).unit() * away;
    Ray::from_to(origin.0, r.point(aim).0)
}

pub fn row_09_hole_of_a_tiny_torus(precision: Precision) {
    let mut r = Random(9);
    let mut rays = Vec::new();
    for _ in 0..100 {
        // Through the hole, whose radius is 0.75e-4, at less than 45°: 0.4 + 0.25 < 0.75.
        let through = [r.within(-0.2e-4, 0.2e-4), 0.0, r.within(-0.2e-4, 0.2e-4)];
        let side = if r.below(2) == 0 { 1.0 } else { -1.0 };
        let view = [r.within(-0.3, 0.3), side, r.within(-0.3, 0.3)];
        let far = 10f64.powf(r.within(-3.0, 1.0));
        rays.push(Ray::from_to(view.map(|x| x * far), through));
    }
    for answer in all_held(&data("tiny-torus.zpg"), &rays, precision) {
        assert!(answer.changes.is_empty());
    }
    // From the side there is no way around the tube.
    let mut rays = Vec::new();
    for _ in 0..50 {
        let angle = r.within(0.0, std::f64::consts::TAU);
        let from = [angle.cos(), r.within(-0.1, 0.1), angle.sin()];
        rays.push(Ray::from_to(from, [0.0; 3]));
    }
    for answer in all_held(&data("tiny-torus.zpg"), &rays, precision) {
        assert_eq!(answer.changes.len(), 4);
    }
}

pub fn row_10_torus_from_afar(precision: Precision) {
    let mut r = Random(10);
    let rays: Vec<Ray> = (0..300).map(|_| towards(&mut r, 1e6, 1.3)).collect();
    let answers = all_held(&data("torus.zpg"), &rays, precision);
    let met: usize = answers.iter().map(|a| a.changes.len()).sum();
    assert!(met > 150, "{met}");
}

pub fn row_11_thin_torus_from_afar(precision: Precision) {
    let mut r = Random(11);
    let mut rays = Vec::new();
    for _ in 0..300 {
        let angle = r.within(0.0, std::f64::consts::TAU);
        let near = Vec3::new(angle.cos(), 0.0, angle.sin()) + r.point(1.2e-4);
        rays.push(Ray::from_to((r.point(1.0).unit() * 1e3).0, near.0));
    }
    let answers = all_held(&data("thin-torus.zpg"), &rays, precision);
    let met: usize = answers.iter().map(|a| a.changes.len()).sum();
    assert!(met > 150, "{met}");
}

pub fn row_15_sphere_from_afar(precision: Precision) {
    let mut r = Random(15);
    let rays: Vec<Ray> = (0..300).map(|_| towards(&mut r, 1.1e7, 1.0)).collect();
    let answers = all_held(&data("sphere.zpg"), &rays, precision);
    let met = answers.iter().filter(|a| a.changes.len() == 2).count();
    assert!(met > 100, "{met}");
}

/// Seen from the origin the rim of a unit sphere at z = −1e4 is where x² + y² = z²/(1e8 − 1): rays
/// are aimed a few units in the last place inwards and outwards of it.
pub fn row_17_rim_of_a_distant_sphere(precision: Precision) {
    let mut r = Random(17);
    let mut rays = Vec::new();
    let rim = (1.0 / (1e8f64 - 1.0)).sqrt();
    for k in -40..=40 {
        for _ in 0..5 {
            let angle = r.within(0.0, std::f64::consts::TAU);
            let wide = rim * (1.0 + f64::from(k) * f64::EPSILON / 4.0);
            rays.push(Ray::new(
                [0.0; 3],
                [wide * angle.cos(), wide * angle.sin(), -1.0],
            ));
        }
    }
    for k in 1..50 {
        let wide = rim * (1.0 - 0.5f64.powi(k));
        rays.push(Ray::new([0.0; 3], [wide, 0.0, -1.0]));
    }
    let answers = all_held(&data("distant-sphere.zpg"), &rays, precision);
    let (disc, edge) = (&answers[405..], &answers[..405]);
    assert!(disc.iter().all(|a| a.changes.len() == 2));
    let met = edge.iter().filter(|a| a.changes.len() == 2).count();
    assert!((100..300).contains(&met), "{met}");
}

pub fn row_22_clipped_paraboloid(precision: Precision) {
    let mut r = Random(22);
    let rays: Vec<Ray> = (0..300).map(|_| towards(&mut r, 8.0, 0.5)).collect();
    let path = data("clipped-paraboloid.zpg");
    let answers = all_held(&path, &rays, precision);
    for (ray, answer) in rays.iter().zip(answers) {
        let aim: [f64; 3] = std::array::from_fn(|i| ray.origin[i] + ray.direction[i]);
        let square = aim[0] * aim[0] + aim[2] * aim[2];
        if square + aim[1] < 0.999 && square < 0.999 {
            assert_eq!(answer.changes.len(), 2, "{ray:?}");
        }
    }
}

/// The sliver is there for every ray or for none; here for every, whatever the angle.
pub fn row_31_sliver(precision: Precision) {
    let mut r = Random(31);
    let mut rays = Vec::new();
    for _ in 0..200 {
        let aim = [r.within(-0.99, 0.99), 1.0, r.within(-0.99, 0.99)];
        let from = r.point(1.0).unit() * 5.0;
        if from[1].abs() > 0.1 {
            rays.push(Ray::from_to(from.0, aim));
        }
    }
    let path = data("sliver.zpg");
    for answer in all_held(&path, &rays, precision) {
        assert_eq!(answer.changes.len(), 2);
    }
    if precision == Precision::F64 {
        let scene = zpg::internals::analysis::file::load(&path).unwrap().scene;
        let tracer = zpg::internals::trace::Tracer::new(&scene).unwrap();
        let mut walker = tracer.walker();
        for ray in &rays {
            let mut ray = zpg::internals::trace::Ray::new(Vec3(ray.origin), Vec3(ray.direction));
            ray.is_outside = true;
            let hit = tracer.hit(&mut walker, &ray).expect("the sliver");
            assert!((hit.point[1] - 1.0).abs() < 1e-14, "{hit:?}");
        }
    }
}

/// A vase of n segments whose radii and heights are short binary fractions, so that rays can be
/// aimed at its seams exactly.
fn vase(n: u32) -> (String, Vec<[f64; 2]>) {
    let seam = |i: u32| {
        let y = f64::from(i) / 64.0;
        let x = 1.0 + f64::from((i * i * 7 + i) % 32) / 128.0;
        [x, y]
    };
    let profile: Vec<[f64; 2]> = (0..=n).map(seam).collect();
    let points = profile.iter().map(|[x, y]| format!(" {x} {y}"));
    let points: String = points.collect();
    (format!("2 1 {}{points}", n + 1), profile)
}

/// Rays through points of the seams, level, steep, and along the axis' direction.
fn through_seams(r: &mut Random, profile: &[[f64; 2]], count: usize) -> Vec<Ray> {
    let mut rays = Vec::new();
    while rays.len() < count {
        // Not the ends: rays across the axis would lie in the discs.
        let inner = r.below(profile.len() as u64 - 2) as usize + 1;
        let [x, y] = profile[inner];
        // Points at rational angles: (3, 4, 5) and on the axes; x times them is nearly exact.
        let (c, s) = [(1.0, 0.0), (0.0, -1.0), (0.6, 0.8), (-0.8, 0.6)][r.below(4) as usize];
        let seam = [x * c, y, x * s];
        let d = match r.below(4) {
            0 => [1.0, 0.0, 0.0],
            1 => [0.0, -1.0, 0.0],
            2 => [-s, 0.0, c],
            _ => [
                r.within(-1.0, 1.0),
                r.within(-0.2, 0.2),
                r.within(-1.0, 1.0),
            ],
        };
        let far = 16.0 + f64::from(profile.len() as u32) / 32.0;
        let origin = std::array::from_fn(|i| seam[i] - far * d[i]);
        rays.push(Ray::new(origin, d));
    }
    rays
}

pub fn row_34_seams_of_a_lathe(precision: Precision) {
    let mut r = Random(34);
    // A thousand segments: crossings alternate from outside to outside.
    let (records, profile) = vase(1000);
    let scene = Written::new(&records);
    // Pairs of doubles take their time.
    let count = if precision == Precision::Dd {
        cases(20, 60)
    } else {
        cases(300, 1000)
    };
    let rays = through_seams(&mut r, &profile, count);
    let said = ask(&scene.path, None, &rays, precision);
    let mut met = 0;
    for (ray, said) in rays.iter().zip(&said) {
        orderly(said, &format!("{ray:?}"));
        assert!(
            !said.inside && said.hits.len() % 2 == 0,
            "{ray:?} {:?}",
            said.t()
        );
        met += said.hits.len();
    }
    assert!(met > count, "{met}");
    // Twelve segments: they are the right ones.
    let (records, profile) = vase(12);
    let scene = Written::new(&records);
    let rays = through_seams(&mut r, &profile, 60);
    if precision == Precision::F32 {
        // Single precision cannot tell which side of a seam a ray is on that was aimed in double.
        return;
    }
    all_held(&scene.path, &rays, precision);
}

/// Vertices and midpoints of the edges of an icosahedron split twice, by the definition.
fn geodesic_points(radius: f64) -> Vec<Vec3> {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let mut corners = Vec::new();
    for (a, b) in [(1.0, phi), (1.0, -phi), (-1.0, phi), (-1.0, -phi)] {
        corners.push(Vec3::new(0.0, a, b).unit() * radius);
        corners.push(Vec3::new(b, 0.0, a).unit() * radius);
        corners.push(Vec3::new(a, b, 0.0).unit() * radius);
    }
    let near = |list: &[Vec3]| {
        let mut edges = Vec::new();
        let gap = |a: &Vec3, b: &Vec3| (*a - *b).length();
        for (i, a) in list.iter().enumerate() {
            let mut others: Vec<&Vec3> = list.iter().skip(i + 1).collect();
            others.retain(|b| gap(a, b) < 1.2 * shortest(list));
            edges.extend(others.iter().map(|&&b| (*a + b) * 0.5));
        }
        edges
    };
    let mut points = corners.clone();
    // The midpoints of the icosahedron's edges become vertices.
    let middles = near(&corners);
    assert_eq!(middles.len(), 30);
    points.extend(middles.iter().map(|m| m.unit() * radius));
    let edges = near(&points);
    assert_eq!(edges.len(), 120);
    points.extend(edges);
    points
}

fn shortest(list: &[Vec3]) -> f64 {
    let mut least = f64::INFINITY;
    for (i, a) in list.iter().enumerate() {
        for b in &list[i + 1..] {
            least = least.min((*a - *b).length());
        }
    }
    least
}

pub fn row_36_geodesic_vertices_and_edges(precision: Precision) {
    let mut r = Random(36);
    let scene = Written::new("2 13 1.5 1");
    let mut rays = Vec::new();
    for p in geodesic_points(1.5) {
        rays.push(Ray::new((p * 4.0).0, (-p).0));
        for _ in 0..5 {
            // From where the facets around the point face the ray: the sphere is convex.
            let from = p * r.within(2.0, 50.0) + r.point(0.5);
            rays.push(Ray::from_to(from.0, p.0));
        }
    }
    let said = ask(&scene.path, None, &rays, precision);
    for (ray, said) in rays.iter().zip(&said) {
        let what = format!("{} {ray:?} {:?}", precision.name(), said.t());
        orderly(said, &what);
        assert!(!said.inside && said.hits.len() == 2, "{what}");
    }
}

/// One of every shape, of size about 1.
const SHAPES: &[&str] = &[
    "2 1 5  0 2  1 1  0.5 0.25  0.75 -1  0 -1",
    "2 1 5  1 0  1.5 0.5  2 0  1.5 -0.5  1 0",
    "2 4 1 2 3 0.5",
    "2 9 1",
    "2 10 1 2 0.5",
    "2 11 0.5 0.25 -0.125 1",
    "2 12 -1 -0.5 -0.75 1 0.5 0.75",
    "2 13 1 2",
    "2 14 1 0.25",
    "2 14 0.5 1",
    "2 15 1 0.25 0 0  0.25 2 0 0  0 0 1 0.5  0 0 0.5 -1",
    "2 16 -1 1.5",
    "2 17 1 0.5",
    "2 18 0.5",
    "2 19 1 0.5",
    "2 20 1 0.75 1 1",
    "2 20 1 0.75 1 2",
    "2 21 1 2",
];

/// What a transformation does: its records, the scale, the way, and by how much the coordinates it
/// works with are larger than the object's own: the rounding of the inputs grows with them.
struct Change {
    records: String,
    scale: f64,
    way: f64,
    larger: f64,
}

pub fn row_38_scaled_moved_turned(precision: Precision) {
    let mut r = Random(38);
    let scaled = |s: f64| Change {
        records: format!("2 -3 {s} {s} {s}"),
        scale: s,
        way: 0.0,
        larger: 1.0,
    };
    let turns = |axis: u32| Change {
        records: format!("2 -2 0.36 {axis}\n").repeat(1000),
        scale: 1.0,
        way: 0.0,
        // Each of a thousand turns rounds, and the turn that all come to is 360°.
        larger: 1000.0,
    };
    let moved = Change {
        records: "2 -1 1e6 -1e6 1e6".into(),
        scale: 1.0,
        way: 1e6,
        larger: 2e6,
    };
    let changes = [
        scaled(1e6),
        scaled(1e-6),
        moved,
        turns(1),
        turns(2),
        turns(3),
    ];
    let (count, exact_of) = match precision {
        Precision::Dd => cases((4, 1), (40, 6)),
        _ => cases((12, 2), (40, 6)),
    };
    let mut met = 0;
    for shape in SHAPES {
        let plain = Written::new(shape);
        let rays: Vec<Ray> = (0..count).map(|_| towards(&mut r, 4.0, 1.2)).collect();
        let before = ask(&plain.path, None, &rays, precision);
        for Change {
            records,
            scale,
            way,
            larger,
        } in &changes
        {
            let changed = Written::new(&format!("{shape}\n{records}"));
            let way = [*way, -*way, *way];
            let seen: Vec<Ray> = rays
                .iter()
                .map(|ray| {
                    Ray::new(
                        std::array::from_fn(|i| ray.origin[i] * scale + way[i]),
                        ray.direction.map(|d| d * scale),
                    )
                })
                .collect();
            let after = ask(&changed.path, None, &seen, precision);
            // Some of them held to the exact answer for the rounded rays and matrices, whose numbers
            // get long.
            if !shape.starts_with("2 13") {
                let exact = exact(&changed.path);
                for (ray, said) in seen.iter().zip(&after).take(exact_of) {
                    held(&exact, *ray, said, precision, shape);
                }
            }
            let input = 64.0 * f64::EPSILON * larger * 8.0;
            for ((ray, a), b) in rays.iter().zip(&before).zip(&after) {
                if !clear(ray, a, input) {
                    continue;
                }
                let what = format!("{shape} {records:.20} {ray:?}: {:?} {:?}", a.t(), b.t());
                assert_eq!((a.inside, a.hits.len()), (b.inside, b.hits.len()), "{what}");
                for (h, g) in a.hits.iter().zip(&b.hits) {
                    let steep = Vec3(h.normal).dot(Vec3(ray.direction)).abs();
                    let apart = to_f64(&(&h.t - &g.t)).abs();
                    assert!(apart * steep <= input, "{what} {apart:e}");
                }
                met += a.hits.len();
            }
        }
    }
    assert!(met > 75 * count, "{met}");
}

/// Whether no crossing is so slanting that the rounding of the inputs could move it by more than a
/// thousandth, and none lies so close to another. The rays that meet nothing are left to the exact
/// evaluation.
fn clear(ray: &Ray, said: &Said, input: f64) -> bool {
    let t = said.t();
    let steep = |h: &super::ask::Hit| Vec3(h.normal).dot(Vec3(ray.direction)).abs() * 1e-3 > input;
    !t.is_empty() && t.windows(2).all(|w| w[1] - w[0] > 1e-2) && said.hits.iter().all(steep)
}
