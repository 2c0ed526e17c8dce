//! The graph of the scene, taken apart into leaves.

mod operands;

pub use operands::{Gate, Operands};

use super::leaf::{self, Form, Kind, Leaf, is_usual, with_lanes};
use super::look::{Colour, Look, Way};
use crate::geometry::aabb::Aabb;
use crate::geometry::vec::Vec3;
use crate::scene::{DEFAULT_COLOUR, Texture};
use crate::trace::graph::{Coat, Graph, Operation, Target};
use crate::trace::shapes::Primitive;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What a look depends on: a texture and its chain, the numbers of the optics and of the refractive index; then whether
/// the shape may have colours of its own, and whether it is a solid.
type LookKey = (Option<(u32, u32)>, [u32; 2], [bool; 2]);

/// The leaves of a scene.
#[derive(Default)]
pub struct Leaves {
    pub all: Vec<Leaf>,
    /// Leaves without bounds in the scene's union.
    pub loose: Vec<u32>,
    /// The other leaves of the scene's union, with their boxes.
    pub boxes: Vec<(u32, Aabb)>,
    /// Chains of placements, the outermost placement first. Chain 0 is empty.
    pub chains: Vec<Vec<u32>>,
    /// The index of each chain in `chains`.
    numbers: FxHashMap<Vec<u32>, u32>,
    /// The first leaf for each pair of a shape and a chain.
    twins: FxHashMap<(u32, u32), u32>,
    /// The looks that leaves have.
    looks: FxHashMap<LookKey, Arc<Look>>,
    /// The operands of intersections and differences.
    pub operands: Vec<Operands>,
    /// For each leaf of `all`, the parts on the way from the scene down to the leaf.
    paths: Vec<Vec<u32>>,
}

/// The way down to the parts of an object: the placements, the parts and the paint above them.
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

    /// The way down to the parts of part `number`, which is a part of the object.
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

impl Leaves {
    /// Takes a scene apart. `None` where the kernel cannot draw some part of the scene, or where there are more than
    /// `most` leaves.
    pub fn new(graph: &Graph, most: usize) -> Option<Leaves> {
        let mut leaves = Leaves {
            chains: vec![Vec::new()],
            numbers: [(Vec::new(), 0)].into_iter().collect(),
            all: Vec::with_capacity(graph.parts.len()),
            paths: Vec::with_capacity(graph.parts.len()),
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

    /// Numbers the leaves in the order of the scene's union: earlier operands get smaller numbers.
    fn number_operands(&mut self) {
        let mut order: Vec<u32> = (0..self.all.len() as u32).collect();
        order.sort_by(|&a, &b| self.paths[a as usize].cmp(&self.paths[b as usize]));
        for (operand, leaf) in (0..).zip(order) {
            self.all[leaf as usize].operand = operand;
        }
    }

    /// The index of a chain in `chains`, to which a new chain is added.
    fn chain(&mut self, chain: &[u32]) -> u32 {
        if let Some(&number) = self.numbers.get(chain) {
            return number;
        }
        let number = self.chains.len() as u32;
        self.chains.push(chain.to_vec());
        self.numbers.insert(chain.to_vec(), number);
        number
    }

    /// Adds a part that is a shape, and returns the number of its leaf; `None` for a part that is no shape. A cutting
    /// tool whose faces look like the solid that it cuts takes the paint of `looks`.
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
        let is_solid = shape.is_solid();
        let look = self.look(graph, looks, has_own, is_solid);
        let is_clear = look.kt != [0.0; 3];
        let placement = match above.chain[..] {
            [] => Some(0),
            [only] => Some(only),
            _ => None,
        };
        let is_usual = |&at: &u32| is_usual(&graph.placements[at as usize]);
        let lanes = match placement.filter(is_usual) {
            Some(placement) => with_lanes(shape, is_clear).map(|lanes| (lanes, placement)),
            None => None,
        };
        let none = ((Kind::Other, [0.0; 8], Form::Plain), 0);
        let ((mut kind, mut numbers, mut form), placement) = lanes.unwrap_or(none);
        let mut extent = graph.extents[primitive as usize];
        if kind == Kind::Other
            && let Some((own, of_it, size)) = leaf::quadric(graph, &above.chain, shape)
        {
            (kind, numbers, form) = (Kind::Quadric, of_it, Form::Quadric(own));
            extent = extent.max(size);
        }
        let number = self.all.len() as u32;
        let chain = self.chain(&above.chain);
        let twin = *self.twins.entry((primitive, chain)).or_insert(number);
        self.paths.push(above.path.clone());
        self.all.push(Leaf {
            kind,
            numbers,
            form,
            primitive,
            chain,
            placement,
            solid: number,
            twin,
            extent,
            operand: 0,
            gate: 0,
            is_cut: false,
            is_solid,
            is_convex: shape.shape().is_convex(),
            look,
            is_clear,
            is_lone: !is_clear,
        });
        Some(number)
    }

    /// The look of a shape, shared by all shapes that look alike. `has_own`: whether the shape may have colours of its
    /// own.
    fn look(&mut self, graph: &Graph, of: &Above, has_own: bool, is_solid: bool) -> Arc<Look> {
        let (texture, optics, index) = of.look();
        let texture = texture.as_ref();
        let painted = texture.map(|(texture, chain)| match graph.textures[*texture as usize] {
            Texture::Colour(_) => (*texture, 0),
            _ => (*texture, self.chain(chain)),
        });
        let key = (painted, [optics, index], [has_own, is_solid]);
        let new = || {
            let (plain, colour) = match painted {
                Some((texture, chain)) => match graph.textures[texture as usize] {
                    Texture::Colour(colour) => (colour, Colour::Plain),
                    _ => (DEFAULT_COLOUR, Colour::Texture { texture, chain }),
                },
                None if has_own => (DEFAULT_COLOUR, Colour::Own),
                None => (DEFAULT_COLOUR, Colour::Plain),
            };
            let medium = [optics, index];
            let optics = &graph.optics[optics as usize];
            let index = |number: u32| match is_solid {
                true => graph.indices[number as usize],
                false => [1.0; 3],
            };
            let own = index(medium[1]);
            let may_part = !graph.without.dispersion;
            let (ways, way_count) = Way::through(optics.kt, index(0), own, may_part);
            Arc::new(Look {
                colour,
                kd: optics.kd,
                albedo: match optics.kd {
                    [0.0, 0.0, 0.0] => [0.0; 3],
                    kd => Vec3(kd).times(Vec3(plain)).0,
                },
                ks: optics.ks,
                kt: optics.kt,
                medium,
                index: own,
                ways,
                way_count,
            })
        };
        self.looks.entry(key).or_insert_with(new).clone()
    }
}

/// A box around the box `bounds`, taken out of the space of a chain, with room for the rounding of the maps.
fn moved(graph: &Graph, bounds: &Aabb, chain: &[u32]) -> Aabb {
    let out = |bounds: Aabb, &m: &u32| bounds.image(&graph.placements[m as usize].out).padded();
    chain.iter().rev().fold(*bounds, out)
}
