//! Tokens that may be two numbers: `0,5` has a decimal comma, or the separator of the handout's notation of points;
//! `0-1` and `1.2.3` may have lost a space. A token is read as two numbers if the record on the line then has as many
//! numbers as it takes, and has not if each token is one number. In the same way `(0,5; 1)`, where the comma is a
//! separator at first sight, may be two numbers instead of three.

use super::super::ast::{Broken, Fault, Item};
use super::super::commas::pairs;
use super::super::lexed::Lexed;
use super::super::lexer::{self, Token, TokenKind};
use super::super::quote::quote;
use super::super::table::{ParamKind, RecordType};
use super::stretch::MIN_LONG_PARAMS;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span};

/// A way to read a line: which tokens are cut into several numbers, and whether pairs of tokens are joined to one.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Split {
    commas: bool,
    glued: bool,
    /// Whether commas between digits that were taken for separators are decimal commas.
    joined: bool,
}

const AS_IT_STANDS: Split = Split {
    commas: false,
    glued: false,
    joined: false,
};

const JOINED: Split = Split {
    joined: true,
    ..AS_IT_STANDS
};

/// The other ways to read, the likeliest first.
const SPLITS: [Split; 4] = [
    Split {
        commas: true,
        ..AS_IT_STANDS
    },
    Split {
        glued: true,
        ..AS_IT_STANDS
    },
    Split {
        commas: true,
        glued: true,
        joined: false,
    },
    JOINED,
];

impl Split {
    fn takes(self, kind: TokenKind) -> bool {
        kind == TokenKind::DecimalComma && self.commas
            || kind == TokenKind::MalformedNumber && self.glued
    }
}

/// Reads the tokens of a text anew. Also returns the spans of the words that are several numbers without a space
/// between them.
pub(crate) fn respell(text: &str, tokens: Vec<Token>) -> (Vec<Token>, Vec<Span>) {
    let may_be_two = |t: &Token| {
        t.kind() == TokenKind::DecimalComma
            || t.kind() == TokenKind::MalformedNumber && parts(text, t).is_some()
    };
    let pairs: Vec<Token> = pairs(text, &tokens).collect();
    if pairs.is_empty() && !tokens.iter().any(may_be_two) {
        return (tokens, Vec::new());
    }
    let lines = Lines::new(text, &tokens, &pairs);
    let splits = lines.splits();
    let mut out = Vec::with_capacity(tokens.len() + 16);
    let mut glued = Vec::new();
    let mut line = 0;
    for (i, t) in tokens.iter().enumerate() {
        while lines.ends.get(line).is_some_and(|&end| end <= i) {
            line += 1;
        }
        let split = splits.get(line).copied().unwrap_or(AS_IT_STANDS);
        if split.takes(t.kind())
            && t.kind() == TokenKind::MalformedNumber
            && parts(text, t).is_some()
        {
            glued.push(t.span());
        }
        out.extend(lines.read(t, split));
    }
    (out, glued)
}

/// Whether there is any [pair](pairs).
pub(crate) fn has_pair(text: &str, lexed: &Lexed) -> bool {
    lexed.has_separator && pairs(text, &lexed.tokens).next().is_some()
}

/// The numbers a token can be taken apart to, with the comma between them.
fn parts(text: &str, token: &Token) -> Option<Vec<Token>> {
    let word = token.text(text);
    let cuts: Vec<usize> = match token.kind() {
        TokenKind::DecimalComma => {
            let comma = word.find(',')?;
            vec![comma, comma + 1]
        }
        TokenKind::MalformedNumber => cuts(word)?,
        _ => return None,
    };
    let mut start = 0;
    let mut out = Vec::with_capacity(cuts.len() + 1);
    for end in cuts.into_iter().chain([word.len()]) {
        let [t] = lexer::lex(&word[start..end], &[])[..] else {
            return None;
        };
        let at = token.start as usize;
        out.push(Token::new(t.kind(), at + start, at + end));
        start = end;
    }
    let number = |t: &Token| t.kind().is_number() || t.kind() == TokenKind::Separator;
    out.iter().all(number).then_some(out)
}

/// The starts of the second number of a word, and of the third, if the word is nothing but numbers.
fn cuts(word: &str) -> Option<Vec<usize>> {
    let mut at = 0;
    let mut out = Vec::new();
    while at < word.len() {
        if at > 0 {
            out.push(at);
        }
        at += number_length(&word.as_bytes()[at..])?;
    }
    (!out.is_empty() && out.len() <= PARTS_MAX).then_some(out)
}

/// The most places at which one word is cut.
const PARTS_MAX: usize = 20;

