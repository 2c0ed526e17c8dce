//! A kernel like that of most ray tracers, over the hierarchy of ours: closed formulas with coefficients from the ray's
//! own origin, one constant epsilon, no bounds on errors, and no decision that is asked again in more digits.
//!
//! A comparison with the tracer in the same numbers shows what certainty costs, and which errors it avoids.

pub mod solver;

use super::naive::form::{NaiveShape, Roots};
use super::naive::light::{Lens, RayCounts, Scenery, World, back, radiance};
use super::naive::number::{Number, Ray, V};
use super::naive::trail::{Event, GivenProperties, Leaf, List, Media, Operation, Trail};
use crate::diagnostics::{Complaint, Error};
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Beam, Child, Frame, Is, Tree, WIDTH};
use crate::scene::{Camera, Rgb, Scene};
use crate::trace::graph::{self, Graph, Group, Target, outermost};
use crate::trace::pixels::{Pixels, VisibleObject};
use crate::trace::sampling::sample;
use crate::trace::stats::{Counts, Rays};
use crate::trace::{Settings, Tracer};
use std::ops::Range;

/// The largest depth of nested objects that are drawn: the kernel is recursive.
const MAX_DEPTH: u32 = 200;

/// The plain kernel with a camera.
pub struct Plain<'a, T> {
    lens: Lens<T>,
    scenery: Scenery<'a, T>,
    walker: Walker<'a, T>,
    outside: bool,
    rays: RayCounts,
}

/// An object that the ray has entered on the way down to the shapes.
#[derive(Clone, Copy)]
struct Context {
    object: u32,
    frame: u32,
    /// The ray in the object's space, prepared for tests with the boxes of its tree.
    beam: Beam,
    look: GivenProperties,
}

/// A child of a tree that is still to be visited: the least t at which the ray may meet it, its context, the child.
type PendingNode<T> = (T, u32, Child);

struct Walker<'a, T> {
    graph: &'a Graph,
    forms: Vec<NaiveShape<T>>,
    solid: Vec<bool>,
    backs: Vec<[[T; 4]; 3]>,
    /// Whether each texture is a pattern in space.
    in_space: Vec<bool>,
    glass: bool,
    trail: Trail<T>,
    contexts: Vec<Context>,
    stack: Vec<PendingNode<T>>,
    roots: Roots<T>,
    tests: u64,
    boxes: u64,
}

/// Checks that the plain kernel can draw a tracer's scene.
///
/// # Errors
///
/// The ID of the message that says why not: objects are nested too deeply, or geodesic spheres have too many facets.
pub fn fits(tracer: &Tracer, scene: &Scene) -> Result<(), &'static str> {
    let graph = &tracer.graph;
    let mut depths = vec![0u32; graph.objects.len()];
    // The objects of the graph come after the objects that they are made of.
    for (i, object) in graph.objects.iter().enumerate() {
        let deepest = |parts: &mut dyn Iterator<Item = u32>| {
            let of = |part: u32| match graph.parts[part as usize].target {
                Target::Object(o) => depths[o as usize] + 1,
                Target::Shape(_) => 0,
            };
            parts.map(of).max().unwrap_or(0)
        };
        let group = |g: &Group| deepest(&mut g.parts());
        depths[i] = match &object.operation {
            graph::Operation::Union(g) => group(g),
            graph::Operation::Intersection { first, cuts, .. } => {
                deepest(&mut first.clone()).max(group(cuts))
            }
        };
    }
    let known = |record: &u32| {
        use crate::scene::Geometry::GeodesicSphere;
        match scene.shapes[*record as usize].geometry {
            GeodesicSphere { splits, .. } => splits <= super::naive::form::MAX_SPLITS,
            _ => true,
        }
    };
    match () {
        () if depths.iter().any(|&d| d > MAX_DEPTH) => Err("accuracy-unfit-deep"),
        () if !graph.records.iter().all(known) => Err("accuracy-unfit-facets"),
        () => Ok(()),
    }
}

