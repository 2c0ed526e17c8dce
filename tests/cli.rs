//! The command line from outside: what is printed where, and the exit status.

use std::fs;
use std::process::Stdio;

use crate::support::program::{folder, text, zpg, zpg_with};

const GOOD: &str =
    "2 11 0 0 0 1\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

#[test]
fn a_good_scene_is_clean() {
    let dir = folder(&[("a.zpg", GOOD.as_bytes())]);
    let run = zpg(dir.path(), &["check", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(text(&run.stdout), "All checks passed!\n");
    assert_eq!(text(&run.stderr), "");
}

/// What a run that is killed has begun to write is removed by the next one.
#[test]
fn a_killed_run_leaves_nothing_for_long() {
    let dir = folder(&[("a.zpg", GOOD.as_bytes())]);
    let names = || {
        let entries = fs::read_dir(dir.path()).unwrap();
        let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    };
    let mut long = crate::support::program::command()
        .args(["render", "a.zpg", "--size", "9000x9000", "--samples", "64"])
        .current_dir(dir.path())
        .spawn()
        .unwrap();
    while names().len() == 1 {
        assert!(long.try_wait().unwrap().is_none(), "it has ended");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(names()[0].ends_with(".draft"), "{:?}", names());
    // What another run is still at is left alone.
    let run = zpg(
        dir.path(),
        &["render", "a.zpg", "-o", "b.png", "--size", "8x6"],
    );
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(names().len(), 3);
    long.kill().unwrap();
    long.wait().unwrap();
    assert_eq!(names().len(), 3);
    let run = zpg(dir.path(), &["render", "a.zpg", "--size", "8x6"]);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(names(), ["a.png", "a.zpg", "b.png"]);
}

#[test]
fn json_is_written_even_when_nothing_is_found() {
    let dir = folder(&[("a.zpg", GOOD.as_bytes())]);
    let run = zpg(dir.path(), &["check", "--format", "json", "."]);
    assert_eq!(run.status.code(), Some(0));
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["version"], 1);
    assert_eq!(json["files"][0]["diagnostics"], serde_json::json!([]));
    assert_eq!(
        json["summary"],
        serde_json::json!({"files": 1, "errors": 0, "warnings": 0, "notes": 0, "style": 0})
    );
}

#[test]
fn an_unreadable_file_does_not_stop_the_others() {
    let dir = folder(&[("b.zpg", b"# \xf8 #")]);
    let run = zpg(
        dir.path(),
        &["check", "--format", "short", "a.zpg", "b.zpg"],
    );
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(
        text(&run.stderr),
        "error: cannot read a.zpg: No such file or directory\n"
    );
    assert!(text(&run.stdout).contains("b.zpg:1:3: N601 note: "));
    // What was not read has passed no check.
    fs::write(dir.path().join("good.zpg"), GOOD).unwrap();
    for (lang, said) in [
        (
            "en",
            "Nothing was found in 1 file; what could not be read was not checked.\n",
        ),
        (
            "cs",
            "V 1 souboru se nic nenašlo; co nešlo přečíst, se nezkontrolovalo.\n",
        ),
    ] {
        let args = ["check", "--lang", lang, "a.zpg", "good.zpg"];
        let run = zpg(dir.path(), &args);
        assert_eq!(
            (run.status.code(), text(&run.stdout)),
            (Some(2), said.to_owned())
        );
    }
}

#[test]
fn a_scene_without_its_ending_is_named() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.zpg"), "2 9 1\n1 9999 2 0\n").unwrap();
    for (args, expected) in [
        (
            ["check", "a"],
            "error: cannot read a: there is no such file, but a.zpg\n",
        ),
        (
            ["render", "a"],
            "error: cannot read a: there is no such file, but a.zpg\n",
        ),
        (
            ["check", "b"],
            "error: cannot read b: No such file or directory\n",
        ),
    ] {
        let out = zpg(folder.path(), &args);
        assert_eq!(String::from_utf8(out.stderr).unwrap(), expected);
        assert_eq!(out.status.code(), Some(2));
    }
}

/// Names of formats that ruff has are understood.
#[test]
fn formats_have_other_names() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.zpg"), "2 9\n").unwrap();
    for (theirs, ours) in [("concise", "short"), ("full", "human")] {
        let [a, b] = [["--output-format", theirs], ["--format", ours]]
            .map(|[flag, name]| zpg(folder.path(), &["check", flag, name, "a.zpg"]).stdout);
        assert!(!a.is_empty());
        assert_eq!(a, b);
    }
}

