//! Work-precision diagrams as SVG: one panel for each kind of error, all with the same axes, error on x and time on y,
//! both logarithmic. A gutter on the left has the points without any error.

use super::super::configurations::{Axis, Kind};
use super::super::number_format::{self, local, say};
use super::super::report::{Report, Row};
use super::labels::{self, Label, LabelBox, Placed, Surroundings};
use crate::diagnostics::Language;
use crate::study::page::{VARIABLES, escaped};
use std::fmt::Write as _;

/// The style of the diagram's parts.
pub const STYLE: &str = "\
svg.panels{width:100%;height:auto;display:block;font-family:system-ui,'DejaVu Sans',sans-serif}
.pane{fill:none;stroke:var(--line)}.gut{fill:var(--card);stroke:var(--line);stroke-dasharray:2 2}
.grid{stroke:var(--line);stroke-width:.7}.grid.one{stroke:var(--mut);stroke-width:1}
.goal{stroke:var(--goal);stroke-width:1.4;stroke-dasharray:5 3}.floor{fill:var(--floor)}
.tick{font-size:11.5px;fill:var(--mut)}.tiny{font-size:10.5px;fill:var(--mut)}.lab{font-size:11px}
.ttl{font-size:15px;font-weight:700;fill:var(--fg)}.sub{font-size:12px;fill:var(--mut)}
.front{stroke:var(--mut);stroke-width:6;opacity:.22;fill:none;stroke-linejoin:round}
.curve{fill:none;stroke-width:1.4}.lead{fill:none;stroke-width:.7;opacity:.6}.def{fill:none;stroke:var(--fg);stroke-width:1.6}
.c1{stroke:var(--c1)}.c2{stroke:var(--c2)}.c3{stroke:var(--c3)}.c4{stroke:var(--c4)}.c5{stroke:var(--c5)}.c6{stroke:var(--c6)}
.c1.full{fill:var(--c1)}.c2.full{fill:var(--c2)}.c3.full{fill:var(--c3)}.c4.full{fill:var(--c4)}.c5.full{fill:var(--c5)}.c6.full{fill:var(--c6)}
.open{fill:var(--bg)}
.c1t{fill:var(--c1)}.c2t{fill:var(--c2)}.c3t{fill:var(--c3)}.c4t{fill:var(--c4)}.c5t{fill:var(--c5)}.c6t{fill:var(--c6)}
";

const WIDTH: f64 = 1080.0;
const HEIGHT: f64 = 360.0;
const TOP: f64 = 46.0;
const BOTTOM: f64 = 292.0;
/// Width of the gutter.
const GUTTER: f64 = 27.0;
/// The powers of ten that the axis of errors spans, in steps.
const DECADES: std::ops::RangeInclusive<i32> = -6..=2;

/// The colour and the marker of an axis: no two in one panel share either.
fn marker(axis: Axis) -> (&'static str, Shape) {
    match axis {
        Axis::Samples => ("c1", Shape::Circle),
        Axis::Adaptive => ("c2", Shape::Square),
        Axis::Depth => ("c3", Shape::Triangle),
        Axis::Cutoff => ("c4", Shape::Diamond),
        Axis::Precision => ("c5", Shape::Circle),
        Axis::Solver => ("c6", Shape::Square),
        Axis::Tessellation => ("c3", Shape::Triangle),
        Axis::Levels => ("c4", Shape::Diamond),
    }
}

#[derive(Clone, Copy)]
enum Shape {
    Circle,
    Square,
    Triangle,
    Diamond,
}

impl Shape {
    fn sign(self) -> char {
        match self {
            Shape::Circle => '●',
            Shape::Square => '■',
            Shape::Triangle => '▲',
            Shape::Diamond => '◆',
        }
    }

