//! Text to records: the record [`table`], the [`lexer`], the [`parser`] with its recovery, and the
//! typed syntax tree ([`ast`]) that still holds every character of the source; and the table in
//! words ([`describe`]).

pub mod ast;
mod comments;
pub mod describe;
mod faults;
mod layout;
pub mod lexer;
pub mod parser;
mod reader;
mod references;
mod report;
mod stream;
pub mod table;

pub use ast::{Document, Item, Record};
pub use parser::parse;
pub use report::quote;
