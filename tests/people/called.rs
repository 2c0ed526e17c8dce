//! What a comment says of a record, and the record says otherwise.

use zpg::internals::diagnostics::{Code, Language};

use super::{fixed, guessed, read};

const REST: &str = "50 -402 0.9\n50 -1 4 6 5\n9 -501 0 2 9 0 -0.2 -1 0 1 0 50\n1 9999 2 0\n";

fn scene(records: &str) -> String {
    format!("{records}\n{REST}")
}

/// Bounds that a comment calls a centre or a corner and a size, and the first guess.
const SIZES: &[(&str, Code, &str)] = &[
    (
        "2 12 2 1 0 2 2 2 # kostka se středem 2 1 0 a hranou 2 #",
        Code::W305,
        "2 12 1 0 -1 3 2 1 # kostka se středem 2 1 0 a hranou 2 #",
    ),
    (
        "0 # box, size 2, center 2 1 0 #\n2 12 2 1 0 2 2 2",
        Code::W305,
        "0 # box, size 2, center 2 1 0 #\n2 12 1 0 -1 3 2 1",
    ),
    (
        "2 12 2 1 0 1 2 2 # centre and edges #",
        Code::E202,
        "2 12 1.5 0 -1 2.5 2 1 # centre and edges #",
    ),
    (
        "2 12 2 1 0 2 2 2 # centre, half size #",
        Code::W305,
        "2 12 0 -1 -2 4 3 2 # centre, half size #",
    ),
    (
        "2 12 2 1 0 2 2 2 # střed a poloviční hrana #",
        Code::W305,
        "2 12 0 -1 -2 4 3 2 # střed a poloviční hrana #",
    ),
    (
        "2 12 2 1 0 2 2 2 # roh a velikost #",
        Code::W305,
        "2 12 2 1 0 4 3 2 # roh a velikost #",
    ),
    (
        "2 5 2 1 2 2 # centre and size #",
        Code::W305,
        "2 5 1 0 3 2 # centre and size #",
    ),
];

#[test]
fn a_centre_and_a_size_by_a_comment() {
    for (written, code, meant) in SIZES {
        let (finding, made) = guessed(&scene(written), *code);
        assert_eq!(made[0], scene(meant), "{written}");
        assert_eq!(fixed(&scene(written)), scene(meant), "{written}");
        for language in [Language::English, Language::Czech] {
            assert_eq!(finding.wording(language).fixes.len(), made.len());
        }
    }
}

/// Without a comment a lost minus comes first, and nothing is taken without being asked. A prism is no edge.
#[test]
fn a_centre_and_a_size_without_a_comment() {
    for comment in ["", " # hranol #", " # in the centre of the room #"] {
        let text = scene(&format!("2 12 2 1 0 2 2 2{comment}"));
        let (finding, made) = guessed(&text, Code::W305);
        let at = usize::from(!comment.contains("centre"));
        assert_eq!(made[at], text.replace("2 1 0 2 2 2", "1 0 -1 3 2 1"));
        assert!(made.contains(&text.replace("12 2 1", "12 -2 1")));
        assert_eq!(fixed(&text), text);
        let said = finding.wording(Language::Czech).fixes;
        assert_eq!(
            said[at],
            "je-li `2 1 0` střed a `2 2 2` velikost, napsat `1 0 -1 3 2 1`"
        );
    }
    // Nothing has a size of 0.
    let flat = read(&scene("2 12 -1 0 -1 1 0 1 # centre and size #"));
    assert!(flat.findings().iter().all(|d| d.fixes.is_empty()));
}
