use super::*;
use crate::syntax::parse;

/// Formats and checks what must always hold.
fn fmt(text: &str) -> String {
    let (document, _) = parse(text);
    let once = format(text, &document, &Options::default());
    let (again, _) = parse(&once);
    assert!(
        same_content((text, &document), (&once, &again)),
        "the content has changed:\n{text}\n---\n{once}"
    );
    assert_eq!(
        format(&once, &again, &Options::default()),
        once,
        "not stable"
    );
    once
}

#[track_caller]
fn check(from: &str, to: &str) {
    assert_eq!(fmt(from), to);
    assert_eq!(fmt(to), to);
}

#[test]
fn a_record_a_line() {
    check(
        "  2 9 1   3\t11 0 0\n0 1 \n\n\n 4 -101 2 3",
        "2 9 1\n3 11  0 0 0  1\n\n4 -101 2 3\n",
    );
}

#[test]
fn numbers_are_short_and_integers_stay_integers() {
    check(
        "+2 013 1.50 +3\n3 10 1E+3 .5 5.\n4 3 -0.0 1 0 -0\n",
        "2 13 1.5 3\n3 10 1000 0.5 5\n4 3  -0 1 0  -0\n",
    );
    // A zero with a sign is no type.
    check("5   -00\n", "5 -00\n");
}

#[test]
fn matrices_stand_in_rows() {
    check(
        "2 15 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1 # ball #\n",
        "2 15\n  1 0 0  0\n  0 1 0  0\n  0 0 1  0\n  0 0 0 -1  # ball #\n",
    );
    check(
        "2 15 # Q #\n1 0 0 0 # x #\n# y # 0 1 0 0 0 0 # half # 1 0\n0 0 0 -1\n",
        "2 15        # Q #\n  1 0 0  0  # x #\n  # y # 0 1 0 0\n  0 0 # half # 1 0\n  0 0 0 -1\n",
    );
}

#[test]
fn comments_stay_in_place() {
    check(
        "0   # heading #  2 9 1 # ball #\n\n\n  0 # many\n   lines #\n# before # 3 9\n# radius # 2\n",
        "0 # heading #\n2 9 1  # ball #\n\n0 # many\n   lines #\n# before # 3 9 # radius # 2\n",
    );
    check(
        "2 9 1 # a #\n  # b ##c#\n3 9 1\n",
        "2 9 1  # a #\n# b # #c#\n3 9 1\n",
    );
}

#[test]
fn optional_parameters_stay_what_they_are() {
    check(
        "2 18 3 19 # none # 4 19 1 2\n5 20\n6 20 1 1 1 2 # two #\n1 9999\n2 0 -1 -1 -1 1 1 1",
        "2 18\n3 19          # none #\n4 19 1 2\n5 20\n6 20 1 1 1 2  # two #\n1 9999  2 0  -1 -1 -1  1 1 1\n",
    );
}

#[test]
fn what_cannot_be_read_stays_to_the_byte() {
    check(
        "  2   9   1\n\n\n\n  3   11   0 0\t0  # short #  \n\n\n  4  9  1\n",
        "2 9 1\n\n  3   11   0 0\t0  # short #  \n\n4 9 1\n",
    );
    check(
        "2  9  1   5  -204   0  35\n  6  9  2\n",
        "2  9  1   5  -204   0  35\n6 9 2\n",
    );
    check("2  9  1  # open\n3  9  1\n", "2  9  1  # open\n3 9 1\n");
}

#[test]
fn notation_goes() {
    check("2 11 <0, 0, 0>, 1;\n", "2 11  0 0 0  1\n");
}

#[test]
fn the_file_keeps_its_form() {
    check("\u{feff}2  9 1\r\n3 9 1", "\u{feff}2 9 1\r\n3 9 1\r\n");
    check("", "");
    check("\n\n \n", "");
    check("\n\n2 9 1\n\n\n", "2 9 1\n");
}

#[test]
fn file_names_are_left_alone() {
    check(
        "2 -301   01.png\n3 -301 \"a  b.png\"\n",
        "2 -301 01.png\n3 -301 \"a  b.png\"\n",
    );
}

