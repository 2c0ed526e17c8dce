//! Objects as text: every object is declared before it is used, operands first, without recursion
//! on the depth of the scene.

use std::collections::{BTreeSet, HashMap};

use super::build::Builder;
use super::changes::Change;
use super::piece::{Body, Group, Key, Modifier, Piece, State};
use super::shape::{self, Primitive, primitive};
use super::text::{commented, number, transformation, vector};
use super::triangle;
use crate::scene::{Geometry, NodeId, Rgb, TriangleNormals, Volume};
use crate::syntax::Captions;
use crate::translate::fidelity::Fidelity;
use crate::translate::names;

/// What there is to do: look what a key needs, or write it, once that is written.
enum Step {
    Visit(Key),
    Write(Key, Piece),
}

/// A piece within this many characters stands on one line.
const WIDE: usize = 100;

/// The declarations of all objects, and the names they go by.
pub(super) struct Emitter<'b, 'a> {
    builder: &'b mut Builder<'a>,
    captions: &'b Captions,
    pub text: String,
    names: HashMap<Key, Option<String>>,
    /// The name of each object by what is said of it.
    bodies: HashMap<String, String>,
    /// The numbers of splits that geodesic spheres were written with.
    pub geodesics: BTreeSet<u32>,
    /// All of space was written.
    pub everywhere: bool,
    /// How many objects of each entity there are.
    times: HashMap<u32, u32>,
}

impl<'b, 'a> Emitter<'b, 'a> {
    pub fn new(builder: &'b mut Builder<'a>, captions: &'b Captions) -> Emitter<'b, 'a> {
        Emitter {
            builder,
            captions,
            text: String::new(),
            names: HashMap::new(),
            bodies: HashMap::new(),
            geodesics: BTreeSet::new(),
            everywhere: false,
            times: HashMap::new(),
        }
    }

    /// Declares the object of the root; its name, unless there is nothing in it.
    pub fn declare(&mut self, root: NodeId) -> Option<String> {
        let root = Key {
            node: root,
            state: State::ROOT,
        };
        let mut todo = vec![Step::Visit(root)];
        while let Some(step) = todo.pop() {
            match step {
                Step::Visit(key) => {
                    if self.names.contains_key(&key) {
                        continue;
                    }
                    self.names.insert(key, None);
                    let piece = self.builder.definition(key);
                    let mut needs = Vec::new();
                    let Some(piece) = piece else { continue };
                    piece.for_each_declared(&mut |k| needs.push(Step::Visit(k)));
                    todo.push(Step::Write(key, piece));
                    todo.extend(needs.into_iter().rev());
                }
                Step::Write(key, piece) => {
                    let body = self.piece(&piece, 0);
                    let body = self.bounded(body, key);
                    // States that differ need not look different.
                    if let Some(name) = self.bodies.get(&body) {
                        self.names.insert(key, Some(name.clone()));
                        continue;
                    }
                    let name = self.name(piece.id);
                    let scene = self.builder.scene;
                    let comment = names::comment(scene, self.captions, key.node, piece.id);
                    let text = format!("#declare {name} = {body}");
                    self.bodies.insert(body, name.clone());
                    self.text += &match comment {
                        Some(comment) => commented(&text, &comment),
                        None => text,
                    };
                    self.text.push('\n');
                    self.names.insert(key, Some(name));
                }
            }
        }
        self.names.get(&root).cloned().flatten()
    }

    /// Whether nothing is in a declared object.
    fn is_empty(&self, piece: &Piece) -> bool {
        match piece.body {
            Body::Declared(key) => self.names.get(&key).is_none_or(Option::is_none),
            _ => false,
        }
    }

