//! Answers for clients that can less than others, and answers about large scenes.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::session::{Session, rich};
use super::{A, SCENE, at, edited, everything, file, with};

/// Every request of an editor that asks for all there is.
const ABOUT_FILES: [&str; 8] = [
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/documentColor",
    "textDocument/codeLens",
    "textDocument/formatting",
    "textDocument/semanticTokens/full",
    "textDocument/inlayHint",
    "textDocument/codeAction",
];

fn whole(s: &mut Session, method: &str) -> Value {
    let mut params = file();
    params["range"] = json!({ "start": at(0, 0), "end": at(1_000_000, 0) });
    params["context"] = json!({ "diagnostics": [] });
    params["options"] = json!({ "tabSize": 2, "insertSpaces": true });
    s.try_ask(method, params).unwrap()
}

/// A scene of so many lines whose IDs begin at 1000: balls in their places and colours, each put to the union of all
/// before.
fn large(lines: usize) -> String {
    let mut text = String::from("0 # Balls #\n1000 11 0 1 0 1\n");
    let (mut id, mut all) = (1001, 1000);
    for i in 0..lines / 4 {
        let (ball, union) = (id, id + 1);
        let _ = writeln!(
            text,
            "{ball} 11 {} 1.5 {} 0.25 # ball {i} #",
            i % 99,
            i / 99
        );
        let _ = writeln!(text, "{ball} -1 0.5 0 0.125\n{ball} -701 0.5 0.25 0.125");
        let _ = writeln!(text, "{union} -101 {all} {ball}");
        (id, all) = (id + 2, union);
    }
    let _ = writeln!(text, "0 # The end #\n{id} -402 1\n1 9999 {all} 0");
    text
}

/// Actions of whole files: their edits come when somebody chooses one. How that goes depends on the client.
#[test]
fn whole_files_are_changed_when_it_is_asked_for() {
    // An ID out of order, and marks that a safe fix removes.
    let text = "22 11  0 1 0  1\n22 -701 <0.9 0.2 0.1>\n3 4 0 1 0 0\n4 -101 22 3\n1 9999 4 0\n";
    let is_of_file =
        |a: &&Value| a["kind"] != "quickfix" && a["kind"] != "refactor.rewrite.comment";
    let kinds = |all: &Value| -> Vec<String> {
        let all = all.as_array().unwrap().iter();
        let of_file = all.filter(is_of_file);
        of_file
            .map(|a| a["kind"].as_str().unwrap().to_owned())
            .collect()
    };
    let offered = |s: &mut Session, only: Value| {
        let mut context = json!({ "diagnostics": [] });
        if only.is_array() {
            context["only"] = only;
        }
        let params = with(with(file(), "range", everything()), "context", context);
        s.ask("textDocument/codeAction", params)
    };
    let mut applies = rich();
    applies["textDocument"]["codeAction"] = json!({});
    let mut neither = applies.clone();
    neither["workspace"]["applyEdit"] = json!(false);

    // With a command.
    let mut s = Session::start(applies, Value::Null);
    s.open(A, text);
    let all = offered(&mut s, Value::Null);
    assert_eq!(
        kinds(&all),
        ["source.fixAll.zpg", "refactor.rewrite.renumber"]
    );
    for action in all.as_array().unwrap().iter().filter(is_of_file) {
        assert_eq!(action["edit"], Value::Null);
        let command = &action["command"];
        let params = json!({ "command": command["command"], "arguments": command["arguments"] });
        s.ask("workspace/executeCommand", params);
        let asked = s.heard("workspace/applyEdit");
        assert_eq!(asked["label"], action["title"]);
        let edits = &asked["edit"]["documentChanges"][0]["edits"];
        let after = edited(text, edits);
        match action["kind"].as_str() {
            Some("refactor.rewrite.renumber") => {
                assert!(after.starts_with("2 11  0 1 0  1\n2 -701 <0"), "{after}");
                assert!(after.contains("-101 2 3"), "{after}");
            }
            _ => assert!(after.contains("22 -701 0.9 0.2 0.1\n"), "{after}"),
        }
    }
    // At once, where it is asked for by its kind; elsewhere not at all.
    let mut s = Session::start(neither, Value::Null);
    s.open(A, text);
    let all = offered(&mut s, Value::Null);
    assert_eq!(kinds(&all), [] as [&str; 0]);
    let all = offered(&mut s, json!(["refactor.rewrite.renumber"]));
    assert!(all[0]["edit"]["documentChanges"][0]["edits"].is_array());
}

