//! A comma between two digits, which may be a decimal comma or a separator.

use zpg::internals::analysis::{Analysis, fixing};
use zpg::internals::diagnostics::{Applicability, Code, Language};
use zpg::internals::format::{self, Options};

use super::read;
use super::rules::with;

/// A record, what `fmt` makes of it, and what `--unsafe-fixes` does where `--fix` leaves it as it is.
const RECORDS: &[(&str, &str, Option<&str>)] = &[
    ("5 11 0 1 0,5", "5 11 0 1 0,5", Some("5 11 0 1 0 5")),
    ("5 11 0; 1; 0,5", "5 11 0; 1; 0,5", Some("5 11 0 1 0 5")),
    (
        "5 11   <0 1>   0,5",
        "5 11   <0 1>   0,5",
        Some("5 11   0 1   0 5"),
    ),
    (
        "5 14 3,1 # ring #",
        "5 14 3,1 # ring #",
        Some("5 14 3 1 # ring #"),
    ),
    // Separators.
    ("5 11 0,1,0,5", "5 11  0 1 0  5", None),
    ("5 11 0, 1, 0, 5", "5 11  0 1 0  5", None),
    ("5 11 <0,1,0>,5", "5 11  0 1 0  5", None),
];

fn fixed(text: &str, unsafe_too: bool) -> String {
    let mended = fixing::to_fixed_point(read(text), unsafe_too, Analysis::of);
    mended.analysis.source.text
}

#[test]
fn numbers_are_kept_apart_only_where_the_comma_is_a_separator() {
    for &(record, formatted, guess) in RECORDS {
        let text = with(5, record);
        let analysis = read(&text);
        let said = analysis.findings().iter().find(|d| d.code == Code::S501);
        let said = said.unwrap_or_else(|| panic!("{record}"));
        let line = |text: &str| text.lines().nth(4).unwrap_or_default().to_owned();
        let printed = format::format(&text, &analysis.document, &Options::default());
        assert_eq!(line(&printed), formatted);
        match guess {
            Some(guess) => {
                assert_eq!(
                    said.fixes[0].applicability,
                    Applicability::Unsafe,
                    "{record}"
                );
                assert!(
                    said.wording(Language::English)
                        .label
                        .contains("decimal comma")
                );
                assert_eq!(line(&fixed(&text, false)), record);
                assert_eq!(line(&fixed(&text, true)), guess);
            }
            None => {
                assert_eq!(said.fixes[0].applicability, Applicability::Safe, "{record}");
                assert!(!line(&fixed(&text, false)).contains(','), "{record}");
            }
        }
    }
}

/// Points of a profile as pairs, with decimal commas and a semicolon, a comma and a space, or a space between the
/// numbers. A comma that is alone in a pair separates.
#[test]
fn points_with_decimal_commas() {
    let meant = with(5, "5 1 4 0 0 0.5 0 0.5 1.2 0 1.2");
    for points in [
        "(0,0) (0,5;0) (0,5;1,2) (0;1,2)",
        "(0,0) (0,5; 0) (0,5; 1,2) (0; 1,2)",
        "(0,0), (0,5, 0), (0,5, 1,2), (0, 1,2)",
        "[0,0] [0,5 0] [0,5 1,2] [0 1,2]",
        "0,0 0,5;0 0,5;1,2 0;1,2",
    ] {
        let text = with(5, &format!("5 1 4 {points}"));
        assert_eq!(fixed(&text, true), meant, "{points}");
        // Without being asked nothing is written.
        assert_eq!(fixed(&text, false), text, "{points}");
    }
    // All commas are decimal, which is certain.
    let text = with(5, "5 1 2 0,5;0 0,5;1,2");
    assert!(fixed(&text, false).contains("0.5"));
    // A comment keeps its place.
    let text = with(5, "5 1 2 (0,5;0) (1,1) # válec #");
    assert!(fixed(&text, true).contains("5 1 2 0.5 0 1 1 # válec #"));
}
