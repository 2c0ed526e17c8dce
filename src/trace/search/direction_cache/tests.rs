use super::*;
use crate::geometry::dd::Dd;
use crate::testing::{random, scene};
use crate::trace::search::hit::Hit;
use crate::trace::within::Within;
use crate::trace::{Ray, Tracer};
use std::fmt::Write;

/// A number from −1 to 1.
fn number(next: &mut impl FnMut(u64) -> u64) -> f64 {
    next(2_000_001) as f64 / 1e6 - 1.0
}

fn vector(next: &mut impl FnMut(u64) -> u64) -> Vec3 {
    Vec3([0; 3].map(|_| number(next)))
}

/// The body that is all of a box.
fn filling(part: u32, bounds: Aabb) -> Body {
    let corners = bounds.corners().map(Vec3);
    Body::of_corners(part, bounds, (corners.to_vec(), 0.0))
}

/// Boxes of many sizes, some of them flat, near a point and around it.
fn boxes(next: &mut impl FnMut(u64) -> u64, scale: f64) -> Arc<[Body]> {
    (0..40)
        .map(|part| {
            let size = 10f64.powi(-(next(4) as i32));
            let middle = vector(next);
            let half = Vec3([0; 3].map(|_| size * (next(4) as f64 / 4.0)));
            let [min, max] = [middle - half, middle + half].map(|corner| corner * scale);
            filling(part, Aabb::new(min, max))
        })
        .collect()
}

/// Points of many kinds and their boxes.
fn hulls(next: &mut impl FnMut(u64) -> u64, scale: f64) -> Arc<[Body]> {
    (0..40)
        .map(|part| {
            let size = 10f64.powi(-(next(4) as i32));
            let middle = vector(next);
            let corners: Vec<Vec3> = (0..3 + next(10))
                .map(|_| (middle + vector(next) * size) * scale)
                .collect();
            let around = (corners.iter()).fold(Aabb::EMPTY, |b, &c| b.hull(&Aabb::new(c, c)));
            Body::of_corners(part, around, (corners, 0.0))
        })
        .collect()
}

#[test]
fn nothing_between_the_corners_of_a_body_is_missed() {
    let mut next = random();
    let (mut met, mut listed, mut boxed) = (0, 0, 0);
    for round in 0..400 {
        let scale = 10f64.powi(round % 25 - 12);
        let bodies = hulls(&mut next, scale);
        let point = vector(&mut next) * scale * [0.5, 1.0, 20.0][next(3) as usize];
        let direction_cache = DirectionCache::new(&bodies, point).unwrap();
        for _ in 0..200 {
            let part = next(40);
            let body = &bodies[part as usize];
            // A corner, or a point on an edge, in a triangle or inside.
            let weights: Vec<f64> = (0..1 + next(4)).map(|_| number(&mut next).abs()).collect();
            let sum: f64 = weights.iter().sum();
            let corner = |next: &mut dyn FnMut(u64) -> u64| {
                body.corners[next(body.corners.len() as u64) as usize]
            };
            let to = (weights.iter()).fold(Vec3::ZERO, |p, w| p + corner(&mut next) * (w / sum));
            // From there, and from behind it.
            let way = (point - to) * [1.0, 1.5][next(2) as usize];
            if !(way.any() && way.is_finite()) {
                continue;
            }
            let list: Vec<u32> = direction_cache
                .arriving(way)
                .unwrap()
                .map(|(_, b)| b.part)
                .collect();
            assert!(list.contains(&(part as u32)), "{point:?} {to:?} {body:?}");
            let line = Ray::new(point, -way).line;
            let is_in_box = |b: &&Body| b.bounds.clip(&line, 0.0, 1.0).is_some();
            boxed += bodies.iter().filter(is_in_box).count();
            listed += list.len();
            met += 1;
        }
    }
    // Octagons say more than boxes.
    assert!(
        met > 70_000 && listed < boxed * 9 / 10,
        "{met} {listed} {boxed}"
    );
}

