//! Programs of others that the server's commands run: they end with whoever wants them.

use std::path::Path;

use serde_json::{Value, json};

use super::session::{Session, rich};
use crate::support::endless::Endless;
use crate::support::program;

/// A session that takes an endless program for POV-Ray, and has it running. Gives the request, too.
fn started(folder: &Path, endless: &Endless) -> (Session, i32) {
    let mut command = program::command();
    let path = std::env::var("PATH").unwrap_or_default();
    let own = folder.to_str().unwrap();
    command.env("PATH", format!("{own}:{path}"));
    let mut s = Session::started(command, rich());
    let uri = format!("file://{own}/a.zpg");
    s.open(&uri, "2 9 1\n1 9999 2 0\n");
    let params = json!({ "command": "zpg.crosscheck", "arguments": [uri] });
    let id = s.send("workspace/executeCommand", params);
    endless.wait_for_start();
    (s, id)
}

#[test]
fn they_end_with_the_request() {
    let folder = tempfile::tempdir().unwrap();
    let endless = Endless::new(folder.path(), "povray");
    let (mut s, id) = started(folder.path(), &endless);
    s.tell("$/cancelRequest", json!({ "id": id }));
    assert_eq!(s.answer(id).unwrap_err()["code"], -32800);
    endless.wait_for_end();
    s.end();
}

#[test]
fn they_end_with_the_session() {
    for is_asked in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        let endless = Endless::new(folder.path(), "povray");
        let (mut s, _) = started(folder.path(), &endless);
        if is_asked {
            assert_eq!(s.end(), Some(0));
        } else {
            s.tell("exit", Value::Null);
            s.child.take().unwrap().wait().unwrap();
        }
        endless.wait_for_end();
    }
}
