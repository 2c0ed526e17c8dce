//! Random scenes that are valid by construction: no rule sees an error in them, and what those
//! rules say that prove is true, by other means than theirs.

pub mod scenes;

use crate::campaign::rng::Rng;
use crate::support::cases;
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Value, fixes};
use zpg::internals::geometry::Aabb;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::{Node, NodeId, Scene, Volume};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::trace::{Images, Ray, Settings, Tracer, members, selected_camera};

const SCENES: u64 = 500;

fn load(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

fn text(d: &Diagnostic, place: &str) -> String {
    let found = d.values.iter().find(|v| v.0 == place);
    match found.map(|v| &v.1) {
        Some(Value::Text(text)) => text.to_string(),
        Some(Value::Decimal(number)) => number.clone(),
        other => panic!("{place}: {other:?}"),
    }
}

fn witness(d: &Diagnostic) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| text(d, axis).parse().unwrap())
}

fn id(d: &Diagnostic, place: &str) -> u32 {
    text(d, place).parse().unwrap()
}

/// Whether a ray meets the surface of a node near a point that is named to about a thousandth.
fn on_surface(text: &str, node: NodeId, p: [f64; 3], near: f64) -> bool {
    let mut scene = load(text).scene;
    let render = scene
        .render
        .as_mut()
        .expect("every scene has a render record");
    (render.root, render.clip) = (node, None);
    let tracer = Tracer::with_images(&scene, &Images::default()).expect("there are no images");
    let mut walkers = tracer.walker::<f64>();
    let mut rng = Rng::new(7);
    (0..60).any(|_| {
        let direction = Vec3(std::array::from_fn(|_| rng.range(-1.0, 1.0)));
        // Through a point close by, whatever side of the surface it is on.
        let q = Vec3(p.map(|x| x + rng.range(-near, near) / 4.0));
        let ray = Ray::new(q - direction * 3.0, direction);
        tracer
            .crossings(&mut walkers, &ray)
            .iter()
            .any(|c| (c.hit.point - Vec3(p)).length() < near)
    })
}

/// Random points in a node's bounds and around, where it has any.
fn around(rng: &mut Rng, b: &Aabb) -> Vec3 {
    Vec3(std::array::from_fn(|i| {
        let low = b.min[i].max(-8.0);
        let high = b.max[i].min(8.0);
        if low < high {
            rng.range(low, high)
        } else {
            rng.range(-8.0, 8.0)
        }
    }))
}

fn holds(scene: &Scene, node: NodeId, p: Vec3) -> bool {
    members(scene, node, p).is_ok_and(|m| m.in_root)
}

/// The nodes of unions, intersections and differences.
fn operations(scene: &Scene) -> impl Iterator<Item = NodeId> {
    let nodes = (0..).zip(&scene.nodes);
    nodes.filter_map(|(i, node)| node.operands().map(|_| i))
}

