//! Round trips from text to JSON and back.

use super::*;
use crate::diagnostics::{Diagnostic, Language, SourceFile};
use crate::{scene, syntax};

fn resolve(text: &str) -> (scene::Scene, Vec<Diagnostic>) {
    let source = SourceFile::new("a.zpg", text.as_bytes().to_vec());
    let (document, mut found) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut found);
    (scene, found)
}

/// The model of a scene, through text.
fn model(text: &str) -> model::Scene {
    let (scene, found) = resolve(text);
    assert!(!found.iter().any(Diagnostic::is_error), "{text}{found:?}");
    let json = serde_json::to_string(&write(&scene)).unwrap();
    read(&json).unwrap_or_else(|e| panic!("{e}\n{json}"))
}

/// The records of a model, which must resolve.
fn records(model: &model::Scene) -> String {
    let records = spell(model, Language::English);
    assert_eq!(records.text.lines().count(), records.places.len());
    records.text
}

#[test]
fn what_comes_back_is_the_same() {
    for text in [
        "2 9 1\n3 11 0 1 2 0.1\n4 -101 2 3\n4 -2 33 2\n4 -1 1 2 3\n4 -3 1 -2 3\n1 9999 4 0\n",
        "2 1 3 0 1 1 0.5 0 0\n2 -201 0.1 0.2 0.3\n2 -203 1.1 1.2 1.3\n2 -701 0.1 0 1\n",
        "2 2 2 0 1 1 0 1 0 0 0 0 1\n3 6 0 0 0 1 0 0 0 1 0\n4 7 0 0 0 1 0 0 0 1 0 0 0 1\n",
        "8 8 0 0 0 1 0 0 0 1 0 0 0 1 0 0 1 0 0 1\n9 14 1 0.25\n10 13 1 3\n11 20 1 2 3 2\n",
        "2 18 3\n3 19 1 2\n4 21 1 2\n5 16 -1 2\n6 17 1 2\n7 5 0 0 1 1\n8 3 0 1 0 2\n9 4 1 0 0 2\n",
        "2 9 1\n2 -601 -1 -1 -1 1 1 1\n2 -1 1 0 0\n2 -602 1 0 0 1\n3 -104 2\n4 -105 3\n",
        "5 -701 1 0 0\n6 -701 0 0 1\n2 9 1\n2 -399 3 4 5 6\n3 9 2\n3 -302 5 6 0.5\n1 9999 2 5 -1 -1 -1 1 1 1\n",
        "9 -501 0 0 5 0 0 -1 0 1 0 45\n10 -105 9\n10 -1 1 0 0\n11 -503 10 9\n12 -401 0.5\n13 -402 1\n13 -1 1 2 3\n13 -701 0 1 0\n",
        "9 -99 1 0 0 0 0 1 0 0 0 0 -1.2 -2.2 0 0 -1 0\n2 12 -1e-300 -1 -1 0.1 1 1e300\n",
    ] {
        let first = model(text);
        let second = model(&records(&first));
        assert_eq!(second, first, "{text}\n{}", records(&first));
    }
}

#[test]
fn a_state_that_others_need_is_copied() {
    // The union holds the sphere as it is before it moves.
    let first = model("2 9 1\n3 12 0 0 0 1 1 1\n4 -101 2 3\n2 -1 5 0 0\n5 -103 4 2\n1 9999 5 0\n");
    assert_eq!(
        records(&first),
        "2 9 1.0\n3 12 0.0 0.0 0.0 1.0 1.0 1.0\n4 -101 2 3\n2 -1 5.0 0.0 0.0\n5 -103 4 2\n\
         0 # what is drawn #\n1 9999 5 0\n"
    );
    // Both states of 2 are made of the sphere, and the second one of the first.
    let text = "2 9 1\n2 -1 5 0 0\n4 -104 2\n2 -1 5 0 0\n";
    assert_eq!(
        records(&model(text)),
        "2 9 1.0\n2 -1 5.0 0.0 0.0\n4 -104 2\n2 -1 5.0 0.0 0.0\n"
    );
    // What a program writes may need both.
    let json = r#"{"version": 1, "nodes": [{"type": "sphere", "radius": 1, "id": 2},
        {"type": "transform", "of": 0, "matrix": [1,0,0,2, 0,1,0,0, 0,0,1,0, 0,0,0,1]},
        {"type": "union", "operands": [0, 1], "id": 3}]}"#;
    assert_eq!(
        records(&read(json).unwrap()),
        "2 9 1.0\n4 -105 2\n4 -1 2.0 0.0 0.0\n3 -101 2 4\n"
    );
}

