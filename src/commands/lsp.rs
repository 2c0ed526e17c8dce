//! `zpg lsp`: the language server.

use super::terminal::unprintable;
use super::{LookChoice, Status, complain};
use crate::lsp::{self, Ending};

/// Serve an editor: diagnostics, hints, fixes and more, over the language server protocol
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Editors start this command themselves and talk to it on its standard input and output; docs/editors.md
says how each of them is set up. Settings come from zpg.toml, as on the command line.

Examples:
  zpg lsp              what an editor starts
  zpg lsp --lang cs    the same with messages in Czech")]
pub struct Args {
    /// Talk on standard input and output, as it always does; some editors say so
    #[arg(long)]
    stdio: bool,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let Args { stdio: _ } = args;
    match lsp::run(look.language()) {
        Ok(Ending::Clean) => Status::Clean,
        Ok(Ending::Early) => Status::Negative,
        Err(e) => {
            complain(look, &unprintable(&e));
            Status::Failure
        }
    }
}