    fn draw(self, x: f64, y: f64, class: &str) -> String {
        match self {
            Shape::Circle => {
                format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.2\" class=\"{class}\"/>")
            }
            Shape::Square => {
                let (x, y) = (x - 3.8, y - 3.8);
                format!(
                    "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"7.6\" height=\"7.6\" class=\"{class}\"/>"
                )
            }
            Shape::Triangle => {
                let y = y - 5.0;
                format!("<path d=\"M{x:.1} {y:.1}l4.8 8.4h-9.6z\" class=\"{class}\"/>")
            }
            Shape::Diamond => {
                let y = y - 5.4;
                format!("<path d=\"M{x:.1} {y:.1}l5.4 5.4l-5.4 5.4l-5.4-5.4z\" class=\"{class}\"/>")
            }
        }
    }
}

/// The diagram as an SVG file of its own.
pub fn file(report: &Report, language: Language) -> String {
    let panels = panels(report, language);
    let open = "<svg ";
    let style = format!(
        "<style>{VARIABLES}{STYLE}</style><rect width=\"100%\" height=\"100%\" style=\"fill:var(--bg)\"/>"
    );
    match panels.find('>') {
        Some(end) => {
            let head =
                panels[..end].replacen(open, "<svg xmlns=\"http://www.w3.org/2000/svg\" ", 1);
            format!("{head}>{style}{}\n", &panels[end + 1..])
        }
        None => panels,
    }
}

/// The map from values to places in a panel.
struct Scale {
    /// The left end of the gutter.
    left: f64,
    /// The left and the right end of the logarithmic part.
    x: [f64; 2],
    /// The ends of the axis of times, as exponents of 2.
    low: f64,
    high: f64,
}

impl Scale {
    fn x(&self, error: f64) -> f64 {
        if error <= 0.0 {
            return self.left + GUTTER / 2.0;
        }
        let (a, b) = (f64::from(*DECADES.start()), f64::from(*DECADES.end()));
        let share = ((error.log10() - a) / (b - a)).clamp(0.0, 1.0);
        self.x[0] + share * (self.x[1] - self.x[0])
    }

    fn y(&self, times: f64) -> f64 {
        let share = (times.max(1e-9).log2() - self.low) / (self.high - self.low);
        BOTTOM - 12.0 - share.clamp(0.0, 1.0) * (BOTTOM - TOP - 24.0)
    }
}

/// Draws a panel for each kind of error that has rows to be shown.
pub fn panels(report: &Report, language: Language) -> String {
    let kinds: Vec<Kind> = (Kind::ALL.into_iter())
        .filter(|&k| report.of_kind(k).any(is_shown))
        .collect();
    let times: Vec<f64> = (report.rows.iter())
        .filter(|r| is_shown(r))
        .filter_map(|r| r.times_default)
        .collect();
    let low = times.iter().copied().fold(0.5, f64::min).log2().floor();
    let high = times.iter().copied().fold(2.0, f64::max).log2().ceil();
    let label = escaped(&say(language, "accuracy-panels-alt", &[]));
    let mut out = format!(
        "<svg class=\"panels\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"{label}\">\n"
    );
    let first = 62.0;
    let each = (WIDTH - first) / kinds.len().max(1) as f64;
    for (i, &kind) in kinds.iter().enumerate() {
        let left = first + each * i as f64;
        let scale = Scale {
            left,
            x: [left + GUTTER + 3.0, left + each - 14.0],
            low,
            high,
        };
        panel(&mut out, report, kind, &scale, i == 0, language);
    }
    out.push_str("</svg>");
    out
}

fn is_shown(row: &Row) -> bool {
    row.times_default.is_some() && row.error.is_some() && row.same_as.is_none()
}

