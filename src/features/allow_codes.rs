//! Proposals between the brackets of `# zpg: allow(…) #`.

use crate::analysis::Analysis;
use crate::diagnostics::{Code, Span};
use crate::syntax::directive::{PREFIX, without_word};
use crate::syntax::lexer::Token;

use super::completion::{Completion, Insert, Proposal, SnippetPart, Sort};

/// The codes that may be typed at an offset between the brackets. Codes of findings come first, the nearest finding
/// at the top. `None` outside of the brackets.
pub(super) fn completion(analysis: &Analysis, offset: u32) -> Option<Completion> {
    let tokens = &analysis.document.tokens;
    let at = tokens
        .partition_point(|t| t.start < offset)
        .checked_sub(1)?;
    let (list, word) = place(&tokens[at], &analysis.source.text, offset)?;
    let line = |at: u32| analysis.source.line_index(at);
    let own = line(offset);
    let mut found: Vec<(usize, Code)> = (analysis.findings().iter())
        .map(|d| (line(d.span.start).abs_diff(own), d.code))
        .collect();
    found.sort_by_key(|f| f.0);
    let mut codes: Vec<Code> = Vec::new();
    for code in found
        .into_iter()
        .map(|f| f.1)
        .chain(Code::ALL.iter().copied())
    {
        let is_there = |entry: &str| entry.eq_ignore_ascii_case(code.as_str());
        if !code.is_never_allowed() && !codes.contains(&code) && !list.iter().any(|e| is_there(e)) {
            codes.push(code);
        }
    }
    let proposal = |code: Code| Proposal {
        label: code.as_str().to_owned(),
        detail: code.name().to_owned(),
        doc: String::new(),
        filter: format!("{} {}", code.as_str(), code.name()),
        insert: Insert(vec![SnippetPart::Fixed(code.as_str().to_owned())]),
        kind: Sort::Value,
    };
    Some(Completion {
        word,
        proposals: codes.into_iter().map(proposal).collect(),
    })
}

/// The other entries of the list that an offset is in, and the span of what has been typed of its own entry. `None`
/// if the offset is in no list.
fn place<'a>(comment: &Token, text: &'a str, offset: u32) -> Option<(Vec<&'a str>, Span)> {
    if !comment.kind().is_comment() || offset > comment.end() {
        return None;
    }
    // The bracket, and the comment, may not be closed yet.
    let before = text.get(comment.start as usize..offset as usize)?;
    let inside = before.trim_start_matches('#').trim_start();
    let list = without_word(without_word(inside, PREFIX)?, "allow")?.strip_prefix('(')?;
    if list.contains([')', '#']) {
        return None;
    }
    let behind = &text[offset as usize..comment.end() as usize];
    let behind = behind.split([')', '#']).next().unwrap_or_default();
    let (others, word) = list.rsplit_once(',').unwrap_or(("", list));
    let others = others.split(',').chain(behind.split(',').skip(1));
    let length = word.trim_start().len() as u32;
    Some((
        others.map(str::trim).collect(),
        Span::new(offset - length, offset),
    ))
}
