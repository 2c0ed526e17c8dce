//! Findings in the forms that services for continuous integration read: GitLab's Code Quality and JUnit XML.

use std::collections::BTreeSet;

use quick_xml::events::{BytesStart, Event};
use serde_json::Value;

use crate::support::program::{self, folder, text};

/// A scene without findings.
const GOOD: &str = "2 11 0 0 0 1\n1 9999 2 0\n";
/// Two equal mistakes on equal lines: 7 is not defined.
const BAD: &str = "2 11 0 0 0 1\n3 -6 2 7\n3 -6 2 7\n1 9999 2 0\n";

fn check(files: &[(&str, &str)], format: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let dir = folder(files);
    let run = program::zpg(
        dir.path(),
        &[&["check", "--format", format], arguments].concat(),
    );
    (run.status.code(), text(&run.stdout))
}

/// The findings of the same files, as `--format json` has them: file, code, line and column.
fn found(files: &[(&str, &str)]) -> Vec<(String, String, u64, u64)> {
    let (_, json) = check(files, "json", &["."]);
    let json: Value = serde_json::from_str(&json).unwrap();
    let mut all = Vec::new();
    for file in json["files"].as_array().unwrap() {
        let path = file["path"].as_str().unwrap();
        for d in file["diagnostics"].as_array().unwrap() {
            let place = &d["span"]["start"];
            let code = d["code"].as_str().unwrap().to_owned();
            let (line, column) = (place["line"].as_u64(), place["column"].as_u64());
            let path = path.trim_start_matches("./").to_owned();
            all.push((path, code, line.unwrap(), column.unwrap()));
        }
    }
    all
}

/// What <https://docs.gitlab.com/ci/testing/code_quality> asks of a report.
#[test]
fn gitlab_gets_a_list_of_issues() {
    let files = [("a.zpg", BAD), ("sub/b & c.zpg", BAD)];
    let (status, report) = check(&files, "gitlab", &["."]);
    assert_eq!(status, Some(1));
    let report: Value = serde_json::from_str(&report).unwrap();
    let issues = report.as_array().unwrap();
    let mut prints = BTreeSet::new();
    let mut said = Vec::new();
    for issue in issues {
        let severity = issue["severity"].as_str().unwrap();
        assert!(["info", "minor", "major", "critical", "blocker"].contains(&severity));
        let code = issue["check_name"].as_str().unwrap();
        let description = issue["description"].as_str().unwrap();
        assert!(description.starts_with(code) && !description.contains('\n'));
        assert!(prints.insert(issue["fingerprint"].as_str().unwrap()));
        let begin = &issue["location"]["positions"]["begin"];
        let path = issue["location"]["path"].as_str().unwrap().to_owned();
        let (line, column) = (begin["line"].as_u64(), begin["column"].as_u64());
        said.push((path, code.to_owned(), line.unwrap(), column.unwrap()));
    }
    assert!(said.len() >= 4, "{said:?}");
    assert_eq!(said, found(&files));
}

/// GitLab takes a finding with another fingerprint for a new one.
#[test]
fn fingerprints_stay_where_findings_move() {
    let prints = |scene: &str| {
        let (_, report) = check(&[("a.zpg", scene)], "gitlab", &["."]);
        let report: Value = serde_json::from_str(&report).unwrap();
        let issues = report.as_array().unwrap().iter();
        let prints = issues.map(|i| i["fingerprint"].to_string());
        prints.collect::<BTreeSet<_>>()
    };
    let before = prints(BAD);
    assert_eq!(before, prints(&format!("\n\n{BAD}")));
    assert_ne!(before, prints(&BAD.replace("2 7", "2 8")));
}

#[test]
fn nothing_found_is_an_empty_list() {
    let (status, report) = check(&[("a.zpg", GOOD)], "gitlab", &["--ignore", "all", "."]);
    assert_eq!((status, report.as_str()), (Some(0), "[]\n"));
}

/// An element's attributes.
fn attribute(element: &BytesStart, name: &str) -> String {
    let found = element.try_get_attribute(name).unwrap();
    let found = found.unwrap_or_else(|| panic!("no {name} in {element:?}"));
    found
        .normalized_value(quick_xml::XmlVersion::Explicit1_0)
        .unwrap()
        .into_owned()
}

#[test]
fn junit_gets_a_test_for_each_finding() {
    let files = [
        ("a.zpg", BAD),
        ("good.zpg", GOOD),
        ("sub/b & \"c\".zpg", BAD),
    ];
    let (status, report) = check(&files, "junit", &["."]);
    assert_eq!(status, Some(1));
    let mut reader = quick_xml::Reader::from_str(&report);
    reader.config_mut().check_end_names = true;
    let (mut said, mut counted, mut texts) = (Vec::new(), (0, 0), 0);
    let mut totals = None;
    let mut suites = Vec::new();
    loop {
        let event = reader.read_event().unwrap();
        let element = match &event {
            Event::Start(element) | Event::Empty(element) => element,
            Event::Eof => break,
            _ => continue,
        };
        let number = |name| attribute(element, name).parse::<usize>().unwrap();
        match element.name().as_ref() {
            "testsuites" => totals = Some((number("tests"), number("failures"))),
            "testsuite" => {
                counted.0 += number("tests");
                counted.1 += number("failures");
                suites.push(attribute(element, "name"));
            }
            "testcase" if attribute(element, "name") == "no findings" => {}
            "testcase" => {
                let code = attribute(element, "name");
                let code = code.split(' ').next().unwrap().to_owned();
                let place = (number("line") as u64, number("column") as u64);
                said.push((attribute(element, "file"), code, place.0, place.1));
            }
            "failure" => {
                let severity = attribute(element, "type");
                assert!(["error", "warning", "note", "style"].contains(&severity.as_str()));
                assert!(!attribute(element, "message").is_empty());
                texts += 1;
            }
            other => panic!("{other}"),
        }
    }
    assert_eq!(suites, ["a.zpg", "good.zpg", "sub/b & \"c\".zpg"]);
    assert_eq!(totals, Some(counted));
    assert_eq!((said.len(), texts), (counted.1, counted.1));
    assert_eq!(said, found(&files));
}

/// Names of files and texts of scenes are foreign.
#[test]
fn nothing_foreign_breaks_the_xml() {
    let files = [(
        "a]]><x>&\u{1}\u{fffe}.zpg",
        "2 11 <&\u{1}]]> 0 0 1\n1 9999 2 0\n",
    )];
    let (_, report) = check(&files, "junit", &["."]);
    let mut reader = quick_xml::Reader::from_str(&report);
    while reader.read_event().unwrap() != Event::Eof {}
    assert!(
        !report.contains("<x>") && !report.contains(['\u{1}', '\u{fffe}']),
        "{report}"
    );
}
