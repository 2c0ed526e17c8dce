//! Numbers behind those of a record that make a record of their own: the place of a lamp, the colour of an object.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType, ShapeKind};

/// How many numbers a move has, and a colour.
const OWN: usize = 3;

/// Evidence that a place goes before the numbers of a record.
#[derive(Clone, Copy)]
enum Order {
    /// The place stands in brackets.
    Brackets,
    /// The numbers behind the place are rather those of the record.
    PlaceFirst,
    /// There is no evidence: the place may also follow the numbers.
    Either,
}

impl LineContext<'_> {
    /// Guesses at a light or a shape with surplus numbers: three are its colour or its place, six are both. The type
    /// may have lost its minus, too.
    pub(super) fn apart(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_better = |c: &Candidate| matches!(c.habit, Habit::Doubled | Habit::Sibling);
        let Some(id) = self.id() else {
            return;
        };
        let is_surplus = matches!(finding.code, Code::E007 | Code::E009);
        if !is_surplus || out.iter().any(is_better) {
            return;
        }
        let lost = self.int(1).and_then(i64::checked_neg);
        let (ty, habit) = match (self.ty(), lost.and_then(RecordType::by_code)) {
            (Some(ty), _) if self.named.is_some() => (ty, Habit::Word),
            (Some(ty), _) => (ty, Habit::Apart),
            (None, Some(ty)) => (ty, Habit::Sign),
            (None, None) => return,
        };
        let Effect::Defines(kind) = ty.effect else {
            return;
        };
        let is_one = matches!(ty.family, Family::Light | Family::Shape) && !ty.is_counted();
        let wanted = ty.params.len();
        let Some((own, rest)) = self.params().split_at_checked(wanted).filter(|_| is_one) else {
            return;
        };
        if own.is_empty() || self.is_cone_of_circles() {
            return;
        }
        let records = match rest.len() {
            OWN => vec![vec![RecordKind::Colour], vec![RecordKind::Translation]],
            n if n == 2 * OWN => vec![vec![RecordKind::Translation, RecordKind::Colour]],
            _ => Vec::new(),
        };
        let start = out.len();
        let at_origin = self.at_origin(ty, habit);
        for records in &records {
            let records: Vec<&RecordType> = records.iter().map(|&k| RecordType::of(k)).collect();
            if !self.may_follow(&records, rest, kind) || self.is_flat(ty, own) {
                continue;
            }
            let mut before = &own[own.len() - 1];
            let mut edits = self.signed(ty, habit);
            for (ty, tokens) in records.iter().zip(rest.chunks(OWN)) {
                edits.push(self.begun(id, ty, before, &tokens[0]));
                before = &tokens[OWN - 1];
            }
            out.extend(self.records_apart(ty, &records, habit, rest, edits));
        }
        // As other programs have it, the place goes first where brackets or the numbers say so.
        let order = self.order(ty);
        let placed = order.and_then(|_| self.place_first(id, ty, kind, habit));
        match order {
            Some(Order::Brackets) if placed.is_some() => out.truncate(start),
            _ => {}
        }
        let at = match order {
            Some(Order::PlaceFirst) => start,
            _ => out.len(),
        };
        match at_origin {
            Some(candidate) => out.insert(start, candidate),
            None => {
                out.splice(at..at, placed);
            }
        }
    }

    /// Guesses that surplus zeros, before or behind the sizes of a shape without a place of its own, are its place: the
    /// origin, which is left out.
    fn at_origin(&self, ty: &RecordType, habit: Habit) -> Option<Candidate> {
        let params = self.params();
        let sizes = ty.params.len();
        let is_placed = ty.family == Family::Shape
            && ty.vectors.is_empty()
            && sizes > 0
            && params.len() == sizes + OWN
            && habit == Habit::Apart;
        if !is_placed {
            return None;
        }
        let is_zero = |some: &[Token]| some.iter().all(|t| t.number(self.text) == Some(0.0));
        let (before, behind) = (&params[..OWN], &params[sizes..]);
        let (place, span) = match (is_zero(before), is_zero(behind)) {
            (true, _) => (before, Span::new(before[0].start, params[OWN].start)),
            (false, true) => {
                let end = behind[OWN - 1].end();
                (behind, Span::new(params[sizes - 1].end(), end))
            }
            (false, false) => return None,
        };
        let fix = Fix::replace("fix-origin", Applicability::Unsafe, span, "");
        let text = quote(&self.spaced(place)?);
        Some(Candidate::new(habit, fix.with("text", text)))
    }

    /// Guesses at whole records behind the first record of a line: each goes to a line of its own. A colour may have
    /// its name in place of its numbers.
    pub(super) fn records_behind(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let mut at = 2 + self.wanted(ty);
        let (mut edits, mut last) = (Vec::new(), None);
        while at < self.tokens.len() {
            let place = LineContext {
                tokens: self.tokens[at..].to_vec(),
                named: None,
                ..*self
            };
            let (id, ty) = (place.id()?, place.ty()?);
            let (count, text) = place.own_numbers(ty)?;
            let gap = Span::new(self.tokens[at - 1].end(), self.tokens[at].start);
            let params = &place.params()[..count];
            let edit = |span: Span, text: String| Edit { span, text };
            edits.push(edit(self.is_gap(gap).then_some(gap)?, String::from("\n")));
            edits.push(edit(
                params[0].span().to(params[count - 1].span()),
                text.clone(),
            ));
            last = Some((ty, format!("{id} {} {text}", ty.code)));
            at += 2 + count;
        }
        let (ty, text) = last?;
        let fix = Fix {
            title: "fix-apart",
            values: vec![
                ("type", Value::Term(ty.title)),
                ("text", quote(&text).into()),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(Habit::Apart, fix))
    }

    /// The fix for a second record of the same ID on a line, which lacks numbers: it goes to a line of its own. The
    /// numbers that it lacks are another matter.
    pub(in crate::analysis::repair) fn incomplete_behind(&self) -> Option<Fix> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let at = 2 + ty.params.len();
        let behind = self.tokens.get(at..)?;
        let (id, code) = (behind.first()?, behind.get(1)?);
        let next = RecordType::by_code(code.integer(self.text)?)?;
        let is_own = id.integer(self.text).is_some() && id.integer(self.text) == self.int(0);
        let count = behind.len() - 2;
        let changes = !matches!(next.effect, Effect::Defines(_)) && !next.is_counted();
        let is_short = changes && (1..next.params.len()).contains(&count);
        let gap = Span::new(self.tokens[at - 1].end(), id.start);
        if !is_own || !is_short || !self.is_gap(gap) {
            return None;
        }
        let text = self.spaced(behind)?;
        let fix = Fix::replace("fix-apart", Applicability::Choice, gap, "\n");
        let fix = fix.with("type", Value::Term(next.title));
        Some(fix.with("text", quote(&text)))
    }

    /// Guesses at a record and the next one without a line end between them, so that the last number and the next ID
    /// are one token. The second record changes the same object, or defines an undefined ID.
    pub(super) fn lost_line_end(&self, finding: &Diagnostic, used: &[u32]) -> Option<Candidate> {
        let is_surplus = finding.code == Code::E009;
        let ty =
            (self.ty()).filter(|ty| is_surplus && !ty.is_counted() && !ty.params.is_empty())?;
        let (own, behind) = self.params().split_at_checked(ty.params.len())?;
        let last = own.last()?;
        let (head, params) = behind.split_first()?;
        let next = RecordType::by_code(head.integer(self.text)?)?;
        let written = last.text(self.text);
        let defines = matches!(next.effect, Effect::Defines(_));
        let ids: &[u32] = if defines { used } else { &[self.id()?] };
        let digits = written.bytes().rev().take_while(u8::is_ascii_digit);
        let split = |count: usize| {
            let (number, id) = written.split_at(written.len() - count);
            let is_number = number.parse::<f64>().is_ok() && !number.ends_with('.');
            let is_id = !id.starts_with('0') && id.parse().is_ok_and(|id| ids.contains(&id));
            (is_number && is_id).then_some((number, id))
        };
        let (number, id) = (1..=digits.count()).rev().find_map(split)?;
        if !self.fit(next, params) {
            return None;
        }
        let text = format!("{id} {}", self.spaced(behind)?);
        let fix = Fix::replace(
            "fix-apart",
            Applicability::Unsafe,
            last.span(),
            format!("{number}\n{id}"),
        );
        Some(Candidate::new(
            Habit::Apart,
            fix.with("type", Value::Term(next.title))
                .with("text", quote(&text)),
        ))
    }

    /// Guesses at a copy and its translation, where a translation names the object that it copies, `3 -1 2  4 0 0`, or
    /// where a copy has a place.
    pub(super) fn moved_copy(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = self.ty().filter(|_| finding.code == Code::E009)?;
        let [copy, translation] = [RecordKind::Copy, RecordKind::Translation].map(RecordType::of);
        let title = match ty.kind {
            RecordKind::Copy => "fix-apart",
            RecordKind::Translation => "fix-copy",
            _ => return None,
        };
        let (original, place) = self.params().split_first().filter(|p| p.1.len() == OWN)?;
        let id = self.id()?;
        let is_new = ty.kind == RecordKind::Copy || self.kind_of(id.into()).is_none();
        let is_object = self.kind_of(original.integer(self.text)?) == Some(Kind::Object);
        if !is_new || !is_object || !place.iter().all(|t| t.kind().is_number()) {
            return None;
        }
        let edits = vec![
            Edit {
                span: self.tokens[1].span(),
                text: copy.code.to_string(),
            },
            self.begun(id, translation, original, &place[0]),
        ];
        let text = if ty.kind == RecordKind::Copy {
            place
        } else {
            &self.params()[..1]
        };
        let fix = Fix {
            title,
            values: vec![
                ("type", Value::Term(translation.title)),
                ("text", quote(&self.spaced(text)?).into()),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(Habit::Apart, fix))
    }

    /// How many tokens are the numbers of a record of this type, and these numbers as a text.
    fn own_numbers(&self, ty: &RecordType) -> Option<(usize, String)> {
        let colour = (ty.kind == RecordKind::Colour).then(|| self.named_colour(self.params()));
        if let Some(colour) = colour.flatten() {
            return Some(colour);
        }
        let count = self.wanted(ty);
        let numbers = self.params().get(..count).filter(|n| !n.is_empty())?;
        let text = self.spaced(numbers)?;
        (numbers.iter().all(|t| t.kind().is_number())).then_some((count, text))
    }

    /// The edit that gives the type its minus, if the habit is that the minus is lost; empty otherwise.
    fn signed(&self, ty: &RecordType, habit: Habit) -> Vec<Edit> {
        let sign = (habit == Habit::Sign).then(|| Edit {
            span: self.tokens[1].span(),
            text: ty.code.to_string(),
        });
        sign.into_iter().collect()
    }

    /// Guesses that the place stands before the numbers of the type, or that a lamp has its place and its colour, but
    /// no intensity.
    fn place_first(&self, id: u32, ty: &RecordType, kind: Kind, habit: Habit) -> Option<Candidate> {
        let params = self.params();
        let (place, own) = params.split_at_checked(OWN)?;
        let [translation, colour] =
            [RecordKind::Translation, RecordKind::Colour].map(RecordType::of);
        let begun = |ty: &RecordType, text: &str| format!("\n{id} {} {text}", ty.code);
        let (place_text, own_text) = (self.spaced(place)?, self.spaced(own)?);
        let moved = begun(translation, &place_text);
        let (records, told, text) = match own.len() {
            n if n == ty.params.len() => (vec![translation], place, format!("{own_text}{moved}")),
            OWN if ty.family == Family::Light => (
                vec![translation, colour],
                params,
                format!("1{moved}{}", begun(colour, &own_text)),
            ),
            _ => return None,
        };
        if !self.may_follow(&records, params, kind) || self.is_flat(ty, own) {
            return None;
        }
        let mut edits = self.signed(ty, habit);
        let span = place[0].span().to(params[params.len() - 1].span());
        edits.push(Edit { span, text });
        self.records_apart(ty, &records, habit, told, edits)
    }

    /// The evidence that the first three numbers are a place. `None` if they are none. In most scenes an intensity is 1
    /// at most.
    fn order(&self, ty: &RecordType) -> Option<Order> {
        let params = self.params();
        let ends = params.get(OWN - 1..=OWN)?;
        let between = &self.text[ends[0].end() as usize..ends[1].start as usize];
        if between.contains(['>', ')', '}', ']']) {
            return Some(Order::Brackets);
        }
        let is_intensity = |t: Option<&Token>| {
            let x = t.and_then(|t| t.number(self.text));
            x.is_some_and(|x| (0.0..=1.0).contains(&x))
        };
        if ty.family != Family::Light {
            // The numbers of a shape of sizes alone have no place: either order may be meant, and one makes more sense.
            let order = match self.has_thinner_tube_behind(ty) {
                true => Order::PlaceFirst,
                false => Order::Either,
            };
            return ty.vectors.is_empty().then_some(order);
        }
        match (is_intensity(params.first()), is_intensity(params.last())) {
            (false, true) => Some(Order::PlaceFirst),
            (true, false) => None,
            _ => Some(Order::Either),
        }
    }

    /// Whether the last two numbers are the radii of a torus rather than the first two: most tubes are thin.
    fn has_thinner_tube_behind(&self, ty: &RecordType) -> bool {
        let params = self.params();
        if ty.kind != RecordKind::Shape(ShapeKind::Torus) || params.len() != ty.params.len() + OWN {
            return false;
        }
        let thickness = |radii: &[Token]| {
            let [ring, tube] = [0, 1].map(|i| radii[i].number(self.text));
            let (ring, tube) = (ring?, tube?);
            (tube > 0.0 && ring > tube).then_some(tube / ring)
        };
        let (before, behind) = (thickness(&params[..2]), thickness(&params[OWN..]));
        behind.is_some_and(|behind| before.is_none_or(|before| behind < before))
    }

    /// The candidate whose edits make some numbers records of their own.
    fn records_apart(
        &self,
        ty: &RecordType,
        records: &[&'static RecordType],
        habit: Habit,
        told: &[Token],
        edits: Vec<Edit>,
    ) -> Option<Candidate> {
        let names_type = matches!(habit, Habit::Sign | Habit::Word);
        let fix = Fix {
            title: match (records.len(), names_type) {
                (1, true) => "fix-sign-apart",
                (1, false) => "fix-apart",
                (_, true) => "fix-sign-apart-both",
                (_, false) => "fix-apart-both",
            },
            values: vec![
                ("type", Value::Term(records[0].title)),
                ("number", ty.code.to_string().into()),
                ("text", quote(&self.spaced(told)?).into()),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(habit, fix))
    }

    /// Whether a shape has no inside: one of its sizes is zero, or two corners of a box share a coordinate.
    fn is_flat(&self, ty: &RecordType, own: &[Token]) -> bool {
        let is_zero = |t: &Token| t.number(self.text) == Some(0.0);
        let is_same = |(low, high): (&Token, &Token)| {
            low.number(self.text).map(f64::to_bits) == high.number(self.text).map(f64::to_bits)
        };
        match ty.kind {
            RecordKind::Shape(ShapeKind::Box) => own.iter().zip(own.iter().skip(OWN)).any(is_same),
            RecordKind::Shape(_) => ty.vectors.is_empty() && own.iter().any(is_zero),
            _ => false,
        }
    }

    /// Whether numbers may be meant as records that follow a definition of a kind.
    fn may_follow(&self, records: &[&RecordType], tokens: &[Token], kind: Kind) -> bool {
        let numbers: Option<Vec<f64>> = tokens.iter().map(|t| t.number(self.text)).collect();
        let mut each = records
            .iter()
            .rev()
            .zip(numbers.iter().flat_map(|n| n.rchunks(OWN)));
        numbers.is_some() && each.all(|(ty, numbers)| may_follow(ty, kind, numbers))
    }

    /// The edit that begins a record on a line of its own, between the token `before` and its first number.
    fn begun(&self, id: u32, ty: &RecordType, before: &Token, number: &Token) -> Edit {
        let between = Span::new(before.end(), number.start);
        Edit {
            span: match self.is_gap(between) {
                true => between,
                false => Span::new(number.start, number.start),
            },
            text: format!("\n{id} {} ", ty.code),
        }
    }
}

/// Whether numbers may be meant as a record of a type that follows a definition of a kind.
fn may_follow(ty: &RecordType, kind: Kind, numbers: &[f64]) -> bool {
    let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = ty.effect else {
        return false;
    };
    let fits = match ty.kind {
        RecordKind::Colour => numbers.iter().all(|x| (0.0..=1.0).contains(x)),
        // At the origin there is nothing to be moved.
        RecordKind::Translation => numbers.iter().any(|&x| x != 0.0),
        _ => true,
    };
    kinds.contains(&kind) && fits
}
