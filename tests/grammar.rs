//! The files in `grammar/` agree with the record table. `UPDATE_GRAMMAR=1 cargo test --test all grammar`
//! writes them anew.

mod reference;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Language};
use zpg::internals::features::tokens::{self, Role};
use zpg::internals::syntax::lexer::SEPARATORS;
use zpg::internals::syntax::table::{Family, Param, ParamKind, RECORD_TYPES, RecordType};

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
    for (name, language) in REFERENCES {
        let reference = fs::read_to_string(path(name)).unwrap();
        agrees(name, &reference::fill(&reference, language).unwrap());
    }
}

/// The reference in each language.
const REFERENCES: [(&str, Language); 2] = [
    ("reference.md", Language::English),
    ("reference.cs.md", Language::Czech),
];

#[test]
fn the_reference_has_every_record_type() {
    for (name, language) in REFERENCES {
        let reference = fs::read_to_string(path(name)).unwrap();
        for ty in RECORD_TYPES {
            let row = match language {
                Language::English => format!("| {} | `{}` |", ty.code, ty.keyword),
                Language::Czech => {
                    format!(
                        "| {} | {}, `{}` |",
                        ty.code,
                        language.name(ty.title),
                        ty.keyword
                    )
                }
            };
            assert!(reference.contains(&row), "{name}: {row}");
        }
    }
}

#[test]
fn the_scenes_in_the_reference_are_good() {
    for (name, _) in REFERENCES {
        let reference = fs::read_to_string(path(name)).unwrap();
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
}

#[test]
fn the_pages_of_the_codes_are_up_to_date() {
    for (name, language, head) in [
        (
            "diagnostics.md",
            Language::English,
            "# Diagnostics\n\nThe pages that `zpg explain` shows.\n",
        ),
        (
            "diagnostics.cs.md",
            Language::Czech,
            "# Nálezy\n\nStránky, které ukazuje `zpg explain`.\n",
        ),
    ] {
        let mut pages = head.to_owned();
        for code in Code::ALL {
            let page = code.explanation(language).replace("\n## ", "\n### ");
            let page = page.replacen("## ", "### ", 1);
            pages += &format!(
                "\n## {} {}\n\n{}\n",
                code.as_str(),
                code.name(),
                page.trim_end()
            );
        }
        agrees(name, &pages);
    }
}

#[test]
fn the_ebnf_is_up_to_date() {
    agrees("zpg.ebnf", &reference::ebnf());
}

#[test]
fn the_ebnf_defines_what_it_uses() {
    let ebnf = reference::ebnf();
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

/// A letter for what a parameter is, as the scanner of the tree-sitter grammar has it.
fn letter(ty: &RecordType, param: &Param) -> char {
    match tokens::of_param(ty, param) {
        _ if param.kind == ParamKind::Count => 'k',
        Role::Reference => 'r',
        Role::Colour => 'c',
        Role::Angle => 'a',
        Role::File => 'f',
        _ => 'n',
    }
}

#[test]
fn the_scanner_of_the_tree_sitter_grammar_is_up_to_date() {
    let mut table =
        "// Made from the record table by `UPDATE_GRAMMAR=1 cargo test --test all grammar`.\n\n\
                     static const struct RecordType RECORD_TYPES[] = {\n"
            .to_owned();
    for ty in RECORD_TYPES {
        let letters = |all: &[Param]| all.iter().map(|p| letter(ty, p)).collect::<String>();
        let group = |i: usize| ty.repeats.get(i).map_or(String::new(), |g| letters(g));
        let (params, optional) = (letters(ty.params), letters(ty.optional));
        let (first, second) = (group(0), group(1));
        let code = ty.code;
        table += &format!(
            "  {{{code}, \"{params}\", {{\"{first}\", \"{second}\"}}, \"{optional}\"}},\n"
        );
        assert!(ty.repeats.len() <= 2);
    }
    let list: Vec<String> = SEPARATORS
        .iter()
        .map(|&c| format!("0x{:X}", c as u32))
        .collect();
    let list: Vec<String> = list
        .chunks(14)
        .map(|row| format!("  {},\n", row.join(", ")))
        .collect();
    table +=
        "};\n\n// Signs that are read as white space.\nstatic const int32_t SEPARATORS[] = {\n";
    table += &list.concat();
    agrees("tree-sitter/src/types.h", &(table + "};\n"));
}

/// The characters of a class of a regular expression.
fn class(text: &str, before: &str) -> BTreeSet<char> {
    let (_, rest) = text.split_once(before).unwrap();
    let (class, _) = rest.split_once(']').unwrap();
    let mut parts = class.split("\\u");
    let mut all: BTreeSet<char> = parts.next().unwrap().chars().collect();
    for part in parts {
        let (code, plain) = part.split_at(4);
        all.extend(char::from_u32(u32::from_str_radix(code, 16).unwrap()));
        all.extend(plain.chars());
    }
    all
}

/// Editors' grammars have the lexer's separators.
#[test]
fn separators_are_the_same_everywhere() {
    let read =
        |name: &str| fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap();
    let expected: BTreeSet<char> = SEPARATORS.iter().copied().collect();
    assert_eq!(expected.len(), SEPARATORS.len());
    let grammar = read("grammar/tree-sitter/grammar.js");
    assert_eq!(class(&grammar, "separator: () => /["), expected);
    let grammar = read("grammar/tree-sitter/src/grammar.json");
    assert_eq!(
        class(&grammar.replace("\\\\", "\\"), "\"value\": \"[,"),
        &expected - &[','].into()
    );
    let textmate = read("editors/vscode/syntaxes/zpg.tmLanguage.json");
    assert_eq!(
        class(
            &textmate.replace("\\\\u", "\\u"),
            "\"separator\": {\n      \"match\": \"["
        ),
        expected
    );
    // What `tree-sitter generate` made of it: ranges of characters.
    let parser = read("grammar/tree-sitter/src/parser.c");
    let (_, ranges) = parser
        .split_once("sym_separator_character_set_1[] = {")
        .unwrap();
    let (ranges, rest) = ranges.split_once("};").unwrap();
    let code = |text: &str| -> char {
        let text = text.trim_matches([' ', '{', '}', ',', '\n']);
        match text.strip_prefix("0x") {
            Some(hex) => char::from_u32(u32::from_str_radix(hex, 16).unwrap()).unwrap(),
            None => text.trim_matches('\'').chars().next().unwrap_or(','),
        }
    };
    let ranges: Vec<(char, char)> = (ranges.split("},"))
        .filter_map(|range| range.split_once(", "))
        .map(|(from, to)| (code(from), code(to)))
        .collect();
    let all: BTreeSet<char> = ranges.iter().flat_map(|&(from, to)| from..=to).collect();
    assert_eq!(all, expected);
    assert!(rest.contains(&format!(
        "sym_separator_character_set_1, {}, lookahead",
        ranges.len()
    )));
}

/// The grammar of VS Code has a pattern for each family, and each pattern the types of that family.
#[test]
fn the_textmate_grammar_knows_all_types() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/editors/vscode/syntaxes/zpg.tmLanguage.json"
    );
    let grammar: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let patterns = grammar["repository"]["records"]["patterns"]
        .as_array()
        .unwrap();
    assert_eq!(patterns.len(), Family::ALL.len());
    for pattern in patterns {
        let name = pattern["comment"].as_str().unwrap();
        let text = pattern["match"].as_str().unwrap();
        let (_, list) = text.split_once("\\s+(").unwrap();
        let codes = list.split_once(')').unwrap().0.split('|');
        let codes: BTreeSet<i32> = codes.map(|c| c.parse().unwrap()).collect();
        let of_family = |family: Family| -> BTreeSet<i32> {
            let all = RECORD_TYPES.iter().filter(|t| t.family == family);
            all.map(|t| t.code).collect()
        };
        let family = Family::ALL.into_iter().find(|f| of_family(*f) == codes);
        let family = family.unwrap_or_else(|| panic!("{name} is no family"));
        assert!(
            format!("{family:?}").eq_ignore_ascii_case(name),
            "{family:?} {name}"
        );
    }
}

