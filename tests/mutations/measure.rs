//! Recovery, measured: scenes with one to four small mistakes, in lines and wrapped at any place.
//!
//! *Localised*: the first error is on the mutated line; in free-form text within the mutated record or at the next
//! token. *Single*: it is the only one. *Several*: as many errors as there are mistakes, each in its own record.

use std::ops::Range;

use rayon::prelude::*;
use zpg::internals::analysis::{Analysis, repair};
use zpg::internals::diagnostics::{Diagnostic, SourceFile};

use super::rng::Rng;
use super::scenes;

/// A scene with mistakes.
pub struct Mutant {
    pub text: String,
    /// For each mistake: its kind, and the bytes of the text in which an error is in its place.
    pub places: Vec<(&'static str, usize, usize)>,
}

/// How records are laid out.
#[derive(Clone, Copy, PartialEq)]
pub enum Layout {
    Lines,
    Free,
}

/// What happens to the tokens of a record.
fn mutate(rng: &mut Rng, tokens: &mut Vec<String>) -> Option<&'static str> {
    let i = rng.below(tokens.len());
    let other = ["7", "0", "1", "0.5", "-3", "21", "x", "2", "@", "1.5.2"];
    Some(match rng.below(7) {
        0 => {
            tokens.remove(i);
            "deleted"
        }
        1 => {
            let token = tokens[i].clone();
            tokens.insert(i, token);
            "doubled"
        }
        2 => {
            let token = other[rng.below(other.len())].to_owned();
            tokens.insert(i, token);
            "inserted"
        }
        3 => {
            let token = other[rng.below(other.len())].to_owned();
            if tokens[i] == token {
                return None;
            }
            tokens[i] = token;
            "replaced"
        }
        4 => {
            let at = 1 + rng.below(tokens[i].len().max(2) - 1);
            if at >= tokens[i].len() {
                return None;
            }
            let rest = tokens[i].split_off(at);
            tokens.insert(i + 1, rest);
            "split"
        }
        5 => {
            let rest = tokens[1].strip_prefix('-')?.to_owned();
            tokens[1] = rest;
            "lost sign"
        }
        _ => "lost comment mark",
    })
}

/// Whether a text has errors.
fn has_errors(text: &str) -> bool {
    !Analysis::of(SourceFile::new("m.zpg", text.into())).is_sound()
}

/// Whether tokens are a record by their number and form: then nothing has to be recovered, whatever it means.
fn is_record(tokens: &[String]) -> bool {
    let (document, findings) = zpg::internals::syntax::parse(&tokens.join(" "));
    findings.is_empty()
        && matches!(
            document.items[..],
            [zpg::internals::syntax::Item::Record(_)]
        )
}

