//! Differences that take away an object with colours of its own, as if a union were to join it, or as if the operands
//! were swapped.

use rustc_hash::{FxHashMap, FxHashSet};

use super::super::idle_difference::touching::touch;
use super::super::swapped_difference;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::geometry::Aabb;
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Node, NodeId, Scene};
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};

/// Least number of colours of a tool that is no hole.
const TOOL_COLOURS: usize = 2;
/// Least share of the first operand's box within that of a tool which rather is what remains.
const MIN_SHARE_WITHIN: f64 = 0.9;
/// Least ratio of the volume of the box of such a tool to that of the first operand.
const MIN_VOLUME_RATIO: f64 = 4.0;

/// The indices of those colours that a difference takes away in the place of a union, and the findings about these
/// differences. Each of `colours` comes with a node that has the colour.
pub(super) fn unions(
    context: &Context,
    colours: &[(usize, NodeId)],
    is_drawn: impl Fn(NodeId) -> bool,
) -> (FxHashSet<usize>, Vec<Diagnostic>) {
    let mut told = FxHashSet::default();
    let mut findings = Vec::new();
    if colours.is_empty() {
        return (told, findings);
    }
    let scene = context.scene;
    let above = Above::new(scene, is_drawn);
    let mut of: FxHashMap<NodeId, FxHashSet<usize>> = FxHashMap::default();
    for &(colour, node) in colours {
        if let Some(difference) = above.cut[node as usize] {
            of.entry(difference).or_default().insert(colour);
        }
    }
    if of.is_empty() {
        return (told, findings);
    }
    let mut all: Vec<(NodeId, FxHashSet<usize>)> = of.into_iter().collect();
    all.sort_unstable_by_key(|(difference, _)| *difference);
    let swapped = swapped_difference::reported(context, RecordKind::Difference);
    for (difference, colours) in all {
        let Node::Difference(a, tool) = scene.nodes[difference as usize] else {
            continue;
        };
        if swapped.contains(&difference) {
            told.extend(colours);
            continue;
        }
        let is_joined = |node| is_union(scene, node);
        let is_many = colours.len() >= TOOL_COLOURS && is_joined(tool);
        let is_in_chain = is_joined(a) && above.in_union[difference as usize];
        if !is_many && !is_in_chain {
            continue;
        }
        told.extend(colours);
        // Another rule reports a difference that takes nothing away.
        if touch(context, a, tool) {
            continue;
        }
        let origin = scene.origins[difference as usize];
        let Some(p) = context.params(origin.span) else {
            continue;
        };
        let union = RecordType::of(RecordKind::Union).code.to_string();
        let fix = Fix::replace("fix", Applicability::Choice, p.type_span(), union.clone());
        let fix = fix.with("number", quote(&union));
        let d = Diagnostic::new(Code::W331, p.span());
        let d = d.with("id", origin.id.to_string());
        let d = d.with("tool", p.integer(1).to_string());
        let boxes = [a, tool].map(|n| context.bounds()[n as usize].all);
        let d = match is_rather_what_remains(&boxes) {
            true => d.case("swapped").fix(swap(&p)),
            false => d.case("union"),
        };
        findings.push(d.fix(fix));
    }
    (told, findings)
}

/// Whether a tool rather is what remains, by the boxes of the first operand and of the tool: the tool's is much larger,
/// or holds nearly all of the other.
fn is_rather_what_remains([first, tool]: &[Aabb; 2]) -> bool {
    if !first.is_bounded() || !tool.is_bounded() {
        return false;
    }
    let volume = |b: &Aabb| match b.is_empty() {
        true => 0.0,
        false => b.extent().iter().product::<f64>(),
    };
    let [own, other, common] = [first, tool, &first.intersection(tool)].map(volume);
    own > 0.0
        && common > 0.0
        && (other >= MIN_VOLUME_RATIO * own || common >= MIN_SHARE_WITHIN * own)
}

fn swap(p: &Params) -> Fix {
    let [one, two] = [0, 1].map(|i| p.text_of(i).to_owned());
    let text = quote(&format!("{} {} {two} {one}", p.id, p.ty.code));
    let edits = [(0, two), (1, one)].map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    Fix {
        title: "fix-swap",
        values: vec![("number", text.into())],
        applicability: Applicability::Choice,
        edits: edits.into(),
    }
}

/// Whether an object is a union, which may be painted or moved.
fn is_union(scene: &Scene, node: NodeId) -> bool {
    scene
        .states(node)
        .any(|(_, n)| matches!(n, Node::Union(..)))
}

struct Above {
    /// For each node the outermost difference that takes it away.
    cut: Vec<Option<NodeId>>,
    /// Whether each node is an operand of a union.
    in_union: Vec<bool>,
}

impl Above {
    fn new(scene: &Scene, is_drawn: impl Fn(NodeId) -> bool) -> Above {
        let mut cut: Vec<Option<NodeId>> = vec![None; scene.nodes.len()];
        let mut in_union = vec![false; scene.nodes.len()];
        // Children stand before their parents.
        let nodes = (0..scene.nodes.len()).rev();
        for at in nodes.filter(|&at| is_drawn(at as NodeId)) {
            let node = scene.nodes[at];
            let joins = match node {
                Node::Union(..) => true,
                Node::Paint { .. } | Node::Transform { .. } => in_union[at],
                _ => false,
            };
            let tool = match node {
                Node::Difference(_, tool) => Some(tool),
                _ => None,
            };
            for child in node.children() {
                let own = (tool == Some(child)).then_some(at as NodeId);
                let child = child as usize;
                cut[child] = cut[child].or(cut[at]).or(own);
                in_union[child] |= joins;
            }
        }
        Above { cut, in_union }
    }
}
