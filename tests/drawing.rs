//! What `zpg render` says of a picture, and the files and scenes it takes.

use crate::support::program::{folder, started, text, zpg};
use std::fs;
use std::path::Path;

const SMALL: [&str; 2] = ["--size", "40x30"];
const BALL: &str = "2 9 1\n1 9999 2 0\n";
const CAMERA: &str = "9 -501 0 0 5 0 0 -1 0 1 0 45\n";
const LAMP: &str = "50 -402 0.9\n50 -1 0 0 30\n";

/// Standard output and standard error of a run that ends well.
fn render(dir: &Path, options: &[&str]) -> [String; 2] {
    let out = zpg(dir, &[&["render"], &SMALL[..], options].concat());
    let said = [text(&out.stdout), text(&out.stderr)];
    assert_eq!(out.status.code(), Some(0), "{said:?}");
    said
}

#[test]
fn what_is_wrong_with_a_picture_is_said() {
    let away = "9 -501 0 0 5 0 0 1 0 1 0 45\n";
    let within = "9 -501 0 0 0 0 0 1 0 1 0 45\n";
    let behind = "50 -402 0.9\n50 -1 0 0 -30\n";
    let glaring = "50 -402 2\n50 -1 0 0 1000\n";
    let (no_camera, no_light) = ("the scene has no camera", "the scene has no light");
    for (parts, meant) in [
        (vec![CAMERA, LAMP], vec![]),
        (vec![LAMP], vec![no_camera]),
        (vec![CAMERA], vec![no_light]),
        (vec![], vec![no_camera, no_light]),
        (vec![away, LAMP], vec!["nothing is in view"]),
        (vec![within, LAMP], vec!["the camera is inside of a solid"]),
        (vec![CAMERA, behind], vec!["no light falls on anything"]),
        (
            vec![CAMERA, glaring],
            vec!["brighter than white; `--exposure 0.50`"],
        ),
    ] {
        let dir = folder(&[("a.zpg", parts.concat() + BALL)]);
        let [wrote, said] = render(dir.path(), &["a.zpg"]);
        assert_eq!(wrote, "Wrote a.png: 40 × 30 pixels\n");
        let lines: Vec<&str> = said.lines().collect();
        assert_eq!(lines.len(), meant.len(), "{parts:?}: {said}");
        for (line, meant) in lines.iter().zip(meant) {
            assert!(line.starts_with("note: ") && line.contains(meant), "{line}");
        }
        assert_eq!(
            render(dir.path(), &["a.zpg", "-q"]),
            [String::new(), String::new()]
        );
    }
}

/// A view of the whole scene shows nothing only where there is nothing; what is brighter than white by one record is told so.
#[test]
fn what_check_explains_is_left_to_it() {
    let nothing = "the scene has nothing that could be seen; `zpg check` says why\n";
    let flat = "2 1 2  0 0  1 0\n1 9999 2 0\n";
    let swapped = "3 9 1\n4 9 2\n2 -103 3 4\n1 9999 2 0\n";
    for (scene, options, line) in [
        ([LAMP, swapped].concat(), &["--view", "iso"][..], nothing),
        (
            [CAMERA, LAMP, swapped].concat(),
            &["--view", "top"],
            nothing,
        ),
        (
            [CAMERA, LAMP, swapped].concat(),
            &[],
            "nothing is in view; `--view iso` shows the whole scene\n",
        ),
        (
            [
                CAMERA,
                LAMP,
                "20 -701 204 25 25\n2 9 1\n2 -299 20 0\n1 9999 2 0\n",
            ]
            .concat(),
            &[],
            "brighter than white: the record 20 gives out more light than it gets; `zpg check` says what to write\n",
        ),
    ] {
        let dir = folder(&[("a.zpg", scene)]);
        let said = &render(dir.path(), &[&["a.zpg"], options].concat())[1];
        assert!(said.ends_with(line), "{said}");
    }
    // A negative part makes nothing brighter, and what a comment allows is meant.
    let glaring = "50 -402 2\n50 -1 0 0 1000\n";
    let dark = "2 9 1\n2 -701 1 1 -1\n1 9999 2 0\n";
    let meant = "2 9 1\n2 -701 204 1 1 # zpg: allow(W301) #\n1 9999 2 0\n";
    for scene in [dark, meant] {
        let dir = folder(&[("a.zpg", [CAMERA, glaring, scene].concat())]);
        let said = &render(dir.path(), &["a.zpg"])[1];
        assert!(said.contains("`--exposure 0."), "{said}");
    }
    let dir = folder(&[("a.zpg", [CAMERA, LAMP, flat].concat())]);
    let said = &render(dir.path(), &["a.zpg", "--view", "iso"])[1];
    assert!(said.ends_with(nothing), "{said}");
}

