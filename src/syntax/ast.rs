//! The typed syntax tree. Nothing of the source is lost in it: a [`Document`] keeps all tokens, comments too, and its
//! items are ranges of them.

#![warn(missing_docs)]

use rustc_hash::FxHashMap;

use super::contents::Contents;
use super::lexed::Lexed;
use super::lexer::{Token, TokenKind};
use super::table::{Effect, Kind, RecordKind, RecordType};
use crate::diagnostics::{Code, Diagnostic, Span};

/// A parsed scene text.
#[derive(Debug, Default)]
pub struct Document {
    /// Every token with trivia; white space is what lies between them.
    pub tokens: Vec<Token>,
    /// Records in file order, whole and broken; comments between them are found in `tokens`.
    pub items: Vec<Item>,
    /// The values of all records' parameters, in file order, each read once; NaN for a parameter that is no number. The
    /// values of one record begin at [`Record::value`].
    pub values: Vec<f64>,
    /// The number of significant tokens in stretches that are not laid out in lines. All ways to cut these stretches
    /// into records are tried, which takes hundreds of times as long as reading.
    pub searched: usize,
    /// Which kinds of records the text has, and whether it has comments, separators and broken items.
    pub contents: Contents,
    /// The first tokens of doubtful records, ascending: records that take their last numbers from a line which would be
    /// a record of its own (W314), and rotations about axis 0. Another layout would hide the mistake.
    pub doubted: Vec<u32>,
    /// The first tokens of records that follow another record on its line and define an ID that is defined twice. Their
    /// numbers may be surplus numbers of the record before, like the last operands in `12 -101 2 3 4 5 6 7 8 9`.
    pub redefining: Vec<u32>,
}

/// An item of the file: a record, or text in the place of one.
#[derive(Debug, Clone, Copy)]
pub enum Item {
    /// A lone `0`.
    Void {
        /// The index of the token.
        token: u32,
    },
    /// A record that follows its type's signature.
    Record(Record),
    /// Tokens that could not be read as a record; an error has been reported for them.
    Broken(Broken),
}

// A large file has millions of them.
const _: () = assert!(size_of::<Token>() == 8 && size_of::<Item>() == 24);

/// A record that can be read: its tokens are at `first..=last` of the document's tokens, trivia
/// between them.
#[derive(Debug, Clone, Copy)]
pub struct Record {
    /// The record's ID, 1 to 2 147 483 647.
    pub id: u32,
    /// The kind of the record.
    pub kind: RecordKind,
    /// The index of the ID's token.
    pub first: u32,
    /// The index of the record's last token.
    pub last: u32,
    /// The number of parameters (trivia not counted).
    pub params: u32,
    /// Index of the value of the first parameter in [`Document::values`].
    pub value: u32,
}

/// Tokens that are no record.
#[derive(Debug, Clone, Copy)]
pub struct Broken {
    /// The index of the first token.
    pub first: u32,
    /// The index of the last token.
    pub last: u32,
    /// The ID that the text most likely defines, if one could be told. References to this ID are no errors.
    pub id: Option<u32>,
    /// The type of the record, if that could be told.
    pub kind: Option<RecordKind>,
    /// The fault.
    pub fault: Fault,
    /// Whether only a small mistake, such as a number too many, keeps the text from being a record.
    pub is_slip: bool,
}

/// The fault of a [`Broken`] item, in the few kinds that later stages tell apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// Any fault but those below: a malformed parameter, a missing type, a lost sign.
    Form,
    /// A wrong number of parameters. The type may be the mistake instead: another type may take as many.
    Arity,
    /// A type that does not exist.
    UnknownType,
    /// A missing ID. One reference to an undefined ID may mean this item.
    LostId,
}

impl Record {
    /// The entry of the record's type in the table.
    #[inline]
    pub fn ty(&self) -> &'static RecordType {
        RecordType::of(self.kind)
    }

    /// The value of the count parameter, 0 where the type has none.
    pub fn count(&self) -> usize {
        self.ty().count(self.params as usize)
    }
}

impl Broken {
    /// The entry of the type in the table, if the type could be told.
    #[inline]
    pub fn ty(&self) -> Option<&'static RecordType> {
        self.kind.map(RecordType::of)
    }
}

