//! Moving, turning or scaling a scene and its rays changes no crossing count. `cargo bench --bench
//! invariance` runs a million trials of the same kinds.

mod trials;

use crate::trace_support;
use trials::{exact_trials, rounded_trials};

#[test]
fn exact_changes_change_no_count() {
    let mut tally = exact_trials(1, 100);
    tally.add(exact_trials(2, 100));
    assert!(tally.wrong.is_empty(), "{}", tally.wrong.join("\n"));
    assert!(tally.trials == 10_000 && tally.met > 3000, "{tally:?}");
}

#[test]
fn changes_that_round_change_no_count() {
    let mut tally = rounded_trials(3, 100);
    tally.add(rounded_trials(4, 100));
    assert!(tally.wrong.is_empty(), "{}", tally.wrong.join("\n"));
    assert!(tally.trials == 10_000 && tally.met > 3000, "{tally:?}");
    // Random rays are hardly ever that close; rays along an axis may be parallel to a plane.
    assert!(tally.excluded <= 20, "{}", tally.excluded);
}
