//! W312: the box of the render record cuts what is drawn.
//!
//! Planes, half-spaces, quadrics and everything else without end are what the box is for: they are
//! passed over. A point of something that ends, outside of the box, and one inside are the proof. Of
//! what lies wholly outside it says that it is not drawn.

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

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let Some((min, max)) = render.clip else {
        return;
    };
    let Some(p) = context.params(render.span) else {
        return;
    };
    let bounds = context.bounds();
    let whole = bounds[render.root as usize];
    let clip = Aabb::new(min, max);
    let span = p.span_of(2, 6);
    if let Some((axis, above)) = apart(&whole.all, &clip) {
        let (side, reach) = beyond_side(&whole.all, axis, above);
        out.push(
            Diagnostic::new(Code::W312, p.span_of(side, 1))
                .case("outside")
                .with("id", render.root_id.to_string())
                .with("axis", AXES[axis])
                .with("reach", near(reach, clip.radius()))
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
    if inside(&whole.bounded) {
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
    // Rays may meet these outside of the box, and they do not reach out of it.
    let aside: FxHashSet<u32> = endless.into_iter().chain(&unseen).map(|l| l.id).collect();
    let aims = || -> Vec<Aabb> {
        let within = ends.iter().map(|l| l.bounds.intersection(&whole.bounded));
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
    let Some(shape) = leaf.and_then(|l| l.shape) else {
        return;
    };
    let shape = &scene.shapes[shape as usize];
    // So finely that the place named is outside too.
    let out_by = beyond(&volume, met.point);
    let [x, y, z] = met.point.map(|x| near(x, out_by));
    out.push(
        Diagnostic::new(Code::W312, span)
            .with("type", Value::Term(shape.ty.title))
            .with("id", met.shape.to_string())
            .with("x", x)
            .with("y", y)
            .with("z", z)
            .label(shape.span, "shape"),
    );
}

/// What is said of shapes that end and lie wholly outside of the box: one finding for all of them, about
/// the first. What is taken away from something is not drawn anyway.
fn not_drawn(
    scene: &Scene,
    p: &Params,
    tree: &Tree,
    unseen: &[Leaf],
    clip: &Aabb,
) -> Option<Diagnostic> {
    // What occurs in several places may be seen in another one.
    let seen: FxHashSet<u32> = tree.leaves.iter().map(|l| l.id).collect();
    let counts = |l: &&Leaf| {
        l.bounds.is_finite() && !tree.places[l.place as usize].turned && !seen.contains(&l.id)
    };
    let mut all = unseen.iter().filter(counts);
    let leaf = all.next()?;
    let (axis, above) = apart(&leaf.bounds, clip)?;
    let shape = &scene.shapes[leaf.shape? as usize];
    let (side, reach) = beyond_side(&leaf.bounds, axis, above);
    Some(
        Diagnostic::new(Code::W312, p.span_of(side, 1))
            .case("part")
            .with("type", Value::Term(shape.ty.title))
            .with("id", leaf.id.to_string())
            .with("axis", AXES[axis])
            .with("reach", near(reach, clip.radius()))
            .with("name", p.param(side).map_or("", |q| q.name))
            .with("where", if above { "above" } else { "below" })
            .with("others", Value::Count(all.count() as u64))
            .label(shape.span, "shape"),
    )
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The side of the box of the render record, as the index of its parameter, beyond which all of another
/// box lies, and where that begins.
fn beyond_side(b: &Aabb, axis: usize, above: bool) -> (usize, f64) {
    match above {
        true => (5 + axis, b.min[axis]),
        false => (2 + axis, b.max[axis]),
    }
}

/// An axis along which a box lies wholly beyond another one, and whether it lies above. The first is
/// rounded outwards, the second is as written: what is so apart is apart.
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

#[cfg(test)]
mod tests {
    use crate::lint::testing::{self, messages};

    /// What this rule finds.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W312")).collect()
    }

    fn boxed(records: &str, region: &str) -> String {
        format!("{records}\n1 9999 2 0 {region}\n")
    }

    #[test]
    fn a_sphere_that_reaches_out() {
        let scene = boxed("2 9 1", "-2 -2 -2 2 2 0.5");
        assert_eq!(found(&scene), ["W312 2:12"]);
        assert_eq!(
            messages(&scene),
            [
                "the box of the render record cuts the scene: the sphere at the origin 2 reaches out of it at (0, 0, 1)"
            ]
        );
        assert!(found(&boxed("2 9 1", "-1 -1 -1 1 1 1")).is_empty());
        // A millionth of the box may be rounding.
        assert!(found(&boxed("2 9 1", "-1 -1 -1 1 1 0.9999995")).is_empty());
        assert_eq!(found(&boxed("2 9 1", "-1 -1 -1 1 1 0.999998")).len(), 1);
    }

    #[test]
    fn what_has_no_end_is_what_the_box_is_for() {
        let region = "-3 -3 -3 3 3 3";
        for record in ["2 3 0 1 0 0", "2 4 0 1 0 0", "2 21", "2 20"] {
            assert!(found(&boxed(record, region)).is_empty(), "{record}");
        }
        // A ball on a floor: the floor is cut, the ball is not.
        assert!(found(&boxed("3 9 1\n4 3 0 1 0 1\n2 -101 3 4", region)).is_empty());
        assert_eq!(
            found(&boxed("3 9 4\n4 3 0 1 0 1\n2 -101 3 4", region)).len(),
            1
        );
        // What is cut out of a ball reaches out of the box, the rest does not.
        let rest = "3 12 -1 -1 -1 1 1 1\n4 11 0 6 0 5.5\n2 -103 3 4";
        assert!(found(&boxed(rest, region)).is_empty());
    }

    #[test]
    fn all_of_it_is_outside() {
        let scene = boxed("2 11 0 5 0 1", "-2 -2 -2 2 2 2");
        assert_eq!(
            messages(&scene),
            [
                "nothing will be seen: all of the object 2 lies outside of the box of the render record, its y is at least 4 everywhere"
            ]
        );
        assert_eq!(found(&scene), ["W312 2:23"]);
        let surface = boxed("2 5 -1 -1 1 1\n2 -1 -9 0 0", "-2 -2 -2 2 2 2");
        assert_eq!(found(&surface).len(), 1);
    }

    #[test]
    fn one_part_is_outside() {
        let region = "-2 -2 -2 2 2 2";
        let three = "3 9 1\n4 11 0 5 0 1\n5 12 1 1 -9 1.5 1.5 -8\n6 -101 3 4\n2 -101 6 5";
        let scene = boxed(three, region);
        assert_eq!(
            messages(&scene),
            [
                "nothing will be seen of the sphere 4: all of it lies outside of the box of the render record, its y is at least 4 everywhere; 1 other part lies outside too"
            ]
        );
        assert_eq!(found(&scene), ["W312 6:23"]);
        // It touches the box: that may be seen.
        let touching = boxed("3 9 1\n4 12 2 0 0 3 1 1\n2 -101 3 4", region);
        let all = messages(&touching);
        assert!(
            all[0].contains("the box 4 reaches out of it at (3, 1, 0)"),
            "{all:?}"
        );
        assert_eq!(all.len(), 1);
        // One lies outside, another one is cut.
        let both = boxed("3 11 0 1.5 0 1\n4 11 0 5 0 1\n2 -101 3 4", region);
        let all = messages(&both);
        assert_eq!(all.len(), 2);
        assert!(all.iter().any(|m| m.contains("of the sphere 4")));
        assert!(
            all.iter()
                .any(|m| m.contains("the sphere 3 reaches out of it at (0, 2.5, 0)"))
        );
        // The same ball in two places, one of them in the box.
        let moved = boxed("4 9 1\n3 -101 4 4\n4 -1 9 0 0\n2 -101 3 4", region);
        assert!(found(&moved).is_empty());
        // A tool is not drawn anyway, and a plane has no end.
        let tool = boxed("3 9 1\n4 11 0 5 0 1\n2 -103 3 4", region);
        assert!(found(&tool).is_empty());
        assert!(found(&boxed("3 9 1\n4 3 0 1 0 -5\n2 -101 3 4", region)).is_empty());
    }

    #[test]
    fn surfaces_and_moved_things() {
        let region = "-2 -2 -2 2 2 2";
        assert_eq!(found(&boxed("2 5 -3 -1 1 1", region)), ["W312 2:12"]);
        assert_eq!(
            found(&boxed("2 12 -1 -1 -1 1 1 1\n2 -1 1.5 0 0", region)),
            ["W312 3:12"]
        );
        assert!(found(&boxed("2 12 -1 -1 -1 1 1 1\n2 -2 30 2", region)).is_empty());
        // A corner just out of it, and just not.
        let turned = |half: &str| {
            boxed(
                "2 12 -1 -1 -1 1 1 1\n2 -2 45 3",
                &format!("-{half} -{half} -2 {half} {half} 2"),
            )
        };
        assert_eq!(found(&turned("1.414")).len(), 1);
        assert!(found(&turned("1.4143")).is_empty());
        // Where several shapes stand and one reaches out by a corner.
        let two = "3 12 -1 -1 -1 1 1 1\n4 16 1 1\n4 -2 40 1\n4 -2 25 2\n4 -1 1.2 0 0\n2 -101 3 4";
        assert_eq!(found(&boxed(two, region)).len(), 1);
        assert!(found(&boxed(two, "-2 -2 -2 3 3 3")).is_empty());
    }
}