#[test]
fn runs_stand_in_columns() {
    check(
        "2 11 0 10.5 -3 1\n10 11 -1.25 0 0 .5 # small #\n100 11 1e-5 0 0 2\n",
        "2   11   0    10.5 -3  1\n10  11  -1.25  0    0  0.5  # small #\n100 11   1e-5  0    0  2\n",
    );
    // Another type, a blank line, a comment and what cannot be read end a run.
    check(
        "2 9 1\n3 10 1 1 1\n4 9 10\n\n5 9 -1\n# c #\n6 9 100\n7 9 x\n8 9 1\n",
        "2 9 1\n3 10 1 1 1\n4 9 10\n\n5 9 -1\n# c #\n6 9 100\n7 9 x\n8 9 1\n",
    );
    // What would leave the page is not aligned.
    let short = "2 6  0 0 0  1 0 0  0 1 0\n";
    let digits = "0.1234567890123456 ".repeat(3) + &"0 ".repeat(6);
    let long = format!(
        "3 6 {digits}\n4 6 {digits}\n5 6 {}\n",
        digits.replace("0.", "1000.")
    );
    let aligned = fmt(&(short.to_owned() + &long));
    assert!(aligned.starts_with("2 6     0 "), "{aligned}");
    let wide = "3 6 -12345678.12345678 -12345678.12345678 -12345678.12345678 0 0 0 0 0 0\n";
    let wider = "4 6 0 0 0 -12345678.12345678 -12345678.12345678 -12345678.12345678 0 0 0\n";
    assert!(fmt(&[short, wide, wider].concat()).starts_with(short));
}

#[test]
fn profiles_wrap() {
    let points: Vec<String> = (0..15).map(|i| format!("{}.5 {}", i, 100 - i)).collect();
    let wrapped = fmt(&format!("2 1 15 {} # vase #\n", points.join(" ")));
    let lines: Vec<&str> = wrapped.lines().collect();
    assert_eq!(lines[0], "2 1 15");
    assert_eq!(
        lines[1],
        "   0.5 100     1.5  99     2.5  98     3.5  97     4.5  96     5.5  95     6.5  94     7.5  93"
    );
    assert!(lines[2].ends_with("14.5  86  # vase #"));
    assert_eq!(lines.len(), 3);
    // Comments between points end a line or have one of their own, as in the file.
    check(
        "2 2 3 # pairs #\n0 0 # foot #\n1.5 2 # belly #\n# top #\n0 3 # colours # 1 0 0 0 1 0\n0 .5 1",
        "2 2 3    # pairs #\n  0   0  # foot #\n  1.5 2  # belly #\n  # top #\n  0   3  # colours #\n  \
         1 0   0    0 1   0    0 0.5 1\n",
    );
    check(
        "2 1 2 # a # 0 0 # b # 1 1\n",
        "2 1 2  # a #\n  0 0  # b #\n  1 1\n",
    );
}

/// A row that could be taken for a record of its own is avoided.
#[test]
fn no_row_reads_as_a_record() {
    let text = fmt(&format!(
        "2 1 30 {}\n",
        "0.123456789 9 ".repeat(15) + &"4 9 ".repeat(15)
    ));
    let (_, findings) = parse(&text);
    assert!(findings.is_empty(), "{findings:?}");
}

#[test]
fn headings_keep_a_blank_line() {
    check(
        "0 # a #\n0 # b #\n2 9 1\n0 # c #\n3 9 1 0 # lamps # 4 9 1\n# d #\n0 # e #\n",
        "0 # a #\n0 # b #\n2 9 1\n\n0 # c #\n3 9 1\n\n0 # lamps #\n4 9 1\n# d #\n0 # e #\n",
    );
    // What speaks to us is no heading; behind a record no `0` is needed.
    check(
        "2 9 1 0 # ball #\n0 # zpg: allow(W302) #\n3 9 1\n",
        "2 9 1  # ball #\n0 # zpg: allow(W302) #\n3 9 1\n",
    );
}

#[test]
fn what_a_comment_allows_stays_on_its_line() {
    let text = "35 -201 1 1 0  36 -201 1 1 0 # zpg: allow(W302) #\n";
    check(text, text);
    let text = "# zpg: allow(W302) #\n35 -201 1 1 0  36 -201 1 1 0\n";
    check(text, text);
    check(
        "35 -201 1 1 0 # zpg: allow(W302) #\n36 -201 .5 0 0\n",
        "35 -201 1   1 0  # zpg: allow(W302) #\n36 -201 0.5 0 0\n",
    );
}

#[test]
fn comments_stand_in_a_column_while_they_fit() {
    let long = "x".repeat(70);
    check(
        &format!("2 9 1 # koule č. 1 #\n3 12 -1 -1 -1 1 1 1 # {long} #\n4 9 1 # c #\n"),
        &format!(
            "2 9 1                  # koule č. 1 #\n\
             3 12  -1 -1 -1  1 1 1  # {long} #\n\
             4 9 1                  # c #\n"
        ),
    );
    // Where one does not fit in the column of those above, another column begins.
    let longer = "x".repeat(85);
    check(
        &format!("2 12 -1 -1 -1 1 1 1 # a #\n3 9 1 # {longer} #\n"),
        &format!("2 12  -1 -1 -1  1 1 1  # a #\n3 9 1  # {longer} #\n"),
    );
}

