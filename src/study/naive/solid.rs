//! A scene's tree of solids, with complements pushed down to the shapes.

use super::boxes::{Bounds, Boxes};
use super::form::{NaiveShape, Roots};
use super::light::{World, back};
use super::number::{Number, Ray, V};
use super::trail::{Event, GivenProperties, Leaf, List, Media, Operation, Trail};
use crate::geometry::Matrix;
use crate::geometry::array::each;
use crate::scene::{DEFAULT_INDEX, Geometry, Node, NodeId, Scene, Texture};
use crate::solids::shapes::facts::Facts as _;
use rustc_hash::FxHashMap;

enum Solid<T> {
    Shape {
        shape: u32,
        negated: bool,
    },
    /// `parts` are the operands in order. `boxes` has the numbers of those with bounds, `loose` of those without.
    Union {
        parts: Vec<u32>,
        loose: Vec<u32>,
        boxes: Boxes,
    },
    Both(Operation, u32, u32),
    Placed(u32, Box<[[T; 4]; 3]>),
    Painted(u32, u32),
    /// The solid of all space.
    Everything,
}

/// The reason why a scene cannot be traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unfit {
    NothingDrawn,
    TooManyParts,
    TooDeep,
    TooManyFacets,
    Singular,
}

/// The largest number of solids that a scene may have.
const MAX_SOLIDS: usize = 300_000;
const MAX_DEPTH: u32 = 150;
/// The largest number of tests of a ray with a shape. After more tests the answers are incomplete.
const MAX_CROSSINGS: u64 = 30_000_000;

pub struct Solids<'s, T> {
    scene: &'s Scene,
    forms: Vec<Option<NaiveShape<T>>>,
    solids: Vec<Solid<T>>,
    root: u32,
    /// The textures of all paints that have one.
    pub textures: Vec<&'s Texture>,
    /// For each paint, the number of its texture in `textures`.
    texture_of: Vec<Option<u32>>,
    trail: Trail<T>,
    roots: Roots<T>,
    crossings: u64,
}

impl<'s, T: Number> Solids<'s, T> {
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn new(scene: &'s Scene) -> Result<Solids<'s, T>, Unfit> {
        let render = scene.render.ok_or(Unfit::NothingDrawn)?;
        let mut build = Build {
            scene,
            forms: (0..scene.shapes.len()).map(|_| None).collect(),
            solids: Vec::new(),
            bounds: Vec::new(),
            depths: Vec::new(),
            made: FxHashMap::default(),
        };
        let root = build.make(render.root)?;
        if build.depths[root as usize] > MAX_DEPTH {
            return Err(Unfit::TooDeep);
        }
        let mut textures = Vec::new();
        let texture_of = (scene.paints.iter())
            .map(|paint| {
                paint.texture.as_ref().map(|texture| {
                    textures.push(texture);
                    textures.len() as u32 - 1
                })
            })
            .collect();
        Ok(Solids {
            scene,
            forms: build.forms,
            solids: build.solids,
            root,
            textures,
            texture_of,
            trail: Trail {
                media: media(scene),
                ..Trail::default()
            },
            roots: Roots::default(),
            crossings: 0,
        })
    }

    /// Whether there were too many crossings for the answers to be complete.
    pub fn is_exhausted(&self) -> bool {
        self.crossings > MAX_CROSSINGS
    }

    fn list(&mut self, solid: u32, frame: u32, look: GivenProperties, tie: T) -> List<T> {
        match &self.solids[solid as usize] {
            Solid::Everything => List {
                start: Some(0),
                events: Vec::new(),
            },
            &Solid::Shape { shape, negated } => self.shape(shape, negated, frame, look),
            Solid::Placed(child, rows) => {
                let (child, rows) = (*child, **rows);
                let frame = self.trail.enter(frame, &rows);
                self.list(child, frame, look, tie)
            }
            &Solid::Painted(child, paint) => {
                let record = &self.scene.paints[paint as usize];
                let texture = self.texture_of[paint as usize].map(|t| (t, frame));
                let look = GivenProperties {
                    texture: look.texture.or(texture),
                    optics: look.optics.or(record.optics.map(|_| paint + 1)),
                    index: look.index.or(record.index.map(|_| paint + 1)),
                    owner: if look.owner == 0 {
                        record.owner
                    } else {
                        look.owner
                    },
                };
                self.list(child, frame, look, tie)
            }
            &Solid::Both(operation, a, b) => {
                let first = self.list(a, frame, look, tie);
                if first.is_nothing() {
                    return first;
                }
                let second = self.list(b, frame, look, tie);
                self.trail.join(operation, first, second, tie)
            }
            Solid::Union {
                parts,
                loose,
                boxes,
            } => {
                let ray = self.trail.frames[frame as usize].ray;
                let mut near = loose.clone();
                boxes.visit(
                    each(ray.origin, T::wide),
                    each(ray.direction, T::wide),
                    |i| near.push(i),
                );
                near.sort_unstable();
                let near: Vec<u32> = near.into_iter().map(|i| parts[i as usize]).collect();
                let mut all = List::default();
                for part in near {
                    let list = self.list(part, frame, look, tie);
                    all = self.trail.join(Operation::Union, all, list, tie);
                }
                all
            }
        }
    }

    fn shape(&mut self, shape: u32, negated: bool, frame: u32, look: GivenProperties) -> List<T> {
        self.crossings += 1;
        let Some(form) = &self.forms[shape as usize] else {
            return List::default();
        };
        if self.crossings > MAX_CROSSINGS {
            return List::default();
        }
        form.cross(&self.trail.frames[frame as usize].ray, &mut self.roots);
        let record = &self.scene.shapes[shape as usize];
        let leaf = self.trail.leaves.len() as u32;
        self.trail.leaves.push(Leaf {
            shape,
            frame,
            look,
            id: record.id,
        });
        let sheet = !record.geometry.is_solid();
        if !T::TEXTBOOK && !sheet {
            // Two crossings in one place are a touch: no inside lies between them.
            let tie = self.trail.frames[frame as usize].ray.offset();
            let mut kept: Vec<(T, u32)> = Vec::with_capacity(self.roots.list.len());
            for &root in &self.roots.list {
                if kept.pop_if(|last| root.0 - last.0 <= tie).is_none() {
                    kept.push(root);
                }
            }
            self.roots.list = kept;
        }
        let mut inside = self.roots.inside != negated && !sheet;
        let state = |inside: bool| inside.then_some(leaf);
        let start = state(inside);
        let events = (self.roots.list.iter())
            .map(|&(t, face)| {
                inside = !inside && !sheet;
                Event {
                    t,
                    leaf,
                    face,
                    sheet,
                    seen: true,
                    owner: leaf,
                    after: state(inside),
                }
            })
            .collect();
        List { start, events }
    }
}

impl<T: Number> World<T> for Solids<'_, T> {
    fn first_from_outside(&mut self, _: &Ray<T>, _: T, _: T) -> Option<Option<Event<T>>> {
        None
    }

