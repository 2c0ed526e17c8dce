//! The same mistake on many lines: on a run of neighbours, on every k-th line, in the whole file.
//! There should be just the errors that were made, each on its line.

use std::collections::BTreeMap;

use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::SourceFile;
use zpg::internals::syntax::lexer::{Token, TokenKind};
use zpg::internals::syntax::table::{ParamKind, RecordType};
use zpg::internals::syntax::{Document, Item};

/// The share of texts with exactly the errors that were made, of all texts and of each kind.
const EXACT: f64 = 0.985;
const EXACT_OF_A_KIND: f64 = 0.93;

/// What one mistake makes of one record: replacements of bytes, and the error for each line of it.
struct Mistake {
    edits: Vec<(usize, usize, String)>,
    codes: &'static [&'static str],
    errors: usize,
}

type Maker = fn(&Row) -> Option<Mistake>;

/// A record that has a line for itself.
struct Row<'a> {
    line: u32,
    number: usize,
    text: &'a str,
    ty: &'static RecordType,
    tokens: Vec<Token>,
}

impl Row<'_> {
    fn at(&self, i: usize) -> (usize, usize) {
        (self.tokens[i].start as usize, self.tokens[i].end() as usize)
    }

    /// Whether the record is right with one number more or less, or has a file name in it.
    fn flexible(&self) -> bool {
        let named = |k| k == ParamKind::FileName;
        self.ty.optional.len() == 1 || self.ty.params.iter().any(|p| named(p.kind))
    }

    /// Between the two numbers of parameters that a record may have, either can be said.
    fn count_codes(&self, codes: &'static [&'static str]) -> &'static [&'static str] {
        match self.ty.optional.len() {
            0 => codes,
            _ => &["E008", "E009"],
        }
    }

    fn one(&self, at: (usize, usize), with: &str, codes: &'static [&'static str]) -> Mistake {
        Mistake {
            edits: vec![(at.0, at.1, with.into())],
            codes,
            errors: 1,
        }
    }
}

fn decimal_commas(row: &Row) -> Option<Mistake> {
    let comma = |t: &Token| {
        let text = t.text(row.text);
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let (before, after) = text.split_once('.')?;
        let both = digit(before.chars().last()) && digit(after.chars().next());
        both.then(|| (t.start as usize, t.end() as usize, text.replace('.', ",")))
    };
    let edits: Vec<_> = row.tokens[2..].iter().filter_map(comma).collect();
    (!edits.is_empty()).then_some(Mistake {
        edits,
        codes: &["E003"],
        errors: 1,
    })
}

fn one_number_more(row: &Row) -> Option<Mistake> {
    let end = row.at(row.tokens.len() - 1).1;
    let codes = row.count_codes(&["E009"]);
    (!row.flexible()).then(|| row.one((end, end), " 1", codes))
}

fn one_number_less(row: &Row) -> Option<Mistake> {
    let last = row.tokens.len() - 1;
    let lost = |last: usize| (row.at(last - 1).1, row.at(last).1);
    let codes = row.count_codes(&["E008"]);
    (last > 1 && !row.flexible()).then(|| row.one(lost(last), "", codes))
}

fn word_for_a_number(row: &Row) -> Option<Mistake> {
    let params = row.tokens.len() - 2;
    let i = 2 + row.number % params.max(1);
    let number = params > 0 && !row.flexible() && !(row.ty.is_counted() && i == 2);
    number.then(|| row.one(row.at(i), "x", &["E012"]))
}

fn word_for_the_type(row: &Row) -> Option<Mistake> {
    (row.tokens.len() > 2).then(|| row.one(row.at(1), row.ty.keyword, &["E006"]))
}

fn lost_id(row: &Row) -> Option<Mistake> {
    let lost = (row.at(0).0, row.at(1).0);
    // `9 1 …` is a VOID and more; `0 …` is no record.
    (row.tokens.len() > 2).then(|| row.one(lost, "", &["E005"]))
}

fn lost_sign(row: &Row) -> Option<Mistake> {
    let code = row.ty.code;
    let (at, to) = row.at(1);
    let unknown = code < 0 && RecordType::by_code((-code).into()).is_none();
    unknown.then(|| row.one((at, to), &(-code).to_string(), &["E007"]))
}

fn unknown_type(row: &Row) -> Option<Mistake> {
    (row.tokens.len() > 2).then(|| row.one(row.at(1), "77", &["E007"]))
}

fn letter_for_zero(row: &Row) -> Option<Mistake> {
    let named = row.ty.params.iter().any(|p| p.kind == ParamKind::FileName);
    let zero = |i: &usize| {
        row.tokens[*i].text(row.text).contains('0') && row.tokens[*i].kind() == TokenKind::Integer
    };
    let i = (2 + usize::from(row.ty.is_counted())..row.tokens.len())
        .find(zero)
        .filter(|_| !named)?;
    let text = row.tokens[i].text(row.text).replacen('0', "O", 1);
    Some(row.one(row.at(i), &text, &["E003", "E012"]))
}

const KINDS: [(&str, Maker); 9] = [
    ("decimal commas", decimal_commas),
    ("one number more", one_number_more),
    ("one number less", one_number_less),
    ("word for a number", word_for_a_number),
    ("word for the type", word_for_the_type),
    ("lost ID", lost_id),
    ("lost sign of a type", lost_sign),
    ("unknown type", unknown_type),
    ("letter O for 0", letter_for_zero),
];

