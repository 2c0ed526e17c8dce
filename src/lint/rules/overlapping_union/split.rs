//! The fix that writes a union as the handout has it where media meet, (A − B) ∪ (B − A) ∪ (A ∩ B), but the common
//! piece first.

use crate::diagnostics::{Edit, Fix, Span};
use crate::lint::Context;
use crate::lint::parts::{Parts, parts};
use crate::lint::properties::{ASPECTS, Properties};
use crate::scene::record::Params;
use crate::scene::{Node, NodeId, Scene};
use crate::solids::bounds::NodeBounds;
use crate::solids::proofs::Proofs;
use crate::solids::shapes::facts::Facts;

/// The largest ID that the language knows.
const ID_MAX: u32 = i32::MAX as u32;

/// Chooses the pieces of unions and new IDs for them. No two fixes of a file share an ID.
pub(super) struct Splitter<'a> {
    scene: &'a Scene,
    proofs: Proofs<'a>,
    parts: Vec<Parts>,
    /// A free ID; all larger ones are free, too. `None` if there is none left.
    free: Option<u32>,
}

/// The IDs of the pieces of a union. Pieces that are certainly empty are left out.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pieces {
    first: NodeId,
    both: u32,
    rest: Rest,
}

#[derive(Debug, Clone, Copy)]
enum Rest {
    OnlyA(u32),
    OnlyB(u32),
    /// The IDs of A − B, B − A and their union.
    Either([u32; 3]),
}

impl<'a> Splitter<'a> {
    pub(super) fn new(context: &'a Context<'a>, bounds: &'a [NodeBounds]) -> Splitter<'a> {
        Splitter {
            scene: context.scene,
            proofs: Proofs::new(context.scene, bounds),
            parts: parts(context.scene),
            free: context.free_id(),
        }
    }

    pub(super) fn pieces(&mut self, union: NodeId) -> Option<Pieces> {
        let Node::Union(first, second) = self.scene.nodes[union as usize] else {
            return None;
        };
        // A surface has no common piece with anything.
        if [first, second]
            .iter()
            .any(|&n| self.parts[n as usize].surface.is_some())
        {
            return None;
        }
        let only_a = self.proofs.covered(first, second).is_none();
        let only_b = self.proofs.covered(second, first).is_none();
        let both = self.id()?;
        let rest = match (only_a, only_b) {
            (false, false) => return None,
            (true, false) => Rest::OnlyA(self.id()?),
            (false, true) => Rest::OnlyB(self.id()?),
            (true, true) => Rest::Either([self.id()?, self.id()?, self.id()?]),
        };
        Some(Pieces { first, both, rest })
    }

    fn id(&mut self) -> Option<u32> {
        let id = self.free?;
        self.free = id.checked_add(1).filter(|&next| next <= ID_MAX);
        Some(id)
    }
}

impl Pieces {
    /// The fix that writes the pieces in front of the union, whose record keeps its place and its comments. The common
    /// piece gets the properties of A, to which it belongs in a union. `None` if these properties cannot be repeated.
    pub(super) fn fix(self, context: &Context, properties: &Properties, p: &Params) -> Option<Fix> {
        let (a, b, both) = (p.text_of(0), p.text_of(1), self.both);
        let mut lines = vec![format!("{both} -102 {a} {b}")];
        lines.extend(self.looks(context, properties, u32::try_from(p.integer(0)).ok()?)?);
        let rest = match self.rest {
            Rest::OnlyA(one) => {
                lines.push(format!("{one} -103 {a} {b}"));
                one
            }
            Rest::OnlyB(one) => {
                lines.push(format!("{one} -103 {b} {a}"));
                one
            }
            Rest::Either([one, other, either]) => {
                lines.push(format!("{one} -103 {a} {b}"));
                lines.push(format!("{other} -103 {b} {a}"));
                lines.push(format!("{either} -101 {one} {other}"));
                either
            }
        };
        let edit = |span, text| Edit { span, text };
        let front = Span::new(p.id_span().start, p.id_span().start);
        Some(Fix::guess(
            "fix",
            vec![
                edit(front, lines.join("\n") + "\n"),
                // The common piece is the first operand, so faces that it shares with the other pieces look like it.
                edit(p.span_of(0, 1), both.to_string()),
                edit(p.span_of(1, 1), rest.to_string()),
            ],
        ))
    }

    /// The records that give the common piece the properties of the first operand; `None` if these cannot be repeated.
    fn looks(
        self,
        context: &Context,
        properties: &Properties,
        operand: u32,
    ) -> Option<Vec<String>> {
        if is_default(context.scene, self.first) {
            return Some(vec![format!("{} -299 0 0", self.both)]);
        }
        properties.again(context, operand, self.first, self.both, [false; ASPECTS])
    }
}

/// Whether a node is a shape, moved or not, without any property: no paint, and no colours of its own.
fn is_default(scene: &Scene, mut node: NodeId) -> bool {
    loop {
        node = match scene.nodes[node as usize] {
            Node::Transform { child, .. } | Node::Copy { child, .. } => child,
            Node::Shape(s) => {
                let geometry = &scene.shapes[s as usize].geometry;
                return !geometry.character().has_colours;
            }
            _ => return false,
        };
    }
}
