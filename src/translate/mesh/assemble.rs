//! Assembly of closed meshes from the graph of operations. Each object is built after the objects that it is made of,
//! so that no recursion is needed.
//!
//! A thing is a union of pieces, and each piece has one material inside. A difference is taken of every piece
//! separately, so that its cut faces look like the piece that they are in. Pieces are joined at the very end.

use std::collections::HashMap;

use super::budget::{Budget, Crowd, TooMany};

use super::shape::{self, DROPPED, tessellate};
use super::surface_label::SurfaceLabel;
use super::triangle_mesh::Mesh;

use crate::geometry::{Aabb, Matrix};
use crate::scene::Scene;
use crate::solids::shapes::facts::Facts;
use crate::trace::graph::{self, Graph, Part, Target};

/// The fewest triangles of a shape: a triangle becomes a slab, which has eight.
const MIN_SHAPE_TRIANGLES: f64 = 8.0;

/// The most shapes of a scene in which small shapes are made finer than the tolerance, so that each keeps its form.
const MAX_SHAPES_KEEPING_FORM: usize = 1000;
/// The least length of a shape, in tolerances, in a scene of few shapes: a shorter shape gets a smaller tolerance.
const MIN_LENGTH_TOLERANCES: f64 = 40.0;

/// A piece of a thing: a solid with one material inside, or a surface.
#[derive(Debug, Clone)]
pub struct MeshPart {
    /// A closed mesh. If the part is a surface, triangles labelled [`DROPPED`] only close it and do not belong to it.
    pub mesh: Mesh,
    pub bounds: Aabb,
    /// The label whose properties the part's inside has.
    pub inside: u32,
    pub surface: bool,
    /// Whether the part is one shape that no operation cut anything from, and neither did the render box.
    pub whole: bool,
    /// The medium on the other side of the boundary, if that is not empty space: the index into [`Graph::indices`].
    pub around: Option<u32>,
}

/// A union of pieces, and what their labels mean. Where pieces overlap, the first one owns the common points.
#[derive(Debug, Clone, Default)]
pub(super) struct Thing {
    pub pieces: Vec<MeshPart>,
    pub skins: Vec<SurfaceLabel>,
}

/// The numbers of operations and shapes that could not be built as they should be.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Troubles {
    /// Operands that an operation failed to cut and left as they were.
    pub uncut: u64,
    /// Pairs of solids that overlap and were not joined.
    pub unjoined: u64,
    /// Shapes without end, and complements, which have no end either.
    pub endless: u64,
}

/// Builds the scene's pieces in the scene's coordinates, and cuts them to the region.
pub(super) struct Assembly<'a> {
    scene: &'a Scene,
    graph: &'a Graph,
    pub budget: Budget,
    pub troubles: Troubles,
    /// For each object, a box in its own coordinates that holds all of it that matters; empty if it does not occur.
    regions: Vec<Aabb>,
    /// For each object, the tolerance in its own coordinates: the finest that any of its placements needs.
    tolerances: Vec<f64>,
    /// How often each object still has to be placed.
    uses: Vec<u32>,
    /// The number of shapes in the whole scene, each counted once for every placement.
    shapes: f64,
    things: Vec<Option<Thing>>,
}