#[test]
fn standard_input_is_a_dash() {
    let dir = tempfile::tempdir().unwrap();
    let run = zpg_with(
        dir.path(),
        &["check", "--format=json", "-"],
        GOOD.as_bytes(),
    );
    assert_eq!(run.status.code(), Some(0));
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["files"][0]["path"], "-");
}

#[test]
fn colour_is_a_choice() {
    let dir = folder(&[("b.zpg", b"# \xf8 #")]);
    let coloured = |args: &[&str]| text(&zpg(dir.path(), args).stdout).contains('\u{1b}');
    assert!(!coloured(&["check", "b.zpg"]));
    assert!(!coloured(&["check", "b.zpg", "--color", "never"]));
    assert!(coloured(&["check", "b.zpg", "--color", "always"]));
    // Continuous integration has no terminal and shows colour.
    let forced = |variables: &[(&str, &str)], args: &[&str]| {
        let mut command = crate::support::program::command();
        command.env_remove("NO_COLOR").envs(variables.to_vec());
        let run = command.args(args).current_dir(dir.path()).output().unwrap();
        text(&run.stdout).contains('\u{1b}')
    };
    for name in ["FORCE_COLOR", "CLICOLOR_FORCE"] {
        assert!(forced(&[(name, "1")], &["check", "b.zpg"]));
        assert!(!forced(
            &[(name, "1"), ("NO_COLOR", "1")],
            &["check", "b.zpg"]
        ));
        assert!(!forced(
            &[(name, "1")],
            &["check", "b.zpg", "--color", "never"]
        ));
    }
}

#[test]
fn wrong_usage_is_2() {
    let dir = tempfile::tempdir().unwrap();
    for args in [
        &["probe"][..],
        &["check", "--format", "xml", "a"],
        &["nonsense"],
        &["explain", "E999"],
        &["explain", "-400"],
        &[],
    ] {
        let run = zpg(dir.path(), args);
        assert_eq!(run.status.code(), Some(2), "{args:?}");
        assert!(!run.stderr.is_empty(), "{args:?}");
    }
}

#[test]
fn explain_lists_all_topics() {
    let dir = tempfile::tempdir().unwrap();
    let run = zpg(dir.path(), &["explain"]);
    assert_eq!(run.status.code(), Some(0));
    let list = text(&run.stdout);
    assert!(list.starts_with(" E001  invalid-character\n"));
    assert!(list.contains("\n W307  overlapping-union\n") && list.contains("\n   11  sphere\n"));
}

#[test]
fn explain_takes_several_topics_and_groups() {
    let dir = tempfile::tempdir().unwrap();
    let run = zpg(dir.path(), &["explain", "W310", "W305"]);
    let said = text(&run.stdout);
    assert!(said.starts_with("# unused-definition (W310)"), "{said}");
    assert!(said.contains("\n# degenerate-shape (W305)"), "{said}");
    let run = zpg(dir.path(), &["explain", "E20"]);
    let said = text(&run.stdout);
    assert!(said.starts_with(" E201  not-positive\n"), "{said}");
    assert!(said.lines().all(|line| line.starts_with(" E20")), "{said}");
    let run = zpg(dir.path(), &["explain", "W310", "chekerboard"]);
    assert_eq!(run.status.code(), Some(2));
}

/// What else was written may not go together either: the usage has none of it.
#[test]
fn usage_after_a_conflict_is_that_of_the_command() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["render", "a.zpg", "--tile", "1/4", "--resume", "--watch"];
    let run = zpg(dir.path(), &args);
    let said = text(&run.stderr);
    assert!(
        said.contains("`--tile <I/N>` cannot be used with `--watch`"),
        "{said}"
    );
    assert!(
        said.contains("\nUsage: zpg render [OPTIONS] <PATH>...\n"),
        "{said}"
    );
}

