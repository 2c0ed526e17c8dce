//! Recovery, case by case: one mistake, one error, on its own line.

use zpg::diagnostics::SourceFile;

/// The findings of the parser as `CODE@line`.
fn findings(text: &str) -> Vec<String> {
    let source = SourceFile::new("t.zpg", text.into());
    let (document, diagnostics) = zpg::syntax::parse(&source.text);
    assert_eq!(document.print(text), text, "the tree must print its source");
    diagnostics
        .iter()
        .map(|d| format!("{}@{}", d.code.as_str(), source.position(d.span.start).line))
        .collect()
}

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    assert_eq!(findings(text), expected, "{}", &text[..text.len().min(300)]);
}

/// Lines that surround a case, so that the layout has something to say.
fn among(text: &str) -> String {
    format!("40 -701 1 1 1\n41 -201 0.5 0.5 0\n{text}\n50 -402 1\n51 -401 0.2\n1 9999 2 40\n")
}

#[test]
fn free_form_text_that_is_right_stays_right() {
    check("2 9 10 3 11 0 0\n0 5 4\n-101 2 3 1 9999 4\n0", &[]);
    check("2\n9\n10\n1\n9999\n2\n0\n", &[]);
    check("2 9 10 0 # a comment # 1 9999 2 0", &[]);
    let words: Vec<String> = (2..500)
        .flat_map(|i| {
            [
                i.to_string(),
                "11".into(),
                (i % 7).to_string(),
                "0".into(),
                "1.5".into(),
                "3".into(),
            ]
        })
        .collect();
    for width in [1, 2, 3, 4, 5, 7, 11, 13, 60] {
        let text: Vec<String> = words.chunks(width).map(|c| c.join(" ")).collect();
        // A line may look like a record by chance; that is worth a warning, no more.
        let errors = findings(&text.join("\n"))
            .into_iter()
            .filter(|f| !f.starts_with('W'));
        assert_eq!(errors.count(), 0, "width {width}");
    }
}

#[test]
fn records_over_several_lines_are_right() {
    check(&among("2 15 1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 0"), &[]);
    check(&among("2 1 4\n0 2\n5 20\n1 0\n3 9"), &[]);
    check(&among("2 1 4\n0 2 # top #\n1 1\n1 0\n0 0 # bottom #"), &[]);
}

#[test]
fn one_number_too_few_or_too_many() {
    check(&among("2 11 0 10 0\n3 9 3"), &["E008@3"]);
    check(&among("2 11 0 10 0 5 7\n21 9 3"), &["E009@3"]);
    check(
        "20 11 0 10 0 5 1\n20 -1 1 2 3\n21 9 5\n22 9 4\n",
        &["E009@1"],
    );
    check(&among("2 4 0 1 0\n0 # heading #"), &["E008@3"]);
    check(&among("2 4 0 1 0 0 0\n3 9 1"), &["E009@3"]);
    check(&among("2 1 2 0 2 2 1 3 0 0 0"), &["E009@3"]);
}

#[test]
fn the_odd_line_of_a_matrix_is_blamed() {
    check(
        &among("2 15 1 0 0 0\n0 1 0 0\n0 0 -1\n0 0 0 0\n3 9 1"),
        &["E008@5"],
    );
    check(
        &among("2 15 1 0 0 0\n0 1 0 0 0\n0 0 -1 0\n0 0 0 0\n3 9 1"),
        &["E009@4"],
    );
    check(
        &among("2 15\n1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0\n0 # heading #"),
        &["E008@7"],
    );
    check(&among("2 1 5\n0 2 1 1\n1 0 2\n0 0\n3 9 1"), &["E008@5"]);
    check(&among("2 1\n0 2 1 1\n1 0 2 1\n0 0\n3 9 1"), &["E008@3"]);
}

