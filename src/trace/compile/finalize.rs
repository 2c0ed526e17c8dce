//! The last pass of compiling: from drafts to objects with bounds and trees.

use super::{Compiler, Draft, Kind};
use crate::diagnostics::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::trace::graph::outermost;
use crate::trace::graph::{Coat, Graph, Group, Holds, Object, Operation, Part, Target};
use std::collections::HashSet;

/// What became of a draft.
enum Finished {
    Object,
    /// It is nothing but this part.
    Alias(Part),
    Empty,
}

impl Compiler<'_> {
    /// Turns the drafts into objects, operands first.
    pub fn finish_all(mut self) -> Result<Graph, Error> {
        let drafts = std::mem::take(&mut self.drafts);
        let mut order: Vec<u32> = (0..drafts.len() as u32).collect();
        order.sort_by_key(|&i| drafts[i as usize].rank);
        let mut drafts: Vec<Option<Draft>> = drafts.into_iter().map(Some).collect();
        let mut finished: Vec<Finished> = drafts.iter().map(|_| Finished::Empty).collect();
        // Where the object of a draft ended up.
        let mut places = vec![0u32; drafts.len()];
        for i in order {
            let Some(mut draft) = drafts[i as usize].take() else {
                continue;
            };
            let operands = draft.first.len();
            for parts in [&mut draft.first, &mut draft.cuts] {
                let mut kept = Vec::with_capacity(parts.len());
                for part in parts.drain(..) {
                    kept.extend(self.settle(part, &finished, &places)?);
                }
                *parts = kept;
            }
            if draft.kind != Kind::Union && draft.first.len() < operands {
                // What is in something empty is nowhere; `finished` says so already.
                continue;
            }
            // The root stays an object, whatever it holds.
            finished[i as usize] = match self.finish(draft, i != 0) {
                Ok(object) => {
                    places[i as usize] = self.graph.objects.len() as u32;
                    self.graph.objects.push(object);
                    Finished::Object
                }
                Err(instead) => instead,
            };
        }
        self.graph.root = places[0];
        Ok(self.graph)
    }

    /// A drafted part in terms of finished objects; `None` where it is empty.
    fn settle(
        &mut self,
        part: Part,
        finished: &[Finished],
        places: &[u32],
    ) -> Result<Option<Part>, Error> {
        let Target::Object(draft) = part.target else {
            return Ok(Some(part));
        };
        match finished[draft as usize] {
            Finished::Empty => Ok(None),
            Finished::Object => Ok(Some(Part {
                target: Target::Object(places[draft as usize]),
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

    /// Drops what cannot matter and builds the trees. With `may_vanish`, an object that turns out
    /// to be empty or a single part says so instead.
    fn finish(&mut self, draft: Draft, may_vanish: bool) -> Result<Object, Finished> {
        let Draft {
            kind,
            mut first,
            mut cuts,
            ..
        } = draft;
        let mut seen = HashSet::with_capacity(first.len());
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
            let group = self.group(first);
            return Ok(Object {
                reach: group.reach(),
                operation: Operation::Union(group),
                bounds,
                holds,
            });
        }
        let mut bounds = Aabb::ALL;
        for part in &first {
            bounds = bounds.intersection(&self.bounds(part));
        }
        // A solid less itself is empty, and so is one less something that does not leave a trace.
        let erased = cuts
            .iter()
            .any(|cut| seen.contains(&cut.unnamed()) && self.is_solid_shape(cut));
        if may_vanish && (bounds.is_empty() || erased) {
            return Err(Finished::Empty);
        }
        let mut seen = HashSet::with_capacity(cuts.len());
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
            // All of space has a medium too: that of the part behind `first`.
            self.graph.parts.push(Part {
                target: Target::Shape(0),
                placement: 0,
                paint: 0,
                inverted: false,
                shape: 0,
                owner: 0,
            });
        }
        let cuts = self.group(cuts);
        Ok(Object {
            reach: cuts.reach(),
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
            Target::Shape(p) => self.graph.primitives[p as usize].shape().is_solid(),
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
        match part.placement {
            0 => own,
            m => own.image(&self.graph.placements[m as usize].out),
        }
    }

    fn group(&mut self, parts: Vec<Part>) -> Group {
        let start = self.graph.parts.len() as u32;
        let whole = self.tree((start..).zip(&parts));
        let holds_clear = |p: &Part| self.graph.holds(p).clear;
        let clear = parts.iter().any(holds_clear).then(|| {
            let clear = (start..).zip(&parts).filter(|(_, p)| holds_clear(p));
            Box::new(self.tree(clear))
        });
        self.graph.parts.extend(parts);
        Group { clear, ..whole }
    }

    /// Parts with their numbers: those with bounds in a tree, the others beside it.
    fn tree<'p>(&self, parts: impl Iterator<Item = (u32, &'p Part)>) -> Group {
        let (mut loose, mut boxes) = (Vec::new(), Vec::with_capacity(parts.size_hint().0));
        for (i, part) in parts {
            let bounds = self.bounds(part);
            if bounds.is_bounded() {
                boxes.push((i, bounds));
            } else {
                loose.push(i);
            }
        }
        Group {
            loose,
            bvh: Bvh::new(boxes),
            clear: None,
        }
    }

    /// What some of these parts hold.
    fn holds(&self, parts: &[Part]) -> Holds {
        let each = parts.iter().map(|p| self.graph.holds(p));
        each.fold(Holds::default(), Holds::and)
    }
}
