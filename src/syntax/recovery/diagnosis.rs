//! The diagnosis of a piece of a stretch.

use super::super::ast::{self, Broken, Item, Record};
use super::super::signature::Reading;
use super::super::table::{RecordKind, RecordType};
use super::heads::{integral, spoiled, with_letters, without_point};
use super::slips::is_slip;
use super::stretch::Stretch;

/// A piece of a stretch: tokens `start..end`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RecordCandidate {
    pub start: usize,
    pub end: usize,
    pub verdict: Diagnosis,
}

/// The diagnosis of a piece of the text.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Diagnosis {
    Void,
    Whole(Reading),
    /// A record with the right number of parameters, some of which have findings of their own; tokens
    /// that can be no parameter are passed over.
    Damaged {
        ty: &'static RecordType,
    },
    /// A line that is a record but for integers that are spelled as reals, `2.0 9.0 1`.
    Reals {
        ty: &'static RecordType,
    },
    /// A record with more or fewer parameters than the type takes.
    WrongArity {
        ty: &'static RecordType,
        got: usize,
        expected: usize,
    },
    /// A record that is right but for a token too many, which stands before its ID or between its ID and its type.
    Surplus {
        ty: &'static RecordType,
        expected: usize,
        /// The token too many.
        at: usize,
        id: u32,
    },
    /// A record that lacks the sign of its type: it reads as type `ty`, and would be right with the type `meant`.
    LostSign {
        ty: &'static RecordType,
        meant: &'static RecordType,
        got: usize,
        expected: usize,
    },
    /// A record of a counted type whose number of points, which comes first, is missing or cannot be used.
    BadPointCount {
        ty: &'static RecordType,
    },
    /// A record of a type that does not exist.
    UnknownType,
    /// The token in the type's place is no integer.
    BadType,
    /// An ID with no text behind it.
    MissingType,
    /// A complete record but for the ID in front.
    LostId {
        ty: &'static RecordType,
    },
    /// The render record with ID and type in each other's place.
    Swapped,
    /// The token in the ID's place cannot be one; the rest may be right.
    BadId {
        ty: Option<&'static RecordType>,
    },
    /// A record that was cut off by a comment which nobody closed. That comment is reported already.
    CutOff {
        ty: Option<&'static RecordType>,
    },
}

impl RecordCandidate {
    /// The piece as an item of the tree.
    pub(crate) fn item(&self, stretch: &Stretch) -> Item {
        let sig = |i: usize| stretch.sigs[i];
        let mut broken = Broken {
            first: sig(self.start).token,
            last: sig(self.end - 1).token,
            id: (sig(self.start).int.map(i64::from))
                .or_else(|| without_point(stretch, self.start).map(i64::from))
                .or_else(|| integral(stretch, self.start))
                .and_then(|id| u32::try_from(id).ok())
                .filter(|&id| id > 0),
            kind: None,
            fault: ast::Fault::Form,
            is_slip: is_slip(stretch, self),
        };
        match self.verdict {
            Diagnosis::Void => Item::Void {
                token: sig(self.start).token,
            },
            Diagnosis::Whole(r) => Item::Record(Record {
                id: stretch.sigs[self.start].int.unwrap_or(0) as u32,
                kind: r.ty.kind,
                first: broken.first,
                last: broken.last,
                params: (r.end - self.start - 2) as u32,
                value: stretch.value_index(self.start + 2),
            }),
            Diagnosis::WrongArity { ty, .. } | Diagnosis::BadPointCount { ty } => {
                broken.kind = Some(ty.kind);
                broken.fault = ast::Fault::Arity;
                Item::Broken(broken)
            }
            Diagnosis::Damaged { ty }
            | Diagnosis::Reals { ty }
            | Diagnosis::LostSign { meant: ty, .. } => {
                broken.kind = Some(ty.kind);
                Item::Broken(broken)
            }
            Diagnosis::LostId { ty } => {
                broken.id = (ty.kind == RecordKind::Render).then_some(1);
                broken.kind = Some(ty.kind);
                broken.fault = ast::Fault::LostId;
                Item::Broken(broken)
            }
            Diagnosis::Surplus { ty, id, .. } => {
                broken.id = Some(id);
                broken.kind = Some(ty.kind);
                Item::Broken(broken)
            }
            Diagnosis::Swapped => {
                broken.id = Some(1);
                broken.kind = Some(RecordKind::Render);
                Item::Broken(broken)
            }
            Diagnosis::UnknownType => {
                broken.fault = ast::Fault::UnknownType;
                Item::Broken(broken)
            }
            Diagnosis::BadId { ty } => {
                let spoiled = with_letters(stretch, self.start)
                    .or_else(|| spoiled(stretch, self.start))
                    .and_then(|id| u32::try_from(id).ok());
                broken.id = spoiled.or(broken.id).filter(|&id| id > 0);
                broken.kind = ty.map(|ty| ty.kind);
                if broken.id.is_none() {
                    broken.fault = ast::Fault::LostId;
                }
                Item::Broken(broken)
            }
            Diagnosis::CutOff { ty } => {
                broken.kind = ty.map(|ty| ty.kind);
                Item::Broken(broken)
            }
            Diagnosis::BadType | Diagnosis::MissingType => Item::Broken(broken),
        }
    }
}
