//! Words that were meant as a comment.

use super::clauses::is_word;
use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::slashes;
use crate::diagnostics::{Applicability, Diagnostic, Edit, Fix, Span};
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{RecordKind, RecordType};

/// The beginning of a comment in C.
const SLASHES: &str = "//";
/// The beginning and the end of one that may be of several lines.
const BLOCK: [&str; 2] = ["/*", "*/"];

impl LineContext<'_> {
    /// Words behind a record that were meant as a comment.
    pub(super) fn comments(&self, out: &mut Vec<Candidate>) {
        let is_wordy = |t: &Token| {
            matches!(
                t.kind(),
                TokenKind::Word
                    | TokenKind::Invalid
                    | TokenKind::MalformedNumber
                    | TokenKind::UnterminatedComment
                    | TokenKind::Quoted
            )
        };
        // A closed comment may begin the words, if others follow that are in none.
        let first = |t: &Token| is_wordy(t) || t.kind() == TokenKind::Comment;
        let separators_before = |mut i: usize| {
            while i > 0 && self.all[i - 1].kind() == TokenKind::Separator {
                i -= 1;
            }
            i
        };
        let mut starts: Vec<usize> = Vec::new();
        let significant: Vec<usize> = (0..self.all.len())
            .filter(|&i| !self.all[i].kind().is_trivia())
            .collect();
        // The words may begin behind as many parameters as the record takes.
        if let Some(ty) = self.ty() {
            let at = 2 + self.wanted(ty);
            if let Some(&i) = significant.get(at) {
                starts.push(i);
            } else if at == significant.len() {
                starts.extend(self.all.iter().position(first));
            }
        }
        if self.file_name().is_none() {
            starts.extend(self.all.iter().position(is_wordy));
            starts.extend(self.all.iter().position(first));
        }
        for i in starts {
            let mut i = separators_before(i);
            // A sign that stands before a word, as in `# see #1 top`, closes no comment.
            let is_closed = |t: &Token| t.kind() == TokenKind::Comment;
            if i > 0 && is_closed(&self.all[i - 1]) && self.all[i - 1].end() == self.all[i].start {
                i -= 1;
            }
            // Two signs, as in `## heading`, are a comment without words.
            let is_empty = |t: &Token| is_closed(t) && t.text(self.text).bytes().all(|c| c == b'#');
            while i > 0 && is_empty(&self.all[i - 1]) {
                i -= 1;
            }
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
            // If a comment over several lines ends on this line, a new comment would leave hidden the records that the
            // old one hides.
            if before == 0 && self.ends_a_comment() {
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
            out.push(Candidate::new(Habit::Comment, fix));
        }
    }

    /// The part of the line before a C comment, as in `sphere { <0,1,0>, 1 } // ball`, and the edit that makes that
    /// comment one of zpg.
    fn before_slashes(&self) -> Option<(LineContext<'_>, Edit)> {
        let is_begin = |t: &Token| {
            let rest = &self.text[t.start as usize..self.line.end.max(t.start) as usize];
            let is_block = rest.strip_prefix(BLOCK[0]).is_some_and(|inside| {
                inside
                    .trim_end()
                    .strip_suffix(BLOCK[1])
                    .is_some_and(|words| !words.contains(BLOCK[1]))
            });
            !t.kind().is_comment() && (is_block || rest.starts_with(SLASHES))
        };
        let at = self.all.iter().position(is_begin).filter(|&at| at > 0)?;
        let (all, behind) = self.all.split_at(at);
        // A comment that goes on behind the line is not cut.
        let span = Span::new(behind[0].start, self.line.end);
        if behind.last()?.end() > span.end {
            return None;
        }
        let before = self.text[..span.start as usize].trim_end().len() as u32;
        let tokens = all.iter().filter(|t| !t.kind().is_trivia());
        let line = LineContext {
            line: Span::new(self.line.start, before),
            all,
            tokens: tokens.copied().collect(),
            ..*self
        };
        let words = self.text[span.range()].trim();
        let block = words.strip_prefix(BLOCK[0]);
        let words = match block.and_then(|words| words.strip_suffix(BLOCK[1])) {
            Some(words) => words,
            None => words.trim_start_matches('/'),
        };
        let text = slashes::as_comment(words);
        Some((line, Edit { span, text }))
    }

    /// Guesses at records for a line in the notation of other programs with a C comment behind it, which becomes one of
    /// zpg.
    pub(super) fn with_slashes(
        &self,
        finding: &Diagnostic,
        undefined: &[u32],
        taken: &[u32],
        out: &mut Vec<Candidate>,
    ) {
        let Some((line, comment)) = self.before_slashes() else {
            return;
        };
        let mut records = line.candidates(finding, undefined, taken);
        records.retain(|c| {
            matches!(
                c.habit,
                Habit::Keyword | Habit::Unnamed | Habit::Word | Habit::Apart
            ) && line.tokens.iter().any(is_word)
        });
        for candidate in &mut records {
            candidate.fix.edits.push(comment.clone());
        }
        out.extend(records);
    }

    /// How many parameters a record of a type takes on this line; optional ones count if they are there.
    pub(super) fn wanted(&self, ty: &RecordType) -> usize {
        let count = match ty.is_counted() {
            true => self.int(2).and_then(|n| u64::try_from(n).ok()).unwrap_or(0),
            false => 0,
        };
        // The limit does no harm: no file has more tokens.
        let least = ty.arity(count).min(u32::MAX.into()) as usize;
        if ty.kind == RecordKind::ImageTexture {
            return self.file_name().map_or(least, |name| name.len());
        }
        let more = least + ty.optional.len();
        let optional = self.params().get(least..more).unwrap_or(&[]);
        match optional.iter().all(|t| t.kind().is_number()) {
            true => least + optional.len(),
            false => least,
        }
    }

    /// Whether a comment that began on a line before ends on this one, before its first token.
    fn ends_a_comment(&self) -> bool {
        let source = &self.analysis.source;
        let line = source.line_span(source.line_index(source.floor(self.line.start)));
        let before = &self.text[line.start as usize..self.line.start as usize];
        before.matches('#').count() % 2 == 1
    }

    /// Whether at least half of the line's tokens are words, the first of them in the place of an ID.
    fn is_heading(&self) -> bool {
        let is_word = |t: &Token| matches!(t.kind(), TokenKind::Word | TokenKind::Invalid);
        let on_line = self.all.iter().filter(|t| !t.kind().is_trivia());
        let (words, others): (Vec<&Token>, Vec<&Token>) = on_line.partition(|t| is_word(t));
        words.len() >= others.len() && self.tokens.first().is_some_and(is_word)
    }
}
