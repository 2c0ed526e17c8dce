//! `zpg completions`: a script that completes zpg's command line in a shell.

use clap_complete::Shell;

use super::{LookChoice, Status, help, terminal};

/// Print a script that completes this command line in a shell
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  zpg completions bash > ~/.local/share/bash-completion/completions/zpg
  zpg completions fish > ~/.config/fish/completions/zpg.fish
  zpg completions zsh > ~/.zfunc/_zpg    where ~/.zfunc is a folder of $fpath")]
pub struct Args {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Prints the script for the given command line.
pub fn run(args: &Args, command: clap::Command, look: LookChoice) -> Status {
    let mut command = help::described(command, look.language());
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, name, &mut script);
    terminal::print(look, Status::Clean, |out| out.write_all(&script))
}
