//! What becomes of each feature in JSON, and in records made of the resolved scene.

use crate::translate::{Feature, Verdict};

/// Everything is there; what a record did on the way is not.
pub fn verdict(feature: Feature) -> Option<Verdict> {
    Some(match feature {
        Feature::Record(-4..=-1) => Verdict::exact("steps one after the other are one matrix"),
        Feature::Record(-299) => Verdict::exact("as the properties that were assigned"),
        Feature::Record(_) | Feature::Effect(_) => Verdict::exact(""),
    })
}
