use super::*;
use crate::diagnostics::Code;

fn print(text: &str, diagnostics: &[Diagnostic]) -> String {
    print_as(Look::default(), text, diagnostics)
}

fn print_as(look: Look, text: &str, diagnostics: &[Diagnostic]) -> String {
    let file = SourceFile::new("a.zpg", text.into());
    let mut out = Vec::new();
    write(&mut out, &file, diagnostics, look).unwrap();
    String::from_utf8(out).unwrap()
}

/// A word where a number should be.
fn word(span: Span) -> Diagnostic {
    Diagnostic::new(Code::E012, span).with("text", "`x`")
}

fn swapped(text: &str) -> Diagnostic {
    let at = text.find("1 9").unwrap() as u32;
    let span = Span::new(at, at + 1);
    Diagnostic::new(Code::E202, span)
        .with("lower", "xmin")
        .with("upper", "xmax")
        .with("type", Value::Term("box"))
        .with("others", Value::Count(0))
        .label(Span::new(2, 4), "other")
        .note("no-inside")
        .fix(Fix::replace("fix", Applicability::Unsafe, span, "7"))
}

#[test]
fn two_places_and_a_fix() {
    let text = "7 12 1 # žluť #\n1 9999 77 0\n";
    insta::assert_snapshot!(print(text, &[swapped(text)]), @r#"
    error[E202]: xmin of the box is greater than xmax
       ╭─[ a.zpg:2:1 ]
       │
     1 │ 7 12 1 # žluť #
       │   ─┬
       │    ╰── the upper bound
     2 │ 1 9999 77 0
       │ ┬
       │ ╰── the lower bound
       │
       │ Help: swap them (a guess):
       │       7 9999 77 0
       │
       │ Note: it has no inside: nothing of it is drawn, and it cuts nothing
    ───╯
    "#);
}

#[test]
fn the_same_in_czech() {
    let text = "7 12 1 # žluť #\n1 9999 77 0\n";
    let look = Look {
        language: Language::Czech,
        ..Look::default()
    };
    insta::assert_snapshot!(print_as(look, text, &[swapped(text)]), @r#"
    chyba[E202]: kvádr: xmin je větší než xmax
       ╭─[ a.zpg:2:1 ]
       │
     1 │ 7 12 1 # žluť #
       │   ─┬
       │    ╰── horní mez
     2 │ 1 9999 77 0
       │ ┬
       │ ╰── dolní mez
       │
       │ Rada: prohodit je (odhad):
       │       7 9999 77 0
       │
       │ Pozn.: nemá vnitřek: nic z toho se nezobrazí a nic to neodřízne
    ───╯
    "#);
}

/// The first fix is said as it is; each other one is a choice beside it.
#[test]
fn one_of_several_fixes() {
    let text = "7 12 1\n1 9999 77 0\n";
    let span = Span::new(7, 8);
    let another = |text: &str| Fix::replace("fix", Applicability::Unsafe, span, text);
    let one = swapped(text);
    let three = swapped(text).fix(another("8")).fix(another("9"));
    for (language, helps) in [
        (
            Language::English,
            ["Help 1: swap", "Help 2: or swap", "Help 3: or swap"],
        ),
        (
            Language::Czech,
            [
                "Rada 1: prohodit",
                "Rada 2: nebo prohodit",
                "Rada 3: nebo prohodit",
            ],
        ),
    ] {
        let look = Look {
            language,
            ..Look::default()
        };
        let printed = print_as(look, text, std::slice::from_ref(&three));
        for help in helps {
            assert!(printed.contains(help), "{help}: {printed}");
        }
        let printed = print_as(look, text, std::slice::from_ref(&one));
        assert!(!printed.contains(" or ") && !printed.contains(" nebo "));
    }
}

#[test]
fn far_places_get_sections_of_their_own() {
    let text = format!("2 9 1\n{}2 9 1\n1 9999 2 0\n", "\n".repeat(2_000));
    let d = Diagnostic::new(Code::E102, Span::new(2006, 2007))
        .with("id", "2")
        .with("type", Value::Term("sphere"))
        .label(Span::new(0, 1), "first");
    insta::assert_snapshot!(print(&text, &[d]), @r#"
    error[E102]: the ID 2 is defined already
          ╭─[ a.zpg:2002:1 ]
          │
     2002 │ 2 9 1
          │ ┬
          │ ╰── this sphere would be a second definition
          │
          ├─[ a.zpg:1:1 ]
          │
        1 │ 2 9 1
          │ ┬
          │ ╰── first defined here
          │
          │ Help: give it an ID of its own
    ──────╯
    "#);
}

#[test]
fn colours_change_no_character() {
    for gap in [1, 8, 40, 200, 20_000] {
        let text = format!("{0}2 9 1\n{0}2 9 1\n1 9999 2 0\n", "\n".repeat(gap));
        let ids: Vec<u32> = (text.match_indices("2 9 1"))
            .map(|(i, _)| i as u32)
            .collect();
        let d = Diagnostic::new(Code::E102, Span::new(ids[1], ids[1] + 1))
            .with("id", "2")
            .with("type", Value::Term("sphere"))
            .label(Span::new(ids[0], ids[0] + 1), "first");
        let look = Look {
            colour: true,
            ..Look::default()
        };
        let coloured = print_as(look, &text, std::slice::from_ref(&d));
        let mut pieces = coloured.split('\u{1b}');
        let mut bare = pieces.next().unwrap().to_owned();
        bare.extend(pieces.map(|piece| piece.split_once('m').unwrap().1));
        let plain = print(&text, &[d]);
        assert_eq!(bare, plain);
        let number = format!("{} │ 2 9 1", 2 * gap + 2);
        assert!(plain.contains(&number), "{plain}");
    }
}

#[test]
fn the_tenth_equal_warning_is_counted() {
    let text = "2 9 1\n".repeat(40);
    let warning = |i: u32| Diagnostic::new(Code::S502, Span::new(6 * i, 6 * i + 1));
    let shown = |n: u32| print(&text, &(0..n).map(warning).collect::<Vec<_>>());
    assert_eq!(shown(9).matches("style[S502]").count(), 9);
    let ten = shown(10);
    assert!(ten.ends_with("style[S502]: 1 more finding like these nine, at 10:1\n\n"));
    let many = shown(40);
    assert_eq!(many.matches("style[S502]").count(), 10);
    let places = "10:1, 11:1, 12:1, 13:1, 14:1, 15:1";
    assert!(many.contains(&format!(
        "31 more findings like these nine, the first at {places}"
    )));
    // Errors are all shown.
    let error = |i: u32| word(Span::new(6 * i, 6 * i + 1));
    let errors = print(&text, &(0..40).map(error).collect::<Vec<_>>());
    assert_eq!(errors.matches("error[E012]").count(), 40);
}

#[test]
fn columns_on_long_lines_are_those_of_the_file() {
    let text = format!("{}x", "2 9 1 ".repeat(100_000));
    let at = text.len() as u32 - 1;
    let d = word(Span::new(at, at + 1));
    let first = word(Span::new(0, 1));
    let printed = print(&text, &[first, d]);
    assert!(printed.contains("a.zpg:1:600001 "), "{printed}");
    assert!(printed.lines().all(|l| l.chars().count() < 250));
}

#[test]
fn any_span_can_be_printed() {
    let text = "\u{feff}é\t\u{1}1\r\n\r\u{2028}ž # \u{202e} #\n\n2 9 1";
    let n = text.len() as u32 + 2;
    let all: Vec<Diagnostic> = (0..n)
        .flat_map(|a| (0..n).map(move |b| (a, b)))
        .map(|(a, b)| {
            word(Span::new(a, b))
                .label(Span::new(b, a), "nothing-drawn")
                .fix(Fix::replace(
                    "here",
                    Applicability::Safe,
                    Span::new(a, b),
                    "t",
                ))
        })
        .collect();
    let printed = print(text, &all);
    assert!(!printed.contains(['\u{1}', '\u{202e}', '\r', '\u{feff}']));
}

/// Lines below a Czech note stand under its text.
#[test]
fn lines_below_a_czech_note() {
    let text = "   │ Help: a\n   │       b\n   │\n   │ Note: c\n   │       d\n   │\n";
    let czech = "   │ Rada: a\n   │       b\n   │\n   │ Pozn.: c\n   │        d\n   │\n";
    assert_eq!(in_czech(text), czech);
}
