//! All Czech texts keep to the glossary, `docs/glossary.cs.md`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::program::{text, zpg};
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use zpg::internals::diagnostics::Language;
use zpg::internals::syntax::table::RECORD_TYPES;
use zpg::internals::syntax::words;

const GLOSSARY: &str = include_str!("../docs/glossary.cs.md");

/// A term in English and Czech, and how words begin that are to be avoided.
struct Term {
    english: &'static str,
    czech: &'static str,
    avoided: Vec<&'static str>,
}

fn glossary() -> Vec<Term> {
    let rows = GLOSSARY.lines().filter(|line| line.starts_with("| "));
    let terms = rows.map(|row| {
        let cells: Vec<_> = row.split('|').map(str::trim).collect();
        let [_, english, czech, avoided, _] = cells[..] else {
            panic!("{row}");
        };
        let avoided = avoided.split(',').map(str::trim);
        Term {
            english,
            czech,
            avoided: avoided.filter(|word| !word.is_empty()).collect(),
        }
    });
    terms.filter(|term| term.english != "anglicky").collect()
}

/// All files with Czech texts.
fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["src", "docs", "grammar", "editors"].map(|folder| root.join(folder));
    let all = folders.into_iter().flat_map(ignore::Walk::new);
    let paths = all.map(|entry| entry.unwrap().into_path());
    let is_czech = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy();
        let ends = [".cs.ftl", ".cs.md", ".cs.json"];
        name == "cs.ftl" || ends.iter().any(|end| name.ends_with(end))
    };
    let is_glossary = |path: &PathBuf| path.ends_with("docs/glossary.cs.md");
    paths
        .filter(is_czech)
        .filter(|path| !is_glossary(path))
        .collect()
}

/// The words of a catalogue, without names and places.
fn catalogue(text: &str) -> String {
    let resource = fluent_syntax::parser::parse(text).expect("no error in the catalogue");
    let mut out = String::new();
    for entry in &resource.body {
        if let Entry::Message(message) = entry {
            let attributes = message.attributes.iter().map(|a| &a.value);
            for pattern in message.value.iter().chain(attributes) {
                add(pattern, &mut out);
                out.push('\n');
            }
        }
    }
    out
}

fn add(pattern: &Pattern<&str>, out: &mut String) {
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => out.push_str(value),
            PatternElement::Placeable {
                expression: Expression::Select { variants, .. },
            } => {
                for variant in variants {
                    add(&variant.value, out);
                    out.push('\n');
                }
            }
            PatternElement::Placeable {
                expression: Expression::Inline(InlineExpression::StringLiteral { value }),
            } => out.push_str(value),
            PatternElement::Placeable { .. } => out.push('…'),
        }
    }
}

/// A text without code, in lower case, with single spaces.
fn prose(text: &str) -> String {
    let fences: String = text.split("```").step_by(2).collect();
    let code: Vec<&str> = fences.split('`').step_by(2).collect();
    let words = code.join("…").to_lowercase();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Where a word begins with this, with what stands around it.
fn found<'a>(prose: &'a str, beginning: &str) -> Option<&'a str> {
    let word = |c: char| c.is_alphanumeric();
    let (at, _) = prose.match_indices(beginning).find(|(at, _)| {
        let before = prose[..*at].chars().next_back();
        !before.is_some_and(|c| word(c) || c == '-')
    })?;
    let start = prose[..at].char_indices().rev().nth(20).map_or(0, |c| c.0);
    let end = prose[at..]
        .char_indices()
        .nth(40)
        .map_or(prose.len(), |c| at + c.0);
    Some(&prose[start..end])
}