fn panel(
    out: &mut String,
    report: &Report,
    kind: Kind,
    s: &Scale,
    is_first: bool,
    language: Language,
) {
    let (name, sub) = match kind {
        Kind::Edges => ("accuracy-head-edges", "accuracy-sub-edges"),
        Kind::Light => ("accuracy-head-light", "accuracy-sub-light"),
        Kind::Numbers => ("accuracy-head-numbers", "accuracy-sub-numbers"),
        Kind::Facets => ("accuracy-head-facets", "accuracy-sub-facets"),
    };
    let [x0, x1] = s.x;
    let height = BOTTOM - TOP;
    let _ = writeln!(
        out,
        "<rect x=\"{:.1}\" y=\"{TOP}\" width=\"{GUTTER}\" height=\"{height}\" class=\"gut\"/>\
         <rect x=\"{x0:.1}\" y=\"{TOP}\" width=\"{:.1}\" height=\"{height}\" class=\"pane\"/>",
        s.left,
        x1 - x0
    );
    let margin = report.margin(kind);
    if margin > 0.0 {
        let end = s.x(margin);
        let _ = writeln!(
            out,
            "<rect x=\"{x0:.1}\" y=\"{TOP}\" width=\"{:.1}\" height=\"{height}\" class=\"floor\"/>",
            (end - x0).max(0.0)
        );
        if end - x0 > 120.0 {
            let text = escaped(&say(language, "accuracy-own-error", &[]));
            let _ = writeln!(
                out,
                "<text x=\"{:.1}\" y=\"{}\" class=\"tiny\" text-anchor=\"middle\">{text}</text>",
                (x0 + end) / 2.0,
                BOTTOM - 6.0
            );
        }
    }
    for (message, y, class) in [(name, 16, "ttl"), (sub, 34, "sub")] {
        let text = escaped(&say(language, message, &[]));
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{y}\" class=\"{class}\">{text}</text>",
            s.left
        );
    }
    let step = if s.high - s.low > 9.0 { 2 } else { 1 };
    for power in (s.low as i32..=s.high as i32).filter(|p| p % step == 0) {
        let times = f64::from(power).exp2();
        let y = s.y(times);
        let one = if power == 0 { " one" } else { "" };
        let _ = writeln!(
            out,
            "<path d=\"M{x0:.1} {y:.1}H{x1:.1}\" class=\"grid{one}\"/>"
        );
        if is_first {
            let label = local(
                language,
                if times >= 1.0 {
                    format!("{times:.0} ×")
                } else {
                    format!("{times} ×")
                },
            );
            let _ = writeln!(
                out,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" class=\"tick\">{label}</text>",
                s.left - 8.0,
                y + 4.0
            );
        }
    }
    for decade in DECADES {
        let x = s.x(10f64.powi(decade));
        let _ = writeln!(out, "<path d=\"M{x:.1} {TOP}V{BOTTOM}\" class=\"grid\"/>");
        if decade % 2 == 0 && decade > -6 {
            let label = match decade {
                -2 => local(language, "0.01".into()),
                0 => "1".into(),
                2 => "100".into(),
                _ => "10<tspan dy=\"-4\" font-size=\"8\">−4</tspan>".to_string(),
            };
            let anchor = if decade == 2 { "end" } else { "middle" };
            let _ = writeln!(
                out,
                "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"{anchor}\" class=\"tick\">{label}</text>",
                BOTTOM + 16.0
            );
        }
    }
    let none = escaped(&say(language, "accuracy-none", &[]));
    let _ = writeln!(
        out,
        "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\" class=\"tick\">{none}</text>",
        s.left + GUTTER / 2.0,
        BOTTOM + 16.0
    );
    let goal = s.x(report.goal.steps);
    let _ = writeln!(
        out,
        "<path d=\"M{goal:.1} {}V{BOTTOM}\" class=\"goal\"/>",
        TOP - 4.0
    );
    let rows: Vec<&Row> = report.of_kind(kind).filter(|r| is_shown(r)).collect();
    marks(out, report, &rows, s, language);
    let mut axes: Vec<Axis> = rows.iter().filter_map(|r| r.of.map(|of| of.1)).collect();
    axes.dedup();
    let keys: Vec<String> = (axes.iter())
        .map(|&axis| {
            let (class, shape) = marker(axis);
            format!(
                "<tspan class=\"{class}t\">{} {}</tspan>",
                shape.sign(),
                axis.name()
            )
        })
        .collect();
    let _ = writeln!(
        out,
        "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\" class=\"tick\">{}</text>",
        (s.left + x1) / 2.0,
        BOTTOM + 36.0,
        keys.join(" · ")
    );
}

