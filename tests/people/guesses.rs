//! Guesses and fixes of layout that newcomers found to be wrong, in short scenes.

use zpg::analysis::{Analysis, fixing, repair};
use zpg::diagnostics::{Code, Diagnostic};
use zpg::format::{Options, format};

use super::read;

fn fixed(text: &str, unsafe_too: bool) -> String {
    let mended = fixing::to_fixed_point(read(text), unsafe_too, Analysis::of);
    mended.analysis.source.text.clone()
}

fn codes(text: &str) -> Vec<Code> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).map(|d| d.code).collect()
}

#[test]
fn a_short_camera_takes_no_whole_records() {
    let text = "2 9 1\n9 -501 0 2 10 0 0 -1 45\n50 -402 0.9\n1 9999 2 0\n";
    assert_eq!(codes(text), [Code::E008]);
    let text = "2 9 1\n9 -501 0 0 10 0 0 -1 45\n50 -402 3 3 3\n1 9999 2 0\n";
    assert_eq!(codes(text), [Code::E008, Code::E009]);
    assert_eq!(fixed(text, false), text);
}

#[test]
fn a_doubtful_record_keeps_its_layout() {
    let text = "2 9 1\n4 -101 2 2 3 3\n5 14 3 1\n6 -101 4 3\n1 9999 6 0\n";
    let analysis = read(text);
    let with = |code| analysis.findings().iter().find(move |d| d.code == code);
    assert!(with(Code::W314).is_some());
    assert!(with(Code::S503).is_some_and(|d| d.fixes.is_empty()));
    assert_eq!(format(text, &analysis.document, &Options::default()), text);
    assert_eq!(fixed(text, true), text);
    // On another line nothing is in doubt.
    let apart = text.replace("1 9999 6 0\n", "7 9 2 8 9 3\n1 9999 6 0\n");
    assert!(fixed(&apart, false).contains("\n7 9 2\n8 9 3\n"));
}

#[test]
fn what_a_broken_record_hid_stops_no_fix() {
    let text = "3 11 0 2,5 0 1\n3 11 0 3 0 1\n1 9999 3 0\n";
    assert_eq!(fixed(text, false), text.replace("2,5", "2.5"));
    let text = "3 -701 modrá\n2 9 1\n3 9 2\n4 -101 2 3\n1 9999 4 0\n";
    let mended = text.replace("modrá", "0 0 1");
    assert!(fixed(text, true).starts_with(&mended[..12]));
}