/// The render record names an earlier step of the scene, or something was forgotten in it.
#[test]
fn objects_that_are_not_drawn_are_counted() {
    let balls = "3 11 1 0 0 1\n4 11 0 1 0 1\n";
    let scene = |line: &str| [CAMERA, LAMP, "2 9 1\n", balls, line, "1 9999 2 0\n"].concat();
    for (scene, [english, czech]) in [
        ([CAMERA, LAMP, BALL].concat(), ["", ""]),
        (
            scene("5 -101 2 3\n6 -101 5 4\n"),
            [
                "note: 1 object is not drawn: `zpg check` says which\n",
                "poznámka: 1 objekt se nezobrazí: který, řekne `zpg check`\n",
            ],
        ),
        (
            scene(""),
            [
                "note: 2 objects are not drawn: `zpg check` says which\n",
                "poznámka: 2 objekty se nezobrazí: které, řekne `zpg check`\n",
            ],
        ),
        ("# zpg: allow(W310) #\n".to_owned() + &scene(""), ["", ""]),
    ] {
        let dir = folder(&[("a.zpg", scene)]);
        assert_eq!(render(dir.path(), &["a.zpg"])[1], english);
        assert_eq!(render(dir.path(), &["a.zpg", "--lang", "cs"])[1], czech);
        assert_eq!(render(dir.path(), &["a.zpg", "-q"])[1], "");
    }
}

/// A comma between two digits is read as a space, and the picture shows something else.
#[test]
fn decimal_commas_are_said() {
    for (ball, [english, czech]) in [
        (
            "2 11 0,5 0 1\n",
            [
                "note: line 10: `0,5` is read as two numbers, `0 5`; write a decimal point if it is one\n",
                "poznámka: řádek 10: `0,5` se čte jako dvě čísla, `0 5`; je-li to jedno, napište desetinnou tečku\n",
            ],
        ),
        (
            "2 11 0,5 0 1\n2 -1 0,0 0\n",
            [
                "note: line 10: `0,5` is read as two numbers, `0 5`; write a decimal point if it is one (1 more like it)\n",
                "poznámka: řádek 10: `0,5` se čte jako dvě čísla, `0 5`; je-li to jedno, napište desetinnou tečku (takových je ještě 1)\n",
            ],
        ),
        // A list in commas throughout is none.
        ("2 11 0,5,0,1\n", ["", ""]),
    ] {
        let far = "9 -501 0 5 9 0 0 -1 0 1 0 45\n";
        let scene = [far, "50 -401 0.3\n", ball, "1 9999 2 0\n"].concat();
        let line = scene.lines().position(|line| line.contains("0,5")).unwrap() + 1;
        let dir = folder(&[("a.zpg", scene)]);
        let at = |text: &str| text.replace("10:", &format!("{line}:"));
        assert_eq!(render(dir.path(), &["a.zpg"])[1], at(english));
        assert_eq!(render(dir.path(), &["a.zpg", "--lang", "cs"])[1], at(czech));
        assert_eq!(render(dir.path(), &["a.zpg", "-q"])[1], "");
    }
}

/// A part of the picture that shows only background is not nothing in view of the whole, but of what is drawn.
#[test]
fn a_view_from_a_side_lacks_no_camera() {
    let dir = folder(&[("a.zpg", [LAMP, BALL].concat())]);
    assert_eq!(render(dir.path(), &["a.zpg", "--view", "front"])[1], "");
    let corner = render(
        dir.path(),
        &["a.zpg", "--view", "front", "--crop", "0,0,4,4"],
    );
    assert!(corner[1].contains("nothing is in view"));
}

