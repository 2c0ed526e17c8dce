//! The pictures that a scene names, seen from where its translation lies.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use super::model::{Node, Scene, Texture};
use crate::diagnostics::Complaint;
use crate::syntax::table::RecordKind;
use crate::translate::target::{Options, Prepared};
use crate::translate::{Feature, FeatureSupport};

/// The pictures that cannot be named from the new place.
#[derive(Default)]
pub(super) struct Left(Vec<String>);

/// Makes every path to a picture lead to the same file from the new place. A scene on standard output keeps its paths.
pub(super) fn follow(model: &mut Scene, scene: &Prepared, options: &Options) -> Left {
    let mut left = Left::default();
    let Some(new) = options.output else {
        return left;
    };
    let (Ok(old), Ok(new)) = (scene.folder().canonicalize(), folder(new).canonicalize()) else {
        return left;
    };
    if old == new {
        return left;
    }
    let mut known: BTreeMap<String, Option<String>> = BTreeMap::new();
    for item in &mut model.nodes {
        let Node::Paint {
            texture: Some(Texture::Image(file)),
            ..
        } = &mut item.node
        else {
            continue;
        };
        let path = known
            .entry(file.clone())
            .or_insert_with(|| moved(file, &old, &new));
        if let Some(path) = path {
            file.clone_from(path);
        }
    }
    let lost = known.into_iter().filter(|(_, path)| path.is_none());
    left.0.extend(lost.map(|(file, _)| file));
    left
}

impl Left {
    /// The support for a feature if pictures are left behind.
    pub(super) fn verdict(&self, feature: Feature, options: &Options) -> Option<FeatureSupport> {
        let is_image = feature == Feature::Record(RecordKind::ImageTexture);
        let output = options.output.filter(|_| is_image && !self.0.is_empty())?;
        let bound = Complaint::new("fidelity-pictures")
            .with("files", self.0.join(", "))
            .with("path", output);
        let note = "an image must lie in the folder of its scene";
        Some(FeatureSupport::approximate(bound, Complaint::term(note)))
    }
}

/// The path to a picture from another folder. `None` where the language has none: it goes down only.
fn moved(file: &str, old: &Path, new: &Path) -> Option<String> {
    let path = old.join(file);
    let real = path.canonicalize().ok()?;
    // A name that is a link stays, if what it leads to is in the folder, too.
    let named = folder(&path).canonicalize().ok()?.join(path.file_name()?);
    let below = |path: &Path| real.starts_with(new).then(|| spelled(path, new)).flatten();
    if let Some(path) = below(&named).or_else(|| below(&real)) {
        return Some(path);
    }
    // Somebody may have copied it already.
    let there = new.join(file).canonicalize().ok()?;
    let bytes = |path: PathBuf| std::fs::read(path).ok();
    let is_same = there.starts_with(new) && bytes(there)? == bytes(real)?;
    is_same.then(|| file.to_owned())
}

/// A path below a folder as scenes write it.
fn spelled(path: &Path, folder: &Path) -> Option<String> {
    let below = path.strip_prefix(folder).ok()?;
    let name = |c: Component| {
        let name = c.as_os_str().to_str()?;
        let is_sound = !name.contains(|c: char| c == '"' || c == '\\' || c.is_control());
        is_sound.then(|| name.to_owned())
    };
    let names: Option<Vec<String>> = below.components().map(name).collect();
    Some(names?.join("/"))
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}
