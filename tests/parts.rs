//! Pictures drawn in parts, joined, and taken up again.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::farm::jobs::floor;
use crate::support::program::{self, folder, words, zpg};

/// A glass ball, a box and a textured floor, seen by two cameras.
const SCENE: &str = "2 11 0 0 0 1\n2 -201 0.2 0.2 0.6\n2 -203 1.5 1.5 1.5\n3 12 1.5 -1 0 2.5 1 0.1\n8 3 0 1 0 1\n8 -301 floor.png\n\
                     4 -101 2 3\n5 -101 4 8\n9 -501 0 0 8 0 0 -1 0 1 0 30\n10 -501 1 0 8 0 0 -1 0 1 0 30\n\
                     50 -401 1\n51 -402 1\n51 -1 3 5 6\n1 9999 5 0\n";
const STEREO: &str = "60 -503 9 10\n";

fn scene(more: &str) -> tempfile::TempDir {
    let text = format!("{SCENE}{more}");
    folder(&[("a.zpg", text.as_bytes()), ("floor.png", &floor())])
}

/// Runs a command that ends with this status, and gives what it says.
#[track_caller]
fn says(folder: &Path, args: &str, status: i32) -> String {
    let run = zpg(folder, &words(args));
    let said = [run.stdout, run.stderr].concat();
    let said = String::from_utf8(said).unwrap();
    assert_eq!(run.status.code(), Some(status), "{args}: {said}");
    said
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Draws all tiles of a picture in the reverse order; their names.
fn draw(folder: &Path, options: &str, tiles: u32, ending: &str) -> String {
    let names = (1..=tiles).rev().map(|i| {
        let name = format!("part{i}.{ending}");
        says(
            folder,
            &format!("render a.zpg {options} --tile {i}/{tiles} -o {name}"),
            0,
        );
        name
    });
    names.collect::<Vec<_>>().join(" ")
}

#[test]
fn parts_join_into_the_bytes_of_the_whole() {
    let dir = scene("");
    let dir = dir.path();
    for (options, tiles) in [
        ("--size 40x31", 4),
        ("--size 40x31 --samples 3 --threads 2", 31),
        ("--size 40x31 --adaptive 0.02", 5),
        (
            "--size 64x48 --crop 5,7,33,29 --adaptive 0.05 --exposure 0.5",
            3,
        ),
        ("--size 40x31 --precision dd --depth 3", 2),
    ] {
        for ending in ["png", "exr"] {
            says(dir, &format!("render a.zpg {options} -o whole.{ending}"), 0);
            let parts = draw(dir, options, tiles, ending);
            let said = says(dir, &format!("join {parts} -o joined.{ending}"), 0);
            assert!(
                said.starts_with(&format!("Wrote joined.{ending}: ")),
                "{said}"
            );
            let [joined, whole] = ["joined", "whole"].map(|n| bytes(dir, &format!("{n}.{ending}")));
            assert!(joined == whole, "{options} {ending}");
            assert!(!dir.join("part1.png").exists() && !dir.join("part1.exr").exists());
        }
    }
    // Linear parts make a PNG, too.
    says(dir, "render a.zpg --size 40x31 -o whole.png", 0);
    let parts = draw(dir, "--size 40x31", 3, "exr");
    says(dir, &format!("join {parts} -o joined.png"), 0);
    assert!(bytes(dir, "joined.png") == bytes(dir, "whole.png"));
    // They have more than the PNG.
    assert!(dir.join("part1.exr").exists());
}

#[test]
fn stereo_pictures_are_drawn_in_parts() {
    let dir = scene(STEREO);
    let dir = dir.path();
    for stereo in ["side-by-side", "anaglyph"] {
        let options = format!("--size 40x31 --stereo {stereo}");
        says(dir, &format!("render a.zpg {options} -o whole.png"), 0);
        let parts = draw(dir, &options, 3, "png");
        says(dir, &format!("join {parts} -o joined.png"), 0);
        assert!(
            bytes(dir, "joined.png") == bytes(dir, "whole.png"),
            "{stereo}"
        );
    }
    says(dir, "render a.zpg --size 40x31 -o whole.png", 0);
    draw(dir, "--size 40x31", 3, "png");
    for side in ["left", "right"] {
        let parts = [1, 2, 3].map(|i| format!("part{i}_{side}.png")).join(" ");
        says(dir, &format!("join {parts} -o joined.png --keep"), 0);
        let whole = bytes(dir, &format!("whole_{side}.png"));
        assert!(bytes(dir, "joined.png") == whole, "{side}");
    }
    // What the left eye sees does not complete what the right one sees.
    let mixed = "join part1_left.png part2_right.png part3_left.png -o mixed.png";
    let said = says(dir, mixed, 1);
    assert!(
        said.contains("part2_right.png is a part of another picture than part"),
        "{said}"
    );
}

#[test]
fn a_part_says_what_it_is() {
    let dir = scene("");
    let dir = dir.path();
    says(dir, "render a.zpg --size 40x31 --tile 2/4 -o part.exr", 0);
    says(dir, "render a.zpg --size 40x31 --tile 2/4 -o part.png", 0);
    use exr::prelude::*;
    let meta = exr::meta::MetaData::read_from_file(dir.join("part.exr"), true).unwrap();
    let header = &meta.headers[0];
    // ⌊31/4⌋ = 7 up to ⌊62/4⌋ = 15.
    let window = header.data_window();
    assert_eq!((window.position, window.size), (Vec2(0, 7), Vec2(40, 8)));
    let whole = header.shared_attributes.display_window;
    assert_eq!((whole.position, whole.size), (Vec2(0, 0), Vec2(40, 31)));
    let text = match &header.own_attributes.other[&Text::from("zpg")] {
        AttributeValue::Text(text) => text.to_string(),
        other => panic!("{other:?}"),
    };
    let said: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(said["size"], serde_json::json!([40, 31]));
    assert_eq!(said["rows"], serde_json::json!([[7, 8]]));
    assert_eq!(said["zpg"], env!("CARGO_PKG_VERSION"));
    let file = std::io::BufReader::new(fs::File::open(dir.join("part.png")).unwrap());
    let png = png::Decoder::new(file).read_info().unwrap();
    let info = png.info();
    assert_eq!((info.width, info.height), (40, 8));
    let texts = &info.uncompressed_latin1_text;
    assert_eq!((texts[0].keyword.as_str(), &texts[0].text), ("zpg", &text));
}

/// What the hashes of a picture say: `(scene, settings)`.
fn hashes(folder: &Path, options: &str) -> (String, String) {
    says(
        folder,
        &format!("render a.zpg --size 8x6 {options} -o h.png"),
        0,
    );
    let file = std::io::BufReader::new(fs::File::open(folder.join("h.png")).unwrap());
    let reader = png::Decoder::new(file).read_info().unwrap();
    let text = &reader.info().uncompressed_latin1_text[0].text;
    let said: serde_json::Value = serde_json::from_str(text).unwrap();
    let hash = |name: &str| said[name].as_str().unwrap().to_owned();
    (hash("scene"), hash("settings"))
}

#[test]
fn hashes_tell_pictures_apart_and_nothing_else() {
    let dir = scene("");
    let dir = dir.path();
    let (scene, settings) = hashes(dir, "");
    // Comments and layout, threads, and other words for the same options.
    let commented = format!("# a comment #\n{}", SCENE.replace(' ', "  "));
    fs::write(dir.join("a.zpg"), commented).unwrap();
    for options in [
        "",
        "--threads 1",
        "--samples 1",
        "--quality draft",
        "--depth 10",
    ] {
        assert_eq!(
            hashes(dir, options),
            (scene.clone(), settings.clone()),
            "{options}"
        );
    }
    for options in [
        "--samples 2",
        "--depth 9",
        "--cutoff 0",
        "--exposure 2",
        "--precision dd",
    ] {
        let (same, other) = hashes(dir, options);
        assert!(same == scene && other != settings, "{options}");
    }
    let (other, same) = hashes(dir, "--view top");
    assert!(other != scene && same == settings);
    fs::write(dir.join("a.zpg"), SCENE.replace("1.5 -1", "1.6 -1")).unwrap();
    let moved = hashes(dir, "").0;
    assert!(moved != scene);
    // The name of a texture stays, its bytes do not.
    let mut png = floor();
    png.extend([0]);
    fs::write(dir.join("floor.png"), png).unwrap();
    assert!(hashes(dir, "").0 != moved);
}

#[test]
fn parts_that_lack_or_do_not_belong_are_named() {
    let dir = scene("");
    let dir = dir.path();
    let size = "--size 40x30";
    draw(dir, size, 6, "png");
    let all = [1, 2, 3, 4, 5, 6].map(|i| format!("part{i}.png")).join(" ");
    let without = |names: &[&str]| names.iter().fold(all.clone(), |all, n| all.replace(n, ""));
    let said = says(
        dir,
        &format!("join {} -o j.png", without(&["part1.png", "part4.png"])),
        1,
    );
    assert!(
        said.contains("10 rows of 30 are missing: 0–4, 15–19"),
        "{said}"
    );
    let said = says(dir, &format!("join {all} {} -o j.png", "part3.png"), 1);
    assert!(
        said.contains("rows 10 to 14 are in part3.png and in part3.png"),
        "{said}"
    );
    // Other options, another scene, another version.
    says(
        dir,
        &format!("render a.zpg {size} --samples 2 --tile 2/6 -o other.png"),
        0,
    );
    let with_other = format!("join {} other.png -o j.png", without(&["part2.png"]));
    let said = says(dir, &with_other, 1);
    assert!(
        said.contains("other.png is a part of another picture") && said.contains("options"),
        "{said}"
    );
    fs::write(dir.join("b.zpg"), SCENE.replace("1.5 -1", "1.6 -1")).unwrap();
    says(
        dir,
        &format!("render b.zpg {size} --tile 2/6 -o other.png"),
        0,
    );
    let said = says(dir, &with_other, 1);
    assert!(
        said.contains("other.png") && said.contains("from another scene"),
        "{said}"
    );
    let version = format!("\"zpg\":\"{}\"", env!("CARGO_PKG_VERSION"));
    let old = replaced(
        &bytes(dir, "part2.png"),
        version.as_bytes(),
        b"\"zpg\":\"0.0.9\"",
    );
    fs::write(dir.join("other.png"), old).unwrap();
    let said = says(dir, &with_other, 1);
    assert!(said.contains("another version of zpg"), "{said}");
    // Cut off, not ours, not there.
    let part = bytes(dir, "part2.png");
    for cut in [part.len() - 1, part.len() / 2, 60, 8] {
        fs::write(dir.join("other.png"), &part[..cut]).unwrap();
        let said = says(dir, &with_other, 1);
        assert!(
            said.contains("other.png is damaged or cut off"),
            "{cut}: {said}"
        );
    }
    fs::write(dir.join("other.png"), floor()).unwrap();
    assert!(says(dir, &with_other, 1).contains("other.png does not say what picture"));
    fs::write(dir.join("other.png"), "").unwrap();
    assert!(says(dir, &with_other, 1).contains("other.png does not say what picture"));
    fs::remove_file(dir.join("other.png")).unwrap();
    assert!(says(dir, &with_other, 2).contains("cannot read other.png"));
    assert!(!dir.join("j.png").exists());
    // Where the picture goes.
    #[cfg(target_os = "linux")]
    std::os::unix::fs::symlink("/dev/full", dir.join("full.png")).unwrap();
    for (output, status, why) in [
        ("j.exr", 1, "8-bit"),
        ("j.pfm", 2, "as .png or .exr"),
        ("part1.png", 2, "part1.png"),
        (".", 2, "."),
        ("none/j.png", 2, "cannot write"),
        #[cfg(target_os = "linux")]
        ("full.png", 2, "cannot write"),
    ] {
        let said = says(dir, &format!("join {all} -o {output}"), status);
        assert!(said.contains(why), "{output}: {said}");
    }
    // A finished picture is no part, and stays.
    says(dir, &format!("render a.zpg {size} -o finished.exr"), 0);
    let said = says(dir, "join finished.exr -o j.png", 1);
    assert!(said.contains("finished.exr is a whole picture"), "{said}");
    assert!(dir.join("finished.exr").exists());
    fs::create_dir(dir.join("empty")).unwrap();
    assert!(says(dir, "join empty -o j.png", 2).contains("there are no parts"));
    // Nothing was removed meanwhile.
    says(dir, &format!("join {all} -o j.png"), 0);
    assert!(!dir.join("part1.png").exists());
}

/// What a folder has beside the parts is named.
#[test]
fn pictures_that_are_no_parts_are_named() {
    let folder = scene("");
    let dir = folder.path();
    fs::create_dir(dir.join("parts")).unwrap();
    for i in [1, 2] {
        let args = format!("render a.zpg --size 8x6 --tile {i}/2 -o parts/{i}.png");
        says(dir, &args, 0);
    }
    fs::write(dir.join("parts/old.JPG"), "").unwrap();
    fs::write(dir.join("parts/a.png"), "").unwrap();
    fs::write(dir.join("parts/notes.txt"), "").unwrap();
    let said = says(dir, "join parts -o a.png --keep", 0);
    assert!(
        said.contains("left out: parts/a.png, parts/old.JPG;"),
        "{said}"
    );
    let said = says(dir, "join parts -o a.png --keep --quiet", 0);
    assert_eq!(said, "");
    fs::remove_file(dir.join("parts/old.JPG")).unwrap();
    let said = says(dir, "join parts -o b.png", 1);
    assert!(!said.contains("left out"), "{said}");
}

/// The bytes of a PNG with a text of it replaced by a longer or shorter one.
fn replaced(png: &[u8], old: &[u8], new: &[u8]) -> Vec<u8> {
    let at = png.windows(old.len()).position(|w| w == old).unwrap();
    let chunk = png[..at].windows(4).rposition(|w| w == b"tEXt").unwrap();
    let length = u32::from_be_bytes(png[chunk - 4..chunk].try_into().unwrap()) as usize;
    let mut text = png[chunk..chunk + 4 + length].to_vec();
    let within = at - chunk;
    text.splice(within..within + old.len(), new.iter().copied());
    let mut all = png[..chunk - 4].to_vec();
    all.extend((text.len() as u32 - 4).to_be_bytes());
    all.extend(&text);
    all.extend(checksum(&text).to_be_bytes());
    all.extend(&png[chunk + 4 + length + 4..]);
    all
}

/// CRC-32 (ISO 3309), as PNG has it.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| match crc & 1 {
        1 => (crc >> 1) ^ 0xedb8_8320,
        _ => crc >> 1,
    };
    let add = |crc: u32, byte: &u8| (0..8).fold(crc ^ u32::from(*byte), step);
    !bytes.iter().fold(!0, add)
}