/// What is wrong with a finding.
fn refuted(source: &str, loaded: &Analysis, d: &Diagnostic, rng: &mut Rng) -> Option<String> {
    let scene = &loaded.scene;
    let render = scene.render.as_ref()?;
    let wrong = |what: &str| Some(what.to_owned());
    match d.code {
        Code::W307 => {
            let p = witness(d);
            let inside = members(scene, render.root, Vec3(p)).unwrap().inside;
            let both = ["one-id", "two-id"].map(|place| inside.contains(&id(d, place)));
            if both != [true; 2] {
                return wrong("the point is not in both");
            }
            if d.case == "open" {
                // The named place is rounded: something is left close by, and something is not.
                let near = 0.05;
                let mut close = |_| Vec3(p.map(|x| x + rng.range(-near, near)));
                let left: Vec<bool> = (0..400)
                    .map(|k| holds(scene, render.root, close(k)))
                    .collect();
                if left.iter().all(|h| *h) || !left.contains(&true) {
                    return wrong("nothing is cut there");
                }
            }
        }
        Code::W311 => {
            let at = scene
                .promises
                .iter()
                .find(|p| p.span.start <= d.span.start && d.span.end <= p.span.end)?;
            let p = witness(d);
            let out = match at.volume {
                Volume::Box { min, max } => !Aabb::new(min, max).contains(p),
                Volume::Sphere { centre, radius } => (Vec3(p) - Vec3(centre)).length() > radius,
            };
            if !out {
                return wrong("the point is within");
            }
            if !on_surface(source, at.node, p, 0.05) {
                return wrong("the point is not of the surface");
            }
        }
        Code::W312 if d.case == "outside" => {
            let (min, max) = render.clip?;
            let region = Aabb::new(min, max);
            if (0..300).any(|_| holds(scene, render.root, around(rng, &region))) {
                return wrong("there is something in the box");
            }
        }
        Code::W312 if d.case == "part" => {
            let (min, max) = render.clip?;
            let region = Aabb::new(min, max);
            let part = id(d, "id");
            let inside = |p| members(scene, render.root, p).map(|m| m.inside);
            if (0..300).any(|_| inside(around(rng, &region)).is_ok_and(|all| all.contains(&part))) {
                return wrong("the part is in the box");
            }
        }
        Code::W312 => {
            let (min, max) = render.clip?;
            let p = witness(d);
            if Aabb::new(min, max).contains(p) {
                return wrong("the point is within");
            }
            if !on_surface(source, render.root, p, 0.05) {
                return wrong("the point is not of the surface");
            }
        }
        Code::W319 => {
            let operation = id(d, "id");
            let node = operations(scene).find(|&n| scene.origins[n as usize].id == operation)?;
            let bounds = node_bounds(scene);
            let operands = scene.nodes[node as usize].children();
            for child in operands {
                let b = &bounds[child as usize].all;
                if (0..200).any(|_| holds(scene, node, around(rng, b))) {
                    return wrong("there is something in it");
                }
            }
        }
        Code::W321 => {
            let p = witness(d);
            for place in ["tool", "other"] {
                // What a copy of many things holds there goes by the IDs of these.
                let id = id(d, &format!("{place}-id"));
                let held: Vec<bool> = (0..400)
                    .map(|_| {
                        let q = Vec3(p.map(|x| x + rng.range(-0.05, 0.05)));
                        members(scene, render.root, q).is_ok_and(|m| m.inside.contains(&id))
                    })
                    .collect();
                if held.iter().all(|h| *h) || !held.contains(&true) {
                    return wrong("a face is not there");
                }
            }
        }
        _ => {}
    }
    None
}

fn picture(loaded: &Analysis) -> Vec<[u32; 3]> {
    let settings = Settings {
        width: 16,
        height: 12,
        depth: 4,
        ..Settings::default()
    };
    let tracer = Tracer::new(&loaded.scene).unwrap();
    let camera = selected_camera(&loaded.scene, 16.0 / 12.0);
    let picture = tracer.render(&camera, &settings, || ()).unwrap();
    let bits = |c: &[f32; 3]| c.map(f32::to_bits);
    picture.film.pixels.iter().map(bits).collect()
}

/// What is wrong with a fix.
fn harmful(loaded: &Analysis, d: &Diagnostic) -> Option<String> {
    for fix in &d.fixes {
        let (after, count) = fixes::apply(&loaded.source.text, [fix].into_iter());
        let mended = load(&after);
        let of = |l: &Analysis| l.findings().iter().filter(|f| f.code == d.code).count();
        if count != 1 || !mended.is_sound() || of(&mended) > of(loaded) {
            return Some(format!("the fix makes it worse:\n{after}"));
        }
        if fix.applicability == Applicability::Safe {
            if of(&mended) >= of(loaded) {
                return Some(format!("the fix mends nothing:\n{after}"));
            }
            if picture(loaded) != picture(&mended) {
                return Some(format!("the fix changes the picture:\n{after}"));
            }
        }
    }
    None
}

