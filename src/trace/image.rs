//! The pictures of a scene's image textures.

use super::bitmap::{Bitmap, MAX_SIDE};
use super::decode::Limits;
use crate::diagnostics::{Code, Diagnostic, Span};
use crate::scene::{Node, Scene, Texture, image_file};
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// The most bytes all pictures of a scene may take once they are decoded.
pub const MAX_BYTES: u64 = 256 << 20;

/// The pictures of a scene, each once however often it is used.
#[derive(Debug, Default)]
pub struct Images(BTreeMap<String, Arc<Bitmap>>);

impl Images {
    /// Reads the pictures of all textures that are drawn, from the scene's folder.
    ///
    /// # Errors
    ///
    /// The first picture that cannot be used is the finding: it lies outside of the folder, it cannot be decoded, it is
    /// larger than [`MAX_SIDE`], or together with the pictures before it takes more than [`MAX_BYTES`].
    pub fn load(scene: &Scene, folder: &Path) -> Result<Images, Box<Diagnostic>> {
        Images::load_within(scene, folder, MAX_BYTES)
    }

    /// [`Images::load`] with another limit than [`MAX_BYTES`].
    ///
    /// # Errors
    ///
    /// The errors of [`Images::load`].
    pub fn load_within(
        scene: &Scene,
        folder: &Path,
        max_bytes: u64,
    ) -> Result<Images, Box<Diagnostic>> {
        let mut images = Images::default();
        let mut left = max_bytes;
        for (file, span) in used(scene) {
            if images.0.contains_key(file) {
                continue;
            }
            let mut found = Vec::new();
            if !image_file::check(file, span, Some(folder), &mut found)
                && let Some(first) = found.pop()
            {
                return Err(Box::new(first));
            }
            let limits = Limits {
                side: MAX_SIDE,
                bytes: left,
                too_large: "pictures-too-large",
            };
            let bitmap = Bitmap::read(&folder.join(file), &limits).map_err(|e| {
                Box::new(
                    Diagnostic::new(Code::E210, span)
                        .case("content")
                        .with("why", e),
                )
            })?;
            left = left.saturating_sub(bitmap.bytes());
            images.0.insert(file.to_owned(), Arc::new(bitmap));
        }
        Ok(images)
    }

    /// The image files of all textures that are drawn, each once, in the order in which the scene names them.
    pub fn files(scene: &Scene) -> Vec<&str> {
        let mut seen = FxHashSet::default();
        let files = used(scene).into_iter().map(|(file, _)| file);
        files.filter(|file| seen.insert(*file)).collect()
    }

    /// The picture of a file, if it could be read.
    pub fn get(&self, file: &str) -> Option<&Arc<Bitmap>> {
        self.0.get(file)
    }

    /// The pictures in the order of their names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Bitmap)> {
        self.0
            .iter()
            .map(|(file, bitmap)| (file.as_str(), &**bitmap))
    }
}

/// The image files of the paints that can be reached from the render record, and where they are
/// named.
fn used(scene: &Scene) -> Vec<(&str, Span)> {
    let mut found = Vec::new();
    let Some(render) = &scene.render else {
        return found;
    };
    for (_, node) in scene.below(render.root) {
        if let Node::Paint { paint, .. } = node
            && let Some(Texture::Image { file, span }) = &scene.paints[paint as usize].texture
        {
            found.push((file.as_str(), *span));
        }
    }
    found.sort_by_key(|(_, span)| span.start);
    found
}
