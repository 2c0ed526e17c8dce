//! What accuracy costs in time: on scenes so small that the answers can be known.

use crate::support::program::{text, zpg};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use serde_json::Value;
use zpg::internals::analysis::Analysis;
use zpg::internals::scene::Scene;
use zpg::internals::study::accuracy::check;
use zpg::internals::study::accuracy::configurations::{Kernel, Settings};
use zpg::internals::study::accuracy::measure::compare;
use zpg::internals::study::accuracy::runner::Runner;
use zpg::internals::study::accuracy::sample_tiles::{Tile, chosen};
use zpg::internals::study::naive::{Naive, Wide};
use zpg::internals::trace::camera::View;
use zpg::internals::trace::film::developed;
use zpg::internals::trace::switches::Without;
use zpg::internals::trace::{self, Images, Numbers, Tracer, selected_camera};

/// A glass ball that disperses and a mirroring one on a checkered floor, and a torus; two lamps.
const SCENE: &str = "\
2 11 -0.8 0.7 0  0.7\n2 -201 0.05 0.15 0.8\n2 -203 1.4 1.5 1.6\n\
3 11 0.9 0.6 -0.4  0.6\n3 -201 0.4 0.6 0\n3 -701 0.9 0.3 0.2\n\
4 14 0.5 0.15\n4 -1 0.2 0.15 1.2\n4 -701 0.2 0.5 0.9\n\
5 4 0 1 0 0\n6 -701 0.9 0.9 0.8\n7 -701 0.2 0.3 0.5\n5 -399 2 2 6 7\n\
8 -101 2 3\n9 -101 8 4\n10 -101 9 5\n\
20 -501 0.4 1.8 4.5 -0.05 -0.3 -1 0 1 0 40\n\
50 -402 0.7\n50 -1 3 5 4\n51 -402 0.4\n51 -1 -4 3 2\n52 -401 0.1\n1 9999 10 0\n";

fn resolved(text: &str) -> Arc<Scene> {
    let analysis = Analysis::new("scene.zpg", text.as_bytes().to_vec());
    assert!(analysis.is_sound(), "{:?}", analysis.findings());
    Arc::new(analysis.scene)
}

fn hard(name: &str) -> Arc<Scene> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/hard/{name}.zpg"));
    resolved(&fs::read_to_string(path).unwrap())
}

const SIZE: [u32; 2] = [48, 36];

fn runner<'i>(scene: &Arc<Scene>, images: &'i Images) -> Runner<'i> {
    let camera = selected_camera(scene, f64::from(SIZE[0]) / f64::from(SIZE[1]));
    Runner::new(scene.clone(), images, camera, SIZE).unwrap()
}

fn with(kernel: Kernel) -> Settings {
    Settings {
        kernel,
        ..Settings::default()
    }
}

#[test]
fn tiles_are_the_picture() {
    let scene = resolved(SCENE);
    let images = Images::default();
    let mut runner = runner(&scene, &images);
    let tiles = chosen(SIZE, 1);
    let tracer = Tracer::new(&scene).unwrap();
    for (samples, tolerance) in [(1, None), (4, None), (1, Some(0.05))] {
        let settings = Settings {
            samples,
            tolerance,
            ..Settings::default()
        };
        let drawn = runner.draw(&settings, &tiles).unwrap();
        let timed = runner.time(&settings, &tiles).unwrap();
        let taken = trace::Settings {
            width: SIZE[0],
            height: SIZE[1],
            samples,
            tolerance,
            ..trace::Settings::default()
        };
        let picture = tracer.render(runner.camera(), &taken, || ()).unwrap();
        let pixels = tiles.iter().flat_map(|t| t.pixels());
        for (([x, y], colour), timed) in pixels.zip(&drawn.colours).zip(&timed.drawn.colours) {
            assert_eq!(developed(*colour), picture.film.pixel(x, y), "{x} {y}");
            assert_eq!(colour, timed);
        }
    }
}

