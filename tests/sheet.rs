//! `zpg sheet` from outside: the sheet is read back.

use std::fs;
use std::path::Path;

use image::{ImageFormat, RgbImage};

use crate::support::program::{folder, text, words, zpg};

#[track_caller]
fn runs(folder: &Path, args: &str, status: i32) -> String {
    let run = zpg(folder, &words(args));
    let said = text(&run.stderr);
    assert_eq!(run.status.code(), Some(status), "{args}: {said}");
    said
}

/// A picture of which no two pixels beside each other are alike.
fn picture(width: u32, height: u32) -> RgbImage {
    RgbImage::from_fn(width, height, |x, y| {
        let mixed = (x * 40_507 % 1009) ^ (y * 40_503 % 769);
        // Of darker codes averages may be just between two codes: the curve begins with a line.
        image::Rgb([mixed, mixed / 3 + x, y * 5].map(|c| (c as u8).max(11)))
    })
}

fn save(folder: &Path, name: &str, picture: &RgbImage) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    picture.save(path).unwrap();
}

/// The average of all subpixels that a pixel of a smaller picture covers, by the formulas of IEC 61966-2-1. Subpixels are
/// so small that each is within one pixel of both pictures.
fn averaged(picture: &RgbImage, width: u32, height: u32) -> RgbImage {
    let linear = |code: u8| match f64::from(code) / 255.0 {
        x if x <= 0.04045 => x / 12.92,
        x => ((x + 0.055) / 1.055).powf(2.4),
    };
    let code = |x: f64| match x <= 0.003_130_8 {
        true => (12.92 * x * 255.0).round() as u8,
        false => ((1.055 * x.powf(1.0 / 2.4) - 0.055) * 255.0).round() as u8,
    };
    fn divisor(a: u32, b: u32) -> u32 {
        if b == 0 { a } else { divisor(b, a % b) }
    }
    let (wide, high) = picture.dimensions();
    let [across, down] = [divisor(wide, width), divisor(high, height)];
    // How many subpixels a pixel has: of the larger picture, and of the smaller one.
    let ([many, rows], [wide, high]) = (
        [width / across, height / down],
        [wide / across, high / down],
    );
    RgbImage::from_fn(width, height, |x, y| {
        let mut sums = [0.0; 3];
        for down in y * high..(y + 1) * high {
            for right in x * wide..(x + 1) * wide {
                let pixel = picture.get_pixel(right / many, down / rows);
                for (sum, c) in sums.iter_mut().zip(pixel.0) {
                    *sum += linear(c);
                }
            }
        }
        image::Rgb(sums.map(|sum| code(sum / f64::from(wide * high))))
    })
}

