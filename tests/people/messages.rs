//! What is said of the most frequent slips, in both languages, as one text to be read.

use std::fmt::Write as _;

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Diagnostic, Language};

use super::read;
use super::rules::{SCENE, with};

/// Lines of the scene, as they are written.
pub const SLIPS: &[(usize, &str)] = &[
    (1, "2 701 1 0.5 0.2"),
    (1, "2 -701 1 0.5"),
    (1, "2 -701 100% 50% 20%"),
    (1, "2 -701 255 128 50"),
    (1, "2 -701 #ff8000"),
    (1, "2 -701 0xff8000 # orange #"),
    (1, "2 -701 ff8000"),
    (1, "2 -701 red"),
    (2, "3 -201 0.6 0.3"),
    (2, "3 -201 0.6 0.3 0 0.6 0.3 0 0.6 0.3 0"),
    (2, "3 -202 0.6 0.3 0"),
    (2, "3 -201 0,6 0,3 0"),
    (2, "3 -201 0.6, 0.3, 0"),
    (2, "3 -210 0.6 0.3 0"),
    (3, "4 12 -3 -1 -3"),
    (3, "4 12 -3 -1 -3 3 0"),
    (3, "4 12 -3 -1 -3 3 0 3 1"),
    (3, "4 12 3 -1 -3 -3 0 3"),
    (3, "4 box -3 -1 -3 3 0 3"),
    (3, "12 -3 -1 -3 3 0 3"),
    (3, "4 -3 -1 -3 3 0 3"),
    (3, "1 12 -3 -1 -3 3 0 3"),
    (3, "4 5 -3 -1 -3 3 0 3"),
    (4, "4 299 2 3"),
    (4, "4 -299 3 2"),
    (4, "3 -299 2 4"),
    (4, "4 -204 2 3"),
    (4, "4 -299 3"),
    (4, "4 -299 2 33"),
    (4, "44 -299 2 3"),
    (5, "5 9 0 1 0 1"),
    (5, "5 11 0 1 0"),
    (5, "5 11 0 1 0 1 1"),
    (5, "5 11 0 1 0 -1"),
    (5, "5 11 0 1 0 O.5"),
    (5, "5 11 0,5 1,5 0 1"),
    (5, "5 l1 0 1 0 1"),
    (5, "5 sphere 0 1 0 1"),
    (5, "5 koule 0 1 0 1"),
    (5, "5 cylinder 1 2"),
    (5, "5 11 0 1 0 1 red ball"),
    (5, "5 11 0 1 0 1 red ball #"),
    (5, "5 11 0 1 0 1 # red ball"),
    (5, "5 11 0 1 0 1 # ball #1 #"),
    (5, "5 11 0 1 0 1 // red ball"),
    (5, "5 11 0 1 0 1; red ball"),
    (5, "5: 11 0 1 0 1"),
    (5, "5 11 (0 1 0) 1"),
    (5, "5 11 0 1 0 1.0.0"),
    (5, "5 11 0 1 0 1 5 11 0 1 0 1"),
    (5, "a red ball"),
    (6, "5 1 0.5 0 0"),
    (6, "5 -1 0.5 0"),
    (6, "55 -1 0.5 0 0"),
    (6, "2 -1 0.5 0 0"),
    (6, "12 -301 my image.png"),
    (6, "12 -301"),
    (6, "12 -301 a.png b.png"),
    (12, "3 -401 0.2 0.2 0.2"),
    (8, "6 -2 2 30"),
    (8, "6 -2 30 y"),
    (8, "6 -2 30° 2"),
    (8, "6 -3 2"),
    (10, "7 103 6 5"),
    (10, "7 −103 6 5"),
    (10, "7 -103 7 6"),
    (10, "7 -103 6 8"),
    (10, "7 -103 6 1"),
    (10, "7 -103 6 12\n12 11 0 0 0 1"),
    (10, "7 -103 6 2"),
    (10, "7 -103 6"),
    (10, "6 -103 6 5"),
    (13, "10 -402 1 0.9 0.8"),
    (13, "10 -402"),
    (13, "10 -402 0.8 4 6 5"),
    (13, "10 -402 0.8 4 6 5 1 0 0"),
    (13, "10 -402 4 6 5"),
    (13, "10 402 1 4 6 5"),
    (13, "10 402 1 4 6 5 1 0 0"),
    (16, "11 -501 0 4 12 0 -4 -12 0 1 0"),
    (16, "11 -501 0 4 12 0 -4 -12 0 -4 -12 40"),
    (16, "11 -501 0 4 12 0 1 0 0 1 0 40"),
    (16, "11 -501 0 4 12 0 0 0 0 1 0 40"),
    (17, "1 9999 8 0.2 0.3 0.4"),
    (17, "1 9999 5 8"),
    (17, "1 9999 8"),
    (17, "2 9999 8 2"),
    (17, "9999 1 8 2"),
    (17, ""),
];

type Make = fn() -> String;

/// The whole scene, as it is written.
const WHOLE: &[(&str, Make)] = &[
    ("each minus is a dash", || SCENE.replace('-', "–")),
    ("the minus of all types is lost", || {
        let lines = SCENE.lines().map(|line| {
            let (id, rest) = line.split_once(' ').unwrap();
            format!("{id} {}\n", rest.strip_prefix('-').unwrap_or(rest))
        });
        lines.collect()
    }),
    ("the scene twice", || [SCENE, SCENE].concat()),
    ("the difference the other way round", || {
        let hollow = "2 9 10\n3 11 0 0 0 5\n4 -103 3 2\n";
        hollow.to_owned() + "5 -402 1\n5 -1 30 30 30\n6 -501 0 0 50 0 0 -1 0 1 0 40\n1 9999 4 0\n"
    }),
];

fn write(out: &mut String, d: &Diagnostic, language: Language) {
    let words = d.wording(language);
    let severity = language.say(d.severity.as_str(), &[]);
    writeln!(out, "{} {severity}: {}", d.code.as_str(), words.message).unwrap();
    writeln!(out, "    ^ {}", words.label).unwrap();
    let more = words.labels.iter().map(|l| ("^", l));
    let more = more.chain(words.notes.iter().map(|n| ("-", n)));
    let more = more.chain(words.help.iter().map(|h| ("=", h)));
    let more = more.chain(words.fixes.iter().map(|f| ("→", f)));
    for (sign, text) in more {
        writeln!(out, "    {sign} {text}").unwrap();
    }
}

#[test]
fn what_is_said_of_slips() {
    let mut out = SCENE.to_owned();
    let lines = SLIPS.iter().map(|&(line, new)| {
        let what = format!("line {line}: `{new}`");
        (what, with(line, new))
    });
    let whole = WHOLE.iter().map(|&(what, make)| (what.to_owned(), make()));
    for (what, text) in lines.chain(whole) {
        let analysis = read(&text);
        writeln!(out, "\n## {what}").unwrap();
        for language in [Language::English, Language::Czech] {
            out.push('\n');
            for d in repair::proposals(&analysis) {
                write(&mut out, &d, language);
            }
        }
    }
    insta::with_settings!({
        snapshot_path => ".",
        prepend_module_to_snapshot => false,
        omit_expression => true,
    }, {
        insta::assert_snapshot!("messages", out);
    });
}
