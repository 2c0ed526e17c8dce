//! Events on a ray: crossings of shapes, and the boundaries that operations make of them.

use super::context::Leaf;
use crate::trace::precision::Precision;
use crate::trace::shapes::Root;

/// A crossing with a shape, and how exactly its t is known.
#[derive(Debug, Clone, Copy)]
pub struct RayPoint<R> {
    pub leaf: Leaf,
    pub root: Root<R>,
    /// A rough bound on the error of the root's t; see [`Walker::rough`](super::walk::Walker::rough).
    pub error: R,
}

/// A crossing with a shape, and the owner of its properties. The crossing may or may not be a boundary of the scene.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<R = f64> {
    pub place: RayPoint<R>,
    /// The leaf whose properties apply.
    pub owner: Leaf,
}

impl<R> Crossing<R> {
    /// A crossing of a part that is a shape, which is its own owner.
    pub fn at(leaf: Leaf, root: Root<R>, error: R) -> Crossing<R> {
        Crossing {
            place: RayPoint { leaf, root, error },
            owner: leaf,
        }
    }
}

/// The properties of a solid that light notices: the numbers of its optics and of its refractive index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    pub optics: u32,
    pub index: u32,
}

/// The owner of a point: the part that the point belongs to, and the part's medium.
#[derive(Debug, Clone, Copy)]
pub struct Owner {
    pub leaf: Leaf,
    pub medium: Medium,
}

/// The state of an object between two events. The owner has a meaning only if `inside` is true.
#[derive(Debug, Clone, Copy)]
pub struct State {
    pub inside: bool,
    pub owner: Owner,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A boundary of the object.
    Boundary,
    /// A surface without inside.
    Sheet,
    /// A change of the owner and of nothing else, which is not visible.
    Silent,
}

#[derive(Debug, Clone, Copy)]
pub struct Event<R = f64> {
    pub kind: Kind,
    /// The crossing of the ray with the surface of a shape.
    pub place: RayPoint<R>,
    /// The owner whose properties the surface has.
    pub owner: Owner,
    /// The state after the event.
    pub state: State,
}

impl<R: Precision> Event<R> {
    pub fn t(&self) -> R {
        self.place.root.t
    }
}

/// A list of the events of one operand, in [`Spans::events`]. It ends where the next list begins.
#[derive(Debug, Clone, Copy)]
pub(in crate::trace) struct List {
    /// The index of the operand in the graph's parts, which gives the order of the operands.
    pub part: u32,
    pub start: State,
    pub begin: usize,
}

/// The lists of events that wait to be joined, and the tasks that make and join them. Tasks, lists and events are
/// stacks.
#[derive(Debug, Default)]
pub(in crate::trace) struct Spans<R = f64> {
    pub tasks: Vec<Task>,
    pub lists: Vec<List>,
    pub events: Vec<Event<R>>,
    pub scratch: Scratch<R>,
}

#[derive(Debug, Clone, Copy)]
pub(in crate::trace) enum Task {
    Part {
        part: u32,
        context: u32,
    },
    Object {
        context: u32,
    },
    /// Continues an intersection with operand `part`, unless an earlier operand was empty. The intersection's lists
    /// start at index `base` of the stack [`Spans::lists`].
    Operand {
        part: u32,
        context: u32,
        base: usize,
    },
    JoinUnion {
        context: u32,
        base: usize,
    },
    JoinIntersection {
        context: u32,
        base: usize,
        first: usize,
    },
}

/// Buffers that are kept from one join to the next.
#[derive(Debug, Default)]
pub(in crate::trace) struct Scratch<R = f64> {
    /// The events of all lists in order: t, the number of the list, and the index of the event.
    pub order: Vec<(R, u32, u32)>,
    /// For each entry of `order`, whether its event is in one place with the event before.
    pub tied: Vec<bool>,
    pub(in crate::trace) before: Vec<State>,
    pub(in crate::trace) after: Vec<State>,
    pub(in crate::trace) out: Vec<Event<R>>,
}

impl<R: Precision> Spans<R> {
    /// Forgets all lists.
    pub(crate) fn forget(&mut self) {
        self.tasks.clear();
        self.lists.clear();
        self.events.clear();
    }

    /// The bytes that the lists take when they are joined next. Each event is there twice, once more in the result, and
    /// has an entry in the order. Each list has a state before and a state after.
    pub(crate) fn bytes(&self) -> usize {
        let event = 2 * size_of::<Event<R>>() + size_of::<(R, u32, u32)>() + 1;
        let list = size_of::<List>() + 2 * size_of::<State>();
        self.events.len() * event + self.lists.len() * list
    }

    /// The events of list `i`.
    pub(crate) fn of(&self, i: usize) -> &[Event<R>] {
        let end = self.lists.get(i + 1).map_or(self.events.len(), |l| l.begin);
        &self.events[self.lists[i].begin..end]
    }

    /// A part of [from, to] that holds every place where all lists from `base` on are inside or have a sheet.
    pub(in crate::trace) fn extent(&self, base: usize, from: R, to: R) -> (R, R) {
        let (mut near, mut far) = (from, to);
        for i in base..self.lists.len() {
            let events = self.of(i);
            if let (false, Some(first)) = (self.lists[i].start.inside, events.first()) {
                near = near.max(first.t());
            }
            if let Some(last) = events.last().filter(|e| !e.state.inside) {
                far = far.min(last.t());
            }
        }
        (near, far)
    }
}
