//! Looks and media of nodes, given the decisions that nodes above them have made.

use super::Model;
use super::state::{Appearance, Medium, State};
use super::tables::{DEFAULT, TextureUse};
use crate::scene::{Node, NodeId};
use crate::translate::pov::tree::Modifier;

/// A look whose texture and optics are both known, and the number of the refractive index inside.
pub(crate) type Substance = (Appearance, u32);

impl<'a> Model<'a> {
    /// Whether any part of a node lets light through when the node has this look.
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

    /// The numbers of the optics and the index of a node; `None` if the node is of several media. A property that an
    /// object around the node gives is the same for all operands, and counts as the default.
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

    /// The substance of a node; `None` if it is not the same everywhere in the node.
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

    /// Splits a look in two: the part that is left to give below the node, and the modifier that gives the whole node
    /// its look. Without a modifier, the look differs within the node or cannot be given from outside.
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
        // Triangles whose normals turn away from the eye have a look for each side, and so have sheets in glass: shapes
        // get such a look one by one.
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

    /// A look in the coordinates inside a transformation: a texture in space is moved back by the matrix.
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
