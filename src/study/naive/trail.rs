//! The trail of a ray: the shapes that it meets in their spaces, and the boundaries that operations make of its
//! crossings (Roth, "Ray Casting for Modeling Solids", 1982).

use super::number::{Number, Ray, V, dot};
use crate::geometry::array::each;
use crate::scene::{DEFAULT_INDEX, Optics, Rgb};

/// The space of a node on the way down to a shape.
#[derive(Debug, Clone, Copy)]
pub struct LocalSpace<T> {
    pub parent: u32,
    /// The rows of the map from the parent's space into this one.
    pub back: [[T; 4]; 3],
    pub ray: Ray<T>,
}

/// The properties that paints on the way down to a shape give. The value that is given first, farthest up, stays.
#[derive(Debug, Clone, Copy, Default)]
pub struct GivenProperties {
    /// The number of the texture, and of the frame in which it was given.
    pub texture: Option<(u32, u32)>,
    /// The number of the optics in [`Media`]; `None` for the default.
    pub optics: Option<u32>,
    /// The number of the refractive index in [`Media`]; `None` for the default.
    pub index: Option<u32>,
    /// The ID of the outermost entity that was given a property; 0 for none.
    pub owner: u32,
}

/// The optics and refractive indices that [`GivenProperties`] refer to. The first of each is the default.
#[derive(Debug, Clone)]
pub struct Media {
    pub optics: Vec<Optics>,
    pub indices: Vec<Rgb>,
}

impl Default for Media {
    fn default() -> Media {
        Media {
            optics: vec![Optics::default()],
            indices: vec![DEFAULT_INDEX],
        }
    }
}

impl Media {
    pub fn optics(&self, look: &GivenProperties) -> &Optics {
        &self.optics[look.optics.unwrap_or(0) as usize]
    }

    pub fn index(&self, look: &GivenProperties) -> Rgb {
        self.indices[look.index.unwrap_or(0) as usize]
    }

    /// Whether `a` and `b` have the same optics and refractive index, so that light notices no boundary between them.
    fn are_same(&self, a: &GivenProperties, b: &GivenProperties) -> bool {
        (a.optics == b.optics || self.optics(a) == self.optics(b))
            && (a.index == b.index || self.index(a) == self.index(b))
    }
}

/// An occurrence of a shape.
#[derive(Debug, Clone, Copy, Default)]
pub struct Leaf {
    pub shape: u32,
    pub frame: u32,
    pub look: GivenProperties,
    /// ID of the entity whose record made the leaf.
    pub id: u32,
}

/// A crossing that may or may not be a boundary.
#[derive(Debug, Clone, Copy)]
pub struct Event<T> {
    pub t: T,
    pub leaf: u32,
    pub face: u32,
    pub sheet: bool,
    pub seen: bool,
    /// The leaf whose properties the surface has.
    pub owner: u32,
    /// The leaf whose medium is behind the crossing; `None` outside of all solids.
    pub after: Option<u32>,
}

/// Events by ascending t. `start` is the leaf whose medium the line comes from; `None` outside of all solids.
#[derive(Debug, Clone)]
pub struct List<T> {
    pub start: Option<u32>,
    pub events: Vec<Event<T>>,
}

impl<T> Default for List<T> {
    fn default() -> List<T> {
        List {
            start: None,
            events: Vec::new(),
        }
    }
}

impl<T> List<T> {
    pub fn is_nothing(&self) -> bool {
        self.start.is_none() && self.events.is_empty()
    }
}

/// The spaces and leaves that one ray has met.
#[derive(Debug, Clone)]
pub struct Trail<T> {
    pub frames: Vec<LocalSpace<T>>,
    pub leaves: Vec<Leaf>,
    pub media: Media,
}

impl<T> Default for Trail<T> {
    fn default() -> Trail<T> {
        Trail {
            frames: Vec::new(),
            leaves: Vec::new(),
            media: Media::default(),
        }
    }
}

/// Maps a ray by the map with these rows.
pub fn through<T: Number>(back: &[[T; 4]; 3], ray: &Ray<T>) -> Ray<T> {
    let row = |i: usize, v: V<T>| dot([back[i][0], back[i][1], back[i][2]], v);
    Ray {
        origin: each([0, 1, 2], |i| row(i, ray.origin) + back[i][3]),
        direction: each([0, 1, 2], |i| row(i, ray.direction)),
    }
}

impl<T: Number> Trail<T> {
    pub fn look(&self, leaf: u32) -> &GivenProperties {
        &self.leaves[leaf as usize].look
    }

    /// Begins a ray: frame 0 is the scene, and leaf 0 is the medium that fills all of space.
    pub fn begin(&mut self, ray: &Ray<T>) {
        self.frames.clear();
        self.leaves.clear();
        let (o, l) = (T::of(0.0), T::of(1.0));
        self.frames.push(LocalSpace {
            parent: 0,
            back: [[l, o, o, o], [o, l, o, o], [o, o, l, o]],
            ray: *ray,
        });
        self.leaves.push(Leaf::default());
    }

    pub fn enter(&mut self, parent: u32, back: &[[T; 4]; 3]) -> u32 {
        let ray = through(back, &self.frames[parent as usize].ray);
        self.frames.push(LocalSpace {
            parent,
            back: *back,
            ray,
        });
        self.frames.len() as u32 - 1
    }

    /// Maps a normal from a frame's space to the scene's. The result has any length.
    pub fn normal(&self, frame: u32, mut normal: V<T>) -> V<T> {
        let mut frame = frame;
        while frame != 0 {
            let here = &self.frames[frame as usize];
            let m = &here.back;
            normal = each([0, 1, 2], |i| dot([m[0][i], m[1][i], m[2][i]], normal));
            frame = here.parent;
        }
        normal
    }

