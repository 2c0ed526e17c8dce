//! W308: an intersection whose surface is made of pieces with different properties, and that has no properties of its
//! own.

use std::cell::LazyCell;

use rustc_hash::FxHashSet;

use super::swapped_difference;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::lint::parts::parts;
use crate::lint::properties::{ASPECTS, Properties, sets};
use crate::parallel;
use crate::scene::{DEFAULT_COLOUR, DEFAULT_INDEX, Node, NodeId, Scene, Texture, fold_up};
use crate::solids::proofs::{Proofs, Reason};
use crate::solids::shapes::facts::Facts;
use crate::syntax::table::RecordKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if !(scene.nodes.iter()).any(|n| matches!(n, Node::Intersection(..))) {
        return;
    }
    let looks = looks(scene);
    let seen = seen(scene);
    let parts = parts(scene);
    let owners: FxHashSet<u32> = scene.paints.iter().map(|p| p.owner).collect();
    let mut proofs = Proofs::new(scene, context.bounds());
    // W319 reports empty intersections.
    let empty: LazyCell<FxHashSet<NodeId>, _> = LazyCell::new(|| {
        let is_empty = |proven: &&Proven| matches!(proven.what, Proof::Empty(..));
        let empty = context.proven().iter().filter(is_empty);
        empty.map(|proven| proven.node).collect()
    });
    let mut mixed: Vec<(NodeId, [bool; 3])> = Vec::new();
    for (i, node) in scene.nodes.iter().enumerate() {
        let Node::Intersection(a, b) = *node else {
            continue;
        };
        // In an intersection of a surface with a solid only the surface is seen.
        let surface = [a, b].iter().any(|&c| parts[c as usize].surface.is_some());
        let differ: [bool; 3] = std::array::from_fn(|aspect| {
            let [a, b] = [a, b].map(|c| looks[c as usize][aspect]);
            seen[i] & 1 << aspect != 0 && !same(scene, aspect, a, b)
        });
        // An author writes A ∩ −B in place of A − B to make the cut look like the tool.
        let tool = [a, b].iter().any(|&c| is_complement(scene, c));
        // An author who assigns anything to the result has thought of its look.
        if !surface && !tool && differ.contains(&true) && !owners.contains(&scene.origins[i].id) {
            // W321 reports operands that only touch.
            if context.is_flat(i as NodeId) || empty.contains(&(i as NodeId)) {
                continue;
            }
            // An operand that holds all of the other one leaves no face of its own; operands that lie apart leave no
            // face at all.
            let within =
                |x, y, proofs: &mut Proofs| matches!(proofs.covered(x, y), Some(Reason::Within));
            let nothing = |proofs: &mut Proofs| {
                let whole = |n| [(n, false)];
                proofs.nothing(&whole(a), &whole(b), Some((a, b))).is_some()
            };
            if !within(a, b, &mut proofs) && !within(b, a, &mut proofs) && !nothing(&mut proofs) {
                mixed.push((i as NodeId, differ));
            }
        }
    }
    if !mixed.is_empty() {
        report(context, &mixed, out);
    }
}

fn is_complement(scene: &Scene, node: NodeId) -> bool {
    let mut unpainted = (scene.states(node)).take_while(|(_, n)| !matches!(n, Node::Paint { .. }));
    unpainted.any(|(_, n)| matches!(n, Node::Complement(_)))
}

/// The origin of an aspect (texture, optics or refractive index) of a whole object.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Source {
    Default,
    /// Index into [`Scene::paints`].
    Paint(u32),
    /// The colours of a profile; index into [`Scene::shapes`].
    Profile(u32),
    Mixed,
}

/// For each node the source of each aspect.
fn looks(scene: &Scene) -> Vec<[Source; ASPECTS]> {
    fold_up(&scene.nodes, |_, node, looks: &[[Source; ASPECTS]]| {
        let of = |n: NodeId| looks[n as usize];
        match node {
            Node::Shape(s) => {
                let coloured = scene.shapes[s as usize].geometry.character().has_colours;
                let texture = match coloured {
                    true => Source::Profile(s),
                    false => Source::Default,
                };
                [texture, Source::Default, Source::Default]
            }
            Node::Union(a, b) | Node::Intersection(a, b) => std::array::from_fn(|aspect| {
                let (a, b) = (of(a)[aspect], of(b)[aspect]);
                match same(scene, aspect, a, b) {
                    true => a,
                    false => Source::Mixed,
                }
            }),
            Node::Difference(a, _) | Node::Complement(a) => of(a),
            Node::Transform { child, .. } | Node::Copy { child, .. } => of(child),
            Node::Paint { child, paint } => {
                let set = sets(&scene.paints[paint as usize]);
                std::array::from_fn(|aspect| match set[aspect] {
                    true => Source::Paint(paint),
                    false => of(child)[aspect],
                })
            }
        }
    })
}

