//! Paths to the pictures of a scene, as seen from the folder of its translation.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use super::model::{Node, Scene, Texture};
use crate::diagnostics::Complaint;
use crate::syntax::table::RecordKind;
use crate::translate::target::{Options, Prepared};
use crate::translate::{Feature, FeatureSupport};

/// The paths of pictures that cannot be named from the new folder.
#[derive(Default)]
pub(super) struct Left(Vec<String>);

/// Changes every path to a picture so that it leads to the same file from the folder of the output. Returns the
/// pictures for which there is no path. A scene on standard output keeps its paths.
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
    /// The support for image textures if pictures are left behind; `None` for other features, and if none is left
    /// behind.
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

/// The path to a picture from the folder `new`. `None` if there is none: paths of the language lead down only.
fn moved(file: &str, old: &Path, new: &Path) -> Option<String> {
    let path = old.join(file);
    let real = path.canonicalize().ok()?;
    // The name of a link is kept, if the file that it leads to is in the new folder, too.
    let named = folder(&path).canonicalize().ok()?.join(path.file_name()?);
    let below = |path: &Path| real.starts_with(new).then(|| spelled(path, new)).flatten();
    if let Some(path) = below(&named).or_else(|| below(&real)) {
        return Some(path);
    }
    // A copy of the picture may be in the new folder already.
    let there = new.join(file).canonicalize().ok()?;
    let bytes = |path: PathBuf| std::fs::read(path).ok();
    let is_same = there.starts_with(new) && bytes(there)? == bytes(real)?;
    is_same.then(|| file.to_owned())
}

/// A path below a folder as scenes write it; `None` if a name has a character that scenes cannot write.
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
