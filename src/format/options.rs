//! What can be chosen about the layout.

use serde::de::{Deserialize, Deserializer, Error};

/// The style; the default is the one to use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// Characters a line may have: where a profile wraps, and how far alignment may go.
    #[serde(deserialize_with = "width")]
    pub width: usize,
    /// Whether numbers and comments stand under each other.
    pub align: bool,
    /// Whether the vectors of a record are set off by double spaces.
    pub group: bool,
    pub numbers: Numbers,
}

/// How numbers are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Numbers {
    /// In the shortest way that has the same value.
    Shortest,
    /// As they are written.
    Keep,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            width: 100,
            align: true,
            group: true,
            numbers: Numbers::Shortest,
        }
    }
}

fn width<'de, D: Deserializer<'de>>(from: D) -> Result<usize, D::Error> {
    let width = i64::deserialize(from)?;
    match usize::try_from(width) {
        Ok(width @ 20..=1000) => Ok(width),
        _ => Err(D::Error::custom("a width is from 20 to 1000")),
    }
}
