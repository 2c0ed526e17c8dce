//! Scenes as records, or as JSON.

use std::path::Path;

use crate::analysis::Analysis;
use crate::analysis::file::{self, unreadable};
use crate::commands::load::render_is_needed;
use crate::commands::{LookChoice, Needs, Status, complain, load_for, load_sound};
use crate::diagnostics::{Complaint, Diagnostic};
use crate::translate::json;

/// Reads a sound scene; with `draws`, something is to be drawn.
pub fn load(path: &Path, draws: bool, look: LookChoice) -> Result<Analysis, Status> {
    let is_json = (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("json"));
    match is_json {
        true => load_json(path, draws, look),
        false if draws => load_sound(path, look),
        false => load_for(Needs::Nothing, path, look),
    }
}

/// Reads a scene that is written as JSON, by way of its records.
fn load_json(path: &Path, draws: bool, look: LookChoice) -> Result<Analysis, Status> {
    let fail = |complaint: Complaint, status| {
        complain(look, &complaint);
        Err(status)
    };
    let bytes = match file::read(path) {
        Ok(bytes) => bytes,
        Err(complaint) => return fail(complaint, Status::Failure),
    };
    let text = String::from_utf8_lossy(&bytes);
    let model = match json::read(&text) {
        Ok(model) => model,
        Err(e) => return fail(unreadable(path, e.complaint()), Status::Negative),
    };
    let records = json::spell(&model);
    let loaded = Analysis::new(path.to_string_lossy(), records.text.into_bytes());
    let mut findings = loaded.findings().to_vec();
    if draws {
        render_is_needed(&mut findings);
    }
    findings.retain(Diagnostic::is_error);
    for error in &findings {
        let line = loaded.source.position(error.span.start).line as usize;
        let place = records.places.get(line - 1).copied();
        let complaint = Complaint::new("at-part")
            .with("path", path)
            .with("part", place.map_or(String::new(), |p| p.to_string()))
            .with("why", error.wording(look.language()).message);
        complain(look, &complaint);
    }
    match findings.is_empty() {
        true => Ok(loaded),
        false => Err(Status::Negative),
    }
}