/// Where nothing is to do, or nobody to do it, no edit is asked for.
#[test]
fn there_are_no_empty_edits() {
    let folder = tempfile::tempdir().unwrap();
    let uri = |path: &std::path::Path| format!("file://{}", path.to_str().unwrap());
    let [here, gone] = ["a.zpg", "gone.zpg"].map(|name| folder.path().join(name));
    std::fs::write(&here, "2 9 1\n1 9999 2 0\n").unwrap();
    let wrong = "22 9 0,5\n1 9999 22 0\n";
    let mut without = rich();
    without["workspace"]["applyEdit"] = json!(false);
    for (capabilities, applies) in [(rich(), true), (without, false), (json!({}), false)] {
        let mut s = Session::start(capabilities, Value::Null);
        s.open(A, "2 9 1\n1 9999 2 0\n");
        let broken = "file:///nowhere/broken.zpg";
        s.open(broken, "2 9\n1 9999 2 0\n");
        for (command, kind) in [
            ("zpg.fixAll", "source.fixAll.zpg"),
            ("zpg.renumber", "refactor.rewrite.renumber"),
        ] {
            let run = |s: &mut Session, uri: &str| {
                let params = json!({ "command": command, "arguments": [uri] });
                s.try_ask("workspace/executeCommand", params)
            };
            for uri in [A, broken, &uri(&here)] {
                match run(&mut s, uri) {
                    Ok(answer) => assert_eq!((answer, applies), (Value::Null, true)),
                    Err(why) => {
                        let message = why["message"].as_str().unwrap();
                        assert!(!applies && message.ends_with(kind), "{message}");
                    }
                }
            }
            for uri in [A, broken, &uri(&here), &uri(&gone)] {
                let action = json!({ "title": "t", "kind": kind, "data": { "uri": uri } });
                assert_eq!(s.ask("codeAction/resolve", action.clone()), action);
            }
            for uri in [uri(&gone), uri(folder.path()), "untitled:U".to_owned()] {
                let why = run(&mut s, &uri).unwrap_err();
                let message = why["message"].as_str().unwrap();
                assert!(message.ends_with("is not there"), "{message}");
            }
        }
        let context =
            json!({ "diagnostics": [], "only": ["source.fixAll", "refactor.rewrite.renumber"] });
        let params = with(with(file(), "range", everything()), "context", context);
        let all = s.ask("textDocument/codeAction", params);
        let empty = |a: &Value| !a["edit"].is_null();
        assert!(!all.as_array().unwrap().iter().any(empty), "{all}");
        s.ask("textDocument/hover", with(file(), "position", at(0, 0)));
        let asked = |s: &Session| s.said.iter().any(|(m, _)| m == "workspace/applyEdit");
        assert!(!asked(&s));
        s.replace(A, 2, wrong);
        let params = json!({ "command": "zpg.fixAll", "arguments": [A] });
        let _ = s.try_ask("workspace/executeCommand", params);
        s.ask("textDocument/hover", with(file(), "position", at(0, 0)));
        assert_eq!(asked(&s), applies);
    }
}

