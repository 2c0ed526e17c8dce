//! Proofs that two solids have nothing in common, or that one holds all of the other: by boxes, balls,
//! half-spaces, and by being the same.

use super::inside::Inside;
use super::reach::{ball, distance};
use crate::scene::bounds::NodeBounds;
use crate::scene::{Aabb, Geometry, Matrix, Node, NodeId, Scene, Vec3};

/// How many of a list are kept, the first ones: what a chain begins with is what is cut.
pub const KEPT: usize = 4;

/// What must lie apart or within by this share of its size and place: more than the rounding of any
/// test of a point, and of the matrices before it.
const CLEAR: f64 = 1e-9;

/// Something in the coordinates of the operation, or its complement.
pub type Literal = (NodeId, bool);

/// Why there is nothing.
pub enum Reason {
    /// The first ends before the second begins, along an axis.
    Apart {
        axis: usize,
        end: f64,
        begin: f64,
    },
    /// Two balls are further from each other than their radii.
    Balls {
        between: f64,
        radii: f64,
    },
    /// The first is outside of the second, a half-space.
    Beyond,
    /// The first is within the second, which is taken away.
    Within,
    Same,
}

/// Proofs about the solids of a scene.
pub struct Proofs<'a> {
    scene: &'a Scene,
    bounds: &'a [NodeBounds],
    inside: Inside<'a>,
    /// Whether a surface without inside is a part, to which the laws of sets do not apply.
    sheets: Vec<bool>,
}

