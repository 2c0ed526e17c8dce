//! What `zpg plan` decides, effect by effect, and that `zpg render` keeps to it.

use serde_json::Value;
use std::fs;
use zpg::internals::syntax::table::ShapeKind;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    fn run(&self, scene: &str, args: &[&str]) -> Vec<u8> {
        fs::write(self.0.path().join("scene.zpg"), scene).unwrap();
        let out = crate::support::program::command()
            .current_dir(self.0.path())
            .args(args)
            .output()
            .unwrap();
        let complaint = String::from_utf8_lossy(&out.stderr);
        assert!(out.status.success(), "{scene}\n{complaint}");
        out.stdout
    }

    /// The bytes of the picture, and the statistics without what differs from run to run.
    fn render(&self, scene: &str) -> (Vec<u8>, Value) {
        let args = "render scene.zpg -o a.pfm --size 48x36 --stats a.json";
        self.run(scene, &args.split(' ').collect::<Vec<_>>());
        let stats = fs::read(self.0.path().join("a.json")).unwrap();
        let mut stats: Value = serde_json::from_slice(&stats).unwrap();
        let object = stats.as_object_mut().unwrap();
        object.remove("seconds");
        object.remove("peak_memory_bytes");
        (fs::read(self.0.path().join("a.pfm")).unwrap(), stats)
    }
}

fn plan(scene: &str) -> Value {
    let out = Folder::new().run(scene, &["plan", "scene.zpg", "--json"]);
    serde_json::from_slice(&out).unwrap()
}

fn effect<'p>(plan: &'p Value, name: &str) -> &'p Value {
    let effects = plan["effects"].as_array().unwrap();
    effects.iter().find(|e| e["name"] == name).unwrap()
}

const NAMES: [&str; 17] = [
    "ambient",
    "diffuse",
    "shadows",
    "transparent-shadows",
    "reflection",
    "refraction",
    "dispersion",
    "image-texture",
    "solid-texture",
    "checkerboard",
    "vertex-colour",
    "smooth-normals",
    "csg",
    "unbounded",
    "clip-box",
    "stereo",
    "projection-matrix",
];

/// A camera and two spheres, 2 and 3, united in 4 unless the scene says otherwise.
const CAMERA: &str = "90 -501 0 0 9 0 0 -1 0 1 0 45\n";
const SPHERES: &str = "2 11 0 0 0 1\n3 11 3 0 0 1\n";

fn scene(middle: &str) -> String {
    format!("{CAMERA}{SPHERES}{middle}\n1 9999 4 0\n")
}

/// The effect is on in the first scene, because of the entity on that line, and off in the second.
#[track_caller]
fn decides(name: &str, on: &str, (id, line): (u32, u32), near_miss: &str) {
    let with = plan(on);
    let decision = effect(&with, name);
    assert_eq!(decision["on"], true, "{name} in\n{on}");
    let because = decision["because"].as_array().unwrap();
    let named = because.iter().any(|b| b["id"] == id && b["line"] == line);
    assert!(named, "{name}: {because:?}");
    assert!(
        because
            .iter()
            .all(|b| !b["text"].as_str().unwrap().is_empty())
    );
    let without = plan(near_miss);
    let decision = effect(&without, name);
    assert_eq!(decision["on"], false, "{name} in\n{near_miss}");
    assert_eq!(decision["because"].as_array().unwrap().len(), 0);
    assert!(!decision["note"].as_str().unwrap().is_empty());
}

