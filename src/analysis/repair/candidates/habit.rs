//! The ways in which lines are miswritten.

use crate::diagnostics::{Code, Diagnostic};

/// Habits of people, the most frequent first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::analysis::repair) enum Habit {
    /// The minus of a type is lost, or there is one too many.
    Sign,
    /// The camera of one eye is left out, and but one other camera is there.
    Eye,
    /// A space is lost behind a type that the record above or below has.
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
    /// A comment has no signs around it.
    Comment,
    /// A profile says another number of points than it has.
    Count,
    /// Numbers stand there twice, or one is too many.
    Doubled,
    /// An axis is a letter, or stands before its angle.
    Axis,
    /// The record is that of a sibling.
    Sibling,
    /// The numbers that are too many are a record of their own.
    Apart,
    /// The direction of a camera has the length 1, so it is one.
    Direction,
    /// The direction of a camera is the point that it looks at.
    Point,
    /// The up vector of a camera is along its direction.
    Up,
    /// A space is lost within a whole number, which is two digits.
    Split,
    /// A number of many is lost.
    Lost,
    /// Two references stand in each other's place.
    Swapped,
    /// All references are off by the same number.
    Shifted,
    /// A single reference names something else.
    Reference,
    /// The record stands between those of another ID, and has that one.
    Between,
    /// The finding itself proposes the fix.
    Proposed,
    /// The record has another ID.
    Id,
    /// The record has another type.
    Type,
    /// The type is left out.
    NoType,
}

impl Habit {
    /// Whether this puts another ID in the place of one.
    pub(in crate::analysis::repair) fn names_another(self) -> bool {
        matches!(self, Habit::Shifted | Habit::Reference | Habit::Proposed)
    }

    /// Whether a finding speaks of what this puts right. If not, `LineContext::matter` does.
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
            // They are made for such findings only.
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
