//! `zpg check`: reads scenes, says what is wrong with them, and mends it.

mod report;
mod statistics;

use std::borrow::Cow;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::apart::apart;
use super::atomic_file::{self, try_file_in_new_folder, unwritable};
use super::difference::{Change, changes, diff};
use super::endings;
use super::habits;
use super::help;
use super::load::{analyse, is_json};
use super::memory::Memory;
use super::paths::{is_stdin, is_stdout};
use super::refuse_overwrite::refuse_overwrite_of_scenes;
use super::rewrite::{allow, bytes_of, replace};
use super::settings::{Chosen, Scenes, pass_through};
use super::terminal::Complaints;
use super::{LookChoice, Status, complain, terminal, watch};
use crate::analysis::config::{ConfigError, Configs, whole};
use crate::analysis::file;
use crate::analysis::{Analysis, Settings, allowing, fixing, repair};
use crate::diagnostics::render::Tally;
use crate::diagnostics::render::human::Look;
use crate::diagnostics::{Code, Complaint, Language, SourceFile, Value};
use crate::lint::levels::{Choice, Selector};
use crate::parallel;
use crate::syntax::quote;
use report::{Format, Output};
use statistics::Statistics;

/// Check scenes for mistakes
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Findings go to standard output. The exit status is 0 when there is no error, 1 when there is
one (or --diff shows a change), 2 when a file cannot be read or written, or is no scene: such a file
is never written to.

CODE is a code (W307), its name (overlapping-union), how codes begin (W3), or one of warnings,
notes, style and all. Levels for a folder of scenes stand in zpg.toml; a comment
`# zpg: allow(W307) #` allows a finding where it is. Of --select, --extend-select, --ignore and
--deny the one that names fewer codes counts. Errors of the language are always reported.

A scene in JSON (FILE.json) is checked as one of records is, but --fix, --diff and --add-allow refuse it.

The settings of zpg.toml can also be given with --config. Its `exclude` leaves out files and folders
that are come across, and `per-file-ignores` leaves out codes in some files.

Examples:
  zpg check                            all *.zpg in this folder and below
  zpg check scene.zpg
  zpg check scenes/                    all *.zpg in the folder, .gitignore honoured
  zpg check --fix scene.zpg            mend what is certain
  zpg check --add-allow scenes/        have comments allow what is left
  zpg check --diff scene.zpg           show what --fix would change
  zpg check --deny warnings scenes/    for a continuous build
  zpg check --format short scenes/     one line for each finding
  zpg check --format json - < scene.zpg
  zpg check --format sarif --output-file zpg.sarif scenes/
  zpg check --isolated --config lint.W310=off scenes/

`zpg explain E101` tells more about a finding.")]
pub struct Args {
    #[command(flatten)]
    chosen: Chosen,

