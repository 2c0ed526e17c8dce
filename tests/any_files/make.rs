//! Files of all kinds, at random.

use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::translate::json;

use crate::rng::Rng;

/// A file, and what it was made as.
pub struct File {
    pub kind: &'static str,
    pub bytes: Vec<u8>,
    /// Whether it is a scene, where there is no doubt.
    pub is_scene: Option<bool>,
}

pub const FOUND: &str = "a file of this machine";
/// One that is hardly ever taken for something else.
pub const SPOILED: &str = "a scene with mistakes";

/// What files are made of.
pub struct Pool {
    scenes: Vec<String>,
    /// Texts and other files of this machine, at most so long.
    texts: Vec<Vec<u8>>,
    scenes_in_json: Vec<String>,
}

/// Longer files are not taken: they would say the same for longer.
const LONGEST: u64 = 20_000;
/// So many files of each folder of the machine.
const OF_EACH: usize = 20_000;

impl Pool {
    /// Takes the scenes of the project, and what lies in some folders.
    pub fn new(folders: &[PathBuf]) -> Pool {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut scenes = Vec::new();
        for folder in ["scenes", "tests"] {
            for path in files(&root.join(folder), usize::MAX) {
                let is_scene = path.extension().is_some_and(|e| e == "zpg");
                if let Some(text) = fs::read_to_string(&path).ok().filter(|_| is_scene) {
                    // With the mark of a cursor it is no scene.
                    let fits = text.len() < 2500 && !text.contains("$0");
                    scenes.extend(fits.then_some(text));
                }
            }
        }
        let model = |text: &String| {
            let loaded = zpg::internals::analysis::Analysis::new("a.zpg", text.clone().into());
            serde_json::to_string_pretty(&json::write(&loaded.scene)).expect("numbers are finite")
        };
        let mut texts = Vec::new();
        for folder in folders {
            texts.extend(
                files(folder, OF_EACH)
                    .iter()
                    .filter_map(|p| fs::read(p).ok()),
            );
        }
        Pool {
            scenes_in_json: scenes.iter().map(model).collect(),
            scenes,
            texts,
        }
    }

    pub fn texts(&self) -> usize {
        self.texts.len()
    }
}

/// The files of a folder that are not long, in the order of their names.
fn files(folder: &Path, most: usize) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut entries: Vec<_> = entries.collect();
        entries.sort_by_key(|e| e.file_name());
        for entry in entries {
            let Ok(about) = entry.metadata() else {
                continue;
            };
            if about.is_dir() {
                folders.push(entry.path());
            } else if about.is_file() && about.len() < LONGEST {
                found.push(entry.path());
                if found.len() == most {
                    return found;
                }
            }
        }
    }
    found
}

/// How files of known formats begin.
const MAGIC: &[&[u8]] = &[
    b"\x89PNG\r\n\x1a\n",
    b"\xff\xd8\xff\xe0\x00\x10JFIF",
    b"GIF89a",
    b"%PDF-1.7\n",
    b"PK\x03\x04",
    b"\x1f\x8b\x08",
    b"\x7fELF\x02\x01\x01",
    b"\x76\x2f\x31\x01",
    b"glTF\x02\x00\x00\x00",
    b"SQLite format 3\x00",
    b"RIFF\x24\x00\x00\x00WAVE",
    b"RIFF\x24\x00\x00\x00WEBPVP8 ",
    b"ply\nformat ascii 1.0\n",
    b"ply\nformat binary_little_endian 1.0\n",
    b"\x00asm\x01\x00\x00\x00",
    b"\xca\xfe\xba\xbe\x00\x00\x00\x34",
    b"7z\xbc\xaf\x27\x1c",
    b"\xfd7zXZ\x00",
    b"\x28\xb5\x2f\xfd",
    b"BZh91AY&SY",
    b"OggS",
    b"fLaC",
    b"II*\x00",
    b"MM\x00*",
    b"<?xml version=\"1.0\"?>\n",
];

