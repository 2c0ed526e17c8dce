//! A million trials of `tests/invariance.rs`: half with changes that are exact in doubles, half with
//! changes that round. Says how many crossing counts have changed; fails if any.

#[expect(dead_code, reason = "the tests use the rest")]
#[path = "../tests/trace_support/mod.rs"]
mod trace_support;
#[path = "../tests/invariance/trials.rs"]
mod trials;

use rayon::prelude::*;
use std::process::ExitCode;
use std::time::Instant;
use trials::{Tally, exact_trials, rounded_trials};

/// Shares of 100 scenes with 50 rays each, of each kind.
const SHARES: u64 = 100;

fn main() -> ExitCode {
    type Trials = fn(u64, u64) -> Tally;
    let kinds: [(&str, Trials); 2] = [("exact", exact_trials), ("rounded", rounded_trials)];
    let mut failed = false;
    for (name, trials) in kinds {
        let start = Instant::now();
        let shares: Vec<Tally> = (0..SHARES)
            .into_par_iter()
            .map(|share| trials(1000 + share, 100))
            .collect();
        let mut all = Tally::default();
        shares.into_iter().for_each(|t| all.add(t));
        for line in all.wrong.iter().take(20) {
            println!("{line}");
        }
        println!(
            "{name}: {} trials, {} met something, {} excluded, {} counts changed, {:.1} s",
            all.trials,
            all.met,
            all.excluded,
            all.wrong.len(),
            start.elapsed().as_secs_f64()
        );
        failed |= !all.wrong.is_empty();
    }
    if failed {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    }
}
