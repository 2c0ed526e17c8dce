//! Tables that the page and the Markdown have in common.

use super::super::number_format::{self, local, say};
use super::super::report::Report;
use crate::diagnostics::Language;

/// A table whose first column is text, and whose other columns are numbers.
pub(super) struct Table {
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    fn new(language: Language, head: &'static str) -> Table {
        let head = say(language, head, &[]);
        let cells = head.trim_matches('|').split('|');
        Table {
            head: cells.map(|cell| cell.trim().to_owned()).collect(),
            rows: Vec::new(),
        }
    }
}

/// The table of time and error for each object that is seen first, the most expensive ones first.
pub(super) fn objects(report: &Report, language: Language) -> Table {
    let mut table = Table::new(language, "accuracy-objects-head");
    let percent = |share: f64| number_format::percent(language, share) + " %";
    for object in report.objects.iter().take(8) {
        let name = match object.id {
            0 => say(language, "accuracy-background", &[]),
            id => format!("#{id}"),
        };
        table.rows.push(vec![
            name,
            percent(object.share_of_pixels),
            percent(object.share_of_time),
            percent(object.share_of_error),
            local(language, format!("{:.2}", object.microseconds_per_pixel)),
        ]);
    }
    table
}

/// The table of the time that is saved when an effect is taken out.
pub(super) fn effects(report: &Report, language: Language) -> Table {
    let mut table = Table::new(language, "accuracy-effects-head");
    for effect in &report.effects {
        let saved = match (effect.saved, effect.within_noise) {
            (None, _) => "–".into(),
            (_, true) => say(language, "accuracy-within-noise", &[]),
            (Some(s), false) => number_format::percent(language, s) + " %",
        };
        table.rows.push(vec![
            number_format::effect(language, effect.name),
            saved,
            effect.rays_saved.to_string(),
            number_format::error(language, effect.error.steps),
        ]);
    }
    table
}
