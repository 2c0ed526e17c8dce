//! Commands that take long. Each runs as a program of its own, which is this program with other arguments. Thus it has
//! memory of its own, and can be ended when nobody waits for it.
//!
//! The files that they make lie beside the scene, as on the command line. Those of a scene that was never saved lie in
//! the folder for temporary files.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use gen_lsp_types::{ExecuteCommandParams, LspAny, TextDocumentIdentifier, Uri};
use lsp_server::ErrorCode;
use serde_json::json;
use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, Signal, System};

use super::ask::Ask;
use super::documents::Snapshot;
use super::refusal::{Refusal, refusal};
use super::uri::{path_of, uri_of};
use super::whole_file::WholeFile;
use crate::analysis::repair;
use crate::diagnostics::{Code, Complaint, Language, Value};
use crate::features::pages;
use crate::study::program;
use crate::syntax::table::RecordType;
use crate::translate::registry;

/// The command that shows the page of a code or of a type of records.
pub(super) const EXPLAIN: &str = "zpg.explain";

/// All commands that run programs or show pages. Each except [`EXPLAIN`] takes the URI of an open file first.
pub(super) const COMMANDS: [&str; 6] = [
    "zpg.render",
    "zpg.convert",
    "zpg.plan",
    "zpg.crosscheck",
    "zpg.accuracy",
    EXPLAIN,
];

/// Runs a command. The answer has the `uri` of the file that was made, the `text` that was printed, or both.
pub(super) fn execute(ask: &Ask, p: ExecuteCommandParams) -> Result<Option<LspAny>, Refusal> {
    let arguments = p.arguments.unwrap_or_default();
    let text = |i: usize| arguments.get(i).and_then(|a| a.as_str());
    if p.command == EXPLAIN {
        return explain(ask, text(0).unwrap_or_default()).map(Some);
    }
    let invalid = |message, text: &str| {
        let message = (ask.client.language).say(message, &[("text", text.to_owned().into())]);
        refusal(ErrorCode::InvalidParams, message)
    };
    let whole = (WholeFile::ALL.into_iter()).find(|action| p.command == action.command());
    if whole.is_none() && !COMMANDS.contains(&p.command.as_str()) {
        return Err(invalid("lsp-no-command", &p.command));
    }
    let uri = Uri::from(text(0).unwrap_or_default());
    let file = ask.file(&TextDocumentIdentifier { uri })?;
    if let Some(action) = whole {
        return action.apply(ask, file).map(Some);
    }
    if let Some(why) = trouble(file, ask.client.language) {
        return Err(ask.refuse(&why));
    }
    let job = Job::of(ask, file);
    let made = match p.command.as_str() {
        "zpg.render" => {
            let out = job.beside("png");
            let mut arguments = vec!["render".into(), "-".into(), "-o".into(), out.clone().into()];
            if let Some(size) = text(1) {
                arguments.extend(["--size".into(), size.into()]);
            }
            job.run(&arguments)?;
            job.show(&out)
        }
        "zpg.convert" => {
            let target = text(1).unwrap_or("pov");
            let extension = match registry::named(target).map(|t| t.name()) {
                // The scene itself is not overwritten.
                None | Some("zpg") => return Err(invalid("lsp-no-target", target)),
                Some("mitsuba") => "xml",
                Some(name) => name,
            };
            let out = job.beside(extension);
            let to = ["convert", "-", "--to", target, "-o"].map(Into::into);
            job.run(&[&to[..], &[out.clone().into()]].concat())?;
            job.show(&out)
        }
        "zpg.plan" => {
            let plan = job.run(&["plan".into(), "-".into()])?;
            job.page("plan", "txt", &plan)?
        }
        "zpg.crosscheck" => {
            let out = job.beside("povray");
            let with = ["crosscheck", "-", "--with", "povray", "-o"].map(Into::into);
            let said = job.run(&[&with[..], &[out.into()]].concat())?;
            ask.outgoing.show_message(said.trim());
            json!({ "text": said })
        }
        "zpg.accuracy" => {
            let out = job.beside("accuracy");
            let mut arguments = vec![
                "accuracy".into(),
                "-".into(),
                "-o".into(),
                out.clone().into(),
            ];
            for (option, value) in [("--budget", text(1)), ("--size", text(2))] {
                arguments.extend(value.into_iter().flat_map(|v| [option.into(), v.into()]));
            }
            let said = job.run(&arguments)?;
            let page = out.join("accuracy.html");
            ask.outgoing.show_in_browser(&page);
            json!({ "uri": uri_of(&page), "text": said })
        }
        other => return Err(invalid("lsp-no-command", other)),
    };
    Ok(Some(made))
}

