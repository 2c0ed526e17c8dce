//! The catalogues of messages: none is missing in any language, and each is used.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::Path;

use fluent_syntax::ast::{
    Attribute, CallArguments, Entry, Expression, InlineExpression, Pattern, PatternElement,
};
use zpg::internals::diagnostics::{Code, Language, Value};
use zpg::internals::syntax::table::{Effect, Family, Kind, ParamKind, RECORD_TYPES};
use zpg::internals::translate::Feature;

/// All messages of a language: those of the diagnostics and those in the folders of rules.
fn messages_of(own: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files: Vec<_> = (ignore::Walk::new(root).map(|e| e.unwrap().into_path()))
        .filter(|path| {
            // Some files are Czech alone: English has their texts in the source.
            let path = path.to_string_lossy();
            let other = |tag| path.replace(&format!("{own}.ftl"), &format!("{tag}.ftl"));
            path.ends_with(&format!("{own}.ftl"))
                && ["en", "cs"]
                    .iter()
                    .all(|tag| Path::new(&other(tag)).exists())
        })
        .collect();
    files.sort();
    let texts = files
        .iter()
        .map(|path| std::fs::read_to_string(path).unwrap());
    texts.collect()
}

const CZECH_TERMS: &str = concat!(
    include_str!("../src/diagnostics/messages/terms.cs.ftl"),
    include_str!("../src/diagnostics/messages/phrases.cs.ftl")
);

/// Messages and, as `message.attribute`, their attributes; with the places of each.
type Catalogue = BTreeMap<String, BTreeSet<String>>;

fn catalogue(text: &str) -> Catalogue {
    let resource = fluent_syntax::parser::parse(text).expect("no error in the catalogue");
    let mut all = Catalogue::new();
    let mut add = |name: String, pattern: &Pattern<&str>| {
        let mut places = BTreeSet::new();
        collect(pattern, &mut places);
        let before = all.insert(name.clone(), places);
        assert!(before.is_none(), "{name} stands there twice");
    };
    for entry in &resource.body {
        match entry {
            Entry::Message(m) => {
                let id = m.id.name;
                add(
                    id.to_owned(),
                    m.value.as_ref().expect("a message says something"),
                );
                for Attribute { id: name, value } in &m.attributes {
                    add(format!("{id}.{}", name.name), value);
                }
            }
            Entry::Term(t) => panic!("-{}: names of the language are messages, term-…", t.id.name),
            Entry::Junk { content } => panic!("{content}"),
            _ => {}
        }
    }
    all
}

/// The places of a pattern, and the messages it refers to as `message` or `message.attribute`.
fn collect(pattern: &Pattern<&str>, places: &mut BTreeSet<String>) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            expression_places(expression, places);
        }
    }
}

fn expression_places(expression: &Expression<&str>, places: &mut BTreeSet<String>) {
    match expression {
        Expression::Inline(inline) => inline_places(inline, places),
        Expression::Select { selector, variants } => {
            inline_places(selector, places);
            for v in variants {
                collect(&v.value, places);
            }
        }
    }
}

fn inline_places(inline: &InlineExpression<&str>, places: &mut BTreeSet<String>) {
    match inline {
        InlineExpression::VariableReference { id } => {
            places.insert(format!("${}", id.name));
        }
        InlineExpression::MessageReference { id, attribute } => {
            let attribute = attribute.as_ref().map(|a| format!(".{}", a.name));
            places.insert(id.name.to_owned() + &attribute.unwrap_or_default());
        }
        InlineExpression::Placeable { expression } => expression_places(expression, places),
        InlineExpression::FunctionReference {
            arguments: CallArguments { .. },
            id,
        } => panic!("no function {} is known", id.name),
        _ => {}
    }
}

/// The places of a message, those of the messages it refers to included.
fn all_places(catalogue: &Catalogue, name: &str) -> BTreeSet<String> {
    let mut places = BTreeSet::new();
    for place in &catalogue[name] {
        match place.strip_prefix('$') {
            Some(_) => {
                places.insert(place.clone());
            }
            None => {
                assert!(catalogue.contains_key(place), "{name} refers to {place}");
                places.extend(all_places(catalogue, place));
            }
        }
    }
    places
}

