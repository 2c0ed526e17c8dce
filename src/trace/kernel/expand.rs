//! The graph of the scene, taken apart into leaves.

use super::leaf::{Colour, Kind, Leaf, Way};
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::{Affine, Placement};
use crate::geometry::exponent::{exponent, shifted};
use crate::geometry::vec::Vec3;
use crate::scene::{DEFAULT_COLOUR, Texture};
use crate::trace::graph::{Coat, Graph, Object, Operation, Target};
use crate::trace::shapes::Primitive;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// A solid within an intersection: what is in all of some operands and in none of some others, the cuts. A union is kept as
/// the complement of what is in none of its operands.
#[derive(Debug, Clone, Copy)]
pub struct Gate {
    /// The gate that it is an operand of, which is an earlier one. That of the whole is its own.
    pub parent: u32,
    /// Whether it is a cut there.
    pub is_cut: bool,
    pub is_union: bool,
}

/// What an intersection is made of.
#[derive(Debug)]
pub struct Operands {
    /// Holds all of it, in its space.
    pub bounds: Aabb,
    /// The whole comes first.
    pub gates: Vec<Gate>,
    /// Shapes that all of the whole is in.
    pub firsts: Vec<u32>,
    /// Other shapes without bounds.
    pub loose: Vec<u32>,
    /// The other shapes, with their boxes in the space of the intersection.
    pub boxes: Vec<(u32, Aabb)>,
}

impl Operands {
    pub fn all(&self) -> impl Iterator<Item = u32> {
        let boxes = self.boxes.iter().map(|(leaf, _)| leaf);
        self.firsts.iter().chain(&self.loose).chain(boxes).copied()
    }
}

/// The leaves of a scene.
#[derive(Default)]
pub struct Leaves {
    pub all: Vec<Leaf>,
    /// Those without bounds that are in the scene's union.
    pub loose: Vec<u32>,
    /// The others in it, with their boxes.
    pub boxes: Vec<(u32, Aabb)>,
    /// Chains of placements, the outermost first; the first one is empty.
    pub chains: Vec<Vec<u32>>,
    numbers: FxHashMap<Vec<u32>, u32>,
    /// For each shape and each chain, the first leaf that is that shape placed so.
    twins: FxHashMap<(u32, u32), u32>,
    /// The operands of intersections and differences.
    pub operands: Vec<Operands>,
    /// Beside `all`: from the scene down, which operand each leaf is in.
    paths: Vec<Vec<u32>>,
}

/// What is above the parts of an object.
#[derive(Clone, Default)]
struct Above {
    /// The placements, the outermost first.
    chain: Vec<u32>,
    path: Vec<u32>,
    /// A texture, and the chain of the space that it is painted in.
    texture: Option<(u32, Vec<u32>)>,
    optics: Option<u32>,
    index: Option<u32>,
}

impl Above {
    /// The texture, the optics and the refractive index of a shape under it.
    fn look(&self) -> (&Option<(u32, Vec<u32>)>, u32, u32) {
        (
            &self.texture,
            self.optics.unwrap_or(0),
            self.index.unwrap_or(0),
        )
    }

    /// What is above the parts of a part.
    fn and(&self, graph: &Graph, number: u32) -> Above {
        let part = &graph.parts[number as usize];
        let coat: &Coat = &graph.paints[part.paint as usize];
        let placed = |placement: u32| {
            let own = Some(placement).filter(|&placement| placement != 0);
            self.chain.iter().copied().chain(own).collect::<Vec<u32>>()
        };
        let own = || {
            let (texture, placement) = coat.texture?;
            Some((texture, placed(placement)))
        };
        Above {
            chain: placed(part.placement),
            path: self.path.iter().copied().chain([number]).collect(),
            texture: self.texture.clone().or_else(own),
            optics: self.optics.or(coat.optics),
            index: self.index.or(coat.index),
        }
    }
}

/// Numbers of a shape with lanes are between this and its reciprocal, or zero.
const LEAST: f64 = 1e-30;
/// Deeper operations are left to the arbiter, who skips what a ray passes level by level: a scene of forty lines may have
/// 2⁴⁰ operands.
const MAX_GATE_DEPTH: u32 = 4;
/// More operations within one intersection are left to the arbiter, too: each merged list counts in all of them.
const MAX_GATES: usize = 1000;
/// Maps that stretch by more than this along one axis, compared with another, are not for lanes.
const STRETCH: f64 = 100.0;

