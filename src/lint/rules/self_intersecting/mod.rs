//! W320: a torus or a profile that runs through itself.

mod crossing;
mod mended;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::lint::spelling::rough;
use crate::scene::record::Params;
use crate::scene::{Geometry, Shape};
use crate::solids::shapes::AnyShape;
use crossing::{Crossing, first_crossing};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        let Some(crossing) = shape.geometry.crossing() else {
            continue;
        };
        let Some(p) = context.params(span) else {
            continue;
        };
        out.push(match crossing {
            Crossing::Tube => tube(&p, shape),
            Crossing::Pieces { pieces, at } => profile(&p, shape, pieces, at),
        });
    }
}

fn tube(p: &Params, shape: &Shape) -> Diagnostic {
    Diagnostic::new(Code::W320, p.span_of(1, 1))
        .case("torus")
        .with("id", shape.id.to_string())
        .with("tube", p.text_of(1).to_owned())
        .with("ring", p.text_of(0).to_owned())
        .label(p.span_of(0, 1), "ring")
        .fix(Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits: [(0, 1), (1, 0)]
                .map(|(to, from)| Edit {
                    span: p.span_of(to, 1),
                    text: p.text_of(from).to_owned(),
                })
                .into(),
        })
}

fn profile(p: &Params, shape: &Shape, (a, b): (usize, usize), at: [f64; 2]) -> Diagnostic {
    let [x, y] = at.map(rough);
    let n = p.count;
    // The span of a piece of the profile has its two points, that of a closing disc its one point.
    let piece = |s: usize| match s.checked_sub(n - 1) {
        Some(0) => ("start", p.span_of(1, 2)),
        Some(_) => ("end", p.span_of(2 * n - 1, 2)),
        None => ("piece", p.span_of(1 + 2 * s, 4)),
    };
    let finding = Diagnostic::new(Code::W320, piece(a).1)
        .with("type", Value::Term(shape.ty().title))
        .with("id", shape.id.to_string())
        .with("x", Value::Decimal(x))
        .with("y", Value::Decimal(y))
        .with("one", piece(a).0)
        .with("one-from", (a + 1).to_string())
        .with("one-to", (a + 2).to_string())
        .with("two", piece(b).0)
        .with("two-from", (b + 1).to_string())
        .with("two-to", (b + 2).to_string())
        .label(piece(b).1, "other");
    let fixes = mended::mended(p);
    let case = if fixes.is_empty() { "" } else { "mended" };
    fixes.into_iter().fold(finding.case(case), Diagnostic::fix)
}

impl Geometry {
    /// The place where the surface runs through itself, if it does.
    fn crossing(&self) -> Option<Crossing> {
        match AnyShape::of(self) {
            AnyShape::Torus(s) => (s.major < s.minor).then_some(Crossing::Tube),
            AnyShape::Revolution(s) => first_crossing(s.profile),
            AnyShape::Cone(_)
            | AnyShape::Cuboid(_)
            | AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Triangle(_) => None,
        }
    }
}
