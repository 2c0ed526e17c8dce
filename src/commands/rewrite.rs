//! Changes of a user's file, and the checks before them.

use std::borrow::Cow;
use std::fs;
use std::path::Path;

use super::atomic_file::{self, unwritable};
use crate::diagnostics::{Complaint, SourceFile};
use crate::syntax::{self, in_records, recognise};

/// The name endings of other tools' files whose text may look like a scene: documents, tables, meshes, and scenes and
/// programs in other languages. Scenes in JSON are refused elsewhere, with a message of their own.
const OTHER_TOOLS: [&str; 59] = [
    "md", "markdown", "mdown", "mkd", "rst", "adoc", "org", "tex", "html", "htm", "xml", "svg",
    "yaml", "yml", "toml", "ini", "cfg", "csv", "tsv", "psv", "jsonl", "ndjson", "json5",
    "geojson", "gltf", "off", "coff", "noff", "obj", "mtl", "ply", "stl", "pcd", "xyz", "vtk",
    "msh", "dxf", "step", "pov", "inc", "nff", "rib", "iv", "wrl", "ray", "pbrt", "gcode", "nc",
    "ngc", "srt", "vtt", "sub", "log", "py", "c", "h", "cpp", "rs", "js",
];

/// Refuses to change a file whose name has the ending of another tool's files, unless `force` is set. If `writes` is
/// set, also refuses anything but a regular file; a command that only reads may read a pipe.
pub(super) fn allow(path: &Path, force: bool, writes: bool) -> Result<(), Complaint> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    if !force && OTHER_TOOLS.iter().any(|e| ending.eq_ignore_ascii_case(e)) {
        return Err(Complaint::new("other-ending")
            .with("path", path)
            .with("ending", format!(".{ending}")));
    }
    match fs::metadata(path) {
        Ok(found) if writes && !found.is_file() => Err(refused(path, "no-regular-file")),
        _ => Ok(()),
    }
}

fn refused(path: &Path, why: &'static str) -> Complaint {
    Complaint::new("cannot-write")
        .with("path", path)
        .with("reason", Complaint::new(why))
}

/// The bytes of the scene file with the new text, in the scene's encoding. Refuses a text that the encoding cannot
/// hold, or that would not be recognised as a scene when it is read again. With `read_again`, too few numbers in
/// records are a reason to refuse, too.
pub(super) fn bytes_of<'t>(
    scene: &SourceFile,
    text: &'t str,
    read_again: bool,
) -> Result<Cow<'t, [u8]>, Complaint> {
    let path = Path::new(&scene.path);
    let bytes = scene.encode(text).ok_or_else(|| {
        let encoding = scene.encoding.name();
        Complaint::new("cannot-write").with("path", path).with(
            "reason",
            Complaint::new("text-lost").with("encoding", encoding),
        )
    })?;
    let has_records =
        || !read_again || in_records::by_records(text, &syntax::parse(text).0).is_none();
    match text == scene.text || recognise::is_scene(text) && has_records() {
        true => Ok(bytes),
        false => Err(refused(path, "no-scene-any-more")),
    }
}

/// Replaces the content of a file through [`atomic_file`]. Refuses anything but a regular file that may be written.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    let found = fs::metadata(path).map_err(|e| unwritable(path, &e))?;
    if !found.is_file() {
        return Err(refused(path, "no-regular-file"));
    }
    if found.permissions().readonly() {
        return Err(refused(path, "read-only-file"));
    }
    atomic_file::write(path, |out| out.write_all(bytes))
}
