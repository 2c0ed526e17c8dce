//! Records that stand in a comment, and that others still need.

use zpg::internals::diagnostics::{Applicability, Code, Fix, Language};

use super::{fixed, guessed};

/// A camera and a lamp.
const REST: &str = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n";

/// A scene without camera and lamp, what is drawn of it, what is said, and what the guesses make of both.
struct Off {
    text: &'static str,
    drawn: u32,
    code: Code,
    line: u32,
    guesses: &'static [(&'static str, u32)],
}

const ALL: &[Off] = &[
    // A difference whose colour is still there: it is wanted, or its first operand alone.
    Off {
        text: "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n0 # 4 -103 2 3 #\n4 -701 0.2 0.4 0.9\n5 11 2.5 1 0 1\n6 -101 4 5\n",
        drawn: 6,
        code: Code::E103,
        line: 3,
        guesses: &[
            (
                "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n4 -103 2 3\n4 -701 0.2 0.4 0.9\n5 11 2.5 1 0 1\n6 -101 4 5\n",
                6,
            ),
            (
                "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n0 # 4 -103 2 3 #\n2 -701 0.2 0.4 0.9\n5 11 2.5 1 0 1\n6 -101 2 5\n",
                6,
            ),
        ],
    },
    // A union of a chain: without it the chain goes on with the union before.
    Off {
        text: "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 -101 2 3\n# 6 -101 5 4 #\n7 11 4 1 0 1\n8 -101 6 7\n",
        drawn: 8,
        code: Code::E101,
        line: 5,
        guesses: &[
            (
                "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 -101 2 3\n6 -101 5 4\n7 11 4 1 0 1\n8 -101 6 7\n",
                8,
            ),
            (
                "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 -101 2 3\n# 6 -101 5 4 #\n7 11 4 1 0 1\n8 -101 5 7\n",
                8,
            ),
        ],
    },
    // A shape: without it its union is what the union before is.
    Off {
        text: "2 11 -2 1 0 1\n3 11 0 1 0 1\n0 # 4 11  0 1 0  1 #\n5 -101 2 3\n6 -101 5 4\n",
        drawn: 6,
        code: Code::E101,
        line: 3,
        guesses: &[
            (
                "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11  0 1 0  1\n5 -101 2 3\n6 -101 5 4\n",
                6,
            ),
            (
                "2 11 -2 1 0 1\n3 11 0 1 0 1\n0 # 4 11  0 1 0  1 #\n5 -101 2 3\n0 # ~ 6 -101 5 4 #\n",
                5,
            ),
        ],
    },
    // What is taken away; the record has a comment of its own, in the signs of editors.
    Off {
        text: "2 12 -1 0 -1 1 2 1\n0 # ~ 3 11 0 1 1 0.7 ~~ hole ~~ #\n4 -103 2 3\n",
        drawn: 4,
        code: Code::E101,
        line: 2,
        guesses: &[
            (
                "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7 # hole #\n4 -103 2 3\n",
                4,
            ),
            (
                "2 12 -1 0 -1 1 2 1\n0 # ~ 3 11 0 1 1 0.7 ~~ hole ~~ #\n0 # ~ 4 -103 2 3 #\n",
                2,
            ),
        ],
    },
    // Both the union and what it needs: all comes back together.
    Off {
        text: "2 11 -2 1 0 1\n# 3 11 0 1 0 1 #\n# 3 -701 1 0 0 #\n# 4 -101 2 3 #\n",
        drawn: 4,
        code: Code::E101,
        line: 4,
        guesses: &[
            ("2 11 -2 1 0 1\n3 11 0 1 0 1\n3 -701 1 0 0\n4 -101 2 3\n", 4),
            (
                "2 11 -2 1 0 1\n# 3 11 0 1 0 1 #\n# 3 -701 1 0 0 #\n# 4 -101 2 3 #\n",
                2,
            ),
        ],
    },
    // A comment that is not closed, as it has one in it.
    Off {
        text: "2 11 0 1 0 1\n# 23 12 2 0 -1 4 2 1 # kostka #\n24 -101 2 23\n",
        drawn: 24,
        code: Code::E101,
        line: 2,
        guesses: &[
            (
                "2 11 0 1 0 1\n23 12 2 0 -1 4 2 1 # kostka #\n24 -101 2 23\n",
                24,
            ),
            (
                "2 11 0 1 0 1\n# 23 12 2 0 -1 4 2 1 # kostka #\n0 # ~ 24 -101 2 23 #\n",
                2,
            ),
        ],
    },
];

/// The record of an ID is in a comment: that is said, and both that it is wanted and that it is not may be meant.
#[test]
fn the_record_of_an_id_is_in_a_comment() {
    for off in ALL {
        let scene = |text: &str, drawn: u32| format!("{text}{REST}1 9999 {drawn} 0\n");
        let text = scene(off.text, off.drawn);
        let (finding, made) = guessed(&text, off.code);
        let meant: Vec<String> = off.guesses.iter().map(|g| scene(g.0, g.1)).collect();
        assert_eq!(made, meant);
        let is_choice = |f: &Fix| f.applicability == Applicability::Choice;
        assert!(finding.fixes.iter().all(is_choice));
        let id = text.lines().nth(off.line as usize - 1).unwrap();
        let id = id
            .split_whitespace()
            .find(|w| w.parse() != Ok(0) && w.parse::<u32>().is_ok());
        let id = id.unwrap();
        for (language, said) in [
            (
                Language::English,
                format!(
                    "the record of {id} stands in the comment on line {}",
                    off.line
                ),
            ),
            (
                Language::Czech,
                format!("záznam {id} je v komentáři na řádku {}", off.line),
            ),
        ] {
            let notes = finding.wording(language).notes;
            assert!(notes.contains(&said), "{notes:?}");
        }
    }
}

