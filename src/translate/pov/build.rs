//! From nodes to objects: which `#declare`s a scene becomes, and what each consists of.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use super::aspects::{Aspects, DEFAULT, PROFILE, TextureUse};
use super::changes::{Change, Changes};
use super::descend::{End, Stop};
use super::difference::Substance;
use super::facts::{self, Facts};
use super::frame::power_of_two_about;
use super::offset::stretched;
use super::sets::Sets;
use super::sheets;
use super::spread;
use super::state::{Key, Layer, Look, Medium, State};
use super::textures::Textures;
use super::tree::{Body, Declaration, Modifier, Object, Operation};
use super::triangle;
use super::turned::with_normals_turned;
use super::volumes::{self, Volumes};
use crate::diagnostics::Complaint;
use crate::geometry::Aabb;
use crate::geometry::vec::Vec3;
use crate::scene::{Geometry, Node, NodeId, Scene, TriangleNormals};
use crate::solids::bounds::NodeBounds;
use crate::solids::contacts;
use crate::solids::shapes::facts::Facts as _;
use crate::syntax::Captions;
use crate::trace::members;
use crate::translate::fidelity::{Fidelity, Report};
use crate::translate::names;

/// What the report calls faces that POV-Ray cannot tell apart.
const FACES: &str = "faces in one place";

/// Unions of more members are not searched for them.
const MANY: usize = 4096;

/// Operands of larger intersections are not compared with each other.
const FEW: usize = 64;

/// What the objects of a scene are built from.
pub(super) struct Builder<'a> {
    pub scene: &'a Scene,
    pub aspects: Aspects,
    pub facts: Vec<Facts>,
    pub bounds: Vec<NodeBounds>,
    pub sets: Sets,
    pub textures: Textures,
    captions: &'a Captions,
    /// What is declared, by number.
    keys: Vec<Key>,
    numbers: HashMap<Key, usize>,
    /// How shapes are changed where nobody sees it.
    pub changes: Changes,
    /// How far apart faces are that are one, in the coordinates of what is written at the moment: see
    /// [`Frame::hair`](super::frame::Frame::hair).
    pub hair: f64,
    /// The same in the scene's coordinates.
    pub hair_of_scene: f64,
    /// For each node how many times as long the scene is in the coordinates that it is placed in.
    stretches: Vec<f64>,
    /// Some of them stand between other faces and those who look at them from inside.
    pub unseen_twice: bool,
    /// Shapes that were made longer.
    pub longer: HashSet<u32>,
    /// Bounding volumes that help.
    pub volumes: Volumes,
    /// Triangles whose normals turn away from the eye somewhere, and whether they are on the far side.
    pub turned: HashMap<u32, bool>,
    /// For each node whether there are any in it; nothing where there are none at all.
    pub holds_turned: Vec<bool>,
    /// For each node whether a flat surface is in it; nothing where no light goes through anything.
    pub holds_sheets: Vec<bool>,
    /// Opaque unions that touch what light goes through.
    pub beside_clear: HashSet<NodeId>,
    /// The number of an index as large as that of any solid.
    pub densest: u32,
    pub report: Report,
    /// The entity each node belongs to, 0 where none does.
    pub ids: Vec<u32>,
    /// The render box cuts through the scene, or a camera is in it: what lies inside of opaque
    /// objects can be seen.
    pub cut_open: bool,
}