/// A part of a picture.
fn part(sheet: &RgbImage, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> RgbImage {
    image::imageops::crop_imm(sheet, x, y, width, height).to_image()
}

fn read(path: &Path) -> RgbImage {
    image::open(path).unwrap().to_rgb8()
}

/// The pictures in a page, with their names.
fn embedded(page: &str) -> Vec<(String, RgbImage)> {
    let starts = page.split("<img src=\"data:image/png;base64,").skip(1);
    let one = |rest: &str| {
        let (data, rest) = rest.split_once('"').unwrap();
        let name = rest.split('"').nth(1).unwrap().to_owned();
        let engine = &base64::engine::general_purpose::STANDARD;
        let bytes = base64::Engine::decode(engine, data).unwrap();
        let picture = image::load_from_memory_with_format(&bytes, ImageFormat::Png);
        (name, picture.unwrap().to_rgb8())
    };
    starts.map(one).collect()
}

/// What `zpg check` says of the scenes in `in`, beside the pictures in `out`.
fn check(dir: &Path) {
    let run = zpg(dir, &words("check --isolated --format json in"));
    fs::write(dir.join("out/findings.json"), run.stdout).unwrap();
}

const GOOD: &str =
    "2 11 0 0 0 1\n50 -402 1\n50 -1 4 6 5\n9 -501 0 0 5 0 0 -1 0 1 0 40\n1 9999 2 0\n";
/// An error in its third record.
const WRONG: &str = "2 11 0 0 0 1\n3 -701 1 1 1\n4 -101 2 77\n1 9999 4 0\n";

#[test]
fn thumbnails_are_averages_in_linear_light() {
    let dir = tempfile::tempdir().unwrap();
    // Four pixels in one; pixels shared by two; one that is not made larger.
    let pictures = [
        ("a.png", picture(128, 96), [64, 48]),
        ("b.png", picture(50, 40), [50, 40]),
        ("sub/c.png", picture(75, 100), [36, 48]),
    ];
    for (name, picture, _) in &pictures {
        save(dir.path(), &format!("in/{name}"), picture);
    }
    runs(
        dir.path(),
        "sheet in -o sheet.png --size 64x48 --columns 2",
        0,
    );
    runs(dir.path(), "sheet in -o sheet.html --size 64x48", 0);
    let sheet = read(&dir.path().join("sheet.png"));
    let page = fs::read_to_string(dir.path().join("sheet.html")).unwrap();
    let page = embedded(&page);
    // A heading of one line, and boxes from 12 pixels on.
    let head = 2 * 12 + 24;
    let high = 48 + 4 + 3 * 16 + 12;
    assert_eq!(sheet.dimensions(), (12 + 2 * (64 + 12), head + 2 * high));
    for (i, (name, picture, [width, height])) in (0..).zip(pictures) {
        let expected = averaged(&picture, width, height);
        let left = 12 + i % 2 * (64 + 12) + (64 - width) / 2;
        let top = head + i / 2 * high + (48 - height) / 2;
        for shown in [
            &part(&sheet, [left, top], [width, height]),
            &page[i as usize].1,
        ] {
            assert_eq!(shown.dimensions(), (width, height), "{name}");
            for (at, (shown, expected)) in shown.pixels().zip(expected.pixels()).enumerate() {
                assert_eq!(shown, expected, "{name}, pixel {at}");
            }
        }
        assert_eq!(page[i as usize].0, name);
    }
}

#[test]
fn all_formats_are_shown_in_the_order_of_names() {
    let dir = folder(&[("in/a.zpg", GOOD)]);
    fs::create_dir(dir.path().join("out")).unwrap();
    for ending in ["webp", "jpg", "exr", "png", "pfm"] {
        let args = format!("render in/a.zpg -q --size 40x30 -o out/{ending}.{ending}");
        runs(dir.path(), &args, 0);
    }
    runs(dir.path(), "sheet out -o sheet.html", 0);
    let page = fs::read_to_string(dir.path().join("sheet.html")).unwrap();
    let shown = embedded(&page);
    let names: Vec<&str> = shown.iter().map(|(name, _)| &**name).collect();
    assert_eq!(
        names,
        ["exr.exr", "jpg.jpg", "pfm.pfm", "png.png", "webp.webp"]
    );
    let png = read(&dir.path().join("out/png.png"));
    for (name, picture) in &shown {
        assert!(name == "jpg.jpg" || *picture == png, "{name}");
    }
    for word in names
        .iter()
        .chain(&["40 × 30", "out: 5 pictures", "color-scheme"])
    {
        assert!(page.contains(word), "{word}");
    }
    assert!(
        !page.contains("<script") && !page.contains("http"),
        "{page}"
    );
}

#[test]
fn findings_stand_with_their_scenes() {
    let dir = folder(&[
        ("in/a/scene.zpg", GOOD),
        ("in/b/scene.zpg", WRONG),
        ("in/c/scene.zpg", "2 11 0 0 0 1\n3 11 9 9 9 1\n1 9999 2 0\n"),
    ]);
    let small = picture(40, 30);
    for name in ["a/scene.png", "c/scene_left.png", "d/<&\">.png"] {
        save(dir.path(), &format!("out/{name}"), &small);
    }
    check(dir.path());
    let json = fs::read_to_string(dir.path().join("out/findings.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let of = |i: usize, severity: &str| {
        let all = json["files"][i]["diagnostics"].as_array().unwrap().iter();
        all.filter(|d| d["severity"] == severity).count()
    };
    assert_eq!([of(0, "error"), of(1, "error"), of(2, "error")], [0, 1, 0]);
    assert_eq!([of(0, "warning"), of(2, "warning")], [0, 1]);
    runs(dir.path(), "sheet out -o sheet.html", 0);
    let page = fs::read_to_string(dir.path().join("sheet.html")).unwrap();
    let figure = |name: &str| {
        let figures = page.split("<figure>").skip(1);
        let mut named = figures.filter(|f| f.contains(&format!("<b>{name}</b>")));
        let found = named.next().unwrap_or_else(|| panic!("{name}: {page}"));
        assert!(named.next().is_none(), "{name} twice");
        found
    };
    assert!(figure("a/scene.png").contains(">clean<"));
    let wrong = figure("b/scene.zpg");
    assert!(wrong.contains("1 error, so there is no picture") && !wrong.contains("<img"));
    let said = json["files"][1]["diagnostics"][0]["message"]
        .as_str()
        .unwrap();
    assert!(
        wrong.contains("E101") && wrong.contains("3:10") && wrong.contains(said),
        "{wrong}"
    );
    let warned = figure("c/scene_left.png");
    assert!(warned.contains("<img") && warned.contains(">1 warning<") && warned.contains("W310"));
    // No scene is called so.
    let other = figure("d/&lt;&amp;&quot;&gt;.png");
    assert!(
        other.contains("<img") && !other.contains("errors"),
        "{other}"
    );
    assert!(page.contains("out: 3 pictures, 1 error, 1 warning"));

    runs(dir.path(), "sheet out -o cs.html --lang cs", 0);
    let page = fs::read_to_string(dir.path().join("cs.html")).unwrap();
    for words in [
        "lang=\"cs\"",
        "out: 3 obrázky, 1 chyba, 1 varování",
        "1 chyba, proto obrázek chybí",
    ] {
        assert!(page.contains(words), "{words}");
    }
    // In a picture too: red ink below the box without a picture, yellow below the one with a warning, and no other.
    runs(dir.path(), "sheet out -o sheet.png --columns 4", 0);
    let sheet = read(&dir.path().join("sheet.png"));
    let ink = |column: u32, colour: [u8; 3]| {
        let caption = part(&sheet, [12 + column * 252, 48 + 180], [240, 64]);
        caption.pixels().any(|p| p.0 == colour)
    };
    let (red, yellow) = ([255, 128, 128], [240, 208, 96]);
    assert_eq!(
        [0, 1, 2, 3].map(|c| ink(c, red)),
        [false, true, false, false]
    );
    assert_eq!(
        [0, 1, 2, 3].map(|c| ink(c, yellow)),
        [false, false, true, false]
    );
}

/// So many findings that a page of them would be long.
#[test]
fn a_long_list_is_cut() {
    let lines: String = (10..50).map(|id| format!("{id} -101 2 77\n")).collect();
    let dir = folder(&[("in/a.zpg", format!("2 11 0 0 0 1\n{lines}1 9999 2 0\n"))]);
    fs::create_dir(dir.path().join("out")).unwrap();
    check(dir.path());
    let json = fs::read_to_string(dir.path().join("out/findings.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let count = json["files"][0]["diagnostics"].as_array().unwrap().len();
    assert!(count > 20);
    runs(dir.path(), "sheet out -o sheet.html", 0);
    let page = fs::read_to_string(dir.path().join("sheet.html")).unwrap();
    assert_eq!(page.matches("<li>").count(), 20);
    assert!(page.contains(&format!("{} more", count - 20)));
}

#[test]
fn a_sheet_is_no_picture_of_a_sheet() {
    let dir = tempfile::tempdir().unwrap();
    save(dir.path(), "a.png", &picture(40, 30));
    save(dir.path(), ".hidden/b.png", &picture(40, 30));
    // What git ignores is shown all the same.
    fs::write(dir.path().join(".gitignore"), "*.png\n").unwrap();
    fs::create_dir(dir.path().join(".git")).unwrap();
    runs(dir.path(), "sheet . -o sheet.png", 0);
    let first = fs::read(dir.path().join("sheet.png")).unwrap();
    runs(dir.path(), "sheet . -o sheet.png", 0);
    assert!(fs::read(dir.path().join("sheet.png")).unwrap() == first);
    // Nor is one of another name.
    runs(dir.path(), "sheet . -o other.html", 0);
    let page = fs::read_to_string(dir.path().join("other.html")).unwrap();
    assert_eq!(embedded(&page).len(), 1);
    let run = zpg(dir.path(), &words("sheet . -o -"));
    assert!(run.stdout == first && run.stderr.is_empty());
}

#[test]
fn a_picture_that_cannot_be_read_has_its_box() {
    let dir = tempfile::tempdir().unwrap();
    save(dir.path(), "in/a.png", &picture(40, 30));
    let whole = fs::read(dir.path().join("in/a.png")).unwrap();
    fs::write(dir.path().join("in/torn.png"), &whole[..whole.len() / 2]).unwrap();
    fs::write(dir.path().join("in/huge.pfm"), "PF\n300000 300000\n-1.0\n").unwrap();
    fs::write(dir.path().join("in/empty.exr"), "").unwrap();
    for sheet in ["sheet.html", "sheet.png"] {
        let said = runs(dir.path(), &format!("sheet in -o {sheet}"), 2);
        for name in [
            "torn.png: it is damaged",
            "huge.pfm: it has 300000 × 300000",
            "empty.exr",
        ] {
            assert!(said.contains(name), "{said}");
        }
        assert!(said.contains(&format!("Wrote {sheet}")), "{said}");
    }
    let page = fs::read_to_string(dir.path().join("sheet.html")).unwrap();
    assert_eq!(page.matches("cannot be read: ").count(), 3);
    assert_eq!(embedded(&page).len(), 1);
}

#[test]
fn what_cannot_be_done_is_said_and_nothing_is_written() {
    let dir = folder(&[("scene.zpg", GOOD), ("empty/a.txt", "")]);
    for name in ["in/a.png", "broken/a.png", "later/a.png"] {
        save(dir.path(), name, &picture(40, 30));
    }
    let later = r#"{"version": 99, "files": [], "summary": {}}"#;
    fs::write(dir.path().join("later/findings.json"), later).unwrap();
    fs::write(
        dir.path().join("broken/findings.json"),
        "{\"version\": 1,\n \"files\": 3}",
    )
    .unwrap();
    let picture = fs::read(dir.path().join("in/a.png")).unwrap();
    for (args, words) in [
        (
            "sheet empty -o s.png",
            "no pictures (*.png, *.jpg, *.webp, *.exr, *.pfm) in empty",
        ),
        (
            "sheet scene.zpg -o s.png",
            "cannot read scene.zpg: Not a directory",
        ),
        (
            "sheet none -o s.png",
            "cannot read none: No such file or directory",
        ),
        (
            "sheet in -o s.gif",
            "the name s.gif: expected a name that ends in .png or .html",
        ),
        (
            "sheet in -o s",
            "expected a name that ends in .png or .html",
        ),
        ("sheet in", "--output"),
        (
            "sheet in -o s.png --columns 0",
            "expected a whole number from 1 to 10000",
        ),
        (
            "sheet in -o s.png --size 9x9",
            "expected WxH from 32x32 to 1024x1024",
        ),
        (
            "sheet in -o s.png --size 99999x99999",
            "expected WxH from 32x32 to 1024x1024",
        ),
        (
            "sheet in -o in/a.png",
            "in/a.png is a picture of the folder",
        ),
        ("sheet in -o none/s.png", "cannot write none/s.png"),
        ("sheet in -o in", "expected a name"),
        ("sheet broken -o s.png", "(line 2, column 11)"),
        ("sheet later -o s.png", "has version 99"),
    ] {
        let said = runs(dir.path(), args, 2);
        assert!(said.contains(words), "{args}: {said}");
        for name in ["s.png", "s.gif", "s"] {
            assert!(!dir.path().join(name).exists(), "{args}");
        }
    }
    assert!(fs::read(dir.path().join("in/a.png")).unwrap() == picture);
}
