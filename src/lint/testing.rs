//! The findings in scenes that tests make. Scenes that are written down stand in the folders of the rules.

use crate::diagnostics::{self, Code, Diagnostic, Language, SourceFile};
use crate::{scene, syntax};

/// The findings of a few records, but for the lack of a render record, a camera and a light.
fn findings(text: &str) -> (SourceFile, Vec<Diagnostic>) {
    let source = SourceFile::new("t.zpg", text.into());
    let (document, mut all) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut all);
    let bounds = Default::default();
    let context = super::Context::new(&source.text, &document, &scene, &bounds);
    super::run(&context, |_| true, &mut all);
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

/// The findings, as `CODE line:column`.
pub(crate) fn found(scene: &str) -> Vec<String> {
    let (source, all) = findings(scene);
    all.iter()
        .map(|d| {
            let at = source.position(d.span.start);
            format!("{} {}:{}", d.code.as_str(), at.line, at.column)
        })
        .collect()
}

/// The messages of all findings.
pub(crate) fn messages(scene: &str) -> Vec<String> {
    let words = |d: &Diagnostic| d.wording(Language::English).message;
    findings(scene).1.iter().map(words).collect()
}
