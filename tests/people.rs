//! What people get wrong: the first error is on the line, is the only one, and its first proposal is the
//! record that was meant.

mod agreement;
mod aimed;
mod blocks;
mod called;
mod commas;
mod copied;
mod doubted;
mod eyes;
mod forgotten;
mod guesses;
mod left_out;
mod meant;
mod messages;
mod misplaced;
mod misread;
mod mistaken;
mod mug;
mod newcomers;
mod operands;
mod order;
mod pasted;
mod rules;
mod said;
mod scenes;
mod shell;
mod slipped;
mod slips;
mod student;
mod surplus;
mod switched_off;
mod taken_back;
mod tenth;
mod whole;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language, Severity, fixes};
use zpg::internals::syntax::lexer;

use crate::rng::Rng;
use crate::support::{cases, seeds};
pub use scenes::text;
use slips::Slip;

/// What writes a scene of at most so many records.
pub type Scene = fn(&mut Rng, usize) -> Vec<scenes::Record>;

/// As one and another person writes.
pub const WRITERS: [Scene; 2] = [scenes::scene, student::scene];

/// The same before anybody has looked at what they write.
pub const DRAFTS: [Scene; 2] = [scenes::draft, student::draft];

/// Scenes of both.
pub fn texts(seeds: Range<u64>) -> impl Iterator<Item = String> {
    let both = seeds.flat_map(|seed| WRITERS.map(|scene| (seed, scene)));
    both.map(|(seed, scene)| {
        let most = 8 + (seed as usize * 7) % 43;
        text(&scene(&mut Rng::new(seed), most))
    })
}

/// The scenes of the counted test.
const SCENES: Range<u64> = 0..16;

fn read(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

/// The first finding of a code, and the scenes that its guesses make.
fn guessed(text: &str, code: Code) -> (Diagnostic, Vec<String>) {
    let all = repair::proposals(&read(text));
    let finding = all.into_iter().find(|d| d.code == code).expect(text);
    let made = |fix| fixes::apply(text, [fix].into_iter()).0;
    let made = finding.fixes.iter().map(made).collect();
    (finding, made)
}

/// A scene as `check --fix --unsafe-fixes` leaves it.
fn fixed(text: &str) -> String {
    let mended = fixing::to_fixed_point(read(text), true, Analysis::of);
    mended.analysis.source.text
}

/// The numbers and words of a text.
fn values(text: &str) -> Vec<String> {
    let tokens = lexer::lex(text, &[]);
    (tokens.iter())
        .filter(|t| !t.kind().is_trivia())
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

/// What is wrong with the report on a text with a slip on a line; `None` if the report has no error. `severity` is
/// what the slip is.
fn verdict(
    (text, line, meant): (&str, usize, &str),
    severity: Severity,
) -> Option<Result<(), String>> {
    let analysis = read(text);
    let findings = repair::proposals(&analysis);
    let is_such = |d: &&Diagnostic| d.severity == severity;
    let errors: Vec<&Diagnostic> = findings.iter().filter(is_such).collect();
    let Some(first) = errors.first() else {
        let is_seen = severity == Severity::Error;
        return (!is_seen).then(|| Err("nothing is said".to_owned()));
    };
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
    /// Those of each type of record, and the wrong ones among them.
    types: BTreeMap<i32, (usize, Vec<String>)>,
}

fn count(slip: &Slip, scene: Scene, seeds: Range<u64>) -> Count {
    let mut count = Count::default();
    for seed in seeds {
        let mut rng = Rng::new(seed);
        let most = 5 + (seed as usize * 7) % 46;
        let records = scene(&mut rng, most.max(8));
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
            // A comment stands behind the slip only where the slip is none of a comment's.
            let keeps = !slip.name.starts_with('`');
            let with = |line: &str| -> String {
                let mut all = String::new();
                for (k, r) in records.iter().enumerate() {
                    all += &match k == i {
                        true if keeps => format!("{}{line}{}\n", r.above, r.behind),
                        true => format!("{}{line}\n", r.above),
                        false => scenes::text(std::slice::from_ref(r)),
                    };
                }
                all
            };
            let (text, meant) = (with(&written.line), with(&written.meant));
            let before = scenes::text(&records[..i]) + &records[i].above;
            let at = before.matches('\n').count() + 1;
            if values(&text) == values(&meant) {
                continue;
            }
            let severity = match slip.name == slips::DIFFERENCE {
                true => Severity::Warning,
                false => Severity::Error,
            };
            let Some(verdict) = verdict((&text, at, &meant), severity) else {
                continue;
            };
            *times += 1;
            count.all += 1;
            let of_type = count.types.entry(records[i].code).or_default();
            of_type.0 += 1;
            match verdict {
                Ok(()) => count.right += 1,
                Err(why) => {
                    (of_type.1).push(format!("seed {seed}: `{}` — {why}", written.line));
                }
            }
        }
    }
    count
}

/// The table of all kinds, and whether each is as good as it must be.
pub fn table(seeds: Range<u64>, scene: Scene) -> (String, bool) {
    let mut out = String::new();
    let mut good = true;
    for slip in slips::ALL
        .iter()
        .filter(|s| std::env::var("ONLY").map_or(true, |o| s.name.contains(&o)))
    {
        let count = count(slip, scene, seeds.clone());
        let share = count.right as f64 / count.all.max(1) as f64;
        // One of few is no share.
        let is_good = |(all, wrong): &(usize, Vec<String>)| {
            wrong.len() <= 1 || wrong.len() as f64 <= (1.0 - slip.bar) * *all as f64
        };
        good &= count.all > 0 && share >= slip.bar && count.types.values().all(is_good);
        writeln!(
            out,
            "{:32} {:6} {:6.1} %",
            slip.name,
            count.all,
            100.0 * share
        )
        .unwrap();
        for (code, (all, wrong)) in count.types.iter().filter(|t| !t.1.1.is_empty()) {
            writeln!(out, "    {code}: {} of {all}", wrong.len()).unwrap();
            for line in wrong.iter().take(3) {
                writeln!(out, "        {line}").unwrap();
            }
        }
    }
    (out, good)
}

#[test]
fn what_was_meant_comes_first() {
    let seeds = seeds("PEOPLE", cases(SCENES, 0..100));
    for scene in WRITERS {
        let (table, good) = table(seeds.clone(), scene);
        println!("{table}");
        assert!(good, "{table}");
    }
}
