//! Parts of the outermost union that no ray of a picture can see.
//!
//! A part is unseen when it lies outside of the region that is drawn, or strictly inside a solid that lets no light
//! through and that nothing opens (see [`hidden`]). Both reasons are proofs: a part counts as seen if bounds are not
//! close enough, or if rounding might matter.

mod hidden;
mod members;
mod screens;
pub mod sides;
mod starts;
pub mod view;
pub mod views;

use crate::diagnostics::Span;
use crate::geometry::Aabb;
use crate::scene::{NodeId, Scene};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::solids::{Named, named};
use hidden::Hidden;
use members::{Member, Slot, TOUCHING_SHARE, definitions, members};
use rustc_hash::FxHashMap;
pub use screens::{Screened, screened};
pub use starts::Starts;

/// The reason why no ray can see any of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// Outside of the box of the render record.
    Outside,
    /// Inside of this shape, which is opaque.
    Inside(Named),
}

/// A part that no ray can see anything of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unseen {
    /// The operand node, with its transformations and properties.
    pub node: NodeId,
    /// The ID by which the operand is written in the union.
    pub id: u32,
    /// The place in the text where the entity with this ID is defined.
    pub span: Span,
    pub why: Why,
}

/// The operands of unions that are left out of a picture.
#[derive(Debug, Clone, Default)]
pub struct LeftOut {
    operands: FxHashMap<NodeId, [bool; 2]>,
    /// Whether the root is left out, and with it all of the scene.
    root: bool,
}

impl LeftOut {
    /// The operands of a union that are not left out.
    pub fn kept<T>(
        &self,
        union: NodeId,
        operands: [T; 2],
    ) -> impl DoubleEndedIterator<Item = T> + use<T> {
        let out = match self.operands.is_empty() {
            true => [false; 2],
            false => self.operands.get(&union).copied().unwrap_or_default(),
        };
        let all = operands.into_iter().zip(out);
        all.filter(|(_, out)| !out).map(|(operand, _)| operand)
    }

    /// Whether all of the scene is left out.
    pub fn all(&self) -> bool {
        self.root
    }

    fn add(&mut self, slot: Slot) {
        match slot {
            Slot::Root => self.root = true,
            Slot::Operand(union, operand) => {
                self.operands.entry(union).or_default()[operand] = true;
            }
        }
    }
}

/// The operands that no ray can see and that are left out, and whether the rest is cut open.
#[derive(Debug, Default)]
pub struct UnseenParts {
    /// The unseen operands in their order.
    pub unseen: Vec<Unseen>,
    pub left_out: LeftOut,
    /// Whether a part that is still drawn may reach out of the region that is drawn.
    pub cut: bool,
}

impl UnseenParts {
    /// The result for drawing all parts of a scene, whether a ray can see them or not.
    pub fn all(scene: &Scene, root: NodeId) -> UnseenParts {
        let clip = scene.render.and_then(|r| r.clip);
        UnseenParts {
            cut: clip
                .is_some_and(|(min, max)| is_cut(&node_bounds(scene), root, &Aabb::new(min, max))),
            ..UnseenParts::default()
        }
    }
}

/// Finds the parts that no ray of a picture can see.
pub fn find(scene: &Scene, root: NodeId) -> UnseenParts {
    find_with(scene, root, 0.0)
}

/// Like [`find`], but a ball that touches something in a single point counts as apart from it. The result says what a
/// viewer does not see; it does not prove that a picture is the same without these parts.
pub fn find_but_for_points(scene: &Scene, root: NodeId) -> UnseenParts {
    find_with(scene, root, TOUCHING_SHARE)
}

fn find_with(scene: &Scene, root: NodeId, less: f64) -> UnseenParts {
    let bounds = node_bounds(scene);
    let all = members(scene, &bounds, root);
    let starts = Starts::new(scene, &bounds);
    let clip = scene.render.and_then(|r| r.clip);
    let clip = clip.map(|(min, max)| Aabb::new(min, max));
    let is_cut = (clip.as_ref()).is_some_and(|clip| is_cut(&bounds, root, clip));
    // The bounds may be millions and are not needed any more.
    drop(bounds);
    // Rounding moves the ends of rays by a share of how far these go.
    let reach = clip.map_or(0.0, |c| c.far()).max(starts.reach());
    let hair = |b: &Aabb| APART_REL_GAP * reach.max(b.far());
    let mut why: Vec<Option<Why>> = vec![None; all.len()];
    if let Some(clip) = &clip {
        for (why, member) in why.iter_mut().zip(&all) {
            let apart =
                !member.bounds.is_empty() && is_apart(&member.bounds, clip, hair(&member.bounds));
            *why = apart.then_some(Why::Outside);
        }
    }
    let whole = |m: &Member| match &clip {
        None => true,
        Some(clip) => (0..3).all(|i| {
            let hair = hair(&m.bounds);
            clip.min[i] + hair < m.bounds.min[i] && m.bounds.max[i] + hair < clip.max[i]
        }),
    };
    let left: Vec<u32> = (0..all.len() as u32)
        .filter(|&i| why[i as usize].is_none())
        .collect();
    for (i, holder) in Hidden::find(scene, (&all, &left), &starts, whole, less) {
        why[i as usize] = named(scene, all[holder as usize].node).map(Why::Inside);
    }
    let mut found = UnseenParts::default();
    let spans: FxHashMap<u32, Span> = match why.iter().any(Option::is_some) {
        true => definitions(scene),
        false => FxHashMap::default(),
    };
    for (member, why) in all.iter().zip(&why) {
        if let Some(why) = *why {
            let id = member.id(scene);
            let span = spans.get(&id).copied().unwrap_or_default();
            found.unseen.push(Unseen {
                node: member.node,
                id,
                span,
                why,
            });
            found.left_out.add(member.slot);
        }
    }
    found.cut = clip.is_some_and(|clip| {
        let mut seen = all.iter().zip(&why).filter(|(_, why)| why.is_none());
        is_cut && seen.any(|(m, _)| !clip.holds(&m.bounds))
    });
    found
}

/// Whether some part of the scene may reach out of the region that is drawn.
fn is_cut(bounds: &[NodeBounds], root: NodeId, clip: &Aabb) -> bool {
    !clip.holds(&bounds[root as usize].all)
}

/// The least gap between two boxes that count as apart, as a share of the largest coordinates of boxes and of ray
/// starts.
const APART_REL_GAP: f64 = 1e-9;

/// Whether two boxes are more than `hair` apart along some axis.
fn is_apart(a: &Aabb, b: &Aabb, hair: f64) -> bool {
    (0..3).any(|i| a.max[i] + hair < b.min[i] || b.max[i] + hair < a.min[i])
}
