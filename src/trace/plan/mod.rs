//! The effects that a scene calls for. They are decided before the first ray, by the nodes that the render record
//! reaches and the properties that apply there after overriding.
//!
//! The decision errs on one side only: an effect that is off is certainly not needed, and its code
//! does not run.

mod below;
mod lone;
mod media;
mod notes;
pub mod unseen;
pub mod visible_aspects;

use crate::diagnostics::Span;
use crate::parallel;
use crate::scene::{Node, NodeId, Rgb, Scene, View};
use crate::solids::staging::is_dark;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::ops::Range;
use unseen::{LeftOut, Unseen, UnseenParts};
use visible_aspects::VisibleAspects;

/// The most entities that a plan names as reasons for an effect.
pub const MAX_SOURCES: usize = 16;

/// An effect. The variants are in the order in which plans list them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    Ambient,
    Diffuse,
    Shadows,
    TransparentShadows,
    Reflection,
    Refraction,
    Dispersion,
    ImageTexture,
    SolidTexture,
    Checkerboard,
    VertexColour,
    SmoothNormals,
    Csg,
    Unbounded,
    ClipBox,
    Stereo,
    ProjectionMatrix,
}

/// An entity that turns an effect on, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Because {
    pub id: u32,
    /// The place of the entity's definition.
    pub span: Span,
    pub text: &'static str,
}

/// The decision about one effect.
#[derive(Debug, Clone)]
pub struct Decision {
    pub effect: Effect,
    pub on: bool,
    /// The first [`MAX_SOURCES`] reasons; empty for an effect that is off.
    pub because: Vec<Because>,
    /// The cost of the effect, or why it is off.
    pub note: &'static str,
}

/// The plan of a scene.
#[derive(Debug, Clone)]
pub struct Plan {
    /// All effects, in their order.
    pub effects: Vec<Decision>,
    /// IDs of the objects that are not drawn, ascending.
    pub unreached: Vec<u32>,
    /// Parts of the drawn scene that no ray can see, and that therefore call for no effect.
    pub unseen: Vec<Unseen>,
    /// The unseen parts, as operands that are left out.
    pub left_out: LeftOut,
    /// The number of shape records that are drawn, by the name of the shape.
    pub shapes: BTreeMap<&'static str, u32>,
    /// The number of operations that are drawn, by the name of the operation.
    pub operations: BTreeMap<&'static str, u32>,
    /// An upper bound on the number of transparent solids that hold one point.
    pub medium_depth: u32,
    /// Whether the scene is one convex shape, seen from outside.
    pub lone_convex: bool,
}

/// IDs of the first few entities that call for an effect.
#[derive(Debug, Clone, Default)]
pub struct Sources(Vec<u32>);

impl Sources {
    fn add(&mut self, id: u32) {
        if self.0.len() < MAX_SOURCES && !self.0.contains(&id) {
            self.0.push(id);
        }
    }

    fn some(&self) -> bool {
        !self.0.is_empty()
    }

    fn of(ids: impl IntoIterator<Item = u32>) -> Sources {
        let mut out = Sources::default();
        ids.into_iter().for_each(|id| out.add(id));
        out
    }
}

/// The reason that names the render record of a scene without any light.
const UNLIT: &str = "draws a scene without any light, so automatic lights shine";

/// The numbers of nodes for which a scene is searched on two threads. For smaller scenes, waking a thread takes longer
/// than it saves. For larger scenes, both searches at once would take too much memory.
const AT_ONCE: Range<usize> = 1 << 10..1 << 17;

impl Plan {
    /// The plan for all parts of the drawn scene, whether a picture shows them or not: for questions about single rays,
    /// which may start anywhere. `None` if there is no render record.
    pub fn new(scene: &Scene) -> Option<Plan> {
        Plan::of(scene, UnseenParts::all)
    }

    /// The plan for a picture: parts that no ray of a camera can see are left out. `None` where there is no render
    /// record.
    pub fn of_picture(scene: &Scene) -> Option<Plan> {
        Plan::of(scene, unseen::find)
    }

