//! Diagnostics that the client asks for: of an open file, and of all scenes in its folders.
//!
//! Each report has a name. If the client has the report of that name already, it is told that nothing has changed, and
//! nothing is computed: clients ask for the whole folder every few seconds.

use std::collections::{HashMap, HashSet};
use std::fs::Metadata;
use std::path::PathBuf;
use std::time::UNIX_EPOCH;

use gen_lsp_types::{
    Diagnostic, DocumentDiagnosticParams, DocumentDiagnosticReport, FullDocumentDiagnosticReport,
    PreviousResultId, RelatedFullDocumentDiagnosticReport,
    RelatedUnchangedDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport, Uri,
    WorkspaceDiagnosticParams, WorkspaceDiagnosticReport,
    WorkspaceDocumentDiagnosticReport as Report, WorkspaceFullDocumentDiagnosticReport,
    WorkspaceUnchangedDocumentDiagnosticReport,
};
use lsp_server::ErrorCode;

use super::ask::Ask;
use super::documents::{Changes, Snapshot};
use super::refusal::{Refusal, refusal};
use super::uri::key;
use super::workspace::{self, OnDisk, PICTURES};
use crate::analysis::config::Configs;

/// The findings of an open file.
pub(super) fn of_file(
    ask: &Ask,
    p: DocumentDiagnosticParams,
) -> Result<DocumentDiagnosticReport, Refusal> {
    let file = ask.file(&p.text_document)?;
    // A file on disk may change unseen, so that its report has no name.
    let name = file.version.map(|_| file.number.to_string());
    match name {
        Some(result_id) if p.previous_result_id.as_ref() == Some(&result_id) => {
            return Ok(RelatedUnchangedDocumentDiagnosticReport {
                related_documents: None,
                unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport {
                    result_id,
                },
            }
            .into());
        }
        _ => {}
    }
    ask.told.note(&file.uri);
    Ok(RelatedFullDocumentDiagnosticReport {
        related_documents: None,
        full_document_diagnostic_report: FullDocumentDiagnosticReport {
            result_id: name,
            items: ask.convert(file).diagnostics(),
        },
    }
    .into())
}

/// The findings of all scenes in the client's folders, and of those that are open. Files that are gone get empty
/// reports.
pub(super) fn of_folders(
    ask: &Ask,
    p: WorkspaceDiagnosticParams,
) -> Result<WorkspaceDiagnosticReport, Refusal> {
    let mut known = KnownReports::of(p.previous_result_ids);
    let mut items = Vec::new();
    if ask.preferences.whole_folder {
        let mut open = HashSet::new();
        for file in ask.files.values() {
            let (name, version) = (file.number.to_string(), file.version);
            let report = match known.take(&file.uri) {
                Some(known) if known == name => same(&file.uri, version, name),
                _ => {
                    let found = ask.convert(file).diagnostics();
                    ask.told.note(&file.uri);
                    full(&file.uri, version, Some(name), found)
                }
            };
            items.push(report);
            open.insert(key(&file.uri));
        }
        let configs = Configs::default();
        for scene in workspace::scenes(ask).filter(|scene| !open.contains(&scene.path)) {
            if ask.is_cancelled() {
                return Err(refusal(ErrorCode::RequestCanceled, "stopped"));
            }
            let names = NamesOnDisk::of(&scene.metadata, ask.changes);
            let report = match known.take(&scene.uri) {
                Some(known) if names.contains(&known) => same(&scene.uri, None, known),
                _ => {
                    ask.told.note(&scene.uri);
                    found_on_disk(ask, &scene, &configs, names)
                }
            };
            items.push(report);
        }
    }
    // The reports that are left are about files that have gone, or that are not looked at any more.
    items.extend(known.left().map(|uri| full(&uri, None, None, Vec::new())));
    let reported = items.iter().map(|report| key(uri_of_report(report)));
    let open = ask.files.keys().map(key);
    let gone = ask.told.others(&reported.chain(open).collect());
    items.extend(gone.iter().map(|uri| full(uri, None, None, Vec::new())));
    Ok(WorkspaceDiagnosticReport { items })
}

fn uri_of_report(report: &Report) -> &Uri {
    match report {
        Report::WorkspaceFullDocumentDiagnosticReport(r) => &r.uri,
        Report::WorkspaceUnchangedDocumentDiagnosticReport(r) => &r.uri,
    }
}

/// The reports that a client has: the URI of a file as the client writes it, and the report's name.
struct KnownReports(HashMap<PathBuf, (Uri, String)>);

impl KnownReports {
    fn of(all: Vec<PreviousResultId>) -> KnownReports {
        let all = all.into_iter().map(|k| (key(&k.uri), (k.uri, k.value)));
        KnownReports(all.collect())
    }

    fn take(&mut self, uri: &Uri) -> Option<String> {
        self.0.remove(&key(uri)).map(|(_, name)| name)
    }

    fn left(self) -> impl Iterator<Item = Uri> {
        self.0.into_values().map(|(uri, _)| uri)
    }
}

fn same(uri: &Uri, version: Option<i32>, name: String) -> Report {
    WorkspaceUnchangedDocumentDiagnosticReport {
        uri: uri.clone(),
        version,
        unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id: name },
    }
    .into()
}

fn full(uri: &Uri, version: Option<i32>, name: Option<String>, items: Vec<Diagnostic>) -> Report {
    WorkspaceFullDocumentDiagnosticReport {
        uri: uri.clone(),
        version,
        full_document_diagnostic_report: FullDocumentDiagnosticReport {
            result_id: name,
            items,
        },
    }
    .into()
}

/// Two names of a report about a file that is not open: for a file that shows pictures, and for one that shows none.
/// Both change with the file and the settings, the first also with the pictures.
struct NamesOnDisk([String; 2]);

impl NamesOnDisk {
    fn of(metadata: &Metadata, changes: Changes) -> NamesOnDisk {
        let written = metadata.modified().ok();
        let written = written.and_then(|t| t.duration_since(UNIX_EPOCH).ok());
        let nanoseconds = written.unwrap_or_default().as_nanos();
        let plain = format!("{nanoseconds}.{}.{}", metadata.len(), changes.settings);
        NamesOnDisk([format!("{plain}.{}", changes.pictures), plain])
    }

    fn contains(&self, name: &str) -> bool {
        self.0.iter().any(|own| own == name)
    }
}

fn found_on_disk(ask: &Ask, scene: &OnDisk, configs: &Configs, names: NamesOnDisk) -> Report {
    let NamesOnDisk([with_pictures, plain]) = names;
    let file = Snapshot::on_disk(scene.uri.clone(), configs);
    let text = &file.analysis().source.text;
    let shows_pictures = PICTURES.iter().any(|e| text.contains(e));
    let name = if shows_pictures { with_pictures } else { plain };
    let found = ask.convert(&file).diagnostics();
    full(&scene.uri, None, Some(name), found)
}