#[test]
fn types_and_ids() {
    check(&among("2 77 1 2\n3 9 1"), &["E007@3"]);
    check(
        &among("2 77 1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 0\n3 9 1"),
        &["E007@3"],
    );
    check(&among("2 77 1.5 2\n3 88 1 2"), &["E007@3", "E007@4"]);
    check(&among("9 10\n3 9 5\n4 -101 2 3"), &["E005@3"]);
    check(&among("-101 2 3\n3 9 1"), &["E005@3"]);
    check(&among("11 0 10 0 10\n3 9 1"), &["E005@3"]);
    check(&among("4 1 1 1 0\n5 9 1"), &["E005@3"]);
    check(
        &among("15 1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 0\n3 9 1"),
        &["E005@3"],
    );
    check(&among("2 abc 1\n3 9 1"), &["E006@3"]);
    check(&among("2\n3 9 1"), &["E006@3"]);
    check(&among("2 9.0 1\n3 9 1"), &["E010@3"]);
    check(&among("99999999999 9 1\n3 9 1"), &["E004@3"]);
    check(&among("2 1 2000000000 1 0 0 1\n3 9 1"), &["E013@3"]);
}

#[test]
fn stray_characters_and_words() {
    check(&among("2 11 0 @ 0 0 5"), &["E001@3"]);
    check(&among("2 11 0 abc 0 5"), &["E012@3"]);
    check(&among("@ 2 11 0 0 0 5"), &["E001@3"]);
    check(&among("2 @ 11 0 0 0 5"), &["E001@3"]);
    check(&among("2 11 0 1.2.3 0 5"), &["E003@3"]);
    check(&among("2 11 0 0,5 0 5"), &["E003@3"]);
    check(&among("2 11 0 0 0 5 $"), &["E001@3"]);
    check(&among("hello world"), &["E012@3"]);
    check(&among("2 -301 5\n3 9 1"), &["E011@3"]);
    check(&among("2 -301 01.png\n3 9 1"), &[]);
}

#[test]
fn numbers_without_a_space_between() {
    check(&among("3 11 0 0-1 1"), &["E003@3"]);
    check(&among("2 11 1.2.3 0 1"), &["E003@3"]);
    check(&among("3-101 40 41"), &["E003@3"]);
    // The count fits as it is: one number is malformed.
    check(&among("3 11 0 0-1 1 2"), &["E003@3"]);
    check(&among("2 11 1.2.3 0 0 1"), &["E003@3"]);
    // No way to read it gives the right count.
    check(&among("3 11 0-1 1"), &["E008@3", "E003@3"]);
}

#[test]
fn commas_between_coordinates() {
    check(&among("2 1 3 0,0 1,1 0,2"), &[]);
    check(&among("2 1 3\n0,0 1,1\n0,2"), &[]);
    check(&among("2 11 0,0 0,1"), &[]);
    check(&among("2 11 0 0 0 0,5"), &["E003@3"]);
    check(&among("2 11 0,5 0,5 0,5 0,5"), &["E003@3"; 4]);
    // Where another comma is a decimal one, so is this, and a number is missing.
    check(
        &among("2 11 0 0 0 0,5\n3 11 0,5 0 1"),
        &["E003@3", "E008@4", "E003@4"],
    );
}

/// An optional parameter that is not the last of its line is none.
#[test]
fn no_broken_record_without_an_error() {
    check("5\n18\n1  6 -101 2 3\n", &["E006@3"]);
    // A plane 18 1 4 9 without its ID.
    check("2 9 1\n3 18 1 4 9\n", &["E005@2"]);
    check("5 18\n1 9999 5 0\n", &[]);
    check("5\n19\n1 1 6 9 1\n", &["E008@3"]);
}

#[test]
fn the_render_record() {
    check("2 9 1\n3 9 2\n9999 1 2 0", &["E005@3"]);
    check("2 9 1\n3 9 2\n9999 1 2 0 -1 -1 -1 1 1 1", &["E005@3"]);
    // A surface of revolution with a large ID.
    check("2 9 1\n9999 1 2 0 0 1 1\n1 9999 2 0", &[]);
    for extra in ["0", "0 0", "0 0 0", "0.1 0.2 0.3"] {
        check(&format!("2 9 1\n1 9999 2 0 {extra}\n"), &["E009@2"]);
    }
}

