//! Flat faces of a union's parts that lie in one plane. By right the one of the first part is seen, and that of
//! a sheet before those of solids; POV-Ray shows now one, now the other, or where parts are joined to one
//! solid, none. So the faces are put a part of a hair apart, those that are seen farther out.

use std::collections::HashMap;

use super::settle::Kind;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId};
use crate::solids::shapes::facts::Facts as _;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::{Layer, Look, State};

/// Unions of more parts are not searched.
const MANY: usize = 1024;
/// So many nodes of a part are looked at.
const PATIENCE: usize = 64;
/// So many hairs apart faces are put at most.
const HIGH: f64 = 16.0;

/// A flat face of a part in the union's coordinates.
struct Face {
    part: usize,
    /// Its normal points out of the solid.
    plane: Plane,
    /// A box around it.
    around: Aabb,
    sheet: bool,
    /// It is that of a hole, which stays as it is.
    cut: bool,
}

/// Which way a part lies from the faces of a shape that it is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Way {
    /// Inside, as that of the shape.
    Out,
    /// Outside: the shape is a hole.
    In,
    /// Inside, in a hole of a hole.
    Back,
}

impl Way {
    fn turned(self) -> Way {
        match self {
            Way::Out | Way::Back => Way::In,
            Way::In => Way::Back,
        }
    }
}

impl Face {
    /// Whether two faces lie in one plane, and at one place there; the normals of solids to the same side,
    /// or to opposite ones.
    fn is_level_with(&self, other: &Face, same: bool) -> bool {
        let ends = [&self.around, &other.around]
            .into_iter()
            .flat_map(|b| [b.min, b.max]);
        let finite = ends.flatten().filter(|x| x.is_finite());
        let size = finite.fold(0.0f64, |m, x| m.max(x.abs()));
        let hair = 1e-9 * size;
        // Along an axis that they lie across they are as thick as nothing; along others more than an edge
        // has to be in common.
        let over = |i: usize| {
            let [a, b] = [&self.around, &other.around];
            let common = a.max[i].min(b.max[i]) - a.min[i].max(b.min[i]);
            let flat = |b: &Aabb| b.max[i] - b.min[i] <= hair;
            common > if flat(a) && flat(b) { -hair } else { hair }
        };
        if !(0..3).all(over) {
            return false;
        }
        let alike = self.plane.is(&other.plane, size);
        let opposed = self.plane.is(&other.plane.turned(), size);
        match (self.sheet || other.sheet, same) {
            (true, _) => alike || opposed,
            (false, true) => alike,
            (false, false) => opposed,
        }
    }

    /// Whether it lies within another one, as far as boxes tell.
    fn is_within(&self, other: &Face) -> bool {
        other.around.holds(&self.around)
    }
}

