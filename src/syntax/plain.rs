//! Scenes as most are: without mistakes, every record begins on a line of its own, and no row of a long one
//! could be taken for a record. They are read token by token, and nothing has to be kept for it but the
//! IDs that they define. Everything else raises a [`Doubt`], and is for those who know all of the text.
//!
//! What is read here is what [`super::reader`] and [`super::witness::is_undisturbed`] agree on.

use super::ast::{Item, Record};
use super::lexer::{Token, TokenKind};
use super::reader::fits;
use super::table::{Effect, ParamKind, RecordType};

/// The text is not as plain as that; it may be right for all that.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Doubt;

/// Reads the items of a plain text, one after another.
pub struct Reader<'t, I> {
    text: &'t str,
    tokens: I,
    /// How many tokens have been read.
    read: u32,
    /// The head of the next item.
    next: Option<Sig>,
    /// The IDs that are defined, in the order of the file.
    defined: Vec<u32>,
    /// There is a word, or a comment that spans lines. Both together may be a comment that is not closed.
    has_word: bool,
    has_long_comment: bool,
}

/// A token that is no trivia.
#[derive(Clone, Copy)]
struct Sig {
    token: Token,
    /// Among all tokens.
    index: u32,
    starts_line: bool,
    /// A comment stands before it.
    commented: bool,
}

/// The line that a record ends on, if it is not that where it begins.
#[derive(Default)]
struct Row {
    head: Option<Token>,
    second: Option<Sig>,
}

impl<'t, I: Iterator<Item = Token>> Reader<'t, I> {
    /// # Errors
    ///
    /// The text is not plain.
    pub fn new(text: &'t str, tokens: I) -> Result<Self, Doubt> {
        let mut reader = Reader {
            text,
            tokens,
            read: 0,
            next: None,
            defined: Vec::new(),
            has_word: false,
            has_long_comment: false,
        };
        reader.next = reader.pull()?.map(|sig| Sig {
            starts_line: true,
            ..sig
        });
        Ok(reader)
    }

    /// The next item; `each` is told the tokens of a record.
    ///
    /// # Errors
    ///
    /// The text is not plain.
    pub fn item(&mut self, mut each: impl FnMut(&Token)) -> Result<Option<Item>, Doubt> {
        let Some(head) = self.next else {
            return self.finish().map(|()| None);
        };
        let id = self.int(&head.token).filter(|_| head.starts_line);
        let id = u32::try_from(id.ok_or(Doubt)?).map_err(|_| Doubt)?;
        if id == 0 {
            self.next = self.pull()?;
            return Ok(Some(Item::Void { token: head.index }));
        }
        each(&head.token);
        let mut row = Row::default();
        let mut last = head.index;
        let mut params = 0;
        let mut take = |sig: Sig, kind: ParamKind| {
            if !fits(sig.token.kind, kind) {
                return Err(Doubt);
            }
            each(&sig.token);
            row.add(sig);
            last = sig.index;
            params += 1;
            Ok(sig.token)
        };
        let code = take(self.pull()?.ok_or(Doubt)?, ParamKind::Integer)?;
        let code = self.int(&code).ok_or(Doubt)?;
        let ty = RecordType::by_code(code.into()).ok_or(Doubt)?;
        let mut count = 0;
        for param in ty.params {
            let value = take(self.pull()?.ok_or(Doubt)?, param.kind)?;
            if param.kind == ParamKind::Count {
                count = self.int(&value).filter(|&n| n >= 2).ok_or(Doubt)? as u32;
            }
        }
        // Repeated parameters are real, all of them.
        for _ in ty.params.len() as u64..ty.arity(count.into()) {
            take(self.pull()?.ok_or(Doubt)?, ParamKind::Real)?;
        }
        self.next = self.pull()?;
        // As many numbers as are optional, on the line, are there.
        for (i, param) in ty.optional.iter().enumerate() {
            match self.next {
                Some(sig) if !sig.starts_line => take(sig, param.kind)?,
                _ if i == 0 => break,
                _ => return Err(Doubt),
            };
            self.next = self.pull()?;
        }
        let params = params - 1;
        if self.could_be_a_record(&row) {
            return Err(Doubt);
        }
        if let Effect::Defines(_) = ty.effect {
            self.defined.push(id);
        }
        Ok(Some(Item::Record(Record {
            id,
            ty,
            first: head.index,
            last,
            params,
            count,
        })))
    }