impl Item {
    /// The record, if it is one that can be read.
    pub fn record(&self) -> Option<&Record> {
        match self {
            Item::Record(record) => Some(record),
            Item::Void { .. } | Item::Broken(_) => None,
        }
    }

    /// The ID of an item whose type always defines its ID anew. `None` for a type that may change an ID, and for the
    /// declaration of an undefined object.
    fn defined(&self) -> Option<u32> {
        let (id, kind) = match self {
            Item::Record(r) => (r.id, r.kind),
            Item::Broken(b) => (b.id?, b.kind?),
            Item::Void { .. } => return None,
        };
        let is_definition = match RecordType::of(kind).effect {
            Effect::Defines(kind) => kind != Kind::Undefined,
            Effect::Changes(_) | Effect::DefinesOrChanges(..) => false,
        };
        is_definition.then_some(id)
    }

    /// The indices of the item's first and last token.
    pub fn ends(&self) -> (u32, u32) {
        match *self {
            Item::Void { token } => (token, token),
            Item::Record(r) => (r.first, r.last),
            Item::Broken(b) => (b.first, b.last),
        }
    }
}

impl Document {
    /// A document of items in the order of the text. For `searched` see [`Document::searched`].
    pub(super) fn new(lexed: Lexed, mut items: Vec<Item>, searched: usize) -> Document {
        let contents = Contents::new(&items, &lexed);
        // Only the values of parameters are kept. They move to the front, and overwrite no value that is still needed,
        // since the records are in order.
        let mut values = lexed.values;
        let mut kept = 0;
        for item in &mut items {
            if let Item::Record(r) = item {
                let first = r.value as usize;
                debug_assert!(kept <= first);
                r.value = kept as u32;
                for value in first..first + r.params as usize {
                    values[kept] = values[value];
                    kept += 1;
                }
            }
        }
        values.truncate(kept);
        values.shrink_to_fit();
        Document {
            contents,
            tokens: lexed.tokens,
            items,
            values,
            searched,
            doubted: Vec::new(),
            redefining: Vec::new(),
        }
    }

    /// Fills [`doubted`](Self::doubted) and [`redefining`](Self::redefining). `findings` must be sorted by place.
    pub(super) fn doubt(&mut self, findings: &[Diagnostic]) {
        let line_breaks = findings.iter().filter(|d| d.code == Code::W314);
        let doubted = line_breaks.filter_map(|d| self.item_at(d.span.start));
        self.doubted = doubted.map(|i| self.items[i].ends().0).collect();
        if self.contents.has(&[RecordKind::Rotation]) {
            let turned = self.items.iter().filter(|item| self.is_about_nothing(item));
            let turned: Vec<u32> = turned.map(|item| item.ends().0).collect();
            self.doubted.extend(turned);
            self.doubted.sort_unstable();
        }
        self.redefining = self.redefining();
    }

    fn redefining(&self) -> Vec<u32> {
        let is_behind = |two: &&[Item]| {
            let between = two[0].ends().1 + 1..two[1].ends().0;
            let mut between = self.tokens[between.start as usize..between.end as usize].iter();
            matches!(two[0], Item::Record(_)) && between.all(|t| t.kind() != TokenKind::Newline)
        };
        let behind = self.items.windows(2).filter(is_behind);
        // An operation is no operand of itself, so a record with the same ID is no surplus operand.
        let behind = behind.filter(|two| two[0].record().map(|r| r.id) != two[1].defined());
        let behind = behind.filter_map(|two| Some((two[1].defined()?, two[1].ends().0)));
        let behind: Vec<(u32, u32)> = behind.collect();
        if behind.is_empty() {
            return Vec::new();
        }
        let mut counts: FxHashMap<u32, usize> = FxHashMap::default();
        for id in self.items.iter().filter_map(Item::defined) {
            *counts.entry(id).or_default() += 1;
        }
        let again = behind.into_iter().filter(|(id, _)| counts[id] > 1);
        again.map(|(_, first)| first).collect()
    }

    /// Whether an item is a rotation about axis 0, which does not exist. The numbers behind it may belong to the
    /// rotation, like the angles about y and z in `2 -2 90 0 0`.
    fn is_about_nothing(&self, item: &Item) -> bool {
        let turn = item.record().filter(|r| r.kind == RecordKind::Rotation);
        turn.is_some_and(|r| self.values(r).last() == Some(&0.0))
    }

