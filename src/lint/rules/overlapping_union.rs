//! W307: parts of a union that overlap and are of different media.
//!
//! Opaque solids that overlap are everyday modelling, and the picture does not depend on it: all
//! that can be seen of each is what lies outside of the other. It does where light gets in: what
//! both hold belongs to the first operand, and the second one's surface is not seen in there.

use std::collections::{HashMap, HashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::solids::inside::Inside;
use crate::lint::solids::{Named, named, near, operation_of, roots};
use crate::lint::{Context, live_nodes};
use crate::scene::bounds::{NodeBounds, node_bounds};
use crate::scene::record::Params;
use crate::scene::{
    Aabb, DEFAULT_INDEX, Matrix, Node, NodeId, OperationRecord, Optics, Rgb, Scene, Vec3,
};
use crate::syntax::Item;
use crate::trace::bounds::Bounds;
use crate::trace::bvh::Bvh;
use crate::trace::vec;

/// Nodes gone through more often than once, in scenes that share parts.
const REPEATED: usize = 200_000;

/// Boxes looked at and steps up the unions, for all parts together: some hundredths of a second.
const STEPS: usize = 10_000_000;

/// Points tried for a pair of parts whose boxes overlap.
const POINTS: u32 = 24;

/// How far inside of both parts a point must be, as a share of the smaller one: what overlaps by less
/// is meant to touch, and written with six or seven digits.
const DEPTH: f64 = 1e-6;

const NONE: u32 = u32::MAX;

/// What light notices of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Medium {
    optics: Optics,
    index: Rgb,
}

impl Medium {
    fn transmits(&self) -> bool {
        self.optics.kt.iter().any(|&k| k > 0.0)
    }

    fn bits(&self) -> [u64; 12] {
        let all = [self.optics.kd, self.optics.ks, self.optics.kt, self.index];
        // Zeros of both signs are one number.
        std::array::from_fn(|i| (all[i / 3][i % 3] + 0.0).to_bits())
    }
}

/// What was given to the whole, which overrides what its parts have.
#[derive(Debug, Clone, Copy, Default)]
struct Coat {
    optics: Option<Optics>,
    index: Option<Rgb>,
}

impl Coat {
    fn over(self, scene: &Scene, paint: u32) -> Coat {
        let paint = &scene.paints[paint as usize];
        Coat {
            optics: self.optics.or(paint.optics),
            index: self.index.or(paint.index),
        }
    }

    fn medium(self) -> Medium {
        Medium {
            optics: self.optics.unwrap_or_default(),
            index: self.index.unwrap_or(DEFAULT_INDEX),
        }
    }
}

/// A union where it occurs.
struct Place {
    node: NodeId,
    parent: u32,
    depth: u32,
    /// The topmost union of unions that this is part of.
    top: u32,
    /// The top of a way down along the larger operands.
    head: u32,
}

/// A part of a union that is none itself.
struct Part {
    node: NodeId,
    named: Named,
    /// From its own coordinates into those of the root.
    matrix: Matrix,
    bounds: Aabb,
    medium: u32,
    union: u32,
    /// What it is part of altogether, where an intersection or a difference may cut something off.
    cut: Option<NodeId>,
}

struct Task {
    node: NodeId,
    matrix: Matrix,
    coat: Coat,
    copy: Option<u32>,
    union: u32,
    root: NodeId,
    cut: bool,
}

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let glass = |o: &Optics| o.kt.iter().any(|&k| k > 0.0);
    if !(scene.paints.iter().filter_map(|p| p.optics.as_ref())).any(glass)
        || !scene.nodes.iter().any(|n| matches!(n, Node::Union(..)))
    {
        return;
    }
    let bounds = node_bounds(scene);
    let roots = roots(scene, &live_nodes(scene));
    let unions = Unions::new(scene, &bounds, &roots);
    let mut fresh = largest_id(context);
    let mut search = Search {
        scene,
        unions: &unions,
        inside: Inside::new(scene, &bounds),
        left: STEPS,
        done: HashSet::new(),
    };
    for found in search.all() {
        if let Some(record) = operation_of(scene, found.union)
            && let Some(p) = context.params(record.span)
        {
            out.push(finding(&unions, &p, record, &found, &mut fresh));
        }
    }
}

