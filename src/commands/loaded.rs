//! Reading a scene file as far as it goes.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::Status;
use super::terminal::{LookChoice, complain, report};
use crate::config::Configs;
use crate::diagnostics::source::{Encoding, MAX_FILE_BYTES};
use crate::diagnostics::{self, Code, Complaint, Diagnostic, Severity, SourceFile, Span};
use crate::lint;
use crate::lint::levels::{Choice, Levels};
use crate::scene::{self, Render, Scene};
use crate::syntax::{self, Document};

/// The path that stands for standard input.
pub const STDIN: &str = "-";

/// A scene read as far as it goes, with everything there is to say about it.
pub struct Loaded {
    pub source: SourceFile,
    pub document: Document,
    pub scene: Scene,
    /// Sorted by place.
    pub diagnostics: Vec<Diagnostic>,
    /// Whether the scene has no errors of its own, whatever settings make one.
    pub sound: bool,
}

impl Loaded {
    /// Says on standard error what about the scene stands in the way, and where.
    pub fn refuse(&self, file: &Path, span: Span, why: Complaint, look: LookChoice) {
        let place = self.source.position(span.start);
        let complaint = Complaint::new("at-place")
            .with("path", file)
            .with("line", place.line.to_string())
            .with("column", place.column.to_string())
            .with("why", why);
        complain(look, &complaint);
    }

    /// Reads a scene from the bytes of its file; never fails.
    pub fn new(path: impl Into<String>, bytes: Vec<u8>) -> Loaded {
        let not_utf8 = std::str::from_utf8(&bytes).err().map(|e| e.valid_up_to());
        let source = SourceFile::new(path, bytes);
        let (document, mut diagnostics) = syntax::parse(&source.text);
        let scene = scene::resolve(&document, &source, &mut diagnostics);
        if let (Encoding::Windows1250, Some(at)) = (source.encoding, not_utf8) {
            diagnostics.push(not_utf8_note(&source, at));
        }
        let context = lint::Context::new(&source.text, &document, &scene);
        lint::run(&context, &mut diagnostics);
        diagnostics::sort(&mut diagnostics);
        Loaded {
            source,
            document,
            scene,
            sound: !diagnostics.iter().any(Diagnostic::is_error),
            diagnostics,
        }
    }

    /// As [`new`](Self::new), with what settings and the command line make of the findings.
    pub fn with(name: &Path, bytes: Vec<u8>, levels: &Levels, choice: &Choice) -> Loaded {
        let mut loaded = Loaded::new(name.to_string_lossy(), bytes);
        levels.apply(choice, &mut loaded.diagnostics);
        loaded
    }

    /// The render record, for commands that cannot do without one: that it is missing, a warning so
    /// far, becomes an error.
    pub fn require_render(&mut self) -> Option<Render> {
        for d in &mut self.diagnostics {
            if d.code == Code::E106 {
                d.severity = Severity::Error;
            }
        }
        self.scene.render
    }
}

/// What a command needs of a scene besides that it is sound.
#[derive(Debug, Clone, Copy)]
pub struct Needs {
    /// A render record.
    pub render: bool,
    /// A camera and a light, which are made up where there are none.
    pub view: bool,
}

impl Needs {
    pub const ALL: Needs = Needs {
        render: true,
        view: true,
    };

    /// Whether someone with these needs wants to know.
    fn concern(self, about: &Diagnostic) -> bool {
        match about.code {
            Code::E106 => self.render,
            Code::N602 | Code::N603 => self.view,
            _ => true,
        }
    }
}

/// Reads a scene for a command that needs a sound one: says everything there is to say about it, and
/// gives the exit status where there are errors or nothing to draw.
pub fn load_sound(path: &Path, look: LookChoice) -> Result<Loaded, Status> {
    load_for(Needs::ALL, path, look)
}

/// As [`load_sound`], for a command that can do without some things; nothing is said about these.
pub fn load_for(needs: Needs, path: &Path, look: LookChoice) -> Result<Loaded, Status> {
    let mut loaded = load(path).map_err(|e| {
        complain(look, &e);
        Status::Failure
    })?;
    let complete = !needs.render || loaded.require_render().is_some();
    loaded.diagnostics.retain(|d| needs.concern(d));
    report(&loaded, look);
    if !loaded.sound || !complete {
        return Err(Status::Negative);
    }
    Ok(loaded)
}

/// The note on a file in the old encoding, at its first byte that is not UTF-8.
fn not_utf8_note(source: &SourceFile, byte: usize) -> Diagnostic {
    // One byte of the file is one character of the text.
    let mut places = source.text.char_indices().skip(byte).map(|(i, _)| i);
    let start = places.next().unwrap_or(source.text.len());
    let end = places.next().unwrap_or(source.text.len());
    Diagnostic::new(Code::N601, Span::new(start as u32, end as u32))
}

/// Reads a scene file, with the settings of its folder; `-` is standard input.
pub fn load(path: &Path) -> Result<Loaded, Complaint> {
    let config = (Configs::default().for_file(path)).map_err(|e| e.complaint())?;
    let bytes = read(path)?;
    Ok(Loaded::with(
        path,
        bytes,
        &config.levels,
        &Choice::default(),
    ))
}

/// Reads a file's bytes; `-` is standard input.
pub fn read(path: &Path) -> Result<Vec<u8>, Complaint> {
    let error = |reason: Complaint| unreadable(path, reason);
    let too_large = || {
        let size = MAX_FILE_BYTES.div_ceil(1 << 30).to_string();
        error(Complaint::new("too-large").with("size", size))
    };
    let result = if path.as_os_str() == STDIN {
        read_limited(io::stdin().lock(), 0)
    } else {
        File::open(path).and_then(|file| {
            // A file that is known to be too large is not read at all.
            match file.metadata() {
                Ok(m) if m.is_file() && m.len() > MAX_FILE_BYTES as u64 => Ok(None),
                Ok(m) if m.is_file() => read_limited(file, m.len() as usize),
                _ => read_limited(file, 0),
            }
        })
    };
    match result {
        Ok(Some(bytes)) => Ok(bytes),
        Ok(None) => Err(too_large()),
        Err(e) => Err(error((&e).into())),
    }
}

/// A file cannot be read.
pub fn unreadable(path: &Path, reason: Complaint) -> Complaint {
    Complaint::new("cannot-read")
        .with("path", path)
        .with("reason", reason)
}

/// Reads everything, or nothing when there is more than may be. `size` is how much there seems to be.
fn read_limited(input: impl Read, size: usize) -> io::Result<Option<Vec<u8>>> {
    // The end is found by reading a little further.
    let mut bytes = Vec::with_capacity(size + 32);
    input
        .take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)?;
    Ok((bytes.len() <= MAX_FILE_BYTES).then_some(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_old_encoding_is_noted_at_its_first_byte() {
        let loaded = Loaded::new("a", b"# ok # \n# p\xf8\xed #".to_vec());
        let note = loaded
            .diagnostics
            .iter()
            .find(|d| d.code == Code::N601)
            .unwrap();
        assert_eq!(loaded.source.slice(note.span), "ř");
        let place = loaded.source.position(note.span.start);
        assert_eq!((place.offset, place.line, place.column), (11, 2, 4));
    }
}