#[test]
fn queries_are_the_same_everywhere() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let read = |path: &str| fs::read_to_string(root.join(path)).unwrap();
    for name in ["highlights", "folds", "locals", "indents"] {
        let own = read(&format!("grammar/tree-sitter/queries/{name}.scm"));
        assert_eq!(own, read(&format!("editors/neovim/queries/zpg/{name}.scm")));
    }
    let own = read("grammar/tree-sitter/queries/highlights.scm");
    assert_eq!(own, read("editors/zed/languages/zpg/highlights.scm"));
}

/// The settings for editors can be read, and name the command.
#[test]
fn settings_of_editors_start_the_server() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("editors");
    let read = |path: &str| fs::read_to_string(root.join(path)).unwrap();
    let helix: toml::Table = toml::from_str(&read("helix/languages.toml")).unwrap();
    let server = &helix["language-server"]["zpg"];
    assert_eq!(server["command"].as_str(), Some("zpg"));
    assert_eq!(server["args"][0].as_str(), Some("lsp"));
    assert_eq!(
        helix["language"][0]["language-servers"][0].as_str(),
        Some("zpg")
    );
    let kate: serde_json::Value = serde_json::from_str(&read("kate/settings.json")).unwrap();
    assert_eq!(
        kate["servers"]["zpg"]["command"],
        serde_json::json!(["zpg", "lsp"])
    );
    let zed: toml::Table = toml::from_str(&read("zed/extension.toml")).unwrap();
    assert_eq!(
        zed["grammars"]["zpg"]["path"].as_str(),
        Some("grammar/tree-sitter")
    );
    let language: toml::Table = toml::from_str(&read("zed/languages/zpg/config.toml")).unwrap();
    assert_eq!(language["grammar"].as_str(), Some("zpg"));
    assert!(read("kakoune/zpg.kak").contains("command = \"zpg\""));
    assert!(read("emacs/zpg-mode.el").contains("(zpg-mode . (\"zpg\" \"lsp\"))"));
}