struct Unions {
    places: Vec<Place>,
    /// In the order of their operands.
    parts: Vec<Part>,
    media: Vec<Medium>,
}

impl Unions {
    /// Everything that is a part of a union and whose properties show.
    fn new(scene: &Scene, bounds: &[NodeBounds], roots: &[NodeId]) -> Unions {
        let mut all = Unions {
            places: Vec::new(),
            parts: Vec::new(),
            media: Vec::new(),
        };
        let mut known: HashMap<[u64; 12], u32> = HashMap::new();
        let start = |&node: &NodeId| Task {
            node,
            matrix: Matrix::IDENTITY,
            coat: Coat::default(),
            copy: None,
            union: NONE,
            root: node,
            cut: false,
        };
        let mut todo: Vec<Task> = roots.iter().rev().map(start).collect();
        let mut left = scene.nodes.len() + REPEATED;
        while let Some(mut task) = todo.pop() {
            match left.checked_sub(1) {
                Some(l) => left = l,
                None => break,
            }
            match scene.nodes[task.node as usize] {
                Node::Transform { child, matrix } => {
                    task.matrix = task.matrix.after(&scene.matrices[matrix as usize]);
                    todo.push(Task {
                        node: child,
                        ..task
                    });
                }
                Node::Paint { child, paint } => {
                    task.coat = task.coat.over(scene, paint);
                    todo.push(Task {
                        node: child,
                        ..task
                    });
                }
                Node::Copy { child, id } => {
                    task.copy = task.copy.or(Some(id));
                    todo.push(Task {
                        node: child,
                        ..task
                    });
                }
                Node::Union(a, b) => {
                    let union = all.places.len() as u32;
                    let above = all.places.get(task.union as usize);
                    let (depth, top) = above.map_or((0, union), |p| (p.depth + 1, p.top));
                    all.places.push(Place {
                        node: task.node,
                        parent: task.union,
                        depth,
                        top,
                        head: union,
                    });
                    for node in [b, a] {
                        let copy = None;
                        todo.push(Task {
                            node,
                            union,
                            copy,
                            ..task
                        });
                    }
                }
                Node::Shape(s) => {
                    if scene.shapes[s as usize].geometry.is_solid() {
                        all.part(scene, bounds, &task, &mut known);
                    }
                }
                Node::Intersection(first, _) | Node::Difference(first, _) => {
                    all.part(scene, bounds, &task, &mut known);
                    // What is within is of the first operand.
                    todo.push(Task {
                        node: first,
                        copy: None,
                        union: NONE,
                        cut: true,
                        ..task
                    });
                }
                // What its inside is made of is not to be told.
                Node::Complement(_) => {}
            }
        }
        all.find_heads();
        all
    }

    /// Chains of unions are as deep as they are long: ways along the larger operands are gone at once.
    fn find_heads(&mut self) {
        let count = self.places.len();
        let mut weights = vec![1u32; count];
        let mut larger = vec![NONE; count];
        // Parents stand before their children.
        for i in (0..count).rev() {
            let parent = self.places[i].parent as usize;
            if let Some(other) = larger.get_mut(parent) {
                if *other == NONE || weights[*other as usize] < weights[i] {
                    *other = i as u32;
                }
                weights[parent] += weights[i];
            }
        }
        for i in 0..count {
            let parent = self.places[i].parent;
            if parent != NONE && larger[parent as usize] == i as u32 {
                self.places[i].head = self.places[parent as usize].head;
            }
        }
    }