#[test]
fn all_effects_are_there_in_order() {
    let plan = plan(&scene("4 -101 2 3"));
    let effects = plan["effects"].as_array().unwrap();
    let names: Vec<&str> = effects
        .iter()
        .map(|e| e["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, NAMES);
    assert_eq!(plan["shapes"], serde_json::json!({"sphere": 2}));
    assert_eq!(plan["operations"], serde_json::json!({"union": 1}));
    assert_eq!(plan["medium_depth"], 0);
    assert_eq!(plan["unreached"], serde_json::json!([]));
}

#[test]
fn ambient_needs_light_and_something_diffuse() {
    let on = scene("4 -101 2 3\n5 -401 0.5");
    decides("ambient", &on, (5, 5), &scene("4 -101 2 3\n5 -401 0"));
    decides(
        "ambient",
        &on,
        (5, 5),
        &scene("4 -101 2 3\n4 -201 0 1 0\n5 -401 0.5"),
    );
}

#[test]
fn diffuse_needs_a_light_that_shines() {
    let on = scene("4 -101 2 3\n5 -402 1");
    decides("diffuse", &on, (5, 5), &scene("4 -101 2 3\n5 -401 1"));
    decides(
        "diffuse",
        &on,
        (2, 2),
        &scene("4 -101 2 3\n5 -402 1\n4 -201 0 1 0"),
    );
}

#[test]
fn without_any_light_there_are_automatic_lights() {
    let on = scene("4 -101 2 3");
    decides("diffuse", &on, (1, 5), &scene("4 -101 2 3\n5 -401 1"));
}

#[test]
fn a_lone_convex_shape_casts_no_shadow() {
    let on = scene("4 -101 2 3\n5 -402 1");
    let lone = format!("{CAMERA}4 11 0 0 0 1\n5 -402 1\n1 9999 4 0\n");
    decides("shadows", &on, (5, 5), &lone);
    let (_, stats) = Folder::new().render(&lone);
    assert_eq!(stats["rays"]["shadow"], 0);
    // An ellipsoid among the quadrics, too, and no cylinder.
    for (middle, shadows) in [(1, false), (0, true)] {
        let quadric = format!("4 15 2 0 0 0 0 {middle} 0 0 0 0 3 0 0 0 0 -1\n");
        let lone = format!("{CAMERA}{quadric}5 -402 1\n1 9999 4 0\n");
        assert_eq!(effect(&plan(&lone), "shadows")["on"], shadows);
    }
    // From inside its other side is in the way.
    let inside = format!("{CAMERA}4 11 0 0 8 2\n5 -402 1\n1 9999 4 0\n");
    assert_eq!(effect(&plan(&inside), "shadows")["on"], true);
}

#[test]
fn transparent_shadows_need_glass_and_shadows() {
    let on = scene("2 -201 0 0 1\n4 -101 2 3\n5 -402 1");
    decides(
        "transparent-shadows",
        &on,
        (2, 2),
        &scene("2 -201 0 0 1\n4 -101 2 3\n5 -401 1"),
    );
}

#[test]
fn reflection_comes_from_mirrors_and_total_reflection() {
    let on = scene("2 -201 0.5 0.5 0\n4 -101 2 3");
    decides(
        "reflection",
        &on,
        (2, 2),
        &scene("2 -201 0.5 0.5 0\n4 -101 2 3\n4 -201 1 0 0"),
    );
    let glass = scene("2 -201 0 0 1\n2 -203 1.5 1.5 1.5\n4 -101 2 3");
    decides(
        "reflection",
        &glass,
        (2, 2),
        &scene("2 -201 0 0 1\n4 -101 2 3"),
    );
}

#[test]
fn glass_that_is_painted_over_is_no_glass() {
    let on = scene("2 -201 0 0 1\n4 -101 2 3");
    decides(
        "refraction",
        &on,
        (2, 2),
        &scene("2 -201 0 0 1\n4 -101 2 3\n4 -201 1 0 0"),
    );
}

#[test]
fn a_tool_of_glass_leaves_no_glass() {
    let on = scene("2 -201 0 0 1\n4 -103 2 3");
    decides(
        "refraction",
        &on,
        (2, 2),
        &scene("3 -201 0 0 1\n4 -103 2 3"),
    );
    // −(A − B) is −A ∪ B.
    let turned = scene("3 -201 0 0 1\n5 -103 2 3\n4 -104 5");
    assert_eq!(effect(&plan(&turned), "refraction")["on"], true);
    // A ∩ −B keeps the faces of B.
    let kept = scene("3 -201 0 0 1\n5 -104 3\n4 -102 2 5");
    assert_eq!(effect(&plan(&kept), "refraction")["on"], true);
}

#[test]
fn dispersion_needs_three_indices_in_glass() {
    let glass = "2 -201 0 0 1\n2 -203 1.4 1.5 1.6\n";
    let on = scene(&format!("{glass}4 -101 2 3"));
    decides(
        "dispersion",
        &on,
        (2, 2),
        &scene(&format!("{glass}4 -101 2 3\n4 -203 1.5 1.5 1.5")),
    );
    let opaque = scene("2 -203 1.4 1.5 1.6\n4 -101 2 3");
    decides("dispersion", &on, (2, 2), &opaque);
}

#[test]
fn textures_that_are_painted_over_are_off() {
    let solid = scene("2 -302\n4 -101 2 3");
    decides(
        "solid-texture",
        &solid,
        (2, 2),
        &scene("2 -302\n4 -101 2 3\n4 -701 1 0 0"),
    );
    let colours = "10 -701 1 0 0\n11 -701 0 1 0\n";
    let board = scene(&format!("{colours}2 -399 4 4 10 11\n4 -101 2 3"));
    let over = scene(&format!("{colours}2 -399 4 4 10 11\n4 -101 2 3\n4 -302"));
    decides("checkerboard", &board, (2, 2), &over);
    let mirror = scene(&format!(
        "{colours}2 -399 4 4 10 11\n2 -201 0 1 0\n4 -101 2 3"
    ));
    decides("checkerboard", &board, (2, 2), &mirror);
}

#[test]
fn images_count_where_they_show() {
    use zpg::internals::scene::*;
    let image = Texture::Image {
        file: "a.png".into(),
        span: Default::default(),
    };
    let colour = Texture::Colour([1.0; 3]);
    for (textures, on) in [(vec![image.clone()], true), (vec![image, colour], false)] {
        let mut scene = sphere_scene();
        for texture in textures {
            paint(&mut scene, texture);
        }
        assert_eq!(
            is_on(&scene, zpg::internals::trace::plan::Effect::ImageTexture),
            on
        );
    }
}

/// A scene that is one sphere, as objects.
fn sphere_scene() -> zpg::internals::scene::Scene {
    let geometry = zpg::internals::scene::Geometry::Sphere {
        centre: [0.0; 3],
        radius: 1.0,
    };
    shape_scene(ShapeKind::SphereAtOrigin, geometry)
}

const ORIGIN: zpg::internals::scene::Origin = zpg::internals::scene::Origin {
    id: 2,
    span: zpg::internals::diagnostics::Span { start: 0, end: 0 },
};

fn shape_scene(
    kind: ShapeKind,
    geometry: zpg::internals::scene::Geometry,
) -> zpg::internals::scene::Scene {
    use zpg::internals::scene::*;
    Scene {
        nodes: vec![Node::Shape(0)],
        origins: vec![ORIGIN],
        shapes: vec![Shape {
            id: 2,
            kind,
            geometry,
        }],
        render: Some(Render {
            root: 0,
            root_id: 2,
            background: [0.0; 3],
            clip: None,
            span: Default::default(),
        }),
        ..Scene::default()
    }
}

fn paint(scene: &mut zpg::internals::scene::Scene, texture: zpg::internals::scene::Texture) {
    use zpg::internals::scene::*;
    let child = scene.nodes.len() as u32 - 1;
    scene.paints.push(Paint {
        owner: 2,
        texture: Some(texture),
        ..Paint::default()
    });
    let paint = scene.paints.len() as u32 - 1;
    scene.nodes.push(Node::Paint { child, paint });
    scene.origins.push(ORIGIN);
    scene.render.as_mut().unwrap().root = child + 1;
}

fn is_on(
    scene: &zpg::internals::scene::Scene,
    effect: zpg::internals::trace::plan::Effect,
) -> bool {
    zpg::internals::trace::plan::Plan::new(scene)
        .unwrap()
        .on(effect)
}

#[test]
fn vertex_colours_that_are_painted_over_are_off() {
    let coloured = format!("{CAMERA}4 2 2  1 0  1 1  1 0 0  0 1 0\n");
    let on = format!("{coloured}1 9999 4 0\n");
    decides(
        "vertex-colour",
        &on,
        (4, 2),
        &format!("{coloured}4 -701 1 0 0\n1 9999 4 0\n"),
    );
    let tool = scene("5 2 2  1 0  1 1  1 0 0  0 1 0\n4 -103 2 5");
    decides("vertex-colour", &on, (4, 2), &tool);
}

#[test]
fn smooth_normals_come_from_triangles_that_have_them() {
    let on = format!("{CAMERA}4 7 0 0 0 1 0 0 0 1 0  0 0 1\n1 9999 4 0\n");
    let flat = format!("{CAMERA}4 6 0 0 0 1 0 0 0 1 0\n1 9999 4 0\n");
    decides("smooth-normals", &on, (4, 2), &flat);
}

#[test]
fn csg_is_all_but_unions() {
    decides(
        "csg",
        &scene("4 -102 2 3"),
        (4, 4),
        &scene("5 -102 2 3\n4 -101 2 3"),
    );
    // The ID is that of the operation, whatever became of it since.
    let painted = scene("4 -103 2 3\n4 -701 1 0 0\n4 -1 1 0 0");
    decides("csg", &painted, (4, 4), &scene("4 -101 2 3"));
}

#[test]
fn unbounded_shapes_and_complements() {
    let on = scene("5 4 0 1 0 3\n4 -101 2 5");
    decides(
        "unbounded",
        &on,
        (5, 4),
        &scene("5 12 -1 -1 -1 1 1 1\n4 -101 2 5"),
    );
}

#[test]
fn a_region_counts_where_it_cuts() {
    let all = format!("{CAMERA}{SPHERES}4 -101 2 3\n");
    let on = format!("{all}1 9999 4 0 0 0 0 9 9 9\n");
    let off = format!("{all}1 9999 4 0 -9 -9 -9 9 9 9\n");
    decides("clip-box", &on, (1, 5), &off);
}

#[test]
fn stereo_and_projections_belong_to_the_selected_cameras() {
    let second = "91 -501 1 0 9 0 0 -1 0 1 0 45\n";
    let on = scene(&format!("4 -101 2 3\n{second}92 -503 90 91"));
    decides(
        "stereo",
        &on,
        (90, 1),
        &scene(&format!("4 -101 2 3\n{second}")),
    );
    let matrix = "91 -99  1 0 0 0  0 1 0 0  0 0 -1 0  0 0 0 1\n";
    let on = scene(&format!("4 -101 2 3\n{matrix}92 -502 91"));
    decides(
        "projection-matrix",
        &on,
        (91, 5),
        &scene(&format!("4 -101 2 3\n{matrix}92 -502 90")),
    );
}

#[test]
fn media_are_counted_where_they_can_overlap() {
    let glass = |middle: &str| plan(&scene(middle))["medium_depth"].clone();
    assert_eq!(glass("4 -101 2 3"), 0);
    // Apart.
    assert_eq!(glass("4 -101 2 3\n4 -201 0 0 1"), 1);
    assert_eq!(glass("5 11 0 0 0 0.5\n4 -101 2 5\n4 -201 0 0 1"), 2);
}

#[test]
fn glass_that_is_not_reached_changes_nothing() {
    let without = scene("4 -101 2 3\n5 -402 1\n5 -1 5 5 5");
    let glass = "6 11 0 0 3 1\n6 -201 0.1 0.2 0.7\n6 -203 1.4 1.5 1.6\n7 -102 6 6\n";
    let with = scene(&format!("4 -101 2 3\n5 -402 1\n5 -1 5 5 5\n{glass}"));
    let folder = Folder::new();
    let (a, b) = (folder.render(&without), folder.render(&with));
    assert!(a == b, "{:?} {:?}", a.1, b.1);
    assert_eq!(plan(&with)["unreached"], serde_json::json!([6, 7]));
}

#[test]
fn effects_that_are_off_trace_no_rays() {
    let folder = Folder::new();
    for (middle, zero) in [
        ("4 -101 2 3\n5 -402 1", &["reflection", "refraction"][..]),
        (
            "4 -101 2 3\n5 -401 1",
            &["shadow", "reflection", "refraction"],
        ),
        (
            "4 -101 2 3\n4 -201 0 1 0\n5 -402 1",
            &["shadow", "refraction"],
        ),
        (
            "4 -101 2 3\n4 -201 0 0 1\n5 -402 1",
            &["shadow", "reflection"],
        ),
    ] {
        let scene = scene(middle);
        let (_, stats) = folder.render(&scene);
        for kind in zero {
            assert_eq!(stats["rays"][kind], 0, "{kind} in\n{scene}");
        }
        let plan = plan(&scene);
        let on = plan["effects"].as_array().unwrap().iter();
        let on: Vec<&Value> = on.filter(|e| e["on"] == true).map(|e| &e["name"]).collect();
        let listed: Vec<&Value> = stats["effects"].as_array().unwrap().iter().collect();
        assert_eq!(on, listed);
    }
}

/// Light is stopped by opaque things, let through by glass, and not stopped by opaque things that
/// lie inside of glass that owns their place.
#[test]
fn shadows_behind_opaque_things_in_glass() {
    let folder = Folder::new();
    let picture = |order: &str| {
        folder.render(&format!(
            "{CAMERA}2 11 0 3 0 1\n2 -201 0 0 1\n3 11 0 3 0 0.5\n5 12 -9 -2 -9 9 -1 9\n\
             6 -101 {order}\n4 -101 6 5\n7 -402 1\n7 -1 0 9 0\n1 9999 4 0\n"
        ))
    };
    let (owned, solid) = (picture("2 3"), picture("3 2"));
    assert!(owned.0 != solid.0);
    // The glass alone looks the same as with what it owns.
    assert!(owned.0 == picture("2 2").0);
}

#[test]
fn thirty_doublings_are_planned_and_drawn_quickly() {
    let mut text = format!("{CAMERA}2 11 0 0 0 0.1\n2 -201 0.5 0 0.5\n2 -203 1.5 1.5 1.5\n");
    let mut last = 2;
    for i in 0..30 {
        let (copy, union) = (10 + 2 * i, 11 + 2 * i);
        let step = 0.3 * f64::from(i + 1);
        text += &format!("{copy} -105 {last}\n{copy} -1 {step} 0 0\n{union} -101 {last} {copy}\n");
        last = union;
    }
    text += &format!("1 9999 {last} 0\n");
    let plan = plan(&text);
    assert_eq!(plan["shapes"]["sphere"], 1);
    assert_eq!(plan["operations"]["union"], 30);
    assert_eq!(effect(&plan, "refraction")["on"], true);
}