    /// Whether the record that begins with a token is among the doubted ones.
    pub fn is_doubted(&self, first: u32) -> bool {
        self.doubted.binary_search(&first).is_ok()
    }

    /// Whether the record that begins with a token is among the [`redefining`](Self::redefining) ones.
    pub fn is_redefining(&self, first: u32) -> bool {
        self.redefining.binary_search(&first).is_ok()
    }

    /// The index of the item that holds the token at byte `at` of the text, or the next token if `at` is between two.
    /// `None` if that token belongs to no item.
    pub fn item_at(&self, at: u32) -> Option<usize> {
        let token = self.tokens.partition_point(|t| t.end() <= at) as u32;
        let item = self.items.partition_point(|item| item.ends().1 < token);
        let holds = |item: &Item| item.ends().0 <= token;
        self.items.get(item).is_some_and(holds).then_some(item)
    }

    /// The text from the first character of token `first` to the last of token `last`.
    pub fn span(&self, first: u32, last: u32) -> Span {
        self.tokens[first as usize]
            .span()
            .to(self.tokens[last as usize].span())
    }

    /// The span of an item's tokens.
    pub fn item_span(&self, item: &Item) -> Span {
        let (first, last) = item.ends();
        self.span(first, last)
    }

    /// The significant tokens among `first..=last`, in order.
    pub fn significant(&self, first: u32, last: u32) -> impl Iterator<Item = &Token> {
        self.tokens[first as usize..=last as usize]
            .iter()
            .filter(|t| !t.kind().is_trivia())
    }

    /// The record's ID token.
    pub fn id_token(&self, record: &Record) -> &Token {
        &self.tokens[record.first as usize]
    }

    /// The record's parameter tokens, in order.
    pub fn params(&self, record: &Record) -> impl Iterator<Item = &Token> {
        self.significant(record.first, record.last).skip(2)
    }

    /// The values of the record's parameters, in order; NaN for a file name.
    pub fn values(&self, record: &Record) -> &[f64] {
        let first = record.value as usize;
        &self.values[first..first + record.params as usize]
    }

    /// The text again, character by character, from the tokens and what lies between them.
    pub fn print(&self, text: &str) -> String {
        let mut out = String::with_capacity(text.len());
        let mut at = 0;
        for t in &self.tokens {
            out.push_str(&text[at..t.start as usize]);
            out.push_str(t.text(text));
            at = t.end() as usize;
        }
        out.push_str(&text[at..]);
        out
    }

    /// The comments on the line before a record, if nothing but comments and an introducing `0` is on that line.
    pub fn comments_before(&self, record: &Record) -> impl Iterator<Item = &Token> {
        let before = match self.tokens[..record.first as usize].split_last() {
            Some((last, before)) if last.kind() == TokenKind::Newline => before,
            _ => &[],
        };
        let on_line = |t: &&Token| t.kind() != TokenKind::Newline;
        let count = before.iter().rev().take_while(on_line).count();
        let comments = without_void(&before[before.len() - count..]);
        let is_alone = comments.iter().all(|t| t.kind().is_comment());
        (if is_alone { comments } else { &[] }).iter()
    }

    /// The comments inside of a record, and the comments behind it on its last line. A `0` may introduce the comments
    /// behind it.
    pub fn comments_at(&self, record: &Record) -> impl Iterator<Item = &Token> {
        let (first, end) = (record.first as usize, record.last as usize + 1);
        let within = self.tokens[first..end]
            .iter()
            .filter(|t| t.kind().is_comment());
        let behind = without_void(&self.tokens[end..]).iter();
        within.chain(behind.take_while(|t| t.kind().is_comment()))
    }

    /// The comments, closed or not, in order.
    pub fn comments(&self) -> impl Iterator<Item = &Token> {
        self.tokens.iter().filter(|t| t.kind().is_comment())
    }
}

/// Drops a leading integer of one digit: the `0` that introduces a comment. If the digit is an ID instead, other
/// numbers follow, and the caller finds no comments.
fn without_void(tokens: &[Token]) -> &[Token] {
    match tokens {
        [void, rest @ ..] if void.kind() == TokenKind::Integer && void.end() == void.start + 1 => {
            rest
        }
        all => all,
    }
}
