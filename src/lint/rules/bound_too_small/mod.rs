//! W311: a bounding volume that does not hold its object. The proof is a point of the object's surface outside of the
//! volume.

use std::cell::Cell;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::array::{sub, unit};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::rays::{Bare, RAYS, Search, regions, tracer};
use crate::lint::spelling::near;
use crate::lint::spelling::spelled;
use crate::scene::record::Params;
use crate::scene::{NodeId, Promise, Scene, Vec3, Volume};
use crate::solids::bounds::node_bounds;
use crate::solids::distance_field::{Field, Slope};
use crate::solids::extent::{WRITTEN, beyond, farthest_leaf, size};
use crate::solids::inside::Inside;
use crate::solids::lowest::lowest;
use crate::solids::outline::{DIRECTIONS, Met, Outline};
use crate::solids::tree::Tree;

/// Most nodes visited, for all bounding volumes of a file together.
const NODES: usize = 700_000;

/// Least number of rays for one bounding volume, as long as any are left: enough to search one box.
const RAYS_EACH: usize = 75;

/// Most steps of the closer look at one volume, if no ray has met the object outside of it.
const MAX_CLOSE_LOOK_STEPS: usize = 60_000;
/// Most steps of closer looks for all volumes together: some tenths of a second.
const MAX_CLOSE_LOOK_STEPS_IN_ALL: usize = 6_000_000;
/// Most nodes of an object that gets a closer look.
const MAX_CLOSE_LOOK_NODES: usize = 128;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.promises.is_empty() {
        return;
    }
    let bounds = context.bounds();
    let mut rays = RAYS;
    let mut nodes = NODES;
    let mut close = MAX_CLOSE_LOOK_STEPS_IN_ALL;
    let directions = Cell::new(DIRECTIONS);
    let mut bare = Bare::new(scene);
    for (i, promise) in scene.promises.iter().enumerate() {
        let whole = bounds[promise.node as usize].all;
        if whole.is_empty() || held(&promise.volume, &whole) {
            continue;
        }
        let Some(part) = bare.of(promise.node, &mut nodes) else {
            continue;
        };
        let still = scene.promises.len() - i;
        let mut share = (rays / still).max(RAYS_EACH).min(rays);
        rays -= share;
        let copy = (part.nodes.len() <= MAX_CLOSE_LOOK_NODES).then(|| part.clone());
        let (mut met, reach) = search(part, promise, &whole, &mut share, &directions);
        if met.is_none()
            && let Some(part) = &copy
            && reach > radius(&promise.volume)
        {
            met = closely(part, &promise.volume, &whole, &mut close);
        }
        rays += share;
        let Some(met) = met else { continue };
        let Some(p) = context.params(promise.span) else {
            continue;
        };
        // With enough digits that the printed point is outside, too.
        let out_by = beyond(&promise.volume, met.point);
        let [x, y, z] = met.point.map(|x| near(x, out_by));
        let mut d = Diagnostic::new(Code::W311, p.span_of(0, p.len()))
            .case(match promise.volume {
                Volume::Box { .. } => "",
                Volume::Sphere { .. } => "sphere",
            })
            .with("id", promise.id.to_string())
            .with("x", Value::Decimal(x))
            .with("y", Value::Decimal(y))
            .with("z", Value::Decimal(z));
        if let Some(fix) = enlarged(&p, promise, &whole, reach) {
            d = d.fix(fix);
        }
        out.push(d);
    }
}

