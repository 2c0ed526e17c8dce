//! Applying fixes until none is left.

use std::collections::VecDeque;
use std::ops::Range;

use rustc_hash::FxHashSet;

use super::Analysis;
use super::allowing::TRIED_BYTES;
use super::repair;
use super::worse::{harms, has_new_errors, weight, weight_after};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, SourceFile, fixes};
use crate::lint;
use crate::syntax::{preserved, recognise};

/// The limits for trials of fixes that turn out to do harm: how many bytes are read in all, and how often a scene is
/// read again at the least and at the most.
const REFUSED_BYTES: usize = 16_000_000;
const REFUSED: Range<usize> = 16..1000;

/// The fewest new lines of a guess that is left out on trial. Guesses that add optics or move a record write fewer.
const LONG_GUESS_LINES: usize = 3;

/// A scene after its fixes were applied.
pub struct Mended {
    pub analysis: Analysis,
    /// The findings about the scene, with proposals.
    pub findings: Vec<Diagnostic>,
    /// The number of fixes that were applied.
    pub count: usize,
    /// The edits, round by round. Each round edits the text that the rounds before have made.
    pub rounds: Vec<Vec<Edit>>,
}

/// Applies fixes as long as the scene checks better, every token outside of the edits is as it was, and the result is a
/// scene. `again` reads the scene with another text. Fixes that were tried and refused are offered no more.
///
/// Each step has fewer errors, or as many errors and fewer malformed tokens, and so on, so the steps come to an end.
pub fn to_fixed_point(
    mut analysis: Analysis,
    unsafe_too: bool,
    again: impl Fn(SourceFile) -> Analysis,
) -> Mended {
    let mut left =
        (REFUSED_BYTES / analysis.source.text.len().max(1)).clamp(REFUSED.start, REFUSED.end);
    let (mut count, mut rounds) = (0, Vec::new());
    let mut guessed = false;
    // The findings before the first guess. No guess is made for a finding that only another guess has brought to light.
    let mut said = Said::default();
    // Errors are fixed first. What they have hidden is then compared with the findings of the fixed scene.
    let of = |analysis: &Analysis, errors: bool, said: Option<&Said>| -> Vec<Fix> {
        // If no finding needs guesses, the fixes of the findings are enough.
        let proposals;
        let findings = match unsafe_too && analysis.findings().iter().any(repair::is_tried) {
            true => {
                proposals = repair::proposals(analysis);
                &proposals
            }
            false => analysis.findings(),
        };
        // The next guess must not take out a record that a guess has made.
        let is_asked = |d: &&Diagnostic| {
            d.is_error() == errors && !(said.is_some() && lint::takes_records_out(d.code))
        };
        let all = findings.iter().filter(is_asked).filter_map(|d| {
            let fix = d.applicable_fix(unsafe_too)?;
            let is_new = |said: &Said| !errors && !said.contains(&key(analysis, d));
            let follows = is_guess(fix) && said.is_some_and(is_new);
            (!follows).then(|| fix.clone())
        });
        all.collect()
    };
    let mut next = |analysis: &Analysis, said: Option<&Said>| {
        [true, false].into_iter().find_map(|errors| {
            let all = of(analysis, errors, said);
            let step = step(analysis, &all, &again, &mut left)?;
            Some((step, all.iter().any(is_guess)))
        })
    };
    loop {
        if unsafe_too && !guessed {
            said = analysis
                .findings()
                .iter()
                .map(|d| key(&analysis, d))
                .collect();
        }
        let Some((step, with_guesses)) = next(&analysis, guessed.then_some(&said)) else {
            break;
        };
        guessed |= with_guesses;
        analysis = step.analysis;
        count += step.count;
        rounds.push(step.edits);
    }
    if left > 0 {
        let mut findings = analysis.take_findings();
        for d in &mut findings {
            let is_new = guessed && !said.contains(&key(&analysis, d));
            let is_error = d.is_error();
            (d.fixes).retain(|f| match f.applicability {
                Applicability::Safe => false,
                Applicability::Unsafe => !(unsafe_too && is_error),
                Applicability::Choice => true,
            });
            // A guess for a finding that only a guess has brought to light stays, and the next run may apply it.
            if unsafe_too && !is_new {
                leave_open(d);
            }
        }
        analysis.findings = findings.into();
    }
    // With `unsafe_too`, proposals are only made for errors that are left, as choices.
    let is_left = analysis.findings().iter().any(Diagnostic::is_error);
    let findings = match unsafe_too {
        true if is_left => with_choices(analysis.findings(), repair::proposals(&analysis)),
        true => analysis.findings().to_vec(),
        false => repair::proposals(&analysis),
    };
    Mended {
        analysis,
        findings,
        count,
        rounds,
    }
}

