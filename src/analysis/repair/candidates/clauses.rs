//! A shape with its properties in one line, as POV-Ray has them: `sphere { <0,1,0>, 1 pigment { color Red } }`.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Family, RecordKind, RecordType};
use crate::syntax::words;

/// A colour, a move and a scaling have so many numbers, and so many axes has a turn.
const OWN: usize = 3;

/// What POV-Ray says of surfaces and insides in ways that records have no numbers for.
const OTHERS: [&str; 4] = ["finish", "normal", "interior", "no_shadow"];

/// What other programs put around the properties of a surface.
const AROUND: [&str; 2] = ["texture", "material"];

impl LineContext<'_> {
    /// The shape as a record, and each of its properties and moves. Without an ID it gets the only one that is undefined,
    /// or a free one.
    pub(super) fn clauses(&self, used: &[u32]) -> Option<Candidate> {
        let written = self.id().filter(|_| self.tokens[0].kind().is_number());
        let at = usize::from(written.is_some());
        let word = *self.tokens.get(at).filter(|t| is_word(t))?;
        let behind = &self.tokens[at + 1..];
        let (own, rest) = behind.split_at(numbers(behind));
        let named = words::types(word.text(self.text)).into_iter();
        let mut shapes = named.filter(|ty| ty.family == Family::Shape && self.fit(ty, own));
        let shape = shapes.next().filter(|_| !own.is_empty())?;
        let is_other = |t: &Token| OTHERS.contains(&&*t.text(self.text).to_lowercase());
        let leaves_out = rest.iter().any(is_other);
        let (id, is_known) = match (written, &self.missing()[..]) {
            (Some(id), _) | (None, &[id]) => (id, true),
            (None, _) => (self.free_id(used)?, false),
        };
        let mut text = format!(" {}", self.texts(own));
        for (ty, numbers) in self.properties(rest)? {
            text += &format!("\n{id} {} {numbers}", ty.code);
        }
        let is_part = |t: &&Token| t.kind() == TokenKind::Separator || !t.kind().is_trivia();
        let last = self.all.iter().rfind(is_part)?.end();
        let span = Span::new(word.end(), last.max(word.end()));
        // A comment between the numbers would be lost.
        let is_gone = self.text[span.range()].contains('#');
        let code = match written {
            Some(_) => shape.code.to_string(),
            None => format!("{id} {}", shape.code),
        };
        let edit = |span: Span, text: String| Edit { span, text };
        let fix = Fix {
            title: match leaves_out {
                true => "fix-clauses-some",
                false => "fix-clauses",
            },
            values: Vec::new(),
            applicability: match is_known && !leaves_out {
                true => Applicability::Unsafe,
                false => Applicability::Choice,
            },
            edits: vec![edit(word.span(), code), edit(span, text)],
        };
        (!rest.is_empty() && !is_gone).then_some(Candidate {
            habit: Habit::Keyword,
            fix,
            ty: None,
        })
    }

    /// The types and numbers of properties and moves, if the tokens are nothing else.
    fn properties(&self, mut rest: &[Token]) -> Option<Vec<(&'static RecordType, String)>> {
        let mut all = Vec::new();
        let mut is_colour = false;
        while let Some(first) = rest.first() {
            let word = first.text(self.text).to_lowercase();
            let named = words::types(&word);
            let is = |kind: RecordKind| named.iter().find(|ty| ty.kind == kind).copied();
            let colour = RecordType::of(RecordKind::Colour);
            if !is_word(first) {
                // Behind a word for colours.
                let parts = rest.get(..OWN).filter(|parts| numbers(parts) == OWN)?;
                all.push((colour, self.texts(parts)));
                rest = &rest[OWN..];
                if !std::mem::take(&mut is_colour) {
                    return None;
                }
            } else if OTHERS.contains(&&*word) {
                let end = self.end_of_block(first.end());
                rest = &rest[rest.partition_point(|t| t.start < end)..];
            } else if let Some((of, numbers)) = self.named_colour(rest) {
                all.push((colour, numbers));
                rest = &rest[of..];
                is_colour = false;
            } else if is(RecordKind::Colour).is_some() || AROUND.contains(&&*word) {
                is_colour |= is(RecordKind::Colour).is_some();
                rest = &rest[1..];
            } else {
                let kinds = [
                    RecordKind::Translation,
                    RecordKind::Scaling,
                    RecordKind::Rotation,
                ];
                let ty = kinds.into_iter().find_map(is)?;
                let (own, behind) = rest[1..].split_at(numbers(&rest[1..]));
                all.extend(self.moves(ty, own)?.into_iter().map(|text| (ty, text)));
                rest = behind;
            }
        }
        (!is_colour).then_some(all)
    }

    /// Where the block in braces ends that begins at a place on the line; the place itself where none begins there.
    fn end_of_block(&self, at: u32) -> u32 {
        let rest = &self.text[at as usize..self.line.end as usize];
        let mut depth = 0;
        for (i, c) in rest.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                c if depth == 0 && !c.is_whitespace() => return at,
                _ => {}
            }
            if depth <= 0 && c == '}' {
                return at + i as u32;
            }
        }
        at
    }

    /// The numbers of the records that a move, a scaling, or turns about x, y and z are.
    fn moves(&self, ty: &RecordType, own: &[Token]) -> Option<Vec<String>> {
        match (ty.kind, own) {
            (RecordKind::Scaling, [one]) => Some(vec![self.texts(&[*one; OWN])]),
            (RecordKind::Rotation, [_, _, _]) => {
                let turn = |(axis, t): (usize, &Token)| format!("{} {axis}", t.text(self.text));
                let is_turn = |(_, t): &(usize, &Token)| t.number(self.text) != Some(0.0);
                Some((1..).zip(own).filter(is_turn).map(turn).collect())
            }
            (RecordKind::Translation | RecordKind::Scaling, [_, _, _]) => {
                Some(vec![self.texts(own)])
            }
            _ => None,
        }
    }

    fn texts(&self, tokens: &[Token]) -> String {
        let texts: Vec<&str> = tokens.iter().map(|t| t.text(self.text)).collect();
        texts.join(" ")
    }
}

fn is_word(t: &Token) -> bool {
    t.kind() == TokenKind::Word
}

/// How many numbers some tokens begin with.
fn numbers(tokens: &[Token]) -> usize {
    tokens.iter().take_while(|t| t.kind().is_number()).count()
}
