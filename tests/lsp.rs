//! The language server, spoken to as editors do. What it answers is tested as data in `features`; here is the form
//! of its messages, and that it lives on whatever it is sent.

mod answers;
mod edited;
pub mod model;
mod not_open;
#[cfg(unix)]
mod others;
mod session;

use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use session::{Session, rich};

const A: &str = "file:///nowhere/a.zpg";

const SCENE: &str = "0 # parts #
2 11  0 1 0  1 # ball #
2 -701 0.9 0.2 0.1
3 4 0 1 0 0
4 -101 2 3
5 -202  0.5 0.5 0  0.5 0.5 0  0.5 0.5 0
7 14 3 0,5
1 9999 4 0
";

fn at(line: u32, character: u32) -> Value {
    json!({ "line": line, "character": character })
}

fn place(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": A }, "position": at(line, character) })
}

fn file() -> Value {
    json!({ "textDocument": { "uri": A } })
}

fn with(mut params: Value, name: &str, value: Value) -> Value {
    params[name] = value;
    params
}

fn everything() -> Value {
    json!({ "start": at(0, 0), "end": at(99, 0) })
}

/// Every request about an open file that has an answer of the protocol's, with parameters for [`SCENE`].
fn every_request() -> Vec<(&'static str, Value)> {
    let only = |kind: &str| json!({ "diagnostics": [], "only": [kind] });
    let style = json!({ "tabSize": 2, "insertSpaces": true });
    let range = |name: &str, value: Value| with(with(file(), "range", everything()), name, value);
    let red = json!({ "red": 0.5, "green": 0, "blue": 0, "alpha": 1 });
    let colour = json!({ "start": at(2, 7), "end": at(2, 18) });
    vec![
        (
            "textDocument/inlayHint",
            with(file(), "range", everything()),
        ),
        ("textDocument/hover", place(4, 7)),
        ("textDocument/signatureHelp", place(1, 7)),
        ("textDocument/completion", place(4, 7)),
        ("textDocument/definition", place(4, 7)),
        (
            "textDocument/references",
            with(
                place(4, 7),
                "context",
                json!({ "includeDeclaration": true }),
            ),
        ),
        ("textDocument/documentHighlight", place(4, 7)),
        ("textDocument/prepareRename", place(4, 7)),
        (
            "textDocument/rename",
            with(place(4, 7), "newName", "77".into()),
        ),
        (
            "textDocument/formatting",
            with(file(), "options", style.clone()),
        ),
        (
            "textDocument/rangeFormatting",
            range("options", style.clone()),
        ),
        (
            "textDocument/onTypeFormatting",
            with(with(place(4, 0), "ch", "\n".into()), "options", style),
        ),
        ("textDocument/documentSymbol", file()),
        ("workspace/symbol", json!({ "query": "ball" })),
        (
            "textDocument/codeAction",
            range("context", json!({ "diagnostics": [] })),
        ),
        (
            "textDocument/codeAction",
            range("context", only("source.fixAll")),
        ),
        ("textDocument/codeLens", file()),
        ("textDocument/documentColor", file()),
        (
            "textDocument/colorPresentation",
            with(with(file(), "color", red), "range", colour),
        ),
        ("textDocument/foldingRange", file()),
        (
            "textDocument/selectionRange",
            with(file(), "positions", json!([at(1, 7), at(5, 9)])),
        ),
        ("textDocument/semanticTokens/full", file()),
        (
            "textDocument/semanticTokens/full/delta",
            with(file(), "previousResultId", "1".into()),
        ),
        (
            "textDocument/semanticTokens/range",
            with(file(), "range", everything()),
        ),
        (
            "textDocument/codeAction",
            range("context", only("refactor.rewrite.comment")),
        ),
        ("zpg/comment", with(file(), "ranges", json!([everything()]))),
        ("textDocument/prepareCallHierarchy", place(4, 7)),
    ]
}

