//! Changing a user's file.

use std::borrow::Cow;
use std::fs::{self, File, Metadata};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use super::draft::{folder_of, temporary, unwritable};
use crate::diagnostics::{Complaint, SourceFile};
use crate::syntax::{self, in_records, recognise};

/// How the names of other tools' files end whose texts may look like scenes: documents, tables, meshes, and scenes and
/// programs in other languages. Scenes in JSON are refused with words of their own.
const OTHER_TOOLS: [&str; 59] = [
    "md", "markdown", "mdown", "mkd", "rst", "adoc", "org", "tex", "html", "htm", "xml", "svg",
    "yaml", "yml", "toml", "ini", "cfg", "csv", "tsv", "psv", "jsonl", "ndjson", "json5",
    "geojson", "gltf", "off", "coff", "noff", "obj", "mtl", "ply", "stl", "pcd", "xyz", "vtk",
    "msh", "dxf", "step", "pov", "inc", "nff", "rib", "iv", "wrl", "ray", "pbrt", "gcode", "nc",
    "ngc", "srt", "vtt", "sub", "log", "py", "c", "h", "cpp", "rs", "js",
];

/// Refuses to change a file that is another tool's by its name, unless that is forced, or is no regular file. Where nothing
/// is written in the end, a pipe may be read.
pub fn allow(path: &Path, force: bool, writes: bool) -> Result<(), Complaint> {
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

/// The bytes of a scene with another text, in its encoding. Nothing may be lost, and it must be known
/// for a scene when it is read again; `read_again` asks to look at its records, too.
pub fn bytes_of<'t>(
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

/// Replaces a file in one step, so that it is whole at any time, with its owner, permissions and attributes. Links are
/// followed. Where that cannot be, it is written in place.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    let error = |e: io::Error| unwritable(path, &e);
    let found = fs::metadata(path).map_err(error)?;
    if !found.is_file() {
        return Err(refused(path, "no-regular-file"));
    }
    if found.permissions().readonly() {
        return Err(refused(path, "read-only-file"));
    }
    let place = path.canonicalize().map_err(error)?;
    match exchange(&place, &found, bytes).map_err(error)? {
        true => Ok(()),
        false => write_in_place(path, bytes),
    }
}

/// Puts a draft with all that belongs to the file in its place. `false` where its links, its owner, its attributes or its
/// folder forbid that.
fn exchange(path: &Path, found: &Metadata, bytes: &[u8]) -> io::Result<bool> {
    if belongings::has_other_names(found) {
        return Ok(false);
    }
    let forbidden = |e: io::Error| match e.kind() {
        io::ErrorKind::PermissionDenied
        | io::ErrorKind::ReadOnlyFilesystem
        // Another file system begins at the file: a container's has such ones.
        | io::ErrorKind::ResourceBusy
        | io::ErrorKind::CrossesDevices => Ok(false),
        _ => Err(e),
    };
    let mut draft = match temporary(folder_of(path)) {
        Ok(draft) => draft,
        Err(e) => return forbidden(e),
    };
    if belongings::copy(path, found, draft.as_file()).is_err() {
        return Ok(false);
    }
    draft.write_all(bytes)?;
    match draft.persist(path) {
        Ok(_) => Ok(true),
        Err(e) => forbidden(e.error),
    }
}

/// Writes over a file. What it was is kept in the temporary folder until that is done, and named if it fails.
fn write_in_place(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    let error = |e: io::Error| unwritable(path, &e);
    let mut old = Vec::new();
    let mut file = File::options().read(true).write(true).open(path);
    file.as_mut()
        .map_err(|e| io::Error::from(e.kind()))
        .and_then(|file| file.read_to_end(&mut old))
        .map_err(error)?;
    let folder = std::env::temp_dir();
    let kept = keep(&old).map_err(|e| unwritable(&folder, &e))?;
    match fs::write(path, bytes).and_then(|()| File::open(path)?.sync_all()) {
        Ok(()) => {
            // A copy that is left does no harm.
            let _ = fs::remove_file(kept);
            Ok(())
        }
        Err(e) => Err(Complaint::new("cannot-write-in-place")
            .with("path", path)
            .with("reason", Complaint::from(&e))
            .with("copy", kept.as_path())),
    }
}

/// Writes a copy into the temporary folder.
fn keep(bytes: &[u8]) -> io::Result<PathBuf> {
    let mut copy = tempfile::Builder::new()
        .prefix("zpg-")
        .suffix(".zpg")
        .tempfile()?;
    copy.write_all(bytes)?;
    copy.as_file().sync_all()?;
    Ok(copy.keep()?.1)
}

/// What belongs to a file besides its bytes.
#[cfg(unix)]
mod belongings {
    use std::ffi::OsString;
    use std::fs::{File, Metadata};
    use std::io;
    use std::os::unix::fs::{MetadataExt, fchown};
    use std::path::Path;

    use xattr::FileExt;

    /// Whether the file has other names, hard links, which a new file would not have.
    pub fn has_other_names(found: &Metadata) -> bool {
        found.nlink() > 1
    }

    /// Gives a new file the owner, the permissions and the attributes of another; access control lists are such ones.
    pub fn copy(path: &Path, found: &Metadata, new: &File) -> io::Result<()> {
        let owner = |file: &Metadata| (file.uid(), file.gid());
        if owner(&new.metadata()?) != owner(found) {
            fchown(new, Some(found.uid()), Some(found.gid()))?;
        }
        new.set_permissions(found.permissions())?;
        let old = File::open(path)?;
        let names = attributes(&old)?;
        for name in attributes(new)?.iter().filter(|name| !names.contains(name)) {
            new.remove_xattr(name)?;
        }
        for name in names {
            let value = old.get_xattr(&name)?.unwrap_or_default();
            // Some that a file has from the beginning nobody may set.
            if new.get_xattr(&name)?.as_ref() != Some(&value) {
                new.set_xattr(&name, &value)?;
            }
        }
        let now = new.metadata()?;
        match owner(&now) == owner(found) && now.mode() == found.mode() {
            true => Ok(()),
            false => Err(io::ErrorKind::PermissionDenied.into()),
        }
    }

    /// The names of a file's attributes; none where there can be none.
    fn attributes(file: &File) -> io::Result<Vec<OsString>> {
        match file.list_xattr() {
            Ok(names) => Ok(names.collect()),
            Err(e) if e.kind() == io::ErrorKind::Unsupported => Ok(Vec::new()),
            Err(e) => Err(e),
        }
    }
}

#[cfg(not(unix))]
mod belongings {
    use std::fs::{File, Metadata};
    use std::io;
    use std::path::Path;

    pub fn has_other_names(_: &Metadata) -> bool {
        false
    }

    pub fn copy(_: &Path, found: &Metadata, new: &File) -> io::Result<()> {
        new.set_permissions(found.permissions())
    }
}