#[test]
fn matrices_that_are_no_rotations_are_allowed() {
    let text = records(&model("2 9 1\n2 -3 1 2 3\n2 -2 30 1\n"));
    assert!(text.starts_with("# zpg: allow(not-a-rotation) #\n2 9 1.0\n2 -4 1.0 0.0 0.0 0.0 "));
    let text = records(&model("2 9 1\n2 -2 30 1\n2 -1 1 2 3\n"));
    assert!(text.starts_with("2 9 1.0\n2 -4 1.0 0.0 0.0 1.0 "), "{text}");
}

#[test]
fn what_a_program_may_leave_out() {
    let json = r#"{"version": 1, "nodes": [
        {"type": "sphere", "radius": 1},
        {"type": "transform", "of": 0, "matrix": [1,0,0,2, 0,1,0,0, 0,0,1,0, 0,0,0,1]},
        {"type": "union", "operands": [0, 1], "id": 2},
        {"type": "paint", "of": 2, "texture": {"colour": [1, 0, 0]}}
      ], "point_lights": [{"position": [0, 5, 0], "intensity": 1}], "render": {"root": 3}}"#;
    assert_eq!(
        records(&read(json).unwrap()),
        "3 9 1.0\n4 -105 3\n4 -1 2.0 0.0 0.0\n2 -101 3 4\n2 -701 1.0 0.0 0.0\n0 # lights #\n\
         5 -402 1.0\n5 -1 0.0 5.0 0.0\n0 # what is drawn #\n1 9999 2 0\n"
    );
}

