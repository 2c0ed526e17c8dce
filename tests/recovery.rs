//! Recovery as data: scenes in `tests/recovery`, and beside each what is said of it and what fixes make of it.
//! One mistake, one error, in its own record. What holds for any number of lines is tried out here.

use zpg::internals::diagnostics::SourceFile;

#[test]
fn scenes_of_recovery() {
    insta::glob!("recovery/*.zpg", super::lint_rules::snapshot);
}

/// The findings of the parser as `CODE@line`.
fn findings(text: &str) -> Vec<String> {
    let source = SourceFile::new("t.zpg", text.into());
    let (document, diagnostics) = zpg::internals::syntax::parse(&source.text);
    assert_eq!(document.print(text), text, "the tree must print its source");
    diagnostics
        .iter()
        .map(|d| format!("{}@{}", d.code.as_str(), source.position(d.span.start).line))
        .collect()
}

#[test]
fn free_form_text_that_is_right_stays_right() {
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
    for n in 2..12 {
        let expected: Vec<String> = (1..=n).map(|l| format!("E002@{l}")).collect();
        let lines: String = (0..n)
            .map(|i| format!("{} 11 {i} 0 0 1 # koule {i}\n", i + 2))
            .collect();
        assert_eq!(findings(&format!("{lines}20 -101 2 3\n")), expected, "{n}");
    }
}

#[test]
fn mistakes_in_free_form_text() {
    let with = |record: &str| {
        let rest = "3 -701 1 0.5 0 4 -201 0.5 0.3 0.1 6 11 1 2 3 0.5 8 12 -1 -1 -1 1 1 1 10 9 1.5 12 -103 8 10";
        let text = format!("{rest} {record} 16 -101 12 14 18 9 3 20 -101 16 18 1 9999 20 0");
        let words: Vec<&str> = text.split(' ').collect();
        let lines: Vec<String> = words.chunks(7).map(|line| line.join(" ")).collect();
        findings(&(lines.join("\n") + "\n"))
    };
    assert_eq!(with("14 11 0.25 4 -2 1.5"), [""; 0]);
    assert_eq!(with("14 11 0.25 4 1.5"), ["E008@5"]);
    assert_eq!(with("14 11 0.25 7 4 -2 1.5"), ["E009@6"]);
}
