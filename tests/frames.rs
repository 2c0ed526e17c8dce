//! `zpg render --frames`: the pictures of a scene whose numbers vary.

use std::fs;
use std::path::Path;

use crate::support::program::{self, folder, text};

const SIZE: [&str; 2] = ["--size", "24x18"];

/// A ball, a lathe that is moved, a camera in front and a second one beside it.
fn scene(radius: &str, point: &str, camera: &str, fovy: &str) -> String {
    format!(
        "# A ball # 2 11 0 0 0 {radius}\n5 1 3  0.2 -1  {point} 0.5  0 1\n5 -1 0 0 1\n4 -101 2 5\n\
         9 -501 {camera} 0 1 0 {fovy}\n50 -401 0.3\n51 -402 0.7\n51 -1 4 6 5\n1 9999 4 0\n"
    )
}

fn usual() -> String {
    scene("1", "0.5", "0 0 8 0 0 -1", "30")
}

/// Draws, and gives what was printed.
#[track_caller]
fn render(dir: &Path, args: &[&str]) -> String {
    let run = program::zpg(dir, &[&["render"], args, &SIZE].concat());
    let said = text(&run.stderr);
    assert_eq!(run.status.code(), Some(0), "{args:?}: {said}");
    text(&run.stdout)
}

fn bytes(dir: &Path, name: &str) -> Vec<u8> {
    fs::read(dir.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Each picture has the bytes of the picture of a scene with its numbers.
#[track_caller]
fn are_those_of(dir: &Path, pictures: &[(&str, String)]) {
    let mut before = Vec::new();
    for (name, scene) in pictures {
        fs::write(dir.join("written.zpg"), scene).unwrap();
        let ending = name.rsplit('.').next().unwrap();
        let whole = format!("written.{ending}");
        render(dir, &["written.zpg", "-o", &whole]);
        let frame = bytes(dir, name);
        assert!(frame == bytes(dir, &whole), "{name}: {scene}");
        assert!(frame != before, "{name} is as the one before");
        before = frame;
    }
}

#[test]
fn a_frame_is_the_picture_of_a_scene_with_its_numbers() {
    let dir = folder(&[("a.zpg", usual())]);
    let sets = ["--set", "9.fovy=30..60", "--set", "2.r=1..0.25"];
    let args = [
        "a.zpg",
        "-o",
        "zoom.exr",
        "--frames",
        "98-101",
        "--set",
        "5.x[2]=0.5..0.2",
    ];
    let said = render(dir.path(), &[&args[..], &sets].concat());
    let expected =
        ["98", "99", "0100", "0101"].map(|n| format!("Wrote zoom.{n:0>4}.exr: 24 × 18 pixels\n"));
    assert_eq!(said, expected.concat());
    // Thirds and what is computed of them in doubles: 0.5 + (0.2 − 0.5) · 2 / 3 is not quite 0.3.
    let third = |from: f64, to: f64, step: f64| (from + (to - from) * step / 3.0).to_string();
    let point = |step| third(0.5, 0.2, step);
    let camera = "0 0 8 0 0 -1";
    are_those_of(
        dir.path(),
        &[
            ("zoom.0098.exr", scene("1", "0.5", camera, "30")),
            ("zoom.0099.exr", scene("0.75", &point(1.0), camera, "40")),
            ("zoom.0100.exr", scene("0.5", &point(2.0), camera, "50")),
            ("zoom.0101.exr", scene("0.25", "0.2", camera, "60")),
        ],
    );
    // A part of the frames, or one, is the same, and has the same numbers.
    for (only, drawn) in [("100", "zoom.0100.exr"), ("99-100", "zoom.0099.exr")] {
        let whole = bytes(dir.path(), drawn);
        fs::remove_file(dir.path().join(drawn)).unwrap();
        let said = render(dir.path(), &[&args[..], &sets, &["--only", only]].concat());
        assert_eq!(said.lines().count(), only.split('-').count());
        assert!(bytes(dir.path(), drawn) == whole);
    }
}

#[test]
fn frame_numbers_are_as_long_as_the_last_one() {
    let dir = folder(&[("a.zpg", usual()), ("b.zpg", usual())]);
    let args = ["--frames", "9999-10000", "--set", "2.r=1..2"];
    render(dir.path(), &[&["a.zpg"], &args[..]].concat());
    assert!(dir.path().join("a.09999.png").is_file() && dir.path().join("a.10000.png").is_file());
    // A single frame has the first value; several scenes go into a folder.
    let args = [
        "a.zpg", "b.zpg", "-o", "out", "--frames", "3", "--set", "2.r=2..3",
    ];
    render(dir.path(), &args);
    let written = scene("2", "0.5", "0 0 8 0 0 -1", "30");
    are_those_of(dir.path(), &[("out/a.0003.png", written)]);
    assert!(bytes(dir.path(), "out/a.0003.png") == bytes(dir.path(), "out/b.0003.png"));
}

#[test]
fn a_table_has_a_row_for_each_frame() {
    let czech = "9.fovy;5.x[2]\r\n30,5;0,25\r\n45;0.75\r\n";
    let dir = folder(&[("a.zpg", usual()), ("table.csv", czech.to_owned())]);
    let written = |point, fovy| scene("1", point, "0 0 8 0 0 -1", fovy);
    render(
        dir.path(),
        &["a.zpg", "-o", "t.png", "--frames-from", "table.csv"],
    );
    let frames = [written("0.25", "30.5"), written("0.75", "45")];
    let [first, second] = frames.clone();
    are_those_of(dir.path(), &[("t.0000.png", first), ("t.0001.png", second)]);
    // From another number on, and beside a number that varies evenly.
    let args = [
        "a.zpg",
        "--frames-from",
        "table.csv",
        "--frames",
        "7-8",
        "--set",
        "2.r=1..0.5",
    ];
    render(dir.path(), &args);
    let [first, second] = frames;
    let second = second.replace("2 11 0 0 0 1\n", "2 11 0 0 0 0.5\n");
    are_those_of(dir.path(), &[("a.0007.png", first), ("a.0008.png", second)]);
}

#[test]
fn a_camera_goes_around_what_it_looks_at() {
    // The ball alone: its centre is the middle of what is drawn.
    let ball = |camera: &str| {
        format!(
            "2 11 1 0 0 1\n9 -501 {camera} 0 2 0 30\n50 -401 0.3\n51 -402 0.7\n51 -1 4 6 5\n1 9999 2 0\n"
        )
    };
    let dir = folder(&[("a.zpg", ball("1 0 8 0 0 -3"))]);
    let args = [
        "a.zpg", "-o", "o.png", "--frames", "0-3", "--orbit", "9,360",
    ];
    render(dir.path(), &args);
    // Counter-clockwise seen from above: to the right of the front first. A fourth step would be the first frame.
    are_those_of(
        dir.path(),
        &[
            ("o.0000.png", ball("1 0 8 0 0 -3")),
            ("o.0001.png", ball("9 0 0 -3 0 0")),
            ("o.0002.png", ball("1 0 -8 0 0 3")),
            ("o.0003.png", ball("-7 0 0 3 0 0")),
        ],
    );
}

#[test]
fn two_cameras_go_around_together() {
    let pair = |left: &str, right: &str| {
        format!(
            "2 11 0 0 0 1\n3 12 1 -1 0 1.2 1 0.3\n3 -1 -1.1 0 0\n4 -101 2 3\n8 -501 {left} 0 1 0 40\n\
             9 -501 {right} 0 1 0 40\n50 -401 0.3\n51 -402 0.7\n51 -1 4 6 5\n60 -503 8 9\n\
             1 9999 4 0 -2 -2 -2 2 2 2\n"
        )
    };
    let start = pair("-0.25 0 8 0 0 -1", "0.25 0 8 0 0 -1");
    let dir = folder(&[("a.zpg", start.clone())]);
    let args = [
        "a.zpg", "-o", "o.png", "--frames", "0-1", "--orbit", "60,180",
    ];
    let stereo = ["--stereo", "side-by-side"];
    render(dir.path(), &[&args[..], &stereo].concat());
    let turned = pair("8 0 0.25 -1 0 0", "8 0 -0.25 -1 0 0");
    for (name, scene) in [("o.0000.png", &start), ("o.0001.png", &turned)] {
        fs::write(dir.path().join("w.zpg"), scene).unwrap();
        render(dir.path(), &["w.zpg", "--stereo", "side-by-side"]);
        assert!(
            bytes(dir.path(), name) == bytes(dir.path(), "w.png"),
            "{name}"
        );
    }
    // Without that, each frame is a pair of pictures, and an animated one is a pair, too.
    render(dir.path(), &args);
    render(dir.path(), &["w.zpg"]);
    for side in ["left", "right"] {
        let frame = bytes(dir.path(), &format!("o.0001_{side}.png"));
        assert!(frame == bytes(dir.path(), &format!("w_{side}.png")));
    }
    let args = [
        "a.zpg", "-o", "o.apng", "--frames", "0-1", "--orbit", "60,180",
    ];
    render(dir.path(), &args);
    for side in ["left", "right"] {
        let frames = animation(&bytes(dir.path(), &format!("o_{side}.apng"))).1;
        let name = format!("o.0001_{side}.png");
        assert!(
            frames[1] == animation(&bytes(dir.path(), &name)).1[0],
            "{side}"
        );
    }
    assert!(!dir.path().join("o.apng").exists());
    // Of one eye alone the other one stays behind.
    let stays = |orbit: &str| {
        let args = ["render", "a.zpg", "--frames", "0-1", "--orbit", orbit];
        let said = text(&program::zpg(dir.path(), &[&args[..], &SIZE].concat()).stderr);
        said.contains("camera 8 takes the picture and stays where it is")
    };
    assert!(stays("9,180") && !stays("60,180"));
}

/// The delay between the frames of a PNG, and their pixels. One that is not animated has one frame.
fn animation(png: &[u8]) -> (Option<(u16, u16)>, Vec<Vec<u8>>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .unwrap();
    let count = reader.info().animation_control().map(|a| {
        assert_eq!(a.num_plays, 0, "it is shown again and again");
        a.num_frames
    });
    let mut frames = Vec::new();
    let mut delay = None;
    for _ in 0..count.unwrap_or(1) {
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        delay = (reader.info().frame_control).map(|f| (f.delay_num, f.delay_den));
        frames.push(pixels);
    }
    (delay, frames)
}

#[test]
fn an_animated_picture_has_the_pixels_of_the_frames() {
    let dir = folder(&[("a.zpg", usual())]);
    let args = ["a.zpg", "--frames", "3-6", "--set", "2.r=1..0.25"];
    render(dir.path(), &args);
    let said = render(dir.path(), &[&args[..], &["-o", "film.apng"]].concat());
    assert_eq!(said, "Wrote film.apng: 4 frames of 24 × 18 pixels\n");
    let (delay, frames) = animation(&bytes(dir.path(), "film.apng"));
    assert_eq!((delay, frames.len()), (Some((1, 25)), 4));
    for (i, pixels) in frames.iter().enumerate() {
        let name = format!("a.{:04}.png", i + 3);
        assert!(
            animation(&bytes(dir.path(), &name)).1[0] == *pixels,
            "{name}"
        );
    }
    let slow = ["-o", "film.apng", "--fps", "4", "--only", "5-6", "-q"];
    assert_eq!(render(dir.path(), &[&args[..], &slow].concat()), "");
    let (delay, some) = animation(&bytes(dir.path(), "film.apng"));
    assert_eq!(delay, Some((1, 4)));
    assert!(some == frames[2..]);
}

#[test]
fn frames_are_drawn_in_tiles_and_not_twice() {
    let dir = folder(&[("a.zpg", usual())]);
    let args = ["a.zpg", "--frames", "0-1", "--set", "2.r=1..2"];
    render(dir.path(), &args);
    for tile in ["1/2", "2/2"] {
        let part = format!("part{}.png", &tile[..1]);
        render(
            dir.path(),
            &[&args[..], &["-o", &part, "--tile", tile]].concat(),
        );
    }
    let join = [
        "join",
        "part1.0001.png",
        "part2.0001.png",
        "-o",
        "whole.png",
    ];
    let run = program::zpg(dir.path(), &join);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    assert!(bytes(dir.path(), "whole.png") == bytes(dir.path(), "a.0001.png"));
    // The second frame of other numbers is another picture.
    let other = ["a.zpg", "--frames", "0-1", "--set", "2.r=1..3", "--resume"];
    let said = render(dir.path(), &other);
    assert_eq!(said.matches("Wrote ").count(), 1, "{said}");
    assert!(said.contains("Wrote a.0001.png"), "{said}");
}

#[test]
fn what_the_pictures_lack_is_said_once() {
    let dark = usual().replace("50 -401 0.3\n51 -402 0.7\n51 -1 4 6 5\n", "");
    let dir = folder(&[("a.zpg", dark)]);
    let args = ["render", "a.zpg", "--frames", "0-2", "--set", "2.r=1..2"];
    let run = program::zpg(dir.path(), &[&args[..], &SIZE].concat());
    let said = text(&run.stderr);
    assert_eq!(said.matches("the scene has no light").count(), 1, "{said}");
}

/// Refuses, says why, and has drawn nothing.
#[track_caller]
fn refuses(dir: &Path, args: &[&str], status: i32, says: &[&str]) {
    let before = fs::read_dir(dir).unwrap().count();
    let run = program::zpg(dir, &[&["render"], args, &SIZE].concat());
    let said = text(&run.stderr);
    assert_eq!(run.status.code(), Some(status), "{args:?}: {said}");
    assert!(
        says.iter().all(|says| said.contains(says)),
        "{args:?}: {said}"
    );
    assert_eq!(
        fs::read_dir(dir).unwrap().count(),
        before,
        "{args:?} has drawn"
    );
}

#[test]
fn all_frames_are_looked_at_before_the_first_is_drawn() {
    let table = "9.fovy,2.r\n30,1\n40,-1\n";
    let dir = folder(&[("a.zpg", usual()), ("t.csv", table.to_owned())]);
    let dir = dir.path();
    let frames = ["a.zpg", "--frames", "0-4"];
    let with = |args: &[&'static str]| [&frames[..], args].concat();
    refuses(
        dir,
        &with(&["--set", "9.fovy=100..180"]),
        1,
        &["in the scene of frame 4", "E206", "a.zpg:5:", "`180`"],
    );
    refuses(
        dir,
        &["a.zpg", "--frames-from", "t.csv"],
        1,
        &["in the scene of frame 1", "E201"],
    );
    // A scene in which one number alone is right, and both together are not.
    refuses(
        dir,
        &with(&["--set", "9.dx=0..0", "--set", "9.dz=-1..1"]),
        1,
        &["in the scene of frame 2"],
    );
    refuses(
        dir,
        &with(&["--set", "9.x=-1e308..1e308"]),
        2,
        &["frame 1: 9.x is out of range"],
    );
    // What is drawn is looked at, and nothing else.
    let args = with(&["--set", "9.fovy=100..180", "--only", "0-1"]);
    assert_eq!(render(dir, &args).lines().count(), 2);
}

#[test]
fn what_cannot_vary_is_told() {
    let table = "9.fovy,2.colour\n30,1\n";
    let json = r#"{"version": 1}"#;
    let moved = usual().replace("50 -401", "9 -1 0 1 0\n50 -401");
    let projecting = usual().replace(
        "50 -401",
        "10 -99  1 0 0 0  0 1 0 0  0 0 -1.2 -2.2  0 0 -1 0\n50 -401",
    );
    let dir = folder(&[
        ("a.zpg", usual()),
        ("moved.zpg", moved),
        ("projecting.zpg", projecting),
        ("a.json", json.to_owned()),
        ("t.csv", table.to_owned()),
        ("words.csv", "9.fovy\n30\nmany\n".to_owned()),
        ("two.csv", "9.fovy\n30\n31\n".to_owned()),
    ]);
    let dir = dir.path();
    let frames = ["a.zpg", "--frames", "0-4"];
    let with = |args: &[&'static str]| [&frames[..], args].concat();
    let set = |set: &'static str| with(&["--set", set]);
    refuses(dir, &set("7.x=0..1"), 2, &["no record with ID 7"]);
    refuses(
        dir,
        &set("9.fov=0..1"),
        2,
        &["--set: 9.fov", "ux, uy, uz, fovy"],
    );
    refuses(dir, &set("5.y=0..1"), 2, &["5@2.y, 5@3.y"]);
    refuses(dir, &set("4.B=2..5"), 2, &["whole number"]);
    refuses(dir, &set("1.xmin=2..5"), 2, &["optional numbers"]);
    refuses(dir, &set("5.x[4]=0..1"), 2, &["5.x[1] to 5.x[3]"]);
    refuses(dir, &set("2.r=1"), 2, &["ID.PARAM=FROM..TO"]);
    refuses(dir, &set("2.r=1..nan"), 2, &["ID.PARAM=FROM..TO"]);
    refuses(dir, &set("r=1..2"), 2, &["`r` names no number"]);
    refuses(
        dir,
        &with(&["--set", "9.x=1..2", "--orbit", "9,360"]),
        2,
        &["9.x is varied twice"],
    );
    // All mistakes at once.
    let both = [
        "--set",
        "7.x=0..1",
        "--set",
        "9.fov=0..1",
        "--orbit",
        "50,360",
    ];
    refuses(
        dir,
        &with(&both),
        2,
        &["ID 7", "9.fov", "no camera 50; its cameras: 9"],
    );

    let around = |file: &'static str, orbit| [file, "--frames", "0-1", "--orbit", orbit];
    refuses(
        dir,
        &around("moved.zpg", "9,360"),
        2,
        &["camera 9 is moved by the record on line 6"],
    );
    refuses(
        dir,
        &around("projecting.zpg", "10,90"),
        2,
        &["camera 10 has a projection matrix alone"],
    );
    refuses(dir, &around("a.zpg", "9"), 2, &["as in 9,360"]);
    refuses(dir, &around("a.json", "9,360"), 1, &["E015"]);

    refuses(
        dir,
        &["a.zpg", "--frames-from", "t.csv"],
        2,
        &["t.csv, row 1, column 2", "2.colour"],
    );
    refuses(
        dir,
        &["a.zpg", "--frames-from", "words.csv"],
        2,
        &["words.csv, row 3, column 9.fovy: many is not a number"],
    );
    refuses(
        dir,
        &["a.zpg", "--frames-from", "two.csv", "--frames", "1-3"],
        2,
        &["3 frames", "2 rows"],
    );
    refuses(
        dir,
        &["a.zpg", "--frames-from", "none.csv"],
        2,
        &["cannot read none.csv"],
    );
}

#[test]
fn a_scene_in_json_has_no_records() {
    let dir = folder(&[("a.zpg", usual())]);
    let run = program::zpg(dir.path(), &["convert", "a.zpg", "-o", "a.json"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let args = ["a.json", "--frames", "0-1", "--set", "2.r=1..2"];
    refuses(
        dir.path(),
        &args,
        2,
        &["a.json is a scene in JSON", "convert --to zpg"],
    );
}

#[test]
fn options_that_do_not_go_together_are_refused() {
    let dir = folder(&[("a.zpg", usual()), ("b.zpg", usual())]);
    let dir = dir.path();
    let frames = ["a.zpg", "--frames", "0-4", "--set", "2.r=1..2"];
    let with = |args: &[&'static str]| [&frames[..], args].concat();
    for other in [
        &["--watch"][..],
        &["--heatmap", "h.png"],
        &["--stats", "s.json"],
        &["--cost"],
    ] {
        refuses(dir, &with(other), 2, &["cannot be used with", other[0]]);
    }
    refuses(dir, &with(&["-o", "-"]), 2, &["several pictures"]);
    refuses(
        dir,
        &with(&["--stereo", "anaglyph"]),
        2,
        &["error: --stereo needs two cameras"],
    );
    let tile = with(&["-o", "b.apng", "--tile", "1/2"]);
    refuses(dir, &tile, 2, &["not into b.apng"]);
    refuses(dir, &with(&["-o", "b.xyz"]), 2, &["cannot tell the format"]);
    refuses(dir, &with(&["-o", "none/b.png"]), 2, &["cannot write none"]);
    refuses(
        dir,
        &with(&["-o", "b.png", "--fps", "30"]),
        2,
        &["b.png is not one"],
    );
    refuses(dir, &["a.zpg", "--frames", "0-4"], 2, &["would be alike"]);
    refuses(
        dir,
        &with(&["--only", "3-5"]),
        2,
        &["not among the frames 0-4"],
    );
    refuses(
        dir,
        &["a.zpg", "--set", "2.r=1..2"],
        2,
        &["--set needs `--frames`"],
    );
    refuses(
        dir,
        &["a.zpg", "--only", "3"],
        2,
        &["--only needs `--frames`"],
    );
    refuses(
        dir,
        &["a.zpg", "-o", "b.apng"],
        2,
        &["b.apng is an animated picture"],
    );
    let frames = |frames: &'static str| ["a.zpg", "--frames", frames, "--set", "2.r=1..2"];
    refuses(dir, &frames("4-0"), 2, &["expected frames as in 0-99"]);
    refuses(dir, &frames("0-4294967295"), 2, &["at most 100000 frames"]);
    let several = [
        "a.zpg", "b.zpg", "--frames", "0-4", "--set", "2.r=1..2", "-o", "b.apng",
    ];
    refuses(dir, &several, 2, &["b.apng is one file"]);
    // The scene is not written over.
    fs::write(dir.join("a.0002.png"), usual()).unwrap();
    let scene = [
        "a.0002.png",
        "--frames",
        "0-4",
        "--set",
        "2.r=1..2",
        "-o",
        "a.png",
    ];
    refuses(dir, &scene, 2, &["a.0002.png is the scene itself"]);
}

#[test]
fn films_are_made_by_ffmpeg() {
    let dir = folder(&[("a.zpg", usual())]);
    let frames = ["a.zpg", "--frames", "5-9", "--set", "2.r=1..2", "-o"];
    for (film, line) in [
        (
            "b.mp4",
            "`ffmpeg -framerate 25 -start_number 5 -i b.%04d.png -pix_fmt yuv420p b.mp4`",
        ),
        (
            "b.GIF",
            "`ffmpeg -framerate 25 -start_number 5 -i b.%04d.png b.GIF`",
        ),
    ] {
        refuses(
            dir.path(),
            &[&frames[..], &[film]].concat(),
            2,
            &[line, "`-o b.apng`"],
        );
    }
    let run = [
        "render", "a.zpg", "--frames", "0-9", "--set", "2.r=1..2", "-o", "b.mp4", "--lang", "cs",
    ];
    let run = program::zpg(dir.path(), &run);
    assert!(text(&run.stderr).starts_with("chyba: soubor b.mp4 zpg nezapisuje: vykreslete snímky"));
}

/// Who writes a number of frames gets the one with that number, and is told so.
#[test]
fn a_single_number_is_one_frame() {
    let dir = folder(&[("a.zpg", usual())]);
    let run = |frames: &str| {
        let args = ["render", "a.zpg", "--orbit", "9,360", "--frames", frames];
        let run = program::zpg(dir.path(), &[&args[..], &SIZE].concat());
        (text(&run.stdout), text(&run.stderr))
    };
    let (wrote, told) = run("3");
    assert_eq!(wrote, "Wrote a.0003.png: 24 × 18 pixels\n");
    assert!(
        told.contains("draws frame 3 alone; the first 3 are `--frames 0-2`"),
        "{told}"
    );
    for one in ["0", "1", "0-1"] {
        assert_eq!(run(one).1, "");
    }
}
