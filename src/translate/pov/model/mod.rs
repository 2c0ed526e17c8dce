//! The [`Model`]: what is known of the scene before and while its objects are made. The code in here knows neither how
//! objects are made, nor what is done about faces in one place.

pub(super) mod contacts;
pub(super) mod displacement;
pub(super) mod grouping;
mod interner;
mod lengthen;
pub(super) mod looks;
pub(super) mod materials;
pub(super) mod numbered;
pub(super) mod offset;
pub(super) mod plane;
pub(super) mod state;
pub(super) mod stretch;
pub(super) mod tables;
pub(super) mod textures;
mod visibility;

use std::borrow::Cow;
use std::collections::HashSet;

use crate::diagnostics::Complaint;
use crate::geometry::Aabb;
use crate::scene::{Geometry, Node, NodeId, Scene, fold_up};
use crate::solids::bounds::NodeBounds;
use crate::solids::shapes::profile::closed;
use crate::translate::fidelity::{Fidelity, Report};
use crate::translate::names;
use crate::translate::pov::budget::{Budget, Limit};
use crate::translate::pov::tree::{Body, Modifier, Object};
use contacts::Contacts;
use displacement::Changes;
use interner::Interner;
use materials::{Facts, Material};
use numbered::Numbered;
use state::{Key, State};
use stretch::{stretched, stretches};
use tables::{DEFAULT, Tables};
use textures::Textures;
use visibility::camera_is_walled_in;

/// The report's name for faces that POV-Ray cannot tell apart.
const FACES: &str = "faces in one place";

/// The scene, the facts about its nodes, and the values that its objects share, by number: textures, changes, keys.
pub(super) struct Model<'a> {
    pub scene: &'a Scene,
    pub bounds: Cow<'a, [NodeBounds]>,
    pub tables: Tables,
    pub materials: Vec<Material>,
    pub solids: Interner,
    /// The entity each node belongs to, 0 where none does.
    pub ids: Vec<u32>,
    pub textures: Textures,
    /// The changes of shapes that nobody sees, by number.
    pub changes: Changes,
    contacts: Contacts,
    pub budget: &'a Budget,
    /// The keys of the declared objects, by number.
    keys: Numbered<Key>,
    /// The hair: the distance by which faces in one place are put apart, in the coordinates of the operation at hand.
    pub hair: f64,
    /// The hair in the coordinates that each node is placed in.
    hairs: Vec<f64>,
    /// Whether the render box cuts through the scene, or a camera is in it: what lies inside of opaque objects can be
    /// seen.
    pub cut_open: bool,
    /// The number of an index that is, in each channel, the largest of any solid.
    pub densest: u32,
    /// Opaque unions that touch a part, in the union around them, that light goes through.
    pub beside_clear: HashSet<NodeId>,
    /// For each node, whether it contains a flat surface. Empty if no part of the scene lets light through.
    pub holds_sheets: Vec<bool>,
    /// For each node, whether it contains triangles whose shading normals turn away from the eye. Empty if there are
    /// none.
    pub holds_backward_normals: Vec<bool>,
    pub report: Report,
}

