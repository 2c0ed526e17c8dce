//! The nearest crossing of a ray with anything. If the ray starts outside of every solid, that crossing is a boundary
//! of the scene; else no boundary is nearer.

use super::context::Leaf;
use super::events::{Crossing, RayPoint};
use super::query::{PendingNode, Search};
use super::walk::Walker;
use crate::geometry::array::each;
use crate::geometry::wide_bvh::{Child, Is, WIDTH};
use crate::trace::graph::{Group, Holds, Operation, Target};
use crate::trace::precision::Precision;
use crate::trace::ray::Ray;
use crate::trace::shapes::Root;
use std::cmp::Ordering;

/// The nearest crossing that is known. `limit` is the t up to which the search goes on, a little beyond that crossing:
/// crossings that cannot be told from it are met too.
struct Best<R> {
    found: Option<Crossing<R>>,
    limit: R,
    /// A t far behind the start of the ray: crossings before it cannot be taken for the start.
    start: f64,
}

impl<R: Precision> Best<R> {
    /// The state of a search in (from, to] before it has found a crossing.
    #[inline]
    fn new(ray: &Ray<R>, from: R, to: R) -> Best<R> {
        // A crossing within this distance of the start might not be told from the surface that the ray has left.
        let near = ray.left.map_or(0.0, |left| {
            let farthest = left.skin / R::ROUNDOFF.sqrt();
            (farthest / ray.line.direction.length()).to_f64()
        });
        Best {
            found: None,
            limit: to,
            start: from.to_f64() - 1.5 * near,
        }
    }
}

impl<'g, R: Precision> Walker<'g, R> {
    /// The first crossing with a part's surface in (from, to]. The search looks into unions; of an intersection only
    /// its own boundary counts. Among crossings at the same t, one with a sheet wins, then that of the first operand. A
    /// search for any crossing takes the first one found. If it knows only that the ray goes through a solid, it places
    /// the crossing at `to`.
    pub fn nearest(
        &mut self,
        ray: &Ray<R>,
        (from, to): (R, R),
        search: Search,
    ) -> Option<Crossing<R>> {
        self.begin(ray);
        self.search = search;
        let mut best = Best::new(ray, from, to);
        self.entries.clear();
        self.open_union(0, from);
        self.exhaust(ray, from, &mut best);
        best.found
    }

    /// Visits the entries of the stack, until nothing is left or a search for any crossing has found one.
    fn exhaust(&mut self, ray: &Ray<R>, from: R, best: &mut Best<R>) {
        let mut next = None;
        loop {
            if self.search != Search::First && best.found.is_some() {
                return;
            }
            let Some(entry) = next.take().or_else(|| self.entries.pop()) else {
                return;
            };
            if entry.near > best.limit.to_f64() {
                continue;
            }
            match entry.child.is() {
                Is::Node(node) => next = self.visit(entry.context, node, from, best),
                Is::Item(part) => {
                    let leaf = Leaf {
                        part,
                        context: entry.context,
                    };
                    if !self.meet(ray, leaf, from, best) {
                        return;
                    }
                }
            }
        }
    }

    /// Puts the root of a union's tree on the stack, and the union's parts without bounds.
    fn open_union(&mut self, context: u32, from: R) {
        let Some(group) = self.searched(context) else {
            return;
        };
        let near = from.to_f64();
        let entry = |child| PendingNode {
            near,
            context,
            child,
        };
        if !group.tree.nodes.is_empty() {
            self.entries.push(entry(Child::ROOT));
        }
        self.open_loose(group, context, from);
    }

    /// Puts the parts of a union that have no bounds on the stack.
    fn open_loose(&mut self, group: &Group, context: u32, from: R) {
        let near = from.to_f64();
        self.entries
            .extend(group.loose.iter().map(|&part| PendingNode {
                near,
                context,
                child: Child::item(part),
            }));
    }

