//! A tool that reaches a hair further.

use crate::diagnostics::{Applicability, Edit, Fix};
use crate::lint::spelling::spelled;
use crate::scene::Geometry;
use crate::scene::record::Params;
use crate::solids::contacts::search::Side;
use crate::solids::shapes::facts::{Facts, Moved};

/// How much longer a tool becomes: too little to be seen, and a million times what counts as flush.
const HAIR: f64 = 1e-3;

/// Moves the given faces of a tool outwards. `workpiece` is the size of what it cuts.
pub fn lengthen(p: &Params, geometry: &Geometry, tool: &[Side], workpiece: f64) -> Option<Fix> {
    // What each parameter becomes, and how far it is moved.
    let mut moved: Vec<Moved> = Vec::new();
    for side in tool {
        let room = HAIR * workpiece / side.stretch;
        moved.extend(geometry.moved_out(side.part, HAIR, room)?);
    }
    moved.sort_by_key(|m| m.0);
    moved.dedup_by_key(|m| m.0);
    let edits: Option<Vec<Edit>> = moved
        .into_iter()
        .map(|(i, x, hair)| {
            Some(Edit {
                span: p.span_of(i, 1),
                text: short(x, hair)?,
            })
        })
        .collect();
    let edits = edits.filter(|e| !e.is_empty())?;
    Some(Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Unsafe,
        edits,
    })
}

/// A number with no more digits than it takes to tell by how much it was moved.
fn short(x: f64, hair: f64) -> Option<String> {
    let decimals = (2.0 - hair.log10().floor()).clamp(0.0, 300.0) as usize;
    format!("{x:.decimals$}").parse().ok().map(spelled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_short() {
        assert_eq!(short(0.3 + 0.1 + 0.2 + 0.001, 0.001).unwrap(), "0.601");
        assert_eq!(short(-1.0015, 0.0015).unwrap(), "-1.0015");
        assert_eq!(short(2.002e-7, 2e-10).unwrap(), "2.002e-7");
        assert_eq!(short(123_456_789.4, 123.0).unwrap(), "123456789");
    }
}
