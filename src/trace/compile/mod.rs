//! Compilation of the resolved scene into the [`Graph`] that the tracer walks.
//!
//! There are three passes, none of them recursive. The first counts how often each reachable node is used. The second
//! cuts the scene into objects, each a flattened chain of one operation; a node that is used more than once becomes an
//! object of its own. The third finishes the objects, operands first, with bounds and trees.
//!
//! Complements are driven inwards by De Morgan's laws, so −(−A ∪ −B) and A ∩ B become the same
//! graph; −(A − B) is −A ∪ B. An operand that occurs twice in a union or intersection counts once.
//! (A ∪ B) − C is A ∪ (B − C) where C does not reach A: see [`union_members`].
//!
//! Parts know the IDs of the entities that they come from. A copy owns what the copied entity itself owned: its surface
//! if it is a shape, and its properties. It does not own the operands, which are entities of their own.

mod finalize;
mod intern;
mod union_members;

use super::graph::outermost;
use crate::diagnostics::{Complaint, Error, Span};
use crate::geometry::Matrix;
use crate::scene::{Node, NodeId, Scene, Texture};
use crate::trace::graph::{Coat, Graph, Part, Target};
use crate::trace::image::Images;
use crate::trace::plan::unseen::LeftOut;
use crate::trace::shapes::Primitive;
use intern::Interner;
use rustc_hash::FxHashMap;

/// Builds the graph of all that is reachable from `root`, without the operands that are left out.
pub(super) fn compile(
    scene: &Scene,
    images: &Images,
    root: NodeId,
    left_out: &LeftOut,
) -> Result<Graph, Error> {
    let mut graph = Graph::default();
    let mut compiler = Compiler {
        scene,
        images,
        left_out,
        uses: scene.uses(root),
        interner: Interner::new(&mut graph),
        graph,
        shared: FxHashMap::default(),
        textures: FxHashMap::default(),
        pending: Vec::new(),
        drafts: Vec::new(),
    };
    compiler.draft_all(root)?;
    compiler.finish_all()
}

/// The error about a record that asks for something that cannot be drawn. `what` is the name of a message in the
/// catalogues; `id` is the entity of the record, 0 if there is none.
pub(in crate::trace) fn cannot_draw(what: &'static str, span: Span, id: u32) -> Error {
    let what = Complaint::new(what);
    Error::at(
        span,
        match id {
            0 => what,
            id => Complaint::new("cannot-draw")
                .with("what", what)
                .with("id", id.to_string()),
        },
    )
}

/// A node as seen from the object that is being drafted: below transformations, properties and
/// complements that have been folded.
#[derive(Clone, Copy)]
struct PlacedNode {
    node: NodeId,
    negated: bool,
    matrix: Matrix,
    coat: Coat,
    /// ID of the outermost entity above that was given properties; 0 if there is none.
    owner: u32,
    /// ID of the outermost entity above that is a copy of this node's entity; 0 if there is none.
    copy: u32,
    /// Whether some node on the way down is used elsewhere too.
    shared: bool,
}

/// An operation with its operands, before the operands' bounds are known.
pub(in crate::trace) struct Draft {
    /// The number of the operation's node. Operands have smaller numbers, so drafts finished in this order are finished
    /// operands first.
    pub rank: u64,
    pub kind: Kind,
    pub first: Vec<Part>,
    pub cuts: Vec<Part>,
}

#[derive(Clone, Copy, PartialEq)]
pub(in crate::trace) enum Kind {
    Union,
    Intersection,
    Difference,
}

pub(in crate::trace) struct Compiler<'a> {
    scene: &'a Scene,
    images: &'a Images,
    /// The operands that are left out. They count among the uses all the same, so that nothing else is shared or placed
    /// differently.
    left_out: &'a LeftOut,
    uses: Vec<u32>,
    pub graph: Graph,
    pub interner: Interner,
    /// The objects of shared nodes, by the node and whether it is complemented.
    shared: FxHashMap<(NodeId, bool), u32>,
    /// The index in the graph of each texture that is there, by its paint record.
    textures: FxHashMap<u32, u32>,
    /// The objects that are still to be drafted, and their places.
    pending: Vec<(u32, PlacedNode)>,
    pub drafts: Vec<Draft>,
}