    fn part(
        &mut self,
        scene: &Scene,
        bounds: &[NodeBounds],
        task: &Task,
        known: &mut HashMap<[u64; 12], u32>,
    ) {
        if task.union == NONE {
            return;
        }
        let (Some(mut named), Some(medium)) =
            (named(scene, task.node), medium(scene, task.node, task.coat))
        else {
            return;
        };
        named.id = task.copy.unwrap_or(named.id);
        let media = &mut self.media;
        let medium = *known.entry(medium.bits()).or_insert_with(|| {
            media.push(medium);
            media.len() as u32 - 1
        });
        let own = bounds[task.node as usize].all;
        let bounds = match scene.nodes[task.node as usize] {
            // Closer than its own box would come, moved.
            Node::Shape(s) => {
                crate::scene::bounds::shape_bounds(&scene.shapes[s as usize].geometry, &task.matrix)
            }
            _ => own.transformed(&task.matrix),
        };
        if !bounds.is_empty() {
            self.parts.push(Part {
                node: task.node,
                named,
                matrix: task.matrix,
                bounds,
                medium,
                union: task.union,
                cut: task.cut.then_some(task.root),
            });
        }
    }
}

/// The medium of what is within a node; `None` where it has several or that is not known.
fn medium(scene: &Scene, mut node: NodeId, mut coat: Coat) -> Option<Medium> {
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

/// Two parts that overlap.
struct Found {
    /// The union of both.
    union: NodeId,
    /// Indices of the parts, in the order of the operands.
    parts: [u32; 2],
    /// A point of both, in the coordinates of the scene.
    witness: Vec3,
}

struct Search<'a> {
    scene: &'a Scene,
    unions: &'a Unions,
    inside: Inside<'a>,
    left: usize,
    /// Unions that have been spoken of.
    done: HashSet<NodeId>,
}