/// Makes a file of a kind drawn by lot.
pub fn file(rng: &mut Rng, pool: &Pool) -> File {
    let known = |kind, bytes, is_scene| File {
        kind,
        bytes,
        is_scene: Some(is_scene),
    };
    let unknown = |kind, bytes| File {
        kind,
        bytes,
        is_scene: None,
    };
    match rng.below(20) {
        0 => {
            let length = rng.below(2000);
            unknown("random bytes", noise(rng, length))
        }
        1 => {
            let mut bytes = rng.pick(MAGIC).to_vec();
            let length = rng.below(500);
            match rng.chance(0.5) {
                true => bytes.extend(noise(rng, length)),
                // What follows may look like a scene.
                false => bytes.extend(rng.pick(&pool.scenes).bytes()),
            }
            known("a known format", bytes, false)
        }
        2 => {
            let text = rng.pick(&pool.scenes_in_json);
            known("a scene in JSON", text.clone().into(), false)
        }
        3 => known("prose", prose(rng).into(), false),
        4..=8 if !pool.texts.is_empty() => {
            let mut bytes = rng.pick(&pool.texts).clone();
            if rng.chance(0.3) {
                let (a, b) = (rng.below(bytes.len() + 1), rng.below(bytes.len() + 1));
                bytes = bytes[a.min(b)..a.max(b)].to_vec();
            }
            if rng.chance(0.1) {
                let text = String::from_utf8_lossy(&bytes).into_owned();
                bytes = encode(rng, &text);
            }
            unknown(FOUND, bytes)
        }
        4..=8 => unknown("prose and numbers", (prose(rng) + &scene(rng)).into()),
        9 => {
            let mut bytes = scene(rng).into_bytes();
            for _ in 0..=rng.below(4) {
                let at = rng.below(bytes.len());
                bytes[at] = rng.bits() as u8;
            }
            unknown("a scene with other bytes", bytes)
        }
        10 => {
            let mut text = rng.pick(&pool.scenes).clone();
            spoil(rng, &mut text);
            // Where a `#` is lost, most lines may be in comments over several lines.
            match text.matches('#').count().is_multiple_of(2) {
                true => unknown(SPOILED, encode(rng, &text)),
                false => unknown("a scene of the project", encode(rng, &text)),
            }
        }
        11 => {
            let text = scene(rng);
            let half = text.len() / 2;
            unknown("half a scene", text.as_bytes()[..half].to_vec())
        }
        _ => {
            let mut text = scene(rng);
            if rng.chance(0.3) {
                return known("a scene", encode(rng, &text), true);
            }
            spoil(rng, &mut text);
            unknown(SPOILED, encode(rng, &text))
        }
    }
}

fn noise(rng: &mut Rng, length: usize) -> Vec<u8> {
    (0..length).map(|_| rng.bits() as u8).collect()
}

/// A text as people write in Markdown: it begins with a word and has hardly a number.
fn prose(rng: &mut Rng) -> String {
    const WORDS: &[&str] = &[
        "the", "ball", "{glass}", "a", "**red**", "koule", "světlo", "3", "(see", "below)", "`x`",
        "is",
    ];
    let mut text = String::new();
    for _ in 0..=rng.below(12) {
        text += *rng.pick(&["The ", "- ", "## ", "> ", "Koule ", "| ", "\"", "  and "]);
        for _ in 0..rng.below(10) {
            text += *rng.pick(WORDS);
            text += " ";
        }
        text += *rng.pick(&["\n", "\n", "\n\n", ".\n"]);
    }
    // A `#` more than one would be a comment.
    "Scene\n".to_owned() + &text.replace('#', "=")
}

