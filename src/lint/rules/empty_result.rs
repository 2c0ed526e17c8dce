//! W319: an intersection or a difference that is empty for certain.
//!
//! An operation without unions is that everything of a list is to hold: some things, and the
//! complements of others. It is empty if two of the first lie apart, if one of the first lies within
//! one of the second, or is the same. Chains keep a few of their list only.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::solids::inside::Inside;
use crate::lint::solids::reach::{ball, distance};
use crate::lint::solids::{named, near};
use crate::scene::bounds::{NodeBounds, node_bounds};
use crate::scene::{Aabb, Geometry, Matrix, Node, NodeId, OperationRecord, Scene, Vec3};

/// How many of a list are kept, the first ones: what a chain begins with is what is cut.
const KEPT: usize = 4;

/// What must lie apart or within by this share of its size and place: more than the rounding of any
/// test of a point, and of the matrices before it.
const CLEAR: f64 = 1e-9;

/// Something in the coordinates of the operation, or its complement.
type Literal = (NodeId, bool);

/// Why there is nothing.
enum Reason {
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

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.operations.is_empty() {
        return;
    }
    let bounds = node_bounds(scene);
    let mut proofs = Proofs {
        scene,
        bounds: &bounds,
        inside: Inside::new(scene, &bounds),
        sheets: Vec::with_capacity(scene.nodes.len()),
    };
    // What is empty has been spoken of, here or by the rules about shapes.
    let mut empty: Vec<bool> = Vec::with_capacity(scene.nodes.len());
    let mut lists: Vec<Vec<Literal>> = Vec::with_capacity(scene.nodes.len());
    let mut records = scene.operations.iter().peekable();
    for (i, node) in scene.nodes.iter().enumerate() {
        let record = records.next_if(|o| o.node as usize == i);
        let is_empty = |n: NodeId| empty[n as usize];
        let own = vec![(i as NodeId, false)];
        proofs.add(node);
        let (nothing, list) = match *node {
            Node::Shape(_) => (bounds[i].all.is_empty(), own),
            Node::Transform { child, .. } => (is_empty(child), own),
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                (is_empty(child), lists[child as usize].clone())
            }
            Node::Union(a, b) => (is_empty(a) && is_empty(b), own),
            Node::Complement(child) => match lists[child as usize][..] {
                [(n, turned)] => (false, vec![(n, !turned)]),
                _ => (false, own),
            },
            Node::Intersection(a, b) | Node::Difference(a, b) => {
                let cut = matches!(node, Node::Difference(..));
                let first = lists[a as usize].clone();
                let second = match cut {
                    true => proofs.complement(b, &lists),
                    false => lists[b as usize].clone(),
                };
                let known = is_empty(a) || (!cut && is_empty(b));
                let proof = match known || (cut && is_empty(b)) {
                    true => None,
                    false => proofs.nothing(&first, &second, (!cut).then_some((a, b))),
                };
                if let Some((x, y, reason)) = &proof
                    && let Some(record) = record
                {
                    out.extend(finding(context, record, (*x, *y), reason));
                }
                let mut all = first;
                all.extend(second);
                all.truncate(KEPT);
                (known || proof.is_some(), all)
            }
        };
        empty.push(nothing);
        lists.push(list);
    }
}

struct Proofs<'a> {
    scene: &'a Scene,
    bounds: &'a [NodeBounds],
    inside: Inside<'a>,
    /// Whether a surface without inside is a part, to which the laws of sets do not apply.
    sheets: Vec<bool>,
}

