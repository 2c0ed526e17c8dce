//! What becomes of each feature in JSON, and in records made of the resolved scene.

use crate::syntax::table::RecordKind;
use crate::translate::{Feature, FeatureSupport};

/// Everything is there; what a record did on the way is not.
pub fn verdict(feature: Feature) -> FeatureSupport {
    match feature {
        Feature::Record(
            RecordKind::Translation
            | RecordKind::Rotation
            | RecordKind::Scaling
            | RecordKind::RotationMatrix,
        ) => FeatureSupport::exact("steps one after the other are one matrix"),
        Feature::Record(RecordKind::Assignment) => {
            FeatureSupport::exact("as the properties that were assigned")
        }
        Feature::Record(_) | Feature::Effect(_) => FeatureSupport::exact(""),
    }
}
