//! The pass over a tree, in file order, that gives every ID its meaning.

use std::path::Path;

use super::background;
use super::checks;
use super::entity::{State, Values};
use super::model::*;
use super::record::Params;
use super::references::{Lost, References};
use crate::diagnostics::{
    Applicability, Code, Diagnostic, Edit, Fix, Severity, SourceFile, Span, Value,
};
use crate::syntax::ast::{Broken, Fault};
use crate::syntax::ids::IdTable;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};
use crate::syntax::{self, Document, Item, Record};

/// Reads a tree as a program of assignments. `diagnostics` holds the parser's findings. The resolver adds its own, and
/// completes the findings about broken records: it knows which IDs and types may be meant.
///
/// The scene holds whatever could be read; it is whole only if there are no errors.
pub fn resolve(
    document: &Document,
    source: &SourceFile,
    diagnostics: &mut Vec<Diagnostic>,
) -> Scene {
    resolve_with(document, source, diagnostics, true)
}

/// [`resolve`] with a choice about wrong IDs. `compares`: whether an undefined ID is compared with all others to find
/// the one that was meant, which takes most of the time where many are undefined.
pub fn resolve_with(
    document: &Document,
    source: &SourceFile,
    diagnostics: &mut Vec<Diagnostic>,
    compares: bool,
) -> Scene {
    let text = source.text.as_str();
    // Capacity that is never used takes no memory, whereas moving a list that grows takes time.
    let records = document.items.len();
    let of = |families: &[Family]| (document.contents).count(|ty| families.contains(&ty.family));
    let mut resolver = Resolver {
        document,
        text,
        folder: source.folder(),
        scene: Scene {
            ids: IdTable::new(records),
            nodes: Vec::with_capacity(records),
            origins: Vec::with_capacity(records),
            shapes: Vec::with_capacity(of(&[Family::Shape])),
            matrices: Vec::with_capacity(of(&[Family::Transformation])),
            paints: Vec::with_capacity(of(&[Family::Property, Family::Texture, Family::Colour])),
            entities: Vec::with_capacity(records),
            ..Scene::default()
        },
        states: Vec::with_capacity(records),
        values: Values::default(),
        taken: Vec::with_capacity(records),
        references: References::new(compares),
        has_render: false,
        selection: None,
        late: Vec::new(),
        out: Vec::new(),
    };
    for item in &document.items {
        match item {
            Item::Void { .. } => {}
            Item::Record(record) => {
                resolver.record(record);
                resolver.sign(record);
            }
            Item::Broken(broken) => resolver.broken(broken, diagnostics),
        }
    }
    let scene = resolver.finish(diagnostics);
    crate::diagnostics::sort(diagnostics);
    scene
}

pub(super) struct Resolver<'a> {
    pub(super) document: &'a Document,
    pub(super) text: &'a str,
    pub(super) folder: Option<&'a Path>,
    pub(super) scene: Scene,
    /// The value of each ID, by its number in [`Scene::ids`].
    states: Vec<State>,
    pub(super) values: Values,
    /// For each node, whether an operation, a complement, a copy or a bounding volume uses it.
    pub(super) taken: Vec<bool>,
    pub(super) references: References,
    has_render: bool,
    /// The last camera selection.
    selection: Option<Record>,
    /// Records whose references name entities as these stand at the end of the file.
    late: Vec<Record>,
    pub(super) out: Vec<Diagnostic>,
}

impl<'a> Resolver<'a> {
    fn record(&mut self, record: &Record) {
        let p = Params::new(self.document, self.text, record);
        if !self.reserved_id(record, &p) {
            return;
        }
        let exists = self.exists(p.id);
        match record.ty().effect {
            Effect::Defines(kind) => {
                if self.duplicate(&p) {
                    return;
                }
                let state = match kind {
                    Kind::Undefined => Some(State::Undefined),
                    Kind::Render | Kind::Selection => self.view_record(record, &p),
                    _ => self.definition(&p),
                };
                // A record that could not be read still defines its ID.
                self.define(&p, state.unwrap_or(State::Broken(Some(kind))));
            }
            Effect::Changes(kinds) => self.change(&p, kinds),
            Effect::DefinesOrChanges(_, kinds) if exists => self.change(&p, kinds),
            Effect::DefinesOrChanges(kind, _) => {
                let state = self.new_property(&p);
                self.define(&p, state.unwrap_or(State::Broken(Some(kind))));
            }
        }
    }

