//! Scenes in JSON, taken by all commands that read: findings are about the JSON.

use std::fs;

use serde_json::{Value, json};

use crate::support::program::{self, folder, text, zpg};

const GOOD: &str = r#"{"version": 1,
 "nodes": [
  {"id": 2, "type": "sphere", "centre": [0, 1, 0], "radius": 1},
  {"type": "paint", "of": 0, "texture": {"colour": [0.5, 0.5, 0.5]}}
 ],
 "point_lights": [{"position": [0, 5, 5], "intensity": 1}],
 "cameras": [{"id": 9, "position": [0, 1, 5], "direction": [0, 0, -1], "up": [0, 1, 0], "fovy": 45}],
 "render": {"root": 1}
}
"#;

/// What check finds: code, what stands at the span, message.
fn found(json: &str) -> (Vec<(String, String, String)>, Option<i32>) {
    let dir = folder(&[("a.json", json)]);
    let run = zpg(dir.path(), &["check", "--format", "json", "a.json"]);
    let out: Value = serde_json::from_slice(&run.stdout).unwrap();
    let all = out["files"][0]["diagnostics"].as_array().unwrap();
    let of = |d: &Value| {
        let offset = |end: &str| d["span"][end]["offset"].as_u64().unwrap() as usize;
        let (start, end) = (offset("start"), offset("end"));
        // Line and column say the same.
        let before = &json[..start];
        assert_eq!(d["span"]["start"]["line"], before.matches('\n').count() + 1);
        let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
        assert_eq!(d["span"]["start"]["column"], column);
        assert_eq!(d["fixes"], json!([]));
        let text = |name: &str| d[name].as_str().unwrap().to_owned();
        (text("code"), json[start..end].to_owned(), text("message"))
    };
    (all.iter().map(of).collect(), run.status.code())
}

#[test]
fn findings_are_about_the_values() {
    assert_eq!(found(GOOD), (vec![], Some(0)));
    for (old, new, code, value, says) in [
        (
            "0.5, 0.5, 0.5",
            "0.5, 2, 0.5",
            "W301",
            "2",
            "nodes[1].texture.colour[1]: ",
        ),
        (
            "\"radius\": 1",
            "\"radius\": -1",
            "E201",
            "-1",
            "nodes[0].radius: ",
        ),
        (
            "[0, 0, -1]",
            "[0, 0, 0]",
            "E203",
            "[0, 0, 0]",
            "cameras[0].direction: ",
        ),
        (
            "\"fovy\": 45",
            "\"fovy\": 245",
            "E206",
            "245",
            "cameras[0].fovy: ",
        ),
        (
            "\"radius\": 1",
            "\"radius\": \"1\"",
            "E015",
            "\"1\"",
            "nodes[0].radius: expected a number",
        ),
        (
            "\"fovy\"",
            "\"fov\"",
            "E015",
            "45",
            "cameras[0].fov: there is no `fov` here",
        ),
        (
            "\"of\": 0",
            "\"of\": 7",
            "E015",
            "",
            "nodes[1]: it names node 7",
        ),
        (
            "\"root\": 1",
            "\"root\": 3",
            "E015",
            "{\"root\": 3}",
            "render: there is no node 3",
        ),
        (
            "{\"version\"",
            "{[\"version\"",
            "E015",
            "[",
            "this is not JSON",
        ),
        (
            "\"version\": 1",
            "\"version\": 2",
            "E015",
            "2",
            "version: version 2 is not known",
        ),
    ] {
        let json = GOOD.replace(old, new);
        let (all, status) = found(&json);
        let [(found, at, message)] = &all[..] else {
            panic!("{new}: {all:?}");
        };
        assert_eq!(found, code, "{new}: {message}");
        assert!(message.starts_with(says), "{new}: {message}");
        assert!(at == value || value.is_empty(), "{new}: {at}");
        assert_eq!(status, Some(i32::from(code.starts_with('E'))), "{new}");
    }
    // Levels, settings and formats are those of records.
    let dir = folder(&[("a.json", &GOOD.replace("0.5, 0.5]", "2, 0.5]"))]);
    let short = |args: &[&str]| {
        let args = [&["check", "--format", "short", "a.json"], args].concat();
        text(&zpg(dir.path(), &args).stdout)
    };
    let line = short(&[]);
    assert!(
        line.starts_with("a.json:4:58: W301 warning: nodes[1].texture.colour"),
        "{line}"
    );
    assert_eq!(short(&["--ignore", "W301"]), "");
    let ignored = "lint.per-file-ignores={\"*.json\"=[\"W301\"]}";
    assert_eq!(short(&["--config", ignored]), "");
    let czech = text(&zpg(dir.path(), &["check", "--lang", "cs", "a.json"]).stdout);
    assert!(
        czech.starts_with("varování[W301]: nodes[1].texture.colour"),
        "{czech}"
    );
}

/// What has no ID in the JSON is called by its place.
#[test]
fn made_up_ids_are_not_named() {
    let json = r#"{"version": 1, "nodes": [
        {"type": "sphere", "radius": 1},
        {"type": "box", "min": [0, 0, 0], "max": [1, 1, 1]},
        {"type": "torus", "major": 1, "minor": 2}], "render": {"root": 0}}"#;
    let (all, _) = found(json);
    let unused = all.iter().filter(|f| f.0 == "W310").map(|f| &f.2);
    let unused: Vec<_> = unused.collect();
    assert_eq!(unused.len(), 2, "{all:?}");
    assert!(
        unused[0].contains("nodes[1]") && unused[1].contains("nodes[2]"),
        "{unused:?}"
    );
    assert!(!all.iter().any(|f| f.0.starts_with('S')), "{all:?}");
}

