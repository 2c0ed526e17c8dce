//! What the formatter never does, over generated scenes and all scenes of the repository: change what
//! a scene means, lose or swap comments, add a finding or lose one, say something else the second time.
//!
//! `FORMAT_CASES=100000 cargo test --test all formatting` takes as many generated scenes as that.

pub mod generate;

use std::path::{Path, PathBuf};

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Diagnostic, Span};
use zpg::internals::format::{Options, format, format_range};
use zpg::internals::syntax::{Document, Item, parse};

/// Findings about the layout, which another layout can mend.
const OF_LAYOUT: [Code; 3] = [Code::S501, Code::S503, Code::W314];

fn formatted(text: &str) -> String {
    let (document, _) = parse(text);
    format(text, &document, &Options::default())
}

fn load(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

/// Everything that is known of a scene but where in the text it stands. Numbers are to the bit.
fn meaning(loaded: &Analysis) -> String {
    let all = format!("{:?}", loaded.scene);
    let mut out = String::with_capacity(all.len());
    let mut rest = all.as_str();
    while let Some(at) = rest.find("Span {") {
        out.push_str(&rest[..at]);
        rest = &rest[at + rest[at..].find('}').expect("it is closed") + 1..];
    }
    out + rest
}

fn comments(text: &str) -> Vec<String> {
    let (document, _) = parse(text);
    document
        .comments()
        .map(|t| t.text(text).to_owned())
        .collect()
}

/// Records and comments that begin up to a place. A lone `0` does not count.
fn place(document: &Document, at: u32) -> (usize, usize) {
    let records = (document.items.iter())
        .filter(|i| !matches!(i, Item::Void { .. }) && document.item_span(i).start <= at);
    let comments = document.comments().filter(|c| c.span().start <= at);
    (records.count(), comments.count())
}

/// The findings, each with the record or comment that it is about.
fn findings(loaded: &Analysis, of_layout: bool) -> Vec<(Code, (usize, usize))> {
    let mut all: Vec<_> = (loaded.findings().iter())
        .filter(|d| OF_LAYOUT.contains(&d.code) == of_layout)
        .map(|d| (d.code, place(&loaded.document, d.span.start)))
        .collect();
    all.sort_by_key(|(code, place)| (code.as_str(), *place));
    all
}

/// A broken record without an error on its lines, or in the comment behind it that nobody closes.
fn broken_without_an_error(loaded: &Analysis) -> Option<&str> {
    let line = |at: u32| loaded.source.line_index(at);
    let errors = || loaded.findings().iter().filter(|d| d.is_error());
    let open = |d: &Diagnostic| d.code == Code::E002;
    let document = &loaded.document;
    let spans: Vec<Span> = (document.items.iter())
        .map(|i| document.item_span(i))
        .collect();
    let said = |k: usize| {
        let lines = line(spans[k].start)..=line(spans[k].end);
        let next = spans.get(k + 1).map_or(usize::MAX, |s| line(s.start));
        errors().any(|d| {
            let within = [d.span.start, d.span.end].map(|at| lines.contains(&line(at)));
            within.contains(&true) || open(d) && (*lines.end()..=next).contains(&line(d.span.start))
        })
    };
    let is_silent = |k: &usize| matches!(document.items[*k], Item::Broken(_)) && !said(*k);
    let silent = (0..spans.len()).find(is_silent)?;
    Some(loaded.source.slice(spans[silent]))
}

/// The first thing that is not as it should be.
fn complaint(text: &str) -> Option<String> {
    let once = formatted(text);
    if formatted(&once) != once {
        return Some(format!("it is not stable: {}", formatted(&once)));
    }
    if comments(text) != comments(&once) {
        return Some("comments differ".to_owned());
    }
    let (before, after) = (load(text), load(&once));
    if !before.is_scene() {
        // The formatter is not asked.
        return None;
    }
    if let Some(silent) = broken_without_an_error(&before) {
        return Some(format!("nothing is said of {silent}"));
    }
    if meaning(&before) != meaning(&after) {
        return Some("the meaning differs".to_owned());
    }
    // A type may be written `5` but not `5.`: what had one reading may have two, and still has the same meaning.
    let known = |all: Vec<_>| -> Vec<_> {
        let all = all.into_iter();
        all.filter(|(code, _)| *code != Code::N605).collect()
    };
    let (found, left) = (
        known(findings(&before, false)),
        known(findings(&after, false)),
    );
    if found != left {
        return Some(format!("findings: {found:?} became {left:?}"));
    }
    let (had, have) = (findings(&before, true), findings(&after, true));
    if have.iter().any(|f| !had.contains(f)) {
        return Some(format!("findings of layout: {had:?} became {have:?}"));
    }
    let lone = |text: &str| text.replace("\r\n", "").contains('\n');
    if text.contains("\r\n") && !lone(text) && lone(&once) {
        return Some("line breaks differ".to_owned());
    }
    None
}

#[track_caller]
fn check(name: &str, text: &str) {
    if let Some(complaint) = complaint(text) {
        panic!(
            "{name}: {complaint}\n--- from\n{text}\n--- to\n{}",
            formatted(text)
        );
    }
}

/// Runs a property over generated scenes, the same every time.
fn for_scenes(cases: u32, property: fn(&str) -> Option<String>) {
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let run =
        TestRunner::new_with_rng(config, rng).run(&generate::scene(), |text| {
            match property(&text) {
                None => Ok(()),
                Some(complaint) => Err(proptest::test_runner::TestCaseError::fail(format!(
                    "{complaint}\n--- from\n{text}\n--- to\n{}",
                    formatted(&text)
                ))),
            }
        });
    if let Err(e) = run {
        panic!("{e}");
    }
}

/// How many scenes to generate: as many as are asked for.
fn cases(usually: u32) -> u32 {
    let asked = std::env::var("FORMAT_CASES").ok();
    asked.and_then(|n| n.parse().ok()).unwrap_or(usually)
}

#[test]
fn generated_scenes_stay_what_they_are() {
    for_scenes(cases(1500), complaint);
}

fn scenes_below(folder: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let is_scene = |p: &PathBuf| p.extension().is_some_and(|e| e == "zpg");
    let walk = ignore::WalkBuilder::new(root)
        .standard_filters(false)
        .build();
    walk.map(|entry| entry.expect("a file").into_path())
        .filter(is_scene)
        .collect()
}

/// Those that are quoted as they are printed stay so.
#[test]
fn our_scenes_are_formatted() {
    let quoted = |p: &PathBuf| !p.to_string_lossy().contains("printed");
    for path in scenes_below("scenes").into_iter().filter(quoted) {
        let text = std::fs::read_to_string(&path).expect("a file");
        assert!(formatted(&text) == text, "zpg fmt {}", path.display());
    }
}

#[test]
fn the_scenes_of_the_documents_are_formatted() {
    for name in [
        "README.md",
        "README.cs.md",
        "docs/formatting.md",
        "grammar/reference.md",
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        let text = std::fs::read_to_string(path).expect("a file");
        let scenes = text.split("```zpg\n").skip(1);
        for (scene, _) in scenes.filter_map(|rest| rest.split_once("```")) {
            assert_eq!(formatted(scene), scene, "{name}");
        }
    }
}

#[test]
fn scenes_of_the_repository_stay_what_they_are() {
    let scenes = [scenes_below("scenes"), scenes_below("tests")].concat();
    assert!(scenes.len() > 50, "{}", scenes.len());
    for path in scenes {
        let bytes = std::fs::read(&path).expect("a file");
        check(&path.to_string_lossy(), &String::from_utf8_lossy(&bytes));
    }
}

/// Lines of a range, from a seed.
fn some_lines(text: &str, seed: usize) -> std::ops::RangeInclusive<usize> {
    let count = text.matches('\n').count() + 1;
    let first = 1 + seed % count;
    first..=first + seed / count % 4
}

/// What formatting some lines should do: no other line changes, the rest can follow later, and all
/// lines are all there is to do.
fn complaint_of_ranges(text: &str) -> Option<String> {
    let options = Options::default();
    let loaded = load(text);
    let document = &loaded.document;
    let broken = document.items.iter().any(|i| matches!(i, Item::Broken(_)));
    if broken || !loaded.is_sound() || !findings(&loaded, true).is_empty() {
        // How careful it has to be depends on the whole text.
        return None;
    }
    let once = formatted(text);
    let apply = |lines| {
        let edit = format_range(text, document, &options, lines);
        edit.map_or_else(
            || text.to_owned(),
            |e| {
                [
                    &text[..e.span.range().start],
                    &e.text,
                    &text[e.span.range().end..],
                ]
                .concat()
            },
        )
    };
    for seed in [text.len(), 7 * text.len() + 3, 31] {
        let lines = some_lines(text, seed);
        let result = apply(lines.clone());
        // A text of one line has no line break to go by.
        let later = formatted(&result);
        if !later.lines().eq(once.lines()) {
            let difference = later.lines().zip(once.lines()).find(|(a, b)| a != b);
            return Some(format!(
                "after lines {lines:?} the rest is different: {difference:?}"
            ));
        }
    }
    let all = apply(1..=usize::MAX);
    let body = |text: &str| text.trim_start_matches('\u{feff}').trim().to_owned();
    (!body(&all).lines().eq(body(&once).lines())).then(|| format!("all lines become {all}"))
}

#[test]
fn ranges_are_parts_of_the_whole() {
    for_scenes(cases(500), complaint_of_ranges);
}