    /// Stores the record as the origin of the node that it has just made, if it made one.
    fn sign(&mut self, record: &Record) {
        if self.scene.origins.len() < self.scene.nodes.len() {
            self.scene.origins.push(Origin {
                id: record.id,
                span: self.document.span(record.first, record.last),
            });
        }
    }

    /// The value of an ID.
    pub(super) fn state(&self, id: u32) -> Option<State> {
        self.states.get(self.scene.ids.get(id)? as usize).copied()
    }

    pub(super) fn set_state(&mut self, id: u32, state: State) {
        let next = self.states.len() as u32;
        match self.scene.ids.get_or_insert(id, next) {
            number if number == next => self.states.push(state),
            number => self.states[number as usize] = state,
        }
    }

    /// Adds an entity, and sets the state of its ID from now on.
    fn push(&mut self, entity: Entity, state: State) {
        self.set_state(entity.id, state);
        self.references
            .defined(self.scene.ids.get(entity.id), self.scene.entities.len());
        self.scene.entities.push(entity);
    }

    /// The entity of an ID; the last one if several records define the ID.
    pub(super) fn entity(&self, id: u32) -> Option<&Entity> {
        let index = self.references.entity(self.scene.ids.get(id)?)?;
        self.scene.entities.get(index)
    }

    /// Whether the ID stands for something other than a placeholder.
    fn exists(&self, id: u32) -> bool {
        !matches!(self.state(id), None | Some(State::Undefined))
    }

    fn define(&mut self, p: &Params, state: State) {
        let entity = Entity::new(p.id, state.kind(), p.id_span());
        self.push(entity, state);
    }

    /// Reports E105 if a record other than the render record has ID 1, or the render record has another ID. Returns
    /// whether the ID is right.
    fn reserved_id(&mut self, record: &Record, p: &Params) -> bool {
        let is_render = p.ty.kind == RecordKind::Render;
        if (p.id == 1) == is_render {
            return true;
        }
        let d = if is_render {
            self.has_render = true;
            let d = Diagnostic::new(Code::E105, p.id_span());
            let is_render = |ty: &RecordType| ty.kind == RecordKind::Render;
            match self.document.contents.count(is_render) {
                // The fix depends on what is drawn, which is known only at the end of the file.
                0 | 1 => {
                    self.late.push(*record);
                    return false;
                }
                // No fix: there is another render record, and with ID 1 this one would define the ID again.
                _ => d.case("again"),
            }
        } else {
            Diagnostic::new(Code::E105, p.id_span())
                .case("other")
                .with("type", Value::Term(p.ty.title))
        };
        self.out.push(d);
        false
    }

    /// Reports E102 if the record defines an ID that is already defined. Returns whether it does.
    fn duplicate(&mut self, p: &Params) -> bool {
        let Some(state) = self.state(p.id) else {
            return false;
        };
        // An ID that is a placeholder may be defined, and so may one whose record is broken.
        if matches!(state, State::Undefined | State::Broken(_))
            && p.ty.kind != RecordKind::Undefined
        {
            return false;
        }
        let property = matches!(
            state,
            State::Optics(_) | State::Texture(_) | State::Colour(_)
        );
        let bears = matches!(
            p.ty.effect,
            Effect::Defines(Kind::Object | Kind::AmbientLight | Kind::PointLight)
        );
        let too_early = property && bears;
        let mut d = Diagnostic::new(Code::E102, p.id_span())
            .case(match p.ty.kind {
                _ if too_early => "property",
                RecordKind::Render => "render",
                _ => "",
            })
            .with("id", p.id.to_string())
            .with("type", Value::Term(p.ty.title));
        if too_early {
            // The records that follow may be meant for the property or for the new object.
            self.set_state(p.id, State::Broken(None));
        }
        if let Some(e) = self.entity(p.id) {
            d = d.label(e.span, "first");
        }
        self.out.push(d);
        true
    }

