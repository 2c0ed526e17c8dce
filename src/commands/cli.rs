//! The command line of zpg: all subcommands, and the call of the one that the arguments name.

use clap::{CommandFactory, Parser, Subcommand};

use super::terminal::width;
use super::{
    LookChoice, Status, accuracy, check, completions, convert, crosscheck, explain, farm, fmt,
    help, join, lsp, man, new, plan, probe, render, sheet, usage,
};
use crate::{allocator, parallel};

/// Tools for scenes in the ZPG scene language
#[derive(Debug, Parser)]
#[command(
    name = "zpg",
    version,
    after_help = "\
Exit status: 0 done and clean; 1 the scene has errors, or the answer is \"no\"; 2 wrong usage, or
a file cannot be read or written, or is no scene.

Examples:
  zpg new scene.zpg         a scene to start with
  zpg check scene.zpg       what is wrong with a scene
  zpg fmt scene.zpg         one record a line, numbers in their shortest spelling
  zpg render scene.zpg      a picture, scene.png
  zpg plan scene.zpg        which effects the picture needs, and why
  zpg accuracy scene.zpg    what each step of accuracy costs in time
  zpg convert scene.zpg --to pov -o scene.pov
  zpg crosscheck scene.zpg --with povray
  zpg sheet pictures -o sheet.html
  zpg probe scene.zpg --ray \"0 0 9  0 0 -1\"
  zpg explain E101          what a finding means and how to fix it
  zpg explain checkerboard  what a record type means and how it is written"
)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,

    #[command(flatten)]
    look: LookChoice,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    New(new::Args),
    Check(check::Args),
    #[command(alias = "format")]
    Fmt(fmt::Args),
    Convert(convert::Args),
    Crosscheck(crosscheck::Args),
    Render(Box<render::Args>),
    Join(join::Args),
    Farm(Box<farm::Args>),
    Probe(Box<probe::Args>),
    Plan(plan::Args),
    Accuracy(accuracy::Args),
    Sheet(sheet::Args),
    #[command(alias = "rule")]
    Explain(explain::Args),
    Lsp(lsp::Args),
    Completions(completions::Args),
    Man(man::Args),
}

/// The size in bytes up to which freed blocks of memory are kept for reuse: enough to read and draw a scene of ten
/// thousand shapes. If larger blocks were kept, too, large scenes would take a fifth more memory.
const KEPT_BYTES: usize = 4 << 20;

/// Reads the arguments of the program and runs the subcommand that they name. Messages are in the language that the
/// arguments or the environment ask for.
pub fn run() -> Status {
    let written = probe::joined(std::env::args_os());
    let cli = match Cli::try_parse_from(&written) {
        Ok(cli) => cli,
        Err(error) => {
            // The arguments are parsed again, so that the answer has the help in the chosen language.
            let look = LookChoice::among(written.iter().cloned());
            let mut command = help::in_language(Cli::command(), look.language(), width());
            let again = command.try_get_matches_from_mut(&written);
            return usage::refuse(&again.err().unwrap_or(error), &mut command, look);
        }
    };
    allocator::keep(KEPT_BYTES);
    if matches!(cli.command, Command::Check(_) | Command::Fmt(_)) {
        // If no thread can be started, this one does all the work.
        let _ = parallel::take_part(0);
    }
    match &cli.command {
        Command::New(args) => new::run(args, cli.look),
        Command::Check(args) => check::run(args, cli.look),
        Command::Fmt(args) => fmt::run(args, cli.look),
        Command::Convert(args) => convert::run(args, cli.look),
        Command::Crosscheck(args) => crosscheck::run(args, cli.look),
        Command::Render(args) => render::run(args, cli.look),
        Command::Farm(args) => farm::run(args, Cli::command(), cli.look),
        Command::Join(args) => join::run(args, cli.look),
        Command::Probe(args) => probe::run(args, cli.look),
        Command::Plan(args) => plan::run(args, cli.look),
        Command::Accuracy(args) => accuracy::run(args, cli.look),
        Command::Sheet(args) => sheet::run(args, cli.look),
        Command::Explain(args) => explain::run(args, cli.look),
        Command::Lsp(args) => lsp::run(args, cli.look),
        Command::Completions(args) => completions::run(args, Cli::command(), cli.look),
        Command::Man(args) => man::run(args, Cli::command(), cli.look),
    }
}