impl Search<'_> {
    fn all(&mut self) -> Vec<Found> {
        let unions = self.unions;
        let transmits = |p: &Part| unions.media[p.medium as usize].transmits();
        if unions.media.len() < 2 || !unions.parts.iter().any(transmits) {
            return Vec::new();
        }
        let (mut finite, mut endless) = (Vec::new(), Vec::new());
        for (i, part) in unions.parts.iter().enumerate() {
            match part.bounds.is_finite() {
                true => {
                    let (min, max) = (vec::Vec3(part.bounds.min), vec::Vec3(part.bounds.max));
                    finite.push((i as u32, Bounds::new(min, max)));
                }
                false => endless.push(i as u32),
            }
        }
        let tree = Bvh::new(finite);
        let mut found = Vec::new();
        for (i, part) in unions.parts.iter().enumerate() {
            let i = i as u32;
            let near = match part.bounds.is_finite() {
                true => self.near(&tree, &part.bounds, &endless),
                // Two without end: no place to look at.
                false if transmits(part) => self.near(&tree, &part.bounds, &[]),
                false => Some(Vec::new()),
            };
            let Some(near) = near else { break };
            for j in near {
                let other = &unions.parts[j as usize];
                // Each pair once.
                let turn = match (transmits(part), transmits(other)) {
                    (true, true) => i < j || !other.bounds.is_finite(),
                    (one, _) => one,
                };
                if !turn || part.medium == other.medium {
                    continue;
                }
                let Some(left) = self.left.checked_sub(POINTS as usize) else {
                    return found;
                };
                self.left = left;
                found.extend(self.pair([i.min(j), i.max(j)]));
            }
        }
        found
    }

    /// Parts whose boxes overlap a box; `None` when no steps are left.
    fn near(&mut self, tree: &Bvh, b: &Aabb, endless: &[u32]) -> Option<Vec<u32>> {
        let mut near = Vec::new();
        let mut steps = 1 + endless.len();
        let mut todo: Vec<u32> = (!tree.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(i) = todo.pop() {
            let node = &tree.nodes[i as usize];
            steps += 1;
            let apart = |k: usize| b.max[k] < node.bounds.min[k] || node.bounds.max[k] < b.min[k];
            if (0..3).any(apart) {
                continue;
            }
            match node.count {
                0 => todo.extend([node.index, i + 1]),
                n => {
                    let items = node.index as usize..(node.index + n) as usize;
                    near.extend_from_slice(&tree.items[items]);
                }
            }
        }
        near.extend_from_slice(endless);
        near.retain(|&j| self.unions.parts[j as usize].bounds.overlaps(b));
        self.left = self.left.checked_sub(steps)?;
        Some(near)
    }

    fn pair(&mut self, pair: [u32; 2]) -> Option<Found> {
        let parts = pair.map(|i| &self.unions.parts[i as usize]);
        let union = self.union(parts)?;
        if self.done.contains(&union) {
            return None;
        }
        let both = parts[0].bounds.intersection(&parts[1].bounds);
        let longest = |b: &Aabb| (0..3).fold(0.0f64, |m, i| m.max(b.max[i] - b.min[i]));
        let depth = DEPTH * longest(&parts[0].bounds).min(longest(&parts[1].bounds));
        if !both.is_finite() || (0..3).any(|i| both.max[i] - both.min[i] <= depth) {
            return None;
        }
        let [Some(a), Some(b)] = parts.map(|p| p.matrix.inverse()) else {
            return None;
        };
        for k in 0..POINTS {
            // Multiples of the powers of the root of x⁴ = x + 1, modulo 1: spread evenly, the
            // middle first.
            const STEP: [f64; 3] = [
                0.819_172_513_396_164_4,
                0.671_043_606_703_789_2,
                0.549_700_477_901_970_5,
            ];
            let p: Vec3 = std::array::from_fn(|i| {
                let share = (0.5 + f64::from(k) * STEP[i]).fract();
                both.min[i] + share * (both.max[i] - both.min[i])
            });
            if self.deep([(parts[0], &a), (parts[1], &b)], p, depth) {
                self.done.insert(union);
                let parts = pair;
                let witness = p;
                return Some(Found {
                    union,
                    parts,
                    witness,
                });
            }
        }
        None
    }

    /// Whether a point, and what is around it, is in both parts, and is drawn.
    fn deep(&mut self, parts: [(&Part, &Matrix); 2], p: Vec3, depth: f64) -> bool {
        let clip = self.scene.render.and_then(|r| r.clip);
        for k in 0..7 {
            let mut q = p;
            if k > 0 {
                let i = (k - 1) / 2;
                q[i] += if k % 2 == 0 { depth } else { -depth };
            }
            if clip.is_some_and(|(min, max)| !Aabb::new(min, max).contains(q)) {
                return false;
            }
            for (part, back) in parts {
                if self.inside.node(part.node, back.point(q)) != Some(true) {
                    return false;
                }
            }
            if let Some(root) = parts[0].0.cut
                && self.inside.node(root, q) != Some(true)
            {
                return false;
            }
        }
        true
    }

    /// The union that joins two parts, if there is one.
    fn union(&mut self, parts: [&Part; 2]) -> Option<NodeId> {
        let place = |i: u32| &self.unions.places[i as usize];
        let [mut a, mut b] = parts.map(|p| p.union);
        if place(a).top != place(b).top {
            return None;
        }
        while place(a).head != place(b).head {
            self.left = self.left.checked_sub(1)?;
            if place(place(a).head).depth < place(place(b).head).depth {
                std::mem::swap(&mut a, &mut b);
            }
            a = place(place(a).head).parent;
        }
        let upper = if place(a).depth < place(b).depth {
            a
        } else {
            b
        };
        Some(place(upper).node)
    }
}