impl Leaves {
    /// `None` where something in the scene is not for the kernel, or where there are more than so many leaves.
    pub fn new(graph: &Graph, most: usize) -> Option<Leaves> {
        let mut leaves = Leaves {
            chains: vec![Vec::new()],
            numbers: [(Vec::new(), 0)].into_iter().collect(),
            ..Leaves::default()
        };
        let mut pending = vec![(graph.root(), Above::default())];
        while let Some((object, above)) = pending.pop() {
            let Operation::Union(group) = &object.operation else {
                return None;
            };
            let loose = group.loose.iter().map(|&part| (part, None));
            let bounded = group.tree.boxes(&object.frame);
            for (number, bounds) in loose.chain(bounded.map(|(part, b)| (part, Some(b)))) {
                if leaves.all.len() > most {
                    return None;
                }
                let bounds = bounds.map(|bounds| moved(graph, &bounds, &above.chain));
                let above = above.and(graph, number);
                match graph.parts[number as usize].target {
                    Target::Shape(_) if graph.parts[number as usize].inverted => return None,
                    Target::Shape(_) => {
                        let leaf = leaves.leaf(graph, number, &above, None)?;
                        leaves.put(leaf, bounds);
                    }
                    Target::Object(object) => {
                        let object = &graph.objects[object as usize];
                        match object.operation {
                            Operation::Union(_) => pending.push((object, above)),
                            Operation::Intersection { .. } => {
                                let leaf = leaves.csg(graph, object, &above)?;
                                leaves.put(leaf, bounds);
                            }
                        }
                    }
                }
            }
        }
        leaves.number_operands();
        Some(leaves)
    }

    /// Takes a leaf into the scene's union.
    fn put(&mut self, leaf: u32, bounds: Option<Aabb>) {
        match bounds {
            Some(bounds) => self.boxes.push((leaf, bounds)),
            None => self.loose.push(leaf),
        }
    }

    /// The earlier operands get the smaller numbers.
    fn number_operands(&mut self) {
        let mut order: Vec<u32> = (0..self.all.len() as u32).collect();
        order.sort_by(|&a, &b| self.paths[a as usize].cmp(&self.paths[b as usize]));
        for (operand, leaf) in (0..).zip(order) {
            self.all[leaf as usize].operand = operand;
        }
    }

    /// The number of a chain.
    fn chain(&mut self, chain: &[u32]) -> u32 {
        if let Some(&number) = self.numbers.get(chain) {
            return number;
        }
        let number = self.chains.len() as u32;
        self.chains.push(chain.to_vec());
        self.numbers.insert(chain.to_vec(), number);
        number
    }

    /// Adds a part that is a shape, if it is for the kernel; returns its number. If it is a tool whose faces
    /// look like what is cut, it takes these `looks`.
    fn leaf(
        &mut self,
        graph: &Graph,
        part: u32,
        above: &Above,
        looks: Option<&Above>,
    ) -> Option<u32> {
        let Target::Shape(primitive) = graph.parts[part as usize].target else {
            return None;
        };
        let shape = &graph.primitives[primitive as usize];
        // No other shape has colours of its own.
        let has_own = matches!(shape, Primitive::Revolution(_)) && looks.is_none();
        let looks = looks.unwrap_or(above);
        let (plain, colour) = match &looks.texture {
            Some((texture, chain)) => match &graph.textures[*texture as usize] {
                Texture::Colour(colour) => (*colour, Colour::Plain),
                _ => {
                    let (texture, chain) = (*texture, self.chain(chain));
                    (DEFAULT_COLOUR, Colour::Texture { texture, chain })
                }
            },
            None if has_own => (DEFAULT_COLOUR, Colour::Own),
            None => (DEFAULT_COLOUR, Colour::Plain),
        };
        let optics = &graph.optics[looks.optics.unwrap_or(0) as usize];
        let is_clear = optics.kt != [0.0; 3];
        let placement = match above.chain[..] {
            [] => Some(0),
            [only] => Some(only),
            _ => None,
        };
        let is_usual = |&at: &u32| is_usual(&graph.placements[at as usize]);
        let lanes = match placement.filter(is_usual) {
            Some(placement) => {
                with_lanes(shape, is_clear).map(|(kind, numbers)| (kind, numbers, placement))
            }
            None => None,
        };
        let (kind, numbers, placement) = lanes.unwrap_or((Kind::Other, [0.0; 8], 0));
        let albedo = match optics.kd {
            [0.0, 0.0, 0.0] => [0.0; 3],
            kd => Vec3(kd).times(Vec3(plain)).0,
        };
        let is_solid = shape.is_solid();
        let index = |number: u32| match is_solid {
            true => graph.indices[number as usize],
            false => [1.0; 3],
        };
        let own = index(looks.index.unwrap_or(0));
        let may_part = !graph.without.dispersion;
        let (ways, way_count) = Way::through(optics.kt, index(0), own, may_part);
        let number = self.all.len() as u32;
        let chain = self.chain(&above.chain);
        let twin = *self.twins.entry((primitive, chain)).or_insert(number);
        self.paths.push(above.path.clone());
        self.all.push(Leaf {
            kind,
            numbers,
            primitive,
            chain,
            placement,
            solid: number,
            twin,
            extent: graph.extents[primitive as usize],
            operand: 0,
            gate: 0,
            is_cut: false,
            is_solid,
            is_convex: shape.shape().is_convex(),
            colour,
            kd: optics.kd,
            albedo,
            ks: optics.ks,
            kt: optics.kt,
            medium: [looks.optics, looks.index].map(|number| number.unwrap_or(0)),
            index: own,
            ways,
            way_count,
            is_clear,
            is_lone: !is_clear,
        });
        Some(number)
    }

