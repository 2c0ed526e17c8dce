//! Statements of a picture file about its origin.

use serde::{Deserialize, Serialize};

/// The statement of a picture file about its origin: hashes of the scene and the settings, and the rows of the picture
/// that the file has.
///
/// The origin is JSON: in a PNG as the text `zpg`, in an EXR as the attribute `zpg`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// The version of zpg.
    #[serde(rename = "zpg")]
    pub version: String,
    /// A hash of the scene and its textures: 32 hexadecimal digits.
    pub scene: String,
    /// A hash of the options that the picture depends on: 32 hexadecimal digits.
    pub settings: String,
    /// Width and height of the whole picture in pixels.
    pub size: [u32; 2],
    /// The rows that the file has, in stretches: the first row and the number of rows of each. The stretches ascend
    /// from the top and do not overlap.
    pub rows: Vec<[u32; 2]>,
    /// Whether the file is what an interrupted run has left of the picture.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unfinished: bool,
}

impl Origin {
    /// The name of the text in a PNG, and of the attribute in an EXR.
    pub const NAME: &'static str = "zpg";

    /// The first row that the file has, and the number of rows from there to the last one.
    pub fn span(&self) -> [u32; 2] {
        let first = self.rows.first().map_or(0, |rows| rows[0]);
        let end = self.rows.last().map_or(0, |rows| rows[0] + rows[1]);
        [first, end - first]
    }

    /// Whether the file has the whole picture.
    pub fn is_whole(&self) -> bool {
        self.rows == [[0, self.size[1]]]
    }

    /// Whether two files belong to one picture: their versions, scenes, settings and sizes are equal.
    pub fn is_of_one_picture(&self, other: &Origin) -> bool {
        self.size == other.size
            && self.version == other.version
            && self.scene == other.scene
            && self.settings == other.settings
    }

    pub(super) fn to_text(&self) -> String {
        // Strings and numbers can always be written as JSON.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads an origin from JSON. `None` if the text is no origin, or if its rows do not ascend without overlap within
    /// the picture.
    pub(super) fn from_text(text: &str) -> Option<Origin> {
        let origin: Origin = serde_json::from_str(text).ok()?;
        let mut end = Some(0);
        for &[first, count] in &origin.rows {
            end = (end.is_some_and(|end: u32| end <= first) && count > 0)
                .then(|| first.checked_add(count))
                .flatten();
        }
        end.is_some_and(|end| 0 < end && end <= origin.size[1])
            .then_some(origin)
    }
}
