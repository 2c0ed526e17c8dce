//! W308: an intersection whose surface is made of pieces with different properties.

use rayon::prelude::*;
use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::parts::parts;
use crate::lint::properties::{ASPECTS, Properties, sets};
use crate::scene::{DEFAULT_COLOUR, DEFAULT_INDEX, Geometry, Node, NodeId, Scene, Texture};
use crate::solids::proofs::{Proofs, Reason};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if !(scene.nodes.iter()).any(|n| matches!(n, Node::Intersection(..))) {
        return;
    }
    let looks = looks(scene);
    let seen = seen(scene);
    let parts = parts(scene);
    let owners: FxHashSet<u32> = scene.paints.iter().map(|p| p.owner).collect();
    let mut proofs = Proofs::new(scene, context.bounds());
    let mut mixed: Vec<(NodeId, [bool; 3])> = Vec::new();
    for (i, node) in scene.nodes.iter().enumerate() {
        let Node::Intersection(a, b) = *node else {
            continue;
        };
        // Of a surface and a solid only the surface is seen.
        let surface = [a, b].iter().any(|&c| parts[c as usize].surface.is_some());
        let differ: [bool; 3] = std::array::from_fn(|aspect| {
            let [a, b] = [a, b].map(|c| looks[c as usize][aspect]);
            seen[i] & 1 << aspect != 0 && !same(scene, aspect, a, b)
        });
        // A ∩ −B in place of A − B is how the cut is made to look like the tool.
        let tool = [a, b].iter().any(|&c| is_complement(scene, c));
        // Who assigns anything to the result has thought of what it looks like.
        if !surface && !tool && differ.contains(&true) && !owners.contains(&scene.origins[i].id) {
            // Of what holds all of the other one no face is left; of what is apart, of neither.
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

fn is_complement(scene: &Scene, mut node: NodeId) -> bool {
    loop {
        node = match scene.nodes[node as usize] {
            Node::Complement(_) => return true,
            Node::Transform { child, .. } | Node::Copy { child, .. } => child,
            _ => return false,
        };
    }
}

/// Where all of an object has an aspect from, if it is the same everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Source {
    Default,
    /// Index into [`Scene::paints`].
    Paint(u32),
    /// The colours of a profile; index into [`Scene::shapes`].
    Profile(u32),
    Mixed,
}

/// What each node looks like, aspect by aspect.
fn looks(scene: &Scene) -> Vec<[Source; ASPECTS]> {
    let mut looks: Vec<[Source; ASPECTS]> = Vec::with_capacity(scene.nodes.len());
    for node in &scene.nodes {
        let of = |n: NodeId| looks[n as usize];
        looks.push(match *node {
            Node::Shape(s) => {
                let coloured = matches!(&scene.shapes[s as usize].geometry,
                    Geometry::Revolution { colours, .. } if !colours.is_empty());
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
        });
    }
    looks
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

/// Which aspects of each node, as bits, can be seen in what is drawn: nothing that holds it overrides
/// them. Of what a difference takes away none can.
fn seen(scene: &Scene) -> Vec<u8> {
    const ALL: u8 = (1 << ASPECTS) - 1;
    let mut seen = vec![0; scene.nodes.len()];
    match scene.render {
        Some(render) => seen[render.root as usize] = ALL,
        None => {
            for node in scene.entities.iter().filter_map(|e| e.node) {
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
                for child in node.children().into_iter().flatten() {
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
        let mut d = Diagnostic::new(Code::W308, p.span)
            .with("id", origin.id.to_string())
            .with("first", first)
            .with("first-id", operands[0].to_string())
            .with("second", second)
            .with("second-id", operands[1].to_string())
            .with("aspects", aspects);
        let children = context.scene.nodes[node as usize].children();
        for (id, child) in operands.into_iter().zip(children.into_iter().flatten()) {
            if let Some(lines) = properties.again(context, id, child, origin.id, differ) {
                let fix: Fix = context.add_behind(p.span, "fix", Applicability::Unsafe, &lines);
                d = d.with("source", id.to_string()).fix(fix);
                break;
            }
        }
        Some(d)
    };
    out.par_extend(mixed.par_iter().filter_map(finding));
}

#[cfg(test)]
mod tests {
    use crate::diagnostics::Applicability;
    use crate::lint::testing::{fixed, fixes, found, messages};

    /// Two balls, 2 and 3, some properties, and then the records given.
    fn scene(records: &str) -> String {
        let start = "7 -701 1 0 0\n8 -201 0.1 0 0.9\n2 9 1\n3 11 1 0 0 1\n";
        start.to_owned() + records
    }

    #[test]
    fn operands_that_differ() {
        for (paint, aspects) in [
            ("2 -701 1 0 0", "colour"),
            ("3 -201 0.5 0.5 0", "optical property"),
            (
                "3 -203 1.5 1.5 1.5\n3 -201 0 0 1",
                "optical property and refractive index",
            ),
            ("2 -299 7 8", "colour and optical property"),
            ("2 -399 2 2 7 7", "colour"),
        ] {
            let scene = scene(&format!("{paint}\n4 -102 2 3"));
            let line = 5 + paint.lines().count();
            assert_eq!(found(&scene), [format!("W308 {line}:1")]);
            assert_eq!(
                messages(&scene),
                [format!(
                    "the intersection 4 keeps two looks: the sphere at the origin 2 and the sphere 3 differ in {aspects}"
                )]
            );
        }
    }

    #[test]
    fn parts_that_differ() {
        // A union of two colours always differs from what cuts it.
        let cut = "2 -701 1 0 0\n4 -101 2 3\n5 12 -1 -1 -1 1 1 1\n6 -102 4 5";
        assert_eq!(found(&scene(cut)), ["W308 8:1"]);
        assert!(fixes(&scene(cut)).is_empty());
    }

    #[test]
    fn silent_where_nothing_is_mixed() {
        for records in [
            // No properties, and equal ones.
            "4 -102 2 3",
            "2 -701 1 0 0\n3 -299 7 0\n4 -102 2 3",
            "2 -701 1 1 1\n4 -102 2 3",
            // A difference has the properties of the first operand.
            "2 -701 1 0 0\n4 -103 2 3",
            "2 -701 1 0 0\n4 -101 2 3",
            // So is this one, but the cut keeps the properties of the tool.
            "2 -701 1 0 0\n4 -104 2\n5 -102 3 4",
            // Assigned to the result, at once or after a move.
            "2 -701 1 0 0\n4 -102 2 3\n4 -299 7 8",
            "2 -701 1 0 0\n4 -102 2 3\n4 -1 1 0 0\n4 -701 0 1 0",
            // What holds the result covers what differs.
            "2 -701 1 0 0\n4 -102 2 3\n5 12 -1 -1 -1 1 1 1\n6 -101 4 5\n6 -701 0 1 0\n1 9999 6 0",
            // A tool is not seen.
            "2 -701 1 0 0\n4 -102 2 3\n5 12 -1 -1 -1 1 1 1\n6 -103 5 4\n1 9999 6 0",
            // Nothing is left of one of them, or of both.
            "2 -701 1 0 0\n5 12 -3 -3 -3 3 3 3\n4 -102 2 5",
            "2 -701 1 0 0\n5 12 -1.1 -1.1 -1.1 1.1 1.1 1.1\n5 -2 45 1\n4 -102 5 2",
            "2 -701 1 0 0\n5 4 0 1 0 -1.1\n4 -102 5 2",
            "2 -701 1 0 0\n3 -1 2 0 0\n4 -102 3 2",
            // It was painted later.
            "4 -102 2 3\n2 -701 1 0 0\n5 -101 2 4",
        ] {
            let all = found(&scene(records));
            assert!(
                !all.iter().any(|f| f.starts_with("W308")),
                "{records}: {all:?}"
            );
        }
    }

    #[test]
    fn silent_about_surfaces() {
        let all = found(&scene("5 5 0 0 1 1\n5 -701 1 0 0\n6 -102 5 2"));
        assert_eq!(all, ["W313 7:8"]);
    }

    #[test]
    fn the_fix_assigns_what_an_operand_has() {
        let before = scene("2 -299 7 8 # glass #\n2 -1 0 0 0.5\n4 -102 2 3 # lens #\n9 -401 1");
        let after = before.replace("# lens #", "# lens #\n4 -299 7 8");
        assert_eq!(fixed(&before), after);
        assert!(found(&after).is_empty());
        assert_eq!(
            fixes(&before),
            [(
                "give 4 the properties of 2".to_owned(),
                Applicability::Unsafe
            )]
        );
        // Of the second operand, where the first has none; and all of its records.
        let before = scene("3 -701 1 0 0\n3 -201 0 # mirror # 1 0\n4 -102 2 3");
        assert_eq!(
            fixed(&before),
            before.clone() + "\n4 -701 1 0 0\n4 -201 0 1 0"
        );
    }

    #[test]
    fn no_fix_that_is_in_doubt() {
        for records in [
            // The first one sets the colour only, the second one the optical property.
            "2 -701 1 0 0\n3 -201 0 1 0\n4 -102 2 3",
            // The property has become another one since.
            "2 -299 0 8\n8 -203 2 2 2\n4 -102 2 3",
        ] {
            assert!(fixes(&scene(records)).is_empty(), "{records}");
        }
    }
}
