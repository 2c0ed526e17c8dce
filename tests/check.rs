//! `zpg check` from outside: fixes, levels, languages, and what goes where.

use std::fs;
use std::path::Path;
use std::thread;
use std::time::Duration;

use crate::support::program::{folder, text, zpg, zpg_with};

/// A decimal comma (a safe fix), a torus that runs through itself and energy gain (guesses).
const SCENE: &str = "2 9 0,5\n3 14 1 3\n35 -201 0.7 0.7 0.7\n4 -101 2 3\n4 -299 0 35\n\
                     9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 4 0\n";

/// The codes and severities that `--format short` prints.
fn short(folder: &Path, args: &[&str]) -> (Vec<String>, Option<i32>) {
    let run = zpg(folder, &[&["check", "--format", "short"], args].concat());
    let words = |line: &str| {
        line.split(' ')
            .skip(1)
            .take(2)
            .collect::<Vec<_>>()
            .join(" ")
    };
    let found = text(&run.stdout).lines().map(words).collect();
    (found, run.status.code())
}

#[test]
fn fixes_are_written_and_the_rest_is_reported() {
    let dir = folder(&[("a.zpg", SCENE), ("b.zpg", "1 9999 2 0\n")]);
    let run = zpg(dir.path(), &["check", "--fix", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let out = text(&run.stdout);
    assert!(out.contains("W302") && out.contains("W320") && !out.contains("E003"));
    assert!(out.ends_with(
        "Fixed 1 finding in 1 file.\nFound 2 warnings in 1 file; \
         2 can be fixed with `zpg check --fix --unsafe-fixes`.\n"
    ));
    let fixed = SCENE.replace("0,5", "0.5");
    assert_eq!(fs::read_to_string(dir.path().join("a.zpg")).unwrap(), fixed);
    // Guesses on demand only; what has nothing to mend is not touched.
    let run = zpg(dir.path(), &["check", "--fix", "--unsafe-fixes", "."]);
    let out = text(&run.stdout);
    assert!(out.contains("a.zpg:2: `1 3` → `3 1`\n"), "{out}");
    assert!(
        out.contains("a.zpg:3: `0.7 0.7 0.7` → `0.333 0.333 0.333`\n"),
        "{out}"
    );
    let all = (fixed.replace("14 1 3", "14 3 1")).replace("0.7 0.7 0.7", "0.333 0.333 0.333");
    assert_eq!(fs::read_to_string(dir.path().join("a.zpg")).unwrap(), all);
    assert_eq!(
        fs::read_to_string(dir.path().join("b.zpg")).unwrap(),
        "1 9999 2 0\n"
    );
}

/// What guesses have changed is listed with lines of the file as it is now, however many rounds they took: the second
/// record that was made of one moves the lines below it.
#[test]
fn changes_are_listed_by_lines_of_the_file() {
    let scene = "50 -402 1 4 6 5\n2 9 0,5\n3 14 1 3\n4 -101 2 3\n1 9999 4 0\n";
    let dir = folder(&[("a.zpg", scene)]);
    let run = zpg(dir.path(), &["check", "--fix", "--unsafe-fixes", "a.zpg"]);
    let out = text(&run.stdout);
    let now = fs::read_to_string(dir.path().join("a.zpg")).unwrap();
    let listed: Vec<&str> = out
        .lines()
        .filter_map(|l| l.strip_prefix("  a.zpg:"))
        .collect();
    assert_eq!(
        listed,
        [
            "1: `4 6 5` → nothing",
            "2: nothing → `50 -1 4 6 5`",
            "3: `0,5` → `0.5`",
            "4: `1 3` → `3 1`"
        ],
        "{now}"
    );
    for change in listed {
        let (line, new) = (
            change.split(':').next().unwrap(),
            change.split(" → ").nth(1).unwrap(),
        );
        let line = now.lines().nth(line.parse::<usize>().unwrap() - 1).unwrap();
        assert!(
            new == "nothing" || line.contains(new.trim_matches('`')),
            "{change}: {line}"
        );
    }
}

#[test]
fn a_difference_changes_nothing() {
    let dir = folder(&[("a.zpg", SCENE)]);
    let run = zpg(dir.path(), &["check", "--diff", "a.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    let out = text(&run.stdout);
    assert!(out.starts_with("--- a.zpg\n+++ a.zpg\n"));
    assert!(out.contains("\n-2 9 0,5\n+2 9 0.5\n") || out.contains("@@\n-2 9 0,5\n+2 9 0.5\n"));
    assert_eq!(
        text(&run.stderr),
        "Would fix 1 finding in 1 file.\n`--diff --unsafe-fixes` shows 2 guesses more.\n"
    );
    assert_eq!(fs::read_to_string(dir.path().join("a.zpg")).unwrap(), SCENE);
    let clean = folder(&[("a.zpg", &SCENE.replace("0,5", "0.5"))]);
    let run = zpg(clean.path(), &["check", "--diff", "a.zpg"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
}

#[test]
fn a_difference_without_safe_fixes_says_so() {
    let rest = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n1 9999 2 0\n";
    // Alpha may go; that an object stands beside itself has no fix.
    for (lines, guess, english, czech) in [
        (
            "21 -701 0.9 0.2 0.1 1\n2 11 0 1 0 1\n2 -299 21 0\n",
            true,
            "No safe fixes available; `zpg check` shows 1 finding, and `--diff --unsafe-fixes` 1 guess.",
            "Bezpečně tu nelze opravit nic; `zpg check` ukáže 1 nález a `--diff --unsafe-fixes` 1 odhad.",
        ),
        (
            "3 11 0 1 0 1\n2 -101 3 3\n",
            false,
            "No safe fixes available; `zpg check` shows 1 finding.",
            "Bezpečně tu nelze opravit nic; `zpg check` ukáže 1 nález.",
        ),
    ] {
        let dir = folder(&[("a.zpg", &format!("{lines}{rest}"))]);
        let said = |args: &[&str]| {
            let run = zpg(dir.path(), args);
            let words = text(&run.stderr);
            (
                text(&run.stdout),
                words.split_whitespace().collect::<Vec<_>>().join(" "),
            )
        };
        let nothing = |said: &str| (String::new(), said.to_owned());
        assert_eq!(said(&["check", "--diff", "a.zpg"]), nothing(english));
        let in_czech = said(&["--lang", "cs", "check", "--diff", "a.zpg"]);
        assert_eq!(in_czech, nothing(czech));
        assert_eq!(said(&["check", "--diff", "-q", "a.zpg"]), nothing(""));
        let (diff, _) = said(&["check", "--diff", "--unsafe-fixes", "a.zpg"]);
        assert_eq!(!diff.is_empty(), guess);
    }
}

#[test]
fn standard_input_is_mended_to_standard_output() {
    let dir = folder(&[("zpg.toml", "[lint]\nW302 = \"off\"\n")]);
    let args = ["check", "--fix", "--stdin-filename", "in/scene.zpg", "-"];
    let run = zpg_with(dir.path(), &args, SCENE);
    assert_eq!(text(&run.stdout), SCENE.replace("0,5", "0.5"));
    let findings = text(&run.stderr);
    assert!(findings.contains("in/scene.zpg:2:") && !findings.contains("W302"));
    assert_eq!(run.status.code(), Some(0));
    let run = zpg_with(
        dir.path(),
        &["check", "--fix", "--format", "json", "-"],
        SCENE,
    );
    assert_eq!(text(&run.stdout), SCENE.replace("0,5", "0.5"));
    let report: serde_json::Value = serde_json::from_slice(&run.stderr).unwrap();
    assert_eq!(report["files"][0]["diagnostics"][0]["code"], "W320");
}

#[test]
fn a_file_that_cannot_be_written_is_said() {
    let dir = folder(&[("a.zpg", SCENE)]);
    let path = dir.path().join("a.zpg");
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let run = zpg(dir.path(), &["check", "--fix", "a.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    assert!(text(&run.stderr).contains("cannot write a.zpg: it is read-only"));
}

#[test]
fn the_command_line_chooses() {
    let dir = folder(&[("a.zpg", SCENE)]);
    let at = |args: &[&str]| short(dir.path(), &[args, &["a.zpg"]].concat());
    let (all, status) = at(&[]);
    assert_eq!(all, ["E003 error:", "W320 warning:", "W302 warning:"]);
    assert_eq!(status, Some(1));
    assert_eq!(
        at(&["--select", "W302"]).0,
        ["E003 error:", "W302 warning:"]
    );
    assert_eq!(at(&["--ignore", "W3"]).0, ["E003 error:"]);
    assert_eq!(
        at(&["--ignore", "W302,self-intersecting"]).0,
        ["E003 error:"]
    );
    let denied = ["E003 error:", "W320 error:", "W302 error:"];
    assert_eq!(at(&["--deny", "warnings"]).0, denied);
    for wrong in [["--ignore", "E003"], ["--select", "W999"], ["--deny", ""]] {
        let (found, status) = at(&wrong);
        assert_eq!((found.len(), status), (0, Some(2)), "{wrong:?}");
    }
    // A denied warning alone is a reason to fail.
    fs::write(dir.path().join("a.zpg"), SCENE.replace("0,5", "0.5")).unwrap();
    assert_eq!(at(&[]).1, Some(0));
    assert_eq!(at(&["--deny", "energy-gain"]).1, Some(1));
}

#[test]
fn settings_of_a_folder() {
    let dir = folder(&[
        ("a.zpg", SCENE),
        ("zpg.toml", "[lint]\nW3 = \"note\"\nW320 = \"off\"\n"),
    ]);
    assert_eq!(
        short(dir.path(), &["a.zpg"]).0,
        ["E003 error:", "W302 note:"]
    );
    let selected = short(dir.path(), &["--select", "W320", "a.zpg"]).0;
    assert_eq!(selected, ["E003 error:", "W320 warning:"]);
    fs::write(dir.path().join("zpg.toml"), "[lint]\nW399 = \"off\"\n").unwrap();
    let run = zpg(dir.path(), &["check", "a.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    let message = text(&run.stderr);
    assert!(
        message.contains("zpg.toml:2:1: there is no code `W399`"),
        "{message}"
    );
    // What is an error by settings does not keep a sound scene from being drawn.
    fs::write(dir.path().join("zpg.toml"), "[lint]\nW3 = \"error\"\n").unwrap();
    fs::write(dir.path().join("a.zpg"), SCENE.replace("0,5", "0.5")).unwrap();
    assert_eq!(short(dir.path(), &["a.zpg"]).1, Some(1));
    let run = zpg(dir.path(), &["render", "a.zpg", "--size", "4x3"]);
    assert_eq!(run.status.code(), Some(0));
}

#[test]
fn statistics_count() {
    let dir = folder(&[("a.zpg", SCENE), ("b.zpg", SCENE)]);
    let run = zpg(dir.path(), &["check", "--statistics", "."]);
    assert_eq!(
        text(&run.stdout),
        "2  E003  malformed-number  [--fix]\n2  W302  energy-gain\n2  W320  self-intersecting\n"
    );
    assert_eq!(run.status.code(), Some(1));
}

#[test]
fn statistics_for_programs() {
    let dir = folder(&[("a.zpg", SCENE), ("b.zpg", SCENE)]);
    let ask = |format: &str| {
        let args = ["check", "--statistics", "--format", format, "./a.zpg", "."];
        zpg(dir.path(), &args)
    };
    let run = ask("json");
    let out: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let first = &out["statistics"][0];
    assert_eq!(first["code"], "E003");
    assert_eq!(first["name"], "malformed-number");
    // Each file once.
    assert_eq!((&first["count"], &first["fixable"]), (&2.into(), &2.into()));
    assert_eq!(out["statistics"][1]["fixable"], 0);
    assert_eq!(out["summary"]["files"], 2);
    let refused = ask("sarif");
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("--format human or json"));
}

#[test]
fn messages_in_czech() {
    let dir = folder(&[("a.zpg", "2 9 -1\n1 9999 2 0\n")]);
    let run = zpg(dir.path(), &["check", "--lang", "cs", "a.zpg"]);
    let out = text(&run.stdout);
    assert!(
        out.starts_with(
            "chyba[E201]: koule se středem v počátku: poloměr musí být větší než nula\n"
        )
    );
    let run = zpg(
        dir.path(),
        &["check", "--lang", "cs", "--format", "json", "a.zpg"],
    );
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let first = &json["files"][0]["diagnostics"][0];
    assert_eq!(first["severity"], "error");
    assert_eq!(first["labels"].as_array().unwrap().len(), 0);
    let run = zpg(dir.path(), &["render", "--lang", "cs", "a.zpg"]);
    assert!(text(&run.stderr).contains("Nalezeno: 1 chyba"));
}

#[test]
fn complaints_in_czech() {
    let dir = folder(&[
        ("a.zpg", SCENE),
        ("b/a.zpg", SCENE),
        ("b/zpg.toml", "[lint]\nW30 = \"off\"\nE101 = \"off\"\n"),
    ]);
    for (args, complaint) in [
        (
            &["check", "c.zpg"][..],
            "c.zpg nelze přečíst: soubor nebo složka neexistuje",
        ),
        (
            &["check", "--ignore", "E101", "a.zpg"],
            "E101 je vždy chyba a nelze ji vynechat",
        ),
        (&["check", "b"], "b/zpg.toml:3:1: E101 je vždy chyba"),
        (
            &["check", "--watch", "-"],
            "standardní vstup nelze sledovat",
        ),
        (
            &["explain", "W999"],
            "žádný nález ani typ záznamu se nejmenuje `W999`",
        ),
    ] {
        let run = zpg(dir.path(), &[args, &["--lang", "cs"]].concat());
        let said = text(&run.stderr);
        assert!(
            said.starts_with("chyba: ") && said.contains(complaint),
            "{said}"
        );
        assert_eq!(run.status.code(), Some(2));
    }
}

#[test]
fn what_cannot_be_translated_in_both_languages() {
    let dir = folder(&[("a.zpg", "2 9 1\n1 9999 2 0\n")]);
    let args = ["convert", "a.zpg", "--to", "ply", "--tolerance", "1e-12"];
    for (language, expected) in [
        ("en", "choose a larger --tolerance"),
        ("cs", "zvolte větší --tolerance"),
    ] {
        let run = zpg(dir.path(), &[&["--lang", language], &args[..]].concat());
        let said = text(&run.stderr);
        assert!(said.contains(expected), "{said}");
        assert_eq!(run.status.code(), Some(1));
        assert!(run.stdout.is_empty());
    }
}

#[test]
fn wrong_usage_in_both_languages() {
    let dir = folder(&[("a.zpg", SCENE)]);
    for (args, english, czech) in [
        (
            &["check", "--fixx", "a.zpg"][..],
            "error: unexpected argument `--fixx`; did you mean `--fix`?\n\nUsage: zpg check",
            "chyba: neočekávaný argument `--fixx`; měli jste na mysli `--fix`?\n\nPoužití: zpg check",
        ),
        (
            &["chek", "a.zpg"],
            "error: there is no command `chek`; did you mean `check`?",
            "chyba: příkaz `chek` neexistuje; měli jste na mysli `check`?",
        ),
        (
            &["check", "a.zpg", "--format", "xml"],
            "error: `xml` is not a value of `--format <FORMAT>`: there are human, short, json,",
            "chyba: `xml` není hodnota pro `--format <FORMÁT>`: možnosti jsou human, short, json,",
        ),
        (
            &["check", "a.zpg", "--select", "W399"],
            "error: `W399` is not a value of `--select <CODE>`: there is no code `W399`; did you mean",
            "chyba: `W399` není hodnota pro `--select <KÓD>`: kód `W399` neexistuje; měli jste na mysli",
        ),
        (
            &["render", "a.zpg", "--size", "9"],
            "`--size <WxH>`: expected WxH, as in 640x480",
            "`--size <ŠxV>`: očekává se ŠxV, například 640x480",
        ),
        (
            &["render", "a.zpg", "--samples", "0"],
            "expected a whole number from 1 to 1048576",
            "očekává se celé číslo od 1 do 1048576",
        ),
        (
            &["render", "a.zpg", "--adaptive", "0.1", "--samples", "2"],
            "`--adaptive <TOL>` cannot be used with `--samples <N>`",
            "`--adaptive <MEZ>` nelze uvést spolu s `--samples <N>`",
        ),
        (
            &["probe", "a.zpg", "--ray", "0 0 x 0 0 1"],
            "`x` is not a number",
            "`x` není číslo",
        ),
        (
            &["plan", "a.zpg", "b.zpg"],
            "error: unexpected argument `b.zpg`\n",
            "chyba: neočekávaný argument `b.zpg`\n",
        ),
        (
            &["check", "--fix=1", "a.zpg"],
            "error: `--fix` takes no value, but `1` is given",
            "chyba: `--fix` se píše bez hodnoty, ale uvedena je `1`",
        ),
        (
            &[],
            "zpg: tools for scenes in the ZPG scene language\n\n  zpg new scene.zpg ",
            "zpg: nástroje pro scény v jazyce ZPG\n\n  zpg new scena.zpg ",
        ),
        (
            &["render"],
            "error: missing: <PATH>...",
            "chyba: chybí: <CESTA>...",
        ),
        (
            &["explain", "--color"],
            "`--color <WHEN>` needs a value: there are auto, always, never",
            "`--color <KDY>` potřebuje hodnotu: možnosti jsou auto, always, never",
        ),
    ] {
        for (language, expected) in [("en", english), ("cs", czech)] {
            let run = zpg(dir.path(), &[&["--lang", language], args].concat());
            let said = text(&run.stderr);
            assert!(said.contains(expected), "{args:?}: {said}");
            assert_eq!(run.status.code(), Some(2));
            assert!(run.stdout.is_empty());
        }
    }
    // Help is no complaint.
    for args in [&["--help"][..], &["check", "--help"], &["--version"]] {
        let run = zpg(dir.path(), args);
        assert_eq!(run.status.code(), Some(0));
        assert!(run.stderr.is_empty() && !run.stdout.is_empty());
    }
}

#[test]
fn watching_checks_again() {
    let dir = folder(&[("a.zpg", SCENE)]);
    let arguments = ["check", "--watch", "--format", "short", "a.zpg"];
    let (mut child, [mut findings, mut errors]) =
        crate::support::program::started(dir.path(), &arguments);
    let ready = "Watching for changes; Ctrl-C ends it";
    assert_eq!(errors.next().unwrap().unwrap(), ready);
    let mut three = || {
        (0..3)
            .map(|_| findings.next().unwrap().unwrap())
            .collect::<Vec<_>>()
    };
    assert!(three()[0].contains("E003"));
    let changed = SCENE.replace("0,5", "x");
    fs::write(dir.path().join("a.zpg"), changed).unwrap();
    assert_eq!(errors.next().unwrap().unwrap(), ready);
    assert!(three()[0].contains("E012"));
    // It ends when nobody reads any more.
    drop(findings);
    while child.try_wait().unwrap().is_none() {
        fs::write(dir.path().join("a.zpg"), SCENE).unwrap();
        thread::sleep(Duration::from_millis(300));
    }
    let run = zpg(dir.path(), &["check", "--watch", "-"]);
    assert_eq!(run.status.code(), Some(2));
}