#[test]
fn no_text_has_a_word_that_is_avoided() {
    let mut wrong = String::new();
    let (files, terms) = (files(), glossary());
    assert!(files.len() > 100);
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        let text = match path.extension().is_some_and(|e| e == "ftl") {
            true => catalogue(&text),
            false => text,
        };
        let prose = prose(&text);
        for term in &terms {
            for avoided in &term.avoided {
                if let Some(place) = found(&prose, avoided) {
                    wrong += &format!("{}: …{place}… say {}\n", path.display(), term.czech);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The names that lead to a type, by its number: the list at the end of the glossary.
fn names() -> Vec<(i32, &'static str)> {
    let (_, list) = GLOSSARY.split_once("\n- ").expect("there is a list");
    let lines = list.split("\n- ").flat_map(|line| {
        let (code, names) = line.split_once(':').expect("a number and names");
        let code: i32 = code.parse().expect("a number");
        names.split(',').map(move |name| (code, name.trim()))
    });
    lines.collect()
}

/// What the glossary lists leads to its type, and whatever leads to a type is listed.
#[test]
fn names_lead_to_their_types() {
    let names = names();
    assert!(names.len() > 100);
    for (code, name) in &names {
        let lines: Vec<&str> = name.split_whitespace().collect();
        let name = lines.join(" ");
        for name in [name.to_uppercase(), words::plain(&name), name] {
            let first = words::named(&name).first().map(|ty| ty.code);
            assert_eq!(first, Some(*code), "{name}");
        }
    }
    let listed: BTreeSet<String> = names.iter().map(|n| words::plain(n.1)).collect();
    let known: BTreeSet<String> = words::all().map(|n| n.0.to_owned()).collect();
    let missing: Vec<_> = known.difference(&listed).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// What people ask for: types as a course calls them, and what they are for.
#[test]
fn names_of_the_course() {
    for (name, code) in [
        ("posuv", -1),
        ("anuloid", 14),
        ("krychle", 12),
        ("kamera stereo", -503),
        ("textura obrazová", -301),
        ("válcová plocha parabolická", 18),
        ("valcova plocha parabolicka", 18),
        ("glass", -201),
        ("mirror", -201),
        ("ior", -203),
        ("look at", -501),
        ("lathe", 1),
        ("prism", -102),
        ("material", -201),
        ("light", -402),
        ("transparent", -201),
        ("shadow", -402),
        ("cylinder", 1),
        ("válec", 1),
    ] {
        let first = words::named(name).first().map(|ty| ty.code);
        assert_eq!(first, Some(code), "{name}");
    }
}

/// The names of record types are those of the glossary.
#[test]
fn names_are_those_of_the_glossary() {
    let terms = glossary();
    for ty in RECORD_TYPES {
        let term = terms.iter().find(|t| t.english == ty.title);
        let term = term.unwrap_or_else(|| panic!("{} is not in the glossary", ty.title));
        assert_eq!(Language::Czech.name(ty.title), term.czech);
    }
}

#[test]
fn words_are_found_where_they_begin() {
    assert!(found("vnitřní poloprostoru", "poloprost").is_some());
    assert!(found("nepovolit", "povol").is_none());
    assert!(found("volba --threads", "threads").is_none());
    assert_eq!(prose("a `default`\nb\n```\nlampa\n```\n"), "a … b");
}

/// Comments in examples of Czech pages are Czech: none with words in it is that of the English page.
#[test]
fn comments_of_czech_examples_are_czech() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let comments = |path: &Path| -> Vec<String> {
        let page = fs::read_to_string(path).unwrap();
        let mut all = Vec::new();
        for block in page.split("```zpg").skip(1) {
            let block = block.split("```").next().unwrap();
            all.extend(
                block
                    .split('#')
                    .skip(1)
                    .step_by(2)
                    .map(|c| c.trim().to_owned()),
            );
        }
        all
    };
    let mut pairs = 0;
    let walk = ignore::WalkBuilder::new(root).build();
    for czech in walk.map(|entry| entry.unwrap().into_path()) {
        let name = czech.to_string_lossy();
        let Some(stem) = name.strip_suffix(".cs.md") else {
            continue;
        };
        let english = Path::new(stem).with_extension("md");
        if !english.exists() {
            continue;
        }
        pairs += 1;
        let own = comments(&english);
        for comment in comments(&czech) {
            let words = comment.split_whitespace();
            let has_words = words
                .filter(|w| w.len() > 2 && w.chars().all(|c| c.is_ascii_lowercase()))
                .count()
                > 0;
            let is_setting = comment.starts_with("zpg:");
            assert!(
                !has_words || is_setting || !own.contains(&comment),
                "{name}: # {comment} #"
            );
        }
    }
    assert!(pairs > 50, "{pairs}");
}

/// Several words need no quotes.
#[test]
fn topics_of_several_words() {
    let page = |arguments: &[&str]| {
        let out = zpg(Path::new("."), &[&["explain"], arguments].concat());
        assert_eq!(out.status.code(), Some(0), "{arguments:?}");
        text(&out.stdout)
    };
    assert_eq!(page(&["point", "light"]), page(&["point light"]));
    assert_eq!(page(&["point", "light"]), page(&["-402"]));
    // Under the word that was looked for.
    let (named, coded) = (page(&["textura", "obrazová"]), page(&["-301"]));
    assert!(named.starts_with("# textura obrazová: image texture (-301)\n"));
    assert_eq!(
        named.split_once('\n').unwrap().1,
        coded.split_once('\n').unwrap().1
    );
}
