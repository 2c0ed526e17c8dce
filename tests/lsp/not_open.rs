//! Files that are not open: editors ask about those that they have just closed, renamed or deleted.

use std::path::Path;

use serde_json::{Value, json};

use super::session::{Session, rich};
use super::{A, SCENE, every_request};

fn uri(path: &Path) -> String {
    format!("file://{}", path.to_str().unwrap())
}

/// Parameters for the file `A`, for another one.
fn about(uri: &str, params: &Value) -> Value {
    serde_json::from_str(&params.to_string().replace(A, uri)).unwrap()
}

/// An answer without what says which state of the file it is for.
fn timeless(mut answer: Value) -> Value {
    match &mut answer {
        Value::Array(all) => all.iter_mut().for_each(|v| *v = timeless(v.take())),
        Value::Object(fields) => {
            fields.retain(|name, _| name != "version" && name != "resultId");
            fields.values_mut().for_each(|v| *v = timeless(v.take()));
        }
        _ => {}
    }
    answer
}

/// Every request, and those that other answers lead to.
fn all_requests(s: &mut Session, open: &str) -> Vec<(&'static str, Value)> {
    let mut all = every_request();
    all.retain(|(method, _)| *method != "workspace/symbol");
    let is_prepare = |(method, _): &&(&str, Value)| *method == "textDocument/prepareCallHierarchy";
    let prepare = all.iter().find(is_prepare).unwrap();
    let ball = s.ask(prepare.0, about(open, &prepare.1))[0].clone();
    let ball: Value = serde_json::from_str(&ball.to_string().replace(open, A)).unwrap();
    all.push(("callHierarchy/incomingCalls", json!({ "item": ball })));
    all.push(("callHierarchy/outgoingCalls", json!({ "item": ball })));
    let action = json!({ "title": "t", "kind": "source.fixAll.zpg", "data": { "uri": A } });
    all.push(("codeAction/resolve", action));
    all.push((
        "textDocument/diagnostic",
        json!({ "textDocument": { "uri": A } }),
    ));
    all
}

/// What is on disk is answered as if it were open; about what is nowhere there is nothing to say.
#[test]
fn every_request_is_answered() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.zpg");
    std::fs::write(&path, SCENE).unwrap();
    let own = uri(&path);
    let mut pulls = rich();
    pulls["textDocument"]["diagnostic"] = json!({});
    let mut s = Session::start(pulls, Value::Null);
    s.open(&own, SCENE);
    let requests = all_requests(&mut s, &own);
    let open: Vec<Value> = (requests.iter())
        .map(|(method, params)| s.ask(method, about(&own, params)))
        .collect();
    let file = json!({ "textDocument": { "uri": own } });
    s.tell("textDocument/didClose", file);
    for ((method, params), open) in requests.iter().zip(open) {
        let closed = s.ask(method, about(&own, params));
        // The tokens that were sent last are forgotten with the file.
        if !method.ends_with("/delta") {
            assert_eq!(timeless(closed), timeless(open), "{method}");
        }
    }
    std::fs::remove_file(&path).unwrap();
    let gone = ["untitled:Untitled-1", "file:///", &uri(folder.path()), &own];
    for (uri, (method, params)) in gone
        .iter()
        .flat_map(|uri| requests.iter().map(move |r| (uri, r)))
    {
        let answer = s.ask(method, about(uri, params));
        let said = match *method {
            "textDocument/diagnostic" => &answer["items"],
            "codeAction/resolve" => &answer["edit"]["documentChanges"][0]["edits"],
            m if m.contains("semanticTokens") => &answer["data"],
            _ => &answer,
        };
        let is_empty = said.is_null() || said.as_array().is_some_and(Vec::is_empty);
        assert!(is_empty, "{method} about {uri}: {answer}");
    }
}