    /// How to print the findings
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, alias = "output-format", value_enum, default_value_t)]
    format: Format,

    /// Write the findings to this file, not to standard output
    #[arg(help_heading = help::REPORTS)]
    #[arg(short, long, value_name = "FILE")]
    output_file: Option<PathBuf>,

    /// Exit with 0 even if there are errors; 2 stays 2
    #[arg(help_heading = help::CHOICE)]
    #[arg(long)]
    exit_zero: bool,

    /// List the files that would be checked
    #[arg(help_heading = help::FILES)]
    #[arg(long, conflicts_with_all = ["show_settings", "fix", "diff", "statistics", "watch"])]
    show_files: bool,

    /// Show the settings of the first file, as they could stand in its zpg.toml
    #[arg(help_heading = help::FILES)]
    #[arg(long, conflicts_with_all = ["fix", "diff", "statistics", "watch"])]
    show_settings: bool,

    /// Mend what can be mended safely, in place; a scene from standard input goes to standard output
    #[arg(long)]
    fix: bool,

    /// With --fix or --add-allow: change files even if their names end as those of other tools' files do (.csv, .md,
    /// .obj …)
    #[arg(help_heading = help::FILES)]
    #[arg(long)]
    force: bool,

    /// Write comments that allow all findings that are left; errors cannot be allowed
    #[arg(long, conflicts_with_all = ["fix", "diff", "watch", "show_files", "show_settings"])]
    add_allow: bool,

    /// With --fix or --diff: apply guesses, too
    #[arg(long)]
    unsafe_fixes: bool,

    /// Write nothing; show what --fix would change
    #[arg(long)]
    diff: bool,

    /// Report only these (and errors)
    #[arg(help_heading = help::CHOICE)]
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    select: Vec<Selector>,

    /// Report these, too, even if the settings turn them off
    #[arg(help_heading = help::CHOICE)]
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    extend_select: Vec<Selector>,

    /// Do not report these
    #[arg(help_heading = help::CHOICE)]
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    ignore: Vec<Selector>,

    /// Take these for errors
    #[arg(help_heading = help::CHOICE)]
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    deny: Vec<Selector>,

    /// Count the findings of each code instead of printing them (as text or JSON)
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, conflicts_with = "diff")]
    statistics: bool,

    /// What standard input goes by, in messages, for zpg.toml and for images; without a PATH, standard input is read
    #[arg(help_heading = help::FILES)]
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<PathBuf>,

    #[command(flatten)]
    memory: Memory,

    /// Check again whenever a file changes
    #[arg(short, long, conflicts_with_all = ["fix", "diff"])]
    watch: bool,
}

impl Args {
    /// The endings of file names that fit what is printed.
    fn endings(&self) -> &'static [&'static str] {
        match self.show_settings {
            true => &["toml"],
            false if self.show_files => &[],
            false => self.format.endings(),
        }
    }
}

/// The findings of a file, ready to be put out.
struct Checked {
    is_scene: bool,
    output: Output,
    /// The mended scene for standard output, or the diff; else empty.
    data: Vec<u8>,
    tally: Tally,
    statistics: Statistics,
    /// How many findings were mended.
    fixed: usize,
    /// How many findings comments allow now.
    allowed: usize,
    /// The changes that unsafe fixes have made, a line each.
    changes: Vec<String>,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let fixed_error = |s: &Selector| s.fixed_error().map(Code::as_str);
    if let Some(code) = args.ignore.iter().find_map(fixed_error) {
        complain(
            look,
            &Complaint::new("error-not-ignored").with("code", code),
        );
        return Status::Failure;
    }
    if args.statistics && !matches!(args.format, Format::Human | Format::Json) {
        complain(look, &Complaint::new("statistics-format"));
        return Status::Failure;
    }
    let roots = args.chosen.roots(args.stdin_filename.as_deref());
    if let Some((path, instead)) = roots.iter().find_map(|p| Some((p, habits::of_check(p)?))) {
        let what = Complaint::new("no-scene").with("path", path.as_path());
        let complaint = Complaint::new("with-reason").with("what", what);
        complain(look, &complaint.with("reason", instead));
        return Status::Failure;
    }
    if args.watch {
        let never = AtomicBool::new(false);
        return watch::run(&roots, look, &never, |_| false, || once(args, look));
    }
    once(args, look)
}

