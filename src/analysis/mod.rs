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
mod lone_signs;
mod materials;
mod moving;
pub mod parameters;
mod pictures;
pub mod repair;
mod worse;

use std::fmt;
use std::sync::OnceLock;

use rustc_hash::FxHashMap;

use crate::diagnostics::source::Encoding;
use crate::diagnostics::{self, Code, Diagnostic, SourceFile, Span, Value};
use crate::lint;
use crate::lint::levels::{Choice, Levels};
use crate::scene::{self, Scene};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::syntax::recognise::{self, NotAScene};
use crate::syntax::table::{Effect, RecordKind};
use crate::syntax::{self, Document, Item, Record, in_records, lexer};

/// A scene file with all that could be read of it.
#[warn(missing_docs)]
#[derive(Debug)]
pub struct Analysis {
    /// The scene file.
    pub source: SourceFile,
    /// The records of the text.
    pub document: Document,
    /// The scene that the records make.
    pub scene: Scene,
    /// Whether the file is a scene. If not, one finding says so, and there is nothing else.
    is_scene: bool,
    /// The findings of reading: those of the lexer, the parser, the resolver, and the encoding.
    read: Vec<Diagnostic>,
    /// The code and place of each error in `read`. They stay when `read` is taken.
    errors: Vec<(Code, Span)>,
    settings: Settings,
    findings: OnceLock<Vec<Diagnostic>>,
    definitions: OnceLock<FxHashMap<u32, u32>>,
    bounds: OnceLock<Vec<NodeBounds>>,
    /// The records that say the same as a scene in another notation; `None` for a scene in records.
    foreign: Option<Foreign>,
    /// The result of [`glaring`](Self::glaring), kept once the records are forgotten.
    glaring: Option<u32>,
}

/// The records that stand for a file in another notation.
#[derive(Debug)]
struct Foreign {
    records: Box<Analysis>,
    origin: Box<dyn Origin>,
}

/// The way from records back to the file that they were made from.
pub trait Origin: fmt::Debug + Send + Sync {
    /// The place in the file of a span of the records, and the name of that place there, if it has one.
    fn place(&self, file: &SourceFile, records: &SourceFile, span: Span) -> (Span, Option<String>);

    /// Like [`place`](Self::place), but quicker: the part of the file that a span of the records was made from.
    fn part(&self, file: &SourceFile, records: &SourceFile, span: Span) -> Span;

    /// The name in the file of the element whose records have an ID that the file itself does not have.
    fn name(&self, id: u32) -> Option<String>;
}

impl Foreign {
    /// The findings about the records, turned into findings about the file. Findings about the notation of the records
    /// are left out.
    fn findings(&self, file: &SourceFile, settings: &Settings) -> Vec<Diagnostic> {
        let records = &self.records.source;
        let mut all = self.records.find(self.records.read.clone(), settings);
        all.retain(|d| !d.code.is_about_notation());
        for d in &mut all {
            (d.span, d.at) = self.origin.place(file, records, d.span);
            for label in &mut d.labels {
                label.span = self.origin.place(file, records, label.span).0;
            }
            d.fixes.clear();
            for (name, value) in &mut d.values {
                if let (true, Value::Text(text)) = (is_id(name), &*value)
                    && let Some(name) = text.parse().ok().and_then(|id| self.origin.name(id))
                {
                    *value = name.into();
                }
            }
        }
        diagnostics::sort(&mut all);
        all
    }
}

/// Whether the place of a message with this name is filled by an ID.
fn is_id(place: &str) -> bool {
    matches!(place, "id" | "other" | "source") || place.ends_with("-id")
}

/// The levels of findings that `zpg.toml` sets, and the codes that one run asks for.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// The levels of the settings.
    pub levels: Levels,
    /// The codes that this run is to report.
    pub choice: Choice,
}

#[warn(missing_docs)]
impl Analysis {
    /// Reads a scene from the bytes of its file; never fails. `path` is the name of the file in messages.
    pub fn new(path: impl Into<String>, bytes: Vec<u8>) -> Analysis {
        match recognise::read(path, bytes) {
            Ok(source) => Analysis::of(source),
            Err(stranger) => Analysis::not_a_scene(*stranger),
        }
    }

    /// A scene in another notation, with the records that were made from it.
    pub fn from_json(source: SourceFile, records: Analysis, origin: Box<dyn Origin>) -> Analysis {
        let mut scene = records.scene.clone();
        scene.move_spans(|span| origin.part(&source, &records.source, span));
        Analysis {
            scene,
            foreign: Some(Foreign {
                records: Box::new(records),
                origin,
            }),
            ..Analysis::empty(source)
        }
    }

    /// A scene in another notation that cannot be read.
    pub fn unreadable(source: SourceFile, finding: Diagnostic) -> Analysis {
        Analysis::empty(source).with_read(vec![finding])
    }

    /// A scene without records and without findings.
    fn empty(source: SourceFile) -> Analysis {
        Analysis {
            source,
            document: Document::default(),
            scene: Scene::default(),
            is_scene: true,
            read: Vec::new(),
            errors: Vec::new(),
            settings: Settings::default(),
            findings: OnceLock::new(),
            definitions: OnceLock::new(),
            bounds: OnceLock::new(),
            foreign: None,
            glaring: None,
        }
    }

    /// The analysis with the findings of reading.
    fn with_read(self, read: Vec<Diagnostic>) -> Analysis {
        let errors = read.iter().filter(|d| d.is_error());
        Analysis {
            errors: errors.map(|d| (d.code, d.span)).collect(),
            read,
            ..self
        }
    }

