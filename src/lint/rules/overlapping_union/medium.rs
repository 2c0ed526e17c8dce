//! Properties of the parts of a union by which light tells the parts apart.

use crate::scene::{DEFAULT_INDEX, Node, NodeId, Optics, Rgb, Scene, Texture};
use crate::solids::shapes::facts::Facts;

/// The optics and the refractive index of a part, as light notices them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Medium {
    pub(super) optics: Optics,
    pub(super) index: Rgb,
}

impl Medium {
    pub(super) fn transmits(&self) -> bool {
        self.optics.kt.iter().any(|&k| k > 0.0)
    }

    pub(super) fn bits(&self) -> [u64; 12] {
        let all = [self.optics.kd, self.optics.ks, self.optics.kt, self.index];
        // Adding 0 makes zeros of both signs one number.
        std::array::from_fn(|i| (all[i / 3][i % 3] + 0.0).to_bits())
    }
}

/// The properties that paints above a node give to it. They override those of the node itself.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Coat {
    pub(super) optics: Option<Optics>,
    pub(super) index: Option<Rgb>,
    /// Index into the scene's paints.
    pub(super) texture: Option<u32>,
}

impl Coat {
    pub(super) fn over(self, scene: &Scene, index: u32) -> Coat {
        let paint = &scene.paints[index as usize];
        Coat {
            optics: self.optics.or(paint.optics),
            index: self.index.or(paint.index),
            texture: self.texture.or(paint.texture.is_some().then_some(index)),
        }
    }

    pub(super) fn medium(self) -> Medium {
        Medium {
            optics: self.optics.unwrap_or_default(),
            index: self.index.unwrap_or(DEFAULT_INDEX),
        }
    }
}

/// The source of the visible colours of an opaque part.
#[derive(Debug, Clone, Copy)]
pub(super) enum Colouring {
    White,
    /// The colours of the scene's paint with this index.
    Paint(u32),
    /// The colours of a profile's own points.
    Own,
}

/// The texture of a colouring, to be compared with others; `None` for the colours of a profile.
pub(super) fn texture(scene: &Scene, colouring: Colouring) -> Option<&Texture> {
    const WHITE: Texture = Texture::Colour([1.0; 3]);
    match colouring {
        Colouring::White => Some(&WHITE),
        Colouring::Paint(paint) => scene.paints[paint as usize].texture.as_ref(),
        Colouring::Own => None,
    }
}

/// The medium and the colouring of the inside of a node, below the paints `coat`. Each is `None` if there are several,
/// or if it is not known.
pub(super) fn looks(
    scene: &Scene,
    mut node: NodeId,
    mut coat: Coat,
) -> (Option<Medium>, Option<Colouring>) {
    // The colouring of the shape at the end of the walk, if there is one.
    let mut own = None;
    loop {
        node = match scene.nodes[node as usize] {
            Node::Shape(s) => {
                let geometry = &scene.shapes[s as usize].geometry;
                let coloured = geometry.character().has_colours;
                own = Some(if coloured {
                    Colouring::Own
                } else {
                    Colouring::White
                });
                break;
            }
            Node::Transform { child, .. } | Node::Copy { child, .. } => child,
            Node::Paint { child, paint } => {
                coat = coat.over(scene, paint);
                child
            }
            Node::Intersection(first, _) | Node::Difference(first, _) => first,
            Node::Union(..) | Node::Complement(_) => break,
        };
        if coat.optics.is_some() && coat.index.is_some() && coat.texture.is_some() {
            break;
        }
    }
    let known = own.is_some() || coat.optics.is_some() && coat.index.is_some();
    (
        known.then(|| coat.medium()),
        coat.texture.map(Colouring::Paint).or(own),
    )
}
