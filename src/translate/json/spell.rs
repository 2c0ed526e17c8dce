//! A model of a scene as records of the language, one record on each line.
//!
//! Records change objects, whereas nodes never change. A node that transforms or paints another one is written as a
//! change of that one's object, if nothing else needs the object as it was; otherwise as a change of a copy. In a
//! scene that was records before, nothing has to be copied: whatever needs a state of an object stands before the
//! change of the state.

use std::collections::{HashMap, HashSet};
use std::fmt::{self, Write};

use super::locate::Path;
use super::model::{self, Item, Node, Rgb, Scene, Texture, Volume};
use crate::diagnostics::Language;
use crate::geometry::Matrix;
use crate::scene::geometry::Parameter;
use crate::syntax::table::{RecordKind, RecordType};

/// The largest ID.
pub(super) const ID_MAX: u32 = i32::MAX as u32;

/// The largest distance of a matrix from a rotation at which the matrix is written without an `allow` comment. It is
/// less than the distance that W303 finds fault with.
const ROTATION_EPS: f64 = 1e-7;

/// An element of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelElement {
    Head,
    Node(u32),
    AmbientLight(u32),
    PointLight(u32),
    Camera(u32),
    View,
    Render,
    Bound(u32),
}

impl ModelElement {
    /// The path to the element.
    pub fn path(self) -> Path {
        let list = |name: &'static str, i: u32| Path::default().name(name).item(i as usize);
        match self {
            ModelElement::Head => Path::default().name("version"),
            ModelElement::Node(i) => list("nodes", i),
            ModelElement::AmbientLight(i) => list("ambient_lights", i),
            ModelElement::PointLight(i) => list("point_lights", i),
            ModelElement::Camera(i) => list("cameras", i),
            ModelElement::View => Path::default().name("view"),
            ModelElement::Render => Path::default().name("render"),
            ModelElement::Bound(i) => list("bounds", i),
        }
    }
}

impl fmt::Display for ModelElement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.path().fmt(f)
    }
}

/// The part of an element that a record spells. Most records tell it by their type; some colours do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Matter {
    /// The part that the record's type tells; `None` for a heading.
    Type(Option<RecordKind>),
    /// A colour of a pattern: 0 for the first, 1 for the second.
    PatternColour(u8),
    /// The colour of the background.
    Background,
}

/// The records of a scene.
#[derive(Debug)]
pub struct Records {
    /// The text, with a record or a heading on each line.
    pub text: String,
    /// The element that each line stands for.
    pub places: Vec<ModelElement>,
    /// The part of the element that each line spells.
    pub matters: Vec<Matter>,
    /// The IDs that were made up, since the model has none, and the elements that got them.
    pub made_up: HashMap<u32, ModelElement>,
}

/// Writes the records that make a scene. The scene has to be valid, as [`read`](super::read()) checks it.
///
/// Headings are in `language`.
pub fn spell(scene: &Scene, language: Language) -> Records {
    let mut speller = Speller::new(scene, language);
    speller.objects();
    speller.lights();
    speller.cameras();
    speller.render();
    if speller.any_matrix {
        let allow = "# zpg: allow(not-a-rotation) #\n";
        speller.text.insert_str(0, allow);
        speller.places.insert(0, ModelElement::Head);
        speller.matters.insert(0, Matter::Type(None));
    }
    Records {
        text: speller.text,
        places: speller.places,
        matters: speller.matters,
        made_up: speller.made_up,
    }
}

struct Speller<'a> {
    scene: &'a Scene,
    language: Language,
    text: String,
    places: Vec<ModelElement>,
    matters: Vec<Matter>,
    made_up: HashMap<u32, ModelElement>,
    /// The element that the next lines stand for.
    place: ModelElement,
    /// The matter of the next colour, if its type does not tell it.
    matter: Option<Matter>,
    ids: HashSet<u32>,
    next_id: u32,
    /// For each node that has been written, the ID of its object.
    holders: Vec<u32>,
    /// For each node, the number of references to it that are still to be written.
    uses: Vec<u32>,
    colours: HashMap<[u64; 3], u32>,
    /// Whether a matrix has been written that is no rotation.
    any_matrix: bool,
}

