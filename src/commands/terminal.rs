//! Output on a terminal: colour or not, messages, and output that nobody reads any more.

use std::ffi::OsString;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use terminal_size::{Width, terminal_size_of};

use super::Status;
use super::help;
use super::language::{self, LanguageChoice};
use crate::diagnostics::layout::wrapped;
use crate::diagnostics::render::Tally;
use crate::diagnostics::render::human::{self, Look};
use crate::diagnostics::{Complaint, Diagnostic, Language, SourceFile};
use crate::study::program;

/// How people want to be spoken to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::Args)]
pub struct LookChoice {
    /// When to use colour
    #[arg(help_heading = help::GLOBAL)]
    #[arg(long, global = true, value_enum, default_value_t, value_name = "WHEN")]
    color: ColorChoice,

    /// The language of messages [default: that of LC_ALL, LC_MESSAGES or LANG]
    #[arg(help_heading = help::GLOBAL)]
    #[arg(long, global = true, value_enum)]
    lang: Option<LanguageChoice>,

    /// Print findings, answers and errors, and nothing besides
    #[arg(help_heading = help::GLOBAL)]
    #[arg(short, long, global = true)]
    pub quiet: bool,

    /// Leave out notes: they have been said
    #[arg(skip)]
    no_notes: bool,
}

/// When to colour what is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
enum ColorChoice {
    /// On a terminal, or where FORCE_COLOR or CLICOLOR_FORCE is set, unless NO_COLOR is
    #[default]
    Auto,
    Always,
    Never,
}

impl LookChoice {
    /// The look with the `--lang` among arguments that clap could not parse; all other settings have their defaults.
    pub fn among(args: impl Iterator<Item = OsString>) -> LookChoice {
        LookChoice {
            lang: language::among(args),
            ..LookChoice::default()
        }
    }

    /// The same look without notes: [`note`] prints nothing.
    #[must_use]
    pub fn without_notes(self) -> LookChoice {
        LookChoice {
            no_notes: true,
            ..self
        }
    }

    /// The look of findings that are printed on this stream.
    pub fn on(self, stream: &impl IsTerminal) -> Look {
        Look {
            colour: self.colour(stream),
            language: self.language(),
            width: Some(width()),
        }
    }

    /// The look of findings that are written to a file.
    pub fn on_file(self) -> Look {
        Look {
            colour: self.color == ColorChoice::Always,
            language: self.language(),
            width: Some(width()),
        }
    }

    /// Whether to colour what goes to this stream.
    pub fn colour(self, stream: &impl IsTerminal) -> bool {
        match self.color {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto => usual(stream.is_terminal(), |name| std::env::var_os(name)),
        }
    }

    /// The language that is asked for, or that of the environment.
    pub fn language(self) -> Language {
        self.lang
            .map_or_else(language::of_environment, Language::from)
    }
}

/// Whether to use colour if no option says so. The variables of <https://no-color.org>, <https://force-color.org> and
/// <https://bixense.com/clicolors> decide, the first of them that is set; without them a terminal has colour.
fn usual(is_terminal: bool, variable: impl Fn(&str) -> Option<OsString>) -> bool {
    let is_set = |name| variable(name).is_some_and(|value| !value.is_empty());
    // In many programs the value 0 means no.
    let says_yes = |name| is_set(name) && variable(name).is_some_and(|value| value != "0");
    if is_set("NO_COLOR") {
        return false;
    }
    if says_yes("FORCE_COLOR") || says_yes("CLICOLOR_FORCE") {
        return true;
    }
    is_terminal && variable("TERM").is_none_or(|terminal| terminal != "dumb")
}

/// Prints an error on standard error.
pub fn complain(look: LookChoice, complaint: &Complaint) {
    let kind = look.language().say("error", &[]);
    for one in complaint.each() {
        tell(&format!("{kind}: {}", one.wording(look.language())));
    }
}

/// Prints the complaints about many files. A complaint that is the same as the last one, as about the settings of all
/// files, is printed once.
pub struct Complaints {
    look: LookChoice,
    said: Vec<Complaint>,
}

impl Complaints {
    pub fn new(look: LookChoice) -> Complaints {
        Complaints {
            look,
            said: Vec::new(),
        }
    }

    pub fn say(&mut self, complaint: Complaint) {
        if self.said.last() != Some(&complaint) {
            complain(self.look, &complaint);
            self.said.push(complaint);
        }
    }
}

/// Prints a warning on standard error, unless `--quiet` is given.
pub fn warn(look: LookChoice, complaint: &Complaint) {
    if look.quiet {
        return;
    }
    let kind = look.language().say("warning", &[]);
    tell(&format!("{kind}: {}", complaint.wording(look.language())));
}

/// Prints a note on standard error, unless `--quiet` is given or notes are left out.
pub fn note(look: LookChoice, complaint: &Complaint) {
    if look.quiet || look.no_notes {
        return;
    }
    let kind = look.language().say("note", &[]);
    tell(&format!("{kind}: {}", complaint.wording(look.language())));
}

/// Writes a line to standard error, or several where the terminal is narrower.
pub fn tell(line: &str) {
    // Nobody is left to be told when standard error is gone.
    let _ = writeln!(io::stderr(), "{}", wrapped(line, width(), "  "));
}

