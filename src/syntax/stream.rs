//! The significant tokens of a text, with what the parser asks of them all the time: the line they
//! stand on, and their value if they are integers.

use super::lexer::{Token, TokenKind};

/// A significant token.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sig {
    /// Index into the document's tokens.
    pub token: u32,
    /// Number of its line, counting only lines with significant tokens. Line breaks inside comments
    /// do not end a line.
    pub line: u32,
    /// Its value, if it is an integer literal that fits.
    pub int: Option<i32>,
    pub kind: TokenKind,
    /// The next token that is no line break is a comment.
    pub before_comment: bool,
}

/// All significant tokens of a text.
#[derive(Debug)]
pub struct Stream<'s> {
    pub text: &'s str,
    pub tokens: &'s [Token],
    pub sigs: Vec<Sig>,
    /// For each line the index of its first significant token, and one more for the end.
    line_starts: Vec<u32>,
    /// The lines on which a comment is given up.
    unclosed_lines: Vec<u32>,
    /// For each token how many before it are no plain numbers, and so bad, unless one is a file name.
    odd_before: Vec<u32>,
}

impl<'s> Stream<'s> {
    pub fn new(text: &'s str, tokens: &'s [Token]) -> Stream<'s> {
        let mut sigs: Vec<Sig> = Vec::with_capacity(tokens.len());
        let mut line_starts = Vec::new();
        let mut unclosed_lines = Vec::new();
        let mut at_line_start = true;
        for (i, t) in tokens.iter().enumerate() {
            match t.kind {
                TokenKind::Newline => at_line_start = true,
                TokenKind::Comment | TokenKind::UnterminatedComment => {
                    // The mark is for a token whose next token, line breaks aside, is the comment.
                    if let Some(last) = sigs.last_mut()
                        && tokens[last.token as usize + 1..i]
                            .iter()
                            .all(|t| t.kind == TokenKind::Newline)
                    {
                        last.before_comment = true;
                    }
                    if t.kind == TokenKind::UnterminatedComment && !at_line_start {
                        unclosed_lines.push(line_starts.len() as u32 - 1);
                    }
                }
                kind if kind.is_trivia() => {}
                kind => {
                    if at_line_start {
                        line_starts.push(sigs.len() as u32);
                        at_line_start = false;
                    }
                    sigs.push(Sig {
                        token: i as u32,
                        line: line_starts.len() as u32 - 1,
                        int: t.int(text),
                        kind,
                        before_comment: false,
                    });
                }
            }
        }
        line_starts.push(sigs.len() as u32);
        let mut odd_before = Vec::with_capacity(sigs.len() + 1);
        let mut odd = 0;
        odd_before.push(0);
        for s in &sigs {
            odd += u32::from(!matches!(s.kind, TokenKind::Integer | TokenKind::Real));
            odd_before.push(odd);
        }
        Stream {
            text,
            tokens,
            sigs,
            line_starts,
            unclosed_lines,
            odd_before,
        }
    }

    /// Whether tokens `from..to` are plain numbers, all of them.
    pub fn all_numbers(&self, from: usize, to: usize) -> bool {
        self.bad(from, to) == 0
    }

    /// How many of tokens `from..to` are no plain numbers.
    pub fn bad(&self, from: usize, to: usize) -> u32 {
        self.odd_before[to] - self.odd_before[from.min(to)]
    }

    pub fn len(&self) -> usize {
        self.sigs.len()
    }

    pub fn line_count(&self) -> usize {
        self.line_starts.len() - 1
    }

    pub fn line(&self, i: usize) -> usize {
        self.sigs[i].line as usize
    }

    /// The first token of a line.
    pub fn line_start(&self, line: usize) -> usize {
        self.line_starts[line] as usize
    }

    /// One past the last token of a line.
    pub fn line_end(&self, line: usize) -> usize {
        self.line_starts[line + 1] as usize
    }

    pub fn starts_line(&self, i: usize) -> bool {
        self.line_start(self.line(i)) == i
    }

    /// Whether a stretch that stops before token `end` stops at the end of a line.
    pub fn ends_line(&self, end: usize) -> bool {
        end > 0 && self.line_end(self.line(end - 1)) == end
    }

    /// Whether a comment was given up on one of the lines of tokens `from..to`.
    pub fn has_unclosed_comment(&self, from: usize, to: usize) -> bool {
        let (first, last) = (self.line(from) as u32, self.line(to - 1) as u32);
        let i = self.unclosed_lines.partition_point(|&l| l < first);
        self.unclosed_lines.get(i).is_some_and(|&l| l <= last)
    }

    pub fn token(&self, i: usize) -> &Token {
        &self.tokens[self.sigs[i].token as usize]
    }
}
