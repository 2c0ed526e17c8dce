//! Findings of the parser: what is wrong with the broken pieces of a text, in words.

use super::super::calculated::calculated;
use super::super::lexer::{Token, TokenKind};
use super::super::quote::quote;
use super::super::signature::fits;
use super::super::table::{Param, ParamKind, RecordKind, RecordType};
use super::super::words;
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::faults;
use super::stretch::Stretch;
use super::witness::Witnesses;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};

/// The most numbers that one record may claim to have.
const NUMBERS_MAX: usize = 100_000_000;

pub(super) fn header(ty: &RecordType) -> String {
    match ty.signature() {
        s if s.is_empty() => format!("`ID {}`", ty.code),
        s => format!("`ID {} {s}`", ty.code),
    }
}

/// Reports the comments that nobody closes.
pub(crate) fn comments(text: &str, tokens: &[Token], out: &mut Vec<Diagnostic>) {
    for (i, t) in tokens.iter().enumerate() {
        if t.kind() == TokenKind::UnterminatedComment {
            let end = t.start + t.text(text).trim_end().len() as u32;
            // A `#` with nothing behind it was rather meant to close a comment.
            let applicability = match t.text(text).trim_end().len() {
                0 | 1 => Applicability::Unsafe,
                _ => Applicability::Safe,
            };
            let fix = without_inner_signs(text, &tokens[..=i])
                .unwrap_or_else(|| Fix::replace("fix", applicability, Span::new(end, end), " #"));
            let span = Span::new(t.start, end.max(t.start + 1));
            out.push(Diagnostic::new(Code::E002, span).fix(fix));
        }
    }
}

/// The fix that leaves out each `#` inside of a comment, as in `# see #1 top #`. The last token is that comment, or the
/// rest of it behind an inner `#`.
fn without_inner_signs(text: &str, tokens: &[Token]) -> Option<Fix> {
    let (last, before) = tokens.split_last()?;
    let words = last.text(text).trim_end();
    let end = last.start + words.len() as u32;
    let is_tag = |sign: usize| {
        text[sign + 1..].starts_with(char::is_alphanumeric) && text[..sign].ends_with(' ')
    };
    let mut inside = words.match_indices('#').skip(1);
    // As in `# a # ball #`: closed once more, the words between two signs would be read as a record.
    let is_closed = words.ends_with('#') && words.matches('#').count() > 2;
    let begin = match words {
        _ if is_closed => last.start,
        _ if inside.any(|(at, _)| is_tag(last.start as usize + at)) => last.start,
        // As in `# ball #1 #`: the sign has closed the comment, and the last one is left over.
        "#" => {
            let on_line = |t: &&Token| t.kind() != TokenKind::Newline;
            let mut on_line = before.iter().rev().take_while(on_line);
            let closed = on_line.find(|t| t.kind() == TokenKind::Comment)?;
            is_tag(closed.end() as usize - 1).then_some(closed.start)?
        }
        _ => return None,
    };
    let span = Span::new(begin, end);
    let words = text[span.range()].replace('#', "");
    let words: Vec<&str> = words.split_whitespace().collect();
    let comment = format!("# {} #", words.join(" "));
    let fix = Fix::replace("fix-inner", Applicability::Unsafe, span, comment);
    Some(fix)
}

/// Reports everything that is wrong with the pieces of a text.
pub(crate) fn pieces(
    stretch: &Stretch,
    witnesses: &Witnesses,
    all: &[RecordCandidate],
    out: &mut Vec<Diagnostic>,
) {
    let reporter = Reporter { stretch };
    for piece in all {
        match piece.verdict {
            Diagnosis::Void => {}
            Diagnosis::Whole(r) => {
                let last = stretch.line(r.end - 1);
                let is_taken = witnesses.is_complete_line(stretch, last)
                    && witnesses.takes_over(stretch, piece.start, r.end);
                let head = stretch.line_start(last);
                let is_again = stretch.begins_again(piece.start, head);
                if is_taken || is_again || reporter.ends_with_record(witnesses, piece, r.ty) {
                    out.push(reporter.line_break(piece, r.ty));
                }
            }
            _ => reporter.broken(piece, out),
        }
    }
}

