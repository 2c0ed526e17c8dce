//! Solids as lists of crossings along a line, and what operations make of them (Roth, "Ray Casting
//! for Modeling Solids", 1982).

use super::number::{Number, Ray, V, dot};
use super::shapes;
use zpg::scene::{Node, NodeId, Optics, Rgb, Scene, Texture};

/// One crossing.
#[derive(Clone, Copy)]
pub struct Hit<'s, T> {
    pub t: T,
    /// Outwards, of any length.
    pub normal: V<T>,
    pub uv: [T; 2],
    /// A surface without inside.
    pub sheet: bool,
    pub look: Look<'s>,
}

#[derive(Clone, Copy, Default)]
pub struct Look<'s> {
    pub texture: Option<&'s Texture>,
    pub optics: Option<Optics>,
    pub index: Option<Rgb>,
}

impl<T: Number> Hit<'_, T> {
    pub fn new(t: T, normal: V<T>) -> Self {
        Hit {
            t,
            normal,
            uv: [T::of(0.0); 2],
            sheet: false,
            look: Look::default(),
        }
    }
}

/// Crossings in order, and whether the line comes from inside.
#[derive(Clone)]
pub struct Hits<'s, T> {
    pub inside: bool,
    pub list: Vec<Hit<'s, T>>,
}

impl<T> Default for Hits<'_, T> {
    fn default() -> Self {
        Hits {
            inside: false,
            list: Vec::new(),
        }
    }
}

impl<T: Number> Hits<'_, T> {
    /// Sorts the crossings of a shape.
    pub fn order(&mut self) {
        self.list.retain(|hit| hit.t.wide().is_finite());
        self.list.sort_by(|a, b| a.t.wide().total_cmp(&b.t.wide()));
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Operation {
    Union,
    Intersection,
    Difference,
}

impl Operation {
    fn holds(self, a: bool, b: bool) -> bool {
        match self {
            Operation::Union => a || b,
            Operation::Intersection => a && b,
            Operation::Difference => a && !b,
        }
    }
}

/// A scene's tree of solids.
pub struct Solids<'s, T> {
    scene: &'s Scene,
    /// The inverses of the scene's matrices, the first three rows.
    back: Vec<[[T; 4]; 3]>,
}

impl<'s, T: Number> Solids<'s, T> {
    /// # Errors
    ///
    /// Names a shape or texture that this ray tracer does not know.
    pub fn new(scene: &'s Scene) -> Result<Solids<'s, T>, String> {
        if let Some(shape) = scene.shapes.iter().find(|s| !shapes::is_known(&s.geometry)) {
            return Err(format!("shape {} is of no known kind", shape.id));
        }
        for paint in &scene.paints {
            if let Some(Texture::Solid { .. } | Texture::Image { .. }) = paint.texture {
                return Err(format!(
                    "the texture of {} is of no known kind",
                    paint.owner
                ));
            }
        }
        let mut back = Vec::new();
        for matrix in &scene.matrices {
            let inverse = matrix.inverse().ok_or("a singular matrix")?;
            back.push([0, 1, 2].map(|i| inverse.0[i].map(T::of)));
        }
        Ok(Solids { scene, back })
    }

    /// All crossings of the line with a node of the tree, by recursion: scenes here are small.
    pub fn crossings(&self, node: NodeId, ray: &Ray<T>) -> Hits<'s, T> {
        match self.scene.nodes[node as usize] {
            Node::Shape(shape) => {
                shapes::crossings(&self.scene.shapes[shape as usize].geometry, ray)
            }
            Node::Union(a, b) => self.combined(Operation::Union, a, b, ray),
            Node::Intersection(a, b) => self.combined(Operation::Intersection, a, b, ray),
            Node::Difference(a, b) => self.combined(Operation::Difference, a, b, ray),
            Node::Complement(child) => {
                let mut hits = self.crossings(child, ray);
                hits.inside = !hits.inside;
                for hit in &mut hits.list {
                    hit.normal = hit.normal.map(|x| -x);
                }
                hits
            }
            Node::Transform { child, matrix } => {
                let m = &self.back[matrix as usize];
                let vector = |v: V<T>| [0, 1, 2].map(|i| dot([m[i][0], m[i][1], m[i][2]], v));
                let origin = vector(ray.origin);
                let local = Ray {
                    origin: [0, 1, 2].map(|i| origin[i] + m[i][3]),
                    direction: vector(ray.direction),
                };
                let mut hits = self.crossings(child, &local);
                for hit in &mut hits.list {
                    let n = hit.normal;
                    hit.normal = [0, 1, 2].map(|i| dot([m[0][i], m[1][i], m[2][i]], n));
                }
                hits
            }
            Node::Paint { child, paint } => {
                let paint = &self.scene.paints[paint as usize];
                let mut hits = self.crossings(child, ray);
                for Hit { look, .. } in &mut hits.list {
                    look.texture = paint.texture.as_ref().or(look.texture);
                    look.optics = paint.optics.or(look.optics);
                    look.index = paint.index.or(look.index);
                }
                hits
            }
            Node::Copy { child, .. } => self.crossings(child, ray),
        }
    }

    fn combined(&self, operation: Operation, a: NodeId, b: NodeId, ray: &Ray<T>) -> Hits<'s, T> {
        let (a, b) = (self.crossings(a, ray), self.crossings(b, ray));
        let (mut in_a, mut in_b) = (a.inside, b.inside);
        let mut result = Hits {
            inside: operation.holds(in_a, in_b),
            list: Vec::new(),
        };
        let mut look = a.list.first().map(|hit| hit.look).unwrap_or_default();
        let (mut a, mut b) = (a.list.into_iter().peekable(), b.list.into_iter().peekable());
        loop {
            let first = match (a.peek(), b.peek()) {
                (Some(x), Some(y)) => x.t <= y.t,
                (Some(_), None) => true,
                (None, Some(_)) => false,
                (None, None) => return result,
            };
            let Some(mut hit) = (if first { a.next() } else { b.next() }) else {
                return result;
            };
            if hit.sheet {
                let shown = match operation {
                    Operation::Union => !in_a && !in_b,
                    Operation::Intersection => operation.holds(in_a || first, in_b || !first),
                    Operation::Difference => first && !in_b,
                };
                if shown {
                    result.list.push(hit);
                }
                continue;
            }
            let before = operation.holds(in_a, in_b);
            if first {
                in_a = !in_a;
                look = hit.look;
            } else {
                in_b = !in_b;
            }
            if operation.holds(in_a, in_b) == before {
                continue;
            }
            if operation == Operation::Difference && !first {
                hit.normal = hit.normal.map(|x| -x);
                hit.look = look;
            }
            result.list.push(hit);
        }
    }
}
