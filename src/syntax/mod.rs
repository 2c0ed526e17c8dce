//! Text to records: the record [`table`], the [`lexer`], the [`parser`] with its recovery, and the
//! typed syntax tree ([`ast`]) that still holds every character of the source; and the table in
//! words ([`describe`]).

pub mod ast;
pub mod describe;
pub mod lexer;
pub mod parser;
pub mod table;

pub use ast::{Document, Item, Record};
pub use parser::parse;