    /// Joins the events of two operands. Events that are at most `tie` apart in t are in one place; below 0, each event
    /// has a place of its own.
    pub fn join(&self, operation: Operation, a: List<T>, b: List<T>, tie: T) -> List<T> {
        if operation == Operation::Union {
            if a.is_nothing() {
                return b;
            }
            if b.is_nothing() {
                return a;
            }
        }
        let cuts = matches!(operation, Operation::Difference | Operation::Removal);
        if cuts && b.is_nothing() {
            return a;
        }
        let state = |a: Option<u32>, b: Option<u32>| match operation {
            Operation::Union => a.or(b),
            Operation::Intersection => a.filter(|_| b.is_some()),
            Operation::Difference | Operation::Removal => a.filter(|_| b.is_none()),
        };
        let mut now = (a.start, b.start);
        let mut out = List {
            start: state(now.0, now.1),
            events: Vec::with_capacity(a.events.len() + b.events.len()),
        };
        let (mut i, mut j) = (0, 0);
        while i < a.events.len() || j < b.events.len() {
            let first = match (a.events.get(i), b.events.get(j)) {
                (Some(x), Some(y)) => {
                    if x.t <= y.t {
                        x.t
                    } else {
                        y.t
                    }
                }
                (Some(x), None) | (None, Some(x)) => x.t,
                (None, None) => break,
            };
            // All events of both operands in this place are judged together.
            let (i0, j0) = (i, j);
            let mut last = first;
            loop {
                let taken = i + j > i0 + j0;
                let near = |e: Option<&Event<T>>| {
                    e.is_some_and(|e| {
                        if taken {
                            e.t - last <= tie
                        } else {
                            e.t <= last
                        }
                    })
                };
                if near(a.events.get(i)) {
                    last = a.events[i].t;
                    i += 1;
                } else if near(b.events.get(j)) {
                    last = b.events[j].t;
                    j += 1;
                } else {
                    break;
                }
            }
            let here = [&a.events[i0..i], &b.events[j0..j]];
            let before = now;
            for (list, events) in here.iter().enumerate() {
                if let Some(event) = events.iter().rev().find(|e| !e.sheet) {
                    match list {
                        0 => now.0 = event.after,
                        _ => now.1 = event.after,
                    }
                }
            }
            self.judge(operation, here, [before, now], state, &mut out);
        }
        out
    }

    /// Appends the boundaries that the events in one place make. `here` has the events of the two operands; `before`
    /// and `after` are the media of the operands on either side of the place.
    fn judge(
        &self,
        operation: Operation,
        here: [&[Event<T>]; 2],
        [before, after]: [(Option<u32>, Option<u32>); 2],
        state: impl Fn(Option<u32>, Option<u32>) -> Option<u32>,
        out: &mut List<T>,
    ) {
        let (was, is) = (state(before.0, before.1), state(after.0, after.1));
        let inside = |list: usize| match list {
            0 => (before.0.is_some(), after.0.is_some()),
            _ => (before.1.is_some(), after.1.is_some()),
        };
        for (list, events) in here.iter().enumerate() {
            let (x, y) = inside(1 - list);
            let shown = match (operation, list) {
                (Operation::Union, _) => true,
                // A sheet that lies in a face of the other operand counts as inside of it.
                (Operation::Intersection, _) => x || y,
                (Operation::Difference | Operation::Removal, 0) => !x || !y,
                (Operation::Difference | Operation::Removal, _) => false,
            };
            let sheets = events.iter().filter(|e| e.sheet && shown);
            (out.events).extend(sheets.map(|e| Event { after: was, ..*e }));
        }
        let solid = |list: usize| here[list].iter().find(|e| !e.sheet);
        let same = |a: u32, b: u32| {
            let look = |leaf: u32| &self.leaves[leaf as usize].look;
            a == b || self.media.are_same(look(a), look(b))
        };
        let differs = match (was, is) {
            (Some(a), Some(b)) => !same(a, b),
            (None, None) => return,
            _ => true,
        };
        if operation == Operation::Union {
            // For each side of the place, the operand that holds the medium there. The event of the first operand is
            // preferred.
            let holder = |s: (Option<u32>, Option<u32>)| match s {
                (Some(_), _) => Some(0),
                (None, Some(_)) => Some(1),
                _ => None,
            };
            let mut holders = [holder(before), holder(after)];
            if let [Some(a), Some(b)] = holders
                && b < a
            {
                holders.swap(0, 1);
            }
            let event = holders.into_iter().flatten().find_map(solid);
            if let Some(event) = event {
                out.events.push(Event {
                    seen: differs,
                    after: is,
                    ..*event
                });
            }
            return;
        }
        if was.is_some() != is.is_some() {
            let turned = |list: &usize| inside(*list).0 != inside(*list).1;
            let Some(list) = (0..2).find(turned) else {
                return;
            };
            let Some(event) = solid(list) else { return };
            let owner = match (operation, list) {
                (Operation::Difference, 1) => was.or(is).unwrap_or(event.owner),
                _ => event.owner,
            };
            out.events.push(Event {
                seen: true,
                owner,
                after: is,
                ..*event
            });
        } else if let Some(event) = solid(0) {
            // The owner within the first operand may have changed.
            out.events.push(Event {
                seen: differs,
                after: is,
                ..*event
            });
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    Union,
    Intersection,
    /// A difference in which a face that the cut makes has the look of the solid that is cut.
    Difference,
    /// A difference in which a face that the cut makes has the look of the solid that cuts.
    Removal,
}