/// The reason, in one line, why nothing can be done with a file: it is missing, or its scene has errors, which the
/// client shows already. `None` if the scene is sound.
pub(super) fn trouble(file: &Snapshot, language: Language) -> Option<Complaint> {
    if file.is_missing {
        return Some(Complaint::new("lsp-missing").with("path", file.name()));
    }
    let analysis = file.analysis();
    if analysis.is_scene() && analysis.is_sound() {
        return None;
    }
    let findings = repair::proposals(analysis);
    let mut errors = findings.iter().filter(|d| d.is_error());
    let first = errors.next()?;
    let line = analysis.source.position(first.span.start).line;
    let why = Complaint::new("lsp-has-errors")
        .with("count", Value::Count(1 + errors.count() as u64))
        .with("line", line.to_string())
        .with("message", first.wording(language).message);
    Some(why)
}

/// The headline of a report on the terminal: its first line that begins with `error`, without the kind, or else its
/// first line.
fn headline<'a>(report: &'a str, error: &str) -> &'a str {
    let says_so = |line: &&str| line.starts_with(error);
    let line = report.lines().find(says_so).or(report.lines().next());
    match line.unwrap_or_default().split_once(": ") {
        Some((kind, rest)) if kind.starts_with(error) => rest,
        _ => line.unwrap_or_default(),
    }
}

/// Shows the page of a code or of a type of records to the client.
fn explain(ask: &Ask, topic: &str) -> Result<serde_json::Value, Refusal> {
    let language = ask.client.language;
    let ty = || RecordType::by_code(topic.parse().ok()?).or_else(|| RecordType::by_keyword(topic));
    let page = match (Code::parse(topic), ty()) {
        (Some(code), _) => (code.as_str(), pages::code_page(code, language)),
        (None, Some(ty)) => (ty.keyword, pages::type_page(ty, language)),
        (None, None) => {
            let why = Complaint::new("no-topic").with("text", crate::syntax::quote(topic));
            return Err(ask.refuse(&why));
        }
    };
    let path = write_page(page.0, "md", &page.1).map_err(|why| ask.refuse(&why))?;
    ask.outgoing.show_document(&path);
    Ok(json!({ "text": page.1, "uri": uri_of(&path) }))
}

/// The folder for the texts that the client is shown.
fn pages_folder() -> PathBuf {
    std::env::temp_dir().join(format!("zpg-{}", std::process::id()))
}

/// The folder for files made from a text that was never saved: the one for shown texts, or else that for all temporary
/// files.
fn unsaved() -> PathBuf {
    let folder = pages_folder();
    match std::fs::create_dir_all(&folder) {
        Ok(()) => folder,
        Err(_) => std::env::temp_dir(),
    }
}

/// Removes the folder of the shown texts, when the server ends.
pub(super) fn remove_pages() {
    // The folder is missing if no text was shown.
    let _ = std::fs::remove_dir_all(pages_folder());
}

/// Writes a text for the client to show.
fn write_page(name: &str, extension: &str, text: &str) -> Result<PathBuf, Complaint> {
    let folder = pages_folder();
    let path = folder.join(name).with_extension(extension);
    let written = std::fs::create_dir_all(&folder).and_then(|()| std::fs::write(&path, text));
    written.map(|()| path.clone()).map_err(|e| {
        Complaint::new("cannot-write")
            .with("path", path.as_path())
            .with("reason", Complaint::from(&e))
    })
}

/// A command on a scene.
struct Job<'a> {
    ask: &'a Ask,
    file: &'a Snapshot,
    /// The folder that the program runs in and writes to. The scene's pictures are found from there.
    folder: PathBuf,
    stem: String,
}

/// The time between two looks at a program.
const STEP: Duration = Duration::from_millis(20);

/// The time that a program may take to end after it was interrupted.
const GRACE: Duration = Duration::from_secs(10);