/// The length of the longest number that a word begins with.
fn number_length(word: &[u8]) -> Option<usize> {
    let digits = |from: usize| {
        word[from..]
            .iter()
            .take_while(|c| c.is_ascii_digit())
            .count()
    };
    let sign = |at: usize| usize::from(word.get(at).is_some_and(|c| b"+-".contains(c)));
    let mut at = sign(0);
    let whole = digits(at);
    at += whole;
    if word.get(at) == Some(&b'.') {
        let fraction = digits(at + 1);
        if whole + fraction == 0 {
            return None;
        }
        at += 1 + fraction;
    } else if whole == 0 {
        return None;
    }
    if word.get(at).is_some_and(|c| b"eE".contains(c)) {
        let from = at + 1 + sign(at + 1);
        let exponent = digits(from.min(word.len()));
        if exponent > 0 {
            at = from + exponent;
        }
    }
    Some(at)
}

/// The significant tokens, line by line.
struct Lines<'a> {
    text: &'a str,
    tokens: &'a [Token],
    /// The pairs of integers that [`pairs`] finds.
    pairs: &'a [Token],
    /// For each line the index behind its last token, trivia counted.
    ends: Vec<usize>,
    /// For each way to read, how many numbers stand before each line and before the end.
    before: Vec<(Split, Vec<u64>)>,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str, tokens: &'a [Token], pairs: &'a [Token]) -> Lines<'a> {
        let newline = |(_, t): &(usize, &Token)| t.kind() == TokenKind::Newline;
        let ends = tokens.iter().enumerate().filter(newline);
        let ends = ends.map(|(i, _)| i + 1).chain([tokens.len()]).collect();
        let mut lines = Lines {
            text,
            tokens,
            pairs,
            ends,
            before: Vec::new(),
        };
        let before = |split: Split| {
            let width = |t: &Token| lines.numbers(t, split).len() as u64;
            let mut sum = 0;
            let sums = (0..lines.ends.len()).map(|l| {
                sum += lines.line(l).map(width).sum::<u64>();
                sum
            });
            (split, [0].into_iter().chain(sums).collect())
        };
        let before = [AS_IT_STANDS]
            .iter()
            .chain(&SPLITS)
            .map(|&s| before(s))
            .collect();
        lines.before = before;
        lines
    }

    fn line(&self, line: usize) -> impl Iterator<Item = &'a Token> {
        let start = line.checked_sub(1).map_or(0, |l| self.ends[l]);
        let significant = |t: &&Token| !t.kind().is_trivia();
        self.tokens[start..self.ends[line]]
            .iter()
            .filter(significant)
    }

    /// The tokens that a token is read as: itself, its parts, or the pair that begins with it. Empty for the other
    /// tokens of a pair.
    fn read(&self, token: &Token, split: Split) -> Vec<Token> {
        let pair = match split.joined {
            true => self
                .pairs
                .get(self.pairs.partition_point(|p| p.end() <= token.start)),
            false => None,
        };
        match pair.filter(|pair| pair.start <= token.start) {
            Some(pair) if pair.start == token.start => vec![*pair],
            Some(_) => Vec::new(),
            None if split.takes(token.kind()) => {
                parts(self.text, token).unwrap_or_else(|| vec![*token])
            }
            None => vec![*token],
        }
    }

    /// The numbers that a token is read as.
    fn numbers(&self, token: &Token, split: Split) -> Vec<Token> {
        let mut parts = self.read(token, split);
        parts.retain(|t| !t.kind().is_trivia());
        parts
    }

    /// Chooses for each line how to read it.
    fn splits(&self) -> Vec<Split> {
        let lines = self.ends.len();
        let commas = |l: usize| {
            let commas = self.line(l).filter(|t| t.kind() == TokenKind::DecimalComma);
            commas.count()
        };
        let mut out = vec![AS_IT_STANDS; lines];
        let mut decimal_commas = false;
        let mut l = 0;
        while l < lines {
            // A record that ends with its own line is preferred to one that ends with a later line. A record that takes
            // in a line which is a record as it stands is the last choice.
            let ways = self.before.iter();
            let ways = ways.filter_map(|s| Some((s.0, self.fits(l, s)?)));
            let whole = |l: usize| self.fits(l, &self.before[0]) == Some(1);
            let n = match ways.min_by_key(|&(_, n)| (n > 1, n > 1 && (l + 1..l + n).any(whole))) {
                Some((AS_IT_STANDS, n)) => {
                    decimal_commas |= (l..l + n).any(|l| commas(l) > 0);
                    n
                }
                Some((split, n)) => {
                    out[l..l + n].fill(split);
                    decimal_commas |= split.joined;
                    n
                }
                None => 1,
            };
            l += n;
        }
        if decimal_commas {
            // If there are decimal commas elsewhere, the only comma of a line is one too, and the line lacks a number.
            for (l, split) in out.iter_mut().enumerate() {
                if split.commas && commas(l) == 1 {
                    split.commas = false;
                }
            }
        }
        out
    }

    /// How many lines the record at the head of a line takes, read in one of the ways; `None` if it does not end with a
    /// line.
    fn fits(&self, line: usize, (split, before): &(Split, Vec<u64>)) -> Option<usize> {
        let mut head = self.line(line).flat_map(|t| self.numbers(t, *split));
        let mut integer = || head.next()?.integer(self.text);
        integer().filter(|&id| id > 0)?;
        let ty = RecordType::by_code(integer()?)?;
        let n = match ty.is_counted() {
            true => u64::try_from(integer()?).ok().filter(|&n| n >= 2)?,
            false => 0,
        };
        let wanted = ty.arity(n).saturating_add(2);
        let got = before[line + 1] - before[line];
        if got == wanted || got == wanted + ty.optional.len() as u64 {
            // A dash between two IDs is no sign.
            let negative_id = |(i, t): (usize, Token)| {
                let reference = ty.param(i, n as usize).map(|p| p.kind);
                matches!(reference, Some(ParamKind::Reference { .. }))
                    && t.text(self.text).starts_with('-')
            };
            let params = self
                .line(line)
                .flat_map(|t| self.numbers(t, *split))
                .skip(2);
            return (!split.glued || !params.enumerate().any(negative_id)).then_some(1);
        }
        if !ty.is_counted() && ty.params.len() < MIN_LONG_PARAMS {
            return None;
        }
        let end = before[line].saturating_add(wanted);
        let lines = before[line + 1..].partition_point(|&b| b < end) + 1;
        (before.get(line + lines) == Some(&end)).then_some(lines)
    }
}