    /// Adds an intersection or a difference of solids, if it is for the kernel; returns its number.
    fn csg(&mut self, graph: &Graph, object: &Object, above: &Above) -> Option<u32> {
        let operands = self.operands(graph, object, above)?;
        let number = self.all.len() as u32;
        let first = match &object.operation {
            Operation::Intersection { first, .. } => foremost(graph, first.clone(), above),
            Operation::Union(_) => None,
        };
        // What is in it is one medium: that of its foremost shape.
        let is_foremost = |&leaf: &u32| {
            first
                .as_ref()
                .is_some_and(|a| a.path == self.paths[leaf as usize])
        };
        let foremost = operands.all().find(is_foremost);
        let whole = self.all[foremost.or(operands.all().next())? as usize].clone();
        let has_unions = operands.gates.iter().any(|gate| gate.is_union);
        let is_medium = foremost.is_some() && whole.is_clear && !has_unions;
        for leaf in operands.all() {
            let leaf = &mut self.all[leaf as usize];
            let is_known = !leaf.is_clear && !whole.is_clear
                || is_medium && (leaf.ways == whole.ways || !leaf.is_clear);
            if !(leaf.is_solid && is_known) {
                return None;
            }
            leaf.solid = number;
        }
        let chain = self.chain(&above.chain);
        self.paths.push(above.path.clone());
        self.all.push(Leaf {
            kind: Kind::Csg,
            primitive: self.operands.len() as u32,
            chain,
            placement: 0,
            solid: number,
            twin: number,
            is_convex: false,
            ..whole
        });
        self.operands.push(operands);
        Some(number)
    }

    /// Adds the shapes that an intersection or a difference is made of.
    fn operands(&mut self, graph: &Graph, object: &Object, above: &Above) -> Option<Operands> {
        let mut operands = Operands {
            bounds: object.bounds,
            gates: vec![Gate {
                parent: 0,
                is_cut: false,
                is_union: false,
            }],
            firsts: Vec::new(),
            loose: Vec::new(),
            boxes: Vec::new(),
        };
        let outer = above.chain.len();
        // With each object its gate and how deep that is, what is above it, and what its shapes look like, if not like
        // themselves.
        let mut pending = vec![(object, [0, 0], above.clone(), None)];
        while let Some((object, [gate, depth], above, looks)) = pending.pop() {
            let (firsts, cuts, cut_looks) = match &object.operation {
                Operation::Union(all) => (0..0, all, looks.clone()),
                Operation::Intersection {
                    first,
                    cuts,
                    inherit,
                } => {
                    let inherited = match (&looks, inherit) {
                        (None, true) => Some(foremost(graph, first.clone(), &above)?),
                        _ => looks.clone(),
                    };
                    (first.clone(), cuts, inherited)
                }
            };
            let bounds = cuts.tree.boxes(&object.frame);
            let bounds = bounds.map(|(part, bounds)| (part, Some(bounds), true));
            let loose = cuts.loose.iter().map(|&part| (part, None, true));
            let firsts = firsts.map(|part| (part, None, false));
            for (number, bounds, is_cut) in firsts.chain(loose).chain(bounds) {
                let looks = if is_cut { &cut_looks } else { &looks };
                let part = &graph.parts[number as usize];
                let own = above.and(graph, number);
                let shape = match part.target {
                    Target::Shape(primitive) => graph.primitives[primitive as usize].shape(),
                    Target::Object(object) => {
                        let object = &graph.objects[object as usize];
                        let inner = operands.gates.len() as u32;
                        if depth == MAX_GATE_DEPTH || operands.gates.len() == MAX_GATES {
                            return None;
                        }
                        operands.gates.push(Gate {
                            parent: gate,
                            is_cut,
                            is_union: matches!(object.operation, Operation::Union(_)),
                        });
                        pending.push((object, [inner, depth + 1], own, looks.clone()));
                        continue;
                    }
                };
                let is_cut = is_cut != part.inverted;
                let leaf = self.leaf(graph, number, &own, looks.as_ref())?;
                (self.all[leaf as usize].gate, self.all[leaf as usize].is_cut) = (gate, is_cut);
                let bounds = match bounds {
                    Some(bounds) if gate == 0 => bounds,
                    _ => moved(graph, &shape.bounds(), &own.chain[outer..]),
                };
                match bounds.is_bounded() {
                    _ if gate == 0 && !is_cut => operands.firsts.push(leaf),
                    true => operands.boxes.push((leaf, bounds)),
                    false => operands.loose.push(leaf),
                }
            }
        }
        Some(operands)
    }
}

