//! The licences of the libraries that the program is made of are those that `deny.toml` allows.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde_json::Value;

/// The licences that a file allows, in a list called so.
fn allowed(file: &str, path: &[&str]) -> BTreeSet<String> {
    let text = std::fs::read_to_string(file).unwrap();
    let table: toml::Table = text.parse().unwrap();
    let list = path
        .iter()
        .fold(&toml::Value::Table(table), |value, key| &value[key])
        .clone();
    let list = list.as_array().unwrap().clone();
    list.iter()
        .map(|v| v.as_str().unwrap().to_owned())
        .collect()
}

/// Whether an expression of SPDX, or an older one with slashes, is met by some licences.
fn is_met(expression: &str, allowed: &BTreeSet<String>) -> bool {
    expression.split(" AND ").all(|part| {
        let part = part.trim_matches(['(', ')']).replace('/', " OR ");
        part.split(" OR ").any(|name| allowed.contains(name.trim()))
    })
}

#[test]
fn expressions_are_read() {
    let allowed = ["MIT", "IJG"].map(str::to_owned).into();
    for (expression, met) in [
        ("MIT", true),
        ("GPL-2.0-only", false),
        ("MIT OR GPL-2.0-only", true),
        ("Unlicense/MIT", true),
        ("(MIT OR Apache-2.0) AND IJG", true),
        ("(MIT OR Apache-2.0) AND NCSA", false),
    ] {
        assert_eq!(is_met(expression, &allowed), met, "{expression}");
    }
}

#[test]
fn libraries_have_licences_that_are_allowed() {
    let ours = allowed("deny.toml", &["licenses", "allow"]);
    assert_eq!(ours, allowed("packages/about.toml", &["accepted"]));
    let cargo = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--format-version", "1"])
        .args(["--filter-platform", "x86_64-unknown-linux-gnu"])
        .output()
        .unwrap();
    assert!(
        cargo.status.success(),
        "{}",
        String::from_utf8_lossy(&cargo.stderr)
    );
    let all: Value = serde_json::from_slice(&cargo.stdout).unwrap();
    let text = |v: &Value| v.as_str().unwrap_or_default().to_owned();
    let packages: BTreeMap<String, &Value> = (all["packages"].as_array().unwrap().iter())
        .map(|p| (text(&p["id"]), p))
        .collect();
    let nodes: BTreeMap<String, &Value> = (all["resolve"]["nodes"].as_array().unwrap().iter())
        .map(|n| (text(&n["id"]), n))
        .collect();
    let root = packages.iter().find(|(_, p)| p["name"] == "zpg").unwrap().0;
    let (mut todo, mut seen) = (vec![root.clone()], BTreeSet::new());
    while let Some(id) = todo.pop() {
        if !seen.insert(id.clone()) {
            continue;
        }
        for dependency in nodes[&id]["deps"].as_array().unwrap() {
            // Those of tests and build scripts are not part of the program.
            let kinds = dependency["dep_kinds"].as_array().unwrap();
            if kinds.iter().any(|kind| kind["kind"].is_null()) {
                todo.push(text(&dependency["pkg"]));
            }
        }
    }
    assert!(seen.len() > 100, "{}", seen.len());
    for id in seen {
        let package = packages[&id];
        let licence = package["license"].as_str();
        // Some have a file of it instead, which `cargo about` reads.
        let is_right = match licence {
            Some(expression) => is_met(expression, &ours),
            None => package["license_file"].is_string(),
        };
        assert!(is_right, "{}: {licence:?}", package["name"]);
    }
}