#[test]
fn the_independent_tracer_agrees_and_sees_what_is_off() {
    let scene = resolved(SCENE);
    let images = Images::default();
    let mut runner = runner(&scene, &images);
    let tiles = chosen(SIZE, 1);
    let settings = with(Kernel::Ours(Numbers::Dd));
    let mut right = runner.draw(&settings, &tiles).unwrap().colours;
    let seen = runner.seen(&Settings::default(), &tiles).unwrap();
    let order = check::order(&tiles, &seen);
    assert_eq!(order.len(), right.len());
    let checked = check::check(&runner, &images, &settings, &order, &right, [0.0, 1e9]);
    let checked = checked.unwrap().unwrap();
    assert_eq!(
        (checked.pixels, checked.wrong),
        (check::MIN_PIXELS, 0),
        "{checked:?}"
    );
    assert!(checked.rays > 300 && checked.largest < 1e-12, "{checked:?}");
    // One pixel that is off by less than anybody sees.
    right[order[7].0][1] += 1e-5;
    let checked = check::check(&runner, &images, &settings, &order, &right, [0.0, 1e9]);
    let checked = checked.unwrap().unwrap();
    assert_eq!((checked.wrong, checked.wrong_pixels), (1, vec![order[7].1]));
}

/// A ray along a generator of a cone: which side of it the camera's doubles lie on is no mistake of the tracer. Another
/// colour is one all the same.
#[test]
fn what_the_rounding_of_a_camera_changes_is_no_mistake() {
    let scene = hard("cone-apex");
    let images = Images::default();
    let size = [96, 72];
    let camera = selected_camera(&scene, 96.0 / 72.0);
    let mut runner = Runner::new(scene.clone(), &images, camera, size).unwrap();
    let [x, y] = [79, 35];
    let tile = Tile {
        x,
        y,
        width: 1,
        height: 1,
    };
    let settings = with(Kernel::Ours(Numbers::Dd));
    let mut ours = runner.draw(&settings, &[tile]).unwrap().colours;
    let pixels = vec![(0, [x, y])];
    let checked = |ours: &[[f64; 3]]| {
        let checked = check::check(&runner, &images, &settings, &pixels, ours, [0.0, 1e9]);
        let checked = checked.unwrap().unwrap();
        (checked.pixels, checked.wrong, checked.camera_rounding)
    };
    assert_eq!(checked(&ours), (1, 0, 1));
    ours[0][1] += 1e-5;
    assert_eq!(checked(&ours), (1, 1, 0));
}

/// The rays of all cameras are those of doubles: far nearer to the exact ones than [`check::SAME_RAY`], so that no
/// wrong ray is taken for a rounded one.
#[test]
fn rays_of_cameras_are_right_but_for_rounding() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let scenes = ["gallery", "hard"].map(|name| fs::read_dir(folder.join(name)).unwrap());
    let mut count = 0;
    for entry in scenes.into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "zpg") || path.metadata().unwrap().len() > 100_000 {
            continue;
        }
        let analysis = Analysis::new("scene.zpg", fs::read(&path).unwrap());
        let scene = analysis.scene;
        for camera in &scene.cameras {
            let [width, height] = SIZE;
            let images = Images::default();
            let view = View::new(camera, width, height).unwrap();
            let Ok(naive) = Naive::<Wide>::new(&scene, &images, camera, SIZE, 0, 1.0) else {
                continue;
            };
            for place in [[0, 0], [17, 30], [47, 35]] {
                let [x, y] = place.map(|x: u32| f64::from(x) + 0.5);
                let line = view.ray(x, y).unwrap().line;
                let off = naive.aside(place, line.origin.0, line.direction.0);
                assert!(off < 1e-14, "{path:?}: {off:e}");
                count += 1;
            }
        }
    }
    assert!(count >= 60, "{count}");
}

