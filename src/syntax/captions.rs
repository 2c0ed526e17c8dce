//! Captions of a scene, from its comments: a title, and a line for each ID that has one.

use std::collections::HashMap;

use super::ast::{Document, Item};
use super::commented_out::is_commented_out;
use super::directive::{inside, is_directive};
use super::lexer::{Token, TokenKind};
use super::table::RecordType;
use super::words;

/// The comments of a scene by what they belong to, each as one line of text without control
/// characters.
///
/// The comment of an entity stands inside of one of its records, or behind one on the record's last line. An entity
/// without a comment of its own has the heading before its first record: comments on lines of their own with no blank
/// line in between. Comments before all records, with a blank line behind them, are the title of the scene. The only
/// heading of a scene is its title, too, if the heading stands before all records. That heading still belongs to the
/// first record if it is one comment that names the shape of the record and no other shape.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Captions {
    title: Option<String>,
    texts: Vec<String>,
    /// For each ID the index of its text, and whether the text is the entity's own comment and no heading.
    ids: HashMap<u32, (u32, bool)>,
}

/// The most characters of a comment; a longer one is cut off.
const MAX_CAPTION_CHARS: usize = 72;

/// The state of the walk along the tokens.
#[derive(Default)]
struct Walk {
    captions: Captions,
    /// Comments that may become a heading or the title.
    heading: Vec<String>,
    /// The index of the heading's text, once a record has asked for it.
    heading_text: Option<u32>,
    /// Line breaks since the last token of another kind.
    breaks: u32,
    /// The ID of the record that a comment on this line belongs to.
    last: Option<u32>,
    any_record: bool,
    /// The index of the text of the heading before all records, and the number of headings.
    first: Option<u32>,
    headings: u32,
    /// The ID of the first record, if the heading before all records names its shape.
    named: Option<u32>,
}

impl Captions {
    pub fn of(document: &Document, text: &str) -> Captions {
        let mut walk = Walk::default();
        let mut items = document.items.iter().peekable();
        let mut at = 0;
        while at < document.tokens.len() {
            if let Some(item) = items.next_if(|item| item.ends().0 as usize <= at) {
                let (first, last) = item.ends();
                walk.item(item, &document.tokens[first as usize..=last as usize], text);
                at = last as usize + 1;
                continue;
            }
            walk.token(&document.tokens[at], text);
            at += 1;
        }
        walk.end_of_block();
        walk.settle_title();
        walk.captions
    }

    /// The title of the scene, from its first comments.
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// The text of the entity's own comment. `None` if the entity has a heading at most.
    pub fn own(&self, id: u32) -> Option<&str> {
        let (_, own) = self.ids.get(&id)?;
        self.get(id).filter(|_| *own)
    }

    /// An entity's ID, with what a comment or a heading says about it.
    pub fn entity(&self, id: u32) -> String {
        match self.get(id) {
            Some(words) => format!("{id}, {words}"),
            None => id.to_string(),
        }
    }

    /// The text of the entity's own comment, or else of its heading.
    pub fn get(&self, id: u32) -> Option<&str> {
        let (text, _) = self.ids.get(&id)?;
        Some(&self.texts[*text as usize])
    }
}

impl Walk {
    fn token(&mut self, token: &Token, text: &str) {
        match token.kind() {
            TokenKind::Newline => {
                self.breaks += 1;
                self.last = None;
                if self.breaks > 1 {
                    self.end_of_block();
                }
            }
            kind if kind.is_comment() => {
                self.breaks = 0;
                let said = said(token, text);
                match self.last {
                    Some(id) => self.own(id, said),
                    None if said.is_some() => {
                        if self.heading_text.is_some() {
                            self.end_of_block();
                        }
                        self.heading.extend(said);
                    }
                    None => {}
                }
            }
            _ => self.breaks = 0,
        }
    }

    fn item(&mut self, item: &Item, tokens: &[Token], text: &str) {
        self.breaks = 0;
        let record = match item {
            Item::Record(record) => record,
            // A `0` introduces a comment, which belongs to the record before the `0` on the line, if there is one.
            Item::Void { .. } => return,
            Item::Broken(_) => {
                self.last = None;
                return;
            }
        };
        let at_top = !self.any_record;
        self.any_record = true;
        let id = record.id;
        if !self.captions.ids.contains_key(&id) && !self.heading.is_empty() {
            let index = match self.heading_text {
                Some(index) => index,
                None => {
                    let index = self.keep(self.heading.join(" "));
                    self.headings += 1;
                    self.first = self.first.or(at_top.then_some(index));
                    let is_name = matches!(&self.heading[..], [one] if names(one, record.ty()));
                    self.named = self.named.or((at_top && is_name).then_some(id));
                    index
                }
            };
            self.heading_text = Some(index);
            self.captions.ids.insert(id, (index, false));
        }
        let within = tokens.iter().filter(|t| t.kind().is_comment());
        for comment in within {
            self.own(id, said(comment, text));
        }
        self.last = Some(id);
    }

    /// Takes in a comment that is the entity's own. Only the first one counts.
    fn own(&mut self, id: u32, said: Option<String>) {
        let known = self.captions.ids.get(&id);
        if let Some(said) = said
            && !known.is_some_and(|(_, own)| *own)
        {
            let index = self.keep(said);
            self.captions.ids.insert(id, (index, true));
        }
    }

    fn keep(&mut self, text: String) -> u32 {
        self.captions.texts.push(shortened(text));
        self.captions.texts.len() as u32 - 1
    }

    /// Makes the only heading the title of the scene, if it stands before all records and there is no title yet.
    fn settle_title(&mut self) {
        if let (Some(first), 1, None) = (self.first, self.headings, &self.captions.title) {
            self.captions.title = Some(self.captions.texts[first as usize].clone());
            let named = self.named;
            (self.captions.ids).retain(|id, (_, own)| *own || named == Some(*id));
        }
    }

