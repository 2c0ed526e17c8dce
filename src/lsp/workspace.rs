//! The scenes in the client's folders, and their symbols.

use std::collections::HashSet;
use std::fs::Metadata;
use std::path::PathBuf;

use gen_lsp_types::{BaseSymbolInformation, Location, Uri, WorkspaceSymbol};
use ignore::WalkBuilder;

use super::ask::Ask;
use super::convert::symbol_kind;
use super::position::Places;
use super::uri::{path_of, uri_of};
use crate::analysis::{Analysis, file};
use crate::features::symbols;

/// The largest number of symbols in an answer.
const MAX_SYMBOLS: usize = 500;
/// The largest number of a folder's entries that are looked at.
const MAX_ENTRIES: usize = 20_000;
/// The largest number of scenes that are looked at.
const MAX_FILES: usize = 2000;
/// The largest number of bytes of these scenes together.
const MAX_BYTES: u64 = 32_000_000;

/// The extensions of the pictures that a scene may show.
pub(super) const PICTURES: [&str; 3] = ["png", "jpg", "jpeg"];

/// A scene on disk.
pub(super) struct OnDisk {
    pub uri: Uri,
    pub path: PathBuf,
    pub metadata: Metadata,
}

/// The scenes in the client's folders, open or not, up to the limits on entries, scenes and bytes.
pub(super) fn scenes(ask: &Ask) -> impl Iterator<Item = OnDisk> {
    let folders = ask.folders.iter().filter_map(path_of);
    let walk = folders.flat_map(|folder| WalkBuilder::new(folder).build().take(MAX_ENTRIES));
    let paths = walk.filter_map(|entry| Some(entry.ok()?.into_path()));
    let scenes = paths.filter(|path| path.extension().is_some_and(|e| e == "zpg"));
    let mut bytes = 0;
    let scenes = scenes.filter_map(|path| {
        let metadata = std::fs::metadata(&path).ok().filter(Metadata::is_file)?;
        let uri = uri_of(&path)?;
        Some(OnDisk {
            uri,
            path,
            metadata,
        })
    });
    scenes.take(MAX_FILES).take_while(move |scene| {
        bytes += scene.metadata.len();
        bytes <= MAX_BYTES
    })
}

/// The entities that match a query, those of open files first.
pub(super) fn symbols(ask: &Ask, query: &str) -> Vec<WorkspaceSymbol> {
    let mut out = Vec::new();
    for file in ask.files.values() {
        add(ask, &file.uri, file.analysis(), query, &mut out);
    }
    let open: HashSet<PathBuf> = ask.files.keys().filter_map(path_of).collect();
    for scene in scenes(ask).filter(|scene| !open.contains(&scene.path)) {
        if out.len() >= MAX_SYMBOLS || ask.is_cancelled() {
            return out;
        }
        if let Ok(read) = file::read(&scene.path) {
            let analysis = Analysis::new(scene.path.to_string_lossy(), read);
            add(ask, &scene.uri, &analysis, query, &mut out);
        }
    }
    out
}

fn add(ask: &Ask, uri: &Uri, analysis: &Analysis, query: &str, out: &mut Vec<WorkspaceSymbol>) {
    let places = Places::new(&analysis.source, ask.client.units);
    let left = MAX_SYMBOLS.saturating_sub(out.len());
    for symbol in symbols::matching(analysis, query, left, ask.client.language) {
        out.push(WorkspaceSymbol {
            location: Location {
                uri: uri.clone(),
                range: places.range(symbol.id_span),
            }
            .into(),
            data: None,
            base_symbol_information: BaseSymbolInformation {
                name: symbol.name,
                kind: symbol_kind(symbol.sort),
                tags: None,
                container_name: Some(symbol.detail),
            },
        });
    }
}
