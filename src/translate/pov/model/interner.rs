//! Finds solids that are equal, or certainly within each other. POV-Ray speckles faces of two solids in one place, so a
//! solid is not written if an operation leaves nothing of it, or if it is there already.

use std::collections::{HashMap, HashSet};

use super::numbered::Numbered;
use crate::geometry::Matrix;
use crate::geometry::array::{cross, dot, length};
use crate::scene::geometry::Parameter;
use crate::scene::{Geometry, Node, NodeId, Scene, TriangleNormals, Vec3};
use crate::solids::shapes::facts::Facts as _;

/// A solid in its placement. Nodes that hold the same points have the same occurrence, whatever they look like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Occurrence {
    core: u32,
    matrix: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Core {
    /// The first shape record with this geometry.
    Shape(u32),
    Union(Occurrence, Occurrence),
    Intersection(Occurrence, Occurrence),
    Difference(Occurrence, Occurrence),
    Complement(Occurrence),
}

/// The distinct solids of a scene, and the occurrence of each node.
#[derive(Debug)]
pub(crate) struct Interner {
    /// The occurrence of each node, by its index.
    places: Vec<Occurrence>,
    cores: Numbered<Core>,
    matrices: Numbered<[u64; 16], Matrix>,
    /// The cores that are surfaces of revolution about the y axis.
    round: HashSet<u32>,
}

/// The number of the matrix that changes nothing.
const HERE: u32 = 0;

/// Most steps to find out whether a solid is within others.
const MAX_CONTAINMENT_STEPS: u32 = 64;

/// The relative difference up to which numbers count as equal: a power of two, about 1e-13.
const NUMBER_REL_EPS: f64 = 1.0 / (1u64 << 43) as f64;

impl Interner {
    pub(crate) fn of(scene: &Scene, root: NodeId) -> Interner {
        let mut sets = Interner {
            places: Vec::with_capacity(root as usize + 1),
            cores: Numbered::default(),
            matrices: Numbered::default(),
            round: HashSet::new(),
        };
        sets.matrices.matrix(&Matrix::IDENTITY);
        let mut shapes: HashMap<Vec<u64>, u32> = HashMap::new();
        for node in scene.nodes.iter().take(root as usize + 1) {
            let of = |id: NodeId| sets.places[id as usize];
            let place = match *node {
                Node::Shape(s) => {
                    let (geometry, m) = standard(&scene.shapes[s as usize].geometry);
                    let first = *shapes.entry(bits(&geometry)).or_insert(s);
                    let m = match geometry.character().is_round {
                        true => unturned(&m),
                        false => m,
                    };
                    let place = Occurrence {
                        matrix: sets.matrices.matrix(&rounded(&m)),
                        ..sets.here(Core::Shape(first))
                    };
                    if scene.shapes[first as usize].geometry.character().is_round {
                        sets.round.insert(place.core);
                    }
                    place
                }
                Node::Union(a, b) => sets.here(Core::Union(of(a), of(b))),
                Node::Intersection(a, b) => sets.here(Core::Intersection(of(a), of(b))),
                Node::Difference(a, b) => sets.here(Core::Difference(of(a), of(b))),
                Node::Complement(a) => sets.here(Core::Complement(of(a))),
                Node::Paint { child, .. } | Node::Copy { child, .. } => of(child),
                Node::Transform { child, matrix } => {
                    sets.moved(of(child), &scene.matrices[matrix as usize])
                }
            };
            sets.places.push(place);
        }
        sets
    }

    /// The occurrence of a core without a placement of its own.
    fn here(&mut self, core: Core) -> Occurrence {
        Occurrence {
            core: self.cores.number(core, || core),
            matrix: HERE,
        }
    }

    fn moved(&mut self, place: Occurrence, m: &Matrix) -> Occurrence {
        let mut all = m.after(self.matrices.get(place.matrix));
        if self.round.contains(&place.core) {
            all = unturned(&all);
        }
        Occurrence {
            matrix: self.matrices.matrix(&rounded(&all)),
            ..place
        }
    }

    pub(crate) fn place(&self, node: NodeId) -> Occurrence {
        self.places[node as usize]
    }

