//! Scenes as records, or as JSON.

use std::path::Path;

use crate::commands::loaded::{self, unreadable};
use crate::commands::{Loaded, LookChoice, Needs, Status, complain, load_for, load_sound};
use crate::diagnostics::{Complaint, Diagnostic};
use crate::translate::json;

/// Reads a sound scene; with `draws`, something is to be drawn.
pub fn load(path: &Path, draws: bool, look: LookChoice) -> Result<Loaded, Status> {
    let is_json = (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("json"));
    match is_json {
        true => load_json(path, draws, look),
        false if draws => load_sound(path, look),
        false => {
            let needs = Needs {
                render: false,
                view: false,
            };
            load_for(needs, path, look)
        }
    }
}

/// Reads a scene that is written as JSON, by way of its records.
fn load_json(path: &Path, draws: bool, look: LookChoice) -> Result<Loaded, Status> {
    let fail = |complaint: Complaint, status| {
        complain(look, &complaint);
        Err(status)
    };
    let bytes = match loaded::read(path) {
        Ok(bytes) => bytes,
        Err(complaint) => return fail(complaint, Status::Failure),
    };
    let text = String::from_utf8_lossy(&bytes);
    let model = match json::read(&text) {
        Ok(model) => model,
        Err(e) => return fail(unreadable(path, e.complaint()), Status::Negative),
    };
    let records = json::spell(&model);
    let mut loaded = Loaded::new(path.to_string_lossy(), records.text.into_bytes());
    if draws {
        loaded.require_render();
    }
    let errors: Vec<&Diagnostic> = loaded.diagnostics.iter().filter(|d| d.is_error()).collect();
    for error in &errors {
        let line = loaded.source.position(error.span.start).line as usize;
        let place = records.places.get(line - 1).copied();
        let complaint = Complaint::new("at-part")
            .with("path", path)
            .with("part", place.map_or(String::new(), |p| p.to_string()))
            .with("why", error.wording(look.language()).message);
        complain(look, &complaint);
    }
    match errors.is_empty() {
        true => Ok(loaded),
        false => Err(Status::Negative),
    }
}
