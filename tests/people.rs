//! What people get wrong: the first error is on the line, is the only one, and its first proposal is the
//! record that was meant.

mod messages;
mod rules;
mod scenes;
mod slips;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use zpg::analysis::{Analysis, repair};
use zpg::diagnostics::{Diagnostic, Language, fixes};
use zpg::syntax::lexer;

use crate::rng::Rng;
use slips::Slip;

/// So many scenes, unless `ZPG_PEOPLE` says how many.
const SCENES: usize = 12;

fn read(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

/// The numbers and words of a text.
fn values(text: &str) -> Vec<String> {
    let tokens = lexer::lex(text, &[]);
    (tokens.iter())
        .filter(|t| !t.kind.is_trivia())
        .map(|t| match t.number(text) {
            // There is but one zero.
            Some(x) => (x + 0.0).to_string(),
            None => t.text(text).to_owned(),
        })
        .collect()
}

/// A finding in all languages.
fn said(d: &Diagnostic) -> Vec<String> {
    [Language::English, Language::Czech]
        .iter()
        .flat_map(|&l| {
            let words = d.wording(l);
            [vec![words.message], words.fixes].concat()
        })
        .collect()
}

/// What is wrong with the report on a text with a slip on a line; `None` if the report has no error.
fn verdict(text: &str, line: usize, meant: &str) -> Option<Result<(), String>> {
    let analysis = read(text);
    let findings = repair::proposals(&analysis);
    let errors: Vec<&Diagnostic> = findings.iter().filter(|d| d.is_error()).collect();
    let first = errors.first()?;
    let at = |d: &Diagnostic| analysis.source.position(d.span.start).line as usize;
    let told = said(first).join("; ");
    if at(first) != line {
        return Some(Err(format!("error on line {}: {told}", at(first))));
    }
    if errors.len() > 1 {
        return Some(Err(format!("{} errors: {told}", errors.len())));
    }
    let Some(fix) = first.fixes.first() else {
        return Some(Err(format!("no proposal: {told}")));
    };
    let (fixed, _) = fixes::apply(text, [fix].into_iter());
    if values(&fixed) == values(meant) {
        return Some(Ok(()));
    }
    Some(Err(format!("another proposal: {told}")))
}

/// How many of a kind's slips came out right, and the others.
#[derive(Default)]
struct Count {
    all: usize,
    right: usize,
    /// By type of record.
    wrong: BTreeMap<i32, Vec<String>>,
}

fn count(slip: &Slip, scenes: usize) -> Count {
    let mut count = Count::default();
    for seed in 0..scenes as u64 {
        let mut rng = Rng::new(seed);
        let most = 5 + (seed as usize * 7) % 46;
        let records = scenes::scene(&mut rng, most.max(8));
        let mut tried: BTreeMap<i32, usize> = BTreeMap::new();
        for i in 0..records.len() {
            // Two records of each type in each scene.
            let times = tried.entry(records[i].code).or_default();
            if *times == 2 {
                continue;
            }
            let Some(written) = (slip.make)(&mut rng, &records, i) else {
                continue;
            };
            let with = |line: &str| -> String {
                (records.iter().enumerate())
                    .map(|(k, r)| if k == i { line.to_owned() } else { r.line() } + "\n")
                    .collect()
            };
            // Every other scene has comments, on lines with the slip only where it is none of a comment's.
            let with = |line: &str| -> String {
                (with(line).lines().enumerate())
                    .map(|(k, l)| match seed % 2 == 1 && k % 3 == 0 {
                        true if k != i || !slip.name.starts_with('`') => {
                            format!("{l} # část {k} #\n")
                        }
                        _ => l.to_owned() + "\n",
                    })
                    .collect()
            };
            let (text, meant) = (with(&written.line), with(&written.meant));
            if values(&text) == values(&meant) {
                continue;
            }
            let Some(verdict) = verdict(&text, i + 1, &meant) else {
                continue;
            };
            *times += 1;
            count.all += 1;
            match verdict {
                Ok(()) => count.right += 1,
                Err(why) => {
                    let wrong = count.wrong.entry(records[i].code).or_default();
                    wrong.push(format!("seed {seed}: `{}` — {why}", written.line));
                }
            }
        }
    }
    count
}

/// The table of all kinds, and whether each is as good as it must be.
pub fn table(scenes: usize) -> (String, bool) {
    let mut out = String::new();
    let mut good = true;
    for slip in slips::ALL {
        let count = count(slip, scenes);
        let share = count.right as f64 / count.all.max(1) as f64;
        good &= count.all > 0 && share >= slip.bar;
        writeln!(
            out,
            "{:32} {:6} {:6.1} %",
            slip.name,
            count.all,
            100.0 * share
        )
        .unwrap();
        for (code, wrong) in &count.wrong {
            writeln!(out, "    {code}: {}", wrong.len()).unwrap();
            for line in wrong.iter().take(3) {
                writeln!(out, "        {line}").unwrap();
            }
        }
    }
    (out, good)
}

#[test]
fn what_was_meant_comes_first() {
    let scenes = std::env::var("ZPG_PEOPLE");
    let scenes = scenes.ok().and_then(|n| n.parse().ok()).unwrap_or(SCENES);
    let (table, good) = table(scenes);
    println!("{table}");
    assert!(good, "{table}");
}
