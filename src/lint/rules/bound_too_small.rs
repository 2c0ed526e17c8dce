//! W311: a bounding volume that does not hold its object. The proof is a point of the object's
//! surface outside of it.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::solids::reach::{
    RAYS, Search, WRITTEN, bare, beyond, farthest_leaf, size, tracer,
};
use crate::lint::solids::{near, tree::Tree};
use crate::lint::{Context, spelled};
use crate::scene::record::Params;
use crate::scene::{Aabb, Promise, Volume};

/// Nodes gone through for all bounding volumes of a file together.
const NODES: usize = 1_000_000;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.promises.is_empty() {
        return;
    }
    let bounds = context.bounds();
    let mut rays = RAYS;
    let mut nodes = NODES;
    let mut geometry = None;
    for promise in &scene.promises {
        let whole = bounds[promise.node as usize].all;
        if whole.is_empty() || held(&promise.volume, &whole) {
            continue;
        }
        match nodes.checked_sub(promise.node as usize + 1) {
            Some(left) => nodes = left,
            None => return,
        }
        let tree = Tree::new(scene, bounds, &[promise.node]);
        let reach = match promise.volume {
            Volume::Sphere { centre, .. } => farthest_leaf(scene, &tree, &whole, centre),
            Volume::Box { .. } => f64::INFINITY,
        };
        if let Volume::Sphere { radius, .. } = promise.volume
            && reach <= radius
        {
            continue;
        }
        let Some(tracer) = tracer(geometry.get_or_insert_with(|| bare(scene)), promise.node) else {
            return;
        };
        // What has no end certainly reaches out: it is met close to the volume too.
        let around = around(&promise.volume);
        let aims = (tree.leaves.iter())
            .map(|l| l.bounds.intersection(&whole))
            .filter(|b| !b.is_empty())
            .map(|b| {
                if b.is_finite() {
                    b
                } else {
                    b.intersection(&around)
                }
            })
            .filter(|b| !b.is_empty());
        let mut search = Search {
            tracer: &tracer,
            rays: &mut rays,
        };
        let Some(met) = search.outside(&promise.volume, aims.collect(), |_| true) else {
            continue;
        };
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