pub(super) struct Reporter<'a, 's> {
    pub(super) stretch: &'a Stretch<'s>,
}

impl Reporter<'_, '_> {
    pub(super) fn span(&self, start: usize, end: usize) -> Span {
        let last = self.stretch.token(end.max(start + 1) - 1);
        self.stretch.token(start).span().to(last.span())
    }

    pub(super) fn text(&self, i: usize) -> &str {
        self.stretch.token(i).text(self.stretch.text())
    }

    /// The text between a token and the next one.
    fn between(&self, i: usize) -> &str {
        let between = self.stretch.token(i).end()..self.stretch.token(i + 1).start;
        &self.stretch.text()[between.start as usize..between.end as usize]
    }

    /// Whether nothing but white space lies between a token and the next one.
    fn only_space_between(&self, i: usize) -> bool {
        self.between(i).trim().is_empty()
    }

    fn broken(&self, piece: &RecordCandidate, out: &mut Vec<Diagnostic>) {
        let (start, end) = (piece.start, piece.end);
        let is_record = !matches!(
            piece.verdict,
            Diagnosis::BadId { .. }
                | Diagnosis::LostId { .. }
                | Diagnosis::Surplus { .. }
                | Diagnosis::CutOff { .. }
        );
        if is_record && self.stretch.sigs[start].kind == TokenKind::Real {
            out.push(self.no_integer_for_id(start));
        }
        match piece.verdict {
            Diagnosis::Void | Diagnosis::Whole(_) | Diagnosis::CutOff { .. } => {}
            Diagnosis::Damaged { ty } | Diagnosis::Reals { ty } => {
                self.real_type(start, out);
                self.params(ty, start + 2, end, out);
            }
            Diagnosis::WrongArity { ty, got, expected } => {
                self.real_type(start, out);
                let before = out.len();
                self.bad_tokens(ty, start + 2, end, out);
                // A word for all numbers, as in `2 -701 red`, is one mistake, and so is one between numbers.
                let is_word = |i: &usize| self.stretch.sigs[*i].kind == TokenKind::Word;
                let words = match ty.kind {
                    // A file's name is no number, but the record has a place for it.
                    RecordKind::ImageTexture => 0,
                    _ => (start + 2..end).filter(is_word).count(),
                };
                let numbers = got - words.min(got);
                let is_all = got == 1 && expected > 1 && words == 1;
                let is_said = out.len() > before && (is_all || numbers == expected);
                if !is_said {
                    // If there are too many, a word may stand in the place of a number.
                    let got = if got < expected { numbers } else { got };
                    out.push(self.count(piece, ty, got, expected));
                }
            }
            Diagnosis::Surplus {
                ty,
                expected,
                at,
                id,
            } => {
                let span = self.stretch.token(at).span();
                let count = |n: usize| Value::Count(n as u64);
                let d = Diagnostic::new(Code::E009, span)
                    .with("type", Value::Term(ty.title))
                    .with("got", count(expected + 1))
                    .with("off", count(1))
                    .with("wanted", count(expected))
                    .with("fewer", "none")
                    .with("header", header(ty));
                // The fix writes the ID in the place of the first two tokens.
                let (head, id) = (self.span(start, start + 2), id.to_string());
                let fix = Fix::replace("fix-write", Applicability::Unsafe, head, id.clone());
                out.push(match self.only_space_between(start) {
                    true => d.fix(fix.with("number", quote(&id))),
                    false => d,
                });
            }
            Diagnosis::LostSign {
                ty,
                meant,
                got,
                expected,
            } => out.push(self.lost_sign(piece, (ty, meant), got, expected)),
            Diagnosis::BadPointCount { ty } => {
                self.real_type(start, out);
                self.bad_count(ty, start, end, out);
                self.commas(start + 3, end, out);
            }
            Diagnosis::UnknownType if self.is_render(start, end) => {
                out.push(self.lost_id(start, RecordType::of(RecordKind::Render)));
            }
            Diagnosis::UnknownType => {
                out.push(self.unknown_type(start + 1));
                self.commas(start + 2, end, out);
            }
            Diagnosis::BadType => {
                self.bad_type(start + 1, out);
                self.commas(start + 2, end, out);
            }
            Diagnosis::MissingType => out.push(self.missing_type(start)),
            Diagnosis::LostId { ty } => out.push(self.lost_id(start, ty)),
            Diagnosis::Swapped => {
                let span = self.span(start, start + 2);
                let head = format!("1 {}", RecordType::of(RecordKind::Render).code);
                out.push(
                    Diagnostic::new(Code::E005, span)
                        .case("swapped")
                        .with("text", quote(self.text(start)))
                        .with("number", format!("`{head}`"))
                        .fix(write(Applicability::Unsafe, span, head)),
                );
            }
            Diagnosis::BadId { ty } => {
                self.bad_id(start, out);
                let is_render = ty.is_some_and(|ty| ty.kind == RecordKind::Render);
                if is_render
                    && self.text(start) == "0"
                    && let Some(d) = out.pop()
                {
                    let span = self.span(start, start + 1);
                    let fix =
                        Fix::replace("fix-write", Applicability::Unsafe, span, String::from("1"));
                    out.push(d.fix(fix.with("number", quote("1"))));
                }
                if let Some(ty) = ty {
                    self.bad_tokens(ty, start + 2, end, out);
                }
            }
        }
    }

