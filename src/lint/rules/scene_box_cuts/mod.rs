//! W312: the box of the render record cuts what is drawn.
//!
//! The box is there to cut planes, half-spaces, quadrics and other endless shapes: the rule ignores them. The proof of
//! a cut is a point of a bounded shape outside of the box, and one inside. A shape that lies wholly outside is reported
//! as not drawn.

use std::cell::Cell;

use rustc_hash::FxHashSet;

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::geometry::Aabb;
use crate::lint::Context;
use crate::lint::rays::{Bare, RAYS, Search, tracer};
use crate::lint::spelling::near;
use crate::scene::record::Params;
use crate::scene::{Scene, Volume};
use crate::solids::extent::{WRITTEN, beyond, size};
use crate::solids::leaf::Leaf;
use crate::solids::outline::{DIRECTIONS, Outline};
use crate::solids::tree::Tree;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let Some((min, max)) = render.clip else {
        return;
    };
    let Some(p) = context.params(render.span) else {
        return;
    };
    let bounds = context.bounds();
    let whole = &bounds[render.root as usize];
    let clip = Aabb::new(min, max);
    let span = p.span_of(2, 6);
    if let Some((axis, above)) = apart(&whole.all, &clip) {
        let (side, reach) = beyond_side(&whole.all, axis, above);
        out.push(
            Diagnostic::new(Code::W312, p.span_of(side, 1))
                .case("outside")
                .with("id", render.root_id.to_string())
                .with("axis", AXES[axis])
                .with("reach", Value::Decimal(near(reach, clip.radius())))
                .with("name", p.param(side).map_or("", |q| q.name))
                .with("where", if above { "above" } else { "below" }),
        );
        return;
    }
    let volume = Volume::Box { min, max };
    let slack = WRITTEN * size(&volume);
    let inside = |b: &Aabb| {
        b.is_empty() || (0..3).all(|i| min[i] - slack <= b.min[i] && b.max[i] <= max[i] + slack)
    };
    if inside(&whole.bounded()) {
        return;
    }
    let mut tree = Tree::new(scene, bounds, &[render.root]);
    let (unseen, seen): (Vec<Leaf>, Vec<Leaf>) = tree
        .leaves
        .into_iter()
        .partition(|l| apart(&l.bounds, &clip).is_some());
    tree.leaves = seen;
    out.extend(not_drawn(scene, &p, &tree, &unseen, &clip));
    let (ends, endless): (Vec<_>, Vec<_>) =
        (tree.leaves.iter()).partition(|l| l.bounds.is_bounded());
    // Points on endless shapes and on shapes wholly outside prove no cut, though rays may meet them outside of the box.
    let aside: FxHashSet<u32> = endless.into_iter().chain(&unseen).map(|l| l.id).collect();
    let aims = || -> Vec<Aabb> {
        let within = ends.iter().map(|l| l.bounds.intersection(&whole.bounded()));
        within.filter(|b| !b.is_empty()).collect()
    };
    if aims().iter().all(inside) {
        return;
    }
    let outline = Outline {
        left: &Cell::new(DIRECTIONS),
        scene,
        bounds,
        tree: &tree,
        root: render.root,
    };
    let known = (outline.outside(&volume), outline.inside(&volume));
    let met = match known {
        (Some(met), Some(_)) => Some(met),
        (None, _) if outline.is_exact(&volume) => None,
        (known, within) => {
            let part = Bare::new(scene).of(render.root, &mut { usize::MAX });
            let Some(tracer) = part.and_then(tracer) else {
                return;
            };
            let mut search = Search {
                tracer: &tracer,
                rays: &mut { RAYS },
            };
            let counts = |id| !aside.contains(&id);
            let met = known.or_else(|| search.outside(&volume, aims(), counts));
            met.filter(|_| within.is_some() || search.inside(&volume, aims()).is_some())
        }
    };
    let Some(met) = met else { return };
    let leaf = ends.iter().find(|l| l.id == met.shape);
    let Some(shape) = leaf.and_then(|l| l.written(scene)) else {
        return;
    };
    // With enough digits that the printed point is outside, too.
    let out_by = beyond(&volume, met.point);
    let [x, y, z] = met.point.map(|x| near(x, out_by));
    out.push(
        Diagnostic::new(Code::W312, span)
            .with("type", Value::Term(shape.title))
            .with("id", met.shape.to_string())
            .with("x", Value::Decimal(x))
            .with("y", Value::Decimal(y))
            .with("z", Value::Decimal(z))
            .label(shape.span, "shape"),
    );
}

/// The finding about bounded shapes that lie wholly outside of the box: one for all of them, about the first. A shape
/// that is taken away from another object is not drawn anyway.
fn not_drawn(
    scene: &Scene,
    p: &Params,
    tree: &Tree,
    unseen: &[Leaf],
    clip: &Aabb,
) -> Option<Diagnostic> {
    // A shape that occurs in several places may be seen in another one.
    let seen: FxHashSet<u32> = tree.leaves.iter().map(|l| l.id).collect();
    let counts = |l: &&Leaf| {
        l.bounds.is_finite() && !tree.places[l.place as usize].turned && !seen.contains(&l.id)
    };
    let mut all = unseen.iter().filter(counts);
    let leaf = all.next()?;
    let (axis, above) = apart(&leaf.bounds, clip)?;
    let shape = leaf.written(scene)?;
    let (side, reach) = beyond_side(&leaf.bounds, axis, above);
    Some(
        Diagnostic::new(Code::W312, p.span_of(side, 1))
            .case("part")
            .with("type", Value::Term(shape.title))
            .with("id", leaf.id.to_string())
            .with("axis", AXES[axis])
            .with("reach", Value::Decimal(near(reach, clip.radius())))
            .with("name", p.param(side).map_or("", |q| q.name))
            .with("where", if above { "above" } else { "below" })
            .with("others", Value::Count(all.count() as u64))
            .label(shape.span, "shape"),
    )
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The side of the render record's box beyond which all of the box `b` lies, as the index of the side's parameter, and
/// the coordinate at which `b` begins.
fn beyond_side(b: &Aabb, axis: usize, above: bool) -> (usize, f64) {
    match above {
        true => (5 + axis, b.min[axis]),
        false => (2 + axis, b.max[axis]),
    }
}

/// An axis along which the box `b` lies wholly beyond the box `clip`, and whether `b` lies above. `None` if there is
/// none. `b` is rounded outwards and `clip` is as written, so boxes that are found apart are apart.
fn apart(b: &Aabb, clip: &Aabb) -> Option<(usize, bool)> {
    if b.is_empty() {
        return None;
    }
    (0..3).find_map(|i| match (b.min[i] > clip.max[i], b.max[i] < clip.min[i]) {
        (true, _) => Some((i, true)),
        (_, true) => Some((i, false)),
        _ => None,
    })
}
