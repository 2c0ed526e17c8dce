//! The nearest crossing with anything: all that is needed while a ray is outside of every solid,
//! since then the first boundary it meets is a boundary of the scene.

use super::context::Leaf;
use super::events::{Crossing, Place};
use super::query::{Entry, Item, Search};
use super::walk::Walker;
use crate::geometry::aabb::Aabb;
use crate::trace::graph::{Group, Holds, Operation, Target};
use crate::trace::precision::Precision;
use crate::trace::ray::Ray;
use std::cmp::Ordering;

/// The nearest crossing so far, and how far along the ray something as near may be found: crossings
/// that cannot be told from the nearest are met too.
struct Best<R> {
    found: Option<Crossing<R>>,
    limit: R,
}

impl<R: Precision> Walker<'_, R> {
    /// The first crossing with a part's surface in (from, to]. Parts that are unions are looked
    /// into; of intersections only their own boundary counts. Among crossings at the same t a sheet's
    /// wins, then the first operand's. A search for any crossing takes the first one found.
    pub fn nearest(&mut self, ray: &Ray<R>, from: R, to: R, search: Search) -> Option<Crossing<R>> {
        self.begin(ray);
        self.entries.clear();
        let mut best = Best {
            found: None,
            limit: to,
        };
        self.search = search;
        self.open_union(ray, 0, from, &mut best);
        while let Some(entry) = self.entries.pop() {
            if search != Search::First && best.found.is_some() {
                break;
            }
            if entry.near > best.limit.to_f64() {
                continue;
            }
            match entry.item {
                Item::Node(node) => self.visit(ray, entry, node, from, &mut best),
                Item::Part(part, object) => {
                    let Some(context) = self.enter(entry.context, part, object) else {
                        break;
                    };
                    match &self.graph.objects[object as usize].operation {
                        Operation::Union(_) => {
                            self.open_union(ray, context, from, &mut best);
                        }
                        Operation::Intersection { .. } => {
                            if let Some(found) = self.first_of(ray, context, from, best.limit) {
                                self.consider(found, &mut best);
                            }
                        }
                    }
                }
            }
        }
        best.found
    }

    /// Meets the parts of a union that have no bounds, and puts the rest on the stack.
    fn open_union(&mut self, ray: &Ray<R>, context: u32, from: R, best: &mut Best<R>) {
        let graph = self.graph;
        let object = self.contexts[context as usize].object;
        let Operation::Union(whole) = &graph.objects[object as usize].operation else {
            return;
        };
        let Some(group) = self.searched(context, whole) else {
            return;
        };
        for &part in &group.loose {
            self.meet(ray, Leaf { part, context }, from.to_f64(), from, best);
        }
        if let Some(root) = group.bvh.nodes.first() {
            self.counts.boxes += 1;
            if let Some((near, _)) = self.clip(context, &root.bounds, from, best) {
                self.entries.push(Entry {
                    near,
                    context,
                    item: Item::Node(0),
                });
            }
        }
    }

    /// The stretch of the ray in a box of a context's object, as far as it matters.
    #[inline]
    fn clip(&self, context: u32, bounds: &Aabb, from: R, best: &Best<R>) -> Option<(f64, f64)> {
        let here = &self.contexts[context as usize];
        bounds.clip(&here.beam, from.to_f64(), best.limit.to_f64())
    }

    /// The parts of a context's union among which is what is looked for.
    fn searched<'g>(&self, context: u32, whole: &'g Group) -> Option<&'g Group> {
        if self.search == Search::AnyClear && self.contexts[context as usize].optics.is_none() {
            return whole.clear.as_deref();
        }
        Some(whole)
    }

    /// What a part of a context's object holds, with what is painted over it.
    fn holds(&self, leaf: Leaf) -> Holds {
        match self.contexts[leaf.context as usize].optics {
            Some(optics) => self.graph.made_of(optics),
            None => self.graph.holds(self.part(leaf.part)),
        }
    }

    fn visit(&mut self, ray: &Ray<R>, entry: Entry, node: u32, from: R, best: &mut Best<R>) {
        let graph = self.graph;
        let context = entry.context;
        let object = self.contexts[context as usize].object;
        let Operation::Union(whole) = &graph.objects[object as usize].operation else {
            return;
        };
        let Some(group) = self.searched(context, whole) else {
            return;
        };
        let bvh = &group.bvh;
        let here = &bvh.nodes[node as usize];
        if here.count > 0 {
            let items = here.index as usize..(here.index + here.count) as usize;
            for &part in &bvh.items[items] {
                self.meet(ray, Leaf { part, context }, entry.near, from, best);
            }
            return;
        }
        self.counts.boxes += 2;
        let [left, right] = [node + 1, here.index].map(|child| {
            let bounds = &bvh.nodes[child as usize].bounds;
            let (near, _) = self.clip(context, bounds, from, best)?;
            Some(Entry {
                near,
                context,
                item: Item::Node(child),
            })
        });
        match (left, right) {
            (Some(a), Some(b)) if b.near < a.near => self.entries.extend([a, b]),
            (a, b) => self.entries.extend(b.into_iter().chain(a)),
        }
    }

    /// A shape is crossed at once, an object put on the stack.
    fn meet(&mut self, ray: &Ray<R>, leaf: Leaf, near: f64, from: R, best: &mut Best<R>) {
        if self.search.is_picky() && !self.search.wants(self.holds(leaf)) {
            return;
        }
        match self.part(leaf.part).target {
            Target::Object(object) => self.entries.push(Entry {
                near,
                context: leaf.context,
                item: Item::Part(leaf.part, object),
            }),
            Target::Shape(primitive) => {
                let behind = self.cross(ray, leaf, primitive, from);
                if let Some(&root) = self.roots.list.get(behind)
                    && root.t <= best.limit
                {
                    let error = self.rough(&self.line, primitive, root);
                    let found = Crossing {
                        place: Place { leaf, root, error },
                        owner: leaf,
                    };
                    self.consider(found, best);
                }
            }
        }
    }

    /// Whether a crossing with a shape is one of its boundary.
    fn is_solid(&self, leaf: Leaf) -> bool {
        match self.part(leaf.part).target {
            Target::Shape(primitive) => {
                self.graph.primitives[primitive as usize].shape().is_solid()
            }
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
            let Place { root, error, .. } = found.place;
            best.limit = best.limit.min(root.t + error + error);
            best.found = Some(found);
        }
    }
}
