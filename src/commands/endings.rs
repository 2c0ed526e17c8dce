//! Refuses to write to a file whose name has the ending of another format.
//!
//! A slip of the hand such as `--stats other.zpg` then destroys no scene, settings or picture.

use std::path::Path;

use crate::diagnostics::Complaint;

/// The name endings of all files that zpg reads or writes.
const KNOWN: [&str; 18] = [
    "zpg", "json", "toml", "pov", "xml", "ply", "obj", "mtl", "glb", "stl", "png", "jpg", "jpeg",
    "webp", "apng", "exr", "pfm", "sarif",
];

/// Refuses a file name whose ending stands for another format. `own` are the endings of the format to be written; the
/// complaint proposes the first of them. A name without an ending, or with an ending that zpg does not know, fits every
/// format.
pub(super) fn fits(path: &Path, own: &[&str]) -> Result<(), Complaint> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let is_one_of = |endings: &[&str]| endings.iter().any(|e| ending.eq_ignore_ascii_case(e));
    if !is_one_of(&KNOWN) || is_one_of(own) {
        return Ok(());
    }
    Err(Complaint::new("wrong-ending")
        .with("path", path)
        .with("ending", format!(".{ending}"))
        .with("right", format!(".{}", own.first().unwrap_or(&"txt"))))
}

/// Refuses to write a scene over a file that exists and is not empty: a person may have written its content.
pub(super) fn is_new_scene(path: &Path) -> Result<(), Complaint> {
    match path.metadata() {
        Ok(found) if found.is_file() && found.len() > 0 => {
            Err(Complaint::new("scene-is-there").with("path", path))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_in_files() {
        let fits = |name: &str, own: &[&str]| fits(Path::new(name), own).is_ok();
        assert!(fits("a.json", &["json"]) && fits("A.JSON", &["json"]));
        assert!(fits("a.sarif", &["json", "sarif"]));
        for name in ["-", "a", "a.txt", "/dev/stdout", "zpg", "a.zpg.new"] {
            assert!(fits(name, &["json"]), "{name}");
        }
        for name in ["b.zpg", "b.ZPG", "b.json.zpg", "zpg.toml", "c.png", "d.pov"] {
            assert!(!fits(name, &["json"]) && !fits(name, &[]), "{name}");
        }
    }
}