/// No guess is taken, and so nothing else is either that throws an object out.
#[test]
fn nothing_is_thrown_out_for_a_record_in_a_comment() {
    for off in ALL.iter().filter(|o| !o.text.contains("kostka")) {
        let text = format!("{}{REST}1 9999 {} 0\n", off.text, off.drawn);
        let marked = text.replace("\n# ", "\n0 # ");
        assert_eq!(fixed(&text), marked);
    }
}

/// Where something else has the ID and the record in the comment would not help, other guesses stand.
#[test]
fn a_comment_that_does_not_help_is_not_spoken_of() {
    for comment in ["0 # 4 -1 1 0 0 #", "0 # 4 red balls #", "0 # 4 11 2 1 #"] {
        let text = format!("2 11 0 1 0 1\n{comment}\n5 -101 2 4\n{REST}1 9999 5 0\n");
        let (finding, _) = guessed(&text, Code::E101);
        let label = finding.wording(Language::English).label;
        assert_eq!(label, "nothing in this file has this ID");
    }
}

/// Two lines that a `#` begins each, what is drawn, a finding that follows, and the lines when all guesses are taken.
const SIGNS: &[(&str, u32, Code, &str)] = &[
    (
        "2 11 0 1 0 1\n#3 11 2 1 0 1\n#3 -701 1 0 0\n",
        2,
        Code::W310,
        "2 11 0 1 0 1\n0 # 3 11 2 1 0 1 #\n0 # 3 -701 1 0 0 #\n",
    ),
    (
        "2 11 0 1 0 1\n#3 11 2 1 0 1\n#3 -1 1 0 0\n",
        2,
        Code::E101,
        "2 11 0 1 0 1\n0 # 3 11 2 1 0 1 #\n0 # 3 -1 1 0 0 #\n",
    ),
    // A record with a comment of its own.
    (
        "2 11 0 1 0 1\n#2 12 1 1 0 1 1 1\n#2 11 5 1 0 1 # ball #\n",
        2,
        Code::E102,
        "2 11 0 1 0 1\n0 # 2 12 1 1 0 1 1 1 #\n0 # ~ 2 11 5 1 0 1 ~~ ball ~~ #\n",
    ),
    // Another record needs the ID: what is switched off is missed.
    (
        "2 11 0 1 0 1\n#3 11 2 1 0 1\n#3 -701 1 0 0\n4 -101 2 3\n",
        4,
        Code::E101,
        "2 11 0 1 0 1\n#3 11 2 1 0 1\n#3 -701 1 0 0\n4 -101 2 3\n",
    ),
    (
        "2 11 0 1 0 1\n#6 -701 1 1 0\n#4 -1 1 0 0\n4 11 1 1 1 1\n5 -101 2 4\n",
        5,
        Code::E107,
        "2 11 0 1 0 1\n0 # 6 -701 1 1 0 #\n0 # 4 -1 1 0 0 #\n4 11 1 1 1 1\n5 -101 2 4\n",
    ),
];

/// A comment ends at the `#` of the next line: both lines are to be comments, and nothing is guessed of the second one.
#[test]
fn two_lines_with_a_sign_each() {
    for &(lines, drawn, code, meant) in SIGNS {
        let scene = |lines: &str| format!("{lines}{REST}1 9999 {drawn} 0\n");
        let text = scene(lines);
        let (finding, made) = guessed(&text, code);
        assert!(made.is_empty(), "{made:?}");
        for (language, said) in [
            (
                Language::English,
                "line 3 is not in a comment: its first `#` ends the comment before it",
            ),
            (
                Language::Czech,
                "řádek 3 není v komentáři: komentář před ním končí jeho prvním znakem `#`",
            ),
        ] {
            let notes = finding.wording(language).notes;
            assert!(notes.iter().any(|note| note == said), "{notes:?}");
        }
        // A comment in a comment is written in the signs of editors, behind a `0`.
        let closed = if lines.contains("ball") { 1 } else { 2 };
        let (_, made) = guessed(&text, Code::W315);
        let [made] = &made[..] else {
            panic!("{made:?}");
        };
        let is_closed = |line: &&str| line.starts_with('#') && line.ends_with(" #");
        assert_eq!(made.lines().filter(is_closed).count(), closed, "{made}");
        assert_eq!(fixed(&text), scene(meant));
    }
}

/// Where a comment has lines of its own, or a line is prose, no such guess is made.
#[test]
fn comments_of_several_lines_are_not_lines_with_signs() {
    for lines in [
        "#\n3 11 2 1 0 1\n#3 -701 1 0 0\n",
        "#3 11 2 1 0 1\n3 -701 1 0 0\n#\n",
        "0 #3 11 2 1 0 1\n#3 -701 1 0 0\n",
        "#3 11 2 1 0 1\n#\n3 -701 1 0 0\n",
    ] {
        let text = format!("2 11 0 1 0 1\n{lines}{REST}1 9999 2 0\n");
        let (_, made) = guessed(&text, Code::W315);
        assert!(made.is_empty(), "{lines}: {made:?}");
    }
}
