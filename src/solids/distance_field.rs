//! Rough distances of points from the boundary of a solid, rather too short than too long: below zero inside, above
//! zero outside.

use crate::geometry::Matrix;
use crate::geometry::array::length;
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3};
use crate::solids::shapes::facts::{Facts, Taylor};

/// The most shapes of a solid, and the most points of a profile, for which there is a field.
const SHAPES_MAX: usize = 32;
const PROFILE_MAX: usize = 128;

/// A solid in its place, as the steps that compute its distance from a point: operands stand before their operation.
pub struct Field<'a> {
    steps: Vec<FieldOperation<'a>>,
    /// The results of the steps, kept from one point to the next.
    values: Vec<Slope>,
    /// Cost of one point, in steps.
    pub cost: usize,
}

/// A distance, which is below zero inside, and the direction in which it grows: a unit vector, or zero.
#[derive(Debug, Clone, Copy)]
pub struct Slope {
    pub distance: f64,
    pub up: Vec3,
}

impl Slope {
    pub const NOWHERE: Slope = Slope {
        distance: f64::INFINITY,
        up: [0.0; 3],
    };

    /// The slope of an intersection: the one with the larger distance.
    pub fn both(self, other: Slope) -> Slope {
        if self.distance > other.distance {
            self
        } else {
            other
        }
    }

    /// The slope of the complement.
    pub fn turned(self) -> Slope {
        Slope {
            distance: -self.distance,
            up: self.up.map(|x| -x),
        }
    }
}

enum FieldOperation<'a> {
    Shape(&'a Geometry, Box<Placement>),
    /// A surface, which has no inside.
    Nothing,
    Union,
    Intersection,
    Difference,
    Complement,
}

/// Map from the coordinates of the root back to those of a shape.
struct Placement {
    back: Matrix,
    /// An upper bound on the factor by which the map lengthens a vector.
    stretch: f64,
}

impl<'a> Field<'a> {
    /// The field of a node. `matrix` maps the node's coordinates to those of the root. `None` if the node has too many
    /// shapes, or a matrix has no inverse.
    pub fn new(scene: &'a Scene, node: NodeId, matrix: &Matrix) -> Option<Field<'a>> {
        enum Task<'a> {
            Visit(NodeId, Matrix),
            Join(FieldOperation<'a>),
        }
        let mut out = Field {
            steps: Vec::new(),
            values: Vec::new(),
            cost: 0,
        };
        let mut tasks = vec![Task::Visit(node, *matrix)];
        while let Some(task) = tasks.pop() {
            let (node, matrix) = match task {
                Task::Join(step) => {
                    out.steps.push(step);
                    continue;
                }
                Task::Visit(node, matrix) => (node, matrix),
            };
            if out.steps.len() + tasks.len() > 4 * SHAPES_MAX {
                return None;
            }
            let mut pair = |step, a, b| {
                tasks.push(Task::Join(step));
                tasks.extend([Task::Visit(b, matrix), Task::Visit(a, matrix)]);
            };
            match scene.nodes[node as usize] {
                Node::Shape(s) => {
                    let geometry = &scene.shapes[s as usize].geometry;
                    let pieces = geometry.pieces();
                    if pieces > PROFILE_MAX {
                        return None;
                    }
                    out.cost += 4 + pieces / 4;
                    out.steps.push(match geometry.is_solid() {
                        true => {
                            let back = matrix.inverse()?;
                            let rows = &back.0[..3];
                            let squares = rows.iter().flat_map(|r| &r[..3]).map(|x| x * x);
                            let stretch = squares.sum::<f64>().sqrt();
                            FieldOperation::Shape(geometry, Box::new(Placement { back, stretch }))
                        }
                        false => FieldOperation::Nothing,
                    });
                }
                Node::Transform { child, matrix: m } => {
                    let matrix = matrix.after(&scene.matrices[m as usize]);
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => {
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Complement(child) => {
                    tasks.push(Task::Join(FieldOperation::Complement));
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Union(a, b) => pair(FieldOperation::Union, a, b),
                Node::Intersection(a, b) => pair(FieldOperation::Intersection, a, b),
                Node::Difference(a, b) => pair(FieldOperation::Difference, a, b),
            }
        }
        Some(out)
    }

    pub fn at(&mut self, p: Vec3) -> Slope {
        let values = &mut self.values;
        values.clear();
        for step in &self.steps {
            let mut last = || values.pop().unwrap_or(Slope::NOWHERE);
            let value = match step {
                FieldOperation::Shape(geometry, placement) => placement.slope(geometry, p),
                FieldOperation::Nothing => Slope::NOWHERE,
                FieldOperation::Complement => last().turned(),
                two => {
                    let (b, a) = (last(), last());
                    match two {
                        FieldOperation::Union => a.turned().both(b.turned()).turned(),
                        FieldOperation::Intersection => a.both(b),
                        _ => a.both(b.turned()),
                    }
                }
            };
            values.push(value);
        }
        values.pop().unwrap_or(Slope::NOWHERE)
    }
}

impl Placement {
    /// The least distance t at which the shape's function can be zero, with the sign of the function, in the
    /// coordinates of the root: |g|·t + λt² = |f|, with the bound λ of the second-order term.
    fn slope(&self, geometry: &Geometry, p: Vec3) -> Slope {
        let rows = &self.back.0;
        let Taylor { f, g, bend } = geometry.taylor(self.back.point(p));
        let g: Vec3 = std::array::from_fn(|j| (0..3).map(|i| rows[i][j] * g[i]).sum());
        let steep = length(g);
        let bend = bend * self.stretch * self.stretch;
        let root = (steep * steep + 4.0 * bend * f.abs()).sqrt();
        let distance = match steep + root > 0.0 {
            true => 2.0 * f / (steep + root),
            false if f == 0.0 => 0.0,
            false => f.signum() * f64::MAX,
        };
        let up = if steep > 0.0 {
            g.map(|x| x / steep)
        } else {
            [0.0; 3]
        };
        Slope { distance, up }
    }
}
