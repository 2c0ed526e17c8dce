//! Code actions: fixes of findings, and actions on a whole file.

use crate::analysis::{Analysis, Settings, allowing, fixing, repair};
use crate::diagnostics::{
    Applicability, Code, Complaint, Diagnostic, Edit, Language, SourceFile, Span, fixes,
};

use super::formatting;

/// An action that is offered at a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Action {
    pub title: String,
    pub what: What,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum What {
    /// Mends the finding with this index among all. `preferred` marks the first safe fix, if `zpg check --fix` would
    /// apply it.
    Fix {
        finding: usize,
        edits: Vec<Edit>,
        preferred: bool,
    },
    /// Adds a comment that allows the finding with this index among all.
    Allow { finding: usize, edits: Vec<Edit> },
    /// Shows the page of a code.
    Explain(Code),
}

/// The actions that are offered for the findings that touch a stretch of text: fixes first.
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
    // Repairs are tried only when somebody asks for actions at their finding, not with every key.
    let proposals = match here().any(|(_, d)| repair::is_tried(d)) {
        true => repair::proposals(analysis),
        false => Vec::new(),
    };
    let mut left = allowing::TRIED_BYTES;
    // In a long scene a fix is taken as applied without a trial: nobody waits for the cursor.
    let mut is_applied = |fix| match left.checked_sub(analysis.source.text.len()) {
        Some(rest) => {
            left = rest;
            fixing::is_applied(analysis, fix)
        }
        None => true,
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
            let preferred = first_safe == Some(i) && is_applied(fix);
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
    let mut finder = None;
    for (finding, d) in here().filter(|(_, d)| !d.code.is_never_allowed()) {
        if seen.contains(&d.code) {
            continue;
        }
        let finder = finder.get_or_insert_with(|| allowing::Finder::new(analysis));
        if let Some(edit) = finder.edit(d) {
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

/// Whether "fix all" would find something to do.
pub fn has_safe_fixes(analysis: &Analysis) -> bool {
    let is_safe = |d: &Diagnostic| d.applicable_fix(false).is_some();
    analysis.findings().iter().any(is_safe)
}

/// The edits of all safe fixes, applied as `zpg check --fix` does.
pub fn fix_all(analysis: &Analysis, settings: &Settings) -> Vec<Edit> {
    let read = |source: SourceFile| Analysis::of(source).with_settings(settings.clone());
    let text = &analysis.source.text;
    let again = read(analysis.source.with_text(text.clone()));
    let mended = fixing::to_fixed_point(again, false, read);
    formatting::edits(text, &mended.analysis.source.text)
}
