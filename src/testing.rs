//! What tests share.

use crate::diagnostics::{Diagnostic, SourceFile};
use crate::scene::{self, Scene};
use crate::syntax;

/// Numbers below another one, the same each time (Knuth's MMIX, The Art of Computer Programming, 3.3.4).
pub fn random() -> impl FnMut(u64) -> u64 {
    let mut state = 12345u64;
    move |n| {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) % n
    }
}

/// The scene of a text that has no errors.
pub fn scene(text: &str) -> Scene {
    let source = SourceFile::new("scene.zpg", text.into());
    let (document, mut found) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut found);
    assert!(!found.iter().any(Diagnostic::is_error), "{found:?}");
    scene
}