#[test]
fn every_message_is_there_in_every_language() {
    let (english, czech) = (catalogue(&messages_of("en")), catalogue(&messages_of("cs")));
    let names = |c: &Catalogue| c.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&english), names(&czech));
    let base = |place: &str| {
        let mut place = place.to_owned();
        for form in ["-a", "-capital", "-gen", "-acc"] {
            if let Some(name) = place.strip_suffix(form) {
                place = name.to_owned();
            }
        }
        place
    };
    for name in english.keys() {
        let places = |c: &Catalogue| {
            let all = all_places(c, name);
            all.iter().map(|p| base(p)).collect::<BTreeSet<_>>()
        };
        let (en, cs) = (places(&english), places(&czech));
        // What one language says in other words need not name everything, but nothing unknown.
        assert!(
            cs.is_subset(&en),
            "{name}: {cs:?} in Czech, {en:?} in English"
        );
    }
}

#[test]
fn every_name_of_the_language_is_translated() {
    let terms = catalogue(CZECH_TERMS);
    assert!(
        terms.values().all(BTreeSet::is_empty),
        "terms have no places"
    );
    let mut names: BTreeSet<&'static str> = BTreeSet::new();
    for ty in RECORD_TYPES {
        names.insert(ty.title);
        let params = ty.params.iter().chain(ty.optional);
        for p in params.chain(ty.repeats.iter().copied().flatten()) {
            names.insert(p.doc);
            if let ParamKind::Reference { kinds, .. } = p.kind {
                names.extend(kinds.iter().map(|k| k.name()));
            }
        }
        match ty.effect {
            Effect::Defines(kind) => names.insert(kind.name()),
            Effect::Changes(_) | Effect::DefinesOrChanges(..) => false,
        };
    }
    names.insert(Kind::Undefined.name());
    names.extend(Family::ALL.map(Family::title));
    names.extend(Feature::all().map(Feature::name));
    for source in sources() {
        for opening in [
            "Value::Term(",
            "Complaint::term(",
            "Fidelity::approximate(",
            "Verdict::exact(",
            "Verdict::approximate(",
            "Verdict::dropped(",
            "report.state(",
            "report.count(",
            "ProgramError::Unexpected(",
            "language.name(",
        ] {
            names.extend(first_arguments(source, opening));
        }
    }
    for source in [
        include_str!("../src/trace/plan/notes.rs"),
        include_str!("../src/trace/plan/mod.rs"),
    ] {
        names.extend(source.split('"').skip(1).step_by(2));
    }
    names.remove("");
    let id = |name: &&str| {
        let words = name.split(|c: char| !c.is_ascii_alphanumeric());
        let words = words.filter(|w| !w.is_empty());
        words.fold("term".to_owned(), |id, w| id + "-" + &w.to_lowercase())
    };
    let missing: Vec<_> = (names.iter())
        .filter(|name| !terms.contains_key(&id(name)))
        .collect();
    assert!(missing.is_empty(), "not translated: {missing:#?}");
}

/// The program's own text, without its tests.
fn sources() -> Vec<&'static str> {
    fn walk(folder: &Path, out: &mut Vec<&'static str>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, out);
            } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                let code = text
                    .split("#[cfg(test)]\nmod tests {")
                    .next()
                    .unwrap_or_default();
                out.push(code.to_owned().leak());
            }
        }
    }
    let mut all = Vec::new();
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut all);
    all
}

