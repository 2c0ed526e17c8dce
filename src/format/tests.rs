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
        "2 13 1.5 3\n3 10 1000 0.5 5\n4 3  -0.0 1 0  -0.0\n",
    );
}

#[test]
fn matrices_stand_in_rows() {
    check(
        "2 15 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1 # ball #\n",
        "2 15\n  1 0 0  0\n  0 1 0  0\n  0 0 1  0\n  0 0 0 -1  # ball #\n",
    );
    check(
        "2 15 # Q #\n1 0 0 0 # x #\n# y # 0 1 0 0 0 0 # half # 1 0\n0 0 0 -1\n",
        "2 15     # Q #\n  1 0 0 0  # x #\n  # y # 0 1 0 0\n  0 0 # half # 1 0\n  0 0 0 -1\n",
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

/// What scenes are made of, and what goes wrong in them.
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
        let once = format(&text, &document, &Options::default());
        let (again, _) = parse(&once);
        let same = same_content((&text, &document), (&once, &again));
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