impl<'a, T: Number> Plain<'a, T> {
    /// Calls `draw` with a kernel that draws the pixels of the camera's picture, and returns the answer of `draw`.
    ///
    /// # Errors
    ///
    /// A camera or a scene that the plain kernel cannot draw; see [`fits`].
    pub fn pixels<A>(
        (scene, tracer, camera): (&'a Scene, &'a Tracer, &Camera),
        settings: &Settings,
        draw: impl FnOnce(&mut dyn Pixels) -> A,
    ) -> Result<A, Error> {
        let unfit = || Complaint::new("accuracy-unfit-matrix");
        let Settings { width, height, .. } = *settings;
        let lens = Lens::new(camera, width, height).ok_or_else(unfit)?;
        let graph = &tracer.graph;
        let geometry = |record: &u32| &scene.shapes[*record as usize].geometry;
        let forms = (graph.records.iter())
            .map(|r| NaiveShape::new(geometry(r)))
            .collect::<Option<Vec<_>>>();
        let forms = forms.ok_or_else(|| Complaint::new("accuracy-unfit-facets"))?;
        let backs = graph.matrices.iter().map(back).collect::<Option<Vec<_>>>();
        let mut scenery = Scenery::new(scene, settings.depth, settings.cutoff);
        scenery.records = graph.records.clone();
        scenery.textures = graph
            .textures
            .iter()
            .zip(graph.bitmaps.iter().cloned())
            .collect();
        let in_space = |t| matches!(t, &crate::scene::Texture::Solid { .. });
        let mut walker = Walker {
            graph,
            forms,
            solid: graph
                .records
                .iter()
                .map(|r| geometry(r).is_solid())
                .collect(),
            backs: backs.ok_or_else(unfit)?,
            in_space: graph.textures.iter().map(in_space).collect(),
            glass: graph.root().holds.clear,
            trail: Trail {
                media: Media {
                    optics: graph.optics.clone(),
                    indices: graph.indices.clone(),
                },
                ..Trail::default()
            },
            contexts: Vec::new(),
            stack: Vec::new(),
            roots: Roots::default(),
            tests: 0,
            boxes: 0,
        };
        let position = Ray {
            origin: lens.position,
            direction: [T::of(0.0), T::of(0.0), T::of(1.0)],
        };
        let outside = scenery.clip.is_none()
            && camera.projection.is_none()
            && walker
                .between(&position, T::of(0.0), T::of(0.0))
                .start
                .is_none();
        Ok(draw(&mut Plain {
            lens,
            scenery,
            walker,
            outside,
            rays: RayCounts::default(),
        }))
    }
}

impl<T: Number> Pixels for Plain<'_, T> {
    fn sum(&mut self, x: u32, y: u32, samples: Range<u32>, of: u32) -> Rgb {
        let mut sum = [0.0; 3];
        for i in samples {
            let [dx, dy] = sample(x, y, i, of);
            let ray = self.lens.ray(f64::from(x) + dx, f64::from(y) + dy);
            let light = radiance(
                &self.scenery,
                &mut self.walker,
                ray,
                self.outside,
                &mut self.rays,
            );
            // The formulas may end in NaN or infinity; the picture shows black there.
            let light = each(light, |c| if c.is_finite() { c } else { 0.0 });
            sum = each([0, 1, 2], |c| sum[c] + light[c]);
        }
        sum
    }

    fn seen(&mut self, x: u32, y: u32) -> Option<VisibleObject> {
        let ray = self.lens.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let (zero, far) = (T::of(0.0), T::of(f64::INFINITY));
        let (from, to) = self.scenery.window(&ray, zero, far)?;
        let list = self.walker.events(&ray, from, to);
        let event = list
            .events
            .iter()
            .find(|e| e.seen && e.t > from && e.t <= to)?;
        let leaf = &self.walker.trail.leaves[event.owner as usize];
        Some(VisibleObject {
            object: outermost(leaf.look.owner, leaf.id),
            t: (event.t.wide(), 0.0),
        })
    }

    fn counts(&mut self) -> Counts {
        let [camera, shadow, reflection, refraction] = self.rays.sent;
        let mut counts = Counts {
            rays: Rays {
                camera,
                shadow,
                reflection,
                refraction,
                total: 0,
            },
            ..Counts::default()
        };
        counts.intersections.shape = self.walker.tests;
        counts.intersections.boxes = self.walker.boxes;
        counts
    }

    fn reset(&mut self) {
        self.rays = RayCounts::default();
        (self.walker.tests, self.walker.boxes) = (0, 0);
    }
}

