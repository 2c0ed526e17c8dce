//! Properties and moves of an object one behind the other, as POV-Ray has them:
//! `pigment { color Red } finish { reflection 0.3 }`, `translate <0, 1, 0> rotate y*45`.

use super::axes::{about_axis, along_axis};
use super::clauses::{Line, is_word, numbers};
use super::numbers::PICTURE;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span};
use crate::lint::spelling::decimal;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, RecordKind, RecordType};
use crate::syntax::words;

/// How many numbers a colour, a move and a scaling have, and how many axes a turn has.
pub(super) const OWN: usize = 3;

/// Words of POV-Ray for surfaces and insides; for some of their values there are records.
const OTHERS: [&str; 4] = ["finish", "normal", "interior", "no_shadow"];

/// Colours of POV-Ray with transmitted parts, and which parts each has: filtered by the colour, and unfiltered.
const CLEAR: [(&str, [bool; 2]); 3] = [
    ("rgbf", [true, false]),
    ("rgbt", [false, true]),
    ("rgbft", [true, true]),
];

/// Words behind a colour for its transmitted parts: filtered, and unfiltered.
const PARTS: [&str; 2] = ["filter", "transmit"];

/// Words that other programs put around the properties of a surface.
const AROUND: [&str; 2] = ["texture", "material"];

/// Properties and moves of an object.
#[derive(Default)]
pub(super) struct Properties {
    /// Records: their types and numbers.
    pub lines: Vec<Line>,
    /// Texts of properties for which there is no record.
    left: Vec<String>,
    /// The transmitted parts of light: filtered by the colour of the surface, and unfiltered.
    clear: [f64; 2],
}

impl Properties {
    /// Whether there are properties for which there is no record.
    pub(super) fn leaves_out(&self) -> bool {
        !self.left.is_empty()
    }

    /// The properties for which there is no record, as a comment behind one; empty if there are none.
    pub(super) fn comment(&self) -> String {
        match self.leaves_out() {
            true => format!(" # {} #", self.left.join(" ")),
            false => String::new(),
        }
    }
}

impl Properties {
    /// Adds the optics of a surface with transmitted parts. They are shares of the light that is not mirrored; the rest
    /// of that light is diffuse. `None` if a part is no share of 1, or if there is no colour.
    fn let_through(&mut self) -> Option<()> {
        let [filtered, plain] = self.clear;
        let all = filtered + plain;
        if all == 0.0 {
            return Some(());
        }
        let of_kind = |kind: RecordKind| {
            let line = self.lines.iter().find(|line| line.0.kind == kind)?;
            let numbers: Option<Vec<f64>> = line.1.split(' ').map(|n| n.parse().ok()).collect();
            numbers?.try_into().ok()
        };
        let colour: [f64; OWN] = of_kind(RecordKind::Colour)?;
        let [kd, ks, _] = of_kind(RecordKind::Optics).unwrap_or([1.0, 0.0, 0.0]);
        let is_share = |x: f64| (0.0..=1.0).contains(&x);
        if ![filtered, plain, all, ks].into_iter().all(is_share) {
            return None;
        }
        self.lines.retain(|line| line.0.kind != RecordKind::Optics);
        let channel = |c: f64| {
            let kt = (1.0 - ks) * (plain + filtered * c);
            [kd * (1.0 - all), ks, kt].map(decimal).join(" ")
        };
        let is_grey = filtered == 0.0 || colour == [colour[0]; OWN];
        self.lines.push(match is_grey {
            true => (RecordType::of(RecordKind::Optics), channel(colour[0])),
            false => (
                RecordType::of(RecordKind::OpticsRgb),
                colour.map(channel).join(" "),
            ),
        });
        Some(())
    }
}

