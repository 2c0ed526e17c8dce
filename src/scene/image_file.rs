//! Image files that a scene names: only from the scene's own folder.

use std::io::{self, Read};
use std::path::{Component, Path};

use crate::diagnostics::{Applicability, Code, Complaint, Diagnostic, Fix, Span};
use crate::syntax::quote;

/// How a JPEG picture begins.
pub const JPEG: [u8; 3] = [0xff, 0xd8, 0xff];

/// Checks a file name; `folder` is where the scene lies, if it is a file. `true` if it can be used.
pub fn check(file: &str, span: Span, folder: Option<&Path>, out: &mut Vec<Diagnostic>) -> bool {
    let path = Path::new(file);
    let inside = path
        .components()
        .all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    if !inside || file.is_empty() || file.contains('\\') || file.contains('\0') {
        out.push(Diagnostic::new(Code::E209, span));
        return false;
    }
    let Some(folder) = folder else { return true };
    // A link may lead out of the folder too.
    let real = folder
        .canonicalize()
        .and_then(|f| folder.join(path).canonicalize().map(|p| (f, p)));
    match real {
        Ok((folder, path)) if !path.starts_with(&folder) => {
            out.push(Diagnostic::new(Code::E209, span).case("link"));
            false
        }
        Ok((_, path)) => match is_picture(&path) {
            Ok(true) => true,
            Ok(false) => {
                out.push(Diagnostic::new(Code::E210, span).case("format"));
                false
            }
            Err(e) => unreadable(span, &e, out),
        },
        Err(e) => {
            unreadable(span, &e, out);
            if let (Some(d), Some(near)) = (out.last_mut(), beside(folder, path)) {
                // A name with spaces stands in quotes.
                let text = match near.contains(|c: char| c.is_whitespace() || c == '#') {
                    true => format!("\"{near}\""),
                    false => near.clone(),
                };
                let fix = Fix::replace("fix-write", Applicability::Unsafe, span, text);
                d.fixes.push(fix.with("number", quote(&near)));
            }
            false
        }
    }
}

/// So many entries of a folder are looked at.
const ENTRIES: usize = 1000;

/// The picture in a scene's folder whose name is nearest to that of a file that is not there, if one is near.
fn beside(folder: &Path, file: &Path) -> Option<String> {
    let plain = |name: &str| name.to_lowercase();
    let written = plain(file.file_name()?.to_str()?);
    let most = 1 + written.chars().count() / 5;
    let parent = file.parent().unwrap_or(Path::new(""));
    let entries = std::fs::read_dir(folder.join(parent)).ok()?;
    let names = entries
        .take(ENTRIES)
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let distance = |name: &str| {
        let name = plain(name);
        let stem = |name: &str| Path::new(name).file_stem().map(ToOwned::to_owned);
        // Another ending is one mistake.
        match stem(&name) == stem(&written) {
            true => 1,
            false => strsim::osa_distance(&name, &written),
        }
    };
    let near = names.map(|name| (distance(&name), name));
    let near = near.filter(|(distance, name)| {
        let path = parent.join(name);
        *distance <= most && !name.contains('"') && is_picture(&folder.join(path)).unwrap_or(false)
    });
    let (_, name) = near.min()?;
    parent.join(name).to_str().map(str::to_owned)
}

/// Whether a file begins like a PNG or JPEG picture.
fn is_picture(path: &Path) -> io::Result<bool> {
    let mut start = Vec::new();
    // Only what lies on disk: opening a pipe would wait for somebody to write.
    if std::fs::metadata(path)?.is_file() {
        let file = std::fs::File::open(path)?;
        file.take(8).read_to_end(&mut start)?;
    }
    Ok(start == b"\x89PNG\r\n\x1a\n" || start.starts_with(&JPEG))
}

fn unreadable(span: Span, why: &io::Error, out: &mut Vec<Diagnostic>) -> bool {
    out.push(Diagnostic::new(Code::E210, span).with("why", Complaint::from(why)));
    false
}
