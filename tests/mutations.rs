//! Recovery, measured: valid scenes with one edit each. The first error should be on the edited
//! line, and it should be the only one.

use std::collections::BTreeMap;
use std::path::PathBuf;

use rayon::prelude::*;
use zpg::internals::analysis::Analysis;
use zpg::internals::syntax::table::ParamKind;
use zpg::internals::syntax::{Document, Item};

mod drawn;
mod located;
mod measure;
mod repeated;
mod scenes;

use crate::campaign::rng;

const FIRST_ON_LINE: f64 = 0.99;
const EXACTLY_ONE: f64 = 0.97;

/// One edit of a text: what kind, and the bytes `at..to` replaced by `with`.
struct Mutant {
    kind: &'static str,
    at: usize,
    to: usize,
    with: String,
}

fn corpus() -> Vec<(String, String)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let mut files: Vec<PathBuf> = [
        "tests/corpus",
        "scenes/handout",
        "scenes/gallery",
        "scenes/hard",
    ]
    .iter()
    .filter_map(|d| std::fs::read_dir(root.join(d)).ok())
    .flat_map(|d| d.map(|e| e.unwrap().path()))
    .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
    .collect();
    files.sort();
    files
        .iter()
        .map(|p| {
            let name = p.file_name().unwrap().to_string_lossy().into_owned();
            (name, std::fs::read_to_string(p).unwrap())
        })
        .collect()
}

fn mutants(text: &str, document: &Document) -> Vec<Mutant> {
    let mut out = Vec::new();
    let mut add = |kind, at: usize, to: usize, with: &str| {
        out.push(Mutant {
            kind,
            at,
            to,
            with: with.into(),
        });
    };
    for (n, item) in document.items.iter().enumerate() {
        let Item::Record(record) = item else { continue };
        let tokens: Vec<_> = document.significant(record.first, record.last).collect();
        let (id, ty, params) = (tokens[0], tokens[1], &tokens[2..]);
        let end = |t: &zpg::internals::syntax::lexer::Token| t.end() as usize;
        // With its one optional parameter more or less the record is right again.
        let free = record.ty().optional.len() == 1;
        for (i, p) in params.iter().enumerate() {
            let (at, to) = (p.start as usize, end(p));
            if !free {
                add("drop a parameter", at, to, "");
            }
            let extra = ["7", "0", "0.5", "-3", "21", "2"][(n + i) % 6];
            add("add a parameter", at, at, &format!("{extra} "));
            let bad = ["1.2.3", "1e", "--5", "0x1F", "5abc", "1.5.", "nan"][(n + i) % 7];
            add("malformed number", at, to, bad);
            let stray = ["@", "$", "!", "?", "x", "&"][(n + i) % 6];
            add("stray character", at, at, &format!("{stray} "));
            add("stray character", to, to, stray);
            let kind = record.ty().param(i, record.count()).map(|p| p.kind);
            if let Some(ParamKind::Reference { .. }) = kind {
                add("reference to nothing", at, to, "987654");
            }
        }
        if !free {
            add(
                "add a parameter",
                end(tokens[tokens.len() - 1]),
                end(tokens[tokens.len() - 1]),
                " 4",
            );
            add(
                "add a parameter",
                end(tokens[tokens.len() - 1]),
                end(tokens[tokens.len() - 1]),
                " 0",
            );
        }
        add(
            "stray character",
            id.start as usize,
            id.start as usize,
            "@ ",
        );
        add("malformed number", id.start as usize, end(id), "1.2.3");
        add("malformed number", ty.start as usize, end(ty), "9..");
        for code in ["77", "-204", "0.5", "1000"] {
            add("unknown type", ty.start as usize, end(ty), code);
        }
        add("dropped ID", id.start as usize, end(id), "");
    }
    for c in document.comments() {
        let end = c.end() as usize;
        // Where the closing sign of a comment over several lines is gone, the words on its last
        // lines are no comment by any rule; the line of the opening sign is the one to blame.
        if !c.text(text).contains('\n') {
            add("unclosed comment", end - 1, end, "");
        }
    }
    out
}

#[derive(Default)]
struct Tally {
    all: usize,
    on_line: usize,
    one: usize,
}

impl Tally {
    fn add(&mut self, other: &Tally) {
        self.all += other.all;
        self.on_line += other.on_line;
        self.one += other.one;
    }
}

/// What comes of the edits of a scene, by kind; and the edits whose error is not alone on their line.
fn outcome(name: &str, text: &str) -> (BTreeMap<&'static str, Tally>, String) {
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    let mut misses = String::new();
    let original = Analysis::new(name, text.as_bytes().to_vec());
    assert!(original.is_sound(), "{name} is not valid");
    let step = crate::support::cases(13, 1);
    for m in mutants(text, &original.document).iter().step_by(step) {
        let mut mutated = text.to_owned();
        mutated.replace_range(m.at..m.to, &m.with);
        let line = text[..m.at].matches('\n').count() as u32 + 1;
        let loaded = Analysis::new(name, mutated.into_bytes());
        let errors: Vec<_> = loaded.findings().iter().filter(|d| d.is_error()).collect();
        let found = |d: &&zpg::internals::diagnostics::Diagnostic| {
            loaded.source.position(d.span.start).line
        };
        let on_line = errors.first().map(found) == Some(line);
        let tally = tallies.entry(m.kind).or_default();
        tally.all += 1;
        tally.on_line += usize::from(on_line);
        tally.one += usize::from(errors.len() == 1);
        if !on_line || errors.len() != 1 {
            let what: Vec<String> = errors
                .iter()
                .take(4)
                .map(|d| format!("{}@{}", d.code.as_str(), found(d)))
                .collect();
            let edited = loaded
                .source
                .slice(loaded.source.line_span(line as usize - 1));
            misses += &format!("{name}:{line} {} | {edited} | {}\n", m.kind, what.join(" "));
        }
    }
    (tallies, misses)
}

#[test]
fn one_edit_one_error_on_its_line() {
    let outcomes: Vec<_> = (corpus().par_iter())
        .map(|(name, text)| outcome(name, text))
        .collect();
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    let mut misses = String::new();
    for (scene, missed) in outcomes {
        misses += &missed;
        for (kind, t) in scene {
            tallies.entry(kind).or_default().add(&t);
        }
    }
    let mut sum = Tally::default();
    let mut table = String::new();
    for (kind, t) in &tallies {
        let share = |n: usize| 100.0 * n as f64 / t.all as f64;
        table += &format!(
            "{kind:22} {:6} {:7.2} % {:7.2} %\n",
            t.all,
            share(t.on_line),
            share(t.one)
        );
        sum.add(t);
    }
    let share = |n: usize| n as f64 / sum.all as f64;
    table += &format!(
        "{:22} {:6} {:7.2} % {:7.2} %\n",
        "all",
        sum.all,
        100.0 * share(sum.on_line),
        100.0 * share(sum.one)
    );
    println!("{table}\n{misses}");
    assert!(share(sum.on_line) >= FIRST_ON_LINE, "{table}");
    assert!(share(sum.one) >= EXACTLY_ONE, "{table}");
}
