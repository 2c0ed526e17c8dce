//! What can be done about findings, and to a whole file.

use crate::analysis::{Analysis, Settings, fixing, repair};
use crate::diagnostics::{
    Applicability, Code, Complaint, Diagnostic, Edit, Language, SourceFile, Span, fixes,
};
use crate::syntax::directive::is_directive;
use crate::syntax::lexer::TokenKind;

use super::formatting;

/// Something that is offered at a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Action {
    pub title: String,
    pub what: What,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum What {
    /// Mends a finding, the one with this index among all; a safe fix is the preferred one.
    Fix {
        finding: usize,
        edits: Vec<Edit>,
        preferred: bool,
    },
    /// Has a comment allow a finding.
    Allow { finding: usize, edits: Vec<Edit> },
    /// Shows the page of a code.
    Explain(Code),
}

/// What is offered for the findings that touch a stretch of text: fixes first.
pub fn actions(analysis: &Analysis, span: Span, language: Language) -> Vec<Action> {
    let touches = |d: &Diagnostic| d.span.start <= span.end && span.start <= d.span.end;
    let here = || {
        analysis
            .findings()
            .iter()
            .enumerate()
            .filter(|(_, d)| touches(d))
    };
    let mut out = Vec::new();
    // What was meant is tried when somebody asks for it, not with every key.
    let proposals = match here().any(|(_, d)| repair::is_tried(d)) {
        true => repair::proposals(analysis),
        false => Vec::new(),
    };
    for (finding, d) in here() {
        let same = |p: &&Diagnostic| (p.code, p.span) == (d.code, d.span);
        let d = proposals.iter().find(same).unwrap_or(d);
        let titles = d.wording(language).fixes;
        let first_safe = d
            .fixes
            .iter()
            .position(|f| f.applicability == Applicability::Safe);
        for (i, (fix, title)) in d.fixes.iter().zip(titles).enumerate() {
            let (edits, _) = fixes::edits(&analysis.source.text, [fix].into_iter());
            let preferred = first_safe == Some(i);
            out.push(Action {
                title,
                what: What::Fix {
                    finding,
                    edits,
                    preferred,
                },
            });
        }
    }
    let mut seen: Vec<Code> = Vec::new();
    for (finding, d) in here().filter(|(_, d)| !d.code.is_never_allowed()) {
        if let Some(edit) = allow(analysis, d)
            && !seen.contains(&d.code)
        {
            seen.push(d.code);
            out.push(Action {
                title: said("lsp-allow", d.code, language),
                what: What::Allow {
                    finding,
                    edits: vec![edit],
                },
            });
        }
    }
    let mut codes: Vec<Code> = here().map(|(_, d)| d.code).collect();
    codes.dedup();
    for code in codes {
        out.push(Action {
            title: said("lsp-explain", code, language),
            what: What::Explain(code),
        });
    }
    out
}

fn said(message: &'static str, code: Code, language: Language) -> String {
    let complaint = Complaint::new(message)
        .with("code", code.as_str())
        .with("name", code.name());
    complaint.wording(language)
}

/// A comment that allows a finding: behind the record, or at the head of the file where the finding is about
/// no record. A comment that is there already is made longer.
fn allow(analysis: &Analysis, d: &Diagnostic) -> Option<Edit> {
    let (document, source) = (&analysis.document, &analysis.source);
    let items = super::place::items_in(document, Span::new(d.span.start, d.span.start + 1));
    let Some(item) = document
        .items
        .get(items.start)
        .filter(|_| !items.is_empty())
    else {
        let start = u32::from(source.text.starts_with('\u{feff}')) * 3;
        let break_ = crate::diagnostics::source::line_break(&source.text);
        let text = format!("# zpg: allow({}) #{break_}", d.code.as_str());
        let span = Span::new(start, start);
        return Some(Edit { span, text });
    };
    let tokens = &document.tokens;
    let behind = item.ends().1 as usize + 1;
    let on_line = tokens[behind..]
        .iter()
        .take_while(|t| t.kind() != TokenKind::Newline);
    let mut end = tokens[item.ends().1 as usize].end();
    for token in on_line {
        if token.kind() == TokenKind::UnterminatedComment {
            return None;
        }
        if is_directive(token, &source.text) {
            let close = token.text(&source.text).find(')')?;
            let at = token.start + close as u32;
            return Some(Edit {
                span: Span::new(at, at),
                text: format!(", {}", d.code.as_str()),
            });
        }
        // A comment of several lines ends elsewhere.
        if source.line_index(token.end()) != source.line_index(end) {
            return None;
        }
        end = token.end();
    }
    let text = format!(" # zpg: allow({}) #", d.code.as_str());
    let span = Span::new(end, end);
    Some(Edit { span, text })
}

/// Whether "fix all" would find something to do.
pub fn has_safe_fixes(analysis: &Analysis) -> bool {
    let is_safe = |d: &Diagnostic| d.applicable_fix(false).is_some();
    analysis.findings().iter().any(is_safe)
}

/// Applies all safe fixes, as `zpg check --fix` does.
pub fn fix_all(analysis: &Analysis, settings: &Settings) -> Vec<Edit> {
    let read = |source: SourceFile| Analysis::of(source).with_settings(settings.clone());
    let text = &analysis.source.text;
    let again = read(analysis.source.with_text(text.clone()));
    let mended = fixing::to_fixed_point(again, false, read);
    formatting::edits(text, &mended.analysis.source.text)
}
