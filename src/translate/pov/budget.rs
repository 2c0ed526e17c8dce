//! Limits of what is looked at, so that no scene takes forever. What is beyond one is written otherwise, as if there were
//! nothing to find, and the report says so.
//!
//! A limit beyond which the safe side is taken is none of these: it makes the text longer, and changes no picture.

use std::cell::RefCell;
use std::collections::BTreeSet;

use crate::diagnostics::Complaint;
use crate::translate::fidelity::{Fidelity, Report};

/// The kind of work that a limit applies to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Limit {
    /// Nodes of an object of which the faces are looked for.
    NodesWithFaces,
    /// Nodes that are looked at to find out whether a solid can be made larger or smaller.
    NodesOffset,
    /// Points of a profile that is asked whether it crosses itself.
    ProfilePoints,
    /// Parts of a union of which faces in one plane are looked for.
    PartsLevelled,
    /// Solids of a union that are searched for those that stand on each other.
    SolidsSettled,
    /// Parts of a union that are searched for the same solids in them.
    PartsShared,
    /// Parts of a union that is written part by part, and half of those of one in which such unions are looked for.
    PartsSplit,
    PartsAround,
    /// Tools, or operands of an intersection, that are compared with each other.
    OperandsFlush,
    /// Operands of an intersection that are searched for those that hold others.
    OperandsHeld,
    /// Groups of a union with the parts of which one more part is compared.
    GroupsCompared,
    /// Parts of groups that touch and are written again for each other, in all together. Nobody could read or render more.
    PartsRewritten,
    /// Changes of look between the earlier groups within which one ends.
    LooksOfSkin,
    /// Transformations, properties and copies between an operation and what it is an operand of.
    Modifications,
    /// Pieces along each side of a triangle with normals of several lengths.
    TrianglePieces,
    /// Planes that may be mirrors in which the eye is.
    Mirrors,
}

impl Limit {
    pub(crate) fn most(self) -> usize {
        self.says().0
    }

    /// How much is looked at, and the message on what is done beyond that.
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
    /// Whether so much is within a limit. The report names one that is exceeded.
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