    /// The plan of a scene without the parts that `find` leaves out.
    fn of(scene: &Scene, find: fn(&Scene, NodeId) -> UnseenParts) -> Option<Plan> {
        let render = scene.render.as_ref()?;
        let find = || find(scene, render.root);
        let reach = || VisibleAspects::new(scene, render.root, &LeftOut::default());
        let (found, everything) = match AT_ONCE.contains(&scene.nodes.len()) {
            true => parallel::both(find, reach),
            false => (find(), reach()),
        };
        let UnseenParts {
            unseen,
            left_out,
            cut: clipped,
        } = found;
        let mut plan = Plan {
            effects: Vec::new(),
            unreached: Vec::new(),
            shapes: BTreeMap::new(),
            operations: BTreeMap::new(),
            medium_depth: 0,
            lone_convex: lone::lone_convex(scene, render.root, &left_out),
            unseen,
            left_out,
        };
        plan.count(scene, &everything, render.root);
        let owners = plan.owners(scene, &everything);
        let reach = match plan.unseen.is_empty() {
            true => everything,
            false => VisibleAspects::new(scene, render.root, &plan.left_out),
        };
        let ids = |nodes: &[NodeId]| {
            Sources::of(nodes.iter().map(|n| owners.get(n).copied().unwrap_or(0)))
        };
        if reach.glass.some() {
            let complements = !reach.complements.is_empty();
            plan.medium_depth = media::depth(scene, render.root, complements, &plan.left_out);
        }

        let lit = |power: Rgb, intensity: f64| power.iter().any(|c| c * intensity != 0.0);
        let ambient = (scene.ambient_lights.iter()).filter(|l| lit(l.colour, l.intensity));
        let ambient = Sources::of(ambient.map(|l| l.id));
        let points = (scene.point_lights.iter()).filter(|l| lit(l.colour, l.intensity));
        let points = Sources::of(points.map(|l| l.id));
        let dark = is_dark(scene);

        let diffuse = reach.diffuse.some() && (dark || points.some());
        let glass = reach.glass.some();
        // A lone convex shape throws shadows on its own inside, which is lit if the shape lets light in or is cut open.
        let shadows = diffuse && (!plan.lone_convex || glass || clipped);
        // Total reflection needs a refractive index that differs from the index of the space outside.
        let total = glass && reach.bent.some();
        let cameras: Vec<_> = scene.chosen_cameras().collect();
        let projecting = cameras.iter().filter(|c| c.projection.is_some());
        let stereo = matches!(scene.view, View::Stereo { .. });

        let automatic = Sources::of(dark.then_some(1));
        let mut out = Decisions {
            spans: FxHashMap::default(),
            list: Vec::with_capacity(17),
        };
        use Effect::*;
        let light = [(&points, "is a point light"), (&automatic, UNLIT)];
        out.decide(
            Ambient,
            reach.diffuse.some() && (dark || ambient.some()),
            &[
                (&ambient, "is an ambient light"),
                (&automatic, UNLIT),
                (&reach.diffuse, "is diffuse"),
            ],
        );
        let lit_surfaces = [light[0], light[1], (&reach.diffuse, "is diffuse")];
        out.decide(Diffuse, diffuse, &lit_surfaces);
        out.decide(Shadows, shadows, &light);
        out.decide(
            TransparentShadows,
            shadows && glass,
            &[(
                &reach.glass,
                "lets light through, so its shadow is not black",
            )],
        );
        let bent = match total {
            true => reach.bent.clone(),
            false => Sources::default(),
        };
        out.decide(
            Reflection,
            reach.mirror.some() || total,
            &[
                (&reach.mirror, "mirrors: its ks is not 0"),
                (
                    &bent,
                    "has a refractive index that can reflect light totally",
                ),
            ],
        );
        out.decide(
            Refraction,
            glass,
            &[(&reach.glass, "lets light through: its kt is not 0")],
        );
        out.decide(
            Dispersion,
            glass && reach.uneven.some(),
            &[(
                &reach.uneven,
                "has refractive indices that differ between channels",
            )],
        );
        out.decide(
            ImageTexture,
            reach.image.some(),
            &[(&reach.image, "has an image texture")],
        );
        out.decide(
            SolidTexture,
            reach.solid_texture.some(),
            &[(&reach.solid_texture, "has a solid texture")],
        );
        out.decide(
            Checkerboard,
            reach.checkerboard.some(),
            &[(&reach.checkerboard, "has a checkerboard")],
        );
        out.decide(
            VertexColour,
            reach.vertex_colour.some(),
            &[(
                &reach.vertex_colour,
                "has colours of its own, and none is painted over them",
            )],
        );
        out.decide(
            SmoothNormals,
            reach.smooth.some(),
            &[(&reach.smooth, "has normals of its own")],
        );
        let cuts = ids(&reach.cuts);
        out.decide(
            Csg,
            !reach.cuts.is_empty(),
            &[(&cuts, "is an intersection, a difference or a complement")],
        );
        let complements = ids(&reach.complements);
        out.decide(
            Unbounded,
            reach.unbounded.some() || !reach.complements.is_empty(),
            &[
                (&reach.unbounded, "goes on without end"),
                (&complements, "is a complement, which goes on without end"),
            ],
        );
        let record = Sources::of([1]);
        out.decide(
            ClipBox,
            clipped,
            &[(&record, "draws a region that cuts the scene")],
        );
        let pair = Sources::of(cameras.iter().map(|c| c.id));
        out.decide(Stereo, stereo, &[(&pair, "is one of the two cameras")]);
        let projecting = Sources::of(projecting.map(|c| c.id));
        out.decide(
            ProjectionMatrix,
            projecting.some(),
            &[(&projecting, "has a projection matrix")],
        );
        plan.effects = out.placed(scene, render.span);
        Some(plan)
    }

