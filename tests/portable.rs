//! Pictures have the same bits on every machine: nothing between a scene and a pixel asks the system's
//! library, whose last digits differ, for more than a square root or a fused multiply-add.

use std::fs;
use std::path::{Path, PathBuf};

/// Functions of floating-point numbers that are not correctly rounded everywhere.
const FUNCTIONS: [&str; 22] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
    "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "hypot", "cbrt",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() {
            sources(&path, found);
        } else if name.ends_with(".rs") && !name.contains("test") {
            found.push(path);
        }
    }
}

#[test]
fn elementary_functions_come_from_one_library() {
    let mut files = Vec::new();
    for folder in ["src/scene", "src/trace"] {
        sources(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join(folder),
            &mut files,
        );
    }
    assert!(files.len() > 60);
    let mut calls = 0;
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        // Tests stand at the end of a file, or in files of their own.
        let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
        if path.ends_with("close_calls.rs") || path.to_string_lossy().contains("close_calls/") {
            continue;
        }
        for (i, line) in code.lines().enumerate() {
            calls += line.matches("libm::").count();
            for function in FUNCTIONS {
                let call = format!(".{function}(");
                assert!(
                    !line.contains(&call),
                    "{}:{}: {call}…) is the system's; take libm's",
                    path.display(),
                    i + 1
                );
            }
        }
    }
    assert!(calls > 15, "{calls}");
}

/// FNV-1a, 64 bits.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// The linear pictures of five scenes that use most of the shapes and effects, bit by bit. When the
/// picture of one of them is meant to change, look at it before its number is changed here.
#[test]
fn pictures_have_the_same_bits_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let found: Vec<(&str, String)> = PICTURES
        .iter()
        .map(|(name, _)| {
            let scene = format!("{}/scenes/gallery/{name}.zpg", env!("CARGO_MANIFEST_DIR"));
            let picture = folder.path().join(format!("{name}.pfm"));
            let output = crate::support::program::command()
                .args(["render", "--samples", "1", "--size", "96x72", "-o"])
                .arg(&picture)
                .arg(scene)
                .output()
                .unwrap();
            assert!(output.status.success(), "{name}: {output:?}");
            (*name, format!("{:016x}", hash(&fs::read(picture).unwrap())))
        })
        .collect();
    let meant: Vec<(&str, String)> = PICTURES.map(|(n, h)| (n, h.to_owned())).to_vec();
    assert_eq!(found, meant);
}

const PICTURES: [(&str, &str); 5] = [
    ("bracket", "ea787e6609c7aa69"),
    ("dice", "365c65094bc26517"),
    ("pawns", "5ab3826d0b244dc2"),
    ("quadrics", "cf49af589b21f4c3"),
    ("spectrum", "90eca1cf3d65bc26"),
];
