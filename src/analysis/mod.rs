//! A scene file analysed: bytes become text, records, a scene and, when somebody asks, findings.
//!
//! The commands, the tests and the editor features all start from an [`Analysis`]. It prints nothing and
//! knows of no command line.

pub mod allowing;
pub mod colours;
mod commas;
pub mod config;
pub mod file;
pub mod fixing;
pub mod repair;
mod worse;

use std::sync::OnceLock;

use rustc_hash::FxHashMap;

use crate::diagnostics::source::Encoding;
use crate::diagnostics::{self, Code, Diagnostic, SourceFile, Span};
use crate::lint;
use crate::lint::levels::{Choice, Levels};
use crate::scene::{self, Scene};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::syntax::recognise::{self, Stranger};
use crate::syntax::table::{Effect, RecordKind};
use crate::syntax::{self, Document, Item, Record, lexer};

/// A scene read as far as it goes.
#[derive(Debug)]
pub struct Analysis {
    pub source: SourceFile,
    pub document: Document,
    pub scene: Scene,
    /// Whether the file is a scene. If not, one finding says so, and there is nothing else.
    is_scene: bool,
    /// What reading found: the lexer, the parser, the resolver, and the encoding.
    read: Vec<Diagnostic>,
    settings: Settings,
    findings: OnceLock<Vec<Diagnostic>>,
    definitions: OnceLock<FxHashMap<u32, u32>>,
    bounds: OnceLock<Vec<NodeBounds>>,
}

/// How much findings weigh: what `zpg.toml` says, and what was asked for in one run.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    pub levels: Levels,
    pub choice: Choice,
}

impl Analysis {
    /// Reads a scene from the bytes of its file; never fails. `path` is what messages call it.
    pub fn new(path: impl Into<String>, bytes: Vec<u8>) -> Analysis {
        match recognise::read(path, bytes) {
            Ok(source) => Analysis::of(source),
            Err(stranger) => Analysis::stranger(*stranger),
        }
    }

    /// A file that is no scene.
    pub fn stranger(stranger: Stranger) -> Analysis {
        let Stranger { source, finding } = stranger;
        let document = Document {
            tokens: lexer::lex(&source.text, &[]),
            ..Document::default()
        };
        Analysis {
            source,
            document,
            scene: Scene::default(),
            is_scene: false,
            read: vec![finding],
            settings: Settings::default(),
            findings: OnceLock::new(),
            definitions: OnceLock::new(),
            bounds: OnceLock::new(),
        }
    }

    /// Reads a scene from its text.
    pub fn of(source: SourceFile) -> Analysis {
        let (document, mut read) = syntax::parse(&source.text);
        commas::join(&source, &mut read);
        colours::join(&document, &source, &mut read);
        let scene = scene::resolve(&document, &source, &mut read);
        read.extend(encoding_note(&source));
        Analysis {
            source,
            document,
            scene,
            is_scene: true,
            read,
            settings: Settings::default(),
            findings: OnceLock::new(),
            definitions: OnceLock::new(),
            bounds: OnceLock::new(),
        }
    }

    /// The analysis with settings for its findings.
    #[must_use]
    pub fn with_settings(self, settings: Settings) -> Analysis {
        Analysis {
            settings,
            findings: OnceLock::new(),
            ..self
        }
    }

    /// Whether the file is a scene.
    pub fn is_scene(&self) -> bool {
        self.is_scene
    }

    /// Whether the scene has no errors of its own, whatever settings take for one. The rules are not run
    /// for that: they never find errors.
    pub fn is_sound(&self) -> bool {
        !self.read.iter().any(Diagnostic::is_error)
    }

    /// Everything there is to say about the scene, with the settings applied, sorted by place. The rules
    /// are run when this is first called.
    pub fn findings(&self) -> &[Diagnostic] {
        self.findings.get_or_init(|| self.find())
    }

    /// The findings, if somebody has asked for them already.
    pub fn known_findings(&self) -> Option<&[Diagnostic]> {
        self.findings.get().map(Vec::as_slice)
    }

    /// The record that defines an ID; one that declares it (type 0), or changes it, where there is no other.
    pub fn definition(&self, id: u32) -> Option<&Record> {
        let all = self.definitions.get_or_init(|| self.find_definitions());
        match self.document.items.get(*all.get(&id)? as usize)? {
            Item::Record(record) => Some(record),
            _ => None,
        }
    }

    fn find_definitions(&self) -> FxHashMap<u32, u32> {
        let mut all = FxHashMap::default();
        let mut weak = FxHashMap::default();
        for (i, item) in (0..).zip(&self.document.items) {
            let Item::Record(record) = item else { continue };
            let defines = !matches!(record.ty().effect, Effect::Changes(_))
                && record.kind != RecordKind::Undefined;
            match defines {
                true => all.entry(record.id).or_insert(i),
                false => weak.entry(record.id).or_insert(i),
            };
        }
        for (id, i) in weak {
            all.entry(id).or_insert(i);
        }
        all
    }

    /// The bounds of each node of the scene.
    pub fn bounds(&self) -> &[NodeBounds] {
        self.bounds.get_or_init(|| node_bounds(&self.scene))
    }

    /// The findings, which are looked for again when they are asked for next.
    fn take_findings(&mut self) -> Vec<Diagnostic> {
        self.findings.take().unwrap_or_else(|| self.find())
    }

    fn find(&self) -> Vec<Diagnostic> {
        let Settings { levels, choice } = &self.settings;
        let mut all = self.read.clone();
        if self.is_scene {
            let context = lint::Context::new(&self.source.text, &self.document, &self.scene);
            lint::run(&context, |code| levels.is_on(choice, code), &mut all);
            diagnostics::sort(&mut all);
        }
        levels.apply(choice, &mut all);
        all
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_old_encoding_is_noted_at_its_first_byte() {
        let analysis = Analysis::new("a", b"# ok # \n# p\xf8\xed #".to_vec());
        let note = analysis
            .findings()
            .iter()
            .find(|d| d.code == Code::N601)
            .unwrap();
        assert_eq!(analysis.source.slice(note.span), "ř");
        let place = analysis.source.position(note.span.start);
        assert_eq!((place.offset, place.line, place.column), (11, 2, 4));
    }
}