#[test]
fn commands_that_read_take_it() {
    let records = "2 11 0 1 0 1\n2 -701 0.5 0.5 0.5\n50 -402 1\n50 -1 0 5 5\n\
                   9 -501 0 1 5 0 0 -1 0 1 0 45\n1 9999 2 0\n";
    let dir = folder(&[("a.json", GOOD), ("b.zpg", records)]);
    let run = |args: &[&str]| {
        let run = zpg(dir.path(), args);
        assert_eq!(
            run.status.code(),
            Some(0),
            "{args:?}: {}",
            text(&run.stderr)
        );
        text(&run.stdout)
    };
    run(&["render", "a.json", "--size", "16x12"]);
    run(&["render", "b.zpg", "--size", "16x12"]);
    let pixels = |name: &str| image::open(dir.path().join(name)).unwrap().to_rgb8();
    assert!(pixels("a.png") == pixels("b.png"));
    for question in [
        ["--ray", "0 1 9 0 0 -1"],
        ["--pixel", "320,240"],
        ["--point", "0 1 0"],
    ] {
        let [a, b] = ["a.json", "b.zpg"].map(|s| run(&[&["probe", s], &question[..]].concat()));
        assert_eq!(a, b);
    }
    let [a, b] = ["a.json", "b.zpg"].map(|s| run(&["plan", "--json", s]));
    let [a, b] = [a, b].map(|s| serde_json::from_str::<Value>(&s).unwrap());
    let names = |v: &Value| -> Vec<(Value, Value)> {
        let all = v["effects"].as_array().unwrap().iter();
        all.map(|e| (e["name"].clone(), e["on"].clone())).collect()
    };
    assert_eq!(names(&a), names(&b));
    // Reasons are in the lines of the JSON.
    let reasons: Vec<&Value> = a["effects"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|e| e["because"].as_array().unwrap())
        .collect();
    let light = reasons
        .iter()
        .find(|r| r["text"].as_str().unwrap().contains("light"));
    assert_eq!(light.unwrap()["line"], 6, "{reasons:?}");
    // From standard input it is known by how it begins.
    let stdin = program::zpg_with(dir.path(), &["plan", "-"], GOOD);
    assert_eq!(stdin.status.code(), Some(0), "{}", text(&stdin.stderr));
    let named = ["check", "--stdin-filename", "x.json", "-"];
    assert_eq!(
        program::zpg_with(dir.path(), &named, GOOD).status.code(),
        Some(0)
    );
    // A file of records that holds JSON is still no scene.
    fs::write(dir.path().join("c.zpg"), GOOD).unwrap();
    let run = zpg(dir.path(), &["check", "c.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    assert!(text(&run.stdout).contains("E014"));
}

#[test]
fn nothing_is_written_into_it() {
    let dir = folder(&[("a.json", GOOD), ("b.zpg", "2   9 1\n1 9999 2 0\n")]);
    for (args, says) in [
        (&["fmt", "a.json"][..], "which zpg fmt does not lay out"),
        (
            &["fmt", "--check", "a.json"],
            "which zpg fmt does not lay out",
        ),
        (&["check", "--fix", "a.json"], "which zpg check only reads"),
        (&["check", "--diff", "a.json"], "which zpg check only reads"),
        (
            &["check", "--add-allow", "a.json"],
            "which zpg check only reads",
        ),
    ] {
        let run = zpg(dir.path(), args);
        let said = text(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{args:?}");
        assert!(
            said.starts_with("error: a.json is a scene in JSON") && said.contains(says),
            "{said}"
        );
        assert_eq!(fs::read_to_string(dir.path().join("a.json")).unwrap(), GOOD);
    }
    let run = program::zpg_with(dir.path(), &["fmt", "-"], GOOD);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(2), String::new())
    );
    // The others of a run are treated as ever.
    let run = zpg(dir.path(), &["fmt", "a.json", "b.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    let formatted = fs::read_to_string(dir.path().join("b.zpg")).unwrap();
    assert_eq!(formatted, "2 9 1\n1 9999 2 0\n");
}

#[test]
fn what_no_command_can_read() {
    let deep = "[".repeat(100_000) + &"]".repeat(100_000);
    let nested = format!(r#"{{"version": 1, "nodes": [{{"type": "box", "min": {deep}}}]}}"#);
    let many = r#"{"version": 1, "nodes": [{"type": "geodesic-sphere", "radius": 1, "splits": 4294967295}], "render": {"root": 0}}"#;
    for bytes in [
        b"".to_vec(),
        b"{".to_vec(),
        b"null".to_vec(),
        b"\xff\xfe\x00".to_vec(),
        b"\x89PNG\r\n\x1a\n\0\0".to_vec(),
        deep.clone().into_bytes(),
        nested.into_bytes(),
        many.as_bytes().to_vec(),
        "[".repeat(100_000).into_bytes(),
        r#"{"a":"#.repeat(100_000).into_bytes(),
    ] {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("a.json"), &bytes).unwrap();
        for args in [
            &["check", "a.json"][..],
            &["render", "a.json"],
            &["plan", "a.json"],
            &["probe", "a.json", "--point", "0 0 0"],
            &["convert", "a.json", "--to", "zpg"],
        ] {
            let run = zpg(dir.path(), args);
            let said = text(&run.stdout) + &text(&run.stderr);
            let start = String::from_utf8_lossy(&bytes[..bytes.len().min(20)]).into_owned();
            assert_eq!(run.status.code(), Some(1), "{start} {args:?}: {said}");
            assert!(said.starts_with("error[E"), "{start} {args:?}: {said}");
            assert!(said.len() < 3000, "{start} {args:?}: {} bytes", said.len());
        }
    }
}