impl<'a> Model<'a> {
    pub(super) fn new(
        scene: &'a Scene,
        facts: Facts<'a>,
        hair: f64,
        budget: &'a Budget,
        report: Report,
    ) -> Model<'a> {
        let Facts {
            bounds,
            mut tables,
            materials,
        } = facts;
        let root = materials.len() as NodeId - 1;
        let hairs = stretches(scene, root).into_iter().map(|s| hair * s);
        let all = bounds[root as usize].all;
        let clip = scene.render.and_then(|render| render.clip);
        let cut_open = clip.is_some_and(|(min, max)| !Aabb::new(min, max).holds(&all))
            || camera_is_walled_in(scene, &materials, &tables);
        let mut densest = DEFAULT;
        for solid in materials.iter().filter(|f| f.uses > 0 && f.has_solid) {
            densest = tables.denser(densest, solid.index.first);
        }
        Model {
            scene,
            bounds,
            tables,
            materials,
            solids: Interner::of(scene, root),
            ids: names::node_ids(scene),
            textures: Textures::default(),
            changes: Changes::default(),
            contacts: Contacts::default(),
            budget,
            keys: Numbered::default(),
            hair: 0.0,
            hairs: hairs.collect(),
            cut_open,
            densest,
            beside_clear: HashSet::new(),
            holds_sheets: Vec::new(),
            holds_backward_normals: Vec::new(),
            report,
        }
    }

    /// A reference to the declared object of a node in a state.
    pub(super) fn refer(&mut self, node: NodeId, state: State) -> Object<'a> {
        let key = Key { node, state };
        Object::new(Body::Declared(self.keys.number(key, || key) as usize))
    }

    /// References to the declared objects of operands.
    pub(super) fn refer_all(
        &mut self,
        operands: impl IntoIterator<Item = (NodeId, State)>,
    ) -> Vec<Object<'a>> {
        let operands = operands.into_iter();
        operands
            .map(|(node, state)| self.refer(node, state))
            .collect()
    }

    /// The key of the object with a number.
    pub(super) fn key(&self, number: usize) -> Key {
        self.keys.values[number]
    }

    /// For each node, whether it contains a shape, given by its index, for which `holds` is true.
    pub(super) fn holders(&self, holds: impl Fn(u32) -> bool) -> Vec<bool> {
        let nodes = &self.scene.nodes[..self.materials.len()];
        fold_up(nodes, |_, node, below| match node {
            Node::Shape(shape) => holds(shape),
            node => node.children().any(|child| below[child as usize]),
        })
    }

    /// Sets `hair` for the coordinates that a node is placed in.
    pub(super) fn turn_to(&mut self, node: NodeId) {
        self.hair = self.hairs[node as usize];
    }

    pub(super) fn box_of(&self, node: NodeId) -> Aabb {
        self.bounds[node as usize].all
    }

    /// The modifier that gives an object the refractive index with this number.
    pub(super) fn index(&self, number: u32) -> Modifier<'a> {
        Modifier::Index(self.tables.index(number))
    }

    /// Whether the surfaces of all shapes that a solid is made of can be moved outwards by `by`, or inwards if `by` is
    /// negative.
    pub(super) fn has_offset(&self, node: NodeId, by: f64) -> bool {
        let mut todo = vec![(node, by)];
        let mut looked_at = 0;
        while let Some((node, by)) = todo.pop() {
            looked_at += 1;
            if !self.budget.spend(Limit::NodesOffset, looked_at) {
                return false;
            }
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    let has_room = match geometry {
                        Geometry::Revolution { profile, .. } => {
                            let points = closed(profile).len();
                            self.budget.spend(Limit::ProfilePoints, points)
                        }
                        _ => true,
                    };
                    if geometry.is_solid() && !(has_room && geometry.offset(by).is_some()) {
                        return false;
                    }
                }
                Node::Transform { child, matrix } => {
                    match stretched(&self.scene.matrices[matrix as usize]) {
                        Some(factor) => todo.push((child, by * factor)),
                        None => return false,
                    }
                }
                Node::Complement(child) => todo.push((child, -by)),
                Node::Difference(a, b) => todo.extend([(a, by), (b, -by)]),
                node => todo.extend(node.children().map(|child| (child, by))),
            }
        }
        true
    }

    /// Reports that faces of the entity `id` lie in faces of another object. The id 0 stands for an object that belongs
    /// to no entity.
    pub(super) fn faces_in_one_place(&mut self, id: u32) {
        let doubt = match id {
            0 => Complaint::term("which is seen is up to rounding"),
            id => Complaint::new("fidelity-rounding").with("id", id.to_string()),
        };
        let known = |e: &crate::translate::fidelity::ReportLine| e.feature == FACES;
        if !self.report.entries().any(known) {
            self.report.state(FACES, Fidelity::Approximate(doubt), "");
        }
    }

    pub(super) fn media_are_approximate(&mut self) {
        self.report.count(
            "operations on media of different index",
            Fidelity::approximate(
                "light that goes through faces between the media may take another way, and show another picture",
            ),
            "an object has one index there",
        );
    }
}
