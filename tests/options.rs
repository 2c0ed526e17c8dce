//! What users of ruff look for: which files are checked, by which settings, and what is said of it.

use std::fs;
use std::path::Path;

use crate::support::program::{self, folder, text, zpg};

const GOOD: &str = "2 11 0 0 0 1\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -401 1\n1 9999 2 0\n";
/// A warning and a remark on style: a colour out of range, two records on a line.
const WARNED: &str =
    "2 11 0 0 0 1 2 -701 2 0 0\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -401 1\n1 9999 2 0\n";
const BAD: &str = "2 11 0 0 0 -1\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -401 1\n1 9999 2 0\n";

/// `a.zpg W301`, a line for each finding.
fn found(dir: &Path, args: &[&str]) -> (Vec<String>, Option<i32>) {
    let run = zpg(dir, &[&["check", "--format", "short"], args].concat());
    let out = text(&run.stdout);
    let line = |line: &str| {
        let mut parts = line.split(": ");
        let path = parts.next().unwrap().split(':').next().unwrap();
        let code = parts.next().unwrap().split(' ').next().unwrap();
        format!("{path} {code}")
    };
    (out.lines().map(line).collect(), run.status.code())
}

#[track_caller]
fn refused(dir: &Path, args: &[&str], says: &str) {
    let run = zpg(dir, args);
    let said = text(&run.stderr);
    assert_eq!(run.status.code(), Some(2), "{args:?}: {said}");
    assert!(said.contains(says), "{args:?}: {said}");
    assert_eq!(said.matches("error: ").count(), 1, "{said}");
    assert_eq!(text(&run.stdout), "");
}

