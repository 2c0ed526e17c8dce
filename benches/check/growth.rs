//! How the time grows with the number of records.

use std::fmt::Write;
use std::path::Path;

use super::scenes::RECORDS;
use super::{Table, least};
use zpg::analysis::Analysis;

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
    if std::fs::write(path, svg(&curves)).is_ok() {
        println!("\n`{path}` has the curves.");
    }
}

/// Logarithmic on both axes: records to the right, seconds upwards.
fn svg(curves: &[(&str, Vec<f64>)]) -> String {
    const COLOURS: [&str; 6] = [
        "#1b9e77", "#d95f02", "#7570b3", "#e7298a", "#66a61e", "#a6761d",
    ];
    let x = |n: usize| 60.0 + 160.0 * ((n as f64).log10() - 3.0);
    let y = |seconds: f64| 40.0 + 80.0 * (1.0 - seconds.log10());
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"760\" height=\"520\" font-family=\"sans-serif\" font-size=\"12\">\n".to_owned();
    for decade in -4..=1 {
        let at = y(10f64.powi(decade));
        let _ = writeln!(
            out,
            "<path d=\"M60 {at}H540\" stroke=\"#ccc\"/><text x=\"8\" y=\"{at}\">1e{decade} s</text>"
        );
    }
    for n in COUNTS {
        let at = x(n);
        let _ = writeln!(
            out,
            "<path d=\"M{at} 40V440\" stroke=\"#ccc\"/><text x=\"{at}\" y=\"460\">{n}</text>"
        );
    }
    for (i, (name, times)) in curves.iter().enumerate() {
        let points: Vec<String> = (COUNTS.iter().zip(times))
            .map(|(&n, &t)| format!("{:.1},{:.1}", x(n), y(t.max(1e-4))))
            .collect();
        let last = times.last().copied().unwrap_or(1.0);
        let _ = writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/><text x=\"548\" y=\"{}\" fill=\"{1}\">{name}</text>",
            points.join(" "),
            COLOURS[i % COLOURS.len()],
            y(last) + 4.0,
        );
    }
    out + "</svg>\n"
}
