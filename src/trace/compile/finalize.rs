//! The last pass of compiling: from drafts to objects with bounds and trees.

use super::union_members::{self, Pieces, UnionMember};
use super::{Compiler, Draft, Kind};
use crate::diagnostics::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::solids::shapes::facts::Facts;
use crate::trace::graph::outermost;
use crate::trace::graph::{Coat, Graph, Group, Holds, Object, Operation, Part, Target};
use rustc_hash::FxHashSet;

/// The result of finishing a draft.
enum Finished {
    Object(u32),
    /// A draft that is nothing but this part.
    Alias(Part),
    Empty,
    /// A union of these pieces that is used once: its pieces may become pieces of the operation that uses it.
    Open(Box<Pieces>),
}

impl Compiler<'_> {
    /// Turns the drafts into objects, operands first.
    pub(crate) fn finish_all(mut self) -> Result<Graph, Error> {
        self.uses = Vec::new();
        self.interner.forget_primitives();
        let drafts = std::mem::take(&mut self.drafts);
        let mut order: Vec<u32> = (0..drafts.len() as u32).collect();
        order.sort_by_key(|&i| drafts[i as usize].rank);
        let uses = uses(&drafts);
        let mut drafts: Vec<Option<Draft>> = drafts.into_iter().map(Some).collect();
        let mut finished: Vec<Finished> = drafts.iter().map(|_| Finished::Empty).collect();
        let mut budget = union_members::MAX_BOX_COMPARISONS;
        for i in order {
            let Some(draft) = drafts[i as usize].take() else {
                continue;
            };
            // The root stays an object, whatever it holds.
            let may_vanish = i != 0;
            let stays_open = may_vanish && uses[i as usize] == 1;
            let is_whole = match draft.kind {
                Kind::Intersection => true,
                Kind::Difference => false,
                Kind::Union => !stays_open && !has_open(&draft.first, &finished),
            };
            let made = match is_whole {
                true => self.finish_whole(draft, &mut finished, may_vanish)?,
                false => {
                    let open = self.opened(draft, &mut finished, &mut budget)?;
                    match stays_open {
                        true => Finished::Open(Box::new(open)),
                        false => self.close(open, may_vanish),
                    }
                }
            };
            finished[i as usize] = made;
        }
        if let Finished::Object(root) = finished[0] {
            self.graph.root = root;
        }
        Ok(self.graph)
    }

    /// Makes an object of a draft as it is, without dividing it into pieces.
    fn finish_whole(
        &mut self,
        mut draft: Draft,
        finished: &mut [Finished],
        may_vanish: bool,
    ) -> Result<Finished, Error> {
        let operands = draft.first.len();
        for parts in [&mut draft.first, &mut draft.cuts] {
            *parts = self.settle_all(std::mem::take(parts), finished)?;
        }
        if draft.kind != Kind::Union && draft.first.len() < operands {
            // An intersection or a difference with an empty operand of `first` is empty.
            return Ok(Finished::Empty);
        }
        Ok(self.placed(draft, may_vanish))
    }

    /// The pieces that a union or a difference is made of.
    fn opened(
        &mut self,
        draft: Draft,
        finished: &mut [Finished],
        budget: &mut usize,
    ) -> Result<Pieces, Error> {
        let mut pieces = Pieces::default();
        for part in draft.first {
            pieces = pieces.followed_by(self.pieces(part, finished)?);
        }
        if draft.kind == Kind::Union {
            return Ok(pieces);
        }
        let cuts = self.settle_all(draft.cuts, finished)?;
        let cuts: Vec<(Part, Aabb)> = cuts.into_iter().map(|c| (c, self.bounds(&c))).collect();
        if pieces.cut(&cuts, budget) {
            return Ok(pieces);
        }
        let whole = match self.close(pieces, true) {
            Finished::Object(object) => plain(object),
            Finished::Alias(part) => part,
            Finished::Empty | Finished::Open(_) => return Ok(Pieces::default()),
        };
        let whole = UnionMember {
            cuts: cuts.into_iter().map(|(cut, _)| cut).collect(),
            ..self.piece(whole)
        };
        Ok(Pieces::from_iter([whole]))
    }

    /// The pieces of an operand of a union, or of the solid that a difference cuts.
    fn pieces(&mut self, part: Part, finished: &mut [Finished]) -> Result<Pieces, Error> {
        if let Target::Object(draft) = part.target
            && part.unnamed() == plain(draft)
            && part.owner == 0
            && let Finished::Open(pieces) = &mut finished[draft as usize]
        {
            return Ok(*std::mem::take(pieces));
        }
        let part = self.settle(part, finished)?;
        Ok(part.map(|part| self.piece(part)).into_iter().collect())
    }

    fn piece(&self, part: Part) -> UnionMember {
        UnionMember {
            bounds: self.bounds(&part),
            part,
            cuts: Vec::new(),
        }
    }

    /// Makes an object of the union of pieces. A piece with cuts becomes an object of its own, a difference.
    fn close(&mut self, pieces: Pieces, may_vanish: bool) -> Finished {
        let mut parts = Vec::with_capacity(pieces.len());
        for UnionMember { part, cuts, .. } in pieces {
            if cuts.is_empty() {
                parts.push(part);
                continue;
            }
            let draft = Draft {
                rank: 0,
                kind: Kind::Difference,
                first: vec![part],
                cuts,
            };
            match self.placed(draft, true) {
                Finished::Object(object) => parts.push(plain(object)),
                Finished::Alias(part) => parts.push(part),
                Finished::Empty | Finished::Open(_) => {}
            }
        }
        let union = Draft {
            rank: 0,
            kind: Kind::Union,
            first: parts,
            cuts: Vec::new(),
        };
        self.placed(union, may_vanish)
    }

    /// Finishes a draft and puts its object into the graph.
    fn placed(&mut self, draft: Draft, may_vanish: bool) -> Finished {
        match self.finish(draft, may_vanish) {
            Ok(object) => {
                self.graph.objects.push(object);
                Finished::Object(self.graph.objects.len() as u32 - 1)
            }
            Err(instead) => instead,
        }
    }

    fn settle_all(
        &mut self,
        parts: Vec<Part>,
        finished: &mut [Finished],
    ) -> Result<Vec<Part>, Error> {
        let mut kept = Vec::with_capacity(parts.len());
        for part in parts {
            kept.extend(self.settle(part, finished)?);
        }
        Ok(kept)
    }

    /// Turns a part whose target is a draft into one whose target is finished; `None` if it is empty.
    fn settle(&mut self, part: Part, finished: &mut [Finished]) -> Result<Option<Part>, Error> {
        let Target::Object(draft) = part.target else {
            return Ok(Some(part));
        };
        let below = &mut finished[draft as usize];
        if let Finished::Open(pieces) = below {
            *below = self.close(*std::mem::take(pieces), true);
        }
        match *below {
            Finished::Empty | Finished::Open(_) => Ok(None),
            Finished::Object(object) => Ok(Some(Part {
                target: Target::Object(object),
                ..part
            })),
            Finished::Alias(inner) => {
                let outer = self.graph.matrices[part.placement as usize];
                let matrix = outer.after(&self.graph.matrices[inner.placement as usize]);
                let (over, under) = (
                    self.graph.paints[part.paint as usize],
                    self.graph.paints[inner.paint as usize],
                );
                let texture = match (over.texture, under.texture) {
                    (None, Some((texture, m))) => {
                        let m = outer.after(&self.graph.matrices[m as usize]);
                        Some((texture, self.matrix(&m)?))
                    }
                    (texture, _) => texture,
                };
                let coat = Coat {
                    texture,
                    optics: over.optics.or(under.optics),
                    index: over.index.or(under.index),
                };
                Ok(Some(Part {
                    placement: self.matrix(&matrix)?,
                    paint: self.interner.paint(&mut self.graph, coat),
                    owner: outermost(part.owner, inner.owner),
                    ..inner
                }))
            }
        }
    }

    /// Makes an object of a draft: drops parts that cannot matter, and builds the trees. With `may_vanish`, returns
    /// `Err` with [`Finished::Empty`] or [`Finished::Alias`] if the object is empty or a single part.
    fn finish(&mut self, draft: Draft, may_vanish: bool) -> Result<Object, Finished> {
        let Draft {
            kind,
            mut first,
            mut cuts,
            ..
        } = draft;
        let mut seen = FxHashSet::with_capacity_and_hasher(first.len(), Default::default());
        first.retain(|p| seen.insert(p.unnamed()));
        if kind == Kind::Union {
            if may_vanish {
                match first[..] {
                    [] => return Err(Finished::Empty),
                    [only] => return Err(Finished::Alias(only)),
                    _ => {}
                }
            }
            let mut bounds = Aabb::EMPTY;
            for part in &first {
                bounds = bounds.hull(&self.bounds(part));
            }
            let holds = self.holds(&first);
            let (group, frame) = self.group(first);
            return Ok(Object {
                frame,
                operation: Operation::Union(group),
                bounds,
                holds,
            });
        }
        let mut bounds = Aabb::ALL;
        for part in &first {
            bounds = bounds.intersection(&self.bounds(part));
        }
        // A solid less itself is empty.
        let erased = cuts
            .iter()
            .any(|cut| seen.contains(&cut.unnamed()) && self.is_solid_shape(cut));
        if may_vanish && (bounds.is_empty() || erased) {
            return Err(Finished::Empty);
        }
        let mut seen = FxHashSet::with_capacity_and_hasher(cuts.len(), Default::default());
        cuts.retain(|cut| {
            seen.insert(cut.unnamed()) && !self.bounds(cut).intersection(&bounds).is_empty()
        });
        if let ([only], true, true) = (&first[..], cuts.is_empty(), may_vanish) {
            return Err(Finished::Alias(*only));
        }
        let inherit = kind == Kind::Difference;
        let mut holds = self.holds(&first);
        if !inherit {
            holds = holds.and(self.holds(&cuts));
        }
        let start = self.graph.parts.len() as u32;
        self.graph.parts.extend(first);
        let end = self.graph.parts.len() as u32;
        if start == end && cuts.is_empty() {
            // All of space has a medium, too: it is taken from the part behind `first`, so one is added.
            self.graph.parts.push(Part {
                target: Target::Shape(0),
                placement: 0,
                paint: 0,
                inverted: false,
                shape: 0,
                owner: 0,
            });
        }
        let (cuts, frame) = self.group(cuts);
        Ok(Object {
            frame,
            operation: Operation::Intersection {
                first: start..end,
                cuts,
                inherit,
            },
            bounds,
            holds,
        })
    }

    fn is_solid_shape(&self, part: &Part) -> bool {
        match part.target {
            Target::Shape(p) => self.graph.primitives[p as usize].is_solid(),
            Target::Object(_) => false,
        }
    }

    /// A box around a part, in the space of the object it belongs to.
    fn bounds(&self, part: &Part) -> Aabb {
        if part.inverted {
            return Aabb::ALL;
        }
        let own = match part.target {
            Target::Shape(p) => self.graph.primitives[p as usize].shape().bounds(),
            Target::Object(o) => self.graph.objects[o as usize].bounds,
        };
        let placement = part.placement as usize;
        if placement == 0 {
            return own;
        }
        let image = own.image(&self.graph.placements[placement].out);
        let Target::Shape(p) = part.target else {
            return image;
        };
        // The box around a turned box is larger than the box around the turned shape, so the shape is asked, too.
        let record = self.graph.records[p as usize] as usize;
        let geometry = &self.scene.shapes[record].geometry;
        image.intersection(&geometry.bounds(&self.graph.matrices[placement]))
    }

    /// Adds the parts of an object to the graph. Returns them with their trees, and the units of the trees' boxes.
    fn group(&mut self, parts: Vec<Part>) -> (Group, Frame) {
        let start = self.graph.parts.len() as u32;
        let bounds = |(i, part)| (i, self.bounds(part));
        let numbered: Vec<(u32, Aabb)> = (start..).zip(&parts).map(bounds).collect();
        let bounded = numbered.iter().map(|(_, b)| b).filter(|b| b.is_bounded());
        let frame = Frame::around(bounded);
        let that_hold = |wanted: fn(Holds) -> bool| -> Vec<(u32, Aabb)> {
            let holds = |i: u32| self.graph.holds(&parts[(i - start) as usize]);
            let all = numbered.iter().copied();
            all.filter(|&(i, _)| wanted(holds(i))).collect()
        };
        let [clear, opaque] = [that_hold(|h| h.clear), that_hold(|h| h.opaque)];
        let clear = (!clear.is_empty()).then(|| Box::new(tree(clear, &frame)));
        let opaque = (opaque.len() < numbered.len()).then(|| Box::new(tree(opaque, &frame)));
        let whole = tree(numbered, &frame);
        self.graph.parts.extend(parts);
        let group = Group {
            clear,
            opaque,
            ..whole
        };
        (group, frame)
    }

    /// The sorts of media that these parts hold together.
    fn holds(&self, parts: &[Part]) -> Holds {
        let each = parts.iter().map(|p| self.graph.holds(p));
        each.fold(Holds::default(), Holds::and)
    }
}