    /// Whether the type of a render record stands in the place of its ID.
    fn is_render(&self, start: usize, end: usize) -> bool {
        let render = RecordType::of(RecordKind::Render);
        let is_long_enough = (end - start) as u64 == 1 + render.arity(0);
        is_long_enough && self.text(start) == render.code.to_string()
    }

    /// The finding that a record begins with its type.
    fn lost_id(&self, start: usize, ty: &RecordType) -> Diagnostic {
        let span = self.stretch.token(start).span();
        let d = Diagnostic::new(Code::E005, span)
            .case("lost")
            .with("type", Value::Term(ty.title))
            .with("number", ty.code.to_string())
            .with("header", header(ty));
        // The render record can only have the ID 1.
        let head = format!("1 {}", ty.code);
        let fix = Fix::replace("fix-write", Applicability::Unsafe, span, head.clone());
        match ty.kind {
            RecordKind::Render => d.fix(fix.with("number", quote(&head))),
            RecordKind::Assignment => d.note("assignment-ids"),
            _ => d,
        }
    }

    /// Reports a token that is wrong wherever it stands. Returns `false` for any other token.
    fn bad_token(&self, i: usize, out: &mut Vec<Diagnostic>) -> bool {
        let token = self.stretch.token(i);
        let text = self.text(i);
        let span = token.span();
        let new = |code| Diagnostic::new(code, span).with("text", quote(text));
        let d = match token.kind() {
            TokenKind::DecimalComma => {
                let point = text.replace(',', ".");
                new(Code::E003)
                    .case("decimal-comma")
                    .with("number", quote(&point))
                    .fix(write(Applicability::Safe, span, point))
            }
            TokenKind::HugeNumber => new(Code::E004),
            TokenKind::MalformedNumber => match repaired(text) {
                Some(r) => {
                    let bare = text.strip_suffix(['°', 'º', '˚']);
                    let is_angle = bare.is_some_and(|x| x.parse::<f64>().is_ok());
                    let d = new(Code::E003).case(if is_angle { "degrees" } else { "" });
                    let fix = write(Applicability::Unsafe, span, r.clone());
                    d.with("number", quote(&r)).fix(fix)
                }
                None => new(Code::E003),
            },
            TokenKind::Word | TokenKind::Quoted => new(Code::E012),
            TokenKind::Invalid if self.is_sign_apart(i) => new(Code::E001).case("sign"),
            TokenKind::Invalid => new(Code::E001),
            _ => return false,
        };
        out.push(d);
        true
    }

