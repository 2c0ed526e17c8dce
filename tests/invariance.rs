//! Moving, turning or scaling a scene and its rays changes no crossing count. `cargo bench --bench
//! invariance` runs a million trials of the same kinds.

mod trace_support;
#[path = "invariance/trials.rs"]
mod trials;

use trials::{exact_trials, rounded_trials};

#[test]
fn exact_changes_change_no_count() {
    let tally = exact_trials(1, 200);
    assert!(tally.wrong.is_empty(), "{}", tally.wrong.join("\n"));
    assert!(tally.trials == 10_000 && tally.met > 3000, "{tally:?}");
}

#[test]
fn changes_that_round_change_no_count() {
    let tally = rounded_trials(2, 200);
    assert!(tally.wrong.is_empty(), "{}", tally.wrong.join("\n"));
    assert!(tally.trials == 10_000 && tally.met > 3000, "{tally:?}");
    // Random rays are hardly ever that close: input rounding is 1e-9 of the scene at worst.
    assert!(tally.excluded <= 2, "{}", tally.excluded);
}