impl<'a> Job<'a> {
    fn of(ask: &'a Ask, file: &'a Snapshot) -> Job<'a> {
        let path = path_of(&file.uri);
        let folder = path
            .as_deref()
            .and_then(Path::parent)
            .filter(|f| f.is_dir());
        let stem = path.as_deref().and_then(Path::file_stem);
        Job {
            ask,
            file,
            // Files of a scene that was never saved must not replace other files.
            folder: folder.map_or_else(unsaved, Path::to_owned),
            stem: stem.map_or_else(|| "scene".to_owned(), |s| s.to_string_lossy().into_owned()),
        }
    }

    fn beside(&self, extension: &str) -> PathBuf {
        self.folder.join(format!("{}.{extension}", self.stem))
    }

    /// Runs zpg with the scene as its input, and returns its output.
    fn run(&self, arguments: &[std::ffi::OsString]) -> Result<String, Refusal> {
        let why = |reason: Complaint| {
            let why = Complaint::new("lsp-cannot-run").with("reason", reason);
            self.ask.refuse(&why)
        };
        let io = |e: &std::io::Error| why(Complaint::from(e));
        let program = std::env::current_exe().map_err(|e| io(&e))?;
        let mut command = Command::new(program);
        command.args(["--lang", self.ask.client.language.tag()]);
        let pipes = (command.args(arguments).current_dir(&self.folder))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = pipes.spawn().map_err(|e| io(&e))?;
        let text = self.file.analysis().source.text.clone();
        let input = child.stdin.take();
        let writer = thread::spawn(move || input.map(|mut i| i.write_all(text.as_bytes())));
        let (out, said) = (child.stdout.take(), child.stderr.take());
        let out = thread::spawn(move || all_of(out));
        let said = thread::spawn(move || all_of(said));
        let success = self.wait(&mut child).map_err(|e| io(&e))?;
        let _ = writer.join();
        let out = out.join().unwrap_or_default();
        let said = said.join().unwrap_or_default();
        match success {
            Some(true) => Ok(out),
            Some(false) => {
                let error = self.ask.client.language.say("error", &[]);
                Err(why(Complaint::quoted(headline(said.trim(), &error))))
            }
            None => Err(refusal(ErrorCode::RequestCanceled, "stopped")),
        }
    }

    /// Waits for the program's end, and returns whether it has succeeded. `None` if it was ended since the client does
    /// not wait any more.
    fn wait(&self, child: &mut Child) -> std::io::Result<Option<bool>> {
        loop {
            if let Some(status) = child.try_wait()? {
                return Ok(Some(status.success()));
            }
            if self.ask.is_cancelled() {
                end(child)?;
                return Ok(None);
            }
            thread::sleep(STEP);
        }
    }

    fn show(&self, path: &Path) -> serde_json::Value {
        self.ask.outgoing.show_document(path);
        json!({ "uri": uri_of(path) })
    }

    fn page(&self, name: &str, extension: &str, text: &str) -> Result<serde_json::Value, Refusal> {
        let path = write_page(name, extension, text).map_err(|why| self.ask.refuse(&why))?;
        self.ask.outgoing.show_document(&path);
        Ok(json!({ "uri": uri_of(&path), "text": text }))
    }
}

/// Ends a program as Ctrl-C does, so that it removes its drafts of files. A program that does not react is killed.
fn end(child: &mut Child) -> std::io::Result<()> {
    let pid = Pid::from_u32(child.id());
    let mut system = System::new();
    let which = ProcessesToUpdate::Some(&[pid]);
    system.refresh_processes_specifics(which, true, ProcessRefreshKind::nothing());
    let process = system.process(pid);
    let is_told = process.and_then(|p| p.kill_with(Signal::Interrupt)) == Some(true);
    let latest = Instant::now() + GRACE;
    while is_told && Instant::now() < latest {
        if child.try_wait()?.is_some() {
            return Ok(());
        }
        thread::sleep(STEP);
    }
    program::end_those_of(child.id());
    child.kill()?;
    child.wait().map(drop)
}

fn all_of(stream: Option<impl Read>) -> String {
    let mut bytes = Vec::new();
    if let Some(mut stream) = stream {
        let _ = stream.read_to_end(&mut bytes);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