/// The width of text in columns if neither COLUMNS nor a terminal says one: in a pipe, in a file.
const USUAL_WIDTH: usize = 80;
/// The greatest width that is taken from a terminal: longer lines are hard to read.
const MOST_WIDTH: usize = 120;
const LEAST_WIDTH: usize = 40;

/// The width of text in columns, from COLUMNS or else from the terminal.
pub fn width() -> usize {
    let said = std::env::var("COLUMNS").ok();
    if let Some(said) = said.and_then(|said| said.parse().ok()) {
        return usize::max(said, LEAST_WIDTH);
    }
    let size = terminal_size_of(io::stdout()).or_else(|| terminal_size_of(io::stderr()));
    size.map_or(USUAL_WIDTH, |(Width(width), _)| {
        usize::from(width).clamp(LEAST_WIDTH, MOST_WIDTH)
    })
}

/// A flag that Ctrl-C sets, so that long work ends and drafts of files are removed.
pub fn stop_on_interrupt(look: LookChoice) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    let handler = move || flag.store(true, Ordering::Relaxed);
    if let Err(e) = ctrlc::set_handler(handler) {
        let reason = e.to_string();
        warn(
            look,
            &Complaint::new("ctrl-c-leaves").with("reason", reason),
        );
    }
    stop
}

/// Makes Ctrl-C, and on Unix SIGTERM, end the program at once, together with the programs that it runs.
pub fn end_on_interrupt(look: LookChoice) {
    let leaves = |reason: String| {
        let why = Complaint::new("ctrl-c-leaves-programs").with("reason", reason);
        warn(look, &why);
    };
    if let Err(e) = ctrlc::set_handler(|| program::exit(Status::Interrupted as u8)) {
        leaves(e.to_string());
    }
    #[cfg(unix)]
    match signal_hook::iterator::Signals::new([signal_hook::consts::SIGTERM]) {
        Ok(mut signals) => {
            std::thread::spawn(move || {
                if signals.forever().next().is_some() {
                    program::exit(TERMINATED);
                }
            });
        }
        Err(e) => leaves(e.to_string()),
    }
}

/// The exit status after SIGTERM: 128 and the number of the signal, as shells have it.
#[cfg(unix)]
const TERMINATED: u8 = 143;

/// A progress bar on standard error that ends at `rows`; hidden with `--quiet`.
pub fn progress_bar(rows: u64, look: LookChoice) -> ProgressBar {
    if look.quiet {
        return ProgressBar::hidden();
    }
    // Draws on standard error, and only where that is a terminal.
    let bar = ProgressBar::with_draw_target(Some(rows), ProgressDrawTarget::stderr_with_hz(10));
    let left = (look.language()).say("progress-left", &[("time", "{eta:>4}".into())]);
    let template = format!("{{wide_bar}} {{percent:>3}} %  {left}");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    bar
}

/// Prints the findings of a scene on standard error, with a summary. Prints nothing if there are no findings.
pub fn report(source: &SourceFile, found: &[Diagnostic], look: LookChoice) {
    if found.is_empty() {
        return;
    }
    findings(source, found, look);
    let mut tally = Tally::default();
    tally.add(found);
    tell(&tally.sentence(look.language()));
}

/// Prints the findings of a scene on standard error, without a summary.
pub fn findings(source: &SourceFile, found: &[Diagnostic], look: LookChoice) {
    let stderr = io::stderr();
    let look = look.on(&stderr);
    let mut out = BufWriter::new(stderr.lock());
    // Nobody is left to be told when standard error is gone.
    let _ = human::write(&mut out, source, found, look).and_then(|()| out.flush());
}

/// Writes to standard output, buffered, and returns `status`. Output that nobody reads any more (a closed pipe) is no
/// failure; output that cannot be written gives [`Status::Failure`].
pub fn print(
    look: LookChoice,
    status: Status,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Status {
    let mut out = BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Ok(()) => status,
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => {
            UNREAD.store(true, Ordering::Relaxed);
            status
        }
        Err(e) => {
            complain(look, &unprintable(&e));
            Status::Failure
        }
    }
}

/// Whether the reader of standard output has closed it.
static UNREAD: AtomicBool = AtomicBool::new(false);

/// Whether nobody reads standard output any more, as far as [`print()`] has noticed.
pub fn is_unread() -> bool {
    UNREAD.load(Ordering::Relaxed)
}

/// The complaint that standard output cannot be written.
pub fn unprintable(error: &io::Error) -> Complaint {
    Complaint::new("cannot-print").with("reason", Complaint::from(error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colour_is_forced_and_forbidden() {
        let of = |is_terminal, all: &[(&str, &str)]| {
            usual(is_terminal, |name| {
                let found = all.iter().find(|(n, _)| *n == name);
                found.map(|(_, value)| OsString::from(value))
            })
        };
        assert!(of(true, &[]) && !of(false, &[]));
        assert!(!of(true, &[("TERM", "dumb")]) && of(true, &[("TERM", "xterm")]));
        for name in ["FORCE_COLOR", "CLICOLOR_FORCE"] {
            assert!(of(false, &[(name, "1")]) && of(false, &[(name, "1"), ("TERM", "dumb")]));
            assert!(!of(false, &[(name, "")]) && !of(false, &[(name, "0")]));
            assert!(!of(true, &[(name, "1"), ("NO_COLOR", "1")]));
            assert!(of(false, &[(name, "1"), ("NO_COLOR", "")]));
        }
    }
}