    /// Whether a token is a minus that stands apart from the number behind it.
    fn is_sign_apart(&self, i: usize) -> bool {
        i + 1 < self.stretch.len()
            && matches!(self.text(i), "-" | "−" | "–")
            && self.text(i + 1).starts_with(|c: char| c.is_ascii_digit())
            && self.between(i).trim_matches([' ', '\t']).is_empty()
    }

    fn bad_tokens(&self, ty: &RecordType, first: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let name = faults::file_name(self.stretch, ty, first, end);
        if let Some(d) = name.and_then(|name| self.spaced_name(name, end)) {
            out.push(d);
            return;
        }
        let most = ty.params.len() + ty.optional.len();
        let all = || ty.params.iter().chain(ty.optional);
        let is_whole = |p: &&Param| p.kind != ParamKind::FileName && !fits(TokenKind::Real, p.kind);
        for i in (first..end).filter(|&i| Some(i) != name) {
            // A point in the place of the comma makes no whole number of it.
            let param = all().nth(i - first).filter(is_whole);
            if let Some(param) = param
                && self.stretch.token(i).kind() == TokenKind::DecimalComma
            {
                out.push(self.no_integer_for(i, param));
                continue;
            }
            if self.bad_token(i, out)
                && i - first < most
                && let Some(d) = out.pop_if(|d| d.code == Code::E012)
            {
                let is_axis = ["x", "y", "z"].contains(&self.text(i).to_lowercase().as_str());
                // The axis is the record's only parameter.
                let is_alone = ty.kind == RecordKind::Rotation && end - first == 1;
                let case = match is_alone && is_axis {
                    true => "angle",
                    false => "parameter",
                };
                out.push(d.case(case).with("header", header(ty)));
            }
        }
    }

    /// A file name with spaces in it, from token `name` to the end of its record.
    fn spaced_name(&self, name: usize, end: usize) -> Option<Diagnostic> {
        let stretch = self.stretch;
        let dotted = |i: usize| self.text(i).contains('.');
        let word = |i: usize| {
            let kind = stretch.sigs[i].kind;
            kind.is_number() || matches!(kind, TokenKind::Word | TokenKind::MalformedNumber)
        };
        let one_name = end > name + 1
            && stretch.line(name) == stretch.line(end - 1)
            && (name..end).all(word)
            && dotted(end - 1)
            && !(name..end - 1).any(dotted);
        if !one_name {
            return None;
        }
        let span = self.span(name, end);
        let text = &stretch.text()[span.range()];
        let apart = text.contains(['#', '"']);
        (!apart).then(|| {
            let quoted = format!("\"{text}\"");
            Diagnostic::new(Code::E012, span)
                .case("file-name")
                .with("text", quote(text))
                .with("number", quote(&quoted))
                .fix(write(Applicability::Unsafe, span, quoted))
        })
    }

    /// Reports the decimal commas among tokens about which nothing else is reported.
    fn commas(&self, first: usize, end: usize, out: &mut Vec<Diagnostic>) {
        for i in first..end {
            if self.stretch.sigs[i].kind == TokenKind::DecimalComma {
                self.bad_token(i, out);
            }
        }
    }

