//! What POV-Ray makes of each feature.

use crate::translate::{Effect, Feature, Verdict};

/// What shading normals cost.
const BEHIND: &str = "a light behind the triangle, but before its shading normal, is seen";

/// `None` for a feature that this translation was never told about.
pub fn verdict(feature: Feature) -> Option<Verdict> {
    Some(match feature {
        Feature::Record(code) => record(code)?,
        Feature::Effect(effect) => of_effect(effect),
    })
}

fn record(code: i32) -> Option<Verdict> {
    Some(match code {
        0 => Verdict::exact("there is nothing to draw"),
        1 => Verdict::exact("lathe { linear_spline }"),
        2 => Verdict::exact("lathe { linear_spline }, the colours as a pigment"),
        3 | 4 => Verdict::exact("plane"),
        5 => Verdict::exact("polygon"),
        6 => Verdict::exact("triangle"),
        7 | 8 => Verdict::approximate(BEHIND, "smooth_triangle"),
        9..=11 => Verdict::exact("sphere"),
        12 => Verdict::exact("box"),
        13 => Verdict::exact("a mesh of the same facets"),
        14 => Verdict::exact("torus"),
        15 | 18..=21 => Verdict::exact("poly { 2 }"),
        16 | 17 => Verdict::exact("cone"),
        -4..=-1 => Verdict::exact("matrix"),
        -99 => Verdict::exact("location, direction, right and up"),
        -101 => Verdict::exact("union, of transparent parts merge"),
        -102 => Verdict::exact("intersection"),
        -103 => Verdict::exact("difference"),
        -104 => Verdict::exact("inverse"),
        -105 => Verdict::exact("the same object, declared once"),
        -201 | -202 => Verdict::exact("finish, kt as a filter"),
        -203 => Verdict::exact("interior { ior }"),
        -299 | -701 => Verdict::exact(""),
        -301 => Verdict::exact("image_map through the surface coordinates"),
        -302 | -399 => Verdict::exact("a function pigment"),
        -401 => Verdict::exact("ambient_light"),
        -402 => Verdict::exact("light_source without fading"),
        -501 | -502 => Verdict::exact("camera"),
        -503 => Verdict::exact("one file for each eye"),
        -601 | -602 => Verdict::exact("bounded_by, where it is proved to hold the object"),
        9999 => Verdict::exact(""),
        _ => return None,
    })
}

fn of_effect(effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection | Effect::Refraction => {
            Verdict::exact("")
        }
        Effect::TransparentShadows => Verdict::exact("kt of each surface on the way"),
        Effect::Dispersion => Verdict::exact("three passes, Channel 0, 1 and 2"),
        Effect::TotalReflection => Verdict::approximate(
            "the mirrored ray counts with weight 1 instead of ks + kt",
            "",
        ),
        Effect::VertexColours => Verdict::exact("a pigment over the profile"),
        Effect::SmoothNormals => Verdict::approximate(BEHIND, "smooth_triangle"),
        Effect::Background => Verdict::exact("background"),
        Effect::RenderBox => Verdict::exact("clipped_by"),
        Effect::AutomaticCamera => Verdict::exact("the camera is written out"),
        Effect::Headlight => Verdict::exact("a light_source at the camera"),
        Effect::Depth => Verdict::exact("max_trace_level"),
        Effect::Cutoff => Verdict::exact("adc_bailout 0: all rays are followed"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_feature_has_a_line() {
        for feature in Feature::all() {
            assert!(verdict(feature).is_some(), "{feature:?}");
        }
    }
}