/// Whichever comes first, the picture is whole, and the other says what it lacks.
#[test]
fn two_joins_at_once_make_one_picture() {
    let dir = scene("");
    let dir = dir.path();
    says(dir, "render a.zpg --size 40x30 -o whole.png", 0);
    for _ in 0..5 {
        let parts = draw(dir, "--size 40x30", 10, "png");
        let join = || {
            let mut command = program::command();
            let command = command.args(format!("join {parts} -o j.png").split_whitespace());
            let command = command.stderr(Stdio::piped()).stdout(Stdio::null());
            command.current_dir(dir).spawn().unwrap()
        };
        let runs = [join(), join()].map(|run| run.wait_with_output().unwrap());
        assert!(bytes(dir, "j.png") == bytes(dir, "whole.png"));
        assert!(runs.iter().any(|run| run.status.success()));
        for run in runs.iter().filter(|run| !run.status.success()) {
            let said = String::from_utf8_lossy(&run.stderr);
            assert!(said.contains("cannot read part"), "{said}");
        }
        fs::remove_file(dir.join("j.png")).unwrap();
    }
}

#[test]
fn tiles_that_cannot_be() {
    let dir = scene("");
    let dir = dir.path();
    for (options, why) in [
        ("--tile 0/4 -o a.png", "counted from 1"),
        ("--tile 5/4 -o a.png", "counted from 1"),
        ("--tile 1 -o a.png", "counted from 1"),
        ("--tile -1/4 -o a.png", "counted from 1"),
        ("--tile 1/31 --size 40x30 -o a.png", "more tiles (31) than"),
        ("--tile 1/4", "--output"),
        (
            "--tile 1/4 -o a.pfm",
            "choose a name that ends in .png or .exr",
        ),
        (
            "--tile 1/4 -o a.jpg",
            "choose a name that ends in .png or .exr",
        ),
        ("--tile 1/4 -o a.png --heatmap h.png", "--heatmap"),
        ("--tile 1/4 -o a.png --watch", "--watch"),
        ("--tile 1/4 -o a.png .", "`--tile` is for one scene"),
        ("--resume --stats s.json", "--stats"),
        ("--frames 0-1 --orbit 9,360 --view top", "--view"),
    ] {
        let said = says(dir, &format!("render a.zpg {options}"), 2);
        assert!(said.contains(why), "{options}: {said}");
    }
    assert_eq!(fs::read_dir(dir).unwrap().count(), 2);
}

