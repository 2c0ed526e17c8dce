//! The open files: their texts as the client has them, and their analyses.

use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

use gen_lsp_types::Uri;

use super::did_change::Change;
use super::position::{self, Units};
use super::uri::path_of;
use crate::analysis::config::{Config, Configs};
use crate::analysis::{Analysis, Settings, file};
use crate::diagnostics::{Complaint, SourceFile};
use crate::lint::levels::Choice;

/// The files that are open.
#[derive(Default)]
pub(super) struct Documents {
    open: HashMap<Uri, Document>,
    /// The `zpg.toml` files, each read once until one of them changes.
    configs: Configs,
    pub changes: Changes,
    /// The number of the next snapshot.
    next: u64,
}

/// Counts of changes to files that scenes depend on: to `zpg.toml` files, and to pictures.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Changes {
    pub settings: u64,
    pub pictures: u64,
}

struct Document {
    version: i32,
    text: Arc<String>,
    /// The snapshot of the present text; `None` after an edit, until the next request for it.
    snapshot: Option<Arc<Snapshot>>,
}

/// All open files as they are at one moment, for a request.
pub(super) type Snapshots = HashMap<Uri, Arc<Snapshot>>;

/// A file as it is at one moment. It is analysed when its analysis is first asked for, on the thread that asks.
pub(super) struct Snapshot {
    pub uri: Uri,
    /// The version that the client has open; `None` if the file is not open.
    pub version: Option<i32>,
    /// A number of the snapshot that no other snapshot of an open file has.
    pub number: u64,
    /// Whether the file is neither open nor on disk.
    pub is_missing: bool,
    /// The settings of the file's `zpg.toml`, or the fault in them.
    pub config: Result<Arc<Config>, Complaint>,
    text: Arc<String>,
    analysis: OnceLock<Analysis>,
}

impl Snapshot {
    /// The name of the document in messages: the path of a file, otherwise the URI.
    pub(super) fn name(&self) -> String {
        let path = path_of(&self.uri);
        path.map_or_else(
            || self.uri.0.clone(),
            |path| path.to_string_lossy().into_owned(),
        )
    }

    /// Reads a file that is not open from disk. A file that cannot be read counts as empty and missing.
    pub(super) fn on_disk(uri: Uri, configs: &Configs) -> Snapshot {
        let path = path_of(&uri).filter(|path| path.is_file());
        let config = path.as_ref().map(|path| configs.for_file(path));
        let bytes = path.and_then(|path| file::read(&path).ok());
        let mut file = Snapshot {
            version: None,
            number: 0,
            is_missing: bytes.is_none(),
            config: config.map_or_else(|| Ok(Arc::default()), |c| c.map_err(|e| e.complaint())),
            text: Arc::default(),
            analysis: OnceLock::new(),
            uri,
        };
        let analysis = Analysis::new(file.name(), bytes.unwrap_or_default());
        file.analysis = analysis.with_settings(file.settings()).into();
        file
    }

    /// The settings of the file's analysis: the levels of its findings.
    pub(super) fn settings(&self) -> Settings {
        let path = path_of(&self.uri).unwrap_or_default();
        let levels = self.config.as_ref().map(|c| c.levels(&path));
        Settings {
            levels: levels.unwrap_or_default(),
            choice: Choice::default(),
        }
    }

    /// Whether the file's settings exclude it: it gets no diagnostics, and no edits that nobody has asked for.
    pub(super) fn is_excluded(&self) -> bool {
        let path = path_of(&self.uri);
        let config = self.config.as_ref().ok();
        (path.zip(config)).is_some_and(|(path, config)| config.excludes_file(&path))
    }

    pub(super) fn analysis(&self) -> &Analysis {
        self.analysis.get_or_init(|| {
            let text = self.text.as_ref().clone();
            let source = SourceFile::of_text(self.name(), text);
            Analysis::of(source).with_settings(self.settings())
        })
    }
}

impl Documents {
    pub(super) fn open(&mut self, uri: Uri, version: i32, text: String) {
        let document = Document {
            version,
            text: Arc::new(text),
            snapshot: None,
        };
        self.open.insert(uri, document);
    }

    pub(super) fn close(&mut self, uri: &Uri) {
        self.open.remove(uri);
    }

    /// Edits an open file. Returns `false`, and does nothing, if the file is not open.
    pub(super) fn change(
        &mut self,
        uri: &Uri,
        version: i32,
        changes: &[Change],
        units: Units,
    ) -> bool {
        let Some(document) = self.open.get_mut(uri) else {
            return false;
        };
        document.version = version;
        // If a request still reads the old text, a copy is edited; otherwise the text is edited in place.
        document.snapshot = None;
        let text = Arc::make_mut(&mut document.text);
        for change in changes {
            match change.range {
                Some(range) => position::edit(text, units, range, &change.text),
                None => text.clone_from(&change.text),
            }
        }
        true
    }

    /// Forgets all settings that were read, and all snapshots, since a `zpg.toml` file has changed.
    pub(super) fn forget_configs(&mut self) {
        self.configs = Configs::default();
        self.changes.settings += 1;
        self.open.values_mut().for_each(|d| d.snapshot = None);
    }

    /// Forgets the snapshots of the files that contain the name of a picture, and returns the URIs of these files. The
    /// picture has appeared, changed or gone.
    pub(super) fn forget_picture(&mut self, name: &str) -> Vec<Uri> {
        self.changes.pictures += 1;
        let mut shown = Vec::new();
        for (uri, document) in &mut self.open {
            if document.text.contains(name) {
                document.snapshot = None;
                shown.push(uri.clone());
            }
        }
        shown
    }

    pub(super) fn uris(&self) -> Vec<Uri> {
        self.open.keys().cloned().collect()
    }

    /// An open file as it is now; `None` if the file is not open.
    pub(super) fn snapshot(&mut self, uri: &Uri) -> Option<Arc<Snapshot>> {
        let document = self.open.get_mut(uri)?;
        let next = &mut self.next;
        let snapshot = document.snapshot.get_or_insert_with(|| {
            *next += 1;
            let config = match path_of(uri) {
                Some(path) => self.configs.for_file(&path).map_err(|e| e.complaint()),
                None => Ok(Arc::default()),
            };
            Arc::new(Snapshot {
                uri: uri.clone(),
                version: Some(document.version),
                number: *next,
                is_missing: false,
                config,
                text: document.text.clone(),
                analysis: OnceLock::new(),
            })
        });
        Some(snapshot.clone())
    }

    /// All open files as they are now.
    pub(super) fn snapshots(&mut self) -> Snapshots {
        let uris = self.uris();
        let now = uris
            .into_iter()
            .filter_map(|uri| Some((uri.clone(), self.snapshot(&uri)?)));
        now.collect()
    }
}