    /// An object with the bounding volume that it is promised to lie in.
    fn bounded(&mut self, body: String, key: Key) -> String {
        let flush = key.state.flush.is_some();
        let volume = self.builder.volumes.get_mut(&key.node).filter(|_| !flush);
        let Some((volume, written)) = volume else {
            return body;
        };
        *written = true;
        let volume = match volume {
            Volume::Box { min, max } => format!("box {{ {}, {} }}", vector(min), vector(max)),
            Volume::Sphere { centre, radius } => {
                format!("sphere {{ {}, {} }}", vector(centre), number(*radius))
            }
        };
        let inner = body.strip_suffix('}').unwrap_or(&body).trim_end();
        match body.contains('\n') {
            true => format!("{inner}\n  bounded_by {{ {volume} }}\n}}"),
            false => format!("{inner} bounded_by {{ {volume} }} }}"),
        }
    }

    fn name(&mut self, id: u32) -> String {
        let times = self.times.entry(id).or_insert(0);
        *times += 1;
        match (id, *times) {
            (0, n) => format!("Part_{n}"),
            (id, 1) => format!("Object_{id}"),
            (id, n) => format!("Object_{id}_{n}"),
        }
    }

    /// A piece as text. Groups nest a few levels deep at most.
    fn piece(&mut self, piece: &Piece, depth: usize) -> String {
        let (keyword, body) = match &piece.body {
            Body::Shape(shape, flush) => {
                let geometry = &self.builder.scene.shapes[*shape as usize].geometry;
                let changes = &self.builder.changes;
                let changed = flush.and_then(|f| changes.changed(f, geometry));
                let other = match self.builder.turned.get(shape) {
                    Some(true) => triangle::turned(geometry),
                    _ => changed,
                };
                let geometry = other.as_ref().unwrap_or(geometry);
                // What the primitives of two shapes need besides.
                match geometry {
                    Geometry::GeodesicSphere { splits, .. } => {
                        self.geodesics.insert(*splits);
                    }
                    Geometry::Triangle {
                        normals: TriangleNormals::PerVertex(n),
                        ..
                    } if !triangle::are_equally_long(n) => {
                        let fidelity = Fidelity::approximate(triangle::BOUND);
                        let report = &mut self.builder.report;
                        report.count("vertex normals of different length", fidelity, "a mesh");
                    }
                    _ => {}
                }
                let plate = flush.and_then(|f| changes.plate(f));
                let plate = plate.and_then(|(by, _)| shape::plate(geometry, by));
                let Primitive { keyword, lines } = plate.unwrap_or_else(|| primitive(geometry));
                (keyword, lines)
            }
            Body::Declared(key) => match self.names.get(key).cloned().flatten() {
                Some(name) => ("object", vec![name]),
                // Nothing was in it.
                None => ("union", Vec::new()),
            },
            Body::Everything => {
                self.everywhere = true;
                ("object", vec!["Everywhere".to_owned()])
            }
            Body::Group { kind, members } => {
                let mut lines = Vec::with_capacity(members.len());
                for (i, member) in members.iter().enumerate() {
                    let adds = match kind {
                        Group::Union | Group::Merge => true,
                        Group::Difference | Group::CutawayDifference => i > 0,
                        Group::Intersection => member.modifiers.contains(&Modifier::Inverse),
                    };
                    if adds && self.is_empty(member) {
                        continue;
                    }
                    let mut line = self.piece(member, depth + 1);
                    if let Some(id) = self.unnamed(member) {
                        let mut comment = match self.captions.own(id) {
                            Some(words) => format!("{id}, {words}"),
                            None => id.to_string(),
                        };
                        if let Body::Shape(_, Some(change)) = member.body {
                            comment += match self.builder.changes.get(change) {
                                Change::Longer(_)
                                | Change::Sides(..)
                                | Change::Both(..)
                                | Change::Planes(_)
                                | Change::Within(..) => LONGER,
                                Change::Offset(by) | Change::One(by, _) if by < 0.0 => {
                                    ": a hair smaller"
                                }
                                Change::Offset(_) | Change::One(..) | Change::Skin(..) => {
                                    ": a hair larger"
                                }
                                Change::Plate(..) => ": a hair thick",
                            };
                        }
                        line = commented(&line, &comment);
                    }
                    lines.push(line);
                }
                if *kind == Group::CutawayDifference {
                    lines.push("cutaway_textures".to_owned());
                }
                (group_keyword(*kind), lines)
            }
        };
        let modifiers = self.modifiers(&piece.modifiers, depth);
        let flat = !matches!(piece.body, Body::Group { .. })
            && !modifiers.iter().any(|m| m.contains('\n'))
            && modifiers.iter().map(String::len).sum::<usize>()
                + body.iter().map(String::len).sum::<usize>()
                < WIDE;
        let parts = body.into_iter().chain(modifiers);
        if flat {
            let parts: Vec<String> = parts.collect();
            return format!("{keyword} {{ {} }}", parts.join(" "));
        }
        let indent = "  ".repeat(depth);
        let mut text = format!("{keyword} {{\n");
        for part in parts {
            text.push_str(&format!("{indent}  {part}\n"));
        }
        text.push_str(&format!("{indent}}}"));
        text
    }

