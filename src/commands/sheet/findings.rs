//! The findings of `zpg check --format json` in scenes.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::analysis::file::unreadable;
use crate::diagnostics::render::json::VERSION;
use crate::diagnostics::{Complaint, Language, Value};

/// The name of the file of findings that a folder of pictures may have.
pub(super) const FILE: &str = "findings.json";

/// The findings of all scenes, as they stand in findings.json.
#[derive(Deserialize)]
pub(super) struct Findings {
    version: u32,
    #[serde(rename = "files")]
    pub scenes: Vec<Scene>,
}

/// A scene and its findings, in the order of their places.
#[derive(Deserialize)]
pub(super) struct Scene {
    pub path: PathBuf,
    #[serde(rename = "diagnostics")]
    pub findings: Vec<Finding>,
}

#[derive(Deserialize)]
pub(super) struct Finding {
    pub code: String,
    pub severity: String,
    /// The message of the finding in English.
    pub message: String,
    pub span: Span,
}

#[derive(Deserialize)]
pub(super) struct Span {
    pub start: LineColumn,
}

#[derive(Deserialize)]
pub(super) struct LineColumn {
    pub line: u64,
    pub column: u64,
}

/// How many errors and warnings there are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Counts {
    pub errors: u64,
    pub warnings: u64,
}

impl Findings {
    /// Reads the file of findings in a folder; `None` if there is none.
    pub(super) fn of_folder(folder: &Path) -> Result<Option<Findings>, Complaint> {
        let path = folder.join(FILE);
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(unreadable(&path, Complaint::from(&e))),
        };
        let findings: Findings = serde_json::from_slice(&bytes).map_err(|e| {
            Complaint::new("sheet-findings-broken")
                .with("path", path.as_path())
                .with("line", e.line().to_string())
                .with("column", e.column().to_string())
        })?;
        match findings.version == VERSION {
            true => Ok(Some(findings)),
            false => Err(Complaint::new("sheet-findings-version")
                .with("path", path.as_path())
                .with("version", findings.version.to_string())),
        }
    }

    pub(super) fn counts(&self) -> Counts {
        let all = self.scenes.iter().map(Scene::counts);
        all.fold(Counts::default(), |a, b| Counts {
            errors: a.errors + b.errors,
            warnings: a.warnings + b.warnings,
        })
    }
}

impl Scene {
    pub(super) fn counts(&self) -> Counts {
        let count = |severity: &str| {
            let such = self.findings.iter().filter(|f| f.severity == severity);
            such.count() as u64
        };
        Counts {
            errors: count("error"),
            warnings: count("warning"),
        }
    }
}

impl Counts {
    /// The texts for the number of errors and for the number of warnings; `None` for a number that is 0.
    pub(super) fn parts(self, language: Language) -> [Option<String>; 2] {
        let part = |count: u64, message| {
            (count > 0).then(|| language.say(message, &[("count", Value::Count(count))]))
        };
        [
            part(self.errors, "tally-errors"),
            part(self.warnings, "tally-warnings"),
        ]
    }
}
