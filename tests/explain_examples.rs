//! The examples on the pages of `zpg explain` are true: the bad scene has just that finding, the
//! good one has none.

use std::path::Path;

use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Language, SourceFile};
use zpg::internals::translate::json;

/// The ```` ```zpg ```` fences of a page, or those of JSON.
fn examples(code: Code) -> Vec<&'static str> {
    let fence = match code {
        Code::E015 => "```json\n",
        _ => "```zpg\n",
    };
    (code.explanation(Language::English).split(fence))
        .skip(1)
        .filter_map(|rest| rest.split_once("```"))
        .map(|(scene, _)| scene)
        .collect()
}

/// A folder for the examples, with the picture that they name.
fn folder() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let wood = image::RgbImage::from_pixel(2, 2, image::Rgb([120, 80, 40]));
    wood.save(dir.path().join("wood.png")).unwrap();
    dir
}

/// A text in Windows-1250, which has these letters where Latin 1 has them.
fn windows_1250(text: &str) -> Vec<u8> {
    let byte = |c: char| match c {
        '\0'..='\x7f' | 'á' | 'é' | 'í' | 'ó' | 'ú' | 'ý' => c as u32 as u8,
        _ => panic!("another letter: {c}"),
    };
    text.chars().map(byte).collect()
}

/// What is found in a scene in a folder, a line each.
fn findings(folder: &Path, code: Code, scene: Vec<u8>) -> Vec<(Code, String)> {
    let path = folder.join("scene.zpg");
    std::fs::write(&path, &scene).unwrap();
    let path = path.to_str().unwrap();
    let loaded = match code {
        Code::E015 => json::analyse(SourceFile::new(path, scene)),
        _ => Analysis::new(path, scene),
    };
    loaded
        .findings()
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
    let folder = folder();
    for &code in Code::ALL {
        let scenes = examples(code);
        let &[bad, good] = scenes.as_slice() else {
            wrong += &format!("{}: {} examples, not two\n", code.as_str(), scenes.len());
            continue;
        };
        // Its page says that the scene is saved so; the page itself is UTF-8.
        let bytes = match code {
            Code::N601 => windows_1250(bad),
            Code::N604 => bad.encode_utf16().flat_map(u16::to_le_bytes).collect(),
            _ => bad.into(),
        };
        let found = findings(folder.path(), code, bytes);
        if found.is_empty() || found.iter().any(|&(c, _)| c != code) {
            wrong += &format!("{}: the bad scene has {found:#?}\n", code.as_str());
        }
        let mut found = findings(folder.path(), code, good.into());
        // The good JSON is one line; it has neither camera nor light.
        found.retain(|&(c, _)| code != Code::E015 || !matches!(c, Code::N602 | Code::N603));
        if !found.is_empty() {
            wrong += &format!("{}: the good scene has {found:#?}\n", code.as_str());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The fenced blocks of a page, whole.
fn fences(page: &str) -> Vec<&str> {
    page.split("```").skip(1).step_by(2).collect()
}

/// A block without its words: comments are in the language of their page.
fn without_words(block: &str) -> Vec<Vec<&str>> {
    let is_word = |word: &&str| word.chars().any(char::is_alphabetic);
    let lines = block.lines().map(|line| line.split_whitespace());
    lines
        .map(|words| words.filter(|w| !is_word(w)).collect())
        .collect()
}

#[test]
fn czech_pages_have_the_same_examples() {
    for &code in Code::ALL {
        let [english, czech] = [Language::English, Language::Czech].map(|l| {
            let fences = fences(code.explanation(l)).into_iter();
            fences.map(without_words).collect::<Vec<_>>()
        });
        assert_eq!(english, czech, "{}", code.as_str());
    }
}

#[test]
fn every_czech_page_has_its_headings() {
    for &code in Code::ALL {
        let [english, czech] = [Language::English, Language::Czech].map(|l| {
            let page = code.explanation(l).lines();
            let headings = page.filter(|line| line.starts_with("## "));
            headings.collect::<Vec<_>>()
        });
        let all = [
            ("## What it does", "## Co to hlásí"),
            ("## Why is this bad", "## Proč je to špatně"),
            ("## Example", "## Příklad"),
            ("## Fix", "## Oprava"),
        ];
        let translated = |heading: &&str| all.iter().find(|h| h.0 == *heading).map(|h| h.1);
        let expected: Vec<_> = english.iter().filter_map(translated).collect();
        assert_eq!(czech, expected, "{}", code.as_str());
    }
}

#[test]
fn every_page_has_its_headings() {
    for &code in Code::ALL {
        let page = code.explanation(Language::English);
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
