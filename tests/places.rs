//! What cannot be written is known before anything is read or computed.

use std::fs;

/// All commands that write what they compute: the scene is not there, and it is the place to write to that is complained of.
#[test]
fn places_are_tried_first() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    fs::write(at("file"), "").unwrap();
    fs::create_dir(at("folder")).unwrap();
    for args in [
        &["convert", "none.zpg", "--to", "pov", "-o", "nowhere/a.pov"][..],
        &["convert", "none.zpg", "--to", "glb", "-o", "folder"],
        &[
            "convert",
            "none.zpg",
            "--to",
            "json",
            "--report",
            "nowhere/a.json",
        ],
        &["crosscheck", "none.zpg", "--with", "povray", "-o", "file"],
        &[
            "crosscheck",
            "none.zpg",
            "--with",
            "mitsuba",
            "-o",
            "file/a/b",
        ],
        &["accuracy", "none.zpg", "-o", "file/a"],
        &["accuracy", "--shapes", "-o", "file/a"],
        &["check", "none.zpg", "--output-file", "folder"],
        &["check", "none.zpg", "--output-file", "file/a/b.txt"],
    ] {
        let run = crate::support::program::command()
            .args(args)
            .current_dir(dir.path())
            .output()
            .unwrap();
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{args:?}: {said}");
        assert!(
            said.contains("cannot write") && !said.contains("none.zpg"),
            "{args:?}: {said}"
        );
    }
    // Nothing is left of a place that was tried, where the work then fails.
    for args in [
        &["convert", "none.zpg", "--to", "pov", "-o", "a.pov"][..],
        &[
            "crosscheck",
            "none.zpg",
            "--with",
            "povray",
            "-o",
            "new/folder",
        ],
        &["accuracy", "none.zpg", "-o", "new/folder"],
    ] {
        let mut command = crate::support::program::command();
        let run = command.args(args).current_dir(dir.path()).output().unwrap();
        let said = String::from_utf8(run.stderr).unwrap();
        assert!(said.contains("cannot read none.zpg"), "{said}");
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 2);
}
