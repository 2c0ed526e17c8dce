//! What may have been meant by a line that something is wrong with.

use rustc_hash::FxHashSet;

use super::characters;
use super::words;
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::Entity;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, Param, ParamKind, RecordKind, RecordType};

/// What people do, what they do most first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Habit {
    /// The minus of a type is lost, or there is one too many.
    Sign,
    /// A number has letters, signs or units in it.
    Characters,
    /// A word stands in the place of a type's number.
    Word,
    /// A comment has no signs around it.
    Comment,
    /// Numbers stand there twice.
    Doubled,
    /// It is the record of a sibling.
    Sibling,
    /// Two references stand in each other's place.
    Swapped,
    /// All references are off by the same number.
    Shifted,
    /// One reference names something else.
    Reference,
    /// What the finding itself proposes.
    Proposed,
    /// The record has another ID.
    Id,
    /// It is a record of another type.
    Type,
}

/// A text that may have been meant.
#[derive(Debug, Clone)]
pub struct Candidate {
    pub habit: Habit,
    pub fix: Fix,
    /// The type that the fix writes, if it writes one.
    pub ty: Option<&'static RecordType>,
}

/// No more are made for one finding.
const MOST: usize = 16;

/// Records that people take for each other, by the numbers they have; the first is written in place of the others.
const SIBLINGS: &[(i32, &[i32])] = &[
    (9, &[11, 10, 13]),
    (10, &[9, 11]),
    (11, &[9, 10]),
    (13, &[9]),
    (3, &[4]),
    (5, &[12]),
    (6, &[7, 8]),
    (7, &[6, 8]),
    (8, &[6, 7]),
    (1, &[2]),
    (2, &[1]),
    (12, &[5, 11]),
    (-1, &[-2]),
    (-2, &[-1, -4]),
    (-3, &[-1, -2]),
    (-4, &[-2]),
    (-101, &[-104, -105]),
    (-103, &[-104]),
    (-104, &[-103, -102, -101]),
    (-105, &[-101]),
    (-201, &[-202]),
    (-202, &[-201, -203]),
    (-203, &[-202]),
    (-502, &[-503]),
    (-503, &[-502]),
    (-601, &[-602]),
    (-602, &[-601]),
];

/// A line of the text, or all of a record that begins on it.
pub struct Place<'a> {
    analysis: &'a Analysis,
    text: &'a str,
    /// From the first token to the end of the line, white space left out.
    line: Span,
    /// The tokens of the line, trivia too.
    all: &'a [Token],
    /// The significant tokens of the record that begins the line, else of the line.
    tokens: Vec<Token>,
}

