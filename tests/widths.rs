//! Lines of answers for people are no wider than the terminal, with colours and without, in both languages.

use unicode_width::UnicodeWidthStr as _;

use crate::support::program::{self, folder, text};

/// Mistakes with long texts: notes, helps, fixes, labels.
const SCENE: &str = "# mistakes #\n2 11 0 0 0 1\n3 11 0,5 0 0 1\n4 -4 2 3\n5 -6 4 77\n30 402 1 4 6 5\n\
                     9 -501 0 0 5 0 0 0 0 1 0 45\n6 12 0 0 0 -1 1 1\n7 -5 6 6\n1 9999 5 0\n";

/// Text without colours.
fn plain(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        out += before;
        rest = after.split_once('m').map_or("", |(_, rest)| rest);
    }
    out + rest
}

fn said(columns: Option<&str>, arguments: &[&str]) -> String {
    let dir = folder(&[("a.zpg", SCENE)]);
    let mut command = program::command();
    match columns {
        Some(columns) => command.env("COLUMNS", columns),
        None => command.env_remove("COLUMNS"),
    };
    let run = command
        .args(arguments)
        .current_dir(dir.path())
        .output()
        .unwrap();
    text(&run.stdout) + &text(&run.stderr)
}

/// The words, whatever the lines are.
fn words(text: &str) -> Vec<String> {
    let is_text = |word: &&str| word.chars().any(char::is_alphanumeric);
    plain(text)
        .split_whitespace()
        .filter(is_text)
        .map(str::to_owned)
        .collect()
}

#[test]
fn all_that_is_said_fits() {
    for language in ["en", "cs"] {
        for colour in ["never", "always"] {
            for arguments in [
                &["check", "a.zpg"][..],
                &["check", "--diff", "--unsafe-fixes", "--no-such-option"],
                &["explain", "W307"],
                &["explain", "torus"],
                &["explain", "glass"],
                &["explain", "E015"],
                &["explain", "W303"],
                &["explain", "no-such-thing"],
                &["explain"],
                &["render", "--help"],
                &["check", "-h"],
                &["--help"],
                &[],
                &["check", "--fix-only"],
                &["render", "a.zpg"],
            ] {
                let all = [arguments, &["--color", colour, "--lang", language]].concat();
                let wide = said(Some("1000"), &all);
                for (columns, width) in [(None, 80), (Some("80"), 80), (Some("120"), 120)] {
                    let answer = said(columns, &all);
                    for line in plain(&answer).lines() {
                        assert!(line.width() <= width, "{all:?} {width}: {line}\n{answer}");
                    }
                    assert_eq!(words(&answer), words(&wide), "{all:?}");
                }
            }
        }
    }
}

/// Notes stay within the frame.
#[test]
fn notes_stay_in_their_frame() {
    let answer = said(Some("80"), &["check", "a.zpg"]);
    let mut is_framed = false;
    let mut framed = 0;
    for line in answer.lines() {
        if line.contains("─╯") {
            is_framed = false;
        }
        if is_framed {
            assert!(line.contains(['│', '┆', '├', '╭', '╰']), "{line}\n{answer}");
            framed += 1;
        }
        if line.contains("╭─[") {
            is_framed = true;
        }
    }
    assert!(framed > 20, "{answer}");
    assert!(
        answer
            .lines()
            .any(|l| l.contains("│ Help: ") || l.contains("│ Help 1: "))
    );
}

#[test]
fn machines_get_one_line_for_each() {
    for format in ["short", "github"] {
        let arguments = ["check", "--format", format, "a.zpg"];
        assert_eq!(said(Some("80"), &arguments), said(Some("1000"), &arguments));
    }
}

/// A box in a ball of glass before a mirror: effects with long reasons, and approximations with long notes.
const GLASS: &str = "2 11 0 1 0 1\n3 14 2 0.5\n4 -102 2 3\n4 -201 0.1 0.2 0.7\n4 -203 1.5 1.52 1.54\n5 4 0 1 0 0\n\
                     6 -701 1 1 1\n7 -701 0 0 0\n5 -399 1 1 6 7\n8 -101 4 5\n9 -501 0 2 8 0 -0.2 -1 0 1 0 45\n50 -402 0.9\n\
                     50 -1 3 5 5\n1 9999 8 0\n";

/// What plan and convert say, and the columns of help and of explain, go on under their column.
#[test]
fn columns_fit_and_hang() {
    for language in ["en", "cs"] {
        for arguments in [
            &["plan", "b.zpg"][..],
            &[
                "convert",
                "b.zpg",
                "-o",
                "b.glb",
                "--tolerance",
                "1",
                "--verbose",
            ],
            &["fmt", "--help"],
            &["explain"],
        ] {
            let answer = |columns: &str| {
                let dir = folder(&[("b.zpg", GLASS)]);
                let mut command = program::command();
                let command = command.env("COLUMNS", columns).current_dir(dir.path());
                let run = command
                    .args(arguments)
                    .args(["--lang", language])
                    .output()
                    .unwrap();
                assert!(run.status.success(), "{}", text(&run.stderr));
                text(&run.stdout) + &text(&run.stderr)
            };
            let (narrow, wide) = (answer("80"), answer("1000"));
            for line in narrow.lines() {
                assert!(line.width() <= 80, "{arguments:?}: {line}");
            }
            assert_eq!(words(&narrow), words(&wide), "{arguments:?}");
            // The list of codes has no texts in English.
            let is_short = arguments == ["explain"] && language == "en";
            let (narrow, wide) = (narrow.lines().count(), wide.lines().count());
            assert!(is_short || narrow > wide, "{arguments:?}");
        }
    }
    let help = said(Some("80"), &["fmt", "--help", "--lang", "en"]);
    // The settings of the style are a table of three columns.
    let under = format!("\n{}under each other\n", " ".repeat(33));
    assert!(help.contains(&under), "{help}");
}

/// Times differ from run to run.
#[test]
fn what_a_picture_costs_fits() {
    for language in ["en", "cs"] {
        let arguments = [
            "render", "b.zpg", "-o", "b.png", "--size", "16x12", "--cost", "--lang", language,
        ];
        let dir = folder(&[("b.zpg", GLASS)]);
        let mut command = program::command();
        let command = command.env("COLUMNS", "80").current_dir(dir.path());
        let run = command.args(arguments).output().unwrap();
        let all = text(&run.stdout) + &text(&run.stderr);
        assert!(run.status.success() && all.contains(" · "), "{all}");
        for line in all.lines() {
            assert!(line.width() <= 80, "{line}");
        }
    }
}
