//! What is said of things that no picture shows (W323 to W331), of random scenes: only what is true. A texture that is
//! said to be unseen changes no picture, and a light inside of something lights nothing.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use crate::campaign::rng::Rng;
use crate::lint_generated::scenes;
use crate::people::{self, DRAFTS};
use crate::support::{cases, seeds};
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Diagnostic, Span};
use zpg::internals::scene::{Camera, Scene};
use zpg::internals::solids::staging::selected_cameras;
use zpg::internals::trace::plan::Plan;
use zpg::internals::trace::{Images, Settings, Tracer, members};

/// What speaks of things that no picture shows.
const CODES: RangeInclusive<Code> = Code::W323..=Code::W331;

fn load(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

/// The pictures of all cameras, and of others, as bits.
fn pictures(scene: &Scene, others: &[Camera]) -> Vec<Vec<[u32; 3]>> {
    let settings = Settings {
        width: 32,
        height: 24,
        depth: 4,
        ..Settings::default()
    };
    let plan = Plan::new(scene).unwrap();
    let tracer = Tracer::planned(scene, &Images::default(), plan).unwrap();
    let cameras = scene.cameras.iter().chain(others);
    let taken = cameras.filter_map(|c| tracer.render(c, &settings, || ()).ok());
    let bits = |p: &[f32; 3]| p.map(f32::to_bits);
    taken
        .map(|picture| picture.film.pixels.iter().map(bits).collect())
        .collect()
}

/// The text with the record of a finding replaced.
///
/// A difference takes away a copy with that record, in the place of what it takes away.
fn replaced(text: &str, d: &Diagnostic, parameters: &str) -> String {
    let (start, end) = (d.span.start as usize, d.span.end as usize);
    let mut words = text[start..end].split_whitespace();
    let id = words.next().unwrap();
    if d.case == "union" {
        let operands: Vec<&str> = words.skip(1).collect();
        let [cut, tool] = operands[..] else {
            panic!("{text}");
        };
        let copy = format!("900 -105 {tool}\n900 {parameters}");
        return format!(
            "{}{copy}\n{id} -103 {cut} 900{}",
            &text[..start],
            &text[end..]
        );
    }
    format!("{}{id} {parameters}{}", &text[..start], &text[end..])
}

/// What is wrong with the finding that a texture is unseen: with another texture in its place a picture differs. What
/// does not depend on cameras must hold for any.
fn refuted_texture(text: &str, scene: &Scene, d: &Diagnostic, rng: &mut Rng) -> bool {
    let mut others = Vec::new();
    if matches!(d.case, "covered" | "removed" | "union" | "dark") {
        let camera = scene.cameras[0];
        others = (0..4)
            .map(|_| Camera {
                position: [0; 3].map(|_| rng.range(-6.0, 6.0)),
                direction: [0; 3].map(|_| rng.range(-1.0, 1.0)),
                projection: None,
                ..camera
            })
            .collect();
    }
    let before = pictures(scene, &others);
    let mut count = 0;
    for other in ["-701 0.9 0.15 0.6", "-302", "-399 9 7 3 4"] {
        let changed = load(&replaced(text, d, other));
        if changed.is_sound() {
            count += 1;
            if pictures(&changed.scene, &others) != before {
                return true;
            }
        }
    }
    count == 0
}

/// Writes scenes with textures in every way that the language knows: given at once and by assignment, to objects, copies
/// and groups, on mirrors and glass, on what is cut away, hidden, or out of view. 3 to 5 are colours, 10 to 13 textures,
/// 20 to 23 optical properties.
struct Writer {
    rng: Rng,
    text: String,
    /// Whether nothing mirrors much and nothing lets light through.
    plain: bool,
}

impl Writer {
    fn line(&mut self, line: String) {
        self.text += &line;
        self.text += "\n";
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.rng.below(of.len())]
    }

    fn properties(&mut self) {
        self.line("3 -701 1 0.1 0.2\n4 -701 0.2 0.3 0.9\n5 -701 0.1 0.8 0.3".into());
        for id in 10..14 {
            let n = 2 + self.rng.below(6);
            let texture = match self.rng.chance(0.5) {
                true => format!("-399 {n} 5 3 4"),
                false => format!("-302 4 3 0.{n}"),
            };
            self.line(format!("{id} {texture}"));
        }
        for (id, k) in [
            (20, "0 1 0"),
            (21, "0 0.2 0.8"),
            (22, "0.6 0.4 0"),
            (23, "1 0 0"),
        ] {
            self.line(format!("{id} -201 {k}"));
        }
    }

    fn paint(&mut self, id: usize) {
        for _ in 0..self.rng.below(3) {
            let texture = self.one(&[0, 5, 10, 11, 12, 13]);
            let optics = match self.plain {
                true => self.one(&[0, 23]),
                false => self.one(&[0, 20, 21, 22, 23]),
            };
            let record = match self.rng.below(6) {
                0 => "-701 0.9 0.9 0.2".to_owned(),
                1 => "-399 3 5 4 5".to_owned(),
                2 => "-302 5 3 0.3".to_owned(),
                3 if !self.plain => "-201 0 1 0".to_owned(),
                _ => format!("-299 {texture} {optics}"),
            };
            self.line(format!("{id} {record}"));
        }
    }

    fn shape(&mut self, id: usize, far: f64) {
        let r = self.one(&[0.4, 0.8, 1.6, 2.5]);
        let shape = match self.rng.below(3) {
            0 => format!("12 -{r} -{r} -{r} {r} {r} {r}"),
            1 => format!("14 {r} {:.2}", r / 3.0),
            _ => format!("9 {r}"),
        };
        self.line(format!("{id} {shape}"));
        self.paint(id);
        if self.rng.chance(0.6) {
            let [x, y, z] = [0; 3].map(|_| self.rng.range(-far, far));
            self.line(format!("{id} -1 {x:.2} {y:.2} {z:.2}"));
            self.paint(id);
        }
    }

    fn operation(&mut self, id: usize, objects: &[usize]) {
        let (a, b) = (self.one(objects), self.one(objects));
        let operation = match self.rng.below(10) {
            0 => format!("-105 {a}"),
            1 => format!("-102 {a} {b}"),
            2 | 3 => format!("-103 {a} {b}"),
            4 => {
                self.line(format!("{} -104 {b}", id + 100));
                format!("-102 {a} {}", id + 100)
            }
            _ => format!("-101 {a} {b}"),
        };
        self.line(format!("{id} {operation}"));
        self.paint(id);
    }

    fn write(mut self) -> String {
        self.properties();
        let far = self.one(&[1.5, 3.0, 12.0, 12.0]);
        let mut objects = Vec::new();
        for id in (100..).take(3 + self.rng.below(4)) {
            self.shape(id, far);
            objects.push(id);
        }
        for id in (200..).take(2 + self.rng.below(5)) {
            self.operation(id, &objects);
            objects.push(id);
        }
        self.line("60 -401 0.3\n61 -402 0.7\n61 -1 4 6 8".into());
        for id in (70..).take(1 + self.rng.below(3)) {
            let [x, y, z] = [0; 3].map(|_| self.rng.range(-9.0, 9.0));
            self.line(format!(
                "{id} -501 {x:.2} {y:.2} {z:.2} {:.2} {:.2} {:.2} 0.1 1 0.2 45",
                -x, -y, -z
            ));
        }
        self.line("79 -502 70".into());
        let region = self.one(&["", "", " -2 -2 -2 2 2 2"]);
        let root = objects[objects.len() - 1];
        let others = [self.one(&objects), self.one(&objects)];
        self.line(format!(
            "400 -101 {root} {}\n401 -101 {} 400",
            others[0], others[1]
        ));
        self.line(format!("1 9999 401 0{region}"));
        self.text
    }
}

