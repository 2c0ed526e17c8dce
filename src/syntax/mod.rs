//! Text to records: the record [`table`], the [`lexer`], the [`parser`] with its recovery, and the
//! typed syntax tree ([`ast`]) that still holds every character of the source; and what is
//! made of the table: words ([`describe`]), the reference and the EBNF ([`grammar`]).

pub mod ast;
pub mod captions;
mod comments;
pub mod describe;
pub mod directive;
mod faults;
pub mod grammar;
mod layout;
pub mod lexer;
pub mod parser;
pub mod plain;
pub mod preserved;
mod reader;
pub mod recognise;
mod references;
mod report;
mod respell;
mod slips;
mod stream;
mod sums;
pub mod table;
mod witness;

pub use ast::{Document, Item, Record};
pub use captions::Captions;
pub use directive::is_directive;
pub use parser::parse;
pub use report::quote;