/// Two columns for a wide character, none for an accent that combines.
#[test]
fn comments_align_by_the_room_they_take() {
    check(
        "# 半径 # 2 9 1 # a #\n3 9 1 # b #\n# e\u{301} # 4 9 1 # c #\n5 9 1 # ž #\n",
        "# 半径 # 2 9 1  # a #\n3 9 1           # b #\n# e\u{301} # 4 9 1     # c #\n5 9 1           # ž #\n",
    );
}

/// With other breaks the lines of this comment would be read as records; the lines behind it are not.
#[test]
fn only_what_would_be_read_otherwise_is_kept() {
    check(
        "2 -301\n# 7 9 1\n 8 9 2 #\na.png\n3 11 +7 0 3 1\n\n\n4 9 1.50\n",
        "2 -301\n# 7 9 1\n 8 9 2 #\na.png\n3 11  7 0 3  1\n\n4 9 1.5\n",
    );
}

/// Where there are mistakes, what a `0` behind a record introduces may bear witness; the record is laid
/// out for all that.
#[test]
fn among_mistakes_the_zero_of_a_comment_stays() {
    check(
        "2   9 1.0  0   # ball #\n3  9 x\n",
        "2 9 1  0 # ball #\n3  9 x\n",
    );
}

/// Runs, columns of comments, headings and what is said to the next line do not see where a text is cut.
#[test]
fn parts_are_printed_as_the_whole() {
    let text = "0 # balls #
2 11 0 0 1.50 1 # c #
3 20   # a comment further to the right #
4 11 0 0 1 1
5 11 10 0 1 1  # c #
# zpg: ignore #
6 -101 2 3 7 -101 2 4

8 -103 2 3 0 # d #
9 15 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1
10 -101 2 3 # e #
11 20 # one that leaves no room for a column, since it goes on up to the end of the line and beyond it #
12 -701 1 1 1 # f #
12 -1 1 2 3
0 # a heading #
14 -101 2 3 # g #
";
    let (document, _) = parse(text);
    for zeros in [false, true] {
        same_in_parts(text, &document, &Options::default(), zeros);
    }
    // A part may begin with the records 3, 4, 8, 10, 11, 12 and the translation.
    assert_eq!(
        DocumentRange::cut(&document, document.tokens.len()).len(),
        8
    );
}

/// Checks that a text is printed the same in any number of parts.
fn same_in_parts(text: &str, document: &Document, options: &Options, zeros: bool) {
    let care = Care {
        zeros,
        ..Care::default()
    };
    let context = Context {
        text,
        document,
        options,
    };
    let whole = print_all(&context, &care, 1);
    for parts in 2..=document.tokens.len() {
        assert_eq!(print_all(&context, &care, parts), whole, "in {parts} parts");
    }
}

#[test]
fn what_says_the_same() {
    let same = |a: &str, b: &str| compare::are_plainly_same(a, &parse(a).0, b);
    let text = "0 # h #\n2 11 0 0 1.50 1 # c #\n3 20\n4 -101 2 3\n";
    for other in [
        "2 11 0 0 1.5 1\n# h # # c #\n3 20\n4 -101 2 3",
        "2 11 # h #\n0 0 1.50 +1 # c #\n0\n3 20\n4 -101 2 3\n0",
        // No half-axis is negative: these are two records.
        "2 11 0 0 1.5 1\n# h # # c #\n3 20 4 -101 2 3",
    ] {
        assert!(same(text, other), "{other}");
    }
    for other in [
        text.replace("1.50", "1.51"),
        text.replace("# c #", "# d #"),
        text.replace("# c #", ""),
        text.replace("3 20", "3 19"),
        text.replace("3 20\n4 -101", "3 20 4 0.101"),
        text.replace("4 -101", "5 -101"),
        text.replace("4 -101 2 3", ""),
        text.to_owned() + "5 9 1",
        text.to_owned() + "# e #",
        text.to_owned() + "x",
    ] {
        assert!(!same(text, &other), "{other}");
    }
}

