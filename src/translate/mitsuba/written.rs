//! Shapes as they were written: as Mitsuba's own, or as meshes.

use std::collections::{BTreeSet, HashMap};

use crate::scene::{Scene, Texture};
use crate::syntax::table::RecordKind;
use crate::trace::graph::Graph;
use crate::translate::mesh::SurfaceLabel;

/// The shapes that were written, by type of record: their own types, and those of the textures on them.
pub(super) struct Written<'a> {
    graph: &'a Graph,
    /// The kind of each shape, by its ID.
    types: HashMap<u32, RecordKind>,
    exact: BTreeSet<(RecordKind, u32)>,
    meshes: BTreeSet<(RecordKind, u32)>,
}

impl<'a> Written<'a> {
    pub(super) fn new(scene: &Scene, graph: &'a Graph) -> Written<'a> {
        Written {
            graph,
            types: scene.shapes.iter().map(|s| (s.id, s.ty().kind)).collect(),
            exact: BTreeSet::new(),
            meshes: BTreeSet::new(),
        }
    }

    /// Notes that a surface was written.
    pub(super) fn note(&mut self, skin: &SurfaceLabel, exact: bool) {
        let texture = skin.texture.as_ref();
        let laid = texture.and_then(|t| match &self.graph.textures[t.texture as usize] {
            Texture::Checkerboard { .. } => Some(RecordKind::Checkerboard),
            Texture::Image { .. } => Some(RecordKind::ImageTexture),
            _ => None,
        });
        let list = match exact {
            true => &mut self.exact,
            false => &mut self.meshes,
        };
        for kind in self.types.get(&skin.shape).copied().into_iter().chain(laid) {
            list.insert((kind, skin.shape));
        }
    }

    /// The numbers of shapes with a type of record that are Mitsuba's own, and that are meshes. A shape may be both.
    pub(super) fn counts(&self, kind: RecordKind) -> [usize; 2] {
        [&self.exact, &self.meshes].map(|list| list.iter().filter(|(k, _)| *k == kind).count())
    }
}