/// Searches for a point of an object's surface outside of its volume. Returns the point, if one is found, and for a
/// bounding sphere an upper bound of the distance of the object's points from its centre (infinity for a box).
fn search(
    part: Scene,
    promise: &Promise,
    whole: &Aabb,
    rays: &mut usize,
    directions: &Cell<usize>,
) -> (Option<Met>, f64) {
    let volume = &promise.volume;
    let bounds = node_bounds(&part);
    let root = part.nodes.len() as NodeId - 1;
    let tree = Tree::new(&part, &bounds, &[root]);
    let reach = match *volume {
        Volume::Sphere { centre, .. } => farthest_leaf(&part, &tree, whole, centre),
        Volume::Box { .. } => f64::INFINITY,
    };
    if let Volume::Sphere { radius, .. } = *volume
        && reach <= radius + WRITTEN * size(volume)
    {
        return (None, reach);
    }
    let outline = Outline {
        left: directions,
        scene: &part,
        bounds: &bounds,
        tree: &tree,
        root,
    };
    let known = outline.outside(volume);
    let spent = *rays == 0 || directions.get() == 0;
    if known.is_some() || spent || outline.is_exact(volume) {
        return (known, reach);
    }
    // An endless shape certainly reaches out of the volume, and rays near the volume meet it, too.
    let around = around(volume);
    let aims = (tree.leaves.iter())
        .map(|l| l.bounds.intersection(whole))
        .map(|b| match b.is_finite() || b.is_empty() {
            true => b,
            false => b.intersection(&around),
        })
        .filter(|b| !b.is_empty())
        .collect();
    let Some(tracer) = tracer(part) else {
        return (None, reach);
    };
    let mut search = Search {
        tracer: &tracer,
        rays,
    };
    (search.outside(volume, aims, |_| true), reach)
}

/// The radius of a sphere, larger by the rounding of its written numbers; −∞ for a box.
fn radius(volume: &Volume) -> f64 {
    match *volume {
        Volume::Box { .. } => f64::NEG_INFINITY,
        Volume::Sphere { radius, .. } => radius * (1.0 + WRITTEN),
    }
}

/// The distance by which a point falls short of being outside of a volume by more than `slack` (negative if it is), and
/// the direction in which that distance grows.
fn within(volume: &Volume, p: Vec3, slack: f64) -> Slope {
    let distance = slack - beyond(volume, p);
    let up = match *volume {
        Volume::Sphere { centre, .. } => unit(sub(centre, p)).unwrap_or([1.0, 0.0, 0.0]),
        Volume::Box { min, max } => {
            let out = |i: usize| (p[i] - max[i]).max(min[i] - p[i]);
            let most = (0..3).fold(0, |m, i| if out(i) > out(m) { i } else { m });
            let up = if p[most] - max[most] > min[most] - p[most] {
                -1.0
            } else {
                1.0
            };
            std::array::from_fn(|i| if i == most { up } else { 0.0 })
        }
    };
    Slope { distance, up }
}

/// Searches for a point of the surface outside of a volume where the object reaches furthest out: on edges that
/// operations have made, which no ray hits by chance.
fn closely(part: &Scene, volume: &Volume, whole: &Aabb, left: &mut usize) -> Option<Met> {
    /// Most doublings of the step that leads out of the object, and halvings of the last step.
    const DOUBLINGS: usize = 40;
    const HALVINGS: usize = 60;
    let bounds = node_bounds(part);
    let root = part.nodes.len() as NodeId - 1;
    let mut object = Field::new(part, root, &Matrix::IDENTITY)?;
    let mut inside = Inside::new(part, &bounds);
    let slack = WRITTEN * size(volume);
    let place = match whole.is_finite() {
        true => *whole,
        false => whole.intersection(&around(volume)),
    };
    let regions = regions(volume, &place);
    let share = MAX_CLOSE_LOOK_STEPS.min(*left) / object.cost.max(1) / regions.len().max(1);
    let mut holds = |p: Vec3| inside.node(root, p) == Some(true);
    let found = regions.iter().find_map(|region| {
        let mut points = share;
        let slopes = |p| [object.at(p), within(volume, p, slack)];
        let is_out = |p| beyond(volume, p) > slack && holds(p);
        let found = lowest(region, slack, &mut points, slopes, is_out);
        *left = left.saturating_sub((share - points) * object.cost);
        found
    });
    let p = found?;
    // The point moves on outwards, up to where the object ends.
    let way = within(volume, p, slack).up.map(|x| -x * size(volume));
    let at = |t: f64| -> Vec3 { std::array::from_fn(|i| p[i] + t * way[i]) };
    let steps = (0..DOUBLINGS).map(|k| WRITTEN * 2f64.powi(k as i32));
    let mut off = steps.into_iter().find(|&t| !holds(at(t)))?;
    let mut on = 0.0;
    for _ in 0..HALVINGS {
        let middle = (on + off) / 2.0;
        match holds(at(middle)) {
            true => on = middle,
            false => off = middle,
        }
    }
    let shape = 0;
    Some(Met {
        point: at(on),
        shape,
    })
}