fn same(scene: &Scene, aspect: usize, a: Source, b: Source) -> bool {
    let paint = |s: Source| match s {
        Source::Paint(p) => Some(&scene.paints[p as usize]),
        _ => None,
    };
    match (a, b) {
        (Source::Mixed, _) | (_, Source::Mixed) => false,
        _ if a == b => true,
        (Source::Profile(_), _) | (_, Source::Profile(_)) => aspect != 0,
        _ => match aspect {
            0 => {
                const WHITE: &Texture = &Texture::Colour(DEFAULT_COLOUR);
                let texture = |s| paint(s).and_then(|p| p.texture.as_ref()).unwrap_or(WHITE);
                texture(a) == texture(b)
            }
            1 => {
                let optics = |s| paint(s).and_then(|p| p.optics).unwrap_or_default();
                optics(a) == optics(b)
            }
            _ => {
                let index = |s| paint(s).and_then(|p| p.index).unwrap_or(DEFAULT_INDEX);
                index(a) == index(b)
            }
        },
    }
}

/// For each node the aspects, as bits, that can be seen in what is drawn: no paint above the node overrides them. A
/// node that a difference takes away has none.
fn seen(scene: &Scene) -> Vec<u8> {
    const ALL: u8 = (1 << ASPECTS) - 1;
    let mut seen = vec![0; scene.nodes.len()];
    match scene.render {
        Some(render) => seen[render.root as usize] = ALL,
        None => {
            for node in scene.entities.iter().filter_map(|e| e.node()) {
                seen[node as usize] = ALL;
            }
        }
    }
    for (i, node) in scene.nodes.iter().enumerate().rev() {
        let here = seen[i];
        match *node {
            Node::Difference(a, _) => seen[a as usize] |= here,
            Node::Paint { child, paint } => {
                let set = sets(&scene.paints[paint as usize]);
                let left = (0..ASPECTS).filter(|&aspect| !set[aspect]);
                let mask = left.fold(0, |mask, aspect| mask | 1 << aspect);
                seen[child as usize] |= here & mask;
            }
            _ => {
                for child in node.children() {
                    seen[child as usize] |= here;
                }
            }
        }
    }
    seen
}

fn report(context: &Context, mixed: &[(NodeId, [bool; 3])], out: &mut Vec<Diagnostic>) {
    let titles = context.titles();
    let properties = Properties::new(context);
    // W340 proposes a difference in place of these intersections.
    let differences = swapped_difference::reported(context, RecordKind::Intersection);
    let finding = |&(node, differ): &(NodeId, [bool; 3])| {
        let origin = context.scene.origins[node as usize];
        let p = context.params(origin.span)?;
        let operands = [0, 1].map(|i| u32::try_from(p.integer(i)).unwrap_or(0));
        let [first, second] =
            operands.map(|id| Value::Term(titles.get(&id).copied().unwrap_or("object")));
        let aspects = match differ {
            [true, false, false] => "texture",
            [false, true, false] => "optics",
            [false, false, true] => "index",
            [true, true, false] => "texture-optics",
            [true, false, true] => "texture-index",
            [false, true, true] => "optics-index",
            _ => "all",
        };
        let mut d = Diagnostic::new(Code::W308, p.span())
            .with("id", origin.id.to_string())
            .with("first", first)
            .with("first-id", operands[0].to_string())
            .with("second", second)
            .with("second-id", operands[1].to_string())
            .with("aspects", aspects);
        let children = context.scene.nodes[node as usize].children();
        let is_one = !differences.contains(&node);
        for (id, child) in operands.into_iter().zip(children).filter(|_| is_one) {
            if let Some(lines) = properties.again(context, id, child, origin.id, differ) {
                let fix: Fix = context.add_behind(p.span(), "fix", Applicability::Unsafe, &lines);
                d = d.with("source", id.to_string()).fix(fix);
                break;
            }
        }
        Some(d)
    };
    let findings = parallel::map(mixed.len(), |i| finding(&mixed[i]));
    out.extend(findings.into_iter().flatten());
}
