//! W311: a bounding volume that does not hold its object. The proof is a point of the object's
//! surface outside of it.

use std::cell::Cell;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::geometry::array::{sub, unit};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::rays::{Bare, RAYS, Search, regions, tracer};
use crate::lint::spelling::near;
use crate::lint::spelling::spelled;
use crate::scene::bounds::node_bounds;
use crate::scene::record::Params;
use crate::scene::{NodeId, Promise, Scene, Vec3, Volume};
use crate::solids::distance_field::{Field, Slope};
use crate::solids::extent::{WRITTEN, beyond, farthest_leaf, size};
use crate::solids::inside::Inside;
use crate::solids::lowest::lowest;
use crate::solids::outline::{DIRECTIONS, Met, Outline};
use crate::solids::tree::Tree;

/// Nodes gone through for all bounding volumes of a file together.
const NODES: usize = 700_000;

/// Rays for one of them at least, as long as there are any: enough to look at one box.
const RAYS_EACH: usize = 75;

/// What the closer look may cost where nothing has been met, for one volume and for all together: some
/// tenths of a second. Objects of more nodes are not looked at.
const CLOSE: usize = 60_000;
const CLOSE_ALL: usize = 6_000_000;
const CLOSE_NODES: usize = 128;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.promises.is_empty() {
        return;
    }
    let bounds = context.bounds();
    let mut rays = RAYS;
    let mut nodes = NODES;
    let mut close = CLOSE_ALL;
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
        let copy = (part.nodes.len() <= CLOSE_NODES).then(|| part.clone());
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
        // So finely that the place named is outside too.
        let out_by = beyond(&promise.volume, met.point);
        let [x, y, z] = met.point.map(|x| near(x, out_by));
        let mut d = Diagnostic::new(Code::W311, p.span_of(0, p.len()))
            .case(match promise.volume {
                Volume::Box { .. } => "",
                Volume::Sphere { .. } => "sphere",
            })
            .with("id", promise.id.to_string())
            .with("x", x)
            .with("y", y)
            .with("z", z);
        if let Some(fix) = enlarged(&p, promise, &whole, reach) {
            d = d.fix(fix);
        }
        out.push(d);
    }
}

/// A point of an object's surface outside of its volume, and the largest distance of the object's
/// points from the middle of a sphere.
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
    // What has no end certainly reaches out: it is met close to the volume too.
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

/// The radius of a sphere.
fn radius(volume: &Volume) -> f64 {
    match *volume {
        Volume::Box { .. } => f64::NEG_INFINITY,
        Volume::Sphere { radius, .. } => radius * (1.0 + WRITTEN),
    }
}

/// How far a point is from being outside of a volume by more than some slack.
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

/// A point of the surface outside of a volume, looked for where the object is furthest out: on edges that
/// operations have made, which no ray hits by chance.
fn closely(part: &Scene, volume: &Volume, whole: &Aabb, left: &mut usize) -> Option<Met> {
    /// How often the way out of the object is doubled, and its last step halved.
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
    let share = CLOSE.min(*left) / object.cost.max(1) / regions.len().max(1);
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
    // From there on outwards, up to where the object ends.
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

/// Whether a volume certainly holds a box, up to what may be the rounding of its numbers.
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

/// The volume made large enough: the sides of a box that are too near go where the object's bounds
/// are, the radius of a sphere grows.
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
        applicability: Applicability::Safe,
        edits,
    })
}

/// A number rounded up or down to about six digits of a size; bounds are rounded outwards by some
/// 1e-15, and what is a whole number but for that shall be one, which is a thousand times less than
/// the language lets pass.
fn outwards(x: f64, up: bool, size: f64) -> String {
    const HAIR: f64 = 1e-9;
    let digits = 5 - size.max(f64::MIN_POSITIVE).log10().floor() as i32;
    if !(0..=15).contains(&digits) {
        return spelled(x);
    }
    let steps = 10f64.powi(digits);
    let hair = HAIR * size * steps;
    let whole = match up {
        true => (x * steps - hair).ceil(),
        false => (x * steps + hair).floor(),
    };
    let text = format!("{:.precision$}", whole / steps, precision = digits as usize);
    text.parse().map_or(text, spelled)
}

#[cfg(test)]
mod tests {
    use crate::diagnostics::Applicability;
    use crate::lint::testing::{self, fixed, fixes, messages};

    /// What this rule finds.
    fn found(scene: &str) -> Vec<String> {
        let all = testing::found(scene).into_iter();
        all.filter(|f| f.starts_with("W311")).collect()
    }

    #[test]
    fn a_box_too_small() {
        let scene = "2 9 1.5\n2 -1 1 0 0\n2 -601 -1 # low # -2 -2 2 2 1.25 # high #\n";
        assert_eq!(found(scene), ["W311 3:8"]);
        assert_eq!(
            messages(scene),
            [
                "the bounding box of the object 2 is too small: (2.5, 0, 0) is a point of its surface"
            ]
        );
        assert_eq!(
            fixed(scene),
            "2 9 1.5\n2 -1 1 0 0\n2 -601 -1 # low # -2 -2 2.5 2 1.5 # high #\n"
        );
        assert_eq!(fixes(scene), [("enlarge it".into(), Applicability::Safe)]);
        assert!(found(&fixed(scene)).is_empty());
    }

