//! Findings of the parser: what is wrong with the broken pieces of a text, in words.

use super::faults::{self, Verdict};
use super::layout::Piece;
use super::lexer::{Token, TokenKind};
use super::reader::fits;
use super::stream::Stream;
use super::table::{ParamKind, RecordType};
use super::witness::Witnesses;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span};

/// The most numbers that one record may claim to have.
const NUMBERS_MAX: usize = 100_000_000;

/// The longest stretch of the user's text that a message quotes, in characters.
const QUOTE_MAX: usize = 24;

/// A token's text for a message: shortened, control characters made visible.
pub fn quote(text: &str) -> String {
    let mut out: String = text
        .chars()
        .take(QUOTE_MAX)
        .flat_map(|c| {
            if c.is_control() {
                c.escape_default().collect::<Vec<_>>()
            } else {
                vec![c]
            }
        })
        .collect();
    if text.chars().nth(QUOTE_MAX).is_some() {
        out.push('…');
    }
    format!("`{out}`")
}

/// "1 number", "3 numbers".
fn numbers(n: usize) -> String {
    format!("{n} number{}", if n == 1 { "" } else { "s" })
}

fn header(ty: &RecordType) -> String {
    match ty.signature() {
        s if s.is_empty() => format!("`ID {}`", ty.code),
        s => format!("`ID {} {s}`", ty.code),
    }
}

/// The comments that nobody closes.
pub fn comments(text: &str, tokens: &[Token], out: &mut Vec<Diagnostic>) {
    for t in tokens {
        if t.kind == TokenKind::UnterminatedComment {
            let end = t.start + t.text(text).trim_end().len() as u32;
            out.push(
                Diagnostic::new(
                    Code::E002,
                    Span::new(t.start, end.max(t.start + 1)),
                    "this comment is never closed",
                )
                .here("it is taken to end with its line")
                .help("close the comment with `#`")
                .fix(Fix::replace(
                    "close the comment at the end of the line",
                    Applicability::Safe,
                    Span::new(end, end),
                    " #",
                )),
            );
        }
    }
}

/// Reports everything that is wrong with the pieces of a text.
pub fn pieces(stream: &Stream, witnesses: &Witnesses, all: &[Piece], out: &mut Vec<Diagnostic>) {
    let reporter = Reporter { stream };
    for piece in all {
        match piece.verdict {
            Verdict::Void => {}
            Verdict::Whole(r) => {
                let last = stream.line(r.end - 1);
                if witnesses.is_complete_line(stream, last)
                    && witnesses.takes_over(stream, piece.start, r.end)
                {
                    out.push(reporter.line_break(piece, r.ty));
                }
            }
            _ => reporter.broken(piece, out),
        }
    }
}

struct Reporter<'a, 's> {
    stream: &'a Stream<'s>,
}

impl Reporter<'_, '_> {
    fn span(&self, start: usize, end: usize) -> Span {
        let last = self.stream.token(end.max(start + 1) - 1);
        self.stream.token(start).span().to(last.span())
    }

    fn text(&self, i: usize) -> &str {
        self.stream.token(i).text(self.stream.text)
    }

    fn line_break(&self, piece: &Piece, ty: &RecordType) -> Diagnostic {
        let last = self.stream.line(piece.end - 1);
        let head = self.stream.line_start(last);
        let line_end = self.stream.line_end(last);
        Diagnostic::new(
            Code::W314,
            self.span(head, piece.end),
            format!(
                "this {} takes its last numbers from a line that would be a record of its own",
                ty.title
            ),
        )
        .here("taken from the head of this line")
        .label(self.span(piece.start, head), "the record begins here")
        .note(format!(
            "by itself the line would read {}",
            quote(&self.stream.text[self.span(head, line_end).range()])
        ))
        .help(format!(
            "if a number is missing above, add it: {}",
            header(ty)
        ))
    }

