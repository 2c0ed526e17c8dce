//! The text of translations: every shape, operation, optic, texture, light and camera, the gallery, the handout, and
//! eleven contacts, for each target. A review sees each line that a change writes otherwise.
//!
//! Long runs of lines that differ in their numbers alone are abridged; a hash stands for what is left out. Of a mesh in
//! bytes the header is kept. Which diagonals split the faces of joined solids differs from run to run: faces of OBJ are
//! counted, and meshes in bytes have no hash.

use std::fmt::Write;
use std::path::Path;

use zpg::internals::analysis::file::load;
use zpg::internals::solids::staging::Viewpoint;
use zpg::internals::translate::registry::named;
use zpg::internals::translate::target::{Options, Prepared};

/// Lines of one form in a row that are written out at both ends of a run.
const SHOWN_OF_A_RUN: usize = 3;
/// A run is abridged from this many lines on.
const ABRIDGED_FROM: usize = 12;

/// FNV-1a in 64 bits, which never changes.
fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// A line with a sign for each of its numbers.
fn form(line: &str) -> String {
    let mut form = String::new();
    for c in line.chars() {
        match c {
            '0'..='9' | '.' | '-' if form.ends_with('0') => {}
            '0'..='9' | '.' | '-' => form.push('0'),
            _ => form.push(c),
        }
    }
    form
}

/// A number to two digits. Where solids are joined, how many vertices and faces a mesh has depends on the run and on how the
/// program was compiled.
fn about(n: usize) -> String {
    let digits = 10usize.pow(n.max(1).ilog10().saturating_sub(1));
    match n {
        0..100 => n.to_string(),
        _ => format!("about {}", (n + digits / 2) / digits * digits),
    }
}

/// The text with its long runs cut short.
fn abridged(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut out = String::new();
    let is_face = |line: &str| line.starts_with("f ");
    let is_vertex = |line: &str| ["v ", "vt ", "vn "].iter().any(|v| line.starts_with(v));
    for run in lines.chunk_by(|a, b| form(a) == form(b)) {
        if is_face(run[0]) {
            writeln!(out, "… {} faces", about(run.len())).unwrap();
            continue;
        }
        let shown = match run.len() < ABRIDGED_FROM {
            true => run.len(),
            false => SHOWN_OF_A_RUN,
        };
        let (head, rest) = run.split_at(shown);
        for line in head {
            writeln!(out, "{line}").unwrap();
        }
        if is_vertex(run[0]) && !rest.is_empty() {
            writeln!(out, "… {} more", about(rest.len())).unwrap();
        } else if !rest.is_empty() {
            let left_out = hash(rest.join("\n").into_bytes());
            writeln!(out, "… {} more, {left_out:016x}", rest.len()).unwrap();
        }
    }
    out
}

/// The text of a file; of a mesh in bytes its header and its size.
fn shown(bytes: &[u8]) -> String {
    const END: &[u8] = b"end_header\n";
    match bytes.windows(END.len()).position(|w| w == END) {
        Some(at) => {
            let (header, body) = bytes.split_at(at + END.len());
            let mut shown = String::new();
            for line in std::str::from_utf8(header).unwrap().lines() {
                match line.rsplit_once(' ') {
                    Some((element, count)) if element.starts_with("element ") => {
                        writeln!(shown, "{element} {}", about(count.parse().unwrap()))
                    }
                    _ => writeln!(shown, "{line}"),
                }
                .unwrap();
            }
            shown + &format!("… {} bytes\n", about(body.len()))
        }
        None => match std::str::from_utf8(bytes) {
            Ok(text) => abridged(text),
            Err(_) => {
                let sum = hash(bytes.iter().copied());
                format!("… {} bytes, {sum:016x}\n", bytes.len())
            }
        },
    }
}

/// All files that a target writes of a scene, and its report.
fn written(path: &Path, target: &str) -> String {
    let loaded = load(path).unwrap();
    let name = path.file_name().unwrap();
    // Beside the scene, where its pictures are.
    let output = path.with_file_name("out").with_extension(match target {
        "mitsuba" => "xml",
        other => other,
    });
    let options = Options {
        size: (640, 480),
        viewpoint: Viewpoint::Scene,
        depth: 10,
        // Coarse: what is held is what is written, not how round it is.
        tolerance: Some(0.05),
        memory: None,
        confine: &|_| Ok(()),
        file: Path::new(name),
        output: Some(&output),
        ..Options::default()
    };
    let made = match named(target)
        .unwrap()
        .write(&Prepared::new(&loaded), &options)
    {
        Ok(made) => made,
        Err(error) => return format!("{error}\n"),
    };
    let mut text = made
        .report
        .text(zpg::internals::diagnostics::Language::English);
    for (path, bytes) in &made.files {
        let name = path.as_ref().and_then(|path| path.file_name()).unwrap();
        write!(text, "\n==== {}\n{}", name.display(), shown(bytes)).unwrap();
    }
    text
}

/// Holds the text of a target for all scenes.
fn hold(target: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_snapshot_path(format!("emitted/{target}"));
    settings.set_omit_expression(true);
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for folder in ["tests/emitted", "scenes/gallery", "scenes/handout"] {
        let mut scenes: Vec<_> = (std::fs::read_dir(root.join(folder)).unwrap())
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|e| e == "zpg"))
            .collect();
        scenes.sort();
        for path in scenes {
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            settings.bind(|| insta::assert_snapshot!(name, written(&path, target)));
            count += 1;
        }
    }
    assert_eq!(count, 31);
}

#[test]
fn for_pov_ray() {
    hold("pov");
}

#[test]
fn for_mitsuba() {
    hold("mitsuba");
}

#[test]
fn as_obj() {
    hold("obj");
}

#[test]
fn as_ply() {
    hold("ply");
}

#[test]
fn as_json() {
    hold("json");
}