/// An operand of an operation, in the coordinates of the result.
pub(super) struct Operand {
    pub pieces: Vec<MeshPart>,
    /// Whether the operand is all of space except the pieces.
    pub outside: bool,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(
        scene: &'a Scene,
        graph: &'a Graph,
        region: &Aabb,
        tolerance: f64,
        budget: Budget,
    ) -> Assembly<'a> {
        let n = graph.objects.len();
        let mut out = Assembly {
            scene,
            graph,
            budget,
            troubles: Troubles::default(),
            regions: vec![Aabb::EMPTY; n],
            tolerances: vec![f64::INFINITY; n],
            uses: vec![0; n],
            shapes: 0.0,
            things: (0..n).map(|_| None).collect(),
        };
        out.look_down(region, tolerance);
        out
    }

    /// Fills `regions`, `tolerances`, `uses` and `shapes` from the root down: where each object occurs, how fine and
    /// how often.
    fn look_down(&mut self, region: &Aabb, tolerance: f64) {
        let graph = self.graph;
        let root = graph.root as usize;
        // The box is somewhat larger than the region, so that none of the box's own faces is left after the cut at
        // the end.
        self.regions[root] = enlarged(region, 1.1);
        self.tolerances[root] = tolerance;
        self.uses[root] = 1;
        let mut occurrences = vec![0.0; graph.objects.len()];
        occurrences[root] = 1.0;
        // Objects stand after those that they are made of.
        for object in (0..graph.objects.len()).rev() {
            if self.uses[object] == 0 {
                continue;
            }
            for part in parts(&graph.objects[object].operation) {
                let part = &graph.parts[part as usize];
                let Target::Object(below) = part.target else {
                    self.shapes += occurrences[object];
                    continue;
                };
                let below = below as usize;
                occurrences[below] += occurrences[object];
                let m = &graph.matrices[part.placement as usize];
                let back = m.inverse().unwrap_or(Matrix::IDENTITY);
                let region = self.regions[object].transformed(&back);
                self.regions[below] = self.regions[below].hull(&region);
                let tolerance = self.tolerances[object] / shape::stretch(m);
                self.tolerances[below] = self.tolerances[below].min(tolerance);
                self.uses[below] += 1;
            }
        }
    }

    /// The pieces of the whole scene.
    ///
    /// # Errors
    /// There would be too many triangles.
    pub(super) fn pieces(&mut self, region: &Aabb, boxed: bool) -> Result<Thing, TooMany> {
        // A scene that needs too many is refused before any triangle is made.
        let needed = MIN_SHAPE_TRIANGLES * self.shapes;
        self.budget.foresee(needed)?;
        for object in 0..self.graph.objects.len() {
            if self.uses[object] > 0 {
                self.things[object] = Some(self.object(object)?);
            }
        }
        let mut thing = self.things[self.graph.root as usize]
            .take()
            .unwrap_or_default();
        self.cut_to(&mut thing, region, boxed);
        Ok(thing)
    }

    fn object(&mut self, object: usize) -> Result<Thing, TooMany> {
        let graph = self.graph;
        match &graph.objects[object].operation {
            graph::Operation::Union(_) => {
                let mut thing = Thing::default();
                for part in parts(&graph.objects[object].operation) {
                    let operand = self.operand(object, part, &mut thing.skins)?;
                    let pieces = self.inside_out(object, operand, &mut thing.skins)?;
                    thing.pieces.extend(pieces);
                }
                Ok(thing)
            }
            graph::Operation::Intersection {
                first,
                cuts,
                inherit,
            } => {
                let mut skins = Vec::new();
                let (mut kept, mut taken) = (Vec::new(), Vec::new());
                for part in first.clone() {
                    let operand = self.operand(object, part, &mut skins)?;
                    if operand.outside {
                        taken.push(operand);
                    } else {
                        kept.push(operand);
                    }
                }
                let tools = skins.len() as u32;
                for part in group(cuts) {
                    let operand = self.operand(object, part, &mut skins)?;
                    if operand.outside {
                        kept.push(operand);
                    } else {
                        taken.push(operand);
                    }
                }
                if kept.is_empty() {
                    self.troubles.endless += 1;
                    kept.push(self.all_of_space(object, &mut skins));
                }
                let pieces = self.intersection(kept, taken, &skins)?;
                let mut thing = Thing { pieces, skins };
                if *inherit {
                    thing.hand_down(tools);
                }
                Ok(thing)
            }
        }
    }

    /// Builds a part as an operand, in the coordinates of the object. The part's labels are added to `skins`; labels
    /// are indices into it.
    fn operand(
        &mut self,
        object: usize,
        part: u32,
        skins: &mut Vec<SurfaceLabel>,
    ) -> Result<Operand, TooMany> {
        let graph = self.graph;
        let part = &graph.parts[part as usize];
        let m = &graph.matrices[part.placement as usize];
        match part.target {
            Target::Shape(primitive) => self.shape(object, part, primitive, m, skins),
            Target::Object(below) => {
                let below = below as usize;
                self.uses[below] -= 1;
                let thing = match self.uses[below] {
                    0 => self.things[below].take(),
                    _ => self.things[below].clone(),
                };
                let mut thing = thing.unwrap_or_default();
                if self.uses[below] > 0 {
                    let triangles = thing.pieces.iter().map(|p| p.mesh.triangles.len());
                    self.budget.spend(triangles.sum::<usize>() as f64)?;
                }
                let start = skins.len() as u32;
                let coat = &graph.paints[part.paint as usize];
                for skin in thing.skins {
                    skins.push(skin.placed(m, coat, graph, part.owner));
                }
                for piece in &mut thing.pieces {
                    if part.placement != 0 {
                        piece.mesh.transform(m);
                        piece.bounds = piece.mesh.bounds();
                    }
                    piece.inside += start;
                    piece.relabel(|label| label + start);
                }
                Ok(Operand {
                    pieces: thing.pieces,
                    outside: false,
                })
            }
        }
    }

    fn shape(
        &mut self,
        object: usize,
        part: &Part,
        primitive: u32,
        m: &Matrix,
        skins: &mut Vec<SurfaceLabel>,
    ) -> Result<Operand, TooMany> {
        let graph = self.graph;
        let record = &self.scene.shapes[graph.records[primitive as usize] as usize];
        let back = m.inverse().unwrap_or(Matrix::IDENTITY);
        let region = self.regions[object].transformed(&back);
        let mut tolerance = self.tolerances[object] / shape::stretch(m);
        if self.scene.shapes.len() <= MAX_SHAPES_KEEPING_FORM {
            let own = record.geometry.bounds(&Matrix::IDENTITY);
            let longest = (0..3).fold(0.0f64, |l, i| l.max(own.max[i] - own.min[i]));
            tolerance = tolerance.min(longest / MIN_LENGTH_TOLERANCES);
        }
        let solid = tessellate(&record.geometry, tolerance, &region, &mut self.budget)?;
        self.troubles.endless += u64::from(!solid.bounded);
        let label = skins.len() as u32;
        skins.push(SurfaceLabel::new(part, primitive, m, graph));
        let surface = !record.geometry.is_solid();
        let one = solid.meshes.len() == 1;
        let mut pieces = Vec::with_capacity(solid.meshes.len());
        for mut mesh in solid.meshes {
            mesh.transform(m);
            for l in mesh.labels.iter_mut().filter(|l| **l != DROPPED) {
                *l = label;
            }
            pieces.push(MeshPart {
                bounds: mesh.bounds(),
                mesh,
                inside: label,
                surface,
                whole: one && !solid.outside && !part.inverted,
                around: None,
            });
        }
        Ok(Operand {
            pieces: if surface && part.inverted {
                // The complement of a surface is all of space.
                Vec::new()
            } else {
                pieces
            },
            outside: solid.outside != part.inverted,
        })
    }

    /// The whole region of an object as an operand: a box that stands for all of space.
    fn all_of_space(&self, object: usize, skins: &mut Vec<SurfaceLabel>) -> Operand {
        let region = enlarged(&self.regions[object], 1.01);
        let label = skins.len() as u32;
        skins.push(SurfaceLabel::cap(None));
        let mut mesh = shape::flat::cuboid(region.min, region.max);
        mesh.label_all(label);
        Operand {
            pieces: vec![MeshPart {
                bounds: mesh.bounds(),
                mesh,
                inside: label,
                surface: false,
                whole: false,
                around: None,
            }],
            outside: false,
        }
    }

    /// The pieces of an operand. An operand that is all of space except some pieces is cut to the object's region
    /// first.
    fn inside_out(
        &mut self,
        object: usize,
        operand: Operand,
        skins: &mut Vec<SurfaceLabel>,
    ) -> Result<Vec<MeshPart>, TooMany> {
        if !operand.outside {
            return Ok(operand.pieces);
        }
        self.troubles.endless += 1;
        let inside = operand.pieces.first().map(|p| p.inside);
        let mut all = self.all_of_space(object, skins);
        if let (Some(inside), Some(piece)) = (inside, all.pieces.first_mut()) {
            piece.inside = inside;
        }
        self.intersection(vec![all], vec![operand], skins)
    }
}

