//! The way down from a node to the shape or operation that it stands for. The nodes on the way are written as
//! modifiers, or not at all: transformations, paints, copies, complements, and operations that only one operand counts
//! in.

use crate::scene::{Node, NodeId};
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::state::{Appearance, Key, Layer, Medium, State};
use crate::translate::pov::model::tables::{DEFAULT, TextureUse};
use crate::translate::pov::tree::Modifier;

/// The node at the end of the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum End {
    /// The empty set: no solid to draw or to cut with.
    Nothing,
    /// All space.
    Everything,
    Shape(u32, State),
    /// A node that other nodes use, too, so that it is declared by itself.
    Shared(Key),
    /// A union whose operands both count.
    Union(NodeId, NodeId, State),
    Intersection(NodeId, NodeId, State),
    Difference(NodeId, NodeId, State),
    /// The surfaces of each operand that lie inside the solids of the other.
    CrossedSurfaces(NodeId, NodeId, State),
    /// The node's solids and surfaces have to be written separately.
    Split(NodeId, State),
}

/// The nodes with several users at which the way down ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stop {
    AtShared,
    /// Like `AtShared`, but small unions do not get their look as a whole if light goes through them, or through a part
    /// that they touch: each of their parts has to be seen among those of the union around it.
    AmongParts,
    /// Like `AtShared`, but not at the start, since that node is being declared.
    BelowStart,
    Never,
}

pub(crate) struct Descent<'a> {
    pub end: End,
    /// The modifiers on the way, in the order to be written: the innermost first.
    pub modifiers: Vec<Modifier<'a>>,
}

impl Descent<'_> {
    /// The end of the way if there are no modifiers on it; otherwise `None`.
    pub(crate) fn bare(&self) -> Option<End> {
        self.modifiers.is_empty().then_some(self.end)
    }
}

/// Modifiers as they are met: the outermost first.
#[derive(Default)]
struct ModifierStack<'a> {
    modifiers: Vec<Modifier<'a>>,
    inverse: bool,
}

impl<'a> ModifierStack<'a> {
    fn push(&mut self, modifier: Modifier<'a>) {
        match (self.modifiers.last_mut(), modifier) {
            (Some(Modifier::Matrix(outer)), Modifier::Matrix(m)) => *outer = outer.after(&m),
            (_, modifier) => self.modifiers.push(modifier),
        }
    }

    fn end(mut self, end: End) -> Descent<'a> {
        if self.inverse {
            self.modifiers.push(Modifier::Inverse);
        }
        self.modifiers.reverse();
        Descent {
            end,
            modifiers: self.modifiers,
        }
    }
}

