//! Loads a scene for a command, makes sure that it has what the command needs, and says what is missing.

use std::path::Path;

use super::Status;
use super::terminal::{LookChoice, complain, report};
use crate::analysis::file::{self, STDIN};
use crate::analysis::{Analysis, repair};
use crate::diagnostics::{Code, Complaint, Diagnostic, Error, Severity, SourceFile, Span};
use crate::translate::json;

/// What a command needs in a scene, besides that the scene has no errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// A render record, since the command draws something.
    Render,
    Nothing,
}

/// Whether a file is a scene in JSON: its name ends in .json, or, from standard input, its first character is `{`.
pub fn is_json(path: &Path, bytes: &[u8]) -> bool {
    if path.as_os_str() == STDIN {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        return text.trim_ascii_start().starts_with(b"{");
    }
    (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("json"))
}

/// Reads a scene, as records or as JSON; never fails. `path` is the scene's name in messages.
pub fn analyse(path: &Path, bytes: Vec<u8>) -> Analysis {
    let name = path.to_string_lossy();
    match is_json(path, &bytes) {
        true => json::analyse(SourceFile::new(name, bytes)),
        false => Analysis::new(name, bytes),
    }
}

/// Reads a scene for a command that draws it. A scene with errors or without a render record is refused: its errors are
/// printed, and `Err` is the exit status. Warnings and notes are left to `zpg check`.
pub fn load_valid(path: &Path, look: LookChoice) -> Result<Analysis, Status> {
    load_for(Needs::Render, path, look)
}

/// Like [`load_valid`], for a command that may do without a render record.
pub fn load_for(needs: Needs, path: &Path, look: LookChoice) -> Result<Analysis, Status> {
    let bytes = file::read(path).map_err(|e| {
        complain(look, &e);
        Status::Failure
    })?;
    let analysis = analyse(path, bytes);
    let complete = needs == Needs::Nothing || analysis.scene.render.is_some();
    if analysis.is_scene() && analysis.is_sound() && complete {
        return Ok(analysis);
    }
    let mut findings = repair::proposals(&analysis);
    if needs == Needs::Render {
        render_is_needed(&mut findings);
    }
    findings.retain(Diagnostic::is_error);
    report(&analysis.source, &findings, look);
    Err(match analysis.is_scene() {
        true => Status::Negative,
        false => Status::Failure,
    })
}

/// Raises the warning that there is no render record (E106) to an error, for commands that need the record.
fn render_is_needed(findings: &mut [Diagnostic]) {
    let about = findings.iter_mut().filter(|d| d.code == Code::E106);
    about.for_each(|d| d.severity = Severity::Error);
}

/// Prints why a command refuses to do its work, and returns the exit status.
pub fn refuse(analysis: &Analysis, error: Error, look: LookChoice) -> Status {
    match error {
        Error::Scene { why, span } => {
            complain(
                look,
                &span.map_or(why.clone(), |span| placed(analysis, span, why)),
            );
            Status::Negative
        }
        Error::Finding(finding) => {
            report(&analysis.source, &[*finding], look);
            Status::Negative
        }
        Error::Request(why) => {
            complain(look, &why);
            Status::Failure
        }
        Error::Interrupted => Status::Interrupted,
    }
}

/// The complaint with the path, line and column of `span` in front.
fn placed(analysis: &Analysis, span: Span, why: Complaint) -> Complaint {
    let place = analysis.source.position(span.start);
    Complaint::new("at-place")
        .with("path", Path::new(&analysis.source.path))
        .with("line", place.line.to_string())
        .with("column", place.column.to_string())
        .with("why", why)
}