impl<'a> Builder<'a> {
    pub fn new(
        scene: &'a Scene,
        bounds: Vec<NodeBounds>,
        root: NodeId,
        captions: &'a Captions,
        report: Report,
    ) -> Builder<'a> {
        let mut aspects = Aspects::of(scene);
        let facts = facts::facts(scene, &mut aspects, root);
        let volumes = volumes::proved(scene, &bounds);
        let all = bounds.get(root as usize).map_or(Aabb::EMPTY, |b| b.all);
        let cut_open = scene
            .render
            .and_then(|r| r.clip)
            .is_some_and(|(min, max)| !Aabb::new(min, max).holds(&all))
            || camera_is_walled_in(scene, &facts, &aspects);
        let clear = facts.iter().any(|f| f.uses > 0 && f.transparent);
        let beside_clear = match clear {
            true => spread::beside_clear(scene, &facts, &bounds, root),
            false => HashSet::new(),
        };
        let mut densest = DEFAULT;
        for solid in facts.iter().filter(|f| f.uses > 0 && f.has_solid) {
            densest = aspects.denser(densest, solid.index.first);
        }
        Builder {
            scene,
            aspects,
            facts,
            bounds,
            cut_open,
            sets: Sets::of(scene, root),
            textures: Textures::default(),
            captions,
            keys: Vec::new(),
            numbers: HashMap::new(),
            changes: Changes::default(),
            hair: 0.0,
            hair_of_scene: 0.0,
            stretches: stretches(scene, root),
            unseen_twice: false,
            longer: HashSet::new(),
            turned: HashMap::new(),
            holds_turned: Vec::new(),
            holds_sheets: sheets::holders(scene, clear),
            beside_clear,
            densest,
            volumes,
            report,
            ids: names::node_ids(scene),
        }
    }

    /// All objects that the scene consists of: each behind those it is made of, the root's last.
    pub fn objects(&mut self, root: NodeId) -> Vec<Declaration<'a>> {
        enum Step<'a> {
            Visit(usize),
            Write(usize, Declaration<'a>),
        }
        let state = State::ROOT;
        self.declared(Key { node: root, state });
        let mut todo = vec![Step::Visit(0)];
        let mut visited = HashSet::new();
        let mut places: HashMap<usize, usize> = HashMap::new();
        let mut objects = Vec::new();
        while let Some(step) = todo.pop() {
            match step {
                Step::Visit(number) => {
                    if !visited.insert(number) {
                        continue;
                    }
                    let declaration = self.declaration(self.keys[number]);
                    let mut needs = Vec::new();
                    declaration.object.each(&mut |part| {
                        if let Body::Declared(number) = part.body {
                            needs.push(Step::Visit(number));
                        }
                    });
                    todo.push(Step::Write(number, declaration));
                    todo.extend(needs.into_iter().rev());
                }
                Step::Write(number, mut declaration) => {
                    (declaration.object).each_declared(&mut |number| *number = places[number]);
                    places.insert(number, objects.len());
                    objects.push(declaration);
                }
            }
        }
        objects
    }

    /// A reference to the object that a key is declared as.
    fn declared(&mut self, key: Key) -> Object<'a> {
        let next = self.keys.len();
        let number = *self.numbers.entry(key).or_insert(next);
        if number == next {
            self.keys.push(key);
        }
        Object::new(Body::Declared(number))
    }

    fn declaration(&mut self, key: Key) -> Declaration<'a> {
        let id = self.ids[key.node as usize];
        let mut object = self.definition(key).unwrap_or(Object::nothing());
        if key.state.flush.is_none()
            && let Some((volume, written)) = self.volumes.get_mut(&key.node)
        {
            *written = true;
            object.modifiers.push(Modifier::Bound(*volume));
        }
        object.comment = names::comment(self.scene, self.captions, key.node, id);
        Declaration {
            id,
            name: String::new(),
            object,
        }
    }

    /// The object that a key is declared as; `None` where there is nothing in it.
    fn definition(&mut self, key: Key) -> Option<Object<'a>> {
        let descent = self.descend(key.node, key.state, Stop::BelowStart);
        let object = match descent.end {
            End::Nothing => Object::nothing(),
            End::Shape(shape, state) => {
                let id = self.ids[key.node as usize];
                return Some(self.shape(shape, state, descent.modifiers, id));
            }
            end => self.body(&end).unwrap_or(Object::nothing()),
        };
        Some(object.with(descent.modifiers))
    }

    /// What is at the end of a descent, if anything is left of it.
    fn body(&mut self, end: &End) -> Option<Object<'a>> {
        if let End::Union(part, ..)
        | End::Intersection(part, ..)
        | End::Difference(part, ..)
        | End::CrossedSurfaces(part, ..)
        | End::Split(part, _) = *end
        {
            self.hair = self.hair_of_scene * self.stretches[part as usize];
        }
        Some(match *end {
            End::Nothing | End::Shape(..) => return None,
            End::Everything => Object::new(Body::Everything),
            End::Shared(shared) => self.declared(shared),
            End::Union(a, b, state) => {
                let members = self.flat_union(&[a, b], state);
                self.union(members)?
            }
            End::Intersection(a, b, state) => {
                let members = self.flat_intersection(a, b, state);
                let nodes: Vec<_> = members.iter().map(|m| m.0).collect();
                if self.sets.is_empty(&nodes) {
                    return None;
                }
                let members = self.without_wider(members);
                let members = self.with_room(members);
                Object::of(Operation::Intersection, self.pieces(&members))
            }
            End::Difference(a, b, state) => self.difference(a, b, state)?,
            End::CrossedSurfaces(a, b, state) => {
                let mut members = Vec::new();
                for (shown, by) in [(a, b), (b, a)] {
                    let object = self.piece(shown, state);
                    let by = self.piece(by, State::GEOMETRY);
                    members.extend(object.map(|o| o.with(by.map(Modifier::inside))));
                }
                Object::of(Operation::Union, members)
            }
            End::Split(node, state) => {
                let surface = state.layer(Layer::Surface);
                let plate = Change::Plate(self.hair / 2.0, self.densest);
                let clear = self.is_transparent(node, state.look);
                let plate = clear.then(|| self.changes.number(plate));
                let parts = [
                    (node, state.layer(Layer::Solid)),
                    (node, surface.flush(surface.flush.or(plate))),
                ];
                Object::of(Operation::Union, self.pieces(&parts))
            }
        })
    }

    /// The object that stands for a node inside another object: a shape is written out, an
    /// operation is declared before.
    pub fn piece(&mut self, node: NodeId, state: State) -> Option<Object<'a>> {
        let descent = self.descend(node, state, Stop::AtShared);
        let id = self.ids[node as usize];
        let mut object = match descent.end {
            End::Nothing => return None,
            End::Everything => Object::new(Body::Everything),
            End::Shape(shape, state) => {
                return Some(self.shape(shape, state, descent.modifiers, id));
            }
            End::Shared(key) => self.declared(key),
            _ => return Some(self.declared(Key { node, state })),
        };
        if let End::Shared(key) = descent.end
            && id != 0
            && id != self.ids[key.node as usize]
        {
            object.comment = Some(self.caption(id));
        }
        Some(object.with(descent.modifiers))
    }

    /// What the scene calls an entity.
    fn caption(&self, id: u32) -> String {
        match self.captions.own(id) {
            Some(words) => format!("{id}, {words}"),
            None => id.to_string(),
        }
    }

    pub fn pieces(&mut self, members: &[(NodeId, State)]) -> Vec<Object<'a>> {
        members
            .iter()
            .filter_map(|&(node, state)| self.piece(node, state))
            .collect()
    }

    /// A shape with what is said about it; `id` is that of the entity that it belongs to.
    fn shape(
        &mut self,
        shape: u32,
        state: State,
        modifiers: Vec<Modifier<'a>>,
        id: u32,
    ) -> Object<'a> {
        let scene = self.scene;
        let record = &scene.shapes[shape as usize];
        let geometry = &record.geometry;
        let change = state
            .flush
            .filter(|f| self.applies(*f, state.look, geometry));
        if let Some(Change::Longer(_) | Change::Sides(..) | Change::Both(..)) =
            change.map(|f| self.changes.get(f))
        {
            self.longer.insert(shape);
        }
        let own = match state.look {
            // A texture that lies on shapes was handed down to here.
            Look::Own { texture, optics } => {
                let own = match geometry.character().has_colours {
                    true => TextureUse::here(PROFILE),
                    false => TextureUse::DEFAULT,
                };
                let (texture, optics) = (texture.unwrap_or(own), optics.unwrap_or(DEFAULT));
                self.textures.number(texture, optics, Some(shape))
            }
            Look::Above { .. } => None,
        };
        let mut all: Vec<_> = own.map(Modifier::Texture).into_iter().collect();
        all.extend(modifiers);
        let texture = all.iter().find_map(|m| match m {
            Modifier::Texture(texture) => Some(*texture),
            _ => None,
        });
        let clear = match texture {
            Some(texture) => self.textures.is_transparent(&self.aspects, texture),
            None => state.look == Look::Above { transparent: true },
        };
        let mut body = self.changed(shape, change);
        if let Some((by, index)) = change.and_then(|c| self.changes.plate(c)) {
            // Where something around it gives it its look, both sides would have that.
            if !clear || texture.is_some() {
                body = sheets::plate(geometry, by).unwrap_or(body);
            }
            if clear && texture.is_some() {
                all.push(Modifier::UnseenWithin);
                all.extend((index != DEFAULT).then(|| self.index(index)));
            }
        }
        if self.turned.contains_key(&shape) {
            let behind = texture.and_then(|t| self.textures.behind(&self.aspects, t));
            all.extend(behind.map(Modifier::InnerTexture));
        }
        let id = if id == 0 { record.id } else { id };
        let note = change.map_or("", |c| self.changes.note(c));
        Object {
            body,
            modifiers: all,
            comment: (id != 0).then(|| self.caption(id) + note),
        }
    }

    /// Whether a change is made to a shape of some look.
    fn applies(&self, change: u32, look: Look, geometry: &Geometry) -> bool {
        // Textures that are laid on shapes would be seen to move with them.
        let may = !self.is_laid_out(look) || self.changes.is_small(change);
        may && match geometry.is_solid() {
            true => self.changes.changed(change, geometry).is_some(),
            false => self.changes.plate(change).is_some() && geometry.character().is_flat,
        }
    }

    /// A shape, changed, as POV-Ray can have it.
    fn changed(&mut self, shape: u32, change: Option<u32>) -> Body<'a> {
        let geometry = &self.scene.shapes[shape as usize].geometry;
        let other = match self.turned.get(&shape) {
            Some(true) => with_normals_turned(geometry),
            _ => change.and_then(|c| self.changes.changed(c, geometry)),
        };
        let geometry = other.map_or(Cow::Borrowed(geometry), Cow::Owned);
        if let Geometry::Triangle { vertices, normals } = &*geometry
            && let TriangleNormals::PerVertex(normals) = normals
            && !triangle::are_equally_long(normals)
        {
            let fidelity = Fidelity::approximate(triangle::BOUND);
            self.report
                .count("vertex normals of different length", fidelity, "a mesh");
            return Body::Mesh(triangle::cut(vertices, normals));
        }
        Body::Shape(geometry)
    }

    /// The modifier of an index by its number.
    pub fn index(&self, number: u32) -> Modifier<'a> {
        Modifier::Index(self.aspects.index(number))
    }

    /// Whether some of a node may look so.
    pub fn may_be_laid_out(&self, node: NodeId, look: Look) -> bool {
        let own = self.facts[node as usize].texture;
        match look {
            Look::Own { texture: None, .. } => {
                !own.uniform || self.aspects.is_laid_on_shapes(own.first.texture)
            }
            look => self.is_laid_out(look),
        }
    }

    /// Whether a look follows the surface, so that the shape has to be what it is.
    fn is_laid_out(&self, look: Look) -> bool {
        match look {
            Look::Own { texture, .. } => {
                texture.is_some_and(|t| self.aspects.is_laid_on_shapes(t.texture))
            }
            Look::Above { .. } => false,
        }
    }

    /// The operands of a union and of the unions among them, in order. What is within one that came
    /// before is left out.
    pub fn flat_union(&mut self, roots: &[NodeId], state: State) -> Vec<(NodeId, State)> {
        let mut todo: Vec<_> = roots.iter().rev().map(|&node| (node, state)).collect();
        let mut out = Vec::new();
        let mut surfaces = HashSet::new();
        let mut solids = HashSet::new();
        while let Some((node, state)) = todo.pop() {
            let descent = self.descend(node, state, Stop::AmongParts);
            match (descent.bare_union(), descent.end) {
                (Some((a, b, state)), _) => todo.extend([(b, state), (a, state)]),
                (None, End::Nothing) => {}
                (None, _) => {
                    let facts = self.facts[node as usize];
                    let surface = facts.has_surface && state.layer != Layer::Solid;
                    let place = self.sets.place(node);
                    let is_new = if surface {
                        surfaces.insert((place, state.layer))
                    } else {
                        let known = self.sets.is_within(place, &solids);
                        self.sets.add(place, &mut solids);
                        !known
                    };
                    if is_new {
                        out.push((node, state));
                    }
                }
            }
        }
        let out = self.without_repeats(out);
        self.look_for_shared_faces(&out);
        out
    }

    /// Says so where members that look different are made of one and the same solid.
    fn look_for_shared_faces(&mut self, members: &[(NodeId, State)]) {
        if members.len() > MANY {
            return;
        }
        let mut seen: HashMap<_, (Option<Substance>, NodeId, bool)> = HashMap::new();
        for &(node, state) in members {
            if self.facts[node as usize].has_surface {
                continue;
            }
            let substance = self.substance(node, state);
            let place = self.sets.place(node);
            let parts = self.sets.parts(place);
            let differing: HashSet<_> = (parts.iter())
                .filter_map(|p| seen.get(p))
                .filter(|known| known.0.is_none() || known.0 != substance)
                .map(|&(_, owner, clear)| (owner, clear))
                .collect();
            // Those that fill a hole are made larger than that.
            let is_plug = |&(owner, clear): &(NodeId, bool)| {
                clear && !self.plug(node, &[owner]).held.is_empty()
            };
            if !differing.iter().all(is_plug) {
                self.faces_in_one_place(self.ids[node as usize]);
            }
            let clear = self.cut_open || self.is_transparent(node, state.look);
            for part in parts {
                seen.entry(part).or_insert((substance, node, clear));
            }
        }
    }

    /// Says that faces of an object lie in those of another; 0 is nobody's object.
    pub fn faces_in_one_place(&mut self, id: u32) {
        let doubt = match id {
            0 => Complaint::term("which is seen is up to rounding"),
            id => Complaint::new("fidelity-rounding").with("id", id.to_string()),
        };
        let known = |e: &crate::translate::fidelity::Entry| e.feature == FACES;
        if !self.report.entries().any(known) {
            self.report.state(FACES, Fidelity::Approximate(doubt), "");
        }
    }

    /// Leaves out what is within a later member of the same look and medium.
    fn without_repeats(&mut self, members: Vec<(NodeId, State)>) -> Vec<(NodeId, State)> {
        let mut later: HashMap<_, HashSet<_>> = HashMap::new();
        let mut out = Vec::with_capacity(members.len());
        for (node, state) in members.into_iter().rev() {
            let substance = self.substance(node, state);
            if let Some(substance) = substance
                && !self.facts[node as usize].has_surface
            {
                let place = self.sets.place(node);
                let set = later.entry((substance, state.layer)).or_default();
                if self.sets.is_within(place, set) {
                    continue;
                }
                self.sets.add(place, set);
            }
            out.push((node, state));
        }
        out.reverse();
        out
    }

    /// Leaves out operands of an intersection that hold another one: they take nothing away, and have
    /// faces where that one has. Those are the first one's, unless both are of one look and medium.
    fn without_wider(&mut self, mut members: Vec<(NodeId, State)>) -> Vec<(NodeId, State)> {
        if members.len() > FEW || members.iter().any(|m| self.facts[m.0 as usize].has_surface) {
            return members;
        }
        let mut i = 0;
        while i < members.len() {
            let (node, state) = members[i];
            let own = self.substance(node, state);
            let (mut held, mut doubtful) = (false, false);
            for (j, &(other, state)) in members.iter().enumerate() {
                if j != i && self.is_within(other, &[node]) {
                    let alike = own.is_some() && own == self.substance(other, state);
                    held |= alike || j < i;
                    doubtful |= !alike && j > i;
                }
            }
            if held {
                members.remove(i);
                continue;
            }
            if doubtful {
                self.faces_in_one_place(self.ids[node as usize]);
            }
            i += 1;
        }
        members
    }

    /// Whether a node's solid is certainly part of one of others.
    pub fn is_within(&mut self, node: NodeId, others: &[NodeId]) -> bool {
        let mut set = HashSet::new();
        for other in others {
            let place = self.sets.place(*other);
            self.sets.add(place, &mut set);
        }
        let place = self.sets.place(node);
        self.sets.is_within(place, &set)
    }

    /// Gives the tools among the operands of an intersection, the complements, room outside of what
    /// all others hold.
    fn with_room(&mut self, mut members: Vec<(NodeId, State)>) -> Vec<(NodeId, State)> {
        let cut = (members.iter()).fold(Aabb::ALL, |cut, m| cut.intersection(&self.box_of(m.0)));
        for (node, state) in &mut members {
            if self.box_of(*node) == Aabb::ALL {
                state.flush = state.flush.or(self.flush(*node, cut));
            }
        }
        members
    }

    pub fn flat_intersection(
        &mut self,
        a: NodeId,
        b: NodeId,
        state: State,
    ) -> Vec<(NodeId, State)> {
        let mut todo = vec![(b, state), (a, state)];
        let mut out = Vec::new();
        while let Some((node, state)) = todo.pop() {
            match self
                .descend(node, state, Stop::AtShared)
                .bare_intersection()
            {
                Some((a, b, state)) => todo.extend([(b, state), (a, state)]),
                None => out.push((node, state)),
            }
        }
        out
    }

    /// Whether any of a node lets light through.
    pub fn is_transparent(&self, node: NodeId, look: Look) -> bool {
        match look {
            Look::Above { transparent } => transparent,
            Look::Own {
                optics: Some(o), ..
            } => self.aspects.is_transparent(o),
            Look::Own { optics: None, .. } => self.facts[node as usize].transparent,
        }
    }

    pub fn box_of(&self, node: NodeId) -> Aabb {
        self.bounds[node as usize].all
    }

    /// States what the scene has that the objects have not.
    pub fn report_what_is_left(&mut self) {
        if self.unseen_twice {
            self.report.state(
                "depth of rays in parts that others surround",
                Fidelity::approximate("light that is mirrored there takes two steps more"),
                "",
            );
        }
        let is_left = |pair: &[u32; 2]| !pair.iter().any(|shape| self.longer.contains(shape));
        let mut flush = contacts::pairs(self.scene, &self.bounds).into_iter();
        if let Some([shape, _]) = flush.find(is_left) {
            self.faces_in_one_place(self.scene.shapes[shape as usize].id);
        }
        if !self.longer.is_empty() {
            let note = "made longer, where nobody sees them";
            let tools = "solids that end flush with others";
            self.report.state(tools, Fidelity::Exact, note);
        }
        let drawn = |node| (self.facts.get(node as usize)).is_some_and(|f| f.uses > 0);
        let left_out = volumes::left_out(self.scene, &self.volumes, drawn);
        if !left_out.is_empty() {
            let ids: Vec<String> = left_out.iter().take(8).map(u32::to_string).collect();
            let more = match left_out.len() > ids.len() {
                true => ", …",
                false => "",
            };
            let ids = Complaint::new("fidelity-volumes").with("ids", ids.join(", ") + more);
            let volumes = "bounding volumes left out";
            self.report.state(volumes, Fidelity::Exact, ids);
        }
    }

    pub fn media_are_approximate(&mut self) {
        self.report.count(
            "operations on media of different index",
            Fidelity::approximate(
                "light that goes through faces between the media may take another way, and show another picture",
            ),
            "an object has one index there",
        );
    }
}

