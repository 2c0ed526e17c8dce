//! `zpg man`: the page of the manual about a command, as `man` reads it. Packages are made with it.

use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use super::help::{described_help, in_language, own_words};
use super::usage::is_near;
use super::{LookChoice, Status, complain, terminal};
use crate::diagnostics::{Complaint, Language};

/// The width of text in columns: a page of 80 columns without its margins.
const WIDTH: usize = 72;

/// Print the page of the manual about zpg or one of its commands
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  zpg man render > zpg-render.1    the page about zpg render, in the language of the messages
  man ./zpg-render.1               what it looks like")]
pub struct Args {
    /// The command [default: all of zpg]
    #[arg(value_name = "COMMAND")]
    about: Option<String>,
}

/// The English headings of sections, each with the message that translates it.
pub const SECTIONS: [(&str, &str); 6] = [
    ("NAME", "help-section-name"),
    ("SYNOPSIS", "help-section-synopsis"),
    ("DESCRIPTION", "help-section-description"),
    ("OPTIONS", "help-section-options"),
    ("SUBCOMMANDS", "help-section-commands"),
    ("NOTES", "help-section-notes"),
];

/// Prints the page about a command of the given command line.
pub fn run(args: &Args, command: clap::Command, look: LookChoice) -> Status {
    let language = look.language();
    let version = command.get_version().unwrap_or_default().to_owned();
    let command = command.disable_help_subcommand(true);
    let mut command = in_language(command, language, WIDTH);
    command.build();
    let command = match &args.about {
        None => command,
        Some(name) => match command.find_subcommand(name) {
            Some(command) => command.clone(),
            None => {
                let what = Complaint::new("usage-no-command").with("arg", name.clone());
                let all = command.get_subcommands().map(clap::Command::get_name);
                let near = all.filter(|n| is_near(name, n)).map(str::to_owned);
                complain(look, &what.or_meant(near));
                return Status::Failure;
            }
        },
    };
    let page = page(command, &version, language);
    terminal::print(look, Status::Clean, |out| {
        page.and_then(|page| out.write_all(page.as_bytes()))
    })
}

fn page(mut command: clap::Command, version: &str, language: Language) -> std::io::Result<String> {
    // The synopsis that clap_mangen would write names all options, and would be longer than the page.
    let usage = own_words(command.render_usage().to_string(), language);
    let usage = usage.split_once(": ").map_or("", |(_, usage)| usage);
    let command = described_help(command, language).override_usage(usage.to_owned());
    let notes = command.get_after_help().map(ToString::to_string);
    let has_commands = command.has_subcommands();
    // No date is known. The version stands in its place, since an empty argument would move the next one to the left.
    let man = Man::new(command).date(format!("zpg {version}")).source("");
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    if has_commands {
        man.render_subcommands_section(&mut page)?;
    }
    man.render_options_section(&mut page)?;
    if let Some(notes) = notes {
        // The lines of the notes are laid out already, and `nf` keeps `man` from filling them.
        let mut roff = Roff::default();
        roff.control("SH", ["NOTES"]).control("nf", []);
        for line in notes.lines() {
            roff.text([roman(line)]);
        }
        roff.control("fi", []);
        roff.to_writer(&mut page)?;
    }
    let page = String::from_utf8_lossy(&page).into_owned();
    Ok(lines_of_their_own(&named(&page, language)))
}

/// The page with its section headings translated into a language.
fn named(page: &str, language: Language) -> String {
    let heading = |line: &str| {
        let name = line.strip_prefix(".SH ")?;
        let (_, message) = SECTIONS.iter().find(|(english, _)| *english == name)?;
        Some(format!(".SH {}", language.own(message, None)?))
    };
    let lines = page
        .lines()
        .map(|line| heading(line).unwrap_or_else(|| line.to_owned()));
    lines.map(|line| line + "\n").collect()
}

/// Puts each item of a list on a line of its own: `man` would fill the items into one paragraph otherwise.
fn lines_of_their_own(page: &str) -> String {
    page.replace("\n\\- ", "\n.br\n\\- ")
}