    /// A file that is no scene.
    pub fn not_a_scene(stranger: NotAScene) -> Analysis {
        let NotAScene { source, finding } = stranger;
        let document = Document {
            tokens: lexer::lex(&source.text, &[]),
            ..Document::default()
        };
        Analysis {
            document,
            is_scene: false,
            ..Analysis::empty(source).with_read(vec![finding])
        }
    }

    /// Reads a scene from its text.
    pub fn of(source: SourceFile) -> Analysis {
        let analysis = Analysis::read(source, true);
        match in_records::by_records(&analysis.source.text, &analysis.document) {
            None => analysis,
            Some(finding) => Analysis::not_a_scene(NotAScene {
                source: analysis.source,
                finding,
            }),
        }
    }

    /// Reads a text that is only tried: its findings are counted, and not all proposals are made.
    fn trial(source: SourceFile) -> Analysis {
        Analysis::read(source, false)
    }

    /// Reads a scene from its text. `compares` says whether all proposals are made; see [`scene::resolve_with`].
    fn read(source: SourceFile, compares: bool) -> Analysis {
        let (document, mut read) = syntax::parse(&source.text);
        commas::join(&source, &mut read);
        colours::join(&document, &source, &mut read);
        let scene = scene::resolve_with(&document, &source, &mut read, compares);
        if compares {
            moving::propose(&source, &document, &mut read);
            pictures::propose(&source, &mut read);
        }
        read.extend(encoding_note(&source));
        Analysis {
            document,
            scene,
            ..Analysis::empty(source).with_read(read)
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

    /// Forgets the text's records, which take more memory than the scene. Afterwards nothing can be found in the
    /// records.
    pub fn forget_records(&mut self) {
        self.glaring = self.glaring();
        self.document = Document::default();
        self.foreign = None;
    }

    /// Whether the file is a scene in records. A scene in another notation can only be read.
    pub fn is_records(&self) -> bool {
        self.is_scene && self.foreign.is_none()
    }

    /// Whether the file is a scene.
    pub fn is_scene(&self) -> bool {
        self.is_scene
    }

    /// Whether the scene has no errors by itself, whatever severity the settings give to findings. The rules are not
    /// run, as they never find errors.
    pub fn is_sound(&self) -> bool {
        self.errors.is_empty()
            && (self.foreign.as_ref()).is_none_or(|foreign| foreign.records.is_sound())
    }

    /// All findings about the scene, with the settings applied, sorted by place. The rules are run when this is first
    /// called.
    pub fn findings(&self) -> &[Diagnostic] {
        self.findings
            .get_or_init(|| self.find(self.read.clone(), &self.settings))
    }

    /// The findings, if somebody has asked for them already.
    pub fn known_findings(&self) -> Option<&[Diagnostic]> {
        self.findings.get().map(Vec::as_slice)
    }

    /// The record that defines an ID. If none does, the record that declares it (type 0) or the first that changes it.
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

    /// The number of objects that are not part of what is drawn, according to the findings. The other findings are not
    /// looked for.
    pub fn undrawn(&self) -> usize {
        if let Some(foreign) = &self.foreign {
            return foreign.records.undrawn();
        }
        let Settings { levels, choice } = &self.settings;
        if !self.is_scene || !levels.is_on(choice, Code::W310) {
            return 0;
        }
        lint::undrawn(&self.context())
    }

    /// The ID of the first record that gives out more light than it gets, according to the findings. The other findings
    /// are not looked for.
    pub fn glaring(&self) -> Option<u32> {
        if let Some(foreign) = &self.foreign {
            return foreign.records.glaring();
        }
        let Settings { levels, choice } = &self.settings;
        match self.is_scene {
            true => {
                lint::glaring(&self.context(), |code| levels.is_on(choice, code)).or(self.glaring)
            }
            false => None,
        }
    }

    /// The texts that are read as two numbers each, but may be one number with a decimal comma.
    pub fn commas_in_doubt(&self) -> Vec<Span> {
        let Settings { levels, choice } = &self.settings;
        let has_any = self.is_records() && self.document.contents.separators;
        match has_any && levels.is_on(choice, Code::S501) {
            true => syntax::commas::in_doubt(&self.source.text, &self.document),
            false => Vec::new(),
        }
    }

    /// Moves the findings out of the analysis without a copy. Afterwards [`findings`](Self::findings) is empty, and new
    /// settings do not bring back the findings of reading.
    pub fn take_findings(&mut self) -> Vec<Diagnostic> {
        let known = self.findings.take();
        self.findings = Vec::new().into();
        let read = std::mem::take(&mut self.read);
        known.unwrap_or_else(|| self.find(read, &self.settings))
    }

    /// The context that rules look at.
    fn context(&self) -> lint::Context<'_> {
        lint::Context::new(&self.source.text, &self.document, &self.scene, &self.bounds)
            .within(self.source.folder())
    }

    fn find(&self, read: Vec<Diagnostic>, settings: &Settings) -> Vec<Diagnostic> {
        if let Some(foreign) = &self.foreign {
            return foreign.findings(&self.source, settings);
        }
        let Settings { levels, choice } = settings;
        let mut all = read;
        if self.is_scene {
            lint::run(&self.context(), |code| levels.is_on(choice, code), &mut all);
            diagnostics::sort(&mut all);
            lone_signs::retell(&self.source, &self.document, &mut all);
        }
        levels.apply(choice, &mut all);
        all
    }
}

/// The note on a file that is not UTF-8. For Windows-1250, the note is at the first byte that shows that encoding.
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