/// So many parts of a scene are looked at for one that holds a camera.
const PARTS: usize = 256;

/// Whether a camera is in a solid that lets no light through: it sees faces that are inside of others.
fn camera_is_walled_in(scene: &Scene, facts: &[Facts], aspects: &Aspects) -> bool {
    let Some(render) = scene.render else {
        return false;
    };
    scene
        .chosen_cameras()
        .any(|c| is_walled_in(scene, (facts, aspects), render.root, c.position.into()))
}

fn is_walled_in(
    scene: &Scene,
    (facts, aspects): (&[Facts], &Aspects),
    root: NodeId,
    point: Vec3,
) -> bool {
    let mut todo = vec![(root, point)];
    for _ in 0..PARTS {
        let Some((node, point)) = todo.pop() else {
            return false;
        };
        if !members(scene, node, point).is_ok_and(|m| m.in_root) {
            continue;
        }
        let optics = facts[node as usize].optics;
        match scene.nodes[node as usize] {
            _ if optics.uniform => {
                if !aspects.is_transparent(optics.first) {
                    return true;
                }
            }
            Node::Union(a, b) => todo.extend([(a, point), (b, point)]),
            Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push((child, point)),
            Node::Transform { child, matrix } => {
                let Some(back) = scene.matrices[matrix as usize].inverse() else {
                    return true;
                };
                todo.push((child, back.point(point.0).into()));
            }
            _ => return true,
        }
    }
    true
}

/// The state of a part whose medium something around it gives.
pub(super) fn inside_medium(state: State) -> State {
    state.medium(Medium::Above)
}

/// For each node by how much all lengths grow from the scene's coordinates to those that the node is placed
/// in, as a power of two; where it is in several places, the most.
fn stretches(scene: &Scene, root: NodeId) -> Vec<f64> {
    let mut out = vec![0.0; root as usize + 1];
    out[root as usize] = 1.0;
    for id in (0..=root as usize).rev() {
        let own: f64 = out[id];
        let below = match scene.nodes[id] {
            Node::Transform { matrix, .. } => {
                let factor = stretched(&scene.matrices[matrix as usize]).unwrap_or(1.0);
                Some(own * factor).filter(|f| f.is_finite()).unwrap_or(own)
            }
            _ => own,
        };
        for child in scene.nodes[id].children().into_iter().flatten() {
            out[child as usize] = below.max(out[child as usize]);
        }
    }
    // What is a power of two but for rounding stays that.
    let about = |factor: f64| match factor > 0.0 {
        true => power_of_two_about(1.9 * factor),
        false => 0.0,
    };
    out.into_iter().map(about).collect()
}
