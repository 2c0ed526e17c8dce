//! Changing a user's file, and showing how it would change.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use clap::builder::styling::AnsiColor;
use similar::TextDiff;

use super::draft::{temporary, unwritable};
use crate::diagnostics::{Complaint, SourceFile};
use crate::syntax::recognise;

/// The bytes of a scene with another text, in its encoding. Nothing may be lost, and it must be known
/// for a scene when it is read again.
pub fn bytes_of(scene: &SourceFile, text: &str) -> Result<Vec<u8>, Complaint> {
    let refused = |reason| {
        Complaint::new("cannot-write")
            .with("path", Path::new(&scene.path))
            .with("reason", reason)
    };
    let bytes = scene.encode(text).ok_or_else(|| {
        let encoding = scene.encoding.name();
        refused(Complaint::new("text-lost").with("encoding", encoding))
    })?;
    match text == scene.text || recognise::is_scene(&scene.with_text(text.to_owned())) {
        true => Ok(bytes),
        false => Err(refused(Complaint::new("no-scene-any-more"))),
    }
}

/// Replaces a file in one step, so that it is whole at any time. Links are followed.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    let error = |e: io::Error| unwritable(path, &e);
    let permissions = fs::metadata(path).map_err(error)?.permissions();
    if permissions.readonly() {
        return Err(Complaint::new("cannot-write")
            .with("path", path)
            .with("reason", Complaint::new("read-only-file")));
    }
    exchange(path, bytes, permissions).map_err(error)
}

fn exchange(path: &Path, bytes: &[u8], permissions: fs::Permissions) -> io::Result<()> {
    let path = path.canonicalize()?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = temporary(folder)?;
    file.write_all(bytes)?;
    file.as_file().set_permissions(permissions)?;
    file.persist(&path)?;
    Ok(())
}

/// How long the search for the smallest difference may take.
const DIFF_TIMEOUT: std::time::Duration = std::time::Duration::from_secs(2);

/// Writes a unified diff.
pub fn diff(out: &mut Vec<u8>, path: &str, old: &str, new: &str, colour: bool) {
    let diff = TextDiff::configure()
        .timeout(DIFF_TIMEOUT)
        .diff_lines(old, new);
    let unified = diff.unified_diff().header(path, path).to_string();
    for line in unified.split_inclusive('\n') {
        let style = match line.as_bytes().first() {
            _ if !colour => None,
            Some(b'+') => Some(AnsiColor::Green),
            Some(b'-') => Some(AnsiColor::Red),
            Some(b'@') => Some(AnsiColor::Cyan),
            _ => None,
        };
        match style.map(AnsiColor::on_default) {
            Some(style) => {
                let text = line.trim_end_matches('\n');
                out.extend(format!("{style}{text}{style:#}\n").into_bytes());
            }
            None => out.extend(line.as_bytes()),
        }
    }
}
