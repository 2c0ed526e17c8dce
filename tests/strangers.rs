//! Files that are no scenes are never written to, and scenes keep their encoding and every token.

use crate::support::program::{zpg, zpg_with};
use std::fs;
use std::path::Path;

use crate::any_files::{self, Pool};
use crate::support::cases;

const SCENE: &str = "2 11 0 0 0 1.50\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -402 1\n1 9999 2 0\n";
const FORMATTED: &str =
    "2 11  0 0 0  1.5\n9 -501  0 0 5  0 0 -1  0 1 0  45\n50 -402 1\n1 9999 2 0\n";

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn png() -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    let picture = image::RgbImage::from_pixel(9, 9, image::Rgb([120, 80, 40]));
    picture.write_to(&mut out, image::ImageFormat::Png).unwrap();
    out.into_inner()
}

/// Files that are no scenes, and what is said of them.
fn strangers() -> Vec<(Vec<u8>, &'static str)> {
    let json = zpg_with(
        Path::new("."),
        &["convert", "-", "--to", "json"],
        SCENE.as_bytes(),
    );
    let pov = zpg_with(
        Path::new("."),
        &["convert", "-", "--to", "pov"],
        SCENE.as_bytes(),
    );
    assert!(!json.stdout.is_empty() && !pov.stdout.is_empty());
    vec![
        (png(), "this is a PNG picture, not a scene"),
        (
            b"2 9 1\n\0\n3 9 1\n".to_vec(),
            "this is binary data, not a scene",
        ),
        (json.stdout, "this is a scene written as JSON"),
        (b"[\n1,\n2,\n3\n]\n".to_vec(), "this is JSON, not a scene"),
        (pov.stdout, "this looks like a POV-Ray scene"),
        (
            b"# Title\n\nSome {text}\n".to_vec(),
            "0 of 2 lines begin with a number",
        ),
    ]
}

#[test]
fn nothing_is_written_to_what_is_no_scene() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.zpg");
    for (bytes, said) in strangers() {
        fs::write(&path, &bytes).unwrap();
        for args in [
            &["fmt", "a.zpg"][..],
            &["fmt", "--check", "a.zpg"],
            &["fmt", "--diff", "a.zpg"],
            &["fmt", "--range", "1-2", "a.zpg"],
            &["check", "a.zpg"],
            &["check", "--fix", "a.zpg"],
            &["check", "--fix", "--unsafe-fixes", "a.zpg"],
            &["check", "--diff", "a.zpg"],
            &["check", "--ignore", "W,N,S", "--format", "json", "a.zpg"],
            &["check", "--format", "sarif", "a.zpg"],
            &["check", "--format", "github", "a.zpg"],
            &["check", "--format", "short", "a.zpg"],
            &["render", "a.zpg", "-o", "a.png"],
            &["probe", "a.zpg", "--ray", "0 0 9 0 0 -1"],
            &["plan", "a.zpg"],
            &["convert", "a.zpg", "--to", "pov"],
        ] {
            let run = zpg(dir.path(), args);
            let all = text(&run.stdout) + &text(&run.stderr);
            assert_eq!(run.status.code(), Some(2), "{args:?}: {all}");
            assert!(
                all.contains("E014") && all.contains(said),
                "{args:?}: {all}"
            );
            assert!(fs::read(&path).unwrap() == bytes, "{args:?}");
        }
        // Standard input goes nowhere.
        for args in [&["fmt", "-"][..], &["check", "--fix", "-"]] {
            let run = zpg_with(dir.path(), args, &bytes);
            assert_eq!(
                (run.status.code(), text(&run.stdout)),
                (Some(2), String::new())
            );
        }
        let run = zpg(dir.path(), &["fmt", "--lang", "cs", "a.zpg"]);
        assert!(text(&run.stderr).contains("chyba"), "{run:?}");
    }
}

#[test]
fn the_other_files_of_a_run_are_treated_as_ever() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    fs::write(at("a.zpg"), png()).unwrap();
    fs::write(at("b.zpg"), SCENE).unwrap();
    let run = zpg(dir.path(), &["fmt", "."]);
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(text(&run.stdout), "1 file reformatted\n");
    assert_eq!(fs::read_to_string(at("b.zpg")).unwrap(), FORMATTED);
    fs::write(at("b.zpg"), "2 11 0 0 0 0,5\n1 9999 2 0\n").unwrap();
    let run = zpg(dir.path(), &["check", "--fix", "--format", "json", "."]);
    assert_eq!(run.status.code(), Some(2));
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["files"][0]["diagnostics"][0]["code"], "E014");
    assert_eq!(json["files"][1]["path"], "./b.zpg");
    let fixed = fs::read_to_string(at("b.zpg")).unwrap();
    assert_eq!(fixed, "2 11 0 0 0 0.5\n1 9999 2 0\n");
}

