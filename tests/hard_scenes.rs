//! The scenes of `scenes/hard` look as they must. What that is, is known from a scene that is the
//! same to the eye but not hard, from an independent ray tracer where that is able, or by arithmetic.

use std::fs;
use std::path::{Path, PathBuf};
use zpg::internals::analysis::Analysis;
use zpg::internals::study::naive::Naive;
use zpg::internals::trace::film::srgb8;
use zpg::internals::trace::{Film, Images, Settings, Tracer, selected_camera};

/// The size that the scenes in parallel projection are made for.
const SIZE: [u32; 2] = [160, 128];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/hard")
}

fn names() -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "zpg"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(names.len() >= 12);
    names
}

fn text(name: &str) -> String {
    fs::read_to_string(folder().join(name).with_extension("zpg")).unwrap()
}

/// The text with edits, each of which must find its place exactly once. How it is aligned is no matter.
fn edited(text: &str, edits: &[(&str, &str)]) -> String {
    let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ") + "\n";
    let text: String = text.lines().map(words).collect();
    edits.iter().fold(text, |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "{from}");
        text.replace(from, to)
    })
}

fn load(text: &str) -> Analysis {
    let loaded = Analysis::new("scene.zpg", text.into());
    assert!(loaded.is_sound(), "{:?}\n{text}", loaded.findings());
    loaded
}

fn picture(text: &str, [width, height]: [u32; 2]) -> Film {
    let loaded = load(text);
    let camera = selected_camera(&loaded.scene, f64::from(width) / f64::from(height));
    let settings = Settings {
        width,
        height,
        ..Settings::default()
    };
    let tracer = Tracer::new(&loaded.scene).unwrap();
    tracer.render(&camera, &settings, || ()).unwrap().film
}

fn textbook(text: &str, size: [u32; 2]) -> Film {
    let loaded = load(text);
    let camera = selected_camera(&loaded.scene, f64::from(size[0]) / f64::from(size[1]));
    let images = Images::default();
    let Settings { depth, cutoff, .. } = Settings::default();
    let naive = Naive::<f64>::new(&loaded.scene, &images, &camera, size, depth, cutoff).unwrap();
    naive.film().unwrap()
}

/// Whether two pixels look the same: within 2/255.
fn alike(a: [f32; 3], b: [f32; 3]) -> bool {
    (0..3).all(|c| srgb8(a[c]).abs_diff(srgb8(b[c])) <= 2)
}

fn differing(a: &Film, b: &Film) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let pairs = a.pixels.iter().zip(&b.pixels);
    pairs.filter(|(a, b)| !alike(**a, **b)).count()
}

#[test]
fn all_of_them_are_sound_and_have_their_place_on_the_page() {
    let page = fs::read_to_string(folder().join("README.md")).unwrap();
    for name in names() {
        let film = picture(&text(&name), [64, 48]);
        let sound = |x: &f32| x.is_finite() && *x >= 0.0;
        assert!(film.pixels.iter().flatten().all(sound), "{name}");
        let drawn = film.pixels.iter().any(|p| *p != film.pixels[0]);
        assert!(drawn, "{name} is all of one colour");
        assert!(page.contains(&format!("({name}.zpg)")), "{name}");
        let picture = format!("pictures/{name}.png");
        assert!(page.contains(&format!("({picture})")), "{name}");
        assert!(folder().join(picture).is_file(), "{name}");
    }
}

/// A scene, edits that make it an easy one that looks the same, and the largest number of pixels
/// of 160 × 128 that may differ even so.
type Easier = (&'static str, &'static [(&'static str, &'static str)], usize);