impl<'a> Place<'a> {
    /// Where a finding is: the line, and the record that begins it where that goes on behind its end.
    pub fn both(analysis: &'a Analysis, at: u32) -> Vec<Place<'a>> {
        let Some(line) = Place::of(analysis, at, false) else {
            return Vec::new();
        };
        let record = Place::of(analysis, at, true);
        let longer = record.filter(|r| r.tokens.len() > line.tokens.len());
        std::iter::once(line).chain(longer).collect()
    }

    fn of(analysis: &'a Analysis, at: u32, goes_on: bool) -> Option<Place<'a>> {
        let source = &analysis.source;
        let line = source.line_span(source.line_index(source.floor(at)));
        let document = &analysis.document;
        let first = document.tokens.partition_point(|t| t.start < line.start);
        let last = document.tokens.partition_point(|t| t.start < line.end);
        let all = &document.tokens[first..last];
        let all = match all {
            [rest @ .., last] if last.kind == TokenKind::Newline => rest,
            all => all,
        };
        let head = all.iter().position(|t| !t.kind.is_trivia())?;
        let begin = (first + head) as u32;
        let item = document.items.partition_point(|item| item.ends().0 < begin);
        let item = document
            .items
            .get(item)
            .filter(|item| item.ends().0 == begin);
        let on_line = || all.iter().filter(|t| !t.kind.is_trivia()).copied();
        let tokens: Vec<Token> = match item.map(|item| item.ends().1) {
            Some(end) if goes_on && end as usize >= last => {
                document.significant(begin, end).copied().collect()
            }
            _ => on_line().collect(),
        };
        let text = &source.text;
        let end = line.start + text[line.range()].trim_end().len() as u32;
        Some(Place {
            analysis,
            text,
            line: Span::new(all[head].start, end),
            all,
            tokens,
        })
    }

    pub fn line(&self) -> Span {
        self.line
    }

    fn int(&self, i: usize) -> Option<i64> {
        self.tokens.get(i)?.integer(self.text)
    }

    fn params(&self) -> &[Token] {
        self.tokens.get(2..).unwrap_or(&[])
    }

    fn id(&self) -> Option<u32> {
        u32::try_from(self.int(0)?).ok().filter(|&id| id > 0)
    }

    fn ty(&self) -> Option<&'static RecordType> {
        RecordType::by_code(self.int(1)?)
    }

    /// Whether a record of this type has as many parameters as stand here.
    fn fits(&self, ty: &RecordType) -> bool {
        self.fit(ty, self.params())
    }

    fn fit(&self, ty: &RecordType, params: &[Token]) -> bool {
        let n = params.len() as u64;
        let count = match ty.is_counted() {
            true => (params.first())
                .and_then(|t| t.integer(self.text))
                .and_then(|n| u64::try_from(n).ok()),
            false => Some(0),
        };
        count.is_some_and(|count| {
            let base = ty.arity(count);
            n == base || !ty.optional.is_empty() && n == base + ty.optional.len() as u64
        })
    }

    /// The names of the numbers that a record with too few has, and of those that it lacks, where that can be told:
    /// it ends between two vectors of its type.
    pub fn lacking(&self) -> Option<(String, String)> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let n = self.params().len();
        let mut ends = ty.vectors.iter().scan(0, |sum, n| {
            *sum += n;
            Some(*sum)
        });
        let between = ends.any(|end| end == n) && n < ty.params.len();
        between.then(|| {
            let names = |some: &[Param]| some.iter().map(|p| p.name).collect::<Vec<_>>().join(" ");
            (names(&ty.params[..n]), names(&ty.params[n..]))
        })
    }

    /// What may have been meant, given a finding of this place. `undefined` are the IDs that are used and
    /// defined nowhere.
    pub fn candidates(&self, finding: &Diagnostic, undefined: &[u32]) -> Vec<Candidate> {
        let mut out = Vec::new();
        if finding.is_error() {
            self.characters(&mut out);
            self.words(&mut out);
            self.comments(&mut out);
            self.signs(&mut out);
            self.doubled(&mut out);
            self.siblings(&mut out);
            self.types(finding, &mut out);
            self.references(finding, &mut out);
            self.ids(finding, undefined, &mut out);
        } else if finding.code == Code::W319 {
            self.swapped(&mut out);
        }
        let mut seen: FxHashSet<Vec<(Span, String)>> = FxHashSet::default();
        let edits = |c: &Candidate| -> Vec<(Span, String)> {
            (c.fix.edits.iter())
                .map(|e| (e.span, e.text.clone()))
                .collect()
        };
        out.retain(|c| seen.insert(edits(c)));
        out.truncate(MOST);
        out
    }

    fn write_type(&self, habit: Habit, ty: &'static RecordType) -> Candidate {
        let fix = Fix::replace(
            "fix-type",
            Applicability::Unsafe,
            self.tokens[1].span(),
            ty.code.to_string(),
        );
        Candidate {
            habit,
            fix: (fix.with("number", ty.code.to_string())).with("type", Value::Term(ty.title)),
            ty: Some(ty),
        }
    }