fn utf16(text: &str, little: bool, mark: bool) -> Vec<u8> {
    let bytes = if little {
        u16::to_le_bytes
    } else {
        u16::to_be_bytes
    };
    let mark = if mark { "\u{feff}" } else { "" };
    format!("{mark}{text}")
        .encode_utf16()
        .flat_map(bytes)
        .collect()
}

#[test]
fn utf_16_stays_utf_16() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.zpg");
    for (little, mark) in [(true, true), (true, false), (false, true), (false, false)] {
        let file = |text: &str| utf16(&text.replace('\n', "\r\n"), little, mark);
        let scene = "0 # příliš žluťoučký kůň 😀 #\n".to_owned() + SCENE;
        fs::write(&path, file(&scene)).unwrap();
        let run = zpg(dir.path(), &["fmt", "a.zpg"]);
        assert_eq!(run.status.code(), Some(0), "{run:?}");
        let formatted = file(&("0 # příliš žluťoučký kůň 😀 #\n".to_owned() + FORMATTED));
        assert_eq!(fs::read(&path).unwrap(), formatted);
        let run = zpg_with(dir.path(), &["fmt", "-"], file(&scene));
        assert_eq!(run.stdout, formatted);

        let faulty = scene.replace("1.50", "1,5");
        fs::write(&path, file(&faulty)).unwrap();
        let run = zpg(dir.path(), &["check", "--format", "json", "a.zpg"]);
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        let found = json["files"][0]["diagnostics"].as_array().unwrap();
        let codes: Vec<_> = found.iter().map(|d| d["code"].as_str().unwrap()).collect();
        assert_eq!(codes, ["N604", "E003"]);
        // The bytes that are to be replaced.
        let edit = &found[1]["fixes"][0]["edits"][0];
        let place = |name: &str| edit[name].as_u64().unwrap() as usize;
        let old = &file(&faulty)[place("start")..place("end")];
        assert_eq!(old, utf16("1,5", little, false));
        assert_eq!(edit["text"], "1.5");
        zpg(dir.path(), &["check", "--fix", "a.zpg"]);
        assert_eq!(
            fs::read(&path).unwrap(),
            file(&faulty.replace("1,5", "1.5"))
        );

        // Half a character is kept by leaving the file alone.
        for lost in [&[0xd8, 0xd8][..], b"\n"] {
            let broken = [&file(&faulty), lost].concat();
            fs::write(&path, &broken).unwrap();
            for command in [&["fmt", "a.zpg"][..], &["check", "--fix", "a.zpg"]] {
                let run = zpg(dir.path(), command);
                assert_eq!(run.status.code(), Some(2), "{run:?}");
                assert!(fs::read(&path).unwrap() == broken);
            }
            let run = zpg(dir.path(), &["check", "a.zpg"]);
            assert!(text(&run.stdout).contains("not a character"), "{run:?}");
        }
    }
}

#[test]
fn line_breaks_stay() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.zpg");
    for line_break in ["\n", "\r\n", "\r"] {
        let file = |text: &str| text.replace('\n', line_break);
        fs::write(&path, file(SCENE)).unwrap();
        zpg(dir.path(), &["fmt", "a.zpg"]);
        assert_eq!(fs::read_to_string(&path).unwrap(), file(FORMATTED));
        // A fix breaks a line.
        fs::write(&path, file("2 9 1 3 9 2\n4 -101 2 3\n1 9999 4 0\n")).unwrap();
        zpg(dir.path(), &["check", "--fix", "a.zpg"]);
        let fixed = fs::read_to_string(&path).unwrap();
        assert!(fixed.starts_with(&file("2 9 1\n3 9 2\n")), "{fixed:?}");
    }
}

/// A short run of the campaign `cargo bench --bench files`.
#[test]
fn files_of_all_kinds_come_out_right() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pool = Pool::new(&[
        root.join("src/translate"),
        root.join("grammar"),
        root.join("benches"),
    ]);
    let count = cases(1500, 3000);
    let tally = any_files::run(count, 1, &pool);
    let wrong = &tally.wrong[..tally.wrong.len().min(10)];
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        tally.wrong.len(),
        tally.files
    );
    // A long matrix with mistakes may be most of a scene.
    let lost = tally.lost.len();
    assert!(
        lost * 50 <= tally.spoiled,
        "{lost} of {}: {:#?}",
        tally.spoiled,
        tally.lost
    );
    // All kinds were there.
    assert!(pool.texts() > 50 && tally.found > count / 6);
    assert!(tally.scenes > count / 3 && tally.files - tally.scenes > count / 5);
    assert!(tally.formatted > count * 7 / 30 && tally.fixed > count / 6);
}

