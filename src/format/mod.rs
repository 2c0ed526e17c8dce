//! The pretty-printer.