/// The beam of a ray for tests with boxes.
fn beam<T: Number>(ray: &Ray<T>, frame: &Frame) -> Beam {
    let [origin, direction] = each([ray.origin, ray.direction], |v| Vec3(each(v, T::wide)));
    Beam::new(&Line::new(origin, direction), frame)
}

struct Best<T> {
    t: T,
    event: Option<Event<T>>,
    /// Whether any crossing will do, so that the search stops at the first one that it finds.
    any: bool,
}

impl<'a, T: Number> Walker<'a, T> {
    fn begin(&mut self, ray: &Ray<T>) {
        self.trail.begin(ray);
        self.contexts.clear();
        self.contexts.push(Context {
            object: self.graph.root,
            frame: 0,
            beam: beam(ray, &self.graph.root().frame),
            look: GivenProperties::default(),
        });
    }

    /// Returns the frame of a part, and its look: the properties given above the part, and its own paint for the rest.
    fn placed(&mut self, context: u32, part: &graph::Part) -> (u32, GivenProperties) {
        let above = self.contexts[context as usize];
        let coat = &self.graph.paints[part.paint as usize];
        let mut look = above.look;
        look.owner = outermost(look.owner, part.owner);
        look.optics = look.optics.or(coat.optics);
        look.index = look.index.or(coat.index);
        if look.texture.is_none()
            && let Some((texture, placement)) = coat.texture
        {
            let frame = match self.in_space[texture as usize] && placement != 0 {
                true => self
                    .trail
                    .enter(above.frame, &self.backs[placement as usize]),
                false => above.frame,
            };
            look.texture = Some((texture, frame));
        }
        let frame = match part.placement {
            0 => above.frame,
            m => self.trail.enter(above.frame, &self.backs[m as usize]),
        };
        (frame, look)
    }

    fn enter(&mut self, context: u32, part: &graph::Part, object: u32) -> u32 {
        let (frame, look) = self.placed(context, part);
        let ray = &self.trail.frames[frame as usize].ray;
        let beam = beam(ray, &self.graph.objects[object as usize].frame);
        self.contexts.push(Context {
            object,
            frame,
            beam,
            look,
        });
        self.contexts.len() as u32 - 1
    }

    fn leaf(&mut self, context: u32, part: &graph::Part, shape: u32) -> u32 {
        let (frame, look) = self.placed(context, part);
        self.trail.leaves.push(Leaf {
            shape,
            frame,
            look,
            id: part.shape,
        });
        self.trail.leaves.len() as u32 - 1
    }

    /// Finds the crossings of the ray with a part that is a shape, into `roots`.
    fn cross(&mut self, context: u32, part: &graph::Part, shape: u32) {
        self.tests += 1;
        let above = self.contexts[context as usize].frame;
        let ray = self.trail.frames[above as usize].ray;
        let ray = match part.placement {
            0 => ray,
            m => super::naive::trail::through(&self.backs[m as usize], &ray),
        };
        self.forms[shape as usize].cross(&ray, &mut self.roots);
    }

    /// The nearest crossing with anything in (from, to), or with `any` the first that is found. In an intersection only
    /// the boundary of the whole counts.
    fn nearest(&mut self, ray: &Ray<T>, from: T, to: T, any: bool) -> Option<Event<T>> {
        self.begin(ray);
        let mut best = Best {
            t: to,
            event: None,
            any,
        };
        self.stack.clear();
        self.open(0, from);
        let mut next = None;
        while let Some((near, context, child)) = next.take().or_else(|| self.stack.pop()) {
            if best.any && best.event.is_some() {
                break;
            }
            if near > best.t {
                continue;
            }
            match child.is() {
                Is::Node(node) => next = self.visit(context, node, from, &best),
                Is::Item(part) => self.meet(context, part, from, &mut best),
            }
        }
        best.event
    }

