//! W321: two operands of a difference or an intersection share a face.
//!
//! Of two faces in one place, one may lead a ray into the result and the other out of it: in A ∩ B if the outward
//! normals of the faces are opposite, in A − B if they are equal. Rounding then decides what the ray meets. Any other
//! two faces in one place only leave open whose face the result shows: a tool that lies against a face from outside, or
//! faces with equal normals in an intersection. The rule says nothing of these, nor of equal shapes in equal places,
//! which are decided exactly, nor of faces that another operation covers or cuts off, or that are not drawn. It does
//! not know the faces of geodesic spheres and of profiles of more than 64 points.

mod fix;

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::lint::roots;
use crate::lint::rules::swapped_difference;
use crate::lint::spelling::near;
use crate::lint::{Context, live_nodes};
use crate::parallel;
use crate::scene::record::Params;
use crate::scene::{Geometry, Node, NodeId, Scene};
use crate::solids::contacts::face::FaceId;
use crate::solids::contacts::search::{ContactSide, FaceContact, search};
use crate::solids::named;
use crate::solids::shapes::AnyShape;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};

/// The way in which two shapes share a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Case {
    /// A tool ends flush with what it cuts.
    Flush,
    /// Two tools cut up to the shared face, one from each side.
    Holes,
    /// Neither shape is a tool: the two have nothing but the face in common.
    Touch,
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let live = live_nodes(scene);
    // One finding for each tool of an operation, however many faces it shares.
    let group = |found: &FaceContact| {
        let [tool, other] = &found.sides;
        let case = match (tool.cuts, other.cuts) {
            (true, false) => Case::Flush,
            (true, true) => Case::Holes,
            _ => Case::Touch,
        };
        (found.operation, tool.shape, case)
    };
    let mut found = search(scene, context.bounds(), &roots(scene, &live));
    if found.is_empty() {
        return;
    }
    found.sort_by_key(group);
    let parents = Parents::new(scene, &live);
    // W340 proposes other operands or another operation.
    let contradicted = swapped_difference::contradicted(context);
    let groups: Vec<&[FaceContact]> = found.chunk_by(|a, b| group(a) == group(b)).collect();
    let findings = parallel::map(groups.len(), |i| {
        let pairs = groups[i];
        let (operation, _, case) = group(&pairs[0]);
        let found = finding(context, operation, case, pairs, &parents);
        found.map(|d| match contradicted.contains(&operation) {
            true => Diagnostic {
                fixes: Vec::new(),
                ..d
            },
            false => d,
        })
    });
    out.extend(findings.into_iter().flatten());
}

fn finding(
    context: &Context,
    operation: NodeId,
    case: Case,
    pairs: &[FaceContact],
    parents: &Parents,
) -> Option<Diagnostic> {
    let scene = context.scene;
    let found = pairs.first()?;
    let [tool, other] = &found.sides;
    let record = scene.origins[operation as usize];
    let title = match scene.nodes[operation as usize] {
        Node::Difference(..) => "difference",
        _ => "intersection",
    };
    let size = found.sides.iter().fold(f64::INFINITY, |m, s| m.min(s.size));
    let [x, y, z] = found.witness.map(|x| near(x, size));
    let shape = |side: &ContactSide| &scene.shapes[side.shape as usize];
    let face = |side: &ContactSide| {
        let params = context.params(scene.origins[side.node as usize].span)?;
        Some(place(&params, &shape(side).geometry, side.part))
    };
    let copy = |side: &ContactSide| {
        side.copy
            .map_or(Value::from("none"), |id| id.to_string().into())
    };
    // Two states of one shape have the same ID, so the message names the operands that contain them.
    let alike = tool.id == other.id && tool.copy == other.copy;
    let within = |side: &ContactSide| {
        let operand = named(scene, side.operand).filter(|_| alike && side.operand != side.node);
        operand.map_or(Value::from("none"), |n| n.id.to_string().into())
    };
    let (span, face_of_tool, name) = face(tool)?;
    let (other_span, face_of_other, other_name) = face(other)?;
    let mut d = Diagnostic::new(Code::W321, span);
    // There may be as many findings as objects, so each reserves only the memory that it needs.
    d.values.reserve_exact(17);
    d = d
        .case(match case {
            Case::Flush if tool.round => "round",
            Case::Flush => "",
            Case::Holes => "holes",
            Case::Touch => "touch",
        })
        .with("operation", Value::Term(title))
        .with("id", record.id.to_string())
        .with("tool", Value::Term(shape(tool).ty().title))
        .with("tool-id", tool.id.to_string())
        .with("tool-copy", copy(tool))
        .with("tool-in", within(tool))
        .with("tool-face", face_of_tool)
        .with("tool-name", name)
        .with("other", Value::Term(shape(other).ty().title))
        .with("other-id", other.id.to_string())
        .with("other-copy", copy(other))
        .with("other-in", within(other))
        .with("other-face", face_of_other)
        .with("other-name", other_name)
        .with("x", Value::Decimal(x))
        .with("y", Value::Decimal(y))
        .with("z", Value::Decimal(z))
        .label(other_span, "other")
        .label(record.span, "operation");
    let skin = pairs.iter().any(|p| p.skin);
    let bound = parents.bound.contains(&tool.id);
    if case == Case::Touch
        && context.is_flat(operation)
        && let Some(p) = context.params(record.span)
        && p.ty.kind == RecordKind::Intersection
    {
        let union = RecordType::of(RecordKind::Union).code.to_string();
        let span = p.type_span();
        let fix = Fix::replace("fix-union", Applicability::Choice, span, union.clone());
        d = d.case("empty").fix(fix.with("number", quote(&union)));
    }
    if case != Case::Touch && !skin && !bound && parents.only_in(tool.node, operation) {
        let shape = &scene.shapes[tool.shape as usize];
        let sides: Vec<ContactSide> = pairs.iter().map(|p| p.sides[0]).collect();
        let params = context.params(scene.origins[tool.node as usize].span)?;
        if let Some(fix) = fix::lengthen(&params, &shape.geometry, &sides, other.size) {
            d = d.fix(fix);
        }
    }
    Some(d)
}

