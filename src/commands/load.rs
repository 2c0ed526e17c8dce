//! Loading a scene for a command: what it needs of the scene, and what it says where that is not there.

use std::path::Path;

use super::Status;
use super::terminal::{LookChoice, complain, report};
use crate::analysis::{Analysis, file, repair};
use crate::diagnostics::{Code, Complaint, Diagnostic, Error, Severity, Span};

/// What a command needs of a scene besides that it is sound.
#[derive(Debug, Clone, Copy)]
pub struct Needs {
    /// A render record.
    pub render: bool,
    /// A camera and a light, which are made up where there are none.
    pub view: bool,
}

impl Needs {
    pub const ALL: Needs = Needs {
        render: true,
        view: true,
    };

    /// Whether someone with these needs wants to know.
    fn concern(self, about: &Diagnostic) -> bool {
        match about.code {
            Code::E106 => self.render,
            Code::N602 | Code::N603 => self.view,
            _ => true,
        }
    }
}

/// Reads a scene for a command that needs a sound one: says everything there is to say about it, and
/// gives the exit status where there are errors or nothing to draw.
pub fn load_sound(path: &Path, look: LookChoice) -> Result<Analysis, Status> {
    load_for(Needs::ALL, path, look)
}

/// As [`load_sound`], for a command that can do without some things; nothing is said about these.
pub fn load_for(needs: Needs, path: &Path, look: LookChoice) -> Result<Analysis, Status> {
    let analysis = file::load(path).map_err(|e| {
        complain(look, &e);
        Status::Failure
    })?;
    let mut findings = repair::proposals(&analysis);
    if needs.render {
        render_is_needed(&mut findings);
    }
    findings.retain(|d| needs.concern(d));
    report(&analysis.source, &findings, look);
    if !analysis.is_scene() {
        return Err(Status::Failure);
    }
    let complete = !needs.render || analysis.scene.render.is_some();
    if !analysis.is_sound() || !complete {
        return Err(Status::Negative);
    }
    Ok(analysis)
}

/// That there is no render record is a warning, and an error for commands that cannot do without one.
pub fn render_is_needed(findings: &mut [Diagnostic]) {
    let about = findings.iter_mut().filter(|d| d.code == Code::E106);
    about.for_each(|d| d.severity = Severity::Error);
}

/// Says why a command does not do what it was asked for, and gives the exit status.
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

/// With the place in the scene.
fn placed(analysis: &Analysis, span: Span, why: Complaint) -> Complaint {
    let place = analysis.source.position(span.start);
    Complaint::new("at-place")
        .with("path", Path::new(&analysis.source.path))
        .with("line", place.line.to_string())
        .with("column", place.column.to_string())
        .with("why", why)
}