    /// The core of a solid, with the solid's placement applied to its operands.
    fn core(&mut self, place: Occurrence) -> Core {
        let core = *self.cores.get(place.core);
        if place.matrix == HERE {
            return core;
        }
        let m = *self.matrices.get(place.matrix);
        let mut moved = |p: Occurrence| self.moved(p, &m);
        match core {
            Core::Shape(s) => Core::Shape(s),
            Core::Union(a, b) => Core::Union(moved(a), moved(b)),
            Core::Intersection(a, b) => Core::Intersection(moved(a), moved(b)),
            Core::Difference(a, b) => Core::Difference(moved(a), moved(b)),
            Core::Complement(a) => Core::Complement(moved(a)),
        }
    }

    /// Adds a solid to a set. If the solid is a union, its operands are added, too.
    pub(crate) fn add(&mut self, place: Occurrence, to: &mut HashSet<Occurrence>) {
        let mut todo = vec![place];
        let mut steps = 0;
        while let Some(place) = todo.pop() {
            if to.insert(place)
                && steps < MAX_CONTAINMENT_STEPS
                && let Core::Union(a, b) = self.core(place)
            {
                todo.extend([a, b]);
            }
            steps += 1;
        }
    }

    /// The solid and the solids that it is made of, at any depth; about `MAX_CONTAINMENT_STEPS` of them at most.
    pub(crate) fn parts(&mut self, place: Occurrence) -> Vec<Occurrence> {
        let mut out = vec![place];
        let mut at = 0;
        while at < out.len() && out.len() < MAX_CONTAINMENT_STEPS as usize {
            match self.core(out[at]) {
                Core::Shape(_) => {}
                Core::Complement(a) => out.push(a),
                Core::Union(a, b) | Core::Intersection(a, b) | Core::Difference(a, b) => {
                    out.extend([a, b]);
                }
            }
            at += 1;
        }
        out
    }

    /// Whether a solid certainly lies within the union of others, which were [added](Self::add).
    pub(crate) fn is_within(&mut self, place: Occurrence, others: &HashSet<Occurrence>) -> bool {
        if others.is_empty() {
            return false;
        }
        let mut fuel = MAX_CONTAINMENT_STEPS;
        self.within(place, others, &mut fuel)
    }

    /// Like [`is_within`](Self::is_within). `fuel` is the number of solids that may still be taken apart.
    fn within(&mut self, place: Occurrence, others: &HashSet<Occurrence>, fuel: &mut u32) -> bool {
        if others.contains(&place) {
            return true;
        }
        if *fuel == 0 {
            return false;
        }
        *fuel -= 1;
        match self.core(place) {
            Core::Shape(_) | Core::Complement(_) => false,
            Core::Union(a, b) => self.within(a, others, fuel) && self.within(b, others, fuel),
            Core::Intersection(a, b) => {
                self.within(a, others, fuel) || self.within(b, others, fuel)
            }
            Core::Difference(a, _) => self.within(a, others, fuel),
        }
    }

    /// Whether two solids certainly have no point in common: one of them is a difference, and the other lies within
    /// what it takes away.
    pub(crate) fn is_apart(&mut self, a: Occurrence, b: Occurrence) -> bool {
        [(a, b), (b, a)].into_iter().any(|(whole, rest)| {
            let mut taken = HashSet::new();
            if let Core::Difference(_, by) = self.core(rest) {
                self.add(by, &mut taken);
            }
            self.is_within(whole, &taken)
        })
    }

    /// Whether an intersection of solids is certainly empty: one of them lies within the operand of a complement among
    /// them, or within what a difference among them takes away.
    pub(crate) fn is_empty(&mut self, members: &[NodeId]) -> bool {
        let mut inside: Vec<Occurrence> = members.iter().map(|n| self.place(*n)).collect();
        let mut outside = HashSet::new();
        let most = inside.len() + MAX_CONTAINMENT_STEPS as usize;
        let mut at = 0;
        while at < inside.len() && at < most {
            match self.core(inside[at]) {
                Core::Shape(_) | Core::Union(..) => {}
                Core::Intersection(a, b) => inside.extend([a, b]),
                Core::Difference(a, b) => {
                    inside.push(a);
                    self.add(b, &mut outside);
                }
                Core::Complement(a) => self.add(a, &mut outside),
            }
            at += 1;
        }
        inside.iter().any(|p| self.is_within(*p, &outside))
    }
}