#[test]
fn what_is_drawn_is_not_drawn_again() {
    let dir = scene("");
    let dir = dir.path();
    for (first, is_skipped) in [("a.png", true), ("a.exr", true), ("a.pfm", false)] {
        let command = format!("render a.zpg --size 40x30 -o {first} --resume");
        assert!(says(dir, &command, 0).contains("Wrote"));
        let said = says(dir, &command, 0);
        assert_eq!(said.contains("is drawn already"), is_skipped, "{said}");
        assert_eq!(said.contains("is drawn in any case"), !is_skipped, "{said}");
    }
    let whole = bytes(dir, "a.png");
    let command = "render a.zpg --size 40x30 -o a.png --resume";
    for changed in ["--samples 2", "--size 40x31", "--view top"] {
        let said = says(dir, &format!("render a.zpg -o a.png {changed}"), 0);
        assert!(said.contains("Wrote"));
        assert!(says(dir, command, 0).contains("Wrote a.png"), "{changed}");
        assert!(bytes(dir, "a.png") == whole);
    }
    // Cut off, and a part for a whole.
    fs::write(dir.join("a.png"), &whole[..whole.len() - 20]).unwrap();
    assert!(says(dir, command, 0).contains("Wrote a.png"));
    says(dir, "render a.zpg --size 40x30 -o a.png --tile 1/2", 0);
    assert!(says(dir, command, 0).contains("Wrote a.png"));
    assert!(bytes(dir, "a.png") == whole);
    // A texture, and the scene.
    let mut png = floor();
    png.extend([0]);
    fs::write(dir.join("floor.png"), png).unwrap();
    assert!(says(dir, command, 0).contains("Wrote a.png"));
    fs::write(dir.join("a.zpg"), format!("# a comment #\n{SCENE}")).unwrap();
    assert!(says(dir, command, 0).contains("is drawn already"));
}

