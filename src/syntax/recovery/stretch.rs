//! The significant tokens of a stretch of text. For each of them recovery often needs three things: the line, the value
//! of an integer, and the record that can be read from the token on.

use super::super::lexer::{Token, TokenKind};
use super::super::signature::{self, Columns, Reading};
use super::super::table::RecordType;
use super::surroundings::Surroundings;

/// A significant token.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sig {
    /// Index into the document's tokens.
    pub token: u32,
    /// Number of its line, counting only lines with significant tokens. Line breaks inside comments
    /// do not end a line.
    pub line: u32,
    /// The value of the token, if it is an integer literal that fits.
    pub int: Option<i32>,
    pub kind: TokenKind,
    /// Whether the next token that is no line break is a comment.
    pub before_comment: bool,
}

/// Fewest parameters of a record that is often laid out over several lines.
pub(super) const MIN_LONG_PARAMS: usize = 9;

/// The significant tokens of a stretch, from the beginning of a line to the end of one. They are counted from
/// its beginning.
#[derive(Debug)]
pub(crate) struct Stretch<'s> {
    columns: Columns<'s>,
    /// The first token of the stretch among the significant ones of the text.
    from: usize,
    pub sigs: Vec<Sig>,
    /// For each line the index of its first significant token, and one more for the end.
    line_starts: Vec<u32>,
    /// The lines with a comment that nobody closes.
    unclosed_lines: Vec<u32>,
    /// For each token and the end, how many tokens before it are no plain numbers. Each of those is a bad token, unless
    /// it is a file name.
    odd_before: Vec<u32>,
    /// For each token the record that can be read from there on.
    readings: Vec<Option<Reading>>,
    /// Whether it is known that the text is not laid out in lines.
    pub is_free: bool,
}

impl<'s> Stretch<'s> {
    /// Significant tokens `from..to` of a text.
    pub(crate) fn new(columns: Columns<'s>, from: usize, to: usize) -> Stretch<'s> {
        let tokens = &columns.lexed.tokens;
        let mut sigs: Vec<Sig> = Vec::with_capacity(to - from);
        let mut line_starts = Vec::new();
        let mut unclosed_lines = Vec::new();
        let mut odd_before = Vec::with_capacity(to - from + 1);
        let mut odd = 0;
        odd_before.push(0);
        for i in from..to {
            if i == from || columns.starts_line(i) {
                line_starts.push(sigs.len() as u32);
            }
            let token = columns.lexed.sigs[i].token();
            let kind = tokens[token as usize].kind();
            odd += u32::from(!matches!(kind, TokenKind::Integer | TokenKind::Real));
            odd_before.push(odd);
            let (mut broken, mut before_comment) = (false, None);
            for t in &tokens[token as usize + 1..] {
                match t.kind() {
                    TokenKind::Newline => broken = true,
                    kind if kind.is_comment() => {
                        // The mark is for a token whose next token, line breaks aside, is the comment.
                        before_comment.get_or_insert(true);
                        if kind == TokenKind::UnterminatedComment && !broken {
                            unclosed_lines.push(line_starts.len() as u32 - 1);
                        }
                    }
                    kind if kind.is_trivia() => {
                        before_comment.get_or_insert(false);
                    }
                    _ => break,
                }
            }
            sigs.push(Sig {
                token,
                line: line_starts.len() as u32 - 1,
                int: columns.int(i),
                kind,
                before_comment: before_comment == Some(true),
            });
        }
        line_starts.push(sigs.len() as u32);
        let read = |i| {
            signature::read(&columns, i, to).map(|r| Reading {
                end: r.end - from,
                ..r
            })
        };
        Stretch {
            columns,
            from,
            readings: (from..to).map(read).collect(),
            sigs,
            line_starts,
            unclosed_lines,
            odd_before,
            is_free: false,
        }
    }

    /// The record that begins at token `i`, if there is one without any fault of form.
    pub(crate) fn read(&self, i: usize) -> Option<&Reading> {
        self.readings.get(i)?.as_ref()
    }

    /// Whether a line that is commented out begins among tokens `from..to`.
    pub(crate) fn goes_out(&self, from: usize, to: usize) -> bool {
        (self.columns.lexed).goes_out(self.from + from, self.from + to)
    }

    /// Like [`signature::begins_again`], for a record and the start of a line in this stretch.
    pub(crate) fn begins_again(&self, head: usize, line: usize) -> bool {
        signature::begins_again(&self.columns, self.from + head, self.from + line)
    }

    /// The index of a token of the stretch among the significant tokens of the whole text.
    pub(crate) fn in_text(&self, i: usize) -> usize {
        self.from + i
    }

    /// The record at token `i` if line breaks alone decide about its optional group. `None` if there is no record, or
    /// if it is the same as that of [`read`](Self::read), which a mistake on a line behind it may have changed.
    pub(crate) fn read_by_line(&self, i: usize) -> Option<Reading> {
        let reading = self.read(i)?;
        let to = self.from + self.len();
        let by_line = signature::read_by_line(&self.columns, self.from + i, to)?;
        let end = by_line.end - self.from;
        (end != reading.end).then_some(Reading { end, ..by_line })
    }

    /// The type whose number stands at a token.
    pub(crate) fn record_type(&self, i: usize) -> Option<&'static RecordType> {
        RecordType::by_code(self.sigs.get(i)?.int?.into())
    }