    /// Several tokens written anew; `None` if that changes nothing.
    fn write(&self, habit: Habit, new: &[(Token, String)]) -> Option<Candidate> {
        let edits: Vec<Edit> = (new.iter())
            .filter(|(t, text)| t.text(self.text) != text)
            .map(|(t, text)| Edit {
                span: t.span(),
                text: text.clone(),
            })
            .collect();
        let (first, last) = (edits.first()?.span, edits.last()?.span);
        // All that stands there, as it is to be.
        let mut shown = String::new();
        let mut at = first.start;
        for edit in &edits {
            shown += &self.text[at as usize..edit.span.start as usize];
            shown += &edit.text;
            at = edit.span.end;
        }
        debug_assert!(at == last.end);
        let fix = Fix {
            title: "fix-write",
            values: vec![("number", quote(&shown).into())],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate {
            habit,
            fix,
            ty: None,
        })
    }

    /// Numbers in other characters; a unit or dash on its own joins its number.
    fn characters(&self, out: &mut Vec<Candidate>) {
        let on_line: Vec<Token> = (self.all.iter())
            .filter(|t| !t.kind.is_trivia())
            .copied()
            .collect();
        let mut new = Vec::new();
        let mut i = 0;
        while i < on_line.len() {
            let joined = |j: usize| {
                let (a, b) = (on_line[i], *on_line.get(j)?);
                let token = Token {
                    len: b.end() - a.start,
                    ..a
                };
                Some((token, a.text(self.text), b.text(self.text)))
            };
            if let Some((token, a, b)) = joined(i + 1) {
                let (a_is_number, b_is_number) =
                    (on_line[i].kind.is_number(), on_line[i + 1].kind.is_number());
                let text = match () {
                    () if a_is_number && characters::is_unit(b) && b == "%" => {
                        characters::number(&format!("{a}%"))
                    }
                    () if a_is_number && characters::is_unit(b) => characters::number(a),
                    () if characters::is_dash(a) && b_is_number => {
                        characters::number(&format!("-{b}"))
                    }
                    () => None,
                };
                if let Some(text) = text {
                    new.push((token, text));
                    i += 2;
                    continue;
                }
            }
            let token = on_line[i];
            let is_word = matches!(
                token.kind,
                TokenKind::MalformedNumber | TokenKind::Word | TokenKind::Invalid
            );
            if is_word {
                match characters::number(token.text(self.text)) {
                    Some(text) => new.push((token, text)),
                    // What else is wrong with the line is another matter.
                    None if i != 1 => return,
                    None => {}
                }
            }
            i += 1;
        }
        out.extend(self.write(Habit::Characters, &new));
    }

    /// A word, or several, in the place of a type's number.
    fn words(&self, out: &mut Vec<Candidate>) {
        let behind = self.tokens.get(1..).unwrap_or(&[]);
        let count = (behind.iter())
            .take_while(|t| t.kind == TokenKind::Word)
            .count();
        let Some(last) = count.checked_sub(1).map(|last| behind[last]) else {
            return;
        };
        let span = behind[0].span().to(last.span());
        let params = &behind[count..];
        for ty in words::types(&self.text[span.range()]) {
            if self.fit(ty, params) {
                let mut candidate = self.write_type(Habit::Word, ty);
                candidate.fix.edits[0].span = span;
                out.push(candidate);
            }
        }
    }

