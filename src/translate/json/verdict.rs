//! Support of each feature by JSON, and by records made of the resolved scene.

use crate::syntax::table::RecordKind;
use crate::translate::{Feature, FeatureSupport};

/// The support of a feature. JSON has the whole resolved scene, but not the steps by which records made it.
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