#[test]
fn the_style_can_be_chosen() {
    let styled = |text: &str, options: Options| format(text, &parse(text).0, &options);
    let all = Options::default();
    let text = "2 11 0 -1 0 1.50\n3 11 0 0 0 +1 # c #\n";
    assert_eq!(
        styled(
            text,
            Options {
                align: false,
                ..all
            }
        ),
        "2 11  0 -1 0  1.5\n3 11  0 0 0  1  # c #\n"
    );
    assert_eq!(
        styled(
            text,
            Options {
                group: false,
                ..all
            }
        ),
        "2 11 0 -1 0 1.5\n3 11 0  0 0 1  # c #\n"
    );
    assert_eq!(
        styled(
            text,
            Options {
                numbers: Numbers::Keep,
                ..all
            }
        ),
        "2 11  0 -1 0   1.50\n3 11  0  0 0  +1  # c #\n"
    );
    let profile = "2 1 3 0 0 10 10 0 20\n";
    assert_eq!(styled(profile, all), "2 1 3  0 0  10 10  0 20\n");
    assert_eq!(
        styled(profile, Options { width: 20, ..all }),
        "2 1 3\n   0  0    10 10\n   0 20\n"
    );
}

#[test]
fn examples_of_the_table_are_in_the_style() {
    use crate::syntax::table::RECORD_TYPES;
    for ty in RECORD_TYPES.iter().filter(|t| t.vectors != [4; 4]) {
        check(&format!("{}\n", ty.example), &format!("{}\n", ty.example));
    }
}

#[test]
fn lines_are_those_of_an_editor() {
    let text = "a\nb\r\nc\rd";
    let of = |lines| bytes_of(text, lines).map(|bytes| &text[bytes]);
    let one = [of(1..=1), of(2..=2), of(3..=3), of(4..=9)];
    assert_eq!(one, [Some("a"), Some("b\r"), Some("c"), Some("d")]);
    assert_eq!(of(2..=3), Some("b\r\nc"));
    assert_eq!((of(1..=usize::MAX), of(7..=8)), (Some(text), None));
}

/// Pieces that scenes are made of, and what goes wrong in them.
const PIECES: &[&str] = &[
    "2",
    "3",
    "9",
    "11",
    "18",
    "19",
    "20",
    "21",
    "-302",
    "9999",
    "1",
    "0",
    "-1",
    "-4",
    "-299",
    "-301",
    "1.50",
    "+7",
    "-0.0",
    "1e3",
    "0,5",
    "1e999",
    "x",
    "a.png",
    "\"a b\"",
    "@",
    "#",
    "# c #",
    "# c\nd #",
    "\n",
    "\n",
    "\n\n",
    "\r\n",
    " ",
    "\t",
    ",",
    "<",
    "2 9 1\n",
    "3 11 0 0 0 1\n",
    "4 18\n",
    "5 20 1 1 1 2\n",
    "6 15 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1\n",
];

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(1_000))]

    /// The result is stable wherever the content is kept. (A scene with mistakes can be read
    /// differently in another layout; the command then leaves the file alone.)
    #[test]
    fn soup_is_stable(pieces in proptest::collection::vec(proptest::sample::select(PIECES), 0..40)) {
        let text = pieces.join(" ");
        let (document, diagnostics) = parse(&text);
        same_in_parts(&text, &document, &Options::default(), false);
        let once = format(&text, &document, &Options::default());
        let (again, _) = parse(&once);
        let same = same_content((&text, &document), (&once, &again));
        proptest::prop_assert!(same || !compare::are_plainly_same(&text, &document, &once));
        if same {
            proptest::prop_assert_eq!(format(&once, &again, &Options::default()), once);
        } else {
            proptest::prop_assert!(diagnostics.iter().any(|d| d.is_error()), "{:?} -> {:?}", text, once);
        }
    }

    /// Good records keep their content whatever white space and comments lie between their tokens.
    #[test]
    fn good_scenes_keep_their_content(
        gaps in proptest::collection::vec(proptest::sample::select(&[" ", "\n", "  ", " # c # ", "\n# c\n c #\n", "\r\n\n"][..]), 60),
    ) {
        let scene = "2 11 0 0 0 1.0 3 9 2 4 -101 2 3 4 -4 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 5 -701 1 1 1 4 -299 5 0 9 -402 .5";
        let mut text = String::new();
        for (token, gap) in scene.split(' ').zip(gaps) {
            text += token;
            text += gap;
        }
        fmt(&text);
    }
}

#[test]
fn scenes_of_the_repository_keep_their_content() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut scenes = 0;
    for folder in ["tests/corpus", "scenes"] {
        for entry in ignore::Walk::new(root.join(folder)) {
            let entry = entry.unwrap();
            if entry.path().extension().is_some_and(|e| e == "zpg") {
                let bytes = std::fs::read(entry.path()).unwrap();
                fmt(&String::from_utf8_lossy(&bytes));
                scenes += 1;
            }
        }
    }
    assert!(scenes > 0);
}
