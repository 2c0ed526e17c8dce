//! Analysis of a scene in JSON: its records are analysed, and the findings get their places in the JSON.

use std::collections::HashMap;

use super::fields::{RecordField, values};
use super::locate::{Path, Places};
use super::model::Scene;
use super::spell::{Matter, ModelElement, Records, spell};
use super::{Unreadable, read};
use crate::analysis::{Analysis, Origin};
use crate::diagnostics::{Code, Diagnostic, Language, SourceFile, Span};
use crate::syntax::table::RecordKind;

/// Reads a scene in JSON; never fails. What is wrong with the JSON is a finding.
pub fn analyse(source: SourceFile) -> Analysis {
    match read(&source.text) {
        Err(unreadable) => Analysis::unreadable(source, finding(unreadable)),
        Ok(model) => {
            let Records {
                text,
                places,
                matters,
                made_up,
            } = spell(&model, Language::English);
            // The records get the path of the JSON, so that pictures are looked for beside the JSON.
            let records = SourceFile::new(source.path.clone(), text.into_bytes());
            let origin = Json {
                values: Places::new(&source.text),
                model,
                places,
                matters,
                made_up,
            };
            Analysis::from_json(source, Analysis::of(records), Box::new(origin))
        }
    }
}

/// The fault in the JSON, as a finding.
fn finding(unreadable: Unreadable) -> Diagnostic {
    let Unreadable { at, span, why } = unreadable;
    let finding = Diagnostic::new(Code::E015, span).with("why", why);
    Diagnostic { at, ..finding }
}

/// The way from the records back to the values of the JSON.
#[derive(Debug)]
struct Json {
    model: Scene,
    values: Places,
    places: Vec<ModelElement>,
    matters: Vec<Matter>,
    made_up: HashMap<u32, ModelElement>,
}

impl Json {
    fn path(&self, records: &SourceFile, span: Span) -> Option<Path> {
        let line = records.line_index(span.start);
        let (&place, &matter) = self.places.get(line).zip(self.matters.get(line))?;
        let whole = records.line_span(line);
        let text = records.slice(whole);
        let is_image = matter == Matter::Type(Some(RecordKind::ImageTexture));
        // Words are counted by the blanks between them. The name of a picture may have blanks, so it is one word.
        let word = |at: u32| {
            let at = (at.clamp(whole.start, whole.end) - whole.start) as usize;
            let words = text.as_bytes()[..at].iter().filter(|b| **b == b' ').count();
            if is_image { words.min(2) } else { words }
        };
        let (first, last) = (word(span.start), word(span.end.max(span.start + 1) - 1));
        let part = |word: usize| match word {
            0 => RecordField::Id,
            1 => RecordField::Type,
            n => RecordField::Parameter(n - 2),
        };
        let parts: Vec<RecordField> = (first..=last.max(first)).map(part).collect();
        Some(values(&self.model, place, matter, &parts))
    }
}

impl Origin for Json {
    fn place(&self, file: &SourceFile, records: &SourceFile, span: Span) -> (Span, Option<String>) {
        match self.path(records, span) {
            // A finding about something that the file lacks is put at the beginning of the file.
            None => (Span::default(), None),
            Some(path) => (self.values.find(&file.text, &path), Some(path.to_string())),
        }
    }

    fn part(&self, file: &SourceFile, records: &SourceFile, span: Span) -> Span {
        let place = self.places.get(records.line_index(span.start));
        place.map_or(Span::default(), |place| {
            self.values.find(&file.text, &place.path())
        })
    }

    fn name(&self, id: u32) -> Option<String> {
        self.made_up.get(&id).map(ModelElement::to_string)
    }
}