impl<'a> Model<'a> {
    /// Goes down from a node as far as the nodes on the way can be modifiers of one object.
    pub(crate) fn descend(&mut self, start: NodeId, state: State, stop: Stop) -> Descent<'a> {
        let (mut node, mut state) = (start, state);
        let mut way = ModifierStack::default();
        loop {
            let f = self.materials[node as usize];
            let solid = f.has_solid && state.layer != Layer::Surface;
            let surface = f.has_surface && state.layer != Layer::Solid;
            if !solid && !surface {
                return way.end(End::Nothing);
            }
            if !(f.has_solid && f.has_surface) {
                // A node with one layer only has the same state whichever layers are asked for.
                state.layer = Layer::All;
            }
            let apart = stop == Stop::AmongParts && f.uses <= 1 && way.modifiers.is_empty();
            if !(apart && self.is_union_of_parts(node, state.look)) {
                if !self.settle_medium(node, &mut state, surface, &mut way) {
                    return way.end(End::Split(node, state));
                }
                let (look, modifier) = self.settle_look(node, state.look);
                state.look = look;
                modifier.into_iter().for_each(|m| way.push(m));
            }
            let may_stop = match stop {
                Stop::AtShared | Stop::AmongParts => true,
                Stop::BelowStart => node != start,
                Stop::Never => false,
            };
            if may_stop && f.uses > 1 {
                return way.end(End::Shared(Key { node, state }));
            }
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => return way.end(End::Shape(shape, state)),
                Node::Copy { child, .. } => node = child,
                Node::Transform { child, matrix } => {
                    way.push(Modifier::Matrix(self.scene.matrices[matrix as usize]));
                    state.look = self.look_below(state.look, matrix);
                    let m = &self.scene.matrices[matrix as usize];
                    state.flush = state.flush.and_then(|f| self.changes.moved_back(f, m));
                    node = child;
                }
                Node::Paint { child, paint } => {
                    // A look that is the same in the whole node was given by `settle_look` already; any other is handed
                    // down.
                    let given = self.tables.paint(paint);
                    if let Appearance::Own { texture, optics } = &mut state.look {
                        *texture = texture.or(given.texture.map(TextureUse::here));
                        *optics = optics.or(given.optics);
                    }
                    node = child;
                }
                Node::Complement(child) => {
                    if !self.materials[child as usize].has_solid {
                        return way.end(End::Everything);
                    }
                    way.inverse = !way.inverse;
                    state.flush = state.flush.map(|f| self.changes.turned(f));
                    state.layer = Layer::Solid;
                    node = child;
                }
                Node::Union(a, b) => {
                    let shows = |id: NodeId| {
                        let f = self.materials[id as usize];
                        (f.has_solid && solid) || (f.has_surface && surface)
                    };
                    match (a == b, shows(a), shows(b)) {
                        (false, true, true) => return way.end(End::Union(a, b, state)),
                        (_, true, _) => node = a,
                        _ => node = b,
                    }
                }
                Node::Intersection(..) | Node::Difference(..) if solid && surface => {
                    return way.end(End::Split(node, state));
                }
                Node::Intersection(a, b) if solid => {
                    state.layer = Layer::Solid;
                    if a != b {
                        self.one_medium(node, a, &mut state, &mut way);
                        return way.end(End::Intersection(a, b, state));
                    }
                    node = a;
                }
                Node::Intersection(a, b) => {
                    state.layer = Layer::Surface;
                    let (of_a, of_b) = (self.materials[a as usize], self.materials[b as usize]);
                    let a_shows = of_a.has_surface && of_b.has_solid;
                    let b_shows = of_b.has_surface && of_a.has_solid;
                    if a_shows && b_shows && a != b {
                        return way.end(End::CrossedSurfaces(a, b, state));
                    }
                    let (shown, by) = if a_shows { (a, b) } else { (b, a) };
                    way.push(Modifier::inside(self.refer(by, State::GEOMETRY)));
                    node = shown;
                }
                Node::Difference(a, b) if solid => {
                    state.layer = Layer::Solid;
                    if self.materials[b as usize].has_solid {
                        return way.end(End::Difference(a, b, state));
                    }
                    node = a;
                }
                Node::Difference(a, b) => {
                    state.layer = Layer::Surface;
                    way.push(Modifier::outside(self.refer(b, State::GEOMETRY)));
                    node = a;
                }
            }
        }
    }

    /// Whether a node is a union of a few parts, and light goes through it or through a part that it touches.
    fn is_union_of_parts(&self, node: NodeId, look: Appearance) -> bool {
        let counts = self.is_transparent(node, look) || self.beside_clear.contains(&node);
        if !matches!(look, Appearance::Own { .. }) || !counts {
            return false;
        }
        let mut todo = vec![node];
        let mut parts = 0;
        while let Some(node) = todo.pop() {
            match self.scene.nodes[node as usize] {
                Node::Union(a, b) => todo.extend([a, b]),
                _ => parts += 1,
            }
            if !self.budget.spend(Limit::PartsSplit, parts + todo.len()) {
                return false;
            }
        }
        parts > 1
    }

    /// Gives the node's inside its index, if that is the same everywhere. `false` if surfaces would get the index, too.
    fn settle_medium(
        &mut self,
        node: NodeId,
        state: &mut State,
        surface: bool,
        way: &mut ModifierStack<'a>,
    ) -> bool {
        let f = self.materials[node as usize];
        if state.medium == Medium::Above {
            return true;
        }
        if !f.has_solid || state.layer == Layer::Surface {
            state.medium = Medium::Above;
        } else if f.index.uniform && !self.is_of_several(node, state.look) {
            if f.index.first != DEFAULT && self.is_transparent(node, state.look) {
                if surface {
                    return false;
                }
                way.push(self.index(f.index.first));
            }
            state.medium = Medium::Above;
        }
        true
    }

    /// Whether a node of one index has several optics, and its parts give the index themselves: where they meet, each
    /// has to be an object of its own.
    fn is_of_several(&self, node: NodeId, look: Appearance) -> bool {
        let open = matches!(look, Appearance::Own { optics: None, .. });
        let gives = match self.scene.nodes[node as usize] {
            Node::Paint { paint, .. } => self.tables.paint(paint).index.is_some(),
            _ => false,
        };
        open && !gives && !self.materials[node as usize].optics.uniform
    }

    /// Decides on one medium for the inside of a whole solid: the first operand's.
    fn one_medium(
        &mut self,
        node: NodeId,
        first: NodeId,
        state: &mut State,
        way: &mut ModifierStack<'a>,
    ) {
        if state.medium == Medium::Own {
            let index = self.materials[first as usize].index;
            if index.first != DEFAULT && self.is_transparent(node, state.look) {
                way.push(self.index(index.first));
            }
            state.medium = Medium::Above;
            if !index.uniform {
                self.media_are_approximate();
            }
        }
    }
}
