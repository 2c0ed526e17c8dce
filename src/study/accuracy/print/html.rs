//! The report as one HTML page that needs no other file and no script, for light, dark and print.

use super::super::advice::names;
use super::super::configurations::{Axis, Kind};
use super::super::number_format::{self, each, local, say};
use super::super::report::{Report, Row};
use super::image;
use super::svg;
use super::tables::{self, Table};
use super::terminal::{sureness, whole_default};
use crate::diagnostics::Language;
use crate::study::page::{self, escaped, prose};
use std::fmt::Write as _;

const STYLE: &str = "\
@media print{section{break-inside:avoid}main{max-width:none!important;padding:0!important}}
.wide{overflow-x:auto}
main{max-width:1120px;margin:0 auto;padding:28px 20px 60px}h1{font-size:27px;margin:0}h2{font-size:19px;margin:34px 0 6px}
p,li,h1,h2{overflow-wrap:anywhere}p{margin:.35em 0;max-width:88ch}
header{display:flex;gap:24px;align-items:flex-start;justify-content:space-between}header img{width:320px;border-radius:4px}
img{image-rendering:pixelated;display:block;max-width:100%}
.advice{border-left:5px solid var(--acc);background:var(--card);padding:14px 18px;font-size:19px;line-height:1.45;margin:16px 0;border-radius:0 6px 6px 0;max-width:74ch}
.advice code{font-size:17px}code{font-family:ui-monospace,'DejaVu Sans Mono',monospace;font-size:13px;background:color-mix(in srgb,var(--fg) 8%,transparent);padding:1px 4px;border-radius:3px;overflow-wrap:anywhere}
.tiles{display:grid;grid-template-columns:repeat(3,1fr);gap:14px;margin:14px 0}.tile{background:var(--card);border-radius:6px;padding:10px 14px;border:1px solid var(--line)}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums;font-size:14px}
th{text-align:left;font-weight:600;border-bottom:2px solid var(--line);padding:5px 8px;vertical-align:bottom}
td{padding:4px 8px;border-bottom:1px solid var(--line);vertical-align:top}tbody td:first-child{white-space:nowrap}td.n,th.n{text-align:right;white-space:nowrap}
tr.def td{background:var(--card);font-weight:600}tr.rec td{background:color-mix(in srgb,var(--acc) 14%,transparent)}
tr.k td{font-weight:700;padding-top:12px;border-bottom:2px solid var(--line)}
.bar{display:inline-block;height:9px;background:var(--bar);vertical-align:middle;border-radius:2px}
figure{margin:0}figcaption{font-size:13px;color:var(--mut);margin-top:4px}
.row{display:grid;grid-template-columns:repeat(3,1fr);gap:14px;margin:10px 0 18px}.row img{width:100%}
.two{display:grid;grid-template-columns:1fr 1fr;gap:26px}.two img{width:100%}
@media (max-width:760px){header,.two,.tiles{display:block}.row{grid-template-columns:1fr}}
";

struct Page<'r> {
    report: &'r Report,
    language: Language,
    out: String,
}

pub fn text(report: &Report, language: Language) -> String {
    let mut page = Page {
        report,
        language,
        out: String::new(),
    };
    page.head();
    page.panels();
    page.table();
    page.pictures();
    page.shares();
    page.rest();
    page.out
}