#[test]
fn no_path_is_this_folder() {
    let dir = folder(&[("a.zpg", BAD), ("sub/b.zpg", WARNED), ("c.txt", "")]);
    let expected = ["a.zpg E201", "sub/b.zpg S503", "sub/b.zpg W301"];
    assert_eq!(found(dir.path(), &[]).0, expected);
    let run = zpg(dir.path(), &["fmt", "--check"]);
    assert_eq!(run.status.code(), Some(1));
    let out = text(&run.stdout);
    assert!(out.contains("would reformat: sub/b.zpg\n"), "{out}");
    let run = zpg(dir.path(), &["fmt"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    assert_eq!(zpg(dir.path(), &["fmt", "--check"]).status.code(), Some(0));
    let empty = tempfile::tempdir().unwrap();
    let run = zpg(empty.path(), &["check"]);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(text(&run.stderr), "warning: no scene files (*.zpg) in .\n");
}

#[test]
fn quiet_is_findings_and_nothing_else() {
    let dir = folder(&[("a.zpg", BAD), ("b.zpg", GOOD), ("c.zpg", WARNED)]);
    let run = zpg(dir.path(), &["check", "--quiet", "b.zpg"]);
    assert_eq!(
        (text(&run.stdout), text(&run.stderr)),
        (String::new(), String::new())
    );
    let loud = text(&zpg(dir.path(), &["check", "a.zpg"]).stdout);
    let run = zpg(dir.path(), &["check", "-q", "a.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    let quiet = text(&run.stdout);
    assert_eq!(loud, format!("{quiet}Found 1 error in 1 file.\n"));
    // No summary of what was mended, laid out or drawn; no warning about an empty folder.
    let run = zpg(dir.path(), &["fmt", "-q", "c.zpg"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
    fs::write(
        dir.path().join("d.zpg"),
        GOOD.replace("0 0 0 1", "0 0 0 0,5"),
    )
    .unwrap();
    let run = zpg(dir.path(), &["check", "-q", "--fix", "d.zpg"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
    let run = zpg(dir.path(), &["render", "-q", "b.zpg", "--size", "4x3"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
    fs::create_dir(dir.path().join("empty")).unwrap();
    let run = zpg(dir.path(), &["check", "-q", "empty"]);
    assert_eq!(
        (run.status.code(), text(&run.stderr)),
        (Some(0), String::new())
    );
    // Errors are said all the same.
    refused(
        dir.path(),
        &["check", "-q", "none.zpg"],
        "cannot read none.zpg",
    );
}

#[test]
fn exit_zero_is_about_findings() {
    let dir = folder(&[
        ("a.zpg", BAD),
        ("b.zpg", &GOOD.replace("0 0 0 1", "0 0 0 0,5")),
    ]);
    assert_eq!(found(dir.path(), &["a.zpg"]).1, Some(1));
    assert_eq!(
        found(dir.path(), &["--exit-zero", "a.zpg"]),
        (vec!["a.zpg E201".to_owned()], Some(0))
    );
    let diff = ["check", "--diff", "b.zpg"];
    assert_eq!(zpg(dir.path(), &diff).status.code(), Some(1));
    let diff = [&diff[..], &["--exit-zero"]].concat();
    assert_eq!(zpg(dir.path(), &diff).status.code(), Some(0));
    refused(
        dir.path(),
        &["check", "--exit-zero", "none.zpg"],
        "cannot read none.zpg",
    );
}

#[test]
fn findings_go_to_a_file() {
    let dir = folder(&[("a.zpg", BAD), ("b.zpg", &BAD.replace("-1\n9", "0,5\n9"))]);
    let read = |name: &str| fs::read_to_string(dir.path().join(name)).unwrap();
    for format in [
        "human", "short", "json", "sarif", "github", "gitlab", "junit",
    ] {
        let plain = text(&zpg(dir.path(), &["check", "--format", format, "a.zpg"]).stdout);
        let args = [
            "check",
            "--format",
            format,
            "a.zpg",
            "--output-file",
            "new/out",
        ];
        let run = zpg(dir.path(), &args);
        assert_eq!(run.status.code(), Some(1));
        assert_eq!(
            (text(&run.stdout), text(&run.stderr)),
            (String::new(), String::new())
        );
        assert_eq!(read("new/out"), plain);
    }
    let run = zpg(dir.path(), &["check", "--statistics", "-o", "out", "a.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(read("out").starts_with("1  E201"));
    // A scene that is mended on its way goes on to standard output.
    let scene = read("b.zpg");
    let run = program::zpg_with(dir.path(), &["check", "--fix", "-o", "out", "-"], &scene);
    assert_eq!(text(&run.stdout), scene.replace("0,5", "0.5"));
    assert_eq!(text(&run.stderr), "");
    assert!(
        read("out").starts_with("Fixed 1 finding in 1 file."),
        "{}",
        read("out")
    );
    refused(
        dir.path(),
        &["check", "-o", "a.zpg/out", "a.zpg"],
        "cannot write a.zpg/out",
    );
}

#[test]
fn files_that_are_left_out() {
    let dir = folder(&[
        ("zpg.toml", "exclude = [\"old\", \"sub/x-*.zpg\"]\n"),
        ("a.zpg", BAD),
        ("old/b.zpg", BAD),
        ("sub/old/b.zpg", BAD),
        ("sub/x-1.zpg", BAD),
        ("sub/y.zpg", BAD),
        ("x-2.zpg", BAD),
        ("own/zpg.toml", "exclude = [\"c.zpg\"]\n"),
        ("own/c.zpg", BAD),
        ("own/old/d.zpg", BAD),
    ]);
    let files = |at: &str, args: &[&str]| -> Vec<String> {
        let all = found(&dir.path().join(at), args).0.into_iter();
        all.map(|line| line.replace(" E201", "")).collect()
    };
    // The nearest zpg.toml counts, as for all settings.
    let expected = ["a.zpg", "own/old/d.zpg", "sub/y.zpg", "x-2.zpg"];
    assert_eq!(files(".", &[]), expected);
    // Patterns are of the folder of the file that they stand in, not of where the command runs.
    assert_eq!(files("sub", &[]), ["y.zpg"]);
    assert_eq!(files(".", &["sub"]), ["sub/y.zpg"]);
    // What is named is checked, unless it is forced.
    assert_eq!(files(".", &["old/b.zpg"]), ["old/b.zpg"]);
    assert_eq!(files(".", &["old"]), ["old/b.zpg"]);
    assert_eq!(
        files(".", &["--force-exclude", "old", "old/b.zpg", "a.zpg"]),
        ["a.zpg"]
    );
    let run = zpg(dir.path(), &["fmt", "--check"]);
    let out = text(&run.stdout);
    assert!(!out.contains("old/b.zpg") && !out.contains("x-1"), "{out}");
    // Standard input goes by its name.
    let stdin = ["--stdin-filename", "old/b.zpg", "-"];
    let fmt = |more: &[&str]| {
        let args = [&["fmt"], more, &stdin].concat();
        text(&program::zpg_with(dir.path(), &args, "2   9 1\n").stdout)
    };
    assert_eq!(
        (fmt(&[]), fmt(&["--force-exclude"])),
        ("2 9 1\n".into(), "2   9 1\n".into())
    );
    for (changes, passed) in [
        (&["--fix"][..], "2   9 0,5\n"),
        (&["--add-allow"], "2   9 0,5\n"),
        (&["--fix", "--diff"], ""),
    ] {
        let args = [&["check", "--force-exclude"], changes, &stdin].concat();
        let run = program::zpg_with(dir.path(), &args, "2   9 0,5\n");
        assert_eq!(
            (text(&run.stdout), run.status.code()),
            (passed.into(), Some(0))
        );
    }
    // Others count in their place.
    let all = [
        "a.zpg",
        "old/b.zpg",
        "own/c.zpg",
        "own/old/d.zpg",
        "sub/old/b.zpg",
    ];
    assert_eq!(files(".", &["--isolated"])[..5], all);
    let chosen = ["--config", "exclude=[\"own\", \"sub\"]"];
    assert_eq!(files(".", &chosen), ["a.zpg", "old/b.zpg", "x-2.zpg"]);
}

#[test]
fn codes_that_files_may_have() {
    let dir = folder(&[
        (
            "zpg.toml",
            "[lint.per-file-ignores]\n\"old/*\" = [\"W3\"]\n\"a.zpg\" = [\"several-records-per-line\"]\n",
        ),
        ("a.zpg", WARNED),
        ("old/b.zpg", WARNED),
        ("sub/old/b.zpg", WARNED),
    ]);
    let expected = [
        "a.zpg W301",
        "old/b.zpg S503",
        "sub/old/b.zpg S503",
        "sub/old/b.zpg W301",
    ];
    assert_eq!(found(dir.path(), &[]).0, expected);
    // No choice brings them back.
    let chosen = ["--select", "W301", "--deny", "W301", "old/b.zpg"];
    assert_eq!(found(dir.path(), &chosen), (Vec::new(), Some(0)));
    // The name is that of standard input, too.
    let args = [
        "check",
        "--format",
        "short",
        "--stdin-filename",
        "old/b.zpg",
        "-",
    ];
    let run = program::zpg_with(dir.path(), &args, WARNED);
    assert!(!text(&run.stdout).contains("W301"));
    let chosen = ["--config", "lint.per-file-ignores={\"!a.zpg\" = [\"all\"]}"];
    let refusal = [&["check"], &chosen[..]].concat();
    assert_eq!(zpg(dir.path(), &refusal).status.code(), Some(0));
    assert_eq!(found(dir.path(), &chosen).0, ["a.zpg S503", "a.zpg W301"]);
}

#[test]
fn settings_with_a_point_before_their_name_are_told_of() {
    let dir = folder(&[(".zpg.toml", "[lint]\nW301 = \"off\"\n"), ("a.zpg", GOOD)]);
    let said = |args: &[&str]| text(&zpg(dir.path(), args).stderr);
    let note = "note: .zpg.toml is ignored: a settings file must be named zpg.toml\n";
    assert_eq!(said(&["check"]), note);
    assert_eq!(said(&["check", "--isolated"]), "");
    assert_eq!(said(&["check", "--quiet", "a.zpg"]), "");
    fs::write(dir.path().join("zpg.toml"), "").unwrap();
    assert_eq!(said(&["check"]), "");
}

/// Settings for zpg in the file of Python's tools; those of other tools are none of zpg's business.
#[test]
fn settings_in_pyproject_are_told_of() {
    let dir = folder(&[
        ("pyproject.toml", "[tool.zpg.lint]\nW301 = \"off\"\n"),
        ("a.zpg", GOOD),
    ]);
    let said = || text(&zpg(dir.path(), &["check"]).stderr);
    let note = "note: pyproject.toml is ignored: a settings file must be named zpg.toml\n";
    assert_eq!(said(), note);
    fs::write(dir.path().join("pyproject.toml"), "[tool.zpgx]\n").unwrap();
    assert_eq!(said(), "");
    fs::write(dir.path().join("pyproject.toml"), "[tool.zpg]\n").unwrap();
    assert_eq!(said(), note);
    fs::write(dir.path().join("zpg.toml"), "").unwrap();
    assert_eq!(said(), "");
}

#[test]
fn settings_of_a_file_that_is_named() {
    let dir = folder(&[
        ("zpg.toml", "[lint]\nW301 = \"off\"\n"),
        (
            "other.toml",
            "exclude = [\"sub/b.zpg\"]\n[lint]\nS503 = \"off\"\n",
        ),
        (
            "elsewhere/third.toml",
            "exclude = [\"sub\"]\n[format]\nalign = false\n",
        ),
        ("a.zpg", WARNED),
        ("sub/b.zpg", WARNED),
        ("sub/zpg.toml", "[lint]\nS503 = \"error\"\n"),
    ]);
    assert_eq!(
        found(dir.path(), &[]).0,
        ["a.zpg S503", "sub/b.zpg S503", "sub/b.zpg W301"]
    );
    assert_eq!(
        found(dir.path(), &["--config", "other.toml"]).0,
        ["a.zpg W301"]
    );
    // Patterns of such a file are about the folder where the command runs.
    assert_eq!(
        found(dir.path(), &["--config", "elsewhere/third.toml"]).0,
        ["a.zpg S503", "a.zpg W301"]
    );
    // A single setting counts more than any file.
    let both = ["--config", "lint.W3=\"off\"", "--config", "other.toml"];
    assert_eq!(found(dir.path(), &both).0, Vec::<String>::new());
    let error = ["--config", "lint.W301=\"error\"", "a.zpg"];
    assert_eq!(found(dir.path(), &error).1, Some(1));
    assert_eq!(
        found(dir.path(), &["--isolated", "a.zpg"]).0,
        ["a.zpg S503", "a.zpg W301"]
    );
    let isolated = ["--isolated", "--config", "lint.S503=\"off\"", "a.zpg"];
    assert_eq!(found(dir.path(), &isolated).0, ["a.zpg W301"]);
    let plain = ["fmt", "--config", "format.group=false", "--diff", "a.zpg"];
    let aligned = zpg(dir.path(), &["fmt", "--diff", "a.zpg"]);
    assert_ne!(zpg(dir.path(), &plain).stdout, aligned.stdout);
}

#[test]
fn settings_that_are_wrong() {
    let dir = folder(&[
        ("a.zpg", GOOD),
        ("b.zpg", GOOD),
        ("zpg.toml", "[lint]\nW399 = \"off\"\n"),
        ("o.toml", "[format]\nwidht = 80\n"),
        ("two.toml", "[lint]\nstyl = \"off\"\n[format]\nalign = 1\n"),
    ]);
    // All that is wrong, each with its place, and scenes say nothing.
    let run = zpg(dir.path(), &["check", "--config", "two.toml", "a.zpg"]);
    assert_eq!(
        text(&run.stderr),
        "error: two.toml:2:1: there is no code `styl`; did you mean `style`?\n\
         error: two.toml:4:9: `format.align`: expected true or false, found `1`\n"
    );
    // The file is named once, for however many scenes.
    refused(
        dir.path(),
        &["check"],
        "zpg.toml:2:1: there is no code `W399`; did you mean `W309`?",
    );
    refused(dir.path(), &["fmt"], "zpg.toml:2:1: there is no code");
    let with = |config: &'static str| ["check", "--config", config, "a.zpg"];
    refused(
        dir.path(),
        &with("o.toml"),
        "o.toml:2:1: there is no setting `format.widht`",
    );
    refused(dir.path(), &with("o.toml"), "did you mean `width`?");
    refused(dir.path(), &with("none.toml"), "there is no file none.toml");
    refused(dir.path(), &with("lint.W310=of"), "did you mean `off`?");
    refused(dir.path(), &with("excluded=[]"), "did you mean `exclude`?");
    refused(
        dir.path(),
        &with("exclude=\"a\""),
        "`exclude`: expected a list of file patterns",
    );
    let isolated = ["check", "--isolated", "--config", "o.toml", "a.zpg"];
    refused(
        dir.path(),
        &isolated,
        "--config o.toml cannot be used with --isolated",
    );
    let two = ["check", "--config", "o.toml", "--config", "zpg.toml"];
    refused(dir.path(), &two, "two settings files, o.toml and zpg.toml");
    let czech = ["check", "--lang", "cs", "--config", "format.width=5"];
    let said = text(&zpg(dir.path(), &czech).stderr);
    assert!(said.contains("očekává se celé číslo"), "{said}");
    // Where files of settings do not count, neither do their mistakes; what draws does without them.
    assert_eq!(
        zpg(dir.path(), &["check", "--isolated"]).status.code(),
        Some(0)
    );
    assert_eq!(zpg(dir.path(), &["plan", "a.zpg"]).status.code(), Some(0));
}

#[test]
fn files_and_settings_are_shown() {
    let dir = folder(&[
        (
            "zpg.toml",
            "exclude = [\"old\"]\n[lint]\nW3 = \"note\"\n[lint.per-file-ignores]\n\"a.zpg\" = [\"W301\"]\n",
        ),
        ("a.zpg", BAD),
        ("b/c.zpg", "no scene"),
        ("old/d.zpg", GOOD),
    ]);
    let here = dir.path().canonicalize().unwrap();
    let run = zpg(&here, &["check", "--show-files"]);
    assert_eq!(
        (run.status.code(), text(&run.stderr)),
        (Some(0), String::new())
    );
    let path = |name: &str| here.join(name).to_string_lossy().into_owned();
    assert_eq!(
        text(&run.stdout),
        format!("{}\n{}\n", path("a.zpg"), path("b/c.zpg"))
    );
    let run = zpg(
        &here,
        &["check", "--show-settings", "--deny", "S501", "a.zpg"],
    );
    assert_eq!(run.status.code(), Some(0));
    let shown = text(&run.stdout);
    let head = format!(
        "# {}\n# zpg.toml: {}\nexclude = [\"old\"]\n",
        path("a.zpg"),
        path("zpg.toml")
    );
    assert!(shown.starts_with(&head), "{shown}");
    for line in [
        "W301 = \"off\"  # colour-out-of-range",
        "W302 = \"note\"  # energy-gain",
        "S501 = \"error\"  # notation-separator",
        "# S502 = \"style\"  # bare-comment",
        "\"a.zpg\" = [\"W301\"]",
        "width = 100",
    ] {
        assert!(shown.lines().any(|l| l == line), "{line}: {shown}");
    }
    // What is shown could stand in a zpg.toml.
    fs::write(here.join("shown.toml"), &shown).unwrap();
    let again = zpg(
        &here,
        &[
            "check",
            "--config",
            "shown.toml",
            "--show-settings",
            "a.zpg",
        ],
    );
    let settings = |text: String| text.lines().skip(2).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(settings(text(&again.stdout)), settings(shown));
    refused(
        &here,
        &["check", "--show-settings", "old", "--force-exclude"],
        "no scene file",
    );
    let bare = zpg(&here, &["check", "--isolated", "--show-settings", "a.zpg"]);
    assert!(text(&bare.stdout).contains("\n# zpg.toml: -\nexclude = []\n"));
    let run = zpg(&here, &["check", "--show-files", "-o", "list"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
    assert!(
        fs::read_to_string(here.join("list"))
            .unwrap()
            .ends_with("c.zpg\n")
    );
}

#[test]
fn pictures_are_said_to_be_written() {
    let dir = folder(&[("a.zpg", GOOD)]);
    let render = |args: &[&str]| {
        zpg(
            dir.path(),
            &[&["render", "a.zpg", "--size", "8x6"], args].concat(),
        )
    };
    let run = render(&[]);
    assert_eq!(text(&run.stdout), "Wrote a.png: 8 × 6 pixels\n");
    assert_eq!(text(&run.stderr), "");
    assert_eq!(
        text(&render(&["-o", "b.exr"]).stdout),
        "Wrote b.exr: 8 × 6 pixels\n"
    );
    let cropped = render(&["--crop", "1,1,2,3", "--lang", "cs"]);
    assert_eq!(text(&cropped.stdout), "Zapsáno: a.png, 2 × 3 pixelů\n");
    render(&[]);
    let file = fs::read(dir.path().join("a.png")).unwrap();
    let run = render(&["-o", "-"]);
    assert_eq!(
        (run.status.code(), text(&run.stderr)),
        (Some(0), String::new())
    );
    assert!(run.stdout == file, "the picture itself");
    assert!(!dir.path().join("-").exists() && !dir.path().join("-.png").exists());
    // What is said besides goes to standard error.
    let run = render(&["-o", "-", "--cost"]);
    assert!(
        run.stdout == file && text(&run.stderr).contains("rays"),
        "{}",
        text(&run.stderr)
    );
}

#[test]
fn cameras_that_are_not_there() {
    let two = "8 -501 0 0 9 0 0 -1 0 1 0 45\n10 -501 1 0 9 0 0 -1 0 1 0 45\n";
    let stereo = format!("2 11 0 0 0 1\n{two}60 -503 8 10\n50 -401 1\n1 9999 2 0\n");
    let dir = folder(&[
        ("a.zpg", GOOD),
        ("s.zpg", &stereo),
        ("n.zpg", "2 9 1\n1 9999 2 0\n"),
    ]);
    let render = |scene: &'static str| ["render", scene, "--size", "4x3", "--camera", "12"];
    refused(
        dir.path(),
        &render("s.zpg"),
        "no camera 12; its cameras: 8, 10\n",
    );
    refused(
        dir.path(),
        &render("n.zpg"),
        "no camera 12: it has no cameras at all\n",
    );
    let probe = ["probe", "s.zpg", "--pixel", "0,0", "--camera", "12"];
    refused(dir.path(), &probe, "no camera 12; its cameras: 8, 10\n");
    for how in ["pair", "side-by-side", "anaglyph"] {
        refused(
            dir.path(),
            &["render", "a.zpg", "--stereo", how],
            "--stereo needs two cameras",
        );
        let one = ["render", "s.zpg", "--stereo", how, "--camera", "8"];
        refused(dir.path(), &one, "--stereo needs two cameras");
    }
    refused(
        dir.path(),
        &["render", "s.zpg", "-o", "-"],
        "choose --stereo side-by-side",
    );
    let run = zpg(dir.path(), &["render", "s.zpg", "--size", "4x3"]);
    let wrote = "Wrote s_left.png: 4 × 3 pixels\nWrote s_right.png: 4 × 3 pixels\n";
    assert_eq!(text(&run.stdout), wrote);
    let args = [
        "render",
        "s.zpg",
        "--size",
        "4x3",
        "--stereo",
        "side-by-side",
    ];
    assert_eq!(
        text(&zpg(dir.path(), &args).stdout),
        "Wrote s.png: 8 × 3 pixels\n"
    );
}

#[test]
fn reports_say_what_is_not_exact() {
    let scene = GOOD.replace("50 -401 1\n", "50 -402 1\n50 -1 3 5 5\n");
    let dir = folder(&[("a.zpg", &scene)]);
    let report = |args: &[&str]| {
        let args = [&["convert", "a.zpg", "--to", "ply"], args].concat();
        text(&zpg(dir.path(), &args).stderr)
    };
    let all = report(&["--verbose"]);
    let exact = all.lines().filter(|l| l.starts_with("exact")).count();
    assert!(exact > 1, "{all}");
    let is_rest = |l: &&str| !l.starts_with("exact") && !l.starts_with("Wrote");
    let rest: Vec<&str> = all.lines().filter(is_rest).collect();
    assert!(rest.iter().any(|l| l.starts_with("dropped")), "{all}");
    let brief = report(&[]);
    let mut lines: Vec<&str> = brief.lines().collect();
    let count = format!("exact        {exact} features (--verbose names them)");
    assert_eq!(lines.pop(), Some("Wrote a.ply"));
    assert_eq!(lines.pop(), Some(&*count));
    assert_eq!(lines, rest);
    assert_eq!(report(&["-q"]), "");
}

#[test]
fn commands_that_are_not_check_say_errors_only() {
    let dir = folder(&[("a.zpg", WARNED), ("b.zpg", BAD), ("n.zpg", "2 9 1\n")]);
    for args in [
        &["render", "a.zpg", "--size", "4x3"][..],
        &["plan", "a.zpg"],
        &["probe", "a.zpg", "--pixel", "1,1"],
        &["convert", "a.zpg", "--to", "json"],
    ] {
        let run = zpg(dir.path(), args);
        assert_eq!(run.status.code(), Some(0));
        let said = text(&run.stderr);
        assert!(
            !said.contains("W301") && !said.contains("S503"),
            "{args:?}: {said}"
        );
        // A warning does not stop it, nor do settings that make an error of it.
        fs::write(dir.path().join("zpg.toml"), "[lint]\nW301 = \"error\"\n").unwrap();
        assert_eq!(zpg(dir.path(), args).status.code(), Some(0));
    }
    let run = zpg(dir.path(), &["plan", "b.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(text(&run.stderr).starts_with("error[E201]"));
    let run = zpg(dir.path(), &["plan", "n.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(text(&run.stderr).starts_with("error[E106]"));
}

/// A suggestion is a name that may have been meant.
#[test]
fn suggestions_are_near() {
    let dir = folder(&[("a.zpg", GOOD)]);
    for (args, near) in [
        (&["chek"][..], Some("check")),
        (&["render", "--camra=3", "a.zpg"], Some("--camera")),
        (&["check", "--stat", "a.zpg"], Some("--statistics")),
        (&["convert", "--to", "mitsub", "a.zpg"], Some("mitsuba")),
        (&["render", "--gamma=2", "a.zpg"], None),
        (&["check", "--fix-onlyest", "a.zpg"], Some("--fix")),
        (&["explain", "W999"], None),
    ] {
        let run = zpg(dir.path(), args);
        let said = text(&run.stderr);
        let meant = near.map(|near| format!("did you mean `{near}`?"));
        assert_eq!(said.contains("did you mean"), near.is_some(), "{said}");
        assert!(meant.is_none_or(|meant| said.contains(&meant)), "{said}");
        // Nor does the usage name what cannot be meant.
        assert!(
            near.is_some() || !said.contains("Usage: zpg render --camera"),
            "{said}"
        );
        assert_eq!(run.status.code(), Some(2));
    }
    // Two are quoted apart.
    let said = zpg(dir.path(), &["explain", "hyperbolic"]);
    let said = text(&said.stderr);
    assert!(said.contains("` or `") && !said.contains(", "), "{said}");
}

#[test]
fn names_that_ruff_has() {
    let dir = folder(&[("a.zpg", BAD)]);
    for (theirs, ours) in [
        (
            &["format", "--check", "a.zpg"][..],
            &["fmt", "--check", "a.zpg"][..],
        ),
        (&["rule", "E201"], &["explain", "E201"]),
        (
            &["check", "--output-format", "short", "a.zpg"],
            &["check", "--format", "short", "a.zpg"],
        ),
        (&["check", "-w", "-"], &["check", "--watch", "-"]),
    ] {
        let [theirs, ours] = [theirs, ours].map(|args| zpg(dir.path(), args));
        assert_eq!(theirs, ours);
    }
}

/// What `--help` gives as a default can be written on the command line.
#[test]
fn defaults_in_help_are_accepted() {
    let dir = folder(&[("a.zpg", GOOD)]);
    let mut tried = 0;
    for command in [
        "check",
        "fmt",
        "render",
        "convert",
        "crosscheck",
        "accuracy",
    ] {
        let help = text(&zpg(dir.path(), &[command, "--help"]).stdout).to_owned();
        let mut option = "";
        for line in help.lines().map(str::trim) {
            let long = line.split_whitespace().find(|w| w.starts_with("--"));
            option = long.filter(|_| line.starts_with('-')).unwrap_or(option);
            let Some((_, value)) = line.split_once("[default: ") else {
                continue;
            };
            let value = value.trim_end_matches(']');
            // Some are described.
            if value.contains(' ') {
                continue;
            }
            let given = format!("{option}={value}");
            let run = zpg(dir.path(), &[command, "missing.zpg", &given]);
            let said = text(&run.stderr);
            assert!(
                !said.contains("is not a value"),
                "{command} {given}: {said}"
            );
            tried += 1;
        }
    }
    assert!(tried > 12, "{tried}");
    for (cutoff, is_right) in [
        ("1/4096", true),
        ("0", true),
        ("2/1", false),
        ("1/0", false),
        ("1/", false),
    ] {
        let given = ["render", "missing.zpg", "--cutoff", cutoff];
        let said = text(&zpg(dir.path(), &given).stderr).to_owned();
        assert_eq!(said.contains("from 0 to 1"), !is_right, "{cutoff}: {said}");
    }
}

/// Words that are none of zpg's are answered with those that are: a command with a letter missing, a scene without a
/// command, a side in other words.
#[test]
fn what_is_meant_is_proposed() {
    let dir = folder(&[("a.zpg", "2 9 1\n3 11 0 0 0 1\n40 -101 2 3\n1 9999 40 0\n")]);
    for (arguments, proposed) in [
        (&["help", "rendr"][..], "did you mean `render`?"),
        (&["rendr"], "did you mean `render`?"),
        (
            &["a.zpg"],
            "did you mean `zpg check a.zpg` or `zpg render a.zpg`?",
        ),
        (&["none.json"], "did you mean `zpg check none.json` or "),
        (
            &["render", "a.zpg", "--view", "shora"],
            "did you mean `top`?",
        ),
        (
            &["render", "a.zpg", "--view", "Zezadu"],
            "did you mean `back`?",
        ),
        (
            &["probe", "a.zpg", "--point", "0 0 0", "--object", "99"],
            "its objects: 2, 3, 40\n",
        ),
        (
            &["probe", "a.zpg", "--point", "0 0 0", "--object", "41"],
            "did you mean 40?",
        ),
        (&["explain", "203"], "did you mean `-203`?"),
    ] {
        let run = zpg(dir.path(), arguments);
        let said = text(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(proposed), "{arguments:?}: {said}");
    }
    // Nothing is proposed for what is far from all.
    let said = text(&zpg(dir.path(), &["quite-something"]).stderr).to_owned();
    assert!(!said.contains("did you mean"), "{said}");
    let said =
        text(&zpg(dir.path(), &["render", "a.zpg", "--view", "elsewhere"]).stderr).to_owned();
    assert!(!said.contains("did you mean"), "{said}");
}

/// A width behind `-w`, as other programs have it, is none, and nothing is watched.
#[test]
fn a_width_behind_watch() {
    let dir = folder(&[("a.zpg", GOOD)]);
    for size in ["64", "64x48"] {
        refused(dir.path(), &["render", "a.zpg", "-w", size], "--size 64x48");
        let run = zpg(dir.path(), &["--lang", "cs", "render", "a.zpg", "-w", size]);
        assert_eq!(run.status.code(), Some(2));
        assert!(text(&run.stderr).contains("velikost"));
    }
}
