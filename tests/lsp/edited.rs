//! Edits at random places: what the server says afterwards is what one says that opens the text as it is then.

use serde_json::{Value, json};

use super::session::{Session, rich};
use super::{A, SCENE};
use crate::rng::Rng;

const PIECES: [&str; 16] = [
    "",
    " ",
    "\n",
    "\r\n",
    "#",
    "0",
    "-",
    "0,5",
    "1e9",
    "7 11 ",
    "# ž😀 #",
    "3 -701 0.9 0.2 0.1\n",
    "4 -101 2 3\n",
    "1 9999 4 0\n",
    "# zpg: allow W310 #",
    "2 -399 1 1 5 6\n",
];

fn scenes() -> Vec<String> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let read =
        |name: &str| std::fs::read_to_string(root.join("scenes/gallery").join(name)).unwrap();
    vec![
        String::new(),
        SCENE.replace("parts", "části 😀"),
        read("pawns.zpg").replace('\n', "\r\n"),
        read("chain.zpg"),
    ]
}

/// A place of a text in UTF-8, and its position.
fn position(text: &str, at: usize) -> Value {
    let mut line = 0;
    let mut start = 0;
    let bytes = text.as_bytes();
    for i in 0..at {
        let is_break = match bytes[i] {
            b'\n' => true,
            b'\r' => bytes.get(i + 1) != Some(&b'\n'),
            _ => false,
        };
        if is_break {
            (line, start) = (line + 1, i + 1);
        }
    }
    json!({ "line": line, "character": at - start })
}

/// The place itself, or the one before it that is not within a character or a line break.
fn between(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) || text[..at].ends_with('\r') && text[at..].starts_with('\n') {
        at -= 1;
    }
    at
}

/// All that is said about the text as a whole.
fn said(s: &mut Session, version: i32) -> Vec<Value> {
    let file = json!({ "textDocument": { "uri": A } });
    let everything =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99999, "character": 0 } });
    let hints = json!({ "textDocument": { "uri": A }, "range": everything });
    let style =
        json!({ "textDocument": { "uri": A }, "options": { "tabSize": 2, "insertSpaces": true } });
    vec![
        s.diagnostics(version).into(),
        s.ask("textDocument/inlayHint", hints),
        s.ask("textDocument/semanticTokens/full", file.clone())["data"].clone(),
        s.ask("textDocument/documentSymbol", file.clone()),
        s.ask("textDocument/foldingRange", file.clone()),
        s.ask("textDocument/documentColor", file.clone()),
        s.ask("textDocument/codeLens", file),
        s.ask("textDocument/formatting", style),
    ]
}

#[test]
fn an_edited_file_is_as_one_that_is_opened() {
    let mut capabilities = rich();
    capabilities["general"]["positionEncodings"] = json!(["utf-8"]);
    let start = || Session::start(capabilities.clone(), Value::Null);
    let mut random = Rng::new(11);
    for scene in scenes() {
        let mut text = scene;
        let mut s = start();
        s.open(A, &text);
        let mut version = 1;
        for _ in 0..4 {
            for _ in 0..25 {
                let from = between(&text, random.below(text.len() + 1));
                let longest = if random.chance(0.3) { 20 } else { 1 };
                let to = (from + random.below(longest)).min(text.len());
                let to = between(&text, to).max(from);
                let new = *random.pick(&PIECES);
                let range = json!({ "start": position(&text, from), "end": position(&text, to) });
                version += 1;
                s.tell(
                    "textDocument/didChange",
                    json!({
                        "textDocument": { "uri": A, "version": version },
                        "contentChanges": [{ "range": range, "text": new }],
                    }),
                );
                text.replace_range(from..to, new);
            }
            let mut fresh = start();
            fresh.open(A, &text);
            assert_eq!(said(&mut s, version), said(&mut fresh, 1), "{text:?}");
        }
    }
}

/// An edit at a place that cannot be read is none, and so are those that are sent with it.
#[test]
fn what_cannot_be_read_changes_nothing() {
    let mut s = Session::start(rich(), Value::Null);
    let place = |line: Value, character: Value| json!({ "line": line, "character": character });
    let good = || place(json!(0), json!(1));
    let mut ranges = vec![
        json!({ "start": good() }),
        json!({ "end": good() }),
        json!({}),
    ];
    ranges.extend([json!([]), json!(7), json!("0:1"), json!(true)]);
    for odd in [
        json!(-1),
        json!(0.5),
        json!(1u64 << 32),
        json!("1"),
        json!(null),
        json!([]),
    ] {
        for at in [place(odd.clone(), json!(1)), place(json!(0), odd)] {
            ranges.push(json!({ "start": at, "end": good() }));
            ranges.push(json!({ "start": good(), "end": at }));
        }
    }
    let mut changes: Vec<Value> = (ranges.into_iter())
        .map(|range| json!({ "range": range, "text": "7" }))
        .collect();
    let start = json!({ "start": good(), "end": good() });
    changes.extend([
        json!({ "range": start, "text": 7 }),
        json!({ "range": start }),
        json!({}),
        json!(null),
        json!([]),
    ]);
    s.open(A, SCENE);
    let before = said(&mut s, 1);
    let fine = json!({ "range": start, "text": " # new #" });
    let mut version = 1;
    for change in changes {
        for all in [json!([change]), json!([fine, change])] {
            version += 1;
            s.tell(
                "textDocument/didChange",
                json!({ "textDocument": { "uri": A, "version": version }, "contentChanges": all }),
            );
            let told = s.heard("window/logMessage");
            let message = told["message"].as_str().unwrap();
            assert!(
                message.starts_with("textDocument/didChange cannot be read"),
                "{message}"
            );
            assert_eq!(message.lines().count(), 1, "{message}");
            let tokens = s.ask(
                "textDocument/semanticTokens/full",
                json!({ "textDocument": { "uri": A } }),
            );
            assert_eq!(tokens["data"], before[2], "{all}");
        }
    }
    // Without a range, all of it is new, also with what is said of a range that is none.
    for (range, length) in [(json!(null), json!(-1)), (start, json!("x"))] {
        version += 1;
        let change = json!({ "range": range, "rangeLength": length, "text": SCENE });
        s.tell(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": A, "version": version }, "contentChanges": [change] }),
        );
        s.diagnostics(version);
    }
}