#[test]
fn file_names_with_spaces() {
    check(&among("2 -301 my image.png"), &["E012@3"]);
    check(&among("2 -301 my \"image.png\""), &["E012@3"]);
    check(&among("2 -301 \"my image.png\""), &[]);
}

/// Lines `line` with IDs from 10 on between two records, and the same error on each of them.
#[track_caller]
fn on_each_line(line: &str, code: &str, count: usize) {
    for n in 2..40 {
        let lines: String = (0..n)
            .map(|i| format!("{} {}\n", i + 10, line.replace('k', &i.to_string())))
            .collect();
        let expected: Vec<String> = (0..n * count)
            .map(|i| format!("{code}@{}", i / count + 2))
            .collect();
        let text = format!("2 9 1\n{lines}1 9999 2 0\n");
        let found = findings(&text);
        assert_eq!(found, expected, "{n} lines of {line}");
        let found = findings(&format!("2 9 1\n3 9 1\n4 9 1\n{lines}"));
        assert_eq!(found.len(), n * count, "{n} lines of {line}");
    }
}

#[test]
fn the_same_mistake_on_neighbouring_lines() {
    on_each_line("11 0 0 0 0,5", "E003", 1);
    on_each_line("11 0,5 1,5 0 0,5", "E003", 3);
    on_each_line("-701 1 0 0 1", "E009", 1);
    on_each_line("11 k 1 0", "E008", 1);
    on_each_line("11 k 1 0 1 1", "E009", 1);
    on_each_line("sphere 1 0 0 2", "E006", 1);
    on_each_line("11 x 1 0 2", "E012", 1);
    on_each_line("77 1 0 2", "E007", 1);
    on_each_line("201 0.8 0.1 0.1", "E007", 1);
}

#[test]
fn a_sign_that_comments_the_rest_of_the_line() {
    check(
        "2 11 0 0 0 1 # koule\n3 11 1 0 0 1 # druha\n4 -101 2 3\n",
        &["E002@1", "E002@2"],
    );
    for n in 2..12 {
        let expected: Vec<String> = (1..=n).map(|l| format!("E002@{l}")).collect();
        let lines: String = (0..n)
            .map(|i| format!("{} 11 {i} 0 0 1 # koule {i}\n", i + 2))
            .collect();
        assert_eq!(findings(&format!("{lines}20 -101 2 3\n")), expected, "{n}");
    }
    // A block of records in a comment is one that was meant.
    check(
        "0 # off:\n2 11 0 0 0 1\n3 11 0 0 0 1\n#\n4 11 0 0 0 1 # on #\n",
        &[],
    );
}

#[test]
fn comments_that_nobody_closes() {
    check(&among("2 9 1 # a\n3 9 2 # b #\n4 9 3 # c #"), &["E002@3"]);
    check(&among("2 11 0 # a 0 0 5\n3 9 2 # b #"), &["E002@3"]);
    check(&among("2 9 1 # a #\n3 # 9 2 # b #"), &["E002@4"]);
}

#[test]
fn a_number_taken_from_a_line_that_could_stand_alone() {
    // In a text that is not laid out in lines, arity decides, with a warning.
    let free = "2 9 1 3 9\n2 4 11 0 0\n0 1 5 4 0 1 0\n0 # heading #\n6 9 1 7 -101\n6 2 1\n9999 7 0";
    check(free, &["W314@4"]);
}

/// The line of a second definition that is also a record without its ID: never passed over in silence.
#[test]
fn a_line_that_lost_its_id_and_reads_well_gets_an_error() {
    let rows: String = (6..=13).map(|id| format!("{id} 1 2 0 0 0 0\n")).collect();
    check(&format!("2 0\n3 0\n13 9 1\n5 0\n{rows}"), &["E005@3"]);
}