/// Every request, sent by a client that can all and by one that can nothing. The form of each answer is checked
/// where it comes in.
#[test]
fn every_request_is_answered_in_the_protocols_form() {
    let options = json!({ "commands": ["zpg.preview", "zpg.showReferences"] });
    for capabilities in [rich(), json!({})] {
        let mut s = Session::start(capabilities.clone(), options.clone());
        s.open(A, SCENE);
        assert_eq!(s.diagnostics(1)[0]["code"], "E003");
        for (method, params) in every_request() {
            let answer = s.ask(method, params);
            let is_empty = answer.is_null() || answer.as_array().is_some_and(Vec::is_empty);
            assert!(!is_empty, "{method} has no answer");
        }
        let ball = s.ask("textDocument/prepareCallHierarchy", place(4, 7))[0].clone();
        let calls = s.ask("callHierarchy/incomingCalls", json!({ "item": ball }));
        assert_eq!(calls[0]["from"]["name"], "4 union");
        let calls = s.ask(
            "callHierarchy/outgoingCalls",
            json!({ "item": calls[0]["from"] }),
        );
        assert_eq!(calls[0]["to"]["name"], "2 ball");
        s.end();
    }
}

/// Clients that pull are told what has changed, and nothing unasked. More of it is in `tests/editors/flows`.
#[test]
fn diagnostics_are_pulled_where_the_client_pulls() {
    let mut pulls = rich();
    pulls["textDocument"]["diagnostic"] = json!({});
    let mut s = Session::start(pulls, Value::Null);
    s.open(A, SCENE);
    let report = s.ask("textDocument/diagnostic", file());
    assert_eq!(report["kind"], "full");
    assert_eq!(report["items"][0]["code"], "E003");
    let known = with(file(), "previousResultId", report["resultId"].clone());
    let again = s.ask("textDocument/diagnostic", known);
    assert_eq!(
        (again["kind"].as_str(), &again["resultId"]),
        (Some("unchanged"), &report["resultId"])
    );
    let all = s.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert_eq!(
        (&all["items"][0]["items"], &all["items"][0]["version"]),
        (&report["items"], &json!(1))
    );
    s.replace(A, 2, "2 9 1\n1 9999 2 0\n");
    let report = s.ask("textDocument/diagnostic", file());
    assert!(
        report["items"]
            .as_array()
            .unwrap()
            .iter()
            .all(|d| d["severity"] != 1)
    );
    assert!(
        s.said
            .iter()
            .all(|(method, _)| method != "textDocument/publishDiagnostics")
    );
}

/// 3000 wrong lines: a thousand are shown, and one more says how many are not.
#[test]
fn a_thousand_findings_are_enough() {
    let mut s = Session::start(rich(), Value::Null);
    let text: String = (2..3002).map(|i| format!("{i} 9 0,5\n")).collect();
    s.open(A, &text);
    let all = s.diagnostics(1);
    assert_eq!(all.len(), 1001);
    assert!(all[..1000].iter().all(|d| d["code"] == "E003"));
    let rest = all[1000]["message"].as_str().unwrap();
    assert!(rest.contains("more findings are left out"), "{rest}");
}

/// The text after the edits of an answer, counted in UTF-16.
fn edited(text: &str, edits: &Value) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let offset = |p: &Value| {
        let (line, units) = (
            p["line"].as_u64().unwrap() as usize,
            p["character"].as_u64().unwrap(),
        );
        let start: usize = lines[..line].iter().map(|l| l.len()).sum();
        let mut left = units as usize;
        let mut at = start;
        for c in text[start..].chars() {
            if left == 0 {
                break;
            }
            left -= c.len_utf16();
            at += c.len_utf8();
        }
        at
    };
    let mut edits: Vec<(usize, usize, &str)> = (edits.as_array().unwrap().iter())
        .map(|e| {
            let range = &e["range"];
            let text = e["newText"].as_str().unwrap();
            (offset(&range["start"]), offset(&range["end"]), text)
        })
        .collect();
    edits.sort();
    let mut out = text.to_owned();
    for (start, end, new) in edits.into_iter().rev() {
        out.replace_range(start..end, new);
    }
    out
}

/// One scene with characters of all widths before the IDs, in each of the units that a client may count in.
#[test]
fn positions_in_all_units() {
    // The 2 in `-101 2 3` is behind: 4 bytes of the emoji, 2 of ž.
    let text = "2 9 1\r\n3 9 2\r4 # ž😀 # -101 2 3\n";
    for (units, column) in [("utf-8", 18), ("utf-16", 15), ("utf-32", 14)] {
        let mut capabilities = rich();
        capabilities["general"]["positionEncodings"] = json!([units]);
        let mut s = Session::start(capabilities, Value::Null);
        s.open(A, text);
        let found = s.ask("textDocument/definition", place(2, column));
        assert_eq!(found["range"]["start"], at(0, 0), "{units}");
        let uses = with(
            place(0, 0),
            "context",
            json!({ "includeDeclaration": false }),
        );
        let found = s.ask("textDocument/references", uses);
        let range = json!({ "start": at(2, column), "end": at(2, column + 1) });
        assert_eq!(found[0]["range"], range, "{units}");
    }
}