/// Checks all files once.
fn once(args: &Args, look: LookChoice) -> Status {
    let stdin = args.stdin_filename.as_deref();
    let Some(Scenes { files, configs }) = args.chosen.scenes(stdin, look) else {
        return Status::Failure;
    };
    let mends = args.fix || args.add_allow;
    if files.files.is_empty() && mends && args.chosen.reads_stdin(stdin) {
        return pass_through(!args.diff, look);
    }
    let checker = Checker {
        args,
        choice_of_look: look,
        look: match args.output_file.as_deref() {
            Some(path) if !is_stdout(path) => look.on_file(),
            _ => look.on(&io::stdout()),
        },
        configs,
        at_a_time: rayon::current_num_threads().min(files.files.len()),
        choice: Choice {
            select: args.select.clone(),
            extend: args.extend_select.clone(),
            ignore: args.ignore.clone(),
            deny: args.deny.clone(),
        },
    };
    let named = args.output_file.iter().filter(|path| !is_stdout(path));
    let mut tried = named.map(|path| {
        refuse_overwrite_of_scenes(&files.files, path)?;
        endings::fits(path, args.endings())?;
        try_file_in_new_folder(path)
    });
    if let Err(complaint) = tried.try_for_each(|tried| tried) {
        complain(look, &complaint);
        return Status::Failure;
    }
    if args.show_files || args.show_settings {
        return checker.show(&files.files);
    }
    let results = parallel::map(files.files.len(), |i| {
        let path = &files.files[i];
        apart(checker.name(path), || checker.check(path))
    });

    let mut failed = files.failed;
    let mut complaints = Complaints::new(look);
    let mut all = Vec::new();
    for result in results {
        match result {
            Ok(checked) => all.push(checked),
            Err(complaint) => {
                complaints.say(complaint);
                failed = true;
            }
        }
    }
    let mut total = Tally::default();
    all.iter().for_each(|c| total.merge(&c.tally));
    let changed = all.iter().any(|c| c.fixed > 0);
    let status = if failed || all.iter().any(|c| !c.is_scene) {
        Status::Failure
    } else if !args.exit_zero && (total.errors > 0 || args.diff && changed) {
        Status::Negative
    } else {
        Status::Clean
    };
    checker.print(status, all, &total)
}

struct Checker<'a> {
    args: &'a Args,
    choice_of_look: LookChoice,
    look: Look,
    configs: Arc<Configs>,
    choice: Choice,
    /// How many files are read at a time.
    at_a_time: usize,
}

