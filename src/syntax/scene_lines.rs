//! Lines that begin as only those of scenes do: with an ID and a type that no table of numbers has there, or with an ID
//! and the name of a type in English or Czech.

use rustc_hash::FxHashMap;

use super::lexer::{Token, TokenKind};
use super::recovery::LEAST_HEAD as LEAST_OF_SCENES;
use super::table::{RECORD_TYPES, RecordKind, RecordType};
use super::words;

/// Counts of the lines of a text by what they begin with.
#[derive(Debug, Default)]
pub(super) struct SceneLines {
    /// The lines that are not blank and not comments.
    all: usize,
    /// Lines with the type of a render record, an operation, a property, a light or a camera, behind an ID or without
    /// one.
    pub typed: usize,
    /// Whether a render record with ID 1 is among the `typed` lines.
    pub is_drawn: bool,
    /// Lines that would be `typed` but for a lost minus or one wrong digit of the type.
    slipped: usize,
    /// Lines with an ID, the name of a type, and numbers.
    pub worded: usize,
    /// How many numbers are on lines with an ID and a type. The type may lack its minus, have a dash for it, or be a
    /// name.
    numbers: usize,
}

impl SceneLines {
    pub(super) fn of(text: &str, tokens: &[Token]) -> SceneLines {
        let mut names = Names::default();
        let mut lines = SceneLines::default();
        for line in tokens.split(|t| t.kind() == TokenKind::Newline) {
            let line = line.iter().filter(|t| !t.kind().is_trivia());
            lines.add(text, line, &mut names);
        }
        lines
    }

    fn add<'a, 't>(
        &mut self,
        text: &'a str,
        line: impl Iterator<Item = &'t Token> + Clone,
        names: &mut Names<'a>,
    ) {
        let count = line.clone().count();
        self.all += usize::from(count > 0);
        let mut has_type = names.begins(text, line.clone());
        self.worded += usize::from(has_type);
        for (i, token) in line.clone().take(2).enumerate() {
            let word = token.text(text);
            let dashed = word.strip_prefix(['−', '–', '-']);
            let Ok(code) = dashed.unwrap_or(word).parse::<u32>().map(i64::from) else {
                continue;
            };
            let (plain, signed) = (RecordType::by_code(code), RecordType::by_code(-code));
            has_type |= i == 1 && (plain.is_some() || signed.is_some());
            if i == 1 && plain.is_none() && signed.is_none() {
                let code = if dashed.is_some() { -code } else { code };
                let is_first = line.clone().next().is_some_and(|t| t.text(text) == "1");
                let is_near = is_nearly_a_type(code, count - 2, is_first);
                has_type |= is_near;
                self.slipped += usize::from(is_near);
                continue;
            }
            let is_drawn = plain.is_some_and(|ty| ty.kind == RecordKind::Render);
            let is_typed = match signed.filter(|ty| ty.code <= LEAST_OF_SCENES) {
                Some(_) if dashed.is_some() => true,
                Some(ty) => {
                    self.slipped += usize::from(i + 1 + ty.params.len() == count);
                    false
                }
                None => is_drawn && dashed.is_none() && count > 2,
            };
            self.typed += usize::from(is_typed);
            let is_render = is_typed && is_drawn && i == 1 && count > 3;
            self.is_drawn |= is_render && line.clone().next().is_some_and(|t| t.text(text) == "1");
        }
        if has_type {
            self.numbers += line.filter(|t| t.kind().is_numeric()).count();
        }
    }

    /// How many numbers are on lines with the head of a record; `None` if no line begins as only those of scenes do.
    /// Types without their minus or with a wrong digit count as a beginning if one line in five has one, and so do
    /// names of types.
    pub(super) fn headed(&self) -> Option<usize> {
        let are_many = |n: usize| n > 1 && 5 * n >= self.all;
        let are_of_scene = self.typed > 0 || are_many(self.slipped) || are_many(self.worded);
        are_of_scene.then_some(self.numbers)
    }
}

/// Whether `code` is the type of a record with `params` parameters, but for one digit. `is_first` says whether the ID
/// is 1, which only the render record has. Hardly any table has numbers like these.
fn is_nearly_a_type(code: i64, params: usize, is_first: bool) -> bool {
    let is_of_scenes = |ty: &&RecordType| match ty.kind {
        RecordKind::Render => is_first,
        _ => ty.code <= LEAST_OF_SCENES && !is_first,
    };
    let written = code.to_string();
    let fitting = RECORD_TYPES.iter().filter(|ty| ty.params.len() == params);
    code.abs() >= i64::from(-LEAST_OF_SCENES)
        && (fitting.filter(is_of_scenes))
            .any(|ty| strsim::osa_distance(&ty.code.to_string(), &written) == 1)
}

/// Remembers which words are names of types. A text may have millions of different words, and only some are looked up.
#[derive(Default)]
struct Names<'a> {
    known: FxHashMap<&'a str, bool>,
}

/// The most different words that are looked up.
const LOOKED_UP: usize = 1000;

impl<'a> Names<'a> {
    /// Whether a line is an ID, the name of a type, and numbers.
    fn begins<'t>(&mut self, text: &'a str, mut line: impl Iterator<Item = &'t Token>) -> bool {
        let (Some(id), Some(first)) = (line.next(), line.next()) else {
            return false;
        };
        // A line with a comma or a point between the two is one of a table or a list.
        let is_apart = text[id.end() as usize..first.start as usize]
            .trim()
            .is_empty();
        let is_id = id.integer(text).is_some_and(|id| id > 0);
        if !(is_id && is_apart && first.kind() == TokenKind::Word) {
            return false;
        }
        let mut name = first.span();
        let mut numbers = 0;
        for token in line {
            match token.kind() {
                TokenKind::Word if numbers == 0 => name = name.to(token.span()),
                kind if kind.is_numeric() => numbers += 1,
                _ => return false,
            }
        }
        numbers > 0 && self.is_type(&text[name.range()])
    }

    fn is_type(&mut self, name: &'a str) -> bool {
        if let Some(&known) = self.known.get(name) {
            return known;
        }
        if self.known.len() == LOOKED_UP {
            return false;
        }
        let is_type = !words::types(name).is_empty();
        self.known.insert(name, is_type);
        is_type
    }
}
