//! Parts of a union that is taken away, which lie apart from what is cut.

use rustc_hash::FxHashSet;

use super::about;
use super::touching::parts;
use crate::diagnostics::Diagnostic;
use crate::lint::Context;
use crate::scene::{Node, NodeId};
use crate::solids::proofs::Proofs;

/// Reports each part that no other operation uses, and that has nothing in common with what its tool is taken from.
/// `proven` are the operations that are reported already.
pub(super) fn check(context: &Context, proven: &FxHashSet<NodeId>, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let is_cut = |n: &Node| matches!(n, Node::Difference(..));
    if !scene.nodes.iter().any(is_cut) {
        return;
    }
    let mut uses = vec![0_u32; scene.nodes.len()];
    for child in scene.nodes.iter().flat_map(|n| n.children()) {
        uses[child as usize] += 1;
    }
    let is_own = |node: NodeId| uses[node as usize] == 1;
    let mut proofs: Option<Proofs> = None;
    for (node, made) in (0..).zip(&scene.nodes) {
        let Node::Difference(a, tool) = *made else {
            continue;
        };
        // Of a tool that is a cutter for several objects, a part may be for another one.
        if proven.contains(&node) || !is_own(tool) {
            continue;
        }
        let all = parts(context, tool).filter(|all| all.len() > 1);
        for part in all.into_iter().flatten().filter(|&part| is_own(part)) {
            let proofs = proofs.get_or_insert_with(|| Proofs::new(scene, context.bounds()));
            let (first, second) = ([(a, false)], [(part, false)]);
            if proofs.nothing(&first, &second, Some((a, part))).is_some()
                && let Some((finding, p)) = about(context, node, (a, part))
            {
                let tool = p.integer(1).to_string();
                out.push(finding.case("part").with("tool", tool));
            }
        }
    }
}
