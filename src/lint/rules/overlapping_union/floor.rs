//! Half-spaces that overlap other parts, and would not overlap them with the other sign of d: in other programs the
//! inside is ax + by + cz ≤ d.

use rustc_hash::FxHashMap;

use super::search::{MIN_REL_DEPTH, Overlap};
use super::unions::{UnionOperand, Unions};
use crate::diagnostics::{Fix, Span};
use crate::geometry::Aabb;
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::camera_in_solid::moved;
use crate::scene::Node;
use crate::scene::record::Params;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::sides::Sides;

/// Most half-spaces for which the other sign is tried: each is held against all other parts.
const MAX_HALF_SPACES: usize = 16;

/// The fixes of half-spaces, by the spans of their records.
pub(super) struct Floors(FxHashMap<Span, Fix>);

impl Floors {
    pub(super) fn new(context: &Context, unions: &Unions, found: &[Overlap]) -> Floors {
        let mut order: Vec<&UnionOperand> = Vec::new();
        let mut held: FxHashMap<Span, Vec<Aabb>> = FxHashMap::default();
        for overlap in found {
            let [one, two] = overlap.parts.map(|i| &unions.parts[i as usize]);
            for (floor, other) in [(one, two), (two, one)] {
                // A body that overlaps water or glass is in there on purpose.
                let is_clear = unions.media[floor.medium as usize].transmits();
                if is_clear || half_space(context, floor).is_none() {
                    continue;
                }
                let all = held.entry(floor.named.span).or_default();
                if all.is_empty() {
                    order.push(floor);
                }
                all.push(other.bounds);
            }
        }
        let fix = |floor: &UnionOperand| {
            let fix = other_sign(context, floor, &held[&floor.named.span])?;
            Some((floor.named.span, fix))
        };
        Floors(
            (order.into_iter().take(MAX_HALF_SPACES))
                .filter_map(fix)
                .collect(),
        )
    }

    /// The fix of that of two overlapping parts which is a half-space; `None` if neither has a fix.
    pub(super) fn fix(&self, unions: &Unions, found: &Overlap) -> Option<Fix> {
        let spans = found.parts.map(|i| unions.parts[i as usize].named.span);
        spans.iter().find_map(|span| self.0.get(span)).cloned()
    }
}

/// The record of a part that is a half-space; `None` for other parts.
fn half_space<'c>(context: &'c Context, part: &UnionOperand) -> Option<Params<'c>> {
    let (core, _) = context.scene.core(part.node, part.matrix);
    if !matches!(context.scene.nodes[core as usize], Node::Shape(_)) {
        return None;
    }
    let p = context.params(part.named.span)?;
    let is_one = p.ty.kind == RecordKind::Shape(ShapeKind::HalfSpace);
    (is_one && p.id == part.named.id).then_some(p)
}

/// The fix that gives d the other sign. `None` unless the half-space then holds nothing of the parts that it overlaps,
/// no camera, and no lamp or other part that it does not hold now.
fn other_sign(context: &Context, floor: &UnionOperand, overlapped: &[Aabb]) -> Option<Fix> {
    let scene = context.scene;
    let p = half_space(context, floor)?;
    let sides = Sides::new(scene, context.bounds(), scene.render?.root, floor.named)?;
    let now: [f64; 4] = p.numbers(0);
    let then = [now[0], now[1], now[2], -now[3]];
    let is_clear = |b: &Aabb| b.is_bounded() && sides.is_clear_of(then, b, MIN_REL_DEPTH);
    let holds_more = |place| sides.holds(then, place) && !sides.holds(now, place);
    let is_better = overlapped.iter().all(is_clear)
        && !(chosen_cameras(context).iter()).any(|(c, _)| sides.holds(then, c.position))
        && !scene.point_lights.iter().any(|l| holds_more(l.position))
        && !sides.would_bury(now, then);
    is_better.then(|| moved(&p))
}