    /// Whether an effect is on.
    pub fn on(&self, effect: Effect) -> bool {
        self.effects.iter().any(|d| d.effect == effect && d.on)
    }

    /// Names of the effects that are on.
    pub fn names(&self) -> Vec<&'static str> {
        let on = self.effects.iter().filter(|d| d.on);
        on.map(|d| d.effect.name()).collect()
    }

    fn count(&mut self, scene: &Scene, reach: &VisibleAspects, root: NodeId) {
        for node in (0..=root).filter(|&n| reach.reaches(n)) {
            let (counts, name) = match scene.nodes[node as usize] {
                Node::Shape(s) => (&mut self.shapes, scene.shapes[s as usize].geometry.name()),
                Node::Union(..) => (&mut self.operations, "union"),
                Node::Intersection(..) => (&mut self.operations, "intersection"),
                Node::Difference(..) => (&mut self.operations, "difference"),
                Node::Complement(_) => (&mut self.operations, "complement"),
                Node::Transform { .. } | Node::Paint { .. } | Node::Copy { .. } => continue,
            };
            *counts.entry(name).or_insert(0) += 1;
        }
    }

    /// Notes the objects that are not reached. Returns the entity's ID for each operation that a reason may name, by
    /// the operation's node.
    fn owners(&mut self, scene: &Scene, reach: &VisibleAspects) -> FxHashMap<NodeId, u32> {
        let mut owners = FxHashMap::default();
        for entity in &scene.entities {
            let Some(node) = entity.node() else { continue };
            let base = base(scene, entity.id, node);
            if !reach.reaches(base) {
                self.unreached.push(entity.id);
            } else if reach.cuts.contains(&base) || reach.complements.contains(&base) {
                owners.insert(base, entity.id);
            }
        }
        self.unreached.sort_unstable();
        owners
    }
}

/// The node that the defining record of an entity made, below the nodes of all later changes.
fn base(scene: &Scene, id: u32, node: NodeId) -> NodeId {
    let is_own = |n: Node| match n {
        Node::Transform { .. } => true,
        Node::Paint { paint, .. } => scene.paints[paint as usize].owner == id,
        _ => false,
    };
    let mut states = scene.states(node).filter(|(_, n)| !is_own(*n));
    states.next().map_or(node, |(node, _)| node)
}

struct Decisions {
    spans: FxHashMap<u32, Span>,
    list: Vec<Decision>,
}

impl Decisions {
    fn decide(&mut self, effect: Effect, on: bool, why: &[(&Sources, &'static str)]) {
        let mut because = Vec::new();
        if on {
            for (sources, text) in why {
                because.extend(sources.0.iter().map(|&id| Because {
                    id,
                    span: Span::default(),
                    text,
                }));
            }
            because.truncate(MAX_SOURCES);
        }
        for b in &because {
            self.spans.insert(b.id, Span::default());
        }
        let note = if on { effect.cost() } else { effect.absence() };
        self.list.push(Decision {
            effect,
            on,
            because,
            note,
        });
    }

    /// The decisions with the places of all entities they name.
    fn placed(mut self, scene: &Scene, render: Span) -> Vec<Decision> {
        for entity in &scene.entities {
            if let Some(span) = self.spans.get_mut(&entity.id) {
                *span = entity.span;
            }
        }
        self.spans.insert(1, render);
        for because in self.list.iter_mut().flat_map(|d| &mut d.because) {
            because.span = self.spans.get(&because.id).copied().unwrap_or_default();
        }
        self.list
    }
}