#[test]
fn explain_suggests() {
    let dir = tempfile::tempdir().unwrap();
    let run = zpg(dir.path(), &["explain", "chekerboard"]);
    assert_eq!(
        text(&run.stderr),
        "error: there is no finding or record type `chekerboard`; did you mean `checkerboard`?\n"
    );
    for topic in ["-399", "checkerboard", "E101", "undefined-id"] {
        let run = zpg(dir.path(), &["explain", topic]);
        assert_eq!(run.status.code(), Some(0), "{topic}");
        assert!(text(&run.stdout).starts_with("# "));
    }
}

#[test]
fn completions_name_the_commands() {
    let dir = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = zpg(dir.path(), &["completions", shell]);
        assert_eq!(run.status.code(), Some(0));
        assert!(text(&run.stdout).contains("explain"), "{shell}");
    }
}

/// What shells show beside commands, options and values is in the language that is spoken; names are the same.
#[test]
fn completions_speak_the_language() {
    let dir = tempfile::tempdir().unwrap();
    let script = |shell: &str, lang: &str| {
        let run = zpg(dir.path(), &["completions", shell, "--lang", lang]);
        text(&run.stdout).to_owned()
    };
    for shell in ["zsh", "fish", "powershell", "elvish"] {
        let (english, czech) = (script(shell, "en"), script(shell, "cs"));
        assert!(
            english.contains("Check scenes for mistakes") || english.contains("mistakes"),
            "{shell}"
        );
        for word in ["Hledá ve scénách chyby", "Vypíše nápovědu", "Vypíše verzi"] {
            assert!(
                czech.contains(word) && !english.contains(word),
                "{shell}: {word}"
            );
        }
        let own = english
            .split(['\'', '"'])
            .filter(|words| words.starts_with("Print ") || words.starts_with("The "));
        for words in own {
            assert!(!czech.contains(words), "{shell}: {words}");
        }
        assert_eq!(
            english.matches("crosscheck").count(),
            czech.matches("crosscheck").count(),
            "{shell}"
        );
    }
    // What values mean.
    for shell in ["zsh", "fish"] {
        assert!(
            !script(shell, "cs").contains("The resolved scene"),
            "{shell}"
        );
    }
    assert_eq!(script("bash", "en"), script("bash", "cs"));
}

