//! Image files that a scene names: only from the scene's own folder.

use std::path::{Component, Path};

use crate::diagnostics::{Code, Diagnostic, Span};

/// Checks a file name; `folder` is where the scene lies, if it is a file. `true` if it can be used.
pub fn check(file: &str, span: Span, folder: Option<&Path>, out: &mut Vec<Diagnostic>) -> bool {
    let path = Path::new(file);
    let inside = path
        .components()
        .all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    if !inside || file.is_empty() || file.contains('\\') || file.contains('\0') {
        out.push(
            Diagnostic::new(
                Code::E209,
                span,
                "the image must lie in the scene's own folder",
            )
            .here("this path leaves it")
            .help("copy the image beside the scene and name it without a folder"),
        );
        return false;
    }
    let Some(folder) = folder else { return true };
    // A link may lead out of the folder too.
    let real = folder
        .canonicalize()
        .and_then(|f| folder.join(path).canonicalize().map(|p| (f, p)));
    match real {
        Ok((folder, path)) if !path.starts_with(&folder) => {
            out.push(
                Diagnostic::new(
                    Code::E209,
                    span,
                    "the image must lie in the scene's own folder",
                )
                .here("this is a link that leaves it"),
            );
            false
        }
        Ok((_, path)) => match std::fs::File::open(&path).and_then(|f| f.metadata()) {
            Ok(m) if m.is_file() => true,
            Ok(_) => unreadable(span, "it is no file", out),
            Err(e) => unreadable(span, &e.to_string(), out),
        },
        Err(e) => unreadable(span, &e.to_string(), out),
    }
}

fn unreadable(span: Span, why: &str, out: &mut Vec<Diagnostic>) -> bool {
    out.push(
        Diagnostic::new(Code::E210, span, "the image cannot be read")
            .here(why.to_owned())
            .help("the file is looked for in the scene's folder"),
    );
    false
}
