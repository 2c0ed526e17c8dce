//! The resolved scene as JSON, for programs that read scenes and for programs that write them.
//!
//! [`write()`] makes a [`model::Scene`] of a resolved scene; [`read()`] takes JSON apart and finds what is
//! wrong with it; [`spell()`] writes the records of the language that make the same scene; [`analyse()`] does both,
//! and says what there is to say of the scene in the words and places of the JSON. The schema is
//! `grammar/scene.schema.json`.

mod fields;
mod file;
mod locate;
pub mod model;
mod pictures;
mod read;
mod spell;
pub mod target;
mod unreadable;
mod verdict;
mod write;

pub use file::analyse;
pub use read::read;
pub use spell::{ModelElement, Records, spell};
pub use unreadable::Unreadable;
pub use verdict::verdict;
pub use write::write;

#[cfg(test)]
mod tests;
