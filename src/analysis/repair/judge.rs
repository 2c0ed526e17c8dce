//! What is left to be said of a scene: the less, the likelier it is what a person meant.

use crate::analysis::Analysis;
use crate::diagnostics::{Code, Severity};
use crate::scene::{Node, NodeId, Scene, View};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::solids::proofs::{Literals, Proofs};
use crate::trace::plan::unseen::view::out_of_view;

/// What weighs most first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Left {
    pub errors: usize,
    /// Objects that are empty, that nothing needs, that change nothing, or that no camera sees.
    pub in_vain: usize,
    pub warnings: usize,
    pub notes: usize,
}

pub fn errors(analysis: &Analysis) -> usize {
    analysis.read.iter().filter(|d| d.is_error()).count()
}

/// Runs the rules.
pub fn left(analysis: &Analysis) -> Left {
    let mut left = Left {
        errors: 0,
        in_vain: 0,
        warnings: 0,
        notes: 0,
    };
    for d in analysis.findings() {
        match (d.severity, d.code) {
            (Severity::Error, _) => left.errors += 1,
            (_, Code::W310 | Code::W319 | Code::W305 | Code::W306 | Code::W327) => {
                left.in_vain += 1;
            }
            (Severity::Warning, _) => left.warnings += 1,
            (Severity::Note, _) => left.notes += 1,
            (Severity::Style, _) => {}
        }
    }
    let bounds = node_bounds(&analysis.scene);
    left.in_vain += useless(&analysis.scene, &bounds);
    left.in_vain += usize::from(is_unseen(&analysis.scene, &bounds));
    left
}

/// How many operations are what one of their operands is: a part of a union within the other, a solid
/// taken away from what it does not meet, an intersection with all around.
fn useless(scene: &Scene, bounds: &[NodeBounds]) -> usize {
    let mut proofs = Proofs::new(scene, bounds);
    let mut lists: Vec<Literals> = Vec::with_capacity(scene.nodes.len());
    let mut count = 0;
    for (i, node) in scene.nodes.iter().enumerate() {
        let own = Literals::new((i as NodeId, false));
        let mut within = |a: NodeId, b: NodeId, lists: &[Literals]| {
            let outside = proofs.complement(b, lists);
            a == b || proofs.nothing(&lists[a as usize], &outside, None).is_some()
        };
        let (vain, list) = match *node {
            Node::Paint { child, .. } | Node::Copy { child, .. } => (false, lists[child as usize]),
            Node::Union(a, b) | Node::Intersection(a, b) => {
                (within(a, b, &lists) || within(b, a, &lists), own)
            }
            Node::Difference(a, b) => {
                let apart = proofs.nothing(&lists[a as usize], &lists[b as usize], Some((a, b)));
                (apart.is_some(), own)
            }
            _ => (false, own),
        };
        count += usize::from(vain);
        lists.push(list);
    }
    count
}

/// Whether the camera sees nothing of all that is drawn.
fn is_unseen(scene: &Scene, bounds: &[NodeBounds]) -> bool {
    let (Some(render), View::Mono(at)) = (&scene.render, &scene.view) else {
        return false;
    };
    let Some(camera) = scene.cameras.get(*at) else {
        return false;
    };
    let nothing = bounds[render.root as usize].all.is_empty();
    nothing || out_of_view(scene, bounds, render.root, camera).is_some()
}