/// Whether a volume certainly holds a box, up to the rounding of its written numbers. `false` for every sphere:
/// `search` judges spheres.
fn held(volume: &Volume, b: &Aabb) -> bool {
    match volume {
        Volume::Box { .. } => {
            beyond(volume, b.min).max(beyond(volume, b.max)) <= WRITTEN * size(volume)
        }
        Volume::Sphere { .. } => false,
    }
}

/// A box about a volume, of several times its size.
fn around(volume: &Volume) -> Aabb {
    const TIMES: f64 = 3.0;
    let (min, max) = match *volume {
        Volume::Box { min, max } => (min, max),
        Volume::Sphere { centre, radius } => {
            (centre.map(|x| x - radius), centre.map(|x| x + radius))
        }
    };
    let b = Aabb::new(min, max);
    let (middle, reach) = (b.centre(), TIMES * b.radius());
    Aabb::new(middle.map(|x| x - reach), middle.map(|x| x + reach))
}

/// The fix that enlarges the volume: the sides of a box that are too near move to the object's bounds, the radius of a
/// sphere grows to `reach`. `None` if the object has no end.
fn enlarged(p: &Params, promise: &Promise, whole: &Aabb, reach: f64) -> Option<Fix> {
    let mut edits = Vec::new();
    let mut set = |i: usize, x: f64, up: bool, size: f64| {
        edits.push(Edit {
            span: p.span_of(i, 1),
            text: outwards(x, up, size),
        });
    };
    match promise.volume {
        Volume::Box { min, max } if whole.is_finite() => {
            let size = whole.radius();
            for i in (0..3).filter(|&i| whole.min[i] < min[i]) {
                set(i, whole.min[i], false, size);
            }
            for i in (0..3).filter(|&i| whole.max[i] > max[i]) {
                set(i + 3, whole.max[i], true, size);
            }
        }
        Volume::Sphere { .. } if reach.is_finite() => set(3, reach, true, reach),
        _ => return None,
    }
    Some(Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Safe,
        edits,
    })
}

/// Rounds a number up or down, to about six digits of `size`, and writes it. Computed bounds are too large by some
/// 1e-15 of the size, so a number that exceeds a rounded one by less than 1e-9 of the size becomes that one. The
/// language tolerates a thousand times more.
fn outwards(x: f64, up: bool, size: f64) -> String {
    const WHOLE_NUMBER_EPS: f64 = 1e-9;
    let digits = 5 - size.max(f64::MIN_POSITIVE).log10().floor() as i32;
    if !(0..=15).contains(&digits) {
        return spelled(x);
    }
    let steps = 10f64.powi(digits);
    let hair = WHOLE_NUMBER_EPS * size * steps;
    let whole = match up {
        true => (x * steps - hair).ceil(),
        false => (x * steps + hair).floor(),
    };
    let text = format!("{:.precision$}", whole / steps, precision = digits as usize);
    text.parse().map_or(text, spelled)
}

#[cfg(test)]
mod tests {

    use crate::lint::testing::{self};

    /// The findings of this rule.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W311")).collect()
    }

    /// Many volumes share what there is to search with.
    #[test]
    fn the_last_of_many() {
        let mut scene = String::new();
        for id in 2..400 {
            // Nothing reaches out, though nobody can know.
            let (tool, rest) = (id + 1000, id + 2000);
            scene += &format!("{id} 10 1 2 3\n{tool} 9 2.5\n{rest} -102 {id} {tool}\n");
            scene += &format!("{rest} -601 -1 -2 -2.6 1 2 2.6\n");
        }
        scene += "4000 12 -1 -1 -1 1 1 1\n4000 -2 45 3\n4000 -601 -1 -1 -1 1 1 1\n";
        assert_eq!(found(&scene).len(), 1);
    }
}
