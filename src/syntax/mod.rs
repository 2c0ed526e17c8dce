//! Text to records: the record [`table`], the [`lexer`], the [`parser`] with its [recovery], and the typed syntax tree
//! ([`ast`]) that still holds every character of the source. The table also gives the words of [`describe`];
//! `tests/grammar` makes the reference and the EBNF from it.
//!
//! ```text
//!   text ──lexer──► lexed: columns of tokens, significant tokens, values   logos; each number is read once
//!                      │
//!                   parser  (void | record | gap)*                     chumsky
//!                      │      │                 ╲
//!                      │   signature             ╲  lines that cannot be read by arity, or whose reading
//!                      │   THE reader of a record ╲ goes across lines that are records of their own
//!                      │                           ▼
//!                      │                        recovery (stretch, what the rest says) → records, findings
//!                      ▼                           │
//!                  Document { tokens, items, values, contents }  + findings
//! ```
//!
//! Where a number may be missing or too many, `Plan::agrees` in the parser refuses the record, and [recovery] decides
//! which number it is.
//!
//! A scene that is right enters recovery only where the layout does not agree with it: where a record goes from the
//! middle of a line to another one, or takes up lines that look like records of their own.

pub mod ast;
mod calculated;
pub mod captions;
pub mod colour_names;
pub mod commas;
pub mod commented_out;
pub mod contents;
pub mod describe;
pub mod directive;
pub mod hex;
pub mod hidden;
pub mod ids;
pub mod in_records;
pub mod last_row;
mod lexed;
pub mod lexer;
pub mod parser;
pub mod preserved;
mod quote;
pub mod recognise;
mod recovery;
mod scene_lines;
mod signature;
pub mod table;
pub mod words;

pub use ast::{Document, Item, Record};
pub use calculated::{calculated, opposite, tenth, with_point};
pub use captions::Captions;
pub use directive::is_directive;
pub use parser::parse;
pub use quote::quote;
pub use recovery::LEAST_HEAD;
pub use signature::allows;
