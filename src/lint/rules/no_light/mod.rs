//! N603: the scene has no light, so automatic lights are added.

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::syntax::Item;
use crate::syntax::table::{Kind, RecordKind};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    let scene = context.scene;
    let light = |k: Option<Kind>| matches!(k, Some(Kind::AmbientLight | Kind::PointLight));
    // A light with an error was meant to be there.
    let meant = |item: &Item| match item {
        Item::Record(r) => matches!(r.kind, RecordKind::AmbientLight | RecordKind::PointLight),
        Item::Broken(b) => b
            .kind
            .is_none_or(|kind| matches!(kind, RecordKind::AmbientLight | RecordKind::PointLight)),
        Item::Void { .. } => false,
    };
    let contents = &context.document.contents;
    let certain =
        !contents.broken && !contents.has(&[RecordKind::AmbientLight, RecordKind::PointLight]);
    let none = || {
        scene.ambient_lights.is_empty()
            && scene.point_lights.is_empty()
            && !scene.entities.iter().any(|e| light(e.kind))
            && !context.document.items.iter().any(meant)
    };
    if certain || none() {
        out.push(Diagnostic::new(Code::N603, render.span));
    }
}

#[cfg(test)]
mod tests {
    use crate::diagnostics::SourceFile;
    use crate::lint::Context;
    use crate::{scene, syntax};

    fn dark(text: &str) -> bool {
        let source = SourceFile::new("t.zpg", text.into());
        let (document, mut all) = syntax::parse(text);
        let scene = scene::resolve(&document, &source, &mut all);
        let mut out = Vec::new();
        let bounds = Default::default();
        super::check(&Context::new(text, &document, &scene, &bounds), &mut out);
        !out.is_empty()
    }

    #[test]
    fn a_light_that_is_wrong_is_one() {
        assert!(dark("2 9 1\n1 9999 2 0\n"));
        assert!(!dark("2 9 1\n50 -402 1\n1 9999 2 0\n"));
        assert!(!dark("2 9 1\n50 -402 x\n1 9999 2 0\n"));
        // Defined twice.
        assert!(!dark("2 9 1\n50 -701 1 1 1\n50 -402 1\n1 9999 2 0\n"));
    }
}