/// A scene with so many mistakes; `None` if one of them leaves a record that can be read.
pub fn mutant(seed: u64, layout: Layout, mistakes: usize) -> Option<Mutant> {
    let mut rng = Rng::new(seed);
    let most = [30, 90, 190][rng.below(3)];
    let count = 10 + rng.below(1 + most);
    let records = scenes::records(seed, count);
    let write = |records: &[Vec<String>], kinds: &[Option<&'static str>], rng: &mut Rng| {
        let mut text = String::new();
        let mut places = Vec::new();
        let mut column = 0;
        let width = 12 + rng.below(70);
        for (record, kind) in records.iter().zip(kinds) {
            let start = text.len();
            for (i, token) in record.iter().enumerate() {
                let gap = match layout {
                    Layout::Lines if i == 0 => "",
                    Layout::Lines => " ",
                    _ if column + token.len() > width => "\n",
                    _ if text.is_empty() => "",
                    Layout::Free => " ",
                };
                text += gap;
                column = if gap == "\n" { 0 } else { column + gap.len() };
                text += token;
                column += token.len();
            }
            let comment = match kind {
                Some("lost comment mark") => " # a mark",
                _ if layout == Layout::Lines && rng.chance(0.2) => " # so #",
                _ => "",
            };
            text += comment;
            places.extend(kind.map(|kind| (kind, start, text.len())));
            if layout == Layout::Lines || comment.ends_with("mark") {
                text += "\n";
                column = 0;
            }
        }
        (text, places)
    };
    let none = vec![None; records.len()];
    let (right, _) = write(&records, &none, &mut rng.clone());
    if has_errors(&right) {
        return None;
    }
    let mut wrong = records.clone();
    let mut kinds = none.clone();
    for _ in 0..mistakes {
        let at = rng.below(records.len());
        if kinds[at].is_some() {
            return None;
        }
        kinds[at] = Some(mutate(&mut rng, &mut wrong[at])?);
        if kinds[at] != Some("lost comment mark") && is_record(&wrong[at]) {
            return None;
        }
        // One that is none alone is none among others.
        let mut alone = records.clone();
        alone[at] = wrong[at].clone();
        let mut kind = none.clone();
        kind[at] = kinds[at];
        let (text, _) = write(&alone, &kind, &mut rng.clone());
        if !has_errors(&text) {
            return None;
        }
    }
    let (text, places) = write(&wrong, &kinds, &mut rng);
    // Up to the end of the next token.
    let places = (places.into_iter())
        .map(|(kind, from, to)| {
            let rest = &text[to..];
            let gap = rest.len() - rest.trim_start().len();
            let word = rest[gap..]
                .find(char::is_whitespace)
                .unwrap_or(rest.len() - gap);
            let next = if layout == Layout::Free {
                gap + word
            } else {
                0
            };
            (kind, from, to + next)
        })
        .collect();
    Some(Mutant { text, places })
}

/// What `zpg check` says of a mutant: whether the first error is in its place, whether there are as many as mistakes
/// and each is in a place, and all errors for a list.
pub fn judge(mutant: &Mutant) -> (bool, bool, String) {
    let analysis = Analysis::of(SourceFile::new("m.zpg", mutant.text.as_str().into()));
    let found = judged(mutant, &analysis, analysis.findings());
    match found {
        (true, true, _) => found,
        // Of several errors that one fix mends, one is left.
        _ => judged(mutant, &analysis, &repair::proposals(&analysis)),
    }
}

fn judged(mutant: &Mutant, analysis: &Analysis, findings: &[Diagnostic]) -> (bool, bool, String) {
    let errors: Vec<_> = findings.iter().filter(|d| d.is_error()).collect();
    let place = |at: u32| {
        let within = |p: &&(&str, usize, usize)| (p.1..=p.2).contains(&(at as usize));
        mutant.places.iter().find(within)
    };
    let first = errors
        .first()
        .is_some_and(|d| place(d.span.start).is_some());
    let all =
        errors.len() == mutant.places.len() && errors.iter().all(|d| place(d.span.start).is_some());
    let said: Vec<String> = (errors.iter().take(4))
        .map(|d| {
            let line = analysis.source.position(d.span.start).line;
            format!("{}@{line}", d.code.as_str())
        })
        .collect();
    let places = mutant.places.iter().map(|&(kind, from, to)| {
        let line = analysis.source.position(from as u32).line;
        format!(
            "{kind}@{line} `{}`",
            mutant.text[from..to].replace('\n', "⏎")
        )
    });
    let places: Vec<String> = places.collect();
    (
        first,
        all,
        format!("{}: {}", places.join(", "), said.join(" ")),
    )
}

/// The shares of localised and single among so many mutants, and what was missed.
pub fn shares(
    layout: Layout,
    mistakes: usize,
    seeds: Range<u64>,
) -> ([f64; 2], usize, Vec<String>) {
    let all: Vec<(bool, bool, String)> = seeds
        .into_par_iter()
        .filter_map(|seed| mutant(seed, layout, mistakes))
        .map(|m| judge(&m))
        .collect();
    let share = |n: usize| n as f64 / all.len() as f64;
    let localised = share(all.iter().filter(|a| a.0).count());
    let single = share(all.iter().filter(|a| a.1).count());
    let count = all.len();
    let missed = all.into_iter().filter(|a| !(a.0 && a.1)).map(|a| a.2);
    ([localised, single], count, missed.collect())
}