    /// Ends a heading: a blank line or another heading follows. Comments before all records become the title.
    fn end_of_block(&mut self) {
        let heading = std::mem::take(&mut self.heading);
        self.heading_text = None;
        if !self.any_record && self.captions.title.is_none() && !heading.is_empty() {
            self.captions.title = Some(shortened(heading.join(" ")));
        }
    }
}

/// Whether a text names the shape of type `ty` and no other shape.
fn names(said: &str, ty: &RecordType) -> bool {
    let words = said.split(|c: char| !c.is_alphabetic());
    let mut shapes = words
        .map(words::shapes)
        .filter(|s| !s.is_empty())
        .peekable();
    shapes.peek().is_some() && shapes.all(|s| s.iter().any(|s| s.code == ty.code))
}

/// The text of a comment as one line. `None` if the comment is empty, meant for zpg, or commented out.
fn said(token: &Token, text: &str) -> Option<String> {
    if is_directive(token, text) || is_commented_out(token.text(text)) {
        return None;
    }
    let breaks = |c: char| c.is_whitespace() || c.is_control();
    let words = inside(token.text(text)).split(breaks);
    let words: Vec<&str> = words.filter(|w| !w.is_empty()).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

fn shortened(text: String) -> String {
    match text.char_indices().nth(MAX_CAPTION_CHARS) {
        Some(_) => {
            let cut: String = text.chars().take(MAX_CAPTION_CHARS - 1).collect();
            cut.trim_end().to_owned() + "…"
        }
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse;

    fn captions(text: &str) -> Captions {
        Captions::of(&parse(text).0, text)
    }

    #[test]
    fn own_comments_come_before_headings() {
        let all = captions(
            "0 # a scene #\n0 # in two lines #\n\n0 # balls #\n2 9 1 # red #\n3 9 2\n\n4 9 3\n\
             # bare # \n5 9 4\n6 11 0 # the middle # 0 0 1\n0 # more #\n7 9 5\n3 -1 1 0 0 # moved #\n",
        );
        assert_eq!(all.title(), Some("a scene in two lines"));
        let of: Vec<_> = (2..8).map(|id| all.get(id)).collect();
        assert_eq!((all.own(2), all.own(5)), (Some("red"), None));
        let expected = ["red", "moved", "", "bare", "the middle", "more"];
        assert_eq!(of, expected.map(|t| (!t.is_empty()).then_some(t)));
    }

    #[test]
    fn a_comment_behind_a_zero_is_of_the_record_on_its_line() {
        let all = captions("2 9 1 0 # red #\n3 9 2\n4 9 3 0 # blue #\n0 # the rest #\n5 9 4\n");
        let of: Vec<_> = (2..6).map(|id| all.get(id)).collect();
        assert_eq!(of, [Some("red"), None, Some("blue"), Some("the rest")]);
    }

    #[test]
    fn a_heading_at_the_top_is_a_title_if_there_is_no_other() {
        let all = captions("0 # balls #\n2 9 1\n\n# boxes #\n3 12 0 0 0 1 1 1\n");
        assert_eq!((all.title(), all.get(2)), (None, Some("balls")));
        let all = captions("0 # balls #\n2 9 1 # red #\n\n3 9 2\n");
        let of = (all.title(), all.get(2), all.get(3));
        assert_eq!(of, (Some("balls"), Some("red"), None));
    }

    #[test]
    fn a_heading_at_the_top_that_names_the_first_record_is_of_that_too() {
        let of = |text: &str| {
            let all = captions(text);
            let own = [2, 3].map(|id| all.get(id).map(str::to_owned));
            (all.title().map(str::to_owned), own)
        };
        let some = |text: &str| Some(text.to_owned());
        let ball = "2 11 0 1 0 1\n3 11 0 3 0 1\n";
        let one = of(&format!("# glass ball #\n{ball}"));
        assert_eq!(one, (some("glass ball"), [some("glass ball"), None]));
        let czech = of(&format!("0 # skleněná koule #\n{ball}"));
        assert_eq!(czech.1, [some("skleněná koule"), None]);
        for title in [
            "# glass ball #\n\n",
            "# glass ball #\n# by me #\n",
            "# glass ball on a plane #\n",
            "# glass cube #\n",
            "# glass #\n",
        ] {
            assert_eq!(of(&format!("{title}{ball}")).1, [None, None], "{title}");
        }
    }

    #[test]
    fn what_is_commented_out_says_nothing() {
        let all = captions("2 9 1\n\n0 # ~ 3 9 1 ~~ red ~~ #\n4 9 1\n5 9 1 0 # ~ 6 9 1 #\n");
        assert_eq!((all.title(), all.get(4), all.get(5)), (None, None, None));
    }

    #[test]
    fn comments_are_one_line_without_control_characters() {
        let text =
            "2 9 1 # a\r\n b\t\u{1}c\u{2028}d */ ř #\n3 9 1 # zpg: allow(W310) #\n4 9 1 # #\n";
        let all = captions(text);
        assert_eq!(all.get(2), Some("a b c d */ ř"));
        assert_eq!((all.get(3), all.get(4)), (None, None));
    }

    #[test]
    fn long_comments_are_cut() {
        let all = captions(&format!("2 9 1 # {} #\n", "ž".repeat(500)));
        assert_eq!(all.get(2).unwrap().chars().count(), MAX_CAPTION_CHARS);
        let all = captions(&format!("0 # {} #\n\n2 9 1\n", "ž".repeat(500)));
        assert_eq!(all.title().unwrap().chars().count(), MAX_CAPTION_CHARS);
    }
}