impl Page<'_> {
    fn say(&self, message: &'static str) -> String {
        escaped(&say(self.language, message, &[]))
    }

    fn add(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn section(&mut self, heading: &'static str, note: &'static str) {
        let (heading, note) = (self.say(heading), self.say(note));
        self.add(&format!(
            "<section><h2>{heading}</h2><p class=\"small mut\">{note}</p>"
        ));
    }

    fn head(&mut self) {
        let report = self.report;
        let [w, h] = report.size;
        let title = self.say("accuracy-title");
        let scene = escaped(&report.scene);
        let style = [svg::STYLE, STYLE].concat();
        let head = page::head(self.language, &format!("{title}: {scene}"), &style);
        self.add(&head);
        let first = report
            .advice_parts
            .first()
            .map_or(String::new(), |a| prose(&a.text));
        let picture = match &report.picture {
            Some(raster) => format!("<img src=\"{}\" alt=\"\">", image::picture(raster)),
            None => String::new(),
        };
        let stopped = match report.stopped {
            true => format!("<p>{}</p>", self.say("accuracy-stopped")),
            false => String::new(),
        };
        self.add(&format!(
            "<header><div><div class=\"mut small\">zpg accuracy · {scene} · {w} × {h}</div><h1>{title}</h1>{stopped}\
             <div class=\"advice\">{first}</div></div>{picture}</header>"
        ));
        let tile = |head: String, text: String| {
            format!(
                "<div class=\"tile\"><span class=\"mut small\">{head}</span><p>{text}</p></div>"
            )
        };
        let part = |what: &[&str]| {
            let parts = report
                .advice_parts
                .iter()
                .skip(1)
                .filter(|a| what.contains(&a.what));
            parts.map(|a| prose(&a.text)).collect::<Vec<_>>().join(" ")
        };
        let tiles = [
            tile(
                self.say("accuracy-tile-change"),
                part(&["change", "save", "depth"]),
            ),
            tile(self.say("accuracy-tile-numbers"), part(&["numbers"])),
            tile(
                self.say("accuracy-tile-sure"),
                escaped(&sureness(report, self.language).join(" · "))
                    + " "
                    + &part(&["reference", "busy"]),
            ),
        ];
        self.add(&format!("<div class=\"tiles\">{}</div>", tiles.concat()));
    }

    fn panels(&mut self) {
        self.section("accuracy-section-panels", "accuracy-note-panels");
        let panels = svg::panels(self.report, self.language);
        self.add(&panels);
        self.add("</section>");
    }

    fn table(&mut self) {
        self.section("accuracy-section-table", "accuracy-note-table");
        let heads = self.say("accuracy-table-head");
        let heads: Vec<&str> = heads.trim_matches('|').split('|').map(str::trim).collect();
        let mut head = String::new();
        for (i, text) in heads.iter().enumerate() {
            let class = if i == 0 || i + 1 == heads.len() {
                ""
            } else {
                " class=\"n\""
            };
            let _ = write!(head, "<th{class}>{text}</th>");
        }
        self.add(&format!(
            "<div class=\"wide\"><table><thead><tr>{head}</tr></thead><tbody>"
        ));
        let best = super::super::advice::recommended(self.report).map(Row::name);
        let mut left = 0;
        for kind in Kind::ALL {
            let rows: Vec<&Row> = self.report.of_kind(kind).collect();
            if rows.is_empty() {
                continue;
            }
            let name = escaped(&number_format::kind(self.language, kind));
            self.add(&format!(
                "<tr class=\"k\"><td colspan=\"{}\">{name}</td></tr>",
                heads.len()
            ));
            for row in rows {
                let is_best = best.as_deref() == Some(&row.name());
                let shown = row.default
                    || is_best
                    || names(self.report, row)
                    || (row.pareto && row.same_as.is_none());
                if !shown && !row.is_on(Axis::Precision) {
                    left += 1;
                    continue;
                }
                let text = self.table_row(row, is_best);
                self.add(&text);
            }
        }
        let more = say(
            self.language,
            "accuracy-more-rows",
            &[("left", number_format::count(left))],
        );
        self.add(&format!(
            "</tbody></table></div><p class=\"small mut\">{}</p></section>",
            escaped(&more)
        ));
    }

    fn table_row(&self, row: &Row, is_best: bool) -> String {
        let language = self.language;
        let [w, h] = self.report.size;
        let whole = whole_default(self.report, f64::from(w) * f64::from(h));
        let cpu = row.times_default.zip(whole);
        let cpu = cpu.map_or("–".into(), |(t, d)| {
            number_format::seconds(language, t * d)
        });
        let times = row
            .times_default
            .map_or("–".into(), |t| number_format::times(language, t) + " ×");
        let error = row.error.as_ref();
        let steps = match error {
            Some(e) if e.is_same() => self.say("accuracy-same"),
            Some(e) if e.steps_interval[0] < e.steps_interval[1] && e.steps >= 0.01 => {
                let [a, b] = e.steps_interval.map(|x| number_format::error(language, x));
                let steps = number_format::error(language, e.steps);
                format!("{steps} <span class=\"small mut\">({a} – {b})</span>")
            }
            Some(e) => number_format::error(language, e.steps),
            None => "–".into(),
        };
        let off = error.map_or(String::new(), |e| match e.pixels_off {
            0 => "0".into(),
            n => format!("{n} / {}", e.pixels),
        });
        let flip = error.map_or(String::new(), |e| local(language, format!("{:.4}", e.flip)));
        let mut notes = Vec::new();
        if let Some(other) = &row.same_as {
            notes.push(say(
                language,
                "accuracy-same-as",
                &[("other", other.clone().into())],
            ));
        }
        if row.default {
            notes.push(say(language, "accuracy-default", &[]));
        }
        if is_best {
            notes.push(say(language, "accuracy-recommended", &[]));
        }
        if row.below_reference {
            notes.push(say(language, "accuracy-below-reference", &[]));
        }
        if let Some(wrong) = error.and_then(|e| e.wrong_object).filter(|&n| n > 0) {
            notes.push(say(
                language,
                "accuracy-wrong-object",
                &[("wrong", number_format::count(wrong))],
            ));
        }
        if let Some(ulp) = error.and_then(|e| e.median_ulp) {
            let ulp = local(language, format!("{ulp:.1}"));
            notes.push(say(language, "accuracy-ulps", &[("ulps", ulp.into())]));
        }
        if row.uncertain > 0 {
            let uncertain = number_format::count(row.uncertain as usize);
            notes.push(say(language, "accuracy-uncertain", &[("rays", uncertain)]));
        }
        let class = match (row.default, is_best) {
            (true, _) => " class=\"def\"",
            (_, true) => " class=\"rec\"",
            _ => "",
        };
        let bar = row.times_default.map_or(0.0, |t| {
            ((t.max(0.06).log2() + 4.0) * 9.0).clamp(1.0, 120.0)
        });
        format!(
            "<tr{class}><td>{}</td><td class=\"n\"><span class=\"bar\" style=\"width:{bar:.0}px\"></span> {cpu}</td>\
             <td class=\"n\">{times}</td><td class=\"n\">{steps}</td><td class=\"n\">{flip}</td><td class=\"n\">{off}</td>\
             <td class=\"small\">{}</td></tr>",
            escaped(&row.name()),
            escaped(&notes.join("; "))
        )
    }

    fn pictures(&mut self) {
        if self.report.pictures.is_empty() {
            return;
        }
        self.section("accuracy-section-pictures", "accuracy-note-pictures");
        for shown in &self.report.pictures {
            let (map, factor, largest, wrong) =
                image::difference(&shown.default.1, &shown.better.1);
            let values = [
                ("factor", local(self.language, factor.to_string()).into()),
                (
                    "largest",
                    number_format::error(self.language, largest).into(),
                ),
                ("wrong", number_format::count(wrong)),
            ];
            let caption = say(self.language, "accuracy-difference", &values);
            let figure = |src: &str, caption: &str| {
                format!(
                    "<figure><img src=\"{src}\" alt=\"\"><figcaption>{}</figcaption></figure>",
                    escaped(caption)
                )
            };
            let kind = number_format::kind(self.language, shown.kind);
            let figures = [
                figure(
                    &image::picture(&shown.default.1),
                    &format!("{kind}: {}", shown.default.0),
                ),
                figure(&image::picture(&shown.better.1), &shown.better.0),
                figure(&map, &caption),
            ];
            self.add(&format!("<div class=\"row\">{}</div>", figures.concat()));
        }
        self.add("</section>");
    }

    fn shares(&mut self) {
        let report = self.report;
        if report.objects.is_empty() && report.effects.is_empty() {
            return;
        }
        self.section("accuracy-section-shares", "accuracy-note-shares");
        self.add("<div class=\"two\"><div>");
        self.shared(&tables::objects(report, self.language));
        self.add("</div><div>");
        self.shared(&tables::effects(report, self.language));
        self.add("</div></div>");
        if let Some(maps) = &report.maps {
            let (time, most_time) = image::map(maps.width, maps.height, &maps.time);
            let (error, most_error) = image::map(maps.width, maps.height, &maps.error);
            let most_time = [(
                "most",
                local(self.language, format!("{most_time:.1}")).into(),
            )];
            let most_error = [(
                "most",
                number_format::error(self.language, most_error).into(),
            )];
            let time_caption = escaped(&say(self.language, "accuracy-map-time", &most_time));
            let error_caption = escaped(&say(self.language, "accuracy-map-error", &most_error));
            self.add(&format!(
                "<div class=\"two\"><figure><img src=\"{time}\" alt=\"\"><figcaption>{time_caption}</figcaption></figure>\
                 <figure><img src=\"{error}\" alt=\"\"><figcaption>{error_caption}</figcaption></figure></div>"
            ));
        }
        self.add("</section>");
    }

    fn shared(&mut self, table: &Table) {
        let cell = |tag: &str, (i, text): (usize, &String)| {
            let class = if i == 0 { "" } else { " class=\"n\"" };
            format!("<{tag}{class}>{}</{tag}>", escaped(text))
        };
        let row = |tag: &str, cells: &[String]| -> String {
            let cells: String = cells.iter().enumerate().map(|c| cell(tag, c)).collect();
            format!("<tr>{cells}</tr>")
        };
        let head = row("th", &table.head);
        let rows: String = table.rows.iter().map(|cells| row("td", cells)).collect();
        self.add(&format!(
            "<div class=\"wide\"><table><thead>{head}</thead><tbody>{rows}</tbody></table></div>"
        ));
    }

    fn rest(&mut self) {
        let report = self.report;
        if !report.skipped.is_empty() {
            let heading = self.say("accuracy-section-skipped");
            self.add(&format!("<section><h2>{heading}</h2><ul>"));
            for s in &report.skipped {
                self.add(&format!(
                    "<li>{}: {}</li>",
                    s.axis,
                    escaped(&s.why.wording(self.language))
                ));
            }
            self.add("</ul></section>");
        }
        self.section("accuracy-section-how", "accuracy-note-how");
        let language = self.language;
        let mut lines = Vec::new();
        for (kind, reference) in &report.reference {
            let mut text = format!("{kind}: {}", reference.margin.how.wording(self.language));
            if let Some(n) = reference.samples.filter(|n| *n > 1) {
                let _ = write!(text, "; {n} samples");
            }
            if let (Some(depth), Some(cutoff)) = (reference.depth, reference.cutoff) {
                let _ = write!(text, "; depth {depth}, cutoff {cutoff:e}");
            }
            if let Some(steps) = reference.margin.steps {
                let _ = write!(text, "; ± {}", number_format::error(language, steps));
            }
            lines.push(text);
        }
        if !report.budget.cut.is_empty() {
            let cut = say(language, "accuracy-cut", &[]);
            lines.push(format!(
                "{cut}: {}",
                each(self.language, &report.budget.cut).join(", ")
            ));
        }
        let machine = &report.machine;
        lines.push(format!(
            "{}, {} cores, {} {}",
            machine.cpu, machine.cores, machine.build, machine.version
        ));
        let items: String = lines
            .iter()
            .map(|l| format!("<li>{}</li>", escaped(l)))
            .collect();
        self.add(&format!(
            "<ul class=\"small mut\">{items}</ul></section></main></body></html>"
        ));
    }
}