/// Texts of other tools that are full of numbers.
#[test]
fn nothing_is_written_to_what_other_tools_write() {
    use std::fmt::Write;
    let taken = any_files::others::run(cases(3400, 34_000), 1);
    let mut wrong = String::new();
    let (mut files, mut changed) = (0, 0);
    for (kind, taken) in &taken {
        (files, changed) = (files + taken.files, changed + taken.changed);
        // Of a few rows of integers most may be records that can be read: of graphs, one file in forty.
        if taken.changed * 25 > taken.files + 50 {
            writeln!(
                wrong,
                "{kind}: {} of {}: {:?}",
                taken.changed, taken.files, taken.example
            )
            .unwrap();
        }
    }
    assert!(wrong.is_empty(), "of {files} files: {wrong}");
    assert!(changed * 300 <= files, "{changed} of {files}");
    assert_eq!(taken.len(), any_files::others::KINDS.len());
}

#[test]
fn endings_of_other_tools_protect_a_file() {
    let dir = tempfile::tempdir().unwrap();
    for name in ["a.md", "a.CSV", "a.off", "a.pov"] {
        let path = dir.path().join(name);
        fs::write(&path, SCENE.replace("1.50", "1,50")).unwrap();
        for args in [
            &["fmt"][..],
            &["fmt", "--check"],
            &["check", "--fix"],
            &["check", "--diff"],
            &["check", "--add-allow"],
        ] {
            let run = zpg(dir.path(), &[args, &[name]].concat());
            assert_eq!(run.status.code(), Some(2), "{run:?}");
            assert!(text(&run.stderr).contains("--force changes it"), "{run:?}");
        }
        assert_eq!(
            fs::read_to_string(&path).unwrap(),
            SCENE.replace("1.50", "1,50")
        );
        zpg(dir.path(), &["check", "--fix", "--force", name]);
        zpg(dir.path(), &["fmt", "--force", name]);
        assert_eq!(fs::read_to_string(&path).unwrap(), FORMATTED);
        // What is only read may have any name.
        assert_ne!(zpg(dir.path(), &["check", name]).status.code(), Some(2));
    }
    // Nothing is written to a file.
    let run = zpg_with(
        dir.path(),
        &["fmt", "--stdin-filename", "a.md", "-"],
        SCENE.as_bytes(),
    );
    assert_eq!(text(&run.stdout), FORMATTED);
}

#[test]
fn what_follows_the_text_stays() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.zpg");
    for tail in [
        "\u{1a}",
        "\u{1a}\u{1a}\u{1a}",
        "\0\0\0\0\0",
        "\u{1a}\0\0",
        "\u{1a}\r\n",
    ] {
        for encode in [
            |t: &str| t.as_bytes().to_vec(),
            |t: &str| utf16(t, true, true),
        ] {
            fs::write(&path, encode(&format!("{SCENE}{tail}"))).unwrap();
            let run = zpg(dir.path(), &["check", "--format", "short", "a.zpg"]);
            assert_eq!(
                run.status.code(),
                Some(0),
                "{tail:?}: {}",
                text(&run.stdout)
            );
            let run = zpg(dir.path(), &["fmt", "a.zpg"]);
            assert_eq!(run.status.code(), Some(0), "{tail:?}: {run:?}");
            assert!(
                fs::read(&path).unwrap() == encode(&format!("{FORMATTED}{tail}")),
                "{tail:?}"
            );
            fs::write(
                &path,
                encode(&format!("{}{tail}", SCENE.replace("1.50", "1,5"))),
            )
            .unwrap();
            zpg(dir.path(), &["check", "--fix", "a.zpg"]);
            let fixed = format!("{}{tail}", SCENE.replace("1.50", "1.5"));
            assert!(fs::read(&path).unwrap() == encode(&fixed), "{tail:?}");
        }
    }
    // Files that were joined, and a page break.
    fs::write(&path, format!("\u{feff}# a #\n\u{feff}{SCENE}\u{c}\n")).unwrap();
    let run = zpg(dir.path(), &["fmt", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0), "{run:?}");
    let formatted = fs::read_to_string(&path).unwrap();
    assert_eq!(formatted, format!("\u{feff}# a #\n{FORMATTED}"));
    assert_eq!(zpg(dir.path(), &["check", "a.zpg"]).status.code(), Some(0));
}