/// A client that has forgotten what its last report of a file was called, as Visual Studio Code's does when a tab is
/// closed, loses the findings of a file that is renamed or deleted all the same.
#[test]
fn findings_of_what_is_gone_go_away() {
    let folder = tempfile::tempdir().unwrap();
    let [old, new] = ["old.zpg", "new (1).zpg"].map(|name| folder.path().join(name));
    std::fs::write(&old, SCENE).unwrap();
    let mut pulls = rich();
    pulls["textDocument"]["diagnostic"] = json!({});
    let mut s = Session::start(pulls, Value::Null);
    s.open(&uri(&old), SCENE);
    let file = json!({ "textDocument": { "uri": uri(&old) } });
    let found = s.ask("textDocument/diagnostic", file.clone());
    assert_eq!(found["items"][0]["code"], "E003");
    let report_of = |s: &mut Session, path: &Path| {
        let all = s.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
        let mut all = all["items"].as_array().unwrap().clone();
        all.retain(|r| r["uri"] == uri(path));
        assert!(all.len() < 2, "{all:?}");
        all.pop()
    };
    std::fs::rename(&old, &new).unwrap();
    s.tell("textDocument/didClose", file);
    s.open(&uri(&new), SCENE);
    for _ in 0..3 {
        assert_eq!(report_of(&mut s, &old).unwrap()["items"], json!([]));
        assert_eq!(report_of(&mut s, &new).unwrap()["items"][0]["code"], "E003");
    }
    // It is there again.
    s.open(&uri(&old), SCENE);
    assert_eq!(report_of(&mut s, &old).unwrap()["items"][0]["code"], "E003");
}

/// What commands say of a scene with errors is one line, for every one of them and in both languages.
#[test]
fn commands_refuse_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let own = uri(&folder.path().join("a.zpg"));
    let commands = [
        json!(["zpg.render"]),
        json!(["zpg.convert", "pov"]),
        json!(["zpg.plan"]),
        json!(["zpg.crosscheck"]),
        json!(["zpg.accuracy"]),
    ];
    for (lang, one, two, none) in [
        (
            "en",
            "an error, in line 2: `0,5`",
            "2 errors, the first in line 2",
            "not there",
        ),
        (
            "cs",
            "chyba na řádku 2: `0,5`",
            "2 chyby, první na řádku 2",
            "neexistuje",
        ),
    ] {
        let mut s = Session::start(rich(), json!({ "lang": lang }));
        let refused = |s: &mut Session, words: &str| {
            for command in &commands {
                let mut arguments = vec![json!(own)];
                arguments.extend(command.as_array().unwrap()[1..].iter().cloned());
                let params = json!({ "command": command[0], "arguments": arguments });
                let error = s.try_ask("workspace/executeCommand", params).unwrap_err();
                let message = error["message"].as_str().unwrap();
                assert!(message.contains(words), "{command}: {message}");
                assert_eq!(message.lines().count(), 1, "{command}: {message}");
                assert_eq!(error["code"], -32803);
            }
        };
        refused(&mut s, none);
        s.open(&own, "# scene #\n2 9 0,5\n1 9999 2 0\n");
        refused(&mut s, one);
        s.replace(&own, 2, "\n2 9 0,5\n3 9 0,5\n4 -101 2 3\n1 9999 4 0\n");
        refused(&mut s, two);
    }
}

/// What the program itself says, with a frame around it, becomes one line, too.
#[test]
fn a_failure_of_the_program_is_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let own = uri(&folder.path().join("a.zpg"));
    let mut s = Session::program(rich());
    s.open(&own, "2 9 1\n");
    let params = json!({ "command": "zpg.render", "arguments": [own] });
    let error = s.try_ask("workspace/executeCommand", params).unwrap_err();
    assert_eq!(
        error["message"],
        "zpg did not succeed: there is no render record"
    );
}

/// What there is not is said in words.
#[test]
fn unknown_commands_and_targets_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let own = uri(&folder.path().join("a.zpg"));
    let mut s = Session::start(rich(), json!({ "lang": "en" }));
    s.open(&own, "2 9 1\n1 9999 2 0\n");
    for (command, arguments, says) in [
        ("zpg.nope", json!([own]), "zpg has no command zpg.nope"),
        ("zpg.nope", json!([]), "zpg has no command zpg.nope"),
        (
            "zpg.convert",
            json!([own, "xyz"]),
            "zpg does not convert a scene to xyz here",
        ),
    ] {
        let params = json!({ "command": command, "arguments": arguments });
        let error = s.try_ask("workspace/executeCommand", params).unwrap_err();
        assert_eq!(
            (&error["message"], &error["code"]),
            (&json!(says), &json!(-32602))
        );
    }
}
