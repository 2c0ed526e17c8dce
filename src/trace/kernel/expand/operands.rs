//! The operands of intersections and differences.

use super::{Above, Leaves, moved};
use crate::geometry::aabb::Aabb;
use crate::trace::graph::{Graph, Object, Operation, Target};
use crate::trace::kernel::leaf::{Kind, Leaf};
use std::ops::Range;

/// An operation within an intersection: the points that are in all of its first operands and in none of its cuts. A
/// union has only cuts, and `is_union`: it is the complement of the points that are in none of them.
#[derive(Debug, Clone, Copy)]
pub struct Gate {
    /// The gate that has this gate as an operand; its index is smaller. The gate of the whole is its own parent.
    pub parent: u32,
    /// Whether this gate is a cut of its parent.
    pub is_cut: bool,
    pub is_union: bool,
}

/// The operands of an intersection.
#[derive(Debug)]
pub struct Operands {
    /// A box around the whole, in the space of the intersection.
    pub bounds: Aabb,
    /// All gates; the gate of the whole comes first.
    pub gates: Vec<Gate>,
    /// Shapes that are first operands of the whole: they contain it.
    pub firsts: Vec<u32>,
    /// Other shapes without bounds.
    pub loose: Vec<u32>,
    /// The other shapes, with their boxes in the space of the intersection.
    pub boxes: Vec<(u32, Aabb)>,
}

impl Operands {
    pub fn all(&self) -> impl Iterator<Item = u32> {
        let boxes = self.boxes.iter().map(|(leaf, _)| leaf);
        self.firsts.iter().chain(&self.loose).chain(boxes).copied()
    }
}

/// The greatest depth of operations in an intersection. Deeper ones are left to the arbiter, which skips level by level
/// what a ray misses: a scene of forty lines may have 2⁴⁰ operands.
const MAX_GATE_DEPTH: u32 = 4;
/// The most operations within one intersection. More are left to the arbiter, too: each merge copies the counts of all
/// gates.
const MAX_GATES: usize = 1000;

impl Leaves {
    /// Adds an intersection or a difference of solids, and returns the number of its leaf; `None` if the kernel cannot
    /// draw it.
    pub(super) fn csg(&mut self, graph: &Graph, object: &Object, above: &Above) -> Option<u32> {
        let operands = self.operands(graph, object, above)?;
        let number = self.all.len() as u32;
        let first = match &object.operation {
            Operation::Intersection { first, .. } => foremost(graph, first.clone(), above),
            Operation::Union(_) => None,
        };
        // The inside of the whole is one medium: the medium of its foremost shape.
        let is_foremost = |&leaf: &u32| {
            first
                .as_ref()
                .is_some_and(|a| a.path == self.paths[leaf as usize])
        };
        let foremost = operands.all().find(is_foremost);
        let whole = self.all[foremost.or(operands.all().next())? as usize].clone();
        let has_unions = operands.gates.iter().any(|gate| gate.is_union);
        let is_medium = foremost.is_some() && whole.is_clear && !has_unions;
        for leaf in operands.all() {
            let leaf = &mut self.all[leaf as usize];
            let is_known = !leaf.is_clear && !whole.is_clear
                || is_medium && (leaf.look.ways == whole.look.ways || !leaf.is_clear);
            if !(leaf.is_solid && is_known) {
                return None;
            }
            leaf.solid = number;
        }
        let chain = self.chain(&above.chain);
        self.paths.push(above.path.clone());
        self.all.push(Leaf {
            kind: Kind::Csg,
            primitive: self.operands.len() as u32,
            chain,
            placement: 0,
            solid: number,
            twin: number,
            is_convex: false,
            ..whole
        });
        self.operands.push(operands);
        Some(number)
    }