/// The span of a face in its record, the name of the face, and the name of the parameter that the face is called after
/// (empty if there is none).
fn place(p: &Params, geometry: &Geometry, part: FaceId) -> (Span, &'static str, &'static str) {
    let written = geometry.written(part);
    let span = match written.params {
        Some((first, count)) => p.span_of(first, count),
        // Some types have no parameters.
        None if p.len() == 0 => p.span(),
        None => p.span_of(0, p.len()),
    };
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let named = written.params.filter(|_| written.is_named);
    (span, written.what, named.map_or("", |(i, _)| name(i)))
}

/// The nodes above each node, as far as a node has a single parent; and the objects with bounding volumes.
struct Parents {
    /// For each node the last node of the chain upwards in which each node has a single parent. All that uses the node
    /// uses it by way of that last one.
    sole: Vec<NodeId>,
    /// IDs of the objects with a bounding volume: a longer tool would reach out of its volume.
    bound: FxHashSet<u32>,
}

impl Parents {
    fn new(scene: &Scene, live: &[bool]) -> Parents {
        // For each node the number of its live parents, and the index of one of them.
        let mut of = vec![(0, 0); scene.nodes.len()];
        for (i, node) in scene.nodes.iter().enumerate().filter(|(i, _)| live[*i]) {
            for child in node.children() {
                of[child as usize].0 += 1;
                of[child as usize].1 = i;
            }
        }
        if let Some(render) = &scene.render {
            of[render.root as usize].0 += 1;
        }
        let mut sole: Vec<NodeId> = (0..scene.nodes.len() as NodeId).collect();
        for i in (0..sole.len()).rev() {
            if let (1, parent) = of[i]
                && parent > i
            {
                sole[i] = sole[parent];
            }
        }
        let bound = scene.promises.iter().map(|p| p.id).collect();
        Parents { sole, bound }
    }

    /// Whether this operation uses the node once, and nothing outside of the operation uses it. The operation must be
    /// on the node's chain of single parents. Numbers grow along the chain, and all that uses its last node has a
    /// larger one.
    fn only_in(&self, node: NodeId, operation: NodeId) -> bool {
        operation <= self.sole[node as usize]
    }
}

/// The place of a face in a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Written {
    /// Index of the first parameter and the number of parameters; `None` for the whole record.
    params: Option<(usize, usize)>,
    /// The name of the face, by which the messages choose their words.
    what: &'static str,
    /// Whether messages call the face by the name of its parameter.
    is_named: bool,
}

impl Written {
    fn at(first: usize, count: usize, what: &'static str) -> Written {
        Written {
            params: Some((first, count)),
            what,
            is_named: false,
        }
    }

    const ALL: Written = Written {
        params: None,
        what: "all",
        is_named: false,
    };
}

impl Geometry {
    /// The place of a face in the record, and its name.
    fn written(&self, part: FaceId) -> Written {
        match AnyShape::of(self) {
            AnyShape::Cone(_) => match part {
                FaceId::Mantle => Written::at(0, 2, "mantle"),
                _ => Written::at(0, 1, "base"),
            },
            AnyShape::Cuboid(_) => match part {
                FaceId::Side { axis, upper } => Written {
                    is_named: true,
                    ..Written::at(if upper { axis + 3 } else { axis }, 1, "side")
                },
                _ => Written::ALL,
            },
            AnyShape::HalfSpace(s) => match s.solid {
                true => Written::at(0, 4, "boundary"),
                false => Written::ALL,
            },
            AnyShape::Revolution(_) => match part {
                FaceId::Cap(i) => Written::at(1 + 2 * i, 2, "disc"),
                FaceId::Piece(i) => Written::at(1 + 2 * i, 4, "piece"),
                _ => Written::ALL,
            },
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => Written::ALL,
        }
    }
}

#[cfg(test)]
mod tests;
