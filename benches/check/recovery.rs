//! Mistakes in random scenes: how often the first error is in its place, and how often it is the only one.

#[path = "../../tests/mutations/measure.rs"]
mod measure;
#[path = "../../tests/campaign/rng.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod rng;
#[path = "../../tests/mutations/scenes.rs"]
mod scenes;

use std::ops::Range;

use super::Table;
use measure::{Layout, shares};

/// The scenes that are made, other ones than those of the tests.
const SEEDS: Range<u64> = 40_000_000..40_020_000;

pub fn recovery(table: &mut Table) {
    let single = |layout| shares(layout, 1, SEEDS).0.map(|share| 100.0 * share);
    let lines = single(Layout::Lines);
    table.add("mistakes, in lines: localised", lines[0], "%", 99.9, true);
    table.add("mistakes, in lines: single", lines[1], "%", 99.9, true);
    let free = single(Layout::Free);
    table.add("mistakes, free form: localised", free[0], "%", 99.0, true);
    table.add("mistakes, free form: single", free[1], "%", 97.0, true);
    let (mut right, mut all) = (0.0, 0);
    for mistakes in 2..=4 {
        let ([_, share], count, _) = shares(Layout::Lines, mistakes, SEEDS);
        right += share * count as f64;
        all += count;
    }
    let share = 100.0 * right / all as f64;
    let what = "two to four mistakes, in lines: as many errors";
    table.add(what, share, "%", 98.0, true);
}
