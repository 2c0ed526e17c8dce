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
                &["explain", "no-such-thing"],
                &["explain"],
                &["render", "--help"],
                &["check", "-h"],
                &["--help"],
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