#[test]
fn no_box_on_a_rays_way_is_missed() {
    let mut next = random();
    let (mut met, mut listed) = (0, 0);
    for round in 0..400 {
        let scale = 10f64.powi(round % 25 - 12);
        let bodies = boxes(&mut next, scale);
        let point = vector(&mut next) * scale * [0.5, 1.0, 20.0][next(3) as usize];
        let direction_cache = DirectionCache::new(&bodies, point).unwrap();
        for _ in 0..200 {
            // To the corner of a box, along an axis, on an edge of the cube, or anywhere.
            let b = &bodies[next(40) as usize].bounds;
            let to = match next(5) {
                0 => Vec3([0, 1, 2].map(|i| [b.min, b.max][next(2) as usize][i])),
                1 => {
                    let mut to = point;
                    to[next(3) as usize] += number(&mut next) * scale;
                    to
                }
                2 => point + Vec3([1.0, 1.0, number(&mut next)]) * scale,
                _ => vector(&mut next) * scale,
            };
            let way = point - to;
            if !way.any() {
                continue;
            }
            let list: Vec<u32> = direction_cache
                .arriving(way)
                .unwrap()
                .map(|(_, body)| body.part)
                .collect();
            let line = Ray::new(to, way).line;
            for Body {
                part, bounds: b, ..
            } in bodies.iter()
            {
                // But for what is rounded where it is clipped.
                let hair = Vec3::ONE * (1e-12 * scale);
                let inner = Aabb::new(Vec3(b.min) + hair, Vec3(b.max) - hair);
                let meets = inner.clip(&line, 0.0, 1.0).is_some();
                met += u32::from(meets);
                assert!(!meets || list.contains(part), "{point:?} {to:?} {b:?}");
            }
            listed += list.len() as u32;
            let near: Vec<f64> = direction_cache
                .leaving(-way)
                .map(|(near, _)| near)
                .collect();
            assert!(near.is_sorted());
        }
    }
    // The lists are short.
    assert!(met > 50_000 && listed < 2 * met, "{met} of {listed}");
}

/// A triangle beside the field of view of a face whose box reaches into it.
#[test]
fn what_the_corners_say_is_not_seen_is_in_no_list() {
    let corners = [[1.1, 31.0, 31.0], [31.0, 961.0, 961.0], [1.2, 40.0, 35.0]].map(Vec3);
    let around = (corners.iter()).fold(Aabb::EMPTY, |b, &c| b.hull(&Aabb::new(c, c)));
    let body = Body::of_corners(0, around, (corners.to_vec(), 0.0));
    let is_seen = |axis| body.seen(Vec3::ZERO, (axis, 1.0), &around, 0.0).is_some();
    assert_eq!([0, 1, 2].map(is_seen), [false, true, true]);
    let bodies: Arc<[Body]> = Arc::new([body]);
    let direction_cache = DirectionCache::new(&bodies, Vec3::ZERO).unwrap();
    assert_eq!(
        direction_cache.leaving(Vec3::new(1.0, 0.99, 0.99)).count(),
        0
    );
    assert_eq!(
        direction_cache.leaving(Vec3::new(1.1, 31.0, 31.0)).count(),
        1
    );
}

#[test]
fn points_without_numbers_have_no_vista() {
    let bodies: Arc<[Body]> = Arc::new([filling(0, Aabb::new([0.0; 3], [1.0; 3]))]);
    let far = Vec3::new(f64::INFINITY, 0.0, 0.0);
    assert!(DirectionCache::new(&bodies, far).is_none());
    assert!(DirectionCache::new(&Arc::default(), Vec3::ZERO).is_none());
    let direction_cache = DirectionCache::new(&bodies, Vec3::ONE * 3.0).unwrap();
    assert!(direction_cache.arriving(Vec3::ONE * 1e5).is_none());
    assert!(direction_cache.arriving(Vec3::ONE * f64::NAN).is_none());
    assert_eq!(direction_cache.leaving(Vec3::ONE).count(), 0);
    assert_eq!(direction_cache.leaving(-Vec3::ONE).count(), 1);
}

