//! Flat faces of a union's parts that lie in one plane. The face of a sheet should be seen before those of solids, and
//! otherwise the face of the first part. POV-Ray shows now one face, now the other, and where parts are joined to one
//! solid, none. So the faces are put a little apart, those that should be seen farther out.

use std::collections::HashMap;

use super::settle::Kind;
use crate::scene::NodeId;
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::contacts::{Face, Orientation};
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::{Appearance, State};

/// The largest distance, in units of `Model::hair`, by which a face is moved out.
const MAX_HAIRS: f64 = 16.0;

/// A flat face, and the position of the part that it belongs to.
struct Flat {
    part: usize,
    plane: Plane,
    face: Face,
}

impl Model<'_> {
    /// Changes parts of a union so that of several faces in one plane the right one is seen. `kinds` has the kinds of
    /// the first parts; nobody sees into the others.
    pub(crate) fn level(&mut self, parts: &mut [(NodeId, State)], kinds: &[Kind]) {
        if !self.budget.spend(Limit::PartsLevelled, parts.len()) {
            return;
        }
        let mut faces: Vec<Flat> = Vec::new();
        for (part, &(node, state)) in parts.iter().enumerate() {
            let all = self.faces_of(node, state.layer);
            faces.extend(all.iter().filter_map(|&face| {
                let plane = face.plane()?;
                Some(Flat { part, plane, face })
            }));
        }
        // Faces that should be seen before others come first.
        faces.sort_by_key(|f| (!f.face.is_sheet, f.part));
        // The faces of parts that are larger as a whole are farther out already.
        let larger: Vec<f64> = (faces.iter())
            .map(|f| match parts[f.part].1.flush {
                Some(flush) if f.face.is_outer => self.changes.larger_by(flush),
                _ => 0.0,
            })
            .collect();
        let mut heights = larger.clone();
        for a in (0..faces.len()).rev() {
            for b in a + 1..faces.len() {
                if faces[a].part != faces[b].part {
                    self.level_pair(&faces, (a, b), &mut heights, (parts, kinds));
                }
            }
        }
        let mut moved: HashMap<usize, Vec<(Plane, f64)>> = HashMap::new();
        let mut sheets: HashMap<usize, f64> = HashMap::new();
        for ((flat, height), larger) in faces.iter().zip(heights).zip(larger) {
            if height <= larger {
                continue;
            }
            if height > MAX_HAIRS * self.hair {
                self.faces_in_one_place(self.ids[parts[flat.part].0 as usize]);
            } else if flat.face.is_sheet {
                let known = sheets.entry(flat.part).or_default();
                *known = known.max(height);
            } else {
                let planes = moved.entry(flat.part).or_default();
                planes.push((flat.plane.moved(larger), height - larger));
            }
        }
        for (i, (_, state)) in parts.iter_mut().enumerate() {
            let planes = self.changes.of_planes(moved.remove(&i).unwrap_or_default());
            let plate = sheets.remove(&i);
            let plate = plate.map(|by| self.changes.number(Change::Plate(by, self.densest)));
            self.changes.add(state, planes.into_iter().chain(plate));
        }
    }

    /// Lifts the first of two faces over the second if they lie in one plane and the first one is to be seen.
    fn level_pair(
        &mut self,
        faces: &[Flat],
        (a, b): (usize, usize),
        heights: &mut [f64],
        (parts, kinds): (&[(NodeId, State)], &[Kind]),
    ) {
        let (f, g) = (&faces[a], &faces[b]);
        let kind = |flat: &Flat| kinds.get(flat.part).copied().unwrap_or_default();
        let [of_f, of_g] = [f, g].map(kind);
        if !f.face.is_outer && !g.face.is_outer {
            return;
        }
        let is_level = || match f.face.contact(&g.face) {
            Some(way) => way == Orientation::Alike || f.face.is_sheet || g.face.is_sheet,
            None => false,
        };
        if f.face.is_sheet || (!of_f.1 && !of_g.1) {
            let differ = || {
                let look = |flat: &Flat| self.look_of(parts[flat.part], flat.face.is_sheet);
                look(f).is_none() || look(f) != look(g)
            };
            match is_level() && differ() {
                true if f.face.is_outer => {
                    heights[a] = f64::max(heights[a], heights[b] + self.hair / 2.0);
                }
                true => self.faces_in_one_place(self.ids[parts[f.part].0 as usize]),
                false => {}
            }
            return;
        }
        let joined = of_f.1 && of_g.1 && of_f.0.is_some() && of_f.0 == of_g.0;
        if joined && !g.face.is_sheet && is_level() {
            // Either face may be farther out. Two hairs apart, the lower one is well within a copy that is a hair
            // smaller.
            let (above, below) = if f.face.is_outer { (a, b) } else { (b, a) };
            heights[above] = f64::max(heights[above], heights[below] + 2.0 * self.hair);
        }
    }

    /// The look of all solids of a part, or if `sheet`, of all its surfaces. `None` if they differ.
    fn look_of(&self, (node, state): (NodeId, State), sheet: bool) -> Option<Appearance> {
        let facts = &self.materials[node as usize];
        match state.look {
            Appearance::Own { texture, optics } if sheet => Some(Appearance::Own {
                texture: Some(texture.or(facts.face_texture)?),
                optics: Some(optics.or(facts.face_optics)?),
            }),
            look if sheet => Some(look),
            _ => Some(self.substance(node, state)?.0),
        }
    }
}
