//! The text in a box of a sheet.

use super::average::Thumbnail;
use super::entry::SheetBox;
use super::findings::Counts;
use crate::diagnostics::{Complaint, Language, Value};

/// A box of the sheet, whose picture has been read.
pub(super) struct Cell<'e> {
    pub entry: &'e SheetBox<'e>,
    /// The picture, or why there is none.
    pub picture: Result<Thumbnail, Complaint>,
}

/// The heading of the whole sheet.
pub(super) struct Heading {
    pub folder: String,
    pub pictures: usize,
    /// The errors and warnings of all scenes, if there are findings.
    pub counts: Option<Counts>,
}

impl Cell<'_> {
    /// The size of the picture, as `640 × 480`; `None` if there is no picture.
    pub(super) fn size(&self) -> Option<String> {
        let [width, height] = self.picture.as_ref().ok()?.original;
        Some(format!("{width} × {height}"))
    }

    /// Errors and warnings of the scene, if there is one.
    pub(super) fn counts(&self) -> Option<Counts> {
        self.entry.scene.map(|scene| scene.counts())
    }

    /// The text in place of the picture, which says why there is none; `None` if there is a picture.
    pub(super) fn reason(&self, language: Language) -> Option<String> {
        let why = self.picture.as_ref().err()?;
        Some(match self.entry.picture {
            Some(_) => {
                let cannot = Complaint::new("sheet-unreadable").with("reason", why.clone());
                cannot.wording(language)
            }
            None => why.wording(language),
        })
    }
}

/// The complaint that there is no picture of a scene, with the number of the scene's errors.
pub(super) fn without_picture(counts: Counts) -> Complaint {
    match counts.errors {
        0 => Complaint::new("sheet-no-picture"),
        errors => Complaint::new("sheet-errors").with("count", Value::Count(errors)),
    }
}

impl Heading {
    /// The heading in one line.
    pub(super) fn line(&self, language: Language) -> String {
        let pictures = [("count", Value::Count(self.pictures as u64))];
        let pictures = language.say("sheet-pictures", &pictures);
        let mut parts = vec![pictures];
        if let Some(counts) = self.counts {
            parts.extend(counts.parts(language).into_iter().flatten());
            if counts == Counts::default() {
                parts.push(language.say("sheet-clean", &[]));
            }
        }
        format!("{}: {}", self.folder, parts.join(", "))
    }
}

/// The texts that say how many errors and how many warnings a scene has, or a single one that the scene is clean.
pub(super) fn found(counts: Counts, language: Language) -> Vec<String> {
    match counts == Counts::default() {
        true => vec![language.say("sheet-scene-clean", &[])],
        false => counts.parts(language).into_iter().flatten().collect(),
    }
}