/// The request and the action say the same, in the client's units; what went out comes in. Nothing is offered unasked.
#[test]
fn comments_go_out_and_in() {
    let mut s = Session::start(rich(), Value::Null);
    let text = "# ž😀 # 2 9 1 #😀#\r\n\r\n10 -701 0.8 0.1 0.1 # red #\r\n";
    let range = json!({ "start": at(0, 5), "end": at(2, 1) });
    let ask = |mode: &str| {
        let params = with(file(), "ranges", json!([range]));
        with(params, "mode", mode.into())
    };
    let context = |value: Value| with(with(file(), "range", range.clone()), "context", value);
    let only = json!({ "diagnostics": [], "only": ["refactor.rewrite"] });
    let out = "0 # ~ ~~ ž😀 ~~ 2 9 1 ~~😀~~ #\r\n\r\n0 # ~ 10 -701 0.8 0.1 0.1 ~~ red ~~ #\r\n";
    s.open(A, text);
    for (version, before, after, title) in
        [(2, text, out, "Comment out"), (3, out, text, "Comment in")]
    {
        let edits = s.ask("zpg/comment", ask("toggle"));
        assert_eq!(edited(before, &edits), after);
        let actions = s.ask("textDocument/codeAction", context(only.clone()));
        let own = |a: &&Value| a["kind"] == "refactor.rewrite.comment";
        let action = actions.as_array().unwrap().iter().find(own).unwrap();
        assert_eq!(action["title"], title);
        assert_eq!(action["edit"]["documentChanges"][0]["edits"], edits);
        s.replace(A, version, after);
    }
    assert_eq!(s.ask("zpg/comment", ask("in")), json!([]));
    let unasked = json!({ "diagnostics": [], "triggerKind": 2 });
    let all = s.ask("textDocument/codeAction", context(unasked));
    assert!(!all.to_string().contains("Comment"), "{all}");
}

/// Edits at random places, some out of range: what the server has is what a client has.
#[test]
fn edits_keep_the_texts_alike() {
    let mut s = Session::start(rich(), Value::Null);
    let mut text = SCENE.replace("parts", "části 😀");
    s.open(A, &text);
    let mut seed = 7u64;
    let mut random = |n: usize| {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (seed >> 33) as usize % n
    };
    for version in 2..200 {
        let lines = text.matches('\n').count();
        let [a, b] = [0, 1].map(|_| at(random(lines + 2) as u32, random(20) as u32));
        let (start, end) = match (a["line"].as_u64(), a["character"].as_u64())
            <= (b["line"].as_u64(), b["character"].as_u64())
            && random(3) > 0
        {
            true => (a.clone(), if random(8) == 0 { b } else { a }),
            false => (a.clone(), a),
        };
        let new = ["1", " ", "\n", "😀", "# ř #", "3 9 1\n", ""][random(7)];
        let range = json!({ "start": start, "end": end });
        // Positions behind a line's end mean its end.
        let clamped = |p: &Value| {
            let line = p["line"].as_u64().unwrap() as usize;
            match text.split('\n').nth(line) {
                Some(content) => {
                    let most = content.encode_utf16().count() as u64;
                    let mut units = p["character"].as_u64().unwrap().min(most) as u32;
                    // Not within a character of two units.
                    let mut before = 0;
                    for c in content.chars() {
                        let next = before + c.len_utf16() as u32;
                        if before < units && units < next {
                            units = before;
                        }
                        before = next;
                    }
                    at(line as u32, units)
                }
                None => {
                    let last = text.rsplit('\n').next().unwrap();
                    let line = text.matches('\n').count() as u32;
                    at(line, last.encode_utf16().count() as u32)
                }
            }
        };
        let edit = json!([{ "range": { "start": clamped(&start), "end": clamped(&end) }, "newText": new }]);
        text = edited(&text, &edit);
        let change = json!([{ "range": range, "text": new }]);
        s.tell(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": A, "version": version }, "contentChanges": change }),
        );
    }
    let style = json!({ "tabSize": 2, "insertSpaces": true });
    let edits = s.ask("textDocument/formatting", with(file(), "options", style));
    let source = zpg::internals::diagnostics::SourceFile::new("a", text.clone().into_bytes());
    let analysis = zpg::internals::analysis::Analysis::of(source);
    let formatted = zpg::internals::format::format(&text, &analysis.document, &Default::default());
    match zpg::internals::syntax::recognise::is_scene(&text) {
        true => assert_eq!(edited(&text, &edits), formatted),
        // `zpg fmt` does not write to it.
        false => assert!(edits.is_null(), "{text}"),
    }
}