    fn broken(&self, piece: &Piece, out: &mut Vec<Diagnostic>) {
        let (start, end) = (piece.start, piece.end);
        match piece.verdict {
            Verdict::Void | Verdict::Whole(_) | Verdict::CutOff { .. } => {}
            Verdict::Damaged { ty } => {
                self.real_type(start, out);
                self.params(ty, start + 2, end, out);
            }
            Verdict::Count { ty, got, expected } => {
                self.real_type(start, out);
                self.bad_tokens(ty, start + 2, end, out);
                out.push(self.count(piece, ty, got, expected));
            }
            Verdict::BadCount { ty } => {
                self.real_type(start, out);
                self.bad_count(ty, start, end, out);
            }
            Verdict::UnknownType => out.push(
                Diagnostic::new(
                    Code::E007,
                    self.stream.token(start + 1).span(),
                    format!("there is no record type {}", quote(self.text(start + 1))),
                )
                .here("unknown type"),
            ),
            Verdict::BadType => self.bad_type(start + 1, out),
            Verdict::MissingType => out.push(self.missing_type(start)),
            Verdict::LostId { ty } => out.push(
                Diagnostic::new(
                    Code::E005,
                    self.stream.token(start).span(),
                    format!("this {} has no ID", ty.title),
                )
                .here(format!(
                    "this is the type, {}; an ID belongs in front of it",
                    ty.code
                ))
                .help(format!("{} is written {}", ty.with_article(), header(ty))),
            ),
            Verdict::BadId { ty } => {
                self.bad_id(start, out);
                if let Some(ty) = ty {
                    self.bad_tokens(ty, start + 2, end, out);
                }
            }
        }
    }

    /// A token that can be nothing at all, reported by its own form. `false` if it is none.
    fn bad_token(&self, i: usize, out: &mut Vec<Diagnostic>) -> bool {
        let token = self.stream.token(i);
        let text = self.text(i);
        let span = token.span();
        let d = match token.kind {
            TokenKind::DecimalComma => {
                let point = text.replace(',', ".");
                Diagnostic::new(
                    Code::E003,
                    span,
                    format!("{} has a decimal comma", quote(text)),
                )
                .here(format!("read as {}", quote(&point)))
                .help("numbers are written with a decimal point")
                .fix(Fix::replace(
                    format!("write {}", quote(&point)),
                    Applicability::Safe,
                    span,
                    point,
                ))
            }
            TokenKind::HugeNumber => {
                Diagnostic::new(Code::E004, span, format!("{} is too large", quote(text)))
                    .here("no double-precision number is that large")
                    .help("the largest is about 1.8e308")
            }
            TokenKind::MalformedNumber => {
                let d =
                    Diagnostic::new(Code::E003, span, format!("{} is not a number", quote(text)))
                        .here("malformed number")
                        .help("numbers look like `3`, `-0.5` or `1.5e-3`");
                match repaired(text) {
                    Some(r) => d.fix(Fix::replace(
                        format!("write {}", quote(&r)),
                        Applicability::Unsafe,
                        span,
                        r,
                    )),
                    None => d,
                }
            }
            TokenKind::Word | TokenKind::Quoted => Diagnostic::new(
                Code::E012,
                span,
                format!("the word {} means nothing here", quote(text)),
            )
            .here("a number was expected")
            .help("comments stand between two `#`"),
            TokenKind::Invalid => Diagnostic::new(
                Code::E001,
                span,
                format!("{} means nothing here", quote(text)),
            )
            .here("a number was expected")
            .help("remove it, or put it into a comment: `# … #`"),
            _ => return false,
        };
        out.push(d);
        true
    }

    fn bad_tokens(&self, ty: &RecordType, first: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let name = faults::file_name(self.stream, ty, first, end);
        for i in (first..end).filter(|&i| Some(i) != name) {
            self.bad_token(i, out);
        }
    }

    /// Parameters of a record with the right number of them (but for bad tokens).
    fn params(&self, ty: &'static RecordType, first: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let before = out.len();
        self.bad_tokens(ty, first, end, out);
        if out.len() > before {
            return;
        }
        for (i, p) in (first..end).zip(ty.params.iter().chain(ty.optional)) {
            let span = self.stream.token(i).span();
            if fits(self.stream.sigs[i].kind, p.kind) {
                continue;
            }
            out.push(if p.kind == ParamKind::FileName {
                Diagnostic::new(
                    Code::E011,
                    span,
                    format!("{} is no file name", quote(self.text(i))),
                )
                .here(format!("{} was expected", p.doc))
                .help("a file name is one word, or stands in double quotes")
            } else {
                self.not_an_integer(i, p.doc)
            });
        }
    }