    /// Keeps a render record or camera selection for the end of the file, and returns its state.
    fn view_record(&mut self, record: &Record, p: &Params) -> Option<State> {
        self.late.push(*record);
        if p.ty.kind == RecordKind::Render {
            self.has_render = true;
            Some(State::Render)
        } else {
            self.selection = Some(*record);
            Some(State::Selection)
        }
    }

    fn broken(&mut self, broken: &Broken, diagnostics: &mut [Diagnostic]) {
        self.has_render |= broken.kind == Some(RecordKind::Render) || broken.id == Some(1);
        if broken.fault == Fault::UnknownType {
            self.propose_type(broken, diagnostics);
        }
        // A line without numbers is no record, so it has lost no ID.
        let mut tokens = self.document.significant(broken.first, broken.last);
        if broken.fault == Fault::LostId && tokens.any(|t| t.kind().is_number()) {
            let operation = broken.ty().is_some_and(|t| t.family == Family::Operation);
            let names = self.document.significant(broken.first, broken.last);
            let names = names.filter_map(|t| u32::try_from(t.integer(self.text)?).ok());
            self.references.lost.push(Lost {
                ty: broken.ty(),
                span: self.document.tokens[broken.first as usize].span(),
                names: names.filter(|_| operation).collect(),
            });
        }
        let Some(id) = broken.id else { return };
        if self.exists(id) {
            return;
        }
        let kind = broken.ty().and_then(|t| match t.effect {
            Effect::Defines(kind) | Effect::DefinesOrChanges(kind, _) => Some(kind),
            Effect::Changes(_) => None,
        });
        let span = self.document.tokens[broken.first as usize].span();
        let entity = Entity::new(id, kind, span);
        // With a wrong number of parameters the type may be wrong too, so references are not judged by its kind.
        let certain = broken.fault != Fault::Arity;
        self.push(entity, State::Broken(kind.filter(|_| certain)));
    }

    fn finish(mut self, diagnostics: &mut Vec<Diagnostic>) -> Scene {
        for record in std::mem::take(&mut self.late) {
            self.late_record(&record);
        }
        if !self.has_render {
            let end = self.text.trim_end().len() as u32;
            let at = Span::new(end, end);
            let finding = Diagnostic::new(Code::E106, at).severity(Severity::Warning);
            let is_sound = !diagnostics
                .iter()
                .chain(&self.out)
                .any(Diagnostic::is_error);
            self.out.push(match self.only_root().filter(|_| is_sound) {
                Some(id) => {
                    let of = background::meant(self.document, self.text, &self.scene.entities);
                    let of = of.map_or(0, |b| b.id);
                    let record = format!("1 {} {id} {of}", RecordType::of(RecordKind::Render).code);
                    let fix = Fix::replace("fix", Applicability::Unsafe, at, format!("\n{record}"));
                    finding.fix(fix.with("text", syntax::quote(&record)))
                }
                None => finding,
            });
        }
        References::settle(&mut self, diagnostics);
        for i in 0..self.scene.entities.len() {
            // A placeholder and the later definition of its ID are two entities with one state, which the first one
            // gets.
            let Some(number) = self.scene.ids.get(self.scene.entities[i].id) else {
                continue;
            };
            let state = std::mem::replace(&mut self.states[number as usize], State::Stored);
            if !matches!(state, State::Stored) {
                self.store(i, state);
            }
        }
        if matches!(self.scene.view, View::Automatic) && !self.scene.cameras.is_empty() {
            self.scene.view = View::Mono(self.scene.cameras.len() - 1);
        }
        diagnostics.append(&mut self.out);
        self.scene
    }

    /// The only object that is no part of another one. `None` if there are several, or none.
    fn only_root(&self) -> Option<u32> {
        let ids = self.scene.entities.iter().map(|e| e.id);
        let is_root = |id: &u32| match self.state(*id) {
            Some(State::Object(node)) => !self.taken[node as usize],
            _ => false,
        };
        let mut roots = ids.filter(is_root);
        roots.next().filter(|root| roots.all(|id| id == *root))
    }