#[test]
fn tokens_are_told_by_their_difference() {
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, SCENE);
    let whole = |s: &mut Session| s.ask("textDocument/semanticTokens/full", file());
    let first = whole(&mut s);
    s.replace(
        A,
        2,
        &SCENE.replace("3 4 0 1 0 0", "3 4 0 1 0 0 # new #\n9 9 1"),
    );
    let params = with(file(), "previousResultId", first["resultId"].clone());
    let delta = s.ask("textDocument/semanticTokens/full/delta", params);
    let mut data: Vec<u64> = serde_json::from_value(first["data"].clone()).unwrap();
    let edit = &delta["edits"][0];
    let start = edit["start"].as_u64().unwrap() as usize;
    let gone = edit["deleteCount"].as_u64().unwrap() as usize;
    let new: Vec<u64> = serde_json::from_value(edit["data"].clone()).unwrap();
    assert!(new.len() < data.len() / 2);
    data.splice(start..start + gone, new);
    assert_eq!(json!(data), whole(&mut s)["data"]);
}

/// Settings of the folder count, are read again when they change, and are told of when they are wrong.
#[test]
fn settings_are_those_of_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let write = |text: &str| std::fs::write(folder.path().join("zpg.toml"), text).unwrap();
    let uri = format!("file://{}/a.zpg", folder.path().to_str().unwrap());
    write("[lint]\nW310 = \"off\"\n[format]\ngroup = false\n");
    let mut s = Session::start(rich(), Value::Null);
    let watched = s.heard("client/registerCapability");
    assert!(watched.to_string().contains("**/zpg.toml"));
    s.open(&uri, "2 9 1\n3 11  0 1 0  1\n1 9999 2 0\n");
    let codes = |all: Vec<Value>| -> Vec<String> {
        let code = |d: &Value| d["code"].as_str().unwrap_or("none").to_owned();
        all.iter().map(code).collect()
    };
    assert_eq!(codes(s.diagnostics(1)), ["N602", "N603"]);
    let style = json!({ "tabSize": 2, "insertSpaces": true });
    let format = json!({ "textDocument": { "uri": uri }, "options": style.clone() });
    let edits = s.ask("textDocument/formatting", format);
    assert_eq!(edits[0]["newText"], "3 11 0 1 0 1\n");
    let changed = json!({ "changes": [{ "uri": uri.replace("a.zpg", "zpg.toml"), "type": 2 }] });
    write("");
    s.tell("workspace/didChangeWatchedFiles", changed.clone());
    assert!(codes(s.diagnostics(1)).contains(&"W310".to_owned()));
    write("[lint]\nW310 = 7\n");
    s.tell("workspace/didChangeWatchedFiles", changed.clone());
    assert_eq!(codes(s.diagnostics(1))[0], "none");
    // How the file is to look is not known.
    let format = json!({ "textDocument": { "uri": uri }, "options": style.clone() });
    assert_eq!(s.ask("textDocument/formatting", format), Value::Null);
    // Files have codes of their own that are ignored, and may be left out.
    write("[lint.per-file-ignores]\n\"a.zpg\" = [\"W310\"]\n\"!a.zpg\" = [\"N602\"]\n");
    s.tell("workspace/didChangeWatchedFiles", changed.clone());
    assert_eq!(codes(s.diagnostics(1)), ["N602", "N603"]);
    write("exclude = [\"a.*\"]\n");
    s.tell("workspace/didChangeWatchedFiles", changed);
    assert_eq!(codes(s.diagnostics(1)), Vec::<String>::new());
    let format = json!({ "textDocument": { "uri": uri }, "options": style });
    assert_eq!(s.ask("textDocument/formatting", format), Value::Null);
    let everywhere = json!({ "start": at(0, 0), "end": at(3, 0) });
    let actions = json!({
        "textDocument": { "uri": uri },
        "range": everywhere,
        "context": { "diagnostics": [] },
    });
    assert_eq!(s.ask("textDocument/codeAction", actions), Value::Null);
}

