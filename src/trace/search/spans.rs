//! Spans: the stretches of a ray on which an object is, and the part that owns each stretch (Roth, "Ray Casting for
//! Modeling Solids", 1982). They are kept as sorted events, each with the state after it.

use super::context::Leaf;
use super::events::RayPoint;
use super::events::{Crossing, Event, Kind, List, Medium, Owner, State, Task};
use super::merge::{Until, join_intersection, join_union, merge_union};
use super::walk::Walker;
use crate::geometry::array::each;
use crate::geometry::wide_bvh::{Is, WIDTH};
use crate::trace::graph::{Group, Operation, Target};
use crate::trace::precision::Precision;
use crate::trace::ray::Ray;

/// The boundary or sheet of the scene's union that a ray sees first.
pub(super) struct FirstBoundary<R> {
    pub event: Event<R>,
    /// The states before and behind the boundary.
    pub states: [State; 2],
    /// Whether the boundary is a sheet with another boundary behind it in the same place.
    pub in_face: bool,
}

/// Finds the first event whose kind `is_it` accepts: its number in the list, the event, and the states before and
/// behind it. `start` is the state before all events.
pub(super) fn first_of_kind<R: Precision>(
    start: State,
    events: &[Event<R>],
    is_it: impl Fn(Kind) -> bool,
) -> Option<(usize, Event<R>, [State; 2])> {
    let mut before = start;
    for (i, event) in events.iter().enumerate() {
        if is_it(event.kind) {
            return Some((i, *event, [before, event.state]));
        }
        before = event.state;
    }
    None
}

/// The place of the next boundary behind an event that is a sheet; `None` for other events. `rest` are the events after
/// it.
fn behind_sheet<R: Precision>(event: &Event<R>, rest: &[Event<R>]) -> Option<RayPoint<R>> {
    let next = || rest.iter().find(|e| e.kind == Kind::Boundary);
    match event.kind {
        Kind::Sheet => next().map(|e| e.place),
        Kind::Boundary | Kind::Silent => None,
    }
}

/// Whether events of this kind are visible.
pub(super) fn is_seen(kind: Kind) -> bool {
    kind != Kind::Silent
}

