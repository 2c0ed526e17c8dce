//! The words of a finding, which have to fit its first proposal.

use super::candidates::{Candidate, Habit, LineContext};
use crate::diagnostics::{Code, Diagnostic, Value};

/// Gives a finding its fixes. If the first fix repairs another fault than the finding speaks of, the finding is worded
/// anew.
pub(super) fn retell(finding: &mut Diagnostic, best: &[&Candidate], place: &LineContext) {
    let new = best.iter().map(|c| c.fix.clone()).collect();
    let own = std::mem::replace(&mut finding.fixes, new);
    let Some(first) = best.first() else { return };
    let is_said = first.habit.is_said_by(finding) && !is_other(finding, first, place);
    let matter = match is_said {
        true => None,
        false => place.matter(first),
    };
    if let Some(matter) = matter {
        let mut fixes = std::mem::take(&mut finding.fixes);
        // The fixes that the finding itself proposed fit only its old words.
        fixes.retain(|f| !own.iter().any(|o| o.title == f.title && o.edits == f.edits));
        *finding = Diagnostic { fixes, ..matter };
    } else if finding.code == Code::E007 {
        finding.values.retain(|v| v.0 == "text");
        finding.case = "";
        if let Some(ty) = first.ty {
            finding.case = "proposal";
            finding.values.push(("number", ty.code.to_string().into()));
            finding.values.push(("type", Value::Term(ty.title)));
        }
        for fix in finding.fixes.iter_mut().filter(|f| f.title == "fix") {
            fix.title = "fix-type";
        }
    }
    if first.habit == Habit::Comment && finding.code == Code::E009 {
        finding.notes.push("comment-ends");
    }
    if let Some(fix) = finding.fixes.iter().find(|f| f.title == "fix") {
        // The words of the finding may name the number that the fix writes.
        let written = fix.values.iter().find(|v| v.0 == "number").cloned();
        finding
            .values
            .retain(|v| v.0 != "number" || written.is_none());
        finding.values.extend(written);
    }
}

/// Whether a finding counts the numbers for another type than the line has, while the proposal keeps the type of the
/// line, or counts points where the proposal reads other numbers.
fn is_other(finding: &Diagnostic, first: &Candidate, place: &LineContext) -> bool {
    let is_count = matches!(finding.code, Code::E008 | Code::E009);
    let is_kept = first.ty.is_none() && matches!(first.habit, Habit::Doubled | Habit::Sibling);
    let said = finding.values.iter().find(|v| v.0 == "type");
    let own = place.ty().map(|ty| ty.title);
    let is_own =
        said.is_none_or(|(_, said)| matches!(said, Value::Term(said) if Some(*said) == own));
    // The points that the finding counts are none if commas between their numbers are decimal.
    let is_recounted = finding.case == "points" && first.habit == Habit::Doubled;
    is_count && is_kept && !is_own || is_recounted
}