/// Findings, each as its code and the text that it points at.
type Said = FxHashSet<(Code, String)>;

fn key(analysis: &Analysis, d: &Diagnostic) -> (Code, String) {
    (d.code, analysis.source.slice(d.span).to_owned())
}

/// The findings that are left, with the proposals among which a person has to choose.
fn with_choices(left: &[Diagnostic], proposals: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut left = left.to_vec();
    let is_choice =
        |d: &Diagnostic| (d.fixes.iter()).any(|f| f.applicability == Applicability::Choice);
    for choice in proposals.into_iter().filter(is_choice) {
        let same = |d: &&mut Diagnostic| (d.code, d.span) == (choice.code, choice.span);
        if let Some(d) = left.iter_mut().find(same) {
            *d = choice;
        }
    }
    left
}

/// Whether a fix is applied if it is the only one.
pub fn is_applied(analysis: &Analysis, fix: &Fix) -> bool {
    let read = |source| Analysis::of(source).with_settings(analysis.settings.clone());
    step(analysis, std::slice::from_ref(fix), &read, &mut 1).is_some()
}

/// Whether guesses are tried for a scene at all: for a long scene that takes too much time.
pub fn is_tried(analysis: &Analysis) -> bool {
    analysis.source.text.len() <= TRIED_BYTES
}

/// Adds a note to findings whose guesses `--unsafe-fixes` does not apply.
pub fn explain_what_is_left(analysis: &Analysis, findings: &mut [Diagnostic]) {
    let mut left = TRIED_BYTES;
    let errors = findings.iter().filter(|d| d.is_error()).take(2).count();
    for d in findings
        .iter_mut()
        .filter(|d| analysis.is_records() && !d.fixes.is_empty())
    {
        // A guess for an error may need the guesses for other errors.
        if let Some(guess) = d.applicable_fix(true).filter(|f| is_guess(f))
            && (!d.is_error() || errors == 1)
            && let Some(rest) = left.checked_sub(analysis.source.text.len())
        {
            left = rest;
            if !is_applied(analysis, guess) {
                leave_open(d);
            }
        }
        let is_choice = |f: &Fix| f.applicability == Applicability::Choice;
        let is_said = |note: &&str| ["choose", "lost", "refused"].contains(note);
        if d.fixes.iter().all(is_choice) && !d.notes.iter().any(is_said) {
            d.notes.push(match d.fixes.len() {
                1 => "undecided",
                _ => "choose",
            });
        }
    }
}

/// Turns the guesses of a finding into choices for a person, since applying a guess would leave as many findings as
/// before.
fn leave_open(d: &mut Diagnostic) {
    let mut guesses = d.fixes.iter_mut().filter(|f| is_guess(f)).peekable();
    if guesses.peek().is_some() && !d.notes.contains(&"refused") {
        d.notes.push("refused");
    }
    guesses.for_each(|f| f.applicability = Applicability::Choice);
}

fn is_guess(fix: &Fix) -> bool {
    fix.applicability == Applicability::Unsafe
}