    /// The parts of a context's union that may hold the crossing that the search wants; `None` if there are none.
    fn searched(&self, context: u32) -> Option<&'g Group> {
        let here = &self.contexts[context as usize];
        let Operation::Union(whole) = &self.graph.objects[here.object as usize].operation else {
            return None;
        };
        match self.search {
            // A paint over the union decides for all its parts.
            _ if here.optics.is_some() => Some(whole),
            Search::AnyClear => whole.clear.as_deref(),
            Search::AnyOpaque => whole.opaque.as_deref().or(Some(whole)),
            Search::First | Search::Any => Some(whole),
        }
    }

    /// The sorts of media that a part holds, with the paint over its context's object.
    fn holds(&self, leaf: Leaf) -> Holds {
        match self.contexts[leaf.context as usize].optics {
            Some(optics) => self.graph.made_of(optics),
            None => self.graph.holds(self.part(leaf.part)),
        }
    }

    /// Returns the nearest child of a node that the ray may meet, and puts the other children that it may meet on the
    /// stack, the farthest first.
    #[inline(always)]
    fn visit(&mut self, context: u32, node: u32, from: R, best: &Best<R>) -> Option<PendingNode> {
        let group = self.searched(context)?;
        let node = &group.tree.nodes[node as usize];
        self.counts.boxes += WIDTH as u64;
        let beam = &self.contexts[context as usize].beam;
        let ends = each([from.to_f64(), best.limit.to_f64()], |t| beam.pace(t));
        let entry = |near, child| PendingNode {
            near: beam.unpace(near),
            context,
            child,
        };
        let entries = &mut self.entries;
        let base = entries.len();
        let first = beam.first(node, ends, |near, child| {
            let entry = entry(near, child);
            let mut at = entries.len();
            entries.push(entry);
            while at > base && entries[at - 1].near < entry.near {
                entries[at] = entries[at - 1];
                at -= 1;
            }
            entries[at] = entry;
        });
        first.map(|(near, child)| entry(near, child))
    }

    /// Crosses a shape, or looks into an object. Returns `false` if the memory is used up.
    fn meet(&mut self, ray: &Ray<R>, leaf: Leaf, from: R, best: &mut Best<R>) -> bool {
        if self.search.is_picky() && !self.search.wants(self.holds(leaf)) {
            return true;
        }
        match self.part(leaf.part).target {
            Target::Object(object) => {
                let Some(context) = self.enter(leaf.context, leaf.part, object) else {
                    return false;
                };
                match &self.graph.objects[object as usize].operation {
                    Operation::Union(_) => self.open_union(context, from),
                    Operation::Intersection { .. } => {
                        if let Some(found) = self.first_of(ray, context, from, best.limit) {
                            self.consider(found, best);
                        }
                    }
                }
            }
            Target::Shape(primitive) => {
                let ahead = Some([best.start, best.limit.to_f64()]);
                let Some(behind) = self.cross(ray, leaf, primitive, from, ahead) else {
                    let root = Root {
                        t: best.limit,
                        face: 0,
                    };
                    best.found = Some(Crossing::at(leaf, root, R::ZERO));
                    return true;
                };
                if let Some(&root) = self.roots.list.get(behind)
                    && root.t <= best.limit
                {
                    if self.search != Search::First {
                        best.found = Some(Crossing::at(leaf, root, R::ZERO));
                        return true;
                    }
                    let error = self.rough(&self.line, primitive, root);
                    self.consider(Crossing::at(leaf, root, error), best);
                }
            }
        }
        true
    }

    /// Whether a leaf has an inside, so that a crossing with it is a boundary and not a sheet.
    pub(super) fn is_solid(&self, leaf: Leaf) -> bool {
        match self.part(leaf.part).target {
            Target::Shape(primitive) => self.graph.primitives[primitive as usize].is_solid(),
            Target::Object(_) => true,
        }
    }

    /// Takes a crossing within the limit if it is nearer than the best.
    fn consider(&mut self, found: Crossing<R>, best: &mut Best<R>) {
        let nearer = match &best.found {
            None => true,
            Some(old) => match self.order(&found.place, &old.place) {
                Ordering::Less => true,
                Ordering::Equal => {
                    let [new, old] = [found.place.leaf, old.place.leaf];
                    match (self.is_solid(new), self.is_solid(old)) {
                        (false, true) => true,
                        (true, false) => false,
                        _ => self.precedes(new, old),
                    }
                }
                Ordering::Greater => false,
            },
        };
        if nearer {
            let RayPoint { root, error, .. } = found.place;
            best.limit = best.limit.min(root.t + error + error);
            best.found = Some(found);
        }
    }
}
