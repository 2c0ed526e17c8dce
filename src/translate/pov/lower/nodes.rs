//! Objects that nodes become: which are declared, and what each consists of.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use super::descend::{End, Stop};
use super::triangle;
use super::volumes::{self, Volumes};
use crate::diagnostics::Complaint;
use crate::scene::{Geometry, NodeId, TriangleNormals};
use crate::solids::contacts;
use crate::solids::shapes::facts::Facts as _;
use crate::syntax::Captions;
use crate::translate::fidelity::Fidelity;
use crate::translate::names;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::state::{Appearance, Key, State};
use crate::translate::pov::model::tables::{DEFAULT, PROFILE, TextureUse};
use crate::translate::pov::separate::backward_normals::with_normals_turned;
use crate::translate::pov::separate::plates;
use crate::translate::pov::tree::{Body, Declaration, Modifier, Object};

/// Makes the objects of a model.
pub(super) struct Lower<'a> {
    pub model: Model<'a>,
    captions: &'a Captions,
    /// The bounding volumes that are proved to hold their objects.
    volumes: Volumes,
    /// The triangles whose normals turn away from the eye somewhere, by shape, and whether the normals have to be
    /// turned to the eye's side.
    backward: HashMap<u32, bool>,
    /// Shapes that were made longer.
    longer: HashSet<u32>,
}

