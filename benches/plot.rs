//! Curves of times.

use std::fmt::Write;

/// Logarithmic on both axes: records to the right, seconds upwards.
pub fn svg(counts: &[usize], curves: &[(&str, Vec<f64>)]) -> String {
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
    for &n in counts {
        let at = x(n);
        let _ = writeln!(
            out,
            "<path d=\"M{at} 40V440\" stroke=\"#ccc\"/><text x=\"{at}\" y=\"460\">{n}</text>"
        );
    }
    for (i, (name, times)) in curves.iter().enumerate() {
        let points: Vec<String> = (counts.iter().zip(times))
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