fn finding(
    unions: &Unions,
    p: &Params,
    record: &OperationRecord,
    found: &Found,
    fresh: &mut u32,
) -> Diagnostic {
    let [one, two] = found.parts.map(|i| &unions.parts[i as usize]);
    let size = (0..3).fold(f64::INFINITY, |m, i| {
        let both = one.bounds.intersection(&two.bounds);
        m.min(both.max[i] - both.min[i])
    });
    let [x, y, z] = found.witness.map(|x| near(x, size));
    let d = Diagnostic::new(Code::W307, p.span_of(0, 2))
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.named.title))
        .with("one-id", one.named.id.to_string())
        .with("two", Value::Term(two.named.title))
        .with("two-id", two.named.id.to_string())
        .with("x", x)
        .with("y", y)
        .with("z", z)
        .label(one.named.span, "first")
        .label(two.named.span, "second");
    match split(p, fresh) {
        Some(fix) => d.fix(fix),
        None => d,
    }
}

/// The largest ID of the file.
fn largest_id(context: &Context) -> u32 {
    let ids = context.document.items.iter().map(|item| match item {
        Item::Record(r) => r.id,
        Item::Broken(b) => b.id.unwrap_or(0),
        Item::Void { .. } => 0,
    });
    ids.max().unwrap_or(0)
}

/// The largest ID that the language knows.
const ID_MAX: u32 = i32::MAX as u32;

/// A ∪ B as (A − B) ∪ (B − A) ∪ (A ∩ B): the pieces come first, the record keeps its place and its
/// comments.
fn split(p: &Params, fresh: &mut u32) -> Option<Fix> {
    let first = fresh.checked_add(1).filter(|f| *f <= ID_MAX - 3)?;
    let (a, b) = (p.text_of(0), p.text_of(1));
    let ids: [u32; 4] = std::array::from_fn(|i| first + i as u32);
    *fresh = ids[3];
    let [only_a, only_b, both, either] = ids;
    let at = crate::diagnostics::Span::new(p.id_span.start, p.id_span.start);
    let edit = |span, text| Edit { span, text };
    Some(Fix {
        title: "fix",
        applicability: Applicability::Unsafe,
        edits: vec![
            edit(
                at,
                format!(
                    "{only_a} -103 {a} {b}\n{only_b} -103 {b} {a}\n{both} -102 {a} {b}\n{either} -101 {only_a} {only_b}\n"
                ),
            ),
            edit(p.span_of(0, 1), either.to_string()),
            edit(p.span_of(1, 1), both.to_string()),
        ],
    })
}

#[cfg(test)]
mod tests {
    use crate::diagnostics::Applicability;
    use crate::lint::testing::{self, fixed, fixes, messages};