    fn not_an_integer(&self, i: usize, what: &str) -> Diagnostic {
        let (text, span) = (self.text(i), self.stream.token(i).span());
        let d = Diagnostic::new(
            Code::E010,
            span,
            format!("{} is not an integer", quote(text)),
        )
        .here(format!(
            "{what} must be a whole number, written without a point"
        ));
        let value = self.stream.token(i).number(self.stream.text);
        match value.filter(|x| x.fract() == 0.0 && x.abs() < 1e15) {
            Some(x) => {
                let whole = format!("{}", x as i64);
                d.fix(Fix::replace(
                    format!("write {}", quote(&whole)),
                    Applicability::Safe,
                    span,
                    whole,
                ))
            }
            None => d,
        }
    }

    /// Reports a type that can be understood though it is not written as an integer.
    fn real_type(&self, start: usize, out: &mut Vec<Diagnostic>) {
        if self.stream.sigs[start + 1].int.is_none() {
            self.bad_type(start + 1, out);
        }
    }

    fn count(&self, piece: &Piece, ty: &RecordType, got: usize, expected: usize) -> Diagnostic {
        let (start, end) = (piece.start, piece.end);
        let row = self.odd_row(piece, ty, got, expected);
        let wanted = match ty.params.len() + ty.optional.len() {
            _ if ty.optional.is_empty() => numbers(expected),
            all => format!("{} or {}", ty.params.len(), numbers(all)),
        };
        let title = capitalised(ty.title);
        if expected > NUMBERS_MAX {
            let n = piece.start + 2;
            return Diagnostic::new(
                Code::E013,
                self.span(n, n + 1),
                format!("{} points are more than can be handled", self.text(n)),
            )
            .here(format!(
                "N, the number of points; {} follow",
                numbers(got - 1)
            ));
        }
        let mut d = if got < expected {
            let (from, to) = row.unwrap_or((start, end));
            Diagnostic::new(
                Code::E008,
                self.span(from, to),
                format!(
                    "too few numbers: {} takes {wanted}, here are {got}",
                    ty.with_article()
                ),
            )
            .here(match row {
                Some(_) => "this line has fewer than the others".to_owned(),
                None => format!("{} missing", numbers(expected - got)),
            })
        } else {
            let (from, to) = row.unwrap_or(((start + 2 + expected).min(end - 1), end));
            Diagnostic::new(
                Code::E009,
                self.span(from, to),
                format!(
                    "too many numbers: {} takes {wanted}, here are {got}",
                    ty.with_article()
                ),
            )
            .here(match row {
                Some(_) => "this line has more than the others".to_owned(),
                None => format!("{} too many", numbers(got - expected)),
            })
        };
        if row.is_some() {
            d = d.label(
                self.span(start, start + 2),
                format!("the {} begins here", ty.title),
            );
        }
        d.help(format!("{title}: {}", header(ty)))
    }

    /// In a record laid out over lines: the line whose length deviates from the others by just what
    /// the whole record deviates.
    fn odd_row(
        &self,
        piece: &Piece,
        ty: &RecordType,
        got: usize,
        expected: usize,
    ) -> Option<(usize, usize)> {
        let stream = self.stream;
        let (first, last) = (stream.line(piece.start), stream.line(piece.end - 1));
        if first == last {
            return None;
        }
        // The numbers of the head line behind ID, type and count.
        let head = piece.start + 2 + usize::from(ty.is_counted());
        let rows: Vec<(usize, usize)> = (first..=last)
            .map(|l| {
                let from = if l == first {
                    head
                } else {
                    stream.line_start(l)
                };
                let to = stream.line_end(l).min(piece.end);
                (from.min(to), to)
            })
            .collect();
        let off = got as i64 - expected as i64;
        let lengths: Vec<i64> = rows.iter().map(|r| (r.1 - r.0) as i64).collect();
        if lengths[0] == off && off > 0 {
            return Some((piece.start, rows[0].1));
        }
        // How uneven the table is with row `r` put right: how often the length changes from row to
        // row (a short last row is none), and whether points and colours part at a row's end.
        let points = ty.repeats.first().map_or(0, |g| g.len() as i64);
        let points = points * stream.sigs[(head - 1).min(piece.end - 1)].int.unwrap_or(0) as i64;
        let uneven = |r: usize| {
            let right = |i: usize| lengths[i] - if i == r { off } else { 0 };
            let begin = usize::from(lengths[0] == 0);
            let changes = (begin + 1..lengths.len())
                .filter(|&i| {
                    let (before, now) = (right(i - 1), right(i));
                    now > before || now < before && i + 1 < lengths.len()
                })
                .count();
            let mut sum = 0;
            let parted = (0..lengths.len()).any(|i| {
                sum += right(i);
                sum == points
            });
            let mut distinct: Vec<i64> = (begin..lengths.len()).map(right).collect();
            distinct.sort_unstable();
            distinct.dedup();
            (!parted, changes, distinct.len(), r + 1 == lengths.len())
        };
        let first_row = usize::from(lengths[0] == 0);
        let best = (first_row..rows.len())
            .filter(|&r| lengths[r] - off > 0)
            .min_by_key(|&r| uneven(r))?;
        let from = stream.line_start(first + best).max(piece.start);
        Some((from, rows[best].1))
    }

