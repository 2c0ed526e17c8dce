//! The name of a file says what is in it: nothing is written to one whose name says otherwise.
//!
//! So a slip of the hand, as `--stats other.zpg`, costs nobody a scene, settings or a picture.

use std::path::Path;

use crate::diagnostics::Complaint;

/// How the names of files end that zpg reads or writes.
const KNOWN: [&str; 18] = [
    "zpg", "json", "toml", "pov", "xml", "ply", "obj", "mtl", "glb", "stl", "png", "jpg", "jpeg",
    "webp", "apng", "exr", "pfm", "sarif",
];

/// Refuses a name with an ending that stands for something else than what is to be written, whose names end in `own`; the
/// first of these is proposed. A name without an ending, or with one that zpg knows nothing of, fits everything.
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

/// Refuses to write a scene over one that is there already: somebody may have written it.
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
