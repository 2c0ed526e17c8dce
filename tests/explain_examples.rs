//! The examples on the pages of `zpg explain` are true: the bad scene has just that finding, the
//! good one has none.

use zpg::commands::Loaded;
use zpg::diagnostics::{Code, Language};

/// Codes that no scene in a text can show, and why.
const NOT_SHOWN: &[(Code, &str)] = &[
    (Code::E210, "it depends on the files beside the scene"),
    (Code::N601, "the page is UTF-8 itself"),
];

/// The ```` ```zpg ```` fences of a page.
fn examples(page: &str) -> Vec<&str> {
    page.split("```zpg\n")
        .skip(1)
        .filter_map(|rest| rest.split_once("```"))
        .map(|(scene, _)| scene)
        .collect()
}

/// What is found in a scene, a line each.
fn findings(scene: &str) -> Vec<(Code, String)> {
    let loaded = Loaded::new("scene.zpg", scene.into());
    loaded
        .diagnostics
        .iter()
        .map(|d| {
            let place = loaded.source.position(d.span.start);
            let severity = d.severity.as_str();
            let line = format!(
                "line {}: {} {severity}: {}",
                place.line,
                d.code.as_str(),
                d.wording(Language::English).message
            );
            // It is asserted there that no word is missing.
            d.wording(Language::Czech);
            (d.code, line)
        })
        .collect()
}

#[test]
fn examples_are_true() {
    let mut wrong = String::new();
    for &code in Code::ALL {
        if NOT_SHOWN.iter().any(|&(c, _)| c == code) {
            continue;
        }
        let scenes = examples(code.explanation());
        let &[bad, good] = scenes.as_slice() else {
            wrong += &format!("{}: {} examples, not two\n", code.as_str(), scenes.len());
            continue;
        };
        let found = findings(bad);
        if found.is_empty() || found.iter().any(|&(c, _)| c != code) {
            wrong += &format!("{}: the bad scene has {found:#?}\n", code.as_str());
        }
        let found = findings(good);
        if !found.is_empty() {
            wrong += &format!("{}: the good scene has {found:#?}\n", code.as_str());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn every_page_has_its_headings() {
    for &code in Code::ALL {
        let page = code.explanation();
        let mut headings = page.lines().filter(|l| l.starts_with("## "));
        assert_eq!(
            headings.next(),
            Some("## What it does"),
            "{}",
            code.as_str()
        );
        assert_eq!(
            headings.next(),
            Some("## Why is this bad"),
            "{}",
            code.as_str()
        );
        assert_eq!(headings.next(), Some("## Example"), "{}", code.as_str());
        assert!(
            matches!(headings.next(), None | Some("## Fix")),
            "{}",
            code.as_str()
        );
        assert_eq!(headings.next(), None, "{}", code.as_str());
    }
}
