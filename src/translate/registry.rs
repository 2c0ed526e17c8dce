//! All targets of translations.

use super::target::Target;
use super::{json, mesh, mitsuba, pov};
use std::path::Path;

/// All targets in the order of `--help`.
pub static TARGETS: [&dyn Target; 8] = [
    &pov::target::Pov,
    &mitsuba::target::Mitsuba,
    &mesh::target::Format::Ply,
    &mesh::target::Format::Obj,
    &mesh::target::Format::Glb,
    &mesh::target::Format::Stl,
    &json::target::Json,
    &json::target::Zpg,
];

/// The target of this name.
pub fn named(name: &str) -> Option<&'static dyn Target> {
    TARGETS.into_iter().find(|target| target.name() == name)
}

/// The target whose files have names with the ending of this one; the first if there are several.
pub fn of_file(path: &Path) -> Option<&'static dyn Target> {
    let ending = path.extension()?.to_str()?;
    let is_its = |target: &&dyn Target| target.ending().eq_ignore_ascii_case(ending);
    TARGETS.into_iter().find(is_its)
}
