//! Features of an editor, as plain functions of an [`Analysis`] and a place in its text.
//!
//! A place is a byte offset into the text; a stretch of text is a [`Span`]. No feature knows of a protocol: `lsp`
//! puts the answers into its types. Each feature has a file:
//!
//! | What people see | File |
//! |---|---|
//! | squiggles, in the right number | [`problems`] |
//! | quick fixes, "fix all", "allow here", "renumber" | [`actions`] |
//! | names before numbers | [`hints`] |
//! | what stands under the pointer | [`hover`] |
//! | the parameters while a record is typed | [`signature`] |
//! | proposals while typing | [`completion`]; whole records: `templates`; in comments: `allow_codes` |
//! | jumps, uses, a new ID | [`uses`], [`rename`] |
//! | the outline and operations as calls | [`symbols`], [`calls`] |
//! | folding, selecting outwards | [`folding`], [`selection`] |
//! | colours of the text by meaning, colours of the scene | [`tokens`], [`colours`] |
//! | formatting | [`formatting`] |
//! | commenting records out and in | [`commenting`] |
//! | buttons above records | [`lenses`] |
//! | pictures | [`picture`] |
//!
//! All features build on three files: [`token_at_offset`] tells which token is at an offset, [`entity`] which entity
//! an ID names, and [`pages`] has the pages of `zpg explain`.

pub mod actions;
mod allow_codes;
pub mod calls;
pub mod colours;
pub mod commenting;
pub mod completion;
pub mod entity;
pub mod folding;
pub mod formatting;
pub mod hints;
pub mod hover;
pub mod lenses;
pub mod pages;
pub mod picture;
pub mod problems;
pub mod rename;
pub mod selection;
pub mod signature;
pub mod symbols;
mod templates;
pub mod token_at_offset;
pub mod tokens;
pub mod uses;

pub use crate::analysis::Analysis;
pub use crate::diagnostics::{Edit, Span};