fn textured(seed: u64) -> String {
    let mut rng = Rng::new(seed ^ 0x7e87);
    let plain = rng.chance(0.5);
    let text = String::new();
    Writer { rng, text, plain }.write()
}

#[test]
fn textures_that_are_unseen_change_no_picture() {
    let mut seen: BTreeMap<&str, u32> = BTreeMap::new();
    for seed in seeds("UNSEEN_TEXTURES", 0..cases(100, 300)) {
        let text = textured(seed);
        let loaded = load(&text);
        assert!(loaded.is_sound(), "{seed}:\n{text}");
        for d in loaded.findings().iter().filter(|d| d.code == Code::W331) {
            *seen.entry(d.case).or_insert(0) += 1;
            let is_wrong = refuted_texture(&text, &loaded.scene, d, &mut Rng::new(!seed));
            assert!(!is_wrong, "{seed} {}:\n{text}", d.case);
        }
    }
    println!("{seen:?}");
    for case in [
        "", "covered", "removed", "union", "dark", "hidden", "beside",
    ] {
        assert!(seen.contains_key(case), "{case}: {seen:?}");
    }
}

/// What is checked above can fail: textures of which nothing is said change pictures, where nothing else is in front of them.
#[test]
fn textures_that_are_seen_change_pictures() {
    let (mut changed, mut all) = (0, 0);
    for seed in 0..100 {
        let text = textured(seed);
        let loaded = load(&text);
        let unreached = Plan::new(&loaded.scene).unwrap().unreached;
        for (at, _) in text.match_indices(" -399 ") {
            let line = text[..at].rfind('\n').unwrap() + 1;
            let end = line + text[line..].find('\n').unwrap();
            let span = Span::new(line as u32, end as u32);
            let id: u32 = text[line..at].parse().unwrap();
            let is_said = loaded.findings().iter().any(|d| span.start == d.span.start);
            if id >= 100 && !unreached.contains(&id) && !is_said {
                all += 1;
                let lie = Diagnostic::new(Code::W331, span);
                changed += u32::from(refuted_texture(
                    &text,
                    &loaded.scene,
                    &lie,
                    &mut Rng::new(1),
                ));
            }
        }
    }
    assert!(all > 15 && changed * 4 > all, "{changed} of {all}");
}