/// The texts that calls of a function begin with, everywhere in a source.
fn first_arguments(source: &'static str, opening: &str) -> Vec<&'static str> {
    let calls = source.split(opening).skip(1);
    let texts = calls.filter_map(|rest| rest.trim_start().strip_prefix('"')?.split('"').next());
    texts.collect()
}

/// What a record type means stands in the table, and in Czech by its keyword.
#[test]
fn every_summary_is_translated() {
    let text = include_str!("../src/diagnostics/messages/summaries.cs.ftl");
    let there: BTreeSet<String> = catalogue(text).into_keys().collect();
    let keyword = |t: &zpg::internals::syntax::table::RecordType| format!("summary-{}", t.keyword);
    assert_eq!(there, RECORD_TYPES.iter().map(keyword).collect());
}

#[test]
fn every_message_is_used() {
    let sources = sources();
    let all = sources.concat();
    let english = catalogue(&messages_of("en"));
    // What stands between two quotation marks, and what follows `Code::`.
    let literals: HashSet<&str> = all.split('"').collect();
    let codes: HashSet<&str> = (all.split("Code::").skip(1))
        .filter_map(|rest| rest.get(..4))
        .collect();
    let literal = |name: &str| literals.contains(name);
    let referred: BTreeSet<&String> = english.values().flatten().collect();
    for name in english.keys() {
        let (message, attribute) = name.split_once('.').unwrap_or((name, ""));
        let (code, case) = message.split_once('-').unwrap_or((message, ""));
        let used = match (Code::parse(code).filter(|c| c.as_str() == code), attribute) {
            (_, "label" | "note" | "help") => true,
            (Some(_), "") => codes.contains(code) && (case.is_empty() || literal(case)),
            (_, "") => literal(message),
            (_, attribute) => literal(attribute),
        };
        assert!(used || referred.contains(name), "{name} is never said");
    }
    for code in Code::ALL {
        let own = |name: &&String| name.split(['-', '.']).next() == Some(code.as_str());
        assert!(
            english.keys().any(|n| own(&n)),
            "{} says nothing",
            code.as_str()
        );
    }
}

#[test]
fn a_message_in_both_languages() {
    let values = [
        ("first", Value::Term("sphere")),
        ("last", Value::Term("box")),
    ];
    assert_eq!(Language::English.say("list-or", &values), "sphere or box");
    assert_eq!(Language::Czech.say("list-or", &values), "koule nebo kvádr");
    // Text of the user's stays what it is, whatever it looks like.
    let foreign = [("first", "{ $last }".into()), ("last", "{\"".into())];
    assert_eq!(Language::Czech.say("list-and", &foreign), "{ $last } a {\"");
}

/// What is counted in messages.
const COUNTED: &str = "pixels rays records findings files parts shapes spheres triangles solids errors warnings notes \
                       settings samples places points tiles numbers cameras lights faces cores objects lines";

/// A number before a noun in the plural may be 1: "1 pixels". Where it may be, the message has a form for each. These
/// numbers are sizes of pictures, limits, or numbers with a fraction.
const NEVER_ONE: [&str; 20] = [
    "$width",
    "$height",
    "$side",
    "$max",
    "$most",
    "$size",
    "$needed",
    "$text",
    "$parts",
    "$error",
    "$goal",
    "$ulps",
    "$largest",
    "$percent",
    "$first-id",
    "$second-id",
    "$solid-id",
    "$other-id",
    "$operand-id",
    "$id",
];

#[test]
fn counts_stand_before_the_right_form() {
    let text = messages_of("en");
    let mut wrong = Vec::new();
    for line in text.lines() {
        let is_form = line.trim_start().starts_with(['[', '*']);
        let parts: Vec<&str> = line.split("{ ").collect();
        for part in parts.iter().skip(1).filter(|_| !is_form) {
            let Some((name, rest)) = part.split_once(" }") else {
                continue;
            };
            let noun = |word: &str| {
                COUNTED
                    .split(' ')
                    .any(|c| c == word.trim_end_matches([',', '.', ';', ':']))
            };
            let words: Vec<&str> = rest.split(' ').skip(1).take(2).collect();
            // A pixel by pixel is none.
            let is_plural =
                rest.starts_with(' ') && words.iter().any(|w| noun(w)) && !words.contains(&"of");
            if name.starts_with('$') && is_plural && !NEVER_ONE.contains(&name) {
                wrong.push(line);
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn one_is_one_in_both_languages() {
    let one = [("pixels", Value::Count(1))];
    let four = [("pixels", Value::Count(4))];
    let english = |values: &[_]| Language::English.say("crosscheck-povray-on", values);
    assert_eq!(english(&one), "1 pixel differs");
    assert_eq!(english(&four), "4 pixels differ");
    let expected = |n| {
        let values = [("expected", Value::Count(n)), ("found", "7".into())];
        Language::Czech.say("wrong-count", &values)
    };
    assert_eq!(expected(3), "očekávají se 3 čísla, nalezeno jich je 7");
    assert_eq!(expected(6), "očekává se 6 čísel, nalezeno jich je 7");
    let left = |n| Language::Czech.say("accuracy-more-rows", &[("left", Value::Count(n))]);
    assert!(left(1).starts_with("1 další vyzkoušené nastavení je"));
    assert!(left(3).starts_with("3 další vyzkoušená nastavení jsou"));
    assert!(left(5).starts_with("5 dalších vyzkoušených nastavení je"));
}
