//! How many times as long the peer takes, as bars.

use std::fmt::Write;

/// A picture: what it is called, and how many times as long the peer takes.
pub type Row<'a> = (&'a str, f64);

/// Bars on a logarithmic axis from 1 to 1000.
pub fn svg(rows: &[Row]) -> String {
    const LEFT: f64 = 290.0;
    const TOP: f64 = 40.0;
    const STEP: f64 = 24.0;
    let x = |ratio: f64| LEFT + 140.0 * ratio.max(1.0).log10();
    let bottom = TOP + STEP * rows.len() as f64;
    let height = bottom + 30.0;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"760\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"760\" height=\"{height}\" fill=\"white\"/>\n<text x=\"{LEFT}\" y=\"20\" font-weight=\"bold\">POV-Ray's processor time divided by that of zpg</text>\n"
    );
    for tick in [1.0, 10.0, 100.0, 1000.0] {
        let at = x(tick);
        let _ = writeln!(
            out,
            "<path d=\"M{at} {TOP}V{bottom}\" stroke=\"#ccc\"/><text x=\"{at}\" y=\"{}\" text-anchor=\"middle\" fill=\"#555\">{tick}</text>",
            bottom + 18.0
        );
    }
    for (i, (name, ratio)) in rows.iter().enumerate() {
        let y = TOP + STEP * i as f64;
        let end = x(*ratio);
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{name}</text><rect x=\"{LEFT}\" y=\"{}\" width=\"{:.1}\" height=\"16\" fill=\"#1b9e77\"/><text x=\"{:.1}\" y=\"{1}\">{ratio:.1}</text>",
            LEFT - 8.0,
            y + 17.0,
            y + 4.0,
            end - LEFT,
            end + 6.0,
        );
    }
    out + "</svg>\n"
}