impl Checker<'_> {
    /// The name of a file in messages and for settings: that of `--stdin-filename` for standard input.
    fn name<'p>(&'p self, path: &'p Path) -> &'p Path {
        match &self.args.stdin_filename {
            Some(name) if is_stdin(path) => name,
            _ => path,
        }
    }

    /// Lists the files, or shows the settings of the first one.
    fn show(&self, files: &[PathBuf]) -> Status {
        let look = self.choice_of_look;
        let mut names: Vec<PathBuf> = files.iter().map(|f| whole(self.name(f))).collect();
        if self.args.show_files {
            names.sort();
            return self.put(Status::Clean, |out| {
                let mut lines = names.iter().map(|name| name.to_string_lossy());
                lines.try_for_each(|name| writeln!(out, "{name}"))
            });
        }
        let Some(file) = names.first() else {
            complain(look, &Complaint::new("no-files"));
            return Status::Failure;
        };
        let config = match self.configs.for_file(file) {
            Ok(config) => config,
            Err(e) => {
                complain(look, &e.complaint());
                return Status::Failure;
            }
        };
        let from = match &config.path {
            Some(path) => path.to_string_lossy().into_owned(),
            None => "-".to_owned(),
        };
        self.put(Status::Clean, |out| {
            writeln!(out, "# {}", file.to_string_lossy())?;
            writeln!(out, "# zpg.toml: {from}")?;
            out.write_all(config.show(file, &self.choice).as_bytes())
        })
    }

    /// Writes to the file of `--output-file`, or to standard output.
    fn put(&self, status: Status, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Status {
        let look = self.choice_of_look;
        let named = self.args.output_file.as_ref();
        let Some(path) = named.filter(|path| !is_stdout(path)) else {
            return terminal::print(look, status, write);
        };
        // A missing folder is made, as ruff does.
        let folder = path.parent().unwrap_or(Path::new(""));
        let written = std::fs::create_dir_all(folder)
            .map_err(|e| unwritable(path, &e))
            .and_then(|()| atomic_file::write(path, write));
        match written {
            Ok(()) => status,
            Err(complaint) => {
                complain(look, &complaint);
                Status::Failure
            }
        }
    }

    /// Checks and mends one file.
    fn check(&self, path: &Path) -> Result<Checked, Complaint> {
        let is_stdin = is_stdin(path);
        let name = self.name(path);
        let config = (self.configs.for_file(name)).map_err(ConfigError::complaint)?;
        self.args.memory.admit(path, self.at_a_time)?;
        let changes_it = self.args.fix || self.args.diff || self.args.add_allow;
        if changes_it && !is_stdin {
            allow(path, self.args.force, !self.args.diff)?;
        }
        let bytes = file::read(path)?;
        let settings = Settings {
            levels: config.levels(name),
            choice: self.choice.clone(),
        };
        let levelled = |analysis: Analysis| analysis.with_settings(settings.clone());
        if changes_it && is_json(name, &bytes) {
            return Err(Complaint::new("json-not-changed").with("path", name));
        }
        let mut loaded = levelled(analyse(name, bytes));
        let mut data = Vec::new();
        let mut fixed = 0;
        let mut left = None;
        let mut changes = Vec::new();
        if !loaded.is_scene() && self.args.diff {
            // With --diff the findings are not printed, and there is no difference: why the file is no scene is said
            // here.
            terminal::findings(&loaded.source, loaded.findings(), self.choice_of_look);
        }
        if loaded.is_scene() && (self.args.fix || self.args.diff) {
            let old = loaded.source.text.clone();
            let again = |source| levelled(Analysis::of(source));
            let mended = fixing::to_fixed_point(loaded, self.args.unsafe_fixes, again);
            if self.args.unsafe_fixes && !self.args.diff {
                changes = changes_of(&mended.analysis.source, &old, self.look.language);
            }
            (loaded, fixed) = (mended.analysis, mended.count);
            left = Some(mended.findings);
            let source = &loaded.source;
            // A text that cannot be written is refused even if nothing is to be written.
            let bytes = match fixed > 0 || is_stdin {
                true => bytes_of(source, &source.text, false)?,
                false => Cow::default(),
            };
            if self.args.diff {
                if fixed > 0 {
                    diff(
                        &mut data,
                        &source.path,
                        &old,
                        &source.text,
                        self.look.colour,
                    );
                }
            } else if is_stdin {
                data = bytes.into_owned();
            } else if fixed > 0 {
                replace(path, &bytes)?;
            }
        }
        let mut allowed = 0;
        if loaded.is_scene() && self.args.add_allow {
            let made = allowing::all(loaded, |source| levelled(Analysis::of(source)));
            (loaded, allowed) = (made.analysis, made.count);
            let source = &loaded.source;
            if is_stdin {
                data = bytes_of(source, &source.text, false)?.into_owned();
            } else if allowed > 0 {
                replace(path, &bytes_of(source, &source.text, false)?)?;
            }
        }
        let mut tally = Tally::default();
        let mut findings = left.unwrap_or_else(|| match fixing::is_tried(&loaded) {
            // Guesses are tried against the findings, which stay in the analysis for that.
            true => repair::proposals(&loaded),
            false => {
                let found = loaded.take_findings();
                repair::proposals_for(&loaded, found)
            }
        });
        fixing::explain_what_is_left(&loaded, &mut findings);
        tally.add(&findings);
        let statistics = Statistics::new(&findings);
        Ok(Checked {
            is_scene: loaded.is_scene(),
            changes,
            output: match self.args.statistics {
                true => Output::Text(Vec::new()),
                false => Output::new(self.args.format, &loaded.source, findings, self.look),
            },
            data,
            tally,
            statistics,
            fixed,
            allowed,
        })
    }

    fn print(&self, status: Status, all: Vec<Checked>, total: &Tally) -> Status {
        let args = self.args;
        let fixes = self.fixes(&all);
        let stdin = args.stdin_filename.as_deref();
        // Where standard output carries a scene or a difference, it carries nothing else.
        let mends_stdin = (args.fix || args.add_allow) && args.chosen.reads_stdin(stdin);
        let data: Vec<Vec<u8>> = (all.iter()).map(|c| c.data.clone()).collect();
        let left = self.left(&all, total);
        let report = |out: &mut dyn Write| {
            if args.statistics {
                let sum = Statistics::sum(all.iter().map(|c| &c.statistics));
                return match args.format {
                    Format::Json => sum.write_json(out, total),
                    _ => sum.write(out),
                };
            }
            let outputs = all.into_iter().map(|c| c.output).collect();
            let complete = status != Status::Failure;
            report::write(
                out,
                args.format,
                outputs,
                &fixes,
                total,
                complete,
                (self.look, self.choice_of_look.quiet),
            )
        };
        if args.diff || mends_stdin {
            let mut status = status;
            if args.diff {
                fixes.lines().for_each(terminal::tell);
                if let Some(left) = left.filter(|_| !self.choice_of_look.quiet) {
                    terminal::tell(&left);
                }
            } else if args.output_file.is_some() {
                status = self.put(status, report);
            } else {
                // Nobody is left to be told when standard error is gone.
                let _ = report(&mut io::stderr().lock());
            }
            return terminal::print(self.choice_of_look, status, |out| {
                data.iter().try_for_each(|d| out.write_all(d))
            });
        }
        self.put(status, report)
    }

    /// The line about the findings that a difference does not show: guesses, or all findings where it has no change.
    fn left(&self, all: &[Checked], total: &Tally) -> Option<String> {
        let count = |n: usize| Value::Count(n as u64);
        let guesses = match self.args.unsafe_fixes {
            true => 0,
            false => total.fixable_unsafe,
        };
        let is_changed = all.iter().any(|c| c.fixed > 0);
        let findings = total.errors + total.warnings + total.notes + total.style;
        // A file that is no scene has its own message.
        let is_read = all.iter().all(|c| c.is_scene);
        let language = self.look.language;
        if !is_changed && findings > 0 && is_read {
            let key = match self.args.unsafe_fixes {
                true => "diff-no-fixes",
                false => "diff-no-safe-fixes",
            };
            let values = [("count", count(findings)), ("unsafe", count(guesses))];
            return Some(language.say(key, &values));
        }
        let left = [("count", count(guesses))];
        (guesses > 0).then(|| language.say("diff-left", &left))
    }

    /// The line `Fixed 3 findings in 1 file.` or its like, with a line below it for each change by an unsafe fix. Empty
    /// if nothing was changed, or with `--quiet`.
    fn fixes(&self, all: &[Checked]) -> String {
        let of = |checked: &Checked| checked.fixed + checked.allowed;
        let changed = all.iter().map(of).sum::<usize>();
        if changed == 0 || self.choice_of_look.quiet {
            return String::new();
        }
        let files = all.iter().filter(|c| of(c) > 0).count();
        let message = match (self.args.add_allow, self.args.diff) {
            (true, _) => "allowed",
            (_, true) => "would-fix",
            _ => "fixed",
        };
        let values = [
            ("count", Value::Count(changed as u64)),
            ("files", Value::Count(files as u64)),
        ];
        let changes = all.iter().flat_map(|c| &c.changes);
        let listed: String = changes.map(|line| format!("  {line}\n")).collect();
        self.look.language.say(message, &values) + "\n" + &listed
    }
}

/// The changes from `old` to the text of `now`, such as `scene.zpg:4: -204 → -299`: a line for each changed line of the
/// scene.
fn changes_of(now: &SourceFile, old: &str, language: Language) -> Vec<String> {
    let shown = |text: &str| match text {
        "" => language.say("change-nothing", &[]),
        text => quote(text),
    };
    let told = |change: &Change| {
        let values = [
            (
                "place",
                Value::from(format!("{}:{}", now.path, change.line)),
            ),
            ("old", shown(change.old).into()),
            ("new", shown(change.new).into()),
        ];
        language.say("change", &values)
    };
    changes(old, &now.text).iter().map(told).collect()
}