/// The records that have a line for themselves.
fn rows<'a>(text: &'a str, document: &Document) -> Vec<Row<'a>> {
    let source = SourceFile::new("t.zpg", text.into());
    let line = |offset: u32| source.position(offset).line;
    let mut users: BTreeMap<u32, usize> = BTreeMap::new();
    for item in &document.items {
        let span = document.item_span(item);
        for l in line(span.start)..=line(span.end) {
            *users.entry(l).or_default() += 1;
        }
    }
    let mut out = Vec::new();
    for item in &document.items {
        let Item::Record(r) = item else { continue };
        let span = document.item_span(item);
        let l = line(span.start);
        if line(span.end) == l && users[&l] == 1 {
            let tokens = document.significant(r.first, r.last).copied().collect();
            let number = out.len();
            out.push(Row {
                line: l,
                number,
                text,
                ty: r.ty(),
                tokens,
            });
        }
    }
    out
}

/// Which of `n` places get the mistake: runs, every k-th, and all.
fn choices(n: usize) -> Vec<Vec<usize>> {
    let mut out = vec![];
    for k in [1, 2, 3, 5] {
        if n >= 2 * k {
            out.push((0..n).step_by(k).collect());
        }
    }
    for length in [2, 3, 4, 6, 8, 12] {
        let apart = (n / 12).max(length);
        out.extend(
            (0..n)
                .step_by(apart)
                .filter(|s| s + length <= n)
                .map(|s| (s..s + length).collect()),
        );
    }
    out
}

#[derive(Default)]
struct Tally {
    texts: usize,
    exact: usize,
    lines: usize,
    lines_exact: usize,
}

#[test]
fn the_same_mistake_on_many_lines() {
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    let mut misses = String::new();
    let step = crate::support::cases(2, 1);
    for (name, text) in super::corpus() {
        let original = Analysis::new(name.as_str(), text.clone().into_bytes());
        let rows = rows(&text, &original.document);
        for (kind, make) in KINDS {
            let mistakes: Vec<(u32, Mistake)> = rows
                .iter()
                .filter_map(|r| Some((r.line, make(r)?)))
                .collect();
            for chosen in choices(mistakes.len()).into_iter().step_by(step) {
                // Without one type that is known a text is no scene.
                let is_typeless = matches!(kind, "unknown type" | "word for the type");
                if is_typeless && chosen.len() == mistakes.len() {
                    continue;
                }
                let mut mutated = text.clone();
                let mut wanted: BTreeMap<u32, usize> = BTreeMap::new();
                let mut codes: BTreeMap<u32, &[&str]> = BTreeMap::new();
                for (line, m) in chosen.iter().rev().map(|&i| &mistakes[i]) {
                    for (at, to, with) in m.edits.iter().rev() {
                        mutated.replace_range(at..to, with);
                    }
                    wanted.insert(*line, m.errors);
                    codes.insert(*line, m.codes);
                }
                let loaded = Analysis::new(name.as_str(), mutated.into_bytes());
                let mut found: BTreeMap<u32, usize> = BTreeMap::new();
                let mut what = Vec::new();
                for d in loaded.findings().iter().filter(|d| d.is_error()) {
                    let line = loaded.source.position(d.span.start).line;
                    let right = codes
                        .get(&line)
                        .is_some_and(|c| c.contains(&d.code.as_str()));
                    *found.entry(line).or_default() += if right { 1 } else { 1000 };
                    what.push(format!("{}@{line}", d.code.as_str()));
                }
                let tally = tallies.entry(kind).or_default();
                let exact = found == wanted;
                tally.texts += 1;
                tally.exact += usize::from(exact);
                tally.lines += wanted.len();
                let right = |(l, n): &(&u32, &usize)| found.get(l) == Some(n);
                tally.lines_exact += wanted.iter().filter(right).count();
                if !exact {
                    let wrong: Vec<u32> =
                        wanted.iter().filter(|w| !right(w)).map(|w| *w.0).collect();
                    what.retain(|w| {
                        let line: u32 = w.split('@').nth(1).unwrap().parse().unwrap();
                        wanted.get(&line) != found.get(&line)
                    });
                    what.truncate(8);
                    let on: Vec<u32> = wanted.keys().copied().take(8).collect();
                    misses += &format!(
                        "{name} {kind} on {} lines {on:?}, missed {} {:?}: {}\n",
                        wanted.len(),
                        wrong.len(),
                        &wrong[..wrong.len().min(6)],
                        what.join(" ")
                    );
                }
            }
        }
    }
    let share = |n: usize, of: usize| n as f64 / of as f64;
    let (mut all, mut exact) = (0, 0);
    let mut table = String::new();
    for (kind, t) in &tallies {
        table += &format!(
            "{kind:22} {:6} texts {:6.2} %   {:7} lines {:6.2} %\n",
            t.texts,
            100.0 * share(t.exact, t.texts),
            t.lines,
            100.0 * share(t.lines_exact, t.lines)
        );
        all += t.texts;
        exact += t.exact;
    }
    table += &format!(
        "{:22} {all:6} texts {:6.2} %\n",
        "all",
        100.0 * share(exact, all)
    );
    println!("{table}\n{misses}");
    assert!(share(exact, all) >= EXACT, "{table}");
    for t in tallies.values() {
        assert!(share(t.exact, t.texts) >= EXACT_OF_A_KIND, "{table}");
    }
}
