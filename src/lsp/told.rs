//! The files that the client has got reports about.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use gen_lsp_types::Uri;

use super::uri::key;

/// The files that the client has got reports about. When such a file is closed and gone, Visual Studio Code's client
/// forgets the name of the report, but still shows the report. Therefore each report of the folder says that the file
/// has no findings.
#[derive(Default)]
pub(super) struct Told(Mutex<HashMap<PathBuf, Uri>>);

impl Told {
    pub(super) fn note(&self, uri: &Uri) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.entry(key(uri)).or_insert_with(|| uri.clone());
    }

    /// The URIs of the files that the client has got reports about, except those in `named`.
    pub(super) fn others(&self, named: &HashSet<PathBuf>) -> Vec<Uri> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let others = all.iter().filter(|(path, _)| !named.contains(*path));
        others.map(|(_, uri)| uri.clone()).collect()
    }
}