/// A union of shapes of all kinds, some of them cut and in groups, and a half-space.
fn things(next: &mut impl FnMut(u64) -> u64) -> String {
    let mut text = String::from("3 4 0 1 0 5\n");
    let mut root = 3;
    for id in (10..210).step_by(5) {
        let size = 0.2 + number(next).abs();
        let half = size / 2.0;
        let _ = match next(7) {
            0 => writeln!(text, "{id} 9 {size}"),
            1 => writeln!(text, "{id} 14 {size} {half}"),
            2 => writeln!(text, "{id} 16 {size} {half}"),
            3 => writeln!(text, "{id} 12 0 0 0 {size} {half} 1"),
            4 => writeln!(text, "{id} 10 {size} {half} 1"),
            5 => writeln!(
                text,
                "{0} 9 {size}\n{1} 9 {half}\n{id} -103 {0} {1}",
                id + 1,
                id + 2
            ),
            _ => writeln!(
                text,
                "{0} 9 {half}\n{1} 17 {size} {half}\n{id} -101 {0} {1}",
                id + 1,
                id + 2
            ),
        };
        let [sx, sy, sz] = [0; 3].map(|_| 0.4 + number(next).abs());
        let _ = writeln!(text, "{id} -2 {} 3\n{id} -3 {sx} {sy} {sz}", next(360));
        let [x, y, z] = (vector(next) * 4.0).0;
        let _ = writeln!(
            text,
            "{id} -2 {} {}\n{id} -1 {x} {y} {z}",
            next(360),
            1 + next(2)
        );
        let _ = writeln!(text, "{} -101 {root} {id}", id + 3);
        root = id + 3;
    }
    text + &format!("1 9999 {root} 0\n")
}

#[test]
fn rays_meet_what_they_meet_without_a_vista() {
    let mut next = random();
    let (mut hits, mut hidden) = (0, 0);
    for _ in 0..60 {
        let scene = scene(&things(&mut next));
        let tracer = Tracer::new(&scene).unwrap();
        let bodies = bodies(&tracer.graph, 1000).unwrap();
        let mut walkers = tracer.walker::<f64>();
        let [eye, light] = [vector(&mut next), vector(&mut next)]
            .map(|v| Vec3::new(v[0], v[1].abs(), v[2]).unit() * 9.0);
        let [from_eye, from_light] = [eye, light].map(|p| DirectionCache::new(&bodies, p).unwrap());
        for _ in 0..300 {
            let mut ray = Ray::new(eye, (vector(&mut next) * 4.0 - eye).unit());
            ray.within = Within::Outside;
            let [known, hit] = [End::At(&from_eye), End::Anywhere]
                .map(|end| walkers.first_hit::<false>(&ray, end));
            let told = |hit: &Hit| (hit.t, hit.surface, hit.normal.0);
            assert_eq!(known.as_ref().map(told), hit.as_ref().map(told));
            let Some(hit) = hit else { continue };
            let way = light - hit.point;
            if hit.facing().dot(way) <= 0.0 {
                continue;
            }
            let ray = hit.leave(way, false);
            let [known, seen] = [End::To(&from_light), End::Anywhere]
                .map(|end| walkers.visibility::<false>(&ray, 0, end));
            assert_eq!(known, seen);
            let exact = tracer
                .walker()
                .visibility::<false>(&ray.cast::<Dd>(), 0, End::Anywhere);
            assert_eq!(exact, seen);
            hits += 1;
            hidden += u32::from(!seen.any());
        }
    }
    assert!(hits > 5_000 && hidden > 1_500, "{hidden} of {hits}");
}
