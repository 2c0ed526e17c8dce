//! Slips in how numbers and file names are spelled.

use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::characters;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span};
use crate::lint::spelling::decimal;
use crate::syntax::allows;
use crate::syntax::lexer::{SEPARATORS, Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};

/// Words before the point that a camera of other programs looks at.
const LOOK_AT: [&str; 4] = ["look_at", "lookat", "target", "at"];

/// Words before the name of a picture in POV-Ray.
pub(super) const PICTURE: [&str; 5] = ["pigment", "image_map", "png", "jpeg", "jpg"];

fn is_picture_word(word: &str) -> bool {
    PICTURE.contains(&&*word.to_lowercase())
}

/// The title of fixes that write decimal commas as points.
pub(super) const COMMA_TITLE: &str = "fix-decimal-comma";

/// The most places of one decimal comma that are offered as a choice.
const MAX_PLACES: usize = 3;

impl LineContext<'_> {
    /// Guesses that words between the numbers of a record, as in `look_at 0 0 0`, are too many. The point that a camera
    /// looks at becomes a direction.
    pub(super) fn labelled(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        // `rgb(255,0,0)` and `2*pi` are something else.
        let is_word = |t: &Token| {
            let behind = self.text[t.end() as usize..].chars().next();
            t.kind() == TokenKind::Word && behind.is_none_or(char::is_whitespace)
        };
        let is_number = |t: &Token| t.kind().is_number();
        let params = self.params();
        let (words, numbers): (Vec<Token>, Vec<Token>) = params.iter().partition(|t| is_word(t));
        let is_whole = !words.is_empty()
            && numbers.iter().all(is_number)
            && self.fit(ty, &numbers)
            // Words behind all numbers are rather a comment.
            && params.last().is_some_and(is_number);
        let (first, last) = (words.first()?, words.last()?);
        if !is_whole {
            return None;
        }
        let mut edits: Vec<Edit> = (params.windows(2))
            .filter(|two| is_word(&two[0]))
            .map(|two| Edit {
                span: Span::new(two[0].start, two[1].start),
                text: String::new(),
            })
            .collect();
        let written = quote(&self.text[first.span().to(last.span()).range()]);
        let point = params.windows(2).find(|two| {
            let word = two[0].text(self.text).to_lowercase();
            LOOK_AT.contains(&&*word) && Some(two[1].start) == numbers.get(3).map(|t| t.start)
        });
        let is_camera = ty.kind == RecordKind::Camera && point.is_some();
        let number = |i: usize| numbers[i].number(self.text);
        let title = match is_camera {
            true => {
                for (i, of) in (3..6).zip(0..) {
                    edits.push(Edit {
                        span: numbers[i].span(),
                        text: decimal(number(i)? - number(of)?),
                    });
                }
                "fix-labelled-point"
            }
            false => "fix-labelled",
        };
        edits.sort_by_key(|e| e.span.start);
        Some(Candidate::new(
            Habit::Characters,
            Fix {
                title,
                values: vec![("text", written.into())],
                applicability: Applicability::Unsafe,
                edits,
            },
        ))
    }

    /// Rewrites numbers in other characters than those of the language. A unit or dash on its own joins its number.
    pub(super) fn characters(&self, out: &mut Vec<Candidate>) {
        let on_line: Vec<Token> = (self.all.iter())
            .filter(|t| !t.kind().is_trivia())
            .copied()
            .collect();
        let turns = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Rotation);
        let mut new = Vec::new();
        let mut i = 0;
        while i < on_line.len() {
            let joined = |j: usize| {
                let (a, b) = (on_line[i], *on_line.get(j)?);
                let token = Token::new(a.kind(), a.start as usize, b.end() as usize);
                Some((token, a.text(self.text), b.text(self.text)))
            };
            if let Some((token, a, b)) = joined(i + 1) {
                let (a_is_number, b_is_number) = (
                    on_line[i].kind().is_number(),
                    on_line[i + 1].kind().is_number(),
                );
                let text = match () {
                    () if a_is_number && characters::is_unit(b) && b == "%" => {
                        characters::number(&format!("{a}%"))
                    }
                    () if a_is_number && characters::is_unit(b) => characters::number(a),
                    () if characters::is_dash(a) && b_is_number => {
                        characters::number(&format!("-{b}"))
                    }
                    // Czech letters may stand for the digits on a side of a decimal comma.
                    () if !(a_is_number && b_is_number)
                        && token.text(self.text) == format!("{a},{b}") =>
                    {
                        characters::number(token.text(self.text))
                    }
                    () => None,
                };
                if let Some(text) = text {
                    new.push((token, text));
                    i += 2;
                    continue;
                }
            }
            if let Some(moved) = self.point_behind(&on_line, i) {
                new.push(moved);
                i += 2;
                continue;
            }
            let token = on_line[i];
            let is_word = matches!(
                token.kind(),
                TokenKind::MalformedNumber | TokenKind::Word | TokenKind::Invalid
            );
            if is_word {
                let is_bracket = matches!(token.text(self.text), "[" | "]");
                let number = is_bracket.then(String::new);
                let written = token.text(self.text);
                // A sign too many may hide another mistake, if the number without the sign is not allowed here.
                let has_sign_behind = written.ends_with(['.', '-']);
                let number = number
                    .or_else(|| characters::number(written))
                    .filter(|number| !has_sign_behind || self.may_stand(i, number));
                let is_angle = i == 2 && turns;
                match number.or_else(|| characters::degrees(written).filter(|_| is_angle)) {
                    Some(text) => new.push((token, text)),
                    // A word that is no number is another fault, which this guess does not repair.
                    None if i != 1 => return,
                    None => {}
                }
            }
            i += 1;
        }
        let key = new
            .iter()
            .find_map(|(token, _)| characters::czech_key(token.text(self.text)));
        let written = self.write(Habit::Characters, &new);
        out.extend(written.map(|mut written| {
            if let Some((key, digit)) = key {
                written.fix.title = "fix-czech-key";
                let names = [
                    ("key", quote(&key.to_string())),
                    ("digit", digit.to_string()),
                ];
                written
                    .fix
                    .values
                    .extend(names.map(|(place, text)| (place, text.into())));
            }
            written
        }));
    }

    /// Joins two numbers of which the first has the point of the second at its end: `.2. 1` is `.2 .1`. All other
    /// numbers of the record must have points.
    fn point_behind(&self, on_line: &[Token], i: usize) -> Option<(Token, String)> {
        let text = |t: &Token| t.text(self.text);
        let (first, second) = (on_line.get(i)?, on_line.get(i + 1)?);
        let number = text(first).strip_suffix('.').filter(|n| n.contains('.'))?;
        let is_plain = number.parse().is_ok_and(f64::is_finite);
        let digits = Some(text(second)).filter(|t| t.bytes().all(|c| c.is_ascii_digit()))?;
        let is_between = self.is_gap(Span::new(first.end(), second.start));
        let others = (on_line.iter().enumerate().skip(2)).filter(|(j, _)| *j != i && *j != i + 1);
        let mut others = others.map(|(_, t)| text(t).contains('.')).peekable();
        let have_points = others.peek().is_some() && others.all(|has| has);
        let is_one = i > 1 && is_plain && is_between && have_points;
        is_one.then(|| (self.joined(first, second), format!("{number} .{digits}")))
    }

    /// Whether a number is allowed as a token of the line; `place` 0 is the ID and 1 the type. Parts of colours are not
    /// above 1.
    fn may_stand(&self, place: usize, number: &str) -> bool {
        let (Some(ty), Some(i)) = (self.ty(), place.checked_sub(2)) else {
            return true;
        };
        let count = self.params().first().and_then(|t| t.integer(self.text));
        let count = count.and_then(|n| usize::try_from(n).ok());
        // The count of a profile is not larger than the number of parameters.
        let count = count.map_or(0, |n| n.min(self.params().len()));
        let is_colour = ty.first_colour(count).is_some_and(|first| i >= first);
        ty.param(i, count).is_none_or(|param| {
            let fits = |x: f64| allows(param, x) && !(is_colour && x > 1.0);
            number.parse().is_ok_and(fits)
        })
    }

    /// Square roots as functions, `sqrt(2)`, which may be divided: `sqrt(2)/2`, `1/sqrt(2)`.
    pub(super) fn square_roots(&self) -> Option<Candidate> {
        let text = |i: usize| self.all.get(i).map_or("", |t| t.text(self.text));
        let mut new = Vec::new();
        for (i, word) in self.all.iter().enumerate() {
            let Some(before) = word.text(self.text).strip_suffix("sqrt") else {
                continue;
            };
            if (text(i + 1), text(i + 3)) != ("(", ")") {
                continue;
            }
            let root = text(i + 2).parse::<f64>().ok()?.sqrt();
            let close = self.all[i + 3];
            let behind = self.all.get(i + 4).filter(|t| t.start == close.end());
            let divisor = behind.and_then(|t| t.text(self.text).strip_prefix('/'));
            let part = match divisor {
                Some(divisor) => root / divisor.parse::<f64>().ok()?,
                None => root,
            };
            let number = match before {
                "" => part,
                "-" => -part,
                "1/" => 1.0 / part,
                "-1/" => -1.0 / part,
                _ => return None,
            };
            let last = behind.filter(|_| divisor.is_some()).unwrap_or(&close);
            new.push((self.joined(word, last), decimal(number)));
        }
        let is_finite = |(_, text): &(Token, String)| text.parse().is_ok_and(f64::is_finite);
        new.iter()
            .all(is_finite)
            .then(|| self.write(Habit::Characters, &new))?
    }

    /// The tokens of a picture's file name: all up to the first that ends as the name of a picture does.
    pub(super) fn file_name(&self) -> Option<&[Token]> {
        if self.ty()?.kind != RecordKind::ImageTexture {
            return None;
        }
        let last = self.params().iter().position(|t| self.ends_picture(t))?;
        Some(&self.params()[..=last])
    }

    /// Whether a token ends as the name of a picture does.
    pub(super) fn ends_picture(&self, t: &Token) -> bool {
        let name = t.text(self.text).trim_end_matches('"').to_lowercase();
        [".png", ".jpg", ".jpeg"].iter().any(|e| name.ends_with(e))
    }

    /// The type of an image texture where the name of a picture is all that stands behind another type of texture.
    pub(super) fn image_type(&self) -> Option<Candidate> {
        let [name] = self.params() else { return None };
        let image = RecordType::of(RecordKind::ImageTexture);
        let is_other =
            (self.ty()).is_some_and(|ty| ty.effect == image.effect && ty.code != image.code);
        (is_other && self.ends_picture(name)).then(|| self.write_type(Habit::Digit, image))
    }

    /// The name of a picture without the words that POV-Ray has before it: `image_map { png "moon.png" }`.
    pub(super) fn named_picture(&self) -> Option<Candidate> {
        let all = self
            .file_name()
            .filter(|all| all.len() == self.params().len())?;
        let name = self.picture_name(all)?;
        let (first, last) = (all.first()?, all.last()?);
        let whole = self.joined(first, last);
        is_picture_word(first.text(self.text))
            .then(|| self.write(Habit::Characters, &[(whole, name)]))?
    }

    /// The name of a picture behind words of POV-Ray, in quotes where it needs them.
    pub(super) fn picture_name(&self, all: &[Token]) -> Option<String> {
        let is_word = |t: &&Token| is_picture_word(t.text(self.text));
        let words = all.iter().take_while(is_word).count();
        let (first, last) = (all.get(words)?, all.last()?);
        let name = self.text[first.span().to(last.span()).range()].replace('"', "");
        let is_plain =
            !name.contains(|c: char| c.is_whitespace() || SEPARATORS.contains(&c) || c == '#');
        Some(match is_plain {
            true => name,
            false => format!("\"{name}\""),
        })
    }

    /// A file name with spaces in it, which belongs in quotes.
    pub(super) fn spaced_name(&self, out: &mut Vec<Candidate>) {
        let Some([first, .., last]) = self.file_name() else {
            return;
        };
        let span = first.span().to(last.span());
        let name = format!("\"{}\"", self.text[span.range()].replace('"', ""));
        out.push(Candidate::writing(Habit::Characters, span, name));
    }

    /// Guesses at decimal commas with a space behind them, `0, 9`, where there are too many numbers. If several commas
    /// may be the decimal one, each is a choice.
    pub(super) fn spaced_commas(&self, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty() else { return };
        let params = self.params();
        let Some(more) = params.len().checked_sub(self.wanted(ty)).filter(|&n| n > 0) else {
            return;
        };
        let text = |t: &Token| t.text(self.text);
        let is_digits = |t: &Token| text(t).bytes().all(|c| c.is_ascii_digit());
        let is_pair = |two: &[Token]| {
            let between = &self.text[two[0].end() as usize..two[1].start as usize];
            let is_comma = between
                .strip_prefix(',')
                .is_some_and(|s| s.trim().is_empty());
            is_comma && two[0].integer(self.text).is_some() && is_digits(&two[1])
        };
        let pairs: Vec<&[Token]> = params.windows(2).filter(|two| is_pair(two)).collect();
        let is_apart = pairs.windows(2).all(|p| p[0][1].start < p[1][0].start);
        // If all numbers have commas without spaces between them, and are twice as many as they should be, every other
        // comma is decimal.
        let is_tight = |two: &[Token]| two[0].end() + 1 == two[1].start;
        let every_other = params.chunks_exact(2).filter(|two| is_pair(two));
        let is_list = params.len() == 2 * more
            && pairs.len() + 1 == params.len()
            && pairs.iter().all(|two| is_tight(two));
        let choices: Vec<Vec<&[Token]>> = match pairs.len() {
            _ if is_list => vec![every_other.collect()],
            n if n == more && is_apart => vec![pairs],
            2..=MAX_PLACES if more == 1 => pairs.into_iter().map(|pair| vec![pair]).collect(),
            _ => return,
        };
        let applicability = match choices.len() {
            1 => Applicability::Unsafe,
            _ => Applicability::Choice,
        };
        for pairs in choices {
            let new: Vec<(Token, String)> = (pairs.iter())
                .map(|two| {
                    let number = format!("{}.{}", text(&two[0]), text(&two[1]));
                    (self.joined(&two[0], &two[1]), number)
                })
                .collect();
            let all = new[0].0.span().to(new[new.len() - 1].0.span());
            let Some(mut candidate) = self.write(Habit::Doubled, &new) else {
                continue;
            };
            candidate.fix.title = COMMA_TITLE;
            candidate.fix.applicability = applicability;
            candidate.fix = candidate.fix.with("text", quote(&self.text[all.range()]));
            // Other commas that were read as decimal ones become points, too.
            let commas = params
                .iter()
                .filter(|t| t.kind() == TokenKind::DecimalComma);
            candidate.fix.edits.extend(commas.map(|t| Edit {
                span: t.span(),
                text: text(t).replace(',', "."),
            }));
            candidate.fix.edits.sort_by_key(|e| e.span.start);
            out.push(candidate);
        }
    }

    /// Guesses at spaces beside decimal points, `-0. 35` or `0 .8`, where there are as many of them as surplus numbers.
    pub(super) fn spaced_points(&self) -> Option<Candidate> {
        let ty = self.ty()?;
        let params = self.params();
        let more = params
            .len()
            .checked_sub(self.wanted(ty))
            .filter(|&n| n > 0)?;
        let is_digits = |text: &str| text.bytes().all(|c| c.is_ascii_digit());
        let is_pair = |two: &&[Token]| {
            let [a, b] = [0, 1].map(|i| two[i].text(self.text));
            let is_behind = a.ends_with('.') && is_digits(b);
            let is_before = two[0].integer(self.text).is_some() && b.starts_with('.');
            let between = &self.text[two[0].end() as usize..two[1].start as usize];
            (is_behind || is_before) && between.chars().all(|c| c == ' ')
        };
        let pairs: Vec<&[Token]> = params.windows(2).filter(is_pair).collect();
        let new = pairs.iter().map(|two| {
            let number = [0, 1].map(|i| two[i].text(self.text)).concat();
            (self.joined(&two[0], &two[1]), number)
        });
        let new: Vec<(Token, String)> = new.collect();
        let is_number = |(_, text): &(Token, String)| text.parse().is_ok_and(f64::is_finite);
        let is_one = pairs.len() == more && new.iter().all(is_number);
        is_one.then(|| self.write(Habit::Doubled, &new))?
    }

    /// One token from the start of the first to the end of the last.
    pub(super) fn joined(&self, first: &Token, last: &Token) -> Token {
        Token::new(first.kind(), first.start as usize, last.end() as usize)
    }

    /// Guesses that a record has one reference too many, or a space within a reference. The parser can read such a
    /// record if its last number is a `0`, which then introduces a comment.
    pub(super) fn surplus(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let params = self.params();
        let one_more = |ty: &&RecordType| !ty.is_counted() && params.len() == ty.params.len() + 1;
        let is_reference = matches!(finding.code, Code::E101 | Code::E103);
        if self.ty().filter(one_more).is_none() || !is_reference {
            return;
        }
        let only_space_between = |two: &&[Token]| {
            let between = &self.text[two[0].end() as usize..two[1].start as usize];
            between.trim().is_empty()
        };
        for two in params.windows(2).filter(only_space_between) {
            let [first, last] = [0, 1].map(|i| two[i].text(self.text));
            let both = Token::new(two[0].kind(), two[0].start as usize, two[1].end() as usize);
            for new in [last.to_owned(), format!("{first}{last}")] {
                out.extend(self.write(Habit::Doubled, &[(both, new)]));
            }
        }
    }
}