/// Each command has a page in both languages, and the page has all options that its help has.
#[test]
fn the_manual_has_a_page_on_every_command() {
    let dir = tempfile::tempdir().unwrap();
    let page = |about: &[&str], lang: &str| {
        let run = zpg(dir.path(), &[&["man", "--lang", lang], about].concat());
        assert_eq!(run.status.code(), Some(0), "{about:?}");
        text(&run.stdout).replace("\\-", "-")
    };
    let all = page(&[], "en");
    let commands: Vec<&str> = all
        .lines()
        .filter_map(|line| line.strip_prefix("zpg-")?.strip_suffix("(1)"))
        .collect();
    assert!(commands.len() >= 15 && commands.contains(&"man"), "{all}");
    for name in commands {
        let help = zpg(dir.path(), &[name, "--help"]);
        let help = text(&help.stdout).to_owned();
        let options = help
            .lines()
            .filter_map(|line| line.trim().strip_prefix('-'));
        let options = options.filter_map(|o| o.split("--").nth(1)?.split([' ', '[', '=']).next());
        let options: Vec<String> = options.map(|o| format!("--{o}")).collect();
        assert!(
            options.contains(&"--help".to_owned()),
            "{name}: {options:?}"
        );
        for (lang, sections) in [
            ("en", ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS"]),
            ("cs", ["JMÉNO", "POUŽITÍ", "POPIS", "VOLBY"]),
        ] {
            let page = page(&[name], lang);
            assert!(
                page.contains(&format!(".TH zpg-{name} 1 \"zpg 0.")),
                "{page}"
            );
            for section in sections {
                assert!(
                    page.contains(&format!(".SH {section}\n")),
                    "{section} in {page}"
                );
            }
            for option in &options {
                assert!(page.contains(option), "{option} in {page}");
            }
            // Requests and macros are lines with a dot; text begins none.
            let known = [
                ".TH", ".SH", ".TP", ".IP", ".RS", ".RE", ".PP", ".br", ".nf", ".fi", ".ie", ".el",
            ];
            for line in page.lines().filter(|l| l.starts_with(['.', '\''])) {
                assert!(known.iter().any(|k| line.starts_with(k)), "{line}");
            }
        }
        assert!(!page(&[name], "cs").contains("Print "), "{name}");
    }
    let run = zpg(dir.path(), &["man", "rendr"]);
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(
        text(&run.stderr),
        "error: there is no command `rendr`; did you mean `render`?\n"
    );
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let dir = tempfile::tempdir().unwrap();
    let mut child = crate::support::program::command()
        .args(["completions", "zsh"])
        .current_dir(dir.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let run = child.wait_with_output().unwrap();
    assert_eq!(text(&run.stderr), "");
    assert_eq!(run.status.code(), Some(0));
}

#[test]
fn fmt_rewrites_files() {
    let dir = folder(&[("a.zpg", "2  9 1.50 3 9 2"), ("b.zpg", "2 9 1\n")]);
    let run = zpg(dir.path(), &["fmt", "--check", "."]);
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(
        text(&run.stdout),
        "would reformat: ./a.zpg\n1 file would be reformatted, 1 file left unchanged\n"
    );
    let run = zpg(dir.path(), &["fmt", "--diff", "a.zpg", "b.zpg"]);
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(
        text(&run.stdout),
        "--- a.zpg\n+++ a.zpg\n@@ -1 +1,2 @@\n-2  9 1.50 3 9 2\n\\ No newline at end of file\n+2 9 1.5\n+3 9 2\n"
    );
    // For `patch`, a name with spaces ends with a tab.
    fs::copy(dir.path().join("a.zpg"), dir.path().join("c d.zpg")).unwrap();
    let run = zpg(dir.path(), &["fmt", "--diff", "c d.zpg"]);
    let start = "--- c d.zpg\t\n+++ c d.zpg\t\n@@ -1 +1,2 @@\n";
    assert!(text(&run.stdout).starts_with(start));
    let run = zpg(dir.path(), &["fmt", "a.zpg", "b.zpg"]);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(
        text(&run.stdout),
        "1 file reformatted, 1 file left unchanged\n"
    );
    let formatted = fs::read_to_string(dir.path().join("a.zpg")).unwrap();
    assert_eq!(formatted, "2 9 1.5\n3 9 2\n");
    let run = zpg(dir.path(), &["fmt", "--check", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0));
}

#[test]
fn fmt_says_why_lines_stay() {
    let dir = folder(&[("a.zpg", "2 9 1\n3 9  1 1 1\n4 9 2\n")]);
    let run = zpg(dir.path(), &["fmt", "a.zpg"]);
    let said = text(&run.stderr)
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert_eq!(run.status.code(), Some(0));
    assert!(said.starts_with("note: a.zpg:2:"), "{said}");
    assert!(said.contains("E009: too many numbers"), "{said}");
    assert!(said.ends_with("`zpg check a.zpg` says more"), "{said}");
    let run = zpg(dir.path(), &["fmt", "-q", "a.zpg"]);
    assert_eq!(text(&run.stderr), "");
}

#[test]
fn fmt_keeps_the_encoding() {
    let dir = tempfile::tempdir().unwrap();
    let run = zpg_with(dir.path(), &["fmt", "-"], b"2  9 1 # p\xf8\xedklad #\r\n");
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(run.stdout, b"2 9 1  # p\xf8\xedklad #\r\n");
    assert_eq!(text(&run.stderr), "");
}

#[test]
fn fmt_has_a_style_to_choose() {
    let style = "[format]\nalign = false\ngroup = false\nnumbers = \"keep\"\n";
    let scene = "2 11 0 0 0 1.50\n3  11 0 -1 0 1\n";
    let dir = folder(&[("zpg.toml", style), ("a.zpg", scene)]);
    let run = zpg(dir.path(), &["fmt", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let formatted = fs::read_to_string(dir.path().join("a.zpg")).unwrap();
    assert_eq!(formatted, "2 11 0 0 0 1.50\n3 11 0 -1 0 1\n");
    // Standard input goes by the folder it is said to be from.
    let run = zpg_with(dir.path(), &["fmt", "-"], scene.as_bytes());
    assert_eq!(text(&run.stdout), formatted);
    let elsewhere = tempfile::tempdir().unwrap();
    let name = elsewhere.path().join("b.zpg");
    let name = name.to_str().unwrap();
    let run = zpg_with(
        dir.path(),
        &["fmt", "-", "--stdin-filename", name],
        scene.as_bytes(),
    );
    assert_eq!(text(&run.stdout), "2 11  0  0 0  1.5\n3 11  0 -1 0  1\n");

    fs::write(dir.path().join("zpg.toml"), "[format]\nwidth = 9\n").unwrap();
    let run = zpg(dir.path(), &["fmt", "a.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    let said = text(&run.stderr);
    assert!(
        said.contains("zpg.toml:2:9: ") && said.contains("a width is from 20 to 1000"),
        "{said}"
    );
}

#[test]
fn fmt_changes_some_lines() {
    let dir = folder(&[("a.zpg", b"2   9 1\n3   9 1.50\n4   9 10\n5   9  1")]);
    let some = |lines: &str| {
        let run = zpg(dir.path(), &["fmt", "--range", lines, "--diff", "a.zpg"]);
        let changed = |l: &&str| l.starts_with('+') && !l.starts_with("+++");
        let lines: Vec<String> = (text(&run.stdout).lines().filter(changed))
            .map(str::to_owned)
            .collect();
        (run.status.code(), lines)
    };
    // In the columns that they have among all.
    let lines = |lines: &[&str]| lines.iter().map(|l| (*l).to_owned()).collect::<Vec<_>>();
    assert_eq!(some("2-3"), (Some(1), lines(&["+3 9  1.5", "+4 9 10"])));
    assert_eq!(some("1"), (Some(1), lines(&["+2 9  1"])));
    assert_eq!(some("7-9"), (Some(0), lines(&[])));
    for wrong in ["3-2", "0-1", "x"] {
        let run = zpg(dir.path(), &["fmt", "--range", wrong, "a.zpg"]);
        assert_eq!(run.status.code(), Some(2), "{wrong}");
    }
    let run = zpg(dir.path(), &["fmt", "--range", "1-2", "a.zpg", "b.zpg"]);
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(text(&run.stderr), "error: --range works on one file only\n");
}

#[cfg(unix)]
#[test]
fn fmt_keeps_permissions_and_links() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let dir = folder(&[("a.zpg", b"2  9 1")]);
    let file = dir.path().join("a.zpg");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("a.zpg", dir.path().join("link.zpg")).unwrap();
    let run = zpg(dir.path(), &["fmt", "link.zpg"]);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(fs::read_to_string(&file).unwrap(), "2 9 1\n");
    assert_eq!(
        fs::metadata(&file).unwrap().permissions().mode() & 0o777,
        0o640
    );
    let link = fs::symlink_metadata(dir.path().join("link.zpg")).unwrap();
    assert!(link.is_symlink());
}

#[test]
fn github_gets_a_command_for_each_finding() {
    let broken = GOOD.replace("9999 2", "9999 7");
    let dir = folder(&[
        ("a b.zpg", broken.as_bytes()),
        ("good.zpg", GOOD.as_bytes()),
    ]);
    let run = zpg(dir.path(), &["check", "--format", "github", "."]);
    assert_eq!(run.status.code(), Some(1));
    let said = text(&run.stdout);
    assert!(
        said.starts_with(
            "::error file=a b.zpg,line=5,col=8,endLine=5,endColumn=9,title=zpg (E101 undefined-id)::\
             a b.zpg:5:8: E101: 7 is not defined"
        ),
        "{said}"
    );
    assert!(said.lines().all(|line| line.starts_with("::")), "{said}");
    assert!(!said.contains("good.zpg"), "{said}");
    let run = zpg(dir.path(), &["check", "--format", "github", "good.zpg"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
}