impl MeshPart {
    fn relabel(&mut self, new: impl Fn(u32) -> u32) {
        for l in self.mesh.labels.iter_mut().filter(|l| **l != DROPPED) {
            *l = new(*l);
        }
    }
}

impl Thing {
    /// Gives cut faces the look of the piece that they are on. Labels from `tools` on belong to tools, whose faces
    /// are cut faces.
    fn hand_down(&mut self, tools: u32) {
        let mut looks: HashMap<(u32, u32), u32> = HashMap::new();
        for piece in &mut self.pieces {
            for label in &mut piece.mesh.labels {
                if *label < tools || *label == DROPPED {
                    continue;
                }
                let skins = &mut self.skins;
                *label = *looks.entry((piece.inside, *label)).or_insert_with(|| {
                    let skin = skins[*label as usize].cut_into(&skins[piece.inside as usize]);
                    skins.push(skin);
                    skins.len() as u32 - 1
                });
            }
        }
    }
}

/// The error for solids that are too many to be joined.
pub(super) fn crowded(crowd: Crowd, skins: &[SurfaceLabel]) -> TooMany {
    TooMany::Joined {
        solids: crowd.solids,
        shape: skins.get(crowd.label as usize).map_or(0, |s| s.shape),
    }
}

/// The parts of an operation, in order.
fn parts(operation: &graph::Operation) -> Vec<u32> {
    match operation {
        graph::Operation::Union(all) => group(all),
        graph::Operation::Intersection { first, cuts, .. } => {
            first.clone().chain(group(cuts)).collect()
        }
    }
}

fn group(group: &graph::Group) -> Vec<u32> {
    let mut out: Vec<u32> = group.parts().collect();
    out.sort_unstable();
    out
}

/// The box enlarged by the factor `by` about its centre.
pub(super) fn enlarged(b: &Aabb, by: f64) -> Aabb {
    let c = b.centre();
    let half: [f64; 3] = std::array::from_fn(|i| by * (b.max[i] / 2.0 - b.min[i] / 2.0));
    Aabb::new(
        std::array::from_fn(|i| c[i] - half[i]),
        std::array::from_fn(|i| c[i] + half[i]),
    )
}
