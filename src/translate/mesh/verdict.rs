//! What a mesh makes of each feature.

use crate::translate::{Effect, Feature, Verdict};

/// `None` for a feature that this translation was never told about.
pub fn verdict(target: &str, feature: Feature, tolerance: f64) -> Option<Verdict> {
    Some(match feature {
        Feature::Record(code) => record(target, code, tolerance)?,
        Feature::Effect(effect) => of_effect(target, effect),
    })
}

fn record(target: &str, code: i32, tolerance: f64) -> Option<Verdict> {
    let within = format!("within {tolerance:.3e}");
    let facets = Verdict::approximate(&within, "triangles");
    Some(match code {
        0 => Verdict::exact("there is nothing to draw"),
        1 | 2 | 9..=11 | 14 | 16 | 17 => facets,
        3 | 4 | 15 | 18..=21 => facets,
        5..=8 | 12 | 13 => Verdict::exact("triangles"),
        -4..=-1 => Verdict::exact("applied to the points"),
        -104..=-101 => Verdict::approximate(&within, "cut and joined as meshes"),
        -105 => Verdict::exact(""),
        -203..=-201 => match target {
            "ply" => Verdict::dropped("a PLY file has colours only"),
            "obj" => Verdict::approximate("a material of MTL", "Kd, Ks, Tf, Ni"),
            _ => Verdict::approximate(
                "a physically based material",
                "metallic, roughness, transmission, index",
            ),
        },
        -299 | -701 => Verdict::exact(""),
        -301 | -399 if target != "ply" => {
            Verdict::approximate("straight between the points of the mesh", "a picture")
        }
        -301 | -302 | -399 => Verdict::approximate("one colour a triangle or point", ""),
        -401 | -402 => Verdict::dropped("a mesh has no lights"),
        -503..=-501 | -99 => Verdict::dropped("a mesh has no camera"),
        -601 | -602 => Verdict::exact("left out: it never changes the picture"),
        9999 => Verdict::exact(""),
        _ => return None,
    })
}

fn of_effect(target: &str, effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::TransparentShadows => {
            Verdict::exact("up to the program that shows the mesh")
        }
        Effect::Reflection | Effect::Refraction | Effect::Dispersion | Effect::TotalReflection => {
            match target {
                "ply" => Verdict::dropped("a PLY file has colours only"),
                _ => Verdict::approximate("a material", ""),
            }
        }
        Effect::VertexColours => Verdict::approximate("between the points of the mesh", ""),
        Effect::SmoothNormals => Verdict::exact("normals of the mesh"),
        Effect::Background => Verdict::dropped("a mesh has no background"),
        Effect::RenderBox => {
            Verdict::approximate("what it cuts is closed", "everything is cut to it")
        }
        Effect::AutomaticCamera | Effect::Headlight => Verdict::exact("left to the viewer"),
        Effect::Depth | Effect::Cutoff => Verdict::exact("left to the viewer"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_feature_has_a_line() {
        for target in ["ply", "obj", "glb"] {
            for feature in Feature::all() {
                assert!(verdict(target, feature, 0.1).is_some(), "{feature:?}");
            }
        }
    }
}