/// How often each draft is an operand.
fn uses(drafts: &[Draft]) -> Vec<u32> {
    let mut uses = vec![0; drafts.len()];
    for part in drafts.iter().flat_map(|d| d.first.iter().chain(&d.cuts)) {
        if let Target::Object(draft) = part.target {
            uses[draft as usize] += 1;
        }
    }
    uses
}

/// Whether one of the parts is a union that is still [open](Finished::Open).
fn has_open(parts: &[Part], finished: &[Finished]) -> bool {
    parts.iter().any(|part| match part.target {
        Target::Object(draft) => matches!(finished[draft as usize], Finished::Open(_)),
        Target::Shape(_) => false,
    })
}

/// A part that is an object, without placement and paint.
fn plain(object: u32) -> Part {
    Part {
        target: Target::Object(object),
        placement: 0,
        paint: 0,
        inverted: false,
        shape: 0,
        owner: 0,
    }
}

/// A group of parts, given by their indices and bounds: parts with bounds are in its tree, the others in its list.
fn tree(parts: Vec<(u32, Aabb)>, frame: &Frame) -> Group {
    let (boxes, loose): (Vec<_>, Vec<_>) = parts.into_iter().partition(|(_, b)| b.is_bounded());
    Group {
        loose: loose.into_iter().map(|(i, _)| i).collect(),
        tree: Tree::new(boxes, frame),
        clear: None,
        opaque: None,
    }
}