    /// The first definition of an ID in the rest of the text, and the type of its record.
    pub(crate) fn defined_elsewhere(
        &self,
        around: &Surroundings,
        id: u32,
    ) -> Option<(usize, &'static RecordType)> {
        around.definition(&self.columns, id)
    }

    /// The ID and the type at the head of a line; see [`Columns::head`].
    pub(crate) fn head(&self, line: usize) -> [Option<i32>; 2] {
        self.columns.head(self.from + self.line_start(line))
    }

    /// The ID and the type of a line, if its first token is skipped.
    pub(crate) fn head_behind_first(&self, line: usize) -> [Option<i32>; 2] {
        let second = self.line_start(line) + 1;
        match second < self.line_end(line) {
            true => self.columns.head(self.from + second),
            false => [None; 2],
        }
    }

    /// The heads of the lines before the stretch, the nearest first.
    pub(crate) fn heads_before(&self) -> impl Iterator<Item = [Option<i32>; 2]> {
        self.heads((0..self.from).rev())
    }

    /// The heads of the lines behind the stretch, in their order.
    pub(crate) fn heads_behind(&self) -> impl Iterator<Item = [Option<i32>; 2]> {
        self.heads(self.from + self.len()..self.columns.len())
    }

    fn heads(&self, tokens: impl Iterator<Item = usize>) -> impl Iterator<Item = [Option<i32>; 2]> {
        let c = self.columns;
        (tokens.filter(move |&i| c.starts_line(i))).map(move |i| c.head(i))
    }

    /// Whether the stretch stands behind a significant token of the text.
    pub(crate) fn is_behind(&self, token: usize) -> bool {
        token < self.from
    }

    /// The value of a token; NaN if it is no number.
    pub(crate) fn value(&self, i: usize) -> f64 {
        self.columns.lexed.values[self.from + i]
    }

    /// Index of a token's value in the text's column.
    pub(crate) fn value_index(&self, i: usize) -> u32 {
        (self.from + i) as u32
    }

    /// Whether the type of a record allows its values.
    pub(crate) fn values_allowed(&self, start: usize, r: &Reading) -> bool {
        let r = Reading {
            end: r.end + self.from,
            ..*r
        };
        signature::values_allowed(&self.columns, start + self.from, &r)
    }

    /// Whether a record has a wrong ID or wrong values for its type; see [`signature::is_odd`].
    pub(crate) fn is_odd(&self, start: usize, r: &Reading) -> bool {
        let r = Reading {
            end: r.end + self.from,
            ..*r
        };
        signature::is_odd(&self.columns, start + self.from, &r)
    }

    pub(crate) fn text(&self) -> &'s str {
        self.columns.text
    }

    /// Whether tokens `from..to` are plain numbers, all of them.
    pub(crate) fn all_numbers(&self, from: usize, to: usize) -> bool {
        self.bad(from, to) == 0
    }

    /// How many of tokens `from..to` are no plain numbers.
    pub(crate) fn bad(&self, from: usize, to: usize) -> u32 {
        self.odd_before[to] - self.odd_before[from.min(to)]
    }

    pub(crate) fn len(&self) -> usize {
        self.sigs.len()
    }

    pub(crate) fn line_count(&self) -> usize {
        self.line_starts.len() - 1
    }

    pub(crate) fn line(&self, i: usize) -> usize {
        self.sigs[i].line as usize
    }

    /// The first token of a line.
    pub(crate) fn line_start(&self, line: usize) -> usize {
        self.line_starts[line] as usize
    }

    /// Whether at least half of a line's tokens are words, among them the first token, where an ID should be.
    pub(crate) fn is_prose(&self, line: usize) -> bool {
        let tokens = &self.sigs[self.line_start(line)..self.line_end(line)];
        let is_word = |kind| matches!(kind, TokenKind::Word | TokenKind::Invalid);
        let words = tokens.iter().filter(|sig| is_word(sig.kind)).count();
        2 * words >= tokens.len() && tokens.first().is_some_and(|sig| is_word(sig.kind))
    }

    /// The end of a line: one past its last token.
    pub(crate) fn line_end(&self, line: usize) -> usize {
        self.line_starts[line + 1] as usize
    }

    pub(crate) fn starts_line(&self, i: usize) -> bool {
        self.line_start(self.line(i)) == i
    }

    /// Whether the token before `end` is the last one of its line.
    pub(crate) fn ends_line(&self, end: usize) -> bool {
        end > 0 && self.line_end(self.line(end - 1)) == end
    }

    /// Whether one of the lines of tokens `from..to` has a comment that nobody closes.
    pub(crate) fn has_unclosed_comment(&self, from: usize, to: usize) -> bool {
        let (first, last) = (self.line(from) as u32, self.line(to - 1) as u32);
        let i = self.unclosed_lines.partition_point(|&l| l < first);
        self.unclosed_lines.get(i).is_some_and(|&l| l <= last)
    }

    pub(crate) fn token(&self, i: usize) -> &Token {
        self.columns.token(self.from + i)
    }
}
