//! Helpers that tests share.

use crate::diagnostics::{Diagnostic, SourceFile};
use crate::scene::{self, Geometry, Scene};
use crate::syntax;

/// Numbers below another one, the same each time (Knuth's MMIX, The Art of Computer Programming, 3.3.4).
pub(crate) fn random() -> impl FnMut(u64) -> u64 {
    let mut state = 12345u64;
    move |n| {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) % n
    }
}

/// The scene of a text that has no errors.
pub(crate) fn scene(text: &str) -> Scene {
    let source = SourceFile::new("scene.zpg", text.into());
    let (document, mut found) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut found);
    assert!(!found.iter().any(Diagnostic::is_error), "{found:?}");
    scene
}

/// Solids of most kinds that end.
pub(crate) fn solids() -> Vec<Geometry> {
    vec![
        Geometry::Sphere {
            centre: [1.0, 2.0, 3.0],
            radius: 0.5,
        },
        Geometry::Ellipsoid {
            semi_axes: [1.0, 2.0, 3.0],
        },
        Geometry::Box {
            min: [-1.0, 0.0, 2.0],
            max: [1.0, 3.0, 2.5],
        },
        Geometry::Torus {
            major: 2.0,
            minor: 0.5,
        },
        Geometry::Cone {
            height: -2.0,
            radius: 0.7,
        },
        Geometry::DoubleCone {
            height: 2.0,
            radius: 0.7,
        },
        Geometry::Revolution {
            profile: vec![[0.0, -1.0], [2.0, 0.0], [1.0, 2.0]],
            colours: Vec::new(),
        },
        Geometry::Revolution {
            profile: vec![[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]],
            colours: Vec::new(),
        },
    ]
}
