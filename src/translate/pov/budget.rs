//! Limits of the searches that a translation makes, so that no scene takes forever. Beyond a limit the translator
//! writes the part as if there were nothing to find, and the report says so.
//!
//! Limits beyond which the translator takes the safe side are not among these: they make the text longer, and change no
//! picture.

use std::cell::RefCell;
use std::collections::BTreeSet;

use crate::diagnostics::Complaint;
use crate::translate::fidelity::{Fidelity, Report};

/// The kind of work that a limit applies to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Limit {
    /// Nodes of an object whose faces are looked for.
    NodesWithFaces,
    /// Nodes that are looked at to find out whether a solid can be made larger or smaller.
    NodesOffset,
    /// Points of a profile that is checked for crossing itself.
    ProfilePoints,
    /// Parts of a union that is searched for faces in one plane.
    PartsLevelled,
    /// Solids of a union that is searched for faces in one place.
    SolidsSettled,
    /// Parts of a union that is searched for parts made of the same solid.
    PartsShared,
    /// Parts of a union that is written part by part.
    PartsSplit,
    /// Parts of a union in which unions that may be written part by part are looked for.
    PartsAround,
    /// Tools of a difference, or operands of an intersection, that are compared with each other.
    OperandsFlush,
    /// Operands of an intersection that are searched for those that hold others.
    OperandsHeld,
    /// Groups of a union that one more part is compared with before it joins an earlier group.
    GroupsCompared,
    /// Parts of touching groups of a union, over all pairs of groups: they are written again for each other. Nobody
    /// could read or render a file with more of them.
    PartsRewritten,
    /// Changes of look in the sequence of earlier groups within which one group ends.
    LooksOfSkin,
    /// Transformations, paints and copies between an operation and the shape or operation that is its operand.
    Modifications,
    /// Pieces along each side of a triangle with normals of several lengths.
    TrianglePieces,
    /// Planes that may be mirrors in which the eye appears.
    Mirrors,
}

impl Limit {
    pub(crate) fn most(self) -> usize {
        self.says().0
    }

    /// The largest amount within the limit, and the message on what is done beyond it.
    fn says(self) -> (usize, &'static str) {
        match self {
            Limit::NodesWithFaces => (256, "limit-nodes-with-faces"),
            Limit::NodesOffset => (4096, "limit-nodes-offset"),
            Limit::ProfilePoints => (512, "limit-profile-points"),
            Limit::PartsLevelled => (1024, "limit-parts-levelled"),
            Limit::SolidsSettled => (512, "limit-solids-settled"),
            Limit::PartsShared => (4096, "limit-parts-shared"),
            Limit::PartsSplit => (32, "limit-parts-split"),
            Limit::PartsAround => (512, "limit-parts-around"),
            Limit::OperandsFlush => (256, "limit-operands-flush"),
            Limit::OperandsHeld => (64, "limit-operands-held"),
            Limit::GroupsCompared => (256, "limit-groups-compared"),
            Limit::PartsRewritten => (1 << 18, "limit-parts-rewritten"),
            Limit::LooksOfSkin => (15, "limit-looks-of-skin"),
            Limit::Modifications => (64, "limit-modifications"),
            Limit::TrianglePieces => (24, "limit-triangle-pieces"),
            Limit::Mirrors => (8, "limit-mirrors"),
        }
    }
}

/// The limits that were reached.
#[derive(Debug, Default)]
pub(crate) struct Budget {
    spent: RefCell<BTreeSet<Limit>>,
}

impl Budget {
    /// Whether an amount is within a limit. A limit that is exceeded will be named in the report.
    pub(crate) fn spend(&self, limit: Limit, amount: usize) -> bool {
        let is_within = amount <= limit.most();
        if !is_within {
            self.spent.borrow_mut().insert(limit);
        }
        is_within
    }

    /// Names the limits that were exceeded.
    pub(crate) fn report(&self, report: &mut Report) {
        for limit in self.spent.borrow().iter() {
            let (most, message) = limit.says();
            let beyond = Complaint::new(message).with("most", most.to_string());
            report.state(
                "limits of the translation",
                Fidelity::Approximate(beyond),
                "",
            );
        }
    }
}