/// The limit for the weight of a scene: it must be below, or no greater.
enum Limit<'a> {
    Below(&'a Vec<usize>),
    AtMost(&'a Vec<usize>),
}

/// The result of a round of fixes: the scene, the number of fixes, and their edits.
struct FixRound {
    analysis: Analysis,
    count: usize,
    edits: Vec<Edit>,
}

/// Applies as many of the fixes as work together. A group that does harm is halved, and each half is tried. A group is
/// refused if one of its fixes does harm, even if the others repair more. `left` is how many more trials may fail.
fn step(
    analysis: &Analysis,
    all: &[Fix],
    again: &impl Fn(SourceFile) -> Analysis,
    left: &mut usize,
) -> Option<FixRound> {
    let text = analysis.source.text.as_str();
    let guesses = all.iter().any(is_guess);
    let edits_of = |chosen: &[bool]| {
        let with = all.iter().zip(chosen).filter(|f| *f.1).map(|f| f.0);
        fixes::edits(text, with)
    };
    // The scene with some edits and its weight, if that is within a limit and nothing became worse than `before`.
    let read = |(edits, count): (Vec<Edit>, usize), before: &Analysis, limit: Limit| {
        let edited = fixes::edited(text, &edits);
        let fixed = again(analysis.source.with_text(edited));
        let now = weight_after(before, &fixed);
        let is_light = match limit {
            Limit::Below(lightest) => now < *lightest,
            Limit::AtMost(lightest) => now <= *lightest,
        };
        let is_sound = is_light
            && !has_new_errors(before, &fixed)
            && leaves_the_rest(analysis, &edits, &fixed)
            && fixed.is_scene()
            && recognise::is_scene(&fixed.source.text)
            && !(guesses && repair::draws_nothing(&fixed) && !repair::draws_nothing(before));
        let round = FixRound {
            analysis: fixed,
            count,
            edits,
        };
        is_sound.then_some((round, now))
    };
    let mut chosen = vec![false; all.len()];
    let mut best: Option<FixRound> = None;
    let mut lightest = weight(analysis);
    // Larger groups come first, so that a harmful fix in one place does not hold up fixes in others.
    let mut stretches = VecDeque::new();
    stretches.push_back(0..all.len());
    while let Some(stretch) = stretches.pop_front().filter(|_| *left > 0) {
        let mut tried = chosen.clone();
        tried[stretch.clone()].fill(true);
        let edits = edits_of(&tried);
        if edits.1 > best.as_ref().map_or(0, |b| b.count) {
            let before = best.as_ref().map_or(analysis, |b| &b.analysis);
            let found = read(edits, before, Limit::Below(&lightest));
            let is_harmless = |r: &FixRound| stretch.len() == 1 || !harms(before, &r.analysis);
            if let Some((round, now)) = found.filter(|(round, _)| is_harmless(round)) {
                (best, lightest, chosen) = (Some(round), now, tried);
                continue;
            }
            *left -= 1;
        }
        if stretch.len() > 1 {
            let middle = stretch.start + stretch.len() / 2;
            stretches.extend([stretch.start..middle, middle..stretch.end]);
        }
    }
    // A guess that writes an operation anew is dropped where the other fixes leave as little to be said.
    let is_long = |fix: &Fix| {
        let lines = fix.edits.iter().map(|e| e.text.matches('\n').count());
        is_guess(fix) && lines.sum::<usize>() >= LONG_GUESS_LINES
    };
    for i in (0..all.len()).filter(|&i| is_long(&all[i])) {
        let is_one_of_many = chosen[i] && chosen.iter().filter(|c| **c).count() > 1;
        if *left == 0 || !is_one_of_many {
            continue;
        }
        *left -= 1;
        let mut fewer = chosen.clone();
        fewer[i] = false;
        if let Some((round, now)) = read(edits_of(&fewer), analysis, Limit::AtMost(&lightest)) {
            (best, lightest, chosen) = (Some(round), now, fewer);
        }
    }
    best
}

/// Whether every token outside of the edits is as it was.
fn leaves_the_rest(before: &Analysis, edits: &[Edit], after: &Analysis) -> bool {
    let (old, new) = (
        (before.source.text.as_str(), &before.document),
        (after.source.text.as_str(), &after.document),
    );
    preserved::by_edits(old, edits, new)
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Analysis {
        /// Adds findings to those of the analysis.
        fn add(&mut self, more: Vec<Diagnostic>) {
            let mut all = self.take_findings();
            all.extend(more);
            self.findings = all.into();
        }
    }
    use crate::diagnostics::{Code, Diagnostic};

    fn fixed(text: &str, unsafe_too: bool) -> (String, usize) {
        let analysis = Analysis::new("a.zpg", text.into());
        let mended = to_fixed_point(analysis, unsafe_too, Analysis::of);
        let mut again = text.to_owned();
        for edits in &mended.rounds {
            again = fixes::edited(&again, edits);
        }
        assert_eq!(mended.analysis.source.text, again);
        (again, mended.count)
    }

    #[test]
    fn until_none_is_left() {
        // The separators hide that two records share a line.
        let (text, count) = fixed("2 11 <0,1,2> 1 3 9 0,5\n1 9999 2 0\n", false);
        assert_eq!(text, "2 11 0 1 2 1\n3 9 0.5\n1 9999 2 0\n");
        assert_eq!(count, 3);
        // What cannot be mended stays byte for byte.
        let broken = "2 9 # of what size? #\n1 9999 2 0\n";
        assert_eq!(fixed(broken, true), (broken.to_owned(), 0));
    }

    /// Lines that begin with `;` are ignored, and lines that begin with words are no part of a scene. To read words as
    /// a comment is a guess.
    #[test]
    fn what_is_left_is_a_scene() {
        let prose = "; replace it with the";
        assert_eq!(fixed(prose, false), (prose.to_owned(), 0));
        assert_eq!(fixed(prose, true), ("0 # replace it with the #".into(), 1));
        let records = "2 9 1;\n; 3 9 1;\n1 9999 2 0\n";
        let mended = "2 9 1\n 3 9 1\n1 9999 2 0\n";
        // The marks of one line are one finding.
        assert_eq!(fixed(records, true), (mended.to_owned(), 2));
    }

    #[test]
    fn what_a_fix_brings_to_light_is_mended_too() {
        // A malformed number hides that the box is the wrong way round.
        let (text, count) = fixed("10 12 1 1 1 0,5 0 0\n1 9999 10 0\n", false);
        assert_eq!(
            (text.as_str(), count),
            ("10 12 0.5 0 0 1 1 1\n1 9999 10 0\n", 2)
        );
        // One error hides two others: there would be more errors than before.
        let hidden = "9 -501 0 0 9,5 0 0 0 0 1 0 200\n2 9 1\n1 9999 2 0\n";
        assert_eq!(fixed(hidden, true), (hidden.to_owned(), 0));
    }

    /// No error comes up on a line that nobody changed, whatever is repaired elsewhere.
    #[test]
    fn no_error_where_there_was_none() {
        let read = |source: SourceFile| {
            let mut analysis = Analysis::of(source);
            let text = &analysis.source.text;
            if text.contains("0.5") {
                let at = text.find("3 9 1").unwrap() as u32;
                let span = crate::diagnostics::Span::new(at, at + 1);
                analysis.add(vec![Diagnostic::new(Code::E102, span)]);
            }
            analysis
        };
        let text = "2 11 0,5 0 0 1\n3 9 1\n5 9 0,25\n4 -101 2 3\n6 -101 4 5\n1 9999 6 0\n";
        let first = read(SourceFile::new("a.zpg", text.into()));
        let Mended {
            analysis, count, ..
        } = to_fixed_point(first, false, read);
        assert_eq!(
            (analysis.source.text, count),
            (text.replace("0,25", "0.25"), 1)
        );
    }

    /// Applies the fixes of a scene that checks worse where `harmful` says so. Returns the scene, the number of fixes,
    /// and how often it was read.
    fn counting(text: &str, harmful: impl Fn(&str) -> bool) -> (Analysis, usize, usize) {
        let reads = std::cell::Cell::new(0);
        let read = |source: SourceFile| {
            reads.set(reads.get() + 1);
            let bad = harmful(&source.text);
            let mut analysis = Analysis::of(source);
            if bad {
                let error = Diagnostic::new(Code::E101, Default::default());
                analysis.add(vec![error; 9000]);
            }
            analysis
        };
        let mended = to_fixed_point(Analysis::new("a.zpg", text.into()), false, read);
        (mended.analysis, mended.count, reads.get())
    }

    #[test]
    fn one_that_does_harm_holds_up_no_other() {
        let lines = |n: usize| -> String { (2..n + 2).map(|k| format!("{k} 9 1;\n")).collect() };
        let text = lines(2000);
        let (analysis, count, reads) = counting(&text, |t| !t.contains("\n700 9 1;"));
        assert_eq!(count, 1999);
        assert_eq!(
            analysis.source.text,
            text.replace(';', "").replace("\n700 9 1\n", "\n700 9 1;\n")
        );
        // Halving finds it: a few reads for each bit of its number, in two rounds.
        assert!(reads < 60, "{reads}");
        // What was refused is offered no more.
        let offered = |l: &Analysis| l.findings().iter().filter(|d| !d.fixes.is_empty()).count();
        assert_eq!(offered(&analysis), 0);
        // A hundred at the very front.
        let text = lines(400);
        let refused = |t: &str| t.lines().take(100).any(|l| !l.ends_with(';'));
        let (analysis, count, _) = counting(&text, refused);
        assert_eq!(count, 300);
        assert_eq!(analysis.source.text.matches(';').count(), 100);
    }

    /// A fix that brings a warning of another kind is refused, even if fixes beside it repair other findings.
    #[test]
    fn none_rides_along_that_does_harm() {
        let read = |source: SourceFile| {
            let mut analysis = Analysis::of(source);
            if !analysis.source.text.contains("2 14 1 3") {
                analysis.add(vec![Diagnostic::new(Code::W301, Default::default())]);
            }
            analysis
        };
        // The tori are the wrong way round; turning the first one does harm here.
        let text = "2 14 1 3\n3 14 1 4\n4 14 1 5\n5 -101 2 3\n6 -101 5 4\n1 9999 6 0\n";
        let first = read(SourceFile::new("a.zpg", text.into()));
        let Mended {
            analysis, count, ..
        } = to_fixed_point(first, true, read);
        let mended = text.replace("14 1 4", "14 4 1").replace("14 1 5", "14 5 1");
        assert_eq!((analysis.source.text, count), (mended, 2));
    }

    #[test]
    fn guesses_only_where_they_may_be() {
        let torus = "2 14 1 3\n1 9999 2 0\n";
        assert_eq!(fixed(torus, false), (torus.to_owned(), 0));
        assert_eq!(fixed(torus, true), ("2 14 3 1\n1 9999 2 0\n".to_owned(), 1));
    }

    #[test]
    fn the_encoding_and_the_line_breaks_stay() {
        let bytes = b"# \xf8 #\r\n2 9 0,5 # \xe9 # 3 9 1\r\n1 9999 2 0\r\n".to_vec();
        let analysis = to_fixed_point(Analysis::new("a.zpg", bytes), false, Analysis::of).analysis;
        let out = analysis.source.encode(&analysis.source.text);
        let expected = b"0 # \xf8 #\r\n2 9 0.5 # \xe9 #\r\n3 9 1\r\n1 9999 2 0\r\n";
        assert_eq!(out.as_deref(), Some(&expected[..]));
    }
}
