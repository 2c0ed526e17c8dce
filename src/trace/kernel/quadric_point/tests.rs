//! Points that lanes find on solids of second degree, beside those that the shapes find.

use super::*;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::testing::scene;
use crate::trace::Tracer;
use crate::trace::kernel::query::{Start, Tests, Within};
use crate::trace::kernel::scratch::Scratch;
use crate::trace::kernel::search;
use crate::trace::kernel::shade::Four;
use crate::trace::kernel::tests::{located, numbers};
use crate::trace::kernel::wave::{Hit, Ray};

/// A shape, moved and turned in groups so deep, and a ball far away.
fn text(shape: &str, depth: usize, number: &mut impl FnMut() -> f64) -> String {
    let mut text = format!("2 {shape}\n3 11 900 0 0 1\n");
    let mut whole = 2;
    for i in 0..depth {
        let mut turns = || 45.0 * (number() * 4.0).round();
        let (a, b) = (turns(), turns());
        text += &format!("{whole} -3 1 {} 1\n", 1.5 + number());
        text += &format!("{whole} -2 {a} 1\n{whole} -2 {b} {}\n", 2 + i % 2);
        text += &format!("{whole} -1 {} {} {}\n", number(), number(), number());
        text += &format!("{} -101 {whole} 3\n", 10 + i);
        whole = 10 + i;
    }
    text + &format!("1 9999 {whole} 0\n")
}

/// Known points have the bits of what the shape itself finds, on the way in and on the way out.
#[test]
fn points_have_the_bits_of_shapes() {
    let shapes = [
        "10 0.9 0.5 0.2",
        "10 0.3 1.5 1.5",
        "16 0.9 0.5",
        "16 -0.4 0.6",
        "15 1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 -0.25",
        "15 2 0 0 0.3 0 1.5 0 0 0 0 3 0 0.3 0 0 -1",
    ];
    let mut number = numbers();
    for (shape, depth) in shapes.into_iter().flat_map(|s| (0..4).map(move |d| (s, d))) {
        let scene = scene(&text(shape, depth, &mut number));
        let tracer = Tracer::new(&scene).unwrap();
        let stage = Stage::new(&tracer.graph, 100).expect("shapes for the kernel");
        let (mut scratch, mut tests) = (Scratch::default(), Tests::default());
        let (mut wave, mut hits) = (Vec::new(), Vec::new());
        let mut look = |start: Start, wave: &mut Vec<Ray>, hits: &mut Vec<Hit>| {
            let search::Met::Surface(crossing, sides) =
                stage.first(&start, &mut scratch, &mut tests)
            else {
                return None;
            };
            stage.leaves[crossing.surface as usize].quadric()?;
            hits.push(Hit {
                ray: wave.len() as u32,
                crossing,
                sides,
            });
            wave.push(Ray {
                start,
                weight: [1.0; 3],
                node: 0,
                pixel: 0,
                depth: 0,
            });
            Some(crossing)
        };
        for i in 0..2_000 {
            let mut vector = || Vec3::new(number(), number(), number());
            let (from, to) = (vector() * 9.0, vector());
            let mut direction = (to - from) * (1.0 + number());
            if i % 9 == 0 {
                direction.0[i / 9 % 3] = 0.0;
            }
            let mut start = Start::outside(from, direction);
            if let Some(mut crossing) = look(start, &mut wave, &mut hits)
                && stage.sharpen(&start, &mut crossing, &mut Default::default())
            {
                let leaf = &stage.leaves[crossing.surface as usize];
                let line = Line::new(from, direction);
                let [point, error, ..] = located(&stage, &line, leaf, crossing.root);
                start.origin = point.0;
                start.skin = 2.0 * error.max_component();
                (start.left, start.goes_in) = (leaf.twin, true);
                start.within = Within::one(leaf.solid);
                look(start, &mut wave, &mut hits);
            }
        }
        let mut known = 0;
        for some in hits.chunks(LANES) {
            let four = Four::new(&wave, &stage.leaves, some);
            let met = each(four.hits, |hit| {
                (&wave[hit.ray as usize].start, &hit.crossing)
            });
            let found = meet(&stage, four.leaves, met).expect("forms without mixed terms");
            let all = found.resolved;
            for lane in (0..some.len()).filter(|lane| found.known >> lane & 1 != 0) {
                known += 1;
                let (leaf, ray) = (four.leaves[lane], four.rays[lane]);
                let mut crossing = some[lane].crossing;
                let is_told = stage.sharpen(&ray.start, &mut crossing, &mut Default::default());
                assert!(is_told, "{shape} {depth} {:?}", ray.start);
                let line = Line::new(Vec3(ray.start.origin), Vec3(ray.start.direction));
                let of = |v: V3| Vec3(v.columns().map(|column| column[lane]));
                assert_eq!(
                    (all.t.to_array()[lane], found.flat >> lane & 1),
                    (crossing.root.t, crossing.root.face),
                    "{shape} {depth} {:?}",
                    ray.start
                );
                assert_eq!(
                    [
                        of(all.point),
                        of(all.error),
                        of(all.normal),
                        of(found.local)
                    ],
                    located(&stage, &line, leaf, crossing.root),
                    "{shape} {depth} {:?}",
                    ray.start
                );
            }
        }
        assert!(
            hits.len() > 50 && known * 100 > hits.len() * 97,
            "{shape} {depth}: {known} of {}",
            hits.len()
        );
    }
}