/// All shapes, operations and textures, in the corners of the hard scenes.
#[test]
fn the_independent_tracer_agrees_on_hard_scenes() {
    for name in [
        "flush-box",
        "glass-corner",
        "equal-solids",
        "lathe",
        "paraboloid",
        "cone-apex",
    ] {
        let scene = hard(name);
        let images = Images::default();
        let mut runner = runner(&scene, &images);
        let tiles: Vec<Tile> = chosen(SIZE, 1).into_iter().step_by(3).collect();
        let settings = with(Kernel::Ours(Numbers::Dd));
        let ours = runner.draw(&settings, &tiles).unwrap().colours;
        let pixels: Vec<[u32; 2]> = tiles.iter().flat_map(|t| t.pixels()).step_by(9).collect();
        let (depth, cutoff) = (settings.depth, settings.cutoff);
        let naive =
            Naive::<Wide>::new(&scene, &images, runner.camera(), SIZE, depth, cutoff).unwrap();
        let found = naive.pixels(&pixels).unwrap();
        for ((a, b), pixel) in ours.iter().step_by(9).zip(&found).zip(&pixels) {
            let b = b.colour;
            let off = (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{name} {pixel:?}: {a:?} {b:?}");
        }
    }
}

#[test]
fn a_plain_kernel_is_right_where_it_is_easy_and_wrong_where_it_is_hard() {
    let off = |scene: &Arc<Scene>, kernel| {
        let images = Images::default();
        let mut runner = runner(scene, &images);
        let tiles = chosen(SIZE, 1);
        let exact = runner
            .draw(&with(Kernel::Ours(Numbers::Dd)), &tiles)
            .unwrap();
        let drawn = runner.draw(&with(kernel), &tiles).unwrap();
        let sizes: Vec<[u32; 2]> = tiles.iter().map(|t| [t.width, t.height]).collect();
        compare(&drawn.colours, &exact.colours, &sizes, true).pixels_off
    };
    let easy = resolved(SCENE);
    assert_eq!(off(&easy, Kernel::PlainF64), 0);
    for name in ["flush-box", "thin-torus-far", "small-sphere"] {
        let scene = hard(name);
        assert!(off(&scene, Kernel::PlainF32) > 10, "{name}");
        assert_eq!(off(&scene, Kernel::Ours(Numbers::F64)), 0, "{name}");
    }
    assert!(off(&hard("flush-box"), Kernel::PlainF64) > 10);
}

#[test]
fn effects_that_are_taken_out_do_no_work() {
    let scene = resolved(SCENE);
    let images = Images::default();
    let mut runner = runner(&scene, &images);
    let tiles = chosen(SIZE, 1);
    let none = Without::default();
    let counts = |runner: &mut Runner, without| {
        let settings = Settings {
            without,
            ..Settings::default()
        };
        runner.draw(&settings, &tiles).unwrap().counts
    };
    let all = counts(&mut runner, none);
    assert!(all.rays.shadow > 0 && all.rays.reflection > 0 && all.rays.refraction > 0);
    assert!(all.work.transparent_shadow > 0 && all.work.checkerboard > 0);
    assert!(all.work.channel_split > 0);
    let shadows = counts(
        &mut runner,
        Without {
            shadows: true,
            ..none
        },
    );
    assert_eq!(
        (shadows.rays.shadow, shadows.rays.reflection),
        (0, all.rays.reflection)
    );
    let clear = Without {
        transparent_shadows: true,
        ..none
    };
    assert_eq!(counts(&mut runner, clear).work.transparent_shadow, 0);
    let mirrors = counts(
        &mut runner,
        Without {
            reflection: true,
            ..none
        },
    );
    assert_eq!((mirrors.rays.reflection, mirrors.rays.total > 0), (0, true));
    assert_eq!(
        counts(
            &mut runner,
            Without {
                refraction: true,
                ..none
            }
        )
        .rays
        .refraction,
        0
    );
    assert_eq!(
        counts(
            &mut runner,
            Without {
                dispersion: true,
                ..none
            }
        )
        .work
        .channel_split,
        0
    );
    assert_eq!(
        counts(
            &mut runner,
            Without {
                textures: true,
                ..none
            }
        )
        .work
        .checkerboard,
        0
    );
    // And they come back.
    assert_eq!(counts(&mut runner, none), all);
}

/// Runs zpg in a folder: its exit status, standard output and standard error.
fn ends(folder: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    let run = zpg(folder, args);
    (run.status.code(), text(&run.stdout), text(&run.stderr))
}

/// A page without what encodes its pictures: the picture of times differs from run to run, and letters follow each
/// other there by chance.
fn words(page: &str) -> String {
    let (first, rest) = page.split_once(PICTURE).unwrap();
    let after = |part: &str| String::from(part.split_once('"').unwrap().1);
    String::from(first) + &rest.split(PICTURE).map(after).collect::<String>()
}

/// What was left out to keep the time.
fn cut(out: &str) -> String {
    let lines = out
        .lines()
        .skip_while(|line| !line.starts_with("left out to keep"));
    lines
        .take_while(|line| !line.starts_with("times are sure"))
        .collect()
}

const PICTURE: &str = "data:image/png;base64,";

#[test]
fn a_report_says_what_to_set() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), SCENE).unwrap();
    // Where others have the processor, some settings are left out: then once more, with time enough.
    for budget in ["60s", "20m"] {
        let args = [
            "accuracy", "a.zpg", "--size", "32x24", "--runs", "3", "-o", "out", "--budget", budget,
        ];
        let (status, out, error) = ends(dir.path(), &args);
        assert_eq!((status, error.as_str()), (Some(0), ""), "{out}");
        assert!(
            out.lines().count() < 60
                && out.contains("▶ The largest error of this picture comes from edges"),
            "{out}"
        );
        if ["depth 0", "samples 16", "f32", "dd"]
            .iter()
            .all(|s| !cut(&out).contains(s))
        {
            break;
        }
    }

    let file = |name: &str| fs::read_to_string(dir.path().join("out").join(name)).unwrap();
    let report: Value = serde_json::from_str(&file("accuracy.json")).unwrap();
    let rows = report["rows"].as_array().unwrap();
    let row = |axis: &str, setting: &str| {
        let found = rows
            .iter()
            .find(|r| r["axis"] == axis && r["setting"] == setting);
        found.unwrap_or_else(|| panic!("{axis} {setting}"))
    };
    let steps = |axis, setting| row(axis, setting)["error"]["steps"].as_f64().unwrap();
    // More samples, deeper rays and better numbers are better.
    assert!(steps("samples", "1") > 2.0 * steps("samples", "16"));
    assert!(steps("depth", "0") > 10.0 * steps("depth", "4"));
    assert!(steps("depth", "4") > steps("depth", "10"));
    assert!(steps("cutoff", "0.1") > steps("cutoff", "1/256"));
    assert!(steps("precision", "f32") > steps("precision", "f64"));
    assert_eq!(row("precision", "f64")["error"]["pixels_off"], 0);
    assert_eq!(row("precision", "dd")["error"]["pixels_differ"], 0);
    for (axis, setting) in [
        ("samples", "1"),
        ("depth", "10"),
        ("cutoff", "1/4096"),
        ("precision", "f64"),
    ] {
        assert_eq!(row(axis, setting)["default"], true);
        assert_eq!(row(axis, setting)["times_default"], 1.0);
    }
    assert_eq!(rows.iter().filter(|r| r["default"] == true).count(), 5);
    let times = row("samples", "4")["times_default"].as_f64().unwrap();
    assert!((2.0..8.0).contains(&times), "{times}");
    let numbers = &report["reference"]["numbers"];
    assert_eq!(
        (&numbers["wrong"], numbers["not_checked"].is_null()),
        (&Value::from(0), true)
    );
    assert!(numbers["pixels"].as_u64().unwrap() >= 120);
    assert!(report["noise"]["pairs"].as_u64().unwrap() >= 3);
    let why: Vec<&str> = (report["skipped"].as_array().unwrap().iter())
        .map(|s| s["axis"].as_str().unwrap())
        .collect();
    assert_eq!(why, ["tessellation", "levels"]);
    let share: f64 = (report["objects"].as_array().unwrap().iter())
        .map(|o| o["share_of_time"].as_f64().unwrap())
        .sum();
    assert!((share - 1.0).abs() < 1e-9, "{share}");
    let effects: Vec<&str> = (report["effects"].as_array().unwrap().iter())
        .map(|e| e["name"].as_str().unwrap())
        .collect();
    let all = [
        "shadows",
        "transparent-shadows",
        "reflection",
        "refraction",
        "dispersion",
        "textures",
    ];
    assert_eq!(effects, all);

    let page = file("accuracy.html");
    assert!(page.len() < 400_000, "{}", page.len());
    assert!(!page.contains("<script"));
    assert_eq!(words(&page).matches("NaN").count(), 0, "{page}");
    assert!(page.contains("prefers-color-scheme:dark") && page.contains(PICTURE));
    for href in ["src=\"http", "href=\"http", "@import"] {
        assert!(!page.contains(href));
    }
    assert!(
        file("accuracy.svg").starts_with("<svg xmlns=") && !file("accuracy.svg").contains("NaN")
    );
    assert!(file("accuracy.md").contains("| depth 10 |"));
}