    /// Reports E105 for the only render record, whose ID is not 1. The fix writes ID 1; if ID 1 is what the record
    /// draws and its own ID is an object, the fix swaps the two. Returns whether the references of the record are to be
    /// checked.
    fn other_render_id(&mut self, p: &Params) -> bool {
        let id = p.id.to_string();
        let d = Diagnostic::new(Code::E105, p.id_span());
        let is_object = matches!(self.state(p.id), Some(State::Object(_)));
        if p.integer(0) != 1 || !is_object {
            let fix = Fix::replace("fix", Applicability::Safe, p.id_span(), "1");
            self.out.push(d.fix(fix));
            return true;
        }
        let number = syntax::quote(&format!("1 {} {id}", p.ty.code));
        let edit = |span: Span, text: &str| Edit {
            span,
            text: text.to_owned(),
        };
        let edits = vec![edit(p.id_span(), "1"), edit(p.span_of(0, 1), &id)];
        let fix = Fix::guess("fix-write", edits).with("number", number);
        let fix = Fix {
            applicability: Applicability::Safe,
            ..fix
        };
        self.out.push(d.case("swapped").with("id", id).fix(fix));
        false
    }

    /// Checks and stores a render record or camera selection, whose references mean the values at the end of the file.
    fn late_record(&mut self, record: &Record) {
        let p = Params::new(self.document, self.text, record);
        if p.ty.kind == RecordKind::Render && p.id != 1 && !self.other_render_id(&p) {
            return;
        }
        let targets: Vec<Option<u32>> = (0..record.ty().params.len())
            .map(|i| self.reference(&p, i, true).flatten())
            .collect();
        if p.ty.kind == RecordKind::Render {
            let clip = match p.len() > 2 {
                true => {
                    checks::ordered(&p, 2, 3, &mut self.out).map(|()| (p.numbers(2), p.numbers(5)))
                }
                false => None,
            };
            let background = targets[1].and_then(|id| self.state(id));
            if let Some(root_id) = targets[0]
                && let Some(State::Object(root)) = self.state(root_id)
            {
                self.scene.render = Some(Render {
                    root,
                    root_id,
                    background: match background {
                        Some(State::Colour(at)) => self.values.colours[at as usize],
                        _ => [0.0; 3],
                    },
                    clip,
                    span: p.span(),
                });
            }
            return;
        }
        if self.selection.is_none_or(|s| s.first != record.first) {
            return;
        }
        let cameras: Option<Vec<usize>> = targets
            .iter()
            .map(|t| t.and_then(|id| self.camera_position(id)))
            .collect();
        match cameras.as_deref() {
            Some(&[camera]) => self.scene.view = View::Mono(camera),
            Some(&[left, right]) => self.scene.view = View::Stereo { left, right },
            _ => {}
        }
    }

    /// Index that a camera will have in [`Scene::cameras`]: cameras are stored in the order of definition.
    fn camera_position(&self, id: u32) -> Option<usize> {
        let cameras = self.scene.entities.iter().filter(|e| {
            e.kind == Some(Kind::Camera) && matches!(self.state(e.id), Some(State::Camera(_)))
        });
        cameras.into_iter().position(|e| e.id == id)
    }

    /// Moves the final state of an entity into the scene.
    fn store(&mut self, index: usize, state: State) {
        let (scene, values) = (&mut self.scene, &self.values);
        let entity = &mut scene.entities[index];
        entity.kind = state.kind();
        match state {
            State::Object(node) => entity.set_node(node),
            State::Camera(at) => scene.cameras.push(values.cameras[at as usize]),
            State::PointLight(at) => scene.point_lights.push(values.point_lights[at as usize]),
            State::AmbientLight(at) => {
                scene
                    .ambient_lights
                    .push(values.ambient_lights[at as usize]);
            }
            _ => {}
        }
    }

    pub(super) fn node(&mut self, node: Node) -> NodeId {
        // A move or a paint goes on from its child. Every other node uses its children as they are.
        if !node.is_change() {
            for child in node.children() {
                self.taken[child as usize] = true;
            }
        }
        self.scene.nodes.push(node);
        self.taken.push(false);
        self.scene.nodes.len() as NodeId - 1
    }
}
