//! Looks and materials of nodes, with the decisions from above them.

use super::Model;
use super::state::{Appearance, Medium, State};
use super::tables::{DEFAULT, TextureUse};
use crate::scene::{Node, NodeId};
use crate::translate::pov::tree::Modifier;

/// A look that is fully known, and the index behind it.
pub(crate) type Substance = (Appearance, u32);

impl<'a> Model<'a> {
    /// Whether any of a node lets light through.
    pub(crate) fn is_transparent(&self, node: NodeId, look: Appearance) -> bool {
        match look {
            Appearance::Above { transparent } => transparent,
            Appearance::Own {
                optics: Some(o), ..
            } => self.tables.is_transparent(o),
            Appearance::Own { optics: None, .. } => self.materials[node as usize].transparent,
        }
    }

    /// Whether faces inside a node can be seen.
    pub(crate) fn is_seen_into(&self, node: NodeId, state: State) -> bool {
        self.cut_open || self.is_transparent(node, state.look)
    }

    /// The optics and index of a node that is one medium. What an object around the node gives is
    /// the same for all operands and counts as the default.
    pub(crate) fn medium(&self, node: NodeId, state: State) -> Option<(u32, u32)> {
        let optics = match state.look {
            Appearance::Above { .. } => DEFAULT,
            Appearance::Own { optics, .. } => {
                optics.or(self.materials[node as usize].optics.only())?
            }
        };
        Some((optics, self.own_index(node, state)?))
    }

    fn own_index(&self, node: NodeId, state: State) -> Option<u32> {
        match state.medium {
            Medium::Above => Some(DEFAULT),
            Medium::Own => self.materials[node as usize].index.only(),
        }
    }

    /// The substance of all of a node, if it is the same everywhere.
    pub(crate) fn substance(&self, node: NodeId, state: State) -> Option<Substance> {
        let f = &self.materials[node as usize];
        let look = match state.look {
            Appearance::Above { .. } => state.look,
            Appearance::Own { texture, optics } => Appearance::Own {
                texture: Some(texture.or(f.texture.only())?),
                optics: Some(optics.or(f.optics.only())?),
            },
        };
        Some((look, self.own_index(node, state)?))
    }

    /// The modifier that gives a node its look, where that is the same for all of it and can be
    /// said from outside; and the look that is left to say below.
    pub(crate) fn settle_look(
        &mut self,
        node: NodeId,
        look: Appearance,
    ) -> (Appearance, Option<Modifier<'a>>) {
        let Appearance::Own { texture, optics } = look else {
            return (look, None);
        };
        let f = self.materials[node as usize];
        let texture = texture.or((!f.has_texture).then_some(TextureUse::DEFAULT));
        let optics = optics.or((!f.has_optics).then_some(DEFAULT));
        // Triangles with normals that turn away have a look for each side, and so have sheets in glass.
        let holds = |holders: &[bool]| holders.get(node as usize) == Some(&true);
        let sides = |o: u32| {
            let sheets = holds(&self.holds_sheets) && self.tables.is_transparent(o);
            (sheets || holds(&self.holds_backward_normals))
                && !matches!(self.scene.nodes[node as usize], Node::Shape(_))
        };
        match (texture.or(f.face_texture), optics.or(f.face_optics)) {
            (Some(t), Some(o)) if !sides(o) && !self.tables.is_laid_on_shapes(t.texture) => (
                Appearance::Above {
                    transparent: self.tables.is_transparent(o),
                },
                self.textures.number(t, o, None).map(Modifier::Texture),
            ),
            _ => (Appearance::Own { texture, optics }, None),
        }
    }

    /// A look seen from inside a transformation.
    pub(crate) fn look_below(&mut self, look: Appearance, matrix: u32) -> Appearance {
        match look {
            Appearance::Own {
                texture: Some(texture),
                optics,
            } => Appearance::Own {
                texture: Some(
                    self.tables
                        .moved_back(texture, &self.scene.matrices[matrix as usize]),
                ),
                optics,
            },
            _ => look,
        }
    }
}