impl<'a> Lower<'a> {
    pub(super) fn new(
        model: Model<'a>,
        captions: &'a Captions,
        backward: HashMap<u32, bool>,
    ) -> Lower<'a> {
        Lower {
            volumes: volumes::proved(model.scene, &model.bounds),
            model,
            captions,
            backward,
            longer: HashSet::new(),
        }
    }

    /// All objects that the scene consists of: each behind those it is made of, the root's last.
    pub(super) fn objects(&mut self, root: NodeId) -> Vec<Declaration<'a>> {
        enum Step<'a> {
            Visit(usize),
            Write(usize, Declaration<'a>),
        }
        self.model.refer(root, State::ROOT);
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
                    let mut declaration = self.declaration(self.model.key(number));
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
                    declaration.object.each(&mut |part| {
                        if let Body::Declared(number) = &mut part.body {
                            *number = places[number];
                        }
                    });
                    places.insert(number, objects.len());
                    objects.push(declaration);
                }
            }
        }
        objects
    }

    fn declaration(&mut self, key: Key) -> Declaration<'a> {
        let id = self.model.ids[key.node as usize];
        let mut object = self.definition(key);
        // References to nodes give way to the nodes' objects: a shape is written out, and an operation is declared
        // before.
        object.each(&mut |part| {
            if let Body::Declared(number) = part.body {
                let resolved = self.inline(number);
                part.body = resolved.body;
                part.modifiers.splice(..0, resolved.modifiers);
                part.comment = resolved.comment;
            }
        });
        if key.state.flush.is_none()
            && let Some((volume, written)) = self.volumes.get_mut(&key.node)
        {
            *written = true;
            object.modifiers.push(Modifier::Bound(*volume));
        }
        object.comment = names::comment(self.model.scene, self.captions, key.node, id);
        Declaration {
            id,
            name: String::new(),
            object,
        }
    }

    /// The object that a key is declared as.
    fn definition(&mut self, key: Key) -> Object<'a> {
        let descent = self.model.descend(key.node, key.state, Stop::BelowStart);
        match descent.end {
            End::Shape(shape, state) => {
                let id = self.model.ids[key.node as usize];
                self.shape(shape, state, descent.modifiers, id)
            }
            end => {
                let body = self.model.body(&end).unwrap_or(Object::nothing());
                body.with(descent.modifiers)
            }
        }
    }

    fn inline(&mut self, number: usize) -> Object<'a> {
        let Key { node, state } = self.model.key(number);
        let descent = self.model.descend(node, state, Stop::AtShared);
        let id = self.model.ids[node as usize];
        let mut object = match descent.end {
            End::Nothing => return Object::nothing(),
            End::Everything => Object::new(Body::Everything),
            End::Shape(shape, state) => return self.shape(shape, state, descent.modifiers, id),
            End::Shared(key) => self.model.refer(key.node, key.state),
            _ => return Object::new(Body::Declared(number)),
        };
        if let End::Shared(key) = descent.end
            && id != 0
            && id != self.model.ids[key.node as usize]
        {
            object.comment = Some(self.caption(id));
        }
        object.with(descent.modifiers)
    }

    /// The scene's name of an entity.
    fn caption(&self, id: u32) -> String {
        match self.captions.own(id) {
            Some(words) => format!("{id}, {words}"),
            None => id.to_string(),
        }
    }

    /// The object of a shape, with its texture, its modifiers and its comment. `id` is the entity that the shape
    /// belongs to, 0 for none.
    fn shape(
        &mut self,
        shape: u32,
        state: State,
        modifiers: Vec<Modifier<'a>>,
        id: u32,
    ) -> Object<'a> {
        let scene = self.model.scene;
        let record = &scene.shapes[shape as usize];
        let geometry = &record.geometry;
        let change = state.flush.filter(|f| self.applies(*f, geometry));
        if change.is_some_and(|c| self.model.changes.is_longer(c)) {
            self.longer.insert(shape);
        }
        let own = match state.look {
            // A texture that lies on shapes was handed down to here.
            Appearance::Own { texture, optics } => {
                let own = match geometry.character().has_colours {
                    true => TextureUse::here(PROFILE),
                    false => TextureUse::DEFAULT,
                };
                let (texture, optics) = (texture.unwrap_or(own), optics.unwrap_or(DEFAULT));
                self.model.textures.number(texture, optics, Some(shape))
            }
            Appearance::Above { .. } => None,
        };
        let mut all: Vec<_> = own.map(Modifier::Texture).into_iter().collect();
        all.extend(modifiers);
        let texture = all.iter().find_map(|m| match m {
            Modifier::Texture(texture) => Some(*texture),
            _ => None,
        });
        let clear = match texture {
            Some(texture) => self
                .model
                .textures
                .is_transparent(&self.model.tables, texture),
            None => state.look == Appearance::Above { transparent: true },
        };
        let mut body = self.changed(shape, change);
        if let Some((by, index)) = change.and_then(|c| self.model.changes.plate(c)) {
            // Where an object around it gives a plate its look, both sides would have that look, so a transparent
            // surface stays as it is.
            if !clear || texture.is_some() {
                body = plates::plate(geometry, by).unwrap_or(body);
            }
            if clear && texture.is_some() {
                all.push(Modifier::UnseenWithin);
                all.extend((index != DEFAULT).then(|| self.model.index(index)));
            }
        }
        if self.backward.contains_key(&shape) {
            let behind = texture.and_then(|t| self.model.textures.behind(&self.model.tables, t));
            all.extend(behind.map(Modifier::InnerTexture));
        }
        let id = if id == 0 { record.id } else { id };
        let note = change.map_or("", |c| self.model.changes.note(c));
        Object {
            body,
            modifiers: all,
            comment: (id != 0).then(|| self.caption(id) + note),
        }
    }

    /// Whether a change has an effect on a shape.
    fn applies(&self, change: u32, geometry: &Geometry) -> bool {
        match geometry.is_solid() {
            true => self.model.changes.changed(change, geometry).is_some(),
            false => self.model.changes.plate(change).is_some() && geometry.character().is_flat,
        }
    }

    /// The body of a shape with a change, in a form that POV-Ray can draw.
    fn changed(&mut self, shape: u32, change: Option<u32>) -> Body<'a> {
        let geometry = &self.model.scene.shapes[shape as usize].geometry;
        let other = match self.backward.get(&shape) {
            Some(true) => with_normals_turned(geometry),
            _ => change.and_then(|c| self.model.changes.changed(c, geometry)),
        };
        let geometry = other.map_or(Cow::Borrowed(geometry), Cow::Owned);
        if let Geometry::Triangle { vertices, normals } = &*geometry
            && let TriangleNormals::PerVertex(normals) = normals
            && !triangle::are_equally_long(normals)
        {
            let fidelity = Fidelity::approximate(triangle::BOUND);
            self.model
                .report
                .count("vertex normals of different length", fidelity, "a mesh");
            return Body::Mesh(triangle::cut(vertices, normals, self.model.budget));
        }
        Body::Shape(geometry)
    }

    /// Reports differences between the scene and the finished objects: faces that are still in one place, solids that
    /// were made longer, and bounding volumes that were left out.
    pub(super) fn report_what_is_left(&mut self) {
        let is_left = |pair: &[u32; 2]| !pair.iter().any(|shape| self.longer.contains(shape));
        let mut flush = contacts::pairs(self.model.scene, &self.model.bounds).into_iter();
        if let Some([shape, _]) = flush.find(is_left) {
            self.model
                .faces_in_one_place(self.model.scene.shapes[shape as usize].id);
        }
        if !self.longer.is_empty() {
            let note = "made longer, where nobody sees them";
            let tools = "solids that end flush with others";
            self.model.report.state(tools, Fidelity::Exact, note);
        }
        let drawn = |node| (self.model.materials.get(node as usize)).is_some_and(|f| f.uses > 0);
        let left_out = volumes::left_out(self.model.scene, &self.volumes, drawn);
        if !left_out.is_empty() {
            let ids: Vec<String> = left_out.iter().take(8).map(u32::to_string).collect();
            let more = match left_out.len() > ids.len() {
                true => ", …",
                false => "",
            };
            let ids = Complaint::new("fidelity-volumes").with("ids", ids.join(", ") + more);
            let volumes = "bounding volumes left out";
            self.model.report.state(volumes, Fidelity::Exact, ids);
        }
    }
}