impl Model<'_> {
    /// Changes parts of a union so that of several faces in one plane the right one is seen. `kinds` are
    /// what the parts are made of. Gives those of one medium that lie against each other.
    pub fn level(
        &mut self,
        parts: &mut [(NodeId, State)],
        kinds: &[Kind],
    ) -> Vec<(NodeId, NodeId)> {
        let mut contacts = Vec::new();
        if parts.len() > MANY || self.hair == 0.0 {
            return contacts;
        }
        let mut faces: Vec<Face> = Vec::new();
        for (i, &(node, state)) in parts.iter().enumerate() {
            self.faces(i, (node, state), &mut faces);
        }
        // Those that are seen first, first.
        faces.sort_by_key(|f| (!f.sheet, f.part));
        // Some parts are larger as a whole.
        let larger: Vec<f64> = (faces.iter())
            .map(|face| match parts[face.part].1.flush {
                Some(flush) if !face.cut => self.changes.larger_by(flush),
                _ => 0.0,
            })
            .collect();
        let mut heights = larger.clone();
        for a in (0..faces.len()).rev() {
            for b in a + 1..faces.len() {
                let pair = [a, b].map(|face: usize| faces[face].part);
                if pair[0] != pair[1]
                    && self.level_pair(&faces, (a, b), &mut heights, (parts, kinds))
                {
                    let [a, b] = pair.map(|part| parts[part].0);
                    contacts.push((a.min(b), a.max(b)));
                }
            }
        }
        let mut moved: HashMap<usize, Vec<(Plane, f64)>> = HashMap::new();
        let mut sheets: HashMap<usize, f64> = HashMap::new();
        for ((face, height), larger) in faces.iter().zip(heights).zip(larger) {
            if height <= larger {
                continue;
            }
            if height > HIGH * self.hair {
                self.faces_in_one_place(self.ids[parts[face.part].0 as usize]);
            } else if face.sheet {
                let known = sheets.entry(face.part).or_default();
                *known = known.max(height);
            } else {
                moved
                    .entry(face.part)
                    .or_default()
                    .push((face.plane.moved(larger), height - larger));
            }
        }
        for (i, (_, state)) in parts.iter_mut().enumerate() {
            let planes = moved
                .remove(&i)
                .map(|planes| self.changes.of_planes(planes));
            let plate = sheets.remove(&i);
            let plate = plate.map(|by| self.changes.number(Change::Plate(by, self.densest)));
            for change in [planes, plate].into_iter().flatten() {
                state.flush = Some(self.changes.both(state.flush, change));
            }
        }
        contacts
    }

    /// Lifts the first of two faces over the second if they lie in one plane and the first one is to be seen.
    /// Says whether they are of one medium and lie against each other.
    fn level_pair(
        &mut self,
        faces: &[Face],
        (a, b): (usize, usize),
        heights: &mut [f64],
        (parts, kinds): (&[(NodeId, State)], &[Kind]),
    ) -> bool {
        let (f, g) = (&faces[a], &faces[b]);
        let [of_f, of_g] = [f.part, g.part].map(|part| kinds[part]);
        if f.cut && g.cut {
            return false;
        }
        let joined = of_f.1 && of_g.1 && of_f.0.is_some() && of_f.0 == of_g.0;
        if f.sheet || (!of_f.1 && !of_g.1) {
            let differ = || {
                let [one, other] = [f, g].map(|face| self.look_of(parts[face.part], face.sheet));
                one.is_none() || one != other
            };
            match f.is_level_with(g, true) && differ() {
                true if f.cut => self.faces_in_one_place(self.ids[parts[f.part].0 as usize]),
                true => heights[a] = f64::max(heights[a], heights[b] + self.hair / 2.0),
                false => {}
            }
        } else if joined && !g.sheet {
            // Well within what is a hair smaller.
            let by = 2.0 * self.hair;
            if f.is_level_with(g, true) {
                // Either may be the one that is farther out.
                let (above, below) = if f.cut { (b, a) } else { (a, b) };
                heights[above] = f64::max(heights[above], heights[below] + by);
            } else if f.is_level_with(g, false) {
                // One of them ends where the other begins.
                let into = match (f.cut, g.cut) {
                    (true, _) => b,
                    (_, true) => a,
                    _ if g.is_within(f) => b,
                    _ => a,
                };
                heights[into] = f64::max(heights[into], by);
                return true;
            }
        }
        false
    }

    /// What all solids of a part look like, or all surfaces, if that is the same for all.
    fn look_of(&self, (node, state): (NodeId, State), sheet: bool) -> Option<Look> {
        let facts = &self.materials[node as usize];
        match state.look {
            Look::Own { texture, optics } if sheet => Some(Look::Own {
                texture: Some(texture.or(facts.face_texture)?),
                optics: Some(optics.or(facts.face_optics)?),
            }),
            look if sheet => Some(look),
            _ => Some(self.substance(node, state)?.0),
        }
    }

    /// The flat faces of a part, as far as patience goes.
    fn faces(&self, part: usize, (node, state): (NodeId, State), faces: &mut Vec<Face>) {
        let mut todo = vec![(node, Matrix::IDENTITY, Way::Out)];
        for _ in 0..PATIENCE {
            let Some((node, m, way)) = todo.pop() else {
                return;
            };
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    let left_out = match state.layer {
                        Layer::All => false,
                        Layer::Solid => !geometry.is_solid(),
                        Layer::Surface => geometry.is_solid(),
                    };
                    if left_out {
                        continue;
                    }
                    let Some(back) = m.inverse() else { continue };
                    for face in geometry.flat_faces(&m) {
                        let around = face.around;
                        let Some(plane) = Plane::of(face.n, face.d) else {
                            continue;
                        };
                        faces.extend(plane.moved_back(&back).map(|(plane, _)| Face {
                            part,
                            plane: if way == Way::In {
                                plane.turned()
                            } else {
                                plane
                            },
                            around,
                            sheet: !geometry.is_solid(),
                            cut: way != Way::Out,
                        }));
                    }
                }
                Node::Transform { child, matrix } => {
                    let m = m.after(&self.scene.matrices[matrix as usize]);
                    todo.push((child, m, way));
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push((child, m, way)),
                Node::Complement(a) => todo.push((a, m, way.turned())),
                Node::Union(a, b) | Node::Intersection(a, b) => {
                    todo.extend([(b, m, way), (a, m, way)]);
                }
                Node::Difference(a, b) => todo.extend([(b, m, way.turned()), (a, m, way)]),
            }
        }
    }
}
