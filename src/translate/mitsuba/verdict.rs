//! What Mitsuba makes of each feature.

use crate::translate::{Effect, Feature, Verdict};

/// `None` for a feature that this translation was never told about.
pub fn verdict(feature: Feature, tolerance: f64) -> Option<Verdict> {
    Some(match feature {
        Feature::Record(code) => record(code, tolerance)?,
        Feature::Effect(effect) => of_effect(effect),
    })
}

fn record(code: i32, tolerance: f64) -> Option<Verdict> {
    let within = format!("within {tolerance:.3e}");
    let facets = |note| Verdict::approximate(&within, note);
    Some(match code {
        0 => Verdict::exact("there is nothing to draw"),
        1 | 2 | 10 | 14..=21 => facets("a mesh"),
        9 | 11 => facets("sphere, exact where nothing cuts or stretches it; else a mesh"),
        3 | 4 => Verdict::approximate("ends at a thousand times the scene's size", "rectangle"),
        5 => Verdict::exact("rectangle, or a mesh where it is cut"),
        12 => Verdict::exact("cube, or a mesh where it is cut"),
        6..=8 | 13 => Verdict::exact("a mesh of the same facets"),
        -4..=-1 => Verdict::exact(""),
        -99 => Verdict::approximate(
            "exact where rays are parallel, or pixels square",
            "orthographic, perspective with principal_point_offset",
        ),
        -101 => Verdict::exact("shapes side by side; those of one clear medium are joined"),
        -104..=-102 => facets("cut as meshes"),
        -105 => Verdict::exact(""),
        -201 | -202 => Verdict::approximate(
            "a mixture by the strongest channel, with Fresnel's law where light is bent",
            "diffuse, conductor, dielectric",
        ),
        -203 => Verdict::exact("int_ior, ext_ior"),
        -299 | -701 => Verdict::exact(""),
        -301 => Verdict::approximate("straight between the points of a mesh", "bitmap"),
        -302 => Verdict::approximate("one colour a triangle", "mesh_attribute"),
        -399 => Verdict::approximate(
            "exact on planes, rectangles and spheres; else straight between the points of a mesh",
            "checkerboard",
        ),
        -401 => Verdict::approximate("light that what is near keeps out", "a constant emitter"),
        -402 => Verdict::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point emitter",
        ),
        -501 | -502 => Verdict::exact("perspective"),
        -503 => Verdict::exact("one file for each eye"),
        -601 | -602 => Verdict::exact("left out: it never changes the picture"),
        9999 => Verdict::exact(""),
        _ => return None,
    })
}

fn of_effect(effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection => {
            Verdict::approximate("light between surfaces comes in addition", "path")
        }
        Effect::TransparentShadows => Verdict::approximate(
            "full behind what bends light",
            "point lights are no caustics",
        ),
        Effect::Refraction | Effect::TotalReflection => {
            Verdict::approximate("with Fresnel's law", "dielectric")
        }
        Effect::Dispersion => Verdict::approximate(
            "the mean of the channels; exact in three passes",
            "as the head of the file says",
        ),
        Effect::VertexColours => Verdict::approximate("at the points of a mesh", "mesh_attribute"),
        Effect::SmoothNormals => Verdict::exact("normals of the mesh"),
        Effect::Background => Verdict::approximate(
            "it lights the scene; beside ambient light that is seen instead",
            "a constant emitter",
        ),
        Effect::RenderBox => Verdict::exact("what it cuts is a mesh, and open"),
        Effect::AutomaticCamera => Verdict::exact("the camera is written out"),
        Effect::Headlight => Verdict::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point emitter",
        ),
        Effect::Depth => Verdict::exact("max_depth"),
        Effect::Cutoff => Verdict::exact("paths end at random, which is right on average"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_feature_has_a_line() {
        for feature in Feature::all() {
            assert!(verdict(feature, 0.1).is_some(), "{feature:?}");
        }
    }
}