#[test]
fn two_uses_are_worth_a_button() {
    let mut s = Session::start(rich(), json!({ "commands": ["zpg.showReferences"] }));
    s.open(A, "2 9 1\n3 9 2\n4 -101 2 3\n5 -101 2 4\n1 9999 5 0\n");
    let all = s.ask("textDocument/codeLens", file());
    let used = |l: &&Value| l["command"]["command"] == "zpg.showReferences";
    let used: Vec<&Value> = all.as_array().unwrap().iter().filter(used).collect();
    assert_eq!(used.len(), 1);
    assert_eq!(used[0]["command"]["title"], "used 2 times");
    assert_eq!(used[0]["range"]["start"], at(0, 0));
}

/// The same symbols, as a tree and one after the other.
#[test]
fn symbols_are_flat_where_the_client_knows_no_trees() {
    fn count(symbol: &Value) -> usize {
        let children = symbol["children"].as_array();
        1 + children.map_or(0, |all| all.iter().map(count).sum())
    }
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, SCENE);
    let tree = s.ask("textDocument/documentSymbol", file());
    let total: usize = tree.as_array().unwrap().iter().map(count).sum();
    for said in [
        json!({ "hierarchicalDocumentSymbolSupport": false }),
        json!({}),
    ] {
        let mut flat = rich();
        flat["textDocument"]["documentSymbol"] = said;
        let mut s = Session::start(flat, Value::Null);
        s.open(A, SCENE);
        let all = s.ask("textDocument/documentSymbol", file());
        let all = all.as_array().unwrap();
        assert_eq!(all.len(), total);
        assert!(
            all.iter()
                .all(|s| s["location"]["uri"] == A && s["children"] == Value::Null)
        );
        let ball = all.iter().find(|s| s["name"] == "2 ball").unwrap();
        assert_eq!(ball["containerName"], "4 union");
        assert_eq!(ball["location"]["range"]["start"], at(1, 0));
    }
}

/// Chains of operations are no deep trees, and long scenes make no long outlines.
#[test]
fn outlines_are_shallow() {
    fn depth(symbol: &Value) -> usize {
        let children = symbol["children"].as_array();
        1 + children.map_or(0, |all| all.iter().map(depth).max().unwrap_or(0))
    }
    let text = large(4000);
    // With names, each union is a part of its own.
    let named: String = text
        .lines()
        .map(|l| {
            l.to_owned()
                + if l.contains("-101") {
                    " # more #\n"
                } else {
                    "\n"
                }
        })
        .collect();
    for (text, most) in [(&text, 3), (&named, 13)] {
        let mut s = Session::start(rich(), Value::Null);
        s.open(A, text);
        let all = s.ask("textDocument/documentSymbol", file());
        assert_eq!(all[0]["name"], "Balls");
        assert_eq!(all[1]["name"], "The end");
        let deepest = all.as_array().unwrap().iter().map(depth).max();
        assert_eq!(deepest, Some(most));
        // Whoever needs more of an answer than the line that it is about would not be quick.
        assert!(
            all.to_string().len() < 14 * text.len() / 3,
            "{}",
            all.to_string().len()
        );
    }
}

/// Everything about a scene of 5000 lines, twice. With answers as trees of values the server took 170 MiB.
#[test]
#[cfg(target_os = "linux")]
fn large_answers_take_little_memory() {
    let mut s = Session::program(json!({ "textDocument": { "documentSymbol": {
        "hierarchicalDocumentSymbolSupport": true } } }));
    let text = large(5_000);
    s.open(A, &text);
    for version in 1..3 {
        s.diagnostics(version);
        for method in ABOUT_FILES {
            whole(&mut s, method);
        }
        s.replace(
            A,
            version + 1,
            &text.replace("ball 7", &format!("ball {version}")),
        );
    }
    let child = s.child.as_ref().unwrap().id();
    let status = std::fs::read_to_string(format!("/proc/{child}/status")).unwrap();
    let peak = status
        .lines()
        .find_map(|l| l.strip_prefix("VmHWM:"))
        .unwrap();
    let peak: u64 = peak.split_whitespace().next().unwrap().parse().unwrap();
    assert!(peak < 80 << 10, "{} MiB", peak >> 10);
    s.end();
}