    /// What this rule finds.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W307")).collect()
    }

    /// Water in a glass; the two spheres overlap by 0.5.
    fn two(first: &str, second: &str) -> String {
        format!(
            "2 11 0 0 0 1\n2 {first}\n3 11 1.5 0 0 1\n3 {second}\n4 -101 2 3 # both #\n1 9999 4 0\n"
        )
    }

    const GLASS: &str = "-201 0 0 1";
    const MATT: &str = "-201 0.5 0 0";

    #[test]
    fn glass_with_something_else() {
        let scene = two(GLASS, MATT);
        assert_eq!(found(&scene), ["W307 5:8"]);
        assert_eq!(
            messages(&scene),
            [
                "in the union 4, the sphere 2 and the sphere 3 overlap, and they are of different media: (0.75, 0, 0) is in both"
            ]
        );
        assert_eq!(found(&two(MATT, GLASS)).len(), 1);
        assert_eq!(found(&two(GLASS, "-201 0 0.1 0.9")).len(), 1);
        // Opaque, of one medium, or apart.
        assert!(found(&two(MATT, "-201 0.9 0 0")).is_empty());
        assert!(found(&two(GLASS, "-201 0 0 1.0")).is_empty());
        assert!(found(&two(GLASS, "-1 0.5 0 0")).is_empty());
        assert!(found(&two(GLASS, "-1 0.49999999 0 0")).is_empty());
        assert_eq!(found(&two(GLASS, "-1 0.49 0 0")).len(), 1);
    }

    #[test]
    fn the_fix_keeps_the_comment() {
        let scene = two(GLASS, MATT);
        let after = fixed(&scene);
        assert!(
            after.contains(
                "\n5 -103 2 3\n6 -103 3 2\n7 -102 2 3\n8 -101 5 6\n4 -101 8 7 # both #\n"
            )
        );
        assert_eq!(fixes(&scene)[0].1, Applicability::Unsafe);
        assert!(!found(&after).iter().any(|f| f.starts_with("W307")));
    }

    #[test]
    fn properties_of_the_whole_and_parts_of_parts() {
        // Painted over.
        let over = two(GLASS, MATT).replace("1 9999", "4 -201 0 0 1\n1 9999");
        assert!(found(&over).is_empty());
        // Parts of different unions, one of them moved.
        let nested = "2 9 1\n2 -201 0 0 1\n3 11 9 0 0 1\n4 -101 2 3\n5 9 1\n6 11 9 9 0 1\n7 -101 6 5\n\
            7 -1 0.5 0 0\n8 -101 4 7\n1 9999 8 0\n";
        assert_eq!(found(nested), ["W307 9:8"]);
        // Cut off.
        let cut =
            two(GLASS, MATT).replace("1 9999 4 0", "5 12 -2 -2 -2 0 2 2\n6 -102 4 5\n1 9999 6 0");
        assert!(found(&cut).is_empty());
        let left = two(GLASS, MATT).replace(
            "1 9999 4 0",
            "5 12 -2 -2 -2 2 0.5 2\n6 -102 4 5\n1 9999 6 0",
        );
        assert_eq!(found(&left), ["W307 5:8"]);
        // A tool's parts have no properties.
        let tool =
            two(GLASS, MATT).replace("1 9999 4 0", "5 12 -2 -2 -2 2 2 2\n6 -103 5 4\n1 9999 6 0");
        assert!(found(&tool).is_empty());
        // Not drawn.
        let boxed = two(GLASS, MATT).replace("9999 4 0", "9999 4 0 -9 -9 -9 0 9 9");
        assert!(found(&boxed).is_empty());
    }

    #[test]
    fn a_stone_in_the_glass() {
        let stone = "2 9 2\n2 -201 0 0 1\n3 9 0.5\n4 -101 3 2\n1 9999 4 0\n";
        assert_eq!(found(stone), ["W307 4:8"]);
        // In a hollow made for it.
        let hollow = "2 9 2\n2 -201 0 0 1\n3 9 0.5\n5 -103 2 3\n4 -101 3 5\n1 9999 4 0\n";
        assert!(found(hollow).is_empty());
        // In water that has no end.
        let water = "2 4 0 1 0 0\n2 -201 0 0 1\n3 9 0.5\n4 -101 3 2\n1 9999 4 0\n";
        assert_eq!(found(water), ["W307 4:8"]);
    }

    /// Pairs of balls, all in one chain of unions: each pair is found at the union that joins it,
    /// however deep that lies.
    #[test]
    fn chains_of_unions() {
        const PAIRS: usize = 5000;
        let mut scene = String::from("2 -201 0 0 1\n");
        let mut expected = Vec::new();
        let mut chain = 0;
        for i in 0..PAIRS {
            let (one, two) = (10 + 4 * i, 11 + 4 * i);
            scene += &format!("{one} 11 {} 0 0 1\n{one} -299 0 2\n", 4 * i);
            scene += &format!("{two} 11 {} 0 0 1\n", 4 * i + 1);
            for ball in [one, two] {
                if chain > 0 {
                    scene += &format!("{} -101 {chain} {ball}\n", ball + 2);
                    chain = ball + 2;
                } else {
                    chain = ball;
                }
            }
            let line = scene.lines().count();
            expected.push(format!(
                "W307 {line}:{}",
                format!("{chain} -101 ").len() + 1
            ));
        }
        scene += &format!("1 9999 {chain} 0\n");
        assert_eq!(found(&scene), expected);
    }
}