/// Reports numbers that had lost the space between them, with a fix that inserts it.
pub(crate) fn report(text: &str, tokens: &[Token], glued: &[Span], out: &mut Vec<Diagnostic>) {
    for &span in glued {
        let first = tokens.partition_point(|t| t.start <= span.start);
        let starts = tokens[first..]
            .iter()
            .map(|t| t.start)
            .take_while(|&s| s < span.end);
        let edits: Vec<Edit> = starts
            .map(|s| Edit {
                span: Span::new(s, s),
                text: " ".into(),
            })
            .collect();
        let word = &text[span.range()];
        // A sign says where the second number begins; points leave a choice.
        let sure = !word.contains('.') || word.matches('.').count() < 2;
        let mut apart = word.to_owned();
        for e in edits.iter().rev() {
            apart.insert((e.span.start - span.start) as usize, ' ');
        }
        let applicability = if sure {
            Applicability::Safe
        } else {
            Applicability::Unsafe
        };
        let finding = Diagnostic::new(Code::E003, span)
            .case("glued")
            .with("text", quote(word))
            .with("number", quote(&apart))
            .fix(Fix {
                title: "fix",
                values: Vec::new(),
                applicability,
                edits,
            });
        out.push(others(word).into_iter().fold(finding, |finding, other| {
            let fix = Fix::replace("fix-write", Applicability::Unsafe, span, other.clone());
            finding.fix(fix.with("number", quote(&other)))
        }));
    }
}

/// The other pairs of numbers that a word with two points may mean: `0.41.5` is `0.4 1.5`, or a point stands for the
/// space.
fn others(word: &str) -> Vec<String> {
    let parts: Vec<&str> = word.split('.').collect();
    let [first, middle, last] = parts[..] else {
        return Vec::new();
    };
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let unsigned = first.strip_prefix(['+', '-']).unwrap_or(first);
    if ![unsigned, middle, last].into_iter().all(is_digits) {
        return Vec::new();
    }
    let (before, digit) = middle.split_at(middle.len() - 1);
    let two = format!("{first}.{before} {digit}.{last}");
    let two = (!before.is_empty()).then_some(two);
    two.into_iter()
        .chain([format!("{first}.{middle} {last}")])
        .collect()
}

