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
use crate::syntax::recognise::{self, Stranger};
use crate::syntax::{self, Document, lexer};

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
    /// Whether the file is a scene. If not, that is all there is to say about it.
    pub is_scene: bool,
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
        match recognise::read(path, bytes) {
            Ok(source) => Loaded::of(source),
            Err(stranger) => Loaded::stranger(*stranger),
        }
    }

    /// What there is to say about a file that is no scene.
    pub fn stranger(stranger: Stranger) -> Loaded {
        let Stranger { source, finding } = stranger;
        let document = Document {
            tokens: lexer::lex(&source.text, &[]),
            items: Vec::new(),
        };
        Loaded {
            source,
            document,
            scene: Scene::default(),
            diagnostics: vec![finding],
            sound: false,
            is_scene: false,
        }
    }

    /// Reads a scene from its text.
    pub fn of(source: SourceFile) -> Loaded {
        let (document, mut diagnostics) = syntax::parse(&source.text);
        let scene = scene::resolve(&document, &source, &mut diagnostics);
        diagnostics.extend(encoding_note(&source));
        let context = lint::Context::new(&source.text, &document, &scene);
        lint::run(&context, &mut diagnostics);
        diagnostics::sort(&mut diagnostics);
        Loaded {
            source,
            document,
            scene,
            is_scene: true,
            sound: !diagnostics.iter().any(Diagnostic::is_error),
            diagnostics,
        }
    }

    /// The findings as settings and the command line make them.
    pub fn at(mut self, levels: &Levels, choice: &Choice) -> Loaded {
        levels.apply(choice, &mut self.diagnostics);
        self
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
    if !loaded.is_scene {
        return Err(Status::Failure);
    }
    if !loaded.sound || !complete {
        return Err(Status::Negative);
    }
    Ok(loaded)
}

/// The note on a file that is not UTF-8: in the old encoding, at its first byte that shows it.
fn encoding_note(source: &SourceFile) -> Option<Diagnostic> {
    let note = |code, at: usize| {
        let end = source.text[at..].chars().next().map_or(0, char::len_utf8) + at;
        Diagnostic::new(code, Span::new(at as u32, end as u32))
    };
    match source.encoding {
        Encoding::Utf8 => None,
        Encoding::Windows1250 => {
            // One byte of the file is one character of the text.
            let bytes = source.encode(&source.text)?;
            let before = std::str::from_utf8(&bytes).err()?.valid_up_to();
            let at = source.text.char_indices().nth(before)?.0;
            Some(note(Code::N601, at))
        }
        Encoding::Utf16Le | Encoding::Utf16Be if source.is_whole => Some(note(Code::N604, 0)),
        Encoding::Utf16Le | Encoding::Utf16Be => Some(note(Code::N604, 0).case("incomplete")),
    }
}

/// Reads a scene file, with the settings of its folder; `-` is standard input.
pub fn load(path: &Path) -> Result<Loaded, Complaint> {
    let config = (Configs::default().for_file(path)).map_err(|e| e.complaint())?;
    let bytes = read(path)?;
    let loaded = Loaded::new(path.to_string_lossy(), bytes);
    Ok(loaded.at(&config.levels, &Choice::default()))
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