impl LineContext<'_> {
    /// Whether a colour has a fourth number, which may be its alpha.
    pub(in crate::analysis::repair) fn has_alpha(&self) -> bool {
        let is_colour = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Colour);
        let [.., alpha] = self.params() else {
            return false;
        };
        let is_share = alpha
            .number(self.text)
            .is_some_and(|x| (0.0..=1.0).contains(&x));
        is_colour && self.params().len() == OWN + 1 && is_share
    }

    /// A guess at the colour without its alpha.
    pub(super) fn without_alpha(&self, finding: &Diagnostic) -> Option<Candidate> {
        let params = self.params();
        let is_one = finding.code == Code::E009 && self.has_alpha();
        let colour = self.spaced(params.get(..OWN).filter(|_| is_one)?)?;
        let span = params[0].span().to(params[OWN].span());
        Some(Candidate::writing(Habit::Doubled, span, colour))
    }

    /// Properties and moves behind an ID, the first by its name: `9 pigment { color rgb <1,0,0> }`,
    /// `8 interior { ior 1.5 }`.
    pub(super) fn only_properties(&self, id: u32) -> Option<Candidate> {
        let (word, behind) = self.tokens[1..].split_first()?;
        let name = word.text(self.text).to_lowercase();
        let named = words::types(&name);
        let is_colour = named.iter().any(|ty| ty.kind == RecordKind::Colour);
        let is_around = AROUND.contains(&&*name);
        let is_block = (is_colour || is_around) && behind.first().is_some_and(is_word);
        let found = self.properties(&self.tokens[1..])?;
        // A single record is found by its name elsewhere.
        let is_more = found.lines.len() > 1 || found.leaves_out();
        (is_more || is_block || OTHERS.contains(&&*name))
            .then(|| self.written_as(Habit::Keyword, id, &found))?
    }

    /// A record with properties or moves of its object behind its numbers: `2 -1 0 1 0 rotate <0, 45, 0>`.
    pub(super) fn changes_behind(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let (own, behind) = self.params().split_at_checked(ty.params.len())?;
        let is_whole = self.tokens.last()?.end() <= self.line.end;
        // Numbers behind those of a shape are rather its place or its colour.
        let is_named = behind.first().is_some_and(is_word);
        let may_be = self.named.is_none() && (is_named || ty.family != Family::Shape);
        let all_numbers = numbers(own) == own.len() && !own.is_empty();
        if !is_whole || !may_be || !all_numbers || behind.is_empty() {
            return None;
        }
        let mut found = self.properties(behind)?;
        found.lines.insert(0, (ty, self.texts(own)));
        (found.lines.len() > 1).then(|| self.written_as(Habit::Apart, self.id()?, &found))?
    }

    /// The candidate that writes records in the place of everything behind the ID.
    fn written_as(&self, habit: Habit, id: u32, found: &Properties) -> Option<Candidate> {
        let (first, rest) = found.lines.split_first()?;
        let mut text = format!("{} {}", first.0.code, first.1);
        for (ty, numbers) in rest {
            text += &format!("\n{id} {} {numbers}", ty.code);
        }
        text += &found.comment();
        let span = Span::new(self.tokens[1].start, self.last_part()?);
        // A comment between the numbers would be lost.
        let is_gone = self.text[span.range()].contains('#');
        let title = match (found.leaves_out(), rest.is_empty()) {
            (true, _) => "fix-properties-some",
            (false, true) => "fix-write",
            (false, false) => "fix-properties",
        };
        let fix = Fix::replace(title, Applicability::Unsafe, span, text.clone());
        let fix = fix.with("number", quote(&text));
        (!is_gone).then_some(Candidate::new(habit, fix))
    }

    /// The offset at which the last token or separator of the line ends.
    pub(super) fn last_part(&self) -> Option<u32> {
        let is_part = |t: &&Token| t.kind() == TokenKind::Separator || !t.kind().is_trivia();
        Some(self.all.iter().rfind(is_part)?.end())
    }

    /// Reads tokens as properties and moves. `None` if some are anything else.
    pub(super) fn properties(&self, mut rest: &[Token]) -> Option<Properties> {
        let mut found = Properties::default();
        let mut is_colour = false;
        while let Some(first) = rest.first() {
            let word = first.text(self.text).to_lowercase();
            let named = words::types(&word);
            let is = |kind: RecordKind| named.iter().find(|ty| ty.kind == kind).copied();
            let colour = RecordType::of(RecordKind::Colour);
            if let Some((ty, own)) = self.coded(rest).filter(|_| !is_colour) {
                found.lines.push((ty, self.texts(own)));
                rest = &rest[1 + own.len()..];
            } else if !is_word(first) {
                // Three numbers are a colour if they stand behind a word for colours.
                let parts = rest.get(..OWN).filter(|parts| numbers(parts) == OWN)?;
                found.lines.push((colour, self.texts(parts)));
                rest = &rest[OWN..];
                if !std::mem::take(&mut is_colour) {
                    return None;
                }
            } else if let Some((_, parts)) = CLEAR.iter().find(|c| c.0 == word) {
                let (own, behind) = rest[1..].split_at_checked(OWN)?;
                if numbers(own) < OWN {
                    return None;
                }
                found.lines.push((colour, self.texts(own)));
                is_colour = false;
                rest = self.clear(*parts, behind, &mut found)?;
            } else if PARTS.contains(&&*word) {
                found
                    .lines
                    .iter()
                    .find(|l| l.0.kind == RecordKind::Colour)?;
                let parts = PARTS.map(|part| part == word);
                rest = self.clear(parts, &rest[1..], &mut found)?;
            } else if let Some(count) = self.picture(rest) {
                let name = self.picture_name(&rest[..count])?;
                let image = RecordType::of(RecordKind::ImageTexture);
                found.lines.push((image, name));
                rest = &rest[count..];
                is_colour = false;
            } else if OTHERS.contains(&&*word) {
                rest = self.other(&word, rest, &mut found)?;
            } else if let Some((of, numbers)) = self.named_colour(rest) {
                found.lines.push((colour, numbers));
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
                let count = numbers(&rest[1..]).clamp(1, OWN);
                let (own, behind) = rest[1..].split_at_checked(count)?;
                let moves = self.moves(ty, own)?;
                found.lines.extend(moves.into_iter().map(|text| (ty, text)));
                rest = behind;
            }
        }
        found.let_through()?;
        (!is_colour).then_some(found)
    }

    /// Reads the transmitted parts of a colour, and returns the tokens behind them.
    fn clear<'t>(
        &self,
        parts: [bool; 2],
        mut rest: &'t [Token],
        found: &mut Properties,
    ) -> Option<&'t [Token]> {
        for (i, _) in parts.iter().enumerate().filter(|part| *part.1) {
            let (first, behind) = rest.split_first()?;
            found.clear[i] = first.number(self.text)?;
            rest = behind;
        }
        Some(rest)
    }

    /// How many tokens the name of a picture takes, with the words that POV-Ray has before it.
    fn picture(&self, tokens: &[Token]) -> Option<usize> {
        let first = tokens.first()?.text(self.text).to_lowercase();
        let is_end = |t: &Token| self.ends_picture(t);
        let is_one = first != "pigment" && PICTURE.contains(&&*first);
        tokens
            .iter()
            .position(is_end)
            .filter(|_| is_one)
            .map(|i| i + 1)
    }

    /// Reads a change that begins with its type: the type, and the tokens of its parameters.
    fn coded<'t>(&self, tokens: &'t [Token]) -> Option<(&'static RecordType, &'t [Token])> {
        let code = tokens.first()?.integer(self.text)?;
        let ty = RecordType::by_code(code).filter(|ty| ty.code < 0 && !ty.is_counted())?;
        let own = tokens.get(1..=ty.params.len())?;
        let changes = matches!(ty.effect, Effect::Changes(_) | Effect::DefinesOrChanges(..));
        (changes && numbers(own) == own.len()).then_some((ty, own))
    }

    /// Reads one of the words in [`OTHERS`] with its values, and returns the tokens behind them. Values for which there
    /// is no record are kept for the comment.
    fn other<'t>(
        &self,
        word: &str,
        tokens: &'t [Token],
        found: &mut Properties,
    ) -> Option<&'t [Token]> {
        let first = tokens[0];
        if word == "no_shadow" {
            found.left.push(word.to_owned());
            return Some(&tokens[1..]);
        }
        let end = self.end_of_block(first.end());
        let count = match end {
            Some(end) => tokens.partition_point(|t| t.start < end),
            // Without braces: `interior ior 1.5`.
            None => 3,
        };
        let body = tokens.get(1..count)?;
        let mut parts: Vec<(&str, &[Token])> = Vec::new();
        let mut rest = body;
        while let Some((name, behind)) = rest.split_first() {
            let (own, behind) = behind.split_at(numbers(behind));
            parts.push((name.text(self.text), own));
            rest = behind;
        }
        let number = |name: &str| {
            let own = parts.iter().find(|p| p.0 == name).map(|p| p.1)?;
            own.first().filter(|_| own.len() == 1)
        };
        let known: &[&str] = match word {
            "interior" => &["ior"],
            "finish" => &["diffuse", "reflection"],
            _ => &[],
        };
        let before = found.lines.len();
        if let Some(ior) = number("ior").filter(|_| word == "interior") {
            let index = RecordType::of(RecordKind::RefractiveIndex);
            found.lines.push((index, self.texts(&[*ior; OWN])));
        }
        let [diffuse, mirrored] = known
            .get(..2)
            .map_or([None; 2], |_| ["diffuse", "reflection"].map(number));
        if diffuse.is_some() || mirrored.is_some() {
            let text = |t: &Token| t.text(self.text).to_owned();
            let mirror = mirrored.and_then(|t| t.number(self.text)).unwrap_or(0.0);
            let kd = diffuse.map_or_else(|| decimal((1.0 - mirror).max(0.0)), text);
            let ks = mirrored.map_or_else(|| "0".to_owned(), text);
            let optics = RecordType::of(RecordKind::Optics);
            found.lines.push((optics, format!("{kd} {ks} 0")));
        }
        let is_left = |p: &&(&str, &[Token])| !known.contains(&p.0) || p.1.len() != 1;
        let left = parts.iter().filter(is_left).map(|&(name, own)| match own {
            [] => name.to_owned(),
            own => format!("{name} {}", self.texts(own)),
        });
        let left: Vec<String> = left.collect();
        // If there is no record for any value, the text is kept as it stands.
        if end.is_none() && !left.is_empty() {
            return None;
        } else if found.lines.len() == before {
            let whole = &self.text[first.start as usize..end? as usize];
            found.left.push(whole.to_owned());
        } else if !left.is_empty() {
            found.left.push(format!("{word} {{ {} }}", left.join(" ")));
        }
        Some(&tokens[count..])
    }

    /// The offset behind the block in braces that begins at `at`. `None` if there is none, or if it does not end on the
    /// line.
    fn end_of_block(&self, at: u32) -> Option<u32> {
        let rest = self.text.get(at as usize..self.line.end as usize)?;
        let mut depth = 0;
        for (i, c) in rest.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                c if depth == 0 && !c.is_whitespace() => return None,
                _ => {}
            }
            if c == '}' && depth <= 0 {
                return (depth == 0).then_some(at + i as u32 + 1);
            }
        }
        None
    }

    /// The numbers of each record that a move, a scaling, or turns about x, y and z need.
    fn moves(&self, ty: &RecordType, own: &[Token]) -> Option<Vec<String>> {
        match (ty.kind, own) {
            (RecordKind::Rotation, [one]) => Some(vec![about_axis(one.text(self.text))?]),
            (RecordKind::Translation, [one]) => Some(vec![along_axis(one.text(self.text))?]),
            (RecordKind::Scaling, [one]) if one.kind().is_number() => {
                Some(vec![self.texts(&[*one; OWN])])
            }
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

    pub(super) fn texts(&self, tokens: &[Token]) -> String {
        let texts: Vec<&str> = tokens.iter().map(|t| t.text(self.text)).collect();
        texts.join(" ")
    }
}
