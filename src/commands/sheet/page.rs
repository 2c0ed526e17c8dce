//! The sheet as a page: one file, with the pictures in it and no script.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::cell::{Cell, Heading, found};
use super::findings::{Counts, Finding};
use crate::commands::size::Size;
use crate::diagnostics::{Language, Value};
use crate::study::page::{address, escaped, head, prose};

const STYLE: &str = "\
main{padding:20px 16px 48px}h1{font-size:22px;margin:0 0 14px;overflow-wrap:anywhere}
.sheet{display:grid;gap:12px;align-items:start}
figure{margin:0;padding:8px;background:var(--card);border:1px solid var(--line);border-radius:6px;break-inside:avoid}
.shown{display:flex;align-items:center;justify-content:center;background:var(--bg);overflow:hidden}
.shown p{margin:0;padding:8px;text-align:center;overflow-wrap:anywhere}
.shown.wrong{outline:1px dashed var(--goal)}.shown.none{outline:1px dashed var(--line)}
img{display:block;max-width:100%;max-height:100%;height:auto}
figcaption b{display:block;margin-top:6px;overflow-wrap:anywhere}
.errors{color:var(--goal)}.warnings{color:var(--c6)}
details{margin-top:2px}summary{cursor:pointer}ul{margin:4px 0 0;padding-left:18px}li{overflow-wrap:anywhere}
code{font-family:ui-monospace,'DejaVu Sans Mono',monospace;font-size:12px}
@media print{main{padding:0}}
";

/// Most findings of a scene that are listed.
const MAX_FINDINGS_LISTED: usize = 20;

/// Pixels by which a column may be narrower than a thumbnail, so that two columns have room on a small screen.
const COLUMN_SLACK_PIXELS: u32 = 20;
/// The least width of a column in pixels, if a number of columns is asked for.
const MIN_COLUMN_PIXELS: u32 = 140;

/// The style that sets boxes in columns, with room for thumbnails of this size.
fn columns(columns: Option<u32>, size: Size) -> String {
    let width = match columns {
        None => format!(
            "{}px",
            size.width
                .saturating_sub(COLUMN_SLACK_PIXELS)
                .max(MIN_COLUMN_PIXELS)
        ),
        // The gaps between them are 12 pixels each.
        Some(n) => {
            let gaps = 12 * u64::from(n - 1);
            format!("max({MIN_COLUMN_PIXELS}px,calc((100% - {gaps}px)/{n}))")
        }
    };
    format!(
        ".sheet{{grid-template-columns:repeat(auto-fill,minmax(min(100%,{width}),1fr))}}\n\
         .shown{{aspect-ratio:{}/{}}}\n",
        size.width, size.height
    )
}

/// Writes the sheet, whose boxes are read one by one. No row has more than `most` boxes.
pub(super) fn write<'e>(
    out: &mut dyn Write,
    heading: &Heading,
    most: Option<u32>,
    size: Size,
    language: Language,
    cells: impl Iterator<Item = io::Result<Cell<'e>>>,
) -> io::Result<()> {
    let title = escaped(&heading.line(language));
    let style = [STYLE, &columns(most, size)].concat();
    writeln!(out, "{}", head(language, &title, &style))?;
    writeln!(out, "<h1>{title}</h1>\n<div class=\"sheet\">")?;
    for cell in cells {
        writeln!(out, "{}", figure(&cell?, language))?;
    }
    writeln!(out, "</div></main></body></html>")
}

fn figure(cell: &Cell, language: Language) -> String {
    let name = escaped(&cell.entry.name);
    let counts = cell.counts();
    let shown = match (&cell.picture, cell.reason(language)) {
        (Ok(picture), _) => {
            let [width, height] = picture.size;
            let src = address(width, height, &picture.rgb);
            format!(
                "<div class=\"shown\"><img src=\"{src}\" alt=\"{name}\" width=\"{width}\" height=\"{height}\"></div>"
            )
        }
        (Err(_), reason) => {
            let is_wrong = cell.entry.picture.is_some() || counts.is_some_and(|c| c.errors > 0);
            let [class, ink] = if is_wrong {
                ["wrong", "errors"]
            } else {
                ["none", "mut"]
            };
            let reason = prose(&reason.unwrap_or_default());
            format!("<div class=\"shown {class}\"><p class=\"{ink}\">{reason}</p></div>")
        }
    };
    let size = cell.size().map_or(String::new(), |size| {
        format!("<div class=\"mut small\">{}</div>", escaped(&size))
    });
    let listed = cell.entry.scene.map_or(String::new(), |scene| {
        findings(scene.counts(), &scene.findings, language)
    });
    format!("<figure>{shown}<figcaption><b>{name}</b>{size}{listed}</figcaption></figure>")
}

/// The HTML for the findings of a scene: how many there are, and a list below.
fn findings(counts: Counts, findings: &[Finding], language: Language) -> String {
    let [errors, warnings] = counts.parts(language);
    let part = |class: &str, text: Option<String>| {
        text.map(|text| format!("<span class=\"{class}\">{}</span>", escaped(&text)))
    };
    let parts = [part("errors", errors), part("warnings", warnings)];
    let mut summary = parts.into_iter().flatten().collect::<Vec<_>>().join(", ");
    if summary.is_empty() {
        summary = format!(
            "<span class=\"mut\">{}</span>",
            escaped(&found(counts, language).concat())
        );
    }
    if findings.is_empty() {
        return format!("<div class=\"small\">{summary}</div>");
    }
    let mut items = String::new();
    for finding in findings.iter().take(MAX_FINDINGS_LISTED) {
        let class = match finding.severity.as_str() {
            "error" => "errors",
            "warning" => "warnings",
            _ => "mut",
        };
        let place = &finding.span.start;
        let _ = write!(
            items,
            "<li><code class=\"{class}\">{}</code> <span class=\"mut\">{}:{}</span> <span lang=\"en\">{}</span></li>",
            escaped(&finding.code),
            place.line,
            place.column,
            prose(&finding.message)
        );
    }
    if let Some(more) = findings
        .len()
        .checked_sub(MAX_FINDINGS_LISTED)
        .filter(|&more| more > 0)
    {
        let more = language.say("sheet-more", &[("count", Value::Count(more as u64))]);
        let _ = write!(items, "<li class=\"mut\">{}</li>", escaped(&more));
    }
    format!("<details class=\"small\"><summary>{summary}</summary><ul>{items}</ul></details>")
}