/// Makes each record with numbers that had lost the space between them a broken item, since an error was reported for
/// it.
pub(crate) fn broken(items: &mut [Item], tokens: &[Token], glued: &[Span]) {
    for item in items {
        let Item::Record(r) = item else { continue };
        let (from, to) = (
            tokens[r.first as usize].start,
            tokens[r.last as usize].end(),
        );
        let i = glued.partition_point(|g| g.start < from);
        if glued.get(i).is_some_and(|g| g.start < to) {
            *item = Item::Broken(Broken {
                first: r.first,
                last: r.last,
                id: Some(r.id),
                kind: Some(r.kind),
                fault: Fault::Form,
                is_slip: true,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The significant tokens of a text after all.
    fn words(text: &str) -> Vec<&str> {
        let (tokens, _) = respell(text, lexer::lex(text, &[]));
        let significant = tokens.iter().filter(|t| !t.kind().is_trivia());
        significant.map(|t| t.text(text)).collect()
    }

    #[test]
    fn words_of_numbers() {
        let cut = |word: &str| {
            let mut cuts = cuts(word)?;
            cuts.insert(0, 0);
            cuts.push(word.len());
            Some(
                cuts.windows(2)
                    .map(|w| word[w[0]..w[1]].to_owned())
                    .collect::<Vec<_>>(),
            )
        };
        assert_eq!(cut("0-1").unwrap(), ["0", "-1"]);
        assert_eq!(cut("1.2.3").unwrap(), ["1.2", ".3"]);
        assert_eq!(cut("1e-3-.5+2").unwrap(), ["1e-3", "-.5", "+2"]);
        for one in [
            "--5", "1e", "0x1F", "5-", "5abc", "1.5..", "nan", "1/2", "12", "",
        ] {
            assert_eq!(cut(one), None, "{one}");
        }
    }

    #[test]
    fn pairs_of_a_number_with_two_points() {
        assert_eq!(others("0.41.5"), ["0.4 1.5", "0.41 5"]);
        assert_eq!(others("-1.2.3"), ["-1.2 3"]);
        for word in ["0.4", "1.2.3.4", ".4.5", "0-1.5", "1.5.", "1e2.3.4"] {
            assert!(others(word).is_empty(), "{word}");
        }
    }

    #[test]
    fn commas_are_what_makes_the_count_fit() {
        assert_eq!(words("2 1 3 0,0 1,1 0,2").len(), 9);
        assert_eq!(words("2 1 3\n0,0 1,1\n0,2\n3 9 1").len(), 12);
        let matrix = "2 -99\n0,4 0 0 0\n0 0,5 0 0\n0 0 -0,5 1,5\n0 0 0 1";
        assert_eq!(words(matrix).len(), 18);
        assert_eq!(words("2 11 0 0 0 0,5").len(), 6);
        // A number is missing, and no way to read the commas gives as many as it takes.
        assert_eq!(words("2 11 0,5 0,5 0,5").len(), 5);
        assert_eq!(words("2 11 0,5 0 1").len(), 6);
        assert_eq!(words("3 11 0 0 0 0,5\n2 11 0,5 0 1").len(), 11);
    }

    #[test]
    fn separators_may_be_decimal_commas() {
        let numbers = |text| words(text)[2..].join(" ");
        for (text, meant) in [
            ("2 11 (0,5; 1,25; 0) 0,75", "0,5 1,25 0 0,75"),
            ("2 11 (1,5; 0; 0) 1", "1,5 0 0 1"),
            ("2 11 <0,5 0 0> 1", "0,5 0 0 1"),
            ("2 10 1,5, 1, 1,5", "1,5 1 1,5"),
            ("2 -1 0,5;1,5;0", "0,5 1,5 0"),
            ("2;11;0,5;1,25;0;0,75", "0,5 1,25 0 0,75"),
            ("2 9 (0,5)", "0,5"),
            // As many as it takes, as it stands.
            ("2 11 (1,5; 0) 1", "1 5 0 1"),
            ("2 11 <1,5,0> 1", "1 5 0 1"),
            // A longer list.
            ("2 11 (1,5,0) 1 1", "1 5 0 1 1"),
            // Too many in any way.
            ("2 11 (1,5; 0; 0; 0) 1 1", "1 5 0 0 0 1 1"),
        ] {
            assert_eq!(numbers(text), meant, "{text}");
        }
        // Points of a record over several lines, whatever other lines have.
        let text = "2 5 (0,0)\n(1,1)\n3 11 0 0 0 0,5";
        assert_eq!(words(text).join(" "), "2 5 0 0 1 1 3 11 0 0 0 0,5");
        let text = "2 1 4\n(0,0)\n(1,1)\n(0,2)\n3 11 0 0 0 0,5";
        assert_eq!(words(text)[3..9].join(" "), "0 0 1 1 0 2");
    }

    #[test]
    fn lost_spaces() {
        assert_eq!(words("3 11 0 0-1 1"), ["3", "11", "0", "0", "-1", "1"]);
        assert_eq!(words("3-101 4 5"), ["3", "-101", "4", "5"]);
        assert_eq!(words("3 11 0 0-1 1 2").len(), 6);
        assert_eq!(words("4 -101 2-3").len(), 3);
    }
}
