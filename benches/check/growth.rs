//! How the time grows with the number of records.

use std::path::Path;

use super::scenes::RECORDS;
use super::{Table, least, plot};
use zpg::internals::analysis::Analysis;

const COUNTS: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];

/// What leaves the cache may take longer for that by itself.
const CACHE: f64 = 2.0;

/// Six kinds of records, 10³ to 10⁶ of them: no step of ten times as many takes longer than n·log n and the cache
/// make it. Draws `growth.svg` in the target folder.
pub fn growth(_folder: &Path, table: &mut Table) {
    let mut curves = Vec::new();
    for (name, write) in RECORDS {
        let times: Vec<f64> = COUNTS
            .iter()
            .map(|&count| {
                let text = write(count);
                let runs = if count < 1_000_000 { 5 } else { 2 };
                let time = least(runs, || {
                    let analysis = Analysis::new("scene.zpg", text.clone().into_bytes());
                    std::hint::black_box(analysis.findings().len());
                });
                time.as_secs_f64()
            })
            .collect();
        let worst = (1..COUNTS.len())
            .map(|i| {
                let n_log_n = |n: usize| n as f64 * (n as f64).ln();
                times[i] / times[i - 1] / (n_log_n(COUNTS[i]) / n_log_n(COUNTS[i - 1]))
            })
            .fold(0.0, f64::max);
        table.add(
            format!("growth: {name}, the worst step beside n log n"),
            worst,
            "×",
            CACHE,
            false,
        );
        curves.push((name, times));
    }
    let path = concat!(env!("CARGO_TARGET_TMPDIR"), "/growth.svg");
    if std::fs::write(path, plot::svg(&COUNTS, &curves)).is_ok() {
        println!("\n`{path}` has the curves.");
    }
}