impl<R: Precision> Walker<'_, R> {
    /// The state of the whole scene at t = `from`, where the ray starts, and the events up to `to`. The state is `None`
    /// if the ray starts outside and has no events.
    pub fn trace_spans(&mut self, ray: &Ray<R>, from: R, to: R) -> (Option<State>, &[Event<R>]) {
        self.begin(ray);
        self.evaluate(ray, 0, from, to)
    }

    /// The first boundary or sheet of the scene in (from, to].
    pub(super) fn trace_first(&mut self, ray: &Ray<R>, from: R, to: R) -> Option<FirstBoundary<R>> {
        let Operation::Union(all) = &self.graph.root().operation else {
            return None;
        };
        self.begin(ray);
        self.spans.forget();
        self.gather(0, all, from, to);
        self.work_off(ray, from, to);
        let (start, events) = match self.spans.lists.len() {
            0 => return None,
            1 => (self.spans.lists[0].start, &self.spans.events),
            _ => {
                self.sort(0);
                let start = merge_union(&mut self.spans, 0, Until::FirstSeen);
                (start, &self.spans.scratch.out)
            }
        };
        let (i, event, states) = first_of_kind(start, events, is_seen)?;
        let next = behind_sheet(&event, &events[i + 1..]);
        let in_face = next.is_some_and(|next| self.order(&event.place, &next).is_eq());
        Some(FirstBoundary {
            event,
            states,
            in_face,
        })
    }

    /// The events up to `to` of the parts that hold something transparent. `ray` must be the ray of the search just
    /// before. If it starts outside of every solid and crosses nothing opaque, these are all its events.
    pub fn trace_clear_spans(&mut self, ray: &Ray<R>, from: R, to: R) -> &[Event<R>] {
        self.spans.forget();
        if let Operation::Union(Group {
            clear: Some(clear), ..
        }) = &self.graph.root().operation
        {
            let join = Task::JoinUnion {
                context: 0,
                base: 0,
            };
            self.spans.tasks.push(join);
            self.gather(0, clear, from, to);
            self.work_off(ray, from, to);
        }
        &self.spans.events
    }

    /// The first boundary or sheet of an intersection that the present search wants.
    pub(in crate::trace) fn first_of(
        &mut self,
        ray: &Ray<R>,
        context: u32,
        from: R,
        to: R,
    ) -> Option<Crossing<R>> {
        let (graph, search) = (self.graph, self.search);
        let (_, events) = self.evaluate(ray, context, from, to);
        let is_seen = |e: &Event<R>| {
            e.kind != Kind::Silent && search.wants(graph.made_of(e.owner.medium.optics))
        };
        let event = events.iter().find(|&event| is_seen(event))?;
        Some(Crossing {
            place: event.place,
            owner: event.owner.leaf,
        })
    }

    /// The start state (`None`: outside, and no events) and the events of a context's object.
    fn evaluate(
        &mut self,
        ray: &Ray<R>,
        context: u32,
        from: R,
        to: R,
    ) -> (Option<State>, &[Event<R>]) {
        self.spans.forget();
        self.spans.tasks.push(Task::Object { context });
        self.work_off(ray, from, to);
        let start = self.spans.lists.last().map(|l| l.start);
        (start, &self.spans.events)
    }

    /// Works off all tasks. If a join was the first task, one list or none is left; else there is one list for each
    /// part that was met.
    fn work_off(&mut self, ray: &Ray<R>, from: R, to: R) {
        while let Some(task) = self.spans.tasks.pop() {
            match task {
                Task::Part { part, context } => {
                    self.part_spans(ray, Leaf { part, context }, from, to)
                }
                Task::Object { context } => self.object_spans(ray, context, from, to),
                Task::Operand {
                    part,
                    context,
                    base,
                } => self.operands(ray, part, context, base, from, to),
                Task::JoinUnion { context, base } => {
                    let part = self.contexts[context as usize].part;
                    self.sort(base);
                    join_union(&mut self.spans, part, base);
                }
                Task::JoinIntersection {
                    context,
                    base,
                    first,
                } => {
                    self.join_intersection(context, base, first);
                }
            }
        }
    }

    pub(super) fn owner(&self, leaf: Leaf) -> Owner {
        Owner {
            leaf,
            medium: Medium {
                optics: self.optics(leaf),
                index: self.index(leaf),
            },
        }
    }

    /// Makes the list of a part that is a shape, or enters an object and puts a task for it on the stack.
    fn part_spans(&mut self, ray: &Ray<R>, leaf: Leaf, from: R, to: R) {
        let part = self.part(leaf.part);
        let primitive = match part.target {
            Target::Object(object) => {
                if let Some(context) = self.enter(leaf.context, leaf.part, object) {
                    self.spans.tasks.push(Task::Object { context });
                }
                return;
            }
            Target::Shape(primitive) => primitive,
        };
        let solid = self.graph.primitives[primitive as usize].is_solid();
        let behind = (self.cross(ray, leaf, primitive, from, None)).unwrap_or_default();
        let owner = self.owner(leaf);
        let begin = self.spans.events.len();
        let mut inside = part.inverted != (solid && (self.roots.inside != (behind % 2 == 1)));
        let start = State { inside, owner };
        // The complement of a surface without inside is all of space; that the surface is missing is not visible.
        if solid || !part.inverted {
            for i in behind..self.roots.list.len() {
                let root = self.roots.list[i];
                if root.t > to {
                    break;
                }
                let error = self.rough(&self.line, primitive, root);
                inside ^= solid;
                self.spans.events.push(Event {
                    kind: if solid { Kind::Boundary } else { Kind::Sheet },
                    place: RayPoint { leaf, root, error },
                    owner,
                    state: State { inside, owner },
                });
            }
        }
        if start.inside || self.spans.events.len() > begin {
            self.spans.lists.push(List {
                part: leaf.part,
                start,
                begin,
            });
        }
    }

    fn object_spans(&mut self, ray: &Ray<R>, context: u32, from: R, to: R) {
        let graph = self.graph;
        let object = self.contexts[context as usize].object;
        let base = self.spans.lists.len();
        match &graph.objects[object as usize].operation {
            Operation::Union(group) => {
                self.spans.tasks.push(Task::JoinUnion { context, base });
                self.gather(context, group, from, to);
            }
            Operation::Intersection { first, .. } => {
                self.operands(ray, first.start, context, base, from, to);
            }
        }
    }

    /// Puts a task for each part of a group that the ray may meet in [from, to] on the stack.
    pub(in crate::trace) fn gather(&mut self, context: u32, group: &Group, from: R, to: R) {
        let task = |&part: &u32| Task::Part { part, context };
        self.spans.tasks.extend(group.loose.iter().map(task));
        let beam = self.contexts[context as usize].beam;
        let (from, to) = (from.to_f64(), to.to_f64());
        let (from, to) = (beam.pace(from), beam.pace(to));
        self.nodes.clear();
        if !group.tree.nodes.is_empty() {
            self.nodes.push(0);
        }
        while let Some(node) = self.nodes.pop() {
            let node = &group.tree.nodes[node as usize];
            self.counts.boxes += WIDTH as u64;
            let (mut met, _) = beam.meets(node, from, to);
            while met != 0 {
                let slot = met.trailing_zeros() as usize;
                met &= met - 1;
                match node.children[slot].is() {
                    Is::Node(node) => self.nodes.push(node),
                    Is::Item(part) => self.spans.tasks.push(task(&part)),
                }
            }
        }
    }

    /// Continues an intersection. The lists of the operands before `part` are on the stack. Shapes are crossed at once.
    /// The next operand that is an object becomes a task, and the rest waits for it.
    fn operands(&mut self, ray: &Ray<R>, mut part: u32, context: u32, base: usize, from: R, to: R) {
        let graph = self.graph;
        let object = self.contexts[context as usize].object;
        let Operation::Intersection { first, cuts, .. } = &graph.objects[object as usize].operation
        else {
            return;
        };
        loop {
            let done = (part - first.start) as usize;
            if self.spans.lists.len() < base + done {
                // An operand is nowhere on this ray, so the intersection is nowhere either.
                if let Some(list) = self.spans.lists.get(base) {
                    self.spans.events.truncate(list.begin);
                    self.spans.lists.truncate(base);
                }
                return;
            }
            if part == first.end {
                break;
            }
            let leaf = Leaf { part, context };
            part += 1;
            if let Target::Object(_) = self.part(leaf.part).target {
                let rest = Task::Operand {
                    part,
                    context,
                    base,
                };
                self.spans.tasks.push(rest);
                self.part_spans(ray, leaf, from, to);
                return;
            }
            self.part_spans(ray, leaf, from, to);
        }
        self.spans.tasks.push(Task::JoinIntersection {
            context,
            base,
            first: first.len(),
        });
        let (near, far) = self.spans.extent(base, from, to);
        if near <= far {
            self.gather(context, cuts, near, far);
        }
    }

    fn join_intersection(&mut self, context: u32, base: usize, first: usize) {
        let Operation::Intersection {
            first: operands,
            inherit,
            ..
        } = &self.graph.objects[self.contexts[context as usize].object as usize].operation
        else {
            return;
        };
        // If all operands are complements, the medium is that of the first cut, which is the part behind the empty
        // range.
        let lead = self.owner(Leaf {
            part: operands.start,
            context,
        });
        let part = self.contexts[context as usize].part;
        self.work.csg_merge += 1;
        self.sort(base);
        join_intersection(&mut self.spans, part, base, first, *inherit, lead);
    }
}

impl<R: Precision> Walker<'_, R> {
    /// Puts the events of the lists from `base` on in order, and notes which events are in one place.
    fn sort(&mut self, base: usize) {
        self.spans.sort(base);
        for i in 1..self.spans.scratch.order.len() {
            let [before, here] = each([i - 1, i], |i| self.spans.scratch.order[i]);
            // Two events of one operand are not compared: the operand has decided which of its events are in one place.
            if before.1 != here.1 {
                let [a, b] = each([before, here], |e| self.spans.events[e.2 as usize].place);
                self.spans.scratch.tied[i] = self.order(&a, &b).is_eq();
            }
        }
    }
}