#[test]
fn what_is_said_of_random_scenes_is_true() {
    let mut seen = std::collections::BTreeMap::new();
    let mut wrong = Vec::new();
    for seed in 0..cases(SCENES / 2, SCENES) {
        let source = scenes::scene(seed);
        let loaded = load(&source);
        let mut rng = Rng::new(!seed);
        for d in loaded.findings() {
            *seen.entry(d.code.as_str()).or_insert(0) += 1;
            let message = d
                .wording(zpg::internals::diagnostics::Language::English)
                .message;
            let mut complain = |what: String| {
                wrong.push(format!(
                    "seed {seed}, {}: {message}\n{what}\n{source}",
                    d.code.as_str()
                ));
            };
            if d.is_error() {
                complain("an error in a valid scene".into());
            }
            refuted(&source, &loaded, d, &mut rng)
                .into_iter()
                .for_each(&mut complain);
            harmful(&loaded, d).into_iter().for_each(&mut complain);
        }
    }
    println!("{seen:?}");
    assert!(
        wrong.is_empty(),
        "{} wrong:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(5)].join("\n")
    );
    // The scenes give these rules something to say.
    for code in ["W307", "W311", "W312", "W319"] {
        assert!(seen.get(code).is_some_and(|n| *n >= 10), "{code}: {seen:?}");
    }
}

/// A transformation that moves nothing is taken out: what is left is the scene without it, and its picture is the same.
#[test]
fn pointless_transformations_are_taken_out() {
    let mut found = 0;
    for seed in 0..cases(60, 300) {
        let mut rng = Rng::new(!seed);
        let source = scenes::scene(seed);
        let mut lines: Vec<&str> = source.lines().collect();
        let is_object = |line: &str| {
            let mut words = line.split_whitespace().skip(1);
            let code: i32 = words.next().unwrap().parse().unwrap();
            (1..100).contains(&code) || (-104..=-101).contains(&code)
        };
        let objects: Vec<usize> = (0..lines.len()).filter(|&i| is_object(lines[i])).collect();
        let at = objects[rng.below(objects.len())];
        let id = lines[at].split_whitespace().next().unwrap();
        let idle = [
            "-1 0 0 0",
            "-2 360 2",
            "-3 1 1 1",
            "-4 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        ];
        let line = format!("{id} {}", idle[rng.below(idle.len())]);
        lines.insert(at + 1, &line);
        let text = lines.join("\n") + "\n";
        let loaded = load(&text);
        for d in loaded.findings().iter().filter(|d| d.code == Code::W327) {
            found += 1;
            let (after, count) = fixes::apply(&text, d.fixes.iter());
            assert_eq!((after.as_str(), count), (source.as_str(), 1), "{seed}");
            let mended = load(&after);
            assert_eq!(picture(&loaded), picture(&mended), "{seed}:\n{text}");
        }
    }
    assert!(found > 20, "{found}");
}

/// What is checked above can fail: claims that are not true are refuted, most of them.
#[test]
fn lies_are_refuted() {
    let (mut refuted_lies, mut lies) = (0, 0);
    let mut tell = |source: &str, loaded: &Analysis, lie: &Diagnostic| {
        lies += 1;
        refuted_lies += u32::from(refuted(source, loaded, lie, &mut Rng::new(1)).is_some());
    };
    for seed in 0..60 {
        let source = scenes::scene(seed);
        let loaded = load(&source);
        for d in loaded.findings() {
            // A point far from the one that was meant.
            if let Some(at) = d.values.iter().position(|v| v.0 == "x") {
                let mut lie = d.clone();
                lie.values[at].1 = (witness(d)[0] + 1.37).to_string().into();
                tell(&source, &loaded, &lie);
            }
        }
        // Unions of a solid and whatever are not empty.
        for node in operations(&loaded.scene) {
            let o = loaded.scene.origins[node as usize];
            if let Node::Union(a, _) = loaded.scene.nodes[node as usize]
                && let Node::Shape(s) = loaded.scene.nodes[a as usize]
                && loaded.scene.shapes[s as usize].geometry.is_solid()
            {
                let lie = Diagnostic::new(Code::W319, o.span).with("id", o.id.to_string());
                tell(&source, &loaded, &lie);
            }
        }
    }
    assert!(
        lies > 50 && refuted_lies * 4 > lies * 3,
        "{refuted_lies} of {lies}"
    );
}
