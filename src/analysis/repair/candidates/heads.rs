//! The beginning of a record: the name of a type before its ID, ID and type in each other's place, a type with a space
//! in it, and its name behind it.

use rustc_hash::{FxHashMap, FxHashSet};

use super::axes::about_axis;
use super::inline::NAMED_TITLE;
use super::{Candidate, Habit, LineContext, header};
use crate::analysis::colours;
use crate::analysis::repair::whole::{records, references};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::Entity;
use crate::syntax::LEAST_HEAD;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, Param, ParamKind, RecordKind, RecordType};
use crate::syntax::words;
use crate::syntax::{Item, Record};

/// The most IDs that are tried for a record without one.
const MAX_IDS: usize = 3;

/// The most IDs of properties used as objects that are examined.
const MAX_MISUSED: usize = 8;

/// The render record always has this ID.
const RENDER: u32 = 1;

impl LineContext<'_> {
    /// Guesses at a record that begins with the name of its type, as in other programs: `sphere 4 0 1 0 0.5`. A record
    /// without an ID gets an undefined ID, the ID of the record before if it changes something, or a free ID.
    pub(super) fn keyword(&self, used: &[u32], out: &mut Vec<Candidate>) {
        let is_word = |t: &&Token| t.kind() == TokenKind::Word;
        let count = self.tokens.iter().take_while(is_word).count();
        let (named, rest) = self.tokens.split_at(count);
        let (Some(first), Some(last)) = (named.first(), named.last()) else {
            return;
        };
        let word = first.span().to(last.span());
        for ty in words::types(&self.text[word.range()]) {
            let edit = |span: Span, text: String| Edit { span, text };
            let edits = match rest.split_first() {
                _ if ty.kind == RecordKind::Render => {
                    let mut edits = vec![edit(word, format!("{RENDER} {}", ty.code))];
                    match rest {
                        // The background is left out: it is black.
                        [root] => edits.push(edit(Span::new(root.end(), root.end()), " 0".into())),
                        _ if self.fit(ty, rest) => {}
                        _ => continue,
                    }
                    edits
                }
                Some((id, params)) if self.fit(ty, params) => {
                    let Some(text) = id.integer(self.text).filter(|&id| id > 0) else {
                        continue;
                    };
                    let code = ty.code.to_string();
                    vec![edit(word, text.to_string()), edit(id.span(), code)]
                }
                _ if self.fit(ty, rest) => {
                    self.unnamed(word, ty, used, out);
                    continue;
                }
                _ => continue,
            };
            out.push(self.beginning(Habit::Keyword, edits));
        }
    }

    /// Guesses at the ID of a record that has the name of its type where the ID belongs, as `sphere 0 1 0 1`.
    fn unnamed(&self, word: Span, ty: &'static RecordType, used: &[u32], out: &mut Vec<Candidate>) {
        let before = match ty.effect {
            Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds) => self.id_before(kinds),
            Effect::Defines(_) => None,
        };
        let mut ids = Vec::from_iter(before);
        if !matches!(ty.effect, Effect::Changes(_)) {
            ids.extend(self.missing());
        }
        let is_new = ids.is_empty() && !matches!(ty.effect, Effect::Changes(_));
        ids.extend(self.free_id(used).filter(|_| is_new));
        for id in ids.into_iter().take(MAX_IDS) {
            let edit = |span: Span, text: String| Edit { span, text };
            let start = Span::new(word.start, word.start);
            let edits = vec![
                edit(start, format!("{id} ")),
                edit(word, ty.code.to_string()),
            ];
            let mut candidate = self.beginning(Habit::Unnamed, edits);
            candidate.ty = Some(ty);
            if is_new {
                candidate.fix.title = NAMED_TITLE;
            }
            out.push(candidate);
        }
    }

    /// The finding and the candidate for a record with ID and type in each other's place. `None` if the record is right
    /// as it stands.
    pub(crate) fn exchange(&self) -> Option<(Diagnostic, Candidate)> {
        // Whole numbers are asked for the number of sheets of a hyperboloid, as in `11 20 -2 1 0 0.9`.
        let is_odd = |t: &Token, param: &Param| {
            param.kind == ParamKind::Integer && t.integer(self.text).is_none()
        };
        let takes = |ty: &RecordType| {
            let mut params = self.params().iter().zip(0..);
            !params.any(|(t, i)| ty.param(i, 0).is_some_and(|param| is_odd(t, param)))
        };
        let is_right =
            self.ty().is_some_and(|ty| self.fits(ty) && takes(ty)) && self.id().is_some();
        (!is_right).then(|| self.exchanged_heads())?
    }

    /// Like `exchange`, but also where the record is right as it stands.
    pub(crate) fn exchanged_heads(&self) -> Option<(Diagnostic, Candidate)> {
        let [ty, id] = [self.tokens.first()?, self.tokens.get(1)?];
        let (code, number) = (ty.integer(self.text)?, id.integer(self.text)?);
        // The minus may have stayed in its place, as in `402 -50 1`.
        let (code, number) = match number < 0 && code > 0 {
            true => (-code, number.checked_neg()?),
            false => (code, number),
        };
        let meant = RecordType::by_code(code)?;
        let is_id = number > i64::from(RENDER);
        if !is_id || !self.fits(meant) || meant.kind == RecordKind::Undefined {
            return None;
        }
        let edit = |t: &Token, new: i64| Edit {
            span: t.span(),
            text: new.to_string(),
        };
        let edits = vec![edit(ty, number), edit(id, code)];
        let finding = Diagnostic::new(Code::E005, ty.span().to(id.span()))
            .case("exchanged")
            .with("text", quote(&code.to_string()))
            .with("number", quote(&number.to_string()));
        Some((finding, self.beginning(Habit::Exchanged, edits)))
    }

    /// The finding and the candidate for a render record whose type stands behind the ID of the drawn object:
    /// `1 20 9999 0`.
    pub(crate) fn render_exchanged(&self) -> Option<(Diagnostic, Candidate)> {
        let &[head, root, ty, behind] = self.tokens.as_slice() else {
            return None;
        };
        let render = RecordType::of(RecordKind::Render);
        let is_head = self.id() == Some(RENDER) && self.int(2) == Some(render.code.into());
        let is_object = self.kind_of(root.integer(self.text)?) == Some(Kind::Object);
        if !is_head || !is_object {
            return None;
        }
        let begin = format!("{RENDER} {}", render.code);
        let finding = Diagnostic::new(Code::E005, head.span().to(ty.span()))
            .case("drawn")
            .with("number", quote(&begin));
        let text = format!("{begin} {}", root.text(self.text));
        let whole = format!("{text} {}", behind.text(self.text));
        let span = head.span().to(ty.span());
        let fix = Fix::replace("fix-write", Applicability::Unsafe, span, text);
        let fix = fix.with("number", quote(&whole));
        Some((finding, Candidate::new(Habit::Exchanged, fix)))
    }

    /// The type of shape that the record is, if its ID is lost and its first number is its type.
    pub(crate) fn shape_without_id(&self) -> Option<&'static RecordType> {
        let ty = RecordType::by_code(self.int(0)?)?;
        let is_shape = ty.family == Family::Shape && self.fit(ty, &self.tokens[1..]);
        is_shape.then_some(ty)
    }

    /// The finding that a shape has lost its ID, and the candidate that puts `id` in front.
    pub(crate) fn without_id(
        &self,
        ty: &'static RecordType,
        id: u32,
    ) -> Option<(Diagnostic, Candidate)> {
        let head = self.tokens.first()?;
        let finding = Diagnostic::new(Code::E005, head.span())
            .case("lost")
            .with("type", Value::Term(ty.title))
            .with("number", ty.code.to_string())
            .with("header", header(ty))
            .with("lost", id.to_string());
        let start = Span::new(head.start, head.start);
        let fix = Fix::replace(
            "put-lost-id-in-front",
            Applicability::Unsafe,
            start,
            format!("{id} "),
        );
        let candidate = Candidate::new(Habit::Id, fix);
        Some((finding, candidate))
    }

    /// Whether the record is a change that is not possible for the entity with its ID.
    pub(crate) fn changes_nothing(&self) -> bool {
        let Some(Effect::Changes(kinds)) = self.ty().map(|ty| ty.effect) else {
            return false;
        };
        let mut entities = self.analysis.scene.entities.iter();
        let own = entities.find(|e| Some(e.id) == self.id());
        own.is_none_or(|e| e.kind.is_some_and(|kind| !kinds.contains(&kind)))
    }

    /// Guesses at ID and type without a space between them: `4111 0 1 0 1.2`. Undefined IDs come first, and IDs of
    /// other entities are left out.
    pub(super) fn glued(&self, undefined: &[u32]) -> Vec<Candidate> {
        let is_right = self.ty().is_some_and(|ty| self.fits(ty));
        let Some((head, params)) = self.tokens.split_first().filter(|_| !is_right) else {
            return Vec::new();
        };
        let digits = head.text(self.text);
        if !digits.bytes().all(|c| c.is_ascii_digit()) {
            return Vec::new();
        }
        // A property record below may be for this object, which could not be read.
        let is_free = |id: u32| {
            let mut entities = self.analysis.scene.entities.iter();
            (entities.find(|e| e.id == id)).is_none_or(|e| self.is_property_below(e))
        };
        let is_missing = |id: &u32| {
            let mut entities = self.analysis.scene.entities.iter();
            undefined.contains(id) || entities.any(|e| e.id == *id)
        };
        let split = |at: usize| -> Option<(u32, &'static RecordType)> {
            let (id, code) = digits.split_at(at);
            let id: u32 = id.parse().ok()?;
            let ty = RecordType::by_code(code.parse().ok().filter(|_| !code.starts_with('0'))?)?;
            (id > RENDER && is_free(id) && self.fit(ty, params)).then_some((id, ty))
        };
        let mut all: Vec<(u32, &RecordType)> = (1..digits.len()).filter_map(split).collect();
        // Where a type follows, the ID must be one that is missing.
        let has_type = self.ty().is_some_and(|ty| ty.kind != RecordKind::Undefined);
        all.retain(|(id, _)| !has_type || is_missing(id));
        all.sort_by_key(|(id, _)| !is_missing(id));
        let candidates = all.into_iter().map(|(id, ty)| {
            let text = format!("{id} {}", ty.code);
            Candidate {
                habit: Habit::NoType,
                fix: Fix::replace(
                    "fix-write",
                    Applicability::Unsafe,
                    head.span(),
                    text.clone(),
                )
                .with("number", quote(&text))
                .with("type", Value::Term(ty.title)),
                ty: Some(ty),
            }
        });
        candidates.collect()
    }

    /// Whether an entity is defined below by a property record, which would change an object with its ID if there was
    /// one.
    fn is_property_below(&self, entity: &Entity) -> bool {
        let document = &self.analysis.document;
        let mut below = document.items.iter().filter_map(Item::record);
        let own = below.find(|r| document.id_token(r).start == entity.span.start);
        let changes = own.is_some_and(|r| matches!(r.ty().effect, Effect::DefinesOrChanges(..)));
        entity.span.start >= self.line.end && changes
    }

    /// Guesses at a type with a space in it: `-7 01`. Two positive numbers are rather a type and its first parameter,
    /// unless together they are a type that defines an ID, which nothing else defines.
    pub(super) fn torn_type(&self) -> Option<Candidate> {
        let (first, second) = (self.tokens.get(1)?, self.tokens.get(2)?);
        let span = first.span().to(second.span());
        if self.ty().is_some_and(|ty| self.fits(ty)) || !second.kind().is_number() {
            return None;
        }
        let between = Span::new(first.end(), second.start);
        let is_space = self.text[between.range()].chars().all(|c| c == ' ');
        let joined = format!("{}{}", first.text(self.text), second.text(self.text));
        let ty = RecordType::by_code(joined.parse().ok()?).filter(|_| is_space)?;
        let mut entities = self.analysis.scene.entities.iter();
        let is_defined = entities.any(|e| Some(e.id) == self.id() && !self.line.touches(e.span));
        let is_lost = matches!(ty.effect, Effect::Defines(_)) && !is_defined;
        // `9999 1 8 2` is a render record with ID and type swapped.
        let is_render = self.int(0) == Some(RecordType::of(RecordKind::Render).code.into());
        let is_lost = is_lost && !is_render && self.tokens.len() > 3;
        if ty.code > 0 && !is_lost {
            return None;
        }
        let mut candidate = self.write_type(Habit::Characters, ty);
        candidate.fix.edits[0].span = span;
        self.fit(ty, &self.tokens[3..]).then_some(candidate)
    }

    /// Guesses at the numbers of a record that has the name of its type behind the type's number: `-701 rgb 1 0 0`,
    /// `-701 color red`.
    pub(super) fn own_name(&self) -> Option<Candidate> {
        let ty = self.ty()?;
        let is_name = |t: &&Token| {
            let mut named = words::types(t.text(self.text)).into_iter();
            t.kind() == TokenKind::Word && named.any(|n| n.code == ty.code)
        };
        let count = self.params().iter().take_while(is_name).count();
        let (named, rest) = self.params().split_at(count);
        let (first, last) = (named.first()?, rest.last()?);
        // `rgb(255, 0, 0)` is a colour of CSS as a whole.
        if self.text[first.end() as usize..].starts_with('(') {
            return None;
        }
        // A grey has one number for all three.
        let is_grey =
            ty.kind == RecordKind::Colour && rest.len() == 1 && rest[0].kind().is_number();
        let text = match is_grey {
            true => [rest[0].text(self.text); 3].join(" "),
            false => self.numbers_of(ty, rest)?,
        };
        let span = first.span().to(last.span());
        Some(Candidate::writing(Habit::Characters, span, text))
    }

    /// The finding that a record has one number too few or too many.
    pub(crate) fn one_off(&self) -> Option<Diagnostic> {
        let ty = self.ty().filter(|ty| ty.kind != RecordKind::Undefined)?;
        let is_one = self.params().len().abs_diff(self.wanted(ty)) == 1;
        self.wrong_count().filter(|_| is_one)
    }

    /// The finding that the type of the record does not exist. `None` if it does, or if it is too large a number to be
    /// certain.
    pub(crate) fn odd_type(&self) -> Option<Diagnostic> {
        let code = self.int(1).filter(|&code| code <= LEAST_HEAD.into())?;
        let is_none = RecordType::by_code(code).is_none();
        let d = Diagnostic::new(Code::E007, self.tokens[1].span())
            .with("text", quote(&code.to_string()));
        is_none.then_some(d)
    }

    /// The IDs that are referred to but defined nowhere, whatever findings say of them.
    pub(super) fn missing(&self) -> Vec<u32> {
        let entities = &self.analysis.scene.entities;
        let named = records(self.analysis).flat_map(|r| references(self.analysis, r));
        let mut all: Vec<u32> = named
            .filter_map(|n| u32::try_from(n.1).ok())
            .filter(|&id| id > RENDER)
            .collect();
        all.sort_unstable();
        all.dedup();
        let mut known: FxHashSet<u32> = entities.iter().map(|e| e.id).collect();
        // If an object could not be read, a property may be all that is left of it.
        let misused = self.misused();
        let of_object = entities.iter().filter(|e| misused.contains(&e.id));
        for entity in of_object.filter(|e| self.is_property_below(e)) {
            known.remove(&entity.id);
        }
        all.retain(|id| !known.contains(id));
        all
    }

    /// The IDs of properties that operations or the render record use as objects, at most [`MAX_MISUSED`].
    fn misused(&self) -> Vec<u32> {
        let kinds: FxHashMap<u32, Kind> = (self.analysis.scene.entities.iter())
            .filter_map(|e| Some((e.id, e.kind?)))
            .collect();
        let asks = |r: &&Record| matches!(r.ty().family, Family::Operation | Family::Render);
        let named = records(self.analysis).filter(asks);
        let named = named.flat_map(|r| references(self.analysis, r));
        let is_property =
            |kind: Option<&Kind>| matches!(kind, Some(Kind::Optics | Kind::Texture | Kind::Colour));
        let mut misused: Vec<u32> = named
            .filter_map(|n| u32::try_from(n.1).ok())
            .filter(|id| is_property(kinds.get(id)))
            .take(MAX_MISUSED)
            .collect();
        misused.dedup();
        misused
    }

    /// The numbers of a record, as a text. A colour may have its name in their place.
    fn numbers_of(&self, ty: &RecordType, params: &[Token]) -> Option<String> {
        match self.fit(ty, params) {
            true => self.spaced(params),
            false if ty.kind == RecordKind::Colour => self.colour_name(params),
            false => None,
        }
    }

    /// The numbers of the colour that all of some tokens name: `red`, `dark blue`.
    pub(super) fn colour_name(&self, tokens: &[Token]) -> Option<String> {
        let (first, last) = (tokens.first()?, tokens.last()?);
        if !tokens.iter().all(|t| t.kind() == TokenKind::Word) {
            return None;
        }
        colours::numbers(&self.text[first.span().to(last.span()).range()])
    }

    /// The colour whose name some tokens begin with: how many tokens the name takes, and the numbers of the colour.
    pub(super) fn named_colour(&self, tokens: &[Token]) -> Option<(usize, String)> {
        let named = |of: usize| Some((of, self.colour_name(tokens.get(..of)?)?));
        named(2).or_else(|| named(1))
    }

    /// Guesses at a record that has a word for its type, and another slip in its numbers: a place that stands first, a
    /// camera without its up vector.
    pub(super) fn named(
        &self,
        word: Span,
        ty: &'static RecordType,
        params: &[Token],
    ) -> Vec<Candidate> {
        let code = Edit {
            span: word,
            text: ty.code.to_string(),
        };
        if let ([first, ..], RecordKind::Colour) = (params, ty.kind)
            && let Some(text) = self.colour_name(params)
        {
            let span = first.span().to(params[params.len() - 1].span());
            return vec![self.beginning(Habit::Word, vec![code, Edit { span, text }])];
        }
        // As POV-Ray has it: `scale 1.2`, `ior 1.5`, `rotate x*75`.
        let one = |kind: RecordKind| match params {
            [one] if ty.kind == kind => Some((one, one.text(self.text))),
            _ => None,
        };
        let three = one(RecordKind::Scaling).or_else(|| one(RecordKind::RefractiveIndex));
        let three = three.filter(|(t, _)| t.kind().is_number());
        let three = three.map(|(t, s)| (t, [s; 3].join(" ")));
        let turn = || {
            let (t, text) = one(RecordKind::Rotation)?;
            Some((t, about_axis(text)?))
        };
        if let Some((t, text)) = three.or_else(turn) {
            let span = t.span();
            return vec![self.beginning(Habit::Word, vec![code, Edit { span, text }])];
        }
        let word = Token::new(TokenKind::Word, word.start as usize, word.end as usize);
        // A word for a colour may stand among the numbers, as in `light_source <5, 8, 6> rgb 0.7`.
        let is_colour = |t: &Token| {
            let mut named = words::types(t.text(self.text)).into_iter();
            t.kind() == TokenKind::Word && named.any(|ty| ty.kind == RecordKind::Colour)
        };
        let numbers = params.iter().filter(|t| !is_colour(t)).copied();
        let numbers: Vec<Token> = numbers.collect();
        let place = LineContext {
            tokens: [&[self.tokens[0], word], numbers.as_slice()].concat(),
            named: Some(ty),
            ..*self
        };
        let Some(finding) = place.wrong_count() else {
            return Vec::new();
        };
        let mut out = Vec::from_iter(place.angles().or_else(|| place.vectors()));
        place.apart(&finding, &mut out);
        place.without_up(&finding, &mut out);
        for candidate in &mut out {
            candidate.habit = Habit::Word;
            candidate.fix.edits.insert(0, code.clone());
        }
        out
    }

    /// A candidate that shows how the record begins.
    fn beginning(&self, habit: Habit, edits: Vec<Edit>) -> Candidate {
        let shown: Vec<&str> = edits.iter().map(|e| e.text.trim()).collect();
        let number = quote(&shown.join(" "));
        let fix = Fix {
            title: "fix-write",
            values: vec![("number", number.into())],
            applicability: Applicability::Unsafe,
            edits,
        };
        Candidate::new(habit, fix)
    }
}