/// Where the easy scene is the same but for rounding, only pixels whose rays pass an edge within
/// rounding may differ. Where it is seen from nearer by, edges move by up to half a pixel.
const EASIER: &[Easier] = &[
    // From 250 000 times nearer: the rings are 2e-3 wide and 4 away, so edges do not move.
    (
        "thin-torus-far",
        &[(
            "975001 225000 150000 -975 -225 -150 0 1 0 1.132e-7",
            "4.9 0.9 0.6 -3.9 -0.9 -0.6 0 1 0 0.0283",
        )],
        10,
    ),
    // A tool that ends at a face cuts as one that reaches beyond.
    (
        "flush-box",
        &[
            (
                "31 12 -0.8 0.5 -0.8 -0.1 1 -0.1",
                "31 12 -0.8 0.5 -0.8 -0.1 1.5 -0.1",
            ),
            (
                "33 12 0.1 0 -0.8 0.8 1 -0.1",
                "33 12 0.1 -0.5 -0.8 0.8 2 -0.1",
            ),
            (
                "34 12 -1 0.6 0.4 -0.4 1 1",
                "34 12 -1.2 0.6 0.4 -0.4 1.1 1.3",
            ),
        ],
        0,
    ),
    (
        "flush-tube",
        &[("31 1 2 0.75 0 0.75 1", "31 1 2 0.75 -1 0.75 2")],
        0,
    ),
    // A wall of a thousandth is as opaque as one of a millionth of a millionth; its shadows end
    // elsewhere by as much.
    (
        "slivers",
        &[
            ("0.700001", "0.701"),
            ("0.700000001", "0.701"),
            ("0.700000000001", "0.701"),
        ],
        20,
    ),
    // Nowhere does one see past the ground.
    ("gap", &[("13 -701 0.05 0.05 0.08", "13 -701 1 0 1")], 0),
    // From 1000 times nearer: 1077 units instead of a million. The group is 6.4 wide.
    (
        "far-group",
        &[
            ("33 -1 600000 -400000 -800000\n", ""),
            ("599996 -399992 -799995", "-4 8 5"),
            (
                "0 0 0 6 -4 -8 0 1 0 0.00038",
                "-600 400 800 6 -4 -8 0 1 0 0.38",
            ),
        ],
        80,
    ),
    // The same at the origin.
    (
        "huge",
        &[
            ("99999998.7 100000000.8 -99999999 0.8", "-1.3 0.8 1 0.8"),
            ("22 -1 100000000 100000000 -100000000\n", ""),
            ("23 -1 100000000 100000000 -100000000\n", ""),
            (
                "100000000.5 100000000 -100000001.9 100000001.6 100000001.1 -100000000.8",
                "0.5 0 -1.9 1.6 1.1 -0.8",
            ),
            ("0 1 0 -100000000", "0 1 0 0"),
            ("99999996 100000008 -99999995", "-4 8 5"),
            (
                "100000000 100000003.6 -99999992.6 0 -0.4",
                "0 3.6 7.4 0 -0.4",
            ),
        ],
        10,
    ),
    // Over 24 thousandths of a unit the ground is flat within 3e-10.
    (
        "ground",
        &[("20 11 0 -1000000 0 1000000", "20 4 0 1 0 0")],
        10,
    ),
    // What is equal counts once, and what is taken away from itself is nothing.
    (
        "equal-solids",
        &[
            ("32 -101 30 31", "32 -105 30"),
            ("34 -102 33 33", "34 -105 33"),
            ("40 -101 38 39", "40 -105 38"),
            ("44 -101 43 37", "44 -105 43"),
        ],
        0,
    ),
    // From ten times nearer: 30 units instead of 300.
    (
        "small-sphere",
        &[(
            "0 150.083 260.4 0 -15 -26 0 1 0 0.018",
            "0 15.083 26.4 0 -15 -26 0 1 0 0.18",
        )],
        80,
    ),
];

#[test]
fn they_look_like_scenes_that_are_not_hard() {
    compare(EASIER);
}

/// Faces of solids that are placed differently, or of different kinds, that lie in one plane.
const UNLIKE_FACES: &[Easier] = &[
    (
        "flush-box",
        &[("32 12 0 0 0 0.7 0.7 0.7", "32 12 0 0 0 0.7 1.2 0.7")],
        0,
    ),
    (
        "flush-tube",
        &[
            ("35 -105 34\n35 -3 0.75 1 0.75", "35 1 2 0.75 -1 0.75 2"),
            ("38 1 2 0.6 -0.6 0.6 0.6", "38 1 2 0.6 -1 0.6 1"),
        ],
        5,
    ),
];

#[test]
fn unlike_faces_are_one_too() {
    compare(UNLIKE_FACES);
}