impl Proofs<'_> {
    fn add(&mut self, node: &Node) {
        let sheet = match *node {
            Node::Shape(s) => !self.scene.shapes[s as usize].geometry.is_solid(),
            _ => (node.children().into_iter().flatten()).any(|c| self.sheets[c as usize]),
        };
        self.sheets.push(sheet);
    }

    /// What is left of all of space without an object, as far as that is a list.
    fn complement(&self, node: NodeId, lists: &[Vec<Literal>]) -> Vec<Literal> {
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
    fn nothing(
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
    fn covered(&mut self, x: NodeId, y: NodeId) -> Option<Reason> {
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

fn finding(
    context: &Context,
    record: &OperationRecord,
    (x, y): (NodeId, NodeId),
    reason: &Reason,
) -> Option<Diagnostic> {
    let scene = context.scene;
    let (one, two) = (named(scene, x)?, named(scene, y)?);
    let operation = named(scene, record.node)?;
    let p = context.params(record.span)?;
    let d = Diagnostic::new(Code::W319, p.span_of(0, 2))
        .with("operation", Value::Term(operation.title))
        .with("id", record.id.to_string())
        .with("one", Value::Term(one.title))
        .with("one-id", one.id.to_string())
        .with("two", Value::Term(two.title))
        .with("two-id", two.id.to_string());
    let size = (begin_size(reason)).max(f64::MIN_POSITIVE);
    let d = match reason {
        Reason::Apart { axis, end, begin } => d
            .with("axis", ["x", "y", "z"][*axis])
            .with("end", near(*end, size))
            .with("begin", near(*begin, size)),
        Reason::Balls { between, radii } => d
            .case("balls")
            .with("between", near(*between, size))
            .with("radii", near(*radii, size)),
        Reason::Beyond => d.case("beyond"),
        Reason::Within => d.case("within"),
        Reason::Same if one.id == two.id => d.case("itself"),
        Reason::Same => d.case("same"),
    };
    let same = one.span == two.span;
    let d = d.label(one.span, "one");
    Some(if same { d } else { d.label(two.span, "two") })
}

/// How far the numbers of a reason are apart: they are told so finely that they stay so.
fn begin_size(reason: &Reason) -> f64 {
    match reason {
        Reason::Apart { end, begin, .. } => begin - end,
        Reason::Balls { between, radii } => between - radii,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{self, messages};

    /// What this rule finds.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W319")).collect()
    }

    fn says(scene: &str, message: &str) {
        assert_eq!(messages(scene), [message], "{scene}");
    }

    #[test]
    fn what_lies_apart() {
        says(
            "2 9 1\n3 12 -1 2 -1 1 3 1\n4 -102 2 3\n",
            "the intersection 4 is empty: the sphere at the origin 2 and the box 3 lie apart, y ≤ 1 and y ≥ 2",
        );
        says(
            "2 12 -1 2 -1 1 3 1\n3 9 1\n4 -102 2 3\n",
            "the intersection 4 is empty: the sphere at the origin 3 and the box 2 lie apart, y ≤ 1 and y ≥ 2",
        );
        says(
            "2 9 1\n3 11 1.5 1.5 0 1\n4 -102 2 3\n",
            "the intersection 4 is empty: the sphere at the origin 2 and the sphere 3 lie apart, their centres by 2.1213, their radii add up to 2",
        );
        says(
            "2 9 1\n3 4 1 1 0 3\n4 -102 2 3\n",
            "the intersection 4 is empty: the sphere at the origin 2 lies outside of the half-space 3",
        );
        for near_miss in [
            "2 9 1\n3 12 -1 1 -1 1 3 1\n4 -102 2 3\n",
            "2 9 1\n3 11 1.4 1.4 0 1\n4 -102 2 3\n",
            "2 9 1\n3 4 1 1 0 1.9\n4 -102 2 3\n",
            "2 9 1\n3 12 -1 2 -1 1 3 1\n4 -101 2 3\n",
            // At the edge of what may be rounding: 2e-9 of 1 and 1.
            "2 9 1\n3 12 -1 1.0000000019 -1 1 3 1\n4 -102 2 3\n",
        ] {
            assert!(found(near_miss).is_empty(), "{near_miss}");
        }
    }

    #[test]
    fn the_edge_of_what_is_clear() {
        let apart = "2 9 1\n3 12 -1 1.0000000021 -1 1 3 1\n4 -102 2 3\n";
        assert_eq!(found(apart), ["W319 3:8"]);
    }

    #[test]
    fn what_lies_within() {
        says(
            "2 12 -1 -1 -1 1 1 1\n3 9 2\n4 -103 2 3\n",
            "the difference 4 is empty: the box 2 lies within the sphere at the origin 3, which is taken away",
        );
        says(
            "2 11 0 0 0.5 1\n3 9 1.6\n4 -103 2 3\n",
            "the difference 4 is empty: the sphere 2 lies within the sphere at the origin 3, which is taken away",
        );
        says(
            "2 9 1\n3 4 0 1 0 -2\n3 -2 10 1\n4 -104 3\n5 -102 2 4\n",
            "the intersection 5 is empty: the sphere at the origin 2 lies within the half-space 3, which is taken away",
        );
        // One of several tools.
        assert_eq!(
            found("2 12 -1 -1 -1 1 1 1\n3 11 5 0 0 1\n5 9 2\n6 -101 3 5\n4 -103 2 6\n"),
            ["W319 5:8"]
        );
        for near_miss in [
            "2 12 -1 -1 -1 1 1 1\n3 9 1.7\n4 -103 2 3\n",
            "2 9 1\n3 14 3 1.5\n4 -103 2 3\n",
            "2 9 1\n3 3 0 1 0 9\n4 -101 2 3\n",
        ] {
            assert!(found(near_miss).is_empty(), "{near_miss}");
        }
    }

    #[test]
    fn what_is_the_same() {
        says(
            "2 14 2 1\n4 -103 2 2\n",
            "the difference 4 is empty: the torus 2 is taken away from itself",
        );
        says(
            "2 14 2 1\n3 -104 2\n4 -102 2 3\n",
            "the intersection 4 is empty: the torus 2 is taken away from itself",
        );
        says(
            "2 14 2 1\n3 14 2 1\n4 -103 2 3\n",
            "the difference 4 is empty: the torus 2 and the torus 3, which is taken away, are the same",
        );
        assert!(found("2 14 2 1\n3 14 2 1\n3 -1 1 0 0\n4 -103 2 3\n").is_empty());
    }

    #[test]
    fn once_only() {
        let chain = "2 9 1\n3 9 2\n4 -103 2 3\n5 11 5 0 0 1\n6 -103 4 5\n7 -102 6 5\n8 -101 6 7\n";
        assert_eq!(found(chain), ["W319 3:8"]);
        // (A − B) ∩ B.
        let both = "2 14 2 1\n3 11 2 0 0 0.7\n4 -103 2 3\n5 -102 4 3\n";
        assert_eq!(found(both), ["W319 4:8"]);
    }
}
