//! The camera and the lights of a scene that has none, and views from a side: as where they are written out.

use crate::support::program::{folder, text, zpg};
use std::f64::consts::FRAC_1_SQRT_2;

/// A block from (0, 0, 0) to (2, 4, 6), and a ball on its right.
const THINGS: &str = "2 12 0 0 0 2 4 6\n3 11 5 1 3 1\n4 -101 2 3\n";

/// The middle of the things, and the radius of the ball around their box: from (0, 0, 0) to (6, 4, 6).
const CENTRE: [f64; 3] = [3.0, 2.0, 3.0];
const SIZE: &str = "80x60";

fn radius() -> f64 {
    (9.0f64 + 4.0 + 9.0).sqrt()
}

/// The picture of a scene.
fn pixels(scene: &str, options: &[&str]) -> Vec<u8> {
    let dir = folder(&[("a.zpg", scene)]);
    let arguments = ["render", "a.zpg", "-o", "a.png", "--size", SIZE];
    let out = zpg(dir.path(), &[&arguments, options].concat());
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    let picture = image::open(dir.path().join("a.png")).expect("a picture");
    picture.to_rgb8().into_raw()
}

#[track_caller]
fn are_alike(automatic: &[u8], written: &[u8]) {
    assert!(written.iter().any(|&x| x > 100), "nothing to see");
    let far = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 1;
    let off = automatic
        .iter()
        .zip(written)
        .filter(|&pair| far(pair))
        .count();
    // A ray may go by an edge on the other side.
    assert!(off <= 6, "{off} values differ");
}

/// Where something is that is seen from the middle at these angles, in degrees.
fn at(azimuth: f64, elevation: f64, distance: f64) -> [f64; 3] {
    let (a, e) = (azimuth.to_radians(), elevation.to_radians());
    let way = [a.sin() * e.cos(), e.sin(), a.cos() * e.cos()];
    [0, 1, 2].map(|i| CENTRE[i] + distance * way[i])
}

fn words(v: [f64; 3]) -> String {
    v.map(|x| x.to_string()).join(" ")
}

/// A camera that looks at the middle.
fn camera(azimuth: f64, elevation: f64, up: &str) -> String {
    let place = at(
        azimuth,
        elevation,
        1.05 * radius() / 22.5f64.to_radians().sin(),
    );
    let way = [0, 1, 2].map(|i| CENTRE[i] - place[i]);
    format!("9 -501 {} {} {up} 45\n", words(place), words(way))
}

/// An ambient light, and a lamp at these degrees to the right of the front.
fn lights(azimuth: f64) -> String {
    let lamp = words(at(azimuth, 45.0, 10.0 * radius()));
    format!("50 -401 0.2\n51 -402 0.8\n51 -1 {lamp}\n")
}

const RENDER: &str = "1 9999 4 0\n";

#[test]
fn what_a_scene_lacks_is_as_where_it_is_written_out() {
    let (three_quarter, lit) = (camera(30.0, 25.0, "0 1 0"), lights(-40.0));
    let whole = pixels(&[THINGS, &three_quarter, &lit, RENDER].concat(), &[]);
    are_alike(&pixels(&[THINGS, RENDER].concat(), &[]), &whole);
    are_alike(
        &pixels(&[THINGS, &three_quarter, RENDER].concat(), &[]),
        &whole,
    );
    are_alike(&pixels(&[THINGS, &lit, RENDER].concat(), &[]), &whole);
}

/// The lamp stands on the left of whoever looks, from behind, too, and from above.
#[test]
fn the_lamp_stands_on_the_left_of_the_camera() {
    for (azimuth, elevation, up) in [
        (180.0, 0.0, "0 1 0"),
        (-120.0, -30.0, "0 1 0"),
        (75.0, 60.0, "0.1 1 0"),
        (0.0, 90.0, "0 0 -1"),
    ] {
        let seen = camera(azimuth, elevation, up);
        let whole = [THINGS, &seen, &lights(azimuth - 70.0), RENDER].concat();
        are_alike(
            &pixels(&[THINGS, &seen, RENDER].concat(), &[]),
            &pixels(&whole, &[]),
        );
    }
}