/// What Ctrl-C leaves is taken up, whatever the format; the picture is that of one run.
#[test]
#[cfg(unix)]
fn an_interrupted_picture_is_taken_up() {
    let dir = scene(STEREO);
    let dir = dir.path();
    // As many samples as take long enough to be interrupted.
    let start = Instant::now();
    let few = "render a.zpg --size 60x45 --samples 40 --threads 2 --camera 9 -o few.png";
    says(dir, few, 0);
    let samples = (40.0 * 2.0 / start.elapsed().as_secs_f64()).max(20.0) as u32;
    let options = &format!("--size 60x45 --samples {samples} --threads 2");
    for (output, parts) in [
        ("a.png", vec!["a_left.part.exr", "a_right.part.exr"]),
        ("b.pfm --camera 9", vec!["b.part.exr"]),
        ("c.png --camera 9 --tile 2/3", vec!["c.part.exr"]),
    ] {
        let command = format!("render a.zpg {options} -o {output} --resume");
        let mut rows = Vec::new();
        let mut interrupted = 0;
        // A run may end before it is told to.
        for wait in [300, 300] {
            let mut child = program::command();
            let child = child.args(command.split_whitespace()).current_dir(dir);
            let mut child = child
                .stderr(Stdio::piped())
                .stdout(Stdio::null())
                .spawn()
                .unwrap();
            let end = Instant::now() + Duration::from_millis(wait);
            while Instant::now() < end && child.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_millis(10));
            }
            let number = child.id().to_string();
            let _ = Command::new("kill").args(["-INT", &number]).status();
            let run = child.wait_with_output().unwrap();
            let said = String::from_utf8(run.stderr).unwrap();
            if run.status.code() == Some(130) {
                interrupted += 1;
                // Of each camera that has drawn a row.
                let kept = said
                    .split(" %")
                    .filter_map(|text| text.split(' ').next_back());
                rows.push(kept.filter_map(|n| n.parse::<u32>().ok()).sum::<u32>());
            }
        }
        assert!(interrupted > 0, "{output}: nothing was interrupted");
        // What damage leaves of the rows is taken, and the others are drawn again.
        let part = dir.join("b.part.exr");
        let is_damaged = part.exists();
        if is_damaged {
            let whole = fs::read(&part).unwrap();
            fs::write(&part, &whole[..whole.len() * 2 / 3]).unwrap();
        }
        assert!(rows.is_sorted(), "{output}: {rows:?}");
        let name = output.split(' ').next().unwrap();
        let said = says(dir, &command, 0);
        assert_eq!(said.contains("b.part.exr is damaged"), is_damaged, "{said}");
        for part in parts {
            assert!(!dir.join(part).exists(), "{part}");
        }
        let other = output.replacen(name, &format!("other-{name}"), 1);
        says(dir, &format!("render a.zpg {options} -o {other}"), 0);
        for side in ["_left.", "_right.", "."] {
            let name = name.replacen('.', side, 1);
            if dir.join(&name).exists() {
                assert!(
                    bytes(dir, &name) == bytes(dir, &format!("other-{name}")),
                    "{name}"
                );
            }
        }
    }
}

#[test]
fn rows_of_another_picture_are_not_taken() {
    let dir = scene("");
    let dir = dir.path();
    says(dir, "render a.zpg --size 40x30 -o whole.png", 0);
    // As if an interrupted run had left it.
    says(
        dir,
        "render a.zpg --size 40x30 --samples 2 --tile 1/2 -o a.part.exr",
        0,
    );
    let said = says(dir, "render a.zpg --size 40x30 -o a.png --resume", 0);
    assert!(
        said.contains("a.part.exr is a part of another picture"),
        "{said}"
    );
    assert!(bytes(dir, "a.png") == bytes(dir, "whole.png"));
    assert!(dir.join("a.part.exr").exists());
}
