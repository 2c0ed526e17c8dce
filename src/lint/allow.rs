//! Comments that say what is all right: `# zpg: allow(W307, colour-out-of-range) as it is meant #`.
//!
//! What stands between the brackets is what `zpg.toml` knows too: codes, names and groups. On a record's line such a comment covers the record, alone on the line above one too; at the head
//! of the file, before any record, it covers the file. What it allows is not reported. An entry that
//! allows nothing is S504.

use super::Context;
use super::levels::Selector;
use crate::diagnostics::{self, Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::syntax::Item;
use crate::syntax::directive::{self, PREFIX, is_directive, without_word};
use crate::syntax::lexer::{Token, TokenKind};

/// Takes out what comments allow, and adds what is wrong with the comments. Sorts the findings.
pub fn apply(context: &Context, out: &mut Vec<Diagnostic>) {
    let document = context.document;
    let comments = (document.tokens.iter().enumerate())
        .filter(|(_, t)| t.kind == TokenKind::Comment && is_directive(t, context.text));
    let directives: Vec<Directive> = comments.map(|(i, _)| Directive::new(context, i)).collect();
    if directives.is_empty() {
        return;
    }
    diagnostics::sort(out);
    let mut allowed = vec![false; out.len()];
    let mut remarks = Vec::new();
    for directive in directives {
        remarks.extend(directive.apply(out, &mut allowed));
    }
    let mut at = 0;
    out.retain(|_| {
        at += 1;
        !allowed[at - 1]
    });
    out.append(&mut remarks);
    diagnostics::sort(out);
}

/// One such comment.
struct Directive {
    comment: Span,
    /// The comment with what belongs to nothing else once it is gone: its line, its `0`.
    removal: Span,
    /// What stands between the brackets, and where; `None` if it is no `allow(…)`.
    entries: Option<(Vec<String>, Span)>,
    /// Where findings begin that it may allow.
    covers: Option<Span>,
}

impl Directive {
    /// `at` is the index of the comment's token.
    fn new(context: &Context, at: usize) -> Directive {
        let (text, tokens) = (context.text, &context.document.tokens);
        let token = &tokens[at];
        let is_break = |t: &Token| t.kind == TokenKind::Newline;
        let first = tokens[..at].iter().rposition(is_break).map_or(0, |i| i + 1);
        let last = (tokens[at..].iter().position(is_break)).map_or(tokens.len(), |i| at + i);
        let end = text.len() as u32;
        let line = Span::new(
            tokens[first].start,
            tokens.get(last).map_or(end, |t| t.start),
        );
        // With its line break.
        let whole_line = Span::new(line.start, tokens.get(last).map_or(end, Token::end));
        let items = Items { context };
        let on_line = items.touching(line);
        let no_record = |i: &Item| matches!(i, Item::Void { .. });
        let alone = on_line.iter().all(no_record);
        let covers = if !alone {
            Some(on_line.iter().fold(line, |span, i| span.to(items.span(i))))
        } else if items.none_before(line.start) {
            Some(Span::new(0, end))
        } else {
            items.below(whole_line.end).map(|i| items.line_of(i))
        };
        let list = without_word(directive::inside(token.text(text)), PREFIX)
            .and_then(|rest| without_word(rest, "allow"))
            .and_then(|rest| rest.strip_prefix('('))
            // What follows is the reason.
            .and_then(|rest| rest.split_once(')'));
        let entries = list.map(|(list, _)| {
            let bracket = token.text(text).find('(').map_or(0, |i| i as u32 + 1);
            let start = token.start + bracket;
            let entries = list.split(',').map(|e| e.trim().to_owned());
            (
                entries.collect(),
                Span::new(start, start + list.len() as u32),
            )
        });
        Directive {
            comment: token.span(),
            removal: match alone {
                true => whole_line,
                false => {
                    let before = &text[..token.start as usize];
                    let kept = before.trim_end_matches([' ', '\t']).len();
                    Span::new(kept as u32, token.end())
                }
            },
            entries,
            covers,
        }
    }

    /// Marks what it allows; remarks on what allows nothing or is not understood.
    fn apply(&self, found: &[Diagnostic], allowed: &mut [bool]) -> Vec<Diagnostic> {
        let new = |case| Diagnostic::new(Code::S504, self.comment).case(case);
        let Some((entries, list)) = &self.entries else {
            return vec![new("unknown")];
        };
        let (mut used, mut unused) = (Vec::new(), Vec::new());
        let (mut unknown, mut errors) = (Vec::new(), Vec::new());
        let mut own = false;
        for entry in entries.iter().filter(|e| !e.is_empty()) {
            let Ok(codes) = entry.parse::<Selector>() else {
                unknown.push(crate::syntax::quote(entry));
                continue;
            };
            if codes.only_errors() {
                errors.push(entry.as_str());
            } else if codes.is(Code::S504) {
                // It may be there to allow this very remark.
                own = true;
                used.push(entry.as_str());
            } else if self.allows(&codes, found, allowed) {
                used.push(entry);
            } else {
                unused.push(entry.as_str());
            }
        }
        let mut remarks = Vec::new();
        if entries.iter().any(String::is_empty) {
            remarks.push(new("empty"));
        }
        let count = |list: &[_]| Value::Count(list.len() as u64);
        if !unknown.is_empty() {
            let d = new("no-code").with("count", Value::Count(unknown.len() as u64));
            remarks.push(d.with("text", unknown.join(", ")));
        }
        if !errors.is_empty() {
            let d = new("error").with("count", count(&errors));
            remarks.push(d.with("code", errors.join(", ")));
        }
        if unused.is_empty() || own {
            return remarks;
        }
        let d = new("")
            .with("entries", unused.join(", "))
            .with("count", count(&unused));
        // What is not understood is to be mended first.
        if !remarks.is_empty() {
            remarks.push(d);
            return remarks;
        }
        let (span, text) = match used.as_slice() {
            [] => (self.removal, String::new()),
            used => (*list, used.join(", ")),
        };
        vec![d.fix(Fix::replace("fix", Applicability::Safe, span, text))]
    }

    fn allows(&self, codes: &Selector, found: &[Diagnostic], allowed: &mut [bool]) -> bool {
        let Some(covers) = self.covers else {
            return false;
        };
        let first = found.partition_point(|d| d.span.start < covers.start);
        let mut any = false;
        for (d, allowed) in found[first..].iter().zip(&mut allowed[first..]) {
            if d.span.start > covers.end {
                break;
            }
            if codes.holds(d.code) && !d.code.is_never_allowed() {
                *allowed = true;
                any = true;
            }
        }
        any
    }
}

/// The records and what stands in their place, by their position in the text.
struct Items<'a, 'c> {
    context: &'a Context<'c>,
}

impl<'a> Items<'a, '_> {
    fn span(&self, item: &Item) -> Span {
        self.context.document.item_span(item)
    }

    /// Those that have a part in a stretch of text.
    fn touching(&self, span: Span) -> &'a [Item] {
        let items = &self.context.document.items;
        let first = items.partition_point(|i| self.span(i).end <= span.start);
        let count = items[first..].partition_point(|i| self.span(i).start < span.end);
        &items[first..first + count]
    }

    /// Whether no record begins before a place.
    fn none_before(&self, at: u32) -> bool {
        let items = &self.context.document.items;
        let before = items.partition_point(|i| self.span(i).start < at);
        let void = |i: &Item| matches!(i, Item::Void { .. });
        items[..before].iter().all(void)
    }

    /// The record on the line that begins at a place, or on one of the next lines if nothing but
    /// comments stands between.
    fn below(&self, at: u32) -> Option<&'a Item> {
        let document = self.context.document;
        let first = document.items.partition_point(|i| self.span(i).start < at);
        let void = |i: &&Item| matches!(i, Item::Void { .. });
        let item = document.items[first..].iter().find(|i| !void(i))?;
        let tokens = &document.tokens;
        let from = tokens.partition_point(|t| t.start < at);
        let between = tokens.get(from..item.ends().0 as usize)?;
        // Each line break ends a line with a comment on it: none is blank.
        let lines = between.split(|t| t.kind == TokenKind::Newline);
        let all = lines.clone().count();
        let blank = lines.take(all - 1).any(<[Token]>::is_empty);
        (!blank).then_some(item)
    }

    /// A record with all that stands on its lines.
    fn line_of(&self, item: &Item) -> Span {
        let span = self.span(item);
        let text = self.context.text;
        let rest = &text[span.end as usize..];
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        Span::new(span.start, span.end + end as u32)
    }
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{fixed, found, messages};

    /// A scene with W302 in its second line, and whatever else is put in.
    fn scene(head: &str, above: &str, behind: &str) -> String {
        format!("{head}2 9 1\n{above}35 -201 0.7 0.7 0.7{behind}\n2 -299 0 35\n1 9999 2 0\n")
    }

    #[test]
    fn where_it_covers() {
        let allow = "# zpg: allow(W302) #";
        assert_eq!(found(&scene("", "", "")), ["W302 2:9"]);
        assert!(found(&scene("", "", &format!(" {allow}"))).is_empty());
        assert!(found(&scene("", &format!("{allow}\n"), "")).is_empty());
        assert!(found(&scene("", &format!("0 {allow}\n"), "")).is_empty());
        assert!(found(&scene("", &format!("{allow}\n0 # heading #\n"), "")).is_empty());
        assert!(found(&scene(&format!("{allow}\n"), "", "")).is_empty());
        assert!(found(&scene(&format!("0 # a scene #\n\n{allow}\n\n"), "", "")).is_empty());
        assert!(found(&scene("", "", " # zpg:allow( energy-gain ) #")).is_empty());
        assert!(found(&scene("", "", " ## zpg: allow(w302) ##")).len() > 1);
        // A line too far up, or a record further down.
        assert_eq!(
            found(&scene("", &format!("{allow}\n\n"), "")),
            ["S504 2:1", "W302 4:9"]
        );
        assert_eq!(
            found(&scene("", "", &format!("\n{allow}"))),
            ["W302 2:9", "S504 3:1"]
        );
    }

    #[test]
    fn the_next_line_is_not_covered() {
        // What is found there begins in its first column.
        let scene = "10 -701 1 0 0 # zpg: allow(W310) #\n11 -701 1 0 0\n2 9 1\n1 9999 2 0\n";
        assert_eq!(found(scene), ["W310 2:1"]);
        assert_eq!(found(&scene.replace('\n', "\r\n")), ["W310 2:1"]);
        let above = scene.replace("10 -701 1 0 0 #", "0 # a scene #\n\n#");
        assert!(found(&above).is_empty());
    }

    #[test]
    fn reasons_groups_and_any_case() {
        for comment in [
            "zpg: allow(W302) that is how it is lit",
            "ZPG: Allow(w302)",
            "zpg: allow (W3)",
            "zpg: allow(warnings): all of them (really)",
        ] {
            let scene = scene("", "", &format!(" # {comment} #"));
            assert!(found(&scene).is_empty(), "{comment}");
        }
        let unused = scene("", "", " # ZPG: allow( W302 ,style) so be it #");
        assert_eq!(found(&unused), ["S504 2:21"]);
        let mended = scene("", "", " # ZPG: allow(W302) so be it #");
        assert_eq!(fixed(&unused), mended);
    }

    #[test]
    fn the_lines_of_a_record_are_one() {
        let scene =
            "2 9 1\n35 -202 0.7 0.7 0.7\n 0 0 0 # zpg: allow(W302) #\n 0 0 0\n2 -299 0 35\n";
        assert!(found(scene).is_empty());
    }

    #[test]
    fn what_allows_nothing_is_said_and_goes() {
        let one = scene("", "", " # zpg: allow(W302, W320) #");
        assert_eq!(found(&one), ["S504 2:21"]);
        assert_eq!(fixed(&one), scene("", "", " # zpg: allow(W302) #"));
        let trailing = "2 9 1 # zpg: allow(W302) #\n1 9999 2 0 # keep #\n";
        assert_eq!(found(trailing), ["S504 1:7"]);
        assert_eq!(fixed(trailing), "2 9 1\n1 9999 2 0 # keep #\n");
        let alone = "2 9 1\n0 # zpg: allow(W302) #\r\n1 9999 2 0\n";
        assert_eq!(fixed(alone), "2 9 1\n1 9999 2 0\n");
        let head = "# zpg: allow(W302, W303) #\n2 9 1\n1 9999 2 0\n";
        assert_eq!(fixed(head), "2 9 1\n1 9999 2 0\n");
        assert!(found("# zpg: allow(S504, W303) #\n2 9 1\n").is_empty());
    }

    #[test]
    fn what_is_not_understood() {
        let says = |comment: &str| messages(&format!("2 9 1 # {comment} #\n"));
        assert_eq!(
            says("zpg: alow(W302)"),
            ["zpg does not understand this comment"]
        );
        assert_eq!(says("zpg: allow(W999)"), ["there is no code `W999`"]);
        assert_eq!(
            says("zpg: allow(E101)"),
            ["an error, E101, cannot be allowed"]
        );
        assert!(says("zpg is a language").is_empty());
        assert!(says("zpg: allow").len() == 1 && says("zpg: allow(S504) (").is_empty());
        let empty = "an entry of this comment is empty";
        assert_eq!(says("zpg: allow()"), [empty]);
        assert_eq!(
            says("zpg: allow(W399, W301, E2, what,, E101)"),
            [
                empty,
                "there are no codes `W399`, `what`",
                "errors cannot be allowed: E2, E101",
                "W301 is allowed here, but not found"
            ]
        );
    }
}