    #[test]
    fn it_holds_for_the_object_as_it_is_then() {
        // Moved afterwards, and changed in its own coordinates before.
        assert!(found("2 9 1\n2 -601 -1 -1 -1 1 1 1\n2 -1 5 0 0\n").is_empty());
        assert_eq!(
            found("2 9 1\n2 -1 5 0 0\n2 -601 -1 -1 -1 1 1 1\n"),
            ["W311 3:8"]
        );
    }

    #[test]
    fn a_sphere_too_small() {
        let scene = "2 12 -1 -1 -1 1 1 1\n2 -602 0 0 0 1.7\n";
        assert_eq!(found(scene), ["W311 2:8"]);
        assert_eq!(fixed(scene), "2 12 -1 -1 -1 1 1 1\n2 -602 0 0 0 1.73206\n");
        assert!(found(&fixed(scene)).is_empty());
        assert!(found("2 12 -1 -1 -1 1 1 1\n2 -602 0 0 0 1.7321\n").is_empty());
        // A ball within: its own box's corners lie outside.
        assert!(found("2 9 1\n2 -1 3 4 0\n2 -602 0 0 0 6\n").is_empty());
        assert_eq!(found("2 9 1\n2 -1 3 0 0\n2 -602 0 0 0 3.9\n"), ["W311 3:8"]);
    }

    /// What is known exactly is found however little it reaches out: shapes in many places, and
    /// volumes a thousandth too small, or just large enough.
    #[test]
    fn corners_and_rims() {
        let shapes = [
            ("12 -1 -1 -1 1 2 1", 6f64.sqrt()),
            ("16 2 1", 5f64.sqrt()),
            ("17 2 1", 5f64.sqrt()),
            ("1 2 1 -1 1 1", 2f64.sqrt()),
            ("5 -1 -1 1 2", 5f64.sqrt()),
            ("6 0 0 0 1 0 0 0 3 0", 3.0),
            ("9 1", 1.0),
            ("10 1 2 3", 3.0),
            ("13 1 0", 1.0),
            ("13 1 3", 1.0),
            ("14 2 0.5", 2.5),
        ];
        let mut scene = String::new();
        let mut expected = Vec::new();
        for (k, (shape, radius)) in shapes.iter().enumerate() {
            let id = 2 + k;
            scene += &format!(
                "{id} {shape}\n{id} -2 {} 1\n{id} -2 {} 2\n",
                17 * k,
                31 * k + 9
            );
            let line = scene.lines().count() + 1;
            expected.push(format!("W311 {line}:{}", id.to_string().len() + 7));
            scene += &format!("{id} -602 0 0 0 {}\n", radius * 0.999);
            scene += &format!("{id} -602 0 0 0 {}\n", radius * 1.001);
        }
        assert_eq!(found(&scene), expected);
        // The box of a turned square: half of it, and a little less.
        let turned = |half: f64| {
            format!("2 12 -1 -1 -1 1 1 1\n2 -2 45 3\n2 -601 -{half} -{half} -1 {half} {half} 1\n")
        };
        assert!(found(&turned(2f64.sqrt())).is_empty());
        assert_eq!(found(&turned(1.414)).len(), 1);
        // What is cut off does not count, what is left does.
        let cut =
            |r: f64| format!("2 12 -1 -1 -1 1 1 1\n3 4 1 1 0 0\n4 -102 2 3\n4 -602 0 0 0 {r}\n");
        assert_eq!(found(&cut(1.72)).len(), 1);
        let none = "2 12 -1 -1 -1 1 1 1\n3 9 1.5\n4 -102 2 3\n4 -602 0 0 0 1.51\n";
        assert!(found(none).is_empty());
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

    #[test]
    fn the_edge_of_what_may_be_rounding() {
        let sphere = |r: &str| found(&format!("2 9 1\n2 -601 -1 -1 -1 1 1 {r}\n")).len();
        assert_eq!([sphere("0.9999991"), sphere("0.9999989")], [0, 1]);
    }

    #[test]
    fn what_has_no_end() {
        let scene = "2 4 0 1 0 0\n2 -601 -1 -1 -1 1 1 1\n";
        assert_eq!(found(scene), ["W311 2:8"]);
        assert!(fixes(scene).is_empty());
        // A body's tools do not count.
        let cut = "2 9 1\n3 4 0 1 0 0\n4 -103 2 3\n4 -601 -1 -1 -1 1 1 1\n";
        assert!(found(cut).is_empty());
        // Its bounds do not know what is cut off: nothing is met outside.
        let half = "2 9 1\n3 4 0 1 0 0\n4 -103 2 3\n4 -601 -1 0 -1 1 1 1\n";
        assert!(found(half).is_empty());
    }
}