/// Whoever else has the processor: what does not fit is left out.
#[test]
fn the_budget_is_kept() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), SCENE).unwrap();
    let args = [
        "accuracy",
        "a.zpg",
        "--budget",
        "10s",
        "--axes",
        "samples,adaptive,depth,cutoff",
        "--json",
    ];
    let start = Instant::now();
    let (status, out, error) = ends(dir.path(), &args);
    let spent = start.elapsed().as_secs_f64();
    assert_eq!((status, error.as_str()), (Some(0), ""), "{out}");
    // There is a least that is done: without any optimisation, and with half a dozen others at work, it took 23 s.
    assert!(spent < 45.0, "{spent}");
    let report: Value = serde_json::from_str(&out).unwrap();
    let rows = report["rows"].as_array().unwrap();
    assert!(rows.iter().any(|r| r["times_default"].is_number()), "{out}");
    assert!(report["machine"]["wall_over_cpu"].as_f64().unwrap() > 0.9);
}

#[test]
fn a_report_in_czech_on_one_axis() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), "2 11 0 0 0 1\n1 9999 2 0\n").unwrap();
    let args = [
        "accuracy", "a.zpg", "--size", "16x16", "--budget", "1s", "--runs", "1", "--lang", "cs",
    ];
    let (status, out, _) = ends(
        dir.path(),
        &[&args[..], &["--axes", "samples,depth"]].concat(),
    );
    assert_eq!(status, Some(0), "{out}");
    assert!(
        out.contains("Největší chybu v tomto obrázku působí hrany"),
        "{out}"
    );
    assert!(
        out.contains("nic nezrcadlí") && out.contains("nebylo požadováno"),
        "{out}"
    );
    assert!(dir.path().join("a-accuracy/accuracy.html").exists());
}

