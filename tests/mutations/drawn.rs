//! Guesses on mutants: a scene that draws something still does after all of them, and no guess is guessed again.

use std::sync::atomic::Ordering::Relaxed;

use rayon::prelude::*;
use zpg::internals::analysis::fixing::{self, Mended};
use zpg::internals::analysis::{Analysis, repair};
use zpg::internals::diagnostics::Edit;

use super::{corpus, mutants};
use crate::support::{cases, seeds};

fn read(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

/// The scenes that draw something and are short enough to be mended often.
fn drawing() -> Vec<String> {
    let random = crate::people::texts(seeds("DRAWN", 0..8));
    let all = corpus().into_iter().map(|c| c.1).chain(random);
    all.filter(|text: &String| {
        let analysis = read(text);
        text.len() < 6000 && analysis.is_sound() && !repair::draws_nothing(&analysis)
    })
    .collect()
}

/// What an edit of a later round changes of what an earlier one has written.
fn again(rounds: &[Vec<Edit>]) -> Option<String> {
    // Where the text of earlier edits is now.
    let mut written: Vec<(u32, u32)> = Vec::new();
    for edits in rounds {
        // What puts in records changes the whole of a scene.
        let is_rewriting = edits.iter().any(|e| e.text.contains('\n'));
        for e in edits.iter().filter(|_| !is_rewriting) {
            let touched = |w: &(u32, u32)| e.span.start < w.1 && w.0 < e.span.end;
            if written.iter().any(touched) {
                return Some(format!("{rounds:?}"));
            }
        }
        let shifted = |at: u32| {
            let before = edits.iter().filter(|e| e.span.end <= at);
            let grown: i64 = before
                .map(|e| e.text.len() as i64 - i64::from(e.span.end - e.span.start))
                .sum();
            (i64::from(at) + grown) as u32
        };
        let moved = written.iter().map(|w| (shifted(w.0), shifted(w.1)));
        let mut next: Vec<(u32, u32)> = moved.collect();
        next.extend(edits.iter().map(|e| {
            let end = shifted(e.span.end);
            (end - e.text.len() as u32, end)
        }));
        written = next;
    }
    None
}

#[test]
fn no_guesses_end_in_a_scene_that_draws_nothing() {
    let step = cases(29, 1);
    let count = std::sync::atomic::AtomicUsize::new(0);
    let wrong: Vec<String> = (drawing().par_iter())
        .flat_map(|text| {
            let original = read(text);
            let mutants = mutants(text, &original.document);
            let is_clean = fixing::to_fixed_point(original, true, Analysis::of).count == 0;
            let mut wrong = Vec::new();
            for m in mutants.iter().step_by(step) {
                count.fetch_add(1, Relaxed);
                let mut mutated = text.clone();
                mutated.replace_range(m.at..m.to, &m.with);
                let mended = fixing::to_fixed_point(read(&mutated), true, Analysis::of);
                let Mended {
                    analysis, rounds, ..
                } = mended;
                let line = mutated[..m.at].matches('\n').count();
                let line = mutated.lines().nth(line).unwrap_or_default();
                if repair::draws_nothing(&analysis) {
                    let now = analysis.source.text;
                    wrong.push(format!("{}: {line}: nothing is drawn\n{now}", m.kind));
                }
                if let Some(again) = again(&rounds).filter(|_| is_clean) {
                    wrong.push(format!("{}: {line}: {again}", m.kind));
                }
            }
            wrong
        })
        .collect();
    let count = count.into_inner();
    let told = format!("{} of {count}\n{}", wrong.len(), wrong.join("\n"));
    println!("{told}");
    assert!(wrong.is_empty() && count > 500, "{told}");
}