    /// Reports the parameters of a record that has the right number of them, bad tokens aside.
    fn params(&self, ty: &'static RecordType, first: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let before = out.len();
        self.bad_tokens(ty, first, end, out);
        if out.len() > before {
            return;
        }
        for (i, p) in (first..end).zip(ty.params.iter().chain(ty.optional)) {
            let span = self.stretch.token(i).span();
            if fits(self.stretch.sigs[i].kind, p.kind) {
                continue;
            }
            out.push(if p.kind == ParamKind::FileName {
                Diagnostic::new(Code::E011, span)
                    .with("text", quote(self.text(i)))
                    .with("parameter", Value::Term(p.doc))
            } else {
                self.no_integer_for(i, p)
            });
        }
    }

    /// Reports a type that can be understood though it is not written as an integer.
    fn real_type(&self, start: usize, out: &mut Vec<Diagnostic>) {
        if self.stretch.sigs[start + 1].int.is_none() {
            self.bad_type(start + 1, out);
        }
    }

    fn count(
        &self,
        piece: &RecordCandidate,
        ty: &RecordType,
        got: usize,
        expected: usize,
    ) -> Diagnostic {
        let (start, end) = (piece.start, piece.end);
        let count = |n: usize| Value::Count(n as u64);
        if expected > NUMBERS_MAX {
            let n = piece.start + 2;
            return Diagnostic::new(Code::E013, self.span(n, n + 1))
                .with("text", self.text(n).to_owned())
                .with("got", count(got - 1));
        }
        let row = self.odd_row(piece, ty, got, expected);
        let few = got < expected;
        let (from, to) = row.unwrap_or(match few {
            true => (start, end),
            false => ((start + 2 + expected).min(end - 1), end),
        });
        let d = Diagnostic::new(
            if few { Code::E008 } else { Code::E009 },
            self.span(from, to),
        )
        .with("type", Value::Term(ty.title))
        .with("got", count(got))
        .with("off", count(got.abs_diff(expected)))
        .with("header", header(ty));
        let d = match ty.optional.len() {
            0 => d.with("wanted", count(expected)).with("fewer", "none"),
            all => d
                .with("wanted", count(ty.params.len() + all))
                .with("fewer", ty.params.len().to_string()),
        };
        match (self.points(piece, ty, got), row) {
            (Some(points), _) => {
                let n = self.span(start + 2, start + 3);
                let says = self.text(start + 2).to_owned();
                let d = Diagnostic { span: n, ..d }
                    .case("points")
                    .with("says", says);
                let d = d
                    .with("points", count(points))
                    .with("number", quote(&points.to_string()));
                d.fix(write(Applicability::Unsafe, n, points.to_string()))
            }
            (None, Some(_)) => d.case("row").label(self.span(start, start + 2), "begin"),
            (None, None) if ty.kind == RecordKind::ImageTexture => d.case("file"),
            (None, None) => d,
        }
    }