/// A camera within a solid of which the render box leaves nothing there is outside.
#[test]
fn a_box_that_leaves_the_camera_out() {
    let cut = "2 9 9\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -401 0.8\n1 9999 2 0  -2 -2 -9 2 2 2\n";
    let dir = folder(&[
        ("a.zpg", cut),
        ("b.zpg", &cut.replace("9 2 2 2", "9 2 2 6")),
    ]);
    assert_eq!(render(dir.path(), &["a.zpg"])[1], "");
    assert!(render(dir.path(), &["b.zpg"])[1].contains("the camera is inside of a solid"));
}

/// `--exposure` makes what it proposes true: nothing is brighter than white any more, and hardly darker.
#[test]
fn exposure_mends_what_is_too_bright() {
    let glaring = "50 -402 3.7\n50 -1 0 0 1000\n";
    let dir = folder(&[("a.zpg", [CAMERA, glaring, BALL].concat())]);
    let [_, said] = render(dir.path(), &["a.zpg", "-o", "a.pfm"]);
    let exposure = said
        .split("--exposure ")
        .nth(1)
        .unwrap()
        .split('`')
        .next()
        .unwrap();
    let most = |name: &str| {
        let bytes = fs::read(dir.path().join(name)).unwrap();
        let values = bytes[bytes.len() - 40 * 30 * 12..].chunks(4);
        values
            .map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
            .fold(0.0, f32::max)
    };
    let [_, said] = render(
        dir.path(),
        &["a.zpg", "-o", "b.pfm", "--exposure", exposure],
    );
    assert_eq!(said, "");
    assert!((0.95..=1.0).contains(&most("b.pfm")));
    let times: f32 = exposure.parse().unwrap();
    assert!((most("a.pfm") * times - most("b.pfm")).abs() < 1e-6);
}

#[test]
fn nothing_is_said_of_the_gallery() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let target = folder::<&str>(&[]);
    for name in [
        "bracket", "chain", "dice", "geodesic", "island", "orrery", "pawns", "quadrics", "spectrum",
    ] {
        let picture = target.path().join("a.png");
        let picture = picture.to_string_lossy();
        let scene = format!("{name}.zpg");
        assert_eq!(render(&gallery, &[&scene, "-o", &picture])[1], "", "{name}");
    }
}

#[test]
fn qualities_are_settings_of_the_front() {
    let dir = folder(&[("a.zpg", [CAMERA, LAMP, BALL].concat())]);
    let bytes = |options: &[&str]| {
        render(dir.path(), &[&["a.zpg", "-o", "a.pfm"], options].concat());
        fs::read(dir.path().join("a.pfm")).unwrap()
    };
    for (quality, same) in [
        ("draft", ["--samples", "1"]),
        ("good", ["--adaptive", "0.05"]),
        ("final", ["--adaptive", "0.01"]),
    ] {
        assert_eq!(bytes(&["--quality", quality]), bytes(&same));
    }
    assert_ne!(
        bytes(&["--quality", "good"]),
        bytes(&["--quality", "final"])
    );
}

/// Decoded by another library, they show what the PNG shows.
#[test]
fn jpeg_and_webp_are_the_same_picture() {
    let dir = folder(&[(
        "a.zpg",
        [CAMERA, LAMP, BALL, "2 -701 0.9 0.4 0.1\n"].concat(),
    )]);
    let pixels = |name: &str| {
        render(dir.path(), &["a.zpg", "-o", name, "--samples", "16"]);
        image::open(dir.path().join(name)).unwrap().to_rgb8()
    };
    let png = pixels("a.png");
    assert_eq!(pixels("a.webp"), png);
    for name in ["a.jpg", "b.JPEG"] {
        let jpeg = pixels(name);
        assert_eq!(jpeg.dimensions(), (40, 30));
        let off = jpeg.iter().zip(png.iter()).map(|(a, b)| a.abs_diff(*b));
        assert!(off.max() < Some(40));
        let sum: u32 = jpeg
            .iter()
            .zip(png.iter())
            .map(|(a, b)| u32::from(a.abs_diff(*b)))
            .sum();
        assert!(f64::from(sum) / 3600.0 < 2.0, "{sum}");
    }
    for (name, size) in [("a.jpg", "70000x1"), ("a.webp", "1x16385")] {
        let out = zpg(dir.path(), &["render", "a.zpg", "-o", name, "--size", size]);
        assert_eq!(out.status.code(), Some(2));
        assert!(
            text(&out.stderr).contains("at most"),
            "{}",
            text(&out.stderr)
        );
    }
}