    /// Words behind a record that were meant as a comment.
    fn comments(&self, out: &mut Vec<Candidate>) {
        let is_wordy = |t: &Token| {
            matches!(
                t.kind,
                TokenKind::Word
                    | TokenKind::Invalid
                    | TokenKind::MalformedNumber
                    | TokenKind::UnterminatedComment
                    | TokenKind::Quoted
            )
        };
        // A comment that is closed is part of it only where another is not.
        let first = |t: &Token| is_wordy(t) || t.kind == TokenKind::Comment;
        let separators_before = |mut i: usize| {
            while i > 0 && self.all[i - 1].kind == TokenKind::Separator {
                i -= 1;
            }
            i
        };
        let mut starts: Vec<usize> = Vec::new();
        let significant: Vec<usize> = (0..self.all.len())
            .filter(|&i| !self.all[i].kind.is_trivia())
            .collect();
        // Behind as many numbers as the record has.
        if let Some(ty) = self.ty() {
            let count = match ty.is_counted() {
                true => self.int(2).and_then(|n| u64::try_from(n).ok()).unwrap_or(0),
                false => 0,
            };
            let at = usize::try_from(ty.arity(count).saturating_add(2)).unwrap_or(usize::MAX);
            if let Some(&i) = significant.get(at) {
                starts.push(i);
            } else if at == significant.len() {
                starts.extend(self.all.iter().position(first));
            }
        }
        starts.extend(self.all.iter().position(is_wordy));
        starts.extend(self.all.iter().position(first));
        for i in starts {
            let i = separators_before(i);
            if !self.all[i..].iter().any(is_wordy) {
                continue;
            }
            let begin = self.all[i].start;
            // A record has an ID and a type at least; a `0` may introduce a comment, and words alone are a heading.
            let before = significant.iter().filter(|&&s| s < i).count();
            let is_void = before == 1 && self.int(0) == Some(0);
            if before == 1 && !is_void || before == 0 && !self.is_heading() {
                continue;
            }
            let written = &self.text[begin as usize..self.line.end as usize];
            let words: String = written.replace(['#', '\u{2028}'], " ");
            let words = words
                .trim()
                .trim_start_matches(['/', '*', ';', '-', '%', ',']);
            let words = words.trim_end_matches(['/', '*']).trim();
            if !words.contains(char::is_alphabetic) {
                continue;
            }
            let words: Vec<&str> = words.split_whitespace().collect();
            let comment = format!("# {} #", words.join(" "));
            let comment = match before {
                0 => format!("0 {comment}"),
                _ => comment,
            };
            let fix = Fix::replace(
                "fix-comment",
                Applicability::Unsafe,
                Span::new(begin, self.line.end),
                comment,
            );
            out.push(Candidate {
                habit: Habit::Comment,
                fix,
                ty: None,
            });
        }
    }

    /// Whether the line is words, the first one in the place of an ID.
    fn is_heading(&self) -> bool {
        let is_word = |t: &Token| matches!(t.kind, TokenKind::Word | TokenKind::Invalid);
        let on_line = self.all.iter().filter(|t| !t.kind.is_trivia());
        let (words, others): (Vec<&Token>, Vec<&Token>) = on_line.partition(|t| is_word(t));
        words.len() > others.len() && self.tokens.first().is_some_and(is_word)
    }

    /// The minus of the type, which is lost or too many.
    fn signs(&self, out: &mut Vec<Candidate>) {
        let ty = self.int(1).and_then(i64::checked_neg);
        if let Some(ty) = ty.and_then(RecordType::by_code)
            && self.fits(ty)
        {
            out.push(self.write_type(Habit::Sign, ty));
        }
    }