    fn group(&self, context: u32) -> Option<&'a Group> {
        let object = self.contexts[context as usize].object;
        match &self.graph.objects[object as usize].operation {
            graph::Operation::Union(group) => Some(group),
            graph::Operation::Intersection { .. } => None,
        }
    }

    fn open(&mut self, context: u32, from: T) {
        let Some(group) = self.group(context) else {
            return;
        };
        if !group.tree.nodes.is_empty() {
            self.stack.push((from, context, Child::ROOT));
        }
        let loose = |&part| (from, context, Child::item(part));
        self.stack.extend(group.loose.iter().map(loose));
    }

    /// The nearest child of a node that the ray may meet; the others are put on the stack, the farthest first.
    fn visit(
        &mut self,
        context: u32,
        node: u32,
        from: T,
        best: &Best<T>,
    ) -> Option<PendingNode<T>> {
        let group = self.group(context)?;
        let beam = &self.contexts[context as usize].beam;
        let node = &group.tree.nodes[node as usize];
        self.boxes += WIDTH as u64;
        let ends = each([from, best.t], |t| beam.pace(t.wide()));
        let entry = |near, child| (T::of(beam.unpace(near)), context, child);
        let stack = &mut self.stack;
        let base = stack.len();
        let first = beam.first(node, ends, |near, child| {
            let entry = entry(near, child);
            let mut at = stack.len();
            stack.push(entry);
            while at > base && stack[at - 1].0 < entry.0 {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = entry;
        });
        first.map(|(near, child)| entry(near, child))
    }

    fn meet(&mut self, context: u32, part: u32, from: T, best: &mut Best<T>) {
        let p = &self.graph.parts[part as usize];
        let shape = match p.target {
            Target::Object(object) => return self.look_into(context, p, object, from, best),
            Target::Shape(shape) => shape,
        };
        self.cross(context, p, shape);
        let found = self.roots.list.iter().find(|r| r.0 > from && r.0 < best.t);
        if let Some(&(t, face)) = found {
            let leaf = self.leaf(context, p, shape);
            best.t = t;
            best.event = Some(Event {
                t,
                leaf,
                face,
                sheet: !self.solid[shape as usize],
                seen: true,
                owner: leaf,
                after: None,
            });
        }
    }

    fn look_into(
        &mut self,
        context: u32,
        part: &graph::Part,
        object: u32,
        from: T,
        best: &mut Best<T>,
    ) {
        let entered = self.enter(context, part, object);
        match &self.graph.objects[object as usize].operation {
            graph::Operation::Union(_) => self.open(entered, from),
            graph::Operation::Intersection { .. } => {
                let list = self.object(entered, from, best.t);
                let mut seen = list.events.into_iter().filter(|e| e.seen && e.t > from);
                if let Some(event) = seen.next().filter(|e| e.t < best.t) {
                    best.t = event.t;
                    best.event = Some(event);
                }
            }
        }
    }

    /// The events on the ray of all parts whose boxes it meets between `from` and `to`.
    fn between(&mut self, ray: &Ray<T>, from: T, to: T) -> List<T> {
        self.begin(ray);
        self.object(0, from, to)
    }

    fn object(&mut self, context: u32, from: T, to: T) -> List<T> {
        let tie = T::of(0.0);
        let object = self.contexts[context as usize].object;
        match &self.graph.objects[object as usize].operation {
            graph::Operation::Union(group) => self.joined(context, group, from, to),
            graph::Operation::Intersection {
                first,
                cuts,
                inherit,
            } => {
                let mut all = match first.is_empty() {
                    true => List {
                        start: Some(0),
                        events: Vec::new(),
                    },
                    false => self.part(context, first.start, from, to),
                };
                for part in first.clone().skip(1) {
                    if all.is_nothing() {
                        return all;
                    }
                    let list = self.part(context, part, from, to);
                    all = self.trail.join(Operation::Intersection, all, list, tie);
                }
                if all.is_nothing() {
                    return all;
                }
                let cut = self.joined(context, cuts, from, to);
                let operation = match inherit {
                    true => Operation::Difference,
                    false => Operation::Removal,
                };
                self.trail.join(operation, all, cut, tie)
            }
        }
    }

    fn joined(&mut self, context: u32, group: &Group, from: T, to: T) -> List<T> {
        let mut parts = group.loose.clone();
        self.gather(context, &group.tree, from, to, &mut parts);
        parts.sort_unstable();
        let mut all = List::default();
        for part in parts {
            let list = self.part(context, part, from, to);
            all = self.trail.join(Operation::Union, all, list, T::of(0.0));
        }
        all
    }

    fn gather(&mut self, context: u32, tree: &Tree, from: T, to: T, parts: &mut Vec<u32>) {
        let beam = self.contexts[context as usize].beam;
        let (from, to) = (beam.pace(from.wide()), beam.pace(to.wide()));
        let mut pending: Vec<u32> = tree.nodes.first().map(|_| 0).into_iter().collect();
        while let Some(node) = pending.pop() {
            let node = &tree.nodes[node as usize];
            self.boxes += WIDTH as u64;
            let (met, _) = beam.meets(node, from, to);
            for slot in (0..WIDTH).filter(|slot| met >> slot & 1 != 0) {
                match node.children[slot].is() {
                    Is::Node(node) => pending.push(node),
                    Is::Item(part) => parts.push(part),
                }
            }
        }
    }

    fn part(&mut self, context: u32, part: u32, from: T, to: T) -> List<T> {
        let p = &self.graph.parts[part as usize];
        let shape = match p.target {
            Target::Object(object) => {
                let entered = self.enter(context, p, object);
                return self.object(entered, from, to);
            }
            Target::Shape(shape) => shape,
        };
        let sheet = !self.solid[shape as usize];
        if sheet && p.inverted {
            // The complement of a surface is all of space.
            return List {
                start: Some(0),
                events: Vec::new(),
            };
        }
        self.cross(context, p, shape);
        if self.roots.list.is_empty() && (sheet || self.roots.inside == p.inverted) {
            return List::default();
        }
        let leaf = self.leaf(context, p, shape);
        let mut inside = self.roots.inside != p.inverted && !sheet;
        let state = |inside: bool| inside.then_some(leaf);
        let mut list = List {
            start: state(inside),
            events: Vec::with_capacity(self.roots.list.len()),
        };
        for &(t, face) in &self.roots.list {
            inside = !inside && !sheet;
            list.events.push(Event {
                t,
                leaf,
                face,
                sheet,
                seen: true,
                owner: leaf,
                after: state(inside),
            });
        }
        list
    }
}