#[test]
fn several_scenes_go_into_a_folder() {
    let scene = [CAMERA, LAMP, BALL].concat();
    let dir = folder(&[
        ("a.zpg", scene.as_str()),
        ("b.zpg", &scene),
        ("in/c.zpg", &scene),
        ("in/a.zpg", &scene),
    ]);
    let [said, errors] = render(dir.path(), &["a.zpg", "b.zpg", "-o", "out"]);
    assert_eq!(errors, "");
    assert_eq!(
        said,
        "Wrote out/a.png: 40 × 30 pixels\nWrote out/b.png: 40 × 30 pixels\n"
    );
    render(dir.path(), &["in", "-o", "new/out"]);
    assert!(dir.path().join("new/out/c.png").exists());
    // Each class has a folder of its own.
    render(dir.path(), &[".", "-o", "all"]);
    for name in ["a.png", "b.png", "in/a.png", "in/c.png"] {
        assert!(dir.path().join("all").join(name).exists(), "{name}");
    }
    render(dir.path(), &["b.zpg", "-o", "one/"]);
    assert!(dir.path().join("one/b.png").exists());
    let [said, _] = render(dir.path(), &["a.zpg", "./a.zpg", "-o", "twice"]);
    assert_eq!(said, "Wrote twice/a.png: 40 × 30 pixels\n");
    let refused = |arguments: &[&str]| {
        let out = zpg(dir.path(), &[&["render"], arguments].concat());
        assert_eq!(out.status.code(), Some(2));
        text(&out.stderr)
    };
    assert!(refused(&["a.zpg", "b.zpg", "-o", "x.png"]).contains("x.png is one file"));
    assert!(refused(&["a.zpg", "b.zpg", "-o", "-"]).contains("standard output takes one picture"));
    assert!(refused(&["a.zpg", "b.zpg", "--stats", "s.json"]).contains("are for one scene"));
    let said = refused(&["a.zpg", "in", "-o", "out"]);
    assert!(
        said.contains("the pictures of a.zpg and in/a.zpg would both be out/a.png"),
        "{said}"
    );
}

/// It draws when the scene changes, and not when its own picture does.
#[test]
fn watching_draws_again() {
    let dir = folder(&[("a.zpg", [CAMERA, LAMP, BALL].concat())]);
    let arguments = ["render", "a.zpg", "--watch", "--size", "40x30"];
    let (mut child, [mut wrote, mut errors]) = started(dir.path(), &arguments);
    let mut next = || {
        let wrote = wrote.next().unwrap().unwrap();
        assert_eq!(wrote, "Wrote a.png: 40 × 30 pixels");
        assert_eq!(
            errors.next().unwrap().unwrap(),
            "Watching for changes; Ctrl-C ends it"
        );
        image::open(dir.path().join("a.png")).unwrap().to_rgb8()
    };
    let small = next();
    fs::write(
        dir.path().join("a.zpg"),
        [CAMERA, LAMP, "2 9 1.5\n1 9999 2 0\n"].concat(),
    )
    .unwrap();
    let large = next();
    assert!(
        large.pixels().filter(|p| p[0] > 0).count() > small.pixels().filter(|p| p[0] > 0).count()
    );
    // Were the picture itself a change, there would be more and more of them.
    std::thread::sleep(std::time::Duration::from_millis(1500));
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(wrote.next().is_none());
}