    /// Numbers that stand there twice, one group behind the other.
    fn doubled(&self, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| !ty.is_counted()) else {
            return;
        };
        let (params, wanted) = (self.params(), ty.params.len());
        let Some(more) = params.len().checked_sub(wanted).filter(|&more| more > 1) else {
            return;
        };
        let text = |t: &Token| t.text(self.text);
        let value = |t: &Token| t.number(self.text).map(f64::to_bits);
        let same = |a: &[Token], b: &[Token]| a.iter().zip(b).all(|(a, b)| value(a) == value(b));
        let sorted = |a: &[Token]| {
            let mut all: Vec<&str> = a.iter().map(text).collect();
            all.sort_unstable();
            all
        };
        for i in 0..=params.len() - more {
            let dropped = &params[i..i + more];
            let again = i >= more && same(&params[i - more..i], dropped);
            let turned = i == wanted && more == wanted && sorted(&params[..i]) == sorted(dropped);
            if again || turned {
                let span = Span::new(params[i - 1].end(), dropped[more - 1].end());
                out.push(Candidate {
                    habit: Habit::Doubled,
                    fix: Fix::replace("fix-doubled", Applicability::Unsafe, span, ""),
                    ty: None,
                });
            }
        }
    }

    /// A record with the numbers of its sibling.
    fn siblings(&self, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| !self.fits(ty)) else {
            return;
        };
        let siblings = SIBLINGS.iter().filter(|s| s.0 == ty.code);
        for &code in siblings.flat_map(|s| s.1) {
            if let Some(ty) = RecordType::by_code(code.into()).filter(|ty| self.fits(ty)) {
                out.push(self.write_type(Habit::Sibling, ty));
            }
        }
        let new = |title, text: String| {
            let params = self.params();
            let span = params[0].span().to(params[params.len() - 1].span());
            Candidate {
                habit: Habit::Sibling,
                fix: Fix::replace(title, Applicability::Unsafe, span, text.clone())
                    .with("number", quote(&text)),
                ty: None,
            }
        };
        let texts: Vec<&str> = (self.params().iter()).map(|t| t.text(self.text)).collect();
        match (ty.kind, texts.as_slice(), self.id()) {
            (RecordKind::PointLight | RecordKind::AmbientLight, &[r, g, b], Some(id)) => {
                out.push(new("fix-lamp", format!("1\n{id} -701 {r} {g} {b}")));
            }
            (RecordKind::Scaling, &[s], _) => out.push(new("fix-write", format!("{s} {s} {s}"))),
            (RecordKind::Render, &[one], _) => out.push(new("fix-write", format!("{one} 0"))),
            (RecordKind::Union | RecordKind::Intersection | RecordKind::Difference, &[one], _) => {
                let others = self.entities(&[Kind::Object]).map(|e| e.id);
                let mut others: Vec<u32> = others.filter(|id| id.to_string() != one).collect();
                // The last ones first.
                others.reverse();
                for id in others.into_iter().take(MOST / 2) {
                    out.push(new("fix-write", format!("{one} {id}")));
                    out.push(new("fix-write", format!("{id} {one}")));
                }
            }
            (RecordKind::Assignment, &[one], _) => {
                out.push(new("fix-write", format!("0 {one}")));
                out.push(new("fix-write", format!("{one} 0")));
            }
            _ => {}
        }
    }

    /// Records of other types that have as many numbers, the nearest number first.
    fn types(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let known = self.ty().is_some_and(|ty| self.fits(ty));
        let unknown = match finding.code {
            Code::E007 => true,
            Code::E103 | Code::E101 => known && finding.span == self.tokens[0].span(),
            _ => false,
        };
        let Some(code) = self.int(1).filter(|_| unknown) else {
            return;
        };
        let mut fitting: Vec<&'static RecordType> = crate::syntax::table::RECORD_TYPES
            .iter()
            .filter(|ty| self.fits(ty) && i64::from(ty.code) != code)
            .filter(|ty| ty.family != Family::Void && ty.family != Family::Render)
            .collect();
        fitting.sort_by_key(|ty| i64::from(ty.code).abs_diff(code));
        out.extend(
            fitting
                .into_iter()
                .take(MOST / 2)
                .map(|ty| self.write_type(Habit::Type, ty)),
        );
    }

    /// The parameters that are references, and what they may refer to.
    fn referring(&self) -> Vec<(Token, &'static [Kind])> {
        let Some(ty) = self.ty().filter(|ty| self.fits(ty)) else {
            return Vec::new();
        };
        let kinds = |p: &'static Param| match p.kind {
            ParamKind::Reference { kinds, .. } => Some(kinds),
            _ => None,
        };
        (self.params().iter().enumerate())
            .filter_map(|(i, &t)| Some((t, kinds(ty.param(i, 0)?)?)))
            .filter(|(t, _)| t.integer(self.text).is_some())
            .collect()
    }

    /// The entities that may be referred to here, those of the right kind.
    fn entities(&self, kinds: &'static [Kind]) -> impl Iterator<Item = &Entity> {
        let late = self.ty().is_some_and(|ty| {
            matches!(
                ty.kind,
                RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
            )
        });
        let before = self.line.start;
        (self.analysis.scene.entities.iter())
            .filter(move |e| late || e.span.start < before)
            .filter(|e| e.kind.is_none_or(|k| kinds.contains(&k)))
    }

    /// References that are swapped, off by one, or name something else.
    fn references(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let all = self.referring();
        if !all.iter().any(|(t, _)| finding.span == t.span()) {
            return;
        }
        self.swapped(out);
        let id = |t: &Token| t.integer(self.text).unwrap_or(0);
        // A single one is no more than one off.
        let most = if all.len() > 1 { 4 } else { 2 };
        for by in &[1, -1, 2, -2][..most] {
            let shifted: Option<Vec<(Token, String)>> = (all.iter())
                .filter(|(t, _)| id(t) != 0)
                .map(|(t, _)| {
                    let new = id(t).checked_add(*by).filter(|&id| id > 0)?;
                    Some((*t, new.to_string()))
                })
                .collect();
            out.extend(shifted.and_then(|new| self.write(Habit::Shifted, &new)));
        }
        for (t, kinds) in all.iter().filter(|(t, _)| finding.span == t.span()) {
            let written = id(t);
            let text = written.to_string();
            let used: Vec<i64> = all.iter().map(|(t, _)| id(t)).collect();
            let mut others: Vec<(bool, usize, u64, u32)> = (self.entities(kinds))
                .filter(|e| i64::from(e.id) != written && Some(e.id) != self.id())
                .map(|e| {
                    let new = e.id.to_string();
                    (
                        used.contains(&i64::from(e.id)),
                        strsim::osa_distance(&text, &new),
                        i64::from(e.id).abs_diff(written),
                        e.id,
                    )
                })
                .collect();
            others.sort_unstable();
            out.extend(
                (others.iter().take(MOST))
                    .filter_map(|o| self.write(Habit::Reference, &[(*t, o.3.to_string())])),
            );
        }
    }

    /// Two references in each other's place.
    fn swapped(&self, out: &mut Vec<Candidate>) {
        let all = self.referring();
        let texts = |t: &Token| t.text(self.text).to_owned();
        if let [(a, _), (b, _)] = all[..] {
            out.extend(self.write(Habit::Swapped, &[(a, texts(&b)), (b, texts(&a))]));
        }
    }

    /// Something else that the record may change.
    fn ids(&self, finding: &Diagnostic, undefined: &[u32], out: &mut Vec<Candidate>) {
        if finding.code == Code::E102 && finding.span == self.tokens[0].span() {
            let head = self.tokens[0];
            let new = undefined.iter().take(MOST / 2);
            out.extend(new.filter_map(|id| self.write(Habit::Id, &[(head, id.to_string())])));
            return;
        }
        let (Some(ty), Some(id)) = (self.ty(), self.id()) else {
            return;
        };
        let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = ty.effect else {
            return;
        };
        if finding.span != self.tokens[0].span() || !self.fits(ty) {
            return;
        }
        // The object stands in the place of a property, and the property in that of the object.
        let head = self.tokens[0];
        for (t, _) in self.referring() {
            let texts = |t: &Token| t.text(self.text).to_owned();
            out.extend(self.write(Habit::Swapped, &[(head, texts(&t)), (t, texts(&head))]));
        }
        let text = id.to_string();
        let mut others: Vec<(usize, u32, u32)> = (self.entities(kinds))
            .filter(|e| e.id != id)
            .map(|e| {
                let new = e.id.to_string();
                (strsim::osa_distance(&text, &new), e.id.abs_diff(id), e.id)
            })
            .collect();
        others.sort_unstable();
        out.extend(
            (others.iter().take(MOST / 2))
                .filter_map(|o| self.write(Habit::Id, &[(head, o.2.to_string())])),
        );
    }
}
