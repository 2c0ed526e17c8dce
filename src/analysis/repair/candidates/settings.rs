//! Settings of POV-Ray for the whole of a scene: `background { color rgb <0.2, 0.3, 0.5> }`,
//! `global_settings { ambient_light 0.2 }`.

use super::clauses::{is_word, numbers};
use super::inline::BLOCK_TITLE;
use super::properties::OWN;
use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::whole::records;
use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::syntax::lexer::Token;
use crate::syntax::table::{RecordKind, RecordType};
use crate::syntax::words;

/// Names of the background, without accents.
const BACKGROUND: [&str; 2] = ["background", "pozadi"];
/// The word that POV-Ray has before a block of settings.
const SETTINGS: &str = "global_settings";
/// The word of POV-Ray for an ambient light.
const AMBIENT: &str = "ambient_light";

impl LineContext<'_> {
    /// Guesses at the records of a background or an ambient light that has no ID.
    pub(super) fn setting(&self, used: &[u32]) -> Option<Candidate> {
        let (first, behind) = self.tokens.split_first().filter(|(t, _)| is_word(t))?;
        let is_whole = self.tokens.last()?.end() <= self.line.end;
        let span = Span::new(first.start, self.last_part()?);
        if !is_whole || self.text[span.range()].contains('#') {
            return None;
        }
        let word = first.text(self.text).to_lowercase();
        if BACKGROUND.contains(&&*words::plain(&word)) {
            self.background(span, behind, used)
        } else if word == SETTINGS {
            self.ambient(span, behind, used)
        } else if word == AMBIENT {
            self.ambient(span, &self.tokens, used)
        } else {
            None
        }
    }

    /// The candidate that writes a background as a colour, and the ID of the colour into the render record.
    fn background(&self, span: Span, behind: &[Token], used: &[u32]) -> Option<Candidate> {
        let numbers = self.whole_colour(behind)?;
        let id = self.free_id(used)?;
        let document = &self.analysis.document;
        let render = records(self.analysis).find(|r| r.kind == RecordKind::Render)?;
        let place = *document.params(render).nth(1)?;
        // If the render record names a background already, that one may be meant.
        let is_black = place.integer(self.text) == Some(0);
        let code = RecordType::of(RecordKind::Colour).code;
        let edit = |span: Span, text: String| Edit { span, text };
        let (word, behind) = self.behind_word(span);
        let edits = vec![
            edit(word, format!("{id} {code}")),
            edit(behind, format!(" {numbers}")),
            edit(place.span(), id.to_string()),
        ];
        Some(setting(edits, is_black))
    }

    /// The numbers of the colour that all of some tokens are: a grey, three numbers or a name.
    fn whole_colour(&self, tokens: &[Token]) -> Option<String> {
        let count = tokens.iter().take_while(|t| self.is_colour_word(t)).count();
        let parts = &tokens[count..];
        match parts {
            [grey] if grey.kind().is_number() => Some(self.texts(&[*grey; OWN])),
            [_, _, _] if numbers(parts) == OWN => Some(self.texts(parts)),
            _ => self.colour_name(parts),
        }
    }

    fn is_colour_word(&self, t: &Token) -> bool {
        let mut named = words::types(t.text(self.text)).into_iter();
        is_word(t) && named.any(|ty| ty.kind == RecordKind::Colour)
    }

    /// The candidate that writes an ambient light. Other settings beside it become a comment.
    fn ambient(&self, span: Span, behind: &[Token], used: &[u32]) -> Option<Candidate> {
        let at = behind.iter().position(|t| t.text(self.text) == AMBIENT)?;
        let (before, behind) = (&behind[..at], &behind[at + 1..]);
        let words = behind.iter().take_while(|t| self.is_colour_word(t)).count();
        let (own, rest) = behind[words..].split_at(numbers(&behind[words..]));
        let id = self.free_id(used)?;
        let [light, colour] = [RecordKind::AmbientLight, RecordKind::Colour];
        let light = RecordType::of(light).code;
        let is_grey = |t: &Token| t.number(self.text) == own[0].number(self.text);
        let mut text = match own {
            [one] => format!(" {}", one.text(self.text)),
            [one, _, _] if own.iter().all(is_grey) => format!(" {}", one.text(self.text)),
            [_, _, _] => {
                let colour = RecordType::of(colour).code;
                format!(" 1\n{id} {colour} {}", self.texts(own))
            }
            _ => return None,
        };
        let others = [before, rest].concat();
        if !others.is_empty() {
            text += &format!(" # {} #", self.texts(&others));
        }
        let (word, behind) = self.behind_word(span);
        let edit = |span: Span, text: String| Edit { span, text };
        let edits = vec![edit(word, format!("{id} {light}")), edit(behind, text)];
        Some(setting(edits, true))
    }

    /// The span of the first word of the line, and the span behind that word to the end of `whole`.
    fn behind_word(&self, whole: Span) -> (Span, Span) {
        let word = self.tokens[0].span();
        (word, Span::new(word.end, whole.end.max(word.end)))
    }
}

fn setting(edits: Vec<Edit>, is_sure: bool) -> Candidate {
    let applicability = match is_sure {
        true => Applicability::Unsafe,
        false => Applicability::Choice,
    };
    let fix = Fix {
        title: BLOCK_TITLE,
        values: Vec::new(),
        applicability,
        edits,
    };
    Candidate::new(Habit::Keyword, fix)
}