impl<'a> Speller<'a> {
    fn new(scene: &'a Scene, language: Language) -> Speller<'a> {
        let nodes = scene.nodes.iter().filter_map(|n| n.id);
        let ambient = scene.ambient_lights.iter().filter_map(|l| l.id);
        let points = scene.point_lights.iter().filter_map(|l| l.id);
        let cameras = scene.cameras.iter().filter_map(|c| c.id);
        let ids: HashSet<u32> = nodes.chain(ambient).chain(points).chain(cameras).collect();
        let mut uses = vec![0; scene.nodes.len()];
        let children = scene.nodes.iter().flat_map(|n| n.node.children());
        let render = scene.render.map(|r| r.root);
        for n in children.flatten().chain(render) {
            uses[n as usize] += 1;
        }
        Speller {
            scene,
            language,
            text: String::new(),
            places: Vec::new(),
            matters: Vec::new(),
            made_up: HashMap::new(),
            place: ModelElement::Head,
            matter: None,
            next_id: ids.iter().max().map_or(2, |m| m + 1),
            ids,
            holders: Vec::with_capacity(scene.nodes.len()),
            uses,
            colours: HashMap::new(),
            any_matrix: false,
        }
    }

    /// A new ID that no entity has; notes it in `made_up`.
    fn fresh(&mut self) -> u32 {
        while self.next_id > ID_MAX || !self.ids.insert(self.next_id) {
            self.next_id = if self.next_id >= ID_MAX {
                2
            } else {
                self.next_id + 1
            };
        }
        self.made_up.insert(self.next_id, self.place);
        self.next_id
    }

    /// Writes a record.
    fn record(&mut self, id: u32, kind: RecordKind, params: &[Param]) {
        // Writing to a string cannot fail.
        let _ = write!(self.text, "{id} {}", RecordType::of(kind).code);
        for p in params {
            let _ = match *p {
                Param::Real(x) => write!(self.text, " {x:?}"),
                Param::Integer(n) => write!(self.text, " {n}"),
                Param::Name(name) => write!(self.text, " \"{name}\""),
            };
        }
        self.text.push('\n');
        self.places.push(self.place);
        let own = Matter::Type(Some(kind));
        self.matters.push(self.matter.unwrap_or(own));
    }

    fn heading(&mut self, message: &'static str) {
        let text = self.language.say(message, &[]);
        let _ = writeln!(self.text, "0 # {text} #");
        self.places.push(self.place);
        self.matters.push(Matter::Type(None));
    }

    fn objects(&mut self) {
        let scene = self.scene;
        let mut bounds: Vec<(u32, u32)> = (scene.bounds.iter().zip(0..))
            .map(|(b, i)| (b.node, i))
            .collect();
        bounds.sort_unstable();
        let mut bounds = bounds.into_iter().peekable();
        for (item, i) in scene.nodes.iter().zip(0..) {
            self.place = ModelElement::Node(i);
            let holder = self.node(item);
            self.holders.push(holder);
            while let Some((_, bound)) = bounds.next_if(|b| b.0 == i) {
                self.place = ModelElement::Bound(bound);
                match scene.bounds[bound as usize].volume {
                    Volume::Box { min, max } => {
                        self.record(holder, RecordKind::BoundingBox, &reals(&[min, max]))
                    }
                    Volume::Sphere { centre, radius } => {
                        let params = [&centre[..], &[radius]].concat();
                        self.record(holder, RecordKind::BoundingSphere, &reals(&[params]));
                    }
                }
            }
        }
    }

    /// Writes a node, and returns the ID of its object.
    fn node(&mut self, item: &Item) -> u32 {
        match &item.node {
            Node::Transform { of, matrix } => {
                let id = self.changeable(*of);
                let before = &self.scene.nodes[*of as usize].node;
                self.transform(id, matrix, matches!(before, Node::Transform { .. }));
                id
            }
            Node::Paint {
                of,
                texture,
                optics,
                index,
            } => {
                let id = self.changeable(*of);
                if let Some(texture) = texture {
                    self.texture(id, texture);
                }
                if let Some(model::Optics { kd, ks, kt }) = optics {
                    let channel = |c: usize| [kd[c], ks[c], kt[c]];
                    match channel(0) == channel(1) && channel(0) == channel(2) {
                        true => self.record(id, RecordKind::Optics, &reals(&[channel(0)])),
                        false => {
                            self.record(id, RecordKind::OpticsRgb, &reals(&[0, 1, 2].map(channel)))
                        }
                    }
                }
                if let Some(index) = index {
                    self.record(id, RecordKind::RefractiveIndex, &reals(&[*index]));
                }
                id
            }
            node => {
                let id = item.id.unwrap_or_else(|| self.fresh());
                let operands: Vec<Param> = (node.children().into_iter().flatten())
                    .map(|n| Param::Integer(self.used(n)))
                    .collect();
                match operation(node) {
                    Some(kind) => self.record(id, kind, &operands),
                    None => self.shape(id, node),
                }
                id
            }
        }
    }

    /// The ID of a node's object, for one of the references to the node.
    fn used(&mut self, node: u32) -> u32 {
        self.uses[node as usize] -= 1;
        self.holders[node as usize]
    }

    /// The ID of an object that has the state of the node and may be changed: the node's own object, or a copy if the
    /// node is needed again.
    fn changeable(&mut self, node: u32) -> u32 {
        let holder = self.used(node);
        if self.uses[node as usize] == 0 {
            return holder;
        }
        let copy = self.fresh();
        self.record(copy, RecordKind::Copy, &[Param::Integer(holder)]);
        copy
    }

    /// Writes a transformation, exact to the bit. A transformation that follows another one is written as one record.
    fn transform(&mut self, id: u32, matrix: &[f64; 16], after_another: bool) {
        let m = Matrix::from_rows(matrix);
        let bits = |m: &Matrix| m.0.map(|row| row.map(f64::to_bits));
        let is = |other: &Matrix| bits(other) == bits(&m);
        let [factors, step] = [[0, 5, 10], [3, 7, 11]].map(|places| places.map(|i| matrix[i]));
        let stretch = Matrix::scaling(factors[0], factors[1], factors[2]);
        let moved = Matrix::translation(step[0], step[1], step[2]);
        if is(&moved) {
            self.record(id, RecordKind::Translation, &reals(&[step]));
        } else if is(&stretch) {
            self.record(id, RecordKind::Scaling, &reals(&[factors]));
        } else if is(&moved.after(&stretch)) && !after_another {
            self.record(id, RecordKind::Scaling, &reals(&[factors]));
            self.record(id, RecordKind::Translation, &reals(&[step]));
        } else {
            self.any_matrix |= !m.is_rotation(ROTATION_EPS);
            self.record(id, RecordKind::RotationMatrix, &reals(&[*matrix]));
        }
    }

    fn texture(&mut self, id: u32, texture: &Texture) {
        match texture {
            Texture::Colour(rgb) => self.record(id, RecordKind::Colour, &reals(&[*rgb])),
            Texture::Image(file) => self.record(id, RecordKind::ImageTexture, &[Param::Name(file)]),
            Texture::Checkerboard { n, m, colours } => {
                let [c, d] = self.pattern(colours);
                self.record(
                    id,
                    RecordKind::Checkerboard,
                    &[Param::Integer(*n), Param::Integer(*m), c, d],
                );
            }
            Texture::Solid { colours, size } => {
                let [c, d] = self.pattern(colours);
                self.record(id, RecordKind::SolidTexture, &[c, d, Param::Real(*size)]);
            }
        }
    }

    /// The IDs of the colours of a pattern.
    fn pattern(&mut self, colours: &[Rgb; 2]) -> [Param<'static>; 2] {
        [0, 1].map(|i| {
            let matter = Matter::PatternColour(i);
            Param::Integer(self.colour(colours[usize::from(i)], matter))
        })
    }

    /// The ID of a colour. Its record is written when it is first needed.
    fn colour(&mut self, rgb: Rgb, matter: Matter) -> u32 {
        let key = rgb.map(f64::to_bits);
        if let Some(&id) = self.colours.get(&key) {
            return id;
        }
        let id = self.fresh();
        self.matter = Some(matter);
        self.record(id, RecordKind::Colour, &reals(&[rgb]));
        self.matter = None;
        self.colours.insert(key, id);
        id
    }

    fn shape(&mut self, id: u32, node: &Node) {
        let Some(geometry) = node.geometry() else {
            return;
        };
        let (kind, params) = geometry.record();
        let params: Vec<Param> = (params.into_iter())
            .map(|p| match p {
                Parameter::Real(x) => Param::Real(x),
                Parameter::Integer(n) => Param::Integer(n),
            })
            .collect();
        self.record(id, RecordKind::Shape(kind), &params);
    }

    fn lights(&mut self) {
        let scene = self.scene;
        self.place = ModelElement::Head;
        if !scene.ambient_lights.is_empty() || !scene.point_lights.is_empty() {
            self.heading("heading-lights");
        }
        for (light, i) in scene.ambient_lights.iter().zip(0..) {
            self.place = ModelElement::AmbientLight(i);
            let id = light.id.unwrap_or_else(|| self.fresh());
            self.record(id, RecordKind::AmbientLight, &reals(&[[light.intensity]]));
            self.tint(id, light.colour);
        }
        for (light, i) in scene.point_lights.iter().zip(0..) {
            self.place = ModelElement::PointLight(i);
            let id = light.id.unwrap_or_else(|| self.fresh());
            self.record(id, RecordKind::PointLight, &reals(&[[light.intensity]]));
            if light.position != [0.0; 3] {
                self.record(id, RecordKind::Translation, &reals(&[light.position]));
            }
            self.tint(id, light.colour);
        }
    }

    fn tint(&mut self, id: u32, colour: Rgb) {
        if colour != [1.0; 3] {
            self.record(id, RecordKind::Colour, &reals(&[colour]));
        }
    }

    fn cameras(&mut self) {
        let scene = self.scene;
        self.place = ModelElement::Head;
        if !scene.cameras.is_empty() {
            self.heading(if scene.cameras.len() == 1 {
                "heading-camera"
            } else {
                "heading-cameras"
            });
        }
        let mut ids = Vec::new();
        for (camera, i) in scene.cameras.iter().zip(0..) {
            self.place = ModelElement::Camera(i);
            let id = camera.id.unwrap_or_else(|| self.fresh());
            let model::Camera {
                position,
                direction,
                up,
                fovy,
                ..
            } = *camera;
            let params = [&position[..], &direction, &up, &[fovy]].concat();
            self.record(id, RecordKind::Camera, &reals(&[params]));
            if let Some(projection) = camera.projection {
                self.record(id, RecordKind::ProjectionMatrix, &reals(&[projection]));
            }
            ids.push(Param::Integer(id));
        }
        self.place = ModelElement::View;
        match scene.view {
            Some(model::View::Mono(camera)) if ids.len() > 1 => {
                let id = self.fresh();
                self.record(id, RecordKind::MonoCamera, &[ids[camera as usize]]);
            }
            Some(model::View::Stereo { left, right }) => {
                let id = self.fresh();
                self.record(
                    id,
                    RecordKind::StereoCamera,
                    &[ids[left as usize], ids[right as usize]],
                );
            }
            _ => {}
        }
    }

    fn render(&mut self) {
        let Some(render) = self.scene.render else {
            return;
        };
        self.place = ModelElement::Render;
        self.heading("heading-drawn");
        let background = match render.background == [0.0; 3] {
            true => 0,
            false => self.colour(render.background, Matter::Background),
        };
        let root = self.used(render.root);
        let mut params = vec![Param::Integer(root), Param::Integer(background)];
        if let Some(model::Region { min, max }) = render.clip {
            params.extend(reals(&[min, max]));
        }
        self.record(1, RecordKind::Render, &params);
    }
}

#[derive(Clone, Copy)]
enum Param<'a> {
    Real(f64),
    Integer(u32),
    /// A name, written in quotes.
    Name(&'a str),
}

/// The numbers of all groups, one after the other, as parameters.
fn reals<'a, T: AsRef<[f64]>>(groups: &[T]) -> Vec<Param<'a>> {
    let all = groups.iter().flat_map(|g| g.as_ref());
    all.map(|&x| Param::Real(x)).collect()
}

/// The type of the record for an operation or a copy; `None` for other nodes.
fn operation(node: &Node) -> Option<RecordKind> {
    Some(match node {
        Node::Union { .. } => RecordKind::Union,
        Node::Intersection { .. } => RecordKind::Intersection,
        Node::Difference { .. } => RecordKind::Difference,
        Node::Complement { .. } => RecordKind::Complement,
        Node::Copy { .. } => RecordKind::Copy,
        _ => return None,
    })
}