#[test]
fn wrong_usage_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), "2 11 0 0 0 1\n1 9999 2 0\n").unwrap();
    for args in [
        &["accuracy"][..],
        &["accuracy", "a.zpg", "--budget", "soon"],
        &["accuracy", "a.zpg", "--goal", "0"],
        &["accuracy", "a.zpg", "--axes", "colour"],
        &["accuracy", "a.zpg", "--runs", "0"],
        &["accuracy", "none.zpg"],
    ] {
        let (status, out, error) = ends(dir.path(), args);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{args:?}");
        assert!(
            !error.is_empty() && !error.contains("panicked"),
            "{args:?} {error}"
        );
    }
}

/// `benches/planted` replaces lines of the tracer: each must be there once.
#[test]
fn the_defects_of_the_campaign_can_be_planted() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let campaign = fs::read_to_string(root.join("benches/planted")).unwrap();
    let mut planted = 0;
    for defect in campaign.split("\nplant ").skip(1) {
        let (head, rest) = defect.split_once('\n').unwrap();
        let file = head.split_whitespace().nth(1).unwrap();
        let line = rest.lines().next().unwrap().trim();
        let old = line.strip_prefix('\'').and_then(|l| l.strip_suffix("' \\"));
        let source = fs::read_to_string(root.join(file)).unwrap();
        assert_eq!(source.matches(old.unwrap()).count(), 1, "{head}");
        planted += 1;
    }
    assert_eq!(planted, 3);
}