    fn bad_count(&self, ty: &RecordType, start: usize, end: usize, out: &mut Vec<Diagnostic>) {
        let on_line = self.stream.line(start + 1);
        let Some(n) =
            (start + 2 < end && self.stream.line(start + 2) == on_line).then_some(start + 2)
        else {
            out.push(
                Diagnostic::new(
                    Code::E008,
                    self.span(start, start + 2),
                    format!("this {} has no number of points", ty.title),
                )
                .here("N is missing behind the type")
                .help(format!("{}: {}", capitalised(ty.title), header(ty))),
            );
            return;
        };
        if self.bad_token(n, out) {
            return;
        }
        let sig = &self.stream.sigs[n];
        out.push(match sig.int {
            Some(value) => Diagnostic::new(
                Code::E206,
                self.stream.token(n).span(),
                format!("{} cannot have {value} points", ty.with_article()),
            )
            .here("N, the number of profile points, must be at least 2"),
            None if sig.kind == TokenKind::Integer => Diagnostic::new(
                Code::E004,
                self.stream.token(n).span(),
                format!(
                    "{} points are more than any file can hold",
                    quote(self.text(n))
                ),
            )
            .here("N, the number of profile points"),
            None => self.not_an_integer(n, "N, the number of profile points,"),
        });
    }

    fn bad_type(&self, i: usize, out: &mut Vec<Diagnostic>) {
        let token = self.stream.token(i);
        match token.kind {
            TokenKind::Word | TokenKind::Quoted => out.push(
                Diagnostic::new(
                    Code::E006,
                    token.span(),
                    format!("{} is no record type", quote(self.text(i))),
                )
                .here("a type number was expected")
                .help("`zpg explain` with a name, such as `zpg explain sphere`, tells the number of a type"),
            ),
            TokenKind::Integer => out.push(
                Diagnostic::new(
                    Code::E007,
                    token.span(),
                    format!("there is no record type {}", quote(self.text(i))),
                )
                .here("unknown type"),
            ),
            TokenKind::Real => out.push(self.not_an_integer(i, "a record type")),
            _ => {
                self.bad_token(i, out);
            }
        }
    }

    fn missing_type(&self, start: usize) -> Diagnostic {
        Diagnostic::new(
            Code::E006,
            self.stream.token(start).span(),
            format!("there is no type behind the ID {}", quote(self.text(start))),
        )
        .here("a record type was expected behind this ID")
        .help("a record is `ID TYPE parameters…`")
    }

    fn bad_id(&self, i: usize, out: &mut Vec<Diagnostic>) {
        let sig = &self.stream.sigs[i];
        let (text, span) = (self.text(i), self.stream.token(i).span());
        let expected = |why: &str| {
            Diagnostic::new(Code::E005, span, format!("{} cannot be an ID", quote(text)))
                .here(why.to_owned())
                .help("a record begins with its ID, a whole number from 1 to 2147483647")
        };
        let d = match sig.kind {
            TokenKind::Integer if sig.int.is_none() && !text.starts_with('-') => Diagnostic::new(
                Code::E004,
                span,
                format!("the ID {} is too large", quote(text)),
            )
            .here("IDs go up to 2147483647"),
            TokenKind::Integer => expected("IDs are positive"),
            TokenKind::Real => match self.stream.token(i).number(self.stream.text) {
                Some(x) if x.fract() == 0.0 && x > 0.0 => self.not_an_integer(i, "an ID"),
                _ => expected("an ID was expected here"),
            },
            _ => {
                self.bad_token(i, out);
                return;
            }
        };
        out.push(d);
    }
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map(|c| c.to_uppercase().collect::<String>() + chars.as_str())
        .unwrap_or_default()
}

/// A malformed number without the characters that spoil it, where a number is left.
fn repaired(text: &str) -> Option<String> {
    let plain = text.replace(['−', '–'], "-");
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