/// Random scenes as programs and people write them. Of those that draw something nothing is said but what is true: a
/// texture that is unseen, a light or a camera inside of something.
#[test]
fn nothing_is_said_of_scenes_that_draw_something() {
    let (mut drawn, mut seen) = (0, BTreeMap::new());
    for seed in 0..cases(60, 400) {
        let people = DRAFTS.map(|draft| people::text(&draft(&mut Rng::new(seed), 40)));
        for text in people.into_iter().chain([scenes::scene(seed)]) {
            let loaded = load(&text);
            if !loaded.is_sound() || loaded.scene.render.is_none() || !draws(&loaded.scene) {
                continue;
            }
            drawn += 1;
            let mut rng = Rng::new(!seed);
            for d in loaded.findings().iter().filter(|d| CODES.contains(&d.code)) {
                *seen.entry((d.code.as_str(), d.case)).or_insert(0) += 1;
                let is_wrong = match (d.code, d.case) {
                    (Code::W331, _) => refuted_texture(&text, &loaded.scene, d, &mut rng),
                    (Code::W325, _) => !is_inside(&loaded.scene),
                    // A camera that is inside of something sees what it lights there.
                    (Code::W326, "") => {
                        let dark = replaced(&text, d, "-402 0");
                        !is_inside(&loaded.scene)
                            && pictures(&load(&dark).scene, &[]) != pictures(&loaded.scene, &[])
                    }
                    _ => true,
                };
                assert!(!is_wrong, "{seed} {d:?}:\n{text}");
            }
        }
    }
    println!("{drawn} scenes: {seen:?}");
    assert!(drawn >= cases(100, 1000), "{drawn}");
}

/// Whether the camera is inside of something, by exact numbers.
fn is_inside(scene: &Scene) -> bool {
    let place = selected_cameras(scene, 1.0)[0].position;
    let root = scene.render.unwrap().root;
    members(scene, root, place.into()).unwrap().in_root
}

/// Whether the picture of a scene has more than one colour.
fn draws(scene: &Scene) -> bool {
    let mut scene = scene.clone();
    scene.cameras = selected_cameras(&scene, 32.0 / 24.0);
    let pictures = pictures(&scene, &[]);
    pictures
        .iter()
        .any(|p| p.iter().any(|pixel| pixel != &p[0]))
}