/// From below it stands below.
#[test]
fn the_lamp_stands_below_what_is_seen_from_below() {
    let lamp = words(at(-70.0, -45.0, 10.0 * radius()));
    let lit = format!("50 -401 0.2\n51 -402 0.8\n51 -1 {lamp}\n");
    let seen = pixels(&[THINGS, RENDER].concat(), &["--view", "bottom"]);
    let meant = [THINGS, &camera(0.0, -90.0, "0 0 1"), &lit, RENDER].concat();
    are_alike(&seen, &pixels(&meant, &[]));
}

#[test]
fn views_from_all_sides() {
    let own = camera(100.0, -10.0, "0 1 0");
    let lit = lights(10.0);
    let iso = FRAC_1_SQRT_2.atan().to_degrees();
    for (side, azimuth, elevation, up) in [
        ("front", 0.0, 0.0, "0 1 0"),
        ("back", 180.0, 0.0, "0 1 0"),
        ("left", -90.0, 0.0, "0 1 0"),
        ("right", 90.0, 0.0, "0 1 0"),
        ("top", 0.0, 90.0, "0 0 -1"),
        ("bottom", 0.0, -90.0, "0 0 1"),
        ("iso", 45.0, iso, "0 1 0"),
    ] {
        let seen = pixels(&[THINGS, &own, &lit, RENDER].concat(), &["--view", side]);
        let meant = [THINGS, &camera(azimuth, elevation, up), &lit, RENDER].concat();
        are_alike(&seen, &pixels(&meant, &[]));
    }
}

/// All commands that take a picture take it with the camera that is asked for.
#[test]
fn a_camera_is_chosen_everywhere() {
    let scene = [
        THINGS,
        "7 -501 1 2 40 0 0 -1 0 1 0 30\n8 -501 1 2 -40 0 0 1 0 1 0 20\n",
        RENDER,
    ]
    .concat();
    let dir = folder(&[("a.zpg", &scene)]);
    let said = |arguments: &[&str]| {
        let out = zpg(dir.path(), arguments);
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        text(&out.stdout)
    };
    let pov = |options: &[&str]| said(&[&["convert", "a.zpg", "--to", "pov"], options].concat());
    assert!(pov(&[]).contains("location <1, 2, -40>"));
    assert!(pov(&["--camera", "7"]).contains("location <1, 2, 40>"));
    let left = pov(&["--view", "left"]);
    assert!(left.contains("direction <1, 0, 0>"), "{left}");
    let mitsuba = said(&["convert", "a.zpg", "--to", "mitsuba", "--camera", "7"]);
    assert!(mitsuba.contains("\"fov\" value=\"30\""), "{mitsuba}");
    let middle = ["probe", "a.zpg", "--pixel", "320,240", "--camera"];
    let z = |camera: &str| {
        let answer = said(&[&middle[..], &[camera]].concat());
        let answer: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
        answer["hits"][0]["point"][2].as_f64().expect("a number")
    };
    assert!(z("7") > 3.0 && z("8") < 3.0);
    let out = zpg(
        dir.path(),
        &["convert", "a.zpg", "--to", "pov", "--camera", "9"],
    );
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("7, 8"), "{}", text(&out.stderr));
}

/// Of a stereo pair one eye is measured, which is said.
#[test]
fn which_eye_is_measured_is_said() {
    let pair = "7 -501 1 2 40 0 0 -1 0 1 0 30\n8 -501 1.1 2 40 0 0 -1 0 1 0 30\n6 -503 7 8\n";
    let dir = folder(&[("a.zpg", [THINGS, pair, RENDER].concat())]);
    let probe = ["probe", "a.zpg", "--pixel", "9,9"];
    let accuracy = [
        "accuracy", "a.zpg", "--size", "16x12", "--axes", "samples", "--budget", "1s",
    ];
    for (arguments, other) in [(&probe[..], "8"), (&accuracy, "8")] {
        let said = |more: &[&str]| text(&zpg(dir.path(), &[arguments, more].concat()).stderr);
        let note = "note: camera 7, the left one of the two, takes the picture; `--camera` chooses the other\n";
        assert!(said(&[]).contains(note), "{}", said(&[]));
        assert!(!said(&["-q"]).contains("note"));
        assert!(!said(&["--camera", other]).contains("note"));
    }
}