    fn lost_sign(
        &self,
        piece: &RecordCandidate,
        (ty, meant): (&RecordType, &'static RecordType),
        got: usize,
        expected: usize,
    ) -> Diagnostic {
        let count = |n: usize| Value::Count(n as u64);
        let span = self.span(piece.start + 1, piece.start + 2);
        Diagnostic::new(Code::E008, span)
            .case("sign")
            .with("type", Value::Term(ty.title))
            .with("got", count(got))
            .with("off", count(expected.abs_diff(got)))
            .with("wanted", count(expected))
            .with("fewer", "none")
            .with("meant", Value::Term(meant.title))
            .with("header", header(meant))
            .with("number", quote(&meant.code.to_string()))
            .fix(write(Applicability::Unsafe, span, meant.code.to_string()))
    }

    fn bad_count(&self, ty: &RecordType, start: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let on_line = self.stretch.line(start + 1);
        let Some(n) =
            (start + 2 < end && self.stretch.line(start + 2) == on_line).then_some(start + 2)
        else {
            out.push(
                Diagnostic::new(Code::E008, self.span(start, start + 2))
                    .case("count")
                    .with("type", Value::Term(ty.title))
                    .with("header", header(ty)),
            );
            return;
        };
        if self.bad_token(n, out) {
            return;
        }
        let sig = &self.stretch.sigs[n];
        let new = |code| Diagnostic::new(code, self.stretch.token(n).span()).case("count");
        out.push(match sig.int {
            Some(value) => new(Code::E206)
                .with("type", Value::Term(ty.title))
                .with("value", value.to_string()),
            None if sig.kind == TokenKind::Integer => {
                new(Code::E004).with("text", quote(self.text(n)))
            }
            None => self.not_an_integer(n, "N, the number of profile points,"),
        });
    }

    fn unknown_type(&self, i: usize) -> Diagnostic {
        Diagnostic::new(Code::E007, self.stretch.token(i).span()).with("text", quote(self.text(i)))
    }

    fn bad_type(&self, i: usize, out: &mut Vec<Diagnostic>) {
        let token = self.stretch.token(i);
        match token.kind() {
            TokenKind::Word | TokenKind::Quoted => out.push(
                Diagnostic::new(Code::E006, token.span())
                    .case("word")
                    .with("text", quote(self.text(i)))
                    .with("name", words::explained(self.text(i))),
            ),
            TokenKind::Integer => out.push(self.unknown_type(i)),
            TokenKind::Real => out.push(self.not_an_integer(i, "a record type")),
            _ => {
                self.bad_token(i, out);
            }
        }
    }

    fn missing_type(&self, start: usize) -> Diagnostic {
        Diagnostic::new(Code::E006, self.stretch.token(start).span())
            .with("text", quote(self.text(start)))
    }

    fn bad_id(&self, i: usize, out: &mut Vec<Diagnostic>) {
        let sig = &self.stretch.sigs[i];
        let (text, span) = (self.text(i), self.stretch.token(i).span());
        let new = |code| Diagnostic::new(code, span).with("text", quote(text));
        let d = match sig.kind {
            TokenKind::Integer if sig.int.is_none() && !text.starts_with('-') => {
                new(Code::E004).case("id")
            }
            TokenKind::Integer => new(Code::E005).case("negative"),
            TokenKind::Real => match self.stretch.token(i).number(self.stretch.text()) {
                Some(x) if x.fract() == 0.0 && x > 0.0 => self.no_integer_for_id(i),
                _ => new(Code::E005),
            },
            _ => {
                self.bad_token(i, out);
                return;
            }
        };
        out.push(d);
    }
}

/// A fix that replaces a span by `text`, which the finding quotes as its value `number`.
pub(super) fn write(applicability: Applicability, span: Span, text: String) -> Fix {
    Fix::replace("fix", applicability, span, text)
}

/// The number that a malformed one was likely meant to be: what is left without the characters that
/// spoil it, or the value of a fraction.
fn repaired(text: &str) -> Option<String> {
    if let Some(share) = text.strip_suffix('%') {
        let share = share.parse::<f64>().ok().filter(|x| x.is_finite())?;
        return Some((share / 100.0).to_string());
    }
    if let Some(value) = calculated(text) {
        return Some(value);
    }
    // Between two numbers one of these signs has a meaning, and must not be left out.
    let is_between = |sign: char| text.trim_end_matches(sign).contains(sign);
    if text.contains(['/', '*', '√']) || ['^', ':', '·', '\'', '’'].into_iter().any(is_between)
    {
        let (a, b) = text.split_once('/')?;
        let value = a.parse::<f64>().ok()? / b.parse::<f64>().ok()?;
        return value.is_finite().then(|| value.to_string());
    }
    let plain = text.replace(['−', '–', '—', '‑', '‐'], "-");
    let kept: String = plain
        .chars()
        .filter(|c| c.is_alphanumeric() || "+-.".contains(*c))
        .collect();
    [plain, kept].into_iter().find(|t| {
        t.len() < 40
            && t.parse::<f64>().is_ok_and(f64::is_finite)
            && t.contains(|c: char| c.is_ascii_digit())
    })
}