/// A line break within a record leaves it alone, and what is no scene is never formatted.
#[test]
fn what_is_under_way_is_left_alone() {
    let style = json!({ "tabSize": 2, "insertSpaces": true });
    let broken_line = |s: &mut Session, line| {
        let place = with(
            with(place(line, 0), "ch", "\n".into()),
            "options",
            style.clone(),
        );
        s.ask("textDocument/onTypeFormatting", place)
    };
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, "2 1 3\n  0 0\n\n  1 1\n  0 2\n3   9   1\n\n1 9999 2 0\n");
    assert_eq!(broken_line(&mut s, 2), json!([]));
    let edits = broken_line(&mut s, 6);
    assert_eq!(edits[0]["newText"], "3 9 1");
    s.replace(A, 2, "lorem ipsum dolor  \n\n\n\n sit 5   6");
    let format = with(file(), "options", style.clone());
    assert_eq!(s.ask("textDocument/formatting", format), Value::Null);
    assert_eq!(broken_line(&mut s, 1), Value::Null);
}

#[test]
fn what_is_wanted_can_be_changed() {
    let options = json!({ "hints": { "references": false, "profiles": false } });
    let mut s = Session::start(rich(), options);
    s.open(A, SCENE);
    let labels = |s: &mut Session| -> Vec<String> {
        let all = s.ask(
            "textDocument/inlayHint",
            with(
                file(),
                "range",
                json!({ "start": at(4, 0), "end": at(4, 10) }),
            ),
        );
        let label = |h: &Value| h["label"].as_str().unwrap().to_owned();
        all.as_array().unwrap().iter().map(label).collect()
    };
    assert_eq!(labels(&mut s), ["union", "B:", "C:"]);
    let settings = json!({ "zpg": { "hints": { "types": false, "parameters": false } } });
    s.tell(
        "workspace/didChangeConfiguration",
        json!({ "settings": settings }),
    );
    s.heard("workspace/inlayHint/refresh");
    assert_eq!(labels(&mut s), ["ball", "half-space"]);
}

/// An action of the whole file gets its edit when it is asked for, and keeps what else is in it.
#[test]
fn an_action_is_resolved() {
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, SCENE);
    let context = json!({ "diagnostics": [], "only": ["source.fixAll"] });
    let params = with(with(file(), "range", everything()), "context", context);
    let offered = s.ask("textDocument/codeAction", params)[0].clone();
    assert_eq!(offered["edit"], Value::Null);
    let resolved = s.ask("codeAction/resolve", offered.clone());
    let edit = &resolved["edit"]["documentChanges"][0]["edits"][0];
    assert_eq!(edit["newText"], "7 14 3 0.5\n");
    assert_eq!(
        with(resolved, "edit", Value::Null),
        with(offered, "edit", Value::Null)
    );
}

/// Wrong parameters, unknown methods, files that were never opened: an error each, and the next answer is right.
#[test]
fn nonsense_is_refused() {
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, SCENE);
    let other = json!({ "textDocument": { "uri": "nonsense" }, "position": at(0, 0) });
    for (method, params, code) in [
        ("textDocument/hover", json!({}), -32602),
        ("textDocument/hover", json!([1]), -32602),
        ("textDocument/hover", other.clone(), -32602),
        ("textDocument/nothing", json!({}), -32601),
        ("codeAction/resolve", json!([1]), -32602),
        ("initialize", json!({}), -32600),
        (
            "workspace/executeCommand",
            json!({ "command": "rm", "arguments": [A] }),
            -32602,
        ),
        (
            "workspace/executeCommand",
            json!({ "command": "zpg.render", "arguments": [7] }),
            -32602,
        ),
        (
            "textDocument/rename",
            with(place(4, 7), "newName", "x".into()),
            -32803,
        ),
    ] {
        let error = s.try_ask(method, params.clone()).unwrap_err();
        assert_eq!(error["code"], code, "{method} {params}: {error}");
    }
    s.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": "x", "version": 1 }, "contentChanges": [] }),
    );
    s.tell("textDocument/didChange", json!({ "textDocument": 3 }));
    s.tell("textDocument/didClose", other);
    s.tell("$/cancelRequest", json!({ "id": { "a": 1 } }));
    s.tell("$/cancelRequest", json!({ "id": 77 }));
    s.tell("$/whatever", Value::Null);
    s.ask("textDocument/hover", place(u32::MAX >> 1, u32::MAX >> 1));
    assert!(s.ask("textDocument/hover", place(4, 7)).is_object());
    s.ask("shutdown", Value::Null);
    let error = s.try_ask("textDocument/hover", place(4, 7)).unwrap_err();
    assert_eq!(error["code"], -32600);
}