    /// Adds the shapes that an intersection or a difference is made of; `None` if the kernel cannot draw them.
    fn operands(&mut self, graph: &Graph, object: &Object, above: &Above) -> Option<Operands> {
        let mut operands = Operands {
            bounds: object.bounds,
            gates: vec![Gate {
                parent: 0,
                is_cut: false,
                is_union: false,
            }],
            firsts: Vec::new(),
            loose: Vec::new(),
            boxes: Vec::new(),
        };
        let outer = above.chain.len();
        // Each entry: an object, the index and the depth of its gate, what is above it, and the looks that its shapes
        // take instead of their own.
        let mut pending = vec![(object, [0, 0], above.clone(), None)];
        while let Some((object, [gate, depth], above, looks)) = pending.pop() {
            let (firsts, cuts, cut_looks) = match &object.operation {
                Operation::Union(all) => (0..0, all, looks.clone()),
                Operation::Intersection {
                    first,
                    cuts,
                    inherit,
                } => {
                    let inherited = match (&looks, inherit) {
                        (None, true) => Some(foremost(graph, first.clone(), &above)?),
                        _ => looks.clone(),
                    };
                    (first.clone(), cuts, inherited)
                }
            };
            let bounds = cuts.tree.boxes(&object.frame);
            let bounds = bounds.map(|(part, bounds)| (part, Some(bounds), true));
            let loose = cuts.loose.iter().map(|&part| (part, None, true));
            let firsts = firsts.map(|part| (part, None, false));
            for (number, bounds, is_cut) in firsts.chain(loose).chain(bounds) {
                let looks = if is_cut { &cut_looks } else { &looks };
                let part = &graph.parts[number as usize];
                let own = above.and(graph, number);
                let shape = match part.target {
                    Target::Shape(primitive) => graph.primitives[primitive as usize].shape(),
                    Target::Object(object) => {
                        let object = &graph.objects[object as usize];
                        let inner = operands.gates.len() as u32;
                        if depth == MAX_GATE_DEPTH || operands.gates.len() == MAX_GATES {
                            return None;
                        }
                        operands.gates.push(Gate {
                            parent: gate,
                            is_cut,
                            is_union: matches!(object.operation, Operation::Union(_)),
                        });
                        pending.push((object, [inner, depth + 1], own, looks.clone()));
                        continue;
                    }
                };
                let is_cut = is_cut != part.inverted;
                let leaf = self.leaf(graph, number, &own, looks.as_ref())?;
                (self.all[leaf as usize].gate, self.all[leaf as usize].is_cut) = (gate, is_cut);
                let bounds = match bounds {
                    Some(bounds) if gate == 0 => bounds,
                    _ => moved(graph, &shape.bounds(), &own.chain[outer..]),
                };
                match bounds.is_bounded() {
                    _ if gate == 0 && !is_cut => operands.firsts.push(leaf),
                    true => operands.boxes.push((leaf, bounds)),
                    false => operands.loose.push(leaf),
                }
            }
        }
        Some(operands)
    }
}

/// The way down to the shape that owns the points in all of these parts: the first shape of the first part. `None` if
/// several shapes own points there and do not all look alike.
fn foremost(graph: &Graph, parts: Range<u32>, above: &Above) -> Option<Above> {
    let mut pending = vec![above.and(graph, parts.clone().next()?)];
    let (mut found, mut count): (Option<Above>, usize) = (None, 0);
    while let Some(above) = pending.pop() {
        count += 1;
        let target = above
            .path
            .last()
            .map(|&part| graph.parts[part as usize].target)?;
        let Target::Object(object) = target else {
            let is_like = |other: &Above| other.look() == above.look();
            if !found.as_ref().is_none_or(is_like) || count > MAX_GATES {
                return None;
            }
            found = Some(above);
            continue;
        };
        match &graph.objects[object as usize].operation {
            Operation::Intersection { first, .. } => {
                pending.push(above.and(graph, first.clone().next()?));
            }
            Operation::Union(all) => {
                pending.extend(all.parts().map(|part| above.and(graph, part)));
            }
        }
    }
    found
}