fn compare(scenes: &[Easier]) {
    let mut wrong = String::new();
    for (name, edits, most) in scenes {
        let text = text(name);
        let (hard, easy) = (picture(&text, SIZE), picture(&edited(&text, edits), SIZE));
        let off = differing(&hard, &easy);
        println!("{name}: {off}");
        if off > *most {
            wrong += &format!("{name}: {off} pixels differ, not up to {most}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// In double precision a textbook's methods are enough for some of them, and for any scene that is
/// not hard; there they check everything.
#[test]
fn where_textbooks_are_right_we_agree() {
    let gallery = folder().with_file_name("gallery");
    let easy = ["dice", "pawns", "quadrics"].map(|name| {
        let text = fs::read_to_string(gallery.join(name).with_extension("zpg")).unwrap();
        (name, text)
    });
    let hard = ["huge", "ground", "slivers", "glass-corner", "paraboloid"];
    let hard = hard.map(|name| (name, text(name)));
    for (name, text) in easy.into_iter().chain(hard) {
        let off = differing(&picture(&text, SIZE), &textbook(&text, SIZE));
        println!("{name}: {off}");
        assert!(off * 500 <= (SIZE[0] * SIZE[1]) as usize, "{name}: {off}");
    }
}

/// The direction of a pixel's ray in units of half the picture's height at distance 1: right, up.
fn place(x: u32, y: u32) -> [f64; 2] {
    let [w, h] = SIZE.map(f64::from);
    [
        (2.0 * (f64::from(x) + 0.5) - w) / h,
        1.0 - 2.0 * (f64::from(y) + 0.5) / h,
    ]
}

fn pixels(film: &Film) -> impl Iterator<Item = ([f64; 2], [f32; 3])> {
    let at = |i: u32| (i % film.width, i / film.width);
    (0..film.width * film.height).map(move |i| {
        let (x, y) = at(i);
        (place(x, y), film.pixel(x, y))
    })
}

#[test]
fn a_far_sphere_is_a_disc() {
    let film = picture(&text("far-sphere"), SIZE);
    let background = [0.1f32, 0.15, 0.3];
    // The tangent of the angle at which the radius is seen, in units of half the picture's height.
    let radius = 1.0 / 1.1e7 / (1.3e-5f64 / 2.0).to_radians().tan();
    // The directions are rounded to 1e-16 and the sphere is 9e-8 wide in them.
    let slack = 1e-8;
    for ([x, y], colour) in pixels(&film) {
        let distance = x.hypot(y);
        if (distance - radius).abs() > slack {
            let inside = distance < radius;
            assert_eq!(colour != background, inside, "{x} {y}");
        }
    }
    // It is lit from (4, 5, 6): in that direction it is as bright as it gets, 0.9 + 0.1.
    let length = 77f64.sqrt();
    let brightest = pixels(&film).min_by(|(a, _), (b, _)| {
        let off = |p: &[f64; 2]| (p[0] - radius * 4.0 / length).hypot(p[1] - radius * 5.0 / length);
        off(a).total_cmp(&off(b))
    });
    let (_, colour) = brightest.unwrap();
    assert!((colour[0] - 0.9).abs() < 0.01, "{colour:?}");
}

#[test]
fn no_light_gets_under_a_sheet() {
    let film = picture(&text("sheet"), SIZE);
    let dim = |c: [f64; 3]| c.map(|x| (0.15 * x) as f32);
    let [ground, sheet, ball] = [[0.9, 0.75, 0.3], [0.5, 0.55, 0.6], [0.9, 0.3, 0.2]].map(dim);
    for ([x, y], colour) in pixels(&film) {
        // The ball at (1, 0.3, -4) is seen from (0, 0.4, 0), all in millionths.
        let scale = (45f64 / 2.0).to_radians().tan();
        let (dx, dy) = (x * scale, y * scale);
        let [cx, cy, cz, r] = [1.0, -0.1, -4.0, 0.3];
        let along = (cx * dx + cy * dy - cz) / (dx * dx + dy * dy + 1.0);
        let off = [cx - along * dx, cy - along * dy, cz + along];
        let off = off.iter().map(|x| x * x).sum::<f64>().sqrt() - r;
        let expected = match () {
            () if off.abs() < 1e-6 => continue,
            () if off < 0.0 => ball,
            () if y < 0.0 => ground,
            () => sheet,
        };
        assert!(
            (0..3).all(|c| (colour[c] - expected[c]).abs() < 1e-6),
            "{x} {y}: {colour:?} instead of {expected:?}"
        );
    }
}

/// Rays exactly through seams and along flat steps see what rays just above or just below see. So do
/// rays through apexes but for the apexes themselves: a line through the upright one and along a
/// generator of the turned one touch in one point or along a line, and a touch has no pixel.
#[test]
fn rows_through_seams_are_like_their_neighbours() {
    for (name, apexes) in [("lathe", 0), ("cone-apex", 2)] {
        let text = text(name);
        let shifted = |y: &str| {
            let moved = format!("40 -1 0 {y} 9");
            picture(&edited(&text, &[("40 -1 0 0 9", &moved)]), SIZE)
        };
        let (exact, above, below) = (picture(&text, SIZE), shifted("1e-6"), shifted("-1e-6"));
        for y in 0..SIZE[1] {
            let off = |other: &Film| {
                let differs = |x: &u32| !alike(exact.pixel(*x, y), other.pixel(*x, y));
                (0..SIZE[0]).filter(differs).count()
            };
            let least = off(&above).min(off(&below));
            assert!(least <= apexes, "{name}: {least} pixels of row {y}");
        }
    }
}

/// How long the part of a ray inside the cube of `glass-corner` is, as a multiple of its direction;
/// negative where the ray passes it by.
fn chord(origin: [f64; 3], direction: [f64; 3]) -> f64 {
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let into = |v: [f64; 3]| [cos * v[0] - sin * v[2], v[1], sin * v[0] + cos * v[2]];
    let origin = into([origin[0] + 1.2e-3, origin[1] - 1e-5, origin[2]]);
    let direction = into(direction);
    let slabs = [(-1e-3, 1e-3), (0.0, 2e-3), (-1e-3, 1e-3)];
    let (mut enter, mut leave) = (0f64, f64::INFINITY);
    for (i, (low, high)) in slabs.into_iter().enumerate() {
        let [a, b] = [low, high].map(|x| (x - origin[i]) / direction[i]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    leave - enter
}

/// Light that goes through an edge of the glass is dimmed by kt², however short its way there.
#[test]
fn light_through_an_edge_is_dimmed_twice() {
    // Without the prism, through which the ground is seen bent.
    let film = picture(
        &edited(&text("glass-corner"), &[("40 -101 30 37", "40 -105 30")]),
        SIZE,
    );
    let (eye, light) = ([0.0, 6e-3, 9e-3], [-4e-3, 7e-3, 4e-3]);
    let half = 19f64.to_radians().tan();
    let length = 0.62f64.hypot(1.0);
    let (mut checked, mut short) = (0, 0);
    for ([x, y], colour) in pixels(&film) {
        let (x, y) = (x * half, y * half);
        let way = [x, (y - 0.62) / length, (-1.0 - 0.62 * y) / length];
        let t = -eye[1] / way[1];
        let ground = [t * way[0], 0.0, eye[2] + t * way[2]];
        // In units of the cells of the checkerboard, along x and against z.
        let [u, v] = [1e3 * ground[0], -1e3 * ground[2]];
        let on_line = |x: f64| (x - x.round()).abs() < 1e-9;
        if t < 0.0 || on_line(u) || on_line(v) || chord(eye, way) > -1e-9 {
            continue;
        }
        let to_light: [f64; 3] = std::array::from_fn(|i| light[i] - ground[i]);
        let distance = to_light.iter().map(|x| x * x).sum::<f64>().sqrt();
        let within = chord(ground, to_light) * distance;
        if within.abs() < 1e-12 {
            continue;
        }
        let dimmed = if within > 0.0 { 0.6 * 0.6 } else { 1.0 };
        let brightness = 0.15 + 0.85 * dimmed * to_light[1] / distance;
        let odd = (u.floor() + v.floor()).rem_euclid(2.0) > 0.5;
        let albedo = [[0.95, 0.85, 0.6], [0.75, 0.6, 0.4]][usize::from(odd)];
        let right = (0..3).all(|c| (f64::from(colour[c]) - albedo[c] * brightness).abs() < 1e-6);
        assert!(right, "{ground:?}: {colour:?}, {within} within the glass");
        checked += 1;
        short += usize::from(within > 0.0 && within < 1e-4);
    }
    // The cases that a distance of 1e-4 takes for one crossing are among them.
    assert!(checked > 10_000 && short > 0, "{checked} {short}");
}
