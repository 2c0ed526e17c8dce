//! The command line.

mod machine;

use std::process::ExitCode;

use zpg::internals::commands::{Status, cli};

fn main() -> ExitCode {
    match machine::suffices() {
        Ok(()) => run(),
        Err(missing) => {
            eprintln!("{missing}");
            Status::Failure.into()
        }
    }
}

/// Kept apart from [`main`], which has to run on any machine.
#[inline(never)]
fn run() -> ExitCode {
    cli::run().into()
}
