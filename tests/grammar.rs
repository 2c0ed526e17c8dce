//! The files in `grammar/` agree with the record table. `UPDATE_GRAMMAR=1 cargo test --test all grammar`
//! writes them anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use zpg::analysis::Analysis;
use zpg::diagnostics::Code;
use zpg::syntax::grammar;
use zpg::syntax::table::RECORD_TYPES;

fn path(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "grammar", name]
        .iter()
        .collect()
}

#[track_caller]
fn agrees(name: &str, expected: &str) {
    let path = path(name);
    if std::env::var_os("UPDATE_GRAMMAR").is_some() {
        fs::write(&path, expected).unwrap();
    }
    let actual = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        actual == expected,
        "grammar/{name} does not agree with the record table; run the tests with UPDATE_GRAMMAR=1"
    );
}

#[test]
fn the_reference_is_up_to_date() {
    let reference = fs::read_to_string(path("reference.md")).unwrap();
    agrees("reference.md", &grammar::fill(&reference).unwrap());
}

#[test]
fn the_reference_has_every_record_type() {
    let reference = fs::read_to_string(path("reference.md")).unwrap();
    for ty in RECORD_TYPES {
        let row = format!("| {} | `{}` |", ty.code, ty.keyword);
        assert!(reference.contains(&row), "{row}");
    }
}

#[test]
fn the_scenes_in_the_reference_are_good() {
    let reference = fs::read_to_string(path("reference.md")).unwrap();
    let scenes: Vec<_> = reference
        .split("```zpg\n")
        .skip(1)
        .filter_map(|rest| rest.split_once("```"))
        .collect();
    assert!(!scenes.is_empty());
    for (scene, _) in scenes {
        let loaded = Analysis::new("scene.zpg", scene.into());
        assert!(loaded.findings().is_empty(), "{:#?}", loaded.findings());
    }
}

#[test]
fn the_pages_of_the_codes_are_up_to_date() {
    let mut pages = "# Diagnostics\n\nThe pages that `zpg explain` shows.\n".to_owned();
    for code in Code::ALL {
        let page = code.explanation().replace("\n## ", "\n### ");
        let page = page.replacen("## ", "### ", 1);
        pages += &format!(
            "\n## {} {}\n\n{}\n",
            code.as_str(),
            code.name(),
            page.trim_end()
        );
    }
    agrees("diagnostics.md", &pages);
}

#[test]
fn the_ebnf_is_up_to_date() {
    agrees("zpg.ebnf", &grammar::ebnf());
}

#[test]
fn the_ebnf_defines_what_it_uses() {
    let ebnf = grammar::ebnf();
    // Without comments, special sequences and terminals.
    let mut bare = ebnf.clone();
    for (open, close) in [("(*", "*)"), ("'\"'", ""), ("? ", " ?"), ("\"", "\"")] {
        while let Some(start) = bare.find(open) {
            let from = start + open.len();
            let end = bare[from..]
                .find(close)
                .map_or(bare.len(), |i| from + i + close.len());
            bare.replace_range(start..end, " ");
        }
    }
    let is_name = |c: char| c.is_ascii_alphabetic() || c == '_';
    let words: BTreeSet<&str> = bare
        .split(|c| !is_name(c))
        .filter(|w| !w.is_empty())
        .collect();
    for word in words {
        assert!(
            ebnf.contains(&format!("{word} =")) || word == "record",
            "{word} is not defined"
        );
    }
}
