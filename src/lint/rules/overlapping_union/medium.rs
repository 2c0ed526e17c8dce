//! What light notices of the parts of a union.

use crate::scene::{DEFAULT_INDEX, Node, NodeId, Optics, Rgb, Scene};

/// What light notices of a part.
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
        // Zeros of both signs are one number.
        std::array::from_fn(|i| (all[i / 3][i % 3] + 0.0).to_bits())
    }
}

/// What was given to the whole, which overrides what its parts have.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Coat {
    pub(super) optics: Option<Optics>,
    pub(super) index: Option<Rgb>,
}

impl Coat {
    pub(super) fn over(self, scene: &Scene, paint: u32) -> Coat {
        let paint = &scene.paints[paint as usize];
        Coat {
            optics: self.optics.or(paint.optics),
            index: self.index.or(paint.index),
        }
    }

    pub(super) fn medium(self) -> Medium {
        Medium {
            optics: self.optics.unwrap_or_default(),
            index: self.index.unwrap_or(DEFAULT_INDEX),
        }
    }
}

/// The medium of what is within a node; `None` where it has several or that is not known.
pub(super) fn medium(scene: &Scene, mut node: NodeId, mut coat: Coat) -> Option<Medium> {
    loop {
        if coat.optics.is_some() && coat.index.is_some() {
            return Some(coat.medium());
        }
        node = match scene.nodes[node as usize] {
            Node::Shape(_) => return Some(coat.medium()),
            Node::Transform { child, .. } | Node::Copy { child, .. } => child,
            Node::Paint { child, paint } => {
                coat = coat.over(scene, paint);
                child
            }
            Node::Intersection(first, _) | Node::Difference(first, _) => first,
            Node::Union(..) | Node::Complement(_) => return None,
        };
    }
}
