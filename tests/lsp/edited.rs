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
