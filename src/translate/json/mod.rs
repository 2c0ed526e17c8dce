//! The resolved scene as JSON, for programs that read scenes and for programs that write them.
//!
//! [`write()`] turns a resolved scene into a [`model::Scene`]. [`read()`] parses JSON as a model, or finds its fault.
//! [`spell()`] writes a model as records of the language, which make the same scene. [`analyse()`] reads JSON, spells
//! it and analyses the records; its findings name places of the JSON. The schema is `grammar/scene.schema.json`.

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