    fn events(&mut self, ray: &Ray<T>, _: T, _: T) -> List<T> {
        self.trail.begin(ray);
        let tie = match T::TEXTBOOK {
            // Textbooks take one crossing at a time.
            true => T::of(-1.0),
            false => ray.offset(),
        };
        self.list(self.root, 0, GivenProperties::default(), tie)
    }

    fn trail(&self) -> &Trail<T> {
        &self.trail
    }

    fn normal(&self, shape: u32, point: V<T>, face: u32) -> V<T> {
        let form = self.forms[shape as usize].as_ref();
        form.map_or(point, |form| form.normal(point, face))
    }
}

/// The optics and refractive indices of a scene: the defaults first, then those of each paint.
fn media(scene: &Scene) -> Media {
    let mut media = Media::default();
    for paint in &scene.paints {
        media.optics.push(paint.optics.unwrap_or_default());
        media.indices.push(paint.index.unwrap_or(DEFAULT_INDEX));
    }
    media
}

struct Build<'s, T> {
    scene: &'s Scene,
    forms: Vec<Option<NaiveShape<T>>>,
    solids: Vec<Solid<T>>,
    bounds: Vec<Bounds>,
    depths: Vec<u32>,
    made: FxHashMap<(NodeId, bool), u32>,
}

impl<'s, T: Number> Build<'s, T> {
    /// Makes the solid of a node from the bottom up, on a stack: operands come before their operation.
    fn make(&mut self, root: NodeId) -> Result<u32, Unfit> {
        let mut pending = vec![((root, false), false)];
        while let Some((place, ready)) = pending.pop() {
            if self.made.contains_key(&place) {
                continue;
            }
            if self.solids.len() > MAX_SOLIDS || pending.len() > 4 * MAX_SOLIDS {
                return Err(Unfit::TooManyParts);
            }
            let needs = self.needs(place);
            if !ready {
                pending.push((place, true));
                pending.extend(needs.iter().map(|&n| (n, false)));
                continue;
            }
            let of: Vec<u32> = needs.iter().map(|n| self.made[n]).collect();
            let solid = self.solid(place, of)?;
            self.made.insert(place, solid);
        }
        Ok(self.made[&(root, false)])
    }

    /// The operation of a node and its operands; `None` if the node is no operation. Each `bool` says whether the
    /// complement of the node is meant: De Morgan's laws push complements down to the operands.
    fn operation(
        &self,
        (node, negated): (NodeId, bool),
    ) -> Option<(Operation, [(NodeId, bool); 2])> {
        Some(match (self.scene.nodes[node as usize], negated) {
            (Node::Union(a, b), false) => (Operation::Union, [(a, false), (b, false)]),
            (Node::Union(a, b), true) => (Operation::Intersection, [(a, true), (b, true)]),
            (Node::Intersection(a, b), false) => {
                (Operation::Intersection, [(a, false), (b, false)])
            }
            (Node::Intersection(a, b), true) => (Operation::Union, [(a, true), (b, true)]),
            (Node::Difference(a, b), false) => (Operation::Difference, [(a, false), (b, false)]),
            (Node::Difference(a, b), true) => (Operation::Union, [(a, true), (b, false)]),
            _ => return None,
        })
    }