/// A scene as people write it, in lines, with comments.
fn scene(rng: &mut Rng) -> String {
    let mut text = String::new();
    let mut ids = vec![2];
    text += "2 9 1\n";
    for id in 3..3 + rng.below(12) {
        let number = |rng: &mut Rng| {
            let x = (rng.range(-10.0, 10.0) * 100.0).round() / 100.0;
            match rng.below(12) {
                0 => "-0".to_owned(),
                1 => "0.0".to_owned(),
                2 => format!("{x:.3}"),
                3 => format!("+{}", x.abs()),
                4 => format!("{x:e}"),
                5 => "-.5".to_owned(),
                _ => format!("{x}"),
            }
        };
        let numbers =
            |rng: &mut Rng, n: usize| -> Vec<String> { (0..n).map(|_| number(rng)).collect() };
        let a = *rng.pick(&ids);
        let b = *rng.pick(&ids);
        let record = match rng.below(8) {
            0 => format!("{id} 11 {} 1.50", numbers(rng, 3).join(" ")),
            1 => format!("{id} 12 {} 20 20 20", numbers(rng, 3).join("  ")),
            2 => format!("{id} {} {a} {b}", -101 - rng.below(3) as i32),
            3 => format!("{id} 1 3 0 0 1 {} 0 2", number(rng).replace(['-', '+'], "")),
            4 => format!("{id} 14 2 .5"),
            5 => format!("{id} 9 1\n{id} -1 {}", numbers(rng, 3).join(" ")),
            6 => format!("{id} 9 2 {id} -701 .5 0.50 1"),
            _ => format!(
                "{id} 15 {}",
                numbers(rng, 16).join(if rng.chance(0.5) { " " } else { "\n" })
            ),
        };
        ids.push(id);
        match rng.below(8) {
            0 => text += "0 # nadpis: koule, válec #\n",
            1 => text += "# two lines\nof prose #\n",
            2 => text += "\n\n",
            _ => {}
        }
        text += &record;
        text += *rng.pick(&[
            "\n",
            "\n",
            "\n",
            " # a comment #\n",
            " 0 # žluťoučký kůň #\n",
            "   \n",
            " ",
        ]);
    }
    text + &format!("\n50 -402 1\n1 9999 {} 0\n", rng.pick(&ids))
}

/// What gets between the numbers of a scene by mistake.
const SLIPS: &[&str] = &[
    "x",
    "@",
    "0,5",
    "1.2.3",
    "<",
    ">,",
    ";",
    "sphere",
    "\"a b.png\"",
    "1e999",
    "0x1F",
    "--5",
    "−1",
    "nan",
    "7",
    "0",
    "(",
    "{3}",
    "#",
    "# x #",
    "koule",
];

/// Makes a few mistakes, but leaves most lines as they are: a scene stays one.
fn spoil(rng: &mut Rng, text: &mut String) {
    for _ in 0..=rng.below(3) {
        let places: Vec<usize> = (text.match_indices(' ').map(|(i, _)| i)).collect();
        let Some(&at) = places.get(rng.below(places.len().max(1))) else {
            return;
        };
        match rng.below(5) {
            // A space is lost, or what follows it.
            0 => text.replace_range(at..at + 1, ""),
            1 => {
                let end = text[at + 1..]
                    .find(char::is_whitespace)
                    .map_or(text.len(), |e| at + 1 + e);
                // Not a comment's sign: its lines may be lost with it.
                if !text[at..end].contains('#') {
                    text.replace_range(at..end, "");
                }
            }
            _ => {
                let slip = *rng.pick(SLIPS);
                text.insert_str(at, slip);
                text.insert(at, ' ');
            }
        }
    }
}

/// A text in one of the encodings, with one of the line breaks.
fn encode(rng: &mut Rng, text: &str) -> Vec<u8> {
    let text = match rng.below(6) {
        0 => text.replace('\n', "\r\n"),
        1 => text.replace('\n', "\r"),
        _ => text.to_owned(),
    };
    let mark = if rng.chance(0.5) { "\u{feff}" } else { "" };
    let marked = format!("{mark}{text}");
    match rng.below(8) {
        0 => marked.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        1 => marked.encode_utf16().flat_map(u16::to_be_bytes).collect(),
        2 => match encoding_rs::WINDOWS_1250.encode(&text) {
            (bytes, _, false) => bytes.into_owned(),
            // It has characters that the encoding has not.
            _ => text.into(),
        },
        3 => marked.into(),
        _ => text.into(),
    }
}
