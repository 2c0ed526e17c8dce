//! Facts about every node that are needed before anything can be written: what it contains, whose properties it shows,
//! and how often it is used. Computed bottom-up in one pass over the arena.

use std::borrow::Cow;

use super::tables::{DEFAULT, PROFILE, Tables, TextureUse};
use crate::scene::{Node, NodeId, Scene};
use crate::solids::bounds::NodeBounds;
use crate::solids::shapes::facts::Facts as _;

/// A property of the points of a node's solids. Each point has the property of its owner: the first operand that holds
/// it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Owned<T> {
    pub first: T,
    /// Whether every point of the node has the property.
    pub uniform: bool,
}

impl<T: Copy + PartialEq> Owned<T> {
    fn one(first: T) -> Owned<T> {
        Owned {
            first,
            uniform: true,
        }
    }

    /// The property of all points, if there is one.
    pub(crate) fn only(self) -> Option<T> {
        self.uniform.then_some(self.first)
    }

    fn or(self, other: Owned<T>) -> Owned<T> {
        Owned {
            first: self.first,
            uniform: self.uniform && other.uniform && self.first == other.first,
        }
    }
}

/// The facts about one node, without what nodes above it paint over it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Material {
    pub has_solid: bool,
    pub has_surface: bool,
    /// Whether some part of the node has been given a texture, or optics.
    pub has_texture: bool,
    pub has_optics: bool,
    /// The texture of all faces of the node, if they have the same one; `face_optics` likewise has their optics.
    pub face_texture: Option<TextureUse>,
    pub face_optics: Option<u32>,
    /// Whether some part of the node lets light through.
    pub transparent: bool,
    pub texture: Owned<TextureUse>,
    pub optics: Owned<u32>,
    pub index: Owned<u32>,
    /// Number of nodes under the root that use the node.
    pub uses: u32,
}

const BARE: Material = Material {
    has_solid: false,
    has_surface: false,
    has_texture: false,
    has_optics: false,
    face_texture: None,
    face_optics: Some(DEFAULT),
    transparent: false,
    texture: Owned {
        first: TextureUse::DEFAULT,
        uniform: true,
    },
    optics: Owned {
        first: DEFAULT,
        uniform: true,
    },
    index: Owned {
        first: DEFAULT,
        uniform: true,
    },
    uses: 0,
};

/// Facts about a scene and its nodes.
pub(crate) struct Facts<'a> {
    pub bounds: Cow<'a, [NodeBounds]>,
    pub tables: Tables,
    pub materials: Vec<Material>,
}

impl<'a> Facts<'a> {
    /// The facts about the nodes that are drawn. `None` if the scene draws nothing.
    pub(crate) fn of(scene: &Scene, bounds: Cow<'a, [NodeBounds]>) -> Option<Facts<'a>> {
        let mut tables = Tables::of(scene);
        let materials = materials(scene, &mut tables, scene.render?.root);
        Some(Facts {
            bounds,
            tables,
            materials,
        })
    }

    /// Whether any node that is drawn lets light through.
    pub(crate) fn is_clear(&self) -> bool {
        self.materials.iter().any(|f| f.uses > 0 && f.transparent)
    }
}

/// The facts about all nodes up to the root. Nodes that the root does not reach have those of `BARE`.
fn materials(scene: &Scene, tables: &mut Tables, root: NodeId) -> Vec<Material> {
    let mut out = vec![BARE; root as usize + 1];
    out[root as usize].uses = 1;
    for (_, node) in scene.below(root) {
        let mut children = node.children();
        let first = children.next();
        for child in first
            .into_iter()
            .chain(children.filter(|c| Some(*c) != first))
        {
            out[child as usize].uses += 1;
        }
    }
    for id in 0..=root as usize {
        let uses = out[id].uses;
        if uses > 0 {
            out[id] = Material {
                uses,
                ..one(scene, tables, &out, &scene.nodes[id])
            };
        }
    }
    out
}

fn one(scene: &Scene, tables: &mut Tables, done: &[Material], node: &Node) -> Material {
    let of = |id: NodeId| done[id as usize];
    match *node {
        Node::Shape(shape) => {
            let geometry = &scene.shapes[shape as usize].geometry;
            let solid = geometry.is_solid();
            let character = geometry.character();
            let coloured = character.has_colours;
            let texture = if coloured { PROFILE } else { DEFAULT };
            Material {
                has_solid: solid,
                has_surface: !solid,
                has_texture: coloured,
                texture: Owned::one(TextureUse::here(texture)),
                // The far side of a triangle with shading normals has a look of its own.
                face_texture: (!character.is_smooth).then_some(TextureUse::here(texture)),
                ..BARE
            }
        }
        Node::Union(a, b) => union(of(a), of(b)),
        Node::Intersection(a, b) => {
            let (a, b) = (of(a), of(b));
            Material {
                has_solid: a.has_solid && b.has_solid,
                has_surface: (a.has_surface && b.has_solid) || (b.has_surface && a.has_solid),
                // An intersection has one inside, with the properties of the first operand.
                texture: a.texture,
                optics: a.optics,
                index: a.index,
                ..union(a, b)
            }
        }
        Node::Difference(a, _) => of(a),
        Node::Complement(child) => Material {
            has_solid: true,
            has_surface: false,
            ..of(child)
        },
        Node::Copy { child, .. } => of(child),
        Node::Transform { child, matrix } => {
            let mut facts = of(child);
            let m = &scene.matrices[matrix as usize];
            facts.texture.first = tables.moved(facts.texture.first, m);
            facts.face_texture = facts.face_texture.map(|t| tables.moved(t, m));
            facts
        }
        Node::Paint { child, paint } => {
            let mut facts = of(child);
            let given = tables.paint(paint);
            if let Some(texture) = given.texture {
                facts.has_texture = true;
                facts.texture = Owned::one(TextureUse::here(texture));
                facts.face_texture = facts.face_texture.map(|_| TextureUse::here(texture));
            }
            if let Some(optics) = given.optics {
                facts.has_optics = true;
                facts.transparent = tables.is_transparent(optics);
                facts.optics = Owned::one(optics);
                facts.face_optics = Some(optics);
            }
            if let Some(index) = given.index {
                facts.index = Owned::one(index);
            }
            facts
        }
    }
}

fn union(a: Material, b: Material) -> Material {
    // Surfaces own no points.
    let (texture, optics, index) = match (a.has_solid, b.has_solid) {
        (true, false) => (a.texture, a.optics, a.index),
        (false, true) => (b.texture, b.optics, b.index),
        _ => (
            a.texture.or(b.texture),
            a.optics.or(b.optics),
            a.index.or(b.index),
        ),
    };
    Material {
        has_solid: a.has_solid || b.has_solid,
        has_surface: a.has_surface || b.has_surface,
        has_texture: a.has_texture || b.has_texture,
        has_optics: a.has_optics || b.has_optics,
        face_texture: a.face_texture.filter(|_| a.face_texture == b.face_texture),
        face_optics: a.face_optics.filter(|_| a.face_optics == b.face_optics),
        transparent: a.transparent || b.transparent,
        texture,
        optics,
        index,
        uses: 0,
    }
}