#[test]
fn mistakes_are_named_by_their_place() {
    let scene = |nodes: &str, more: &str| format!(r#"{{"version": 1, "nodes": [{nodes}]{more}}}"#);
    let ball = r#"{"type": "sphere", "radius": 1}"#;
    for (json, says) in [
        (String::from("{"), "this is not JSON: it ends too early"),
        (
            String::from("{\"version\": 1,\n\"nodes\": [],}"),
            "this is not JSON: key must be a string",
        ),
        (scene("", "") + "x", "this is not JSON: trailing characters"),
        (
            scene(r#"{"type": "copy", "of": 1}"#, "")[1..].to_owned(),
            "this is not JSON: ",
        ),
        (
            String::from(r#"{"version": 2, "nodes": []}"#),
            "version: version 2 is not known",
        ),
        (
            scene(r#"{"type": "ball"}"#, ""),
            "nodes[0].type: there is no kind `ball`, only `surface-of-revolution`, ",
        ),
        (
            scene(r#"{"type": "sphere", "radius": 1, "colour": 3}"#, ""),
            "nodes[0].colour: there is no `colour` here, only `centre`, `radius`",
        ),
        (
            scene(&format!("{ball},\n{{\"type\": \"sphere\"}}"), ""),
            "nodes[1]: `radius` is missing: add it",
        ),
        (
            scene(r#"{"type": "torus", "minor": 1}"#, ""),
            "nodes[0]: `major` is missing: add it",
        ),
        (
            scene(r#"{"type": "sphere", "radius": "1"}"#, ""),
            "nodes[0].radius: expected a number, found `\"1\"`",
        ),
        (
            scene(r#"{"type": "sphere", "radius": 1, "centre": [0, 1]}"#, ""),
            "nodes[0].centre: expected a list of 3, found a list of 2",
        ),
        (
            scene(
                r#"{"type": "paint", "of": 0, "texture": {"color": [0, 1, 1]}}"#,
                "",
            ),
            "nodes[0].texture: there is no kind `color`, only `colour`, ",
        ),
        (
            scene(r#"{"type": "copy", "of": -1}"#, ""),
            "nodes[0].of: expected a whole number from 0 to 4294967295, found `-1`",
        ),
        (
            scene(r#"{"type": 3}"#, ""),
            "nodes[0].type: expected a text in quotation marks, found `3`",
        ),
        (
            scene("3", ""),
            "nodes[0]: expected an object in braces, found `3`",
        ),
        (
            scene("", r#", "cameras": [{"position": [0, 0, 1, 1]}]"#),
            "cameras[0].position: the list is too long",
        ),
        (
            scene("", r#", "cameras": {}"#),
            "cameras: expected a list, found an object in braces",
        ),
        (
            scene("", r#", "render": {"root": 0, "root": 1}"#),
            "render: `root` is there twice: leave one of them out",
        ),
        (
            scene("", r#", "view": "mono""#),
            "view.mono: expected an object in braces, found a text in quotation marks",
        ),
        (
            String::from("[]"),
            "expected an object in braces, found a list of 0",
        ),
        (
            scene(r#"{"type": "sphere", "radius": 1e999}"#, ""),
            "nodes[0].radius: the number is too large",
        ),
        (
            scene(r#"{"type": "copy", "of": 0}"#, ""),
            "nodes[0]: it names node 0, which must stand before it",
        ),
        (
            scene(r#"{"type": "sphere", "radius": 1, "id": 1}"#, ""),
            "nodes[0]: an ID is from 2",
        ),
        (
            scene(&format!("{ball}, {ball}"), r#", "render": {"root": 2}"#),
            "render: there is no node 2",
        ),
        (
            scene(ball, r#", "view": {"mono": 0}"#),
            "view: there is no camera 0",
        ),
    ] {
        let found = read(&json).unwrap_err();
        assert!(found.to_string().contains(says), "{json}: {found}");
        let line = json[..found.span.start as usize].matches('\n').count();
        assert_eq!(line, json.matches('\n').count(), "{json}: {found}");
        // The place is the value itself, where the text is JSON.
        if let Some(at) = &found.at {
            let last = at.rsplit(['.', '[']).next().unwrap().trim_end_matches(']');
            let before = &json[..found.span.start as usize];
            let named = before.ends_with(&format!("\"{last}\": "));
            let is_itself = json[found.span.range()] == format!("\"{last}\"");
            let is_item = last.parse::<u32>().is_ok();
            assert!(named || is_itself || is_item, "{json}: {found}");
        }
    }
    let json = scene("", r#", "render": {"root": "a"}"#);
    let found = read(&json).unwrap_err();
    assert_eq!(&json[found.span.range()], "\"a\"");
    assert!(
        found
            .to_string()
            .starts_with("render.root: expected a whole number"),
        "{found}"
    );
    // Behind a mark and over several lines, too.
    let json = format!("\u{feff}\n{}", json.replace(',', ",\n"));
    assert_eq!(&json[read(&json).unwrap_err().span.range()], "\"a\"");
    let json = scene("", "}");
    let found = read(&json).unwrap_err();
    assert_eq!((&json[found.span.range()], found.at), ("}", None));
}

/// However deep lists and objects lie in one another, they are refused in words.
#[test]
fn depth_is_refused() {
    let deep = |open: &str, close: &str, n: usize| open.repeat(n) + &close.repeat(n);
    let all = [
        deep("[", "]", 100_000),
        "[".repeat(100_000),
        deep("{\"a\":", "}", 100_000),
        format!("{{\"version\": 1, \"nodes\": {}}}", deep("[", "]", 100_000)),
        format!(
            "{{\"version\": 1, \"nodes\": [{{\"type\": \"sphere\", \"radius\": {}}}]}}",
            deep("[", "]", 100_000)
        ),
        format!(
            "{{\"version\": 1, \"nodes\": [{{\"type\": {}1{}}}]}}",
            "{\"a\":".repeat(100_000),
            "}".repeat(100_000)
        ),
    ];
    let said: Vec<String> = all
        .iter()
        .map(|json| read(json).unwrap_err().to_string())
        .collect();
    for said in &said {
        assert!(said.len() < 200, "{said}");
    }
    assert!(said[4].contains("nested too deep"), "{}", said[4]);
    assert!(said[1].contains("it ends too early"), "{}", said[1]);
}

/// Each number of the records is the value of the model that it is said to be.
#[test]
fn numbers_are_the_values_that_they_are_called() {
    let at = |json: &serde_json::Value, path: &locate::Path| {
        path.0
            .iter()
            .try_fold(json.clone(), |value, step| match step {
                locate::PathSegment::Name(name) => value.get(name.as_ref()).cloned(),
                locate::PathSegment::Index(i) => value.get(*i).cloned(),
            })
    };
    let corpus = include_str!("../../../tests/corpus/all-types.zpg");
    let mut texts = vec![corpus.to_owned()];
    let mut random = crate::testing::random();
    texts.extend((0..50).map(|_| random_scene(&mut random)));
    let (mut numbers, mut names) = (0, 0);
    for text in texts {
        let (scene, found) = resolve(&text);
        if found.iter().any(Diagnostic::is_error) {
            continue;
        }
        let model = write(&scene);
        let json = serde_json::to_value(&model).unwrap();
        let records = spell(&model, Language::English);
        assert_eq!(records.matters.len(), records.places.len());
        for (i, line) in records
            .text
            .lines()
            .enumerate()
            .filter(|(_, l)| !l.contains('#'))
        {
            let value = |part| fields::value(&model, records.places[i], records.matters[i], part);
            for (k, word) in line.split(' ').skip(2).enumerate() {
                let path = value(fields::RecordField::Parameter(k));
                let Some(found) = at(&json, &path) else {
                    panic!("{line}: {path} is not there");
                };
                match (word.parse::<f64>(), found.as_f64()) {
                    (Ok(written), Some(found)) if word.contains(['.', 'e']) => {
                        assert_eq!(written.to_bits(), found.to_bits(), "{line}: {path}");
                        numbers += 1;
                    }
                    // What names something else goes by its index, and a colour by itself.
                    _ => names += 1,
                }
            }
            let id = at(&json, &value(fields::RecordField::Id)).and_then(|id| id.as_u64());
            let is_path = value(fields::RecordField::Id).to_string().ends_with(".id");
            assert!(
                !is_path || id == line.split(' ').next().unwrap().parse().ok(),
                "{line}"
            );
        }
    }
    assert!(numbers > 500 && names > 100, "{numbers} {names}");
}

#[test]
fn a_byte_order_mark_is_let_pass() {
    let json = r#"{"version": 1, "nodes": [{"type": "sphere", "radius": 1}]}"#;
    let scene = read(json).unwrap();
    assert_eq!(read(&format!("\u{feff}{json}")).unwrap(), scene);
}

#[test]
fn ids_are_found_at_the_end_of_the_numbers() {
    let json = r#"{"version": 1, "nodes": [
        {"type": "sphere", "radius": 1, "id": 2147483647},
        {"type": "complement", "of": 0, "id": 2},
        {"type": "complement", "of": 1}]}"#;
    assert_eq!(
        records(&read(json).unwrap()),
        "2147483647 9 1.0\n2 -104 2147483647\n3 -104 2\n"
    );
}

/// Every form of a node may have an ID.
impl schemars::JsonSchema for model::Item {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Node".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let mut schema = model::Node::json_schema(generator);
        let id = serde_json::json!({
            "description": "The ID by which the language knows it; one is found where it is left out.",
            "type": "integer",
            "minimum": 2,
            "maximum": spell::ID_MAX,
        });
        let forms = schema.get_mut("oneOf").and_then(|v| v.as_array_mut());
        for form in forms.into_iter().flatten() {
            // What changes another node has the ID of that.
            let ty = form["properties"]["type"]["const"].as_str();
            if !["transform", "paint"].map(Some).contains(&ty) {
                form["properties"]["id"] = id.clone();
            }
        }
        schema
    }
}

#[test]
fn the_schema_is_that_of_the_model() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/grammar/scene.schema.json");
    let mut schema = schemars::schema_for!(model::Scene);
    schema.insert("title".into(), "A scene of the ZPG scene language".into());
    let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
    if std::env::var_os("UPDATE_GRAMMAR").is_some() {
        std::fs::write(path, &text).unwrap();
    }
    assert_eq!(
        text,
        std::fs::read_to_string(path).unwrap_or_default(),
        "UPDATE_GRAMMAR=1 cargo test --lib schema writes it anew"
    );
}

#[test]
fn scenes_are_what_the_schema_says() {
    let schema = include_str!("../../../grammar/scene.schema.json");
    let schema = serde_json::from_str(schema).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let mut count = 0;
    for entry in ignore::Walk::new(folder).map(Result::unwrap) {
        if entry.path().extension().is_some_and(|e| e == "zpg") {
            let source = SourceFile::new(
                entry.path().to_string_lossy(),
                std::fs::read(entry.path()).unwrap(),
            );
            let (document, mut found) = syntax::parse(&source.text);
            let scene = scene::resolve(&document, &source, &mut found);
            let json = serde_json::to_value(write(&scene)).unwrap();
            let wrong: Vec<String> = validator
                .iter_errors(&json)
                .map(|e| e.to_string())
                .collect();
            assert!(wrong.is_empty(), "{}: {wrong:#?}", entry.path().display());
            count += 1;
        }
    }
    assert!(count > 30, "{count} scenes");
    for bad in [
        serde_json::json!({"version": 1}),
        serde_json::json!({"version": 1, "nodes": [{"type": "sphere", "radius": 1, "colour": 3}]}),
        serde_json::json!({"version": 1, "nodes": [{"type": "torus", "major": 1}]}),
        serde_json::json!({"version": 1, "nodes": [{"type": "copy", "of": -1}]}),
    ] {
        assert!(!validator.is_valid(&bad), "{bad}");
    }
}

/// A scene of shapes that are changed, copied and used in operations, all of it again and again.
fn random_scene(random: &mut impl FnMut(u64) -> u64) -> String {
    let mut text = String::from("900 -701 1 0 0\n901 -201 0.5 0.25 0.25\n902 -399 2 2 900 900\n");
    let mut objects: Vec<u64> = Vec::new();
    let number = |random: &mut dyn FnMut(u64) -> u64| random(41) as f64 / 10.0 - 2.0;
    let mut add = |line: String| text += &(line + "\n");
    let mut next = 2;
    for _ in 0..4 + random(22) {
        let some =
            |random: &mut dyn FnMut(u64) -> u64| objects[random(objects.len() as u64) as usize];
        let made = match random(if objects.is_empty() { 1 } else { 14 }) {
            0 | 1 => Some(match random(4) {
                0 => format!("{next} 9 {}", 1 + random(3)),
                1 => format!("{next} 12 -1 -1 -1 1 2 1"),
                2 => format!("{next} 14 2 0.5"),
                _ => format!("{next} 2 2 1 -1 1 1 1 0 0 0 0 1"),
            }),
            2 | 3 => Some(format!("{next} -105 {}", some(random))),
            4 | 5 => Some(format!(
                "{next} -10{} {} {}",
                1 + random(3),
                some(random),
                some(random)
            )),
            6 => Some(format!("{next} -104 {}", some(random))),
            7 | 8 => {
                let step = [0; 3].map(|_| number(random));
                add(format!(
                    "{} -1 {} {} {}",
                    some(random),
                    step[0],
                    step[1],
                    step[2]
                ));
                None
            }
            9 => {
                let angle = [0, 30, 90, 123, -90, 360][random(6) as usize];
                add(format!("{} -2 {angle} {}", some(random), 1 + random(3)));
                None
            }
            10 => {
                let factors = ["1 1 1", "2 -1 0.3", "-1 1 1", "0.1 0.7 3"][random(4) as usize];
                add(format!("{} -3 {factors}", some(random)));
                None
            }
            11 => {
                let rows = [
                    "2 0 0 1 0 3 0 -2 0 0 0.1 0.3 0 0 0 1",
                    "0.6 -0.8 0 0.1 0.8 0.6 0 0 0 0 1 0 0 0 0 1",
                ];
                add(format!("{} -4 {}", some(random), rows[random(2) as usize]));
                None
            }
            12 => {
                let volume = ["-601 -9 -9 -9 9 9 9", "-602 0 0 0 20"][random(2) as usize];
                add(format!("{} {volume}", some(random)));
                None
            }
            _ => {
                let paint = [
                    "-701 0 1 0",
                    "-701 0 0 1",
                    "-201 0.5 0.5 0",
                    "-203 1.5 1.6 1.7",
                    "-299 0 0",
                    "-299 902 901",
                    "-399 3 1 900 900",
                    "-302",
                ];
                let paint = paint[random(paint.len() as u64) as usize];
                add(format!("{} {paint}", some(random)));
                None
            }
        };
        if let Some(line) = made {
            add(line);
            objects.push(next);
            next += 1;
        }
    }
    add(format!(
        "1 9999 {} 0",
        objects[random(objects.len() as u64) as usize]
    ));
    text
}

/// The crossings of some rays, to the bit: their places, and the IDs they go by.
fn met(scene: &scene::Scene) -> String {
    use crate::geometry::vec;
    use crate::trace::{Images, Ray, Tracer, members};
    let Ok(tracer) = Tracer::with_images(scene, &Images::default()) else {
        return String::from("none");
    };
    let mut walkers = tracer.walker::<f64>();
    let mut random = crate::testing::random();
    let mut out = String::new();
    for _ in 0..12 {
        let mut part = || random(1000) as f64 / 100.0 - 5.0;
        let from = vec::Vec3([part(), part(), part()]);
        let towards = vec::Vec3([part(), part(), part()]) * 0.3;
        for c in tracer.crossings(&mut walkers, &Ray::new(from, towards - from)) {
            out += &format!("{:?} {} {}, ", c.hit.point, c.shape, c.object);
        }
        let root = scene.render.as_ref().unwrap().root;
        if let Ok(found) = members(scene, root, towards) {
            out += &format!("{:?}; ", found.inside);
        }
    }
    out
}

/// Whatever was done to it: the same JSON, and everything goes by the IDs that it had.
#[test]
fn random_scenes_come_back_under_their_names() {
    let mut random = crate::testing::random();
    let mut stepped = 0;
    for _ in 0..1500 {
        let text = random_scene(&mut random);
        let (before, found) = resolve(&text);
        if found.iter().any(Diagnostic::is_error) {
            continue;
        }
        stepped += usize::from(!before.steps.is_empty());
        let first = model(&text);
        let back = records(&first);
        let second = model(&back);
        assert_eq!(
            serde_json::to_string(&second).unwrap(),
            serde_json::to_string(&first).unwrap(),
            "{text}\n{back}"
        );
        assert_eq!(records(&second), back);
        assert_eq!(met(&resolve(&back).0), met(&before), "{text}\n{back}");
    }
    assert!(stepped > 100, "{stepped}");
}