    /// The nodes whose solids have to be made first. For a union, these are the operands of the whole chain of unions.
    fn needs(&self, place: (NodeId, bool)) -> Vec<(NodeId, bool)> {
        let (node, negated) = place;
        match self.operation(place) {
            Some((Operation::Union, _)) => {
                let mut parts = Vec::new();
                let mut pending = vec![place];
                while let Some(place) = pending.pop() {
                    match self.operation(place) {
                        Some((Operation::Union, [a, b])) => pending.extend([b, a]),
                        _ => parts.push(place),
                    }
                    if parts.len() > MAX_SOLIDS {
                        break;
                    }
                }
                parts
            }
            Some((_, operands)) => operands.to_vec(),
            None => match self.scene.nodes[node as usize] {
                Node::Shape(_) => Vec::new(),
                Node::Complement(child) => vec![(child, !negated)],
                Node::Transform { child, .. }
                | Node::Paint { child, .. }
                | Node::Copy { child, .. } => {
                    vec![(child, negated)]
                }
                _ => Vec::new(),
            },
        }
    }

    fn solid(&mut self, place: (NodeId, bool), of: Vec<u32>) -> Result<u32, Unfit> {
        let (node, negated) = place;
        let bounds = |b: &Build<T>, i: u32| b.bounds[i as usize];
        let (solid, limits) = match self.operation(place) {
            Some((Operation::Union, _)) => {
                let limits = of
                    .iter()
                    .fold(Bounds::NONE, |all, &i| all.around(&bounds(self, i)));
                let all = || (0..of.len() as u32).map(|i| (i, bounds(self, of[i as usize])));
                let boxes = Boxes::new(all().filter(|x| x.1.is_bounded()).collect());
                let loose = all().filter(|x| !x.1.is_bounded()).map(|x| x.0).collect();
                let union = Solid::Union {
                    loose,
                    boxes,
                    parts: of.clone(),
                };
                (union, limits)
            }
            Some((operation, _)) => {
                let (a, b) = (bounds(self, of[0]), bounds(self, of[1]));
                let limits = match operation {
                    Operation::Intersection => a.common(&b),
                    _ => a,
                };
                (Solid::Both(operation, of[0], of[1]), limits)
            }
            None => match self.scene.nodes[node as usize] {
                Node::Shape(shape) => self.leaf(shape, negated)?,
                Node::Transform { matrix, .. } => {
                    let matrix = &self.scene.matrices[matrix as usize];
                    let rows = back(matrix).ok_or(Unfit::Singular)?;
                    let limits = moved(&bounds(self, of[0]), matrix);
                    (Solid::Placed(of[0], Box::new(rows)), limits)
                }
                Node::Paint { paint, .. } => (Solid::Painted(of[0], paint), bounds(self, of[0])),
                // A complement or a copy has the solid of its child.
                _ => return Ok(of[0]),
            },
        };
        let depth = of
            .iter()
            .map(|&i| self.depths[i as usize] + 1)
            .max()
            .unwrap_or(0);
        self.solids.push(solid);
        self.bounds.push(limits);
        self.depths.push(depth);
        Ok(self.solids.len() as u32 - 1)
    }

    fn leaf(&mut self, shape: u32, negated: bool) -> Result<(Solid<T>, Bounds), Unfit> {
        let geometry = &self.scene.shapes[shape as usize].geometry;
        if negated && !geometry.is_solid() {
            return Ok((Solid::Everything, Bounds::ALL));
        }
        let form = &mut self.forms[shape as usize];
        if form.is_none() {
            *form = Some(NaiveShape::new(geometry).ok_or(Unfit::TooManyFacets)?);
        }
        let limits = match (negated, geometry) {
            (true, _) | (_, Geometry::Plane(_)) => Bounds::ALL,
            _ => {
                let b = geometry.bounds(&Matrix::IDENTITY);
                Bounds(b.min, b.max)
            }
        };
        Ok((Solid::Shape { shape, negated }, limits))
    }
}

/// The bounds of the image of a box under a map.
fn moved(bounds: &Bounds, matrix: &Matrix) -> Bounds {
    if !bounds.is_bounded() {
        return Bounds::ALL;
    }
    let corner = |i: usize| {
        let p = std::array::from_fn(|c| {
            if i >> c & 1 == 1 {
                bounds.1[c]
            } else {
                bounds.0[c]
            }
        });
        let p = matrix.point(p);
        Bounds(p, p)
    };
    (0..8).fold(Bounds::NONE, |all, i| all.around(&corner(i)))
}