    /// The next token that is no trivia.
    fn pull(&mut self) -> Result<Option<Sig>, Doubt> {
        let (mut starts_line, mut commented) = (false, false);
        for token in self.tokens.by_ref() {
            let index = self.read;
            self.read += 1;
            match token.kind {
                TokenKind::Newline => starts_line = true,
                TokenKind::Comment => {
                    let text = token.text(self.text).as_bytes();
                    self.has_long_comment |= text.contains(&b'\n') || text.contains(&b'\r');
                    commented = true;
                }
                TokenKind::Separator | TokenKind::ByteOrderMark => {}
                TokenKind::Integer | TokenKind::Real | TokenKind::Word | TokenKind::Quoted => {
                    self.has_word |= token.kind == TokenKind::Word;
                    return Ok(Some(Sig {
                        token,
                        index,
                        starts_line,
                        commented,
                    }));
                }
                TokenKind::UnterminatedComment
                | TokenKind::DecimalComma
                | TokenKind::HugeNumber
                | TokenKind::MalformedNumber
                | TokenKind::Invalid => return Err(Doubt),
            }
        }
        Ok(None)
    }

    fn int(&self, token: &Token) -> Option<i32> {
        token.int(self.text)
    }

    /// Whether the line that a record ends on may look like a record of its own.
    fn could_be_a_record(&self, row: &Row) -> bool {
        let Some(head) = row.head.and_then(|head| self.int(&head)) else {
            return false;
        };
        let Some(second) = row.second else {
            return head >= 0;
        };
        match head {
            0 => second.commented,
            1.. => {
                let code = self.int(&second.token);
                code.is_some_and(|code| RecordType::by_code(code.into()).is_some())
            }
            _ => false,
        }
    }

    /// What can be told only at the end.
    fn finish(&mut self) -> Result<(), Doubt> {
        // Most files have their IDs in order.
        if !self.defined.is_sorted_by(|a, b| a < b) {
            self.defined.sort_unstable();
        }
        let twice = !self.defined.is_sorted_by(|a, b| a < b);
        let unclosed = self.has_word && self.has_long_comment;
        if twice || unclosed {
            Err(Doubt)
        } else {
            Ok(())
        }
    }
}

impl Row {
    fn add(&mut self, sig: Sig) {
        if sig.starts_line {
            (self.head, self.second) = (Some(sig.token), None);
        } else if self.head.is_some() && self.second.is_none() {
            self.second = Some(sig);
        }
    }
}

/// The items of a plain text, `None` if it is not plain.
pub fn items(text: &str, tokens: &[Token]) -> Option<Vec<Item>> {
    let mut reader = Reader::new(text, tokens.iter().copied()).ok()?;
    let mut items = Vec::new();
    while let Some(item) = reader.item(|_| {}).ok()? {
        items.push(item);
    }
    Some(items)
}

/// What the readers are tried on: pieces of texts, right and wrong.
#[cfg(test)]
pub(super) const PIECES: &[&str] = &[
    "2",
    "9",
    "18",
    "1",
    "-101",
    "0",
    "1.5",
    "x",
    "20",
    "1 9999 2 0",
    "# c #",
    "# c\nd #",
    "#",
    "\n",
    "\n",
    "\n",
    "2 9 1\n",
    "3 11 0 0 0 1\n",
    "4 18\n",
    "5 18 2\n",
    "6 1 2\n0 0\n1 1\n",
    "-9 1\n",
    "7 6 0 0 0\n1 2 3\n2 9 1\n",
    "8 -301 a.png\n",
    "0,5",
    "0 # c #\n",
];

#[cfg(test)]
mod tests {
    use super::super::{lexer, parser};
    use super::*;

    proptest::proptest! {
        #![proptest_config(proptest::test_runner::Config::with_cases(4_000))]

        /// What is read here without a doubt is read so, and without a finding, by those who know all of the text.
        #[test]
        fn it_agrees_with_the_other_readers(
            pieces in proptest::collection::vec(proptest::sample::select(PIECES), 0..12),
        ) {
            let text = pieces.join(" ");
            let tokens = lexer::lex(&text, &[]);
            if let Some(items) = items(&text, &tokens) {
                let (document, findings) = parser::in_full(&text, tokens);
                proptest::prop_assert_eq!(format!("{:?}", items), format!("{:?}", document.items));
                proptest::prop_assert!(findings.is_empty(), "{:?}: {:?}", text, findings);
            }
        }
    }

    #[test]
    fn doubts() {
        let is_plain = |text: &str| items(text, &lexer::lex(text, &[])).is_some();
        for text in [
            "",
            "# c #",
            "0 # c #\n2 9 1",
            "2 9 1\n3 20\n4 20 1 1 1 2 # c #\n",
            "2 1 2\n0 0\n1.5 1\n",
            "2 -301 a.png # c #",
        ] {
            assert!(is_plain(text), "{text:?}");
        }
        for text in [
            "2 9 1 3 9 1",
            "2 9",
            "2 9 1 # c",
            "2 99 1",
            "2 9 x",
            "2 9 1\n2 9 2",
            "2 18 1 1",
            "2 9 1,5",
            "2 6 0 0 0 0 0 0\n3 9 1\n",
            "2 1 2\n0 0\n1 1\n",
            "2 -301 a.png # c\nc #",
            "-2 9 1",
            "2 1 99 0 0",
        ] {
            assert!(!is_plain(text), "{text:?}");
        }
    }
}
