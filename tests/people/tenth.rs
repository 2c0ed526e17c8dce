//! What two newcomers stumbled over, and what was meant.

use serde_json::Value;

use crate::support::program::{folder, text, zpg_with};

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

/// A scene with a code, for which there is a guess.
const GUESSES: &[(&str, &str)] = &[
    ("W301", "2 9 1\n2 -701 255 0 51\n"),
    ("W302", "2 9 1\n2 -201 0.5 0.9 0\n"),
    ("W308", "3 9 1\n4 11 1 0 0 1\n3 -701 1 0 0\n2 -102 3 4\n"),
    ("W310", "2 9 1\n3 11 2 0 0 1\n4 -101 2 3\n"),
    ("W320", "2 14 0.3 1\n"),
    (
        "W321",
        "4 12 -1 -1 -1 1 1 1\n3 12 -.5 0 -.5 .5 1 .5\n2 -103 4 3\n",
    ),
    ("W323", "2 9 1\n"),
    ("W324", "2 9 1\n"),
    ("W327", "2 9 1\n2 -1 0 0 0\n"),
    ("N607", "2 12 -1 -1 -1 1 1 1\n2 -2 0.79 2\n"),
    ("E106", "2 9 1\n"),
];

/// What `zpg check` promises of guesses for warnings and notes is what `--fix --unsafe-fixes` does.
#[test]
fn what_is_promised_of_guesses_is_done() {
    let dir = folder::<&str>(&[]);
    for (code, scene) in GUESSES {
        let rest = match *code {
            "W323" => REST.replace(" 45", " 0.785"),
            "W324" => REST.replace("0 0 -1", "0 0 1"),
            "E106" => REST.replace("1 9999 2 0\n", ""),
            _ => REST.to_owned(),
        };
        let scene = format!("{scene}{rest}");
        let run = |arguments: &[&str]| zpg_with(dir.path(), arguments, &scene);
        let json = run(&["check", "--format", "json", "-"]);
        let json: Value = serde_json::from_slice(&json.stdout).unwrap();
        let all = json["files"][0]["diagnostics"].as_array().unwrap();
        let finding = all.iter().find(|d| d["code"] == *code).expect(&scene);
        let said = text(&run(&["check", "-"]).stdout);
        let fixed = text(&run(&["check", "--fix", "--unsafe-fixes", "-"]).stdout);
        assert_ne!(finding["fixes"][0]["applicability"], "choice", "{said}");
        assert!(said.contains("--unsafe-fixes`."), "{said}");
        assert!(!said.contains("takes no guess"), "{said}");
        assert_ne!(fixed, scene);
    }
}