    /// The entity that a member of a group comes from, unless its name says so.
    fn unnamed(&self, member: &Piece) -> Option<u32> {
        let named = match member.body {
            Body::Shape(..) => 0,
            Body::Declared(key) => self.builder.ids[key.node as usize],
            Body::Everything | Body::Group { .. } => return None,
        };
        (member.id != 0 && member.id != named).then_some(member.id)
    }

    /// An index that is written.
    fn refraction(&mut self, index: u32) -> Rgb {
        let written = self.builder.aspects.index(index);
        self.builder.refractive |= written != [1.0; 3];
        written
    }

    fn modifiers(&mut self, modifiers: &[Modifier], depth: usize) -> Vec<String> {
        let mut out = Vec::with_capacity(modifiers.len());
        for modifier in modifiers {
            out.push(match modifier {
                Modifier::Matrix(m) => transformation(m),
                Modifier::Look(look) => {
                    format!("texture {{ {} }}", self.builder.looks.name(*look))
                }
                Modifier::Behind(look) => {
                    format!("interior_texture {{ {} }}", self.builder.looks.name(*look))
                }
                Modifier::Interior(index) => match self.refraction(*index) {
                    [r, g, b] if r == g && g == b => {
                        format!("interior {{ ior {} }}", number(r))
                    }
                    eta => {
                        self.builder.dispersive = true;
                        let [r, g, b] = eta.map(number);
                        format!(
                            "interior {{ ior (Channel = 0 ? {r} : (Channel = 1 ? {g} : {b})) }}"
                        )
                    }
                },
                Modifier::Unseen => "texture { Unseen }".to_owned(),
                Modifier::UnseenWithin => "interior_texture { Unseen }".to_owned(),
                Modifier::Inverse => "inverse".to_owned(),
                // Nothing is in it: all is outside.
                Modifier::Clip { by, outside: true } if self.is_empty(by) => continue,
                Modifier::Clip { by, outside } => {
                    let by = Piece::clone(by);
                    // What is turned inside out by `inverse` keeps its bounds there, unless it is one of
                    // the simplest shapes, and POV-Ray takes them for those of something without end
                    // that is clipped.
                    let by = match outside {
                        true => {
                            let members = vec![Piece::new(Body::Everything, 0), by];
                            Piece::group(Group::Difference, members)
                        }
                        false => by,
                    };
                    format!("clipped_by {{ {} }}", self.piece(&by, depth + 1))
                }
            });
        }
        out
    }
}

const LONGER: &str = ": made longer, since it ends flush with something";

fn group_keyword(kind: Group) -> &'static str {
    match kind {
        Group::Union => "union",
        Group::Merge => "merge",
        Group::Intersection => "intersection",
        Group::Difference | Group::CutawayDifference => "difference",
    }
}
