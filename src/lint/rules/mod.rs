//! One folder a rule.
//!
//! A folder has the name of the rule's code, with underscores, and holds
//!
//! - `mod.rs`: `check`, which looks at a scene and adds its findings;
//! - `explain.md`: the page of `zpg explain`, with a scene that is wrong and one that is right, both of which
//!   a test checks; `explain.cs.md` is the place of the Czech page;
//! - `en.ftl` and `cs.ftl`: its messages;
//! - `tests/*.zpg`: scenes, and beside each a snapshot of all that is printed about it and of what fixes make
//!   of it (`tests/lint_rules.rs` runs them).
//!
//! Three lines name the folder: the code's in `diagnostics/code.rs`, and two here.

mod asymmetric_quadric;
mod bare_comment;
mod bound_too_small;
mod coincident_faces;
mod colour_out_of_range;
mod comment_hides_records;
mod degenerate_shape;
mod empty_result;
mod energy_gain;
mod ill_scaled;
mod mixed_intersection;
mod no_camera;
mod no_light;
mod no_real_points;
mod not_a_rotation;
mod notation_separator;
mod overlapping_union;
mod pointless_index;
mod scene_box_cuts;
mod self_intersecting;
mod several_cameras;
mod several_records_per_line;
mod stale_operand;
mod surface_operand;
mod unused_definition;

use super::Context;
use crate::diagnostics::Diagnostic;

/// Looks at a scene and adds its findings.
pub type Rule = fn(&Context, &mut Vec<Diagnostic>);

/// Every rule. Those that may take longest come first: they are begun in this order.
pub const RULES: &[Rule] = &[
    coincident_faces::check,
    overlapping_union::check,
    bound_too_small::check,
    scene_box_cuts::check,
    empty_result::check,
    mixed_intersection::check,
    unused_definition::check,
    stale_operand::check,
    colour_out_of_range::check,
    energy_gain::check,
    not_a_rotation::check,
    asymmetric_quadric::check,
    degenerate_shape::check,
    no_real_points::check,
    surface_operand::check,
    comment_hides_records::check,
    several_cameras::check,
    pointless_index::check,
    self_intersecting::check,
    ill_scaled::check,
    no_camera::check,
    no_light::check,
    notation_separator::check,
    bare_comment::check,
    several_records_per_line::check,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Code;
    use std::fs;
    use std::path::Path;

    /// Every folder is listed, as a rule and with its code, and has its files.
    #[test]
    fn folders_are_complete() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lint/rules");
        let mut count = 0;
        for entry in fs::read_dir(root).unwrap().map(Result::unwrap) {
            let path = entry.path();
            if !path.is_dir() {
                continue;
            }
            for file in ["mod.rs", "explain.md", "en.ftl", "cs.ftl"] {
                assert!(path.join(file).exists(), "{} lacks {file}", path.display());
            }
            let name = entry.file_name().into_string().unwrap().replace('_', "-");
            let code = Code::ALL.iter().find(|c| c.name() == name);
            let page = fs::read_to_string(path.join("explain.md")).unwrap();
            assert!(code.is_some_and(|c| c.explanation() == page), "{name}");
            count += 1;
        }
        assert_eq!(count, RULES.len());
    }
}