impl Compiler<'_> {
    /// Drafts the root, always as a union, and all objects that it is made of.
    fn draft_all(&mut self, root: NodeId) -> Result<(), Error> {
        let top = PlacedNode {
            node: root,
            negated: false,
            matrix: Matrix::IDENTITY,
            coat: Coat::default(),
            owner: 0,
            copy: 0,
            shared: false,
        };
        self.drafts.push(Draft {
            rank: u64::MAX,
            kind: Kind::Union,
            first: Vec::new(),
            cuts: Vec::new(),
        });
        if !self.left_out.all() {
            self.draft_union(0, top)?;
        }
        while let Some((object, place)) = self.pending.pop() {
            match self.kind(&place) {
                Kind::Union => self.draft_union(object, place)?,
                Kind::Intersection => self.draft_intersection(object, place)?,
                Kind::Difference => self.draft_difference(object, place)?,
            }
        }
        Ok(())
    }

    /// Folds transformations, properties, copies and complements down to a shape or an operation.
    fn resolve(&mut self, mut place: PlacedNode) -> Result<PlacedNode, Error> {
        loop {
            let node = self.scene.nodes[place.node as usize];
            place.shared |= self.uses[place.node as usize] > 1;
            match node {
                Node::Shape(_)
                | Node::Union(..)
                | Node::Intersection(..)
                | Node::Difference(..) => return Ok(place),
                Node::Complement(child) => {
                    place.negated = !place.negated;
                    place.copy = 0;
                    place.node = child;
                }
                Node::Copy { child, id } => {
                    place.copy = outermost(place.copy, id);
                    place.node = child;
                }
                Node::Transform { child, matrix } => {
                    place.matrix = place.matrix.after(&self.scene.matrices[matrix as usize]);
                    place.node = child;
                }
                Node::Paint { child, paint } => {
                    let giver = self.scene.paints[paint as usize].owner;
                    place.owner = outermost(place.owner, outermost(place.copy, giver));
                    self.fold_paint(&mut place, paint)?;
                    place.node = child;
                }
            }
        }
    }

    /// Adds to the coat the properties that the paint sets and that no paint above has set.
    fn fold_paint(&mut self, place: &mut PlacedNode, paint: u32) -> Result<(), Error> {
        let record = &self.scene.paints[paint as usize];
        if let (None, Some(texture)) = (place.coat.texture, &record.texture) {
            let bitmap = match texture {
                Texture::Image { file, span } => Some(
                    self.images
                        .get(file)
                        .ok_or_else(|| cannot_draw("draw-no-picture", *span, record.owner))?,
                ),
                _ => None,
            };
            let graph = &mut self.graph;
            let number = *self.textures.entry(paint).or_insert_with(|| {
                graph.textures.push(texture.clone());
                graph.bitmaps.push(bitmap.cloned());
                graph.textures.len() as u32 - 1
            });
            place.coat.texture = Some((number, self.matrix(&place.matrix)?));
        }
        if let (None, Some(optics)) = (place.coat.optics, record.optics) {
            place.coat.optics = Some(self.interner.optics(&mut self.graph, optics));
        }
        if let (None, Some(index)) = (place.coat.index, record.index) {
            place.coat.index = Some(self.interner.index(&mut self.graph, index));
        }
        Ok(())
    }

    /// The index of a matrix in the graph, to which it is added if it is new.
    pub(super) fn matrix(&mut self, m: &Matrix) -> Result<u32, Error> {
        self.interner.matrix(&mut self.graph, m).ok_or_else(|| {
            let render = self.scene.render;
            let span = render.map(|r| r.span).unwrap_or_default();
            cannot_draw("draw-matrix", span, render.map_or(0, |r| r.root_id))
        })
    }

    /// The operation that a resolved place stands for after its complement is driven inwards.
    fn kind(&self, place: &PlacedNode) -> Kind {
        match (self.scene.nodes[place.node as usize], place.negated) {
            (Node::Intersection(..) | Node::Difference(..), true) => Kind::Union,
            (Node::Union(..), true) | (Node::Intersection(..), false) => Kind::Intersection,
            (Node::Difference(..), false) => Kind::Difference,
            _ => Kind::Union,
        }
    }

    /// The two operands of the operation at a place, complements driven inwards; a difference is
    /// read as A ∩ −B. `None` for a shape.
    fn operands(&self, place: &PlacedNode) -> Option<[PlacedNode; 2]> {
        let (a, b, flip) = match self.scene.nodes[place.node as usize] {
            Node::Union(a, b) | Node::Intersection(a, b) => (a, b, false),
            Node::Difference(a, b) => (a, b, true),
            _ => return None,
        };
        let operand = |node, flip: bool| PlacedNode {
            node,
            negated: place.negated != flip,
            copy: 0,
            shared: false,
            ..*place
        };
        Some([operand(a, false), operand(b, flip)])
    }

    /// A part for a resolved place: a shape, or an object that is drafted now or already shared.
    fn part(&mut self, place: &PlacedNode) -> Result<Part, Error> {
        let paint = self.interner.paint(&mut self.graph, place.coat);
        if let Node::Shape(shape) = self.scene.nodes[place.node as usize] {
            let record = &self.scene.shapes[shape as usize];
            let primitive = Primitive::new(&record.geometry);
            return Ok(Part {
                target: Target::Shape(self.interner.primitive(&mut self.graph, primitive, shape)),
                placement: self.matrix(&place.matrix)?,
                paint,
                inverted: place.negated,
                shape: outermost(place.copy, record.id),
                owner: place.owner,
            });
        }
        if !place.shared {
            return Ok(Part {
                target: Target::Object(self.draft(*place)),
                placement: 0,
                paint: 0,
                inverted: false,
                shape: 0,
                owner: 0,
            });
        }
        let key = (place.node, place.negated);
        let object = match self.shared.get(&key) {
            Some(&object) => object,
            None => {
                let object = self.draft(PlacedNode {
                    matrix: Matrix::IDENTITY,
                    coat: Coat::default(),
                    owner: 0,
                    ..*place
                });
                self.shared.insert(key, object);
                object
            }
        };
        Ok(Part {
            target: Target::Object(object),
            placement: self.matrix(&place.matrix)?,
            paint,
            inverted: false,
            shape: 0,
            owner: place.owner,
        })
    }

    /// Reserves an object for the operation at a place.
    fn draft(&mut self, place: PlacedNode) -> u32 {
        let object = self.drafts.len() as u32;
        self.drafts.push(Draft {
            rank: place.node as u64,
            kind: self.kind(&place),
            first: Vec::new(),
            cuts: Vec::new(),
        });
        self.pending.push((object, place));
        object
    }

    /// Collects the operands of a chain of unions, in order.
    fn draft_union(&mut self, object: u32, top: PlacedNode) -> Result<(), Error> {
        let mut parts = Vec::new();
        let mut stack = vec![top];
        let mut at_top = object != 0;
        while let Some(place) = stack.pop() {
            let place = self.resolve(place)?;
            let open = at_top || !place.shared;
            at_top = false;
            match self.operands(&place) {
                Some([a, b]) if open && self.kind(&place) == Kind::Union => {
                    stack.extend(self.left_out.kept(place.node, [a, b]).rev());
                }
                _ => parts.push(self.part(&place)?),
            }
        }
        self.drafts[object as usize].first = parts;
        Ok(())
    }

    /// Collects the operands of a chain of intersections, in order; complements become cuts.
    fn draft_intersection(&mut self, object: u32, top: PlacedNode) -> Result<(), Error> {
        let (mut first, mut cuts) = (Vec::new(), Vec::new());
        let mut stack = vec![top];
        let mut at_top = true;
        while let Some(place) = stack.pop() {
            let place = self.resolve(place)?;
            let open = at_top || !place.shared;
            at_top = false;
            match self.operands(&place) {
                Some([a, b]) if open && self.kind(&place) == Kind::Intersection => {
                    stack.extend([b, a]);
                }
                _ if place.negated => {
                    let positive = PlacedNode {
                        negated: false,
                        ..place
                    };
                    cuts.push(self.part(&positive)?);
                }
                _ => first.push(self.part(&place)?),
            }
        }
        let draft = &mut self.drafts[object as usize];
        (draft.first, draft.cuts) = (first, cuts);
        Ok(())
    }

    /// Collects the operands of a chain of differences: A − B − C is A − (B ∪ C). Goes down the left side and collects
    /// the operands that are taken away.
    fn draft_difference(&mut self, object: u32, top: PlacedNode) -> Result<(), Error> {
        let mut taken = Vec::new();
        let mut place = top;
        let mut at_top = true;
        loop {
            place = self.resolve(place)?;
            let open = at_top || !place.shared;
            at_top = false;
            match self.operands(&place) {
                Some([a, b]) if open && self.kind(&place) == Kind::Difference => {
                    // `operands` has read B as −B; what is taken away is B itself.
                    taken.push(PlacedNode {
                        negated: !b.negated,
                        ..b
                    });
                    place = a;
                }
                _ => break,
            }
        }
        let first = vec![self.part(&place)?];
        let mut cuts = Vec::new();
        while let Some(cut) = taken.pop() {
            let cut = self.resolve(cut)?;
            match self.operands(&cut) {
                // The operands of a union may be taken away one by one, in any order.
                Some(both) if !cut.shared && self.kind(&cut) == Kind::Union => taken.extend(both),
                _ => cuts.push(self.part(&cut)?),
            }
        }
        let draft = &mut self.drafts[object as usize];
        (draft.first, draft.cuts) = (first, cuts);
        Ok(())
    }
}
