//! A union as the handout has it where media meet: (A − B) ∪ (B − A) ∪ (A ∩ B).

use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::lint::Context;
use crate::lint::properties::{ASPECTS, Properties};
use crate::lint::solids::proofs::Proofs;
use crate::scene::bounds::NodeBounds;
use crate::scene::record::Params;
use crate::scene::{Geometry, Node, NodeId, Scene};

/// The largest ID that the language knows.
const ID_MAX: u32 = i32::MAX as u32;

/// Writes unions anew; each fix of a file has IDs of its own.
pub struct Splitter<'a> {
    context: &'a Context<'a>,
    proofs: Proofs<'a>,
    properties: Properties<'a>,
    /// An ID that is free, as are those above it.
    free: Option<u32>,
}

impl<'a> Splitter<'a> {
    pub fn new(context: &'a Context<'a>, bounds: &'a [NodeBounds]) -> Splitter<'a> {
        Splitter {
            context,
            proofs: Proofs::new(context.scene, bounds),
            properties: Properties::new(context),
            free: context.free_id(),
        }
    }

    /// The pieces come in front of the union, whose record keeps its place and its comments. A piece
    /// that is empty for certain is left out. The common piece has the properties of A, to which it
    /// belongs in a union; there is no fix where these cannot be repeated.
    pub fn split(&mut self, p: &Params, union: NodeId) -> Option<Fix> {
        let Node::Union(first, second) = self.context.scene.nodes[union as usize] else {
            return None;
        };
        let (a, b) = (p.text_of(0), p.text_of(1));
        let only_a = self.proofs.covered(first, second).is_none();
        let only_b = self.proofs.covered(second, first).is_none();
        let both = self.id()?;
        let mut lines = vec![format!("{both} -102 {a} {b}")];
        lines.extend(self.properties_of(u32::try_from(p.integer(0)).ok()?, first, both)?);
        let rest = match (only_a, only_b) {
            (false, false) => return None,
            (true, false) => self.difference(a, b, &mut lines)?,
            (false, true) => self.difference(b, a, &mut lines)?,
            (true, true) => {
                let one = self.difference(a, b, &mut lines)?;
                let other = self.difference(b, a, &mut lines)?;
                let either = self.id()?;
                lines.push(format!("{either} -101 {one} {other}"));
                either
            }
        };
        let edit = |span, text| Edit { span, text };
        let front = Span::new(p.id_span.start, p.id_span.start);
        Some(Fix {
            title: "fix",
            applicability: Applicability::Unsafe,
            edits: vec![
                edit(front, lines.join("\n") + "\n"),
                edit(p.span_of(0, 1), rest.to_string()),
                edit(p.span_of(1, 1), both.to_string()),
            ],
        })
    }

    fn id(&mut self) -> Option<u32> {
        let id = self.free?;
        self.free = id.checked_add(1).filter(|&next| next <= ID_MAX);
        Some(id)
    }

    fn difference(&mut self, of: &str, without: &str, lines: &mut Vec<String>) -> Option<u32> {
        let id = self.id()?;
        lines.push(format!("{id} -103 {of} {without}"));
        Some(id)
    }

    /// The records that give `result` what an operand looks like.
    fn properties_of(&self, operand: u32, node: NodeId, result: u32) -> Option<Vec<String>> {
        if is_default(self.context.scene, node) {
            return Some(vec![format!("{result} -299 0 0")]);
        }
        let any = [false; ASPECTS];
        (self.properties).again(self.context, operand, node, result, any)
    }
}

/// Whether a shape has never been given any property.
fn is_default(scene: &Scene, mut node: NodeId) -> bool {
    loop {
        node = match scene.nodes[node as usize] {
            Node::Transform { child, .. } | Node::Copy { child, .. } => child,
            Node::Shape(s) => {
                let geometry = &scene.shapes[s as usize].geometry;
                return !matches!(geometry, Geometry::Revolution { colours, .. } if !colours.is_empty());
            }
            _ => return false,
        };
    }
}