impl<'a> Proofs<'a> {
    pub fn new(scene: &'a Scene, bounds: &'a [NodeBounds]) -> Proofs<'a> {
        let mut sheets: Vec<bool> = Vec::with_capacity(scene.nodes.len());
        for node in &scene.nodes {
            let sheet = match *node {
                Node::Shape(s) => !scene.shapes[s as usize].geometry.is_solid(),
                _ => (node.children().into_iter().flatten()).any(|c| sheets[c as usize]),
            };
            sheets.push(sheet);
        }
        Proofs {
            scene,
            bounds,
            inside: Inside::new(scene, bounds),
            sheets,
        }
    }

    /// What is left of all of space without an object, as far as that is a list.
    pub fn complement(&self, node: NodeId, lists: &[Vec<Literal>]) -> Vec<Literal> {
        let [(n, turned)] = lists[node as usize][..] else {
            return vec![(node, true)];
        };
        if turned {
            return vec![(n, false)];
        }
        // Without any part of a union.
        let mut out = Vec::new();
        let mut todo = vec![n];
        while let Some(n) = todo.pop() {
            match self.scene.nodes[n as usize] {
                Node::Union(a, b) if todo.len() + out.len() + 2 <= KEPT => todo.extend([b, a]),
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push(child),
                _ => out.push((n, true)),
            }
        }
        out
    }

    /// Two things that have nothing in common. `whole`: the operands, where both are to hold.
    pub fn nothing(
        &mut self,
        first: &[Literal],
        second: &[Literal],
        whole: Option<(NodeId, NodeId)>,
    ) -> Option<(NodeId, NodeId, Reason)> {
        for &(x, x_out) in first {
            for &(y, y_out) in second {
                let reason = match (x_out, y_out) {
                    (false, false) => self.apart(x, y),
                    (false, true) => self.covered(x, y),
                    (true, false) => match self.covered(y, x) {
                        Some(reason) => return Some((y, x, reason)),
                        None => None,
                    },
                    (true, true) => None,
                };
                if let Some(reason) = reason {
                    return Some(match reason {
                        Reason::Apart { axis, end, begin } if end > begin => {
                            let (end, begin) = (begin, end);
                            (y, x, Reason::Apart { axis, end, begin })
                        }
                        reason => (x, y, reason),
                    });
                }
            }
        }
        let (a, b) = whole?;
        match self.boxes_apart(a, b)? {
            (axis, end, begin, false) => Some((a, b, Reason::Apart { axis, end, begin })),
            (axis, end, begin, true) => Some((b, a, Reason::Apart { axis, end, begin })),
        }
    }

    fn all(&self, n: NodeId) -> &Aabb {
        &self.bounds[n as usize].all
    }

    /// An axis along which the boxes of two things are apart: where one ends, where the other begins,
    /// and whether it is the second one that ends. Boxes are rounded outwards.
    fn boxes_apart(&self, a: NodeId, b: NodeId) -> Option<(usize, f64, f64, bool)> {
        let (a, b) = (self.all(a), self.all(b));
        // Nearer to each other than that they touch, as far as the numbers go.
        let clear = |end: f64, begin: f64| begin - end > CLEAR * (end.abs() + begin.abs());
        (0..3).find_map(
            |i| match (clear(a.max[i], b.min[i]), clear(b.max[i], a.min[i])) {
                (true, _) => Some((i, a.max[i], b.min[i], false)),
                (_, true) => Some((i, b.max[i], a.min[i], true)),
                _ => None,
            },
        )
    }

    fn apart(&self, x: NodeId, y: NodeId) -> Option<Reason> {
        if self.all(x).is_empty() || self.all(y).is_empty() {
            return None;
        }
        if let Some((axis, end, begin, second)) = self.boxes_apart(x, y) {
            // Told the other way round by whoever asks.
            let (end, begin) = if second { (begin, end) } else { (end, begin) };
            return Some(Reason::Apart { axis, end, begin });
        }
        let (p, q) = (placed(self.scene, x), placed(self.scene, y));
        if let (Some((c, r)), Some((d, s))) = (self.ball(&p), self.ball(&q)) {
            let between = distance(c, d);
            let clear = CLEAR * (r + s + far(&c) + far(&d));
            let radii = r + s;
            return (between > radii + clear).then_some(Reason::Balls { between, radii });
        }
        // Only the first is said to be outside of the second.
        (self.beyond(x, &q)).then_some(Reason::Beyond)
    }

    fn ball(&self, p: &Placed) -> Option<(Vec3, f64)> {
        ball(self.scene, p.shape?, &p.matrix)
    }

    fn geometry(&self, p: &Placed) -> Option<&Geometry> {
        Some(&self.scene.shapes[p.shape? as usize].geometry)
    }

    /// Whether all of a thing that ends is outside of a half-space.
    fn beyond(&self, x: NodeId, plane: &Placed) -> bool {
        let Some(Geometry::HalfSpace([a, b, c, d])) = self.geometry(plane) else {
            return false;
        };
        let Some(corners) = self.corners(x, plane) else {
            return false;
        };
        corners.iter().all(|[x, y, z]| {
            let terms = [a * x, b * y, c * z, *d];
            let size: f64 = terms.iter().map(|t| t.abs()).sum();
            terms.iter().sum::<f64>() > CLEAR * size
        })
    }

    /// The corners of a box somewhat larger than a thing, in the coordinates of a shape.
    fn corners(&self, x: NodeId, to: &Placed) -> Option<[Vec3; 8]> {
        let b = self.all(x);
        if !b.is_finite() || b.is_empty() {
            return None;
        }
        let clear = CLEAR * (b.radius() + far(&b.min).max(far(&b.max)));
        let back = to.matrix.inverse()?;
        Some(std::array::from_fn(|k| {
            back.point(std::array::from_fn(|i| match k >> i & 1 {
                0 => b.min[i] - clear,
                _ => b.max[i] + clear,
            }))
        }))
    }

    /// Whether nothing of x is left without y.
    pub fn covered(&mut self, x: NodeId, y: NodeId) -> Option<Reason> {
        let (p, q) = (placed(self.scene, x), placed(self.scene, y));
        let solid = !self.sheets[x as usize] && !self.sheets[y as usize];
        if solid && p.matrix == q.matrix {
            let equal = |s: u32, t: u32| {
                self.scene.shapes[s as usize].geometry == self.scene.shapes[t as usize].geometry
            };
            let same = match (p.shape, q.shape) {
                (Some(s), Some(t)) => equal(s, t),
                _ => p.core == q.core,
            };
            if same {
                return Some(Reason::Same);
            }
        }
        let scene = self.scene;
        let geometry = &scene.shapes[q.shape? as usize].geometry;
        // What holds the corners of a box has a box around it that holds the box.
        if !is_convex(geometry) || !self.all(y).holds(self.all(x)) {
            return None;
        }
        if let (Some((c, r)), Some((d, s))) = (self.ball(&p), self.ball(&q)) {
            let clear = CLEAR * (r + s + far(&c) + far(&d));
            if distance(c, d) + r < s - clear {
                return Some(Reason::Within);
            }
        }
        let corners = self.corners(x, &q)?;
        let held = corners
            .iter()
            .all(|&c| self.inside.shape(geometry, c) == Some(true));
        held.then_some(Reason::Within)
    }
}

/// Whether a shape is a solid that holds every point between two of its points.
fn is_convex(geometry: &Geometry) -> bool {
    matches!(
        geometry,
        Geometry::HalfSpace(_)
            | Geometry::Sphere { .. }
            | Geometry::Ellipsoid { .. }
            | Geometry::Box { .. }
            | Geometry::GeodesicSphere { .. }
            | Geometry::Cone { .. }
            | Geometry::ParabolicCylinder { .. }
    )
}

/// The largest of a point's coordinates.
fn far(p: &Vec3) -> f64 {
    p.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// What something is, below its transformations and properties.
struct Placed {
    core: NodeId,
    shape: Option<u32>,
    matrix: Matrix,
}

fn placed(scene: &Scene, mut node: NodeId) -> Placed {
    let mut matrix = Matrix::IDENTITY;
    loop {
        node = match scene.nodes[node as usize] {
            Node::Transform { child, matrix: m } => {
                matrix = matrix.after(&scene.matrices[m as usize]);
                child
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => child,
            core => {
                return Placed {
                    core: node,
                    shape: match core {
                        Node::Shape(s) => Some(s),
                        _ => None,
                    },
                    matrix,
                };
            }
        }
    }
}
