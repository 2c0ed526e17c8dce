//! Symbols of all scenes in the client's folders.

use std::path::Path;

use gen_lsp_types::{BaseSymbolInformation, Location, Uri, WorkspaceSymbol};
use ignore::WalkBuilder;

use super::ask::Ask;
use super::convert::symbol_kind;
use super::position::Places;
use super::uri::{path_of, uri_of};
use crate::analysis::{Analysis, file};
use crate::features::symbols;

/// How many symbols are given, files looked at, and bytes read of those that are not open.
const MAX_SYMBOLS: usize = 500;
const MAX_FILES: usize = 2000;
const MAX_BYTES: u64 = 32_000_000;

/// The entities that a query fits, of open files first.
pub fn symbols(ask: &Ask, query: &str) -> Vec<WorkspaceSymbol> {
    let mut out = Vec::new();
    for file in ask.files.values() {
        add(ask, &file.uri, file.analysis(), query, &mut out);
    }
    let (mut files, mut bytes) = (0, 0);
    for folder in ask.folders.iter().filter_map(path_of) {
        for path in scenes(&folder) {
            files += 1;
            bytes += std::fs::metadata(&path).map_or(0, |m| m.len());
            let is_enough = files > MAX_FILES || bytes > MAX_BYTES || out.len() >= MAX_SYMBOLS;
            if is_enough || ask.is_cancelled() {
                return out;
            }
            let Some(uri) = uri_of(&path).filter(|uri| !ask.files.contains_key(uri)) else {
                continue;
            };
            if let Ok(read) = file::read(&path) {
                let analysis = Analysis::new(path.to_string_lossy(), read);
                add(ask, &uri, &analysis, query, &mut out);
            }
        }
    }
    out
}

fn scenes(folder: &Path) -> impl Iterator<Item = std::path::PathBuf> {
    let walk = WalkBuilder::new(folder).build().filter_map(Result::ok);
    let is_scene = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "zpg");
    walk.map(ignore::DirEntry::into_path).filter(is_scene)
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