/// The placement of a solid of revolution about the y axis, without rotations about this axis and mirror images, which
/// do not change the solid.
fn unturned(m: &Matrix) -> Matrix {
    let column = |j: usize| -> Vec3 { std::array::from_fn(|i| m.0[i][j]) };
    let [a, axis, c] = [0, 1, 2].map(column);
    let mut out = *m;
    let mut set = |j: usize, v: Vec3| (0..3).for_each(|i| out.0[i][j] = v[i]);
    let (wide, deep, high) = (length(a), length(c), length(axis));
    let near = |x: f64, y: f64| x.abs() <= NUMBER_REL_EPS * y;
    let upright = near(dot(a, c), wide * deep)
        && near(dot(a, axis), wide * high)
        && near(dot(c, axis), deep * high);
    if upright && near(wide - deep, wide) {
        // The new x direction: the coordinate axis that is farthest from the symmetry axis, less its component along
        // that axis.
        let up = axis.map(|x| x / high);
        let least = up.iter().fold(1.0f64, |m, x| m.min(x.abs()));
        let k = up.iter().position(|x| x.abs() <= least + 1e-6).unwrap_or(0);
        let across: Vec3 = std::array::from_fn(|i| f64::from(u8::from(i == k)) - up[k] * up[i]);
        let across = across.map(|x| x / length(across));
        set(0, across.map(|x| x * wide));
        set(2, cross(across, up).map(|x| x * wide));
    } else {
        for (j, v) in [(0, a), (2, c)] {
            if v.into_iter().find(|x| *x != 0.0).is_some_and(|x| x < 0.0) {
                set(j, v.map(|x| -x));
            }
        }
    }
    out
}

/// A matrix without its last digits, in which equal placements differ by rounding.
fn rounded(m: &Matrix) -> Matrix {
    let largest = |from: usize, to: usize| {
        let rows = m.0.iter().take(3).flat_map(|row| &row[from..to]);
        rows.fold(0.0f64, |most, x| most.max(x.abs()))
    };
    let mut out = *m;
    for (from, to, most) in [(0, 3, largest(0, 3)), (3, 4, largest(0, 4))] {
        let unit = 2f64.powi(most.log2().ceil() as i32) * NUMBER_REL_EPS;
        if unit.is_normal() {
            for row in out.0.iter_mut().take(3) {
                (row[from..to].iter_mut()).for_each(|x| *x = (*x / unit).round() * unit);
            }
        }
    }
    out
}

/// A ball as the unit ball and a box as the unit cube, with the matrix of its placement: both can be written in several
/// ways. Other shapes stay as they are.
fn standard(geometry: &Geometry) -> (Geometry, Matrix) {
    let ball = Geometry::Sphere {
        centre: [0.0; 3],
        radius: 1.0,
    };
    let place = |[x, y, z]: Vec3, [a, b, c]: Vec3| {
        Matrix::translation(x, y, z).after(&Matrix::scaling(a, b, c))
    };
    match geometry {
        Geometry::Sphere { centre, radius } => (ball, place(*centre, [*radius; 3])),
        Geometry::Ellipsoid { semi_axes } => (ball, place([0.0; 3], *semi_axes)),
        Geometry::Box { min, max } => {
            let cube = Geometry::Box {
                min: [0.0; 3],
                max: [1.0; 3],
            };
            let size = std::array::from_fn(|i| max[i] - min[i]);
            (cube, place(*min, size))
        }
        other => (other.clone(), Matrix::IDENTITY),
    }
}

/// The key of the points that a shape holds: its type and numbers.
fn bits(geometry: &Geometry) -> Vec<u64> {
    // Colours and shading normals do not change which points a shape holds.
    let (kind, numbers) = match geometry {
        Geometry::Revolution { profile, .. } => Geometry::Revolution {
            profile: profile.clone(),
            colours: Vec::new(),
        }
        .record(),
        Geometry::Triangle { vertices, .. } => Geometry::Triangle {
            vertices: vertices.clone(),
            normals: TriangleNormals::Flat,
        }
        .record(),
        all => all.record(),
    };
    let bits = |p: &Parameter| match p {
        Parameter::Real(x) => (x + 0.0).to_bits(),
        Parameter::Integer(n) => u64::from(*n),
    };
    std::iter::once(kind as u64)
        .chain(numbers.iter().map(bits))
        .collect()
}
