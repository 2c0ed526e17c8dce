//! Rules tested as data: a scene, what is found in it, and what a fix makes of it.

use crate::diagnostics::{self, Applicability, Code, Diagnostic, Language, SourceFile};
use crate::{scene, syntax};

/// What is found in a few records, but for the lack of a render record, a camera and a light.
fn findings(text: &str) -> (SourceFile, Vec<Diagnostic>) {
    let source = SourceFile::new("t.zpg", text.into());
    let (document, mut all) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut all);
    let context = super::Context::new(&source.text, &document, &scene);
    super::run(&context, &mut all);
    diagnostics::sort(&mut all);
    let aside = [Code::E106, Code::N602, Code::N603];
    all.retain(|d| !aside.contains(&d.code));
    // Nothing may be missing in any language: that is asserted where it is put into words.
    for d in &all {
        d.wording(Language::English);
        d.wording(Language::Czech);
    }
    (source, all)
}

/// What is found, as `CODE line:column`.
pub fn found(scene: &str) -> Vec<String> {
    let (source, all) = findings(scene);
    all.iter()
        .map(|d| {
            let at = source.position(d.span.start);
            format!("{} {}:{}", d.code.as_str(), at.line, at.column)
        })
        .collect()
}

/// The messages of all findings.
pub fn messages(scene: &str) -> Vec<String> {
    let words = |d: &Diagnostic| d.wording(Language::English).message;
    findings(scene).1.iter().map(words).collect()
}

/// Titles and applicabilities of all fixes.
pub fn fixes(scene: &str) -> Vec<(String, Applicability)> {
    let titles = |d: Diagnostic| {
        let words = d.wording(Language::English);
        words.fixes.into_iter().zip(d.fixes)
    };
    let all = findings(scene).1.into_iter().flat_map(titles);
    all.map(|(title, f)| (title, f.applicability)).collect()
}

/// The scene with the first fix of every finding applied. No two edits may overlap.
pub fn fixed(scene: &str) -> String {
    let all = findings(scene).1;
    let mut edits: Vec<_> = all
        .into_iter()
        .filter_map(|d| d.fixes.into_iter().next())
        .flat_map(|f| f.edits)
        .collect();
    edits.sort_by_key(|e| e.span);
    let mut text = String::new();
    let mut at = 0;
    for e in &edits {
        text += &scene[at..e.span.start as usize];
        text += &e.text;
        at = e.span.end as usize;
    }
    text + &scene[at..]
}