/// A scene that takes long to draw: mirrors that face each other.
fn slow_scene() -> String {
    let mut text = String::from("2 -201 0.1 0.9 0\n3 9 1\n3 -299 0 2\n");
    for i in 4..40 {
        text += &format!("{i} -105 3\n{i} -1 {} {} 0\n", i % 6 * 2, i / 6 * 2);
    }
    text += "100 -101 4 5\n";
    for i in 6..40 {
        text += &format!("{} -101 {} {i}\n", 95 + i, 94 + i);
    }
    text + "1 9999 134 0\n"
}

/// A picture that takes long delays nothing; it comes coarse first; an edit ends it.
#[test]
fn pictures_are_drawn_aside() {
    let mut s = Session::start(rich(), Value::Null);
    s.open(A, &slow_scene());
    let large = json!({ "width": 1024, "height": 1024, "partialResultToken": "p" });
    let ask = |mut params: Value| {
        for (name, value) in file().as_object().unwrap() {
            params[name] = value.clone();
        }
        params
    };
    let small = s.ask("zpg/preview", ask(json!({ "width": 20, "height": 16 })));
    assert_eq!(
        (small["width"].as_u64(), small["version"].as_i64()),
        (Some(20), Some(1))
    );
    let picture = s.send("zpg/preview", ask(large.clone()));
    assert!(s.ask("textDocument/hover", place(1, 0)).is_object());
    assert!(
        !s.has_answer(picture),
        "the picture was there before the hover"
    );
    let coarse = s.heard("$/progress");
    assert_eq!(coarse["value"]["width"], 256);
    s.replace(A, 2, "3 9 1\n1 9999 3 0\n");
    let error = s.answer(picture).unwrap_err();
    assert_eq!(error["code"], -32801, "{error}");
    // One object alone, and one that is cancelled by hand.
    let object = s.ask(
        "zpg/preview",
        ask(json!({ "position": at(0, 0), "width": 32, "height": 32 })),
    );
    assert_eq!(object["id"], 3);
    s.replace(A, 3, &slow_scene());
    let picture = s.send("zpg/preview", ask(large));
    s.tell("$/cancelRequest", json!({ "id": picture }));
    assert_eq!(s.answer(picture).unwrap_err()["code"], -32800);
}

/// A hover has a picture where the client shows one, short enough and a PNG.
#[test]
fn hovers_have_pictures_where_they_are_wanted() {
    let mut s = Session::start(rich(), json!({ "pictures": true }));
    s.open(
        A,
        "2 11 0 1 0 1\n2 -399 9 9 3 4\n3 -701 1 0 0\n4 -701 0 1 0\n1 9999 2 0\n",
    );
    let hover = s.ask("textDocument/hover", place(4, 7));
    let text = hover["contents"]["value"].as_str().unwrap();
    let (_, data) = text
        .split_once("](data:image/png;base64,")
        .expect("a picture");
    let (data, size) = data.split_once('|').unwrap();
    assert!(data.len() < 70_000 && size.starts_with("width=192,height=144)"));
    let png = base64::Engine::decode(&base64::engine::general_purpose::STANDARD, data).unwrap();
    let picture = image::load_from_memory(&png).unwrap();
    assert_eq!((picture.width(), picture.height()), (192, 144));
}