impl<T: Number> World<T> for Walker<'_, T> {
    fn first_from_outside(&mut self, ray: &Ray<T>, from: T, to: T) -> Option<Option<Event<T>>> {
        Some(self.nearest(ray, from, to, false))
    }

    fn is_blocked(&mut self, ray: &Ray<T>, from: T, to: T) -> Option<bool> {
        let Some(event) = self.nearest(ray, from, to, !self.glass) else {
            return Some(false);
        };
        let optics = self.trail.media.optics(self.trail.look(event.owner));
        (optics.kt == [0.0; 3]).then_some(true)
    }

    fn events(&mut self, ray: &Ray<T>, from: T, to: T) -> List<T> {
        if !to.wide().is_finite()
            && let Some(first) = self.nearest(ray, from, to, false)
        {
            // The stretch ends a little behind the first crossing, so that everything in the same place is in it.
            let near = first.t + first.t * T::TINY.sqrt() + T::OFFSET;
            let list = self.between(ray, from, near);
            let seen = |e: &Event<T>| e.seen && e.t > from && e.t <= near;
            if list.events.iter().any(seen) {
                return list;
            }
        }
        self.between(ray, from, to)
    }

    fn trail(&self) -> &Trail<T> {
        &self.trail
    }

    fn normal(&self, shape: u32, point: V<T>, face: u32) -> V<T> {
        self.forms[shape as usize].normal(point, face)
    }
}
