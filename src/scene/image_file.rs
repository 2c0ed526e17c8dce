//! Checks of the image files that a scene names, which must lie in the scene's own folder.

use std::io::{self, Read};
use std::path::{Component, Path};

use crate::diagnostics::{Code, Complaint, Diagnostic, Span};

/// The first bytes of a JPEG file.
pub(crate) const JPEG: [u8; 3] = [0xff, 0xd8, 0xff];

/// The case of E209 for a path that would be right with `/` instead of `\`.
pub(crate) const BACKSLASH: &str = "backslash";

/// The path with `/` between its parts, as scenes have it on every system.
pub(crate) fn with_slashes(file: &str) -> String {
    file.replace('\\', "/")
}

/// Whether a path stays in the folder that it starts from.
fn is_inside(path: &Path) -> bool {
    let mut parts = path.components();
    parts.all(|c| matches!(c, Component::Normal(_) | Component::CurDir))
}

/// Checks the file name of an image and reports what is wrong. `folder` is the folder of the scene, or `None` if the
/// scene is no file. Returns whether the image can be used.
pub(crate) fn check(
    file: &str,
    span: Span,
    folder: Option<&Path>,
    out: &mut Vec<Diagnostic>,
) -> bool {
    let path = Path::new(file);
    if !is_inside(path) || file.is_empty() || file.contains('\\') || file.contains('\0') {
        let is_windows = file.contains('\\') && !file.contains(':');
        let is_slash_missing = is_windows && is_inside(Path::new(&with_slashes(file)));
        let case = if is_slash_missing { BACKSLASH } else { "" };
        out.push(Diagnostic::new(Code::E209, span).case(case));
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
        Err(e) => unreadable(span, &e, out),
    }
}

/// Whether a file begins like a PNG or JPEG picture.
pub(crate) fn is_picture(path: &Path) -> io::Result<bool> {
    let mut start = Vec::new();
    // Only regular files are opened: opening a pipe would wait for somebody to write.
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
