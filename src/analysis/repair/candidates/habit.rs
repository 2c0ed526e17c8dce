//! The ways in which lines are miswritten.

use crate::diagnostics::{Code, Diagnostic};

/// The kinds of slips that people make, the most frequent first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::analysis::repair) enum Habit {
    /// The minus of a type is lost, or there is one too many.
    Sign,
    /// One of the two cameras of a stereo view is left out, and there is only one other camera.
    Eye,
    /// The space behind a type is lost, and the record above or below has that type.
    GluedAsBeside,
    /// A digit of a type is lost, doubled or wrong, or two are exchanged.
    Digit,
    /// Several numbers stand in one token.
    Glued,
    /// A number has letters, signs or units in it; a file name has spaces.
    Characters,
    /// A word stands in the place of a type's number.
    Word,
    /// The name of a type stands before the ID.
    Keyword,
    /// The name of a type stands in the place of the ID.
    Unnamed,
    /// The type of an operation stands between its operands.
    Infix,
    /// ID and type stand in each other's place.
    Exchanged,
    /// A comment lacks the `#` around it.
    Comment,
    /// A profile says another number of points than it has.
    Count,
    /// Numbers are written twice, or one is too many.
    Doubled,
    /// An axis is a letter, or stands before its angle.
    Axis,
    /// The numbers are those of a sibling, a type that people take for the written one.
    Sibling,
    /// The numbers that are too many are a record of their own.
    Apart,
    /// A camera lacks its up vector, and its direction has the length 1, so it is hardly a point.
    Direction,
    /// The direction of a camera is the point that it looks at.
    Point,
    /// The up vector of a camera is parallel to its direction or left out, or the angle is left out or in a wrong
    /// place.
    Up,
    /// The space between two digits is lost, so that they read as one number.
    Split,
    /// One of many numbers is lost.
    Lost,
    /// Two references stand in each other's place.
    Swapped,
    /// All references are off by the same number.
    Shifted,
    /// A single reference should name another ID.
    Reference,
    /// The record stands between records of another ID, and should have that ID.
    Between,
    /// The finding itself proposes the fix.
    Proposed,
    /// The record should have another ID.
    Id,
    /// The record should have another type.
    Type,
    /// The type is left out.
    NoType,
}

impl Habit {
    /// Whether fixes of this habit replace an ID by another.
    pub(in crate::analysis::repair) fn names_another(self) -> bool {
        matches!(self, Habit::Shifted | Habit::Reference | Habit::Proposed)
    }

    /// Whether a finding speaks of the fault that fixes of this habit repair. If not, `LineContext::matter` does.
    pub(in crate::analysis::repair) fn is_said_by(self, finding: &Diagnostic) -> bool {
        use Code::*;
        match self {
            Habit::Sign => matches!(finding.code, E007 | E103),
            Habit::Characters => matches!(
                finding.code,
                E001 | E002 | E003 | E004 | E006 | E007 | E010 | E011 | E012
            ),
            Habit::Glued | Habit::GluedAsBeside => finding.case == "glued",
            Habit::Exchanged => finding.case == "exchanged",
            Habit::Word | Habit::Keyword => finding.code == E006,
            Habit::Comment => matches!(finding.code, E001 | E002 | E003 | E007 | E009 | E012),
            Habit::Doubled | Habit::Sibling => matches!(finding.code, E008 | E009),
            Habit::Apart => matches!(finding.code, E003 | E007 | E008 | E009 | E012 | E101),
            Habit::Count => matches!(finding.case, "points" | "space") || finding.code == E013,
            Habit::Direction | Habit::Point | Habit::Up => {
                matches!(finding.code, E008 | E203 | E206 | E207)
            }
            Habit::Split | Habit::Lost | Habit::Eye => finding.code == E008,
            Habit::Swapped => {
                matches!(finding.code, E101 | E103 | E104 | E107 | E108 | W319)
            }
            Habit::Unnamed => finding.code == E005,
            Habit::NoType | Habit::Axis => false,
            // Candidates of these habits are made only for findings that speak of them.
            Habit::Infix
            | Habit::Digit
            | Habit::Shifted
            | Habit::Reference
            | Habit::Id
            | Habit::Between
            | Habit::Type
            | Habit::Proposed => true,
        }
    }
}