/// The program itself: commands, its ends, and what is no message at all.
#[test]
fn commands_make_what_they_say() {
    let folder = tempfile::tempdir().unwrap();
    let uri = format!("file://{}/a.zpg", folder.path().to_str().unwrap());
    let mut s = Session::program(rich());
    s.open(&uri, "2 9 1\n1 9999 2 0\n");
    let run = |s: &mut Session, command: &str, more: Value| {
        let mut arguments = vec![json!(uri)];
        arguments.extend(more.as_array().cloned().unwrap_or_default());
        s.ask(
            "workspace/executeCommand",
            json!({ "command": command, "arguments": arguments }),
        )
    };
    let made = run(&mut s, "zpg.render", json!(["32x24"]));
    assert_eq!(made["uri"], uri.replace("a.zpg", "a.png"));
    let picture = image::open(folder.path().join("a.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (32, 24));
    assert_eq!(s.heard("window/showDocument")["uri"], made["uri"]);
    run(&mut s, "zpg.convert", json!(["pov"]));
    let pov = std::fs::read_to_string(folder.path().join("a.pov")).unwrap();
    assert!(pov.contains("sphere"));
    for target in ["zpg", "../x", "nothing"] {
        let params = json!({ "command": "zpg.convert", "arguments": [uri, target] });
        let error = s.try_ask("workspace/executeCommand", params).unwrap_err();
        assert_eq!(error["code"], -32602, "{target}");
    }
    let plan = run(&mut s, "zpg.plan", Value::Null);
    assert!(plan["text"].as_str().unwrap().starts_with("ambient"));
    let report = run(&mut s, "zpg.accuracy", json!(["2s", "32x24"]));
    assert_eq!(
        report["uri"],
        uri.replace("a.zpg", "a.accuracy/accuracy.html")
    );
    assert!(folder.path().join("a.accuracy/accuracy.html").is_file());
    let explain = json!({ "command": "zpg.explain", "arguments": ["W310"] });
    let page = s.ask("workspace/executeCommand", explain);
    assert!(
        page["text"]
            .as_str()
            .unwrap()
            .starts_with("# unused-definition (W310)")
    );
    // A command that is not waited for ends.
    s.replace(&uri, 2, &slow_scene());
    let arguments = json!([uri, "2000x2000"]);
    let id = s.send(
        "workspace/executeCommand",
        json!({ "command": "zpg.render", "arguments": arguments }),
    );
    std::thread::sleep(Duration::from_millis(100));
    s.tell("$/cancelRequest", json!({ "id": id }));
    assert_eq!(s.answer(id).unwrap_err()["code"], -32800);
    // Its draft of the picture is removed.
    let has_drafts = || {
        let mut names = std::fs::read_dir(folder.path())
            .unwrap()
            .map(|e| e.unwrap().file_name());
        names.any(|name| name.to_string_lossy().starts_with('.'))
    };
    let start = Instant::now();
    while has_drafts() {
        assert!(start.elapsed() < Duration::from_secs(20), "a draft is left");
        std::thread::sleep(Duration::from_millis(20));
    }
    // So it does when the server ends, and so do the pages.
    let arguments = json!([uri, "2000x2000"]);
    s.send(
        "workspace/executeCommand",
        json!({ "command": "zpg.render", "arguments": arguments }),
    );
    let start = Instant::now();
    while !has_drafts() {
        assert!(start.elapsed() < Duration::from_secs(20), "no draft comes");
        std::thread::sleep(Duration::from_millis(20));
    }
    let page = page["uri"].as_str().unwrap().strip_prefix("file://");
    let page = Path::new(page.unwrap());
    assert!(page.is_file());
    assert_eq!(s.end(), Some(0));
    assert!(!page.parent().unwrap().exists());
    let start = Instant::now();
    while has_drafts() {
        assert!(start.elapsed() < Duration::from_secs(20), "a draft is left");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Starts the server, sends it some bytes, and gives what it says and its exit status.
fn spoken_to(bytes: &[u8]) -> (String, Option<i32>) {
    let mut child = crate::support::program::command()
        .args(["lsp", "--stdio"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let _ = input.write_all(bytes);
    drop(input);
    let mut said = String::new();
    child
        .stdout
        .take()
        .unwrap()
        .read_to_string(&mut said)
        .unwrap();
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(20) {
        if let Some(status) = child.try_wait().unwrap() {
            return (said, status.code());
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    panic!("it does not end");
}

#[test]
fn it_ends_with_its_input() {
    let frame = |body: Value| {
        let body = json!({ "jsonrpc": "2.0" })
            .as_object()
            .unwrap()
            .clone()
            .into_iter()
            .chain(body.as_object().unwrap().clone());
        let body = Value::Object(body.collect()).to_string();
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    };
    let start = frame(
        json!({ "id": 1, "method": "initialize", "params": { "processId": null, "rootUri": null, "capabilities": {} } }),
    );
    let initialized = frame(json!({ "method": "initialized", "params": {} }));
    let shutdown = frame(json!({ "id": 2, "method": "shutdown" }));
    let exit = frame(json!({ "method": "exit" }));
    assert_eq!(spoken_to(b""), (String::new(), Some(1)));
    assert_eq!(spoken_to(&[0xff; 5000]).1, Some(1));
    assert_eq!(spoken_to(start.as_bytes()).1, Some(1));
    assert_eq!(
        spoken_to((start.clone() + &initialized + &exit).as_bytes()).1,
        Some(1)
    );
    let nonsense = "Content-Length: 3\r\n\r\n{]}";
    let all = [&start, &initialized, nonsense, &shutdown, &exit]
        .map(String::from)
        .concat();
    let (said, status) = spoken_to(all.as_bytes());
    assert_eq!(status, Some(0));
    assert!(said.contains(r#""id":2"#), "{said}");
    assert!(said.contains(r#""code":-32700"#), "{said}");

    // What comes too early or twice is refused, and the session goes on.
    let early = frame(json!({ "id": 7, "method": "textDocument/hover", "params": {} }));
    let all = [&early, &start, &start, &initialized, &shutdown, &exit].map(String::from);
    let (said, status) = spoken_to(all.concat().as_bytes());
    assert_eq!(status, Some(0));
    let codes: Vec<&str> = (said.split(r#""code":"#).skip(1))
        .map(|rest| &rest[..6])
        .collect();
    assert_eq!(codes, ["-32002", "-32600"], "{said}");
    assert_eq!(said.matches("hoverProvider").count(), 1);

    // Between the answer to `initialize` and `initialized` all goes on as ever.
    let trace = frame(json!({ "method": "$/setTrace", "params": { "value": "off" } }));
    let (said, status) = spoken_to(
        [start.as_str(), &trace, &shutdown, &exit]
            .concat()
            .as_bytes(),
    );
    assert_eq!(
        (said.contains(r#""id":2"#), status),
        (true, Some(0)),
        "{said}"
    );

    // Of what a client says of itself, the server passes over what it cannot read.
    let odd = json!({ "textDocument": { "hover": 7 }, "window": "yes", "new": {} });
    let odd = json!({ "id": 1, "method": "initialize", "params": { "processId": "x", "capabilities": odd } });
    let all = [&frame(odd), &initialized, &shutdown, &exit].map(String::from);
    let (said, status) = spoken_to(all.concat().as_bytes());
    assert_eq!(status, Some(0));
    assert!(said.contains("hoverProvider"), "{said}");
}

/// A file that was never saved, and one whose characters were lost when it was read in another encoding.
#[test]
fn any_text_is_a_scene() {
    let mut s = Session::start(rich(), Value::Null);
    for (uri, comment) in [
        ("untitled:Untitled-1", "příklad"),
        ("file:///a.zpg", "p\u{fffd}\u{fffd}klad"),
    ] {
        s.open(
            uri,
            &format!("\u{feff}2 9 1 # {comment} #\r\n3 9 0,5\r\n1 9999 2 0\r\n"),
        );
        let all = s.diagnostics(1);
        let error = all.iter().find(|d| d["severity"] == 1).unwrap();
        assert_eq!(
            error["range"],
            json!({ "start": at(1, 4), "end": at(1, 7) })
        );
        let params = json!({ "textDocument": { "uri": uri }, "range": error["range"], "context": { "diagnostics": [] } });
        let actions = s.ask("textDocument/codeAction", params);
        let edit = &actions[0]["edit"]["documentChanges"][0];
        assert_eq!(edit["edits"][0]["newText"], "0.5");
        assert_eq!(edit["textDocument"]["version"], 1);
        s.tell(
            "textDocument/didClose",
            json!({ "textDocument": { "uri": uri } }),
        );
        assert_eq!(
            s.heard("textDocument/publishDiagnostics")["diagnostics"],
            json!([])
        );
    }
}

/// The server ends when the process that its client named has ended, though its input is still open.
#[test]
#[cfg(unix)]
fn it_ends_with_its_parent() {
    let mut parent = Command::new("sleep").arg("1000").spawn().unwrap();
    let mut child = crate::support::program::command()
        .arg("lsp")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let start = json!({
        "jsonrpc": "2.0", "id": 1, "method": "initialize",
        "params": { "processId": parent.id(), "rootUri": null, "capabilities": {} },
    });
    let ready = json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} });
    for message in [start.to_string(), ready.to_string()] {
        write!(input, "Content-Length: {}\r\n\r\n{message}", message.len()).unwrap();
    }
    input.flush().unwrap();
    let mut output = child.stdout.take().unwrap();
    output.read_exact(&mut [0; 100]).unwrap();
    std::thread::sleep(Duration::from_millis(100));
    assert!(
        child.try_wait().unwrap().is_none(),
        "it ends before its parent"
    );
    parent.kill().unwrap();
    parent.wait().unwrap();
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        assert!(
            start.elapsed() < Duration::from_secs(20),
            "it outlives its parent"
        );
        std::thread::sleep(Duration::from_millis(20));
    }
    drop(input);
}