/// What is above the shape that owns all that is in all of some parts: the first one of the first part. `None` where that
/// is not everywhere one shape, and not all of them look alike.
fn foremost(graph: &Graph, parts: Range<u32>, above: &Above) -> Option<Above> {
    let mut pending = vec![above.and(graph, parts.clone().next()?)];
    let (mut found, mut count): (Option<Above>, usize) = (None, 0);
    while let Some(above) = pending.pop() {
        count += 1;
        let target = above
            .path
            .last()
            .map(|&part| graph.parts[part as usize].target)?;
        let Target::Object(object) = target else {
            let is_like = |other: &Above| other.look() == above.look();
            if !found.as_ref().is_none_or(is_like) || count > MAX_GATES {
                return None;
            }
            found = Some(above);
            continue;
        };
        match &graph.objects[object as usize].operation {
            Operation::Intersection { first, .. } => {
                pending.push(above.and(graph, first.clone().next()?));
            }
            Operation::Union(all) => {
                pending.extend(all.parts().map(|part| above.and(graph, part)));
            }
        }
    }
    found
}

/// A box around what is in a box, in the space that a chain leads from, with room for what maps round.
fn moved(graph: &Graph, bounds: &Aabb, chain: &[u32]) -> Aabb {
    let out = |bounds: Aabb, &m: &u32| bounds.image(&graph.placements[m as usize].out).padded();
    chain.iter().rev().fold(*bounds, out)
}

/// The kind and the numbers of a shape that has lanes.
fn with_lanes(primitive: &Primitive, is_clear: bool) -> Option<(Kind, [f64; 8])> {
    let (kind, numbers, sizes) = match primitive {
        Primitive::Sphere(sphere) => {
            let ([x, y, z], r) = sphere.numbers();
            (Kind::Sphere, [x, y, z, r, 0.0, 0.0, 0.0, 0.0], vec![r])
        }
        Primitive::Cuboid(cuboid) => {
            let [min, max] = cuboid.corners();
            let sizes = (0..3).map(|i| max[i] - min[i]).collect();
            let ([a, b, c], [x, y, z]) = (min, max);
            (Kind::Cuboid, [a, b, c, x, y, z, 0.0, 0.0], sizes)
        }
        Primitive::Rectangle(rectangle) => {
            let [[a, b], [x, y]] = rectangle.corners();
            let numbers = [a, b, x, y, 0.0, 0.0, 0.0, 0.0];
            (Kind::Rectangle, numbers, vec![x - a, y - b])
        }
        Primitive::Plane(plane) => (Kind::Plane, of_plane(plane.abcd()), Vec::new()),
        // There may be no way out of it.
        Primitive::HalfSpace(solid) if !is_clear => {
            (Kind::HalfSpace, of_plane(solid.abcd()), Vec::new())
        }
        _ => return None,
    };
    let usual = |x: &f64| (LEAST..LEAST.recip()).contains(x);
    let are_usual = numbers.iter().all(|&x| x == 0.0 || usual(&x.abs()));
    (are_usual && sizes.iter().all(usual)).then_some((kind, numbers))
}

/// a, b, c and d as written, and in units of the normal.
fn of_plane([a, b, c, d]: [f64; 4]) -> [f64; 8] {
    let steep = exponent(a.abs().max(b.abs()).max(c.abs()));
    let [x, y, z, w] = [a, b, c, d].map(|number| shifted(number, -steep));
    [a, b, c, d, x, y, z, w]
}

/// Whether a map neither stretches much along one axis, nor takes numbers far.
fn is_usual(placement: &Placement) -> bool {
    let spread = |map: &Affine| {
        let rows = map.rows.map(|row| row.abs().dot(Vec3::ONE));
        rows[0].max(rows[1]).max(rows[2])
    };
    let [out, back] = [&placement.out, &placement.back].map(spread);
    let sizes = [out, back].into_iter().chain(placement.out.offset.abs().0);
    out * back <= STRETCH && sizes.into_iter().all(|x| x <= LEAST.recip().sqrt())
}
