//! Numbers as other programs write them: a quaternion, points of a profile in space, a colour's alpha, a 3 × 3 matrix.
//! Surplus numbers may also be another record, which lacks numbers itself.

use super::TRIALS;
use super::candidates::LineContext;
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic};

/// Adds to findings about surplus numbers, and about too few numbers of a matrix, what the numbers may be.
pub(super) fn retell(analysis: &Analysis, findings: &mut [Diagnostic]) {
    let is_surplus = |d: &&mut Diagnostic| matches!(d.code, Code::E008 | Code::E009);
    for d in findings.iter_mut().filter(is_surplus).take(TRIALS) {
        for place in LineContext::both(analysis, d.span.start) {
            if d.code == Code::E008 {
                match place.is_smaller_matrix() {
                    true => d.notes.push("smaller-matrix"),
                    false => continue,
                }
            } else if place.has_alpha() {
                d.notes.push("alpha");
            } else if place.is_turn_about_no_axis() {
                d.notes.push("quaternion");
            } else if let Some(in_space) = place.points_in_space() {
                *d = in_space;
            } else if let Some(fix) = place.incomplete_behind() {
                d.fixes.push(fix);
            } else {
                continue;
            }
            break;
        }
    }
}