fn place(s: &Scale, row: &Row) -> (f64, f64) {
    let error = row.error.as_ref();
    let steps = error.map_or(0.0, |e| {
        if e.pixels_differ == 0 {
            0.0
        } else {
            e.steps.max(1e-12)
        }
    });
    (s.x(steps), s.y(row.times_default.unwrap_or(1.0)))
}

fn marks(out: &mut String, report: &Report, rows: &[&Row], s: &Scale, language: Language) {
    let line = |places: &[(f64, f64)]| -> String {
        let points: Vec<String> = places
            .iter()
            .map(|(x, y)| format!("{x:.1} {y:.1}"))
            .collect();
        points.join("L")
    };
    let segments = |places: &[(f64, f64)], weight: f64| -> Vec<([[f64; 2]; 2], f64)> {
        let pairs = places.windows(2);
        pairs
            .map(|p| ([[p[0].0, p[0].1], [p[1].0, p[1].1]], weight))
            .collect()
    };
    let mut front: Vec<(f64, f64)> = rows
        .iter()
        .filter(|r| r.pareto)
        .map(|r| place(s, r))
        .collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    if front.len() > 1 {
        let _ = writeln!(out, "<path d=\"M{}\" class=\"front\"/>", line(&front));
    }
    let best = super::super::advice::recommended(report).map(Row::name);
    let goal = s.x(report.goal.steps);
    let one = s.y(1.0);
    let mut around = Surroundings {
        within: LabelBox([s.left, TOP, s.x[1] - 2.0, BOTTOM]),
        points: Vec::new(),
        lines: vec![
            ([[goal, TOP], [goal, BOTTOM]], 0.6),
            ([[s.x[0], one], [s.x[1], one]], 0.4),
        ],
    };
    around.lines.extend(segments(&front, 0.3));
    let (mut labels, mut names) = (Vec::new(), Vec::new());
    for axis in Axis::ALL {
        let own: Vec<&&Row> = rows.iter().filter(|r| r.is_on(axis)).collect();
        let places: Vec<(f64, f64)> = own.iter().map(|r| place(s, r)).collect();
        let (class, shape) = marker(axis);
        // Numbers and solvers are no sequence: no curve joins their points.
        let is_ladder = !matches!(axis, Axis::Precision | Axis::Solver);
        if is_ladder && places.len() > 1 {
            let _ = writeln!(
                out,
                "<path d=\"M{}\" class=\"curve {class}\"/>",
                line(&places)
            );
            around.lines.extend(segments(&places, 1.5));
        }
        for (row, (x, y)) in own.iter().zip(&places) {
            if row.default {
                let _ = writeln!(
                    out,
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8.5\" class=\"def\"/>"
                );
            }
            let fill = if row.pareto { "full" } else { "open" };
            let title = format!(
                "{}: {} × {}",
                row.name(),
                number_format::times(language, row.times_default.unwrap_or(1.0)),
                number_format::error(language, row.steps()),
            );
            let mark = shape.draw(*x, *y, &format!("{class} {fill}"));
            let _ = writeln!(out, "<g>{mark}<title>{}</title></g>", escaped(&title));
            labels.push(Label {
                point: around.points.len(),
                width: 6.4 * row.setting.chars().count() as f64,
                needed: row.default || best.as_deref() == Some(&row.name()),
            });
            names.push((class, escaped(&row.setting)));
            around.points.push([*x, *y]);
        }
    }
    for (placed, (class, name)) in labels::place(&labels, &around).into_iter().zip(names) {
        let Some(Placed { frame, leader }) = placed else {
            continue;
        };
        if let Some([[x0, y0], [x1, y1]]) = leader {
            let _ = writeln!(
                out,
                "<path d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\" class=\"lead {class}\"/>"
            );
        }
        let LabelBox([left, _, right, bottom]) = frame;
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\" class=\"lab {class}t\">{name}</text>",
            (left + right) / 2.0,
            bottom - 1.5
        );
    }
}
